"""Input checks: every entry raises an exception that names parameter, value, unit and allowed range."""

from __future__ import annotations

import math
from fractions import Fraction

import numpy as np
import pytest
import viscoroll as vr
from viscoroll import enums, paper

SLS = {"instantaneous_modulus": 6e6, "relaxed_modulus": 3e6, "relaxation_time": 0.125}
PRONY = {"instantaneous_modulus": 6e6, "weights": [0.3, 0.2], "relaxation_times": [0.1, 1.0]}
LOSS = {"modulus": 1e6, "loss_factor": 0.1, "reference_frequency": 1.0}
ZENER = SLS | {"order": 0.5}
CREEP = {"instantaneous_compliance": 1e-6, "compliances": [1e-6, 2e-6], "retardation_times": [0.1, 1.0]}
CURVE = {"frequency": [1.0, 10.0, 100.0], "storage": [1e6, 2e6, 3e6], "loss": [1e5, 2e5, 1e5]}
LAYER = {"thickness": 1e-3, "shear_modulus": vr.Elastic(modulus=3e6), "poisson_ratio": 0.5, "density": 1000.0}
BALL = {"core_radius": 20e-3, "layers": [vr.Layer(**LAYER)]}
CASE = {"load": 100.0, "angular_speed": 2.5}
MESH = {"nodes_per_revolution": 100, "max_order": 100}

NOT_POSITIVE = [-1.0, 0.0, math.nan, math.inf, -math.inf]


def solve(**changes):
    return vr.solve(paper.ball(), **CASE | changes)


POSITIVE = [
    (vr.Elastic, {"modulus": 1.0}, "modulus", "Pa"),
    (vr.StandardLinearSolid, SLS, "instantaneous_modulus", "Pa"),
    (vr.StandardLinearSolid, SLS, "relaxed_modulus", "Pa"),
    (vr.StandardLinearSolid, SLS, "relaxation_time", "s"),
    (vr.Prony, PRONY, "instantaneous_modulus", "Pa"),
    (vr.materials.CreepCompliance, CREEP, "instantaneous_compliance", "1/Pa"),
    (vr.LossFactor, LOSS, "modulus", "Pa"),
    (vr.LossFactor, LOSS, "reference_frequency", "rad/s"),
    (vr.materials.KelvinVoigt, {"modulus": 1.0, "viscosity": 1.0}, "modulus", "Pa"),
    (vr.materials.FractionalZener, ZENER, "relaxed_modulus", "Pa"),
    (vr.materials.FractionalZener, ZENER, "relaxation_time", "s"),
    (vr.materials.HavriliakNegami, ZENER | {"asymmetry": 0.5}, "relaxed_modulus", "Pa"),
    (vr.Layer, LAYER, "thickness", "m"),
    (vr.CoatedSphere, {"core_radius": 20e-3}, "core_radius", "m"),
    (solve, CASE, "load", "N"),
    (solve, CASE, "angular_speed", "rad/s"),
]


@pytest.mark.parametrize("value", NOT_POSITIVE)
@pytest.mark.parametrize(("make", "valid", "name", "unit"), POSITIVE)
def test_positive_numbers(make, valid, name, unit, value):
    with pytest.raises(ValueError, match=rf"^{name} must be > 0 {unit}, got {f'{value:g}'}$"):
        make(**valid | {name: value})


@pytest.mark.parametrize(("value", "limit"), [(1e-41, ">= 1e-40"), (1e300, r"<= 1e\+40")])
@pytest.mark.parametrize(("make", "valid", "name", "unit"), POSITIVE)
def test_numbers_out_of_range(make, valid, name, unit, value, limit):
    with pytest.raises(ValueError, match=rf"^{name} must be {limit} {unit}, got "):
        make(**valid | {name: value})


def coated(body=vr.CoatedSphere, core_radius=0.05, layers=({},), **changes):
    return body(core_radius=core_radius, layers=[vr.Layer(**LAYER | layer) for layer in layers], **changes)


