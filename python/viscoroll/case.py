"""Cases in TOML files, checked with pydantic (the extra `viscoroll[cli]`).

A table of the file is read as an object of this package, whose parameters are its keys: pydantic finds keys that are
unknown or missing, and the place in the file; the classes themselves check values and have the defaults.
"""

from __future__ import annotations

import csv
import inspect
import tomllib
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, fields
from difflib import get_close_matches
from enum import Enum
from importlib import resources
from itertools import pairwise
from pathlib import Path
from typing import Annotated, Any, Literal, TypeAlias, TypeVar

from . import materials
from ._arrays import as_member
from ._core import Compliance, Curvature, Extrapolation, PatchLoad, SlipKinematics
from ._extras import extra
from ._text import one_line, shown
from .drive import Drive
from .geometry import CoatedCylinder, CoatedPlane, CoatedSphere, Counterpart, Groove, HalfSpace, Layer, RollingBody
from .interior import Core, SelfHeating, Temperature, self_heating, temperature
from .mesh import Mesh
from .progress import ProgressLike
from .result import Result
from .rheology import LossFactor, load_material
from .rolling import solve
from .shift import Arrhenius, WilliamsLandelFerry

with extra("cli"):
    from pydantic import (
        BaseModel,
        BeforeValidator,
        ConfigDict,
        Field,
        GetCoreSchemaHandler,
        ValidationError,
        ValidationInfo,
        create_model,
    )
    from pydantic_core import CoreSchema, ErrorDetails, core_schema

__all__ = [
    "BallTable",
    "ByName",
    "Case",
    "FileName",
    "MeshTable",
    "StrictTable",
    "Thermal",
    "build_case",
    "checked",
    "errors_in",
    "example_text",
    "first_line",
    "load_case",
    "read_columns",
    "read_toml",
]

_Model = TypeVar("_Model", bound="StrictTable")

#: With or without the byte-order mark that some editors write.
_ENCODING = "utf-8-sig"


class StrictTable(BaseModel):
    """A table of the file: unknown keys and wrong types are errors."""

    model_config = ConfigDict(extra="forbid", strict=True, frozen=True)


class _Table:
    """Mark of a class that a table of the file is read as, or of what `make` makes of its keys.

    The keys are its keyword arguments, of any type but where `types` says more, and `type` in a table of several kinds.
    """

    def __init__(self, kind: str | None = None, make: Callable[..., Any] | None = None, **types: Any) -> None:
        self._make = make
        self._types = types | ({} if kind is None else {"type": Literal[kind]})

    def __get_pydantic_core_schema__(self, source: Callable[..., Any], handler: GetCoreSchemaHandler) -> CoreSchema:
        make = self._make or source
        parameters = inspect.signature(make).parameters
        needed = {"type"} | {name for name, parameter in parameters.items() if parameter.default is parameter.empty}
        keys: dict[str, Any] = {
            name: (self._types.get(name, Any), Field() if name in needed else None)
            for name in [*parameters, *self._types]
        }

        def made(table: StrictTable) -> Any:
            try:
                return make(**{name: getattr(table, name) for name in table.model_fields_set - {"type"}})
            except TypeError as error:  # of values: those of keys are found above
                raise ValueError(str(error)) from None

        model = create_model(make.__name__, __base__=StrictTable, **keys)
        return core_schema.no_info_after_validator_function(made, handler.generate_schema(model))


class ByName:
    """Mark of an enumeration whose members, or some of them alone, the file names in lower case."""

    def __init__(self, *members: Enum) -> None:
        self._members = members

    def __get_pydantic_core_schema__(self, source: type[Enum], handler: GetCoreSchemaHandler) -> CoreSchema:
        """Return the names, and how a member is found by them."""
        members = {member.name.lower(): member for member in self._members or source}
        return core_schema.no_info_after_validator_function(
            members.__getitem__, core_schema.literal_schema(list(members))
        )


def _in_folder(name: object, info: ValidationInfo) -> Path:
    if not isinstance(name, str):
        raise ValueError(f"file must be the name of a file, got {shown(name)}")
    assert isinstance(info.context, Path)
    return info.context / name


#: The name of a file beside the case file.
FileName: TypeAlias = Annotated[Path, BeforeValidator(_in_folder)]


def _measured(
    *, file: Path, temperature: float | None = None, form: Literal["table", "prony"] = "table"
) -> materials.MasterCurve | materials.Prony:
    """Return a material of `viscoroll material`."""
    try:
        return load_material(file, temperature=temperature, form=form)
    except OSError as error:
        raise ValueError(f"material {file}: {error.strerror}") from None


