"""The command `viscoroll report`: a valid HTML file without references to others, with the numbers of the case."""

from __future__ import annotations

import re
import subprocess
import sys
from base64 import b64decode
from html import unescape
from html.parser import HTMLParser
from itertools import pairwise
from xml.etree import ElementTree

import pytest
from shared_cases import command
from viscoroll._core import __commit__, __version__
from viscoroll._support.quantities import quantity_text
from viscoroll.case import load_case
from viscoroll.case.design import design_case
from viscoroll.case.solved import solve_case
from viscoroll.report.margins import margins_of
from viscoroll.solution.text import relative_error, result_sections, scalar_text
from viscoroll.studies import study

#: Elements without an end tag.
VOID = {"meta", "img", "br", "hr", "input", "link"}

RUBBER = """
type = "prony"
instantaneous_modulus = "3 MPa"
weights = [0.25, 0.15, 0.1]
relaxation_times = ["1 ms", "10 ms", "100 ms"]
"""
BALL = """
[ball]
core_radius = "20 mm"
[[ball.layers]]
thickness = "1 mm"
poisson_ratio = 0.49
shear_modulus = { type = "published", name = "pressure_sensitive_adhesive", temperature = "20 degC" }
[rolling]
load = "5 N"
angular_speed = "30 rpm"
[numerics]
nodes_per_revolution = 300
max_order = 300
[design]
vary = "ball.layers[0].thickness"
from = "0.5 mm"
to = "4 mm"
limits = { max_pressure = "1 MPa", penetration = "0.1 mm" }
"""
ROLLER = f"""
[cylinder]
core_radius = 50e-3
[[cylinder.layers]]
thickness = 10e-3
poisson_ratio = 0.49
conductivity = 0.25
[cylinder.layers.shear_modulus]
{RUBBER}
[rolling]
load = "2 N/mm"
angular_speed = 2.5
friction = 0.3
[numerics]
nodes_per_revolution = 600
[thermal]
convection = 10.0
ambient = "20 degC"
core = "isothermal"
[design]
vary = "cylinder.layers[0].thickness"
from = 5e-3
to = 20e-3
limits = {{ temperature = "60 degC", bond_shear = "1 MPa" }}
[sweep]
"rolling.load" = [1e3, 2e3]
"""
WHEEL = f"""
[wheel]
outer_diameter = "125 mm"
width = "32 mm"
[[wheel.layers]]
thickness = "8 mm"
poisson_ratio = 0.49
[wheel.layers.shear_modulus]
{RUBBER}
[rolling]
load = "60 kgf"
speed = "4 km/h"
[numerics]
nodes_per_revolution = 100
"""
PAIR = f"""
[cylinder]
outer_diameter = "120 mm"
[[cylinder.layers]]
thickness = "10 mm"
poisson_ratio = 0.49
[cylinder.layers.shear_modulus]
{RUBBER}
[other_cylinder]
outer_diameter = "200 mm"
[[other_cylinder.layers]]
thickness = "5 mm"
bulk_modulus = "1 GPa"
shear_modulus = "2 MPa"
[rolling]
penetration = "0.3 mm"
angular_speed = "90 rpm"
[numerics]
nodes_per_revolution = 600
"""
CASES = {"ball": BALL, "roller": ROLLER, "wheel": WHEEL, "pair": PAIR}
PICTURES = ["Contact pressure", "Section through the rolling body", "Curves over speed and load", "Moduli"]


class Page(HTMLParser):
    """Parser that keeps the attributes and texts of a page, and requires balanced tags."""

    def __init__(self, text):
        super().__init__()
        self.open, self.attributes, self.texts = [], [], []
        self.feed(text)
        self.close()
        assert self.open == []

    def handle_starttag(self, tag, attrs):
        """Keep the attributes."""
        self.attributes += [(tag, name, value) for name, value in attrs]
        if tag not in VOID:
            self.open.append(tag)

    def handle_endtag(self, tag):
        """Require the end of the innermost element."""
        assert self.open.pop() == tag

    def handle_data(self, data):
        """Keep a text."""
        self.texts.append(data.strip())

    @property
    def pictures(self):
        """Addresses of the pictures."""
        return [value for tag, name, value in self.attributes if (tag, name) == ("img", "src")]


@pytest.fixture(scope="module")
def written(tmp_path_factory):
    """Return a function that writes the report of a case once, and returns its path, page and messages."""
    found = {}

    def write(kind):
        if kind not in found:
            path = tmp_path_factory.mktemp(kind) / "a<b>&c.toml"
            path.write_text(CASES[kind], encoding="utf-8")
            done = command("report", path)
            assert done.returncode == 0, done.stderr
            found[kind] = path, path.with_suffix(".html").read_text(encoding="utf-8"), done.stderr
        return found[kind]

    return write


