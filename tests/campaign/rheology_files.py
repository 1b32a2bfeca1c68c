"""Files of instruments in random dialects: `python -m tests.campaign.rheology_files`.

Each file contains random data in a random layout (TRIOS, RheoCompass, Proteus, or a plain table), language, unit,
separator, decimal mark, encoding and order of steps, as text, Excel workbook or JSON of TRIOS. The command reads it
back. It fails if a value is wrong, if a row or a column is lost silently, or if a file that lacks an item is read or
rejected without naming that item.
"""

from __future__ import annotations

import argparse
import json
import math
import random
import sys
import tempfile
from dataclasses import dataclass
from importlib.util import find_spec
from pathlib import Path

import numpy as np
import viscoroll as vr

if __package__ == "tests.campaign":
    from ..workbooks import write_xlsx
else:
    from workbooks import write_xlsx

#: Names of the quantities, by language.
NAMES = {
    "English": {
        "frequency": ("Angular frequency", "Ang. frequency", "Frequency", "angular_frequency"),
        "storage": ("Storage modulus", "Storage Modulus G'", "storage modulus", "Shear storage modulus"),
        "loss": ("Loss modulus", "loss modulus", "Shear loss modulus"),
        "temperature": ("Temperature", "Temp.", "Sample temperature", "Temp"),
        "tan_delta": ("Tan(delta)", "Loss factor", "tan d", "Damping factor"),
        "complex": ("Complex modulus", "|G*|"),
        "phase": ("Phase angle", "Delta"),
        "time": ("Time", "Step time"),
        "strain": ("Strain", "Oscillation strain"),
        "relaxation": ("Relaxation modulus", "G(t)"),
        "compliance": ("Creep compliance", "J(t)"),
    },
    "German": {
        "frequency": ("Kreisfrequenz", "Frequenz"),
        "storage": ("Speichermodul",),
        "loss": ("Verlustmodul",),
        "temperature": ("Temperatur",),
        "tan_delta": ("Verlustfaktor",),
        "complex": ("Komplexer Schubmodul",),
        "phase": ("Phasenwinkel",),
        "time": ("Zeit",),
        "strain": ("Dehnung",),
        "relaxation": ("Relaxationsmodul",),
        "compliance": ("Nachgiebigkeit",),
    },
    "French": {
        "frequency": ("Pulsation", "Fréquence", "Fréquence angulaire"),
        "storage": ("Module de conservation",),
        "loss": ("Module de perte",),
        "temperature": ("Température",),
        "tan_delta": ("Facteur de perte",),
        "complex": ("Module complexe",),
        "phase": ("Angle de phase", "Déphasage"),
        "time": ("Temps",),
        "strain": ("Déformation",),
        "relaxation": ("Module de relaxation",),
        "compliance": ("Complaisance",),
    },
    "Japanese": {
        "frequency": ("角周波数", "周波数"),
        "storage": ("貯蔵弾性率",),
        "loss": ("損失弾性率",),
        "temperature": ("温度",),
        "tan_delta": ("損失正接",),
        "complex": ("複素弾性率",),
        "phase": ("位相角",),
        "time": ("時間",),
        "strain": ("ひずみ",),
        "relaxation": ("緩和弾性率",),
        "compliance": ("クリープコンプライアンス",),
    },
    "symbols": {
        "frequency": ("ω", "f", "omega"),
        "storage": ("G'", "G\N{PRIME}", "G_stor", "G_prime"),
        "loss": ("G''", "G″", 'G"', "G_loss"),
        "temperature": ("T",),
        "tan_delta": ("tan δ", "tan(δ)"),
        "complex": ("|G*|", "G*"),
        "phase": ("δ", "delta"),
        "time": ("t", "time"),
        "strain": ("\N{GREEK SMALL LETTER GAMMA}", "gamma"),
        "relaxation": ("G(t)",),
        "compliance": ("J(t)",),
    },
}

#: Names of angular frequency: Hz contradicts them, and 1/s is rad/s.
_ANGULAR = {
    "Angular frequency", "Ang. frequency", "angular_frequency", "Kreisfrequenz", "Pulsation", "Fréquence angulaire",
    "角周波数", "ω", "omega",
}  # fmt: skip

