"""Energy lost inside the coating, where and in which of the material's mechanisms."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .. import _core
from .._support.arguments import as_int
from .._support.extras import extra
from .._support.progress import ProgressLike, reporting
from ..materials import Prony, StandardLinearSolid
from .interior_fields import coated_ball, places_of, tractions_of
from .solution import Solution

if TYPE_CHECKING:
    import xarray
    from numpy.typing import ArrayLike, NDArray

    from ..materials import ShearModulusLike

__all__ = ["contact_size", "default_max_order", "loss_of"]

#: Orders, per r_o over the contact's semi-axis, that hold 0.9999 of the loss; near the surface w is right to 1e-3.
_ORDERS_PER_CONTACT = 40.0

#: What the volume integral may differ from the power put in, relatively: the error of its radial nodes.
_BALANCE = 1e-7


def contact_size(result: Solution) -> float:
    """Return the smaller semi-axis of the contact of a ball, or a spacing of the mesh where it has none [m]."""
    return min(result.semi_axis_x or 0.0, result.semi_axis_z or 0.0) or result.ball.outer_radius * result.mesh.spacing


def default_max_order(result: Solution, orders_per_contact: float = _ORDERS_PER_CONTACT) -> int:
    """Return the orders that the loss is summed up to: those that matter, of those that the mesh has."""
    wanted = int(np.ceil(orders_per_contact * result.ball.outer_radius / contact_size(result)))
    most = result.mesh.max_order or 10 * result.mesh.nodes_per_revolution
    return max(8, min(wanted, most, 20000))


def loss_of(
    result: Solution,
    *,
    depth: ArrayLike | None = None,
    max_order: int | None = None,
    threads: int = 0,
    progress: ProgressLike = None,
) -> xarray.Dataset:
    """Energy lost inside the coating; see `Result.loss`."""
    with extra("files"):
        import xarray

    ball = coated_ball(result)
    radii, layers = (np.empty(0), np.empty(0, np.int32)) if depth is None else places_of(ball, depth, None)
    order = default_max_order(result) if max_order is None else as_int("max_order", max_order)
    with reporting(progress) as report:
        loss = _core.loss_density(
            ball._to_core(),
            tractions_of(result),
            radius=radii,
            layer=layers,
            angular_speed=result.angular_speed,
            max_order=order,
            threads=as_int("threads", threads),
            progress=report,
        )
    balance = abs(loss.volume_power - loss.surface_power)
    if balance > _BALANCE * max(loss.surface_power, 1e-6 * abs(result.rolling_bulk_power)):
        raise _core.ConvergenceError(
            f"the loss in the volume, {loss.volume_power:.12g} W, is not the power of the tractions, "
            f"{loss.surface_power:.12g} W"
        )
    radii, layers = loss.places
    # The half of the torus that the sphere has; order (0, 0) to the last go once around.
    shown = slice(len(loss.theta) // 4, 3 * len(loss.theta) // 4 + 1)
    density = np.maximum(loss.density[:, shown], 0.0)
    order_power = loss.order_power.reshape(len(ball.layers), order + 1)
    shares = [_term_shares(layer.shear_modulus, result.angular_speed, order) for layer in ball.layers]
    terms = max(len(share) for share in shares)
    relaxation_power = np.full((len(ball.layers), terms), np.nan)
    for power, share, row in zip(order_power, shares, relaxation_power, strict=True):
        row[: len(share)] = share @ power
    return xarray.Dataset(
        {
            "loss_density": (
                ("radius", "theta"),
                density,
                {"units": "J m-3", "long_name": "energy lost per volume and revolution"},
            ),
            "power_density": (
                ("radius", "theta"),
                density * result.angular_speed / (2.0 * np.pi),
                {"units": "W m-3", "long_name": "power lost per volume, mean over a revolution"},
            ),
            "layer_power": ("layer", order_power.sum(axis=1), {"units": "W", "long_name": "power lost in each layer"}),
            "relaxation_power": (
                ("layer", "term"),
                relaxation_power,
                {"units": "W", "long_name": "power lost in each relaxation time of a Prony series"},
            ),
        },
        {
            "radius": ("radius", radii, {"units": "m"}),
            "depth": ("radius", ball.outer_radius - radii, {"units": "m"}),
            "place_layer": ("radius", layers, {"long_name": "number of the layer, from the center outwards"}),
            "theta": ("theta", loss.theta[shown], {"units": "rad"}),
        },
        attrs={
            "power": loss.volume_power,
            "surface_power": loss.surface_power,
            "bulk_power": result.rolling_bulk_power,
            "max_order": order,
            "angular_speed": result.angular_speed,
            "load": result.load,
            "compliance": result.compliance.name,
            "curvature": result.curvature.name,
        },
    )


def _term_shares(modulus: ShearModulusLike, angular_speed: float, max_order: int) -> NDArray[np.float64]:
    """Share of each relaxation time in the loss modulus at every order, a row for each; none without a series."""
    match modulus:
        case StandardLinearSolid():
            times, weights = np.array([modulus.relaxation_time]), np.ones(1)
        case Prony():
            times, weights = np.asarray(modulus.relaxation_times), np.asarray(modulus.weights)
        case _:
            return np.empty((0, max_order + 1))
    products = angular_speed * np.arange(max_order + 1) * times[:, None]
    loss = weights[:, None] * products / (1.0 + products**2)
    total = loss.sum(axis=0)
    shares: NDArray[np.float64] = np.divide(loss, total, out=np.zeros_like(loss), where=total > 0.0)
    return shares
