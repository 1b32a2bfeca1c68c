"""States of stick and slip that are hard to find, each of which was missed or took minutes once."""

from __future__ import annotations

import numpy as np
import pytest
import viscoroll as vr


def creep(r):
    """Return the largest slip of the nodes that stick, per slip that the ball's curvature asks for."""
    curving = (r.semi_axis_x / r.ball.outer_radius) ** 2 * r.angular_speed * r.ball.outer_radius
    return np.hypot(*r.slip_velocity)[r.stick].max() / curving


@pytest.mark.filterwarnings("ignore::viscoroll.ResultWarning")  # a load that presses the coating to a tenth
def test_shear_that_is_a_small_part_of_the_load():
    # 59 862 nodes in contact. Every other node's state, known to 1e-4 of the load, was no start: no end in 100 s.
    layer = vr.Layer(thickness=5.91e-5, shear_modulus=vr.Elastic(modulus=1.966e6), bulk_modulus=2.089e8)
    r = vr.solve(
        vr.CoatedSphere(core_radius=0.015417, layers=[layer]),
        load=449.0,
        angular_speed=0.01266,
        friction=16.58,
        drive=vr.Drive(creepage=1.211e-4),
        curvature=vr.Curvature.PAPER,
        mesh=vr.Mesh(nodes_per_revolution=9628),
    )
    assert r.contact.sum() > 50_000
    assert r.status is vr.Status.CONVERGED
    assert r.residual < 1e-10


def test_finer_meshes_start_from_who_touches_and_sticks_on_coarser_ones():
    # Forces between coarse nodes make a third of this contact lift off. It came back row by row, in more steps than
    # there were: no state was found.
    def modulus(omega):
        return 1.217e9 + 2.864e8 * (0.04688j * omega) ** 0.1348

    r = vr.solve(
        vr.CoatedSphere(
            core_radius=0.1056, layers=[vr.Layer(thickness=0.0768, shear_modulus=modulus, poisson_ratio=0.5)]
        ),
        load=9.405e6,
        angular_speed=8.504,
        friction=0.27,
        drive=vr.Drive(creepage=-3.524e-4, lateral_creepage=1.035e-3),
        patch_load="SPHERICAL",
        curvature="PAPER",
        mesh=vr.Mesh(nodes_per_revolution=1664),
    )
    assert r.status is vr.Status.CONVERGED
    assert r.contact.sum() > 20_000
    assert r.iterations < 15


def test_friction_gives_no_power():
    # All of this contact sticks but for nodes at its edge; the way of those that leave it counted as work gained.
    layers = [
        vr.Layer(
            thickness=1.172e-5, shear_modulus=vr.KelvinVoigt(modulus=5.342e7, viscosity=222.4), poisson_ratio=-0.577
        ),
        vr.Layer(thickness=4.17e-6, shear_modulus=vr.KelvinVoigt(modulus=5.041e7, viscosity=209.9), poisson_ratio=0.5),
        vr.Layer(
            thickness=3.317e-5, shear_modulus=vr.KelvinVoigt(modulus=1.954e7, viscosity=81.37), bulk_modulus=5.073e7
        ),
    ]
    r = vr.solve(
        vr.CoatedSphere(core_radius=0.01244, layers=layers),
        load=3.1226e-4,
        angular_speed=24.21,
        friction=5.103,
        drive=vr.Drive(force=0.0),
        compliance="VERTICAL",
        mesh=vr.Mesh(nodes_per_revolution=17_571, theta_nodes_per_revolution=27_691),
    )
    assert r.stick.sum() > 0.95 * r.contact.sum()
    assert r.slip_power >= 0.0


