"""Studies in TOML files: a case file with a table of the varying numbers (the extra `viscoroll[cli]`)."""

from __future__ import annotations

import itertools
import re
from collections.abc import Collection, Mapping
from pathlib import Path
from typing import Any, Literal

import numpy as np

from .._support.errors import InvalidInput
from .._support.extras import extra
from .._support.intervals import as_confidence
from .._support.text import key_path_text, shown
from .._support.toml import read_toml
from .._support.units import UNITS
from ..bodies import Counterbody, RollingBody
from ..rheology.material_file import count_draws
from ..rolling.propagation import Pair
from ..sliding import RoughSurface
from ..studies.dimensions import MOST_POINTS, Dimension, require_feasible
from ..studies.kinds import SLIDING
from ..studies.plan import LoadCase, Plan
from .case import BODIES, COUNTERBODIES, Case, CaseFile, build_case, with_values
from .heat import Heating
from .key_paths import KeyPath, key_path_of, substituted
from .sliding import SlidingFile, build_sliding
from .tables import StrictTable, checked, errors_in
from .unit_texts import Key, has_quantities

with extra("cli"):
    from pydantic import Field, ValidationInfo, field_validator

__all__ = ["load_study", "plan_study"]


class Draws(StrictTable):
    """The table `draws`: materials with draws, from which the intervals of the results follow.

    Parameters
    ----------
    of : list of str
        Paths of measured materials in the file, for example ball.layers[0].shear_modulus.
    method : {"linear", "solve"}, optional
        Linearization, or one solution for each draw.
    confidence : float, optional
        Probability of the intervals [-], in (0, 1).
    """

    of: list[str]
    method: Literal["linear", "solve"] = "linear"
    confidence: float = 0.95


class _DrawsFile(StrictTable):
    draws: Draws


class Range(StrictTable):
    """Range of numbers, including both ends.

    Parameters
    ----------
    from, to : float
        First and last number.
    count : int
        Number of numbers.
    scale : {"linear", "log"}, optional
        Equal differences or equal ratios.
    """

    start: float = Field(alias="from")
    stop: float = Field(alias="to")
    count: int = Field(ge=2, le=MOST_POINTS)
    scale: Literal["linear", "log"] = "linear"

    @field_validator("scale")
    @classmethod
    def _has_logarithms(cls, scale: str, info: ValidationInfo) -> str:
        start, stop = (info.data.get(name, 1.0) for name in ("start", "stop"))
        if scale == "log" and not (start > 0.0 and stop > 0.0):
            raise ValueError(f"from and to must be > 0 for a log scale, got {start:g} and {stop:g}")
        return scale

    def values(self) -> list[float] | list[int]:
        spaced = np.geomspace if self.scale == "log" else np.linspace
        with np.errstate(over="ignore", invalid="ignore"):
            values = spaced(self.start, self.stop, self.count)
        if not np.isfinite(values).all():
            raise ValueError(
                f"from and to must be finite and have a finite difference, got {self.start:g} and {self.stop:g}"
            )
        # Counts, for example of nodes, must remain whole numbers.
        whole = self.start.is_integer() and self.stop.is_integer() and bool((values == values.round()).all())
        return [int(value) for value in values] if whole else [float(value) for value in values]


def load_study(path: str | Path) -> Plan:
    """Read a study from a TOML file.

    Parameters
    ----------
    path : path-like
        Path of a case file with a table ``sweep``. Its keys are paths of keys in the file, its values are lists of
        numbers or tables ``{ from = ..., to = ..., count = ..., scale = "linear" or "log" }``. An optional table
        ``draws`` gives the results intervals: its ``of`` lists the paths of measured materials whose files contain
        draws.

    Returns
    -------
    Plan
        Plan of the study. A dimension has the name of the last part of its path, or of the whole path if the last part
        is not unique.

    Raises
    ------
    ValueError
        If the file is not valid. The message is one line and names the key in the file.
    OSError
        If the file cannot be read.
    """
    path = Path(path)
    with errors_in(path):
        return plan_study(read_toml(path), path.parent)


