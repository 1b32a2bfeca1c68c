"""Displacement, strain and stress inside layers, from the tractions of a solved contact."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .. import _core
from .._core import Curvature
from .._support.arguments import as_float, as_int, as_orders, require_type
from .._support.cautions import warn
from .._support.extras import extra
from .._support.progress import ProgressLike, Report, reporting
from ..bodies import CoatedCylinder, CoatedPlane, CoatedSphere, CoatedWheel
from .inside import BodyInside, Inside, Of, finite_line, inside_of, places_of
from .solution import Solution, described, given_of

if TYPE_CHECKING:
    import xarray
    from numpy.typing import ArrayLike, NDArray

__all__ = [
    "COMPONENTS",
    "DIRECTIONS",
    "bonds",
    "interior",
    "order_fields",
    "strains",
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
    "opening_traction": ("Pa", "tension across the surface r = const, where there is any"),
    "shear_traction": ("Pa", "shear on the surface r = const"),
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
    """Fields of single orders (m, n) inside the layers, per unit surface stress.

    Parameters
    ----------
    body : CoatedSphere or CoatedCylinder or CoatedPlane or CoatedWheel
        Layers; of a wheel those of a tread without sides or crown.
    angular_speed : float
        Ω of the body, of a plane that of what rolls [rad/s], > 0.
    m, n : array_like of int
        Orders of any sign, of one length; n is 0 in a cylinder. Across a wheel the wave number is n/outer_radius.
    depth, radius : array_like
        Depth below the surface or, but in a plane, r [m]; where layers meet it comes twice, the outer layer first.
    rolling_radius : float, optional
        Of what rolls [m], > 0: in a plane the order m is a wave number m/rolling_radius.
    curvature : Curvature, default Curvature.SPHERE
        SPHERE or PAPER, of a sphere.

    Returns
    -------
    displacement, stress, strain : ndarray of complex
        [m/Pa], [-] and [1/Pa], of shape (orders, places, 3 or 6, 3); the last index is the direction of the surface
        stress, (r, φ, θ), and components are ordered as in `COMPONENTS`.

    Raises
    ------
    TypeError, ValueError
        For bad input.

    Examples
    --------
    >>> from viscoroll import paper
    >>> displacement, stress, _ = order_fields(paper.ball(), 2.5, [30], [0], radius=[20e-3, 21e-3])
    >>> bool(abs(displacement[0, 0]).max() == 0.0)  # on the rigid core
    True
    >>> print(f"{abs(stress[0, 0, 0, 0]):.2f}")  # of the radial stress, what reaches the core
    0.75
    """
    require_type("body", body, CoatedSphere | CoatedCylinder | CoatedPlane | CoatedWheel)
    require_type("curvature", curvature, Curvature)
    if isinstance(body, CoatedPlane) == (rolling_radius is None):
        raise ValueError("rolling_radius must be given with a plane, and with a plane alone")
    places = places_of(body, depth, radius)
    orders = [np.atleast_1d(as_orders(name, values)).ravel() for name, values in (("m", m), ("n", n))]
    values = _core.order_fields(
        body._to_core(),
        *orders,
        position=places[0],
        layer=places[1],
        angular_speed=as_float("angular_speed", angular_speed),
        radius=as_float("rolling_radius", rolling_radius) if isinstance(body, CoatedPlane) else body.outer_radius,
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
    """Displacement, strain and stress inside the layers of what rolls, or of what it rolls on.

    Parameters
    ----------
    depth : array_like
        Below the surface [m], within the layers; or `radius`. Where layers meet, strains and stresses along the
        surface jump: such a depth comes twice, the outer layer first, see the coordinate `layer`.
    radius : array_like
        r [m], in place of `depth`; not in a plane.
    phi, theta : array_like, optional
        Angles [rad] within half a revolution of the lowest point, π/2, φ in a plane a third of one; θ in a plane or
        a wheel, where it is an arc per radius, a whole one. By default those of the nodes. ``theta=[π/2]`` with many
        depths is the section through the contact; under a line there is no other.
    of : "ball" or "counterpart", optional
        What rolls, or what it rolls on; by default the one that deforms, of two what rolls.
    max_order : float, optional
        Order at which the sum ends, smoothly, > 0; by default where an order has died out at a depth. Shallow places
        are faster with it, and the steps of the pressure from patch to patch lie above π per spacing.
    threads : int, default 0
        Number of threads; 0 for all cores.
    progress : bool or callable, optional
        True shows a bar; or called as progress(stage, fraction) about every 20 ms.

    Returns
    -------
    xarray.Dataset
        Over (depth, phi, theta): `displacement` [m] by `direction`, `stress` [Pa] (tension positive) and `strain`
        [-] by `component`, and of them `von_mises`, `principal_stress` (largest first), `hydrostatic_pressure`,
        and the traction on the surface r = const: `opening_traction`, its tension where there is any, and
        `shear_traction` [Pa]. Coordinates `x` and `z` are arcs forward and sideways from the middle of the contact [m].
        In either body r points out of it, φ is the way of its material, backward, and θ points to -z; in a plane φ and
        θ are arcs per radius of what rolls, in a wheel θ is z per outer radius.

    Raises
    ------
    TypeError, ValueError
        For bad input; also with curvature EXACT, which has no orders (m, n).
    ImportError
        Without the extra `viscoroll[files]`.

    Warns
    -----
    ResultWarning
        For depths where the mesh is too coarse: less than a quarter of a spacing, between nodes half of one. For a
        wheel with free sides nearer to the contact than its tread is thick, whose fields are those of a tread that goes
        on.

    Notes
    -----
    Stresses are those of the compliance of the solve. With VERTICAL pressure acts along the plane's normal and so
    has a share along the coating, up to p x/r_o, which raises the largest von Mises stress near the surface.
    Under a line the displacement of a half-plane is not there (NaN): it is infinite.

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
    _warn_of_shallow_places(inside, inside.depth(positions), on_nodes)
    inside.warn_of_sides()
    if inside.line_contact and not np.isfinite(inside.thickness):
        values[:, :3] = np.nan
    fields = np.moveaxis(values, 1, 0)
    displacement, stress, strain = fields[:3], fields[3:9], fields[9:]
    where = ("depth", "phi", "theta")
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
    return xarray.Dataset(
        {name: (*variable, described(*_TEXT[name])) for name, variable in variables.items()},
        {
            **place_coordinates(inside, positions),
            "layer": ("depth", layers, {"long_name": "number of the layer, from the center or the base outwards"}),
            "phi": ("phi", phi, {"units": "rad"}),
            "theta": ("theta", theta, {"units": "rad"}),
            "x": ("phi", inside.radius * (0.5 * np.pi - phi), {"units": "m", "long_name": "arc forward"}),
            "z": ("theta", inside.radius * (0.5 * np.pi - theta), {"units": "m", "long_name": "arc sideways"}),
            "direction": list(DIRECTIONS),
            "component": list(COMPONENTS),
            "principal": [1, 2, 3],
        },
        attrs=given_of(result)
        | {"of": inside.of, "body": type(inside.body).__name__}
        | ({"outer_radius": inside.radius} if inside.turns else {}),
    )


