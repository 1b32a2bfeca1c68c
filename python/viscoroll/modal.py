"""Response of the layers to single orders (m, n) of the two-variable Fourier series, and influence tables.

A field Σ f_mn(r) exp(i(mφ + nθ)) is steady in space while the material turns. A material point therefore experiences
order m at the angular frequency mΩ. Components are in the order (r, φ, θ).
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, TypeVar

import numpy as np

from . import _core
from ._core import Curvature
from ._support.arguments import as_float, as_float_array, as_int, as_member, as_orders, require_type
from ._support.errors import InvalidInput
from ._support.progress import ProgressLike, reporting
from ._support.text import shown
from .bodies import CoatedSphere, CoatedWheel, Layer, Mesh, RollingBody

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

_First = TypeVar("_First", bound=np.generic)
_Second = TypeVar("_Second", bound=np.generic)

__all__ = [
    "centrifugal_displacement",
    "critical_speed",
    "degree_compliance",
    "influence_tables",
    "state_matrix",
    "surface_compliance",
]


def surface_compliance(
    body: CoatedSphere | CoatedWheel,
    angular_speed: float,
    m: ArrayLike,
    n: ArrayLike,
    *,
    curvature: Curvature | str = Curvature.SPHERE,
) -> NDArray[np.complex128]:
    """Surface compliance of single orders: displacement per surface stress.

    Parameters
    ----------
    body : CoatedSphere or CoatedWheel
        Ball with a rigid core and layers, or a wheel, whose tread is taken without side faces, with the curvature of
        its crown.
    angular_speed : float
        Angular speed Ω [rad/s], > 0.
    m, n : array_like of int
        Orders in φ and θ, of any sign, with shapes that broadcast. For a wheel, `n` contains the wavenumbers k along
        its axis [1/m], which are real numbers.
    curvature : Curvature or str, default Curvature.SPHERE
        Membrane stiffness of a sphere, or that of the paper (PAPER); EXACT is not allowed, because the exact sphere has
        no orders (m, n). Without effect on a wheel, whose equations keep all curvature terms.

    Returns
    -------
    ndarray of complex, shape (..., 3, 3)
        C_mn [m/Pa]: d_mn(r_o) = C_mn f_mn(r_o), rows and columns in the order (r, φ, θ), or (r, φ, z) for a wheel.

    Raises
    ------
    TypeError
        If an argument has the wrong type, or an order is not an integer.
    ValueError
        If an argument is out of range, or the speed is at or above the critical one.

    References
    ----------
    Equation (31) of the paper, computed by a recursion that carries the compliance from the core outwards and therefore
    neither overflows nor loses digits.

    Examples
    --------
    >>> from viscoroll import Elastic, Layer, CoatedSphere
    >>> layer = Layer(thickness=1e-3, shear_modulus=Elastic(modulus=1.0), poisson_ratio=0.5)
    >>> ball = CoatedSphere(core_radius=20e-3, layers=[layer])
    >>> surface_compliance(ball, 1.0, [10, 20], 0).shape
    (2, 3, 3)
    """
    require_type("body", body, CoatedSphere | CoatedWheel)
    curvature = as_member("curvature", curvature, Curvature)
    # Across a ball, orders are integers as along the path; across a wheel, they are wavenumbers.
    is_ball = body.curved_directions == 2
    given: Any = as_orders("n", n) if is_ball else as_float_array("n", n)
    orders, across = _broadcast("m and n", as_orders("m", m), given)
    core: Any = body._to_core()
    compliance: NDArray[np.complex128] = _core.surface_compliance(
        core,
        _flat(orders),
        _flat(across),
        angular_speed=as_float("angular_speed", angular_speed),
        **({"curvature": curvature} if is_ball else {}),
    )
    return compliance.reshape(*orders.shape, 3, 3)


def degree_compliance(
    ball: CoatedSphere, angular_speed: float, degree: ArrayLike, order: ArrayLike
) -> NDArray[np.complex128]:
    """Surface compliance of the exact sphere without inertia: displacement per surface stress of single harmonics.

    The harmonics are the vector spherical harmonics Y, Ψ = r∇Y/√(l(l+1)) and Φ = e_r × Ψ about the rolling axis.

    Parameters
    ----------
    ball : CoatedSphere
        Core and layers; densities have no effect.
    angular_speed : float
        Angular speed Ω [rad/s], > 0.
    degree, order : array_like of int
        Degrees l ≥ 0 and orders m, |m| ≤ l, with shapes that broadcast. The material experiences the frequency mΩ.

    Returns
    -------
    ndarray of complex, shape (..., 3, 3)
        Compliance [m/Pa], rows and columns in the order (Y, Ψ, Φ). Degree 0 has only Y. Without a core, degree 1 is the
        response without rigid motions: a uniform force on the volume balances the loads, and the mean displacement of
        the volume and the mean rotation of the surface are 0.

    Raises
    ------
    TypeError
        If an argument has the wrong type.
    ValueError
        If an argument is out of range.

    Examples
    --------
    >>> from viscoroll import Elastic, Layer, CoatedSphere
    >>> layer = Layer(thickness=1e-3, shear_modulus=Elastic(modulus=1.0), poisson_ratio=0.5)
    >>> ball = CoatedSphere(core_radius=20e-3, layers=[layer])
    >>> degree_compliance(ball, 1.0, [10, 20], 0).shape
    (2, 3, 3)
    """
    require_type("ball", ball, CoatedSphere)
    degrees, orders = _broadcast("degree and order", as_orders("degree", degree), as_orders("order", order))
    compliance = _core.degree_compliance(
        ball._to_core(),
        _flat(degrees),
        _flat(orders),
        angular_speed=as_float("angular_speed", angular_speed),
    )
    return compliance.reshape(*degrees.shape, 3, 3)


def state_matrix(
    layer: Layer, angular_speed: float, radius: float, m: int, n: int, *, curvature: Curvature | str = Curvature.SPHERE
) -> NDArray[np.complex128]:
    """Matrix B of the layer's equations dz/d(ln r) = B z with z = (u_r, u_φ, u_θ, rσ_rr, rσ_rφ, rσ_rθ).

    Parameters
    ----------
    layer : Layer
        Layer whose material is used.
    angular_speed : float
        Angular speed Ω [rad/s], > 0.
    radius : float
        Radius r [m], > 0.
    m, n : int
        Orders in φ and θ.
    curvature : Curvature or str, default Curvature.SPHERE
        Membrane stiffness of a sphere, or that of the paper (PAPER); EXACT is not allowed, because the exact sphere has
        no orders (m, n).

    Returns
    -------
    ndarray of complex, shape (6, 6)
        B; its blocks have the units [-, 1/Pa; Pa, -].

    Raises
    ------
    TypeError
        If an argument has the wrong type.
    ValueError
        If an argument is out of range.

    References
    ----------
    Equation (23) of the paper, with products expanded so that it stays finite at Poisson's ratio 1/2.
    """
    require_type("layer", layer, Layer)
    curvature = as_member("curvature", curvature, Curvature)
    return _core.state_matrix(
        layer._to_core(),
        angular_speed=as_float("angular_speed", angular_speed),
        radius=as_float("radius", radius),
        m=as_int("m", m),
        n=as_int("n", n),
        curvature=curvature,
    )


def centrifugal_displacement(ball: CoatedSphere, angular_speed: float) -> float:
    """Uniform radial displacement of the surface due to the centrifugal load, equation (36) of the paper.

    Parameters
    ----------
    ball : CoatedSphere
        Rigid core and layers.
    angular_speed : float
        Angular speed Ω [rad/s], > 0.

    Returns
    -------
    float
        d_R^(c) [m], positive outwards; 0 for incompressible layers.

    Raises
    ------
    TypeError
        If an argument has the wrong type.
    ValueError
        If an argument is out of range, or the speed is at or above the critical one.
    """
    require_type("ball", ball, CoatedSphere)
    return _core.centrifugal_displacement(ball._to_core(), angular_speed=as_float("angular_speed", angular_speed))


def critical_speed(
    body: RollingBody, *, highest_frequency: float = 1e9, curvature: Curvature | str = Curvature.SPHERE
) -> float:
    """Lowest rolling speed at which the coating radiates waves, above which the steady problem is no longer valid.

    For one layer, the surface then moves at the speed of the Rayleigh wave of the short-time modulus. A soft layer
    below a stiff one lowers the critical speed. A Kelvin-Voigt layer counts as rigid, because it is rigid at infinite
    frequency.

    Parameters
    ----------
    body : CoatedSphere, CoatedCylinder or CoatedWheel
        Rigid core and layers.
    highest_frequency : float, default 1e9
        Angular frequency [rad/s] at which a modulus that is given as a function is taken as its short-time limit.
    curvature : Curvature or str, default Curvature.SPHERE
        Curvature terms of a sphere that the equations keep.

    Returns
    -------
    float
        Critical Ω [rad/s]; infinite if the layers have no density.

    Raises
    ------
    TypeError
        If an argument has the wrong type.
    ValueError
        If an argument is out of range.
    """
    require_type("body", body, RollingBody)
    curvature = as_member("curvature", curvature, Curvature)
    frequency = as_float("highest_frequency", highest_frequency)
    core: Any = body._to_core()
    terms = {"curvature": curvature} if body.curved_directions == 2 else {}
    return float(_core.critical_speed(core, highest_frequency=frequency, **terms))


def influence_tables(
    ball: CoatedSphere,
    angular_speed: float,
    mesh: Mesh,
    *,
    reach: int | tuple[int, int],
    curvature: Curvature | str = Curvature.SPHERE,
    threads: int = 0,
    progress: ProgressLike = None,
) -> NDArray[np.float64]:
    """Influence tables: displacement of one surface node due to a unit force on the flat patch (53) of another.

    Parameters
    ----------
    ball : CoatedSphere
        Rigid core and layers.
    angular_speed : float
        Angular speed Ω [rad/s], > 0.
    mesh : Mesh
        Spacing and truncation of the mesh.
    reach : int or (int, int)
        Largest offsets in φ and θ, in node spacings, at most half of the nodes per revolution.
    curvature : Curvature or str, default Curvature.SPHERE
        Membrane stiffness of a sphere, or that of the paper (PAPER); EXACT is not allowed, because influence on the
        exact sphere does not depend on the offset alone.
    threads : int, default 0
        Number of threads; 0 for all cores.
    progress : bool or callable, optional
        True shows a progress bar; a callable is called as progress(stage, fraction) about every 20 ms.

    Returns
    -------
    ndarray, shape (3, 3, 2 * reach[0] + 1, 2 * reach[1] + 1)
        c[P, Q, J + j, L + l] [m/N]: displacement along P of the node at an offset of j spacings in φ and l in θ from
        the node loaded along Q, with P and Q in the order (r, φ, θ), J = reach[0] and L = reach[1].

    Raises
    ------
    TypeError
        If an argument has the wrong type.
    ValueError
        If an argument is out of range, or the speed is at or above the critical one.
    """
    require_type("ball", ball, CoatedSphere)
    require_type("mesh", mesh, Mesh)
    curvature = as_member("curvature", curvature, Curvature)
    phi_reach, theta_reach = _pair("reach", reach)
    with reporting(progress) as report:
        return _core.influence_tables(
            ball._to_core(),
            mesh._to_core(),
            angular_speed=as_float("angular_speed", angular_speed),
            phi_reach=phi_reach,
            theta_reach=theta_reach,
            threads=as_int("threads", threads),
            curvature=curvature,
            progress=report,
        )


def _broadcast(names: str, m: NDArray[_First], n: NDArray[_Second]) -> tuple[NDArray[_First], NDArray[_Second]]:
    try:
        shape = np.broadcast_shapes(m.shape, n.shape)
    except ValueError:
        raise InvalidInput(names, "must have shapes that broadcast", f"{m.shape} and {n.shape}") from None
    return np.broadcast_to(m, shape), np.broadcast_to(n, shape)


def _flat(numbers: NDArray[_First]) -> NDArray[_First]:
    """Return numbers as a flat, contiguous array for the core."""
    return np.ascontiguousarray(numbers.ravel())


def _pair(name: str, value: int | tuple[int, int]) -> tuple[int, int]:
    """Return a single number twice, and a pair unchanged."""
    if not isinstance(value, tuple):
        return (as_int(name, value),) * 2
    if len(value) != 2:
        raise InvalidInput(name, "must be one whole number or two", shown(value))
    return as_int(f"{name}[0]", value[0]), as_int(f"{name}[1]", value[1])
