"""Text of a result: printed summary, notebook table, and lines for other tables."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from .._support.quantities import percent_text, quantity_texts
from .._support.tables import html_table, unit_text
from .._support.units import suitable_unit
from ..bodies.si_hints import unit_doubt
from .loss_spectrum import extrapolated_loss
from .scalars import PRECISION, SCALAR_GROUPS, SCALARS, label_of
from .solution import Solution

if TYPE_CHECKING:
    from collections.abc import Sequence

__all__ = [
    "ANSWER",
    "LOSSLESS",
    "mesh_text",
    "relative_error",
    "result_html",
    "result_sections",
    "result_summary",
    "result_title",
    "result_warnings",
    "scalar_text",
    "scalar_texts",
    "with_unit",
]

#: Title of the section of a report that comes first: the results for which a body is used.
ANSWER = "answer"

_CERTAINTY, _FURTHER = "how certain", "further results"

#: Text for bodies whose layers have no loss.
LOSSLESS = "this material dissipates nothing"

#: Results of a contact with an area that in line contact repeat the contact length, or do not exist.
_POINT_CONTACT = frozenset({"contact_area", "semi_axis_x", "semi_axis_z", "contact_width"})

#: Parts of the dissipated power, which are omitted if they equal it.
_PARTS = frozenset({"bulk_power", "rolling_bulk_power", "counterbody_bulk_power", "slip_power"})


#: Relative difference below which the torque of the drive is the resisting torque.
_SAME_TORQUE = 1e-6

#: Further results of which 0 is a result: a contact reaches the faces.
_KEPT = frozenset({"face_distance"})


def result_summary(result: Solution) -> str:
    """Return a summary: the answer, how certain it is, and further results."""
    sections = result_sections(result)
    width = max(len(label) for rows in sections.values() for label, _ in rows)
    lines = [f"Result of {result_title(result)}"]
    for title, rows in sections.items():
        lines += [] if title == ANSWER else [f"{title}:"]
        lines += [f"  {label:<{width}}  {text}" for label, text in rows]
    return "\n".join([*lines, mesh_text(result), *(f"warning: {message}" for message in result_warnings(result))])


def result_sections(result: Solution) -> dict[str, list[tuple[str, str]]]:
    """Return the rows of a report, label and text, by the title of their section.

    The order of sections and rows is that of the table of scalar results. Given values and results without meaning for
    the case are omitted, and of the further results also those that vanish.
    """
    answer = {name: label for name, label in _reported(result).items() if _group(result, name) == "answer"}
    lossless = [("dissipation in the layers", LOSSLESS)] if result.bulk_power == 0.0 else []
    certainty = _rows(result, "certainty")
    if (extrapolated := extrapolated_loss(result)) is not None:
        certainty.append(("share of the loss outside the measured table", percent_text(extrapolated)))
    return {
        ANSWER: [
            *lossless,
            *((label, scalar_text(result, name)) for name, label in answer.items()),
            *_sticking(result),
        ],
        _CERTAINTY: certainty,
        _FURTHER: _rows(result, "other"),
    }


def mesh_text(result: Solution) -> str:
    """Return the mesh, its number of nodes in contact, and the status, on one line."""
    return f"{result.mesh}, {int(result.contact.sum())} nodes in contact, {result.status.name}"


def scalar_text(result: Solution, name: str) -> str:
    """Return a scalar result with a readable unit, its digits and its error."""
    return scalar_texts([result], name)[0]


def scalar_texts(results: Sequence[Solution], name: str) -> list[str]:
    """Return a scalar of several results in a common unit; `scalar_text` describes the texts."""
    values = [getattr(result, name) for result in results]
    if PRECISION[name] == ("%",):
        digits = 2 if SCALAR_GROUPS[name] == "certainty" else 3
        return ["undetermined" if value is None else percent_text(value, digits) for value in values]
    if len({result.unit(name) for result in results}) > 1:  # rollers have values per length
        return [scalar_text(result, name) for result in results]
    errors = [relative_error(result, name) for result in results]
    digits = 6 if name in {result.prescribed for result in results} else 3
    texts, unit = quantity_texts(values, results[0].unit(name), errors, digits=digits)
    return [text if value is None else f"{text} {unit}".rstrip() for value, text in zip(values, texts, strict=True)]


def relative_error(result: Solution, name: str) -> float | None:
    """Return the relative error estimate of a scalar result, the sum of those of mesh and theory; None if given."""
    if name == result.prescribed:
        return None
    errors = [getattr(result, error) for error in PRECISION[name] if error != "%"]
    known = [error for error in errors if error is not None]
    return sum(known) if known else None


def result_warnings(result: Solution) -> list[str]:
    """Return the warnings of a result, with a hint if lengths or moduli are implausible in SI units."""
    return [*result.warnings.values(), *filter(None, [unit_doubt(result.body, result.on)])]


def with_unit(label: str, unit: str) -> str:
    """Return a label with its unit in brackets, if it has one."""
    return f"{label} [{unit}]" if unit_text(unit) else label


def result_title(result: Solution) -> str:
    """Return the input on one line."""
    surfaces = f"friction {result.friction:g}" if result.adhesion is None else f"w = {result.adhesion.work:g} J/m²"
    return (
        f"{_prescribed_text(result)}, Ω = {result.angular_speed:g} rad/s, {surfaces}, "
        f"{result.compliance.name.lower()} compliance, {result.curvature.name.lower()} curvature"
    )


def _prescribed_text(result: Solution) -> str:
    """Return the given load or penetration with its unit."""
    symbol, value = "P" if result.prescribed == "load" else "penetration", getattr(result, result.prescribed)
    unit, scale = suitable_unit(value, result.unit(result.prescribed))
    return f"{symbol} = {value / scale:g} {unit}"


def result_html(result: Solution) -> str:
    """Return the table of the result for a notebook."""
    rows = [
        ("" if index else title, label, text)
        for title, section in result_sections(result).items()
        for index, (label, text) in enumerate(section)
    ]
    rows.append(("mesh", "", mesh_text(result)))
    rows += [("warning", "", message) for message in result_warnings(result)]
    return html_table(f"Result of {result_title(result)}", rows)


def _rows(result: Solution, group: str) -> list[tuple[str, str]]:
    return [
        (label, scalar_text(result, name))
        for name, label in _reported(result).items()
        if _group(result, name) == group and (group != "other" or name in _KEPT or getattr(result, name) != 0)
    ]


def _group(result: Solution, name: str) -> str:
    """Return the section of a scalar.

    A prescribed drive is part of the answer with friction only. On a curved counterbody without friction, the resisting
    torque is the moment of the pressure on one body; the torque of the drive then answers alone.
    """
    group = SCALAR_GROUPS[name]
    if name == "finite_strain_torque" and result.friction == 0.0:
        drives = math.isclose(result.driving_torque, result.resisting_torque, rel_tol=_SAME_TORQUE)
        return group if drives else "other"
    return group if group != "friction" else "answer" if result.friction > 0.0 else "other"


def _reported(result: Solution) -> dict[str, str]:
    """Return name and label of the scalars of a report."""
    omitted: set[str] = {result.prescribed}
    if result.semi_axis_z is None:
        omitted |= _POINT_CONTACT
    if result.finite_strain_angular_speed == result.angular_speed:
        omitted.add("finite_strain_angular_speed")
    omitted |= {name for name in _PARTS if getattr(result, name) == result.dissipated_power}
    omitted |= {name for name in SCALARS if getattr(result, name) is None and name != result.unprescribed}
    return {name: label_of(name, result.body) for name in SCALARS if name not in omitted}


def _sticking(result: Solution) -> list[tuple[str, str]]:
    if result.friction == 0.0:
        return []
    sticking = int(result.stick.sum()) / int(result.contact.sum())
    return [("nodes in contact that stick", percent_text(sticking))]
