"""Random case files with a mistake in a unit: each one must be rejected, or solved with a warning or a statement.

`python -m tests.campaign.unit_mistakes` writes one line for each kind of mistake, and files solved silently.
"""

from __future__ import annotations

import argparse
import copy
import math
import sys
import warnings
from collections import Counter
from typing import Any

import numpy as np
from viscoroll import ConvergenceError, ResultWarning
from viscoroll.case import build_case
from viscoroll.case.plausible import speed_text, speed_warning
from viscoroll.solution.text import result_warnings

Document = dict[str, Any]

#: Kinds of mistakes.
MISTAKES = ("all lengths in mm", "one length in mm", "rpm for rad/s", "°C for K", "hardness for modulus", "MPa for Pa")


def random_file(rng: np.random.Generator) -> Document:
    """Return a correct file of a ball, roller or wheel of rubber, from the size of casters to conveyor rollers."""
    name = rng.choice(["ball", "cylinder", "wheel"])
    radius = 10.0 ** rng.uniform(-2.0, -0.4)  # 10 mm to 0.4 m
    thickness = max(0.4e-3, radius * 10.0 ** rng.uniform(-1.5, -0.5))
    layer = {
        "thickness": round(thickness, 6),
        "poisson_ratio": 0.45,
        "shear_modulus": {
            "type": "standard_linear_solid",
            "instantaneous_modulus": round(10.0 ** rng.uniform(6.0, 7.0)),
            "relaxed_modulus": round(10.0 ** rng.uniform(5.3, 5.9)),
            "relaxation_time": 0.01,
        },
        "conductivity": 0.2,
    }
    body: Document = {"core_radius": round(radius, 5), "layers": [layer]}
    document: Document = {name: body}
    if name == "wheel":
        body["width"] = round(radius * rng.uniform(0.4, 1.5), 5)
        body["sides"] = "unbounded"
    if name == "ball" and rng.random() < 0.3:
        document["groove"] = {"radius": round(2.0 * (radius + thickness), 5)}
    speed = rng.uniform(0.2, 6.0) / (radius + thickness)  # walking to conveyor speed
    document["rolling"] = {
        "penetration": round(thickness * rng.uniform(0.02, 0.08), 8),
        "angular_speed": round(speed, 3),
    }
    document["numerics"] = {"accuracy": 0.3}
    document["thermal"] = {"convection": 10.0, "ambient": 293.15, "core": "isothermal", "core_temperature": 300.0}
    return document


def mistaken(document: Document, kind: str, rng: np.random.Generator) -> Document:
    """Return the file with a mistake of a kind."""
    document = copy.deepcopy(document)
    body = next(document[name] for name in ("ball", "cylinder", "wheel") if name in document)
    layer, rolling = body["layers"][0], document["rolling"]
    lengths = [(body, "core_radius"), (layer, "thickness"), (rolling, "penetration")]
    lengths += [
        (table, key) for table, key in ((body, "width"), (document.get("groove", {}), "radius")) if key in table
    ]
    if kind == "all lengths in mm":
        for table, key in lengths:
            table[key] *= 1e3
    elif kind == "one length in mm":
        table, key = lengths[rng.integers(len(lengths))]
        table[key] *= 1e3
    elif kind == "rpm for rad/s":
        rolling["angular_speed"] *= 30.0 / math.pi
    elif kind == "°C for K":
        document["thermal"][rng.choice(["ambient", "core_temperature"])] -= 273.15
    elif kind == "hardness for modulus":
        layer["shear_modulus"] = float(rng.integers(40, 90))
    else:
        layer["shear_modulus"]["instantaneous_modulus"] *= 1e-6
        layer["shear_modulus"]["relaxed_modulus"] *= 1e-6
    return document


def outcome(document: Document) -> str:
    """Return how the command line treats a file: "rejected", "warned", "stated" (its speed) or "silent"."""
    try:
        case = build_case(document, None)
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always", ResultWarning)
            result = case.solve()
            case.thermal.temperature(result)  # type: ignore[union-attr]
    except (ValueError, ConvergenceError, MemoryError):
        return "rejected"
    if result_warnings(result) or caught or speed_warning(result.angular_speed, result.body.outer_radius):
        return "warned"
    return "stated" if speed_text(result.angular_speed, result.body.outer_radius) else "silent"


def main() -> int:
    """Run the campaign; return 1 if a file was solved silently."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--count", type=int, default=200, help="number of files with a mistake")
    parser.add_argument("--seed", type=int, default=1)
    arguments = parser.parse_args()
    rng = np.random.default_rng(arguments.seed)
    found: dict[str, Counter[str]] = {kind: Counter() for kind in MISTAKES}
    silent = 0
    for number in range(arguments.count):
        kind = MISTAKES[number % len(MISTAKES)]
        document = mistaken(random_file(rng), kind, rng)
        how = outcome(document)
        found[kind][how] += 1
        # The printed speed shows only a mistake in the speed.
        if how == "silent" or (how == "stated" and kind != "rpm for rad/s"):
            silent += 1
            print(f"solved silently, {kind}: {document}")
    for kind, counts in found.items():
        print(f"{kind}: " + ", ".join(f"{count} {how}" for how, count in sorted(counts.items())))
    print(f"{silent} of {arguments.count} files were solved silently")
    return int(silent > 0)


if __name__ == "__main__":
    sys.exit(main())
