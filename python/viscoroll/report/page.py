"""Report of a case as one HTML file, filled in by Jinja2 (the extra `viscoroll[cli]`)."""

from __future__ import annotations

from collections.abc import Mapping
from datetime import datetime
from importlib import resources
from pathlib import Path
from typing import TYPE_CHECKING, Any

from .._core import __commit__, __version__
from .._support.citation import bibtex
from .._support.extras import extra
from .._support.toml import read_toml
from ..case.case import CaseFile, build_case, with_changes
from ..case.design import limits_of
from ..case.limits import require_thermal
from ..case.plausible import speed_text
from ..case.solved import solve_case
from ..case.tables import errors_in
from ..solution.text import ANSWER, mesh_text, result_sections, result_title
from .inputs import input_tables
from .margins import margins_of
from .materials import materials_of
from .pictures import pictures_of

with extra("cli"):
    from jinja2 import Environment, StrictUndefined, Template

if TYPE_CHECKING:
    from .._support.progress import Report

__all__ = ["report_of"]


def report_of(path: Path, changes: Mapping[str, Any], report: Report) -> str:
    """Solve the case of a file and return its report, an HTML page that refers to no other file.

    Parameters
    ----------
    path : Path
        Case file.
    changes : mapping
        Values that replace those of the file, by the paths of their keys.
    report : callable
        Called as report(stage, fraction).

    Raises
    ------
    ValueError
        If the file is not valid, or lacks a result that its table [design] limits.
    ConvergenceError
        If the solver fails.
    OSError
        If the file cannot be read.
    """
    with errors_in(path):
        document = with_changes(read_toml(path), changes)
        case = build_case(document, path.parent)
        limits = limits_of(document)
        require_thermal(case, limits)
    solved = solve_case(case, progress=report)
    result = solved.result
    sections = result_sections(result)
    page: str = _template().render(
        name=path.name,
        noun=result.body.noun,
        changes={key: str(value) for key, value in changes.items()},
        title=result_title(result),
        speed=speed_text(result.angular_speed, result.body.outer_radius),
        mesh=mesh_text(result),
        answer=sections.pop(ANSWER),
        sections=sections,
        temperatures=solved.thermal_rows(),
        states=len(solved.temperatures),
        softening=repr(solved.softened) if solved.softened else "",
        margins=margins_of(case, solved, limits),
        warnings=solved.warnings,
        pictures=pictures_of(case, solved, report),
        inputs=input_tables(document),
        materials=materials_of(CaseFile.keys_of(document).in_si(document), path.parent),
        version=__version__,
        commit=__commit__,
        date=datetime.now().astimezone().strftime("%Y-%m-%d %H:%M %Z"),
        citation=bibtex(),
    )
    return page


def _template() -> Template:
    text = resources.files("viscoroll").joinpath("report/page.html").read_text(encoding="utf-8")
    environment = Environment(autoescape=True, undefined=StrictUndefined, trim_blocks=True, lstrip_blocks=True)
    return environment.from_string(text)
