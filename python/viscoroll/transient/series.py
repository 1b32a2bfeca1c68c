"""Scalars of a history, as described by the table of the core: numbers at an instant, arrays over time."""

from __future__ import annotations

from typing import TYPE_CHECKING

from .. import _core
from .._support.scalars import scalar_fields, units_in_contact

__all__ = ["HISTORY_SCALARS", "InstantFields", "SeriesFields", "series_units"]

#: Unit and label of each scalar of a history, by name.
HISTORY_SCALARS = {scalar.name: (scalar.unit, scalar.label) for scalar in _core.history_scalars()}


def series_units(*, line_contact: bool) -> dict[str, str]:
    """Return the unit of every scalar of a history."""
    return units_in_contact(_core.history_scalars(), line_contact=line_contact)


if TYPE_CHECKING:
    from .._core import InstantSeries as SeriesFields
    from .._core import RollingInstant as InstantFields
else:
    #: Dataclasses with one field per scalar: a number, or a time series.
    InstantFields = scalar_fields("InstantFields", dict.fromkeys(HISTORY_SCALARS, "float"))
    SeriesFields = scalar_fields("SeriesFields", dict.fromkeys(HISTORY_SCALARS, "NDArray[np.float64]"))
