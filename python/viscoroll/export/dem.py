"""Rolling friction and normal damping for particle codes, by the definition of each code."""

from __future__ import annotations

import math
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from .._support.arguments import as_float, require_type
from .._support.errors import InvalidInput
from .._support.files import write_csv, write_text
from .._support.text import shown
from ..coupled import StrainSoftening
from ..coupled.softening_result import BOUNDS
from ..rolling import Result
from . import chrono, kratos, lammps, lethe, liggghts, mercurydpm, mujoco, yade
from .balls import Balls
from .contact import ContactModel, OperatingPoint, Stiffness, Style, operating_points
from .impact import Impact
from .restitution import with_restitution

if TYPE_CHECKING:
    import xarray

__all__ = ["CODES", "DemInput", "dem", "style_of"]

#: Styles of each code, by name; the first style is the default.
CODES: dict[str, dict[str, Style]] = {
    "lammps": lammps.STYLES,
    "liggghts": liggghts.STYLES,
    "yade": yade.STYLES,
    "mercurydpm": mercurydpm.STYLES,
    "chrono": chrono.STYLES,
    "lethe": lethe.STYLES,
    "mujoco": mujoco.STYLES,
    "kratos": kratos.STYLES,
}

#: Start and end of a comment line; "# " and "" in codes that are not listed.
_COMMENT = {"chrono": ("// ", ""), "mercurydpm": ("// ", ""), "kratos": ("// ", ""), "mujoco": ("<!-- ", " -->")}


@dataclass(frozen=True, slots=True, kw_only=True, eq=False, repr=False)
class DemInput:
    """Input lines for a discrete-element code, with their torque law and its error.

    Attributes
    ----------
    code, style : str
        Name of the code, and of its model.
    point : OperatingPoint
        Load, speed and radius at which the torque is exact.
    stiffness : Stiffness
        Load as a function of penetration.
    contact_model : ContactModel
        Lines, parameters, torque law and source.
    points : list of OperatingPoint
        All points of the result or study.
    error : float
        Largest relative error of the code's torque over these points [-]; NaN for a single point.
    impact : Impact or None
        Normal impact whose restitution the lines contain.
    """

    code: str
    style: str
    point: OperatingPoint
    stiffness: Stiffness
    contact_model: ContactModel
    points: list[OperatingPoint]
    error: float
    impact: Impact | None = None

    @property
    def parameters(self) -> dict[str, float]:
        """Numbers in the lines, by the names that the code uses."""
        return self.contact_model.parameters

    @property
    def text(self) -> str:
        """Input lines, preceded by a comment that states load, speed, law, source and error."""
        start, end = _COMMENT.get(self.code, ("# ", ""))
        return "\n".join([*(f"{start}{line}{end}" for line in self._comment()), *self.contact_model.lines]) + "\n"

    def save(self, path: str | Path) -> Path:
        """Write the input lines to a file, and the torques T(P, Ω) of all points to a CSV file beside it.

        None of the codes accepts a table of torques. For filled rubber the CSV file contains both torques.

        Returns
        -------
        Path
            Path of the CSV file.
        """
        path = Path(path)
        write_text(self.text, path)
        table = path.with_suffix(".csv")
        heads = {"load": "N", "angular_speed": "rad/s", "torque": "N m", "penetration": "m"}
        columns = {f"{name} [{unit}]": [getattr(p, name) for p in self.points] for name, unit in heads.items()}
        bounds = [point.bounds for point in self.points if point.bounds is not None]
        if len(bounds) == len(self.points):
            both = zip(*bounds, strict=True)
            columns |= {f"{name} [N m]": list(values) for name, values in zip(BOUNDS, both, strict=True)}
        write_csv(columns, table)
        return table

    def __repr__(self) -> str:
        """Return the input lines with their comment."""
        return self.text

    def _pair(self) -> str:
        if not self.point.balls.are_two:
            return "a ball on a plane"
        first, other = self.point.balls.radii
        return f"two balls (R1 = {first:g} m rotates at Omega, R2 = {other:g} m, 1/R = 1/R1 + 1/R2)"

    def _bounds(self) -> list[str]:
        if self.point.bounds is None:
            return []
        harmonic, network = self.point.bounds
        return [
            f"filled rubber: T = {harmonic:.6g} N m if the loss of the filler network is summed over harmonics, "
            f"{network:.6g} N m if the network is rate-independent; the true value may lie between the two, or beyond"
        ]

    def _restitution(self) -> list[str]:
        if self.impact is None:
            return []
        hit = self.impact
        return [
            f"restitution e = {hit.restitution:.6g} of an impact at {hit.impact_speed:g} m/s with the mass "
            f"{hit.mass:g} kg (of two balls m1 m2/(m1 + m2)); it depends on the speed"
        ]

    def _comment(self) -> list[str]:
        p, k = self.point, self.stiffness
        lines = [
            f"viscoroll: rolling resistance of {self._pair()} for {self.code}, {self.style}",
            f"the law has the computed torque at load P = {p.load:g} N, speed Omega = {p.angular_speed:g} rad/s, "
            f"radius R = {p.radius:g} m: torque T = {p.torque:.6g} N m (power dissipated per "
            f"{'relative ' * p.balls.are_two}angular speed), "
            f"T/(P R) = {p.coefficient:.6g}",
            *self._bounds(),
            f"law: {self.contact_model.torque_law}",
            f"source: {self.contact_model.source}",
            *self._restitution(),
        ]
        if len(self.points) > 1:
            loads, speeds = [q.load for q in self.points], [q.angular_speed for q in self.points]
            lines += [
                f"over P = {min(loads):g} to {max(loads):g} N and Omega = {min(speeds):g} to {max(speeds):g} rad/s "
                f"the error of this law is at most {self.error:.1%}; the CSV file contains the computed torques",
                f"stiffness in this range: Hertz {k.hertz:.6g} Pa within {k.hertz_error:.1%}, "
                f"Hooke {k.hooke:.6g} N/m within {k.hooke_error:.1%} of the load",
            ]
        else:
            lines.append(
                f"stiffness from the penetration {p.penetration:.6g} m: Hertz {k.hertz:.6g} Pa, Hooke {k.hooke:.6g} "
                "N/m; the error at other loads and speeds is unknown: pass a study to estimate it"
            )
        return lines


