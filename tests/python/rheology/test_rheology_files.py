"""Files as rheometers and DMA instruments write them, and input checks.

`pressure_sensitive_adhesive.txt` was written by TRIOS 5.1, and `pyvisco_freq_user_raw.csv` is from pyvisco. No free
files of other programs were found, so the others are made by hand after the layouts of files that readers of these
formats expect: TRIOS "Plain Text" (a step below its name, names, units, numbers, in Windows' code page), RheoCompass
(UTF-16, tabs, "Interval data:", units in brackets, a status column), Proteus (##, units behind a slash, semicolons,
decimal commas).
"""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest
import viscoroll as vr

DATA = Path(__file__).parent / "data"
ADHESIVE = vr.rheology.example_data("pressure_sensitive_adhesive.txt")


def written(tmp_path, text, encoding="utf-8"):
    path = tmp_path / "sweep.csv"
    path.write_bytes(text.encode(encoding))
    return path


def test_trios_lims():
    data = vr.rheology.read_rheology(ADHESIVE, tensile=False)
    assert len(data.isotherms) == 20
    assert data.dropped == 1  # a negative loss modulus at -40 °C
    first = data.isotherms[-1]
    # The first data row of the first step.
    assert first.temperature == pytest.approx(423.14, abs=0.01)
    assert first.frequency[0] == 0.628318548202515
    assert first.storage[0] == 10044.287109375
    assert first.loss[0] == 3285.56372070313


def test_pyvisco():
    data = vr.rheology.read_rheology(DATA / "pyvisco_freq_user_raw.csv")
    assert data.is_tensile
    assert len(data.isotherms) == 21
    cold = data.isotherms[0]
    assert cold.frequency[0] == pytest.approx(2.0 * math.pi * 0.1, rel=1e-15)
    assert cold.storage[0] == pytest.approx(8097.175545e6 / 3.0, rel=1e-15)
    assert cold.loss[-1] == pytest.approx(407.0247241e6 / 3.0, rel=1e-15)


def test_trios_plain_text(tmp_path):
    step = (
        "{name}\r\n"
        "Angular frequency\tTemperature\tShear storage modulus\tShear loss modulus\tTan(delta)\r\n"
        "rad/s\t°C\tMPa\tkPa\t\r\n"
        "0.1\t{t}\t{g}\t10.0\t0.005\r\n"
        "1.0\t{t}\t2.5\t20.0\t0.008\r\n"
    )
    text = "Filename\tC:\\Daten\\Gummi.tri\r\nInstrument name\tDHR\r\nOperator\tMüller\r\n[step]\r\n"
    text += step.format(name="Frequency sweep - 1", t="20.0", g="2.0") + "[step]\r\n"
    text += step.format(name="Frequency sweep - 2", t="40.0", g="1.5")
    data = vr.rheology.read_rheology(written(tmp_path, text, "cp1252"))
    assert [isotherm.temperature for isotherm in data.isotherms] == [293.15, 313.15]
    np.testing.assert_array_equal(data.isotherms[0].storage, [2.0e6, 2.5e6])
    np.testing.assert_array_equal(data.isotherms[1].loss, [10e3, 20e3])


def test_rheocompass(tmp_path):
    rows = [
        "Project:\tGummi",
        "Test:\tFrequenztest",
        "",
        "Result:\tFrequency Sweep 1",
        "",
        "Interval and data points:\t1\t3",
        "Interval data:\tPoint No.\tTemperature\tAngular Frequency\tStorage Modulus\tLoss Modulus\tTorque\tStatus",
        "\t\t\t\t\t\t\t",
        "\t\t[°C]\t[rad/s]\t[Pa]\t[Pa]\t[mN·m]\t",
        "\t1\t25.01\t100\t2,5E6\t3,1E5\t0.02\tTruStrain",
        "\t2\t25.02\t10\t2,2E6\t2,5E5\t0.02\tTruStrain",
        "\t3\t24.99\t1\t\t2,1E5\t0.01\tME-",
    ]
    data = vr.rheology.read_rheology(written(tmp_path, "\r\n".join(rows), "utf-16"), tensile=False)
    (sweep,) = data.isotherms
    np.testing.assert_array_equal(sweep.frequency, [10.0, 100.0])
    np.testing.assert_array_equal(sweep.storage, [2.2e6, 2.5e6])
    assert data.dropped == 1  # the point without a storage modulus


