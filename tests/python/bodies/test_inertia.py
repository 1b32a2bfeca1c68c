"""Inertia: figure 13 of the paper, the centrifugal displacement, and the critical speed.

The inertia group is rho Omega^2 r_i^2 / G_o, equation (67) of the paper.
"""

from __future__ import annotations

import math

import numpy as np
import pytest
import viscoroll as vr
from viscoroll import enums, paper


def ball_at(inertia_group):
    """Return the ball of figure 13 (h = 5 mm) with the density that gives the inertia group."""
    return paper.ball(thickness=5e-3, density=inertia_group * 6e6 / (paper.ANGULAR_SPEED**2 * 20e-3**2))


def roll(ball, mesh=None):
    mesh = vr.Mesh(nodes_per_revolution=160, max_order=160) if mesh is None else mesh
    return vr.solve(
        ball,
        load=100.0,
        angular_speed=paper.ANGULAR_SPEED,
        mesh=mesh,
        compliance=enums.Compliance.RADIAL,
        curvature=enums.Curvature.PAPER,
    )


#: Ratios of torque and penetration to those without inertia, by inertia group: docs/theory/inertia.md, to 5e-4.
RATIOS = {
    0.1: (1.050, 1.013),
    0.2: (1.108, 1.027),
    0.3: (1.176, 1.042),
    0.4: (1.258, 1.058),
    0.5: (1.364, 1.075),
    0.55: (1.435, 1.085),
}


@pytest.mark.parametrize("inertia_group", [0.3, 0.55])
def test_figure_13_rises_towards_the_critical_speed(inertia_group):
    # At 400 nodes per revolution, the torque changes in steps of 0.2 % as rows of nodes come into contact.
    mesh = vr.Mesh(nodes_per_revolution=400)
    still, moving = roll(ball_at(0.0), mesh), roll(ball_at(inertia_group), mesh)
    torque, penetration = RATIOS[inertia_group]
    assert moving.resisting_torque / still.resisting_torque == pytest.approx(torque, rel=2.5e-3)
    assert moving.penetration / still.penetration == pytest.approx(penetration, rel=1e-3)


def test_torque_and_penetration_grow_with_inertia():
    results = [roll(ball_at(inertia_group)) for inertia_group in (0.0, *RATIOS)]
    assert (np.diff([r.penetration for r in results]) > 0.0).all()
    torques = [r.resisting_torque / results[0].resisting_torque for r in results[1:]]
    # The sums end at twice the Nyquist order of the mesh, and 20 rows in contact make the torque vary in steps. Both
    # cause errors of at most 7 %.
    assert torques == pytest.approx([torque for torque, _ in RATIOS.values()], rel=0.07)


def test_inertia_is_negligible_in_the_papers_example():
    # The change is of the order of the inertia group, 1e-7 to 1e-6.
    with_density, without = roll(paper.ball()), roll(paper.ball(density=0.0))
    change = with_density.resisting_torque / without.resisting_torque - 1.0
    assert 0.0 < abs(change) < 1e-5


def test_series_for_small_inertia_agrees_with_the_full_equations(rubber):
    # The library uses a series in the Mach number for slow rolling of identical layers, and the full equations
    # otherwise. Nearly identical layers are solved by the full equations at the same speed.
    def ball(epsilon):
        inner = vr.Layer(thickness=2e-3, shear_modulus=rubber, poisson_ratio=0.45, density=1000.0)
        other = vr.StandardLinearSolid(
            instantaneous_modulus=6e6, relaxed_modulus=3e6 * (1 + epsilon), relaxation_time=0.125
        )
        outer = vr.Layer(thickness=3e-3, shear_modulus=other, poisson_ratio=0.45, density=1000.0)
        return vr.CoatedSphere(core_radius=20e-3, layers=[inner, outer])

    mesh = vr.Mesh(nodes_per_revolution=64, max_order=64)
    for speed in (2.5, 20.0):
        series, full = (vr.modal.influence_tables(ball(e), speed, mesh, reach=8) for e in (0.0, 1e-12))
        # The moduli differ by 1e-12, and the inertia series is truncated at 1e-12.
        np.testing.assert_allclose(series, full, rtol=0.0, atol=1e-11 * full.max())


