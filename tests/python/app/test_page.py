"""The page: unit tests of its modules in Node, and a comparison of what a browser displays with the package.

Skipped without node, or without a browser and the package puppeteer-core, which `make test-page` installs.
"""

from __future__ import annotations

import contextlib
import functools
import gzip
import http.server
import io
import json
import os
import re
import runpy
import shutil
import subprocess
import threading
from operator import attrgetter
from pathlib import Path

import pytest
import viscoroll as vr
from viscoroll.app import PageServer, answer
from viscoroll.case import load_case
from viscoroll.case.motion import build_motion

ROOT = Path(__file__).parents[3]
TESTS = ROOT / "tests" / "page"
LIBRARY = ROOT / "build" / "wasm" / "package" / "viscoroll.single.js"
#: Largest total size of the compressed files of the page [B]. The library has 836 kB, of which histories are 164 kB;
#: the rest has 45 kB.
LARGEST_DOWNLOAD = 900e3

NODE = shutil.which("node")
BROWSER = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)

needs_node = pytest.mark.skipif(NODE is None, reason="no node")


@needs_node
def test_modules():
    files = sorted(TESTS.glob("*.test.js"))
    assert len(files) == 12
    done = subprocess.run([NODE, "--test", *files], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout


def environment():
    """Return the environment of node with the browser and the folder where `make test-page` installs packages."""
    own = ROOT / "build" / "page" / "node_modules"
    paths = filter(None, [str(own), os.environ.get("NODE_PATH")])
    return os.environ | {"BROWSER": BROWSER or "", "NODE_PATH": os.pathsep.join(paths)}


def has_driver():
    if NODE is None or BROWSER is None:
        return False
    words = [NODE, "-e", 'require("puppeteer-core")']
    return subprocess.run(words, env=environment(), capture_output=True, check=False).returncode == 0


def driven(address, folder):
    """Drive a page in the browser, and return what it displayed."""
    words = [NODE, str(TESTS / "drive.js"), address, str(folder)]
    done = subprocess.run(words, env=environment(), capture_output=True, text=True, timeout=300, check=False)
    assert done.returncode == 0, done.stderr
    return json.loads((folder / "seen.json").read_text(encoding="utf-8"))


@contextlib.contextmanager
def served(server):
    """Serve until the block ends."""
    with server:
        thread = threading.Thread(target=server.serve_forever)
        thread.start()
        try:
            yield server
        finally:
            server.shutdown()
            thread.join()


class QuietHandler(http.server.SimpleHTTPRequestHandler):
    """Server of the files in a folder, like any static host."""

    def log_message(self, *_):
        """Suppress the log."""


@pytest.fixture(scope="module")
def site(tmp_path_factory):
    """Return the folder of the page as published on the site, with the library in WebAssembly."""
    if not LIBRARY.exists():
        pytest.skip("no WebAssembly: `make wasm` makes it")
    folder = tmp_path_factory.mktemp("site")
    runpy.run_path(str(ROOT / "docs" / "try_page.py"))["write_page"](folder, LIBRARY)
    return folder


@pytest.fixture(scope="module", params=["viscoroll app", "site from a folder", "site over http"])
def seen(request, tmp_path_factory):
    """Yield what a page displayed, and its address."""
    if not has_driver():
        pytest.skip("no browser, or no puppeteer-core: `make test-page` installs it")
    if request.param == "site from a folder":
        server = contextlib.nullcontext()
        address = (request.getfixturevalue("site") / "index.html").as_uri()
    elif request.param == "site over http":
        handler = functools.partial(QuietHandler, directory=request.getfixturevalue("site"))
        server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), handler)
        address = f"http://127.0.0.1:{server.server_port}/"
        server = served(server)
    else:
        server = PageServer()
        address = server.address
        server = served(server)
    with server:
        yield driven(address, tmp_path_factory.mktemp("seen")) | {
            "address": address.removesuffix("index.html"),
            "page": request.param,
        }


#: Scalars that depend on the round-off of each compiler.
ROUNDED = {"iterations", "operator_applications", "residual", "energy_balance_error", "error_estimate"}


