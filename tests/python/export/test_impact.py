"""Normal impact of balls: Hertz's elastic impact, the expansion for viscoelastic spheres, energy, and exports."""

from __future__ import annotations

import json
import math
import re
import sys

import numpy as np
import pytest
import viscoroll as vr
from scipy.integrate import solve_ivp
from shared_cases import RUBBER, ball_file
from typer.testing import CliRunner
from viscoroll.cli.app import app
from viscoroll.export.impact import Impact

MODULUS, RADIUS, MASS = 1e6, 10e-3, 10e-3

#: Hertz's stiffness k of P = k δ^(3/2) for an incompressible half-space: 4/3 E* √R, E* = 4 G.
STIFFNESS = 4.0 / 3.0 * 4.0 * MODULUS * math.sqrt(RADIUS)


def on_half_space(modulus, speed=0.1, **options):
    track = vr.CoatedPlane(base=vr.HalfSpace(shear_modulus=modulus, poisson_ratio=0.5))
    return vr.export.impact(vr.CoatedSphere(core_radius=RADIUS), on=track, mass=MASS, speed=speed, **options)


def kelvin_voigt_like(time, ratio=100.0):
    """Return a solid with G(1 + iωτ) at the frequencies of the impact: relaxation a hundred times faster than τ."""
    return vr.StandardLinearSolid(
        instantaneous_modulus=(1.0 + ratio) * MODULUS, relaxed_modulus=MODULUS, relaxation_time=time / ratio
    )


def test_elastic_impact_of_hertz():
    """H. Hertz, J. reine angew. Math. 92 (1882) 156: e = 1, δ = (5 m v²/(4 k))^(2/5), duration 2.9432 δ/v.

    16 nodes across the contact leave 0.3 % of the force.
    """
    hit = on_half_space(vr.Elastic(modulus=MODULUS))
    depth = (1.25 * MASS * 0.1**2 / STIFFNESS) ** 0.4
    assert hit.restitution == pytest.approx(1.0, abs=1e-5)
    assert hit.largest_approach == pytest.approx(depth, rel=2e-3)
    assert hit.largest_force == pytest.approx(STIFFNESS * depth**1.5, rel=1e-2)
    assert hit.duration == pytest.approx(2.9432 * depth / 0.1, rel=5e-3)
    assert hit.damping_ratio == pytest.approx(0.0, abs=1e-5)
    assert hit.energy_balance_error < 1e-4


@pytest.mark.parametrize("speed", [0.01, 0.1, 1.0])
@pytest.mark.parametrize("time", [1e-6, 1e-5])
def test_expansion_for_small_impact_speeds(time, speed):
    """1 - e of R. Ramírez, T. Pöschel, N. V. Brilliantov and T. Schwager, Phys. Rev. E 60 (1999) 4465.

    e = 1 - C₁ x + 3/5 C₁² x² with x = 3/2 A (k/m)^(2/5) v^(1/5). The loss of the elastic motion, 3 A k ∫ √δ v dδ / (m
    v²), gives C₁ = 4/5 (5/4)^(3/5) B(3/5, 3/2) = 1.15344. For spheres with the modulus G (1 + iωA), the dissipative
    force is 3/2 A k √δ dδ/dt. The expansion neglects third powers of x, and the mesh leaves 0.3 %.
    """
    first = 0.8 * 1.25**0.6 * math.gamma(0.6) * math.gamma(1.5) / math.gamma(2.1)
    x = 1.5 * time * (STIFFNESS / MASS) ** 0.4 * speed**0.2
    expected = first * x - 0.6 * (first * x) ** 2
    loss = 1.0 - on_half_space(kelvin_voigt_like(time), speed=speed).restitution
    assert loss == pytest.approx(expected, rel=1e-2 + x**2)
    assert loss > 100.0 * abs(1.0 - on_half_space(vr.Elastic(modulus=MODULUS), speed=speed).restitution)


def test_kelvin_voigt_equals_its_limit():
    """A dashpot and a relaxation that is as fast give nearly the same restitution."""
    own = on_half_space(vr.materials.KelvinVoigt(modulus=MODULUS, viscosity=1e-5 * MODULUS))
    assert 1.0 - own.restitution == pytest.approx(1.0 - on_half_space(kelvin_voigt_like(1e-5)).restitution, rel=2e-3)