@pytest.mark.parametrize("kind", CASES)
def test_a_report_is_a_page_with_all_numbers_that_needs_no_other_file(written, kind):
    path, text, _ = written(kind)
    page = Page(text)
    assert text.startswith("<!DOCTYPE html>")
    more = {"roller": ["Temperature"], "pair": ["Section through the counterbody"]}
    named = [value for tag, name, value in page.attributes if (tag, name) == ("img", "alt")]
    assert sorted(named) == sorted(PICTURES + more.get(kind, []))
    assert {value.partition(",")[0] for value in page.pictures} == {"data:image/svg+xml;base64"}
    for tag, name, value in page.attributes:
        assert tag not in ("script", "link", "iframe", "object", "a", "base")
        assert "://" not in value
        assert not name.startswith("on")
    style = text[text.index("<style>") : text.index("</style>")]
    assert not re.search(r"url\(|@import", style)
    assert "@media print" in style
    assert "prefers-color-scheme: dark" in style
    for value in page.pictures:
        for element in ElementTree.fromstring(b64decode(value.partition(",")[2])).iter():
            assert all(not v.startswith("http") for k, v in element.attrib.items() if k.endswith(("href", "src")))

    for rows in result_sections(solve_case(load_case(path)).result).values():
        for label, value in rows:
            assert (label, value) in pairwise(filter(None, page.texts))
    assert "Zéhil, G.-P. and Gavin, H. P." in text
    assert f"viscoroll {__version__}, commit {__commit__}" in text


def test_names_of_files_are_escaped(written):
    _, text, _ = written("ball")
    assert "a<b>" not in text
    assert "a&lt;b&gt;&amp;c.toml" in text
    assert "a<b>&c.toml" in Page(text).texts


def cells(text, label):
    """Return the texts of a row of a table by its label."""
    row = re.search(rf'<th scope="row">{re.escape(label)}</th>(.*?)</tr>', text, re.DOTALL)
    return [unescape(re.sub(r"<.*?>", "", cell)) for cell in re.findall(r"<td.*?>(.*?)</td>", row[1])]


def test_inputs_are_listed_as_typed_and_in_si_units(written):
    _, text, _ = written("ball")
    assert cells(text, "thickness") == ["1 mm", "0.001 m"]
    assert cells(text, "load") == ["5 N", "5 N"]
    assert cells(text, "angular speed") == ["30 rpm", "3.14159265 rad/s"]
    _, text, _ = written("roller")
    assert cells(text, "relaxation times") == ["1 ms, 10 ms, 100 ms", "0.001, 0.01, 0.1 s"]
    assert cells(text, "weights") == ["0.25, 0.15, 0.1", ""]
    assert cells(text, "poisson ratio") == ["0.49", ""]
    assert cells(text, "load") == ["2 N/mm", "2000 N/m"]
    assert cells(text, "core radius") == ["0.05", "0.05 m"]
    assert cells(text, "ambient") == ["20 degC", "293.15 K"]


def test_margins_are_those_to_the_limits(written):
    path, text, _ = written("ball")
    result = load_case(path).solve()
    text = text[text.index("Limits and margins") :]
    assert cells(text, "largest contact pressure") == [
        scalar_text(result, "max_pressure"),
        "1 MPa",
        f"{100.0 - 1e-4 * result.max_pressure:.3g} %",
    ]
    assert cells(text, "penetration") == [
        scalar_text(result, "penetration"),
        "0.1 mm",
        f"{result.penetration / 0.1e-3:.3g} times the limit, exceeded",
    ]


def test_a_limit_within_the_error_is_uncertain(written):
    path, _, _ = written("ball")
    case = load_case(path)
    solved = solve_case(case)
    value, error = solved.result.penetration, solved.result.error_estimate + solved.result.penetration_model_error
    states = {
        factor: margins_of(case, solved, {"penetration": value * (1.0 + factor * error)})[0].state
        for factor in (-1.1, -0.9, 0.9, 1.1)
    }
    assert states == {-1.1: "exceeded", -0.9: "uncertain", 0.9: "uncertain", 1.1: "kept"}


def test_temperatures_have_a_table_a_picture_and_a_margin(written):
    path, text, messages = written("roller")
    solved = solve_case(load_case(path))
    rise = solved.temperatures[0].maximum
    error = relative_error(solved.result, "dissipated_power")
    assert cells(text, "largest temperature rise") == [quantity_text(rise, "K", error)]
    assert cells(text, "largest temperature of the layers")[2] == f"{40.0 - rise:.3g} K"
    assert cells(text, "heat generated") == [quantity_text(solved.temperatures[0].heat, "W/m", error)]
    assert 'alt="Temperature"' in text
    assert "[sweep] is for `viscoroll sweep`" in messages


