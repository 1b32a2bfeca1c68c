"""Motions in TOML files, checked with pydantic (the extra `viscoroll[cli]`)."""

from __future__ import annotations

import csv
from dataclasses import dataclass, fields
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from .._core import Compliance, Curvature, Start
from .._support.extras import extra
from ..bodies import CoatedSphere, Drive, Mesh
from ..transient.roll import roll
from .case import BallTable, StrictTable, build_ball, errors_in, first_line, read_toml

with extra("cli"):
    from pydantic import ValidationError

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from ..transient.history import History

__all__ = ["MotionCase", "load_motion"]

#: Knots of an oscillation for each cycle.
_KNOTS = 160


class _Motion(StrictTable):
    time: list[float] | None = None
    angle: list[float] | None = None
    load: float | list[float] | None = None
    file: str | None = None
    amplitude: float | None = None
    frequency: float | None = None
    cycles: float = 1.0
    start: Literal["relaxed", "fresh"] = "relaxed"
    friction: float = 0.0
    driving_force: float = 0.0
    center_way: list[float] | None = None
    mass: float = 0.0
    center_speed: float = 0.0


class _Numerics(StrictTable):
    nodes_per_revolution: int | None = None
    max_order: int | None = None
    theta_nodes_per_revolution: int | None = None
    compliance: Literal["radial", "vertical"] = "radial"
    curvature: Literal["sphere", "paper"] = "sphere"
    lattices: int = 4
    steps_per_spacing: int | None = 4
    spectrum_tolerance: float = 0.01


class _File(StrictTable):
    ball: BallTable
    motion: _Motion
    numerics: _Numerics = _Numerics()


@dataclass(frozen=True, slots=True, kw_only=True)
class MotionCase:
    """A motion, as a file describes it. Parameters as of `viscoroll.roll`."""

    ball: CoatedSphere
    time: NDArray[np.float64]
    angle: NDArray[np.float64]
    load: NDArray[np.float64] | float
    center_way: NDArray[np.float64] | None
    start: Start
    friction: float
    drive: Drive
    mass: float
    center_speed: float
    mesh: Mesh | None
    compliance: Compliance
    curvature: Curvature
    lattices: int
    steps_per_spacing: int | None
    spectrum_tolerance: float

    def roll(self, **options: Any) -> History:
        """Follow the motion; `options` go to `viscoroll.roll`."""
        given = {field.name: getattr(self, field.name) for field in fields(self)}
        return roll(**given | options)


def load_motion(path: str | Path) -> MotionCase:
    """Read a motion from a TOML file; ``viscoroll.case.example_text("motion")`` is a commented example.

    Raises
    ------
    ValueError
        Where the file is not valid: in one line, with the place in the file.
    OSError
        Where it cannot be read.
    """
    path = Path(path)
    with errors_in(path):
        try:
            file = _File.model_validate(read_toml(path))
        except ValidationError as error:
            raise ValueError(first_line(error)) from None
        return _build(file, path.parent)


def _build(file: _File, folder: Path) -> MotionCase:
    numerics = file.numerics
    mesh = None
    if numerics.nodes_per_revolution is not None:
        mesh = Mesh(
            nodes_per_revolution=numerics.nodes_per_revolution,
            max_order=numerics.max_order,
            theta_nodes_per_revolution=numerics.theta_nodes_per_revolution,
        )
    elif numerics.max_order is not None or numerics.theta_nodes_per_revolution is not None:
        raise ValueError("numerics.nodes_per_revolution must be given with the rest of a mesh")
    knots = _motion(file.motion, folder)
    return MotionCase(
        ball=build_ball(file.ball, folder),
        time=knots["time"],
        angle=knots["angle"],
        load=knots["load"],
        center_way=knots.get("center_way"),
        start=Start[file.motion.start.upper()],
        friction=file.motion.friction,
        drive=Drive(force=file.motion.driving_force),
        mass=file.motion.mass,
        center_speed=file.motion.center_speed,
        mesh=mesh,
        compliance=Compliance[numerics.compliance.upper()],
        curvature=Curvature[numerics.curvature.upper()],
        lattices=numerics.lattices,
        steps_per_spacing=numerics.steps_per_spacing,
        spectrum_tolerance=numerics.spectrum_tolerance,
    )


def _motion(motion: _Motion, folder: Path) -> dict[str, Any]:
    """Return knots by name, in whichever of three ways they are given."""
    given = [name for name in ("time", "file", "amplitude") if getattr(motion, name) is not None]
    if len(given) != 1:
        raise ValueError(f"motion must have one of time, file and amplitude, got {', '.join(given) or 'none'}")
    match given[0]:
        case "file":
            assert motion.file is not None
            columns = _read_columns(folder / motion.file)
            if "load" not in columns and motion.load is None:
                raise ValueError("motion.load must be given where the file has no column load")
            for name in ("load", "center_way"):
                if name in columns and getattr(motion, name) is not None:
                    raise ValueError(f"motion.{name} must be left out where the file has a column {name}")
            return {"load": motion.load, "center_way": motion.center_way} | columns
        case "amplitude":
            return _oscillation(motion)
    if motion.angle is None or motion.load is None:
        raise ValueError("motion needs angle and load with time")
    return {name: getattr(motion, name) for name in ("time", "angle", "load", "center_way")}


def _oscillation(motion: _Motion) -> dict[str, Any]:
    if motion.center_way is not None:
        raise ValueError("motion.center_way must be left out with amplitude")
    if motion.frequency is None or motion.load is None:
        raise ValueError("motion needs frequency and load with amplitude")
    if not (np.isfinite(motion.frequency) and motion.frequency > 0.0):
        raise ValueError(f"motion.frequency must be > 0 Hz, got {motion.frequency!r}")
    if not 0.0 < motion.cycles <= 1e4:
        raise ValueError(f"motion.cycles must be in (0, 1e4], got {motion.cycles!r}")
    assert motion.amplitude is not None
    time = np.linspace(0.0, motion.cycles / motion.frequency, max(int(_KNOTS * motion.cycles), 1) + 1)
    angle = motion.amplitude * np.sin(2.0 * np.pi * motion.frequency * time)
    return {"time": time, "angle": angle, "load": motion.load}


def _read_columns(path: Path) -> dict[str, list[float]]:
    try:
        with path.open(newline="", encoding="utf-8-sig") as file:
            rows = list(csv.DictReader(file, skipinitialspace=True))
        names = ["time", "angle", *(name for name in ("load", "center_way") if rows and name in rows[0])]
        return {name: [float(row[name]) for row in rows] for name in names}
    except OSError as error:
        raise ValueError(f"motion {path}: {error.strerror}") from None
    except (KeyError, TypeError, ValueError, csv.Error) as error:
        raise ValueError(
            f"motion {path}: needs numbers in columns time, angle and maybe load, center_way ({error})"
        ) from None