#: Relaxation times [s] and the damping ratios that result.
DAMPING = [(1e-5, 0.0043), (1e-4, 0.041), (3e-4, 0.113), (1e-3, 0.296), (3e-3, 0.541), (1e-2, 0.755)]


def kelvin_voigt_impact_of_ting(time, speed=0.1):
    """Return the largest approach and the restitution of a rigid ball on a half-space with the modulus G (1 + iωτ).

    T. C. T. Ting, J. Appl. Mech. 33 (1966) 845: while the contact grows, the force is k (1 + τ d/dt) δ^(3/2). While it
    shrinks, the force is that of Hertz at the earlier approach δ₁ of the same contact radius, which is δ₁ = δ + τ dδ/dt
    for this modulus.
    """

    def motion(_, state):
        approach, moving = max(state[0], 0.0), state[1]
        if moving > 0.0:
            force = approach**1.5 + 1.5 * time * math.sqrt(approach) * moving
        else:
            force = max(approach + time * moving, 0.0) ** 1.5
        return moving, -STIFFNESS * force / MASS

    def stop(_, state):
        return state[1]

    stop.terminal = True
    options = {"rtol": 1e-9, "atol": 1e-13, "method": "LSODA"}
    pressed = solve_ivp(motion, (0.0, 1.0), (0.0, speed), events=stop, **options)
    released = solve_ivp(motion, (0.0, 100.0 * (pressed.t[-1] + time)), (pressed.y[0, -1], -1e-300), **options)
    return pressed.y[0, -1], -released.y[1, -1] / speed


@pytest.mark.parametrize(
    ("time", "damping", "dashpot"),
    [
        *((time, damping, True) for time, damping in DAMPING),
        *((time, damping, False) for time, damping in DAMPING[:-1]),
        pytest.param(*DAMPING[-1], False, marks=pytest.mark.slow),
    ],
)
def test_strong_damping(time, damping, dashpot):
    """Restitution and energy balance of a Kelvin-Voigt solid, and of one that relaxes much faster than the steps.

    16 nodes leave 0.1 % of the approach, and the relaxation of a fourth of a step 0.1 % of the restitution.
    """
    solid = kelvin_voigt_like(time, ratio=1e5)
    if dashpot:
        solid = vr.materials.KelvinVoigt(modulus=MODULUS, viscosity=time * MODULUS)
    hit = on_half_space(solid)
    approach, restitution = kelvin_voigt_impact_of_ting(time)
    assert hit.largest_approach == pytest.approx(approach, rel=1e-3)
    assert hit.restitution == pytest.approx(restitution, rel=1e-3)
    assert hit.damping_ratio == pytest.approx(damping, rel=2e-2)
    assert hit.energy_balance_error < 1e-3


def test_different_dashpots_on_each_other():
    """Layers of different Kelvin-Voigt solids, which histories reject, have an impact too."""
    stiff, soft = (vr.materials.KelvinVoigt(modulus=1e6 * n, viscosity=1e3) for n in (1, 3))
    layers = [vr.Layer(thickness=1e-3, shear_modulus=one, poisson_ratio=0.5) for one in (stiff, soft)]
    hit = vr.export.impact(vr.CoatedSphere(core_radius=20e-3, layers=layers), mass=0.1, speed=0.1)
    assert hit.energy_balance_error < 1e-3
    assert 0.0 < hit.restitution < 0.7


def test_warning_about_the_energy_balance(monkeypatch):
    """Without a shortest relaxation time, forces alternate from step to step, and too much energy is dissipated."""
    monkeypatch.setattr(sys.modules["viscoroll.export.impact"], "_SHORTEST_RELAXATION", 1e-6)
    with pytest.warns(vr.ResultWarning, match=r"the error of the energy balance is 0\.0\d+ of the kinetic energy"):
        hit = on_half_space(vr.materials.KelvinVoigt(modulus=MODULUS, viscosity=1e-3 * MODULUS))
    assert hit.energy_balance_error > 1e-3


