"""Temperature of the layers: conduction with the dissipated power averaged over a revolution or a period."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from .._support.arguments import as_float, as_kelvin, as_member, as_not_negative, as_positive, require_type
from .._support.errors import InvalidInput, Range
from .._support.extras import extra
from .._support.plotting import plots
from .._support.progress import ProgressLike
from .._support.quantities import quantity_text
from .._support.result_warnings import warn
from .._support.tables import html_table
from ..solution import Solution
from ..solution.inside import Of, finite_line, inside_of
from ..solution.loss import loss as loss_in_the_volume
from .heated_body import HeatedBody, heated_body
from .surroundings import Core, Surroundings

if TYPE_CHECKING:
    import xarray
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from numpy.typing import ArrayLike, NDArray

__all__ = [
    "QUANTITIES",
    "Core",
    "Temperature",
    "plane_cooling",
    "temperature",
    "temperature_of",
    "temperature_warnings",
]

#: Variation over a revolution, divided by the largest rise, above which the mean over a revolution is not valid.
_RIPPLE = 0.2

#: Temperature rise above which the layers would not last [K]: from room temperature, it leads above 220 °C, where only
#: silicone and fluorocarbon rubbers endure some time.
_HIGHEST_RISE = 200.0


#: Unit and label of each reported number of a temperature, by name.
QUANTITIES = {
    "maximum": ("K", "largest temperature rise"),
    "surface_maximum": ("K", "largest temperature rise on the surface"),
    "mean": ("K", "mean temperature rise, weighted by the loss"),
    "heat": ("W", "heat generated"),
    "heat_to_core": ("W", "heat flow to the core, the hub or the base"),
    "heat_to_surroundings": ("W", "heat flow to the surroundings"),
    "ripple": ("K", "largest variation over a revolution or a period"),
}


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class Temperature:
    """Steady temperature of the layers, and its approach over time if requested.

    Attributes
    ----------
    rise : xarray.DataArray
        Rise over the surroundings [K], over (radius, theta) for a ball, (radius, z) for a roller or a wheel, and
        (depth, z) for a plane.
    maximum, surface_maximum : float
        Largest rise in the layers, and on the surface [K].
    mean : float
        Rise weighted by the dissipated power [K]; to first order, it determines the moduli.
    layer_means : tuple of float
        Mean rise of each layer, weighted in the same way [K].
    ambient : float
        Temperature of the surroundings [K].
    heat : float
        Power dissipated in the layers, in `heat_unit`.
    heat_to_core, heat_to_surroundings : float
        Heat that leaves to a core, hub or base, and through all free surfaces; the sum is `heat`.
    ripple : float
        Largest possible variation of the temperature of a point over a revolution or a period [K]; the error of the
        mean is at most this.
    heat_unit : str
        W; W/m for a roller without a width and for a track on a plane; W/m² for a belt.
    times : tuple of float
        Three longest time constants of the approach to the steady state [s], for the given heat capacity. Empty if
        convection varies along the surface.
    history : xarray.Dataset or None
        Dataset over the requested times [s]: `rise` [K] as above, and `maximum`, `surface_maximum`, `mean` [K].
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
    heat_unit: str = "W"
    times: tuple[float, ...] = ()
    history: xarray.Dataset | None = None

    def unit(self, name: str) -> str:
        """Return the unit of a number; those of the heat flows depend on the body.

        Raises
        ------
        KeyError
            If the name is not that of a reported number.
        """
        unit = QUANTITIES[name][0]
        return self.heat_unit if unit == "W" else unit

    def _repr_html_(self) -> str:
        """Return the numbers with units, as a table for notebooks."""
        rows = [(text, quantity_text(getattr(self, name), self.unit(name))) for name, (_, text) in QUANTITIES.items()]
        return html_table(f"Temperature above {self.ambient:g} K", rows)

    @plots("the section")
    def plot(self, ax: Axes | None = None) -> Figure | Axes:
        """Draw the temperature rise over the cross-section of the layers."""
        from .picture import plot_temperature

        title = f"largest rise {self.maximum:.3g} K above {self.ambient:g} K"
        return plot_temperature(self.rise, title, ax)

    def __repr__(self) -> str:
        """Return a summary."""
        heat, to_core = (quantity_text(getattr(self, name), self.heat_unit) for name in ("heat", "heat_to_core"))
        times = f"; time constants {', '.join(f'{time:.3g}' for time in self.times)} s" if self.times else ""
        return (
            f"Temperature(at most {self.ambient + self.maximum:.2f} K: rise {self.maximum:.3g} K, on the surface "
            f"{self.surface_maximum:.3g} K, loss-weighted mean {self.mean:.3g} K;\n"
            f"  {heat}, {to_core} of it to the core; variation {self.ripple:.2g} K{times})"
        )


