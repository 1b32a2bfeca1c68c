"""Commands and TOML files on the pages run as printed, in order, each page in its own folder.

A command is a line of a block `console` or `sh`, an indented line, or inline code that names a file. The first line of
a TOML block names its file; a block without a body is the lower part of the example case, as its comment says. The
reader's own files, measurements and a case file of the example, are provided, and the deck that a page shows.
"""

from __future__ import annotations

import re
import shlex
from pathlib import Path

import numpy as np
import pytest
import viscoroll as vr
from shared_cases import command, few_pictures
from viscoroll.case import example_text
from viscoroll.cli import app

ROOT = Path(__file__).parents[3]
PAGES = [ROOT / "README.md", *sorted((ROOT / "docs").rglob("*.md"))]

_BLOCKS = re.compile(
    r"^```(?P<language>toml|console|sh)\n(?P<block>.*?)^```|"
    r"^ {4}(?P<line>viscoroll [^\n]*)$|"
    r"`(?P<inline>viscoroll \w+[^`]* [^`]*\w\.\w[^`]*)`",
    re.DOTALL | re.MULTILINE,
)

#: Tables of rolling bodies and of rough surfaces; a block with one of them is a whole file.
_BODIES = ("[ball]", "[cylinder]", "[wheel]", "[surface]")

#: Commands that take minutes on a page, and replacements that take seconds.
_SHORT = {"viscoroll reproduce": "viscoroll reproduce table2 --coarse"}

#: The example case, solved more quickly than the reader's.
COARSE_EXAMPLE = example_text().replace("accuracy = 0.01", "accuracy = 0.1")
assert "accuracy = 0.1 " in COARSE_EXAMPLE

#: Pages whose commands take more than ten seconds.
_SLOW = {"caster", "dma", "shell"}

#: Command that ends only on Ctrl-C, tested in `app/test_server.py`.
_SERVER = "app"


def steps(page: Path) -> list[tuple[str, str]]:
    """Return the shell steps of a page in order: ("toml", text) and ("run", command)."""
    found = []
    for match in _BLOCKS.finditer(page.read_text(encoding="utf-8")):
        if match["language"] == "toml":
            found.append(("toml", match["block"]))
        elif match["language"]:
            lines = match["block"].replace("\\\n", " ").splitlines()
            found += [("run", line.removeprefix("$ ")) for line in lines if "viscoroll " in line.partition("#")[0]]
        else:
            found.append(("run", " ".join((match["line"] or match["inline"]).split())))
    return found


COMMAND_PAGES = [page for page in PAGES if steps(page)]


def write_files_of_readers(folder: Path) -> None:
    """Write the files that readers provide: measurements in one file of each kind, and a case."""
    source = vr.rheology.example_data("pressure_sensitive_adhesive.txt")
    (folder / "dma.txt").write_bytes(source.read_bytes())
    rows = [
        f"{sweep.temperature},{w},{storage},{loss}"
        for sweep in vr.rheology.read_rheology(source, tensile=False).between(238.15, 433.15).isotherms
        for w, storage, loss in zip(sweep.frequency, sweep.storage, sweep.loss, strict=True)
    ]
    (folder / "dma.csv").write_text("T,w,G',G''\nK,rad/s,Pa,Pa\n" + "\n".join(rows), encoding="utf-8")
    (folder / "case.toml").write_text(COARSE_EXAMPLE, encoding="utf-8")
    for sweep in vr.rheology.read_rheology(source, tensile=False).between(273.15, 313.15).isotherms:
        lines = ["w,G',G''", "rad/s,Pa,Pa"]
        lines += [f"{w},{a},{b}" for w, a, b in zip(sweep.frequency, sweep.storage, sweep.loss, strict=True)]
        name = f"dma_{sweep.temperature - 273.15:.0f}C.csv"
        (folder / name).write_text("\n".join(lines), encoding="utf-8")
    write_time_tests(folder)
    scan = vr.RoughSurface.self_affine(64, 1e-3, hurst=0.8, rolloff=5e-4, cutoff=125e-6, rms_slope=0.1, seed=7)
    np.save(folder / "asphalt.npy", scan.heights)


