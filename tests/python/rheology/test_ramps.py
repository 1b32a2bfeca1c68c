"""Temperature ramps at one frequency, the most common laboratory data: available and unavailable results."""

from __future__ import annotations

import numpy as np
import pytest
import viscoroll as vr
from shared_cases import command
from viscoroll.rheology import TemperatureRamp

#: Two relaxations eight decades apart and the times between them, with a known law.
RUBBER = vr.Prony(instantaneous_modulus=1e9, weights=[0.1] * 9 + [0.099], relaxation_times=np.logspace(-7, 2, 10))
LAW = vr.materials.WilliamsLandelFerry(c1=12.0, c2=90.0, reference_temperature=303.15)
FREQUENCY = 2.0 * np.pi


def modulus(temperature, frequency=FREQUENCY):
    return RUBBER.complex_modulus(frequency * LAW(temperature))


def written(path, step, *, noise=0.0, frequencies=(FREQUENCY,), head="Temperature,Frequency"):
    """Write a ramp from 0 to 80 °C as instruments do: the temperature rises continuously."""
    generator = np.random.default_rng(3)
    temperature = np.arange(0.0, 80.0 + 0.5 * step, step)
    rows = [f"{head},Storage modulus,Loss modulus", "°C,Hz,MPa,MPa" if "," in head else "°C,MPa,MPa"]
    for number, degrees in enumerate(temperature):
        frequency = frequencies[number % len(frequencies)]
        value = 3.0 * complex(modulus(degrees + 273.15, frequency)) * (1.0 + noise * generator.standard_normal())
        hertz = [f"{frequency / 2.0 / np.pi:.5g}"] if "," in head else []
        rows.append(",".join([f"{degrees:.2f}", *hertz, f"{value.real / 1e6:.6g}", f"{value.imag / 1e6:.6g}"]))
    path.write_text("\n".join(rows), encoding="utf-8")
    return path


@pytest.mark.parametrize("step", [0.2, 0.7, 2.5])  # below and above the gaps that separate sweeps
def test_a_ramp_is_recognized_and_described(tmp_path, step):
    data = vr.rheology.read_rheology(written(tmp_path / "ramp.csv", step), tensile=True)
    ramp = data.ramp
    assert isinstance(ramp, TemperatureRamp)
    assert ramp.frequency == pytest.approx(FREQUENCY)
    assert ramp.temperature.size == round(80.0 / step) + 1
    # 0.005 K, round-off of the file
    np.testing.assert_allclose(ramp.storage, modulus_over(ramp.temperature).real, rtol=1e-2)
    said = repr(data)
    assert said.splitlines()[0].startswith("RheologyData of ramp.csv: a temperature ramp at one frequency, 6.283 rad/s")
    assert "unavailable    dependence on frequency" in said
    assert len(said.splitlines()) < 7


def modulus_over(temperature):
    return np.array([complex(modulus(kelvin)) for kelvin in temperature])


def test_no_shift_is_fitted_to_a_ramp(tmp_path):
    data = vr.rheology.read_rheology(written(tmp_path / "ramp.csv", 2.5), tensile=True)
    with pytest.raises(
        ValueError, match=r"got a temperature ramp at 6.283 rad/s: pass a law of the shift, such as factors="
    ):
        vr.rheology.superpose(data, reference=303.15)


def test_a_shift_law_gives_a_master_curve_of_a_ramp_that_is_checked(tmp_path):
    data = vr.rheology.read_rheology(written(tmp_path / "ramp.csv", 1.0, noise=0.003), tensile=True)
    curve = vr.rheology.superpose(data, reference=303.15, factors=LAW)
    omega = np.geomspace(1e-2, 1e5, 15)
    true, found = RUBBER.complex_modulus(omega), curve.fit.series.complex_modulus(omega)
    np.testing.assert_allclose(np.abs(found), np.abs(true), rtol=0.03)
    assert all(check.passed for check in vr.rheology.check_modulus(curve))
    # With twice the activation, storage changes half as fast with frequency as its loss requires.
    wrong = vr.materials.WilliamsLandelFerry(c1=24.0, c2=90.0, reference_temperature=303.15)
    causal, passive, *_ = vr.rheology.check_modulus(vr.rheology.superpose(data, reference=303.15, factors=wrong))
    assert not causal.passed
    assert not passive.passed
    # A table of the same factors gives the same result.
    table = vr.rheology.ShiftFactors(
        temperature=(273.15, 303.15, 353.15), log10_factor=[np.log10(LAW(t)) for t in (273.15, 303.15, 353.15)]
    )
    ends = vr.rheology.superpose(data, reference=303.15, factors=table).factors.log10_factor
    assert (ends[0], ends[-1]) == pytest.approx([np.log10(LAW(t)) for t in (273.15, 353.15)])