def temperature(
    result: Solution,
    *,
    conductivity: float | Sequence[float] | None = None,
    convection: float | Callable[[NDArray[np.float64]], NDArray[np.float64]],
    ambient: float,
    core: Core | str | float = Core.INSULATED,
    core_temperature: float | None = None,
    of: Of | None = None,
    width: float | None = None,
    side_convection: float | None = None,
    hub_conductance: float | None = None,
    base_convection: float | None = None,
    period: float | None = None,
    time: ArrayLike | None = None,
    start: Temperature | None = None,
    heat_capacity: float = 2e6,
    max_order: int | None = None,
    progress: ProgressLike = None,
) -> Temperature:
    """Return the steady temperature of the layers of one body.

    Parameters
    ----------
    result : Result
        Solution of a contact.
    conductivity : float or sequence of float, optional
        Conductivity of all layers or of each layer [W/(m K)], > 0; by default that of each `Layer`.
    convection : float or callable
        Coefficient of convection at the surface [W/(m² K)], ≥ 0, or a function that returns it for an array of angles θ
        [rad]. It may vary with θ only for a ball or a wheel. `Result.plane_cooling` returns a function that includes
        the heat flow into the plane.
    ambient : float
        Temperature of the surroundings [K], ≥ 100.
    core : Core, str or float, default Core.INSULATED
        Thermal condition at the core of a ball, the hub of a roller or wheel, or the base of a plane: "insulated",
        "isothermal", or the conductivity of a ball's solid core [W/(m K)]. Must be INSULATED for a ball without a core.
    core_temperature : float, optional
        Temperature of an isothermal core [K]; by default that of the surroundings.
    of : "body" or "counterbody", optional
        Rolling body or counterbody. By default the deformable body; if both deform, the rolling body.
    width : float, optional
        Width of a roller from face to face [m], > 0. Without it, heat is per length and the faces take none. Do not
        give it for a wheel.
    side_convection : float, optional
        Coefficient of convection at the side faces of a roller or wheel [W/(m² K)], ≥ 0, by default 0. It requires the
        same conductivity in all layers.
    hub_conductance : float, optional
        Thermal conductance from the hub of a roller or wheel to the surroundings [W/K], ≥ 0, by default 0.
    base_convection : float, optional
        Coefficient of convection below a plane, such as at the other face of a belt [W/(m² K)], ≥ 0.
    period : float, optional
        Time from one pass over a plane to the next [s], > 0; required for a plane.
    time : array_like, optional
        Times [s], ≥ 0, at which `history` contains the approach to the steady state; requires a constant `convection`.
    start : Temperature, optional
        State at time 0, of the same layers: the end of its history, or its steady state if it has none. By default all
        layers have the temperature of the surroundings.
    heat_capacity : float, default 2e6
        Heat capacity per volume ρc [J/(m³ K)], > 0; by default that of rubber. It affects only temperatures over time,
        `times`, `ripple` and the warning about the mean over a revolution.
    max_order, progress
        Same as in `Result.loss`.

    Returns
    -------
    Temperature
        Temperature rise and heat flows.

    Raises
    ------
    TypeError, ValueError
        If an argument is invalid, or if no surface takes the heat.
    ImportError
        If the extra `viscoroll[files]` is missing.

    Warns
    -----
    ResultWarning
        If the temperature of a point varies over a revolution by more than a fifth of the largest rise, or if it rises
        by more than 200 K.

    Notes
    -----
    The source is the loss of the model, with the volume element r² dr dθ dφ, in the volume of the sphere. Heat from
    slip at the surface is not included. A plane has parallel tracks, at a distance of one circumference of the rolling
    body or several. The section of a wheel is rectangular, whatever its crown, and ends at its faces; the source is its
    loss between the faces, scaled to the total power.

    Examples
    --------
    >>> from viscoroll import Mesh, paper, solve
    >>> r = solve(paper.ball(), load=100.0, angular_speed=2.5, mesh=Mesh(nodes_per_revolution=400))
    >>> t = r.temperature(conductivity=0.2, convection=10.0, ambient=293.15)
    >>> print(f"{t.maximum:.2f} K, {t.surface_maximum:.2f} K on the surface")
    1.89 K, 1.83 K on the surface
    """
    given = Surroundings(
        convection=convection,
        ambient=as_kelvin("ambient", ambient),
        core=as_member("core", core, Core) if isinstance(core, str) else core,
        core_temperature=core_temperature,
        width=width,
        side_convection=side_convection,
        hub_conductance=hub_conductance,
        base_convection=base_convection,
        period=period,
    )
    inside = inside_of(result, of)
    body = heated_body(inside, given, conductivity)
    return temperature_of(
        body,
        lambda: loss_in_the_volume(result, of=inside.of, max_order=max_order, progress=progress),
        given.ambient,
        time=time,
        start=start,
        heat_capacity=heat_capacity,
    )


