"""Cases in TOML files, checked with pydantic (the extra `viscoroll[cli]`)."""

from __future__ import annotations

import csv
import tomllib
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, fields
from difflib import get_close_matches
from importlib import resources
from pathlib import Path
from typing import Any, Literal, TypeVar

from .. import materials
from .._core import Compliance, Curvature, Extrapolation, InnerBoundary, PatchLoad, SlipKinematics
from .._support.arguments import as_float, as_member
from .._support.extras import extra
from .._support.progress import ProgressLike
from .._support.text import one_line, shown
from ..bodies import (
    CoatedCylinder,
    CoatedPlane,
    CoatedSphere,
    Counterpart,
    Drive,
    Groove,
    HalfSpace,
    Layer,
    Mesh,
    RollingBody,
)
from ..interior import Core, SelfHeating, Temperature, self_heating, temperature
from ..materials import Arrhenius, WilliamsLandelFerry
from ..rheology import LossFactor, load_material
from ..rolling import Result, solve

with extra("cli"):
    from pydantic import BaseModel, ConfigDict, ValidationError
    from pydantic_core import ErrorDetails

__all__ = [
    "BallTable",
    "Case",
    "StrictTable",
    "Thermal",
    "build_ball",
    "build_case",
    "errors_in",
    "example_text",
    "first_line",
    "load_case",
    "read_toml",
]

_MATERIALS: dict[str, type[materials.ShearModulus]] = {
    "elastic": materials.Elastic,
    "standard_linear_solid": materials.StandardLinearSolid,
    "prony": materials.Prony,
    "kelvin_voigt": materials.KelvinVoigt,
    "fractional_zener": materials.FractionalZener,
    "master_curve": materials.MasterCurve,
    "loss_factor": LossFactor,
}

_SHIFTS: dict[str, type[WilliamsLandelFerry] | type[Arrhenius]] = {
    "williams_landel_ferry": WilliamsLandelFerry,
    "arrhenius": Arrhenius,
}

_COLUMNS = ("frequency", "storage", "loss")

_Choice = TypeVar("_Choice")


#: With or without the byte-order mark that some editors write.
_ENCODING = "utf-8-sig"


class StrictTable(BaseModel):
    """A table of the file: unknown keys and wrong types are errors."""

    model_config = ConfigDict(extra="forbid", strict=True)


class _Layer(StrictTable):
    thickness: float
    shear_modulus: dict[str, Any] | str | float
    poisson_ratio: float | None = None
    bulk_modulus: float | None = None
    density: float = 0.0
    conductivity: float | None = None


class BallTable(StrictTable):
    """The table `ball`."""

    core_radius: float = 0.0
    inner_boundary: str = "rigid"
    layers: list[_Layer] = []


class _Cylinder(StrictTable):
    core_radius: float
    layers: list[_Layer]


class _Base(StrictTable):
    shear_modulus: dict[str, Any] | str | float
    poisson_ratio: float | None = None
    bulk_modulus: float | None = None
    density: float = 0.0


class _Plane(StrictTable):
    layers: list[_Layer] = []
    base: _Base | None = None


class _Groove(_Plane):
    radius: float | None = None
    path_radius: float | None = None


class _Rolling(StrictTable):
    load: float
    angular_speed: float
    friction: float = 0.0
    drive: dict[str, Any] = {"force": 0.0}  # of `viscoroll.Drive`


class _Numerics(StrictTable):
    accuracy: float | None = None
    nodes_per_revolution: int | None = None
    max_order: int | None = None
    theta_nodes_per_revolution: int | None = None
    compliance: Literal["radial", "vertical"] = "radial"
    curvature: Literal["sphere", "paper", "exact"] = "sphere"
    patch_load: Literal["flat", "spherical"] = "flat"
    slip_kinematics: Literal["exact", "flat"] = "exact"


class _Thermal(StrictTable):
    convection: float
    ambient: float
    conductivity: float | list[float] | None = None
    core: Literal["insulated", "isothermal"] | float = "insulated"
    core_temperature: float | None = None
    shift: dict[str, Any] | None = None
    limit: float | None = None


