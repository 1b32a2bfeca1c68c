"""Thermal model of a ball, a roller, a wheel or a slab: conduction, heat transfer at the surfaces, and source."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import singledispatch
from typing import TYPE_CHECKING

import numpy as np

from .._core import InnerBoundary
from .._support.arguments import as_not_negative, as_positive
from .._support.errors import InvalidInput
from .._support.text import shown
from ..bodies import CoatedCylinder, CoatedPlane, CoatedSphere, CoatedWheel
from ..solution.inside import Inside, LayersInside
from ..solution.loss import contact_size
from .conduction import Conduction
from .heat_modes import (
    HeatModes,
    film_matrix_of_ball,
    film_matrix_of_wheel,
    modes_of_ball,
    modes_of_roller,
    modes_of_slab,
    modes_of_track,
    modes_of_wheel,
)
from .surroundings import (
    Core,
    Surroundings,
    conductivities_of,
    core_rise,
    inner_coefficients,
    require_heat_sink,
    require_omitted,
    uniform_film,
)

if TYPE_CHECKING:
    import xarray
    from numpy.typing import NDArray

__all__ = ["HeatedBody", "heated_body", "heated_plane"]

#: Number of modes along a ball or across a wheel in units of r_o/a, with the semi-axis a of the contact (the relative
#: error of the temperature is 1e-5), and largest number.
_DEGREES_PER_CONTACT = 15.0
_MAX_DEGREES = 400

#: Number of modes between side faces: the neglected modes contain 1e-6 of the heat.
_SIDE_MODES = 40

#: Smallest number of places across a roller or wheel at which temperatures are returned.
_PLACES_ACROSS = 41


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class HeatedBody:
    """Thermal model of a body, with the places along its surface at which temperatures are returned.

    Attributes
    ----------
    inside : LayersInside
        Layers of the body.
    conduction : Conduction
        Heat conduction in its layers.
    inner_rise : float
        Rise of an inner surface at a given temperature [K].
    along : str
        Name of the coordinate along the surface, theta [rad] or z [m].
    unit : str
        Unit of heat: W, W/m for a roller without a width and for a track on a plane, W/m² for a belt.
    power : float
        Power dissipated in the body, in that unit.
    project : callable
        Function that converts the loss density [W/m³] along the surface to sources of the modes.
    places : ndarray, optional
        Places along the surface at which temperatures are returned; by default those of the loss.
    """

    inside: LayersInside
    conduction: Conduction
    inner_rise: float
    along: str
    unit: str
    power: float
    project: Callable[[xarray.Dataset], NDArray[np.float64]]
    places: NDArray[np.float64] | None = None

    def places_along(self, loss: xarray.Dataset) -> NDArray[np.float64]:
        """Return the places along the surface, in the coordinate `along`."""
        return loss[self.along].to_numpy() if self.places is None else self.places

    def values(self, places: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return the modes at places along the surface."""
        return self.conduction.modes.values(np.cos(places) if self.along == "theta" else places)

    def source(self, loss: xarray.Dataset) -> NDArray[np.float64]:
        """Return q_j at the points of the layers [W/m³], interpolated over √depth from the Gauss points of the loss."""
        by_mode = self.project(loss)
        source = np.empty((by_mode.shape[0], self.conduction.coordinate.size))
        bounds = self.inside.body.boundaries
        depths = loss.depth.to_numpy()
        for number in range(len(bounds) - 1):
            nodes = loss.place_layer.to_numpy() == number
            points = self.conduction.layer == number
            thickness = bounds[number + 1] - bounds[number]
            top = float(self.inside.depth(bounds[number + 1]))
            root = np.sqrt(np.clip((depths[nodes] - top) / thickness, 0.0, None))
            wanted = np.sqrt(np.clip((bounds[number + 1] - self.conduction.coordinate[points]) / thickness, 0.0, None))
            source[:, points] = by_mode[:, nodes] @ _interpolation(root, wanted).T
        heat = self.conduction.total_heat(source)
        return source * (self.power / heat) if heat > 0.0 else source  # scaled to the power of all orders

    def means(self, source: NDArray[np.float64], rises: NDArray[np.float64]) -> list[float]:
        """Return the rise weighted by the loss, of all layers together and of each layer [K]."""
        modes = self.conduction.modes
        weights = self.conduction.volume_weights()
        heated = weights * (modes.square @ (rises * source))
        heat = weights * (modes.area @ source)
        layers = self.conduction.layer
        groups = [np.ones(layers.size, bool), *(layers == number for number in range(layers.max() + 1))]
        return [float(heated[group].sum() / heat[group].sum()) if heat[group].sum() > 0.0 else 0.0 for group in groups]


