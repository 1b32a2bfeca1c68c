"""Which harmonics lose the power of a body, and which of them a measured table does not hold."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from .._core import Curvature, Extrapolation
from .._support.arguments import Floats
from ..bodies import CoatedPlane
from ..materials import MasterCurve
from .inside import Inside, Of, inside_of
from .interior_fields import order_fields
from .solution import Solution

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["LossSpectrum", "extrapolated_loss", "loss_spectrum"]

#: Orders are taken one by one up to here, then at equal ratios.
_ONE_BY_ONE = 32
_RATIO = 1.05


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class LossSpectrum:
    """Power lost in one body, by the harmonics of the rolling speed.

    Attributes
    ----------
    order : ndarray
        m [-], all up to 32 and some of the rest, each for those around it.
    frequency : ndarray
        mΩ [rad/s], Ω of a counterpart its own; of a plane, where m is a wave number per radius of what rolls, of that.
    power : ndarray
        Lost by the orders around each [W], under a line [W/m]; their sum is the power lost in the body, but for the
        sampling.
    """

    order: Floats
    frequency: Floats
    power: Floats

    def share_outside(self, lowest: float, highest: float) -> float:
        """Return the share of the power that is lost below or above two frequencies [rad/s]."""
        outside = (self.frequency < lowest) | (self.frequency > highest)
        return float(self.power[outside].sum() / self.power.sum())


def loss_spectrum(result: Solution, *, of: Of | None = None) -> LossSpectrum:
    """Split the power lost in a body by harmonics.

    P_bulk = -Ω A Σ_mn m Im(σ̄ᵀ C σ) with the orders σ_mn of the tractions, the compliance C of the surface and its area
    of waves A: (2π r_o)² of a torus, 2π r_o of a roller, per length (`docs/theory/normal-contact.md`,
    `rollers.md`); on the exact sphere, too. C is that of a wheel without sides or crown.

    Parameters
    ----------
    result : Result
        A solution.
    of : "ball" or "counterpart", optional
        What rolls, or what it rolls on; by default the one that deforms, of two what rolls.

    Returns
    -------
    LossSpectrum
        Power by order.

    Raises
    ------
    ValueError
        For a body that is rigid, and for a contact wider than the circumference, which whole orders cannot tell.
    """
    inside = inside_of(result, of)
    width = np.ptp(result.z[0]) / inside.radius
    if width > 2.0 * np.pi:
        raise ValueError(f"result must be narrower than its circumference, got {width / (2.0 * np.pi):.3g} of it")
    m, m_width = _sampled(round(2.0 * np.pi / inside.node_spacings()[0]))
    n, n_width = np.zeros(1, np.int64), np.ones(1)
    if not inside.line_contact:
        n, n_width = _sampled(round(2.0 * np.pi / inside.node_spacings()[1]))
        n, n_width = np.concatenate([[0], n]), np.concatenate([[1.0], 2.0 * n_width])  # -n does as n
    compliance = _compliance(inside, m, n)
    traction = _orders(inside, m, n)
    work = np.einsum("pmn,mnpq,qmn->mn", traction.conj(), compliance, traction).imag
    waves = 2.0 * np.pi * inside.radius
    area = waves if inside.line_contact else waves**2
    # Orders m and -m do the same: twice those above 0.
    power = -2.0 * inside.passes * area * m * m_width * (work @ n_width)
    orders = m.astype(np.float64)
    return LossSpectrum(order=orders, frequency=orders * inside.passes, power=power)


def extrapolated_loss(result: Solution) -> float | None:
    """Return the share of the power lost in the coating at harmonics that a measured table does not hold.

    Returns
    -------
    float or None
        [-], where the outermost entries of a `MasterCurve` were held; None without such a material, and where two
        bodies deform, of whose losses there is no spectrum.
    """
    if result.on is not None:
        return None
    tables = [
        layer.shear_modulus
        for layer in result.ball.layers
        if isinstance(layer.shear_modulus, MasterCurve) and layer.shear_modulus.extrapolation is Extrapolation.HOLD
    ]
    if not tables:
        return None
    ends = [[w for w in table.frequency if w > 0.0] for table in tables]
    return loss_spectrum(result).share_outside(max(e[0] for e in ends), min(e[-1] for e in ends))


def _compliance(inside: Inside, m: NDArray[np.int64], n: NDArray[np.int64]) -> NDArray[np.complex128]:
    """Return that of the surface at all orders, shape (m, n, 3, 3) [m/Pa]."""
    grid = [orders.ravel() for orders in np.meshgrid(m, n, indexing="ij")]
    displacement = order_fields(
        inside.body,
        inside.result.angular_speed * inside.result.ball.outer_radius / inside.radius,
        *grid,
        depth=[0.0],
        rolling_radius=inside.radius if isinstance(inside.body, CoatedPlane) else None,
        curvature=Curvature.PAPER if inside.result.curvature is Curvature.PAPER else Curvature.SPHERE,
    )[0]
    return displacement.reshape(m.size, n.size, 3, 3)


def _sampled(nodes: int) -> tuple[NDArray[np.int64], Floats]:
    """Return orders from 1 up to the nodes per revolution, and how many each stands for."""
    last = max(nodes, 2)
    count = 1 + int(np.log(max(last / _ONE_BY_ONE, 1.0)) / np.log(_RATIO))
    beyond = np.geomspace(_ONE_BY_ONE, last, count) if last > _ONE_BY_ONE else np.array([float(last)])
    orders = np.unique(np.concatenate([np.arange(1, min(_ONE_BY_ONE, last) + 1), beyond.round().astype(np.int64)]))
    edges = np.concatenate([[0.5], 0.5 * (orders[:-1] + orders[1:]), [orders[-1] + 0.5]])
    return orders, np.diff(edges)


def _orders(inside: Inside, m: NDArray[np.int64], n: NDArray[np.int64]) -> NDArray[np.complex128]:
    """Return the tractions along r, φ and θ by orders, shape (3, m, n) [Pa]."""
    result = inside.result
    # φ and θ grow against x and z at the lowest point.
    sense = 1.0 if inside.of == "counterpart" else -1.0
    fields = np.stack([-result.pressure, sense * result.shear_traction[0], sense * result.shear_traction[1]])
    angles = [a - 0.5 * np.pi for a in inside.node_angles()]
    waves = [
        np.exp(-1j * orders[:, None] * places) * np.sinc(orders * step / (2.0 * np.pi))[:, None] * step / (2.0 * np.pi)
        for orders, places, step in zip((m, n), angles, inside.node_spacings(), strict=True)
    ]
    if inside.line_contact:
        waves[1] = np.ones((1, 1))
    return np.asarray(np.einsum("mi,pij,nj->pmn", waves[0], fields, waves[1], optimize=True))
