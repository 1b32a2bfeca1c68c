"""Tables of materials for the page on the site reproduce the results of the package's own functions."""

from __future__ import annotations

import json
import re
from importlib import resources

import numpy as np
import pytest
import viscoroll as vr
from viscoroll.app.tabulated import tabulated_materials
from viscoroll.case import build_case, example_text
from viscoroll.case.tables import read_toml

#: Relative tolerance. The modulus at rest is 1 minus the sum of weights, as small as 1.4e-5, which amplifies round-off.
DIGITS = 1e-9

OMEGA = np.geomspace(1e-2, 1e5, 15)


@pytest.fixture(scope="module")
def tables():
    """Return the tables in the form in which the page receives them."""
    return json.loads(json.dumps(tabulated_materials(), allow_nan=False))


def modulus(table, tmp_path):
    """Return the modulus that a case file builds from a table."""
    (tmp_path / "case.toml").write_text(example_text(), encoding="utf-8")
    case = read_toml(tmp_path / "case.toml")
    case["ball"]["layers"][0]["shear_modulus"] = table
    return build_case(case, tmp_path).body.layers[0].shear_modulus


@pytest.mark.parametrize(("scale", "shore"), [("A", 20), ("A", 85), ("D", 40)])
def test_hardness(tables, scale, shore):
    assert tables["hardness"][scale][str(shore)] == vr.rheology.hardness_to_modulus(float(shore), scale=scale).value


@pytest.mark.parametrize(
    ("name", "percent"), [("rebound", 2), ("rebound", 55), ("loss_factor", 1), ("loss_factor", 100)]
)
def test_series_agree_with_a_constant_loss_factor(tables, name, percent):
    share = percent / 100
    loss_factor = vr.rheology.rebound_to_loss_factor(share).value if name == "rebound" else share
    decades = tables[name]["decades"]
    expected = vr.LossFactor(modulus=1.0, loss_factor=loss_factor, reference_frequency=1.0, decades=decades)
    instantaneous, first, second, ratio, last = tables[name]["series"][str(percent)]
    times = tables[name]["relaxation_times"]
    weights = [first, *(second * ratio**k for k in range(len(times) - 2)), last]
    found = vr.Prony(instantaneous_modulus=instantaneous, weights=weights, relaxation_times=times)
    assert found.complex_modulus(OMEGA) == pytest.approx(expected.complex_modulus(OMEGA), rel=DIGITS)


def test_tables_cover_the_decades_that_the_page_requests(tables):
    text = (resources.files("viscoroll") / "app" / "page" / "materials.js").read_text(encoding="utf-8")
    kinds = {name: text.split(f"  {kind}: {{")[1] for name, kind in (("rebound", "hardness"), ("loss_factor",) * 2)}
    for name, kind in kinds.items():
        assert float(re.search(r"decades: ([\d.]+) }", kind)[1]) == tables[name]["decades"]


@pytest.mark.parametrize("name", ["pressure_sensitive_adhesive", "vinyl_nitrile_foam"])
@pytest.mark.parametrize("kelvin", [263.15, 293.15, 323.15])
def test_published_materials(tables, name, kelvin, tmp_path):
    expected = vr.rheology.example_material(name).at(temperature=kelvin)
    found = modulus(tables["published"][name][str(kelvin)], tmp_path)
    assert found.complex_modulus(OMEGA) == pytest.approx(expected.complex_modulus(OMEGA), rel=DIGITS)
