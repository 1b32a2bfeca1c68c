"""States of random steady cases, stored by one version of the library and compared with those of another.

`python -m tests.campaign.states store FILE` solves the cases and stores their states;
`python -m tests.campaign.states compare OLD NEW` lists the cases that differ. For changes that must not change results,
such as those for speed.
"""

from __future__ import annotations

import argparse
import math
import pickle
import sys
import warnings
from pathlib import Path
from typing import Any

import numpy as np
import viscoroll as vr

from .cases import draw

#: Largest difference of pressures and scalars, relative to the largest pressure and to the size of a scalar.
TOLERANCE = 1e-11

#: Scalars without meaning below round-off, and those that count the work.
SKIPPED = ("residual", "energy_balance_error", "operator_applications", "iterations")


def state(seed: int, number: int) -> dict[str, Any]:
    """Return the scalars and the pressures of a case, or the message of its exception."""
    case = draw(seed, number)
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            result = vr.solve(case.body, **case.arguments)
    except Exception as error:
        return {"message": f"{type(error).__name__}: {error}"}
    return {"message": "", "scalars": result.scalars(), "pressure": np.asarray(result.pressure)}


def difference(old: dict[str, Any], new: dict[str, Any]) -> float:
    """Return the largest relative difference of two states, infinite if they are different states."""
    if old["message"] or new["message"]:
        return 0.0 if old["message"] == new["message"] else math.inf
    before, after = old["pressure"], new["pressure"]
    if before.shape != after.shape or not np.array_equal(before > 0.0, after > 0.0):
        return math.inf
    largest = float(np.abs(after - before).max() / before.max())
    a, b = old["scalars"], new["scalars"]
    for name in a.keys() - set(SKIPPED):
        if isinstance(a[name], float) and isinstance(b[name], float):
            if a[name] != b[name]:
                largest = max(largest, abs(a[name] - b[name]) / size(name, a))
        elif a[name] != b[name]:
            return math.inf
    return largest


def size(name: str, scalars: dict[str, Any]) -> float:
    """Return the size of a scalar to which its difference is compared.

    Resultants may vanish by symmetry or without loss. Their differences are compared to at least a thousandth of the
    load, or of its product with the semi-axis of the contact and the angular speed.
    """
    small = 1e-3 * abs(scalars["load"])
    lever = scalars["semi_axis_x"]
    least = {"torque": small * lever, "force": small, "power": small * lever * scalars["angular_speed"]}
    least |= {"coefficient": 1e-3, "error": 1.0}
    return max(abs(scalars[name]), *(value for part, value in least.items() if part in name), 0.0)


def main() -> int:
    """Store or compare the states of random cases, as the command line requests."""
    parser = argparse.ArgumentParser(prog="python -m tests.campaign.states", description=__doc__)
    commands = parser.add_subparsers(dest="command", required=True)
    store = commands.add_parser("store", help="solve cases and store their states")
    store.add_argument("file", type=Path)
    store.add_argument("--count", type=int, default=300, help="number of cases")
    store.add_argument("--seed", type=int, default=1, help="seed of the random cases")
    compare = commands.add_parser("compare", help="list the cases that differ")
    compare.add_argument("old", type=Path)
    compare.add_argument("new", type=Path)
    arguments = parser.parse_args()
    if arguments.command == "store":
        states = {f"{arguments.seed}:{number}": state(arguments.seed, number) for number in range(arguments.count)}
        arguments.file.write_bytes(pickle.dumps(states))
        return 0
    # The files were written by this program.
    old, new = (pickle.loads(file.read_bytes()) for file in (arguments.old, arguments.new))
    differences = {name: difference(old[name], new[name]) for name in old}
    for name, value in differences.items():
        if not value <= TOLERANCE:
            print(f"{name}: {value:.1e}", old[name]["message"][:100], new[name]["message"][:100])
    print(f"{len(old)} cases, largest difference {max(differences.values()):.1e}")
    return int(not max(differences.values()) <= TOLERANCE)


if __name__ == "__main__":
    sys.exit(main())
