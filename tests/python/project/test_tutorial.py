"""docs/from-dma-to-dem.md runs as printed: its Python, its case file and its commands."""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
import viscoroll as vr

PAGE = (Path(__file__).parents[3] / "docs" / "from-dma-to-dem.md").read_text(encoding="utf-8")


def blocks(language):
    """Return the blocks of a language, without the cell that tells a notebook how to draw."""
    found = re.findall(rf"```{re.escape(language)}\n(.*?)```", PAGE, re.DOTALL)
    return [block for block in found if not block.startswith(":tags: [remove-cell]")]


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """Folder in which the Python of the page has run."""
    path = tmp_path_factory.mktemp("tutorial")
    (path / "page.py").write_text("\n".join(blocks("{code-cell}")), encoding="utf-8")
    done = subprocess.run(
        [sys.executable, "-W", "error", "page.py"], cwd=path, capture_output=True, text=True, timeout=300
    )
    assert done.returncode == 0, done.stderr
    (path / "printed.txt").write_text(done.stdout, encoding="utf-8")
    return path


def shell(command, folder):
    """Run a command of the page in its folder."""
    words = [*command.split()]
    assert words[0] == "viscoroll"
    return subprocess.run([sys.executable, "-m", *words], cwd=folder, capture_output=True, text=True, timeout=300)


def test_python(folder):
    printed = (folder / "printed.txt").read_text(encoding="utf-8")
    assert "339 points in 20 sweeps" in printed
    assert "undetermined              -40 to -29.99 °C" in printed
    assert "rolling sds" in printed
    assert (folder / "floor.lammps").read_text(encoding="utf-8").count("\n") == 7
    assert len((folder / "floor.csv").read_text(encoding="utf-8").splitlines()) == 17
    assert vr.RollingResistance.load_file(folder / "torque.json").radius == pytest.approx(0.022)


@pytest.mark.slow
def test_commands(folder):
    shutil.copy(vr.example_data("pressure_sensitive_adhesive.txt"), folder / "dma.txt")
    (case,) = blocks("toml")
    (folder / "case.toml").write_text(case, encoding="utf-8")
    commands = re.findall(r"^    (viscoroll .*)$|`(viscoroll design [^`]*)`", PAGE, re.MULTILINE)
    commands = [indented or inline for indented, inline in commands]
    assert [command.split()[1] for command in commands] == ["material", "export", "design"]
    for command in commands:
        # The design table of the file is for its own command.
        text = case if "design" in command else case.split("[design]")[0]
        (folder / "case.toml").write_text(text, encoding="utf-8")
        done = shell(command, folder)
        assert done.returncode == 0, done.stderr
    assert (folder / "fit.png").exists()
    assert (folder / "design.png").exists()
    assert "rolling sds" in (folder / "case.lammps").read_text(encoding="utf-8")


def test_table_of_codes_is_whole():
    from viscoroll.export import CODES

    rows = re.findall(r"^\| (?:`(\w+)`)? ?\| ((?:`\w+`(?:, )?)+) \|", PAGE, re.MULTILINE)
    listed, code = set(), ""
    for name, styles in rows:
        code = name or code
        listed |= {(code, style) for style in re.findall(r"`(\w+)`", styles)}
    assert listed == {(code, style) for code, styles in CODES.items() for style in styles}
