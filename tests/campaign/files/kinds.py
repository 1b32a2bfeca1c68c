"""Kinds of files that the program reads, each with the check of one mutated file."""

from __future__ import annotations

import csv
import io
import json
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from random import Random
from typing import Any, TypeAlias

import numpy as np
import viscoroll as vr
from viscoroll.case import load_case
from viscoroll.case.design import design_case
from viscoroll.case.measured import compare_measured, read_measurements
from viscoroll.case.motion import load_motion
from viscoroll.case.study import load_study
from viscoroll.rheology import ShiftFactors

from . import caches, contents, results, states
from .judging import command_failure, infinite, reading_failure
from .mutations import mutated

__all__ = ["KINDS", "Check", "TextFiles"]

#: Check of one mutated file, called as check(seed, folder): returns None, or the failure in one line.
Check: TypeAlias = Callable[[int, Path], "str | None"]

#: Share of files that a command of the shell reads as well [-].
_BY_COMMAND = 0.2

#: Share of files that are missing, or replaced by a folder [-].
_NO_FILE = 0.01


@dataclass(frozen=True, kw_only=True)
class TextFiles:
    """One kind of text files.

    Attributes
    ----------
    name : str
        Name of the mutated file.
    originals : tuple of bytes
        Contents of valid files.
    read : callable
        Called as read(path, random); may start a computation, which ends the check.
    judge : callable
        Returns what is wrong with the content, or None.
    commands : tuple
        Words of the shell commands that read the file.
    beside : mapping of str to bytes
        Other files in its folder.
    """

    name: str
    originals: tuple[bytes, ...]
    read: Callable[[Path, Random], Any]
    judge: Callable[[Any], str | None] = lambda _: None
    commands: tuple[tuple[str, ...], ...] = ()
    beside: Mapping[str, bytes] = field(default_factory=dict)

    def check(self, seed: int, folder: Path) -> str | None:
        """Write one mutated file into a folder, and return what is wrong with the way it is read, or None."""
        random = Random(seed)
        path = folder / self.name
        for name, content in self.beside.items():
            (folder / name).write_bytes(content)
        if random.random() > _NO_FILE:
            path.write_bytes(mutated(random.choice(self.originals), random))
        elif random.random() < 0.5:
            path.mkdir()
        if failure := reading_failure(lambda where: self.read(where, random), path, self.judge):
            return failure
        if self.commands and random.random() < _BY_COMMAND:
            words = random.choice(self.commands)
            return command_failure(tuple(folder / word if "." in word else word for word in words), folder)
        return None


def _material(path: Path, random: Random) -> vr.materials.ShearModulus:
    options = random.choice(
        (
            {},
            {"temperature": 303.15},
            {"temperature": 303.15, "form": "prony"},
            {"form": "prony", "draw": 1},
            {"form": "prony", "draw": 1, "temperature": 308.15},
            {"temperature": random.choice((20.0, 293.15, 1e300, float("nan"), -400.0))},
        )
    )
    return vr.rheology.load_material(path, **options)


def _surface(path: Path, random: Random) -> str | None:
    """Read a surface, and return which number differs from the one in the file."""
    surface = vr.studies.RollingResistance.load_file(path)
    told = json.loads(path.read_text(encoding="utf-8"))
    for name in ("load", "angular_speed", "radius", "coefficients", "error", "largest_error"):
        if not np.array_equal(np.asarray(told[name], dtype=object), np.asarray(getattr(surface, name))):
            return f"read as {getattr(surface, name)}, written as {told[name]}: {name}"
    return infinite(surface)


def _differing(path: Path, found: Mapping[str, Any]) -> str | None:
    """Return the columns of a CSV file whose numbers differ from those of a minimal reader, or None."""
    text = io.StringIO(path.read_bytes().decode("utf-8-sig"), newline="")
    header, *rows = (row for row in csv.reader(text, skipinitialspace=True) if any(map(str.strip, row)))
    if any(len(row) != len(header) for row in rows) or len({name.strip() for name in header}) < len(header):
        return "accepted although rows differ in length or columns have equal names"
    places = {name.strip(): index for index, name in enumerate(header) if name.strip() in found}
    told = {name: [float(row[index]) for row in rows] for name, index in places.items()}
    other = [name for name in told if not np.array_equal(np.asarray(found[name]), told[name])]
    return f"numbers differ from the file: {', '.join(other)}" if other else None


def _measurements(path: Path, random: Random) -> str | None:
    """Read measurements, and return which column differs from the one in the file."""
    found = read_measurements(path)
    if random.random() < 0.1:
        compare_measured(load_case(path.parent / "case.toml"), found)
    read = {found.varied: found.places, found.quantity: found.values, "error": found.errors}
    return _differing(path, read) or infinite(found)


