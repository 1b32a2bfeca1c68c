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
from ..solution.loss_spectrum import loss_spectrum as _loss_spectrum
from ..thermal import temperature as temperatures
from . import sensitivity as sensitivities

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from ..solution.inside import Of

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
    loss_spectrum = _loss_spectrum
    temperature = temperatures.temperature
    plane_cooling = temperatures.plane_cooling
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
        """Draw the pressure with the contact outline and the resultant, and the profile of the pressure along the path.

        With friction, also draw the zones of stick and slip, with arrows for the traction on the coating.
        """
        from ..solution.picture import plot_contact

        return plot_contact(self, ax)

    def plot_section(self, *, of: Of | None = None) -> Figure:
        """Draw the section θ = π/2 through the contact: von Mises stress, and the pressure above it.

        The layers are unrolled, with forward to the right, and stretched in depth. Those of the counterbody are also
        drawn below their surface.

        Parameters
        ----------
        of : "body" or "counterbody", optional
            Rolling body or counterbody. By default the deformable body; if both deform, the rolling body.

        Returns
        -------
        matplotlib.figure.Figure
            New figure without a window.

        Raises
        ------
        ValueError
            If the curvature of the result is EXACT, or the body is rigid.
        ImportError
            If the extra `viscoroll[plot]` or `viscoroll[files]` is missing.
        """
        from ..solution.interior_picture import plot_section

        return plot_section(self, of)

    def plot_loss(self, ax: Axes | None = None, *, of: Of | None = None) -> Figure | Axes:
        """Draw the energy dissipated per volume and passage over the cross-section, or over the depth in line contact.

        Parameters
        ----------
        ax : matplotlib.axes.Axes, optional
            Axes to draw into; by default those of a new figure.
        of : "body" or "counterbody", optional
            Rolling body or counterbody. By default the deformable body; if both deform, the rolling body.

        Returns
        -------
        matplotlib.figure.Figure or matplotlib.axes.Axes
            A new figure, or `ax`.

        Raises
        ------
        ValueError
            If the curvature of the result is EXACT, or the body is rigid.
        ImportError
            If the extra `viscoroll[plot]` or `viscoroll[files]` is missing.
        """
        from ..solution.interior_picture import plot_loss

        return plot_loss(self, ax, of)
