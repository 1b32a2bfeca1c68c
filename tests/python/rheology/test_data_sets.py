"""Files with several data sets, in the words and units of several instruments and languages.

The files in `data` whose names are used here were made for these tests, in the layouts of TRIOS, RheoCompass and
Proteus.
"""

from __future__ import annotations

import math
import random
from pathlib import Path

import numpy as np
import pytest
import viscoroll as vr
from campaign import rheology_files
from shared_cases import command

DATA = Path(__file__).parent / "data"
HERTZ = 2.0 * math.pi


def read(name, **options):
    return vr.rheology.read_rheology(DATA / name, **options)


def written(tmp_path, text, encoding="utf-8", name="data.csv"):
    path = tmp_path / name
    path.write_bytes(text.encode(encoding))
    return path


def test_rows_of_a_creep_step_are_not_moduli():
    data = read("trios_frequency_then_creep.txt", tensile=False)
    (sweep,) = data.isotherms
    np.testing.assert_array_equal(sweep.frequency, [0.1, 0.2, 0.4, 0.8, 1.6, 3.2, 6.4, 12.8])
    assert sweep.storage[0] == 7.9433e5
    assert "2: creep (Creep - 2), 8 points; read: 1" in repr(data)
    with pytest.raises(ValueError, match=r"step must be a frequency sweep or a temperature ramp .* 2: creep"):
        read("trios_frequency_then_creep.txt", tensile=False, step=2)
    with pytest.raises(ValueError, match=r"step must be in \[1, 2\], got 3"):
        read("trios_frequency_then_creep.txt", tensile=False, step=3)


def test_an_amplitude_sweep_is_not_a_frequency_sweep(tmp_path):
    data = read("trios_amplitude_then_frequency.txt", tensile=False)
    (sweep,) = data.isotherms
    assert (sweep.frequency.size, sweep.frequency[-1]) == (8, 12.8)
    assert "1: amplitude sweep (Amplitude sweep - 1), 8 points" in repr(data)
    found = vr.rheology.read_strain_sweep(DATA / "trios_amplitude_then_frequency.txt", kind="shear", tensile=False)
    np.testing.assert_allclose(found.strain[:2], [1e-4, 3e-4], rtol=1e-12)
    alone = (DATA / "trios_amplitude_then_frequency.txt").read_text(encoding="utf-8").split("[step]")[1]
    with pytest.raises(ValueError, match=r"got 1: amplitude sweep .*; read_strain_sweep reads amplitude sweeps"):
        vr.rheology.read_rheology(written(tmp_path, alone), tensile=False)


@pytest.mark.parametrize("name", ["netzsch_two_frequencies.txt", "netzsch_multi.txt"])
def test_frequencies_in_the_names_of_moduli(name):
    data = read(name)
    assert data.is_tensile
    for sweep in data.isotherms:
        np.testing.assert_allclose(sweep.frequency, [HERTZ, 10.0 * HERTZ], rtol=1e-15)
    first = data.isotherms[0]
    expected = {"netzsch_two_frequencies.txt": (100.0, 150.0), "netzsch_multi.txt": (628.67, 1499.7)}[name]
    np.testing.assert_allclose(first.storage, np.array(expected) * 1e6 / 3.0, rtol=1e-14)


def test_one_of_several_data_sets_is_selected_by_number():
    with pytest.raises(ValueError, match=r"step must be given for .*, which contains several data sets, got 1: temp"):
        read("netzsch_compare.txt")
    for step, storage in ((1, 628.67), (2, 691.53)):
        ramp = read("netzsch_compare.txt", step=step).ramp
        assert ramp is not None
        assert ramp.storage[0] == pytest.approx(storage * 1e6 / 3.0, rel=1e-14)
        assert ramp.frequency == pytest.approx(HERTZ, rel=1e-15)


@pytest.mark.parametrize("name", ["german_freq.csv", "german_1_per_s.csv"])
def test_angular_frequencies_per_second(name):
    (sweep,) = read(name, tensile=False).isotherms
    first = {"german_freq.csv": (0.62832, 1.5599e6), "german_1_per_s.csv": (1.0, 1e6)}[name]
    assert (sweep.frequency[0], sweep.storage[0]) == first


@pytest.mark.parametrize("name", ["japanese.csv", "japanese_cp932.csv"])
def test_japanese_column_names(name):
    data = read(name, tensile=False)
    assert [sweep.frequency.size for sweep in data.isotherms] == [13, 13, 13]
    assert data.isotherms[0].storage[0] == 2.77067e6
    assert data.isotherms[0].temperature == pytest.approx(273.21, abs=1e-6)  # mean of 0.00 to 0.12 °C


def test_absolute_value_and_phase_angle():
    (sweep,) = read("complex_modulus_phase.csv").isotherms
    np.testing.assert_allclose(sweep.storage, [1e6 * math.cos(math.radians(6.0)), *sweep.storage[1:]], rtol=1e-15)
    np.testing.assert_allclose(np.hypot(sweep.storage, sweep.loss), [1e6, 1.2e6, 1.5e6], rtol=1e-15)
    np.testing.assert_allclose(np.degrees(np.arctan2(sweep.loss, sweep.storage)), [6.0, 7.0, 8.0], rtol=1e-14)
    assert len(read("gstar_delta.csv", tensile=False).isotherms) == 3