THIN = coated(layers=({"thickness": 1e-9}, {"shear_modulus": vr.Elastic(modulus=6e6)}))
DAMPED = {"shear_modulus": vr.materials.KelvinVoigt(modulus=1e6, viscosity=1e3)}
TOO_MUCH_WORK = [
    # These inputs once took minutes; for the largest ratios of lengths, the solver did not return.
    (lambda: coated(core_radius=1e8), {}, r"layers\[0\].thickness must be at least 1e-09 of .*, 0.1 m, got 0.001 m"),
    (
        lambda: coated(vr.CoatedCylinder, core_radius=1e8),
        {},
        r"layers\[0\].thickness must be at least 1e-09 of the radius",
    ),
    (lambda: coated(vr.CoatedWheel, core_radius=1e8, width=0.02), {}, r"layers\[0\].thickness must be at least 1e-09"),
    (lambda: coated(core_radius=1e-12), {}, "core_radius must be at least 1e-09 of the radius"),
    (
        lambda: THIN,
        {},
        r"mesh.nodes_per_revolution must be at least 1\.02e\+04, because the thinnest layer .* got \d+$",
    ),
    (
        lambda: vr.CoatedSphere(core_radius=0.05),
        {"on": vr.CoatedPlane(layers=[vr.Layer(**LAYER | {"thickness": 1e-20})])},
        r"on.layers\[0\].thickness must be at least 1e-09 of the radius of the rolling body, 5e-11 m, got 1e-20 m",
    ),
    (
        lambda: coated(layers=(DAMPED,)),
        {"angular_speed": 2e9},
        "angular_speed must be so low .* 2.28e.03 times its shear-wave speed;",
    ),
    (lambda: coated(vr.CoatedWheel, width=1e-9), {}, "width must be at least 0.001 of the thickness .* got 1e-09 m"),
    (lambda: coated(vr.CoatedWheel, width=1e9), {}, "width must be at most 1000 times the outer radius, 5"),
    (
        lambda: coated(vr.CoatedWheel, width=0.02, crown_radius=1e9),
        {},
        "crown_radius must be at most 1e.06 times the outer radius, 5.*, or infinite .straight., got 1e.09 m",
    ),
]


@pytest.mark.parametrize(("body", "changes", "message"), TOO_MUCH_WORK)
def test_inputs_of_unlimited_work_are_rejected(body, changes, message):
    with pytest.raises(ValueError, match=message):
        vr.solve(body(), **CASE | changes)


@pytest.mark.parametrize(
    ("make", "valid", "name", "value"),
    [
        (make, valid, name, value)
        for make, valid, name, _ in POSITIVE
        for value in ("1.0", None, 1j, [1.0], np.ones(2), True)
        if value is not None or name not in ("load", "angular_speed")  # penetration or speed may be given instead
    ],
)
def test_values_that_are_not_numbers(make, valid, name, value):
    with pytest.raises(TypeError, match=rf"^{name} must be a real number, got "):
        make(**valid | {name: value})


@pytest.mark.parametrize(("sign", "exponent"), [(1, 400), (-3, 5000)])
@pytest.mark.parametrize(("make", "valid", "name", "unit"), POSITIVE)
def test_integers_beyond_floats(make, valid, name, unit, sign, exponent):
    # The second number also exceeds what Python prints in decimal.
    with pytest.raises(ValueError, match=rf"^{name} must be <= 1.8e\+308 in magnitude, got about {sign}e{exponent}$"):
        make(**valid | {name: sign * 10**exponent})


def test_numbers_beyond_floats_in_arrays(paper_ball):
    with pytest.raises(ValueError, match=r"^weights\[1\] must be <= 1.8e\+308 in magnitude, got about 1e400$"):
        vr.Prony(**PRONY | {"weights": [0.3, 10**400]})
    with pytest.raises(ValueError, match=r"^load must be <= .*, got Fraction\(1000.*\.\.\.$"):
        solve(load=Fraction(10**400))
    with pytest.raises(ValueError, match=r"^m\[0\] must fit into 32 bits, got about 1e400$"):
        vr.modal.surface_compliance(paper_ball, 2.5, [10**400], 1)
    with pytest.raises(ValueError, match=r"^max_order must fit into 32 bits, got about 1e5000$"):
        vr.Mesh(**MESH | {"max_order": 10**5000})


def test_numpy_scalars_are_numbers():
    assert solve(load=np.float32(100.0), angular_speed=np.array(2.5), mesh=vr.Mesh(**MESH)).load == 100.0