@pytest.mark.parametrize("time", [1e-5, 1e-4, 1e-3, 1e-2])
@pytest.mark.parametrize("is_pair", [False, True])
def test_energy_balance(time, is_pair):
    """Kinetic, stored and dissipated energy balance to 1e-3, although the last is computed from the memory alone."""
    rubber = vr.StandardLinearSolid(instantaneous_modulus=6e6, relaxed_modulus=3e6, relaxation_time=time)
    layer = vr.Layer(thickness=2e-3, shear_modulus=rubber, poisson_ratio=0.5)
    ball = vr.CoatedSphere(core_radius=20e-3, layers=[layer])
    hit = vr.export.impact(ball, on=ball if is_pair else None, mass=0.1, speed=0.3)
    assert hit.energy_balance_error < 1e-3
    assert 0.5 < hit.restitution < 1.0
    remaining = hit.stored_energy[-1] + hit.dissipated_energy[-1]
    assert hit.lost_energy == pytest.approx(remaining, abs=1e-3 * 0.5 * 0.1 * 0.3**2)


def test_two_identical_balls_meet_like_one_ball_on_a_plane():
    """In the center of two identical balls with the mass m is a plane: each meets it at half of the relative speed."""
    layer = vr.Layer(thickness=1e-3, shear_modulus=RUBBER, poisson_ratio=0.5)
    ball = vr.CoatedSphere(core_radius=20e-3, layers=[layer])
    pair = vr.export.impact(ball, on=ball, mass=0.05, speed=0.4)
    wall = vr.export.impact(ball, mass=0.1, speed=0.2)
    assert pair.restitution == pytest.approx(wall.restitution, abs=1e-4)
    assert pair.largest_approach == pytest.approx(2.0 * wall.largest_approach, rel=5e-3)
    assert pair.duration == pytest.approx(wall.duration, rel=5e-3)


@pytest.fixture(scope="module")
def hit():
    rubber = vr.StandardLinearSolid(instantaneous_modulus=6e6, relaxed_modulus=3e6, relaxation_time=1e-3)
    layer = vr.Layer(thickness=2e-3, shear_modulus=rubber, poisson_ratio=0.5)
    return vr.export.impact(vr.CoatedSphere(core_radius=20e-3, layers=[layer]), mass=0.1, speed=0.3)


@pytest.fixture(scope="module")
def result():
    rubber = vr.StandardLinearSolid(instantaneous_modulus=6e6, relaxed_modulus=3e6, relaxation_time=1e-3)
    layer = vr.Layer(thickness=2e-3, shear_modulus=rubber, poisson_ratio=0.5)
    ball = vr.CoatedSphere(core_radius=20e-3, layers=[layer])
    return vr.solve(ball, load=50.0, angular_speed=100.0, mesh=vr.Mesh(nodes_per_revolution=400))


def rebound(force, *, mass, speed, pulls):
    """Return the restitution of m d²x/dt² = -F(x, dx/dt), to the end of compression, or where the force would pull."""
    x, v, step = 0.0, speed, 2e-8
    while x >= 0.0 and (pulls or v > 0.0 or force(x, v) > 0.0):
        half = v - 0.5 * step * force(x, v) / mass
        x += half * step
        v = half - 0.5 * step * force(x, half) / mass
    return -v / speed


def test_linear_spring_and_dashpot(hit):
    """Spring and dashpot have the restitution and the duration of the impact."""
    e = rebound(lambda x, v: hit.spring * x + hit.dashpot * v, mass=0.1, speed=0.3, pulls=True)
    assert e == pytest.approx(hit.restitution, rel=1e-4)
    rate = math.sqrt(hit.spring / 0.1 - (hit.dashpot / 0.2) ** 2)
    assert math.pi / rate == pytest.approx(hit.duration, rel=1e-12)


def test_damping_ratio_with_the_law_of_hertz(hit):
    """Damping √5 ζ √(k m) δ^(1/4) has the restitution at any speed: D. Antypov and J. A. Elliott, EPL 94 (2011)."""
    damping = math.sqrt(5.0 * 1e7 * 0.1) * hit.damping_ratio
    for speed in (0.03, 0.3):
        e = rebound(
            lambda x, v: 1e7 * max(x, 0.0) ** 1.5 + damping * max(x, 0.0) ** 0.25 * v, mass=0.1, speed=speed, pulls=True
        )
        assert e == pytest.approx(hit.restitution, rel=1e-3)


def test_mercurydpm_has_the_restitution(result, hit):
    exported = vr.export.dem(result, code="mercurydpm", impact=hit)
    spring = float(re.search(r"setStiffness\((\S+)\)", exported.text)[1])
    dashpot = float(re.search(r"setDissipation\((\S+)\)", exported.text)[1])
    e = rebound(lambda x, v: spring * x + dashpot * v, mass=0.1, speed=0.3, pulls=True)
    assert e == pytest.approx(hit.restitution, rel=1e-4)