def test_centrifugal_displacement_of_one_layer():
    # Spherical symmetry: u = -r + A j1(kr) + B y1(kr) with k^2 = rho Omega^2 / (lambda + 2 mu), u(r_i) = 0 and
    # sigma_rr(r_o) = (lambda + 2 mu) u' + 2 lambda u / r = 0.
    inner, outer, shear, nu, density = 20e-3, 26e-3, 2e6, 0.3, 1200.0
    stiffness = shear * 2 * (1 - nu) / (1 - 2 * nu)
    lame = stiffness - 2 * shear

    def j1(x):
        return np.sin(x) / x**2 - np.cos(x) / x

    def y1(x):
        return -np.cos(x) / x**2 - np.sin(x) / x

    def slope(f, x):
        # f' = f0 - 2 f / x, where f0 is the function of order 0.
        order_zero = np.sin(x) / x if f is j1 else -np.cos(x) / x
        return order_zero - 2 * f(x) / x

    layer = vr.Layer(
        thickness=outer - inner, shear_modulus=vr.Elastic(modulus=shear), poisson_ratio=nu, density=density
    )
    ball = vr.CoatedSphere(core_radius=inner, layers=[layer])
    for speed in (300.0, 1000.0):
        k = speed * math.sqrt(density / stiffness)

        def traction(value, derivative, r):
            return stiffness * derivative + 2 * lame * value / r

        rows = [
            [j1(k * inner), y1(k * inner)],
            [traction(f(k * outer), k * slope(f, k * outer), outer) for f in (j1, y1)],
        ]
        a, b = np.linalg.solve(rows, [inner, traction(outer, 1.0, outer)])
        expected = -outer + a * j1(k * outer) + b * y1(k * outer)
        # At 300 rad/s, kr is 0.1. The closed form of j1 then loses two digits by cancellation, and `expected`, which is
        # small compared with the radius, loses four.
        assert vr.modal.centrifugal_displacement(ball, speed) == pytest.approx(expected, rel=1e-9, abs=0.0)


def test_centrifugal_displacement_in_the_limit_of_low_speed():
    # (lambda + 2 mu)(u'' + 2u'/r - 2u/r^2) = -rho Omega^2 r gives u = A r + B / r^2 - q r^3 with
    # q = rho Omega^2 / (10 (lambda + 2 mu)).
    inner, outer, shear, nu, density, speed = 20e-3, 26e-3, 2e6, 0.3, 1200.0, 1e-2
    stiffness = shear * 2 * (1 - nu) / (1 - 2 * nu)
    lame = stiffness - 2 * shear
    q = density * speed**2 / (10 * stiffness)
    rows = [[inner, inner**-2], [stiffness + 2 * lame, (-2 * stiffness + 2 * lame) / outer**3]]
    a, b = np.linalg.solve(rows, [q * inner**3, q * outer**2 * (3 * stiffness + 2 * lame)])
    layer = vr.Layer(
        thickness=outer - inner, shear_modulus=vr.Elastic(modulus=shear), poisson_ratio=nu, density=density
    )
    displacement = vr.modal.centrifugal_displacement(vr.CoatedSphere(core_radius=inner, layers=[layer]), speed)
    # The displacement is of the order of 1e-14 m: the absolute tolerance of pytest.approx, 1e-12, would hide it.
    assert displacement == pytest.approx(a * outer + b / outer**2 - q * outer**3, rel=1e-9, abs=0.0)


def test_centrifugal_displacement_of_identical_layers_is_that_of_one(rubber):
    def ball(count):
        layer = vr.Layer(thickness=6e-3 / count, shear_modulus=rubber, poisson_ratio=0.3, density=1000.0)
        return vr.CoatedSphere(core_radius=20e-3, layers=[layer] * count)

    one, three = (vr.modal.centrifugal_displacement(ball(count), 500.0) for count in (1, 3))
    assert three == pytest.approx(one, rel=1e-12, abs=0.0)