def strains(
    inside: Inside,
    depth: NDArray[np.float64],
    phi: NDArray[np.float64],
    theta: NDArray[np.float64],
    *,
    max_order: float | None = None,
) -> NDArray[np.float64]:
    """Return the strain of `interior` alone [-], of shape (places, 6, phi, theta); two places where layers meet."""
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
    """Return all components, of shape (places, 15, phi, theta)."""
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
    inside: Inside, positions: NDArray[np.float64]
) -> dict[str, tuple[str, NDArray[np.float64], dict[str, str]]]:
    """Return coordinates of places along the normal: depth, and but in a plane r."""
    coordinates = {"depth": ("depth", inside.depth(positions), {"units": "m"})}
    return coordinates | ({"radius": ("depth", positions, {"units": "m"})} if inside.turns else {})


def bonds(result: Solution, *, of: Of | None = None, threads: int = 0, progress: ProgressLike = None) -> xarray.Dataset:
    """Fields where layers are bonded, to a core or a base and to one another: what debonds.

    Parameters
    ----------
    of, threads, progress
        As of `interior`.

    Returns
    -------
    xarray.Dataset
        As of `interior`, at the rigid core or base where there is one, and on both sides of every boundary between
        layers.

    Raises
    ------
    ValueError
        Where nothing is bonded to anything.
    """
    inside = inside_of(result, of)
    depths = inside.depth(inside.bonded())
    if not depths.size:
        body = "result.ball" if inside.of == "ball" else "result.on"
        raise ValueError(f"{body} must have a rigid core or base, or several layers, for anything to be bonded")
    return interior(result, depth=depths, of=inside.of, threads=threads, progress=progress)


def _von_mises(stress: NDArray[np.float64]) -> NDArray[np.float64]:
    rr, pp, tt, rp, rt, pt = stress
    normal = (rr - pp) ** 2 + (pp - tt) ** 2 + (tt - rr) ** 2
    von_mises: NDArray[np.float64] = np.sqrt(0.5 * normal + 3.0 * (rp**2 + rt**2 + pt**2))
    return von_mises


def _principal(stress: NDArray[np.float64]) -> NDArray[np.float64]:
    """Principal values, the largest first."""
    rr, pp, tt, rp, rt, pt = stress
    matrices = np.stack([rr, rp, rt, rp, pp, pt, rt, pt, tt], axis=-1).reshape(*rr.shape, 3, 3)
    return np.moveaxis(np.linalg.eigvalsh(matrices)[..., ::-1], -1, 0)


def _warn_of_shallow_places(inside: Inside, depths: NDArray[np.float64], on_nodes: bool) -> None:
    """Near the surface the pressure's steps from patch to patch show, at nodes less than between them."""
    along, across = inside.node_spacings()
    spacing = inside.radius * max(along, 0.0 if inside.line_contact else across)
    share, where = (0.25, "a quarter") if on_nodes else (0.5, "half")
    if depths.size and depths.min() < share * spacing * (1.0 - 1e-9):
        shallow = f"depth {depths.min():.3g} m is less than {where} of a spacing of the mesh, {share * spacing:.3g} m"
        steps = "stresses there show the steps of the pressure from patch to patch; a finer mesh has them smaller"
        warn([f"{shallow}: {steps}"])