def test_proteus(tmp_path):
    rows = [
        "#EXPORTTYPE:DATA ALL",
        "#INSTRUMENT:NETZSCH DMA 242",
        "#SEPARATOR:SEMICOLON",
        "##Temp./°C;f/Hz;E'/MPa;E''/MPa;tan δ",
        "25,0;1,000;10,5;1,05;0,1",
        "25,0;10,000;12,5;1,5;0,12",
    ]
    data = vr.rheology.read_rheology(written(tmp_path, "\n".join(rows)))
    (sweep,) = data.isotherms
    np.testing.assert_allclose(sweep.frequency, [2.0 * math.pi, 20.0 * math.pi], rtol=1e-15)
    np.testing.assert_allclose(sweep.storage, [3.5e6, 12.5e6 / 3.0], rtol=1e-15)


#: All columns that TRIOS writes, after those of files that programs for it read.
TRIOS_ALL = """Storage modulus\tLoss modulus\tTan(delta)\tAngular frequency\tOscillation torque\tStep time\t\
Temperature\tRaw phase\tOscillation displacement\tComplex viscosity\tFrequency\tOscillation strain\tAxial force
MPa\tMPa\t\trad/s\tµN.m\ts\t°C\t°\trad\tPa.s\tHz\t%\tN
1.00\t0.10\t0.100\t0.1\t10.0\t12\t25.0\t4.1\t0.001\t1e7\t{low}\t0.1\t0.2
1.10\t0.12\t0.109\t1\t10.0\t24\t25.0\t4.1\t0.001\t1e6\t0.159155\t0.1\t0.2
1.21\t0.14\t0.116\t10\t10.0\t33\t25.0\t4.1\t0.001\t1e5\t1.59155\t0.1\t0.2
"""


def test_a_frequency_in_radians_and_in_hertz(tmp_path):
    data = vr.rheology.read_rheology(written(tmp_path, TRIOS_ALL.format(low="0.0159")), tensile=False)
    np.testing.assert_array_equal(data.isotherms[0].frequency, [0.1, 1.0, 10.0])
    assert repr(data).endswith("; frequency from 'Angular frequency', with which 'Frequency' agrees")


def test_frequency_columns_in_reverse_order_and_without_a_unit(tmp_path):
    rows = "f,G',G'',omega\nHz,MPa,MPa,{unit}\n1,1,0.1,6.2832\n2,1.1,0.1,12.566\n"
    data = vr.rheology.read_rheology(written(tmp_path, rows.format(unit="rad/s")))
    np.testing.assert_array_equal(data.isotherms[0].frequency, [6.2832, 12.566])
    data = vr.rheology.read_rheology(written(tmp_path, rows.format(unit="")))
    np.testing.assert_allclose(data.isotherms[0].frequency, [2.0 * math.pi, 4.0 * math.pi], rtol=1e-15)
    assert data.remarks == ("frequency from 'f', because 'omega' has no unit",)


def test_contradictory_frequencies_are_rejected(tmp_path):
    path = written(tmp_path, TRIOS_ALL.format(low="0.1"))
    with pytest.raises(ValueError, match=r"'Angular frequency' and 'Frequency' must agree .* got 0.1 rad/s and 0.1 Hz"):
        vr.rheology.read_rheology(path, tensile=False)
    data = vr.rheology.read_rheology(path, tensile=False, columns={"frequency": ("Frequency", "Hz")})
    np.testing.assert_allclose(data.isotherms[0].frequency[0], 0.2 * math.pi)
    three = "f,freq,omega,G',G''\nHz,Hz,rad/s,Pa,Pa\n1,1,6.2832,1,1\n"
    with pytest.raises(ValueError, match="two columns contain frequency, 'f' and 'omega': select one"):
        vr.rheology.read_rheology(written(tmp_path, three))


