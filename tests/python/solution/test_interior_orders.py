"""Single orders inside the layers: 50-digit arithmetic, and the work that they dissipate."""

from __future__ import annotations

import math

import numpy as np
import pytest
import viscoroll as vr
from reference import interior as reference
from viscoroll import _core, enums
from viscoroll.solution.interior_fields import order_fields

CORE, SURFACE = 20e-3, 23e-3
PRONY = [(6e6, [0.5], [0.125]), (2e6, [0.3, 0.2], [0.01, 1.0]), (9e6, [0.4, 0.3], [0.05, 0.3])]
SOLID_CORE = 1e-9  # inner radius of the reference's solid ball, where its integration starts


def shells(inner=CORE, outer=SURFACE, density=0.0, bulk=None):
    """Return three layers of dissimilar moduli and Poisson's ratios, the middle one incompressible."""
    radii = np.linspace(inner, outer, 4)
    ratios = [0.3, 0.5, 0.45]
    return [
        reference.Shell(
            inner=float(low),
            outer=float(high),
            prony=prony,
            poisson_ratio=None if bulk and j == 2 else ratio,
            bulk_modulus=bulk if j == 2 else None,
            density=density * (1.0 + 0.2 * j),
        )
        for j, (low, high, prony, ratio) in enumerate(zip(radii[:-1], radii[1:], PRONY, ratios, strict=True))
    ]


def layers_of(layers, inner_boundary="rigid"):
    def modulus(prony):
        return vr.Prony(instantaneous_modulus=prony[0], weights=prony[1], relaxation_times=prony[2])

    return [
        vr.Layer(
            thickness=shell.outer - (0.0 if inner_boundary == "solid" and j == 0 else shell.inner),
            shear_modulus=modulus(shell.prony),
            poisson_ratio=shell.poisson_ratio,
            bulk_modulus=shell.bulk_modulus,
            density=shell.density,
        )
        for j, shell in enumerate(layers)
    ]


def ball_of(layers, inner_boundary="rigid"):
    return vr.CoatedSphere(
        core_radius=0.0 if inner_boundary == "solid" else layers[0].inner,
        inner_boundary=enums.InnerBoundary[inner_boundary.upper()],
        layers=layers_of(layers, inner_boundary),
    )


def places_in(layers, ball):
    """Return the middle and both ends of every layer; the package determines the ends."""
    radii = [ball.core_radius or 0.5 * layers[0].outer, *(shell.outer for shell in layers)]
    middles = [0.5 * (shell.inner + shell.outer) for shell in layers[1:]]
    return sorted([*radii, *middles])


def compare(layers, inner_boundary, angular_speed, m, n, curvature=enums.Curvature.PAPER):
    """Return the largest error of any component, relative to the largest component of the same field at that point.

    The recursion starts 36 e-folds below the surface, so its relative error at depth d is exp(2d - 72): 4e-11 at 24
    e-folds. Deeper, where a field is at most exp(-24) of its surface value, the error is relative to 1e-3 of the
    surface value.
    """
    ball = ball_of(layers, inner_boundary)
    radii = places_in(layers, ball)
    got = order_fields(ball, angular_speed, [m], [n], radius=radii, curvature=curvature)
    core = _core.places_at(ball._to_core(), np.array(radii))
    places = list(zip(core[0].tolist(), core[1].tolist(), strict=True))
    expected = reference.order_fields(
        layers, angular_speed, m, n, places, inner_boundary=inner_boundary, paper=curvature is enums.Curvature.PAPER
    )
    worst = 0.0
    for kind in range(3):
        exact = np.array([place[kind] for place in expected])
        known = ~np.isnan(exact)
        difference = np.where(known, np.abs(got[kind][0] - exact), 0.0)
        size = np.nanmax(np.abs(exact), axis=(1, 2), keepdims=True)
        deep = np.reshape([math.hypot(m, n) * math.log(ball.outer_radius / r) > 24.0 for r, _ in places], size.shape)
        worst = max(worst, float((difference / np.where(deep, 1e-3 * size.max(), np.maximum(size, 1e-300))).max()))
    return worst


LOW_ORDERS = [(1, 0), (2, -1), (13, 7)]
HIGH_ORDERS = [(150, 40), (350, 360)]  # these fields end above the innermost layer of a solid ball


@pytest.mark.parametrize(
    ("inner_boundary", "m", "n"),
    [("solid", *order) for order in LOW_ORDERS]
    + [(inner_boundary, *order) for inner_boundary in ("rigid", "hollow") for order in LOW_ORDERS + HIGH_ORDERS],
)
def test_fields_agree_with_fifty_digits(inner_boundary, m, n):
    """At the last order, fields decay by k ln(23/20) = 70 e-folds from the surface to the core."""
    inner = SOLID_CORE if inner_boundary == "solid" else CORE
    layers = shells(inner=inner)
    assert compare(layers, inner_boundary, 2.5, m, n) < 1e-10


@pytest.mark.parametrize(("m", "n"), [(4, 3), (13, 7), (80, 20)])
def test_fields_on_a_sphere_and_with_a_bulk_modulus(m, n):
    assert compare(shells(bulk=2e8), "rigid", 2.5, m, n, curvature=enums.Curvature.SPHERE) < 1e-10
    assert compare(shells(bulk=2e8), "hollow", 2.5, m, n) < 1e-10


