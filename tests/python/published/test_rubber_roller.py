"""A rubber roller at finite strain: FElupe's numbers, which the errors of linear theory cover."""

from __future__ import annotations

import pytest
from published import rubber_roller as source


def test_penetration_and_pressure(judge):
    # The difference is the error of linear theory, which grows with the strain.
    found = {}
    for row in source.printed():
        r = source.linear(row["load [N/m]"])
        strain = 100.0 * row["penetration [m]"] / (source.OUTER_RADIUS - source.CORE_RADIUS)
        found[f"penetration [mm], strain {strain:g} %"] = 1e3 * r.penetration
        found[f"largest pressure [kPa], strain {strain:g} %"] = 1e-3 * r.max_pressure
    judge(found)


@pytest.mark.parametrize("row", source.printed(), ids=lambda row: f"{row['penetration [m]']}")
def test_errors_of_linear_theory_cover_the_difference(row):
    r = source.linear(row["load [N/m]"])
    assert abs(r.penetration / row["penetration [m]"] - 1.0) < r.penetration_model_error
    assert abs(r.max_pressure / row["largest pressure [Pa]"] - 1.0) < r.max_pressure_model_error


@pytest.mark.filterwarnings("ignore")  # warnings of another program, in any version
def test_felupe_reproduces_its_stored_results():
    # With half as many elements in each direction, the errors are 1.2e-3 of the load and 8e-4 of the pressure.
    pytest.importorskip("felupe")
    rows = source.printed()
    again = source.press([row["penetration [m]"] for row in rows])
    for row, (load, pressure) in zip(rows, again, strict=True):
        assert load == pytest.approx(row["load [N/m]"], rel=2e-3)
        assert pressure == pytest.approx(row["largest pressure [Pa]"], rel=2e-3)
