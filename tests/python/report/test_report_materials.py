"""Sources of the moduli in reports."""

from __future__ import annotations

import math

import numpy as np
import pytest
import viscoroll as vr
from viscoroll.report.materials import materials_of


def layered(modulus):
    return {"wheel": {"layers": [{"shear_modulus": modulus}]}}


def rows_of(modulus, folder):
    (material,) = materials_of(layered(modulus), folder)
    assert material.place == "wheel.layers[0].shear_modulus"
    return material.kind, dict(material.rows)


@pytest.fixture(scope="module")
def saved(tmp_path_factory):
    """Return a file of a measured material."""
    data = vr.rheology.read_rheology(vr.rheology.example_data("pressure_sensitive_adhesive.txt"), tensile=False)
    curve = vr.rheology.superpose(data.between(288.15, 338.15), reference=293.15)
    path = tmp_path_factory.mktemp("measured") / "adhesive.toml"
    vr.rheology.save_material(path, curve)
    return path, curve


def test_numbers_of_the_file_are_their_own_source(tmp_path):
    assert rows_of(1e6, tmp_path) == ("elastic", {"source": "numbers in the case file"})
    modulus = {"type": "loss_factor", "modulus": 1e6, "loss_factor": 0.1, "reference_frequency": 10.0}
    assert rows_of(modulus, tmp_path) == ("loss factor", {"source": "numbers in the case file"})
    modulus = {"type": "master_curve", "file": "curve.csv"}
    assert rows_of(modulus, tmp_path) == ("master curve", {"source": "file curve.csv"})


@pytest.mark.parametrize("short", [True, False])
def test_a_measured_material_states_data_and_range(saved, short):
    path, curve = saved
    modulus = path.name if short else {"type": "measured", "file": path.name, "temperature": 303.15}
    kind, rows = rows_of(modulus, path.parent)
    assert kind == "measured"
    assert rows["file"] == "adhesive.toml"
    assert rows["measured data"] == curve.data.source
    assert rows["reference temperature"] == "293.15 K (20 °C)"
    frequency = np.asarray(curve.curve.frequency)
    low, high = frequency[frequency > 0.0].min(), frequency.max()
    assert rows["frequencies of the table"] == f"{low:.3g} to {high:.3g} rad/s"
    assert rows["temperatures"].startswith(f"{curve.factors.temperature[0]:.5g} to ")
    assert rows.get("temperature") == (None if short else "303.15 K (30 °C)")


def test_a_hardness_has_the_interval_of_its_estimate(tmp_path):
    _, rows = rows_of({"type": "hardness", "hardness": 60.0, "rebound": 0.55, "reference_frequency": 100.0}, tmp_path)
    assert rows["source"] == "estimate from a hardness of 60 Shore A"
    assert rows["shear modulus"] == "1.54 MPa, in [1.11, 2.19] MPa"  # docstring of hardness_to_modulus
    best = float(rows["loss factor"].partition(",")[0])
    assert best == pytest.approx(-math.log(0.55) / math.pi, abs=0.005)  # three digits; exp(-π η) of the energy is left
    assert rows["loss factor"].endswith("estimate from a rebound of 55 %")


def test_constants_name_file_and_program(tmp_path):
    deck = "*MATERIAL, NAME=TREAD\n*ELASTIC, MODULI=INSTANTANEOUS\n6.0, 0.5\n*VISCOELASTIC, TIME=PRONY\n0.3, 0.3, 0.1\n"
    (tmp_path / "tread.inp").write_text(deck)
    _, rows = rows_of({"type": "constants", "file": "tread.inp", "units": "mm-t-s"}, tmp_path)
    assert (rows["file"], rows["name"]) == ("tread.inp", "TREAD")
    assert "abaqus" in rows["program"].lower()


def test_a_modulus_that_softens_lists_its_parts(tmp_path):
    modulus = {
        "type": "softening",
        "matrix": {"type": "published", "name": "vinyl_nitrile_foam", "temperature": 293.15},
        "network": {"type": "strain_sweep", "file": "sweep.csv"},
    }
    found = {material.place: dict(material.rows) for material in materials_of(layered(modulus), tmp_path)}
    place = "wheel.layers[0].shear_modulus"
    assert [*found] == [place, f"{place}.matrix", f"{place}.network"]
    assert "Landauer" in found[f"{place}.matrix"]["citation"]
    assert found[f"{place}.network"] == {"source": "file sweep.csv"}
