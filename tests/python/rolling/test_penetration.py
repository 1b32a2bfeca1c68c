"""Solutions at a given penetration: they are those at the load that causes it, and agree with closed forms."""

from __future__ import annotations

import math
import re

import numpy as np
import pytest
import viscoroll as vr
from viscoroll import analytic, enums, paper
from viscoroll.case import build_case

from tests.shared_cases import RUBBER, coated_ball, one_layer

#: The solver stops at residuals of 1e-11 without friction, and of 1e-10 of the load with friction.
SAME = 1e-9

#: The tables of the exact sphere depend on the window, whose first guess is another one (`RollingModel`).
SAME_TABLES = 1e-6

BALL = coated_ball()
HEAVY = coated_ball(density=1000.0, poisson_ratio=0.4)  # an incompressible layer would not grow
STEEL = vr.CoatedSphere(core_radius=21e-3)
SOLID = vr.CoatedSphere(layers=[one_layer(thickness=10e-3, poisson_ratio=0.3)], inner_boundary="solid")
MAT = vr.CoatedPlane(layers=[one_layer(thickness=2e-3, poisson_ratio=0.4)])
HALF_SPACE = vr.CoatedPlane(base=vr.HalfSpace(shear_modulus=RUBBER, poisson_ratio=0.5))
ROLLER = vr.CoatedCylinder(core_radius=50e-3, layers=[one_layer(thickness=5e-3)])
STEEL_ROLLER = vr.CoatedCylinder(core_radius=80e-3)
WHEEL = vr.CoatedWheel(core_radius=20e-3, width=20e-3, layers=[one_layer(thickness=5e-3)])
CROWNED = vr.CoatedWheel(core_radius=20e-3, width=20e-3, crown_radius=30e-3, layers=[one_layer(thickness=5e-3)])

#: Body, counterbody, load, speed, nodes per revolution, further arguments.
PAIRS = {
    "ball": (BALL, None, 100.0, 2.5, 400, {}),
    "vertical compliance": (BALL, None, 100.0, 2.5, 250, {"compliance": "vertical"}),
    "fast ball": (HEAVY, None, 20.0, 600.0, 600, {}),
    "barely touching fast ball": (HEAVY, None, 0.05, 600.0, 1500, {}),
    "exact ball": (BALL, None, 100.0, 2.5, 200, {"curvature": "exact"}),
    "solid ball": (SOLID, None, 20.0, 2.5, 120, {"curvature": "exact"}),
    "ball on a mat": (BALL, MAT, 100.0, 2.5, 200, {}),
    "steel ball on a mat": (STEEL, MAT, 100.0, 2.5, 200, {}),
    "steel ball on a half-space": (STEEL, HALF_SPACE, 20.0, 2.5, 200, {}),
    "wheel on a half-space": (CROWNED, HALF_SPACE, 50.0, 2.5, 100, {}),
    "ball in a groove": (BALL, vr.Groove(radius=30e-3), 100.0, 2.5, 200, {}),
    "two balls": (BALL, BALL, 50.0, 2.5, 200, {}),
    "roller": (ROLLER, None, 5e3, 2.5, 2000, {}),
    "roller on a soft roller": (ROLLER, ROLLER, 5e3, 2.5, 2000, {}),
    "roller in a ring": (ROLLER, vr.Groove(path_radius=0.1), 5e3, 2.5, 2000, {}),
    "steel roller on a mat": (STEEL_ROLLER, MAT, 5e3, 2.5, 2000, {}),
    "wheel": (WHEEL, None, 300.0, 2.5, 120, {}),
    "crowned wheel on a drum": (CROWNED, STEEL_ROLLER, 200.0, 2.5, 120, {}),
    "two wheels": (CROWNED, CROWNED, 100.0, 2.5, 120, {}),
}

FRICTION = {
    "frictionless": {},
    "with a torque": {"friction": 0.3},
    "towed": {"friction": 0.3, "drive": vr.Drive(torque=0.0)},
    "with a creepage": {"friction": 0.1, "drive": vr.Drive(creepage=0.004)},
}


