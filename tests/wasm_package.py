"""The npm package, and bodies and materials that its tests share."""

from __future__ import annotations

import json
import shutil
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
PACKAGE = ROOT / "build" / "wasm" / "package"

NEEDS = [
    pytest.mark.skipif(shutil.which("node") is None, reason="needs node"),
    pytest.mark.skipif(not PACKAGE.exists(), reason="needs build/wasm, which `make wasm` makes"),
]

RUBBER = {
    "type": "standard_linear_solid",
    "instantaneous_modulus": 6e6,
    "relaxed_modulus": 3e6,
    "relaxation_time": 0.125,
}
PRONY = {"type": "prony", "instantaneous_modulus": 4e6, "weights": [0.3, 0.4], "relaxation_times": [1e-3, 0.1]}
CREEP = {
    "type": "creep_compliance",
    "instantaneous_compliance": 2e-7,
    "compliances": [5e-8, 1e-7],
    "retardation_times": [1e-3, 0.1],
}
FRACTIONAL = {
    "type": "fractional_zener",
    "instantaneous_modulus": 1e8,
    "relaxed_modulus": 2e6,
    "relaxation_time": 1e-5,
    "order": 0.5,
}
NEGAMI = {**FRACTIONAL, "type": "havriliak_negami", "asymmetry": 0.5}
LOSS = {"type": "loss_factor", "modulus": 3e6, "loss_factor": 0.2, "reference_frequency": 30.0}
SHEET = {"type": "hardness", "hardness": 82.5, "rebound": 0.705, "reference_frequency": 1.0, "decades": 4.5}
HARD = {"type": "hardness", "hardness": 40, "scale": "D"}
CURVE = {
    "type": "master_curve",
    "frequency": [0.0, 0.1, 10.0, 1e3],
    "storage": [2e6, 2e6, 3e6, 6e6],
    "loss": [0.0, 2e5, 6e5, 9e5],
    "extrapolation": "hold",
}


def layer(shear_modulus=RUBBER, *, thickness=1e-3, **others):
    return {"thickness": thickness, "shear_modulus": shear_modulus, **(others or {"poisson_ratio": 0.5})}


BALL = {"core_radius": 20e-3, "layers": [layer(poisson_ratio=0.5, density=1000.0)]}
#: For an incompressible tread that ends in faces, the elements themselves have a round-off of 1e-9.
TREAD = layer(thickness=10e-3, poisson_ratio=0.49)
WHEEL = {"core_radius": 40e-3, "layers": [TREAD], "width": 30e-3, "crown_radius": 300e-3}


def answers(requests, entry="module"):
    """Return the answers of node to requests, and the table of scalars."""
    runner = ROOT / "tests" / "wasm" / "answers.mjs"
    done = subprocess.run(
        ["node", str(runner), str(PACKAGE), entry], input=json.dumps(requests), capture_output=True, encoding="utf-8"
    )
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)