def test_units_behind_underscores():
    (sweep,) = read("unit_in_name.csv").isotherms
    np.testing.assert_allclose(sweep.frequency, HERTZ * np.array([1.0, 10.0, 100.0]), rtol=1e-15)
    assert (sweep.temperature, sweep.storage[0], sweep.loss[0]) == (293.15, 1e6, 1e5)


def test_sweeps_in_several_files(tmp_path):
    names = {"rc_0.csv": 273.15, "rc_20.csv": 293.15, "rc_40.csv": 313.15}
    data = vr.rheology.read_rheology({DATA / name: kelvin for name, kelvin in names.items()}, tensile=False)
    assert [sweep.temperature for sweep in data.isotherms] == list(names.values())
    assert data.isotherms[0].storage[-1] == 5.6679e7
    curve = vr.rheology.superpose(data, reference=293.15)
    assert curve.scatter < 1e-3  # the files contain five digits
    done = command("material", *(f"{DATA / name}@{kelvin - 273.15:g}C" for name, kelvin in names.items()), "--shear",
                   "--reference", "293.15")  # fmt: skip
    assert done.returncode == 0, done.stderr
    assert "3 sweeps at 273.15 to 313.15 K" in " ".join(done.stdout.split())
    with pytest.raises(ValueError, match=r"temperature must be that of the sweep in japanese.csv, got 300 K"):
        vr.rheology.read_rheology({DATA / "japanese.csv": 300.0}, tensile=False)
    with pytest.raises(ValueError, match="moduli of tension in all files or of shear in all files"):
        vr.rheology.read_rheology({DATA / "netzsch_multi.txt": None, DATA / "unit_in_name.csv": None})


def test_stress_relaxation_is_named():
    with pytest.raises(ValueError, match=r"must contain a frequency sweep .*, got 1: stress relaxation, 40 points"):
        read("relaxation.csv")


@pytest.mark.parametrize("unit", ["deg C", "°C", "° C", "degC", "C"])
def test_temperatures_in_celsius(tmp_path, unit):
    for header in (f"T ({unit})", f"Temperature [{unit}]", f'"Temperature, {unit}"'):
        text = f"{header},f (Hz),G' (Pa),G'' (Pa)\n20,1,2e6,1e5\n40,1,1e6,1e5\n20,10,3e6,1e5\n40,10,2e6,1e5\n"
        data = vr.rheology.read_rheology(written(tmp_path, text))
        assert [sweep.temperature for sweep in data.isotherms] == [293.15, 313.15]


@pytest.mark.parametrize(
    ("header", "message"),
    [
        ("T (foo)", r"column 'T' \(temperature\) must have a unit of '°C', .*, got unit 'foo'"),
        ("Temperature [Grad]", "got unit 'Grad'"),
        ("T (K)", "column 'T' must be above absolute zero, got -20 K"),
    ],
)
def test_wrong_units_of_temperatures_are_rejected(tmp_path, header, message):
    text = f"{header},f (Hz),G' (Pa),G'' (Pa)\n-20,1,2e6,1e5\n40,1,1e6,1e5\n"
    with pytest.raises(ValueError, match=message):
        vr.rheology.read_rheology(written(tmp_path, text))


def test_mixed_temperatures_fail_the_check_of_scatter():
    frequency = np.geomspace(0.1, 1e3, 60)
    modulus = vr.Prony(instantaneous_modulus=6e6, weights=[0.5], relaxation_times=[0.1]).complex_modulus(frequency)
    factor = np.where(np.arange(60) % 2 == 0, 1.0, 2.0)  # every second point belongs to a colder specimen
    mixed = vr.MasterCurve(frequency, modulus.real * factor, modulus.imag * factor)
    assert not {check.name: check.passed for check in vr.rheology.check_modulus(mixed)}["scatter"]


#: Names of the columns in the languages that the reader knows.
NAMES = {
    "English": ("Angular frequency", "Storage modulus", "Loss modulus", "Temperature"),
    "German": ("Kreisfrequenz", "Speichermodul", "Verlustmodul", "Temperatur"),
    "French": ("Pulsation", "Module de conservation", "Module de perte", "Température"),
    "Japanese": ("角周波数", "貯蔵弾性率", "損失弾性率", "温度"),
    "symbols": ("ω", "G'", "G''", "T"),
}
UNITS = {"frequency": {"rad/s": 1.0, "1/s": 1.0}, "modulus": {"Pa": 1.0, "kPa": 1e-3, "MPa": 1e-6}}


