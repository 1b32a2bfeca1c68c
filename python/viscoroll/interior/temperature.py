"""How hot the coating gets by what is lost in it: steady conduction, the source spread over a revolution."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from enum import Enum
from typing import TYPE_CHECKING

import numpy as np

from .._core import InnerBoundary
from .._support.arguments import as_float, as_kelvin, require_type
from .._support.cautions import warn
from .._support.extras import extra
from .._support.progress import ProgressLike
from .._support.tables import html_table, number_text
from .._support.text import shown
from ..bodies import CoatedSphere
from ..rolling import Result
from ..solution.inside import inside_of
from ..solution.loss import contact_size
from ..solution.solution import node_angles
from .conduction import Conduction, legendre_values

if TYPE_CHECKING:
    import xarray
    from numpy.typing import NDArray

__all__ = ["QUANTITIES", "Core", "Temperature", "plane_cooling", "temperature"]

#: Degrees per r_o over the contact's semi-axis: 1e-5 of the temperature.
_DEGREES_PER_CONTACT = 15.0
_MOST_DEGREES = 400

#: Ripple over a revolution, per largest rise, above which a mean over the revolution does not hold.
_RIPPLE = 0.2


#: Numbers that are reported of a temperature: name, unit, what it is.
QUANTITIES = {
    "maximum": ("K", "largest temperature rise"),
    "surface_maximum": ("K", "largest rise on the surface"),
    "mean": ("K", "rise weighted by the loss"),
    "heat": ("W", "heat"),
    "heat_to_core": ("W", "of it, to the core"),
    "heat_to_surroundings": ("W", "of it, to the surroundings"),
    "ripple": ("K", "swing over a revolution, at most"),
}


class Core(Enum):
    """What the core does to heat; a number in its place is its conductivity [W/(m K)]."""

    INSULATED = "insulated"  #: lets none through
    ISOTHERMAL = "isothermal"  #: takes what comes, at a temperature of its own


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class Temperature:
    """Steady temperature of the coating.

    Attributes
    ----------
    rise : xarray.DataArray
        Over that of the surroundings [K], over (radius, theta).
    maximum, surface_maximum : float
        Largest rise anywhere, and on the surface [K].
    mean : float
        Rise, weighted by the power lost [K]: what the moduli see, to first order.
    layer_means : tuple of float
        The same of each layer [K].
    ambient : float
        Temperature of the surroundings [K].
    heat : float
        Power that is lost in the coating [W].
    heat_to_core, heat_to_surroundings : float
        Where it goes [W]; they add up to `heat`.
    ripple : float
        What the temperature of a point swings by over a revolution, at most [K]: the mean over one is wrong by no more.
    """

    rise: xarray.DataArray
    maximum: float
    surface_maximum: float
    mean: float
    layer_means: tuple[float, ...]
    ambient: float
    heat: float
    heat_to_core: float
    heat_to_surroundings: float
    ripple: float

    def _repr_html_(self) -> str:
        """Return the numbers with units, as a table for notebooks."""
        rows = [(text, number_text(getattr(self, name)), unit) for name, (unit, text) in QUANTITIES.items()]
        return html_table(f"Temperature over {self.ambient:g} K", rows)

    def __repr__(self) -> str:
        """Return a summary."""
        return (
            f"Temperature(at most {self.ambient + self.maximum:.2f} K: rise {self.maximum:.3g} K, on the surface "
            f"{self.surface_maximum:.3g} K, mean by loss {self.mean:.3g} K; {self.heat:.3g} W, of which to the core "
            f"{self.heat_to_core:.3g} W; ripple {self.ripple:.2g} K)"
        )


def temperature(
    result: Result,
    *,
    conductivity: float | Sequence[float] | None = None,
    convection: float | Callable[[NDArray[np.float64]], NDArray[np.float64]],
    ambient: float,
    core: Core | float = Core.INSULATED,
    core_temperature: float | None = None,
    heat_capacity: float = 2e6,
    max_order: int | None = None,
    progress: ProgressLike = None,
) -> Temperature:
    """Temperature of a coating that has rolled for long.

    Parameters
    ----------
    result : Result
        A solution.
    conductivity : float or sequence of float, optional
        Of the layers, or of each [W/(m K)], > 0; by default that of each `Layer`.
    convection : float or callable
        Coefficient at the surface [W/(m² K)], ≥ 0, or a function of an array of angles θ [rad] that returns it:
        `plane_cooling` makes one that adds the heat that the plane takes.
    ambient : float
        Temperature of the surroundings [K], ≥ 100.
    core : Core or float, default Core.INSULATED
        Insulated, isothermal, or the conductivity of a solid core [W/(m K)]. Without a core, INSULATED.
    core_temperature : float, optional
        Of an isothermal core [K]; by default that of the surroundings.
    heat_capacity : float, default 2e6
        Per volume, ρc [J/(m³ K)], > 0, of rubber by default: it counts only in the warning that a mean over a
        revolution does not hold.
    max_order, progress
        As of `Result.loss`.

    Returns
    -------
    Temperature
        The rise and where the heat goes.

    Raises
    ------
    TypeError, ValueError
        For bad input, and where nothing takes the heat.
    ImportError
        Without the extra `viscoroll[files]`.

    Warns
    -----
    ResultWarning
        Where the temperature of a point swings over a revolution by more than a fifth of the largest rise.

    Notes
    -----
    The source is what the model loses in r² dr dθ dφ, put into the sphere's volume. The heat of slip on the plane is
    not in it.

    Examples
    --------
    >>> from viscoroll import Mesh, paper, solve
    >>> r = solve(paper.ball(), load=100.0, angular_speed=2.5, mesh=Mesh(nodes_per_revolution=400))
    >>> t = temperature(r, conductivity=0.2, convection=10.0, ambient=293.15)
    >>> print(f"{t.maximum:.2f} K, {t.surface_maximum:.2f} K on the surface")
    1.89 K, 1.83 K on the surface
    """
    with extra("files"):
        import xarray

    require_type("result", result, Result)
    ball = _coated_ball(result)
    conductivities = _conductivities(ball, conductivity)
    surroundings = as_kelvin("ambient", ambient)
    capacity = _positive("heat_capacity", heat_capacity, "J/(m^3 K)")
    film = convection if callable(convection) else _not_negative("convection", convection, "W/(m^2 K)")
    core_conductivity, core_rise = _core(ball, core, core_temperature, surroundings)
    if core_conductivity is not None and film == 0.0 and result.rolling_bulk_power > 0.0:
        raise ValueError("convection must be > 0 W/(m^2 K) where the core takes no heat, got 0")

    loss = result.loss(of="ball", max_order=max_order, progress=progress)
    degrees = min(int(_DEGREES_PER_CONTACT * ball.outer_radius / contact_size(result)) + 2, _MOST_DEGREES)
    layers = Conduction(_boundaries(ball), conductivities, film, degrees=degrees, core_conductivity=core_conductivity)
    source = _source(ball, loss, layers, degrees)
    heat = layers.heat_of(source)
    if heat > 0.0:
        source = source * (result.rolling_bulk_power / heat)  # of all orders
    rises = layers.solve(source, core_rise)
    means = _means(ball, layers, source, rises)
    theta = loss.theta.to_numpy()
    rise = rises.T @ legendre_values(degrees, np.cos(theta))
    ripple = float(loss.loss_density.max()) / capacity
    found = Temperature(
        rise=xarray.DataArray(
            rise,
            dims=("radius", "theta"),
            coords={"radius": ("radius", layers.radius, {"units": "m"}), "theta": ("theta", theta, {"units": "rad"})},
            attrs={"units": "K", "long_name": "temperature rise over the surroundings"},
            name="rise",
        ),
        maximum=float(rise.max()),
        surface_maximum=float(rise[-1].max()),
        mean=means[0],
        layer_means=tuple(means[1:]),
        ambient=surroundings,
        heat=layers.heat_of(source),
        heat_to_core=layers.heat_to_core(source, rises),
        heat_to_surroundings=layers.heat_to_surroundings(rises),
        ripple=ripple,
    )
    if ripple > _RIPPLE * abs(found.maximum):
        warn(
            [
                f"a point's temperature swings by up to {ripple:.2g} K over a revolution, and the mean rises by "
                f"{found.maximum:.2g} K: at this speed the peaks are hotter than the mean over a revolution"
            ]
        )
    return found


def plane_cooling(
    result: Result,
    *,
    convection: float,
    conductivity: float,
    heat_capacity: float = 2e6,
    plane_effusivity: float = np.inf,
) -> Callable[[NDArray[np.float64]], NDArray[np.float64]]:
    """Convection with the heat that the plane takes at every passage: an estimate, for `temperature`.

    A strip of the surface touches the plane for t_c = (its length in contact)/(Ω r_o) and gives it 2 e ΔT √(t_c/π)
    e_p/(e + e_p) per area, as two half-spaces do; averaged over a revolution that is a coefficient.

    Parameters
    ----------
    result : Result
        A solution.
    convection : float
        Without the plane [W/(m² K)], ≥ 0.
    conductivity : float
        Of the outer layer [W/(m K)], > 0.
    heat_capacity : float, default 2e6
        Of the outer layer, ρc [J/(m³ K)], > 0.
    plane_effusivity : float, default infinity
        √(kρc) of the plane [W √s/(m² K)], > 0; infinite for metals, compared with rubber. The plane is as warm as the
        surroundings.

    Returns
    -------
    callable
        Coefficient [W/(m² K)] at angles θ [rad].

    References
    ----------
    H. S. Carslaw and J. C. Jaeger, Conduction of Heat in Solids, 2nd ed. (1959), section 2.9.
    """
    require_type("result", result, Result)
    _coated_ball(result)
    base = _not_negative("convection", convection, "W/(m^2 K)")
    effusivity = np.sqrt(
        _positive("conductivity", conductivity, "W/(m K)") * _positive("heat_capacity", heat_capacity, "J/(m^3 K)")
    )
    plane = as_float("plane_effusivity", plane_effusivity)
    if not plane > 0.0:
        raise ValueError(f"plane_effusivity must be > 0 W s^0.5/(m^2 K), got {plane!r}")
    share = 1.0 if np.isinf(plane) else plane / (effusivity + plane)
    nodes = node_angles(result)[1]
    time = result.contact.sum(axis=0) * result.mesh.spacing / result.angular_speed
    taken = 2.0 * effusivity * share * np.sqrt(time / np.pi) * result.angular_speed / (2.0 * np.pi)

    def coefficient(theta: NDArray[np.float64]) -> NDArray[np.float64]:
        values: NDArray[np.float64] = base + np.interp(theta, nodes, taken, left=0.0, right=0.0)
        return values

    return coefficient


def _coated_ball(result: Result) -> CoatedSphere:
    body = inside_of(result, "ball").body
    require_type("result.ball", body, CoatedSphere)
    assert isinstance(body, CoatedSphere)
    return body


def _boundaries(ball: CoatedSphere) -> list[float]:
    return [ball.core_radius, *(ball.core_radius + np.cumsum([layer.thickness for layer in ball.layers])).tolist()]


def _conductivities(ball: CoatedSphere, given: float | Sequence[float] | None) -> list[float]:
    if given is None:
        values = [layer.conductivity for layer in ball.layers]
        if None in values:
            raise ValueError(f"conductivity must be given here or in every layer, got layers with {values}")
        return [value for value in values if value is not None]
    if np.ndim(given) == 0:
        return [_positive("conductivity", given, "W/(m K)")] * len(ball.layers)
    several = [_positive(f"conductivity[{j}]", value, "W/(m K)") for j, value in enumerate(given)]  # type: ignore[arg-type]
    if len(several) != len(ball.layers):
        raise ValueError(f"conductivity must be one for each of {len(ball.layers)} layers, got {len(several)}")
    return several


def _core(
    ball: CoatedSphere, core: Core | float, core_temperature: float | None, ambient: float
) -> tuple[float | None, float]:
    """Conductivity of the core, None for one at a given temperature, and its rise [K]."""
    if core is not Core.ISOTHERMAL and core_temperature is not None:
        raise ValueError(f"core_temperature must be left out unless core is ISOTHERMAL, got {shown(core_temperature)}")
    if ball.inner_boundary is not InnerBoundary.RIGID and core is not Core.INSULATED:
        raise ValueError(f"core must be INSULATED in a ball without one, got {shown(core)}")
    if core is Core.INSULATED:
        return 0.0, 0.0
    if core is Core.ISOTHERMAL:
        held = ambient if core_temperature is None else _positive("core_temperature", core_temperature, "K")
        return None, held - ambient
    return _positive("core", core, "W/(m K), or a viscoroll.Core"), 0.0


def _source(ball: CoatedSphere, loss: xarray.Dataset, layers: Conduction, degrees: int) -> NDArray[np.float64]:
    """q_l at the points of the layers, from the loss at its own nodes, which are Gauss's in the root of the depth."""
    theta = loss.theta.to_numpy()
    waves = legendre_values(degrees, np.cos(theta)) * (theta[1] - theta[0])
    by_degree = (np.arange(degrees)[:, None] + 0.5) * (waves @ loss.power_density.to_numpy().T)
    source = np.empty((degrees, layers.radius.size))
    bounds = _boundaries(ball)
    for number in range(len(ball.layers)):
        nodes = loss.place_layer.to_numpy() == number
        points = layers.layer == number
        thickness = bounds[number + 1] - bounds[number]
        root = np.sqrt(np.clip((bounds[number + 1] - loss.radius.to_numpy()[nodes]) / thickness, 0.0, None))
        wanted = np.sqrt(np.clip((bounds[number + 1] - layers.radius[points]) / thickness, 0.0, None))
        source[:, points] = by_degree[:, nodes] @ _interpolation(root, wanted).T
    return source