def heated_body(inside: Inside, given: Surroundings, conductivity: float | Sequence[float] | None) -> HeatedBody:
    """Return the thermal model of a body of a result.

    Raises
    ------
    TypeError, ValueError
        If an argument is invalid or does not apply to the body, or if no surface takes the heat.
    """
    _require_thickness(inside)
    conductivities = conductivities_of(inside, conductivity)
    return _model(inside.body, inside, given, conductivities)


def heated_plane(
    inside: LayersInside,
    given: Surroundings,
    conductivity: float | Sequence[float] | None,
    *,
    track_distance: float | None,
    waves: int,
    period: float,
    power: float,
) -> HeatedBody:
    """Return the thermal model of a plane under a rough surface, whose source has no symmetry across the path.

    Parameters
    ----------
    track_distance : float or None
        Period across the path [m]; None in line contact.
    waves : int
        Number of waves across.
    period : float
        Time from one passage to the next [s].
    power : float
        Power dissipated in the layers [W/m], in line contact [W/m²].

    Raises
    ------
    TypeError, ValueError
        If an argument is invalid or does not apply to a plane, or if no surface takes the heat.
    """
    _require_thickness(inside)
    conductivities = conductivities_of(inside, conductivity)
    modes = modes_of_slab(None) if track_distance is None else modes_of_track(track_distance, waves)
    return _heated_slab(inside, given, conductivities, modes, period, power)


def _require_thickness(inside: LayersInside) -> None:
    if not np.isfinite(inside.thickness):
        raise InvalidInput(
            "result.on", "must have a finite thickness for a steady temperature", "a half-space: give a thick layer"
        )


@singledispatch
def _model(body: object, inside: Inside, given: Surroundings, conductivities: list[float]) -> HeatedBody:
    """Return the thermal model of a body; each type of body registers its own."""
    raise NotImplementedError(type(body).__name__)


@_model.register
def _ball(ball: CoatedSphere, inside: Inside, given: Surroundings, conductivities: list[float]) -> HeatedBody:
    require_omitted(given, ("width", "side_convection", "hub_conductance", "base_convection", "period"), "a ball")
    degrees = min(int(_DEGREES_PER_CONTACT * inside.radius / contact_size(inside.result)) + 2, _MAX_DEGREES)
    if ball.inner_boundary is not InnerBoundary.RIGID and given.core is not Core.INSULATED:
        raise InvalidInput("core", "must be INSULATED in a ball without a rigid core", shown(given.core))
    rise = core_rise(given)
    inner: NDArray[np.float64] | None
    if isinstance(given.core, Core):
        inner = None if given.core is Core.ISOTHERMAL else np.zeros(degrees)
    else:
        inner = (
            as_positive("core", given.core, "W/(m K), or a viscoroll.enums.Core")
            * np.arange(degrees, dtype=np.float64)
            / ball.core_radius
        )
    film = film_matrix_of_ball(given.convection, degrees) if callable(given.convection) else uniform_film(given)
    require_heat_sink(inside.bulk_power, film, inner is None)
    modes = modes_of_ball(degrees)

    def project(loss: xarray.Dataset) -> NDArray[np.float64]:
        theta = loss.theta.to_numpy()
        waves = modes.values(np.cos(theta)) * (theta[1] - theta[0])
        degree = np.arange(degrees)[:, None] + 0.5
        return np.asarray(degree * (waves @ loss.power_density.to_numpy().T))

    return HeatedBody(
        inside=inside,
        conduction=Conduction(ball.boundaries.tolist(), conductivities, modes, film=film, inner=inner),
        inner_rise=rise,
        along="theta",
        unit="W",
        power=inside.bulk_power,
        project=project,
    )