def test_a_strain_sweep_with_both_frequencies(tmp_path):
    rows = "Oscillation strain,Storage modulus,Loss modulus,Angular frequency,Frequency\n%,MPa,MPa,rad/s,Hz\n"
    rows += "".join(f"{g},{2.0 - g / 100},0.3,6.2832,1\n" for g in (0.1, 1.0, 10.0))
    sweep = vr.rheology.read_strain_sweep(written(tmp_path, rows), kind="shear", tensile=False)
    np.testing.assert_allclose(sweep.strain, [1e-3, 1e-2, 1e-1], rtol=1e-12)


@pytest.mark.parametrize(
    ("header", "factor"),
    [
        ("f (Hz),G' (kPa),tan delta", (2.0 * math.pi, 1e3)),
        ("Frequency [rad/s],G' [GPa],tan δ", (1.0, 1e9)),
        ('Frequency / Hz,"G\' in MPa",Loss factor', (2.0 * math.pi, 1e6)),
    ],
)
def test_units_with_the_names_and_tan_delta(tmp_path, header, factor):
    (sweep,) = vr.rheology.read_rheology(written(tmp_path, f"{header}\n1,2,0.5\n3,4,0.25\n")).isotherms
    np.testing.assert_allclose(sweep.frequency, np.array([1.0, 3.0]) * factor[0], rtol=1e-15)
    np.testing.assert_allclose(sweep.storage, np.array([2.0, 4.0]) * factor[1], rtol=1e-15)
    np.testing.assert_allclose(sweep.loss, np.array([1.0, 1.0]) * factor[1], rtol=1e-15)


def test_names_and_units_given_by_the_caller(tmp_path):
    path = written(tmp_path, "Drehzahl;Speicher;Verlust;Ofen\n1;2;1;293,15\n3;4;1;293,15\n")
    columns = {
        "frequency": ("Drehzahl", "Hz"),
        "storage": ("Speicher", "MPa"),
        "loss": ("Verlust", "kPa"),
        "temperature": ("Ofen", "K"),
    }
    (sweep,) = vr.rheology.read_rheology(path, columns=columns, tensile=True, poisson_ratio=0.25).isotherms
    assert sweep.temperature == 293.15
    np.testing.assert_allclose(sweep.storage, [0.8e6, 1.6e6], rtol=1e-15)  # G = E / 2.5
    np.testing.assert_allclose(sweep.loss, [400.0, 400.0], rtol=1e-15)


def test_sweeps_of_one_table_are_separated_by_temperature(tmp_path):
    rows = [f"{f},{1.0 + f},0.1,{t + d}" for d, f in ((0.1, 1), (0.0, 2), (-0.1, 3)) for t in (0, 10, 20)]
    text = "f,G',G'',T\nHz,MPa,MPa,C\n" + "\n".join(rows)
    data = vr.rheology.read_rheology(written(tmp_path, text))
    assert [round(sweep.temperature, 6) for sweep in data.isotherms] == [273.15, 283.15, 293.15]
    assert [sweep.frequency.size for sweep in data.isotherms] == [3, 3, 3]


