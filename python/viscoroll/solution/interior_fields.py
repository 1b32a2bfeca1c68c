"""Displacement, strain and stress inside the layers, from the tractions of a solved contact."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from .. import _core
from .._core import Curvature
from .._support.arguments import as_float, as_int, as_orders, require_type
from .._support.errors import InvalidInput
from .._support.extras import extra
from .._support.progress import ProgressLike, Report, reporting
from .._support.result_warnings import warn
from ..bodies import CoatedCylinder, CoatedPlane, CoatedSphere, CoatedWheel
from .inside import BodyInside, Inside, LayersInside, Of, finite_line, inside_of, places_of
from .solution import Solution, described, given_of

if TYPE_CHECKING:
    import xarray
    from numpy.typing import ArrayLike, NDArray

__all__ = [
    "COMPONENTS",
    "DIRECTIONS",
    "bonds",
    "fields_in_layers",
    "interior",
    "order_fields",
    "place_coordinates",
    "strains",
    "warn_of_shallow_places",
]

#: Components of vectors and of symmetric tensors, in the order of the arrays.
DIRECTIONS = ("r", "phi", "theta")
COMPONENTS = ("rr", "phiphi", "thetatheta", "rphi", "rtheta", "phitheta")

_TEXT = {
    "displacement": ("m", "displacement"),
    "stress": ("Pa", "stress, tension positive"),
    "strain": ("1", "strain"),
    "von_mises": ("Pa", "von Mises stress"),
    "principal_stress": ("Pa", "principal stresses, the largest tension first"),
    "hydrostatic_pressure": ("Pa", "hydrostatic pressure"),
    "opening_traction": ("Pa", "tensile normal traction on the surface r = const, 0 under pressure"),
    "shear_traction": ("Pa", "shear traction on the surface r = const"),
}


def order_fields(
    body: BodyInside,
    angular_speed: float,
    m: ArrayLike,
    n: ArrayLike,
    *,
    depth: ArrayLike | None = None,
    radius: ArrayLike | None = None,
    rolling_radius: float | None = None,
    curvature: Curvature = Curvature.SPHERE,
) -> tuple[NDArray[np.complex128], NDArray[np.complex128], NDArray[np.complex128]]:
    """Return the fields of single orders (m, n) inside the layers, per unit surface stress.

    Parameters
    ----------
    body : CoatedSphere or CoatedCylinder or CoatedPlane or CoatedWheel
        Body with layers. A wheel is taken as a tread without side faces or crown.
    angular_speed : float
        Angular speed Ω of the body, or for a plane that of the rolling body [rad/s], > 0.
    m, n : array_like of int
        Orders of any sign, in arrays of the same length; n is 0 in a cylinder. In a wheel, the wavenumber along the
        axis is n/outer_radius.
    depth, radius : array_like
        Depth below the surface, or radius r except in a plane [m]. A boundary between layers appears twice, first for
        the outer layer.
    rolling_radius : float, optional
        Radius of the rolling body [m], > 0; required for a plane, in which the order m is the wavenumber
        m/rolling_radius.
    curvature : Curvature, default Curvature.SPHERE
        SPHERE or PAPER; used only for a sphere.

    Returns
    -------
    displacement, stress, strain : ndarray of complex
        Fields in [m/Pa], [-] and [1/Pa], of shape (orders, places, 3 or 6, 3). The last index is the direction of the
        surface stress, (r, φ, θ); components are in the order of `COMPONENTS`.

    Raises
    ------
    TypeError, ValueError
        If an argument is invalid.

    Examples
    --------
    >>> from viscoroll import paper
    >>> displacement, stress, _ = order_fields(paper.ball(), 2.5, [30], [0], radius=[20e-3, 21e-3])
    >>> bool(abs(displacement[0, 0]).max() == 0.0)  # on the rigid core
    True
    >>> print(f"{abs(stress[0, 0, 0, 0]):.2f}")  # radial stress at the core
    0.75
    """
    require_type("body", body, CoatedSphere | CoatedCylinder | CoatedPlane | CoatedWheel)
    require_type("curvature", curvature, Curvature)
    if body.is_flat == (rolling_radius is None):
        raise InvalidInput("rolling_radius", "must be given if and only if the body is a plane")
    places = places_of(body, depth, radius)
    orders = [np.atleast_1d(as_orders(name, values)).ravel() for name, values in (("m", m), ("n", n))]
    values = _core.order_fields(
        body._to_core(),
        *orders,
        position=places[0],
        layer=places[1],
        angular_speed=as_float("angular_speed", angular_speed),
        radius=as_float("rolling_radius", rolling_radius) if body.is_flat else body.surface,
        curvature=curvature,
    )
    return values[:, :, :3], values[:, :, 3:9], values[:, :, 9:]


def interior(
    result: Solution,
    *,
    depth: ArrayLike | None = None,
    radius: ArrayLike | None = None,
    phi: ArrayLike | None = None,
    theta: ArrayLike | None = None,
    of: Of | None = None,
    max_order: float | None = None,
    threads: int = 0,
    progress: ProgressLike = None,
) -> xarray.Dataset:
    """Return displacement, strain and stress inside the layers of the rolling body or the counterbody.

    Parameters
    ----------
    depth : array_like
        Depth below the surface [m], within the layers; or `radius`. At a boundary between layers, strains and stresses
        along the surface are discontinuous. Such a depth appears twice, first for the outer layer; see the coordinate
        `layer`.
    radius : array_like
        Radius r [m], in place of `depth`; not in a plane.
    phi, theta : array_like, optional
        Angles [rad], by default those of the nodes. Their distance from the lowest point, π/2, must be at most half a
        revolution; for φ in a plane at most a third of a revolution; for θ in a plane or a wheel, where θ is an arc
        divided by a radius, at most one revolution. ``theta=[π/2]`` is the section through the contact, the only
        section in line contact.
    of : "body" or "counterbody", optional
        Rolling body or counterbody. By default the deformable body; if both deform, the rolling body.
    max_order : float, optional
        Order at which the sum ends smoothly, > 0. By default the sum ends where the orders have decayed at the depth. A
        lower order saves time at small depths. The steps of the pressure from patch to patch belong to orders above π
        divided by the spacing [rad].
    threads : int, default 0
        Number of threads; 0 for all cores.
    progress : bool or callable, optional
        True shows a progress bar; a callable is called as progress(stage, fraction) about every 20 ms.

    Returns
    -------
    xarray.Dataset
        Variables over (depth, phi, theta): `displacement` [m] by `direction`, `stress` [Pa] (tension positive) and
        `strain` [-] by `component`; from these `von_mises`, `principal_stress` (largest first), `hydrostatic_pressure`,
        and the traction on the surface r = const: its tension `opening_traction`, 0 under compression, and its shear
        `shear_traction` [Pa]. Coordinates `x` and `z` are arcs forward and sideways from the middle of the contact [m].
        In either body, r points out of the body, φ points backward, in the direction in which its material moves, and θ
        points to -z. In a plane, φ and θ are arcs divided by the radius of the rolling body; in a wheel, θ is z divided
        by the outer radius.

    Raises
    ------
    TypeError, ValueError
        If an argument is invalid; also with curvature EXACT, which has no orders (m, n).
    ImportError
        If the extra `viscoroll[files]` is missing.

    Warns
    -----
    ResultWarning
        If a depth is too small for the mesh: less than a quarter of a node spacing, or half of one between nodes. If
        the contact of a wheel with free sides is nearer to a face than the thickness of the tread, because the fields
        are those of a tread that continues beyond its faces.

    Notes
    -----
    Stresses are those of the compliance of the solve. With VERTICAL, the pressure acts along the normal of the plane.
    Its component along the coating, up to p x/r_o, raises the largest von Mises stress near the surface. In line
    contact, the displacement of a half-plane is infinite, and NaN is returned.

    Examples
    --------
    >>> from viscoroll import Mesh, paper, solve
    >>> r = solve(paper.ball(), load=100.0, angular_speed=2.5, mesh=Mesh(nodes_per_revolution=400))
    >>> inside = r.interior(depth=[0.3e-3, 1e-3])
    >>> print(f"{inside.von_mises.max().item() / 1e6:.1f} MPa")
    3.8 MPa
    """
    with extra("files"):
        import xarray

    inside = inside_of(result, of)
    positions, layers = inside.places(depth, radius)
    on_nodes = phi is None and theta is None
    phi, theta = (
        inside.node_angles()[axis] if given is None else finite_line(name, given)
        for axis, (name, given) in enumerate((("phi", phi), ("theta", theta)))
    )
    order = None if max_order is None else as_float("max_order", max_order)
    with reporting(progress) as report:
        values = _values(inside, (positions, layers), phi, theta, order, as_int("threads", threads), report)
    along, across = inside.node_spacings()
    spacing = inside.radius * max(along, 0.0 if inside.line_contact else across)
    warn_of_shallow_places(spacing, inside.depth(positions), on_nodes)
    inside.warn_of_sides()
    if inside.line_contact and not np.isfinite(inside.thickness):
        values[:, :3] = np.nan
    coordinates = {
        **place_coordinates(inside, positions),
        "layer": ("depth", layers, {"long_name": "number of the layer, from the center or the base outwards"}),
        "phi": ("phi", phi, {"units": "rad"}),
        "theta": ("theta", theta, {"units": "rad"}),
        "x": ("phi", inside.radius * (0.5 * np.pi - phi), {"units": "m", "long_name": "arc length forward"}),
        "z": ("theta", inside.radius * (0.5 * np.pi - theta), {"units": "m", "long_name": "arc length sideways"}),
    }
    attributes = (
        given_of(result)
        | {"of": inside.of, "body": type(inside.body).__name__}
        | ({"outer_radius": inside.radius} if inside.has_radius else {})
    )
    return fields_in_layers(xarray.Dataset, values, ("depth", "phi", "theta"), coordinates, attributes)


def fields_in_layers(
    dataset: type[xarray.Dataset],
    values: NDArray[np.float64],
    where: tuple[str, str, str],
    coordinates: dict[str, Any],
    attributes: dict[str, Any],
) -> xarray.Dataset:
    """Return the dataset of displacement, strain, stress and what follows from them.

    Parameters
    ----------
    dataset : type
        The class `xarray.Dataset`.
    values : ndarray, shape (places, 15, points along, points across)
        Components of displacement, stress and strain.
    where : tuple of str
        Names of the dimensions of places and points.
    coordinates, attributes : dict
        Coordinates of the places and points, and attributes of the dataset.
    """
    fields = np.moveaxis(values, 1, 0)
    displacement, stress, strain = fields[:3], fields[3:9], fields[9:]
    variables = {
        "displacement": (("direction", *where), displacement),
        "stress": (("component", *where), stress),
        "strain": (("component", *where), strain),
        "von_mises": (where, _von_mises(stress)),
        "principal_stress": (("principal", *where), _principal(stress)),
        "hydrostatic_pressure": (where, -stress[:3].mean(axis=0)),
        "opening_traction": (where, np.maximum(stress[0], 0.0)),
        "shear_traction": (where, np.hypot(stress[3], stress[4])),
    }
    return dataset(
        {name: (*variable, described(*_TEXT[name])) for name, variable in variables.items()},
        coordinates | {"direction": list(DIRECTIONS), "component": list(COMPONENTS), "principal": [1, 2, 3]},
        attrs=attributes,
    )


def strains(
    inside: Inside,
    depth: NDArray[np.float64],
    phi: NDArray[np.float64],
    theta: NDArray[np.float64],
    *,
    max_order: float | None = None,
) -> NDArray[np.float64]:
    """Return the strain of `interior` [-], of shape (places, 6, phi, theta); a layer boundary counts as two places."""
    return _values(inside, inside.places(depth), phi, theta, max_order, 0, None)[:, 9:]


def _values(
    inside: Inside,
    places: tuple[NDArray[np.float64], NDArray[np.int32]],
    phi: NDArray[np.float64],
    theta: NDArray[np.float64],
    max_order: float | None,
    threads: int,
    report: Report | None,
) -> NDArray[np.float64]:
    """Return all field components, of shape (places, 15, phi, theta)."""
    return _core.interior_fields(
        inside.body._to_core(),
        inside.tractions(),
        position=places[0],
        layer=places[1],
        phi=phi,
        theta=theta,
        angular_speed=inside.result.angular_speed,
        max_order=max_order,
        threads=threads,
        progress=report,
    )


def place_coordinates(
    inside: LayersInside, positions: NDArray[np.float64]
) -> dict[str, tuple[str, NDArray[np.float64], dict[str, str]]]:
    """Return the coordinates of places along the normal: depth [m], and the radius r [m] except in a plane."""
    coordinates = {"depth": ("depth", inside.depth(positions), {"units": "m"})}
    return coordinates | ({"radius": ("depth", positions, {"units": "m"})} if inside.has_radius else {})


def bonds(result: Solution, *, of: Of | None = None, threads: int = 0, progress: ProgressLike = None) -> xarray.Dataset:
    """Return the fields at all bonds, between layers and to a core or base, where debonding may occur.

    Parameters
    ----------
    of, threads, progress
        Same as in `interior`.

    Returns
    -------
    xarray.Dataset
        Same as in `interior`, at the rigid core or base if there is one, and on both sides of every boundary between
        layers.

    Raises
    ------
    ValueError
        If the body has no bond.
    """
    inside = inside_of(result, of)
    depths = inside.depth(inside.bonded())
    if not depths.size:
        body = "result.body" if inside.of == "body" else "result.on"
        raise InvalidInput(body, "must have a rigid core, a rigid base or several layers to have bonds")
    return interior(result, depth=depths, of=inside.of, threads=threads, progress=progress)


def _von_mises(stress: NDArray[np.float64]) -> NDArray[np.float64]:
    rr, pp, tt, rp, rt, pt = stress
    normal = (rr - pp) ** 2 + (pp - tt) ** 2 + (tt - rr) ** 2
    von_mises: NDArray[np.float64] = np.sqrt(0.5 * normal + 3.0 * (rp**2 + rt**2 + pt**2))
    return von_mises


def _principal(stress: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the principal stresses, the largest first."""
    rr, pp, tt, rp, rt, pt = stress
    matrices = np.stack([rr, rp, rt, rp, pp, pt, rt, pt, tt], axis=-1).reshape(*rr.shape, 3, 3)
    return np.moveaxis(np.linalg.eigvalsh(matrices)[..., ::-1], -1, 0)


def warn_of_shallow_places(spacing: float, depths: NDArray[np.float64], on_nodes: bool) -> None:
    """Warn of depths at which the stresses show the steps of the pressure from patch to patch."""
    fraction, where = (0.25, "a quarter") if on_nodes else (0.5, "half")
    if depths.size and depths.min() < fraction * spacing * (1.0 - 1e-9):
        shallow = f"depth {depths.min():.3g} m is less than {where} of the node spacing, {fraction * spacing:.3g} m"
        steps = "stresses there show the pressure steps between patches; refine the mesh to reduce them"
        warn([f"{shallow}: {steps}"])
