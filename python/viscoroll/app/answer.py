"""Answers to requests of the page: a case as JSON gives numbers and fields, or an error message."""

from __future__ import annotations

import math
from dataclasses import asdict
from typing import TYPE_CHECKING, Any

from .. import _core
from .._core import ConvergenceError
from .._support.errors import InvalidInput
from .._support.result_warnings import silenced
from .._support.text import one_line
from ..bodies.si_hints import unit_doubt
from ..case import build_case
from ..case.case import BODIES, COUNTERBODIES, CaseFile

if TYPE_CHECKING:
    from collections.abc import Callable

    from .._support.progress import ProgressLike
    from ..case import Case
    from ..rolling import Result

__all__ = [
    "OTHER_TABLES",
    "answer",
    "answered",
    "error_answer",
    "finite",
    "readable_case",
    "scalars",
    "tables_of_page",
]

#: Keys of a request.
_KEYS = {"case", "fields"}

#: Tables of case files that the page does not support.
OTHER_TABLES = ("thermal", "motion", "ground", "tread", "axle", "surface", "sliding", "sweep", "design")


def scalars() -> list[dict[str, str]]:
    """Return name, unit, description, group and precision of every scalar result, from the table of the core."""
    return [
        {
            "name": one.name,
            "unit": one.unit,
            "description": one.label,
            "group": one.group,
            "precision": one.precision,
        }
        for one in _core.result_scalars()
    ]


def answer(request: object, *, progress: ProgressLike = None) -> dict[str, Any]:
    """Solve the case of a request, which has the format of a case file.

    Parameters
    ----------
    request : dict
        ``case``: the tables of a case file, without names of files; ``fields``: whether to return fields.
    progress : callable, optional
        Same as in `viscoroll.solve`. An exception that it raises ends the solve and propagates.

    Returns
    -------
    dict
        ``{"result": {"scalars", "state", "warnings", "fields"}}``, in SI units, or ``{"error": {"message",
        "parameter", "rule", "value", "allowed"}}``: the message as for a case file, and the attributes of
        `InvalidInput`, or None for other errors. Ends of a range that do not exist are None.
    """

    def result() -> dict[str, Any]:
        if not isinstance(request, dict) or "case" not in request or set(request) - _KEYS:
            raise InvalidInput("request", "must be an object with the key case and optionally the key fields")
        case = readable_case(request["case"])
        with silenced():
            solved = case.solve(progress=progress)
        found = {
            "scalars": {name: finite(value) for name, value in solved.scalars().items()},
            "state": solved.status.name.lower(),
            "warnings": _warnings(solved),
        }
        return found | ({"fields": _fields(solved)} if request.get("fields") else {})

    return answered(result)


def answered(result: Callable[[], dict[str, Any]]) -> dict[str, Any]:
    """Return what a function returns as ``{"result": ...}``, or the error of a case that it raises."""
    try:
        return {"result": result()}
    except (ValueError, TypeError, ConvergenceError, RecursionError) as error:
        return {"error": error_answer(one_line(str(error)), error if isinstance(error, InvalidInput) else None)}
    except MemoryError:
        message = "not enough memory for this case: use a larger accuracy, that is, a coarser mesh"
        return {"error": error_answer(message)}


def readable_case(document: object) -> Case:
    """Return the case that tables describe, without reading any file.

    Raises
    ------
    ValueError, TypeError
        If the tables are not valid, refer to a file, or include tables of `OTHER_TABLES`.
    """
    if not isinstance(document, dict):
        raise InvalidInput("case", "must be an object with the tables of a case file")
    if others := [name for name in OTHER_TABLES if name in document]:
        raise InvalidInput(others[0], "must be left out: the page does not support this table")
    # Fields of the page show the unit of each length, and the page itself warns of implausible ones.
    return build_case({"allow_large": True} | document, None)


def tables_of_page(document: dict[str, Any]) -> dict[str, Any]:
    """Return the tables of a case file as the page reads them: in SI units, with the radii of cores.

    Raises
    ------
    ValueError, TypeError
        If the tables are not valid, refer to a file, or include tables of `OTHER_TABLES`.
    """
    case = readable_case({"allow_large": False} | document)
    tables: dict[str, Any] = CaseFile.keys_of(document).in_si(document)
    tables.pop("allow_large", None)
    for names, body in ((BODIES, case.body), (COUNTERBODIES, case.on)):
        for name in [name for name in names if "outer_diameter" in tables.get(name, {})]:
            core_radius = getattr(body, "core_radius")  # noqa: B009 - planes have no core, and no diameter
            tables[name] = {k: v for k, v in tables[name].items() if k != "outer_diameter"} | {
                "core_radius": core_radius
            }
    return tables


def error_answer(message: str, invalid: InvalidInput | None = None) -> dict[str, Any]:
    """Return the error of an answer, with the attributes of `InvalidInput` if there is one."""
    if invalid is None:
        return {"message": message, "parameter": None, "rule": None, "value": None, "allowed": None}
    allowed = None if invalid.allowed is None else {name: finite(one) for name, one in asdict(invalid.allowed).items()}
    return {
        "message": message,
        "parameter": invalid.parameter,
        "rule": invalid.rule,
        "value": invalid.value,
        "allowed": allowed,
    }


def finite(value: float | int | str | None) -> float | int | str | None:
    """Return None for infinite and undefined values, for which JSON has no numbers, else the value."""
    return None if isinstance(value, float) and not math.isfinite(value) else value


def _warnings(result: Result) -> list[dict[str, str]]:
    warnings = [{"kind": kind.name.lower(), "message": message} for kind, message in result.warnings.items()]
    hint = unit_doubt(result.body, result.on)
    return [*warnings, *([{"kind": "units", "message": hint}] if hint else [])]


def _fields(result: Result) -> dict[str, Any]:
    """Return pressure and stick state at the nodes, and heights in the middle plane, deformed and rigid [SI units]."""
    row, middle = (count // 2 for count in result.x.shape)  # on a ball, other rows differ slightly
    surface = result.gap[:, middle]
    state = result.stick.astype(int) + 2 * result.slip.astype(int) if result.friction > 0.0 else None
    return {
        "x": result.x[:, middle].tolist(),
        "z": result.z[row].tolist(),
        "pressure": result.pressure.tolist(),
        "stick": None if state is None else state.tolist(),
        "profile": {
            "x": result.x[:, middle].tolist(),
            "surface": surface.tolist(),
            "rigid": (surface - result.displacement[:, middle]).tolist(),
        },
    }
