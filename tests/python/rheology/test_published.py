"""Published materials: each names its source and its unknowns, and agrees with its source."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest
import viscoroll as vr
from viscoroll.case import example_text, load_case
from viscoroll.rheology.published import EXAMPLES

PAGE = (Path(__file__).parents[3] / "docs" / "published-materials.md").read_text(encoding="utf-8")


@pytest.mark.parametrize("name", EXAMPLES)
def test_each_material_names_its_source_and_unknowns(name):
    material = vr.rheology.example_material(name)
    assert max(map(len, repr(material).splitlines())) <= 92
    said = " ".join(repr(material).split())
    for text in (material.citation, material.address, material.license, material.measured, *material.not_measured):
        assert text
        assert text in said
    assert any("density" in text for text in material.not_measured)
    assert (material.poisson_ratio is None) == any(text == "Poisson's ratio" for text in material.not_measured)
    assert f'"{name}"' in PAGE
    low, high = material.temperature
    with pytest.raises(ValueError, match=rf"temperature must be in the measured range of {name}, .* K .*, got 500 K"):
        material.at(temperature=500.0)
    with pytest.raises(ValueError, match=r"temperature must be >= 100 K \(20 °C are 293.15 K\), got 20 K"):
        material.at(temperature=20.0)
    for kelvin in np.linspace(low, high, 7):
        modulus = material.at(temperature=kelvin).complex_modulus([0.0, 1.0, 100.0])
        assert (modulus.real > 0.0).all()
        assert (modulus.imag[1:] > 0.0).all()


@pytest.mark.parametrize("name", EXAMPLES)
def test_each_material_can_roll(name):
    material = vr.rheology.example_material(name)
    ratio = 0.5 if material.poisson_ratio is None else material.poisson_ratio
    layer = vr.Layer(thickness=2e-3, shear_modulus=material.at(temperature=293.15), poisson_ratio=ratio)
    ball = vr.CoatedSphere(core_radius=20e-3, layers=[layer])
    assert vr.solve(ball, load=0.1, angular_speed=0.5, accuracy=0.1).rolling_resistance_coefficient > 0.0


def test_the_adhesive_follows_from_its_data():
    """The adhesive is the result of the steps of the tutorial with the data of the package."""
    data = vr.rheology.read_rheology(vr.rheology.example_data("pressure_sensitive_adhesive.txt"), tensile=False)
    curve = vr.rheology.superpose(data.between(238.15, 433.15), reference=293.15)
    omega = np.geomspace(1e-2, 1e4, 13)
    for kelvin in (273.15, 293.15, 333.15):
        stored = (
            vr.rheology.example_material("pressure_sensitive_adhesive").at(temperature=kelvin).complex_modulus(omega)
        )
        # The least-squares fit of the shifts is reproducible within 1e-6 decades, also on other machines.
        np.testing.assert_allclose(stored, curve.at(temperature=kelvin).complex_modulus(omega), rtol=1e-3)


@pytest.mark.parametrize(
    ("kelvin", "ratio", "time"), [(293.1633333, 335.9818859, 0.227690381), (313.153, 38.61426008, 0.229855055)]
)
def test_the_foam_agrees_with_measurements_at_10_radians_per_second(kelvin, ratio, time):
    """Compare with the authors' summary of the same sheets: tan δ = 1/(ωτ), E' = 24 545.2584 Pa γ ω²τ² / (1 + ω²τ²)."""
    foam = vr.rheology.example_material("vinyl_nitrile_foam")
    assert foam.poisson_ratio == 0.228250439894909
    relaxing = 10.0 * time
    storage = 24545.2584 * ratio * relaxing**2 / (1.0 + relaxing**2)
    tension = 2.0 * (1.0 + foam.poisson_ratio) * complex(foam.at(temperature=kelvin).complex_modulus(10.0))
    assert tension.real == pytest.approx(storage, rel=2e-3)
    assert tension.imag / tension.real == pytest.approx(1.0 / relaxing, rel=6e-3)


def test_an_unknown_name():
    with pytest.raises(
        ValueError, match="name must be one of pressure_sensitive_adhesive, vinyl_nitrile_foam, got 'NR'"
    ):
        vr.rheology.example_material("NR")


def test_in_a_case_file(tmp_path):
    text = example_text().split("[ball.layers.shear_modulus]")[0]
    text += 'shear_modulus = { type = "published", name = "vinyl_nitrile_foam", temperature = 293.15 }\n'
    path = tmp_path / "case.toml"
    path.write_text(text + "[rolling]\nload = 1.0\nangular_speed = 1.0\n", encoding="utf-8")
    assert load_case(path).body.layers[0].shear_modulus == vr.rheology.example_material("vinyl_nitrile_foam").at(
        temperature=293.15
    )
    path.write_text(path.read_text(encoding="utf-8").replace("293.15 }", "363.15 }"), encoding="utf-8")
    with pytest.raises(ValueError, match=r"measured range of vinyl_nitrile_foam, 253.15 to 333.15 K \(-20 to 60 °C\)"):
        load_case(path)


def test_the_page_shows_all_materials():
    named = re.search(r"for name in \((.*)\):", PAGE)
    assert named is not None
    assert set(re.findall(r"\"(\w+)\"", named[1])) == set(EXAMPLES)
