"""Strain sweeps: files in instrument formats, made by hand because no free ones exist, and laws fitted to them."""

from __future__ import annotations

import math

import matplotlib as mpl
import numpy as np
import pytest
import viscoroll as vr

mpl.use("Agg")

STRAINS = np.geomspace(1e-3, 0.3, 15)
KRAUS = vr.materials.KrausNetwork(storage=8e6, loss=0.8e6, critical_strain=0.01, exponent=0.55)


def written(tmp_path, text, encoding="utf-8"):
    path = tmp_path / "sweep.csv"
    path.write_bytes(text.encode(encoding))
    return path


def test_trios(tmp_path):
    text = (
        "Filename\tgum.tri\r\n[step]\r\nAmplitude sweep - 1\r\n"
        "Oscillation strain\tAngular frequency\tStorage modulus\tLoss modulus\r\n"
        "%\trad/s\tMPa\tkPa\r\n"
        "0.1\t62.8\t9.5\t600\r\n1.0\t62.8\t7.0\t1200\r\n10.0\t62.8\t4.0\t900\r\n"
    )
    found = vr.rheology.read_strain_sweep(written(tmp_path, text), kind="shear", tensile=False, matrix=1e6)
    assert found == vr.materials.StrainSweep(
        strain=[0.1 * 0.01, 0.01, 10 * 0.01],
        storage=[9.5e6, 7e6, 4e6],
        loss=[6e5, 1.2e6, 9e5],
        matrix=1e6,
        frequency=found.frequency,
    )
    assert found.frequency == pytest.approx(62.8, rel=1e-15)


def test_tension_by_tan_delta_and_several_sweeps(tmp_path):
    text = "Set;Strain [%];E' [MPa];tan delta\n1;5,0;9,0;0,2\n1;0,5;18,0;0,1\n1;1;15,0;0,1\n"
    text += "2;1;3;0,1\n2;2;3;0,1\n2;3;3;0,1\n"
    path = written(tmp_path, text, "utf-16")
    with pytest.raises(ValueError, match=r"sweep must be given for .*, which has several: 1 to 2"):
        vr.rheology.read_strain_sweep(path, kind="tension")
    found = vr.rheology.read_strain_sweep(path, kind="tension", sweep=1)
    np.testing.assert_allclose(found.amplitudes, np.sqrt(3.0) * np.array([0.005, 0.01, 0.05]), rtol=1e-14)
    np.testing.assert_allclose(found.storage, [6e6, 5e6, 3e6], rtol=1e-14)
    np.testing.assert_allclose(found.loss, [6e5, 5e5, 6e5], rtol=1e-14)


def test_a_frequency_sweep_with_a_strain_column(tmp_path):
    text = "f [Hz],Strain [%],G' [MPa],G'' [MPa]\n1,0.1,2,0.2\n10,,3,0.3\n100,0.1,4,0.4\n"
    data = vr.rheology.read_rheology(written(tmp_path, text))
    np.testing.assert_allclose(data.isotherms[0].frequency, 2.0 * math.pi * np.array([1.0, 10.0, 100.0]), rtol=1e-14)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("f [Hz],G' [MPa],G'' [MPa]\n1,2,0.2\n", "must have a header with a strain and a storage modulus"),
        ("Strain,G' [MPa],G'' [MPa]\n1,2,0.2\n", "column 'Strain' .strain. must have a unit of '%'"),
        ("Strain [%],G' [MPa]\n1,2\n2,2\n3,2\n", "must have a column of the loss modulus"),
        ("Strain [%],G' [MPa],f [Hz]\n1,2,1\n", "must have a column of the loss modulus or of tan δ"),
    ],
)
def test_files_without_required_columns(tmp_path, text, message):
    with pytest.raises(ValueError, match=message):
        vr.rheology.read_strain_sweep(written(tmp_path, text), kind="shear")


@pytest.mark.parametrize("law", ["kraus", "masing"])
def test_a_fit_recovers_the_law_of_the_sweep(law):
    network = KRAUS if law == "kraus" else vr.materials.MasingNetwork(storage=6e6, critical_strain=0.02)
    storage, loss = network.at(STRAINS)
    sweep = vr.materials.StrainSweep(
        strain=2.0 * STRAINS, storage=storage + 2e6, loss=loss + 1.5e5, kind="double_shear"
    )
    fit = vr.rheology.fit_network(sweep, law=law)
    for name in fit.parameters:
        expected = {"matrix_storage": 2e6, "matrix_loss": 1.5e5}.get(name) or getattr(network, name)
        assert fit.parameters[name].value == pytest.approx(expected, rel=1e-6), name
    assert abs(fit.storage_error).max() < 1e-8


def test_intervals_contain_the_true_value():
    """At least 34 of the 95 % intervals of 40 noisy sweeps contain the truth, with 99.9 % probability."""
    random = np.random.default_rng(7)
    storage, loss = KRAUS.at(STRAINS)
    held = 0
    for _ in range(40):
        noise = 1.0 + 0.02 * random.standard_normal((2, len(STRAINS)))
        noisy = vr.materials.StrainSweep(
            strain=STRAINS, storage=(storage + 2e6) * noise[0], loss=(loss + 2e5) * noise[1]
        )
        fit = vr.rheology.fit_network(noisy)
        critical = fit.parameters["critical_strain"]
        held += critical.lower <= 0.01 <= critical.upper
    assert held >= 34


def test_picture_and_summary_of_a_fit():
    storage, loss = KRAUS.at(STRAINS)
    fit = vr.rheology.fit_network(vr.materials.StrainSweep(strain=STRAINS, storage=storage + 2e6, loss=loss + 2e5))
    assert len(fit.plot().axes[0].lines) == 4
    assert "KrausNetwork, error of storage" in repr(fit)
    with pytest.raises(ValueError, match="law must be 'kraus' or 'masing', got 'ulmer'"):
        vr.rheology.fit_network(fit.sweep, law="ulmer")
