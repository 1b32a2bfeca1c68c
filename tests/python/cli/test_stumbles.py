"""First mistakes of a new user: each message says what to do."""

from __future__ import annotations

import warnings

import numpy as np
import pytest
import viscoroll as vr
from shared_cases import command, one_layer
from viscoroll import enums, paper
from viscoroll.case import example_text

DMA = "frequency [Hz],E' [MPa],E'' [MPa]\n0.1,10,1\n1,12,2\n10,15,3\n"
MOTION = {"time": [0.0, 0.1], "angle": [0.0, 0.1], "load": 50.0, "mesh": vr.Mesh(nodes_per_revolution=64)}


@pytest.fixture
def data(tmp_path):
    path = tmp_path / "dma.csv"
    path.write_text(DMA, encoding="utf-8")
    return vr.rheology.read_rheology(path)


def test_measurements_in_place_of_moduli(data):
    with pytest.raises(TypeError, match=r"; give superpose\(...\).at\(temperature=...\) of the data$"):
        one_layer(data)
    with pytest.raises(TypeError, match=r"; give fit_prony\(...\).series of the curve$"):
        one_layer(data.isotherms[0])
    with pytest.raises(TypeError, match=r"; pass superpose\(...\) of the data, or one of its isotherms$"):
        vr.rheology.fit_prony(data)
    fit = vr.rheology.fit_prony(data.isotherms[0])
    with pytest.raises(TypeError, match=r"; give its series$"):
        one_layer(fit)
    assert one_layer(fit.series).shear_modulus == fit.series


def test_fitted_parameters_in_place_of_numbers():
    stiffness, loss = vr.rheology.hardness_to_modulus(60.0), vr.rheology.rebound_to_loss_factor(0.5)
    with pytest.raises(TypeError, match=r"got Parameter\(value=.*; give its value$"):
        one_layer(stiffness)
    with pytest.raises(TypeError, match=r"loss_factor must be a real number, got Parameter\(value=.*; give its value$"):
        one_layer(vr.LossFactor(modulus=stiffness.value, loss_factor=loss, reference_frequency=1.0))


@pytest.mark.parametrize(
    "make",
    [
        lambda t: vr.materials.WilliamsLandelFerry(c1=8.86, c2=101.6, reference_temperature=t),
        lambda t: vr.materials.Arrhenius(activation_energy=6e4, reference_temperature=t),
    ],
)
@pytest.mark.parametrize("temperature", [20.0, np.nan, np.inf])
def test_messages_recognize_degrees_celsius(make, temperature):
    with pytest.raises(ValueError, match="reference_temperature must be >"):
        make(temperature)
    with pytest.raises(ValueError, match=r"reference_temperature must be .* \(20 °C are 293.15 K\), got 20 K"):
        make(20)


def test_transient_rolling_accepts_names_of_options():
    named = vr.roll(
        paper.ball(), **MOTION, compliance="vertical", curvature="paper", start="undeformed", averaged_meshes=1
    )
    assert (named.compliance, named.curvature) == (enums.Compliance.VERTICAL, enums.Curvature.PAPER)
    assert named.start is enums.Start.UNDEFORMED
    with pytest.raises(ValueError, match="start must be one of relaxed, undeformed, got 'cold'"):
        vr.roll(paper.ball(), **MOTION, start="cold")
    with pytest.raises(TypeError, match=r"compliance must be a viscoroll\.enums\.Compliance, or one of"):
        vr.RollingHistory(paper.ball(), load=50.0, compliance=1)


def test_misspelled_parameters_of_a_study():
    with pytest.raises(
        TypeError, match=r"a rolling body has no parameter acuracy; pass .*; or did you mean accuracy\?"
    ):
        vr.sweep(paper.ball(), load=[50.0, 60.0], angular_speed=2.5, acuracy=0.1, progress=False)
    with pytest.raises(
        TypeError,
        match=r"rolling body has no parameter thickness; .* that returns the rolling body, or as on= the counterbody$",
    ):
        vr.sweep(paper.ball(), load=[50.0, 60.0], angular_speed=2.5, thickness=1e-3, progress=False)


