"""The distributions declare their contents: licenses of all parts, and one version everywhere."""

from __future__ import annotations

import re
import runpy
import tomllib
from pathlib import Path

import pytest
import viscoroll as vr

ROOT = Path(__file__).parents[3]


def metadata(build_state: str) -> dict[str, object]:
    provider = runpy.run_path(str(ROOT / "python" / "packaging" / "wheel_license.py"))["Provider"]()
    provider.build_state(build_state)
    fields = provider.dynamic_metadata({}, {})
    assert all(list(ROOT.glob(pattern)) for pattern in fields["license-files"])
    return fields


def test_a_wheel_with_fftw_declares_and_includes_the_gpl(monkeypatch):
    monkeypatch.delenv("VISCOROLL_FFT", raising=False)
    fields = metadata("wheel")
    assert fields["license"] == "BSD-3-Clause AND GPL-2.0-or-later AND MIT AND MPL-2.0"
    assert "licenses/FFTW.txt" in fields["license-files"]
    assert "GNU GENERAL PUBLIC LICENSE" in (ROOT / "licenses" / "FFTW.txt").read_text()


def test_a_wheel_with_pocketfft_has_no_gpl(monkeypatch):
    monkeypatch.setenv("VISCOROLL_FFT", "PocketFFT")
    fields = metadata("metadata_wheel")
    assert fields["license"] == "BSD-3-Clause AND MIT AND MPL-2.0"
    assert "licenses/PocketFFT.txt" in fields["license-files"]
    assert "licenses/FFTW.txt" not in fields["license-files"]


def test_sources_are_under_the_mit_license(monkeypatch):
    monkeypatch.delenv("VISCOROLL_FFT", raising=False)
    assert metadata("sdist")["license"] == "MIT"


def test_an_unknown_transform_is_rejected(monkeypatch):
    monkeypatch.setenv("VISCOROLL_FFT", "MKL")
    with pytest.raises(ValueError, match="VISCOROLL_FFT must be one of FFTW, PocketFFT, got MKL"):
        metadata("wheel")


def test_all_files_have_the_version_of_the_library():
    for file, pattern in [
        ("CMakeLists.txt", r"VERSION (\d+\.\d+\.\d+)$"),
        ("CITATION.cff", r"^version: (\S+)"),
        ("conda/recipe.yaml", r"^  version: (\d\S+)"),
    ]:
        found = re.search(pattern, (ROOT / file).read_text(), re.MULTILINE)
        assert found is not None, file
        assert found[1] == vr.__version__, file


def test_the_conda_recipe_has_the_version_bounds_of_pyproject():
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    extras = project["optional-dependencies"]
    lines = [f"python{project['requires-python']}", *project["dependencies"], *extras["cli"], *extras["plot"]]
    declared = {line.replace("matplotlib", "matplotlib-base").replace(">=", " >=") for line in lines}
    recipe = (ROOT / "conda" / "recipe.yaml").read_text()
    run = recipe[recipe.index("  run:") : recipe.index("tests:")]
    assert set(re.findall(r"^    - (\S+ >=\S+)$", run, re.MULTILINE)) == declared