def _interpolation(nodes: NDArray[np.float64], points: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the matrix of polynomial interpolation, by the barycentric formula."""
    gaps = nodes[:, None] - nodes[None, :] + np.eye(nodes.size)
    weights = 1.0 / np.prod(4.0 * gaps, axis=1)
    offsets = points[:, None] - nodes[None, :]
    hits = offsets == 0.0
    terms = weights / np.where(hits, 1.0, offsets)
    matrix: NDArray[np.float64] = terms / terms.sum(axis=1, keepdims=True)
    matrix[hits.any(axis=1)] = hits[hits.any(axis=1)]
    return matrix


def _means(
    ball: CoatedSphere, layers: Conduction, source: NDArray[np.float64], rises: NDArray[np.float64]
) -> list[float]:
    """Rise weighted by the loss: of all layers, and of each."""
    degree = np.arange(layers.degrees)[:, None]
    weights = layers.volume_weights()
    heated = weights * (rises * source / (degree + 0.5)).sum(axis=0)
    heat = weights * 2.0 * source[0]
    groups = [np.ones(layers.layer.size, bool), *(layers.layer == number for number in range(len(ball.layers)))]
    return [float(heated[group].sum() / heat[group].sum()) if heat[group].sum() > 0.0 else 0.0 for group in groups]


def _positive(name: str, value: object, unit: str) -> float:
    number = as_float(name, value)
    if not (np.isfinite(number) and number > 0.0):
        raise ValueError(f"{name} must be finite and > 0 {unit}, got {number!r}")
    return number


def _not_negative(name: str, value: object, unit: str) -> float:
    number = as_float(name, value)
    if not (np.isfinite(number) and number >= 0.0):
        raise ValueError(f"{name} must be finite and >= 0 {unit}, got {number!r}")
    return number