@pytest.mark.parametrize("friction", FRICTION)
@pytest.mark.parametrize("pair", PAIRS)
def test_the_penetration_of_a_load_gives_back_the_load(pair, friction):
    body, on, load, speed, nodes, further = PAIRS[pair]
    options = {"on": on, "angular_speed": speed, "mesh": vr.Mesh(nodes_per_revolution=nodes), **further}
    options |= FRICTION[friction]
    loaded = vr.solve(body, load=load, **options)
    pressed = vr.solve(body, penetration=loaded.penetration, **options)
    allowed = SAME_TABLES if "curvature" in further else SAME
    assert pressed.status is enums.Status.CONVERGED
    assert (loaded.prescribed, pressed.prescribed) == ("load", "penetration")
    assert pressed.penetration == loaded.penetration, "a given penetration is returned unchanged"
    assert pressed.load == pytest.approx(load, rel=allowed)
    arm = load * loaded.semi_axis_x
    assert pressed.resisting_torque == pytest.approx(loaded.resisting_torque, abs=allowed * arm)
    assert pressed.dissipated_power == pytest.approx(loaded.dissipated_power, abs=allowed * arm * speed)
    assert pressed.driving_force == pytest.approx(loaded.driving_force, abs=allowed * load)
    assert (pressed.contact.sum(), pressed.stick.sum()) == (loaded.contact.sum(), loaded.stick.sum())


@pytest.mark.parametrize(
    "pair", ["ball", "steel ball on a half-space", "roller", "wheel", "fast ball", "wheel on a half-space"]
)
def test_the_chosen_mesh_reaches_the_accuracy(pair):
    body, on, load, speed, _, _ = PAIRS[pair]
    options = {"on": on, "angular_speed": speed, "accuracy": 0.01}
    loaded = vr.solve(body, load=load, **options)
    pressed = vr.solve(body, penetration=loaded.penetration, **options)
    assert pressed.status is enums.Status.CONVERGED
    assert pressed.load == pytest.approx(load, rel=0.01)
    assert pressed.resisting_torque == pytest.approx(loaded.resisting_torque, rel=0.02)  # the accuracy of both
    # The estimate of the contact from its penetration gives meshes as fine as that from its load.
    assert 0.4 < pressed.refinements[0].contact_nodes / loaded.refinements[0].contact_nodes < 2.5


def test_hertz_contact_of_a_half_space():
    # R = 20 mm, G = 3 MPa, nu = 1/2: P = 4/3 E* sqrt(R) d^(3/2) with E* = 2 G / (1 - nu)
    ground = vr.CoatedPlane(base=vr.HalfSpace(shear_modulus=vr.Elastic(modulus=3e6), poisson_ratio=0.5))
    for depth in (0.05e-3, 0.2e-3):
        r = vr.solve(vr.CoatedSphere(core_radius=20e-3), on=ground, penetration=depth, angular_speed=1.0, accuracy=1e-3)
        # the paraboloid of Hertz and the sphere of the library differ by the order of d/R
        assert r.load == pytest.approx(4.0 / 3.0 * 12e6 * math.sqrt(20e-3) * depth**1.5, rel=1e-3 + depth / 20e-3)
        assert analytic.hertz(
            load=r.load, radius=20e-3, shear_modulus=3e6, poisson_ratio=0.5
        ).approach == pytest.approx(depth, rel=1e-3 + depth / 20e-3)


def test_thin_compressible_layer():
    # Winkler foundation of the confined modulus M = 2 G (1 - nu) / (1 - 2 nu): P = pi M R d^2 / h, for h << a
    layer = one_layer(vr.Elastic(modulus=1e6), thickness=0.02e-3, poisson_ratio=0.2)
    ball = vr.CoatedSphere(core_radius=20e-3, layers=[layer])
    depth = 1e-3 * layer.thickness
    r = vr.solve(ball, penetration=depth, angular_speed=1.0, accuracy=1e-3)
    confined = 2.0 * 1e6 * 0.8 / 0.6
    # The edge of the contact carries more than the foundation by the order of h/a = 0.1 (analytic.thin_layer).
    assert r.load == pytest.approx(math.pi * confined * ball.outer_radius * depth**2 / layer.thickness, rel=0.15)
    assert r.load > math.pi * confined * ball.outer_radius * depth**2 / layer.thickness


def test_centrifugal_growth_presses_a_body_at_a_negative_penetration():
    # The radius at rest is smaller than the height of the center, but the body has grown.
    options = {"angular_speed": 600.0, "mesh": vr.Mesh(nodes_per_revolution=1500)}
    r = vr.solve(HEAVY, load=1e-3, **options)
    growth = r.centrifugal_displacement
    assert growth > 0.0
    for depth in (-0.5 * growth, 0.0, 0.5 * growth):
        pressed = vr.solve(HEAVY, penetration=depth, **options)
        assert pressed.penetration == depth
        assert pressed.load == pytest.approx(vr.solve(HEAVY, load=pressed.load, **options).load)
        again = vr.solve(HEAVY, load=pressed.load, **options)
        assert again.penetration == pytest.approx(depth, abs=1e-9 * growth)
    with pytest.raises(ValueError, match=rf"^penetration must be > -{growth:.3g}".replace(".", r"\.")):
        vr.solve(HEAVY, penetration=-1.001 * growth, **options)


