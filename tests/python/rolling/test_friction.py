"""Coulomb friction: contact conditions, drives, limits, the power balance, and a dense reference solution."""

from __future__ import annotations

import math
import warnings

import numpy as np
import pytest
import viscoroll as vr
from reference import boundary, friction
from viscoroll import enums

SLOW = 0.2  # angular speed of the paper's section 14.3 [rad/s]
MESH = vr.Mesh(nodes_per_revolution=200, max_order=500)  # pi/100


def roll(ball, *, mesh=MESH, load=100.0, angular_speed=SLOW, mu=0.3, **options):
    return vr.solve(ball, load=load, angular_speed=angular_speed, friction=mu, mesh=mesh, **options)


DRIVES = {
    "driven": vr.Drive(force=0.0),
    "pulled": vr.Drive(force=5.0),
    "towed": vr.Drive(torque=0.0),
    "braked": vr.Drive(torque=-0.2),
    "powered": vr.Drive(power=0.03),
    "rolling": vr.Drive(creepage=0.0),
    "skidding": vr.Drive(creepage=-0.5),
    "oblique": vr.Drive(creepage=0.05, lateral_creepage=0.02),
}


def assert_conditions_hold(r):
    """Assert the conditions of contact, stick, slip and balance on the fields of the result."""
    stress = 1e-8 * r.max_pressure
    length = 1e-8 * r.penetration
    assert r.status is enums.Status.CONVERGED
    assert r.residual < 1e-8
    assert (r.pressure >= -stress).all()
    assert (r.pressure[~r.contact] == 0.0).all()
    assert (r.gap > -length).all()
    assert np.abs(r.gap[r.contact]).max() < length
    patch = (r.body.outer_radius * r.mesh.spacing) ** 2
    assert r.pressure.sum() * patch == pytest.approx(r.load, rel=1e-8)

    traction = np.hypot(*r.shear_traction)
    limit = np.full_like(r.pressure, np.inf) if math.isinf(r.friction) else r.friction * r.pressure
    assert (traction[~r.contact] == 0.0).all()
    assert (traction <= limit + stress).all()
    assert (r.stick | r.slip == r.contact).all()
    assert not (r.stick & r.slip).any()
    velocity = 1e-8 * r.angular_speed * r.body.outer_radius
    speed = np.hypot(*r.slip_velocity)
    assert (speed[r.stick] < velocity).all()
    np.testing.assert_allclose(traction[r.slip], limit[r.slip], rtol=0.0, atol=stress)
    # Opposite directions: t . v = -|t| |v|.
    work = (r.shear_traction * r.slip_velocity).sum(axis=0)[r.slip]
    np.testing.assert_allclose(work, -(traction * speed)[r.slip], rtol=0.0, atol=stress * (velocity + speed.max()))

    assert r.driving_force == pytest.approx(-r.shear_traction[0].sum() * patch, abs=1e-8 * r.load)
    assert r.creepage == pytest.approx(r.linear_speed / (r.angular_speed * r.body.outer_radius) - 1.0)


