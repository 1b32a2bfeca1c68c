"""What goes wrong first for a new user: each message says what to do."""

from __future__ import annotations

import inspect
import pickle

import numpy as np
import pytest
import viscoroll as vr
from specimens import command, one_layer
from viscoroll import paper
from viscoroll.case import example_text

DMA = "frequency [Hz],E' [MPa],E'' [MPa]\n0.1,10,1\n1,12,2\n10,15,3\n"
MOTION = {"time": [0.0, 0.1], "angle": [0.0, 0.1], "load": 50.0, "mesh": vr.Mesh(nodes_per_revolution=64)}


@pytest.fixture
def data(tmp_path):
    path = tmp_path / "dma.csv"
    path.write_text(DMA, encoding="utf-8")
    return vr.read_rheology(path)


def test_measurements_are_no_moduli_yet(data):
    with pytest.raises(TypeError, match=r"; give superpose\(...\).at\(temperature=...\) of it$"):
        one_layer(data)
    with pytest.raises(TypeError, match=r"; give fit_prony\(...\).series of it$"):
        one_layer(data.isotherms[0])
    fit = vr.fit_prony(data.isotherms[0])
    with pytest.raises(TypeError, match=r"; give its series$"):
        one_layer(fit)
    assert one_layer(fit.series).shear_modulus == fit.series


@pytest.mark.parametrize(
    "make",
    [
        lambda t: vr.WilliamsLandelFerry(c1=8.86, c2=101.6, reference_temperature=t),
        lambda t: vr.Arrhenius(activation_energy=6e4, reference_temperature=t),
    ],
)
@pytest.mark.parametrize("temperature", [20.0, np.nan, np.inf])
def test_degrees_celsius_are_told(make, temperature):
    with pytest.raises(ValueError, match="reference_temperature must be >"):
        make(temperature)
    with pytest.raises(ValueError, match=r"reference_temperature must be .* \(20 °C are 293.15 K\), got 20 K"):
        make(20)


def test_names_serve_in_transient_rolling_as_in_steady():
    named = vr.roll(paper.ball(), **MOTION, compliance="vertical", curvature="paper", start="fresh", lattices=1)
    assert (named.compliance, named.curvature) == (vr.Compliance.VERTICAL, vr.Curvature.PAPER)
    assert named.start is vr.Start.FRESH
    with pytest.raises(ValueError, match="start must be one of relaxed, fresh, got 'cold'"):
        vr.roll(paper.ball(), **MOTION, start="cold")
    with pytest.raises(TypeError, match=r"compliance must be a viscoroll\.Compliance, or one of"):
        vr.RollingHistory(paper.ball(), load=50.0, compliance=1)


def test_misspelled_parameters_of_a_study():
    with pytest.raises(TypeError, match=r"a ball has no parameter acuracy; pass .*; or did you mean accuracy\?"):
        vr.sweep(paper.ball(), load=[50.0, 60.0], angular_speed=2.5, acuracy=0.1, progress=False)
    with pytest.raises(TypeError, match=r"a ball has no parameter thickness; .* that returns the ball$"):
        vr.sweep(paper.ball(), load=[50.0, 60.0], angular_speed=2.5, thickness=1e-3, progress=False)


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (
            lambda: vr.Layer(h=1e-3, E=9e6, nu=0.5),
            "Layer() got an unexpected keyword argument 'h', 'E', 'nu'; "
            "did you mean thickness, shear_modulus = E / (2 (1 + nu)), poisson_ratio?",
        ),
        (lambda: vr.Elastic(E=9e6), "argument 'E'; did you mean modulus = E / (2 (1 + nu))?"),
        (lambda: vr.Layer(thicknes=1e-3), "argument 'thicknes'; did you mean thickness?"),
        (lambda: vr.CoatedSphere(radius=0.02), "; did you mean core_radius = outer radius - thickness of the layers?"),
        (lambda: vr.solve(paper.ball(), speed=2.5), "argument 'speed'; did you mean angular_speed = V / r_o?"),
        (lambda: vr.solve(paper.ball(), rpm=60.0), "argument 'rpm'; did you mean angular_speed = 2 pi rpm / 60?"),
        (
            lambda: vr.roll(paper.ball(), mu=0.3),
            "roll() got an unexpected keyword argument 'mu'; did you mean friction?",
        ),
        (lambda: vr.Mesh(spacing=0.1), "'spacing'; it has nodes_per_revolution, max_order, theta_nodes_per_revolution"),
        (lambda: vr.analytic.hertz(P=1.0), "hertz() got an unexpected keyword argument 'P'; did you mean load?"),
        (
            lambda: vr.sweep(paper.ball(), load=1.0, speed=1.0),
            "sweep needs angular_speed; did you mean angular_speed = ",
        ),
    ],
)
def test_arguments_by_other_names(call, message):
    with pytest.raises(TypeError) as caught:
        call()
    assert message in str(caught.value)
    assert caught.value.__context__ is None


MM = 1e3  # m, where a user types millimeters
IN_MM = (
    r"; viscoroll takes SI units: outer_radius = 21 m, layers\[0\].thickness = 1 m, "
    r"layers\[0\].shear_modulus = 3 Pa at rest$"
)