def write_time_tests(folder: Path) -> None:
    """Write relaxation tests at 20 and 60 °C and a frequency sweep at 20 °C of a material, 10 times faster at 60 °C."""
    tau = np.logspace(-3.0, 3.0, 13)
    for name, times in (("relaxation20.csv", tau), ("relaxation60.csv", 0.1 * tau)):
        t = np.logspace(-1.0, 3.0, 40)
        modulus = 1e5 + 2e4 * np.exp(-t[:, None] / times).sum(axis=1)
        rows = [f"{time},{value}" for time, value in zip(t, modulus, strict=True)]
        (folder / name).write_text("time,G(t)\ns,Pa\n" + "\n".join(rows), encoding="utf-8")
    omega = np.logspace(-1.0, 2.0, 30)
    terms = 1j * omega[:, None] * tau
    moduli = 1e5 + 2e4 * (terms / (1.0 + terms)).sum(axis=1)
    rows = [f"{w}\t20\t{g.real}\t{g.imag}" for w, g in zip(omega, moduli, strict=True)]
    (folder / "sweeps.txt").write_text("w\tT\tG'\tG''\nrad/s\t°C\tPa\tPa\n" + "\n".join(rows), encoding="utf-8")


def write_deck_of(page: Path, folder: Path) -> None:
    """Write the deck of a finite-element program, if a cell of the page has one."""
    if deck := re.search(r'^deck = """\\\n(.*?)"""', page.read_text(encoding="utf-8"), re.DOTALL | re.MULTILINE):
        (folder / "tread.inp").write_text(deck[1], encoding="utf-8")


def write_file(block: str, folder: Path) -> None:
    name = re.match(r"# (\S+\.toml)\b", block)
    assert name, f"a TOML block must begin with the name of its file, as # case.toml, got {block.splitlines()[0]!r}"
    whole = any(table in block for table in _BODIES)
    (folder / name[1]).write_text(block if whole else f"{COARSE_EXAMPLE}\n{block}", encoding="utf-8")


def run_line(line: str, folder: Path) -> None:
    """Run a command and redirect its output if the page does so; files that it should write must exist."""
    words, arrow, target = line.partition(">")
    program, *arguments = shlex.split(_SHORT.get(words.partition("#")[0].strip(), words), comments=True)
    assert program == "viscoroll"
    if arguments[0] == _SERVER:
        return
    done = command(*arguments, cwd=folder)
    assert done.returncode == 0, f"{line}: {done.stderr}"
    if arrow:
        (folder / target.partition("#")[0].strip()).write_text(done.stdout, encoding="utf-8")
    for option, name in re.findall(r"--(plot|save|section|output)[ =](\S+)", words):
        assert (folder / name).exists(), f"{line}: no file of --{option}"


def test_pages_have_commands_of_all_kinds():
    assert {"README.md", "shell.md", "dma.md", "studies.md", "transient.md"} <= {p.name for p in COMMAND_PAGES}
    listed = [line for kind, line in steps(ROOT / "docs" / "shell.md") if kind == "run"]
    commands = {one.name or one.callback.__name__ for one in app.registered_commands}
    assert {line.split()[1] for line in listed} == commands - {"demo"} | {"--cite"}


@pytest.mark.parametrize(
    "page",
    [
        pytest.param(page, marks=[pytest.mark.slow] if page.stem in _SLOW else [], id=page.stem)
        for page in COMMAND_PAGES
    ],
)
def test_commands_and_files_of_a_page(page, tmp_path):
    write_files_of_readers(tmp_path)
    write_deck_of(page, tmp_path)
    with few_pictures():
        for kind, text in steps(page):
            (write_file if kind == "toml" else run_line)(text, tmp_path)
