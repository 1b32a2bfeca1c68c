"""Tables of results that the command line prints besides the scalars of `viscoroll.Result`."""

from __future__ import annotations

from typing import TYPE_CHECKING, cast

from .. import paper
from .._support.errors import InvalidInput
from .._support.extras import extra
from .._support.result_warnings import warn
from .._support.tables import handy
from ..solution.scalars import label_of
from ..solution.text import with_unit

with extra("cli"):
    from rich.markup import escape
    from rich.table import Table

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from .._support.progress import Report
    from ..bodies import CoatedCylinder, RollingBody
    from ..case import Case
    from ..case.solved import SolvedCase
    from ..reproduce import Verdict
    from ..rolling import Result

__all__ = [
    "finite_strain_scalars",
    "finite_strain_table",
    "require_finite_strain",
    "table_2",
    "thermal_table",
    "verdict_table",
]

#: Results that `--finite-strain` compares.
_COMPARED = ("resisting_torque", "load", "penetration", "contact_length", "max_pressure", "overspeed")

#: Unit, and value of the finite elements, of corrected linear theory and of linear theory, by name.
FiniteStrainRows = dict[str, tuple[str, float, float | None, float | None]]


def thermal_table(solved: SolvedCase) -> Table:
    """Return the table of the reported numbers of the temperature, with a column for every steady state."""
    count = len(solved.temperatures)
    title = "temperature" if count == 1 else f"{count} steady states; a cold start reaches the first"
    table = Table(title=title, title_justify="left", show_header=False)
    for label, texts in solved.thermal_rows():
        table.add_row(escape(label), *texts)
    return table


def verdict_table(verdicts: Mapping[str, Sequence[Verdict]]) -> Table:
    """Return the table that compares the paper's statements with the results of this program."""
    table = Table(title="Comparison with the paper", title_justify="left")
    for head in ("item", "statement of the paper", "viscoroll", "verdict"):
        table.add_column(head, overflow="fold")
    for name, rows in verdicts.items():
        for index, verdict in enumerate(rows):
            color = {"agrees": "[green]", "disagrees": "[red]"}.get(verdict.judgment, "[yellow]")
            judged = f"{color}{escape(verdict.judgment)}[/]"
            cells = (name if index == 0 else "", escape(verdict.statement), escape(verdict.found), judged)
            table.add_row(*cells, end_section=index == len(rows) - 1)
    return table


def table_2(torques: dict[tuple[int, int], float]) -> Table:
    """Return table 2 of the paper, computed and printed, for numbers of nodes and orders as keys."""
    orders = sorted({order for _, order in torques})
    table = Table(title="Resisting torque T_r [mN m], computed and printed in table 2", title_justify="left")
    table.add_column("spacing")
    table.add_column("N_t")
    for order in orders:
        table.add_column(str(order), justify="right")
    for nodes in sorted({nodes for nodes, _ in torques}):
        for label, source in (("computed", torques), ("printed", paper.TABLE_2)):
            cells = [f"{source[nodes, o] * 1e3:.2f}" if (nodes, o) in source else "N/A" for o in orders]
            head = f"π/{nodes // 2}" if source is torques else ""
            table.add_row(head, label, *cells, end_section=source is paper.TABLE_2)
    return table


def require_finite_strain(case: Case) -> None:
    """Raise an error unless `--finite-strain` can solve the bodies and the motion of a case."""
    if not case.body.line_contact:
        raise InvalidInput(
            "--finite-strain",
            "must be left out unless the case has a roller, the table [cylinder]: finite elements at finite strain "
            "solve rollers only",
            f"a {case.body.noun}",
        )
    if case.on is not None and case.on.is_deformable:
        raise InvalidInput(
            "--finite-strain",
            "must be left out unless the counterbody is rigid: finite elements at finite strain deform the roller only",
            f"a {case.on.noun} with layers or a base",
        )
    if case.friction > 0.0:
        raise InvalidInput("rolling.friction", "must be 0 with --finite-strain", f"{case.friction:g}")


def finite_strain_scalars(result: Result, *, progress: Report) -> FiniteStrainRows:
    """Return unit and value of finite elements, corrected linear theory and linear theory for every compared quantity.

    The finite elements have the bodies, the given load or penetration, and the angular speed at finite strain of the
    result of linear theory.
    """
    from .. import finite_strain

    try:
        found = finite_strain.solve(
            cast("CoatedCylinder", result.body),  # require_finite_strain rejects other bodies
            on=result.on,
            **{result.prescribed: getattr(result, result.prescribed)},
            angular_speed=result.finite_strain_angular_speed or result.angular_speed,
            progress=progress,
        )
    except InvalidInput as error:
        raise error.with_more("required by --finite-strain") from None
    warn(
        f"layers[{j}] has the Poisson's ratio {layer.poisson_ratio:g}, which linear theory keeps constant; the finite "
        "elements keep the bulk modulus at rest constant. The two columns therefore differ; to compare the theories, "
        "give bulk_modulus in place of poisson_ratio"
        for j, layer in enumerate(result.body.layers)
        if layer.poisson_ratio is not None and layer.poisson_ratio < 0.5
    )
    linear = {name: getattr(result, name) for name in _COMPARED if name != "overspeed"}
    corrected = {"resisting_torque": result.finite_strain_torque, "overspeed": result.overspeed}
    return {
        name: (result.unit(name), getattr(found, name), corrected.get(name), linear.get(name)) for name in _COMPARED
    }


def finite_strain_table(rows: FiniteStrainRows, body: RollingBody) -> Table:
    """Return the table of finite elements, corrected linear theory and linear theory side by side."""
    table = Table(title="rolling at finite strain; corrected: linear theory with overspeed", title_justify="left")
    for head in ("", "finite elements", "corrected", "linear theory"):
        table.add_column(head)
    for name, (unit, *values) in rows.items():
        texts, handy_unit = handy(values, unit)
        cells = ("" if value is None else text for value, text in zip(values, texts, strict=True))
        label = label_of(name, body)
        table.add_row(escape(with_unit(label, handy_unit)), *cells)
    return table
