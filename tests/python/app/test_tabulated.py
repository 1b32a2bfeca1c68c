"""Tables of published materials for the page on the site reproduce the results of the package's own functions."""

from __future__ import annotations

import json

import numpy as np
import pytest
import viscoroll as vr
from viscoroll.app.tabulated import published_materials
from viscoroll.case import build_case, example_text
from viscoroll.case.tables import read_toml

#: Relative tolerance. The modulus at rest is 1 minus the sum of weights, as small as 1.4e-5, which amplifies round-off.
DIGITS = 1e-9

OMEGA = np.geomspace(1e-2, 1e5, 15)


@pytest.fixture(scope="module")
def tables():
    """Return the tables in the form in which the page receives them."""
    return json.loads(json.dumps(published_materials(), allow_nan=False))


def modulus(table, tmp_path):
    """Return the modulus that a case file builds from a table."""
    (tmp_path / "case.toml").write_text(example_text(), encoding="utf-8")
    case = read_toml(tmp_path / "case.toml")
    case["ball"]["layers"][0]["shear_modulus"] = table
    return build_case(case, tmp_path).body.layers[0].shear_modulus


@pytest.mark.parametrize("name", ["pressure_sensitive_adhesive", "vinyl_nitrile_foam"])
@pytest.mark.parametrize("kelvin", [263.15, 293.15, 323.15])
def test_published_materials(tables, name, kelvin, tmp_path):
    expected = vr.rheology.example_material(name).at(temperature=kelvin)
    found = modulus(tables[name][str(kelvin)], tmp_path)
    assert found.complex_modulus(OMEGA) == pytest.approx(expected.complex_modulus(OMEGA), rel=DIGITS)