def test_steps_go_on_while_they_lead_there():
    # A soft skin pulled back by 0.8 of the load. Newton steps came ever closer, but there were 25 of them.
    layers = [
        vr.Layer(thickness=5.402196e-4, shear_modulus=vr.Elastic(modulus=2942759.7), poisson_ratio=-0.597922),
        vr.Layer(thickness=2.893813e-4, shear_modulus=vr.Elastic(modulus=56739.365), poisson_ratio=0.49814232),
    ]
    r = vr.solve(
        vr.CoatedSphere(core_radius=0.048514838, layers=layers),
        load=1.06738,
        angular_speed=0.874645,
        friction=7.71875,
        drive=vr.Drive(force=-0.850685),
        patch_load="SPHERICAL",
        mesh=vr.Mesh(nodes_per_revolution=678, theta_nodes_per_revolution=1037),
    )
    assert r.status is vr.Status.CONVERGED
    assert r.residual < 1e-9
    assert r.driving_force == -0.850685
    assert (np.hypot(*r.shear_traction) <= r.friction * r.pressure + 1e-8 * r.max_pressure).all()


def test_steps_that_shorten_are_not_at_their_end():
    # With little friction a residual of 1e-8 of the load is 1e-6 of what friction bears: steps that were shortened
    # there were taken for the last ones, and nodes that stick crept by 2 % of the fastest slip.
    layers = [
        vr.Layer(thickness=thickness, shear_modulus=vr.Elastic(modulus=modulus), poisson_ratio=0.5)
        for thickness, modulus in ((1.128e-4, 1.358e9), (3.698e-5, 2.269e9), (7.376e-5, 1.389e9))
    ]
    r = vr.solve(
        vr.CoatedSphere(core_radius=0.05014, layers=layers, inner_boundary="HOLLOW"),
        load=0.01358,
        angular_speed=10.66,
        friction=0.004819,
        drive=vr.Drive(force=4.076e-6),
        mesh=vr.Mesh(nodes_per_revolution=523008),
    )
    speed = np.hypot(*r.slip_velocity)
    assert speed[r.stick].max() < 1e-6 * speed.max()


def test_free_steps_that_go_astray_are_taken_back():
    # The first steps may raise the residual. From where they had led, 102 steps did not lead back.
    layer = vr.Layer(
        thickness=1.0936e-3,
        shear_modulus=vr.KelvinVoigt(modulus=4.3573e6, viscosity=2.2301e8),
        poisson_ratio=0.1386,
    )
    r = vr.solve(
        vr.CoatedSphere(core_radius=1.7011e-4, layers=[layer]),
        load=0.0080243,
        angular_speed=0.0011611,
        friction=5.0264,
        drive=vr.Drive(creepage=8.4358e-5),
        patch_load="SPHERICAL",
        mesh=vr.Mesh(nodes_per_revolution=1100),
    )
    assert r.status is vr.Status.CONVERGED
    assert r.iterations < 60


@pytest.mark.filterwarnings("ignore::viscoroll.ResultWarning")
def test_a_load_that_is_far_beyond_the_coating_is_refused_as_such():
    # 4e16 N: on the exact sphere it ended in "the contact equations were not solved".
    layer = vr.Layer(
        thickness=0.00099014,
        shear_modulus=vr.Prony(
            instantaneous_modulus=2.8603e9, weights=[0.67155, 0.087509], relaxation_times=[21.689, 3.1106]
        ),
        poisson_ratio=0.5,
    )
    with pytest.raises(ValueError, match=r"load must be small enough for the coating, got 4\.28e\+16 N"):
        vr.solve(
            vr.CoatedSphere(core_radius=0.75431, layers=[layer]),
            load=4.28e16,
            angular_speed=0.10616,
            curvature="EXACT",
            mesh=vr.Mesh(nodes_per_revolution=2095, theta_nodes_per_revolution=2369),
        )


def test_a_path_that_turns_back_to_less_friction():
    # From a friction of 0.3 to 5.2 no steps of friction alone led: 185 in vain.
    modulus = vr.Prony(
        instantaneous_modulus=904371004.070464,
        weights=[0.28625034958712753, 0.30180048382485763, 0.0918902540495217, 0.1424543116239465],
        relaxation_times=[1.2499564441540212, 37.479238947267426, 83.13557608642967, 1.9871162996488172],
    )
    layer = vr.Layer(
        thickness=0.15264416208613413,
        shear_modulus=modulus,
        poisson_ratio=0.06957122702668034,
        density=1197.660963155148,
    )
    r = vr.solve(
        vr.CoatedSphere(core_radius=0.06411096514823905, layers=[layer], inner_boundary="HOLLOW"),
        load=2348906.924483077,
        angular_speed=0.0334120318758935,
        friction=5.178106834836993,
        drive=vr.Drive(creepage=-0.0003657313647978389, lateral_creepage=-0.0007012716902450234),
        patch_load="SPHERICAL",
        mesh=vr.Mesh(nodes_per_revolution=132),
    )
    assert r.status is vr.Status.CONVERGED
    assert r.residual < 1e-10
    assert (np.hypot(*r.shear_traction) <= r.friction * r.pressure + 1e-8 * r.max_pressure).all()


