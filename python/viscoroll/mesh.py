"""The surface mesh."""

from __future__ import annotations

import math
from dataclasses import dataclass

from . import _core
from ._arrays import as_int

__all__ = ["Mesh"]


@dataclass(frozen=True, slots=True, kw_only=True)
class Mesh:
    """Surface mesh: nodes at equal spacings in φ and θ, one of them at the lowest point.

    Parameters
    ----------
    nodes_per_revolution : int
        2π/Δ, with Δ the spacing; at least 16. 500 is the paper's Δ = π/250.
    max_order : int
        Truncation order N_t: the orders |m|, |n| ≤ N_t are summed; at least half of `nodes_per_revolution`, below which
        they cannot resolve the mesh. Odd multiples of that half converge best, since errors of aliases then cancel.

    Examples
    --------
    >>> Mesh(nodes_per_revolution=500, max_order=750).spacing
    0.012566370614359173
    """

    nodes_per_revolution: int
    max_order: int

    def __post_init__(self) -> None:
        """Store the numbers as integers of Python and check them."""
        for name in ("nodes_per_revolution", "max_order"):
            object.__setattr__(self, name, as_int(name, getattr(self, name)))
        self._to_core()

    @property
    def spacing(self) -> float:
        """Angle between neighboring nodes Δ [rad]."""
        return 2.0 * math.pi / self.nodes_per_revolution

    def _to_core(self) -> _core.Mesh:
        return _core.Mesh(nodes_per_revolution=self.nodes_per_revolution, max_order=self.max_order)
