"""Cases in TOML files, checked with pydantic (the extra `viscoroll[cli]`)."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, fields
from functools import partial
from importlib import resources
from pathlib import Path
from typing import Annotated, Any, Literal, TypeAlias

from .. import materials
from .._core import Compliance, Curvature, Extrapolation, PatchLoad, SlipKinematics
from .._support.arguments import as_member
from .._support.extras import extra
from .._support.progress import ProgressLike
from .._support.text import shown
from .._support.toml import read_toml
from ..bodies import (
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
from ..materials import Arrhenius, LossFactor, WilliamsLandelFerry
from ..materials.networks import Network
from ..materials.strain_sweep import StrainKind
from ..rheology import example_material, hardness_to_modulus, load_material, rebound_to_loss_factor
from ..rolling import Result, solve
from ..thermal import Temperature
from ..thermal.surroundings import Core
from .columns import read_columns
from .tables import (
    ByName,
    FileName,
    FileTables,
    StrictTable,
    Table,
    checked,
    errors_in,
    in_folder,
)

with extra("cli"):
    from pydantic import BeforeValidator, Field, ValidationInfo

__all__ = [
    "BODIES",
    "COUNTERBODIES",
    "Case",
    "MeshTable",
    "PairTables",
    "Thermal",
    "build_case",
    "example_text",
    "load_case",
]


def _measured(
    *,
    file: Path,
    temperature: float | None = None,
    form: Literal["table", "prony"] = "table",
    draw: int | None = None,
) -> materials.MasterCurve | materials.Prony:
    """Return a material from a file that `viscoroll material` wrote."""
    try:
        return load_material(file, temperature=temperature, form=form, draw=draw)
    except OSError as error:
        raise ValueError(f"material {file}: {error.strerror}") from None


def _published(*, name: str, temperature: float) -> materials.ShearModulus:
    """Return a published material at a temperature [K]."""
    return example_material(name).at(temperature=temperature)


def _of_data_sheet(
    *,
    hardness: float,
    scale: Literal["A", "D"] = "A",
    rebound: float | None = None,
    reference_frequency: float | None = None,
    decades: float | None = None,
) -> materials.Elastic | LossFactor:
    """Return a material from a hardness, and its loss factor from a rebound if there is one."""
    modulus = hardness_to_modulus(hardness, scale=scale).value
    law = {"reference_frequency": reference_frequency, "decades": decades}
    given = {name: value for name, value in law.items() if value is not None}
    if rebound is None:
        if given:
            raise ValueError(f"{' and '.join(given)} must be left out without a rebound")
        return materials.Elastic(modulus=modulus)
    if reference_frequency is None:
        raise ValueError(
            "reference_frequency must be given with a rebound: the frequency [rad/s] of modulus and loss factor"
        )
    return LossFactor(modulus=modulus, loss_factor=rebound_to_loss_factor(rebound).value, **given)


def _with_columns(
    table: dict[str, Any], info: ValidationInfo, *, what: str, make: Callable[..., object], names: tuple[str, ...]
) -> dict[str, Any]:
    """Replace the name of a file by the columns of the file, after `make` has checked their values."""
    if "file" not in table:
        return table
    if both := [name for name in names if name in table]:
        raise ValueError(f"file must be left out if columns are given, got also {', '.join(both)}")
    path = in_folder(table["file"], info)
    columns = read_columns(what, path, names)
    try:
        make(**columns)
    except ValueError as error:
        raise ValueError(f"{what} {path}: {error}") from None
    return {key: value for key, value in table.items() if key != "file"} | columns


def _columns_of(what: str, make: Callable[..., object], *names: str) -> BeforeValidator:
    """Return a validator that replaces the name of a file by the columns of the file."""
    return BeforeValidator(partial(_with_columns, what=what, make=make, names=names))


def _typed(given: object) -> object:
    """Return a table with a key `type`, which is None if it was missing."""
    return {"type": None} | given if isinstance(given, dict) else given


def _as_table(given: object) -> object:
    """Return the table that a number or the name of a file abbreviates."""
    if isinstance(given, str):
        return {"type": "measured", "file": given}
    if isinstance(given, float | int) and not isinstance(given, bool):
        return {"type": "elastic", "modulus": given}
    if not isinstance(given, dict):
        raise ValueError(f"shear_modulus must be a table, a number or the name of a file, got {shown(given)}")
    return _typed(given)


def _strain_sweep(
    *,
    strain: list[float],
    storage: list[float],
    loss: list[float],
    kind: str | StrainKind = StrainKind.SHEAR,
    frequency: float | None = None,
) -> Callable[[Any], materials.StrainSweep]:
    """Return a function of the matrix that makes a strain sweep, which subtracts the matrix if a frequency is given."""
    table = partial(
        materials.StrainSweep,
        strain=strain,
        storage=storage,
        loss=loss,
        kind=as_member("kind", kind, StrainKind),
    )
    if frequency is None:
        return lambda _: table()
    return lambda matrix: table(matrix=matrix, frequency=frequency)


def _softening(*, matrix: Any, network: Network | Callable[[Any], materials.StrainSweep]) -> materials.SofteningModulus:
    made = network if isinstance(network, Network) else network(matrix)
    return materials.SofteningModulus(matrix=matrix, network=made)


_Linear: TypeAlias = Annotated[
    Annotated[materials.Elastic, Table("elastic")]
    | Annotated[materials.StandardLinearSolid, Table("standard_linear_solid")]
    | Annotated[materials.Prony, Table("prony")]
    | Annotated[materials.KelvinVoigt, Table("kelvin_voigt")]
    | Annotated[materials.FractionalZener, Table("fractional_zener")]
    | Annotated[
        materials.MasterCurve,
        Table("master_curve", extrapolation=Annotated[Extrapolation, ByName()]),
        _columns_of("master curve", materials.MasterCurve, "frequency", "storage", "loss"),
    ]
    | Annotated[LossFactor, Table("loss_factor")]
    | Annotated[materials.ShearModulus, Table("hardness", _of_data_sheet)]
    | Annotated[materials.ShearModulus, Table("published", _published)]
    | Annotated[materials.ShearModulus, Table("measured", _measured, file=FileName, temperature=float)],
    Field(discriminator="type"),
]

_Network: TypeAlias = Annotated[
    Annotated[materials.KrausNetwork, Table("kraus")]
    | Annotated[materials.MasingNetwork, Table("masing")]
    | Annotated[
        materials.StrainSweep,
        Table("strain_sweep", _strain_sweep),
        _columns_of("strain sweep", materials.StrainSweep, "strain", "storage", "loss"),
    ],
    Field(discriminator="type"),
    BeforeValidator(_typed),
]

_Modulus: TypeAlias = Annotated[
    _Linear
    | Annotated[
        materials.SofteningModulus,
        Table("softening", _softening, matrix=Annotated[_Linear, BeforeValidator(_as_table)], network=_Network),
    ],
    Field(discriminator="type"),
    BeforeValidator(_as_table),
]

_Shift: TypeAlias = Annotated[
    Annotated[WilliamsLandelFerry, Table("williams_landel_ferry")] | Annotated[Arrhenius, Table("arrhenius")],
    Field(discriminator="type"),
    BeforeValidator(_typed),
]

_Layers: TypeAlias = list[Annotated[Layer, Table(shear_modulus=_Modulus)]]
_Base: TypeAlias = Annotated[HalfSpace, Table(shear_modulus=_Modulus)]

_Ball: TypeAlias = Annotated[CoatedSphere, Table(layers=_Layers)]
_Cylinder: TypeAlias = Annotated[CoatedCylinder, Table(layers=_Layers)]
_Wheel: TypeAlias = Annotated[CoatedWheel, Table(layers=_Layers)]

#: Tables of rolling bodies; a file has exactly one of them.
BODIES = ("ball", "cylinder", "wheel")

#: Tables of counterbodies; a file has at most one of them.
COUNTERBODIES = ("plane", "groove", "other_ball", "other_cylinder", "other_wheel")


class _Rolling(StrictTable):
    load: float
    angular_speed: float
    friction: float = 0.0
    drive: Annotated[Drive, Table()] = Drive(force=0.0)


class MeshTable(StrictTable):
    """Base of the table `numerics`: keyword arguments, including those of a mesh."""

    nodes_per_revolution: int | None = None
    max_order: int | None = None
    theta_nodes_per_revolution: int | None = None

    def arguments(self) -> dict[str, Any]:
        """Return the keyword arguments with `mesh` as one of them, None if the table gives no mesh."""
        given = dict(self)
        numbers = {parameter.name: given.pop(parameter.name) for parameter in fields(Mesh)}
        if self.nodes_per_revolution is not None:
            return given | {"mesh": Mesh(**numbers)}
        if any(number is not None for number in numbers.values()):
            raise ValueError("numerics.nodes_per_revolution must be given with max_order or theta_nodes_per_revolution")
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
    """Cooling of a case. Parameters as in `viscoroll.self_heating`; without `shift`, the moduli do not change."""

    convection: float
    ambient: float
    conductivity: float | list[float] | None = None
    core: Annotated[Core | float, BeforeValidator(_core_of)] = Core.INSULATED
    core_temperature: float | None = None
    width: float | None = None
    side_convection: float | None = None
    hub_conductance: float | None = None
    shift: _Shift | None = None
    limit: float | None = None
    softening: Literal["network", "harmonic"] = "network"
    of: Literal["body", "counterbody"] | None = None
    base_convection: float | None = None
    period: float | None = None

    def temperature(self, result: Result, *, progress: ProgressLike = None) -> Temperature:
        """Return the temperature with unchanged moduli."""
        cooling = {name: value for name, value in self if name not in ("shift", "limit", "softening")}
        return result.temperature(**cooling, progress=progress)


class PairTables(FileTables):
    """Base of a file with one rolling body of `BODIES`, and at most one counterbody of `COUNTERBODIES`."""

    ball: _Ball | None = None
    cylinder: _Cylinder | None = None
    wheel: _Wheel | None = None
    plane: Annotated[CoatedPlane, Table(layers=_Layers, base=_Base)] | None = None
    groove: Annotated[Groove, Table(layers=_Layers, base=_Base)] | None = None
    other_ball: _Ball | None = None
    other_cylinder: _Cylinder | None = None
    other_wheel: _Wheel | None = None

    def pair(self) -> dict[str, Any]:
        """Return the arguments `body` and `on` of `viscoroll.solve` and `viscoroll.roll`."""
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
        return {"body": next(iter(bodies.values())), "on": next(iter(counterbodies.values()), None)}


class _File(PairTables):
    rolling: _Rolling
    numerics: _Numerics = _Numerics()
    thermal: Thermal | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class Case:
    """One load case, as a file describes it. Parameters as in `viscoroll.solve`."""

    body: RollingBody
    on: Counterbody | None = None
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
            raise ValueError("thermal.shift must be given for self-heating")
        for name in ("of", "base_convection", "period"):
            if getattr(self.thermal, name) is not None:
                raise ValueError(
                    f"thermal.{name} must be left out with thermal.shift: self-heating considers only the rolling body"
                )
        cooling = {name: value for name, value in self.thermal if name not in ("of", "base_convection", "period")}
        return self_heating(**self.arguments(), **cooling, **options)


def load_case(path: str | Path) -> Case:
    """Read a case from a TOML file.

    Parameters
    ----------
    path : path-like
        Path of the file; ``example_text()`` is a commented example.

    Returns
    -------
    Case
        Case that can be solved.

    Raises
    ------
    ValueError
        If the file is not valid. The message is one line and names the place in the file.
    OSError
        If the file cannot be read.
    """
    path = Path(path)
    with errors_in(path):
        return build_case(read_toml(path), path.parent)


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
    file = checked(_File, document, folder)
    pair = file.pair()
    numerics = file.numerics.arguments()
    if numerics["mesh"] is not None and numerics["accuracy"] is not None:
        raise ValueError("numerics.accuracy must be left out if a mesh is given")
    return Case(
        thermal=file.thermal,
        **pair,
        **dict(file.rolling),
        **numerics,
    )


def example_text(name: Literal["case", "sweep", "design", "motion", "measured"] = "case") -> str:
    """Return an example: a case file, a motion, measurements, or the table that makes a case a study or a design."""
    file = f"examples/{name}.{'csv' if name == 'measured' else 'toml'}"
    return resources.files("viscoroll").joinpath(file).read_text(encoding="utf-8")