@pytest.mark.parametrize(
    ("make", "valid", "changes", "message"),
    [
        (vr.StandardLinearSolid, SLS, {"relaxed_modulus": 7e6}, "relaxed_modulus must be <= instantaneous_modulus = 6e.06 Pa"),
        (vr.StandardLinearSolid, SLS, {"instantaneous_modulus": 3e20, "relaxed_modulus": 3.0}, r"^relaxed_modulus must be >= 1e-12 instantaneous_modulus = 3e\+08 Pa, got 3$"),
        (vr.Prony, PRONY, {"weights": [0.3]}, r"relaxation_times must be as many as weights \(1\), got 2"),
        (vr.materials.CreepCompliance, CREEP, {"compliances": [1.0]}, r"retardation_times must be as many as compliances \(1\), got 2"),
        (vr.materials.CreepCompliance, CREEP, {"compliances": [1.0, -1.0]}, r"compliances\[1\] must be >= 0 1/Pa, got -1"),
        (vr.materials.CreepCompliance, CREEP, {"retardation_times": [0.0, 1.0]}, r"retardation_times\[0\] must be > 0 s, got 0"),
        (vr.Prony, PRONY, {"weights": [0.3, -0.1]}, r"weights\[1\] must be in \[0, 1\], got -0.1"),
        (vr.Prony, PRONY, {"weights": [0.5, 0.6]}, "weights must be such that their sum is <= 1 .*, got 1.1"),
        (vr.Prony, PRONY, {"weights": [0.3, math.nan]}, r"weights\[1\] must be in \[0, 1\], got nan"),
        (vr.Prony, PRONY, {"weights": [[0.3, 0.2]]}, r"weights must be one-dimensional, got shape \(1, 2\)"),
        (vr.Prony, PRONY, {"weights": [[0.3], [0.2, 0.1]]}, "weights must be one-dimensional, got rows of different"),
        (vr.Prony, PRONY, {"relaxation_times": [0.1, 0.0]}, r"relaxation_times\[1\] must be > 0 s, got 0"),
        (vr.materials.KelvinVoigt, {"modulus": 1.0}, {"viscosity": -2.0}, "viscosity must be >= 0 Pa s, got -2"),
        (vr.materials.FractionalZener, ZENER, {"instantaneous_modulus": 1e6}, "instantaneous_modulus must be >= relaxed_modulus = 3e.06 Pa"),
        (vr.materials.FractionalZener, ZENER, {"order": 0.0}, r"order must be in \(0, 1\], got 0"),
        (vr.materials.FractionalZener, ZENER, {"order": 1.5}, r"order must be in \(0, 1\], got 1.5"),
        (vr.materials.HavriliakNegami, ZENER | {"asymmetry": 0.5}, {"order": 1.5}, r"order must be in \(0, 1\], got 1.5"),
        (vr.materials.HavriliakNegami, ZENER | {"asymmetry": 0.5}, {"asymmetry": 0.0}, r"asymmetry must be in \(0, 1\], got 0"),
        (vr.MasterCurve, CURVE, {"frequency": [1.0, 100.0, 10.0]}, r"frequency\[2\] must be > frequency\[1\] = 100 rad/s \(sort the table by frequency\), got 10"),
        (vr.MasterCurve, CURVE, {"frequency": [-1.0, 1.0, 10.0]}, r"frequency\[0\] must be >= 0 rad/s, got -1"),
        (vr.MasterCurve, CURVE, {"storage": [1e6, 0.0, 1e6]}, r"storage\[1\] must be > 0 Pa, got 0"),
        (vr.MasterCurve, CURVE, {"loss": [1e6, -1.0, 1e6]}, r"loss\[1\] must be >= 0 Pa, got -1"),
        (vr.MasterCurve, CURVE, {"loss": [1e6, math.inf, 1e6]}, r"loss\[1\] must be >= 0 Pa, got inf"),
        (vr.MasterCurve, CURVE, {"loss": [1e6, 1.0]}, r"loss must be as long as frequency \(3\), got 2"),
        (vr.MasterCurve, {}, {"frequency": [], "storage": [], "loss": []}, "frequency must be a table of at least two entries"),
        (vr.MasterCurve, {}, {"frequency": [0.0, 1.0], "storage": [1.0, 1.0], "loss": [0.0, 0.0]}, "at least two entries above 0 rad/s"),
        (vr.Layer, LAYER, {"poisson_ratio": 0.51}, r"poisson_ratio must be in \(-1, 0.5\], got 0.51"),
        (vr.Layer, LAYER, {"poisson_ratio": -1.0}, r"poisson_ratio must be in \(-1, 0.5\], got -1"),
        (vr.Layer, LAYER, {"poisson_ratio": math.nan}, r"poisson_ratio must be in \(-1, 0.5\], got nan"),
        (vr.Layer, LAYER, {"poisson_ratio": None}, "poisson_ratio or bulk_modulus must be given, and not both, got none"),
        (vr.Layer, LAYER, {"bulk_modulus": 1e9}, "poisson_ratio or bulk_modulus must be given, and not both, got both"),
        (vr.Layer, LAYER, {"poisson_ratio": None, "bulk_modulus": 0.0}, "bulk_modulus must be > 0 Pa, got 0"),
        (vr.Layer, LAYER, {"density": -1.0}, r"density must be >= 0 kg/m\^3, got -1"),
        (
            vr.CoatedSphere,
            BALL,
            {"layers": [], "core_radius": 0.0, "inner_boundary": enums.InnerBoundary.SOLID},
            "layers must be a list of at least one layer if the ball has no rigid core, got none",
        ),
        (vr.Mesh, MESH, {"nodes_per_revolution": 15}, r"mesh.nodes_per_revolution must be in \[16, 1000000\], got 15"),
        (vr.Mesh, MESH, {"nodes_per_revolution": -100}, r"mesh.nodes_per_revolution must be in \[16, 1000000\], got -100"),
        (vr.Mesh, MESH, {"nodes_per_revolution": 2**40}, "nodes_per_revolution must fit into 32 bits"),
        (vr.Mesh, MESH, {"max_order": 49}, r"mesh.max_order must be in \[50, 200000\] \(fewer orders .* cannot resolve the mesh\), got 49"),
        (vr.Mesh, MESH, {"theta_nodes_per_revolution": 15}, r"mesh.theta_nodes_per_revolution must be in \[16, 1000000\], got 15"),
        (vr.Mesh, MESH, {"theta_nodes_per_revolution": 20000}, r"mesh.theta_nodes_per_revolution must be in \[1, 10000\] \(between 1/100 and 100 times nodes"),
        (vr.Mesh, MESH, {"theta_nodes_per_revolution": 300}, r"mesh.max_order must be in \[150, 200000\]"),
        (solve, CASE, {"accuracy": 0.0}, r"accuracy must be in \[1e-04, 0.5\], got 0"),
        (solve, CASE, {"accuracy": math.nan}, r"accuracy must be in \[1e-04, 0.5\], got nan"),
        (solve, CASE, {"accuracy": 0.1, "mesh": vr.Mesh(**MESH)}, "accuracy must be left out if a mesh is given"),
        (solve, CASE, {"max_iterations": 0}, "max_iterations must be >= 1, got 0"),
        (solve, CASE, {"threads": -1}, r"threads must be in \[0, 1024\], got -1"),
        (solve, CASE, {"threads": 10**6}, r"threads must be in \[0, 1024\], got 1000000"),
    ],
)  # fmt: skip
def test_values_out_of_range(make, valid, changes, message):
    with pytest.raises(ValueError, match=message):
        make(**valid | changes)


