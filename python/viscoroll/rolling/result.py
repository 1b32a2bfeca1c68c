"""What a solve returns."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, fields
from pathlib import Path
from typing import TYPE_CHECKING, Any, overload

import numpy as np

from .._core import Compliance, Curvature, PatchLoad, Status, WarningKind
from .._support.extras import extra
from .._support.progress import ProgressLike
from ..bodies import CoatedCylinder, Counterpart, Drive, Mesh, RollingBody
from ..bodies.si_hints import si_hint
from ..solution.loss_spectrum import extrapolated_share
from ..solution.scalars import PER_LENGTH, SCALARS, ScalarFields, scalar_units, with_scalars
from ..solution.text import result_html, result_summary

if TYPE_CHECKING:
    import xarray
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from numpy.typing import ArrayLike, NDArray

    from .. import _core

__all__ = ["FIELDS", "VECTOR_FIELDS", "Refinement", "Result"]


@dataclass(frozen=True, slots=True, kw_only=True)
class Refinement:
    """One mesh of a solve that chose its own.

    Attributes
    ----------
    mesh : Mesh
        The mesh.
    contact_nodes : int
        Nodes in contact.
    resisting_torque : float
        T_r [N m].
    penetration : float or None
        r_o - H [m]; None where it is undetermined.
    power_balance_error : float
        Relative [-].
    error_estimate : float
        The larger of the power-balance error and the changes from the mesh before [-]; 1 on the first mesh.
    """

    mesh: Mesh
    contact_nodes: int
    resisting_torque: float
    penetration: float | None
    power_balance_error: float
    error_estimate: float

    @classmethod
    def _from_core(cls, step: _core.Refinement) -> Refinement:
        values = {field.name: getattr(step, field.name) for field in fields(cls)}
        return cls(**values | {"mesh": Mesh._from_core(step.mesh)})


#: Fields on the mesh: name, unit, what it is.
FIELDS = {
    "x": ("m", "forward coordinate of the undeformed node"),
    "z": ("m", "lateral coordinate of the undeformed node"),
    "pressure": ("Pa", "contact pressure"),
    "displacement": ("m", "vertical displacement of the surface, upwards"),
    "gap": ("m", "height of the surface above the plane"),
    "contact": ("1", "whether the node is in contact"),
    "stick": ("1", "whether the node sticks to the plane"),
    "slip": ("1", "whether the node is in contact and slips"),
}

#: Fields of vectors along x and z.
VECTOR_FIELDS = {
    "shear_traction": ("Pa", "traction of the plane on the coating"),
    "slip_velocity": ("m/s", "velocity of the coating over the plane, in contact"),
}


@with_scalars
@dataclass(frozen=True, slots=True, kw_only=True, eq=False, repr=False)
class Result(ScalarFields):
    """Solution of one load case on the candidate window.

    Of a roller (`CoatedCylinder`), whose fields have one column, forces are per length [N/m], and so are torques [N],
    powers [W/m] and the contact area [m]; `unit` tells.

    Fields are read-only arrays of shape (nodes in φ, nodes in θ); material crosses the contact towards growing φ, from
    the leading edge (x > 0) to the trailing edge.

    Attributes
    ----------
    ball, on, load, angular_speed, friction, drive, compliance, curvature, patch_load
        The input; load in [N], of a roller in [N/m], angular_speed in [rad/s].
    status : Status
        How the solve ended.
    %(scalars)s
    mesh : Mesh
        The mesh of this solution.
    refinements : tuple of Refinement
        The meshes tried, coarse to fine.
    warnings : dict of WarningKind to str
        What to know before relying on this: the texts of the `ResultWarning` that the solve gave.
    x, z : ndarray
        Coordinates of the undeformed nodes [m]: x forward, z sideways.
    pressure : ndarray
        Contact pressure, positive [Pa].
    displacement : ndarray
        Vertical displacement of the surface, positive upwards [m]; where the penetration is undetermined, counted from
        that of the lowest point.
    gap : ndarray
        Height of the surface above the plane [m].
    contact, stick, slip : ndarray of bool
        Where the surface touches the plane, and of that, where it sticks and where it slips. Without friction all of it
        slips.
    shear_traction : ndarray, shape (2, nodes in φ, nodes in θ)
        Traction of the plane on the coating along x and z [Pa].
    slip_velocity : ndarray, shape (2, nodes in φ, nodes in θ)
        Velocity of the coating over the plane along x and z [m/s]; zero out of contact, and without friction.
    """

    ball: RollingBody
    on: Counterpart | None
    load: float
    angular_speed: float
    friction: float
    drive: Drive
    compliance: Compliance
    curvature: Curvature
    patch_load: PatchLoad
    status: Status
    mesh: Mesh
    refinements: tuple[Refinement, ...]
    warnings: dict[WarningKind, str]
    x: NDArray[np.float64]
    z: NDArray[np.float64]
    pressure: NDArray[np.float64]
    displacement: NDArray[np.float64]
    gap: NDArray[np.float64]
    contact: NDArray[np.bool_]
    stick: NDArray[np.bool_]
    slip: NDArray[np.bool_]
    shear_traction: NDArray[np.float64]
    slip_velocity: NDArray[np.float64]

    def __post_init__(self) -> None:
        """Freeze the arrays."""
        for name in (*FIELDS, *VECTOR_FIELDS):
            getattr(self, name).flags.writeable = False

    def __reduce__(self) -> tuple[Callable[..., Result], tuple[type[Result], dict[str, Any]]]:
        """Copy and pickle by way of the constructor, which freezes the arrays of the copy."""
        return _rebuilt, (type(self), {field.name: getattr(self, field.name) for field in fields(self)})

    @classmethod
    def _from_core(cls, solution: _core.Result, **inputs: Any) -> Result:
        names = {field.name for field in fields(cls)} - inputs.keys()
        values = {name: getattr(solution, name) for name in names}
        values["mesh"] = Mesh._from_core(solution.mesh)
        values["refinements"] = tuple(Refinement._from_core(step) for step in solution.refinements)
        for name in ("contact", "stick", "slip"):
            values[name] = getattr(solution, name).view(np.bool_)
        hint = si_hint(inputs["ball"], inputs["on"])
        if hint and WarningKind.LARGE_STRAIN in solution.warnings:
            values["warnings"][WarningKind.LARGE_STRAIN] += f"; {hint}"
        return cls(**inputs, **values)

    def __repr__(self) -> str:
        """Return a summary of one screen."""
        return result_summary(self)

    def _repr_html_(self) -> str:
        """Return all scalar results with units, as a table for notebooks."""
        return result_html(self)

    def unit(self, name: str) -> str:
        """Return the unit of a scalar result, or of ``"load"``: of a roller per length.

        Raises
        ------
        KeyError
            For another name.

        Examples
        --------
        >>> from viscoroll import paper, solve
        >>> solve(paper.ball(), load=100.0, angular_speed=2.5, accuracy=0.05).unit("bulk_power")
        'W'
        """
        line_contact = isinstance(self.ball, CoatedCylinder)
        return (scalar_units(line_contact=line_contact) | {"load": PER_LENGTH["N"] if line_contact else "N"})[name]

    def extrapolated_loss(self) -> float | None:
        """Return the share of the power lost in the coating at harmonics that a measured table does not hold.

        Returns
        -------
        float or None
            [-], where the outermost entries of a `MasterCurve` were held; None without such a material.
        """
        return extrapolated_share(self)

    def scalars(self) -> dict[str, float | int | str | None]:
        """Return all scalar results by name, in SI units, with status and warnings by their names."""
        values: dict[str, float | int | str | None] = {name: getattr(self, name) for name in SCALARS}
        values |= {
            "load": self.load,
            "angular_speed": self.angular_speed,
            "friction": self.friction,
            "status": self.status.name,
            "contact_nodes": int(self.contact.sum()),
            "nodes_per_revolution": self.mesh.nodes_per_revolution,
            "theta_nodes_per_revolution": self.mesh.theta_nodes_per_revolution or self.mesh.nodes_per_revolution,
            "max_order": self.mesh.max_order,
            "compliance": self.compliance.name,
            "curvature": self.curvature.name,
            "patch_load": self.patch_load.name,
            "warnings": ", ".join(kind.name for kind in self.warnings),
        }
        return values

    def to_xarray(self) -> xarray.Dataset:
        """Return fields and scalars as a dataset over the angles φ and θ of the nodes.

        Returns
        -------
        xarray.Dataset
            Fields with units over `phi` and `theta` [rad], scalars as attributes.

        Raises
        ------
        ImportError
            Without the extra `viscoroll[files]`.
        """
        with extra("files"):
            import xarray

        angles = zip(("phi", "theta"), self._angles(), strict=True)
        coordinates = {name: (name, values, {"units": "rad"}) for name, values in angles}
        variables = {
            name: (dimensions, getattr(self, name), {"units": unit, "long_name": description})
            for table, dimensions in ((FIELDS, ("phi", "theta")), (VECTOR_FIELDS, ("direction", "phi", "theta")))
            for name, (unit, description) in table.items()
        }
        attributes = {name: value for name, value in self.scalars().items() if value is not None}
        return xarray.Dataset(variables, coordinates | {"direction": ["x", "z"]}, attrs=attributes)

    def _angles(self) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Return φ of the rows and θ of the columns of the fields [rad]."""
        spacings = (self.mesh.spacing, self.mesh.theta_spacing)
        phi, theta = (
            0.5 * np.pi + spacing * (np.arange(count) - count // 2)
            for count, spacing in zip(self.pressure.shape, spacings, strict=True)
        )
        return phi, theta

    def interior(
        self,
        *,
        depth: ArrayLike | None = None,
        radius: ArrayLike | None = None,
        phi: ArrayLike | None = None,
        theta: ArrayLike | None = None,
        threads: int = 0,
        progress: ProgressLike = None,
    ) -> xarray.Dataset:
        """Displacement, strain and stress inside the coating.

        Parameters
        ----------
        depth : array_like
            Below the surface [m], within the coating; or `radius`. Where layers meet, strains and stresses along the
            surface jump: such a depth comes twice, the outer layer first, see the coordinate `layer`.
        radius : array_like
            r [m], in place of `depth`.
        phi, theta : array_like, optional
            Angles [rad] within half a revolution of the lowest point, π/2; by default those of the nodes.
            ``theta=[π/2]`` with many depths is the section through the contact.
        threads : int, default 0
            Number of threads; 0 for all cores.
        progress : bool or callable, optional
            True shows a bar; or called as progress(stage, fraction) about every 20 ms.

        Returns
        -------
        xarray.Dataset
            Over (depth, phi, theta): `displacement` [m] by `direction`, `stress` [Pa] (tension positive) and `strain`
            [-] by `component`, and of them `von_mises`, `principal_stress` (largest first), `hydrostatic_pressure`,
            and the traction on the surface r = const: `opening_traction`, its tension where there is any, and
            `shear_traction` [Pa].

        Raises
        ------
        TypeError, ValueError
            For bad input; also with curvature EXACT, which has no orders (m, n).
        ImportError
            Without the extra `viscoroll[files]`.

        Warns
        -----
        ResultWarning
            For depths where the mesh is too coarse: less than a quarter of a spacing, between nodes half of one.

        Notes
        -----
        Stresses are those of the compliance of the solve. With VERTICAL pressure acts along the plane's normal and so
        has a share along the coating, up to p x/r_o, which raises the largest von Mises stress near the surface.

        Examples
        --------
        >>> from viscoroll import Mesh, paper, solve
        >>> r = solve(paper.ball(), load=100.0, angular_speed=2.5, mesh=Mesh(nodes_per_revolution=400))
        >>> inside = r.interior(depth=[0.3e-3, 1e-3])
        >>> print(f"{inside.von_mises.max().item() / 1e6:.1f} MPa")
        3.8 MPa
        """
        from ..solution.interior_fields import interior_fields

        return interior_fields(
            self, depth=depth, radius=radius, phi=phi, theta=theta, threads=threads, progress=progress
        )

    def bonds(self, *, threads: int = 0, progress: ProgressLike = None) -> xarray.Dataset:
        """Fields where layers are bonded, to the core and to one another: what debonds.

        Parameters
        ----------
        threads, progress
            As of `interior`.

        Returns
        -------
        xarray.Dataset
            As of `interior`, at the core of a ball with a rigid one, and on both sides of every boundary between
            layers.

        Raises
        ------
        ValueError
            Where nothing is bonded to anything.
        """
        from ..solution.interior_fields import bond_fields

        return bond_fields(self, threads=threads, progress=progress)

    def loss(
        self,
        *,
        depth: ArrayLike | None = None,
        max_order: int | None = None,
        threads: int = 0,
        progress: ProgressLike = None,
    ) -> xarray.Dataset:
        """Energy lost inside the coating, per volume and revolution.

        Parameters
        ----------
        depth : array_like, optional
            Where the densities are wanted [m]; by default at the nodes of the volume integral.
        max_order : int, optional
            Orders |m|, |n| up to this one are summed; by default those of the mesh or 40 r_o/a, whichever are fewer, a
            the contact's semi-axis: 0.9999 of the loss, on coarse meshes 0.998.
        threads : int, default 0
            Number of threads; 0 for all cores.
        progress : bool or callable, optional
            True shows a bar; or called as progress(stage, fraction) about every 20 ms.

        Returns
        -------
        xarray.Dataset
            `loss_density` w [J/m³ per revolution] and `power_density` Ωw/2π [W/m³], its mean over a revolution, over
            (radius, theta); `layer_power` [W] by `layer`, and `relaxation_power` [W] by `layer` and `term` for layers
            that are Prony series. Attributes: `power`, the volume integral [W], `surface_power`, what the tractions put
            into the same orders, and `bulk_power`, that of all orders; each of what rolls alone.

        Raises
        ------
        TypeError, ValueError
            For bad input; also with curvature EXACT.
        ImportError
            Without the extra `viscoroll[files]`.

        Notes
        -----
        The model's volume is r² dr dθ dφ, without sin θ.

        Examples
        --------
        >>> from viscoroll import Mesh, paper, solve
        >>> r = solve(paper.ball(), load=100.0, angular_speed=2.5, mesh=Mesh(nodes_per_revolution=400))
        >>> loss = r.loss(depth=[0.5e-3])
        >>> print(f"{loss.attrs['power'] / r.bulk_power:.3f} {loss.power_density.max().item() / 1e3:.0f} kW/m³")
        0.998 50 kW/m³
        """
        from ..solution.loss import loss_of

        return loss_of(self, depth=depth, max_order=max_order, threads=threads, progress=progress)

    def save(self, path: str | Path) -> None:
        """Write the fields to a file, in the format of its suffix.

        Parameters
        ----------
        path : path-like
            ``.csv`` (a row for each node), ``.nc`` (netCDF, with scalars as attributes) or ``.vtu``/``.vtk`` (the
            deformed surface, for ParaView).

        Raises
        ------
        ValueError
            For another suffix.
        ImportError
            For all but ``.csv``, without the extra `viscoroll[files]`.
        """
        from ..solution.files import save_result

        save_result(self, Path(path))

    @overload
    def plot(self) -> Figure: ...

    @overload
    def plot(self, ax: Axes) -> Axes: ...

    def plot(self, ax: Axes | None = None) -> Figure | Axes:
        """Draw the pressure with the contact's outline and the resultant's offset, and the profile along the path.

        With friction also where the contact sticks and slips, with arrows for the traction on the coating.

        Parameters
        ----------
        ax : matplotlib.axes.Axes, optional
            Where to draw the map of the pressure alone, of a roller its profile.

        Returns
        -------
        matplotlib.figure.Figure or matplotlib.axes.Axes
            A new figure, which shows itself in a notebook and is saved by ``savefig``; or `ax`.

        Raises
        ------
        ImportError
            Without the extra `viscoroll[plot]`.
        """
        from ..solution.picture import draw_contact, plot_contact

        return plot_contact(self) if ax is None else draw_contact(self, ax)


def _rebuilt(kind: type[Result], values: dict[str, Any]) -> Result:
    return kind(**values)
