"""The surface mesh."""

from __future__ import annotations

import math
from dataclasses import asdict, dataclass, fields

from .. import _core
from .._support.arguments import as_int
from .._support.tables import ParameterTable

__all__ = ["Mesh"]


@dataclass(frozen=True, slots=True, kw_only=True)
class Mesh(ParameterTable):
    """Surface mesh: nodes at equal spacings in φ and θ, with one node at the lowest point.

    Parameters
    ----------
    nodes_per_revolution : int
        2π/Δφ in [16, 1 000 000], where Δφ is the spacing along φ. A value of 500 is the paper's Δ = π/250.
    max_order : int, optional
        Truncation order N_t, as in the paper: the orders |m|, |n| ≤ N_t are summed. It must be at least half of the
        nodes per revolution, since fewer orders cannot resolve the mesh. By default all orders are summed, at a cost
        that hardly grows with the mesh.
    theta_nodes_per_revolution : int, optional
        2π/Δθ, where Δθ is the spacing along θ. By default the spacing is the same as along φ.

    Examples
    --------
    >>> Mesh(nodes_per_revolution=500).spacing
    0.012566370614359173
    """

    nodes_per_revolution: int
    max_order: int | None = None
    theta_nodes_per_revolution: int | None = None

    def __post_init__(self) -> None:
        """Store the numbers as Python integers and check them."""
        object.__setattr__(self, "nodes_per_revolution", as_int("nodes_per_revolution", self.nodes_per_revolution))
        for name in ("max_order", "theta_nodes_per_revolution"):
            value = getattr(self, name)
            object.__setattr__(self, name, None if value is None else as_int(name, value))
        self._to_core()

    @property
    def spacing(self) -> float:
        """Angle between neighboring nodes along φ, Δφ [rad]."""
        return 2.0 * math.pi / self.nodes_per_revolution

    @property
    def theta_spacing(self) -> float:
        """Angle between neighboring nodes along θ, Δθ [rad]."""
        return 2.0 * math.pi / (self.theta_nodes_per_revolution or self.nodes_per_revolution)

    def __str__(self) -> str:
        """Return a short description."""
        theta = self.theta_nodes_per_revolution
        nodes = f"{self.nodes_per_revolution}" + (f" (φ), {theta} (θ)" if theta else "")
        orders = "all orders" if self.max_order is None else f"orders to {self.max_order}"
        return f"{nodes} nodes per revolution, {orders}"

    def _to_core(self) -> _core.Mesh:
        return _core.Mesh(**asdict(self))

    @classmethod
    def _from_core(cls, mesh: _core.Mesh) -> Mesh:
        return cls(**{field.name: getattr(mesh, field.name) for field in fields(cls)})
