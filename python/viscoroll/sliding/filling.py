"""Heights at nodes that an instrument did not measure."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from .._support.errors import InvalidInput

__all__ = ["filled"]

#: Residual of the equations of the undefined nodes, relative to that of the first guess.
_TOLERANCE = 1e-10


def filled(heights: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return heights in which each undefined node has the mean height of its four neighbors (a harmonic surface).

    Parameters
    ----------
    heights : ndarray, shape (nodes along x, nodes along z)
        Heights; undefined ones are NaN or infinite. Neighbors beyond the edge are left out.

    Raises
    ------
    ValueError
        If all heights are undefined.
    """
    undefined = ~np.isfinite(heights)
    if not undefined.any():
        return heights
    if undefined.all():
        raise InvalidInput("heights", "must have at least one defined node", "none")
    numbers = np.full(heights.shape, -1)
    numbers[undefined] = np.arange(np.count_nonzero(undefined))
    pairs, right = [], np.zeros(np.count_nonzero(undefined))
    neighbors = np.zeros(right.size)
    known = np.where(undefined, 0.0, heights)
    for axis in (0, 1):
        for first, second in ((slice(None, -1), slice(1, None)), (slice(1, None), slice(None, -1))):
            here, there = (tuple(cut if i == axis else slice(None) for i in (0, 1)) for cut in (first, second))
            inside = undefined[here]
            number, other = numbers[here][inside], numbers[there][inside]
            np.add.at(neighbors, number, 1.0)
            np.add.at(right, number, known[there][inside])
            pairs.append((number[other >= 0], other[other >= 0]))
    rows, columns = (np.concatenate(parts) for parts in zip(*pairs, strict=True))

    def product(values: NDArray[np.float64]) -> NDArray[np.float64]:
        return neighbors * values - np.bincount(rows, values[columns], minlength=values.size)

    solved = heights.copy()
    solved[undefined] = _conjugate_gradients(product, right, float(heights[~undefined].mean()))
    return solved


def _conjugate_gradients(
    product: Callable[[NDArray[np.float64]], NDArray[np.float64]], right: NDArray[np.float64], start: float
) -> NDArray[np.float64]:
    """Solve a symmetric positive definite system from a constant start."""
    solution = np.full(right.size, start)
    residual = right - product(solution)
    direction, square = residual.copy(), float(residual @ residual)
    limit = _TOLERANCE**2 * square
    for _ in range(right.size):
        if square <= limit:
            break
        image = product(direction)
        step = square / float(direction @ image)
        solution += step * direction
        residual -= step * image
        before, square = square, float(residual @ residual)
        direction = residual + square / before * direction
    return solution
