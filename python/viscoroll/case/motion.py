"""Motions in TOML files, checked with pydantic (the extra `viscoroll[cli]`)."""

from __future__ import annotations

from dataclasses import dataclass, fields
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import numpy as np

from .. import _core
from .._core import Compliance, Curvature, Start
from .._support.arguments import as_float
from .._support.columns import read_columns
from .._support.errors import InvalidInput
from .._support.toml import read_toml
from ..bodies import Counterbody, Drive, RollingBody
from ..transient.roll import roll
from .case import CaseFile, MeshTable, PairTables
from .ground import AxleTable, ProfileTable
from .tables import ByName, FileName, StrictTable, checked, errors_in

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from ..transient.history import History

__all__ = ["MotionCase", "MotionFile", "build_motion", "load_motion"]


class Motion(StrictTable):
    """The table `motion`: waypoints in lists or in a file, or an oscillation.

    Parameters
    ----------
    file : str
        CSV file with the columns time, angle or distance, and load.
    amplitude : float
        Amplitude of an oscillation about the start [rad].
    frequency : float
        Frequency of the oscillation [Hz].
    cycles : float, optional
        Number of cycles, in (0, 1e4].
    driving_force : float, optional
        Force on the center [N]; needs friction.
    driving_torque : float, optional
        Torque on the body [N m] instead of a driving force.
    """

    documented_by = (roll,)

    time: list[float] | None = None
    angle: list[float] | None = None
    distance: list[float] | None = None
    load: float | list[float] | None = None
    axle_height: float | list[float] | None = None
    file: FileName | None = None
    amplitude: float | None = None
    frequency: float | None = None
    cycles: float = 1.0
    start: Annotated[Start, ByName()] = Start.RELAXED
    friction: float = 0.0
    driving_force: float = 0.0
    driving_torque: float | None = None
    center_displacement: list[float] | None = None
    mass: float = 0.0
    center_speed: float = 0.0


class Numerics(MeshTable):
    """The table `numerics` of a motion."""

    documented_by = (*MeshTable.documented_by, roll)

    compliance: Annotated[Compliance, ByName()] = Compliance.RADIAL
    curvature: Annotated[Curvature, ByName(Curvature.SPHERE, Curvature.PAPER)] = Curvature.SPHERE
    averaged_meshes: int = 4
    steps_per_spacing: int | None = 4
    spectrum_tolerance: float = 0.01


class MotionFile(PairTables):
    """A motion file."""

    motion: Motion
    numerics: Numerics = Numerics()
    ground: ProfileTable | None = None
    tread: ProfileTable | None = None
    axle: AxleTable | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class MotionCase:
    """A motion, as a file describes it. Parameters as in `viscoroll.roll`."""

    body: RollingBody
    on: Counterbody | None
    time: NDArray[np.float64]
    angle: NDArray[np.float64] | None
    distance: NDArray[np.float64] | None
    load: NDArray[np.float64] | float | None
    axle_height: NDArray[np.float64] | float | None
    center_displacement: NDArray[np.float64] | None
    start: Start
    options: dict[str, Any]

    def roll(self, **options: Any) -> History:
        """Compute the history of the motion. `options` go to `viscoroll.roll` and override those of the file."""
        given = {field.name: getattr(self, field.name) for field in fields(self) if field.name != "options"}
        return roll(**given | self.options | options)


def load_motion(path: str | Path) -> MotionCase:
    """Read a motion from a TOML file; ``viscoroll.case.example_text("motion")`` is a commented example.

    Raises
    ------
    ValueError
        If the file is not valid. The message is one line and names the key in the file.
    OSError
        If the file cannot be read.
    """
    path = Path(path)
    with errors_in(path):
        return build_motion(read_toml(path), path.parent)


def build_motion(document: dict[str, Any], folder: Path | None) -> MotionCase:
    """Return the motion that the content of a file describes; parameters as in `viscoroll.case.build_case`."""
    return _build(checked(MotionFile, document, folder), document)


