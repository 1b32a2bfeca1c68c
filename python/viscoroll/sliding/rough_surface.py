"""Rough surfaces as heights at equal distances."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Literal

import numpy as np

from .._support.arguments import as_float, as_float_array, as_int, as_positive, require_callable, require_type
from .._support.errors import InvalidInput
from .._support.plotting import plots
from .._support.text import shown
from .files import read_heights
from .filling import filled
from .random_map import self_affine_heights

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from numpy.typing import ArrayLike, NDArray

__all__ = ["RoughSurface"]


@dataclass(frozen=True, slots=True, eq=False, repr=False)
class RoughSurface:
    """A rigid rough surface: heights at equal distances, as a map or as a profile that is constant across.

    Parameters
    ----------
    heights : array_like, shape (nodes along x,) or (nodes along x, nodes along z)
        Heights [m], positive towards the softer body, so that the highest points touch first. The surface slides
        along x, towards growing indices. A one-dimensional array is a profile in line contact.
    spacing : float or tuple of two floats
        Distance of the nodes along x, or along x and along z [m].
    periodic : bool, default True
        Whether the surface repeats itself beyond the last node. If not, `slide` solves a surface of finite size,
        around which the layers are free; `mirrored` makes it periodic.
    fill : bool, default False
        Whether to give undefined nodes, whose heights are NaN, the mean height of their four neighbors. An error
        otherwise.

    Examples
    --------
    >>> import numpy as np
    >>> import viscoroll as vr
    >>> x = np.arange(64) * 1e-4
    >>> wavy = vr.RoughSurface(1e-5 * np.cos(2 * np.pi * x / 6.4e-3), spacing=1e-4)
    >>> print(f"{wavy.rms_height:.3e} m, rms slope {wavy.rms_slope:.4f}")
    7.071e-06 m, rms slope 0.0069
    """

    heights: NDArray[np.float64]
    spacing: tuple[float, float]
    periodic: bool

    def __init__(
        self, heights: ArrayLike, spacing: float | tuple[float, float], *, periodic: bool = True, fill: bool = False
    ) -> None:
        values = as_float_array("heights", heights)
        if values.ndim == 1:
            values = values[:, np.newaxis]
        if values.ndim != 2 or min(values.shape) < 1:
            raise InvalidInput("heights", "must have one or two dimensions", f"shape {values.shape}")
        require_type("fill", fill, bool)
        if fill:
            values = filled(values)
        if not np.isfinite(values).all():
            missing = int(np.count_nonzero(~np.isfinite(values)))
            raise InvalidInput("heights", "must be finite unless fill is True", f"{missing} undefined nodes")
        values = np.array(values, dtype=np.float64, order="C")
        values.flags.writeable = False
        require_type("periodic", periodic, bool)
        object.__setattr__(self, "heights", values)
        object.__setattr__(self, "spacing", _spacings(spacing))
        object.__setattr__(self, "periodic", periodic)

    @classmethod
    def read(
        cls,
        path: str | Path,
        *,
        format: str | None = None,  # noqa: A002
        spacing: float | tuple[float, float] | None = None,
        periodic: bool = False,
        fill: bool = False,
    ) -> RoughSurface:
        """Read a surface from a file.

        Parameters
        ----------
        path : str or Path
            File in a format of an instrument, if `format` is given, or else in one of these formats:

            - ``.npy``: array of heights [m];
            - ``.csv`` or ``.txt``: matrix of heights [m], one row per node along x, with commas, semicolons, tabs or
              blanks between the numbers; lines that begin with # are skipped;
            - ``.nc``: variable of one or two dimensions, named height or heights unless it is the only one, in m
              unless it has the attribute units (m, mm, um, µm or nm); coordinates with the names of the dimensions
              give the spacing, in m or their own units. Needs the extra `viscoroll[files]`.
        format : str, optional
            Format of an instrument, such as sur, x3p, opd, plux, al3d, vk, gwy or datx: one of the 40 readers of the
            package SurfaceTopography, which is not asked to detect the format, because that takes seconds. Needs the
            extra `viscoroll[surfaces]`.
        spacing : float or tuple of two floats, optional
            Distance of the nodes [m]; required unless the file contains it.
        periodic : bool, default False
            Whether the surface repeats itself beyond the last node.
        fill : bool, default False
            Whether to fill nodes that were not measured; see `RoughSurface`.

        Returns
        -------
        RoughSurface
            The surface.

        Raises
        ------
        ValueError
            If the file has another format, contains no heights, or no spacing is given.
        OSError
            If the file cannot be read.
        """
        heights, in_file = read_heights(Path(path), format)
        if spacing is None and in_file is None:
            raise InvalidInput("spacing", f"must be given: {Path(path).name} does not contain it")
        return cls(
            heights,
            in_file if spacing is None and in_file is not None else _spacings(spacing),
            periodic=periodic,
            fill=fill,
        )

    @classmethod
    def self_affine(
        cls,
        nodes: int,
        side: float,
        *,
        hurst: float,
        rolloff: float,
        cutoff: float,
        rms_slope: float | None = None,
        rms_height: float | None = None,
        seed: int,
    ) -> RoughSurface:
        """Return a random periodic surface whose spectral density falls as a power of the wavenumber.

        The density is constant from the longest waves to the roll-off, falls as q^(-2 - 2H) up to the cutoff and
        vanishes beyond it. Amplitudes are exact and phases are random. The waves do not depend on the number of nodes,
        so that the same surface can be solved on several meshes.

        Parameters
        ----------
        nodes : int
            Nodes per side.
        side : float
            Length of a side of the square [m].
        hurst : float
            Hurst exponent H, in [0, 1].
        rolloff, cutoff : float
            Wavelengths [m], cutoff ≤ rolloff ≤ side. The cutoff spans at least two spacings; a solution needs about
            eight.
        rms_slope, rms_height : float
            Root mean square of the gradient [-] or of the height [m]; exactly one must be given.
        seed : int
            Seed of the random phases, ≥ 0.

        Examples
        --------
        >>> import viscoroll as vr
        >>> rough = vr.RoughSurface.self_affine(
        ...     256, 1e-3, hurst=0.8, rolloff=1e-3 / 4, cutoff=1e-3 / 32, rms_slope=0.1, seed=1
        ... )
        >>> print(f"{rough.rms_slope:.3f}")
        0.100
        """
        count, length = as_int("nodes", nodes), as_positive("side", side, "m")
        heights = self_affine_heights(
            count,
            length,
            hurst=as_float("hurst", hurst),
            rolloff=as_positive("rolloff", rolloff, "m"),
            cutoff=as_positive("cutoff", cutoff, "m"),
            seed=as_int("seed", seed),
        )
        if (rms_slope is None) == (rms_height is None):
            raise ValueError("exactly one of rms_slope and rms_height must be given")
        surface = cls(heights, length / count)
        if rms_height is not None:
            return surface.scaled(as_positive("rms_height", rms_height, "m") / surface.rms_height)
        return surface.scaled(as_positive("rms_slope", rms_slope) / surface.rms_slope)

    @classmethod
    def of(
        cls,
        function: Callable[[NDArray[np.float64], NDArray[np.float64]], ArrayLike],
        nodes: int | tuple[int, int],
        side: float | tuple[float, float],
    ) -> RoughSurface:
        """Return the periodic surface of a function of the position.

        Parameters
        ----------
        function : callable
            Returns the heights [m] at positions x and z [m], given as arrays that broadcast to (nodes along x, nodes
            along z).
        nodes : int or tuple of two ints
            Nodes along x and z; a single number applies to both. (n, 1) is a profile.
        side : float or tuple of two floats
            Periods along x and z [m].

        Examples
        --------
        >>> import numpy as np
        >>> import viscoroll as vr
        >>> egg_box = vr.RoughSurface.of(
        ...     lambda x, z: 1e-6 * np.cos(2e4 * np.pi * x) * np.cos(2e4 * np.pi * z), nodes=64, side=1e-4
        ... )
        >>> egg_box.heights.shape
        (64, 64)
        """
        require_callable("function", function)
        rows, columns = (as_int("nodes", count) for count in _pair("nodes", nodes))
        for count in (rows, columns):
            if count < 1:
                raise InvalidInput("nodes", "must be >= 1", shown(count))
        along, across = (as_positive("side", length, "m") for length in _pair("side", side))
        x = np.arange(rows, dtype=np.float64)[:, np.newaxis] * (along / rows)
        z = np.arange(columns, dtype=np.float64)[np.newaxis, :] * (across / columns)
        heights = np.broadcast_to(as_float_array("heights", function(x, z)), (rows, columns))
        return cls(heights, (along / rows, across / columns))

    @property
    def is_profile(self) -> bool:
        """Whether the surface is constant across the sliding direction."""
        return bool(self.heights.shape[1] == 1)

    @property
    def sides(self) -> tuple[float, float]:
        """Length along x and width along z [m]; the periods if the surface is periodic."""
        rows, columns = self.heights.shape
        return rows * self.spacing[0], columns * self.spacing[1]

    @property
    def rms_height(self) -> float:
        """Root mean square of the heights about their mean [m]."""
        return float(self.heights.std())

    @property
    def rms_slope(self) -> float:
        """Root mean square of the gradient [-]: of all waves if the surface is periodic, else of differences."""
        if self.periodic:
            squares = sum(np.square(slope).mean() for slope in self.slopes())
        else:
            squares = sum(
                np.square(np.diff(self.heights, axis=axis) / self.spacing[axis]).mean()
                for axis in (0, 1)
                if self.heights.shape[axis] > 1
            )
        return float(np.sqrt(squares))

    def slopes(self) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Return the slopes along x and z at the nodes [-], of all waves of a periodic surface.

        Raises
        ------
        ValueError
            If the surface is not periodic.
        """
        self._require_periodic()
        waves, (k_x, k_z) = np.fft.rfft2(self.heights), self._wavenumbers()
        shape = self.heights.shape
        # The highest wave of an even number of nodes has no slope at the nodes.
        k_x, k_z = _without_highest(k_x, shape[0]), _without_highest(k_z, shape[1])
        along = np.fft.irfft2(1j * k_x[:, np.newaxis] * waves, s=shape)
        across = np.fft.irfft2(1j * k_z[np.newaxis, :] * waves, s=shape)
        return along, across

    def scaled(self, factor: float) -> RoughSurface:
        """Return the surface with all heights multiplied by a number."""
        return self._with(as_float("factor", factor) * self.heights)

    def detrended(self, degree: Literal[0, 1, 2] = 1) -> RoughSurface:
        """Return the surface without its mean (degree 0), mean plane (1) or mean paraboloid (2), by least squares."""
        if degree not in (0, 1, 2):
            raise InvalidInput("degree", "must be 0, 1 or 2", shown(degree))
        rows, columns = self.heights.shape
        x, z = (
            grid.ravel() for grid in np.meshgrid(np.linspace(-1, 1, rows), np.linspace(-1, 1, columns), indexing="ij")
        )
        terms = [x**i * z**j for i in range(degree + 1) for j in range(degree + 1 - i) if j == 0 or columns > 1]
        matrix = np.stack(terms, axis=1)
        shares = np.linalg.lstsq(matrix, self.heights.ravel(), rcond=None)[0]
        return self._with(self.heights - (matrix @ shares).reshape(rows, columns))

    def cutoff(self, wavelength: float) -> RoughSurface:
        """Return the surface without waves shorter than a wavelength [m]; a surface that is not periodic is mirrored.

        The friction of a rough surface depends on its shortest waves. Compare two cutoffs.
        """
        shortest = as_positive("wavelength", wavelength, "m")
        whole = self if self.periodic else self.mirrored()
        k_x, k_z = whole._wavenumbers()
        kept = np.hypot(k_x[:, np.newaxis], k_z[np.newaxis, :]) <= 2.0 * np.pi / shortest * (1.0 + 1e-12)
        smooth = np.fft.irfft2(np.where(kept, np.fft.rfft2(whole.heights), 0.0), s=whole.heights.shape)
        rows, columns = self.heights.shape
        return self._with(smooth[:rows, :columns])

    def mirrored(self) -> RoughSurface:
        """Return a periodic surface of twice the length and width: this one and its mirror images."""
        heights = np.concatenate([self.heights, self.heights[::-1]])
        if not self.is_profile:
            heights = np.concatenate([heights, heights[:, ::-1]], axis=1)
        return RoughSurface(heights, self.spacing)

    def resampled(self, nodes: int | tuple[int, int]) -> RoughSurface:
        """Return the same periodic surface on another mesh, by trigonometric interpolation.

        A solution on twice the nodes shows the error of the mesh.

        Parameters
        ----------
        nodes : int or tuple of two ints
            Nodes along x and z; a single number applies to both directions of a map.

        Raises
        ------
        ValueError
            If the surface is not periodic, or if it has waves that the mesh does not resolve.
        """
        self._require_periodic()
        wanted = (
            (as_int("nodes", nodes), 1) if self.is_profile and not isinstance(nodes, tuple) else _pair("nodes", nodes)
        )
        rows, columns = (as_int("nodes", count) for count in wanted)
        if min(rows, columns) < 1:
            raise InvalidInput("nodes", "must be >= 1", shown(nodes))
        given = self.heights.shape
        waves = np.fft.fftshift(np.fft.fft2(self.heights, norm="forward"))
        padded = np.zeros((rows, columns), dtype=complex)
        from_rows, to_rows = _common_waves(given[0], rows)
        from_columns, to_columns = _common_waves(given[1], columns)
        padded[to_rows, to_columns] = waves[from_rows, from_columns]
        lost = np.sqrt(max(np.square(np.abs(waves)).sum() - np.square(np.abs(padded)).sum(), 0.0))
        if lost > 1e-6 * self.rms_height:
            raise InvalidInput(
                "nodes", "must resolve all waves of the surface; apply cutoff first", f"{rows} x {columns}"
            )
        heights = np.fft.ifft2(np.fft.ifftshift(padded), norm="forward").real
        along, across = self.sides
        return RoughSurface(heights, (along / rows, across / columns))

    def spectrum(self) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Return the power spectral density of a periodic surface, averaged over rings of wavenumbers.

        Returns
        -------
        wavenumber : ndarray
            Mean wavenumber of each ring [rad/m].
        density : ndarray
            Spectral density [m⁴], whose integral over all wave vectors (k_x, k_z) is (2π)² times the mean square
            height; of a profile [m³], whose integral over k_x from -∞ to ∞ is 2π times it.
        """
        self._require_periodic()
        rows, columns = self.heights.shape
        along, across = self.sides
        squares = np.square(np.abs(np.fft.fft2(self.heights, norm="forward")))
        k_x = 2.0 * np.pi * np.fft.fftfreq(rows, self.spacing[0])
        k_z = 2.0 * np.pi * np.fft.fftfreq(columns, self.spacing[1])
        wavenumber = np.hypot(k_x[:, np.newaxis], k_z[np.newaxis, :]).ravel()
        width = 2.0 * np.pi / (along if self.is_profile else min(along, across))
        ring = np.rint(wavenumber / width).astype(int)
        count = np.bincount(ring)
        present = np.flatnonzero(count)[1:]
        area = along if self.is_profile else along * across
        mean = np.bincount(ring, squares.ravel())[present] / count[present]
        return np.bincount(ring, wavenumber)[present] / count[present], mean * area

    @plots("the heights")
    def plot(self, ax: Axes | None = None) -> Figure | Axes:
        """Draw the heights: a map in colors, or a profile as a line."""
        from .picture import draw_field

        return draw_field(self.heights * 1e6, self.sides, "height [µm]", colors="viridis", ax=ax)

    def __repr__(self) -> str:
        """Return a summary in one line."""
        rows, columns = self.heights.shape
        size = f"{rows} nodes" if self.is_profile else f"{rows} x {columns} nodes"
        kind = "periodic" if self.periodic else "not periodic"
        length = " x ".join(f"{side:.4g}" for side in (self.sides[:1] if self.is_profile else self.sides))
        return (
            f"RoughSurface({size}, {length} m, {kind}, rms height {self.rms_height:.4g} m, "
            f"rms slope {self.rms_slope:.4g})"
        )

    def _with(self, heights: NDArray[np.float64]) -> RoughSurface:
        return RoughSurface(heights, self.spacing, periodic=self.periodic)

    def _wavenumbers(self) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Return k_x and the nonnegative k_z of the waves of `numpy.fft.rfft2` [rad/m]."""
        rows, columns = self.heights.shape
        k_x = np.asarray(np.fft.fftfreq(rows, self.spacing[0]), dtype=np.float64)
        k_z = np.asarray(np.fft.rfftfreq(columns, self.spacing[1]), dtype=np.float64)
        return 2.0 * np.pi * k_x, 2.0 * np.pi * k_z

    def _require_periodic(self) -> None:
        if not self.periodic:
            raise InvalidInput("surface.periodic", "must be True; use surface.mirrored()", "False")


def _pair(name: str, value: object) -> tuple[object, object]:
    """Return a pair, given as such or as one value for both."""
    if isinstance(value, tuple):
        if len(value) != 2:
            raise InvalidInput(name, "must be one number or a tuple of two", shown(value))
        return value[0], value[1]
    return value, value


def _spacings(spacing: object) -> tuple[float, float]:
    along, across = _pair("spacing", spacing)
    return as_positive("spacing", along, "m"), as_positive("spacing", across, "m")


def _without_highest(k: NDArray[np.float64], nodes: int) -> NDArray[np.float64]:
    """Return wavenumbers with 0 in place of the highest one of an even number of nodes."""
    if nodes % 2 == 0:
        k = k.copy()
        k[nodes // 2] = 0.0
    return k


def _common_waves(given: int, wanted: int) -> tuple[slice, slice]:
    """Return the places of the waves that both numbers of nodes have, in spectra in ascending order."""
    half = (min(given, wanted) - 1) // 2
    middle_given, middle_wanted = given // 2, wanted // 2
    return slice(middle_given - half, middle_given + half + 1), slice(middle_wanted - half, middle_wanted + half + 1)
