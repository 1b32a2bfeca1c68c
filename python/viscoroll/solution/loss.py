"""Energy dissipated inside the layers, by position and by relaxation time of the material."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from .. import _core
from .._support.arguments import as_int
from .._support.extras import extra
from .._support.progress import ProgressLike, reporting
from ..materials.modulus_like import relaxation_of
from .inside import Of, inside_of
from .interior_fields import place_coordinates
from .solution import Solution, described, given_of

if TYPE_CHECKING:
    import xarray
    from numpy.typing import ArrayLike, NDArray

    from ..bodies import HalfSpace, Layer
    from ..materials.modulus_like import ShearModulusLike

__all__ = ["ROUND_OFF", "contact_size", "default_max_order", "layer_powers", "loss", "require_balance"]

#: Highest order of the sums in units of r_o/a, where a is the smaller semi-axis of the contact. The sums then contain
#: 0.9999 of the loss, and the relative error of the density w is 1e-3.
_ORDERS_PER_CONTACT = 40.0

#: Largest relative difference between the volume integral and the power of the tractions: the quadrature error over r.
_BALANCE = 1e-7

#: Power below which a loss is round-off, such as that of an elastic body: fraction of the largest power that the load
#: could dissipate.
ROUND_OFF = 1e-10


def contact_size(result: Solution) -> float:
    """Return the smaller semi-axis of the contact, or a node spacing if that is zero [m]."""
    along = result.semi_axis_x or 0.0
    across = along if result.body.line_contact else result.semi_axis_z or 0.0
    return min(along, across) or result.body.outer_radius * result.mesh.spacing


def default_max_order(result: Solution, orders_per_contact: float = _ORDERS_PER_CONTACT) -> int:
    """Return the highest order of the loss sums: the highest relevant one, or that of the mesh if it is lower."""
    wanted = int(np.ceil(orders_per_contact * result.body.outer_radius / contact_size(result)))
    most = result.mesh.max_order or 10 * result.mesh.nodes_per_revolution
    return max(8, min(wanted, most, 20000))


def loss(
    result: Solution,
    *,
    depth: ArrayLike | None = None,
    of: Of | None = None,
    max_order: int | None = None,
    threads: int = 0,
    progress: ProgressLike = None,
) -> xarray.Dataset:
    """Return the energy dissipated inside the layers of one body, per volume and passage of the contact.

    Parameters
    ----------
    depth : array_like, optional
        Depths of the densities [m]; by default the nodes of the volume integral.
    of : "body" or "counterbody", optional
        Rolling body or counterbody. By default the deformable body; if both deform, the rolling body.
    max_order : int, optional
        Highest order |m|, |n| of the sums. By default that of the mesh or 40 r_o/a, whichever is lower, with the
        contact's semi-axis a. The sums then contain 0.9999 of the loss, or 0.998 on coarse meshes.
    threads : int, default 0
        Number of threads; 0 for all cores.
    progress : bool or callable, optional
        True shows a progress bar; a callable is called as progress(stage, fraction) about every 20 ms.

    Returns
    -------
    xarray.Dataset
        `loss_density` w [J/m³ per revolution, in a plane per pass] over (depth, theta); except in a plane,
        `power_density` Ωw/2π [W/m³], its mean over a revolution; `layer_power` [W] by `layer`; and `relaxation_power`
        [W] by `layer` and `term` for layers with a Prony series. Attributes: `power`, the volume integral [W],
        `surface_power`, the power of the tractions in the same orders, and `bulk_power`, the power in all orders; all
        are those of this body. In line contact, powers are per length [W/m].

    Raises
    ------
    TypeError, ValueError
        If an argument is invalid; also with curvature EXACT.
    ImportError
        If the extra `viscoroll[files]` is missing.
    ConvergenceError
        If the volume integral differs from the power of the tractions in the same orders by more than a relative 1e-7.

    Warns
    -----
    ResultWarning
        If the contact of a wheel with free sides is nearer to a face than the thickness of the tread.

    Notes
    -----
    The volume element of the model is r² dr dθ dφ, without sin θ, or r r_o dr dθ dφ in a wheel. Across the path, a
    plane or a wheel is modeled with parallel tracks at a distance of one circumference of the rolling body, or several
    under wide wheels. The loss of a wheel with free sides is that of a tread that continues beyond its faces, under the
    same tractions. `power` is therefore less than `bulk_power` if the contact is near the faces; with a crown, about
    0.1 h/R_c of it is missing.

    Examples
    --------
    >>> from viscoroll import Mesh, paper, solve
    >>> r = solve(paper.ball(), load=100.0, angular_speed=2.5, mesh=Mesh(nodes_per_revolution=400))
    >>> loss = r.loss(depth=[0.5e-3])
    >>> print(f"{loss.attrs['power'] / r.bulk_power:.3f} {loss.power_density.max().item() / 1e3:.0f} kW/m³")
    0.998 50 kW/m³
    """
    with extra("files"):
        import xarray

    inside = inside_of(result, of)
    positions, layers = (np.empty(0), np.empty(0, np.int32)) if depth is None else inside.places(depth)
    order = default_max_order(result) if max_order is None else as_int("max_order", max_order)
    with reporting(progress) as report:
        lost = _core.loss_density(
            inside.body._to_core(),
            inside.tractions(),
            position=positions,
            layer=layers,
            angular_speed=result.angular_speed,
            max_order=order,
            threads=as_int("threads", threads),
            progress=report,
        )
    round_off = ROUND_OFF * result.load * abs(result.angular_speed) * (result.semi_axis_x or 0.0)
    require_balance(lost.volume_power, lost.surface_power, max(1e-6 * abs(inside.bulk_power), round_off))
    inside.warn_of_sides()
    positions, layers = lost.places
    # θ covers a whole torus. A sphere is half of it; on other bodies, the tractions lie within this half.
    shown = slice(len(lost.theta) // 4, 3 * len(lost.theta) // 4 + 1)
    density = np.maximum(lost.density[:, shown], 0.0)
    # The material of a counterbody passes at the speed of the center, which differs by the creepage from the speed Ω
    # r_o of the solve.
    solved_speed = result.angular_speed * result.body.outer_radius / inside.radius
    order_power = lost.order_power.reshape(len(inside.layers), -1) * (inside.passing_speed / solved_speed)
    where = ("depth", "theta")
    densities = {"loss_density": (where, density, described("J m-3", "energy dissipated per volume and passage"))}
    if inside.has_radius:
        mean = described("W m-3", "power dissipated per volume, mean over a revolution")
        densities["power_density"] = (where, density * inside.passing_speed / (2.0 * np.pi), mean)
    coordinates = {
        **place_coordinates(inside, positions),
        "place_layer": (
            "depth",
            layers,
            {"long_name": "number of the layer, from the center or the base outwards"},
        ),
        "theta": ("theta", lost.theta[shown], {"units": "rad"}),
        "z": ("theta", inside.radius * (0.5 * np.pi - lost.theta[shown]), {"units": "m"}),
    }
    attributes = given_of(result) | {
        "of": inside.of,
        "power": float(order_power.sum()),
        "surface_power": lost.surface_power * inside.passing_speed / solved_speed,
        "bulk_power": inside.bulk_power,
        "max_order": order,
    }
    powers = layer_powers(inside.layers, solved_speed * lost.orders, order_power, inside.line_contact)
    return xarray.Dataset(densities | powers, coordinates, attrs=attributes)


def require_balance(volume: float, surface: float, round_off: float) -> None:
    """Check that the power dissipated in the volume is that of the tractions.

    Raises
    ------
    ConvergenceError
        If they differ by more than a relative 1e-7, or the given round-off times 1e-7.
    """
    if abs(volume - surface) > _BALANCE * max(surface, round_off):
        raise _core.ConvergenceError(
            f"the power dissipated in the volume, {volume:.12g} W, differs from the power of the tractions, "
            f"{surface:.12g} W"
        )


def layer_powers(
    layers: Sequence[Layer | HalfSpace], frequency: NDArray[np.float64], power: NDArray[np.float64], line_contact: bool
) -> dict[str, Any]:
    """Return the variables of the power dissipated in each layer, and by each relaxation time of its modulus.

    Parameters
    ----------
    frequency : ndarray
        Frequencies [rad/s].
    power : ndarray, shape (layers, frequencies)
        Power dissipated at each frequency [W], in line contact [W/m].
    """
    fractions = [_term_fractions(layer.shear_modulus, frequency) for layer in layers]
    terms = max(len(fraction) for fraction in fractions)
    relaxation_power = np.full((len(fractions), terms), np.nan)
    for of_layer, fraction, row in zip(power, fractions, relaxation_power, strict=True):
        row[: len(fraction)] = fraction @ of_layer
    watt = "W m-1" if line_contact else "W"
    return {
        "layer_power": ("layer", power.sum(axis=1), described(watt, "power dissipated in each layer")),
        "relaxation_power": (
            ("layer", "term"),
            relaxation_power,
            described(watt, "power dissipated by each relaxation time of a Prony series"),
        ),
    }


def _term_fractions(modulus: ShearModulusLike, frequency: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the fraction of the loss modulus due to each relaxation time (row) at each frequency."""
    relaxation = relaxation_of(modulus)
    if relaxation is None:
        return np.empty((0, frequency.size))
    products = frequency * relaxation.times[:-1, None]
    loss = relaxation.moduli[:-1, None] * products / (1.0 + products**2)
    total = loss.sum(axis=0)
    fractions: NDArray[np.float64] = np.divide(loss, total, out=np.zeros_like(loss), where=total > 0.0)
    return fractions
