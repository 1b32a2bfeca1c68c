"""Rolling friction for discrete-element codes, by the definition of each."""

from __future__ import annotations

import math
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from .._support.arguments import as_float
from .._support.files import write_csv, write_text
from .._support.text import shown
from ..interior import StrainSoftening
from ..interior.softening_result import BOUNDS
from ..rolling import Result
from . import chrono, lammps, lethe, liggghts, mercurydpm, yade
from .contact import OperatingPoint, Stiffness, Style, Written, operating_points

if TYPE_CHECKING:
    import xarray

__all__ = ["CODES", "DemInput", "dem"]

#: Codes, and the styles of each; the first is the default.
CODES: dict[str, dict[str, Style]] = {
    "lammps": lammps.STYLES,
    "liggghts": liggghts.STYLES,
    "yade": yade.STYLES,
    "mercurydpm": mercurydpm.STYLES,
    "chrono": chrono.STYLES,
    "lethe": lethe.STYLES,
}

_COMMENT = {"chrono": "//", "mercurydpm": "//"}


@dataclass(frozen=True, slots=True, kw_only=True, eq=False, repr=False)
class DemInput:
    """Input lines for a discrete-element code, and what they are good for.

    Attributes
    ----------
    code, style : str
        Which code, and which of its models.
    point : OperatingPoint
        Load, speed and radius at which the torque is exact.
    stiffness : Stiffness
        Load against penetration.
    written : Written
        Lines, parameters, torque law and source.
    points : list of OperatingPoint
        All that are known.
    error : float
        Largest relative error of the code's torque over them [-]; NaN for a single one.
    """

    code: str
    style: str
    point: OperatingPoint
    stiffness: Stiffness
    written: Written
    points: list[OperatingPoint]
    error: float

    @property
    def parameters(self) -> dict[str, float]:
        """The numbers in the lines, by the code's names."""
        return self.written.parameters

    @property
    def text(self) -> str:
        """Input lines behind a comment that says what they hold for."""
        mark = _COMMENT.get(self.code, "#")
        return "\n".join([*(f"{mark} {line}" for line in self._comment()), *self.written.lines]) + "\n"

    def save(self, path: str | Path) -> Path:
        """Write the text, and the torques T(P, Ω) of all points as CSV beside it, since no code takes a table.

        Of filled rubber both torques are in it.

        Returns
        -------
        Path
            Of the table.
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
        """Return the text."""
        return self.text

    def _pair(self) -> str:
        if not self.point.balls.are_two:
            return "a ball on a plane"
        first, other = self.point.balls.radii
        return f"two balls, R1 = {first:g} m at Omega, R2 = {other:g} m, 1/R = 1/R1 + 1/R2,"

    def _bounds(self) -> list[str]:
        if self.point.bounds is None:
            return []
        harmonic, network = self.point.bounds
        return [
            f"filled rubber: T = {harmonic:.6g} N m with its network's loss summed over harmonics, {network:.6g} N m "
            "with that of a network without rate; what is not known lies between the two, or beyond"
        ]

    def _comment(self) -> list[str]:
        p, k = self.point, self.stiffness
        lines = [
            f"viscoroll: rolling resistance of {self._pair()} for {self.code}, {self.style}",
            f"exact at load P = {p.load:g} N, speed Omega = {p.angular_speed:g} rad/s, radius R = {p.radius:g} m: "
            f"torque T = {p.torque:.6g} N m (power lost per {'relative ' * p.balls.are_two}speed), "
            f"T/(P R) = {p.coefficient:.6g}",
            *self._bounds(),
            f"law: {self.written.torque_law}",
            f"source: {self.written.source}",
        ]
        if len(self.points) > 1:
            loads, speeds = [q.load for q in self.points], [q.angular_speed for q in self.points]
            lines += [
                f"over P = {min(loads):g} to {max(loads):g} N and Omega = {min(speeds):g} to {max(speeds):g} rad/s "
                f"this torque is off by up to {self.error:.1%}; the CSV file beside has the right ones",
                f"stiffness over them: Hertz {k.hertz:.6g} Pa within {k.hertz_error:.1%}, "
                f"Hooke {k.hooke:.6g} N/m within {k.hooke_error:.1%} of the load",
            ]
        else:
            lines.append(
                f"stiffness by penetration {p.penetration:.6g} m: Hertz {k.hertz:.6g} Pa, Hooke {k.hooke:.6g} N/m; "
                "at other loads and speeds the error is not known: give a study"
            )
        return lines


def dem(
    source: Result | StrainSoftening | xarray.Dataset,
    *,
    code: str,
    style: str | None = None,
    load: float | None = None,
    angular_speed: float | None = None,
) -> DemInput:
    """Write rolling friction as a discrete-element code takes it.

    Every code means something else by its coefficient; the docstrings of the modules of `viscoroll.export` cite where
    each defines it. The torque is the power lost per speed, of two balls relative to each other, where both take it in
    opposite senses.

    Parameters
    ----------
    source : Result, StrainSoftening or xarray.Dataset
        Of a ball on a plane, or on another one: one result, of filled rubber with both torques, or a study of
        `viscoroll.sweep` over load, angular speed, or both: then the error that the code's law commits over it is
        known, and the stiffness is fitted.
    code : {"lammps", "liggghts", "yade", "mercurydpm", "chrono", "lethe"}
        Which.
    style : str, optional
        Model of that code: "sds" or "viscous" (LAMMPS), "epsd2", "epsd" or "cdt" (LIGGGHTS), "nsc", "multicore" or
        "dem" (Chrono), "constant" or "viscous" (Lethe); by default the first.
    load, angular_speed : float, optional
        Point of the study at which the torque is to be exact [N], [rad/s]; by default the middle one.

    Returns
    -------
    DemInput
        Lines, law, error and files.

    Raises
    ------
    ValueError
        For an unknown code or style, and a load or speed that the study does not have; for rollers, grooves, studies
        over more than load and speed, and balls on balls where a code's law is none for them.

    Examples
    --------
    >>> import viscoroll as vr
    >>> from viscoroll import paper
    >>> r = vr.solve(paper.ball(), load=100.0, angular_speed=2.5)
    >>> print(round(vr.dem(r, code="mercurydpm").parameters["rollingFrictionCoefficient"], 4))
    0.0027
    """
    if code not in CODES:
        raise ValueError(f"code must be one of {', '.join(CODES)}, got {shown(code)}")
    styles = CODES[code]
    if style is not None and style not in styles:
        raise ValueError(f"style of {code} must be one of {', '.join(styles)}, got {shown(style)}")
    chosen = style or next(iter(styles))
    points = operating_points(source)
    point = _nearest(points, load, angular_speed)
    stiffness = Stiffness.fitted([q for q in points if q.angular_speed == point.angular_speed])
    written = styles[chosen](point, stiffness)
    loads, speeds = np.array([p.load for p in points]), np.array([p.relative_speed for p in points])
    ratio = written.law(loads, speeds) / np.array([p.torque for p in points])
    return DemInput(
        code=code,
        style=chosen,
        point=point,
        stiffness=stiffness,
        written=written,
        points=points,
        error=float(np.abs(ratio - 1.0).max()) if len(points) > 1 else math.nan,
    )


def _nearest(points: list[OperatingPoint], load: float | None, speed: float | None) -> OperatingPoint:
    loads, speeds = sorted({p.load for p in points}), sorted({p.angular_speed for p in points})
    wanted_load = loads[len(loads) // 2] if load is None else as_float("load", load)
    wanted_speed = speeds[len(speeds) // 2] if speed is None else as_float("angular_speed", speed)
    for name, value, known, unit in (
        ("load", wanted_load, loads, "N"),
        ("angular_speed", wanted_speed, speeds, "rad/s"),
    ):
        if value not in known:
            raise ValueError(f"{name} must be one of {', '.join(f'{v:g}' for v in known)} {unit}, got {value:g}")
    found = [p for p in points if p.load == wanted_load and p.angular_speed == wanted_speed]
    if not found:
        raise ValueError(f"load {wanted_load:g} N at {wanted_speed:g} rad/s must be a point that did not fail")
    return found[0]