def temperature_of(
    body: HeatedBody,
    lost: Callable[[], xarray.Dataset],
    ambient: float,
    *,
    time: ArrayLike | None,
    start: Temperature | None,
    heat_capacity: float,
) -> Temperature:
    """Return the temperature of a thermal model.

    Parameters
    ----------
    lost : callable
        Function that returns the loss at the places of the volume integral.
    ambient : float
        Temperature of the surroundings [K].
    time, start, heat_capacity
        Same as in `temperature`.
    """
    with extra("files"):
        import xarray

    capacity = as_positive("heat_capacity", heat_capacity, "J/(m^3 K)")
    require_type("start", start, Temperature, optional=True)
    if start is not None and time is None:
        raise InvalidInput("start", "must be left out without time: the steady state does not depend on it")
    loss = lost()
    source = body.source(loss)
    rises = body.conduction.solve(source, body.inner_rise)
    places = body.places_along(loss)
    values = body.values(places)
    rise = rises.T @ values
    means = body.means(source, rises)
    heat = body.conduction.total_heat(source)
    to_core = body.conduction.heat_inwards(source, rises)
    ripple = float(loss.loss_density.max()) / capacity
    found = Temperature(
        rise=_field(body, places, rise, xarray.DataArray),
        maximum=float(body.conduction.refined(rise).max()),
        surface_maximum=float(rise[-1].max()),
        mean=means[0],
        layer_means=tuple(means[1:]),
        ambient=ambient,
        heat=heat,
        heat_to_core=to_core,
        heat_to_surroundings=body.conduction.heat_outwards(rises) + body.conduction.heat_sideways(rises),
        ripple=ripple,
        heat_unit=body.unit,
        times=tuple(body.conduction.time_constants(capacity, 3).tolist()) if body.conduction.has_uniform_film else (),
        history=None if time is None else _history(body, places, source, rises, start, time, capacity),
    )
    warn(temperature_warnings(found))
    return found


def temperature_warnings(found: Temperature) -> list[str]:
    """Return warnings if the mean over a revolution is not valid, and if the layers would not last."""
    warnings = []
    if found.ripple > _RIPPLE * abs(found.maximum):
        warnings.append(
            f"between passes, the temperature of a point varies by up to {found.ripple:.2g} K, while its mean rises by "
            f"up to {found.maximum:.2g} K: at this low speed, peaks are hotter than the computed mean"
        )
    if found.maximum > _HIGHEST_RISE:
        warnings.append(
            f"the temperature rises by {found.maximum:.3g} K (recommended: at most {_HIGHEST_RISE:g} K): this "
            "destroys almost any polymer; reduce load or speed, or improve the cooling"
        )
    return warnings


