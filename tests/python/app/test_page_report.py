"""The page prints the same report as Python: labels, units, digits and errors."""

from __future__ import annotations

import json
import shutil
import subprocess
from pathlib import Path

import pytest
import viscoroll as vr
from viscoroll.app import scalars
from viscoroll.app.answer import finite
from viscoroll.solution.text import ANSWER, result_sections

NODE = shutil.which("node")
PAGE = Path(__file__).parents[3] / "python" / "viscoroll" / "app" / "page"

RUBBER = vr.StandardLinearSolid(instantaneous_modulus=6e6, relaxed_modulus=3e6, relaxation_time=0.0125)


def layer(shear_modulus=RUBBER, thickness=5e-3):
    return vr.Layer(thickness=thickness, shear_modulus=shear_modulus, poisson_ratio=0.49)


BALL = vr.CoatedSphere(core_radius=20e-3, layers=[layer()])
ROLLER = vr.CoatedCylinder(core_radius=50e-3, layers=[layer()])
CASES = {
    "ball": (BALL, {"load": 30.0}),
    "ball with friction": (BALL, {"load": 30.0, "friction": 0.4, "drive": vr.Drive(force=2.0)}),
    "ball at a penetration": (BALL, {"penetration": 2e-4}),
    "elastic ball": (vr.CoatedSphere(core_radius=20e-3, layers=[layer(3e6)]), {"load": 30.0}),
    "rollers": (ROLLER, {"load": 4e3, "on": vr.CoatedCylinder(core_radius=80e-3)}),
    "roller on a half-space": (
        vr.CoatedCylinder(core_radius=50e-3),
        {"load": 1e3, "on": vr.CoatedPlane(base=vr.HalfSpace(shear_modulus=RUBBER, poisson_ratio=0.5))},
    ),
    "wheel": (vr.CoatedWheel(core_radius=50e-3, width=30e-3, layers=[layer()]), {"load": 300.0}),
}

SCRIPT = """
import {{ Report }} from {report};
import {{ BODIES }} from {schema};
const {{ scalars, table, of }} = JSON.parse(process.argv[1]);
const body = Object.values(BODIES).find(({{ noun }}) => noun === of.noun);
console.log(JSON.stringify(new Report(scalars, table, {{ ...of, ...body }}).sections()));
"""


@pytest.mark.skipif(NODE is None, reason="no node")
@pytest.mark.parametrize("name", CASES)
@pytest.mark.filterwarnings("ignore::viscoroll.ResultWarning")
def test_both_reports_agree(name):
    body, options = CASES[name]
    r = vr.solve(body, angular_speed=3.0, accuracy=0.1, **options)
    given = {
        "scalars": {key: finite(value) for key, value in r.scalars().items()},
        "table": scalars(),
        "of": {
            "noun": body.noun,
            "prescribed": r.prescribed,
            "friction": r.friction,
            "angularSpeed": r.angular_speed,
        },
    }
    names = {name: json.dumps((PAGE / f"{name}.js").as_uri()) for name in ("report", "schema")}
    words = [NODE, "--input-type=module", "--eval", SCRIPT.format(**names), json.dumps(given)]
    done = subprocess.run(words, capture_output=True, check=True, encoding="utf-8")
    page = {
        title: [(row["label"], row["text"].replace("−", "-")) for row in rows]  # noqa: RUF001
        for title, rows in json.loads(done.stdout).items()
    }
    printed = result_sections(r)
    # The page has a map of the stick state instead of this number.
    printed[ANSWER] = [row for row in printed[ANSWER] if row[0] != "nodes in contact that stick"]
    # JavaScript writes powers of ten as 10⁻⁹.
    for rows in (*page.values(), *printed.values()):
        rows[:] = [(label, text) for label, text in rows if label != "largest violation of the contact conditions"]
    assert page == printed