@_model.register
def _roller(body: CoatedCylinder, inside: Inside, given: Surroundings, conductivities: list[float]) -> HeatedBody:
    require_omitted(given, ("base_convection", "period"), "a roller")
    width = None if given.width is None else as_positive("width", given.width, "m")
    for name in ("side_convection", "hub_conductance"):
        if width is None and getattr(given, name) is not None:
            raise InvalidInput("width", f"must be given with {name}", "none")
    side = _side(given, conductivities)
    modes = modes_of_roller(width, side / conductivities[0], _SIDE_MODES)
    bounds = body.boundaries
    inner = inner_coefficients(given, modes, lambda: 2.0 * np.pi * bounds[0] * (width or 1.0))
    film = uniform_film(given)
    require_heat_sink(inside.bulk_power, film, inner is None or bool(inner[0] > 0.0) or side > 0.0)
    return HeatedBody(
        inside=inside,
        conduction=Conduction(bounds.tolist(), conductivities, modes, film=film, inner=inner),
        inner_rise=core_rise(given),
        along="z",
        unit="W/m" if width is None else "W",
        power=inside.bulk_power * (width or 1.0),
        project=lambda loss: modes.unity[:, None] * loss.power_density.to_numpy()[:, 0],
        places=np.zeros(1) if width is None else _across(width, modes),
    )


@_model.register
def _wheel(tread: CoatedWheel, inside: Inside, given: Surroundings, conductivities: list[float]) -> HeatedBody:
    """Return the thermal model of a wheel, or of a roller under a wheel: the source varies across the section."""
    result = inside.result
    if inside.selected.line_contact:
        require_omitted(given, ("base_convection", "period"), "a roller")
        if given.width is None:
            raise InvalidInput("width", "must be given for a roller under a wheel: the width of the roller [m]")
        width = as_positive("width", given.width, "m")
    else:
        require_omitted(given, ("width", "base_convection", "period"), "a wheel")
        width = tread.width
    side = _side(given, conductivities)
    narrowest = 0.5 * result.contact_width if result.contact_width else contact_size(result)
    wanted = int(_DEGREES_PER_CONTACT * width / (np.pi * narrowest))
    modes = modes_of_wheel(width, side / conductivities[0], min(max(wanted, 2 * _SIDE_MODES), _MAX_DEGREES))
    bounds = tread.boundaries
    inner = inner_coefficients(given, modes, lambda: 2.0 * np.pi * bounds[0] * width)
    film = (
        film_matrix_of_wheel(given.convection, modes, width, inside.radius)
        if callable(given.convection)
        else uniform_film(given)
    )
    require_heat_sink(inside.bulk_power, film, inner is None or bool(inner[0] > 0.0) or side > 0.0)
    points, weights = np.polynomial.legendre.leggauss(2 * modes.count)
    z = 0.5 * width * points
    # `square` contains the factor 2π of the circumference.
    waves = np.pi * width * weights * modes.values(z) / modes.square[:, None]

    def project(loss: xarray.Dataset) -> NDArray[np.float64]:
        density = loss.power_density.to_numpy().T
        return np.asarray(waves @ _between_nodes(loss.z.to_numpy()[::-1], density[::-1], z))

    return HeatedBody(
        inside=inside,
        conduction=Conduction(bounds.tolist(), conductivities, modes, film=film, inner=inner),
        inner_rise=core_rise(given),
        along="z",
        unit="W",
        power=inside.bulk_power,
        project=project,
        places=_across(width, modes),
    )


def _across(width: float, modes: HeatModes) -> NDArray[np.float64]:
    """Return places between the faces, dense enough to distinguish all modes."""
    return np.linspace(-0.5 * width, 0.5 * width, max(_PLACES_ACROSS, 2 * modes.count + 1))


def _side(given: Surroundings, conductivities: list[float]) -> float:
    """Return the coefficient of convection at the side faces [W/(m² K)]."""
    side = as_not_negative("side_convection", given.side_convection or 0.0, "W/(m^2 K)")
    if side > 0.0 and len(set(conductivities)) > 1:
        raise InvalidInput(
            "conductivity", "must be the same in all layers if side faces are cooled", f"{conductivities}"
        )
    return side