def test_centrifugal_displacement_enters_the_contact():
    layer = vr.Layer(thickness=5e-3, shear_modulus=vr.Elastic(modulus=2e6), poisson_ratio=0.3, density=1000.0)
    ball = vr.CoatedSphere(core_radius=20e-3, layers=[layer])
    still = roll(ball)
    fast = vr.solve(ball, load=100.0, angular_speed=200.0, mesh=still.mesh, compliance=enums.Compliance.RADIAL)
    assert fast.centrifugal_displacement == vr.modal.centrifugal_displacement(ball, 200.0) > 1e-6
    # The center rises by the growth of the ball, less the additional penetration due to inertia (some percent).
    rise = fast.center_height - still.center_height
    assert rise == pytest.approx(fast.centrifugal_displacement, abs=0.03 * still.penetration)
    # Far from the contact, the surface is displaced outwards by the same amount: downwards at the bottom.
    cosine = np.sqrt(ball.outer_radius**2 - fast.x**2 - fast.z**2) / ball.outer_radius
    assert fast.displacement[0, 0] == pytest.approx(-fast.centrifugal_displacement * cosine[0, 0], abs=2e-5)


def growing_roller(density):
    """Return a roller whose radius grows by 0.55 % at 300 rad/s if its density is 2000 kg/m³."""
    rubber = vr.StandardLinearSolid(instantaneous_modulus=2e6, relaxed_modulus=1e6, relaxation_time=1e-2)
    layer = vr.Layer(thickness=15e-3, shear_modulus=rubber, poisson_ratio=0.2, density=density)
    return vr.CoatedCylinder(core_radius=10e-3, layers=[layer])


RIGID_ROLLER = vr.CoatedCylinder(core_radius=25e-3, layers=[])
GROWN = growing_roller(2000.0)


@pytest.mark.parametrize(
    ("roller", "on"), [(GROWN, GROWN), (GROWN, RIGID_ROLLER), (RIGID_ROLLER, GROWN), (GROWN, vr.CoatedPlane())]
)
def test_power_balance_with_centrifugal_growth(roller, on):
    mesh = vr.Mesh(nodes_per_revolution=12000)
    r = vr.solve(roller, on=on, load=2000.0, angular_speed=300.0, mesh=mesh)
    assert r.centrifugal_displacement > 5e-3 * 25e-3
    assert r.energy_balance_error < 2e-4  # 1e-4 without inertia


@pytest.mark.parametrize("friction", [0.0, 0.5])
def test_identical_growing_rollers_have_no_driving_force(friction):
    drive = vr.Drive(creepage=0.0) if friction else vr.Drive(force=0.0)
    mesh = vr.Mesh(nodes_per_revolution=6000)
    given = {"load": 2000.0, "angular_speed": 300.0, "friction": friction, "drive": drive, "mesh": mesh}
    still, fast = (vr.solve(b, on=b, **given) for b in (growing_roller(0.0), GROWN))
    forces = [r.driving_force * 25e-3 / r.resisting_torque for r in (still, fast)]
    # The tolerance is the error of the mesh. If only one body grew, forces of 0.01 or more would remain.
    assert forces == pytest.approx([0.0, 0.0], abs=4e-4)


def test_a_tread_does_not_grow_along_its_axis():
    """The crown radius does not grow either: in a close groove, inertia changes the width only by softening."""
    rubber = vr.StandardLinearSolid(instantaneous_modulus=2e6, relaxed_modulus=1e6, relaxation_time=1e-2)

    def semi_axis(density, on):
        layer = vr.Layer(thickness=15e-3, shear_modulus=rubber, poisson_ratio=0.2, density=density)
        wheel = vr.CoatedWheel(core_radius=10e-3, layers=[layer], width=60e-3, crown_radius=50e-3, sides="UNBOUNDED")
        mesh = vr.Mesh(nodes_per_revolution=600)
        return vr.solve(wheel, on=on, load=50.0, angular_speed=150.0, mesh=mesh).semi_axis_z

    on_plane, in_groove = (
        semi_axis(1500.0, on) / semi_axis(0.0, on) for on in (vr.CoatedPlane(), vr.Groove(radius=51.2e-3))
    )
    # Growth of the crown radius would be amplified 43 times in this close groove, to a difference of 0.02.
    assert in_groove == pytest.approx(on_plane, abs=3e-3)