def test_nonpositive_moduli_are_dropped_and_counted(tmp_path):
    data = vr.rheology.read_rheology(written(tmp_path, "f,G',G''\nHz,Pa,Pa\n1,2,1\n2,-2,1\n3,2,0\n4,2,1\n0,1,1\n"))
    assert data.dropped == 3
    assert data.isotherms[0].frequency.size == 2


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (
            "f,G',G''\n1,2,1\n",
            r"column 'f' \(frequency\) must have a unit of 'Hz', 'rad/s', .*, got no unit; pass columns=",
        ),
        ("f,G',G''\nrpm,Pa,Pa\n1,2,1\n", r"column 'f' \(frequency\) must have a unit of .*, got unit 'rpm'"),
        ("f,G',G''\nHz,psi,Pa\n1,2,1\n", r"column \"G'\" \(storage\) must have a unit of 'Pa', .*, got unit 'psi'"),
        ("f,G',G''\n1/s,Pa,Pa\n1,2,1\n", r"column 'f' \(frequency\) must have a unit of .*, got unit '1/s'"),
        ("f,G',G'',T\nHz,Pa,Pa,\n1,2,1,20\n", r"column 'T' \(temperature\) must have a unit of .*, got no unit"),
        ("f,G',G'',T\nHz,Pa,Pa,K\n1,2,1,20\n", r"column 'T' with the unit 'K' must be >= 100 K .*, got 20 K"),
        ("f,G',G''\nHz,mpa,Pa\n1,2,1\n", r"column \"G'\" \(storage\) must have a unit of .*, got unit 'mpa'"),
        ("omega,G',G''\nHz,Pa,Pa\n1,2,1\n", "column 'omega' must be in 'rad/s' according to its name, got 'Hz'"),
        (
            "f,Storage modulus,Loss modulus\nHz,Pa,Pa\n1,2,1\n",
            "may be a tensile or a shear modulus: pass tensile=True or tensile=False",
        ),
        ("f,G',x\nHz,Pa,Pa\n1,2,1\n", "must have a column of the loss modulus or of tan δ"),
        ("f,G',E',G''\nHz,Pa,Pa,Pa\n1,2,1,1\n", 'two columns contain storage, "G\'" and "E\'": select one by columns='),
        ("a,b,c\n1,2,1\n", "must have a header with a frequency and a storage modulus"),
        ("", "must have a header"),
        ("f,G',G''\nHz,Pa,Pa\n1,-2,1\n", "must have points with moduli > 0, got none among 1"),
        (
            "f,G',G''\nHz,MPa,MPa\n1,1e307,1\n",
            r"sweep.csv: column \"G'\" \(storage\) must be at most 1e\+14 MPa in magnitude, got 1e\+307",
        ),
        ("f,G',G''\nkHz,Pa,Pa\n1e306,2,1\n", r"column 'f' \(frequency\) must be at most 1.592e\+96 kHz in magnitude"),
        ("f (Hz),G' (Pa),G\x1floss\n1,2,1\n", r"in the shell --columns loss=G\\x1floss:unit$"),
        ("f,G',tan d\nHz,Pa,\n1,2,1e300\n", r"column 'tan d' \(tan_delta\) must be at most 1e\+20 in magnitude"),
    ],
)
def test_messages_ask_for_missing_information(tmp_path, text, message):
    with pytest.raises(ValueError, match=message):
        vr.rheology.read_rheology(written(tmp_path, text))


def test_units_that_differ_only_in_case(tmp_path):
    (sweep,) = vr.rheology.read_rheology(written(tmp_path, "f,G',G''\nhz,mPa,KPA\n1,2,1\n")).isotherms
    assert sweep.storage[0] == pytest.approx(2e-3)
    assert sweep.loss[0] == 1e3


def test_a_binary_file(tmp_path):
    path = tmp_path / "sweep.tri"
    path.write_bytes(bytes(range(256)) * 2000)
    with pytest.raises(ValueError, match="got a TRIOS file"):
        vr.rheology.read_rheology(path)


@pytest.mark.parametrize(
    ("options", "error", "message"),
    [
        (
            {"columns": {"modulus": "G'"}},
            ValueError,
            "columns must have keys from frequency, storage, .*, got 'modulus'",
        ),
        ({"columns": {"storage": 3}}, TypeError, r"columns\['storage'\] must be a name, or a name and a unit"),
        ({"poisson_ratio": 0.6}, ValueError, r"poisson_ratio must be in \(-1, 0.5\], got 0.6"),
        ({"tensile": "yes"}, TypeError, "tensile must be True, False or None, got 'yes'"),
    ],
)
def test_bad_options(options, error, message):
    with pytest.raises(error, match=message):
        vr.rheology.read_rheology(ADHESIVE, **options)