def ball_of(*, length=1.0, modulus=1.0, density=0.0):
    """Return the paper's ball as someone would give it who counts in other units."""
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
            r"load must .*\); viscoroll takes SI units: layers\[0\].shear_modulus = 3 Pa at rest$",
        ),
        (ball_of(modulus=1e-9), {}, r"pressed through any such coating\); viscoroll takes SI units: layers\[0\]"),
        (
            ball_of(density=1000.0),
            {"angular_speed": 3e4},
            r"angular_speed must .*, got 30000 rad/s; 30000 rad/s are 286479 revolutions per minute$",
        ),
        (ball_of(), {"load": 2e4}, r"load must be small enough .*\)$"),  # nothing tells of other units
        (ball_of(length=MM), {"friction": -1.0}, r"friction must be >= 0, got -1$"),  # units have no part in it
    ],
)
def test_other_units_are_told(ball, case, message):
    with pytest.raises(ValueError, match=message):
        vr.solve(ball, **{"load": 100.0, "angular_speed": 2.5} | case)


def test_other_units_are_told_by_models_histories_and_strain():
    soft = ball_of(modulus=1e-6)
    told = r"; viscoroll takes SI units: layers\[0\].shear_modulus = 3 Pa at rest$"
    mesh = vr.Mesh(nodes_per_revolution=100)
    with pytest.raises(ValueError, match=told):
        vr.RollingModel(soft, angular_speed=2.5, mesh=mesh).solve(load=100.0)
    with pytest.raises(ValueError, match=told):
        vr.roll(soft, time=[0.0, 0.1], angle=[0.0, 0.1], load=50.0, mesh=mesh)
    with pytest.warns(vr.ResultWarning, match="the strain, .*" + told):
        result = vr.solve(soft, load=2.5e-4, angular_speed=2.5)
    assert result.warnings[vr.WarningKind.LARGE_STRAIN].endswith("3 Pa at rest")


def test_other_units_are_told_of_what_it_rolls_on():
    mat = vr.CoatedPlane(layers=ball_of(length=MM).layers, base=vr.HalfSpace(shear_modulus=10.0, poisson_ratio=0.5))
    told = r"units: on.layers\[0\].thickness = 1 m, on.base.shear_modulus = 10 Pa at rest$"
    with pytest.raises(ValueError, match=told):
        vr.solve(ball_of(), on=mat, load=1e9, angular_speed=2.5)


def test_printed_balls_and_rollers_tell_of_other_units():
    assert str(ball_of()) == repr(ball_of())
    large = ball_of(length=MM)
    assert str(large) == f"{large!r}\nviscoroll takes SI units: outer_radius = 21 m, layers[0].thickness = 1 m"
    roller = vr.CoatedCylinder(core_radius=50.0)
    assert str(roller).splitlines()[1:] == ["viscoroll takes SI units: outer_radius = 50 m"]


def test_arguments_by_other_names_of_a_model():
    model = vr.RollingModel(paper.ball(), angular_speed=2.5, mesh=vr.Mesh(nodes_per_revolution=64))
    with pytest.raises(TypeError, match=r"^RollingModel.solve\(\) got .* 'F'; did you mean load\?$"):
        model.solve(F=50.0)


def public():
    """Return all functions and classes of viscoroll that take keyword arguments of their own."""
    for namespace in (vr, vr.analytic):
        for value in (getattr(namespace, name) for name in namespace.__all__):
            own = "__init__" in vars(value) if isinstance(value, type) else inspect.isfunction(value)
            if own and value is not vr.sweep:  # whose other arguments are parameters of the ball
                yield value


@pytest.mark.parametrize("function", list(public()), ids=lambda f: f.__qualname__)
def test_every_public_function_explains_its_arguments(function):
    with pytest.raises(TypeError, match=r"\(\) got an unexpected keyword argument 'qqq'; it has "):
        function(qqq=1)
    assert "qqq" not in inspect.signature(function).parameters
    assert "arguments" not in inspect.signature(function).parameters
    assert pickle.loads(pickle.dumps(function)) is function


def test_errors_within_a_call_stay_as_they_are():
    with pytest.raises(TypeError, match=r"^solve\(\) missing 1 required keyword-only argument: 'angular_speed'$"):
        vr.solve(paper.ball(), load=50.0)

    def modulus(omega):
        return np.ones(len(omega), h=1)

    with pytest.raises(TypeError, match=r"unexpected keyword argument 'h'$"):
        vr.surface_compliance(vr.CoatedSphere(core_radius=0.02, layers=[one_layer(modulus)]), 2.5, 1, 1)


def test_discrete_elements_need_a_result():
    with pytest.raises(
        TypeError, match=r"source must be a viscoroll.Result, a StrainSoftening, or a study of viscoroll.sweep, got 'r'"
    ):
        vr.dem("r", code="lammps")


def told(*words):
    """Return what the command line says where it refuses."""
    done = command(*words)
    assert (done.returncode, done.stdout) == (2, "")
    return done.stderr.removeprefix("viscoroll: ").removesuffix("\n")


def test_files_of_another_kind(tmp_path):
    case, unknown = tmp_path / "case.toml", tmp_path / "unknown.csv"
    case.write_text(example_text(), encoding="utf-8")
    unknown.write_text("f,A,B\n1,2,3\n", encoding="utf-8")
    assert told("roll", case) == f"{case}: motion: field required (and 4 more)"
    case.write_text(example_text().replace("angular_speed", "angularspeed"), encoding="utf-8")
    extra = "extra inputs are not permitted, got 2.5"
    assert told("solve", case) == f"{case}: rolling.angularspeed: {extra}; did you mean angular_speed?"
    case.write_text(example_text().replace("angular_speed", "speed"), encoding="utf-8")
    assert told("solve", case) == f"{case}: rolling.speed: {extra}; rolling.angular_speed: field required"
    case.write_text(example_text() + example_text("sweep"), encoding="utf-8")
    assert told("solve", case).endswith("; such a file is for `viscoroll sweep`")
    assert told("plot", case) == "study must be the .nc that `viscoroll sweep` writes, got 'case.toml'"
    assert "in the shell --columns frequency=name:unit,storage=name:unit" in told("material", unknown)