def test_a_ball_that_would_fill_its_groove_is_rejected():
    rubber = vr.StandardLinearSolid(instantaneous_modulus=2e6, relaxed_modulus=1e6, relaxation_time=1e-2)
    layer = vr.Layer(thickness=15e-3, shear_modulus=rubber, poisson_ratio=0.2, density=2000.0)
    ball = vr.CoatedSphere(core_radius=10e-3, layers=[layer])
    with pytest.raises(
        ValueError, match=r"angular_speed must be so low that the ball does not grow to fill the counterbody"
    ):
        vr.solve(
            ball, on=vr.Groove(radius=25.6e-3), load=10.0, angular_speed=800.0, mesh=vr.Mesh(nodes_per_revolution=200)
        )


def test_a_rigid_ball_does_not_grow_with_its_counterbody():
    """The driving force has the moment arm of the rigid ball, which does not grow, so it is equal to the given one."""
    soft = vr.StandardLinearSolid(instantaneous_modulus=2800.0, relaxed_modulus=64.0, relaxation_time=233.0)
    layer = vr.Layer(thickness=0.6, shear_modulus=soft, poisson_ratio=-0.25, density=1720.0)
    on = vr.CoatedSphere(layers=[layer], inner_boundary="SOLID")
    mesh = vr.Mesh(nodes_per_revolution=400)
    given = {"load": 0.5, "angular_speed": 0.02, "friction": 0.003, "drive": vr.Drive(force=1.5e-5), "mesh": mesh}
    r = vr.solve(vr.CoatedSphere(core_radius=0.43, layers=[]), on=on, **given)
    assert r.centrifugal_displacement > 1e-4 * 0.43
    assert r.driving_force == pytest.approx(1.5e-5, rel=1e-9, abs=0.0)


def test_incompressible_layers_do_not_grow(paper_ball):
    assert vr.modal.centrifugal_displacement(paper_ball, 1000.0) == 0.0


def test_critical_speed_is_that_of_the_rayleigh_wave():
    # 0.955 sqrt(mu_0 / rho) at Poisson's ratio 1/2; for h = 5 mm the inertia group is 0.58: docs/theory/inertia.md.
    ball = paper.ball(thickness=5e-3)
    critical = vr.modal.critical_speed(ball)
    assert critical * 25e-3 == pytest.approx(0.955 * math.sqrt(6e6 / 1000.0), rel=1e-3)
    assert 1000.0 * critical**2 * 20e-3**2 / 6e6 == pytest.approx(0.58, abs=0.005)


@pytest.mark.parametrize(
    ("poisson_ratio", "ratio"),
    # Rayleigh wave over shear wave, e.g. K. F. Graff, Wave Motion in Elastic Solids, section 6.1.3.
    [(0.0, 0.8740), (0.25, 0.9194), (0.5, 0.9553)],
)
def test_critical_speed_depends_on_poissons_ratio(poisson_ratio, ratio):
    layer = vr.Layer(thickness=5e-3, shear_modulus=vr.Elastic(modulus=4e6), poisson_ratio=poisson_ratio, density=1000.0)
    ball = vr.CoatedSphere(core_radius=20e-3, layers=[layer])
    assert vr.modal.critical_speed(ball) * 25e-3 == pytest.approx(ratio * math.sqrt(4e3), rel=1e-4)


def test_speeds_above_the_critical_speed_are_rejected():
    ball = ball_at(0.6)
    critical = vr.modal.critical_speed(ball)
    message = rf"angular_speed must be below the critical speed {critical!r} rad/s, .*, got 2.5 rad/s"
    with pytest.raises(ValueError, match=message):
        roll(ball)
    for function in (
        lambda: vr.modal.surface_compliance(ball, 2.5, 1, 2),
        lambda: vr.modal.centrifugal_displacement(ball, 2.5),
    ):
        with pytest.raises(ValueError, match=message):
            function()
    assert vr.solve(ball, load=100.0, angular_speed=0.95 * critical, accuracy=0.2).resisting_torque > 0.0


