"""Draws of materials in files: stored with the material, and used by a study on the command line."""

from __future__ import annotations

import numpy as np
import pytest
import viscoroll as vr
import xarray
from campaign.intervals import REFERENCE, Noise, measured
from shared_cases import command
from viscoroll.studies.table import save_table

STUDY = """
[cylinder]
core_radius = 20e-3

[[cylinder.layers]]
thickness = 2e-3
poisson_ratio = 0.5
shear_modulus = { type = "measured", file = "rubber.toml", temperature = 333.15, form = "prony" }

[rolling]
load = 1000.0
angular_speed = 3.0

[numerics]
nodes_per_revolution = 1000

[sweep]
"rolling.load" = [500.0, 1000.0]

[draws]
of = ["cylinder.layers[0].shear_modulus"]
confidence = 0.9
"""


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """Return the folder of a material with ten draws and of a study, and the superposition."""
    folder = tmp_path_factory.mktemp("drawn")
    curve = vr.rheology.superpose(measured(1, Noise()), reference=REFERENCE)
    vr.rheology.save_material(folder / "rubber.toml", curve, fit=curve.fit, draws=curve.draws(10))
    (folder / "study.toml").write_text(STUDY)
    return folder, curve


def roller(modulus):
    layer = vr.Layer(thickness=2e-3, shear_modulus=modulus, poisson_ratio=0.5)
    return vr.CoatedCylinder(core_radius=20e-3, layers=[layer])


def test_a_study_on_the_command_line_uses_the_draws(folder):
    folder, curve = folder
    ended = command("sweep", "study.toml", "--table", "study.csv", cwd=folder)
    assert ended.returncode == 0, ended.stderr
    found = xarray.load_dataset(folder / "study.nc")
    expected = vr.sweep(
        roller,
        modulus=curve.draws(10).map(lambda c: c.series_at(temperature=333.15)),
        load=[500.0, 1000.0],
        angular_speed=3.0,
        mesh=vr.Mesh(nodes_per_revolution=1000),
        confidence=0.9,
        progress=False,
    )
    for name in ("resisting_torque", "resisting_torque_mean", "resisting_torque_lower", "resisting_torque_upper"):
        np.testing.assert_allclose(found[name], expected[name], rtol=1e-6)
    assert command("plot", "study.nc", cwd=folder).returncode == 0
    head, *rows = (line.split(",") for line in (folder / "study.csv").read_text().splitlines())
    assert (head[0], len(rows)) == ("load [N/m]", 2)
    with pytest.raises(ValueError, match=r"path must end in \.csv, got 'study\.txt'"):
        save_table(found, "study.txt")
    lower = [float(row[head.index("resisting_torque_lower [N m/m]")]) for row in rows]
    assert lower == pytest.approx(found.resisting_torque_lower.to_numpy(), rel=1e-12)


def test_draws_of_a_file(folder):
    path, curve = folder[0] / "rubber.toml", folder[1]
    for draw in (0, 9):
        expected = curve.draws(10)[draw].series_at(temperature=313.15)
        found = vr.rheology.load_material(path, temperature=313.15, form="prony", draw=draw)
        np.testing.assert_allclose(found.complex_modulus(3.0), expected.complex_modulus(3.0), rtol=1e-12)
    with pytest.raises(ValueError, match=r"draw must be in \[0, 9\], got 10"):
        vr.rheology.load_material(path, form="prony", draw=10)
    with pytest.raises(ValueError, match="form must be 'prony' if a draw is given, got 'table'"):
        vr.rheology.load_material(path, draw=0)
    with pytest.raises(ValueError, match="fit must be given with draws, which are Prony series"):
        vr.rheology.save_material(folder[0] / "other.toml", curve, draws=curve.draws(2))


def test_the_command_line_saves_draws_of_one_curve(folder):
    folder, _ = folder
    omega = np.geomspace(0.1, 100.0, 16)
    modulus = 1e6 * (1j * omega) ** 0.1
    rows = "".join(f"{w},{value.real},{value.imag}\n" for w, value in zip(omega, modulus, strict=True))
    (folder / "data.csv").write_text(f"frequency,storage modulus,loss modulus\nrad/s,Pa,Pa\n{rows}")
    ended = command("material", "data.csv", "--shear", "--draws", 3, "--save", "one.toml", cwd=folder)
    assert ended.returncode == 0, ended.stderr
    assert isinstance(vr.rheology.load_material(folder / "one.toml", form="prony", draw=2), vr.Prony)


@pytest.mark.parametrize(
    ("options", "message"),
    [
        (["--draws", 1, "--save", "one.toml"], "--draws must be 0 or at least 2, got 1"),
        (["--draws", 5], "--save must be given with --draws, because draws are saved with the material"),
    ],
)
def test_draws_that_would_not_be_saved_are_rejected(folder, options, message):
    ended = command("material", "data.csv", "--shear", *options, cwd=folder[0])
    assert ended.returncode == 2
    assert message in ended.stderr
    assert not ended.stdout


@pytest.mark.parametrize(
    ("changed", "message"),
    [
        ('of = ["cylinder.layers[0].thickness"]', 'contain draws, got "cylinder.layers[0].thickness"'),
        ("of = []", "draws.of must name materials with equal numbers of draws, got none"),
        (
            'of = ["cylinder.layers[0].shear_modulus"]\nmethod = "luck"',
            "draws.method must be 'linear' or 'solve'",
        ),
    ],
)
def test_bad_tables(folder, changed, message):
    folder, _ = folder
    (folder / "bad.toml").write_text(STUDY.replace('of = ["cylinder.layers[0].shear_modulus"]', changed))
    ended = command("sweep", "bad.toml", cwd=folder)
    assert ended.returncode == 2
    assert message in ended.stderr.replace("\n", " ")