#: Units with the factor that converts SI units to them, and the offset in kelvin that is subtracted first.
UNITS = {
    "angular": {"rad/s": 1.0, "1/s": 1.0, "s-1": 1.0, "s^-1": 1.0, "rad/sec": 1.0},
    "frequency": {"Hz": 0.5 / math.pi, "rad/s": 1.0, "mHz": 500.0 / math.pi, "kHz": 5e-4 / math.pi},
    "modulus": {"Pa": 1.0, "kPa": 1e-3, "MPa": 1e-6, "GPa": 1e-9, "N/mm2": 1e-6, "N/mm²": 1e-6},
    "temperature": {"°C": 1.0, "C": 1.0, "deg C": 1.0, "K": 1.0, "°F": 1.8},
    "angle": {"°": 180.0 / math.pi, "deg": 180.0 / math.pi, "rad": 1.0},
    "time": {"s": 1.0, "min": 1.0 / 60.0, "ms": 1e3, "h": 1.0 / 3600.0},
    "compliance": {"1/Pa": 1.0, "1/MPa": 1e6, "1/kPa": 1e3},
    "strain": {"%": 100.0, "1": 1.0},
    "ratio": {"": 1.0},
}
_OFFSETS = {"°C": 273.15, "C": 273.15, "deg C": 273.15, "°F": 273.15 - 160.0 / 9.0, "K": 0.0}
_QUANTITY = {
    "storage": "modulus", "loss": "modulus", "complex": "modulus", "relaxation": "modulus", "phase": "angle",
    "tan_delta": "ratio", "temperature": "temperature", "time": "time", "compliance": "compliance", "strain": "strain",
}  # fmt: skip

#: Relative error of values with seven printed digits.
TOLERANCE = 2e-6


@dataclass
class Step:
    """One table: its kind, roles of the columns in their order, and values in SI units, one row per point."""

    kind: str
    title: str
    roles: list[str]
    values: np.ndarray


@dataclass
class File:
    """One random file: its steps and its dialect, and the item that it lacks."""

    name: str
    steps: list[Step]
    names: dict[str, str]
    units: dict[str, str]
    separator: str
    decimal: str
    encoding: str
    place: str
    fault: str = ""


def draw(seed, with_excel=True):
    """Return a random file."""
    random_ = random.Random(seed)
    language = random_.choice(list(NAMES))
    form = random_.choice(["text"] * 6 + ["json"] + ["xlsx"] * (2 if with_excel else 0))
    names = {role: random_.choice(options) for role, options in NAMES[language].items()}
    units = {role: random_.choice(list(UNITS[kind])) for role, kind in _QUANTITY.items()}
    units["frequency"] = random_.choice(list(UNITS["angular" if names["frequency"] in _ANGULAR else "frequency"]))
    if names["time"] == "t" and units["time"] == "h":
        units["time"] = "s"
    separator = random_.choice(["\t", "\t", ";", ","])
    decimal = random_.choice([".", ","]) if separator != "," else "."
    if language == "Japanese":
        encoding = random_.choice(["utf-8", "cp932", "utf-16", "utf-8-sig"])
    elif language in ("German", "French"):
        encoding = random_.choice(["utf-8", "cp1252", "utf-16", "utf-8-sig"])
    else:
        encoding = random_.choice(["utf-8", "utf-16", "utf-16-le", "utf-8-sig"])
    if encoding == "cp932":
        units = {role: unit.replace("²", "2") for role, unit in units.items()}
    steps = _steps(random_)
    fault = random_.choice([""] * 8 + ["unit", "unknown unit"])
    place = random_.choice(["row", "row", "brackets", "parentheses", "slash"]) if form == "text" else "row"
    name = {"text": random_.choice(["data.txt", "data.csv"]), "json": "data.json", "xlsx": "data.xlsx"}[form]
    return File(name, steps, names, units, separator, decimal, encoding, place, fault)


def _steps(random_):
    """Return steps of one or several kinds in random order; one of them is a sweep or a test over time."""
    main = random_.choice(["sweep", "sweep", "sweep", "relaxation", "creep"])
    pair = random_.choice([("storage", "loss"), ("storage", "tan_delta"), ("complex", "phase")])
    steps = [_step(random_, main, 20.0 * number - 20.0, pair) for number in range(random_.randint(1, 4))]
    for kind in random_.sample(["amplitude", "creep", "relaxation"], random_.randint(0, 2)):
        if kind == main or (main != "sweep" and kind != "amplitude"):
            continue
        steps.insert(random_.randint(0, len(steps)), _step(random_, kind, 20.0, pair))
    return steps


