"""Power dissipated in a body at each harmonic, and its fraction at frequencies outside the measured tables."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from .._core import Curvature
from .._support.arguments import Floats
from .._support.errors import InvalidInput
from ..materials.modulus_like import measured_range_of
from .inside import Inside, Of, inside_of
from .interior_fields import order_fields
from .solution import Solution

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["LossSpectrum", "extrapolated_loss", "loss_spectrum"]

#: All orders up to `_ONE_BY_ONE` are evaluated; higher orders are sampled at the ratio `_RATIO`.
_ONE_BY_ONE = 32
_RATIO = 1.05


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class LossSpectrum:
    """Power dissipated in one body at each harmonic of its angular speed.

    Attributes
    ----------
    order : ndarray
        Orders m [-]: all up to 32, and a sample of the higher ones, each of which represents the orders around it.
    frequency : ndarray
        Frequencies mΩ [rad/s], with the angular speed Ω of the body. In a plane, m divided by the radius of the rolling
        body is the wavenumber, and Ω is that of the rolling body.
    power : ndarray
        Power dissipated by the orders that each sampled order represents [W], in line contact [W/m]. Except for the
        error of sampling, the sum is the power dissipated in the body.
    """

    order: Floats
    frequency: Floats
    power: Floats

    def share_outside(self, lowest: float, highest: float) -> float:
        """Return the fraction of the power that is dissipated outside a range of frequencies [rad/s]."""
        outside = (self.frequency < lowest) | (self.frequency > highest)
        return float(self.power[outside].sum() / self.power.sum())


def loss_spectrum(result: Solution, *, of: Of | None = None) -> LossSpectrum:
    """Return the power dissipated in a body at each harmonic.

    P_bulk = -Ω A Σ_mn m Im(σ̄ᵀ C σ) with the orders σ_mn of the tractions, the compliance C of the surface, and the
    area A of one period: (2π r_o)² for a torus, 2π r_o per length for a roller (`docs/theory/normal-contact.md`,
    `rollers.md`). With curvature EXACT, C is that of SPHERE; for a wheel, C is that of a tread without side faces or
    crown.

    Parameters
    ----------
    result : Result
        Solution of a contact.
    of : "body" or "counterbody", optional
        Rolling body or counterbody. By default the deformable body; if both deform, the rolling body.

    Returns
    -------
    LossSpectrum
        Power by order.

    Raises
    ------
    ValueError
        If the body is rigid, or the fields are wider than its circumference, which integer orders cannot represent.
    """
    inside = inside_of(result, of)
    width = np.ptp(result.z[0]) / inside.radius
    if width > 2.0 * np.pi:
        raise InvalidInput(
            "result", "must have fields narrower than the circumference", f"{width / (2.0 * np.pi):.3g} circumferences"
        )
    m, m_width = _sampled(round(2.0 * np.pi / inside.node_spacings()[0]))
    n, n_width = np.zeros(1, np.int64), np.ones(1)
    if not inside.line_contact:
        n, n_width = _sampled(round(2.0 * np.pi / inside.node_spacings()[1]))
        n, n_width = np.concatenate([[0], n]), np.concatenate([[1.0], 2.0 * n_width])  # n and -n dissipate the same
    compliance = _compliance(inside, m, n)
    traction = _orders(inside, m, n)
    work = np.einsum("pmn,mnpq,qmn->mn", traction.conj(), compliance, traction).imag
    circumference = 2.0 * np.pi * inside.radius
    area = circumference if inside.line_contact else circumference**2
    # Orders m and -m dissipate the same power: count those above 0 twice.
    power = -2.0 * inside.passing_speed * area * m * m_width * (work @ n_width)
    orders = m.astype(np.float64)
    return LossSpectrum(order=orders, frequency=orders * inside.passing_speed, power=power)


def extrapolated_loss(result: Solution) -> float | None:
    """Return the fraction of the power that is dissipated at harmonics outside the measured tables of the layers.

    Returns
    -------
    float or None
        Fraction [-] for layers with a `MasterCurve` that holds its end values outside its range. None without such a
        layer, and with a counterbody `on`.
    """
    if result.on is not None:
        return None
    measured = measured_range_of((layer.shear_modulus for layer in result.body.layers), held=True)
    return None if measured is None else loss_spectrum(result).share_outside(*measured)


def _compliance(inside: Inside, m: NDArray[np.int64], n: NDArray[np.int64]) -> NDArray[np.complex128]:
    """Return the compliance of the surface at all orders [m/Pa], of shape (orders m, orders n, 3, 3)."""
    grid = [orders.ravel() for orders in np.meshgrid(m, n, indexing="ij")]
    displacement = order_fields(
        inside.body,
        inside.result.angular_speed * inside.result.body.outer_radius / inside.radius,
        *grid,
        depth=[0.0],
        rolling_radius=inside.radius if inside.body.is_flat else None,
        curvature=Curvature.PAPER if inside.result.curvature is Curvature.PAPER else Curvature.SPHERE,
    )[0]
    return displacement.reshape(m.size, n.size, 3, 3)


def _sampled(nodes: int) -> tuple[NDArray[np.int64], Floats]:
    """Return sampled orders from 1 to the number of nodes per revolution, and how many orders each represents."""
    last = max(nodes, 2)
    count = 1 + int(np.log(max(last / _ONE_BY_ONE, 1.0)) / np.log(_RATIO))
    beyond = np.geomspace(_ONE_BY_ONE, last, count) if last > _ONE_BY_ONE else np.array([float(last)])
    orders = np.unique(np.concatenate([np.arange(1, min(_ONE_BY_ONE, last) + 1), beyond.round().astype(np.int64)]))
    edges = np.concatenate([[0.5], 0.5 * (orders[:-1] + orders[1:]), [orders[-1] + 0.5]])
    return orders, np.diff(edges)


def _orders(inside: Inside, m: NDArray[np.int64], n: NDArray[np.int64]) -> NDArray[np.complex128]:
    """Return the orders of the tractions along r, φ and θ [Pa], of shape (3, orders m, orders n)."""
    result = inside.result
    # φ and θ increase in the directions -x and -z at the lowest point.
    sense = 1.0 if inside.of == "counterbody" else -1.0
    fields = np.stack([-result.pressure, sense * result.shear_traction[0], sense * result.shear_traction[1]])
    angles = [a - 0.5 * np.pi for a in inside.node_angles()]
    waves = [
        np.exp(-1j * orders[:, None] * places) * np.sinc(orders * step / (2.0 * np.pi))[:, None] * step / (2.0 * np.pi)
        for orders, places, step in zip((m, n), angles, inside.node_spacings(), strict=True)
    ]
    if inside.line_contact:
        waves[1] = np.ones((1, 1))
    return np.asarray(np.einsum("mi,pij,nj->pmn", waves[0], fields, waves[1], optimize=True))