@pytest.mark.filterwarnings("ignore::viscoroll.ResultWarning")
def test_nodes_that_stick_rest_on_meshes_of_a_million_nodes():
    # A residual of 1e-10 of the load left them 1e-4 of the slip that the ball's curvature asks for.
    layers = [
        vr.Layer(
            thickness=2.3405e-5,
            shear_modulus=vr.Prony(
                instantaneous_modulus=2.3453e7,
                weights=[0.24119, 0.19221, 0.405, 0.0047675],
                relaxation_times=[5.3196e-4, 2.0781e-3, 2.0231e-3, 5.6985e-6],
            ),
            bulk_modulus=2.3915e6,
            density=563.47,
        ),
        vr.Layer(
            thickness=4.8504e-5,
            shear_modulus=vr.FractionalZener(
                instantaneous_modulus=8.8409e9, relaxed_modulus=2.0795e9, relaxation_time=2.3213e-3, order=0.73216
            ),
            poisson_ratio=0.5,
            density=316.7,
        ),
    ]
    r = vr.solve(
        vr.CoatedSphere(core_radius=0.013426, layers=layers, inner_boundary="HOLLOW"),
        load=1.2677e-5,
        angular_speed=66.348,
        friction=1.3514,
        drive=vr.Drive(force=0.0),
        compliance="VERTICAL",
        curvature="PAPER",
        accuracy=0.040518,
    )
    assert r.stick.any()
    assert creep(r) < 1e-6


def test_nodes_that_stick_rest_beside_a_ten_millionth_of_the_rolling_speed():
    # A contact of 12 um under a ball of 0.55 m: slip is some 1e-10 of the speed, so that the round-off of the ratio of
    # speeds left nodes at rest 2e-6 of it. The creepage as the unknown leaves 6e-10.
    modulus = vr.Prony(
        instantaneous_modulus=2.246853447932907e9,
        weights=[0.06469799415988227, 0.19358778925079037],
        relaxation_times=[3.891578882323105e-05, 1.746250576358911e-05],
    )
    layer = vr.Layer(thickness=0.007085507079383882, shear_modulus=modulus, poisson_ratio=0.4708800155299279)
    with pytest.warns(vr.ResultWarning):
        r = vr.solve(
            vr.CoatedSphere(core_radius=0.545118707547674, layers=[layer]),
            load=3.302054075311079e-05,
            angular_speed=21.338871936308994,
            friction=1.056057211393157,
            drive=vr.Drive(torque=0.0),
            patch_load="FLAT",
            curvature="EXACT",
            accuracy=0.08805860340451141,
        )
    assert r.stick.any()
    assert creep(r) < 1e-8


