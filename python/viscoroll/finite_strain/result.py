"""Result of steady rolling at finite strain."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import numpy as np

from .._support.extras import extra
from .._support.quantities import quantity_text
from .._support.tables import html_table

if TYPE_CHECKING:
    import xarray
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from .._support.arguments import Floats
    from ..bodies import CoatedCylinder, Counterbody
    from .cover import Cover, CoverState
    from .equilibrium import Rolling
    from .laws import Elasticity, Law
    from .problem import Problem

__all__ = ["FiniteStrainResult"]

#: Strain above which the laws of the viscous stress differ by more than 2 % in the torque.
_LAW_STRAIN = 0.15

#: Relative difference of moment and loss above which the mesh is too coarse.
_LARGEST_BALANCE_ERROR = 0.03


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class FiniteStrainResult:
    """Steady rolling of a covered roller at finite strain; load, forces, torques and powers are per length.

    Attributes
    ----------
    roller : CoatedCylinder
        Roller.
    on : Counterbody or None
        Rigid counterbody; None for the plane.
    law : Law
        Law of the viscous stress.
    elasticity : Elasticity
        Elastic law.
    angular_speed : float
        Ω [rad/s].
    prescribed : str
        Given quantity, "load" or "penetration".
    load : float
        Normal load P [N/m].
    penetration : float
        Outer radius at rest minus height of the axis above the counterbody, r_o - H [m].
    strain : float
        Penetration per thickness of the cover [-].
    driving_torque : float
        Torque T that keeps the roller turning [N m/m]: mean of `contact_torque` and `dissipated_power` / Ω, which both
        have mesh errors.
    resisting_torque : float
        T on a plane; on a roller of radius R or in a drum of radius -R, T / (1 + r_o/R) [N m/m]. It is the quantity
        that `Result.resisting_torque` is in linear theory.
    contact_torque, core_torque : float
        Moments about the axis of the contact pressure and of the stress on the core [N m/m].
    dissipated_power : float
        Power of the viscous stress in the whole cover [W/m].
    power_balance_error : float
        Difference between `contact_torque` and `dissipated_power` / Ω, relative to their mean [-]. It is a measure of
        the mesh error.
    overspeed : float
        c, mean stretch of the surface in contact minus 1 [-]. The counterbody passes at the speed (1 + c) Ω r_o.
    speed : float
        V = (1 + c) Ω r_o, speed of the counterbody relative to the axis [m/s].
    resisting_force : float
        Force along the counterbody that dissipates the same power at this speed, Ω T / V [N/m].
    rolling_resistance_coefficient : float
        Dissipated power per load and speed V, Ω T / (P V) [-].
    position : ndarray, shape (n,)
        Positions of the surface nodes in contact behind the axis, in the direction of the moving surface [m].
    pressure : ndarray, shape (n,)
        Contact pressure there, per deformed area [Pa].
    max_pressure : float
        Largest contact pressure of a node [Pa].
    contact_length : float
        Distance along the counterbody between the outermost nodes in contact [m].
    elements : (int, int)
        Numbers of elements along the angle and along the radius.
    newton_steps, linear_iterations : int
        Newton steps, and iterations of the linear solver, in this equilibrium.
    warnings : tuple of str
        Texts of the warnings.
    """

    roller: CoatedCylinder
    on: Counterbody | None
    law: Law
    elasticity: Elasticity
    angular_speed: float
    prescribed: str
    load: float
    penetration: float
    strain: float
    driving_torque: float
    resisting_torque: float
    contact_torque: float
    core_torque: float
    dissipated_power: float
    power_balance_error: float
    overspeed: float
    speed: float
    resisting_force: float
    rolling_resistance_coefficient: float
    position: Floats
    pressure: Floats
    max_pressure: float
    contact_length: float
    elements: tuple[int, int]
    newton_steps: int
    linear_iterations: int
    warnings: tuple[str, ...]
    _fields: dict[str, tuple[Floats, str, str]] = field(repr=False)
    _axes: tuple[Floats, Floats] = field(repr=False)

    def fields(self) -> xarray.Dataset:
        """Return stress, strain, deformed positions and viscous power at the integration points of the cover.

        Returns
        -------
        xarray.Dataset
            Over `angle` [rad], from the lowest point in the direction of the moving surface, and `radius` [m], both of
            the undeformed cover: deformed position `x` along the counterbody and `y` upwards from the axis [m]; Cauchy
            stress `stress_xx`, `stress_yy` and `stress_xy` [Pa]; Green strain `strain_rr`, `strain_tt` and `strain_rt`
            along radius and angle [-]; `viscous_rr`, `viscous_tt` and `viscous_rt`, the viscous part of the second
            Piola-Kirchhoff stress [Pa]; and `viscous_power`, the power of the viscous stress per undeformed volume
            [W/m³]. The viscous stress also stores energy, so that this power may be negative at a point; its integral
            over the cover is the dissipated power.

        Raises
        ------
        ImportError
            If xarray is missing (the extra `viscoroll[files]`).
        """
        with extra("files"):
            import xarray
        angle, radius = self._axes
        return xarray.Dataset(
            {
                name: (("angle", "radius"), values, {"units": unit, "long_name": label})
                for name, (values, unit, label) in self._fields.items()
            },
            coords={
                "angle": ("angle", angle, {"units": "rad", "long_name": "angle from the lowest point"}),
                "radius": ("radius", radius, {"units": "m", "long_name": "undeformed radius"}),
            },
        )

    def plot(self, ax: Axes | None = None) -> Figure | Axes:
        """Draw the deformed cover with its dissipation, and the contact pressure.

        Parameters
        ----------
        ax : matplotlib.axes.Axes, optional
            Axes for the contact pressure only.

        Returns
        -------
        matplotlib.figure.Figure or matplotlib.axes.Axes
            A figure without a window, or `ax`.

        Raises
        ------
        ImportError
            If matplotlib is missing (the extra `viscoroll[plot]`).
        """
        from .picture import plot_rolling

        return plot_rolling(self, ax)

    def __str__(self) -> str:
        """Return a summary."""
        rows = [(label, quantity_text(value, unit)) for label, value, unit in self._rows()]
        rows += [("elements", f"{self.elements[0]} along the angle, {self.elements[1]} along the radius")]
        rows += [("effort", f"{self.newton_steps} Newton steps, {self.linear_iterations} linear iterations")]
        rows += [("warning", message) for message in self.warnings]
        width = max(len(label) for label, _ in rows)
        head = f"Rolling at finite strain at Ω = {self.angular_speed:g} rad/s (law {self.law.value})"
        return "\n".join([head, *(f"  {label:<{width}}  {value}" for label, value in rows)])

    def _repr_html_(self) -> str:
        """Return the table for a notebook."""
        rows = [(label, quantity_text(value, unit)) for label, value, unit in self._rows()]
        rows += [("warning", message) for message in self.warnings]
        return html_table(f"Rolling at finite strain, law {self.law.value}", rows)

    def _rows(self) -> list[tuple[str, float, str]]:
        return [
            ("driving torque T", self.driving_torque, "N m/m"),
            ("load", self.load, "N/m"),
            ("penetration", self.penetration, "m"),
            ("strain, penetration per thickness", self.strain, "1"),
            ("overspeed", self.overspeed, "1"),
            ("resisting force", self.resisting_force, "N/m"),
            ("rolling resistance coefficient", self.rolling_resistance_coefficient, "1"),
            ("largest pressure", self.max_pressure, "Pa"),
            ("nip length", self.contact_length, "m"),
            ("dissipated power", self.dissipated_power, "W/m"),
            ("power balance error", self.power_balance_error, "1"),
        ]


def result_of(
    problem: Problem, cover: Cover, rolling: Rolling, state: CoverState, prescribed: str
) -> FiniteStrainResult:
    """Return the result of an equilibrium in SI units."""
    mesh, radius = cover.mesh, problem.radius
    force_unit = problem.modulus * radius
    x = mesh.positions[mesh.surface] + rolling.displacement[mesh.surface]
    _, normals, _ = problem.surface.gap(x, rolling.penetration)
    forces = rolling.forces
    load = float(forces @ normals[:, 1]) * force_unit
    moment = float(forces @ (x[:, 1] * normals[:, 0] - x[:, 0] * normals[:, 1])) * force_unit * radius
    reactions = cover.forces(state).reshape(-1, 2)[mesh.core]
    core = mesh.positions[mesh.core]
    core_moment = float(np.sum(core[:, 1] * reactions[:, 0] - core[:, 0] * reactions[:, 1])) * -force_unit * radius
    work = cover.dissipation(state)
    loss = float(cover.angle_weights @ work @ mesh.ring_weights) * force_unit * radius

    touching = np.flatnonzero(forces > 0.0)
    between = slice(touching[0], touching[-1] + 1)
    segments = np.hypot(*np.diff(x[between], axis=0).T)
    turned = float(mesh.angles[touching[-1]] - mesh.angles[touching[0]])
    length = float(segments.sum())
    overspeed = length / turned - 1.0 if turned > 0.0 else 0.0
    speed = (1.0 + overspeed) * problem.angular_speed * radius
    penetration = float(rolling.penetration)
    strain = penetration / problem.thickness
    # A quadratic edge gives two thirds of its load to its middle and one sixth to each end.
    angles = mesh.angles
    steps = (np.roll(angles, -1) - np.roll(angles, 1)) % (2.0 * np.pi)
    share = np.where(np.arange(len(angles)) % 2 == 1, 2.0 / 3.0, 1.0 / 3.0) * steps
    stretch = np.hypot(*(np.roll(x, -1, axis=0) - np.roll(x, 1, axis=0)).T) / steps
    pressure = forces[between] / (share * stretch)[between] * problem.modulus
    torque = 0.5 * (moment + loss)
    balance = abs(loss - moment) / abs(torque) if loss > 0.0 else 0.0
    return FiniteStrainResult(
        roller=problem.roller,
        on=problem.on,
        law=problem.law,
        elasticity=problem.elasticity,
        angular_speed=problem.angular_speed,
        prescribed=prescribed,
        load=load,
        penetration=penetration * radius,
        strain=strain,
        driving_torque=torque,
        resisting_torque=torque / (1.0 + problem.surface.curvature),
        contact_torque=moment,
        core_torque=core_moment,
        dissipated_power=loss * problem.angular_speed,
        power_balance_error=balance,
        overspeed=overspeed,
        speed=speed,
        resisting_force=torque * problem.angular_speed / speed,
        rolling_resistance_coefficient=torque * problem.angular_speed / (load * speed),
        position=x[between, 0] * radius,
        pressure=pressure,
        max_pressure=float(pressure.max()),
        contact_length=length * radius,
        elements=mesh.shape,
        newton_steps=rolling.newton_steps,
        linear_iterations=rolling.linear_iterations,
        warnings=_warnings(problem, strain, balance, len(touching)),
        _fields=_fields(problem, cover, rolling, state, work),
        _axes=(mesh.gauss_angles, mesh.gauss_radii * radius),
    )


def _warnings(problem: Problem, strain: float, balance: float, touching: int) -> tuple[str, ...]:
    texts = []
    viscous = any(len(material.moduli) for material in problem.materials)
    if viscous and strain > _LAW_STRAIN:
        texts.append(
            f"strain = {strain:.3g}: above {_LAW_STRAIN:g}, the torques of the laws newton, simo and abaqus differ by "
            "more than 2 %; compare them, and choose the law that was measured for the material"
        )
    if viscous and balance > _LARGEST_BALANCE_ERROR:
        texts.append(
            f"power_balance_error = {balance:.2g} is above {_LARGEST_BALANCE_ERROR:g}: increase elements_across"
        )
    if touching < 10:
        texts.append(f"only {touching} nodes are in contact: increase elements_across")
    return tuple(texts)


def _fields(
    problem: Problem, cover: Cover, rolling: Rolling, state: CoverState, work: Floats
) -> dict[str, tuple[Floats, str, str]]:
    """Return the fields at the Gauss points with their units and labels."""
    mesh = cover.mesh
    undeformed = mesh.gauss_radii[:, None] * mesh.by_ring(mesh.directions[..., 0, :])
    moved = mesh.by_ring(mesh.shapes @ rolling.displacement[mesh.nodes])
    place = (undeformed + moved) * problem.radius
    s = state.stress
    tensor = np.stack([s[..., 0], s[..., 2], s[..., 2], s[..., 1]], axis=-1).reshape(*s.shape[:2], 2, 2)
    cauchy = state.gradient.swapaxes(-1, -2) @ tensor @ state.gradient / state.strain.jacobian[..., None, None]
    stress = mesh.by_ring(cauchy) * problem.modulus
    green = 0.5 * (mesh.by_ring(state.strain.c) - np.array([1.0, 1.0, 0.0]))
    viscous = mesh.by_ring(state.viscous) * problem.modulus
    named = {"x": (place[..., 0], "m", "deformed position along the counterbody")}
    named["y"] = (place[..., 1], "m", "deformed height above the axis")
    for name, k in (("xx", 0), ("yy", 3), ("xy", 1)):
        named[f"stress_{name}"] = (stress[..., k], "Pa", "Cauchy stress")
    for name, k in (("rr", 0), ("tt", 1), ("rt", 2)):
        named[f"strain_{name}"] = (green[..., k], "1", "Green strain")
        named[f"viscous_{name}"] = (viscous[..., k], "Pa", "viscous second Piola-Kirchhoff stress")
    density = work * problem.modulus * problem.angular_speed
    named["viscous_power"] = (density, "W/m3", "power of the viscous stress per undeformed volume")
    return named