@pytest.mark.parametrize(
    ("make", "valid", "changes", "message"),
    [
        (vr.Prony, PRONY, {"weights": "half"}, "weights must be one-dimensional|weights must contain real numbers"),
        (vr.Prony, PRONY, {"weights": [0.1j, 0.2]}, "weights must contain real numbers, got complex128 entries"),
        (vr.MasterCurve, CURVE, {"loss": ["a", "b", "c"]}, "loss must contain real numbers"),
        (vr.MasterCurve, CURVE, {"extrapolation": "keep"}, "extrapolation must be one of error, hold, got 'keep'"),
        (vr.Layer, LAYER, {"shear_modulus": "3e6"}, "shear_modulus must be a modulus of viscoroll, a number or a function"),
        (vr.CoatedSphere, BALL, {"layers": [3]}, r"layers\[0\] must be a viscoroll.Layer, got 3"),
        (vr.Mesh, MESH, {"max_order": 100.0}, "max_order must be a whole number, got float 100.0"),
        (vr.Mesh, MESH, {"nodes_per_revolution": "many"}, "nodes_per_revolution must be a whole number, got str"),
        (solve, CASE, {"mesh": 500}, "mesh must be a viscoroll.Mesh or None, got 500"),
        (solve, CASE, {"compliance": "full"}, "compliance must be one of radial, vertical, got 'full'"),
        (solve, CASE, {"patch_load": None}, "patch_load must be a viscoroll.enums.PatchLoad, or one of flat, spherical, got None"),
        (solve, CASE, {"progress": 3, "mesh": vr.Mesh(**MESH)}, "progress must be True, False, callable or None, got 3"),
    ],
)  # fmt: skip
def test_values_of_another_type(make, valid, changes, message):
    with pytest.raises((TypeError, ValueError), match=message):
        make(**valid | changes)


