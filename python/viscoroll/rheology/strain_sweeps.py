"""Strain sweeps of filled rubber from files of rheometers and DMA instruments."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from .._support.arguments import as_count, as_member
from .._support.errors import InvalidInput, in_file
from ..materials import StrainSweep
from ..materials.modulus_like import ShearModulusLike
from ..materials.strain_sweep import StrainKind
from .reader_arguments import Columns, checked_conversion, named_columns, tables_of
from .reading import moduli_are_tensile, moduli_of
from .tables import AMPLITUDE, Table

__all__ = ["read_strain_sweep"]

_ROLES = ("strain", "frequency", "storage", "loss", "complex", "tan_delta", "phase", "temperature", "sweep")


def read_strain_sweep(
    path: str | Path,
    *,
    kind: StrainKind | str,
    matrix: ShearModulusLike | None = None,
    frequency: float | None = None,
    sweep: int | None = None,
    columns: Columns | None = None,
    tensile: bool | None = None,
    poisson_ratio: float = 0.5,
) -> StrainSweep:
    """Read a strain sweep from a text or CSV export, in the formats of `read_rheology`.

    Parameters
    ----------
    path : path-like
        Path of the file.
    kind : StrainKind or str
        Definition of strain that the instrument uses: files do not specify whether it is the single or the double
        amplitude.
    matrix : ShearModulus, callable or float, optional
        Modulus of the matrix [Pa], which is subtracted, the same as in `StrainSweep`.
    frequency : float, optional
        Angular frequency of the sweep [rad/s], by default that of the file. Used with a matrix only.
    sweep : int, optional
        Number of the sweep, from 1. Required if the file contains several.
    columns, tensile, poisson_ratio
        The same as in `read_rheology`; "strain" is an additional column, with the unit "%" or "1".

    Returns
    -------
    StrainSweep
        Network of the sweep. Points with a modulus that is not positive are omitted.

    Raises
    ------
    ValueError
        If the file has no table with strain and moduli, a unit is missing, or `sweep` is not given for one of several
        sweeps.
    OSError
        If the file cannot be read.
    """
    path = Path(path)
    nu = checked_conversion(tensile, poisson_ratio)
    found = tables_of(path, named_columns(columns, _ROLES))
    tables = [table for table in found if "strain" in table.columns and table.columns.keys() & {"storage", "complex"}]
    if amplitude := [table for table in tables if table.kind == AMPLITUDE]:
        tables = amplitude
    if not tables:
        raise ValueError(
            f"{path}: must have a header with a strain and a storage modulus, and rows of numbers below it; pass "
            'columns={"strain": (name, "%"), "storage": (name, unit), ...}'
        )
    is_tensile = moduli_are_tensile(path, tables) if tensile is None else tensile
    rows = _chosen([part for table in tables for part in _sweeps(table, path)], sweep, path)
    divisor = 2.0 * (1.0 + nu) if is_tensile else 1.0
    measured = rows.get("frequency")
    if frequency is None and matrix is not None:
        if measured is None:
            raise InvalidInput(
                "frequency", f"must be given with matrix, because {path} does not contain the frequency of the sweep"
            )
        frequency = float(measured.mean())
    try:
        return StrainSweep(
            strain=rows["strain"],
            storage=rows["storage"] / divisor,
            loss=rows["loss"] / divisor,
            kind=as_member("kind", kind, StrainKind),
            matrix=matrix,
            frequency=None if matrix is None else frequency,
        )
    except ValueError as error:
        raise in_file(error, path) from None


def _chosen(sweeps: list[dict[str, np.ndarray]], number: int | None, path: Path) -> dict[str, np.ndarray]:
    """Return the sweep with a number, which may be omitted if there is only one."""
    if number is None and len(sweeps) == 1:
        return sweeps[0]
    if number is None:
        raise InvalidInput("sweep", f"must be given for {path}, which has several: 1 to {len(sweeps)}")
    return sweeps[as_count("sweep", number, 1, len(sweeps)) - 1]


def _sweeps(table: Table, path: Path) -> list[dict[str, np.ndarray]]:
    """Return the sweeps of a table, sorted by strain: columns by role, in SI units."""
    for column in table.repeated:
        if column.role == "strain":
            raise ValueError(
                f"{path}: two columns contain strain, {table.columns['strain'].name!r} and {column.name!r}: select one "
                'by columns={"strain": name}'
            )
    rows, _ = table.complete(AMPLITUDE)
    storage, loss = moduli_of(table, rows, path)
    values = {"storage": storage, "loss": loss}
    for role in ("strain", "frequency"):
        if role in table.columns:
            values[role] = table.columns[role].converted([row[role] for row in rows], path)
    numbers = np.array([row.get("sweep", 0.0) for row in rows])
    valid = (values["strain"] > 0.0) & (values["storage"] > 0.0) & (values["loss"] > 0.0)
    parts = [np.flatnonzero(valid & (numbers == number)) for number in np.unique(numbers[valid])]
    order = [part[np.argsort(values["strain"][part], kind="stable")] for part in parts]
    return [{role: column[part] for role, column in values.items()} for part in order]