def test_modulus_and_loss_factor_of_a_ramp_at_a_temperature(tmp_path):
    ramp = vr.rheology.read_rheology(written(tmp_path / "ramp.csv", 0.5), tensile=True).ramp
    found, true = ramp.at(temperature=314.4), complex(modulus(314.4))
    assert found.modulus == pytest.approx(true.real, rel=1e-2)
    assert found.loss_factor == pytest.approx(true.imag / true.real, rel=1e-2)
    assert complex(found.complex_modulus(FREQUENCY)) == pytest.approx(true, rel=2e-2)
    peak = np.linspace(273.15, 353.15, 801)
    tan_delta = modulus_over(peak).imag / modulus_over(peak).real
    assert ramp.loss_peak == pytest.approx(peak[np.argmax(tan_delta)], abs=0.5)
    with pytest.raises(ValueError, match=r"measured range, 273.15 to 353.15 K \(0 to 80 °C\), got 363.15 K \(90"):
        ramp.at(temperature=363.15)
    with pytest.raises(ValueError, match=r"temperature must be >= 100 K \(20 °C are 293.15 K\), got 20 K"):
        ramp.at(temperature=20.0)


def test_frequency_steps_during_heating_are_sweeps(tmp_path):
    steps = tuple(FREQUENCY * np.array([1.0, 3.0, 10.0]))
    data = vr.rheology.read_rheology(written(tmp_path / "ramp.csv", 0.2, frequencies=steps), tensile=True)
    assert data.ramp is None
    assert {sweep.frequency.size for sweep in data.isotherms[:-1]} == {3}


def test_a_ramp_without_a_frequency_column(tmp_path):
    path = written(tmp_path / "ramp.csv", 2.0, head="Temperature")
    with pytest.raises(
        ValueError, match=r"without a frequency column, as in a ramp at one frequency: pass frequency=... in rad/s"
    ):
        vr.rheology.read_rheology(path, tensile=True)
    assert vr.rheology.read_rheology(path, tensile=True, frequency=FREQUENCY).ramp.frequency == pytest.approx(FREQUENCY)
    with pytest.raises(ValueError, match="frequency must be > 0 rad/s, got -1"):
        vr.rheology.read_rheology(path, tensile=True, frequency=-1)
    with pytest.raises(ValueError, match="frequency must be left out if the file contains the frequency, got 5 rad/s"):
        vr.rheology.read_rheology(written(tmp_path / "with.csv", 2.0), tensile=True, frequency=5.0)


def test_a_ramp_on_the_command_line(tmp_path):
    written(tmp_path / "ramp.csv", 2.5)

    def answered(*words):
        done = command("material", "ramp.csv", "--tensile", *words, cwd=tmp_path)
        return done.returncode, done.stdout, done.stderr

    code, said, _ = answered("--at", 313.15)
    assert code == 0
    assert "a temperature ramp at one frequency" in said.splitlines()[0]
    assert "undetermined" not in said
    assert "shear_modulus = { type = 'loss_factor', modulus = " in said
    assert answered()[0] == 0
    assert answered("--save", "m.toml")[2].endswith("a law of the shift: give --factors or --wlf\n")
    code, said, _ = answered("--reference", 303.15, "--wlf", "12,90,303.15", "--save", "m.toml")
    assert code == 0
    assert "undetermined" not in said
    omega = np.geomspace(1e-1, 1e4, 6)
    table = vr.rheology.load_material(tmp_path / "m.toml", temperature=323.15).complex_modulus(omega)
    np.testing.assert_allclose(np.abs(table), np.abs(RUBBER.complex_modulus(omega * LAW(323.15))), rtol=0.1)
    assert (
        answered("--wlf", "12,90")[2]
        == "viscoroll: --wlf must have the form C1,C2,T_r, such as 17.44,51.6,208, got '12,90'\n"
    )


def test_an_unknown_column_may_be_the_frequency(tmp_path):
    """A table of several frequencies is not read as a ramp at one frequency unless the user says so."""
    path = tmp_path / "export.csv"
    path.write_text(
        "Température;Oszillation;G';G''\n" + "".join(f"{t};{f};{t + f};1\n" for t in (20, 40) for f in (1, 10))
    )
    columns = {"temperature": ("Température", "C"), "storage": ("G'", "Pa"), "loss": ("G''", "Pa")}
    with pytest.raises(ValueError, match=r"or columns=\{\"frequency\".* if it is one of 'Oszillation'$"):
        vr.rheology.read_rheology(path, columns=columns)
    data = vr.rheology.read_rheology(path, columns=columns | {"frequency": ("Oszillation", "Hz")})
    assert [sweep.frequency.size for sweep in data.isotherms] == [2, 2]
    path.write_text("Temperatur [°C];Frequenz [Hz];G' [Pa];G'' [Pa]\n20;1;3;1\n20;10;4;1\n40;1;2;1\n40;10;3;1\n")
    assert vr.rheology.read_rheology(path).ramp is None