def test_a_text_may_replace_an_enumeration_member():
    layer = vr.Layer(**LAYER)
    hollow = {"core_radius": 20e-3, "layers": [layer]}
    assert vr.CoatedSphere(**hollow, inner_boundary="Hollow") == vr.CoatedSphere(
        **hollow, inner_boundary=enums.InnerBoundary.HOLLOW
    )
    assert vr.MasterCurve(**CURVE, extrapolation="hold").extrapolation is enums.Extrapolation.HOLD
    options = {"compliance": "vertical", "curvature": "paper", "patch_load": "spherical", "slip_kinematics": "flat"}
    result = vr.solve(paper.ball(), **CASE, mesh=vr.Mesh(**MESH), friction=0.3, **options)
    assert result.compliance is enums.Compliance.VERTICAL
    assert result.curvature is enums.Curvature.PAPER
    assert result.patch_load is enums.PatchLoad.SPHERICAL


def test_a_body_of_another_type():
    with pytest.raises(
        TypeError, match=r"body must be a viscoroll.CoatedSphere or .*CoatedCylinder or .*CoatedWheel, got 'ball'"
    ):
        vr.solve("ball", **CASE)


def tables(ball=None, mesh=None, **options):
    ball = paper.ball() if ball is None else ball
    return vr.modal.influence_tables(ball, 2.5, vr.Mesh(**MESH) if mesh is None else mesh, **{"reach": 3} | options)


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: vr.modal.critical_speed(3), "body must be a viscoroll.CoatedSphere or .*CoatedWheel, got 3"),
        (
            lambda: vr.modal.surface_compliance(3, 2.5, 1, 1),
            "body must be a viscoroll.CoatedSphere or viscoroll.CoatedWheel, got 3",
        ),
        (lambda: vr.modal.centrifugal_displacement(3, 1.0), "ball must be a viscoroll.CoatedSphere, got 3"),
        (lambda: vr.modal.state_matrix(3, 2.5, 1.0, 1, 1), "layer must be a viscoroll.Layer, got 3"),
        (lambda: tables(ball=3), "ball must be a viscoroll.CoatedSphere, got 3"),
        (lambda: tables(mesh=3), "mesh must be a viscoroll.Mesh, got 3"),
        (lambda: tables(progress=3), "progress must be True, False, callable or None, got 3"),
        (lambda: tables(reach=[1, 2]), r"reach must be a whole number, got list \[1, 2\]"),
        (lambda: tables(reach=(1, 2.0)), r"reach\[1\] must be a whole number, got float 2.0"),
        (lambda: solve(drive=0.1), "drive must be a viscoroll.Drive, got 0.1"),
        (
            lambda: solve(slip_kinematics=1),
            "slip_kinematics must be a viscoroll.enums.SlipKinematics, or one of exact, flat, got 1",
        ),
        (lambda: vr.CoatedSphere(core_radius=1.0, layers=3), "layers must be a sequence of viscoroll.Layer, got 3"),
    ],
)
def test_arguments_of_another_type(call, message):
    with pytest.raises(TypeError, match=f"^{message}$"):
        call()


def test_reach_is_one_number_or_two():
    assert tables(reach=(1, 2)).shape == (3, 3, 3, 5)
    with pytest.raises(ValueError, match=r"^reach must be one whole number or two, got \(1, 2, 3\)$"):
        tables(reach=(1, 2, 3))


def test_messages_shorten_long_values(paper_ball):
    with pytest.raises(TypeError, match=r"^mesh must be a viscoroll.Mesh or None, got \[0, 1, .*\.\.\.$") as caught:
        vr.solve(paper_ball, **CASE, mesh=list(range(10000)))
    assert len(str(caught.value)) < 200


def test_values_without_a_repr():
    def fails(self):
        raise RuntimeError

    unprintable = type("Unprintable", (), {"__repr__": fails})
    with pytest.raises(TypeError, match=r"^load must be a real number, got Unprintable <Unprintable>$"):
        solve(load=unprintable())