def test_mujoco_has_the_restitution(result, hit):
    """Stiffness and damping are per mass, and a contact does not pull."""
    exported = vr.export.dem(result, code="mujoco", impact=hit)
    spring, dashpot = (-float(x) for x in re.search(r'solref="(\S+) (\S+)"', exported.text).groups())
    e = rebound(lambda x, v: spring * x + dashpot * v, mass=1.0, speed=0.3, pulls=False)
    assert e == pytest.approx(hit.restitution, rel=1e-3)


@pytest.mark.parametrize(
    ("code", "style", "pattern"),
    [
        ("lammps", "sds", r"granular hertz \S+ {e} damping tsuji tangential"),
        ("liggghts", "epsd2", r"coefficientRestitution peratomtypepair 1 {e}\n"),
        ("chrono", "nsc", r"SetRestitution\({e}f\)"),
        ("lethe", "epsd", r"set restitution coefficient particles = {e}\n"),
        ("lethe", "epsd", r"set restitution coefficient wall = {e}\n"),
        ("kratos", "constant", r'"COEFFICIENT_OF_RESTITUTION": {e},'),
    ],
)
def test_codes_that_take_the_restitution(result, hit, code, style, pattern):
    text = vr.export.dem(result, code=code, style=style, impact=hit).text
    assert re.search(pattern.replace("{e}", re.escape(repr(hit.restitution))), text)
    assert f"restitution e = {hit.restitution:.6g} of an impact at 0.3 m/s with the mass 0.1 kg" in text
    assert "restitution" not in vr.export.dem(result, code=code, style=style).text.lower()


@pytest.mark.parametrize(("code", "style"), [("yade", "moment"), ("chrono", "dem")])
def test_codes_without_a_restitution_say_so(result, hit, code, style):
    text = vr.export.dem(result, code=code, style=style, impact=hit).text
    assert re.search("no viscous damping|no restitution", text)


def test_run_in_mujoco(result, hit):
    """A ball rolls and bounces in MuJoCo with the exported torque and restitution."""
    mujoco = pytest.importorskip("mujoco")
    exported = vr.export.dem(result, code="mujoco", impact=hit)
    option, *pair = exported.contact_model.lines
    radius, mass = result.body.outer_radius, 0.1

    def model(gravity, height):
        option_with_gravity = option.replace("<option", f'<option timestep="1e-5" gravity="0 0 {-gravity!r}"')
        return mujoco.MjModel.from_xml_string(f"""<mujoco>{option_with_gravity}<worldbody>
            <geom name="floor" type="plane" size="0 0 1"/>
            <body pos="0 0 {radius + height!r}"><freejoint/>
              <geom name="ball" type="sphere" size="{radius!r}" mass="{mass!r}"/></body>
            </worldbody>{"".join(pair)}</mujoco>""")

    flight = model(0.0, 1e-6)
    data = mujoco.MjData(flight)
    data.qvel[2] = -0.3
    while data.time < 0.1 and not (data.qvel[2] > 0.0 and data.ncon == 0):
        mujoco.mj_step(flight, data)
    assert data.qvel[2] / 0.3 == pytest.approx(hit.restitution, rel=5e-3)

    weight = 50.0
    rolling = model(weight / mass, -exported.point.load / exported.stiffness.hooke)
    data = mujoco.MjData(rolling)
    mujoco.mj_step(rolling, data, 2000)
    data.qvel[:] = 0.0
    data.qvel[0], data.qvel[4] = 2.0, 2.0 / radius
    mujoco.mj_step(rolling, data, 200)
    start, time = float(data.qvel[0]), float(data.time)
    mujoco.mj_step(rolling, data, 2000)
    slowing = (start - float(data.qvel[0])) / (float(data.time) - time)
    torque = slowing * 1.4 * mass * radius  # of a towed ball whose moment of inertia is 0.4 m R²
    assert torque == pytest.approx(exported.parameters["rolling friction"] * weight, rel=1e-2)