def _with_columns(table: dict[str, Any], info: ValidationInfo) -> dict[str, Any]:
    """Replace the name of a file by the columns of a master curve in it."""
    if "file" not in table:
        return table
    names = ("frequency", "storage", "loss")
    if both := [name for name in names if name in table]:
        raise ValueError(f"file must be left out where columns are given, got {', '.join(both)} too")
    columns = read_columns("master curve", _in_folder(table["file"], info), names)
    return {key: value for key, value in table.items() if key != "file"} | columns


def _typed(given: object) -> object:
    """Return a table with a type, be it none."""
    return {"type": None} | given if isinstance(given, dict) else given


def _as_table(given: object) -> object:
    """Return the table that a number or the name of a file stands for."""
    if isinstance(given, str):
        return {"type": "measured", "file": given}
    if isinstance(given, float | int) and not isinstance(given, bool):
        return {"type": "elastic", "modulus": given}
    if not isinstance(given, dict):
        raise ValueError(f"shear_modulus must be a table, a number or the name of a file, got {shown(given)}")
    return _typed(given)


_Modulus: TypeAlias = Annotated[
    Annotated[materials.Elastic, _Table("elastic")]
    | Annotated[materials.StandardLinearSolid, _Table("standard_linear_solid")]
    | Annotated[materials.Prony, _Table("prony")]
    | Annotated[materials.KelvinVoigt, _Table("kelvin_voigt")]
    | Annotated[materials.FractionalZener, _Table("fractional_zener")]
    | Annotated[
        materials.MasterCurve,
        _Table("master_curve", extrapolation=Annotated[Extrapolation, ByName()]),
        BeforeValidator(_with_columns),
    ]
    | Annotated[LossFactor, _Table("loss_factor")]
    | Annotated[materials.ShearModulus, _Table("measured", _measured, file=FileName, temperature=float)],
    Field(discriminator="type"),
    BeforeValidator(_as_table),
]

_Shift: TypeAlias = Annotated[
    Annotated[WilliamsLandelFerry, _Table("williams_landel_ferry")] | Annotated[Arrhenius, _Table("arrhenius")],
    Field(discriminator="type"),
    BeforeValidator(_typed),
]

_Layers: TypeAlias = list[Annotated[Layer, _Table(shear_modulus=_Modulus)]]
_Base: TypeAlias = Annotated[HalfSpace, _Table(shear_modulus=_Modulus)]

#: The table `ball`.
BallTable: TypeAlias = Annotated[CoatedSphere, _Table(layers=_Layers)]


class _Rolling(StrictTable):
    load: float
    angular_speed: float
    friction: float = 0.0
    drive: Annotated[Drive, _Table()] = Drive(force=0.0)


class MeshTable(StrictTable):
    """Base of the table `numerics`: keyword arguments, those of a mesh among them."""

    nodes_per_revolution: int | None = None
    max_order: int | None = None
    theta_nodes_per_revolution: int | None = None

    def arguments(self) -> dict[str, Any]:
        """Return keyword arguments with the mesh as one, or None where it is left out."""
        given = dict(self)
        numbers = {parameter.name: given.pop(parameter.name) for parameter in fields(Mesh)}
        if self.nodes_per_revolution is not None:
            return given | {"mesh": Mesh(**numbers)}
        if any(number is not None for number in numbers.values()):
            raise ValueError("numerics.nodes_per_revolution must be given with the rest of a mesh")
        return given | {"mesh": None}


class _Numerics(MeshTable):
    accuracy: float | None = None
    compliance: Annotated[Compliance, ByName()] = Compliance.RADIAL
    curvature: Annotated[Curvature, ByName()] = Curvature.SPHERE
    patch_load: Annotated[PatchLoad, ByName()] = PatchLoad.FLAT
    slip_kinematics: Annotated[SlipKinematics, ByName()] = SlipKinematics.EXACT


def _core_of(given: object) -> object:
    return as_member("core", given, Core) if isinstance(given, str) else given


class Thermal(StrictTable):
    """How a case is cooled. Parameters as of `viscoroll.self_heating`; without a `shift` moduli stay as they are."""

    convection: float
    ambient: float
    conductivity: float | list[float] | None = None
    core: Annotated[Core | float, BeforeValidator(_core_of)] = Core.INSULATED
    core_temperature: float | None = None
    shift: _Shift | None = None
    limit: float | None = None

    def temperature(self, result: Result, *, progress: ProgressLike = None) -> Temperature:
        """Temperature with the moduli as they are."""
        cooling = {name: value for name, value in self if name not in ("shift", "limit")}
        return temperature(result, **cooling, progress=progress)