def random_file(seed):
    """Return the text, the encoding and the sweeps (kelvin, frequency, storage, loss) of a file in a random dialect."""
    draw = random.Random(seed)
    language = draw.choice(list(NAMES))
    names = NAMES[language]
    separator = draw.choice(["\t", ";", ","])
    decimal = "," if separator != "," and draw.random() < 0.4 else "."
    encoding = draw.choice({"Japanese": ["utf-8", "cp932", "utf-16"]}.get(language, ["utf-8", "utf-16", "utf-8-sig"]))
    frequency_unit, modulus_unit = draw.choice(list(UNITS["frequency"])), draw.choice(list(UNITS["modulus"]))
    units = (frequency_unit, modulus_unit, modulus_unit, "°C" if encoding != "cp932" else "C")
    order = draw.sample(range(4), 4)
    beside = draw.random() < 0.5
    header = separator.join(f"{names[i]} [{units[i]}]" if beside else names[i] for i in order)
    lines, sweeps = [], []
    for number in range(draw.randint(1, 4)):
        celsius = 10.0 * number
        if number == 0 or draw.random() < 0.5:
            lines += [draw.choice(["[step]", "Result:\tsweep", ""]), f"Frequency sweep {number}", header]
            lines += [] if beside else [separator.join(units[i] for i in order)]
        rows = []
        for omega in np.geomspace(0.1, 100.0, draw.randint(2, 9)):
            values = (omega, 1e6 * (1.0 + omega), 1e5 * (1.0 + omega), celsius)
            factors = (1.0, UNITS["modulus"][modulus_unit], UNITS["modulus"][modulus_unit], 1.0)
            told = [float(f"{value * factor:.6g}") for value, factor in zip(values, factors, strict=True)]
            lines.append(separator.join(f"{told[i]:.6g}".replace(".", decimal) for i in order))
            rows.append((told[0], told[1] / factors[1], told[2] / factors[2]))
        sweeps.append((celsius + 273.15, np.array(rows).T))
        if draw.random() < 0.3:
            lines += ["[step]", "Creep", separator.join(["Time", "Strain", "Stress"]), separator.join(["s", "%", "Pa"])]
            lines += [separator.join(["10", "1", "100"]), separator.join(["20", "1", "100"]), "[step]", header]
            lines += [] if beside else [separator.join(units[i] for i in order)]
    return "\r\n".join(lines) + "\r\n", encoding, sweeps


@pytest.mark.parametrize("seed", range(100))
def test_random_dialects_are_read_without_loss(tmp_path, seed):
    text, encoding, sweeps = random_file(seed)
    data = vr.rheology.read_rheology(written(tmp_path, text, encoding), tensile=False)
    assert data.dropped == 0
    assert len(data.isotherms) == len(sweeps)
    for found, (kelvin, (frequency, storage, loss)) in zip(data.isotherms, sweeps, strict=True):
        assert found.temperature == pytest.approx(kelvin, abs=1e-9)
        np.testing.assert_allclose(found.frequency, frequency, rtol=1e-12)
        np.testing.assert_allclose(found.storage, storage, rtol=1e-12)
        np.testing.assert_allclose(found.loss, loss, rtol=1e-12)


@pytest.mark.parametrize("seed", range(1000, 1040))
def test_random_files_of_instruments_are_read_or_rejected_for_their_fault(tmp_path, seed):
    file = rheology_files.draw(seed)
    assert not rheology_files.check(file, tmp_path), file


@pytest.mark.parametrize(
    ("header", "message"),
    [
        ("ω/s^-1,G'/foo,G''/Pa", r"column \"G'\" \(storage\) must have a unit of 'Pa', .*, got unit 'foo'"),
        ("f/Hz,Strain/1,Storage Modulus G'/Pa,Loss modulus G''/Pa", "got 1: amplitude sweep, 3 points"),
        ("f/Hz,Temperature/K,G'/Pa,G''/Pa", "got 1: test at one frequency and temperature, 3 points"),
    ],
)
def test_other_tests_are_not_frequency_sweeps(tmp_path, header, message):
    rows = ["1,1e-3,1e6,1e5", "1,1e-2,9e5,1e5", "1,1e-1,8e5,1e5"]
    if "Temp" in header:
        rows = ["1,300,1e6,1e5", "1,300,9e5,1e5", "1,300.1,8e5,1e5"]
    if "foo" in header:
        rows = ["1,1e6,1e5", "2,1e6,1e5", "3,1e6,1e5"]
    with pytest.raises(ValueError, match=message):
        vr.rheology.read_rheology(written(tmp_path, "\n".join([header, *rows])), tensile=False)


def test_columns_that_differ_in_case_only(tmp_path):
    text = "T;t;ω;G';G''\n°C;s;rad/s;Pa;Pa\n20;1;1;2e6;1e5\n20;2;10;3e6;1e5\n"
    (sweep,) = vr.rheology.read_rheology(written(tmp_path, text)).isotherms
    assert (sweep.temperature, sweep.frequency.tolist()) == (293.15, [1.0, 10.0])


def test_western_units_are_not_japanese(tmp_path):
    path = written(tmp_path, "Frequenz [Hz],Speichermodul [N/mm²],Verlustmodul [Pa]\n1,2,1e5\n2,3,1e5\n", "cp1252")
    assert vr.rheology.read_rheology(path, tensile=False).isotherms[0].storage[0] == 2e6
