"""Several files of one material: patterns, and temperatures in the names of files."""

from __future__ import annotations

import numpy as np
import pytest
import viscoroll as vr
from campaign.time_intervals import FREQUENCIES, measured, true_modulus
from shared_cases import command

ROWS = "ω [rad/s],G' [Pa],G'' [Pa]\n1,1e6,1e5\n10,1.2e6,1.2e5\n100,1.5e6,1.4e5\n"


def written(folder, name, text=ROWS):
    (folder / name).write_text(text, encoding="utf-8")
    return folder / name


@pytest.mark.parametrize(
    ("name", "kelvin"),
    [
        ("a_-20C.csv", 253.15),
        ("b_296K.csv", 296.0),
        ("sweep 40 degC.csv", 313.15),
        ("-5°C.csv", 268.15),
        ("relaxation20C_2.csv", 293.15),
        ("dma_1_20.5C.csv", 293.65),
        ("T=22,5C (old).csv", 295.65),
        ("pad \u22127C.csv", 266.15),
        ("minus12C.csv", 261.15),
        ("1_30_deg_C.csv", 303.15),
        ("x_+8C_8C.csv", 281.15),
    ],
)
def test_temperatures_in_names(tmp_path, name, kelvin):
    data = vr.rheology.read_rheology({written(tmp_path, name): None})
    assert data.isotherms[0].temperature == pytest.approx(kelvin, abs=1e-9)
    assert "from the name of the file" in data.remarks[0]


@pytest.mark.parametrize(
    ("name", "got"),
    [
        ("dma20.csv", "none"),
        ("dma-20C.csv", "'dma-20C', whose sign is not clear"),
        ("20-40C.csv", "'-40C', whose sign is not clear"),
        ("m20C.csv", "'m20C', whose sign is not clear"),
        ("20p5C.csv", "'0p5C', which is not clearly a number"),
        ("cured_160C_at_20C.csv", "'160C' and '20C'"),
        ("test_1_C.csv", "none"),
        ("1.2.3C.csv", "none"),
        ("50Cycles.csv", "none"),
    ],
)
def test_names_without_a_clear_temperature(tmp_path, name, got):
    written(tmp_path, name)
    with pytest.raises(ValueError, match="temperature must be given for each of several files") as caught:
        vr.rheology.read_rheology(tmp_path / "*.csv")
    assert caught.value.value == got
    assert name in str(caught.value)


def test_a_name_with_a_temperature_of_another_unit(tmp_path):
    with pytest.raises(ValueError, match=r"a_20K.csv: temperature in the name must be >= 100 K"):
        vr.rheology.read_rheology({written(tmp_path, "a_20K.csv"): None})


def test_a_pattern_reads_all_files_that_match(tmp_path):
    for name in ("dma_-20C.csv", "dma_20C.csv", "dma_60C.csv", "other.csv"):
        written(tmp_path, name)
    data = vr.rheology.read_rheology(str(tmp_path / "dma_*C.csv"))
    assert [round(sweep.temperature, 9) for sweep in data.isotherms] == [253.15, 293.15, 333.15]
    # A given temperature wins over the name.
    given = {tmp_path / "dma_*C.csv": None, tmp_path / "dma_20C.csv": 295.15}
    data = vr.rheology.read_rheology(given)
    assert [round(sweep.temperature, 9) for sweep in data.isotherms] == [253.15, 295.15, 333.15]
    with pytest.raises(ValueError, match=r"path must match a file, got .*dsc"):
        vr.rheology.read_rheology(tmp_path / "dsc_*.csv")
    with pytest.raises(ValueError, match=r"path must have one temperature for .*dma_20C.csv, got 300.0 and 295.15 K"):
        vr.rheology.read_rheology({tmp_path / "dma_2*.csv": 300.0, tmp_path / "dma_20C.csv": 295.15})


def test_a_file_whose_name_has_wildcards_is_one_file(tmp_path):
    data = vr.rheology.read_rheology(written(tmp_path, "pad [20C] *.csv"))
    assert np.isnan(data.isotherms[0].temperature)


def test_the_temperature_of_the_file_wins_over_its_name(tmp_path):
    rows = ROWS.splitlines()
    text = "\n".join([f"{rows[0]},T [°C]", *(f"{row},25" for row in rows[1:])])
    data = vr.rheology.read_rheology({written(tmp_path, "cured_160C.csv", text): None})
    assert data.isotherms[0].temperature == pytest.approx(298.15)


def test_the_command_reads_patterns_of_sweeps_and_tests_over_time(tmp_path):
    for kelvin, test in zip((303.15, 323.15, 343.15), measured(0, 0.0, "relaxation"), strict=True):
        omega = FREQUENCIES[::3]
        modulus = true_modulus(kelvin).complex_modulus(omega)
        columns = (omega.tolist(), modulus.real.tolist(), modulus.imag.tolist())
        rows = "".join(f"{w!r},{g!r},{h!r}\n" for w, g, h in zip(*columns, strict=True))
        written(tmp_path, f"sweep {kelvin - 273.15:g} degC.csv", "f [rad/s],G' [Pa],G'' [Pa]\n" + rows)
        if kelvin == 303.15:
            rows = "".join(f"{t!r},{g!r}\n" for t, g in zip(test.time.tolist(), test.modulus.tolist(), strict=True))
            written(tmp_path, "relaxation_30C.csv", "Time [s],G(t) [Pa]\n" + rows)
    done = command("material", tmp_path / "sweep*.csv", "--reference", "323.15")
    assert done.returncode == 0, done.stderr
    assert "3 sweeps at 303.15 to 343.15 K" in " ".join(done.stdout.split())
    done = command("material", tmp_path / "*.csv", "--reference", "323.15")
    assert done.returncode == 0, done.stderr
    assert "SpectrumFit of 30 of storage and loss, 30 of relaxation" in " ".join(done.stdout.split())
    written(tmp_path, "unnamed.csv")
    done = command("material", tmp_path / "*.csv", "--reference", "323.15")
    assert done.returncode == 2
    assert "unnamed.csv: temperature must be given" in " ".join(done.stderr.split())
    done = command("material", tmp_path / "sweep*C.csv", f"{tmp_path / 'unnamed.csv'}@23C", "--reference", "323.15")
    assert "4 sweeps at 296.15 to 343.15 K" in " ".join(done.stdout.split())