@pytest.mark.parametrize("mu", [0.001, 0.003, 0.01, 0.03, 0.1, 0.3, 1.0, 2.0, 4.0])
@pytest.mark.parametrize("poisson_ratio", [0.3, 0.45, 0.5])
@pytest.mark.parametrize("thickness", [0.5e-3, 1e-3, 5e-3])
def test_every_friction_without_an_initial_guess(rubber, thickness, poisson_ratio, mu):
    layer = vr.Layer(thickness=thickness, shear_modulus=rubber, poisson_ratio=poisson_ratio, density=1000.0)
    ball = vr.CoatedSphere(core_radius=20e-3, layers=[layer])
    for angular_speed in (0.05, 0.2, 1.0, 5.0):
        for nodes in (100, 160):
            mesh = vr.Mesh(nodes_per_revolution=nodes, max_order=3 * nodes // 2)
            assert_conditions_hold(roll(ball, mu=mu, angular_speed=angular_speed, mesh=mesh))


@pytest.mark.parametrize("compliance", enums.Compliance)
@pytest.mark.parametrize("kinematics", enums.SlipKinematics)
@pytest.mark.parametrize("drive", DRIVES.values(), ids=DRIVES)
def test_every_drive(paper_ball, drive, compliance, kinematics):
    r = roll(paper_ball, drive=drive, compliance=compliance, slip_kinematics=kinematics)
    assert_conditions_hold(r)
    if drive.force is not None:
        assert r.driving_force == pytest.approx(drive.force, abs=1e-8 * r.load)
    if drive.torque is not None:
        assert r.driving_torque == pytest.approx(drive.torque, abs=1e-8 * r.load * r.body.outer_radius)
    if drive.power is not None:
        assert r.driving_torque * r.angular_speed == pytest.approx(drive.power, abs=1e-8 * r.load * SLOW * 21e-3)
    if drive.creepage is not None:
        assert r.creepage == pytest.approx(drive.creepage, abs=1e-14)


@pytest.mark.parametrize("power", [0.03, 0.0, -0.03])
def test_a_power_equals_its_torque(paper_ball, power):
    powered, turned = (
        roll(paper_ball, drive=vr.Drive(power=power)),
        roll(paper_ball, drive=vr.Drive(torque=power / SLOW)),
    )
    for name in ("driving_torque", "driving_force", "creepage", "slip_power", "resisting_torque"):
        assert getattr(powered, name) == getattr(turned, name)


def test_a_power_in_line_contact_is_per_length(rubber):
    layer = vr.Layer(thickness=10e-3, shear_modulus=rubber, poisson_ratio=0.49)
    roller = vr.CoatedCylinder(core_radius=50e-3, layers=[layer])
    message = r"drive.power must be between -.* W/m and .* W/m, otherwise the roller slides permanently, got 1e\+06 W/m"
    with pytest.raises(vr.InvalidInput, match=message):
        roll(roller, load=1e3, drive=vr.Drive(power=1e6))


def test_curved_patches(paper_ball):
    curved, flat = (roll(paper_ball, patch_load=patch_load) for patch_load in enums.PatchLoad)
    assert max(curved.residual, flat.residual) < 1e-8
    assert 0.0 < abs(curved.resisting_torque / flat.resisting_torque - 1.0) < 5e-3


# Ratios T_r(mu) / T_r(0) of docs/theory/friction.md from an independent NumPy computation, printed to three digits.
@pytest.mark.parametrize(
    ("mu", "ratio"),
    [
        (0.005, 1.010),
        (0.01, 1.019),
        (0.05, 1.078),
        (0.1, 1.102),
        (0.15, 1.067),
        (0.2, 1.016),
        (0.3, 0.923),
        (0.5, 0.853),
        (1.0, 0.84),
        (math.inf, 0.84),
    ],
)
def test_ratios_of_an_independent_program(paper_ball, mu, ratio):
    model = {"compliance": enums.Compliance.VERTICAL, "curvature": enums.Curvature.PAPER}
    without = roll(paper_ball, mu=0.0, **model).resisting_torque
    assert roll(paper_ball, mu=mu, **model).resisting_torque / without == pytest.approx(ratio, rel=5e-3)


@pytest.mark.parametrize("lateral", [0.0, 0.02])
@pytest.mark.parametrize("mu", [0.05, 0.4, 2.0])
def test_agrees_with_the_dense_reference(two_layer_ball, mu, lateral):
    mesh = vr.Mesh(nodes_per_revolution=90, max_order=60)
    assert_agreement(two_layer_ball, mesh, mu, vr.Drive(creepage=-0.01, lateral_creepage=lateral))


@pytest.mark.parametrize("drive", [DRIVES["driven"], DRIVES["pulled"], DRIVES["towed"]], ids=str)
def test_drives_agree_with_the_dense_reference(two_layer_ball, drive):
    assert_agreement(two_layer_ball, vr.Mesh(nodes_per_revolution=100, max_order=60), 0.4, drive)


@pytest.mark.parametrize("drive", [DRIVES["pulled"], DRIVES["oblique"]], ids=str)
def test_the_radial_compliance_agrees_with_the_dense_reference(two_layer_ball, drive):
    mesh = vr.Mesh(nodes_per_revolution=90, max_order=60)
    assert_agreement(two_layer_ball, mesh, 0.4, drive, compliance=enums.Compliance.RADIAL)


def assert_agreement(ball, mesh, mu, drive, compliance=enums.Compliance.VERTICAL):
    r = roll(ball, mesh=mesh, load=60.0, angular_speed=2.5, mu=mu, drive=drive, compliance=compliance)
    phi, theta = boundary.nodes(mesh.spacing, *(count // 2 for count in r.x.shape))

    def compliance_of_orders(m, n):
        return vr.modal.surface_compliance(ball, 2.5, m.astype(int), n.astype(int))

    matrix = boundary.compliance_matrix(
        compliance_of_orders, mesh.max_order, ball.outer_radius, mesh.spacing, phi, theta
    )
    swollen = ball.outer_radius + vr.modal.centrifugal_displacement(ball, 2.5)
    along_axes = boundary.to_rectangular if compliance is enums.Compliance.VERTICAL else boundary.to_turned
    forces, height, speed_ratio = friction.solve_frictional_contact(
        along_axes(matrix, phi, theta),
        swollen * np.sin(theta) * np.sin(phi),
        swollen * np.sin(theta) * np.cos(phi),
        ball.outer_radius * mesh.spacing,
        60.0,
        mu,
        first=friction.upstream(theta),
        force=drive.force,
        torque=drive.torque,
        creepage=drive.creepage,
        lateral=drive.lateral_creepage,
    )
    patch = (ball.outer_radius * mesh.spacing) ** 2
    tractions = np.stack([-r.pressure, -r.shear_traction[0], -r.shear_traction[1]]).reshape(3, -1)
    np.testing.assert_allclose(tractions * patch, forces, rtol=0.0, atol=1e-7 * np.abs(forces).max())
    assert r.center_height == pytest.approx(height, rel=1e-7)
    assert r.creepage == pytest.approx(speed_ratio - 1.0, abs=1e-7)
    if mu < 0.1:
        assert r.slip.any()


def test_no_friction_is_the_frictionless_solver(paper_ball):
    smooth = vr.solve(paper_ball, load=100.0, angular_speed=SLOW, mesh=MESH)
    without = roll(paper_ball, mu=0.0)
    np.testing.assert_array_equal(without.pressure, smooth.pressure)
    assert without.scalars() == smooth.scalars()
    assert without.linear_speed is None
    assert not without.shear_traction.any()
    given = roll(paper_ball, mu=0.0, drive=vr.Drive(creepage=0.1))
    assert given.linear_speed == pytest.approx(1.1 * SLOW * paper_ball.outer_radius)
    # Small friction has a small effect.
    assert roll(paper_ball, mu=1e-6).resisting_torque == pytest.approx(smooth.resisting_torque, rel=1e-5)


@pytest.mark.parametrize("mu", [0.1, 0.3, 1.0])
def test_power_balance_closes(paper_ball, mu):
    """T Omega + Q V_s = bulk + slip for all drives: to 1 % at pi/250, and better on finer meshes."""
    worst = {}
    for nodes in (100, 200, 500):
        errors = []
        for name in ("driven", "pulled", "towed", "powered", "rolling"):
            mesh = vr.Mesh(nodes_per_revolution=nodes, max_order=3 * nodes // 2)
            r = roll(paper_ball, mu=mu, drive=DRIVES[name], mesh=mesh)
            work = r.driving_torque * r.angular_speed + r.driving_force * r.linear_speed
            lost = r.bulk_power + r.slip_power
            assert r.dissipated_power == lost
            assert r.energy_balance_error == pytest.approx(abs(work - lost) / max(abs(work), abs(lost)), rel=1e-9)
            assert r.slip_power > 0.0
            errors.append(r.energy_balance_error)
        worst[nodes] = max(errors)
    assert worst[500] < 0.01
    assert worst[500] < worst[200] < worst[100]


def test_pressure_and_tractions_are_symmetric_sideways(paper_ball):
    r = roll(paper_ball, drive=DRIVES["pulled"])
    np.testing.assert_array_equal(r.pressure, r.pressure[:, ::-1])
    np.testing.assert_array_equal(r.shear_traction[0], r.shear_traction[0, :, ::-1])
    np.testing.assert_array_equal(r.shear_traction[1], -r.shear_traction[1, :, ::-1])


def test_sideways_creepage_mirrors(paper_ball):
    right, left = (
        roll(paper_ball, drive=vr.Drive(creepage=0.05, lateral_creepage=lateral)) for lateral in (0.02, -0.02)
    )
    assert right.lateral_force == pytest.approx(-left.lateral_force, rel=1e-9)
    np.testing.assert_allclose(right.pressure, left.pressure[:, ::-1], rtol=0.0, atol=1e-7 * right.max_pressure)
    assert right.lateral_force < 0.0  # the plane holds the ball back


def elastic_ball(core_radius, radius, modulus=1e6):
    layer = vr.Layer(thickness=radius - core_radius, shear_modulus=vr.Elastic(modulus=modulus), poisson_ratio=0.5)
    return vr.CoatedSphere(core_radius=core_radius, layers=[layer])


def small_contact(nodes_across, **options):
    """Solve an elastic ball whose contact radius is 1/40 of its radius: nearly a half-space.

    A core of 0.3 of the radius is twelve contact diameters deep. With a core of 1e-3 of the radius, the moment of the
    tractions would rotate the ball about its core by far more than the width of the contact.
    """
    radius, modulus, share = 20e-3, 1e6, 0.025
    nodes = 2 * round(np.pi * nodes_across / (2.0 * share))
    return vr.solve(
        elastic_ball(0.3 * radius, radius, modulus),
        load=16.0 / 3.0 * modulus * (share * radius) ** 3 / radius,  # Hertz
        angular_speed=1.0,
        friction=0.5,
        mesh=vr.Mesh(nodes_per_revolution=nodes, max_order=nodes // 2),
        **options,
    )


def kalker_coefficients(nodes_across, lateral=False):
    """Return C_11 or C_22 from the force at small creepage from free rolling, F = 2 G a^2 C xi on a rigid plane."""
    free = small_contact(nodes_across)
    creepage = 5e-5
    modulus, radius = 1e6, np.sqrt(free.contact_area / np.pi)
    if lateral:
        r = small_contact(nodes_across, drive=vr.Drive(creepage=free.creepage, lateral_creepage=creepage))
        return -r.lateral_force / (2.0 * modulus * radius**2 * creepage)
    r = small_contact(nodes_across, drive=vr.Drive(creepage=free.creepage + creepage))
    assert r.stick.sum() > 0.9 * r.contact.sum()
    return (r.driving_force - free.driving_force) / (2.0 * modulus * radius**2 * creepage)


@pytest.mark.parametrize("drive", [DRIVES["driven"], DRIVES["towed"], DRIVES["rolling"]], ids=str)
def test_large_friction_tends_to_full_stick(paper_ball, drive):
    given = {"drive": drive, "compliance": enums.Compliance.VERTICAL, "mesh": vr.Mesh(nodes_per_revolution=500)}
    stuck, *rough = (roll(paper_ball, mu=mu, **given) for mu in (math.inf, 4.0, 1.0))
    assert_conditions_hold(stuck)
    np.testing.assert_array_equal(stuck.stick, stuck.contact)
    # The tractions are singular at the trailing edge, which causes this error of the mesh.
    assert stuck.energy_balance_error < 0.02
    differences = np.abs([r.pressure - stuck.pressure for r in rough]).max(axis=(1, 2))
    assert differences[0] < 0.5 * differences[1]


def test_full_stick_equals_a_finite_friction_without_slip(paper_ball):
    stuck, rough = (roll(paper_ball, mu=mu) for mu in (math.inf, 4.0))
    assert not rough.slip.any()
    np.testing.assert_allclose(stuck.pressure, rough.pressure, rtol=0.0, atol=1e-9 * rough.max_pressure)
    assert stuck.creepage == pytest.approx(rough.creepage, rel=1e-9)
    axes = stuck.plot().axes
    assert not any("bound" in text.get_text() for a in axes if a.get_legend() for text in a.get_legend().get_texts())


def test_full_stick_with_tension_is_rejected(paper_ball):
    # At the edge of this contact, nodes that stick are in tension, and nodes that are removed overlap the plane.
    message = (
        "no state of full stick without tension was found in .* of the load; with a finite friction, nodes can slip"
    )
    with pytest.raises(vr.ConvergenceError, match=message):
        roll(paper_ball, mu=math.inf, drive=vr.Drive(creepage=0.0))


def test_small_creepage_follows_kalker():
    # J. J. Kalker, Three-Dimensional Elastic Bodies in Rolling Contact, 1990, appendix E: nu = 1/2, a = b.
    assert kalker_coefficients(40) == pytest.approx(5.20, rel=0.03)
    assert kalker_coefficients(20) == pytest.approx(5.20, rel=0.03)
    assert kalker_coefficients(20, lateral=True) == pytest.approx(3.98, rel=0.03)
    # The error decreases; the contact area of few nodes is itself uncertain.
    errors = [abs(kalker_coefficients(n) - 5.20) for n in (6, 20)]
    assert errors[1] < errors[0]


def test_large_creepage_saturates_with_stick_at_the_leading_edge():
    free = small_contact(20).creepage
    shares, creepages = [], (0.0005, 0.002, 0.006, 0.3)
    for creepage in creepages:
        r = small_contact(20, drive=vr.Drive(creepage=free + creepage))
        assert_conditions_hold(r)
        shares.append(r.driving_force / (r.friction * r.load))
        if 0.05 < r.stick.sum() / r.contact.sum() < 0.95:
            assert r.x[r.stick].mean() > r.x[r.slip].mean() + 0.2 * r.semi_axis_x
    assert np.all(np.diff(shares) > 0.0)
    assert shares[0] < 0.5
    assert shares[-1] == pytest.approx(1.0, abs=1e-4)


BAD = {
    "friction": ({"friction": -0.1}, ValueError, "friction must be >= 0, got"),
    "nan": ({"friction": float("nan")}, ValueError, "friction must be >= 0, got"),
    "too large": (
        {"friction": 4.01},
        ValueError,
        r"friction must be <= 4 \(no pair of materials has more\), or infinite for full stick, got 4.01",
    ),
    "text": ({"friction": "much"}, TypeError, "friction must be a real number"),
    "drive": ({"friction": 0.3, "drive": 0.0}, TypeError, "drive must be a viscoroll.Drive"),
    "sliding": (
        {"friction": 0.3, "drive": vr.Drive(force=30.0)},
        ValueError,
        r"drive.force must be smaller than friction \* load = 30 N in magnitude.*, got 30 N",
    ),
    "smooth pull": ({"drive": vr.Drive(force=1.0)}, ValueError, "drive.force must be smaller than"),
    "smooth torque": ({"drive": vr.Drive(torque=0.1)}, ValueError, "drive.torque must be left out without friction"),
    "smooth power": ({"drive": vr.Drive(power=0.1)}, ValueError, "drive.power must be left out without friction"),
    "infinite power": ({"friction": 0.3, "drive": vr.Drive(power=math.inf)}, ValueError, "drive.power must be finite"),
    "power": (
        {"friction": 0.3, "drive": vr.Drive(power=5.0)},
        ValueError,
        r"drive.power must be between -0\.\d+ W and 0\.\d+ W, otherwise the ball slides permanently, got 5 W",
    ),
    "torque": (
        {"friction": 0.3, "drive": vr.Drive(torque=5.0)},
        ValueError,
        r"drive.torque must be between -0\.\d+ N m and 0\.\d+ N m, otherwise the ball slides permanently, got 5 N m",
    ),
    "towed without grip": (
        {"friction": 0.001, "drive": vr.Drive(torque=0.0)},
        ValueError,
        "drive.torque must be between 0.0",
    ),
    "kinematics": ({"friction": 0.3, "slip_kinematics": 1}, TypeError, "slip_kinematics must be"),
}


@pytest.mark.parametrize(("options", "error", "message"), BAD.values(), ids=BAD)
def test_bad_input_is_named(paper_ball, options, error, message):
    with pytest.raises(error, match=message):
        vr.solve(paper_ball, load=100.0, angular_speed=SLOW, mesh=MESH, **options)


@pytest.mark.parametrize(
    ("parameters", "error", "message"),
    [
        ({}, ValueError, "exactly one of force, torque, power and creepage, got none"),
        ({"force": 1.0, "torque": 0.0}, ValueError, "exactly one of .*, got force, torque"),
        ({"force": 1.0, "lateral_creepage": 0.1}, ValueError, "lateral_creepage must be 0 without"),
        ({"force": "1 N"}, TypeError, "drive.force must be a real number"),
        ({"creepage": 0.0, "lateral_creepage": None}, TypeError, "drive.lateral_creepage must be a real number"),
    ],
)
def test_bad_drives_are_named(parameters, error, message):
    with pytest.raises(error, match=message):
        vr.Drive(**parameters)


def test_accuracy_is_reached_with_friction(paper_ball):
    r = vr.solve(paper_ball, load=100.0, angular_speed=SLOW, friction=0.3, accuracy=0.03)
    assert r.status is enums.Status.CONVERGED
    assert r.error_estimate < 0.03
    fine = roll(paper_ball, mesh=vr.Mesh(nodes_per_revolution=800, max_order=1200))
    assert r.driving_torque == pytest.approx(fine.driving_torque, rel=0.03)


def test_plot_shows_stick_and_slip(paper_ball, tmp_path):
    figure = roll(paper_ball, drive=DRIVES["pulled"]).plot()
    legends = [axes.get_legend() for axes in figure.axes if axes.get_legend()]
    assert {"stick", "slip", "traction along x", "bound ±$μp$"} <= {
        text.get_text() for legend in legends for text in legend.get_texts()
    }
    figure.savefig(tmp_path / "friction.png")


@pytest.mark.parametrize(("name", "mu"), [(name, mu) for name in DRIVES for mu in (0.2, 0.5, 2.0)])
def test_large_contacts_without_a_matrix(paper_ball, mu, name):
    """About 3000 nodes, solved iteratively: all conditions hold, and the power balance closes."""
    mesh = vr.Mesh(nodes_per_revolution=1400)
    r = roll(paper_ball, mu=mu, drive=DRIVES[name], mesh=mesh, compliance=enums.Compliance.VERTICAL)
    assert r.operator_applications > 0
    assert r.contact.sum() > 2500
    assert r.residual < 1e-8
    assert r.energy_balance_error < 1e-3
    pressure, (t_x, t_z), (s_x, s_z) = r.pressure, r.shear_traction, r.slip_velocity
    top = pressure.max()
    size = np.hypot(t_x, t_z)
    # Conditions hold as forces to 1e-9 of the load, distributed over thousands of nodes.
    assert (pressure[r.contact] > -1e-6 * top).all()
    assert (pressure[~r.contact] == 0.0).all()
    assert (r.gap[~r.contact] > -1e-8 * r.penetration).all()
    assert np.abs(r.gap[r.contact]).max() < 1e-7 * r.penetration
    assert (size[r.stick] <= mu * pressure[r.stick] + 1e-6 * top).all()
    speed = SLOW * paper_ball.outer_radius
    assert np.hypot(s_x, s_z)[r.stick].max(initial=0.0) < 1e-6 * speed
    np.testing.assert_allclose(size[r.slip], mu * pressure[r.slip], rtol=0.0, atol=1e-6 * top)
    assert (t_x * s_x + t_z * s_z)[r.slip].max(initial=0.0) < 1e-6 * mu * top * speed  # against the slip


def one_layer(core_radius, thickness, modulus, **options):
    return vr.CoatedSphere(
        core_radius=core_radius, layers=[vr.Layer(thickness=thickness, shear_modulus=modulus, **options)]
    )


HARD = {
    # Contacts of 1 to 34 nodes, in which the iteration from full stick does not converge.
    "slippery, driven hard": (
        one_layer(
            0.23718672545634156,
            0.013437919475546853,
            vr.StandardLinearSolid(
                instantaneous_modulus=239257309.13, relaxed_modulus=24578580.237, relaxation_time=0.0010246653446
            ),
            poisson_ratio=0.0,
        ),
        102,
        {"load": 1081.69546, "angular_speed": 0.238184636, "mu": 0.0074393765, "drive": vr.Drive(torque=1.79651391)},
    ),
    "slippery, braked": (
        one_layer(
            0.027883503794322577,
            0.002708314341636647,
            vr.StandardLinearSolid(instantaneous_modulus=68172942.95, relaxed_modulus=34086471.47, relaxation_time=0.1),
            poisson_ratio=0.0,
        ),
        400,
        {
            "load": 2.04979306,
            "angular_speed": 4.44567347,
            "mu": 0.003726635,
            "drive": vr.Drive(torque=-0.00011845147),
            "compliance": enums.Compliance.VERTICAL,
        },
    ),
}


@pytest.mark.parametrize(("ball", "nodes", "options"), HARD.values(), ids=HARD)
def test_states_that_iterations_from_full_stick_do_not_reach(ball, nodes, options):
    mesh = vr.Mesh(nodes_per_revolution=nodes, max_order=nodes)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", vr.ResultWarning)  # few nodes on purpose
        assert_conditions_hold(roll(ball, mesh=mesh, **options))


def test_towed_ball_solved_from_a_state_of_less_friction():
    # Iterations from full stick and from zero friction diverge; those from mu = 0.3 converge.
    material = vr.Prony(
        instantaneous_modulus=15004.339,
        weights=[0.28282342, 0.16715161, 0.44998299, 0.09714387],
        relaxation_times=[0.2956124, 0.0158124, 0.03131925, 0.01266611],
    )
    layer = vr.Layer(thickness=0.01957976, shear_modulus=material, poisson_ratio=-0.9222953)
    r = vr.solve(
        vr.CoatedSphere(core_radius=0.00871902, layers=[layer]),
        load=4.01647e-05,
        angular_speed=0.01755485,
        friction=3.7270738,
        drive=vr.Drive(torque=0.0),
        compliance=enums.Compliance.VERTICAL,
        curvature=enums.Curvature.PAPER,
        mesh=vr.Mesh(nodes_per_revolution=1397),
    )
    assert_conditions_hold(r)