def test_a_model_solves_both():
    model = vr.RollingModel(BALL, angular_speed=2.5, mesh=vr.Mesh(nodes_per_revolution=400))
    loaded = model.solve(load=50.0, friction=0.3)
    assert model.solve(penetration=loaded.penetration, friction=0.3).load == pytest.approx(50.0, rel=SAME)
    # shared starting points belong to one load or one penetration
    assert model.solve(penetration=1.2 * loaded.penetration, friction=0.3).load > 60.0


ERRORS = [
    (BALL, {}, "load must be given, or penetration instead of it, got neither"),
    (BALL, {"load": 1.0, "penetration": 1e-4}, "penetration must be left out if the load is given, got 1e-04 m"),
    (BALL, {"penetration": -1e-4}, "penetration must be > 0 m, got -1e-04 m"),
    (BALL, {"penetration": 0.0}, "penetration must be > 0 m, got 0 m"),
    (BALL, {"penetration": 1e-3}, "penetration must be < 0.001 m, the thickness of the coating, got 0.001 m"),
    (BALL, {"penetration": math.nan}, "penetration must be finite, got nan"),
    (BALL, {"penetration": math.inf}, "penetration must be finite, got inf"),
    (
        ROLLER,
        {"penetration": 1e-4, "on": HALF_SPACE},
        "penetration must be left out in line contact on a half-space, where it is undetermined: give the load, "
        "got 1e-04 m",
    ),
]


@pytest.mark.parametrize("mesh", [None, vr.Mesh(nodes_per_revolution=200)])
@pytest.mark.parametrize(("body", "given", "message"), ERRORS)
def test_messages(body, given, message, mesh):
    with pytest.raises(ValueError, match=f"^{re.escape(message)}$"):
        vr.solve(body, angular_speed=2.5, mesh=mesh, **given)


def test_wrong_type():
    with pytest.raises(TypeError, match=r"^penetration must be a real number, got str '1 mm'$"):
        vr.solve(BALL, penetration="1 mm", angular_speed=2.5)


def test_impossible_drive():
    # The load is unknown before the solution, so the range of the force follows from sliding bodies.
    mesh = vr.Mesh(nodes_per_revolution=200)
    with pytest.raises(ValueError, match=r"^drive\.force must be between .* N, otherwise the ball slides permanently"):
        vr.solve(BALL, penetration=1e-4, angular_speed=2.5, friction=0.1, drive=vr.Drive(force=1e3), mesh=mesh)


def test_large_penetration_warns():
    with pytest.warns(vr.ResultWarning, match="the strain, penetration / coating thickness, is 0.3 "):
        r = vr.solve(BALL, penetration=0.3e-3, angular_speed=2.5, mesh=vr.Mesh(nodes_per_revolution=300))
    assert enums.WarningKind.LARGE_STRAIN in r.warnings


def test_text_names_what_was_given():
    r = vr.solve(BALL, penetration=1e-4, angular_speed=2.5, mesh=vr.Mesh(nodes_per_revolution=300))
    assert repr(r).startswith("Result of penetration = 0.1 mm, ")
    assert "normal load P  " in repr(r)
    assert r.unit("load") == "N"
    assert r.scalars()["load"] == r.load


@pytest.mark.parametrize("friction", [0.0, 0.3])
def test_sensitivities_to_penetration_are_those_of_the_inverse_problem(friction):
    # P(d) is the inverse of d(P): d ln P / d ln d = 1 / (d ln d / d ln P). Torques follow by the chain rule.
    options = {"angular_speed": 2.5, "friction": friction, "mesh": vr.Mesh(nodes_per_revolution=300)}
    loaded = vr.solve(BALL, load=50.0, **options)
    pressed = vr.solve(BALL, penetration=loaded.penetration, **options)
    of_load, of_depth = loaded.sensitivity(), pressed.sensitivity()
    assert "penetration" not in of_load.parameters
    assert "load" not in of_depth.parameters
    stiffness = of_depth["penetration"]["load"]
    # difference quotients with steps of 1e-4 have errors of 1e-8, with friction of the residual per step
    near = {"rel": 1e-6 if friction == 0.0 else 1e-4}
    assert stiffness == pytest.approx(1.0 / of_load["load"]["penetration"], **near)
    torque = of_load["load"]["resisting_torque"]
    assert of_depth["penetration"]["resisting_torque"] == pytest.approx(stiffness * torque, **near)
    # at a given penetration, the load changes so that the penetration does not
    by_speed = of_load["angular_speed"]
    assert of_depth["angular_speed"]["load"] == pytest.approx(-by_speed["penetration"] * stiffness, abs=1e-4)


