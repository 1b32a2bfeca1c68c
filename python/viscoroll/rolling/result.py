"""Result of a solve: a solution, with the methods that evaluate it."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from .._support.files import save
from .._support.plotting import plots
from ..solution import Solution, interior_fields, text
from ..solution import loss as losses
from ..solution.files import FORMATS
from ..solution.loss_spectrum import extrapolated_loss as _extrapolated_loss
from . import sensitivity as sensitivities

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

__all__ = ["Result"]


@dataclass(frozen=True, slots=True, kw_only=True, eq=False, repr=False)
class Result(Solution):  # noqa: D101  (described as the solution that it is)
    __doc__ = Solution.__doc__

    __repr__ = text.result_summary
    _repr_html_ = text.result_html
    extrapolated_loss = _extrapolated_loss
    interior = interior_fields.interior
    bonds = interior_fields.bonds
    loss = losses.loss
    sensitivity = sensitivities.sensitivity

    def save(self, path: str | Path) -> None:
        """Write the fields to a file, in the format of its suffix.

        Parameters
        ----------
        path : path-like
            ``.csv`` (a row for each node), ``.nc`` (netCDF, with scalars as attributes) or ``.vtu``/``.vtk`` (the
            deformed surface, for ParaView).

        Raises
        ------
        ValueError
            If the suffix is another one.
        ImportError
            If the extra `viscoroll[files]` is missing, for all formats except ``.csv``.
        """
        save(self, path, FORMATS)

    @plots("only the map of the pressure, or its profile for a roller")
    def plot(self, ax: Axes | None = None) -> Figure | Axes:
        """Draw the pressure with the contact outline and the offset of the resultant, and the profile along the path.

        With friction, also draw the zones of stick and slip, with arrows for the traction on the coating.
        """
        from ..solution.picture import plot_contact

        return plot_contact(self, ax)
