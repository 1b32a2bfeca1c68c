"""Displacement, strain and stress inside the coating, from the tractions of a solved contact."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .. import _core
from .._core import Curvature
from .._support.arguments import as_float, as_float_array, as_int, as_orders, require_type
from .._support.cautions import warn
from .._support.extras import extra
from .._support.progress import ProgressLike, reporting
from .._support.text import shown
from ..bodies import CoatedSphere, require_ball
from .solution import Solution, described, given_of, node_angles

if TYPE_CHECKING:
    import xarray
    from numpy.typing import ArrayLike, NDArray

__all__ = [
    "COMPONENTS",
    "DIRECTIONS",
    "bonds",
    "coated_ball",
    "interior",
    "order_fields",
    "places_of",
    "tractions_of",
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


def coated_ball(result: Solution) -> CoatedSphere:
    """Return the ball of a result, whose coating there is to look into.

    Raises
    ------
    TypeError
        For rollers and wheels.
    ValueError
        For a rigid ball.
    """
    ball = result.ball
    require_ball("result.ball", ball, "what happens inside")
    assert isinstance(ball, CoatedSphere)
    if not ball.layers:
        raise ValueError("result.ball must have a layer, for there to be an inside, got none")
    return ball


def tractions_of(result: Solution) -> _core.Tractions:
    """Return the tractions of a result, as the core knows them."""
    return _core.Tractions(
        mesh=result.mesh._to_core(),
        pressure=np.ascontiguousarray(result.pressure),
        shear_traction=np.ascontiguousarray(result.shear_traction),
        friction=result.friction > 0.0,
        compliance=result.compliance,
        curvature=result.curvature,
        patch_load=result.patch_load,
    )


def places_of(
    ball: CoatedSphere, depth: ArrayLike | None, radius: ArrayLike | None
) -> tuple[NDArray[np.float64], NDArray[np.int32]]:
    """Return radii and layers of places given by depth or radius: two where layers meet.

    Raises
    ------
    TypeError, ValueError
        Unless exactly one of the two is given, as real numbers within the layers.
    """
    if (depth is None) == (radius is None):
        raise ValueError("exactly one of depth and radius must be given")
    if depth is None:
        assert radius is not None
        return _core.places_at(ball._to_core(), _line("radius", radius))
    below = _line("depth", depth)
    if below.size and not (below.min() >= 0.0 and below.max() <= ball.thickness * (1.0 + 1e-12)):
        raise ValueError(f"depth must be in [0, {ball.thickness:g}] m, got {below.min():g} to {below.max():g}")
    # The innermost radius is the core's to the last bit.
    radii = np.where(below >= ball.thickness * (1.0 - 1e-12), ball.core_radius, ball.outer_radius - below)
    return _core.places_at(ball._to_core(), np.clip(radii, ball.core_radius, None))


def order_fields(
    ball: CoatedSphere,
    angular_speed: float,
    m: ArrayLike,
    n: ArrayLike,
    *,
    radius: ArrayLike,
    curvature: Curvature = Curvature.SPHERE,
) -> tuple[NDArray[np.complex128], NDArray[np.complex128], NDArray[np.complex128]]:
    """Fields of single orders (m, n) inside the layers, per unit surface stress.

    Parameters
    ----------
    ball : CoatedSphere
        Core and layers.
    angular_speed : float
        Ω [rad/s], > 0.
    m, n : array_like of int
        Orders of any sign, of one length.
    radius : array_like
        r [m]; a radius where layers meet comes twice, the outer layer first.
    curvature : Curvature, default Curvature.SPHERE
        SPHERE or PAPER.

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
    require_type("ball", ball, CoatedSphere)
    require_type("curvature", curvature, Curvature)
    places = places_of(ball, None, radius)
    orders = [np.atleast_1d(as_orders(name, values)).ravel() for name, values in (("m", m), ("n", n))]
    values = _core.order_fields(
        ball._to_core(),
        *orders,
        radius=places[0],
        layer=places[1],
        angular_speed=as_float("angular_speed", angular_speed),
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
    threads: int = 0,
    progress: ProgressLike = None,
) -> xarray.Dataset:
    """Displacement, strain and stress inside the coating.

    Parameters
    ----------
    depth : array_like
        Below the surface [m], within the coating; or `radius`. Where layers meet, strains and stresses along the
        surface jump: such a depth comes twice, the outer layer first, see the coordinate `layer`.
    radius : array_like
        r [m], in place of `depth`.
    phi, theta : array_like, optional
        Angles [rad] within half a revolution of the lowest point, π/2; by default those of the nodes.
        ``theta=[π/2]`` with many depths is the section through the contact.
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
        `shear_traction` [Pa].

    Raises
    ------
    TypeError, ValueError
        For bad input; also with curvature EXACT, which has no orders (m, n).
    ImportError
        Without the extra `viscoroll[files]`.

    Warns
    -----
    ResultWarning
        For depths where the mesh is too coarse: less than a quarter of a spacing, between nodes half of one.

    Notes
    -----
    Stresses are those of the compliance of the solve. With VERTICAL pressure acts along the plane's normal and so
    has a share along the coating, up to p x/r_o, which raises the largest von Mises stress near the surface.

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

    ball = coated_ball(result)
    radii, layers = places_of(ball, depth, radius)
    on_nodes = phi is None and theta is None
    angles = [
        node_angles(result)[axis] if given is None else _line(name, given)
        for axis, (name, given) in enumerate((("phi", phi), ("theta", theta)))
    ]
    with reporting(progress) as report:
        values = _core.interior_fields(
            ball._to_core(),
            tractions_of(result),
            radius=radii,
            layer=layers,
            phi=angles[0],
            theta=angles[1],
            angular_speed=result.angular_speed,
            threads=as_int("threads", threads),
            progress=report,
        )
    _warn_of_shallow_places(result, radii, on_nodes)
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
            "depth": ("depth", ball.outer_radius - radii, {"units": "m"}),
            "radius": ("depth", radii, {"units": "m"}),
            "layer": ("depth", layers, {"long_name": "number of the layer, from the center outwards"}),
            "phi": ("phi", angles[0], {"units": "rad"}),
            "theta": ("theta", angles[1], {"units": "rad"}),
            "direction": list(DIRECTIONS),
            "component": list(COMPONENTS),
            "principal": [1, 2, 3],
        },
        attrs=given_of(result) | {"outer_radius": ball.outer_radius},
    )


def bonds(result: Solution, *, threads: int = 0, progress: ProgressLike = None) -> xarray.Dataset:
    """Fields where layers are bonded, to the core and to one another: what debonds.

    Parameters
    ----------
    threads, progress
        As of `interior`.

    Returns
    -------
    xarray.Dataset
        As of `interior`, at the core of a ball with a rigid one, and on both sides of every boundary between
        layers.

    Raises
    ------
    ValueError
        Where nothing is bonded to anything.
    """
    ball = coated_ball(result)
    radii = ball.core_radius + np.concatenate([[0.0], np.cumsum([layer.thickness for layer in ball.layers])])
    bonded = radii[:-1] if ball.inner_boundary is _core.InnerBoundary.RIGID else radii[1:-1]
    if not bonded.size:
        raise ValueError("ball must have a rigid core or several layers, for anything to be bonded")
    return interior(result, radius=bonded, threads=threads, progress=progress)


def _line(name: str, values: ArrayLike) -> NDArray[np.float64]:
    array = np.atleast_1d(as_float_array(name, values))
    if array.ndim != 1:
        raise ValueError(f"{name} must be one-dimensional, got shape {array.shape}")
    if not np.isfinite(array).all():
        raise ValueError(f"{name} must be finite, got {shown(array[~np.isfinite(array)][0])}")
    return np.ascontiguousarray(array)


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


def _warn_of_shallow_places(result: Solution, radii: NDArray[np.float64], on_nodes: bool) -> None:
    """Near the surface the pressure's steps from patch to patch show, at nodes less than between them."""
    spacing = result.ball.outer_radius * max(result.mesh.spacing, result.mesh.theta_spacing)
    share, where = (0.25, "a quarter") if on_nodes else (0.5, "half")
    depths = result.ball.outer_radius - radii
    if depths.size and depths.min() < share * spacing * (1.0 - 1e-9):
        shallow = f"depth {depths.min():.3g} m is less than {where} of a spacing of the mesh, {share * spacing:.3g} m"
        steps = "stresses there show the steps of the pressure from patch to patch; a finer mesh has them smaller"
        warn([f"{shallow}: {steps}"])