def test_critical_speed_is_infinite_without_inertia_or_without_a_short_time_limit():
    assert math.isinf(vr.modal.critical_speed(paper.ball(density=0.0)))
    viscous = vr.materials.KelvinVoigt(modulus=3e6, viscosity=1.0)
    layer = vr.Layer(thickness=1e-3, shear_modulus=viscous, poisson_ratio=0.5, density=1000.0)
    assert math.isinf(vr.modal.critical_speed(vr.CoatedSphere(core_radius=20e-3, layers=[layer])))


def test_critical_speed_of_a_modulus_given_by_a_function(rubber):
    def ball(modulus):
        layer = vr.Layer(thickness=1e-3, shear_modulus=modulus, poisson_ratio=0.5, density=1000.0)
        return vr.CoatedSphere(core_radius=20e-3, layers=[layer])

    assert vr.modal.critical_speed(ball(rubber.complex_modulus)) == pytest.approx(vr.modal.critical_speed(ball(rubber)))


@pytest.mark.parametrize(
    "modulus",
    [
        vr.materials.KelvinVoigt(modulus=3e6, viscosity=1e-9),
        vr.StandardLinearSolid(instantaneous_modulus=3e9, relaxed_modulus=3e6, relaxation_time=1e-17),
    ],
    ids=["Kelvin-Voigt", "standard linear"],
)
def test_waves_are_detected_if_the_short_time_modulus_is_far_above_that_of_rolling(modulus):
    # Both materials are elastic at all frequencies of rolling.
    def ball(material):
        layer = vr.Layer(thickness=5e-3, shear_modulus=material, poisson_ratio=0.5, density=1000.0)
        return vr.CoatedSphere(core_radius=20e-3, layers=[layer])

    speed = 2.0 * vr.modal.critical_speed(ball(vr.Elastic(modulus=3e6)))
    assert speed < vr.modal.critical_speed(ball(modulus))
    with pytest.raises(ValueError, match=r"angular_speed must be below the speed at which the coating radiates waves"):
        vr.solve(ball(modulus), load=50.0, angular_speed=speed)


@pytest.mark.parametrize(
    ("thickness", "poisson_ratio", "load", "exponent"),
    # Exponents of the gap curvature: 1/3 by Hertz; for thin layers 1/2, or 2/3 if they are incompressible.
    [(50e-3, 0.45, 30.0, 1.0 / 3.0), (0.5e-3, 0.2, 300.0, 1.0 / 2.0), (2e-3, 0.4999, 33.0, 2.0 / 3.0)],
    ids=["thick", "thin", "thin, incompressible"],
)
def test_growth_scales_the_gap_at_the_nodes(thickness, poisson_ratio, load, exponent):
    # Influences between nodes are computed at their distances at rest. If the growing ball rolls, the nodes are s times
    # as far apart in contact. The gap at each node is then s^2 times that of the same pair with the other ball as the
    # rolling body, and the penetration is proportional to the power `exponent` of this ratio.
    def ball(radius, density):
        layer = vr.Layer(
            thickness=thickness,
            shear_modulus=vr.Elastic(modulus=1e6),
            poisson_ratio=poisson_ratio,
            density=density,
        )
        return vr.CoatedSphere(core_radius=radius - thickness, layers=[layer])

    growing, still = ball(0.1, 1450.0), ball(0.2, 0.0)
    growth = vr.modal.centrifugal_displacement(growing, 23.5) / 0.1
    one = vr.solve(growing, on=still, load=load, angular_speed=23.5, mesh=vr.Mesh(nodes_per_revolution=660))
    other = vr.solve(still, on=growing, load=load, angular_speed=11.75, mesh=vr.Mesh(nodes_per_revolution=1320))
    power = (one.penetration / other.penetration - 1.0) / (2.0 * growth)
    # These layers deviate from the limits of thick and thin layers by at most 0.06.
    assert power == pytest.approx(exponent, abs=0.07)
