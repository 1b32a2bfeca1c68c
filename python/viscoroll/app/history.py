"""Answers to requests of the page for histories over uneven ground, whose instants are sent as they are computed."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from .. import _core
from .._support.errors import InvalidInput
from .._support.result_warnings import silenced
from ..case.motion import build_motion
from .answer import answered, finite

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping

    from numpy.typing import NDArray

    from .._support.progress import ProgressLike
    from ..case.motion import MotionCase

__all__ = ["history_answer", "history_scalars"]


def history_scalars() -> list[dict[str, str]]:
    """Return name, unit and description of every time series of a history."""
    distance = {"name": "distance", "unit": "m", "description": "distance rolled along the track, r_o ψ"}
    scalars = [{"name": one.name, "unit": one.unit, "description": one.label} for one in _core.history_scalars()]
    return [distance, *scalars]


def history_answer(
    request: object, *, receive: Callable[[dict[str, Any]], object], progress: ProgressLike = None
) -> dict[str, Any]:
    """Compute the history of a request, which has the format of a motion file.

    Parameters
    ----------
    request : dict
        ``case``: the tables of a motion file, without names of files.
    receive : callable
        Called with the time series of new instants by name, in SI units; undetermined values are None.
    progress : callable, optional
        Same as in `viscoroll.roll`. An exception that it or `receive` raises ends the computation and propagates.

    Returns
    -------
    dict
        ``{"result": {"steps", "nodes_per_revolution", "spectrum_error"}}``, or an error as in `answer`.
    """

    def result() -> dict[str, Any]:
        if not isinstance(request, dict) or request.keys() != {"case"}:
            raise InvalidInput("request", "must be an object with the key case")
        motion = _readable_motion(request["case"])

        def received(instants: Mapping[str, NDArray[Any]]) -> None:
            series = {"distance": motion.body.outer_radius * instants["angle"], **instants}
            receive({name: [finite(value) for value in values.tolist()] for name, values in series.items()})

        with silenced():
            history = motion.roll(receive=received, progress=progress)
        return {
            "steps": len(history.time) - 1,
            "nodes_per_revolution": history.mesh.nodes_per_revolution,
            "spectrum_error": history.spectrum_error,
        }

    return answered(result)


def _readable_motion(document: object) -> MotionCase:
    """Return the motion that tables describe, without reading any file."""
    if not isinstance(document, dict):
        raise InvalidInput("case", "must be an object with the tables of a motion file")
    # Fields of the page show the unit of each length, and the page itself warns of implausible ones.
    return build_motion({"allow_large": True} | document, None)