def test_a_sweep_without_a_speed_suggests_the_parameter():
    with pytest.raises(TypeError, match="sweep requires angular_speed; did you mean angular_speed = "):
        vr.sweep(paper.ball(), load=1.0, velocity=1.0)


MM = 1e3  # factor on lengths [m] that a user gives in millimeters
IN_MM = (
    r"; viscoroll expects SI units, got outer_radius = 21 m, layers\[0\].thickness = 1 m, "
    r"layers\[0\].shear_modulus = 3 Pa at rest$"
)


def ball_of(*, length=1.0, modulus=1.0, density=0.0):
    """Return the paper's ball as a user of other units would give it."""
    rubber = vr.StandardLinearSolid(
        instantaneous_modulus=6e6 * modulus, relaxed_modulus=3e6 * modulus, relaxation_time=0.125
    )
    return vr.CoatedSphere(
        core_radius=20e-3 * length,
        layers=[vr.Layer(thickness=1e-3 * length, shear_modulus=rubber, poisson_ratio=0.5, density=density)],
    )


@pytest.mark.parametrize(
    ("ball", "case", "message"),
    [
        (
            ball_of(length=MM, modulus=1e-6, density=1000.0),
            {},
            "angular_speed must be below the critical speed .*" + IN_MM,
        ),
        (ball_of(length=MM, modulus=1e-6), {"load": 2e4}, "load must be small enough.*" + IN_MM),
        (
            ball_of(modulus=1e-6),
            {},
            r"load must .*\); viscoroll expects SI units, got layers\[0\].shear_modulus = 3 Pa at rest$",
        ),
        (
            ball_of(modulus=1e-9),
            {},
            r"pressed through any coating of this stiffness\); viscoroll expects SI units, got layers\[0\]",
        ),
        (
            ball_of(density=1000.0),
            {"angular_speed": 3e4},
            r"angular_speed must .*, got 30000 rad/s; 30000 rad/s are 286479 revolutions per minute$",
        ),
        (ball_of(), {"load": 2e4}, r"load must be small enough .*\)$"),  # no hint about units
        (ball_of(length=MM), {"friction": -1.0}, r"friction must be >= 0, got -1$"),  # the error does not involve units
    ],
)
def test_messages_recognize_other_units(ball, case, message):
    with pytest.raises(ValueError, match=message):
        vr.solve(ball, **{"load": 100.0, "angular_speed": 2.5} | case)


def test_models_histories_and_strain_warnings_recognize_other_units():
    soft = ball_of(modulus=1e-6)
    hint = r"; viscoroll expects SI units, got layers\[0\].shear_modulus = 3 Pa at rest$"
    mesh = vr.Mesh(nodes_per_revolution=100)
    with pytest.raises(ValueError, match=hint):
        vr.RollingModel(soft, angular_speed=2.5, mesh=mesh).solve(load=100.0)
    with pytest.raises(ValueError, match=hint):
        vr.roll(soft, time=[0.0, 0.1], angle=[0.0, 0.1], load=50.0, mesh=mesh)
    with pytest.warns(vr.ResultWarning, match="3 Pa at rest; were megapascals meant") as said:
        vr.solve(soft, load=2.5e-4, angular_speed=2.5)
    assert str(said[0].message).startswith("the strain, ")


def test_messages_recognize_other_units_of_the_counterbody():
    mat = vr.CoatedPlane(layers=ball_of(length=MM).layers, base=vr.HalfSpace(shear_modulus=10.0, poisson_ratio=0.5))
    hint = r"units, got on.layers\[0\].thickness = 1 m, on.base.shear_modulus = 10 Pa at rest$"
    with pytest.raises(ValueError, match=hint):
        vr.solve(ball_of(), on=mat, load=1e9, angular_speed=2.5)


MILLIMETERS = "viscoroll expects SI units, got outer_radius = 21 m, layers[0].thickness = 1 m; were millimeters meant?"