def plan_study(document: dict[str, Any], folder: Path) -> Plan:
    """Return the study that the content of a file describes, without the tables of the study, which it removes."""
    table = document.pop("sweep", None)
    if not isinstance(table, dict) or not table:
        raise InvalidInput(
            "sweep", 'must be a table of parameters with their values, such as "rolling.load" = [50.0, 100.0]'
        )
    draws = checked(_DrawsFile, {"draws": document.pop("draws")}).draws if "draws" in document else None
    key_paths = [key_path_of(key) for key in table]
    if has_quantities(table):
        keys = (SlidingFile if "surface" in document else CaseFile).keys_of(document)
        table = {key: _in_si(key, entry, keys.at(document, key_path_of(key))) for key, entry in table.items()}
    entries = {key: _entry(key, entry) for key, entry in table.items()}
    counts = {key: entry.count if isinstance(entry, Range) else len(entry) for key, entry in entries.items()}
    require_feasible({f'of "{key}"': count for key, count in counts.items()})
    values = [entry.values() if isinstance(entry, Range) else entry for entry in entries.values()]
    dimensions = [
        Dimension(name=name, values=tuple(numbers), unit=UNITS.get(_leaf(key_path)))
        for name, key_path, numbers in zip(_names(key_paths), key_paths, values, strict=True)
    ]
    if "surface" in document:
        if draws is not None:
            raise InvalidInput("draws", "must be left out with a table surface")
        return _sliding_plan(document, folder, key_paths, dimensions)
    return _plan(document, folder, key_paths, dimensions, draws)


def _plan(
    document: dict[str, Any], folder: Path, key_paths: list[KeyPath], dimensions: list[Dimension], draws: Draws | None
) -> Plan:
    cases: list[LoadCase | str] = []
    bodies: dict[tuple[float, ...], RollingBody] = {}
    counterbodies: dict[tuple[float, ...], Counterbody | None] = {}
    drawn: dict[tuple[int, int], tuple[Pair, ...]] = {}
    for point in itertools.product(*(dimension.values for dimension in dimensions)):
        chosen = dict(zip(key_paths, point, strict=True))
        try:
            case = build_case(with_values(document, chosen), folder)
        except (TypeError, ValueError) as error:
            cases.append(f"{type(error).__name__}: {error}")
            continue
        # Points with equal bodies share the same objects, and so the influence tables.
        body = bodies.setdefault(_numbers_in(BODIES, chosen), case.body)
        on = counterbodies.setdefault(_numbers_in(COUNTERBODIES, chosen), case.on)
        if draws is not None and (id(body), id(on)) not in drawn:
            of_draws = [key_path_of(key) for key in draws.of]
            drawn[id(body), id(on)] = _drawn(with_values(document, chosen), folder, of_draws)
        pairs = drawn.get((id(body), id(on)), ())
        cases.append(
            LoadCase(body=body, arguments=_arguments(case) | {"on": on}, draws=pairs, addition=_addition(case))
        )
    _require_effect(dimensions, key_paths, cases)
    fixed = _fixed(dimensions, cases)
    intervals = {} if draws is None else {"method": draws.method, "confidence": as_confidence(draws.confidence)}
    return Plan(dimensions=tuple(dimensions), fixed=fixed, cases=tuple(cases), **intervals)  # type: ignore[arg-type]


def _sliding_plan(
    document: dict[str, Any], folder: Path, key_paths: list[KeyPath], dimensions: list[Dimension]
) -> Plan:
    cases: list[LoadCase | str] = []
    surfaces: dict[str, RoughSurface] = {}
    for point in itertools.product(*(dimension.values for dimension in dimensions)):
        try:
            case = build_sliding(substituted(document, dict(zip(key_paths, point, strict=True))), folder, surfaces)
            cases.append(LoadCase(body=case.surface, arguments=case.arguments()))
        except (TypeError, ValueError) as error:
            cases.append(f"{type(error).__name__}: {error}")
    _require_effect(dimensions, key_paths, cases)
    return Plan(kind=SLIDING, dimensions=tuple(dimensions), fixed=_fixed(dimensions, cases), cases=tuple(cases))


def _fixed(dimensions: list[Dimension], cases: list[LoadCase | str]) -> dict[str, Any]:
    """Return the arguments that are the same at all points."""
    every = [case.arguments for case in cases if isinstance(case, LoadCase)]
    names = {dimension.name for dimension in dimensions}
    same = {k: v for k, v in (every[0] if every else {}).items() if all(other.get(k) == v for other in every)}
    return {name: value for name, value in same.items() if name not in names}


def _require_effect(dimensions: list[Dimension], key_paths: list[KeyPath], cases: list[LoadCase | str]) -> None:
    """Raise an InvalidInput if all points along an axis are the same, because the study does not use its key."""
    every = np.empty(len(cases), dtype=object)
    every[:] = cases
    grid = every.reshape([len(dimension.values) for dimension in dimensions])
    for axis, (dimension, key_path) in enumerate(zip(dimensions, key_paths, strict=True)):
        lines = np.moveaxis(grid, axis, -1).reshape(-1, len(dimension.values))
        if len(set(dimension.values)) > 1 and all(_same(line[0], other) for line in lines for other in line[1:]):
            raise InvalidInput(
                f'sweep."{key_path_text(key_path)}"',
                f"must change the case: `viscoroll sweep` does not use this key of [{key_path[0]}]",
            )


