"""Which harmonics lose the power of a result, and which of them a measured table does not hold."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from .._core import Curvature, Extrapolation
from .._support.arguments import Floats
from ..bodies import CoatedSphere, require_ball
from ..bodies.orders import surface_compliance
from ..materials import MasterCurve
from .solution import Solution

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["LossSpectrum", "extrapolated_loss", "loss_spectrum"]

#: Orders are taken one by one up to here, then at equal ratios.
_ONE_BY_ONE = 32
_RATIO = 1.05


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class LossSpectrum:
    """Power lost in the coating, by the harmonics of the rolling speed.

    Attributes
    ----------
    order : ndarray
        m [-], all up to 32 and some of the rest, each for those around it.
    frequency : ndarray
        mΩ [rad/s].
    power : ndarray
        Lost by the orders around each [W]; their sum is the power lost in the coating, but for the sampling.
    """

    order: Floats
    frequency: Floats
    power: Floats

    def share_outside(self, lowest: float, highest: float) -> float:
        """Return the share of the power that is lost below or above two frequencies [rad/s]."""
        outside = (self.frequency < lowest) | (self.frequency > highest)
        return float(self.power[outside].sum() / self.power.sum())


def loss_spectrum(result: Solution) -> LossSpectrum:
    """Split the power lost in a coating by harmonics.

    P_bulk = -Ω (2π r_o)² Σ_mn m Im(σ̄ᵀ C σ) with the orders σ_mn of the tractions and the compliance C of a torus
    (`docs/theory.md`, section 5); on the exact sphere, too.

    Parameters
    ----------
    result : Result
        Of a coated sphere.

    Returns
    -------
    LossSpectrum
        Power by order.

    Raises
    ------
    TypeError
        For a result of another body.
    """
    require_ball("result.ball", result.ball, "the loss by frequency")
    if result.on is not None:
        raise ValueError(
            f"result.on must be None, a rigid plane, for a spectrum of the coating's loss, got {result.on!r}"
        )
    assert isinstance(result.ball, CoatedSphere)
    m, m_width = _sampled(result.mesh.nodes_per_revolution)
    n, n_width = _sampled(result.mesh.theta_nodes_per_revolution or result.mesh.nodes_per_revolution)
    n, n_width = np.concatenate([[0], n]), np.concatenate([[1.0], 2.0 * n_width])  # -n does as n
    curvature = Curvature.PAPER if result.curvature is Curvature.PAPER else Curvature.SPHERE
    compliance = surface_compliance(result.ball, result.angular_speed, m[:, None], n[None, :], curvature=curvature)
    traction = _orders(result, m, n)
    work = np.einsum("pmn,mnpq,qmn->mn", traction.conj(), compliance, traction).imag
    scale = result.angular_speed * (2.0 * np.pi * result.ball.outer_radius) ** 2
    # Orders m and -m do the same: twice those above 0.
    power = -2.0 * scale * m * m_width * (work @ n_width)
    orders = m.astype(np.float64)
    return LossSpectrum(order=orders, frequency=orders * result.angular_speed, power=power)


def extrapolated_loss(result: Solution) -> float | None:
    """Return the share of the power lost in the coating at harmonics that a measured table does not hold.

    Returns
    -------
    float or None
        [-], where the outermost entries of a `MasterCurve` were held; None without such a material, and where two
        bodies deform, of whose losses there is no spectrum.
    """
    body: object = result.ball if result.on is None else None
    tables = [
        layer.shear_modulus
        for layer in (body.layers if isinstance(body, CoatedSphere) else ())
        if isinstance(layer.shear_modulus, MasterCurve) and layer.shear_modulus.extrapolation is Extrapolation.HOLD
    ]
    if not tables:
        return None
    ends = [[w for w in table.frequency if w > 0.0] for table in tables]
    return loss_spectrum(result).share_outside(max(e[0] for e in ends), min(e[-1] for e in ends))


def _sampled(nodes: int) -> tuple[NDArray[np.int64], Floats]:
    """Return orders from 1 up to the nodes per revolution, and how many each stands for."""
    last = max(nodes, 2)
    count = 1 + int(np.log(max(last / _ONE_BY_ONE, 1.0)) / np.log(_RATIO))
    beyond = np.geomspace(_ONE_BY_ONE, last, count) if last > _ONE_BY_ONE else np.array([float(last)])
    orders = np.unique(np.concatenate([np.arange(1, min(_ONE_BY_ONE, last) + 1), beyond.round().astype(np.int64)]))
    edges = np.concatenate([[0.5], 0.5 * (orders[:-1] + orders[1:]), [orders[-1] + 0.5]])
    return orders, np.diff(edges)


def _orders(result: Solution, m: NDArray[np.int64], n: NDArray[np.int64]) -> NDArray[np.complex128]:
    """Return the tractions along r, φ and θ by orders, shape (3, m, n) [Pa]."""
    # φ and θ grow against x and z at the lowest point.
    fields = np.stack([-result.pressure, -result.shear_traction[0], -result.shear_traction[1]])
    spacings = (result.mesh.spacing, result.mesh.theta_spacing)
    phi, theta = (step * (np.arange(k) - k // 2) for step, k in zip(spacings, result.pressure.shape, strict=True))
    waves_m = np.exp(-1j * m[:, None] * phi) * np.sinc(m * spacings[0] / (2.0 * np.pi))[:, None]
    waves_n = np.exp(-1j * n[:, None] * theta) * np.sinc(n * spacings[1] / (2.0 * np.pi))[:, None]
    area = spacings[0] * spacings[1] / (2.0 * np.pi) ** 2
    return np.asarray(area * np.einsum("mi,pij,nj->pmn", waves_m, fields, waves_n, optimize=True))