def _rolling_load(document: dict[str, Any]) -> float | None:
    """Return the load of the table `rolling`, which holds if the table `motion` has none."""
    rolling = document.get("rolling")
    if not isinstance(rolling, dict) or "load" not in rolling:
        return None
    load = CaseFile.keys_of(document).in_si({"rolling": {"load": rolling["load"]}})["rolling"]["load"]
    return as_float("rolling.load", load)


def _build(file: MotionFile, document: dict[str, Any]) -> MotionCase:
    motion = file.motion
    return MotionCase(
        **file.pair(document),
        **(
            {"angle": None, "distance": None, "center_displacement": None, "axle_height": None}
            | _waypoints(motion, _rolling_load(document))
        ),
        start=motion.start,
        options={
            "friction": motion.friction,
            "drive": _drive(motion),
            "mass": motion.mass,
            "center_speed": motion.center_speed,
            "ground": file.ground,
            "tread": file.tread,
            "axle": file.axle,
            **file.numerics.arguments(),
        },
    )


def _drive(motion: Motion) -> Drive:
    if motion.driving_torque is None:
        return Drive(force=motion.driving_force)
    if motion.driving_force != 0.0:
        raise InvalidInput("motion.driving_force", "must be left out with driving_torque")
    return Drive(torque=motion.driving_torque)


def _waypoints(motion: Motion, rolling_load: float | None) -> dict[str, Any]:
    """Return the waypoints by name, from lists, from a file or from an oscillation."""
    given = [name for name in ("time", "file", "amplitude") if getattr(motion, name) is not None]
    if len(given) != 1:
        raise InvalidInput(
            "motion", "must have exactly one of time, file and amplitude", f"{', '.join(given) or 'none'}"
        )
    match given[0]:
        case "file":
            return _table(motion, rolling_load)
        case "amplitude":
            return _oscillation(motion, rolling_load)
    load = rolling_load if motion.load is None and motion.axle_height is None else motion.load
    if (motion.angle is None and motion.distance is None) or (load is None and motion.axle_height is None):
        raise InvalidInput("motion", "must have load or axle_height, and angle or distance, with time")
    names = ("time", "angle", "distance", "axle_height", "center_displacement")
    return {name: getattr(motion, name) for name in names} | {"load": load}


def _table(motion: Motion, rolling_load: float | None) -> dict[str, Any]:
    assert motion.file is not None
    columns = read_columns("motion", motion.file, ("time",), ("angle", "distance", "load", "center_displacement"))
    if ("angle" in columns) == ("distance" in columns):
        raise ValueError(f"motion {motion.file}: must have exactly one of the columns angle and distance")
    load = rolling_load if motion.load is None else motion.load
    if "load" not in columns and load is None:
        raise InvalidInput("motion.load", f"must be given if {motion.file} has no column load")
    for name in ("load", "center_displacement"):
        if name in columns and getattr(motion, name) is not None:
            raise InvalidInput(f"motion.{name}", f"must be left out if {motion.file} has a column {name}")
    return {"load": load, "center_displacement": motion.center_displacement} | columns


def _oscillation(motion: Motion, rolling_load: float | None) -> dict[str, Any]:
    if motion.center_displacement is not None:
        raise InvalidInput("motion.center_displacement", "must be left out with amplitude")
    load = rolling_load if motion.load is None else motion.load
    if motion.frequency is None or load is None:
        raise InvalidInput("motion", "must have frequency and load with amplitude")
    oscillation = _core.Oscillation(amplitude=motion.amplitude, frequency=motion.frequency, cycles=motion.cycles)
    try:
        waypoints = _core.motion_of(oscillation)
    except InvalidInput as error:
        raise error.inside("motion") from None
    return {"time": np.array(waypoints.time), "angle": np.array(waypoints.angle), "load": load}