def _step(random_, kind, celsius, pair):
    count = random_.randint(3, 12)
    kelvin = np.full(count, celsius + 273.15) + np.round([random_.uniform(-0.2, 0.2) for _ in range(count)], 2)
    level = 10.0 ** random_.uniform(4.0, 9.0)
    ramp = np.sort([random_.uniform(0.0, 1.0) for _ in range(count)]) + np.linspace(0.0, 1.0, count)
    columns = {"temperature": kelvin}
    if kind in ("sweep", "amplitude"):
        storage, loss = level * (1.0 + ramp), level * (0.05 + 0.2 * ramp)
        every = {
            "storage": storage, "loss": loss, "tan_delta": loss / storage, "complex": np.hypot(storage, loss),
            "phase": np.arctan2(loss, storage),
        }  # fmt: skip
        columns |= {role: every[role] for role in pair}
        grows = np.geomspace(0.1, 10.0 ** random_.uniform(1.0, 3.0), count)
        columns["frequency"] = grows if kind == "sweep" else np.full(count, 10.0)
        if kind == "amplitude":
            columns["strain"] = np.geomspace(1e-4, 1e-1, count)
    else:
        columns["time"] = np.geomspace(1.0, 10.0 ** random_.uniform(1.0, 4.0), count)
        columns["relaxation" if kind == "relaxation" else "compliance"] = (
            level * (2.0 - 0.5 * ramp) if kind == "relaxation" else (1.0 + ramp) / level
        )
    roles = list(columns)
    random_.shuffle(roles)
    return Step(kind, f"{kind} {celsius:g}", roles, np.column_stack([columns[role] for role in roles]))


def printed(file, step):
    """Return the values of a step in the units of the file, with seven digits."""
    columns = []
    for role, values in zip(step.roles, step.values.T, strict=True):
        unit = file.units[role]
        kind = _QUANTITY.get(role, "angular" if file.names["frequency"] in _ANGULAR else "frequency")
        columns.append((values - _OFFSETS.get(unit, 0.0) if role == "temperature" else values) * UNITS[kind][unit])
    return np.array([[float(f"{value:.7g}") for value in row] for row in np.column_stack(columns)])


def faulty_role(file):
    """Return the role whose unit is missing or unknown: a modulus or compliance of the steps that are read."""
    roles = {role for step in read_steps(file) for role in step.roles}
    return next(role for role in ("relaxation", "compliance", "storage", "complex") if role in roles)


def read_steps(file):
    """Return the steps that the reader of the file reads."""
    kinds = [step.kind for step in file.steps]
    if "sweep" in kinds:
        return [step for step in file.steps if step.kind == "sweep"]
    return [step for step in file.steps if step.kind in ("relaxation", "creep")]


def write(file, folder):
    """Write the file and return its path."""
    path = Path(folder) / file.name
    units = dict(file.units)
    if file.fault:
        units[faulty_role(file)] = {"unit": "", "unknown unit": "foo"}[file.fault]
    if path.suffix == ".json":
        path.write_text(json.dumps(_json(file, units)), encoding="utf-8")
    elif path.suffix == ".xlsx":
        sheets = {}
        for number, step in enumerate(file.steps):
            head = [[file.names[role] for role in step.roles], [units[role] for role in step.roles]]
            rows = [[float(value) for value in row] for row in printed(file, step)]
            sheets[f"{number} {step.title}"] = [["File", "made"], [], *head, *rows]
        write_xlsx(path, sheets)
    else:
        path.write_bytes("\r\n".join(_lines(file, units)).encode(file.encoding))
    return path


def _lines(file, units):
    join = file.separator.join
    forms = {"brackets": "{} [{}]", "parentheses": "{} ({})", "slash": "{}/{}", "row": "{}"}
    lines = [join(["Filename", "made for a test"]), ""]
    for step in file.steps:
        lines += ["[step]", step.title]
        beside = file.place
        heads = [forms[beside if units[role] else "row"].format(file.names[role], units[role]) for role in step.roles]
        lines.append(join(_quoted(head, file.separator) for head in heads))
        if beside == "row":
            lines.append(join(units[role] for role in step.roles))
        for row in printed(file, step):
            lines.append(join(f"{value:.7g}".replace(".", file.decimal) for value in row))
        lines.append("")
    return lines