def test_load_too_large_for_the_coating(paper_ball):
    message = (
        r"load must be small enough for the coating, got 20000 N "
        r"\(the ball is pressed .* m into a coating of thickness 0.001 m\)"
    )
    with pytest.raises(ValueError, match=message):
        vr.solve(paper_ball, load=20000.0, angular_speed=2.5, mesh=vr.Mesh(**MESH))
    with pytest.raises(ValueError, match="load must be small enough for the coating, got 20000 N"):
        vr.solve(paper_ball, load=20000.0, angular_speed=2.5)


@pytest.mark.parametrize("load", [1e7, 1e9, 1e12, 1e30])
def test_absurd_loads(paper_ball, load):
    with pytest.raises(ValueError, match="load must be small enough for the coating"):
        vr.solve(paper_ball, load=load, angular_speed=2.5)


def test_load_that_a_single_node_supports(paper_ball):
    # A tiny load is solved with one node in contact; its error estimate is large.
    r = vr.solve(paper_ball, load=1e-9, angular_speed=2.5, mesh=vr.Mesh(**MESH))
    assert r.contact.sum() == 1
    assert np.isfinite(r.pressure).all()


@pytest.mark.parametrize("friction", [0.0, 0.3])
def test_too_many_nodes_around_the_contact(paper_ball, friction):
    mesh = vr.Mesh(nodes_per_revolution=1_000_000)
    message = r"must be so small that the mesh needs at most 25000000 nodes around the contact, got 1000000 \("
    with pytest.raises(ValueError, match=message):
        vr.solve(paper_ball, load=100.0, angular_speed=2.5, friction=friction, mesh=mesh)


def test_master_curve_must_reach_all_harmonics():
    curve = vr.MasterCurve([0.0, 1.0, 100.0], [1e6, 1e6, 3e6], [0.0, 1e5, 2e5])
    ball = vr.CoatedSphere(core_radius=20e-3, layers=[vr.Layer(**LAYER | {"shear_modulus": curve})])
    with pytest.raises(ValueError, match=r"within the master curve's table, 1 to 100 rad/s .* got 102.5 rad/s"):
        vr.solve(ball, load=10.0, angular_speed=2.5, mesh=vr.Mesh(**MESH))


@pytest.mark.parametrize("orders", [1.5, [1.0], "a", [1 + 2j]])
def test_orders_must_be_whole(paper_ball, orders):
    with pytest.raises(TypeError, match="m must contain whole numbers"):
        vr.modal.surface_compliance(paper_ball, 2.5, orders, 1)


def test_orders_must_broadcast(paper_ball):
    with pytest.raises(ValueError, match=r"^m and n must have shapes that broadcast, got \(2,\) and \(3,\)$"):
        vr.modal.surface_compliance(paper_ball, 2.5, [1, 2], [1, 2, 3])
    with pytest.raises(ValueError, match=r"^n must be an array, got rows of different lengths$"):
        vr.modal.surface_compliance(paper_ball, 2.5, 1, [[1], [1, 2]])
    with pytest.raises(ValueError, match=r"n must be in \[-1e6, 1e6\]"):
        vr.modal.surface_compliance(paper_ball, 2.5, 1, 10**7)


def test_max_iterations_is_a_status(paper_ball):
    r = vr.solve(paper_ball, **CASE, mesh=vr.Mesh(**MESH), max_iterations=1)
    assert r.status is enums.Status.MAX_ITERATIONS
    assert r.iterations == 1


@pytest.mark.parametrize("radius", [1e-12, 1e12])
@pytest.mark.parametrize("modulus", [1e-12, 1e12])
def test_extreme_scales_give_scaled_results(radius, modulus):
    def press(radius, modulus):
        layer = vr.Layer(thickness=0.1 * radius, shear_modulus=vr.Elastic(modulus=modulus), poisson_ratio=0.5)
        ball = vr.CoatedSphere(core_radius=radius, layers=[layer])
        mesh = vr.Mesh(nodes_per_revolution=300, max_order=300)
        return vr.solve(ball, load=1e-3 * modulus * radius**2, angular_speed=1.0, mesh=mesh)

    r, unit = press(radius, modulus), press(1.0, 1.0)
    assert unit.contact.sum() > 10
    np.testing.assert_array_equal(r.contact, unit.contact)
    np.testing.assert_allclose(r.pressure / modulus, unit.pressure, rtol=0.0, atol=1e-9 * unit.max_pressure)
    assert r.penetration / radius == pytest.approx(unit.penetration, rel=1e-9)
