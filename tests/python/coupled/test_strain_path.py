"""Strain paths: amplitude, loss summed over harmonics, and loss of a rate-independent network."""

from __future__ import annotations

import math

import numpy as np
import pytest
import viscoroll as vr
from shared_cases import RUBBER, coated_ball
from viscoroll import enums
from viscoroll.coupled.network_loss import iwan_loss, turning_ratio
from viscoroll.coupled.strain_path import StrainPath, deviatoric_path, half_range, harmonic_squares, strain_paths
from viscoroll.solution.inside import inside_of

ANGLES = np.linspace(0.0, 2.0 * np.pi, 1000, endpoint=False)


def path_of(*components):
    """Return the path of one point with the given components of p."""
    p = np.zeros((1, len(components[0]), 6))
    for place, values in enumerate(components):
        p[0, :, place] = values
    return p


def circle(x):
    return path_of(x * np.cos(ANGLES), x * np.sin(ANGLES))


def line(x):
    return path_of(x * np.cos(ANGLES))


@pytest.mark.parametrize(
    ("strain", "expected"),
    [
        ([0, 0, 0, 0.5, 0, 0], 1.0),  # simple shear
        ([1, -0.5, -0.5, 0, 0, 0], math.sqrt(3.0)),  # tension at constant volume
        ([1, 0, 0, 0, 0, 0], 2.0 / math.sqrt(3.0)),  # compression between walls
    ],
)
def test_norm_of_the_strain_vector(strain, expected):
    p = deviatoric_path(np.array(strain, dtype=float))
    assert np.linalg.norm(p) == pytest.approx(expected, rel=1e-14)


def test_amplitude_is_half_of_the_largest_distance_between_two_strains():
    assert half_range(circle(0.3)) == pytest.approx(0.3, rel=1e-12)
    assert half_range(line(0.3) + 5.0) == pytest.approx(0.3, rel=1e-12)
    # A pulse from 0 to 1; one of the nodes is at its maximum.
    assert half_range(path_of(np.maximum(np.sin(ANGLES), 0.0))) == pytest.approx(0.5, rel=1e-12)


#: Loss of the harmonics / (π g² N'') for pulses of one component, in closed form; docs/theory/filled-rubber.md.
PULSES = {
    "parabola": (lambda x: 1.0 - x**2, 16.0 / np.pi**2),
    "half an ellipse": (lambda x: np.sqrt(1.0 - x**2), 2.0),
    "(1 - x²)^(3/2)": (lambda x: (1.0 - x**2) ** 1.5, 1.5),
    "x (1 - x²)": (lambda x: x * (1.0 - x**2), 9.0 / np.pi**2),
    "triangle": (lambda x: 1.0 - abs(x), 16.0 * math.log(2.0) / np.pi**2),
}


@pytest.mark.parametrize("name", PULSES)
def test_harmonics_of_a_pulse(name):
    shape, expected = PULSES[name]
    x = np.linspace(-1.5, 1.5, 1501)
    pulse = np.where(abs(x) < 1.0, shape(np.clip(x, -1.0, 1.0)), 0.0)
    path = StrainPath(
        layer=0, phi=x, period=200.0, p=path_of(pulse), volumes=np.ones(1), depth=np.zeros(1), theta=np.zeros(1)
    )
    squares = harmonic_squares(path)[1].sum()
    # If a pulse ends like a square root, its harmonics decay like 1/k^(3/2); 1500 nodes omit 2e-3 of the loss.
    assert squares / (np.pi * half_range(path.p)[0] ** 2) == pytest.approx(expected, rel=3e-3)


@pytest.mark.parametrize(("x", "expected"), [(0.3, 0.0241628073), (1.0, 0.454822556), (3.0, 3.90964511)])
def test_network_on_a_straight_path(x, expected):
    """Compare the dissipation of 30 elements with π x² N''(x), the area of the hysteresis loop in closed form."""
    assert iwan_loss(line(x), np.array([x])) == pytest.approx(expected, rel=1e-7)
    assert turning_ratio(0.01 * line(x), np.array([0.01 * x]), 0.01) == pytest.approx(1.0, rel=1e-7)


@pytest.mark.parametrize(
    ("x", "expected"), [(0.01, 3.133262), (0.3, 2.935023), (1.0, 2.648818), (3.0, 2.299736), (100.0, 1.660626)]
)
def test_network_on_a_circle(x, expected):
    """After several revolutions, an element that yields at y follows the strain on a circle of radius √(x² - y²)."""
    loop = np.pi * x**2 * vr.materials.MasingNetwork(storage=1.0, critical_strain=1.0).at(x)[1]
    angle, weight = np.polynomial.legendre.leggauss(2000)
    angle, weight = 0.25 * np.pi * (1.0 + angle), 0.25 * np.pi * weight
    y = x * np.sin(angle)
    steady = (weight * 2.0 * np.pi * y * (x * np.cos(angle)) ** 2 * 2.0 / (1.0 + y) ** 3).sum()
    assert steady / loop == pytest.approx(expected, rel=1e-6)
    found = iwan_loss(circle(x)[:, ::4], np.array([x]), rounds=20)[0]
    assert found == pytest.approx(steady, rel=2e-4)  # chords 1e-4, transient 1e-5


def test_turning_ratio_on_a_circle_tends_to_pi_at_small_strain():
    found = turning_ratio(circle(1e-6), np.array([1e-6]), math.inf)[0]
    assert found == pytest.approx(math.pi, rel=0.02)  # transient after two revolutions


#: Positions along a half-plane in half-widths, dense in the loaded part.
POSITIONS = np.unique(
    np.concatenate([np.linspace(-1.4, 1.4, 561), 40.0 * np.sinh(np.linspace(-6.0, 6.0, 401)) / math.sinh(6.0)])
)