class _File(StrictTable):
    ball: BallTable | None = None
    cylinder: Annotated[CoatedCylinder, _Table(layers=_Layers)] | None = None
    plane: Annotated[CoatedPlane, _Table(layers=_Layers, base=_Base)] | None = None
    groove: Annotated[Groove, _Table(layers=_Layers, base=_Base)] | None = None
    rolling: _Rolling
    numerics: _Numerics = _Numerics()
    thermal: Thermal | None = None


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
        if self.thermal is None or self.thermal.shift is None:
            raise ValueError("thermal.shift must be given for self-heating")
        return self_heating(**self.arguments(), **dict(self.thermal), **options)


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
    file = checked(_File, document, folder)
    bodies = [body for body in (file.ball, file.cylinder) if body is not None]
    surfaces = [surface for surface in (file.plane, file.groove) if surface is not None]
    if len(bodies) != 1:
        raise ValueError(f"ball or cylinder must be given, and not both, got {'both' if bodies else 'none'}")
    if len(surfaces) > 1:
        raise ValueError("plane or groove must be given, and not both, got both")
    numerics = file.numerics.arguments()
    if numerics["mesh"] is not None and numerics["accuracy"] is not None:
        raise ValueError("numerics.accuracy must be left out where a mesh is given")
    return Case(
        ball=bodies[0],
        on=surfaces[0] if surfaces else None,
        thermal=file.thermal,
        **dict(file.rolling),
        **numerics,
    )


def checked(kind: type[_Model], document: dict[str, Any], folder: Path = Path()) -> _Model:
    """Return the tables of a file whose `kind` says what they may hold; files that they name are in a folder.

    Raises
    ------
    ValueError
        Where they hold something else, with the place in the file.
    """
    try:
        return kind.model_validate(document, context=folder)
    except ValidationError as error:
        raise ValueError(first_line(error)) from None


def example_text(name: Literal["case", "sweep", "motion"] = "case") -> str:
    """Return the commented example of a case file, of a motion, or of the table that makes a study of a case."""
    return resources.files(__package__).joinpath(f"examples/{name}.toml").read_text(encoding="utf-8")


def read_columns(what: str, path: Path, names: Sequence[str], maybe: Sequence[str] = ()) -> dict[str, list[float]]:
    """Return columns of numbers of a CSV file by their names, and those that it may have.

    Raises
    ------
    ValueError
        Where it cannot be read, or is none; `what` says what it should be.
    """
    try:
        with path.open(newline="", encoding=_ENCODING) as file:
            rows = list(csv.DictReader(file, skipinitialspace=True))
        found = [*names, *(name for name in maybe if rows and name in rows[0])]
        return {name: [float(row[name]) for row in rows] for name in found}
    except OSError as error:
        raise ValueError(f"{what} {path}: {error.strerror}") from None
    except (KeyError, TypeError, ValueError, csv.Error) as error:
        wanted = ", ".join(names) + (f" and maybe {', '.join(maybe)}" if maybe else "")
        raise ValueError(f"{what} {path}: needs numbers in columns {wanted} ({error})") from None


#: Which command reads a file with such a table.
_COMMANDS = {"sweep": "viscoroll sweep", "motion": "viscoroll roll"}

#: Errors beside the first that are told one by one.
_MOST_TOLD = 3


def first_line(error: ValidationError) -> str:
    """Return what is wrong first, with its place in the file, and what else."""
    # Values are looked at where all keys of a table are known: the keys of others come first.
    errors = sorted(error.errors(), key=lambda one: one["type"] == "value_error")
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


#: Tables of a type, which stands behind their names in the places of pydantic.
_TYPED = ("shear_modulus", "shift")

#: What is wrong with a key of such a table.
_WRONG_KEYS = {"missing": "must have", "extra_forbidden": "has no parameter"}


def _told(error: ErrorDetails, *, with_value: bool = True) -> str:
    *above, key = [part for before, part in pairwise(("", *error["loc"])) if before not in _TYPED]
    kind = next((part for before, part in pairwise(error["loc"]) if before in _TYPED), None)
    got = f", got {shown(error['input'])}" if with_value and error["type"] != "missing" else ""
    if kind is not None and error["type"] in _WRONG_KEYS:
        return f"{_place(above)} of type {kind} {_WRONG_KEYS[error['type']]} {key}{got}"
    place, context = _place([*above, key]), error.get("ctx", {})
    if error["type"] == "union_tag_invalid":
        kinds = context["expected_tags"].replace("'", "")
        return f"{place}.type must be one of {kinds}, got {shown(error['input']['type'])}"
    if error["type"] == "value_error":  # says by itself what it got
        return f"{place}: {context['error']}"
    return f"{place}: {error['msg'][0].lower()}{error['msg'][1:]}{got}"


def _place(parts: Sequence[str | int]) -> str:
    return "".join(f"[{part}]" if isinstance(part, int) else f".{part}" for part in parts).lstrip(".")