class _File(StrictTable):
    ball: BallTable | None = None
    cylinder: _Cylinder | None = None
    plane: _Plane | None = None
    groove: _Groove | None = None
    rolling: _Rolling
    numerics: _Numerics = _Numerics()
    thermal: _Thermal | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class Thermal:
    """How a case is cooled. Parameters as of `viscoroll.temperature`, and `shift` and `limit` of `self_heating`."""

    convection: float
    ambient: float
    conductivity: float | list[float] | None
    core: Core | float
    core_temperature: float | None
    shift: WilliamsLandelFerry | Arrhenius | None
    limit: float | None

    def temperature(self, result: Result, *, progress: ProgressLike = None) -> Temperature:
        """Temperature with the moduli as they are."""
        return temperature(result, **self._cooling(), progress=progress)

    def _cooling(self) -> dict[str, Any]:
        names = ("convection", "ambient", "conductivity", "core", "core_temperature")
        return {name: getattr(self, name) for name in names}


@dataclass(frozen=True, slots=True, kw_only=True)
class Case:
    """One load case, as a file describes it. Parameters as of `viscoroll.solve`."""

    ball: RollingBody
    on: Counterpart | None = None
    load: float
    angular_speed: float
    friction: float
    drive: Drive
    mesh: Mesh | None
    accuracy: float | None
    compliance: Compliance
    curvature: Curvature
    patch_load: PatchLoad
    slip_kinematics: SlipKinematics
    thermal: Thermal | None = None

    def arguments(self) -> dict[str, Any]:
        """Return the arguments of `viscoroll.solve`."""
        return {field.name: getattr(self, field.name) for field in fields(self) if field.name != "thermal"}

    def solve(self, **options: Any) -> Result:
        """Solve the case; `options` go to `viscoroll.solve`."""
        return solve(**self.arguments(), **options)

    def self_heating(self, **options: Any) -> SelfHeating:
        """Find the steady states of temperature and torque of a case whose table [thermal] has a shift."""
        thermal = self.thermal
        shift = None if thermal is None else thermal.shift
        if thermal is None or shift is None:
            raise ValueError("thermal.shift must be given for self-heating")
        return self_heating(**self.arguments(), **thermal._cooling(), shift=shift, limit=thermal.limit, **options)


def load_case(path: str | Path) -> Case:
    """Read a case from a TOML file.

    Parameters
    ----------
    path : path-like
        The file; ``example_text()`` is a commented example.

    Returns
    -------
    Case
        Ready to solve.

    Raises
    ------
    ValueError
        Where the file is not valid: in one line, with the place in the file.
    OSError
        Where it cannot be read.
    """
    path = Path(path)
    with errors_in(path):
        return build_case(read_toml(path), path.parent)


@contextmanager
def errors_in(path: Path) -> Iterator[None]:
    """Turn an error about the content of a file into a ValueError of one line that names the file."""
    try:
        yield
    except RecursionError:
        raise ValueError(one_line(f"{path}: nested too deeply")) from None
    except (TypeError, ValueError) as error:
        raise ValueError(one_line(f"{path}: {error}")) from None


def read_toml(path: Path) -> dict[str, Any]:
    """Return the content of a TOML file.

    Raises
    ------
    ValueError
        Where it is none.
    OSError
        Where it cannot be read.
    """
    try:
        return tomllib.loads(path.read_text(encoding=_ENCODING))
    except ValueError as error:  # TOMLDecodeError and UnicodeDecodeError are, and integers of thousands of digits
        raise ValueError(f"not a TOML file: {error}") from None


def build_case(document: dict[str, Any], folder: Path) -> Case:
    """Return the case that the content of a file describes.

    Parameters
    ----------
    document : dict
        The content.
    folder : Path
        Where the files that it names are.

    Raises
    ------
    ValueError, TypeError
        Where the content is not valid.
    """
    try:
        file = _File.model_validate(document)
    except ValidationError as error:
        raise ValueError(first_line(error)) from None
    return _build(file, folder)


def example_text(name: Literal["case", "sweep", "motion"] = "case") -> str:
    """Return the commented example of a case file, of a motion, or of the table that makes a study of a case."""
    return resources.files("viscoroll").joinpath(f"examples/{name}.toml").read_text(encoding="utf-8")


def _build(file: _File, folder: Path) -> Case:
    numerics = file.numerics
    mesh = None
    if numerics.nodes_per_revolution is not None:
        if numerics.accuracy is not None:
            raise ValueError("numerics.accuracy must be left out where a mesh is given")
        mesh = Mesh(
            nodes_per_revolution=numerics.nodes_per_revolution,
            max_order=numerics.max_order,
            theta_nodes_per_revolution=numerics.theta_nodes_per_revolution,
        )
    elif numerics.max_order is not None or numerics.theta_nodes_per_revolution is not None:
        raise ValueError("numerics.nodes_per_revolution must be given with the rest of a mesh")
    return Case(
        ball=_rolling_body(file, folder),
        on=_counterpart(file, folder),
        load=file.rolling.load,
        angular_speed=file.rolling.angular_speed,
        friction=file.rolling.friction,
        drive=_drive(file.rolling.drive),
        mesh=mesh,
        accuracy=numerics.accuracy,
        compliance=Compliance[numerics.compliance.upper()],
        curvature=Curvature[numerics.curvature.upper()],
        patch_load=PatchLoad[numerics.patch_load.upper()],
        slip_kinematics=SlipKinematics[numerics.slip_kinematics.upper()],
        thermal=None if file.thermal is None else _thermal(file.thermal),
    )