def _history(
    body: HeatedBody,
    places: NDArray[np.float64],
    source: NDArray[np.float64],
    steady: NDArray[np.float64],
    start: Temperature | None,
    time: ArrayLike,
    capacity: float,
) -> xarray.Dataset:
    import xarray

    times = finite_line("time", time)
    if not (times >= 0.0).all():
        raise Range(0.0, unit="s").error("time", f"{times.min():g} s")
    initial = np.zeros_like(steady)
    if start is not None:
        field = start.rise if start.history is None else start.history.rise[-1]
        expected = (steady.shape[1], places.size)
        if field.shape != expected:
            raise InvalidInput("start", f"must have the same layers and mesh, with shape {expected}", field.shape)
        initial = np.linalg.lstsq(body.values(places).T, field.to_numpy().T, rcond=None)[0]
    rises = body.conduction.transient(steady, initial, times, capacity)
    rise = np.einsum("tjp,jz->tpz", rises, body.values(places))
    kelvin = {"units": "K"}
    frame = _field(body, places, rise[0], xarray.DataArray)
    return xarray.Dataset(
        {
            "rise": (("time", *frame.dims), rise, frame.attrs),
            "maximum": ("time", [float(body.conduction.refined(one).max()) for one in rise], kelvin),
            "surface_maximum": ("time", rise[:, -1].max(axis=1), kelvin),
            "mean": ("time", [body.means(source, one)[0] for one in rises], kelvin),
        },
        {"time": ("time", times, {"units": "s"}), **frame.coords},
    )


def _field(
    body: HeatedBody, places: NDArray[np.float64], rise: NDArray[np.float64], array: type[xarray.DataArray]
) -> xarray.DataArray:
    across, position = body.along, body.conduction.coordinate
    unit = {"units": "rad" if across == "theta" else "m"}
    has_radius = body.inside.has_radius
    normal = "radius" if has_radius else "depth"
    return array(
        rise,
        dims=(normal, across),
        coords={
            normal: (normal, position if has_radius else body.inside.depth(position), {"units": "m"}),
            across: (across, places, unit),
        },
        attrs={"units": "K", "long_name": "temperature rise over the surroundings"},
        name="rise",
    )


def plane_cooling(
    result: Solution,
    *,
    convection: float,
    conductivity: float,
    heat_capacity: float = 2e6,
    plane_effusivity: float = np.inf,
) -> Callable[[NDArray[np.float64]], NDArray[np.float64]]:
    """Return a convection coefficient for `temperature` that includes an estimate of the heat flow into the plane.

    A strip of the surface is in contact with the plane for t_c = (its length in contact)/(Ω r_o). Per area it transfers
    the heat 2 e ΔT √(t_c/π) e_p/(e + e_p) between two half-spaces; the mean over a revolution gives the coefficient.

    Parameters
    ----------
    result : Result
        Solution of a contact.
    convection : float
        Coefficient of convection without the plane [W/(m² K)], ≥ 0.
    conductivity : float
        Conductivity of the outer layer [W/(m K)], > 0.
    heat_capacity : float, default 2e6
        Heat capacity per volume ρc of the outer layer [J/(m³ K)], > 0.
    plane_effusivity : float, default infinity
        Effusivity √(kρc) of the plane [W √s/(m² K)], > 0; infinite for a metal compared with rubber. The plane has the
        temperature of the surroundings.

    Returns
    -------
    callable
        Function that returns the coefficient [W/(m² K)] at angles θ [rad].

    References
    ----------
    H. S. Carslaw and J. C. Jaeger, Conduction of Heat in Solids, 2nd ed. (1959), section 2.9.
    """
    inside = inside_of(result, "body")
    base = as_not_negative("convection", convection, "W/(m^2 K)")
    effusivity = np.sqrt(
        as_positive("conductivity", conductivity, "W/(m K)") * as_positive("heat_capacity", heat_capacity, "J/(m^3 K)")
    )
    plane = as_float("plane_effusivity", plane_effusivity)
    if not plane > 0.0:
        raise InvalidInput("plane_effusivity", "must be > 0 W s^0.5/(m^2 K)", repr(plane))
    fraction = 1.0 if np.isinf(plane) else plane / (effusivity + plane)
    nodes = inside.node_angles()[1]
    time = result.contact.sum(axis=0) * result.mesh.spacing / result.angular_speed
    taken = 2.0 * effusivity * fraction * np.sqrt(time / np.pi) * result.angular_speed / (2.0 * np.pi)

    def coefficient(theta: NDArray[np.float64]) -> NDArray[np.float64]:
        values: NDArray[np.float64] = base + np.interp(theta, nodes, taken, left=0.0, right=0.0)
        return values

    return coefficient