def _same(first: LoadCase | str, second: LoadCase | str) -> bool:
    return (
        isinstance(first, LoadCase)
        and isinstance(second, LoadCase)
        and first.body == second.body
        and first.arguments == second.arguments
        and first.addition == second.addition
    )


def _drawn(document: dict[str, Any], folder: Path, key_paths: list[KeyPath]) -> tuple[Pair, ...]:
    """Return both bodies for each draw of some materials; the i-th draws of all these materials belong together."""
    counts = {key_path_text(key_path): _count_draws(document, folder, key_path) for key_path in key_paths}
    if len(set(counts.values())) != 1:
        found = ", ".join(f"{count} at {key_path}" for key_path, count in counts.items()) or "none"
        raise InvalidInput("draws.of", "must name materials with equal numbers of draws", found)
    cases = (
        build_case(with_values(document, {(*key_path, "draw"): draw for key_path in key_paths}), folder)
        for draw in range(next(iter(counts.values())))
    )
    return tuple((case.body, case.on) for case in cases)


def _count_draws(document: dict[str, Any], folder: Path, key_path: KeyPath) -> int:
    """Return the number of draws in the file of a measured material; reject paths of other tables."""
    material: Any = document
    try:
        for part in key_path:
            material = material[part]
        file = folder / material["file"]
    except (IndexError, KeyError, TypeError):
        raise InvalidInput(
            "draws.of",
            "must name tables of measured materials whose files contain draws",
            f'"{key_path_text(key_path)}"',
        ) from None
    return count_draws(file)


def _numbers_in(tables: Collection[str | int], chosen: Mapping[KeyPath, float]) -> tuple[float, ...]:
    return tuple(number for key_path, number in chosen.items() if key_path[0] in tables)


def _addition(case: Case) -> Heating | None:
    """Return the temperatures of a case with a table [thermal]."""
    if case.thermal is None:
        return None
    if case.thermal.shift is not None:
        case.given_load()
    return Heating(case.thermal)


def _arguments(case: Case) -> dict[str, Any]:
    return {name: value for name, value in case.arguments().items() if name != "body"}


def _in_si(key: str, entry: Any, found: Key | None) -> Any:
    """Return an entry of the table `sweep` with numbers in SI units in place of texts with units."""
    path = f'sweep."{key}"'
    if found is not None and isinstance(entry, list):
        return [found.number(one, f"{path}[{i}]") if isinstance(one, str) else one for i, one in enumerate(entry)]
    if found is not None and isinstance(entry, dict):
        ends = {
            name: found.number(entry[name], f"{path}.{name}")
            for name in ("from", "to")
            if isinstance(entry.get(name), str)
        }
        return entry | ends
    return entry


def _entry(key: str, entry: object) -> list[float] | list[int] | Range:
    """Return the checked entry of the table `sweep` under a key, before the numbers of a range are generated."""
    if isinstance(entry, list) and all(isinstance(v, int | float) and not isinstance(v, bool) for v in entry):
        return entry
    if not isinstance(entry, dict):
        raise ValueError(
            f'sweep."{key}" must be a list of numbers or a table with from, to and count, got {shown(entry)}'
        )
    if "from" not in entry and any(isinstance(value, list | dict) for value in entry.values()):
        raise ValueError(f'sweep.{key}: the whole path must be in quotes, as in "{key}.{next(iter(entry))}"')
    try:
        return checked(Range, entry)
    except InvalidInput as error:
        raise error.inside(f'sweep."{key}"') from None


def _names(key_paths: list[KeyPath]) -> list[str]:
    short = [key_path_text(key_path[_leaf_position(key_path) :]) for key_path in key_paths]
    chosen = [
        s if short.count(s) == 1 else key_path_text(key_path[1:]) for s, key_path in zip(short, key_paths, strict=True)
    ]
    return [re.sub(r"\W+", "_", name).strip("_") for name in chosen]


def _leaf(key_path: KeyPath) -> str:
    return str(key_path[_leaf_position(key_path)])


def _leaf_position(key_path: KeyPath) -> int:
    return max(i for i, part in enumerate(key_path) if isinstance(part, str))