def test_a_drive_between_the_states_of_two_creepages():
    # The moment falls from 2.5 to 1.95 mN m as the creepage passes -0.033; the states between are on a piece of their
    # path that leads back, which halving the creepage does not find.
    modulus = vr.Prony(
        instantaneous_modulus=719306705.8964465,
        weights=[
            0.11776874943618196,
            0.24953626248974753,
            0.10311469824515498,
            0.15961091109345082,
            0.0058231079540967,
        ],
        relaxation_times=[
            0.08246223585170435,
            0.022630251619810332,
            0.08977084313554048,
            0.00913250291033089,
            0.8836423948824675,
        ],
    )
    layer = vr.Layer(thickness=8.29155541701685e-06, shear_modulus=modulus, poisson_ratio=0.49999972521432157)
    ball = vr.CoatedSphere(core_radius=0.005190828126701303, layers=[layer])
    options = {
        "load": 0.6328787337473702,
        "angular_speed": 0.0010937770860999462,
        "friction": 4.873506559562861,
        "patch_load": "SPHERICAL",
        "mesh": vr.Mesh(nodes_per_revolution=1193),
    }
    torque = 0.0022444622585602344
    r = vr.solve(ball, drive=vr.Drive(torque=torque), **options)
    assert r.driving_torque == pytest.approx(torque, rel=1e-9)
    before, beyond = (vr.solve(ball, drive=vr.Drive(creepage=c), **options) for c in (-0.032143, -0.034))
    assert before.driving_torque < 0.88 * torque < 1.1 * torque < beyond.driving_torque
    assert -0.034 < r.creepage < -0.025


def test_a_torque_beyond_all_bounds_is_refused_where_sliding_is_not_found_either():
    # 3.6 kN m on a ball that bears 0.26 N: "no state of stick and slip was found", after nine seconds.
    modulus = vr.KelvinVoigt(modulus=13348521.186386554, viscosity=14954528.947156366)
    layer = vr.Layer(thickness=0.001182181613242, shear_modulus=modulus, poisson_ratio=-0.8830705098552052)
    with pytest.raises(ValueError, match=r"drive\.torque must be between .*, got 3582 N m"):
        vr.solve(
            vr.CoatedSphere(core_radius=0.15971143481770236, layers=[layer]),
            load=0.25529711471004896,
            angular_speed=0.0023035056398902046,
            friction=1.4032188238593115,
            drive=vr.Drive(torque=3582.0),
            curvature="PAPER",
            patch_load="FLAT",
            accuracy=0.08253266122616099,
        )


@pytest.mark.filterwarnings("ignore::viscoroll.ResultWarning")  # of the strain
def test_a_contact_that_fits_with_friction_if_it_fits_without():
    # Every fourth node of the widest window ends within the contact: the load was refused, with friction alone.
    modulus = vr.StandardLinearSolid(instantaneous_modulus=1e6, relaxed_modulus=5e5, relaxation_time=0.1)
    layer = vr.Layer(thickness=21e-3, shear_modulus=modulus, poisson_ratio=0.3)
    ball = vr.CoatedSphere(layers=[layer], inner_boundary="SOLID")
    mesh = vr.Mesh(nodes_per_revolution=200)
    smooth, rough = (vr.solve(ball, load=500.0, angular_speed=2.5, friction=mu, mesh=mesh) for mu in (0.0, 0.3))
    assert rough.contact.sum() == pytest.approx(smooth.contact.sum(), rel=0.1)


def test_a_load_that_flattens_a_shell_is_refused_as_such():
    # 37 kN on a shell of 13 um and a ball of 1.7 mm: 364 products did not solve a system of 1006 forces, which "the
    # contact equations were not solved" told nobody.
    modulus = vr.StandardLinearSolid(
        instantaneous_modulus=4937432452.587377, relaxed_modulus=4597820.530129998, relaxation_time=1.0144709103164116
    )
    layer = vr.Layer(
        thickness=1.2930987169406665e-05, shear_modulus=modulus, poisson_ratio=0.5, density=204.66434559242396
    )
    with pytest.raises(ValueError, match="load must be small enough for the coating, got 37088"):
        vr.solve(
            vr.CoatedSphere(core_radius=0.0016848279278736148, layers=[layer], inner_boundary="HOLLOW"),
            load=37088.96930900707,
            angular_speed=0.0402996034497067,
            mesh=vr.Mesh(nodes_per_revolution=1865),
        )


def test_harmonics_beyond_memory_are_refused_by_the_order_that_asks_for_them(paper_ball):
    mesh = vr.Mesh(nodes_per_revolution=400, max_order=200_000)
    with pytest.raises(
        ValueError, match=r"mesh\.max_order must be small enough for .* values of harmonics, got 200000"
    ):
        vr.solve(paper_ball, load=10.0, angular_speed=1.0, curvature="EXACT", mesh=mesh)