def test_a_published_material_is_cited(written):
    _, text, _ = written("ball")
    assert "A. Perego, hermes-rheo (3M)" in text
    assert cells(text, "range")[0].startswith("243.16 to 423.14 K")
    assert cells(text, "temperature") == ["20 degC", "293.15 K"]


def test_warnings_are_on_the_page(tmp_path):
    path = tmp_path / "case.toml"
    path.write_text(BALL, encoding="utf-8")
    done = command("report", path, "--set", "rolling.load=0.02 kN", "-o", tmp_path / "r.html")
    assert done.returncode == 0, done.stderr
    text = (tmp_path / "r.html").read_text(encoding="utf-8")
    warnings = solve_case(load_case(path, {"rolling.load": "0.02 kN"})).warnings
    assert warnings
    assert all(message in Page(text).texts for message in warnings)
    assert "rolling.load = 0.02 kN" in Page(text).texts
    assert cells(text, "load") == ["0.02 kN", "20 N"]


def test_missing_curves_are_explained(tmp_path, monkeypatch):
    def fail(*_args, **_options):
        raise ValueError("no <curve>")

    monkeypatch.setattr(study, "sweep", fail)
    path = tmp_path / "case.toml"
    path.write_text(BALL, encoding="utf-8")
    assert command("report", path).returncode == 0
    assert "This picture is missing: no &lt;curve&gt;." in path.with_suffix(".html").read_text(encoding="utf-8")


@pytest.mark.parametrize(
    ("output", "message"),
    [
        ("report.pdf", "--output must end in .html, got 'report.pdf'"),
        ("nowhere/report.html", "--output must be a file in a folder that exists"),
    ],
)
def test_an_output_that_cannot_be_written_is_rejected_first(tmp_path, output, message):
    done = command("report", tmp_path / "missing.toml", "-o", tmp_path / output)
    assert done.returncode == 2
    assert message in done.stderr


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ("rolling.friction=9", "friction must be"),
        ("rolling.load=1e9", "load"),
        ("design.limits.bond_shear=5 mm", "design.limits.bond_shear must be a stress or modulus"),
        ("design.limits.temperature=300", "must be used with a table [thermal]"),
        ("design.limits.contact_width=0.1", "design.limits.contact_width must be left out"),
    ],
)
def test_nothing_is_written_for_a_case_without_results(tmp_path, change, message):
    path = tmp_path / "case.toml"
    body = BALL if "contact_width" not in change else ROLLER
    path.write_text(body, encoding="utf-8")
    done = command("report", path, "--set", change)
    assert done.returncode in (1, 2)
    assert message in done.stderr
    assert [file.name for file in tmp_path.iterdir()] == ["case.toml"]


def test_the_limits_of_a_report_are_those_of_the_design(tmp_path):
    path = tmp_path / "case.toml"
    path.write_text(BALL.replace("penetration =", "strain =").replace('"0.1 mm"', "0.2"), encoding="utf-8")
    found = design_case(path)
    assert command("report", path, "--set", f"ball.layers[0].thickness={found.best!r}").returncode == 0
    text = path.with_suffix(".html").read_text(encoding="utf-8")
    margins = text[text.index("Limits and margins") :]
    assert cells(margins, "strain")[0] == scalar_text(found.result, "strain")
    assert 'class="exceeded"' not in text


@pytest.mark.parametrize("words", [["--help"], ["report", "--help"]])
def test_other_commands_do_not_import_the_template_engine(words):
    text = (
        f"import sys; sys.argv = {['viscoroll', *words]!r}\n"
        "from viscoroll.__main__ import main\n"
        "try: main()\n"
        "except SystemExit: pass\n"
        "print('jinja2' in sys.modules)"
    )
    done = subprocess.run([sys.executable, "-c", text], capture_output=True, encoding="utf-8", check=True)
    assert done.stdout.splitlines()[-1] == "False"


def test_a_missing_template_engine_names_the_extra(tmp_path):
    (tmp_path / "case.toml").write_text(BALL, encoding="utf-8")
    text = (
        "import sys; sys.modules['jinja2'] = None; sys.argv = ['viscoroll', 'report', 'case.toml']\n"
        "from viscoroll.__main__ import main; main()"
    )
    done = subprocess.run(
        [sys.executable, "-c", text], capture_output=True, encoding="utf-8", cwd=tmp_path, check=False
    )
    assert done.returncode == 2
    assert "requires jinja2, which is not installed: pip install 'viscoroll[cli]'" in done.stderr