def _motion_table(path: Path, random: Random) -> str | None:
    """Read a motion, and return which column differs from the one in its table."""
    found = load_motion(path.parent / "motion.toml")
    return _differing(
        path, {name: getattr(found, name) for name in ("time", "angle", "distance", "load", "center_displacement")}
    )


#: Radii of curvature that are infinite for flat surfaces.
_FLAT = ("crown_radius", "path_radius")


def _layers(case: Any) -> str | None:
    return infinite(case.body, without=_FLAT) or infinite(case.on, without=_FLAT)


_CASE = contents.CASES[0]
_NAMES_CURVE = contents.CASES[2]
_NAMES_SWEEP = contents.CASES[3]
_NAMES_MATERIAL = contents.CASES[5]

_TEXTS = {
    "case": TextFiles(
        name="case.toml",
        originals=contents.CASES,
        read=lambda path, _: load_case(path),
        judge=_layers,
        commands=(("solve", "case.toml"), ("export", "case.toml", "--for", "lammps"), ("compare", "case.toml")),
        beside=contents.BESIDE_CASES,
    ),
    "motion": TextFiles(
        name="motion.toml",
        originals=contents.MOTIONS,
        read=lambda path, _: load_motion(path),
        judge=_layers,
        commands=(("roll", "motion.toml"),),
        beside={"motion.csv": contents.MOTION_TABLES[0]},
    ),
    "motion table": TextFiles(
        name="motion.csv",
        originals=contents.MOTION_TABLES,
        read=_motion_table,
        judge=lambda failure: failure,
        commands=(("roll", "motion.toml"),),
        beside={"motion.toml": contents.MOTIONS[2].replace(b"mass = 0.1\n", b"mass = 0.1\nload = 50.0\n")},
    ),
    "study": TextFiles(
        name="study.toml",
        originals=contents.STUDIES,
        read=lambda path, _: load_study(path),
        commands=(("sweep", "study.toml"), ("export", "study.toml", "--for", "yade")),
        beside=contents.BESIDE_CASES,
    ),
    "design": TextFiles(
        name="design.toml",
        originals=contents.DESIGNS,
        read=lambda path, _: design_case(path),
        commands=(("design", "design.toml"),),
    ),
    "material": TextFiles(name="rubber.toml", originals=contents.MATERIALS, read=_material, judge=infinite),
    "material of a case": TextFiles(
        name="rubber.toml",
        originals=contents.MATERIALS,
        read=lambda path, _: load_case(path.parent / "case.toml"),
        judge=_layers,
        commands=(("solve", "case.toml"), ("sweep", "study.toml")),
        beside={"case.toml": _NAMES_MATERIAL, "study.toml": contents.STUDIES[1]},
    ),
    "master curve": TextFiles(
        name="curve.csv",
        originals=contents.CURVES,
        read=lambda path, _: load_case(path.parent / "case.toml"),
        judge=_layers,
        beside={"case.toml": _NAMES_CURVE},
    ),
    "strain sweep of a case": TextFiles(
        name="sweep.csv",
        originals=(contents.BESIDE_CASES["sweep.csv"],),
        read=lambda path, _: load_case(path.parent / "case.toml"),
        judge=_layers,
        beside={"case.toml": _NAMES_SWEEP},
    ),
    "rheology": TextFiles(
        name="sweep.txt",
        originals=contents.RHEOLOGY,
        read=lambda path, random: vr.rheology.read_rheology(path, tensile=random.choice((None, True))),
        judge=lambda data: infinite(data, without=("temperature",)),
        commands=(("material", "sweep.txt", "--tensile", "--reference", "293"),),
    ),
    "strain sweep": TextFiles(
        name="sweep.txt",
        originals=contents.STRAIN_SWEEPS,
        read=lambda path, _: vr.rheology.read_strain_sweep(path, kind="shear", tensile=False),
        judge=infinite,
    ),
    "shift factors": TextFiles(
        name="factors.csv",
        originals=contents.FACTORS,
        read=lambda path, _: ShiftFactors.read(path),
        judge=infinite,
        commands=(("material", "sweep.txt", "--tensile", "--factors", "factors.csv", "--reference", "293"),),
        beside={"sweep.txt": contents.RHEOLOGY[3]},
    ),
    "measurements": TextFiles(
        name="measured.csv",
        originals=contents.MEASURED,
        read=_measurements,
        judge=lambda failure: failure,
        commands=(("compare", "case.toml", "--measured", "measured.csv"),),
        beside={"case.toml": _CASE},
    ),
    "resistance surface": TextFiles(
        name="surface.json", originals=contents.SURFACES, read=_surface, judge=lambda failure: failure
    ),
}

#: Checks by kind of file.
KINDS: dict[str, Check] = {name: files.check for name, files in _TEXTS.items()} | {
    "state": states.check,
    "study result": results.check,
    "study cache": caches.check,
}
