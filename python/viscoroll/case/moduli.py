"""Moduli in case files, and their shifts with temperature (the extra `viscoroll[cli]`)."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial, reduce
from operator import or_
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Literal, TypeAlias

from .. import _core, materials
from .._core import Extrapolation
from .._support.arguments import as_float, as_member
from .._support.columns import read_columns
from .._support.errors import InvalidInput, in_file
from .._support.extras import extra
from .._support.text import shown
from ..materials import Arrhenius, LossFactor, WilliamsLandelFerry
from ..materials.moduli import MODULI
from ..materials.networks import Network
from ..materials.strain_sweep import StrainKind
from .tables import (
    AlsoAs,
    ByName,
    ColumnsOf,
    FileName,
    Table,
    in_folder,
)

with extra("cli"):
    from pydantic import BeforeValidator, Field, ValidationInfo

__all__ = ["Modulus", "Shift"]


def _measured(
    *,
    file: Path,
    temperature: float | None = None,
    form: Literal["table", "prony"] = "table",
    draw: int | None = None,
) -> materials.MasterCurve | materials.Prony:
    """Return a material from a file that `viscoroll material` wrote.

    Parameters
    ----------
    file : str
        Name of the file.
    temperature : float, optional
        Temperature [K]; by default the reference temperature of the file.
    form : {"table", "prony"}, optional
        Modulus as the measured table or as the fitted Prony series.
    draw : int, optional
        Number of one of the draws in the file, from 0.
    """
    from ..rheology import load_material

    try:
        return load_material(file, temperature=temperature, form=form, draw=draw)
    except OSError as error:
        raise ValueError(f"material {file}: {error.strerror}") from None


def _published(*, name: str, temperature: float) -> materials.ShearModulus:
    """Return a published material.

    Parameters
    ----------
    name : str
        Name of the material, see `viscoroll.rheology.example_material`.
    temperature : float
        Temperature [K].
    """
    from ..rheology import example_material

    return example_material(name).at(temperature=temperature)


def _of_moduli(*, relaxed_modulus: float, moduli: list[float], relaxation_times: list[float]) -> materials.Prony:
    """Return a Prony series from absolute moduli.

    Parameters
    ----------
    relaxed_modulus : float
        Shear modulus at zero frequency [Pa], ≥ 0.
    moduli : array_like
        Shear moduli of the terms [Pa], ≥ 0.
    relaxation_times : array_like
        Relaxation times [s], > 0, as many as `moduli`.
    """
    return materials.Prony.from_moduli(
        relaxed_modulus=relaxed_modulus, moduli=moduli, relaxation_times=relaxation_times
    )


def _of_program(
    *,
    file: Path,
    name: str | None = None,
    temperature: float | None = None,
    units: str = "m-kg-s",
    temperature_unit: Literal["K", "C"] = "K",
    relaxed_modulus: float | None = None,
) -> materials.ShearModulus:
    """Return a material from the input of Abaqus, Ansys, LS-DYNA or COMSOL, see `viscoroll.materials.read_constants`.

    Parameters
    ----------
    file : str
        Name of the file.
    name : str, optional
        Name or number of the material, if the file has several.
    temperature : float, optional
        Temperature [K]; by default the reference temperature of the file.
    units : str, optional
        Units of the file, by default "m-kg-s".
    temperature_unit : {"K", "C"}, optional
        Unit of the temperatures in the file.
    relaxed_modulus : float, optional
        Long-term shear modulus [Pa] of a table of branches without it.
    """
    try:
        constants = materials.read_constants(
            file, name=name, units=units, temperature_unit=temperature_unit, relaxed_modulus=relaxed_modulus
        )
    except OSError as error:
        raise ValueError(f"constants {file}: {error.strerror}") from None
    return constants.shear_modulus if temperature is None else constants.at(temperature=temperature)


def _of_data_sheet(
    *,
    hardness: float,
    scale: Literal["A", "D"] = "A",
    rebound: float | None = None,
    reference_frequency: float | None = None,
    decades: float | None = None,
) -> materials.Elastic | LossFactor:
    """Return a material from a hardness, and its loss factor from a rebound if there is one.

    Parameters
    ----------
    hardness : float
        Hardness, a number of `scale`.
    scale : {"A", "D"}, optional
        Scale of Shore.
    rebound : float, optional
        Rebound resilience as a fraction; without it, the material has no loss.
    reference_frequency : float, optional
        Angular frequency [rad/s] of modulus and loss factor; required with a rebound. A durometer is read after about
        one second, which is 1 rad/s.
    decades : float, optional
        Decades of frequency on each side over which the loss factor is constant.
    """
    from ..rheology import hardness_to_modulus, rebound_to_loss_factor

    numbers = {"hardness": hardness, "rebound": rebound, "reference_frequency": reference_frequency, "decades": decades}
    given = {name: as_float(name, value) for name, value in numbers.items() if value is not None}
    _core.ShearModulus("hardness", scale=_core.ShoreScale[scale], **given)  # checks the values
    modulus = hardness_to_modulus(given.pop("hardness"), scale=scale).value
    if rebound is None:
        return materials.Elastic(modulus=modulus)
    return LossFactor(modulus=modulus, loss_factor=rebound_to_loss_factor(given.pop("rebound")).value, **given)


def _with_columns(
    table: dict[str, Any], info: ValidationInfo, *, what: str, make: Callable[..., object], names: tuple[str, ...]
) -> dict[str, Any]:
    """Replace the name of a file by the columns of the file, after `make` has checked their values."""
    if "file" not in table:
        return table
    if both := [name for name in names if name in table]:
        raise InvalidInput("file", "must be left out if columns are given", f"also {', '.join(both)}")
    path = in_folder(table["file"], info)
    columns = read_columns(what, path, names)
    try:
        make(**columns)
    except ValueError as error:
        raise in_file(error, f"{what} {path}") from None
    return {key: value for key, value in table.items() if key != "file"} | columns


def _columns_of(what: str, make: Callable[..., object], *names: str) -> ColumnsOf:
    """Return the annotation of a table in which the name of a file may replace its columns."""
    return ColumnsOf(partial(_with_columns, what=what, make=make, names=names), names)


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
        raise InvalidInput("shear_modulus", "must be a table, a number or the name of a file", shown(given))
    return _typed(given)


def _strain_sweep(
    *,
    strain: list[float],
    storage: list[float],
    loss: list[float],
    kind: str | StrainKind = StrainKind.SHEAR,
    frequency: float | None = None,
) -> Callable[[Any], materials.StrainSweep]:
    """Return a function of the matrix that makes a strain sweep, which subtracts the matrix if a frequency is given.

    Parameters
    ----------
    strain : array_like
        Strain amplitudes [-].
    storage, loss : array_like
        Storage and loss moduli [Pa] at these amplitudes.
    kind : StrainKind or str, optional
        Kind of the strain and of the moduli.
    frequency : float, optional
        Angular frequency of the sweep [rad/s], if its moduli include the matrix.
    """
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
    """Return a modulus that decreases with strain.

    Parameters
    ----------
    matrix : table
        Modulus that does not depend on strain; a number is an elastic modulus [Pa].
    network : table
        Filler network, whose modulus decreases with strain.
    """
    made = network if isinstance(network, Network) else network(matrix)
    return materials.SofteningModulus(matrix=matrix, network=made)


#: Annotations of moduli whose tables do not contain only numbers.
_ANNOTATIONS: dict[str, tuple[object, ...]] = {
    "master_curve": (
        Table("master_curve", extrapolation=Annotated[Extrapolation, ByName()]),
        _columns_of("master curve", materials.MasterCurve, "frequency", "storage", "loss"),
    )
}

#: Tables of the moduli of the core, and of others, which Python makes from these.
_TABLES = (
    *(Annotated[(kind, *_ANNOTATIONS.get(name, (Table(name),)))] for name, kind in MODULI.items()),
    Annotated[materials.ShearModulus, Table("hardness", _of_data_sheet, scale=Literal["A", "D"])],
    Annotated[materials.ShearModulus, Table("published", _published)],
    Annotated[materials.ShearModulus, Table("measured", _measured, file=FileName, temperature=float)],
    Annotated[materials.ShearModulus, Table("generalized_maxwell", _of_moduli)],
    Annotated[materials.ShearModulus, Table("constants", _of_program, file=FileName, temperature=float)],
)

if TYPE_CHECKING:
    _Linear: TypeAlias = materials.ShearModulus
else:
    _Linear = Annotated[reduce(or_, _TABLES), Field(discriminator="type")]

#: A number is an elastic modulus, a text the name of a material file.
_Abbreviated = (BeforeValidator(_as_table), AlsoAs("number", "string"))

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

Modulus: TypeAlias = Annotated[
    _Linear
    | Annotated[
        materials.SofteningModulus,
        Table(
            "softening",
            _softening,
            matrix=Annotated[_Linear, *_Abbreviated],
            network=_Network,
        ),
    ],
    Field(discriminator="type"),
    *_Abbreviated,
]

Shift: TypeAlias = Annotated[
    Annotated[WilliamsLandelFerry, Table("williams_landel_ferry")] | Annotated[Arrhenius, Table("arrhenius")],
    Field(discriminator="type"),
    BeforeValidator(_typed),
]
