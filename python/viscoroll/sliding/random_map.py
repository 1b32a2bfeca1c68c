"""Heights of random self-affine surfaces."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from .._support.errors import InvalidInput
from .._support.text import shown

__all__ = ["self_affine_heights"]


def self_affine_heights(
    nodes: int, side: float, *, hurst: float, rolloff: float, cutoff: float, seed: int
) -> NDArray[np.float64]:
    """Return heights of a square surface in arbitrary units; see `RoughSurface.self_affine`.

    Raises
    ------
    ValueError
        If a parameter is out of its range.
    """
    if not 0.0 <= hurst <= 1.0:
        raise InvalidInput("hurst", "must be in [0, 1]", f"{hurst:g}")
    if seed < 0:
        raise InvalidInput("seed", "must be >= 0", shown(seed))
    shortest = 2.0 * side / nodes
    if not cutoff >= shortest * (1.0 - 1e-12):
        raise InvalidInput("cutoff", f"must be >= {shortest:g} m, two spacings", f"{cutoff:g}")
    if not cutoff <= rolloff <= side * (1.0 + 1e-12):
        raise InvalidInput(
            "rolloff", f"must be in [{cutoff:g}, {side:g}] m, from the cutoff to the side", f"{rolloff:g}"
        )
    highest = int(np.floor(side / cutoff * (1.0 + 1e-12)))
    i, j = np.meshgrid(np.arange(-highest, highest + 1), np.arange(highest + 1), indexing="ij")
    q = np.hypot(i, j)
    # The highest wave of an even number of nodes has one phase only.
    used = (q > 0.0) & (q <= side / cutoff * (1.0 + 1e-12)) & ((j > 0) | (i > 0)) & (2 * np.maximum(abs(i), j) < nodes)
    falling = np.maximum(q / (side / rolloff), 1.0)
    amplitude = np.where(used, falling ** -(1.0 + hurst), 0.0)
    phase = 2.0 * np.pi * np.random.default_rng(seed).random(q.shape)
    waves = np.zeros((nodes, nodes), dtype=complex)
    waves[i[used] % nodes, j[used]] = (amplitude * np.exp(1j * phase))[used]
    return np.fft.fft2(waves).real
