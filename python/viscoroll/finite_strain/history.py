"""Memory of material that passes the same points in every revolution."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["memory_matrix"]


def memory_matrix(
    angles: NDArray[np.float64], moduli: NDArray[np.float64], lags: NDArray[np.float64]
) -> NDArray[np.float64]:
    """Return the matrix that maps a strain measure on a ring to the viscous stress Σ μ_i H_i.

    H_i(φ) = ∫ exp(-(φ - s)/l_i) dT(s) is integrated over all earlier angles, also those of earlier revolutions. The
    strain measure T is linear between neighboring points.

    Parameters
    ----------
    angles : ndarray, shape (n,)
        Angles of the points on the ring [rad], increasing, within one revolution.
    moduli : ndarray, shape (k,)
        Moduli μ_i of the terms.
    lags : ndarray, shape (k,)
        Angles l_i = Ω τ_i by which the material turns in the relaxation times [rad], > 0.

    Returns
    -------
    ndarray, shape (n, n)
        The matrix W: viscous stress = W T.

    Notes
    -----
    Over the step Δ from point j to j + 1, H becomes a H + b (T_{j+1} - T_j) with a = exp(-Δ/l) and b = (1 - a) l/Δ.
    Periodicity closes the recursion: the response to one step is divided by 1 - exp(-2π/l).
    """
    n = len(angles)
    matrix = np.zeros((n, n))
    # Column j of `responses` is H at all points after the increment from point j - 1 to point j.
    steps = np.diff(angles, prepend=angles[-1] - 2.0 * np.pi)
    distance = (angles[:, None] - angles[None, :]) % (2.0 * np.pi)
    np.fill_diagonal(distance, 0.0)
    for modulus, lag in zip(moduli, lags, strict=True):
        ratio = steps / lag
        gain = -np.expm1(-ratio) / ratio
        responses = modulus * gain * np.exp(-distance / lag) / -np.expm1(-2.0 * np.pi / lag)
        matrix += responses - np.roll(responses, -1, axis=1)
    return matrix