def assert_numbers(shown, result):
    """Assert that a page displays the numbers of a result, to the round-off of different compilers."""
    assert shown["penetration"] > 0.0
    for name, value in shown.items():
        expected = getattr(result, name)
        if name in ROUNDED:
            assert value is not None
        elif expected is None:
            assert value is None
        else:
            assert value == pytest.approx(expected, rel=1e-9, abs=1e-12), name


def readme_ball():
    rubber = vr.StandardLinearSolid(instantaneous_modulus=6e6, relaxed_modulus=3e6, relaxation_time=0.125)
    layer = vr.Layer(thickness=1e-3, shear_modulus=rubber, poisson_ratio=0.5, density=1000.0)
    return vr.CoatedSphere(core_radius=20e-3, layers=[layer])


def solved_by(code):
    """Run copied Python code, and return its result."""
    names = {}
    with contextlib.redirect_stdout(io.StringIO()) as printed:
        exec(code, names)
    assert "rolling resistance coefficient" in printed.getvalue()
    return names["r"]


@pytest.mark.slow
def test_the_case_of_the_readme_gives_its_numbers(seen):
    assert_numbers(seen["readme"], vr.solve(readme_ball(), load=100.0, angular_speed=2.5))
    assert seen["points"] == 21


@pytest.mark.slow
def test_load_and_speed_are_visible_without_scrolling(seen):
    assert seen["inView"] is True


@pytest.mark.slow
def test_the_last_position_of_a_slider_is_solved(seen):
    """Print the response times; newest.test.js tests that at most two of many positions of a slider are solved."""
    print(f"{seen['address']}: {seen['first']:.2f} s to the first answer, {seen['start']:.2f} s to the refined one")
    print(f"{seen['answered']:.2f} s from the last of 30 positions of a slider to its answer")
    load, unit = seen["load"]
    assert unit == "N"
    assert load != 100.0
    assert_numbers(seen["moved"], vr.solve(readme_ball(), load=load, angular_speed=2.5))


@pytest.mark.slow
def test_copied_python_gives_the_numbers_of_the_page(seen):
    assert_numbers(seen["moved"], solved_by(seen["python"]))


@pytest.mark.slow
def test_a_copied_case_file_gives_the_numbers_of_the_page(seen, tmp_path):
    (tmp_path / "case.toml").write_text(seen["caseFile"], encoding="utf-8")
    assert_numbers(seen["moved"], load_case(tmp_path / "case.toml").solve())


@pytest.mark.slow
def test_a_link_restores_the_case(seen):
    assert seen["restored"] == seen["moved"]
    assert seen["hasLink"] == ("site over http" in seen["page"])


@pytest.mark.slow
def test_an_opened_case_file_restores_the_case(seen):
    assert seen["opened"] == seen["moved"]
    assert seen["dropped"].startswith("dropped.toml is not opened: ")


@pytest.mark.slow
def test_the_numbers_of_a_kept_case_are_shown(seen):
    before, now = (seen[case]["strain"] for case in ("moved", "readme"))
    kept, percent = re.fullmatch(r"kept: (\S+) % \(.(\S+)\s%\)", seen["kept"]).groups()
    assert float(kept) == pytest.approx(100.0 * before, abs=0.051)  # three digits
    assert -float(percent) == pytest.approx(100.0 * (now / before - 1.0), abs=0.51)  # whole percent


@pytest.mark.slow
def test_temperatures_are_shown_if_the_solver_computes_them(seen):
    assert seen["hasTemperature"] == (seen["page"] == "viscoroll app")
    if seen["hasTemperature"]:
        result = vr.solve(readme_ball(), load=100.0, angular_speed=2.5)
        heated = result.temperature(convection=10.0, ambient=293.15, conductivity=0.2)
        assert seen["hottest"] == f"{heated.ambient + heated.maximum - 273.15:.4g} °C"
        assert seen["charts"] == 2