@pytest.mark.parametrize(("m", "n"), [(4, 0), pytest.param(7, 3, marks=pytest.mark.slow), (47, 20)])
def test_fields_with_inertia(m, n):
    """The speed is 0.6 of the lowest shear wave speed of the three layers."""
    layers = shells(density=1000.0)
    speed = 0.6 * math.sqrt(1e6 / 1400.0) / SURFACE
    assert compare(layers, "rigid", speed, m, n) < 1e-10
    assert compare(layers, "hollow", speed, m, n) < 1e-10


@pytest.mark.parametrize("inner_boundary", ["rigid", "hollow", "solid"])
@pytest.mark.parametrize("curvature", [enums.Curvature.PAPER, enums.Curvature.SPHERE])
@pytest.mark.parametrize("density", [0.0, 1000.0])
def test_every_order_dissipates_the_work_of_the_surface(inner_boundary, curvature, density):
    """The work of a surface stress is the integral of the inner dissipation: ν < ½, ν = ½ and a real bulk modulus."""
    layers = shells(inner=8e-3 if inner_boundary == "solid" else CORE, bulk=3e7, density=density)
    ball = ball_of(layers, inner_boundary)
    points, weights = np.polynomial.legendre.leggauss(60)
    speed = 20.0
    m, n = np.array([1, 1, 2, 9, 30]), np.array([0, 1, -3, 12, -40])
    for load in (np.array([1.0, 0.0, 0.0]), np.array([0.3, 1.0j, -0.7])):
        lost = np.zeros(len(m))
        inner = ball.core_radius
        for layer in ball.layers:
            outer = inner + layer.thickness
            # The integrand contains non-integer powers of r, which need points concentrated at the center.
            y, crowding = 0.5 * (1.0 + points), 4 if inner == 0.0 else 1
            radius = inner + (outer - inner) * y**crowding
            widths = (outer - inner) * crowding * y ** (crowding - 1) * 0.5 * weights
            strain = order_fields(ball, speed, m, n, radius=radius, curvature=curvature)[2] @ load
            err, epp, ett, erp, ert, ept = np.moveaxis(strain, 2, 0)
            trace = err + epp + ett
            square = sum(abs(e) ** 2 for e in (err, epp, ett)) + 2 * sum(abs(e) ** 2 for e in (erp, ert, ept))
            mu = layer.shear_modulus.complex_modulus(m * speed)
            bulk = 0.0
            if layer.poisson_ratio is not None and layer.poisson_ratio < 0.5:
                nu = layer.poisson_ratio
                bulk = (mu * 2 * (1 + nu) / (3 * (1 - 2 * nu))).imag[:, None]
            density_lost = 2 * mu.imag[:, None] * (square - abs(trace) ** 2 / 3) + bulk * abs(trace) ** 2
            lost += (density_lost * radius**2) @ widths
            inner = outer
        displacement = order_fields(ball, speed, m, n, radius=[ball.outer_radius], curvature=curvature)[0][:, 0] @ load
        put_in = -(ball.outer_radius**2) * (displacement @ load.conj()).imag
        np.testing.assert_allclose(lost, put_in, rtol=1e-10)


def test_displacement_on_a_rigid_core_and_traction_at_a_cavity_vanish():
    """Both boundary conditions hold exactly; core traction and cavity displacement agree with fifty digits."""
    layers = shells()
    rigid, hollow = (
        order_fields(ball_of(layers, inner_boundary), 2.5, [5], [3], radius=[CORE], curvature=enums.Curvature.PAPER)
        for inner_boundary in ("rigid", "hollow")
    )
    pulls = [0, 3, 4]
    assert np.abs(rigid[0]).max() == 0.0
    assert np.abs(hollow[1][0, 0, pulls]).max() == 0.0
    ((_, traction, _),) = reference.order_fields(layers, 2.5, 5, 3, [(CORE, 0)], inner_boundary="rigid")
    ((expected, _, _),) = reference.order_fields(layers, 2.5, 5, 3, [(CORE, 0)], inner_boundary="hollow")
    np.testing.assert_allclose(rigid[1][0, 0, pulls], traction[pulls], atol=1e-10 * np.abs(traction).max())
    np.testing.assert_allclose(hollow[0][0, 0], expected, atol=1e-10 * np.abs(expected).max())


def test_fields_on_both_sides_of_an_interface():
    layers = shells()
    ball = ball_of(layers)
    _, stress, strain = order_fields(ball, 2.5, [5], [3], radius=[layers[0].outer])
    assert stress.shape[1] == 2
    carried, others = [0, 3, 4], [1, 2, 5]
    np.testing.assert_allclose(stress[0, 0, carried], stress[0, 1, carried], rtol=1e-13)
    assert (np.abs(stress[0, 0, others] - stress[0, 1, others]) > 1e-3).any()
    np.testing.assert_allclose(strain[0, 0, [1, 2, 5]], strain[0, 1, [1, 2, 5]], rtol=1e-9)