@_model.register
def _slab(_plane: CoatedPlane, inside: Inside, given: Surroundings, conductivities: list[float]) -> HeatedBody:
    if given.period is None:
        raise InvalidInput("period", "must be given for a plane: the time from one pass to the next [s]")
    period = as_positive("period", given.period, "s")
    track = None if inside.line_contact else _between_tracks(inside)
    degrees = min(int(_DEGREES_PER_CONTACT * inside.radius / contact_size(inside.result)) + 2, _MAX_DEGREES)
    power = inside.bulk_power / (inside.passing_speed * inside.radius * period)
    return _heated_slab(inside, given, conductivities, modes_of_slab(track, degrees), period, power)


def _heated_slab(
    inside: LayersInside,
    given: Surroundings,
    conductivities: list[float],
    modes: HeatModes,
    period: float,
    power: float,
) -> HeatedBody:
    """Return the thermal model of a plane with given modes across the path; a single mode is the mean."""
    require_omitted(given, ("width", "side_convection", "hub_conductance"), "a plane")
    base = (
        None
        if given.base_convection is None
        else as_not_negative("base_convection", given.base_convection, "W/(m^2 K)")
    )
    if base is not None and given.core is not Core.INSULATED:
        raise InvalidInput("core", "must be INSULATED with base_convection", shown(given.core))
    inner = inner_coefficients(given, modes, lambda: 1.0) if base is None else np.full(modes.count, base)
    film = uniform_film(given)
    require_heat_sink(power, film, inner is None or bool(inner[0] > 0.0))
    is_line = modes.count == 1

    def project(loss: xarray.Dataset) -> NDArray[np.float64]:
        density = loss.loss_density.to_numpy() / period
        if is_line:
            return np.asarray(density[:, 0][None, :])
        z = loss.z.to_numpy()
        waves = modes.values(z) * abs(z[1] - z[0])
        return np.asarray((waves @ density.T) / modes.square[:, None])

    return HeatedBody(
        inside=inside,
        conduction=Conduction(inside.body.boundaries.tolist(), conductivities, modes, film=film, inner=inner),
        inner_rise=core_rise(given),
        along="z",
        unit="W/m²" if is_line else "W/m",
        power=power,
        project=project,
    )


def _between_tracks(inside: Inside) -> float:
    """Return the distance between parallel tracks on a plane [m]: whole circumferences, same as in `Result.loss`."""
    result = inside.result
    width = result.body.width or 0.0
    return 2.0 * np.pi * inside.radius * max(1, int(np.ceil(width / (np.pi * inside.radius))))


def _interpolation(nodes: NDArray[np.float64], points: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the matrix of polynomial interpolation from nodes to points, by the barycentric formula."""
    gaps = nodes[:, None] - nodes[None, :] + np.eye(nodes.size)
    weights = 1.0 / np.prod(4.0 * gaps, axis=1)
    offsets = points[:, None] - nodes[None, :]
    hits = offsets == 0.0
    terms = weights / np.where(hits, 1.0, offsets)
    matrix: NDArray[np.float64] = terms / terms.sum(axis=1, keepdims=True)
    matrix[hits.any(axis=1)] = hits[hits.any(axis=1)]
    return matrix


def _between_nodes(
    nodes: NDArray[np.float64], values: NDArray[np.float64], places: NDArray[np.float64]
) -> NDArray[np.float64]:
    """Return values between equally spaced nodes, by cubic interpolation of four nodes; 0 beyond the nodes."""
    offsets = (places - nodes[0]) / (nodes[1] - nodes[0])
    first = np.clip(np.floor(offsets).astype(np.int_) - 1, 0, nodes.size - 4)
    t = offsets - first
    weights = np.stack(
        [
            -(t - 1) * (t - 2) * (t - 3) / 6,
            t * (t - 2) * (t - 3) / 2,
            -t * (t - 1) * (t - 3) / 2,
            t * (t - 1) * (t - 2) / 6,
        ]
    )
    there = (offsets >= 0.0) & (offsets <= nodes.size - 1.0)
    return np.asarray(np.einsum("ip,ipd->pd", weights * there, values[first + np.arange(4)[:, None]]))