def half_plane(depth, x):
    """Return the deviator path under the pressure √(1 - x²), by McEwen, at p₀/G = 1, ν = 1/2, half-width 1."""
    square = 1.0 - x**2 + depth**2
    root = np.sqrt(square**2 + 4.0 * x**2 * depth**2)
    m, n = np.sqrt(0.5 * (root + square)), np.sqrt(0.5 * (root - square)) * np.sign(x)
    along = -(m * (1.0 + (depth**2 + n**2) / (m**2 + n**2)) - 2.0 * depth)
    normal = -m * (1.0 - (depth**2 + n**2) / (m**2 + n**2))
    shear = -n * (m**2 - depth**2) / (m**2 + n**2)
    # The deviator is e = s/2G. In plane strain at constant volume, the normal components of s are ± (normal - along)/2.
    difference = 0.25 * (normal - along)
    return path_of(math.sqrt(2.0) * difference, -math.sqrt(2.0) * difference, np.zeros(len(x)), shear)


@pytest.mark.parametrize(
    ("depth", "expected"),
    [(0.05, 0.12195), (0.2, 0.2124), (0.4, 0.2471), (0.786, 0.2363), (1.0, 0.2180), (1.5, 0.1756), (4.0, 0.0785)],
)
def test_amplitude_below_a_line_contact(depth, expected):
    p = half_plane(depth, POSITIONS)
    assert half_range(p)[0] == pytest.approx(expected, abs=1e-4)  # the maximum is between two nodes of the path
    if depth == 0.786:
        # Largest shear stress in the literature.
        assert np.linalg.norm(p[0], axis=1).max() == pytest.approx(0.3003, abs=1e-4)


def test_paths_of_a_half_plane_agree_with_mcewen(inside_half_plane):
    """Rigid roller on an elastic half-plane; the mesh and the approximation of a flat contact contribute 1 %."""
    result, path = inside_half_plane
    half_width, pressure = result.semi_axis_x, result.max_pressure
    found = half_range(path.p) * 1e7 / pressure
    for depth, amplitude in zip(path.depth, found, strict=True):
        if 0.1 * half_width < depth < 3.0 * half_width:
            assert amplitude == pytest.approx(half_range(half_plane(depth / half_width, POSITIONS))[0], rel=0.02)


@pytest.fixture(scope="module")
def inside_half_plane():
    plane = vr.CoatedPlane(base=vr.HalfSpace(shear_modulus=1e7, poisson_ratio=0.5))
    result = vr.solve(
        vr.CoatedCylinder(core_radius=0.05),
        on=plane,
        load=2e4,
        angular_speed=1.0,
        mesh=vr.Mesh(nodes_per_revolution=4000),
    )
    return result, strain_paths(inside_of(result), [0], depths=5)[0]


LAYER = vr.Layer(thickness=1e-2, shear_modulus=RUBBER, poisson_ratio=0.5)
BODIES = {
    "ball": (coated_ball(core_radius=11e-3, thickness=10e-3), 100.0, 1000),
    "thick ball": (coated_ball(core_radius=1e-3, thickness=20e-3), 20.0, 1000),
    "base case": (coated_ball(), 100.0, 1000),
    "base case, coarse": (coated_ball(), 100.0, 500),
    "roller": (vr.CoatedCylinder(core_radius=50e-3, layers=[LAYER]), 5e3, 2000),
    "roller, thin": (
        vr.CoatedCylinder(
            core_radius=50e-3, layers=[vr.Layer(thickness=1e-3, shear_modulus=RUBBER, poisson_ratio=0.5)]
        ),
        5e3,
        2000,
    ),
    "crowned wheel": (
        vr.CoatedWheel(core_radius=50e-3, layers=[LAYER], width=60e-3, crown_radius=0.1, sides=enums.Sides.UNBOUNDED),
        300.0,
        500,
    ),
}


@pytest.mark.parametrize("name", BODIES)
def test_dissipation_along_paths_is_that_of_the_layers(name):
    """Compare with `loss` over a whole revolution, to the errors of 6 depths and of the orders that `loss` omits."""
    body, load, nodes = BODIES[name]
    result = vr.solve(body, load=load, angular_speed=2.5, mesh=vr.Mesh(nodes_per_revolution=nodes))
    path = strain_paths(inside_of(result), [0], depths=6, reach=1e3, orders=40.0)[0]
    orders, squares = harmonic_squares(path)
    power = 2.5 * path.volumes @ squares @ RUBBER.complex_modulus(2.5 * orders).imag
    assert power == pytest.approx(result.loss().attrs["power"], rel=1e-3)


def test_paths_with_spin_cover_both_sides():
    """With spin, the paths of both sides are computed; without spin, one side represents both."""
    options = {"load": 100.0, "angular_speed": 2.5, "friction": 0.3, "mesh": vr.Mesh(nodes_per_revolution=400)}
    for drive, count in ((vr.Drive(creepage=0.0, spin=10.0), 2), (vr.Drive(torque=0.0), 1)):
        result = vr.solve(coated_ball(), drive=drive, **options)
        path = strain_paths(inside_of(result), [0], depths=6, reach=1e3, orders=40.0)[0]
        assert (path.theta < 0.5 * np.pi).sum() == (count - 1) * len(path.theta) // 2
        orders, squares = harmonic_squares(path)
        power = 2.5 * path.volumes @ squares @ RUBBER.complex_modulus(2.5 * orders).imag
        assert power == pytest.approx(result.loss().attrs["power"], rel=2e-3)  # ten nodes per half-width of the contact