@pytest.mark.slow
def test_a_body_rolls_over_a_bump(seen):
    ground = seen["ground"]
    rate = ground["frames"] / ground["seconds"]
    print(f"{seen['address']}: {ground['said']} {rate:.0f} pictures per second for {ground['seconds']:.1f} s")
    history = build_motion(ground["tables"], None).roll()
    assert set(ground["last"]) == {"resisting_force", "resisting_torque", "load", "axle_height", "contact_length"}
    for name, value in ground["last"].items():
        assert value == pytest.approx(getattr(history, name)[-1], rel=1e-9), name
    assert ground["said"].startswith(f"{len(history.time) - 1} steps, ")
    assert ground["frames"] > 20  # in six seconds, also on a machine that is busy
    assert ground["next"] == "step"


@pytest.mark.slow
def test_errors_are_shown_at_their_field(seen):
    assert seen["problem"] == "thickness of layer 1 must be greater than 0 mm, got 0 mm"


@pytest.mark.slow
def test_a_unit_typed_with_a_number_is_selected(seen):
    assert seen["typed"] == ["0.1", "cm"]


@pytest.mark.slow
def test_examples_solve_to_the_same_in_python_and_as_case_files(seen, tmp_path):
    assert {"paper", "skate", "caster"} <= set(seen["examples"])
    for name, example in seen["examples"].items():
        assert example["width"] == 400, name
        (tmp_path / "case.toml").write_text(example["caseFile"], encoding="utf-8")
        for result in (solved_by(example["python"]), load_case(tmp_path / "case.toml").solve()):
            assert result.rolling_resistance_coefficient == pytest.approx(example["coefficient"], rel=1e-9), name


@pytest.mark.slow
def test_the_page_loads_nothing_from_elsewhere(seen):
    assert seen["requests"]
    elsewhere = [url for url in seen["requests"] if not url.startswith((seen["address"], "blob:", "data:"))]
    assert elsewhere == []
    assert seen["complaints"] == []


def test_size_of_the_download(site):
    sizes = {path.name: len(gzip.compress(path.read_bytes())) for path in site.iterdir()}
    assert set(sizes) == {"index.html", "page.css", "page.js", "solver.js"}
    assert sum(sizes.values()) < LARGEST_DOWNLOAD, sizes
    print(f"{sum(sizes.values()) / 1e3:.0f} kB, zipped: {sizes}")


@needs_node
def test_the_page_of_the_site_is_one_script(tmp_path):
    page = runpy.run_path(str(ROOT / "docs" / "try_page.py"))
    (tmp_path / "library.js").touch()
    assert page["write_page"](tmp_path / "try", tmp_path / "library.js") is True
    assert sorted(path.name for path in (tmp_path / "try").iterdir()) == [
        "index.html",
        "page.css",
        "page.js",
        "solver.js",
    ]
    done = subprocess.run([NODE, "--check", tmp_path / "try" / "page.js"], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    text = (tmp_path / "try" / "index.html").read_text(encoding="utf-8")
    assert 'type="module"' not in text
    assert '{"solver": "wasm"}' in text


def test_a_site_without_library_has_no_page(tmp_path):
    page = runpy.run_path(str(ROOT / "docs" / "try_page.py"))
    (tmp_path / "try").mkdir()
    assert page["write_page"](tmp_path / "try", tmp_path / "none.js") is False
    assert not (tmp_path / "try").exists()


@needs_node
def test_copied_code_supports_every_body_and_material():
    page = ROOT / "python" / "viscoroll" / "app" / "page" / "code.js"
    table = {"core_radius": 1.0, "layers": [{"shear_modulus": {"type": "none"}, "thickness": 1.0}]}
    message = answer({"case": {"ball": table, "rolling": {"load": 1.0, "angular_speed": 1.0}}})["error"]["message"]
    kinds = set(message.split("must be one of ")[1].split(", got")[0].split(", "))
    converted = {"hardness", "published", "measured", "constants"}  # calls of functions
    script = (
        f"import {{ classOf }} from {json.dumps(page.as_uri())}; console.log(process.argv.slice(1).map(classOf).join())"
    )
    words = [NODE, "--input-type=module", "--eval", script, *sorted(kinds - converted)]
    moduli = subprocess.run(words, capture_output=True, check=True, encoding="utf-8").stdout.strip().split(",")
    assert len(moduli) == len(kinds - converted)
    assert all(attrgetter(name)(vr) for name in moduli)
