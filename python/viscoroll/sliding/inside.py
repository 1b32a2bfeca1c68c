"""Layers under a sliding rough surface, and their input for the core."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from .. import _core
from ..solution.inside import LayersInside
from .solution import SlidingSolution

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["LayersBelow", "layers_below"]


@dataclass(frozen=True, slots=True, kw_only=True)
class LayersBelow(LayersInside):
    """Layers under a rough surface that slides."""

    result: SlidingSolution

    @property
    def line_contact(self) -> bool:
        """Whether powers are per length (profile)."""
        return self.result.surface.is_profile

    @property
    def bulk_power(self) -> float:
        """Power dissipated in the layers under the whole surface [W], under a profile [W/m]."""
        along, across = self.result.surface.sides
        return self.result.power_density * along * (1.0 if self.line_contact else across)

    def tractions(self) -> _core.SlidingTractions:
        """Return the tractions on the layers as an object of the core."""
        surface = self.result.surface
        return _core.SlidingTractions(
            pressure=np.ascontiguousarray(self.result.pressure),
            spacing_x=surface.spacing[0],
            spacing_z=surface.spacing[1],
            periodic=surface.periodic,
            friction=self.result.friction,
        )

    def nodes(self) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Return x and z of the nodes [m]."""
        x, z = (
            step * np.arange(count)
            for step, count in zip(self.result.surface.spacing, self.result.pressure.shape, strict=True)
        )
        return x, z

    def attributes(self) -> dict[str, float | str]:
        """Return the input of the solution as attributes of datasets."""
        result = self.result
        return {"mean_pressure": result.mean_pressure, "speed": result.speed, "friction": result.friction}


def layers_below(result: SlidingSolution) -> LayersBelow:
    """Return the layers under a rough surface."""
    return LayersBelow(body=result.on, result=result)