def dem(
    source: Result | StrainSoftening | xarray.Dataset,
    *,
    code: str,
    style: str | None = None,
    load: float | None = None,
    angular_speed: float | None = None,
    impact: Impact | None = None,
) -> DemInput:
    """Return the input for rolling friction, and optionally normal damping, in a particle code.

    Each code defines its coefficient differently. The docstrings of the modules in `viscoroll.export` cite the
    definitions. The torque is the dissipated power divided by the angular speed; for two balls, by their relative
    angular speed, with opposite torques on both. It is the torque of linear theory, because a study of two coated balls
    or of filled rubber has no other; where `Result.finite_strain_torque` is known, its ratio to
    `Result.resisting_torque` is the correction for finite strain.

    Parameters
    ----------
    source : Result, StrainSoftening or xarray.Dataset
        Result for a ball on a plane or on another ball, or a study of `viscoroll.sweep` over load, angular speed, or
        both. For a study, the largest error of the code's law over all points is computed and the stiffness is fitted.
        A result for filled rubber provides two torques.
    code : {"lammps", "liggghts", "yade", "mercurydpm", "chrono", "lethe", "mujoco", "kratos"}
        Name of the code.
    style : str, optional
        Model of that code: "sds" or "viscous" (LAMMPS), "epsd2", "epsd" or "cdt" (LIGGGHTS), "nsc", "multicore" or
        "dem" (Chrono), "constant", "viscous" or "epsd" (Lethe), "constant" or "viscous" (Kratos); by default the first.
    load, angular_speed : float, optional
        Point of the study at which the torque is exact [N], [rad/s]; by default the middle one.
    impact : Impact, optional
        Normal impact of the same balls, from `impact`. The lines then contain its restitution, or the damping of the
        code that has this restitution.

    Returns
    -------
    DemInput
        Input lines, torque law and error, with a method that writes the files.

    Raises
    ------
    ValueError
        If code or style is unknown; if the study does not contain the load or speed, or varies anything else; if the
        body is not a ball on a plane or ball; or if the law does not apply to two balls.

    Examples
    --------
    >>> import viscoroll as vr
    >>> from viscoroll import paper
    >>> r = vr.solve(paper.ball(), load=100.0, angular_speed=2.5)
    >>> print(round(vr.export.dem(r, code="mercurydpm").parameters["rollingFrictionCoefficient"], 4))
    0.0027
    """
    chosen = style_of(code, style)
    require_type("impact", impact, Impact, optional=True)
    points = operating_points(source)
    point = _nearest(points, load, angular_speed)
    stiffness = Stiffness.fitted([q for q in points if q.angular_speed == point.angular_speed])
    contact_model = CODES[code][chosen](point, stiffness)
    if impact is not None:
        contact_model = with_restitution(code, contact_model, impact, stiffness)
    loads, speeds = np.array([p.load for p in points]), np.array([p.relative_speed for p in points])
    ratio = contact_model.law(loads, speeds) / np.array([p.torque for p in points])
    return DemInput(
        code=code,
        style=chosen,
        point=point,
        stiffness=stiffness,
        contact_model=contact_model,
        points=points,
        error=float(np.abs(ratio - 1.0).max()) if len(points) > 1 else math.nan,
        impact=impact,
    )


def style_of(code: str, style: str | None, balls: Balls | None = None) -> str:
    """Return the style of a code, by default the first one.

    Parameters
    ----------
    code, style : str
        Same as in `dem`.
    balls : Balls, optional
        Balls in contact; if given, the style must apply to them.

    Raises
    ------
    ValueError
        If code or style is unknown, or the style does not apply to the balls.
    """
    if code not in CODES:
        raise InvalidInput("code", f"must be one of {', '.join(CODES)}", shown(code))
    styles = CODES[code]
    if style is not None and style not in styles:
        raise ValueError(f"style of {code} must be one of {', '.join(styles)}, got {shown(style)}")
    chosen = style or next(iter(styles))
    if balls is not None:  # each style rejects balls to which it does not apply, whatever the numbers
        point = OperatingPoint(balls=balls, load=1.0, angular_speed=1.0, torque=1.0, penetration=0.01 * balls.radius)
        styles[chosen](point, Stiffness.fitted([point]))
    return chosen


def _nearest(points: list[OperatingPoint], load: float | None, speed: float | None) -> OperatingPoint:
    loads, speeds = sorted({p.load for p in points}), sorted({p.angular_speed for p in points})
    wanted_load = loads[len(loads) // 2] if load is None else as_float("load", load)
    wanted_speed = speeds[len(speeds) // 2] if speed is None else as_float("angular_speed", speed)
    for name, value, known, unit in (
        ("load", wanted_load, loads, "N"),
        ("angular_speed", wanted_speed, speeds, "rad/s"),
    ):
        if value not in known:
            raise InvalidInput(name, f"must be one of {', '.join(f'{v:g}' for v in known)} {unit}", f"{value:g}")
    found = [p for p in points if p.load == wanted_load and p.angular_speed == wanted_speed]
    if not found:
        raise InvalidInput(
            "load", "must be a solved point of the study", f"{wanted_load:g} N at {wanted_speed:g} rad/s, which failed"
        )
    return found[0]
