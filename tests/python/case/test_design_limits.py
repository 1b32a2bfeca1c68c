"""Design limits on bond tractions, temperature, and the largest load of the cold steady state."""

from __future__ import annotations

import re

import pytest
from shared_cases import command
from viscoroll._support.quantities import quantity_text
from viscoroll.case import load_case
from viscoroll.case.design import design_case
from viscoroll.case.limits import outcome_of

RUBBER = (
    "thickness = 5e-3\npoisson_ratio = 0.5\nshear_modulus = "
    '{ type = "standard_linear_solid", instantaneous_modulus = 6e6, relaxed_modulus = 3e6, relaxation_time = 0.125 }\n'
)
BODIES = {
    "ball": f"[ball]\ncore_radius = 20e-3\n[[ball.layers]]\n{RUBBER}",
    "roller": f"[cylinder]\ncore_radius = 45e-3\n[[cylinder.layers]]\n{RUBBER}",
    "wheel": f"[wheel]\ncore_radius = 45e-3\nwidth = 40e-3\ncrown_radius = 0.1\n[[wheel.layers]]\n{RUBBER}",
    "ball on a mat": f"[ball]\ncore_radius = 20e-3\n[plane]\n[[plane.layers]]\n{RUBBER}",
    "two balls": f"[ball]\ncore_radius = 20e-3\n[[ball.layers]]\n{RUBBER}[other_ball]\ncore_radius = 15e-3\n"
    f"[[other_ball.layers]]\n{RUBBER}",
    "roller on a half-plane": f"[cylinder]\ncore_radius = 45e-3\n[plane]\n[plane.base]\n{RUBBER[17:]}",
}
LOADS = {"roller": 4e3, "roller on a half-plane": 4e3}
COOLED = "[thermal]\nconvection = 15.0\nambient = 293.15\nconductivity = 0.25\n"
ON_PLANES = {"ball on a mat": "period = 2.0\n"}
WLF = '{ type = "williams_landel_ferry", c1 = 8.86, c2 = 101.6, reference_temperature = 293.15 }'
SHIFT = f"limit = 343.15\nshift = {WLF}\n"


@pytest.fixture
def file(tmp_path):
    def write(body, more="", nodes=100):
        path = tmp_path / "case.toml"
        rolling = f"[rolling]\nload = {LOADS.get(body, 50.0)}\nangular_speed = 20.0\n"
        text = f"{BODIES[body]}{rolling}[numerics]\nnodes_per_revolution = {nodes}\n"
        path.write_text(text + more, encoding="utf-8")
        return path

    return write


@pytest.mark.parametrize("body", ["ball", "roller", "wheel", "ball on a mat", "two balls"])
def test_every_body_has_bonds_and_a_temperature(file, body):
    """If both bodies have bonds, the limit uses the larger value."""
    case = load_case(file(body, COOLED + ON_PLANES.get(body, "")))
    outcome = outcome_of(case, ["bond_shear", "bond_tension", "temperature", "strain"], None)
    result = case.solve()
    sides = [
        of
        for of, power in zip(
            ("body", "counterbody"), (result.rolling_bulk_power, result.counterbody_bulk_power), strict=True
        )
        if power
    ]
    assert len(sides) == (2 if body == "two balls" else 1)
    bonds = [result.bonds(of=of) for of in sides]
    assert outcome.value("bond_shear") == pytest.approx(max(b.shear_traction.max().item() for b in bonds), rel=1e-12)
    assert outcome.value("bond_tension") == pytest.approx(
        max(b.opening_traction.max().item() for b in bonds), rel=1e-12
    )
    assert [outcome.unit(name) for name in ("bond_shear", "temperature", "strain")] == ["Pa", "K", "1"]
    found = case.thermal.temperature(result)
    assert outcome.value("temperature") == pytest.approx(found.ambient + found.maximum, rel=1e-12)
    assert outcome.value("strain") == result.strain


