"""Surface of the rigid counterbody, and which surface nodes are in contact."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["RigidSurface"]


@dataclass(frozen=True, slots=True)
class RigidSurface:
    """Rigid plane, roller or drum below the cover; lengths are in units of the outer radius.

    Attributes
    ----------
    curvature : float
        Curvature: 0 for a plane, positive for a roller, negative for a drum around the cover, > -1.
    """

    curvature: float = 0.0

    def gap(
        self, x: NDArray[np.float64], penetration: float
    ) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]:
        """Return the gaps of points, the unit normals away from the counterbody, and the derivatives of the normals.

        Parameters
        ----------
        x : ndarray, shape (n, 2)
            Positions along the ground and upwards from the axis of the cover.
        penetration : float
            Distance by which the counterbody penetrates the undeformed cover.

        Returns
        -------
        gaps : ndarray, shape (n,)
        normals : ndarray, shape (n, 2)
        slopes : ndarray, shape (n, 2, 2)
        """
        height = x[:, 1] + 1.0 - penetration
        if self.curvature == 0.0:
            normal = np.broadcast_to([0.0, 1.0], x.shape)
            return height, normal, np.zeros((len(x), 2, 2))
        k = self.curvature
        # The vector 1 + k y, k x has the length k |x - center|; this form stays accurate for small curvatures.
        direction = np.stack([k * x[:, 0], 1.0 + k * height], axis=1)
        length = np.hypot(direction[:, 0], direction[:, 1])
        normal = direction / length[:, None]
        gaps = (k * x[:, 0] ** 2 + height * (2.0 + k * height)) / (length + 1.0)
        tangent = np.stack([normal[:, 1], -normal[:, 0]], axis=1)
        slopes = (k / length)[:, None, None] * tangent[:, :, None] * tangent[:, None, :]
        return gaps, normal, slopes