def test_small_rolling_friction_in_mujoco(result):
    """MuJoCo raises friction coefficients below 1e-5."""
    layer = vr.Layer(thickness=0.05e-3, shear_modulus=RUBBER, poisson_ratio=0.5)
    thin = vr.CoatedSphere(core_radius=0.5e-3, layers=[layer])
    small = vr.solve(thin, load=1e-3, angular_speed=1.0, mesh=vr.Mesh(nodes_per_revolution=400))
    with pytest.raises(vr.InvalidInput, match="code must be another than mujoco for a rolling friction below 1e-05 m"):
        vr.export.dem(small, code="mujoco")


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"mass": 0.0}, "mass must be in (0, inf) kg, got 0"),
        ({"speed": -1.0}, "speed must be in (0, inf) m/s, got -1"),
        ({"nodes": 4}, "nodes must be in [8, 200], got 4"),
        ({"speed": 1e3}, "speed must be so small that the ball stops within 0.9 mm, got 1000 m/s for a mass of 0.1 kg"),
    ],
)
def test_bad_input(change, message):
    layer = vr.Layer(thickness=1e-3, shear_modulus=RUBBER, poisson_ratio=0.5)
    arguments = {"mass": 0.1, "speed": 0.1} | change
    with pytest.raises(vr.InvalidInput, match=re.escape(message)):
        vr.export.impact(vr.CoatedSphere(core_radius=20e-3, layers=[layer]), **arguments)


def test_rollers_are_rejected():
    layer = vr.Layer(thickness=1e-3, shear_modulus=RUBBER, poisson_ratio=0.5)
    with pytest.raises(ValueError, match="source must be for a ball on a plane or on another ball, got a roller"):
        vr.export.impact(vr.CoatedCylinder(core_radius=20e-3, layers=[layer]), mass=1.0, speed=0.1)


def test_series_and_picture(hit, tmp_path):
    hit.save(tmp_path / "impact.csv")
    table = np.genfromtxt(tmp_path / "impact.csv", delimiter=",", skip_header=1)
    assert table.shape == (len(hit.time), 6)
    assert table[:, 3] == pytest.approx(hit.force)
    axes = hit.plot().axes[0]
    assert axes.get_xlabel() == "approach [mm]"
    assert isinstance(hit, Impact)
    assert "coefficient of restitution" in repr(hit)


CASE = ball_file(nodes_per_revolution=200)


@pytest.fixture
def case(tmp_path):
    path = tmp_path / "ball.toml"
    path.write_text(CASE)
    return path


def run(*arguments):
    return CliRunner().invoke(app, [str(argument) for argument in arguments])


def test_impact_in_the_shell(case, hit, tmp_path):
    """Units are read, and several speeds are a table: faster impacts lose less relative energy here."""
    found = run("impact", case, "--mass", "100 g", "--speed", "0.3 m/s", "--json")
    assert found.exit_code == 0, found.output
    assert json.loads(found.output)[0]["restitution"] == pytest.approx(hit.restitution, rel=1e-12)
    table = run("impact", case, "--mass", "0.1", "--speed", "0.1", "--speed", "30 cm/s", "--save", tmp_path / "i.csv")
    assert [line.split()[0] for line in table.output.splitlines()] == ["speed", "0.1", "0.3"]
    assert (tmp_path / "i.csv").read_text().startswith("impact_speed [m/s],restitution [1]")


def test_export_with_restitution(case, hit):
    found = run("export", case, "--for", "liggghts", "--mass", "100 g", "--impact-speed", "0.3 m/s")
    assert found.exit_code == 0, found.output
    assert f"coefficientRestitution peratomtypepair 1 {hit.restitution!r}" in found.output


def test_style_is_checked_before_anything_is_solved(case, monkeypatch):
    monkeypatch.setattr("viscoroll.studies.study.sweep", lambda *_, **__: pytest.fail("solved"))
    bad = run("export", case, "--for", "lethe", "--style", "sds")
    assert str(bad.exception) == "style of lethe must be one of constant, viscous, epsd, got 'sds'"
    other = case.with_name("pair.toml")
    other.write_text(CASE + CASE[: CASE.index("[rolling]")].replace("ball", "other_ball"))
    pair = run("export", other, "--for", "chrono", "--style", "multicore")
    assert str(pair.exception).startswith("style of chrono must be nsc or dem for two balls, got multicore")
    alone = run("export", case, "--for", "lammps", "--mass", "1")
    assert str(alone.exception) == "--mass and --impact-speed must be given together"