def test_ratio_of_the_load_to_the_largest_load_of_the_cold_state(file):
    """Compare with `self_heating`; the results of the case are those of its coldest steady state."""
    case = load_case(file("roller", COOLED + SHIFT, nodes=300))
    outcome = outcome_of(case, ["load_to_fold", "temperature"], None)
    hot = case.self_heating()
    fold = hot.largest_load()
    assert outcome.value("load_to_fold") == pytest.approx(case.load / fold.load, rel=1e-6)
    assert 0.0 < outcome.value("load_to_fold") < 1.0
    cold = hot.states[0]
    assert outcome.value("temperature") == pytest.approx(cold.temperature.ambient + cold.temperature.maximum, rel=1e-9)
    assert outcome.result.resisting_torque == pytest.approx(cold.result.resisting_torque, rel=1e-6)


def test_a_design_on_the_command_line(file, tmp_path):
    """The command prints the value at which the bond limit is reached, its unit, and the roller's power per length."""
    middle = outcome_of(load_case(file("roller", nodes=300)), ["bond_shear"], None).value("bond_shear")
    table = '[design]\nvary = "cylinder.layers[0].thickness"\nfrom = 3e-3\nto = 12e-3\n'
    path = file("roller", f"{table}limits = {{ bond_shear = {middle!r}, strain = 0.3 }}\n", nodes=300)
    done = command("design", path, "--plot", tmp_path / "design.png")
    assert done.returncode == 0, done.stderr
    best, power = re.match(
        r"cylinder.layers\[0\].thickness = (\S+) mm: power dissipated (\S+ \S+)\n", done.stdout
    ).groups()
    largest = re.escape(quantity_text(middle, "Pa"))
    assert re.search(rf"  largest shear traction at bonded interfaces: \S+ \S+, limit {largest}", done.stdout)
    assert re.search(r"  strain.*: \S+ %, limit 30 %\n", done.stdout)
    assert (tmp_path / "design.png").stat().st_size > 5000
    found = design_case(path)
    assert found.best == pytest.approx(1e-3 * float(best), rel=1e-5)
    assert quantity_text(found.result.dissipated_power, "W/m") == power
    assert found.result.bonds().shear_traction.max().item() <= middle * (1.0 + 1e-9)


@pytest.mark.parametrize(
    ("body", "more", "limits", "message"),
    [
        ("ball", "", "load_to_fold = 0.8", r"design.limits.load_to_fold must be used with a table \[thermal\]"),
        ("ball", COOLED, "load_to_fold = 0.8", "design.limits.load_to_fold must be used with thermal.shift"),
        (
            "ball",
            "",
            "bond_stress = 1e6",
            "design.limits must be named .*bond_shear, bond_tension, load_to_fold, got 'bond_",
        ),
        (
            "roller on a half-plane",
            "",
            "bond_shear = 1e6",
            "design.limits.bond_shear must be left out: this case has no bonded interfaces",
        ),
        (
            "roller on a half-plane",
            "",
            "strain = 0.1",
            "design.limits.strain must be left out: this case does not have",
        ),
    ],
)
def test_limits_that_do_not_apply_are_rejected(file, body, more, limits, message):
    table = f'[design]\nvary = "rolling.load"\nfrom = 20.0\nto = 60.0\nlimits = {{ {limits} }}\n'
    with pytest.raises(ValueError, match=message):
        design_case(file(body, more + table))


@pytest.mark.parametrize(
    ("vary", "low", "high", "name", "part"),
    [("load", 5.0, 5000.0, "strain", 1.2), ("angular_speed", 0.01, 1e3, "dissipated_power", 0.7)],
)
def test_largest_value_within_limits(file, vary, low, high, name, part):
    """The largest value reaches a limit, which a slightly larger value exceeds."""
    limit = part * getattr(load_case(file("ball")).solve(), name)
    table = f'[design]\nvary = "rolling.{vary}"\nfrom = {low}\nto = {high}\ngoal = "largest_value"\n'
    path = file("ball", f"{table}limits = {{ {name} = {limit} }}\n")
    found = design_case(path)
    assert found.outcome.value(name) <= limit
    beyond = load_case(path, {f"rolling.{vary}": 1.001 * found.best}).solve()
    assert getattr(beyond, name) > limit
    assert found.active == (name,)
    assert found.goal == "largest_value"


def test_the_largest_value_is_the_end_of_the_range_if_no_limit_is_reached(file):
    table = '[design]\nvary = "rolling.load"\nfrom = 10\nto = 20\ngoal = "largest_value"\nlimits = { strain = 0.5 }\n'
    assert design_case(file("ball", table)).best == pytest.approx(20.0, rel=1e-12)