def test_a_ball_of_21_meters_is_solved_with_a_warning():
    with pytest.warns(vr.ResultWarning) as said:
        result = vr.solve(ball_of(length=MM), load=1e6, angular_speed=2.5, accuracy=0.1)
    assert result.status is enums.Status.CONVERGED
    assert [str(one.message) for one in said] == [MILLIMETERS]
    assert repr(result).splitlines()[-1].endswith(MILLIMETERS)
    assert MILLIMETERS in result._repr_html_()
    with pytest.warns(vr.ResultWarning) as said:
        vr.RollingHistory(ball_of(length=MM), load=1e6, mesh=vr.Mesh(nodes_per_revolution=400))
    assert [str(one.message) for one in said] == [MILLIMETERS]
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        vr.solve(ball_of(), load=10.0, angular_speed=2.5, accuracy=0.1)  # the ball of 21 mm


def test_a_ball_of_21_meters_in_a_study_and_on_the_command_line(tmp_path):
    mesh = vr.Mesh(nodes_per_revolution=2000)
    with pytest.warns(vr.ResultWarning) as said:
        study = vr.sweep(ball_of(length=MM), load=[1e6, 2e6], angular_speed=2.5, mesh=mesh, progress=False)
    assert str(said[-1].message) == study.attrs["unit_hint"] == MILLIMETERS
    text = example_text().replace("20e-3 ", "20.0 ").replace("thickness = 1e-3", "thickness = 1.0")
    text = text.replace("load = 100.0", "load = 1e6").replace("accuracy = 0.01", "nodes_per_revolution = 2000")
    text = "allow_large = true\n" + text.replace("density = 1000.0", "")
    (tmp_path / "case.toml").write_text(text, encoding="utf-8")
    (tmp_path / "study.toml").write_text(
        (tmp_path / "case.toml").read_text(encoding="utf-8") + '[sweep]\n"rolling.load" = [1e6, 2e6]\n',
        encoding="utf-8",
    )
    for words in (("solve", "case.toml"), ("sweep", "study.toml"), ("export", "case.toml", "--for", "lammps")):
        assert f"warning: {MILLIMETERS}\n" in command(*words, cwd=tmp_path).stderr


def test_printed_bodies_recognize_other_units():
    assert str(ball_of()) == repr(ball_of())
    large = ball_of(length=MM)
    assert str(large) == f"{large!r}\nviscoroll expects SI units, got outer_radius = 21 m, layers[0].thickness = 1 m"
    roller = vr.CoatedCylinder(core_radius=50.0)
    assert str(roller).splitlines()[1:] == ["viscoroll expects SI units, got outer_radius = 50 m"]


def test_export_requires_a_result():
    with pytest.raises(
        TypeError, match=r"source must be a viscoroll.Result, a StrainSoftening, or a study of viscoroll.sweep, got 'r'"
    ):
        vr.export.dem("r", code="lammps")


def message_of(*words):
    """Return the error message of a command."""
    done = command(*words)
    assert (done.returncode, done.stdout) == (2, "")
    return done.stderr.removeprefix("viscoroll: ").removesuffix("\n")


