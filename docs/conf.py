"""Configuration of Sphinx for `make docs`. Neither the build nor the finished site downloads anything."""

import sys
from enum import Enum, EnumType
from importlib.util import find_spec
from pathlib import Path

import viscoroll
from numpydoc.xref import DEFAULT_LINKS

DOCS = Path(__file__).parent
ROOT = DOCS.parent
SITE = ROOT / "build" / "site"

sys.path.insert(0, str(DOCS))
from try_page import write_page  # noqa: E402  (in this folder)

project = "viscoroll"
author = "The viscoroll developers"
copyright = "2026, The viscoroll developers"  # noqa: A001  (name required by Sphinx)
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

# Pages are in Markdown. Their code cells run during the build, which fails if a cell raises an error or warns.
myst_enable_extensions = ["amsmath", "dollarmath"]
myst_heading_anchors = 3
nb_execution_mode = "force"
nb_execution_in_temp = True
nb_execution_raise_on_error = True
nb_execution_timeout = 900  # cells that take seconds may take minutes on a busy machine
nb_output_stderr = "warn"
nb_merge_streams = True
nb_ipywidgets_js = {}  # would be downloaded: pages show the output of a widget, not the widget

# The Python API comes from docstrings, the C++ API from the headers through Doxygen.
autosummary_generate = True
autodoc_typehints = "none"
autodoc_member_order = "bysource"
numpydoc_show_class_members = False
numpydoc_xref_param_type = True
numpydoc_xref_aliases = {word: word for word in DEFAULT_LINKS}  # of Python and NumPy: no external links
numpydoc_xref_ignore = {"of", "or", "to", "in", "optional", "default", "shape", "path-like", "nodes", *DEFAULT_LINKS}
breathe_projects = {"viscoroll": str(ROOT / "build" / "doxygen" / "xml")}
breathe_default_project = "viscoroll"
breathe_default_members = ("members",)
breathe_show_include = False
suppress_warnings = ["duplicate_declaration.cpp"]  # each header opens the namespace again


def complete_docstring(_app, _what, _name, described, _options, lines: list[str]) -> None:
    """List the members of enums, and escape |x|, which reStructuredText takes for a substitution."""
    if isinstance(described, EnumType):
        lines += ["", *(text for member in described for text in (f"``{member.name}``", f"    {member.__doc__}", ""))]
    lines[:] = [line if "``" in line else line.replace("|", r"\|") for line in lines]


def is_listed(_app, _what, _name, described, _skip, _options) -> bool | None:
    """Skip members of enums: the docstring lists them."""
    return True if isinstance(described, Enum) else None


def setup(app) -> None:
    """Connect the functions above to Sphinx; the priority runs `complete_docstring` after numpydoc."""
    app.connect("autodoc-skip-member", is_listed)
    app.connect("autodoc-process-docstring", complete_docstring, priority=900)


html_theme = "pydata_sphinx_theme"
html_title = f"viscoroll {version}"
html_static_path = ["_static"]
html_css_files = ["site.css"]
html_extra_path = [str(SITE)]  # files that are copied: the page "Try it"
html_copy_source = False
html_show_sourcelink = False
html_sidebars = {"index": [], "try": [], "jobs/*": []}  # pages that use the full width
html_theme_options = {
    "show_prev_next": True,
    "navigation_with_keys": False,
    "secondary_sidebar_items": {"**": ["page-toc"], "index": [], "try": []},
    "footer_start": ["copyright"],
    "footer_end": [],
}

# Pages show the link to the page "Try it" only if it exists.
SITE.mkdir(parents=True, exist_ok=True)
if write_page(SITE / "try", ROOT / "build" / "wasm" / "package" / "viscoroll.single.js"):
    tags.add("solver")  # noqa: F821  (Sphinx defines `tags`)
else:
    print("the site is built without the page 'Try it', which needs the library of `make wasm`")

# Take MathJax with its font from a package; by default, readers would download it.
_mathjax = find_spec("sphinx-mathjax-offline")
html_static_path.append(str(Path(_mathjax.origin).parent / "static" / "mathjax" / "tex-svg.js"))
mathjax_path = "tex-svg.js"
