"""Temperature of the layers for the page of `viscoroll app`."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from .._core import ConvergenceError
from .._support.errors import InvalidInput
from .._support.result_warnings import silenced
from .._support.text import one_line
from ..case import build_case
from .answer import error_answer, readable_case

if TYPE_CHECKING:
    from .._support.progress import ProgressLike

__all__ = ["temperature_answer"]

#: Numbers of a temperature that the page shows.
_NUMBERS = ("maximum", "surface_maximum", "mean", "heat", "heat_to_core", "ambient")


def temperature_answer(request: object, *, progress: ProgressLike = None) -> dict[str, Any]:
    """Return the steady temperature of the layers for a case.

    Parameters
    ----------
    request : dict
        ``case``: tables as in `viscoroll.app.answer`; ``thermal``: the table of this name of a case file.
    progress : callable, optional
        Same as in `viscoroll.solve`. An exception that it raises ends the solve and propagates.

    Returns
    -------
    dict
        ``{"temperature": {"maximum", "surface_maximum", "mean", "heat", "heat_to_core", "ambient", "heat_unit", "rise",
        "axes", "warnings"}}``: attributes of `viscoroll.thermal.Temperature`, the coordinates of the rise by the names
        of its dimensions, in their order, and texts of warnings; or ``{"error": {...}}`` as in `viscoroll.app.answer`.
    """
    try:
        if not isinstance(request, dict) or set(request) != {"case", "thermal"}:
            raise InvalidInput("request", "must be an object with the keys case and thermal")
        readable_case(request["case"])  # rejects tables that the page does not support
        case = build_case({"allow_large": True} | request["case"] | {"thermal": request["thermal"]}, None)
        if case.thermal is None:
            raise InvalidInput("thermal", "must be a table")
        with silenced():
            result = case.solve(progress=progress)  # whose warnings are those of `answer`
        with silenced() as warnings:
            found = case.thermal.temperature(result, progress=progress)
    except (ValueError, TypeError, ConvergenceError, RecursionError) as error:
        return {"error": error_answer(one_line(str(error)), error if isinstance(error, InvalidInput) else None)}
    except MemoryError:
        return {"error": error_answer("not enough memory for this temperature: use a larger accuracy")}
    return {
        "temperature": {
            **{name: getattr(found, name) for name in _NUMBERS},
            "heat_unit": found.heat_unit,
            "rise": found.rise.to_numpy().tolist(),
            "axes": {str(name): found.rise[name].to_numpy().tolist() for name in found.rise.dims},
            "warnings": warnings,
        }
    }