def _quoted(cell, separator):
    return '"' + cell.replace('"', '""') + '"' if separator == "," and '"' in cell else cell


def _json(file, units):
    roles = sorted({role for step in file.steps for role in step.roles})
    steps = [{"Name": step.title, "Id": f"id-{number}"} for number, step in enumerate(file.steps)]
    headers = {
        role: {"DisplayName": file.names[role], "ValueType": "Number", "Unit": {"Name": units[role]}} for role in roles
    }
    rows = [
        dict(zip(step.roles, map(float, row), strict=True)) | {"Step": identity["Id"]}
        for step, identity in zip(file.steps, steps, strict=True)
        for row in printed(file, step)
    ]
    return {"Results": {"Processed": {"ColumnHeaders": headers, "Rows": rows, "ResultsSteps": steps}}}


def check(file, folder):
    """Write and read a file; return what is wrong, or an empty text."""
    path = write(file, folder)
    wanted = read_steps(file)
    is_sweep = wanted[0].kind == "sweep"
    reader = vr.rheology.read_rheology if is_sweep else vr.rheology.read_time_tests
    try:
        data = reader(path, tensile=False)
    except ValueError as error:
        name = file.names[faulty_role(file)]
        if file.fault and repr(name)[1:-1] in str(error) and "unit" in str(error):
            return ""
        return f"rejected: {error}"
    if file.fault:
        return f"read although the unit of {file.names[faulty_role(file)]} is {file.fault}"
    if data.dropped:
        return f"{data.dropped} points dropped"
    others = [step for step in file.steps if step not in wanted]
    if others and not all(f"{len(step.values)} points" in repr(data) for step in others):
        return f"steps that were not read are not listed in {data!r}"
    found = data.isotherms if is_sweep else data.tests
    expected = sorted(wanted, key=lambda step: step.values[:, step.roles.index("temperature")].mean())
    if len(found) != len(expected):
        return f"{len(found)} tests in place of {len(expected)}"
    for one, step in zip(found, expected, strict=True):
        columns = dict(zip(step.roles, step.values.T, strict=True))
        pairs = {"temperature": (np.array([one.temperature]), columns["temperature"].mean(keepdims=True))}
        if is_sweep:
            storage, loss = _moduli(columns)
            pairs |= {"frequency": (one.frequency, columns["frequency"])}
            pairs |= {"storage": (one.storage, storage), "loss": (one.loss, loss)}
        else:
            modulus = columns["relaxation"] if "relaxation" in columns else 1.0 / columns["compliance"]
            pairs |= {"time": (one.time, columns["time"]), "modulus": (one.modulus, modulus)}
        for name, (value, true) in pairs.items():
            if value.shape != true.shape:
                return f"{name}: {value.size} points in place of {true.size}"
            if not np.allclose(value, true, rtol=TOLERANCE, atol=0.0):
                return f"{name} of {step.title}: {value} in place of {true}"
    return ""


def _moduli(columns):
    if "complex" in columns:
        return columns["complex"] * np.cos(columns["phase"]), columns["complex"] * np.sin(columns["phase"])
    return columns["storage"], columns.get("loss", columns["storage"] * columns.get("tan_delta", 0.0))


def main():
    """Run the tests."""
    parser = argparse.ArgumentParser(prog="python -m tests.campaign.rheology_files", description=__doc__)
    parser.add_argument("--count", type=int, default=1000, help="number of files")
    parser.add_argument("--first", type=int, default=0, help="seed of the first file")
    arguments = parser.parse_args()
    with_excel = find_spec("python_calamine") is not None
    failed, faults = 0, 0
    with tempfile.TemporaryDirectory() as folder:
        for seed in range(arguments.first, arguments.first + arguments.count):
            file = draw(seed, with_excel)
            faults += bool(file.fault)
            if wrong := check(file, folder):
                failed += 1
                print(f"{seed}: {wrong}")
                print(f"    {file.name} {file.encoding} {file.separator!r} {file.decimal} {file.place} {file.fault}")
    print(
        f"{arguments.count} files, {faults} of them faulty, {'with' if with_excel else 'without'} workbooks: "
        f"{failed} failed"
    )
    return int(failed > 0)


if __name__ == "__main__":
    sys.exit(main())
