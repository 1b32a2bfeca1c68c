"""How Sphinx builds the site, by `make docs`: nothing is fetched while it is built, or when it is read."""

import sys
from enum import Enum, EnumType
from importlib.util import find_spec
from pathlib import Path

import viscoroll
from numpydoc.xref import DEFAULT_LINKS

DOCS = Path(__file__).parent
ROOT = DOCS.parent

sys.path.insert(0, str(DOCS))
from try_page import write_page  # noqa: E402  (of this folder)

project = "viscoroll"
author = "The viscoroll developers"
copyright = "2026, The viscoroll developers"  # noqa: A001  (Sphinx calls it so)
version = release = viscoroll.__version__

extensions = [
    "breathe",
    "myst_nb",
    "numpydoc",
    "sphinx.ext.autodoc",
    "sphinx.ext.autosummary",
    "sphinx.ext.mathjax",
    "sphinx_copybutton",
]
templates_path = ["_templates"]
exclude_patterns = ["recorded/*.md"]
default_role = "py:obj"

# Pages in Markdown; their code cells run when the site is built, and fail the build where they fail or warn.
myst_enable_extensions = ["amsmath", "dollarmath"]
myst_heading_anchors = 3
nb_execution_mode = "force"
nb_execution_in_temp = True
nb_execution_raise_on_error = True
nb_execution_timeout = 900  # what takes seconds takes minutes beside other work
nb_output_stderr = "warn"
nb_merge_streams = True
nb_ipywidgets_js = {}  # they would come from the net: pages show what a widget draws, not the widget

# The API of Python from docstrings, that of C++ from the headers by way of Doxygen.
autosummary_generate = True
autodoc_typehints = "none"
autodoc_member_order = "bysource"
numpydoc_show_class_members = False
numpydoc_xref_param_type = True
numpydoc_xref_aliases = {word: word for word in DEFAULT_LINKS}  # of Python and NumPy, whose sites are elsewhere
numpydoc_xref_ignore = {"of", "or", "to", "in", "optional", "default", "shape", "path-like", "nodes", *DEFAULT_LINKS}
breathe_projects = {"viscoroll": str(ROOT / "build" / "doxygen" / "xml")}
breathe_default_project = "viscoroll"
breathe_default_members = ("members",)
breathe_show_include = False
suppress_warnings = ["duplicate_declaration.cpp"]  # the namespace, which each header opens again


def complete_docstring(_app, _what, _name, described, _options, lines: list[str]) -> None:
    """List the members of enums, and let |x| be an absolute value, where reStructuredText looks for a substitution."""
    if isinstance(described, EnumType):
        lines += ["", *(text for member in described for text in (f"``{member.name}``", f"    {member.__doc__}", ""))]
    lines[:] = [line if "``" in line else line.replace("|", r"\|") for line in lines]


def is_listed(_app, _what, _name, described, _skip, _options) -> bool | None:
    """Leave out members of enums, which the docstring lists."""
    return True if isinstance(described, Enum) else None


def setup(app) -> None:
    """Connect what is above to Sphinx; numpydoc has read the docstrings by then."""
    app.connect("autodoc-skip-member", is_listed)
    app.connect("autodoc-process-docstring", complete_docstring, priority=900)


html_theme = "pydata_sphinx_theme"
html_title = f"viscoroll {version}"
html_static_path = ["_static"]
html_css_files = ["site.css"]
html_extra_path = [str(ROOT / "build" / "site")]  # files as they are: the page of `try.md`
html_copy_source = False
html_show_sourcelink = False
html_sidebars = {"index": [], "try": [], "jobs/*": []}  # whose pages want the room
html_theme_options = {
    "show_prev_next": True,
    "navigation_with_keys": False,
    "secondary_sidebar_items": {"**": ["page-toc"], "index": [], "try": []},
    "footer_start": ["copyright"],
    "footer_end": [],
}

if not write_page(ROOT / "build" / "site" / "try", ROOT / "build" / "wasm" / "package" / "viscoroll.single.js"):
    print("the page to try it on has no solver, and says so: `make wasm` makes one")

# MathJax with its font in one file, from a package; by default it would come from the net.
_mathjax = find_spec("sphinx-mathjax-offline")
html_static_path.append(str(Path(_mathjax.origin).parent / "static" / "mathjax" / "tex-svg.js"))
mathjax_path = "tex-svg.js"
