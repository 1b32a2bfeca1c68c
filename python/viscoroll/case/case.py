"""Cases in TOML files, checked with pydantic (the extra `viscoroll[cli]`)."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, fields, replace
from pathlib import Path
from typing import Annotated, Any, ClassVar, Literal, TypeAlias

from .._core import Compliance, Curvature, PatchLoad, SlipKinematics
from .._support.arguments import as_kelvin, as_member
from .._support.errors import InvalidInput
from .._support.extras import extra
from .._support.progress import ProgressLike
from .._support.toml import read_toml
from ..bodies import (
    Adhesion,
    CoatedCylinder,
    CoatedPlane,
    CoatedSphere,
    CoatedWheel,
    Counterbody,
    Drive,
    Groove,
    HalfSpace,
    Layer,
    Mesh,
    RollingBody,
)
from ..coupled import SelfHeating, StrainSoftening, self_heating, strain_softening
from ..coupled.softening_search import softens
from ..rolling import Result, solve
from ..thermal import Temperature
from ..thermal.surroundings import Core
from .key_paths import KeyPath, key_path_of, substituted
from .moduli import Modulus, Shift
from .plausible import require_plausible, require_plausible_width
from .sizes import SIZES, SizedTable
from .tables import (
    ByName,
    FileTables,
    StrictTable,
    Table,
    checked,
    errors_in,
)

with extra("cli"):
    from pydantic import AfterValidator, BeforeValidator, ValidationInfo

__all__ = [
    "BODIES",
    "COUNTERBODIES",
    "Case",
    "CaseFile",
    "MeshTable",
    "PairTables",
    "Thermal",
    "build_case",
    "example_text",
    "load_case",
    "with_changes",
]


_Layers: TypeAlias = list[Annotated[Layer, Table(shear_modulus=Modulus)]]
_Base: TypeAlias = Annotated[HalfSpace, Table(documented_by=Layer, shear_modulus=Modulus)]

#: Table of a plane.
PlaneTable: TypeAlias = Annotated[CoatedPlane, Table(layers=_Layers, base=_Base)]

_Ball: TypeAlias = Annotated[CoatedSphere, SizedTable(CoatedSphere, layers=_Layers)]
_Cylinder: TypeAlias = Annotated[CoatedCylinder, SizedTable(CoatedCylinder, layers=_Layers)]
_Wheel: TypeAlias = Annotated[CoatedWheel, SizedTable(CoatedWheel, layers=_Layers)]

#: Tables of rolling bodies, and their classes; a file has exactly one of them.
BODIES: dict[str, type[RollingBody]] = {"ball": CoatedSphere, "cylinder": CoatedCylinder, "wheel": CoatedWheel}

#: Tables of counterbodies; a file has at most one of them.
COUNTERBODIES = ("plane", "groove", "other_ball", "other_cylinder", "other_wheel")


class Rolling(StrictTable):
    """The table `rolling`: the load case."""

    documented_by = (solve,)
    one_of = (("load", "penetration"), ("angular_speed", "speed"))

    load: float | None = None
    penetration: float | None = None
    angular_speed: float | None = None
    speed: float | None = None
    friction: float = 0.0
    drive: Annotated[Drive, Table()] = Drive(force=0.0)
    adhesion: Annotated[Adhesion, Table()] | None = None


class MeshTable(StrictTable):
    """Base of the table `numerics`: keyword arguments, including those of a mesh."""

    nodes_per_revolution: int | None = None
    max_order: int | None = None
    theta_nodes_per_revolution: int | None = None

    documented_by: ClassVar[tuple[Callable[..., Any], ...]] = (Mesh,)

    def arguments(self) -> dict[str, Any]:
        """Return the keyword arguments with `mesh` as one of them, None if the table gives no mesh."""
        given = dict(self)
        numbers = {parameter.name: given.pop(parameter.name) for parameter in fields(Mesh)}
        if self.nodes_per_revolution is not None:
            return given | {"mesh": Mesh(**numbers)}
        if any(number is not None for number in numbers.values()):
            raise InvalidInput(
                "numerics.nodes_per_revolution", "must be given with max_order or theta_nodes_per_revolution"
            )
        return given | {"mesh": None}


class Numerics(MeshTable):
    """The table `numerics` of a load case."""

    documented_by = (*MeshTable.documented_by, solve)

    accuracy: float | None = None
    compliance: Annotated[Compliance, ByName()] = Compliance.RADIAL
    curvature: Annotated[Curvature, ByName()] = Curvature.SPHERE
    patch_load: Annotated[PatchLoad, ByName()] = PatchLoad.FLAT
    slip_kinematics: Annotated[SlipKinematics, ByName()] = SlipKinematics.EXACT
    finite_strain: bool = True


def _core_of(given: object) -> object:
    return as_member("core", given, Core) if isinstance(given, str) else given


def _kelvin(value: float, info: ValidationInfo) -> float:
    return as_kelvin(str(info.field_name), value)


Kelvin: TypeAlias = Annotated[float, AfterValidator(_kelvin)]


class Thermal(StrictTable):
    """Cooling of a case; the parameters are those of `viscoroll.self_heating`. Without `shift`, moduli are constant."""

    documented_by = (Result.temperature, self_heating)

    convection: float
    ambient: Kelvin
    conductivity: float | list[float] | None = None
    core: Annotated[Core | float, BeforeValidator(_core_of)] = Core.INSULATED
    core_temperature: Kelvin | None = None
    width: float | None = None
    side_convection: float | None = None
    hub_conductance: float | None = None
    shift: Shift | None = None
    limit: float | None = None
    softening: Literal["network", "harmonic"] = "network"
    of: Literal["body", "counterbody"] | None = None
    base_convection: float | None = None
    period: float | None = None

    def temperature(self, result: Result, *, progress: ProgressLike = None) -> Temperature:
        """Return the temperature with unchanged moduli."""
        cooling = {name: value for name, value in self if name not in ("shift", "limit", "softening")}
        return result.temperature(**cooling, progress=progress)

    def self_heating(self, arguments: Mapping[str, Any], **options: Any) -> SelfHeating:
        """Return the steady states for arguments of `viscoroll.solve`; the table must have a shift."""
        unused = ("of", "base_convection", "period")
        for name in unused:
            if getattr(self, name) is not None:
                raise InvalidInput(
                    f"thermal.{name}",
                    "must be left out with thermal.shift: self-heating considers only the rolling body",
                )
        return self_heating(**arguments, **{name: value for name, value in self if name not in unused}, **options)


class PairTables(FileTables):
    """Base of a file with one rolling body of `BODIES`, and at most one counterbody of `COUNTERBODIES`.

    Parameters
    ----------
    allow_large : bool, optional
        Whether to accept bodies of which a length is probably in millimeters, such as a ball with a radius of 20 m.
    """

    allow_large: bool = False

    ball: _Ball | None = None
    cylinder: _Cylinder | None = None
    wheel: _Wheel | None = None
    plane: PlaneTable | None = None
    groove: Annotated[Groove, Table(layers=_Layers, base=_Base)] | None = None
    other_ball: _Ball | None = None
    other_cylinder: _Cylinder | None = None
    other_wheel: _Wheel | None = None

    @classmethod
    def is_of_roller(cls, document: Mapping[str, Any]) -> bool:
        """Return whether forces of the file are per length."""
        return any(name in document and kind.line_contact for name, kind in BODIES.items())

    def pair(self, document: Mapping[str, Any]) -> dict[str, Any]:
        """Return the arguments `body` and `on` of `viscoroll.solve` and `viscoroll.roll`.

        Parameters
        ----------
        document : mapping
            Content of the file, whose keys error messages name.
        """
        bodies, counterbodies = (
            {name: getattr(self, name) for name in names if getattr(self, name) is not None}
            for names in (BODIES, COUNTERBODIES)
        )
        if len(bodies) != 1:
            raise ValueError(f"exactly one of {', '.join(BODIES)} must be given, got {' and '.join(bodies) or 'none'}")
        if len(counterbodies) > 1:
            raise ValueError(
                f"at most one of {', '.join(COUNTERBODIES)} may be given, got {' and '.join(counterbodies)}"
            )
        (name, body), (other, on) = *bodies.items(), next(iter(counterbodies.items()), (None, None))
        if not self.allow_large:
            sized = {table for table in (name, other) if table and "outer_diameter" in document.get(table, {})}
            require_plausible(name, body, other, on, by_diameter=sized)
        return {"body": body, "on": on}


class CaseFile(PairTables):
    """A case file."""

    rolling: Rolling
    numerics: Numerics = Numerics()
    thermal: Thermal | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class Case:
    """One load case, as a file describes it; the parameters are those of `viscoroll.solve`.

    If the file gives `speed`, `angular_speed` is that at which linear theory is solved.
    """

    body: RollingBody
    on: Counterbody | None = None
    load: float | None
    penetration: float | None
    angular_speed: float
    speed: float | None = None
    friction: float
    drive: Drive
    adhesion: Adhesion | None = None
    mesh: Mesh | None
    accuracy: float | None
    compliance: Compliance
    curvature: Curvature
    patch_load: PatchLoad
    slip_kinematics: SlipKinematics
    finite_strain: bool = True
    thermal: Thermal | None = None

    def arguments(self) -> dict[str, Any]:
        """Return the arguments of `viscoroll.solve`."""
        given = {field.name: getattr(self, field.name) for field in fields(self) if field.name != "thermal"}
        if self.speed is not None:
            del given["angular_speed"]
        return {name: value for name, value in given.items() if value is not None}

    def at(self, angular_speed: float) -> Case:
        """Return the case at an angular speed [rad/s], in place of a speed over the ground."""
        return replace(self, angular_speed=angular_speed, speed=None)

    def given_load(self) -> float:
        """Return the load, for evaluations that need one; raise a ValueError if the case gives the penetration."""
        if self.load is None:
            raise InvalidInput("rolling.load", "must be given here, instead of rolling.penetration")
        return self.load

    def solve(self, **options: Any) -> Result:
        """Solve the case; if layers soften, with the moduli at their strain. `options` go to `viscoroll.solve`."""
        return self.strain_softening(**options).result if self.softens else solve(**self.arguments(), **options)

    @property
    def softens(self) -> bool:
        """Whether a layer has a modulus that decreases with strain."""
        return softens(self.body, self.on)

    def strain_softening(self, **options: Any) -> StrainSoftening:
        """Solve the case with the strain at which the layers soften. `options` go to `viscoroll.strain_softening`."""
        return strain_softening(**self.arguments(), **options)

    def self_heating(self, **options: Any) -> SelfHeating:
        """Compute the steady states of temperature and torque of a case whose table [thermal] has a shift.

        `options` go to `viscoroll.self_heating`.
        """
        if self.thermal is None or self.thermal.shift is None:
            raise InvalidInput("thermal.shift", "must be given for self-heating")
        self.given_load()
        return self.thermal.self_heating(self.arguments(), **options)


def load_case(path: str | Path, changes: Mapping[str, Any] | None = None) -> Case:
    """Read a case from a TOML file.

    Parameters
    ----------
    path : path-like
        Path of the file; ``example_text()`` is a commented example.
    changes : mapping, optional
        Values that replace those of the file, by the paths of their keys: ``{"rolling.load": "500 N"}``.

    Returns
    -------
    Case
        Case that can be solved.

    Raises
    ------
    ValueError
        If the file is not valid. The message is one line and names the key in the file.
    OSError
        If the file cannot be read.
    """
    path = Path(path)
    with errors_in(path):
        return build_case(with_changes(read_toml(path), changes or {}), path.parent)


def with_changes(document: Mapping[str, Any], changes: Mapping[str, Any]) -> dict[str, Any]:
    """Return the content of a file with other values, by the paths of `--set`."""
    return with_values(document, {key_path_of(key, "--set"): value for key, value in changes.items()}, "--set")


def with_values(document: Mapping[str, Any], chosen: Mapping[KeyPath, Any], where: str = "sweep") -> dict[str, Any]:
    """Return the content of a file with other values; a speed replaces an angular speed, and so on.

    Parameters
    ----------
    document : dict
        Content of the file.
    chosen : mapping
        Values by the paths of their keys.
    where : str, optional
        Place of the keys in messages.
    """
    return substituted(document, chosen, (*Rolling.one_of, SIZES), where)


def build_case(document: dict[str, Any], folder: Path | None) -> Case:
    """Return the case that the content of a file describes.

    Parameters
    ----------
    document : dict
        Content of the file.
    folder : Path or None
        Folder of the files to which the content refers. With None, no file is read, and content that refers to a file
        is rejected.

    Raises
    ------
    ValueError, TypeError
        If the content is not valid.
    """
    file = checked(CaseFile, document, folder)
    pair = file.pair(document)
    if file.thermal is not None and file.thermal.width is not None and not file.allow_large:
        require_plausible_width("thermal.width", file.thermal.width, pair["body"].outer_radius)
    numerics = file.numerics.arguments()
    if numerics["mesh"] is not None and numerics["accuracy"] is not None:
        raise InvalidInput("numerics.accuracy", "must be left out if a mesh is given")
    rolling = dict(file.rolling)
    if rolling["angular_speed"] is not None and rolling["speed"] is not None:
        raise InvalidInput("rolling.speed", "must be left out if the angular speed is given", f"{rolling['speed']:g}")
    if rolling["speed"] is not None:
        rolling["angular_speed"] = rolling["speed"] / pair["body"].outer_radius
    return Case(thermal=file.thermal, **pair, **rolling, **numerics)


def example_text(name: Literal["case", "sweep", "design", "motion", "sliding", "measured"] = "case") -> str:
    """Return an example: a case, motion or sliding file, measurements, or the table of a study or a design."""
    from importlib import resources

    file = f"examples/{name}.{'csv' if name == 'measured' else 'toml'}"
    return resources.files("viscoroll").joinpath(file).read_text(encoding="utf-8")