def test_study_over_penetration(tmp_path):
    depths = [0.5e-4, 1e-4]
    options = {"angular_speed": 2.5, "mesh": vr.Mesh(nodes_per_revolution=300), "progress": False}
    study = vr.sweep(BALL, penetration=depths, cache=tmp_path / "study.nc", **options)
    assert study["load"].dims == ("penetration",)
    assert study.penetration.attrs["units"] == "m"
    assert study["load"].attrs["units"] == "N"
    for depth in depths:
        r = vr.solve(BALL, penetration=depth, angular_speed=2.5, mesh=options["mesh"])
        assert study["load"].sel(penetration=depth) == pytest.approx(r.load, rel=1e-9)
    # The cache distinguishes penetrations, and penetrations from loads of the same number.
    again = vr.sweep(BALL, penetration=[0.5e-4, 1.5e-4], cache=tmp_path / "other.nc", **options)
    assert again["load"].values[0] == pytest.approx(study["load"].values[0])
    assert again["load"].values[1] > study["load"].values[1]
    by_load = vr.sweep(BALL, load=[1.0], cache=tmp_path / "load.nc", **options)
    by_depth = vr.sweep(BALL, penetration=[1e-4], cache=tmp_path / "load2.nc", **options)
    assert by_load.penetration.dims == ("load",)
    assert by_depth["load"].values[0] != by_load["load"].values[0]


def test_study_needs_one_of_both():
    with pytest.raises(TypeError, match=r"^sweep requires load"):
        vr.sweep(BALL, angular_speed=2.5, progress=False)


def test_case_file_equals_python():
    document = {
        "ball": {"core_radius": 20e-3, "layers": [{"thickness": 1e-3, "shear_modulus": 3e6, "poisson_ratio": 0.5}]},
        "rolling": {"penetration": 1e-4, "angular_speed": 2.5, "friction": 0.2},
        "numerics": {"nodes_per_revolution": 300},
    }
    case = build_case(document, None)
    ball = vr.CoatedSphere(core_radius=20e-3, layers=[one_layer(vr.Elastic(modulus=3e6))])
    direct = vr.solve(ball, penetration=1e-4, angular_speed=2.5, friction=0.2, mesh=vr.Mesh(nodes_per_revolution=300))
    assert case.solve().scalars() == direct.scalars()
    for given, message in (
        ({"angular_speed": 2.5}, r"rolling\.load must be given"),
        ({"angular_speed": 2.5, "lod": 1.0}, r"rolling\.lod is not a parameter, got 1\.0; did you mean load\?"),
    ):
        with pytest.raises(ValueError, match=message):
            build_case(document | {"rolling": given}, None)
    with pytest.raises(ValueError, match=r"^penetration must be left out if the load is given"):
        build_case(document | {"rolling": document["rolling"] | {"load": 1.0}}, None).solve()


def test_strain_softening_at_a_penetration():
    network = vr.materials.MasingNetwork(storage=6e6, critical_strain=0.01)
    tread = vr.materials.SofteningModulus(matrix=RUBBER, network=network)
    roller = vr.CoatedCylinder(core_radius=50e-3, layers=[one_layer(tread, thickness=1e-2)])
    options = {"angular_speed": 2.5, "mesh": vr.Mesh(nodes_per_revolution=600)}
    loaded = vr.strain_softening(roller, load=2e3, **options)
    pressed = vr.strain_softening(roller, penetration=loaded.result.penetration, **options)
    # The reference frequency of the networks follows from the contact length of an early pass, in whole nodes of which
    # there are about 50, and the strain amplitudes from the tolerance of 1e-3.
    assert pressed.result.load == pytest.approx(2e3, rel=5e-3)
    assert np.allclose(pressed.layer_amplitudes, loaded.layer_amplitudes, rtol=5e-3)


def test_paper_ball_at_a_fixed_gap():
    # A stiffer coating carries more load in the same gap, and less penetration at the same load.
    options = {"penetration": 1e-4, "mesh": vr.Mesh(nodes_per_revolution=400)}
    slow = vr.solve(paper.ball(), angular_speed=0.01, **options)
    fast = vr.solve(paper.ball(), angular_speed=50.0, **options)
    # relaxed and instantaneous modulus of 3 and 6 MPa
    assert 1.8 < fast.load / slow.load < 2.2