def test_files_of_another_kind(tmp_path):
    case, unknown = tmp_path / "case.toml", tmp_path / "unknown.csv"
    case.write_text(example_text(), encoding="utf-8")
    unknown.write_text("f,A,B\n1,2,3\n", encoding="utf-8")
    assert message_of("roll", case) == f"{case}: motion must be given; this file is for `viscoroll solve`"
    case.write_text(example_text().replace("angular_speed", "angularspeed"), encoding="utf-8")
    extra = "is not a parameter, got 2.5"
    assert message_of("solve", case) == f"{case}: rolling.angularspeed {extra}; did you mean angular_speed?"
    case.write_text(example_text().replace("angular_speed", "velocity"), encoding="utf-8")
    meant = "did you mean angular_speed = V / r_o?"
    assert message_of("solve", case) == f"{case}: rolling.velocity {extra}; {meant}"
    case.write_text(example_text().replace("angular_speed", "velocity") + example_text("sweep"), encoding="utf-8")
    assert message_of("solve", case) == f"{case}: rolling.velocity {extra}; {meant}"  # [sweep] does not set it
    case.write_text(example_text() + "[belt]\nlayers = []\n", encoding="utf-8")
    assert message_of("solve", case).endswith("; did you mean plane?")
    layer = "thickness = 5e-3\npoisson_ratio = 0.5\nshear_modulus = 1e6\n"
    for wrong, meant in {
        layer.replace("shear_modulus = 1e6", "hardness = 60"): 'shear_modulus = { type = "hardness", hardness = ... }',
        layer.replace("= 1e6", '= { type = "loss_factor", modulus = 1e6, rebound = 0.5, reference_frequency = 1.0 }'): (
            'loss_factor = ..., or give a rebound with a hardness: type = "hardness"'
        ),
    }.items():
        case.write_text(f"[ball]\ncore_radius = 0.1\n[[ball.layers]]\n{wrong}", encoding="utf-8")
        assert f"; did you mean {meant}?" in message_of("solve", case)
    for word, table in {"caster": "wheel", "idler": "cylinder", "sphere": "ball", "dish": "groove"}.items():
        case.write_text(f"[{word}]\ncore_radius = 0.1\n[rolling]\nload = 1.0\nangular_speed = 1.0\n", encoding="utf-8")
        assert message_of("solve", case).partition("; and ")[0].endswith(f"; did you mean {table}?"), word
    case.write_text(example_text("motion"), encoding="utf-8")
    assert message_of("solve", case) == f"{case}: rolling must be given; this file is for `viscoroll roll`"
    case.write_text((example_text() + example_text("sweep")).replace("load = 100.0", ""), encoding="utf-8")
    varied = "; only `viscoroll sweep` uses the values of [sweep]"
    assert message_of("solve", case) == f"{case}: rolling.load must be given{varied}"
    assert message_of("plot", case) == "study must be a .nc file written by `viscoroll sweep`, got 'case.toml'"
    assert "in the shell --columns frequency=name:unit,storage=name:unit" in message_of("material", unknown)


def test_layers_without_a_core_are_a_solid_ball(tmp_path):
    """A ball without a core has the radius of its layers and equals a ball with a solid inner boundary."""
    ball = vr.CoatedSphere(layers=[one_layer(thickness=0.02)])
    assert ball == vr.CoatedSphere(layers=[one_layer(thickness=0.02)], inner_boundary="solid")
    assert (ball.outer_radius, ball.inner_boundary) == (0.02, enums.InnerBoundary.SOLID)
    with pytest.raises(ValueError, match="core_radius must be > 0 m, got 0"):
        vr.CoatedSphere()
    with pytest.raises(ValueError, match="core_radius must be > 0 m, got 0"):
        vr.CoatedSphere(layers=[one_layer(thickness=0.02)], inner_boundary="hollow")


def test_commands_skip_tables_of_other_commands(tmp_path):
    text = example_text().replace("accuracy = 0.01", "nodes_per_revolution = 300") + example_text("design")
    study = '[sweep]\n"rolling.load" = [50.0, 100.0]\n'
    (tmp_path / "case.toml").write_text(text + study, encoding="utf-8")
    done = command("solve", "case.toml", cwd=tmp_path)
    assert done.returncode == 0
    skipped = "skipped in case.toml: [design] is for `viscoroll design`; [sweep] is for `viscoroll sweep`\n"
    assert done.stderr.startswith(skipped)
    assert command("sweep", "case.toml", cwd=tmp_path).stdout.startswith("2 points (2 load)")
    assert command("export", "case.toml", "--for", "lammps", cwd=tmp_path).returncode == 0
    assert command("design", "case.toml", cwd=tmp_path).stdout.startswith("ball.layers[0].thickness = ")
    (tmp_path / "case.toml").write_text(text.replace("[design]", "[desing]"), encoding="utf-8")
    assert "desing is not a parameter" in command("solve", "case.toml", cwd=tmp_path).stderr


@pytest.mark.parametrize("body", ["[cylinder]", "[wheel]\nwidth = 0.1"])
def test_a_rigid_roller_requires_no_layers(tmp_path, body):
    layer = "thickness = 5e-3\npoisson_ratio = 0.5\nshear_modulus = 1e6\n"
    text = f"{body}\ncore_radius = 0.08\n[plane]\n[[plane.layers]]\n{layer}"
    text += "[rolling]\nload = 100.0\nangular_speed = 10.0\n[numerics]\nnodes_per_revolution = 600\n"
    (tmp_path / "idler.toml").write_text(text, encoding="utf-8")
    done = command("solve", "idler.toml", "--json", cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    assert vr.CoatedWheel(core_radius=0.08, width=0.1).layers == ()
