"""What a solve returns: a solution, and all that looks into it."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, overload

from .._support.files import save
from .._support.progress import ProgressLike
from ..solution import Solution
from ..solution.files import FORMATS
from ..solution.interior_fields import bond_fields, interior_fields
from ..solution.loss import loss_of
from ..solution.loss_spectrum import extrapolated_share
from ..solution.text import result_html, result_summary

if TYPE_CHECKING:
    import xarray
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from numpy.typing import ArrayLike

__all__ = ["Result"]


@dataclass(frozen=True, slots=True, kw_only=True, eq=False, repr=False)
class Result(Solution):  # noqa: D101  (described as the solution that it is)
    __doc__ = Solution.__doc__

    def __repr__(self) -> str:
        """Return a summary of one screen."""
        return result_summary(self)

    def _repr_html_(self) -> str:
        """Return all scalar results with units, as a table for notebooks."""
        return result_html(self)

    def extrapolated_loss(self) -> float | None:
        """Return the share of the power lost in the coating at harmonics that a measured table does not hold.

        Returns
        -------
        float or None
            [-], where the outermost entries of a `MasterCurve` were held; None without such a material.
        """
        return extrapolated_share(self)

    def interior(
        self,
        *,
        depth: ArrayLike | None = None,
        radius: ArrayLike | None = None,
        phi: ArrayLike | None = None,
        theta: ArrayLike | None = None,
        threads: int = 0,
        progress: ProgressLike = None,
    ) -> xarray.Dataset:
        """Displacement, strain and stress inside the coating.

        Parameters
        ----------
        depth : array_like
            Below the surface [m], within the coating; or `radius`. Where layers meet, strains and stresses along the
            surface jump: such a depth comes twice, the outer layer first, see the coordinate `layer`.
        radius : array_like
            r [m], in place of `depth`.
        phi, theta : array_like, optional
            Angles [rad] within half a revolution of the lowest point, π/2; by default those of the nodes.
            ``theta=[π/2]`` with many depths is the section through the contact.
        threads : int, default 0
            Number of threads; 0 for all cores.
        progress : bool or callable, optional
            True shows a bar; or called as progress(stage, fraction) about every 20 ms.

        Returns
        -------
        xarray.Dataset
            Over (depth, phi, theta): `displacement` [m] by `direction`, `stress` [Pa] (tension positive) and `strain`
            [-] by `component`, and of them `von_mises`, `principal_stress` (largest first), `hydrostatic_pressure`,
            and the traction on the surface r = const: `opening_traction`, its tension where there is any, and
            `shear_traction` [Pa].

        Raises
        ------
        TypeError, ValueError
            For bad input; also with curvature EXACT, which has no orders (m, n).
        ImportError
            Without the extra `viscoroll[files]`.

        Warns
        -----
        ResultWarning
            For depths where the mesh is too coarse: less than a quarter of a spacing, between nodes half of one.

        Notes
        -----
        Stresses are those of the compliance of the solve. With VERTICAL pressure acts along the plane's normal and so
        has a share along the coating, up to p x/r_o, which raises the largest von Mises stress near the surface.

        Examples
        --------
        >>> from viscoroll import Mesh, paper, solve
        >>> r = solve(paper.ball(), load=100.0, angular_speed=2.5, mesh=Mesh(nodes_per_revolution=400))
        >>> inside = r.interior(depth=[0.3e-3, 1e-3])
        >>> print(f"{inside.von_mises.max().item() / 1e6:.1f} MPa")
        3.8 MPa
        """
        return interior_fields(
            self, depth=depth, radius=radius, phi=phi, theta=theta, threads=threads, progress=progress
        )

    def bonds(self, *, threads: int = 0, progress: ProgressLike = None) -> xarray.Dataset:
        """Fields where layers are bonded, to the core and to one another: what debonds.

        Parameters
        ----------
        threads, progress
            As of `interior`.

        Returns
        -------
        xarray.Dataset
            As of `interior`, at the core of a ball with a rigid one, and on both sides of every boundary between
            layers.

        Raises
        ------
        ValueError
            Where nothing is bonded to anything.
        """
        return bond_fields(self, threads=threads, progress=progress)

    def loss(
        self,
        *,
        depth: ArrayLike | None = None,
        max_order: int | None = None,
        threads: int = 0,
        progress: ProgressLike = None,
    ) -> xarray.Dataset:
        """Energy lost inside the coating, per volume and revolution.

        Parameters
        ----------
        depth : array_like, optional
            Where the densities are wanted [m]; by default at the nodes of the volume integral.
        max_order : int, optional
            Orders |m|, |n| up to this one are summed; by default those of the mesh or 40 r_o/a, whichever are fewer, a
            the contact's semi-axis: 0.9999 of the loss, on coarse meshes 0.998.
        threads : int, default 0
            Number of threads; 0 for all cores.
        progress : bool or callable, optional
            True shows a bar; or called as progress(stage, fraction) about every 20 ms.

        Returns
        -------
        xarray.Dataset
            `loss_density` w [J/m³ per revolution] and `power_density` Ωw/2π [W/m³], its mean over a revolution, over
            (radius, theta); `layer_power` [W] by `layer`, and `relaxation_power` [W] by `layer` and `term` for layers
            that are Prony series. Attributes: `power`, the volume integral [W], `surface_power`, what the tractions put
            into the same orders, and `bulk_power`, that of all orders; each of what rolls alone.

        Raises
        ------
        TypeError, ValueError
            For bad input; also with curvature EXACT.
        ImportError
            Without the extra `viscoroll[files]`.

        Notes
        -----
        The model's volume is r² dr dθ dφ, without sin θ.

        Examples
        --------
        >>> from viscoroll import Mesh, paper, solve
        >>> r = solve(paper.ball(), load=100.0, angular_speed=2.5, mesh=Mesh(nodes_per_revolution=400))
        >>> loss = r.loss(depth=[0.5e-3])
        >>> print(f"{loss.attrs['power'] / r.bulk_power:.3f} {loss.power_density.max().item() / 1e3:.0f} kW/m³")
        0.998 50 kW/m³
        """
        return loss_of(self, depth=depth, max_order=max_order, threads=threads, progress=progress)

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
            For another suffix.
        ImportError
            For all but ``.csv``, without the extra `viscoroll[files]`.
        """
        save(self, path, FORMATS)

    @overload
    def plot(self) -> Figure: ...

    @overload
    def plot(self, ax: Axes) -> Axes: ...

    def plot(self, ax: Axes | None = None) -> Figure | Axes:
        """Draw the pressure with the contact's outline and the resultant's offset, and the profile along the path.

        With friction also where the contact sticks and slips, with arrows for the traction on the coating.

        Parameters
        ----------
        ax : matplotlib.axes.Axes, optional
            Where to draw the map of the pressure alone, of a roller its profile.

        Returns
        -------
        matplotlib.figure.Figure or matplotlib.axes.Axes
            A new figure, which shows itself in a notebook and is saved by ``savefig``; or `ax`.

        Raises
        ------
        ImportError
            Without the extra `viscoroll[plot]`.
        """
        from ..solution.picture import plot_contact

        return plot_contact(self, ax)