def _drive(table: dict[str, Any]) -> Drive:
    if unknown := sorted(table.keys() - {field.name for field in fields(Drive)}):
        raise ValueError(f"rolling.drive has no parameter {', '.join(unknown)}")
    return Drive(**table)


def _thermal(table: _Thermal) -> Thermal:
    core = Core[table.core.upper()] if isinstance(table.core, str) else table.core
    return Thermal(**dict(table) | {"core": core, "shift": None if table.shift is None else _shift(dict(table.shift))})


def _shift(table: dict[str, Any]) -> WilliamsLandelFerry | Arrhenius:
    kind = table.pop("type", None)
    shift = _chosen("thermal.shift.type", kind, _SHIFTS)
    wanted = {field.name for field in fields(shift)}
    if table.keys() != wanted:
        raise ValueError(f"thermal.shift of type {kind} must have {', '.join(sorted(wanted))}, got {sorted(table)}")
    return shift(**table)


def build_ball(ball: BallTable, folder: Path) -> CoatedSphere:
    """Return the ball that a table describes; its master curves are files in a folder."""
    return CoatedSphere(
        core_radius=ball.core_radius,
        inner_boundary=as_member("inner_boundary", ball.inner_boundary, InnerBoundary),
        layers=_layers(ball.layers, "ball", folder),
    )


def _rolling_body(file: _File, folder: Path) -> RollingBody:
    if (file.ball is None) == (file.cylinder is None):
        raise ValueError(f"ball or cylinder must be given, and not both, got {'none' if file.ball is None else 'both'}")
    if file.cylinder is not None:
        return CoatedCylinder(
            core_radius=file.cylinder.core_radius, layers=_layers(file.cylinder.layers, "cylinder", folder)
        )
    assert file.ball is not None
    return build_ball(file.ball, folder)


def _counterpart(file: _File, folder: Path) -> Counterpart | None:
    if file.plane is not None and file.groove is not None:
        raise ValueError("plane or groove must be given, and not both, got both")
    if file.groove is not None:
        surface = _surface(file.groove, "groove", folder)
        return Groove(radius=file.groove.radius, path_radius=file.groove.path_radius, **surface)
    return None if file.plane is None else CoatedPlane(**_surface(file.plane, "plane", folder))


def _surface(surface: _Plane, name: str, folder: Path) -> dict[str, Any]:
    base = None
    if surface.base is not None:
        modulus = _shear_modulus(surface.base.shear_modulus, folder)
        base = HalfSpace(**dict(surface.base) | {"shear_modulus": modulus})
    return {"layers": _layers(surface.layers, name, folder), "base": base}


def _layers(layers: list[_Layer], name: str, folder: Path) -> list[Layer]:
    return [_layer(layer, f"{name}.layers[{j}]", folder) for j, layer in enumerate(layers)]


def _layer(layer: _Layer, name: str, folder: Path) -> Layer:
    try:
        return Layer(**dict(layer) | {"shear_modulus": _shear_modulus(layer.shear_modulus, folder)})
    except (TypeError, ValueError) as error:
        raise ValueError(f"{name}: {error}") from None


def _shear_modulus(given: dict[str, Any] | str | float, folder: Path) -> materials.ShearModulus:
    if isinstance(given, float | int):
        return materials.Elastic(modulus=given)
    table = {"type": "measured", "file": given} if isinstance(given, str) else dict(given)
    kind = table.pop("type", None)
    if kind == "measured":
        return _measured(table, folder)
    if not isinstance(kind, str) or kind not in _MATERIALS:
        names = ", ".join([*_MATERIALS, "measured"])
        raise ValueError(f"shear_modulus.type must be one of {names}, got {shown(kind)}")
    material = _MATERIALS[kind]
    if material is materials.MasterCurve:
        table = _master_curve(table, folder)
    known = {field.name for field in fields(material)}  # type: ignore[arg-type]
    if unknown := sorted(table.keys() - known):
        raise ValueError(f"shear_modulus of type {kind} has no parameter {', '.join(unknown)}")
    if missing := sorted(known - table.keys() - {"extrapolation", "decades"}):
        raise ValueError(f"shear_modulus of type {kind} needs {', '.join(missing)}")
    return material(**table)


def _measured(table: dict[str, Any], folder: Path) -> materials.ShearModulus:
    """Return a material of `viscoroll material`: file, and temperature and form where they are given."""
    if unknown := sorted(table.keys() - {"file", "temperature", "form"}):
        raise ValueError(f"shear_modulus of type measured has no parameter {', '.join(unknown)}")
    name = table.pop("file", None)
    if not isinstance(name, str):
        raise TypeError(f"shear_modulus.file must be the name of a file, got {shown(name)}")
    if "temperature" in table:
        table["temperature"] = as_float("shear_modulus.temperature", table["temperature"])
    try:
        return load_material(folder / name, **table)
    except OSError as error:
        raise ValueError(f"material {folder / name}: {error.strerror}") from None


def _master_curve(table: dict[str, Any], folder: Path) -> dict[str, Any]:
    """Replace the name of a file by its columns, and the name of an extrapolation by its member."""
    table = dict(table)
    if "file" in table:
        name = table.pop("file")
        if not isinstance(name, str):
            raise TypeError(f"shear_modulus.file must be the name of a file, got {shown(name)}")
        if both := [column for column in _COLUMNS if column in table]:
            raise ValueError(f"shear_modulus.file must be left out where columns are given, got {', '.join(both)} too")
        table |= _read_columns(folder / name)
    if "extrapolation" in table:
        members = {member.name.lower(): member for member in Extrapolation}
        table["extrapolation"] = _chosen("shear_modulus.extrapolation", table["extrapolation"], members)
    return table


def _read_columns(path: Path) -> dict[str, list[float]]:
    try:
        with path.open(newline="", encoding=_ENCODING) as file:
            rows = list(csv.DictReader(file, skipinitialspace=True))
        return {name: [float(row[name]) for row in rows] for name in _COLUMNS}
    except OSError as error:
        raise ValueError(f"master curve {path}: {error.strerror}") from None
    except (KeyError, TypeError, ValueError, csv.Error) as error:
        message = f"master curve {path}: needs numbers in columns {', '.join(_COLUMNS)} ({error})"
        raise ValueError(message) from None


def _chosen(name: str, value: object, choices: Mapping[str, _Choice]) -> _Choice:
    if not isinstance(value, str) or value not in choices:
        raise ValueError(f"{name} must be one of {', '.join(choices)}, got {shown(value)}")
    return choices[value]


#: Which command reads a file with such a table.
_COMMANDS = {"sweep": "viscoroll sweep", "motion": "viscoroll roll"}

#: Errors beside the first that are told one by one.
_MOST_TOLD = 3


def first_line(error: ValidationError) -> str:
    """Return what is wrong first, with its place in the file, and what else."""
    errors = error.errors()
    missing = [str(one["loc"][-1]) for one in errors if one["type"] == "missing"]
    unknown = [number for number, one in enumerate(errors) if one["type"] == "extra_forbidden"]
    meant = {  # a name that is misspelled is missing as well
        number: match for number in unknown for match in get_close_matches(str(errors[number]["loc"][-1]), missing, 1)
    }
    tables = [one["loc"][:-1] for one in errors if one["type"] == "missing" and len(one["loc"]) > 1]
    instead = [number for number in unknown if errors[number]["loc"][:-1] in tables]
    chosen = next(iter([*meant, *instead]), 0)
    name = str(errors[chosen]["loc"][-1])
    told = _told(errors[chosen])
    if chosen in meant:
        told += f"; did you mean {meant[chosen]}?"
    elif chosen in unknown and name in _COMMANDS and len(errors[chosen]["loc"]) == 1:
        told += f"; such a file is for `{_COMMANDS[name]}`"
    others = [
        _told(one, with_value=False)
        for number, one in enumerate(errors)
        if number != chosen and not (chosen in meant and one["type"] == "missing" and one["loc"][-1] == meant[chosen])
    ]
    if len(others) > _MOST_TOLD:
        return f"{told} (and {len(others)} more)"
    return "; ".join([told, *others])


def _told(error: ErrorDetails, *, with_value: bool = True) -> str:
    place = "".join(f"[{part}]" if isinstance(part, int) else f".{part}" for part in error["loc"]).lstrip(".")
    is_whole_table = error["type"] == "missing"
    got = f", got {shown(error['input'])}" if with_value and not is_whole_table else ""
    return f"{place}: {error['msg'][0].lower()}{error['msg'][1:]}{got}"
