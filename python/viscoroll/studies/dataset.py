"""The dataset of a study."""

from __future__ import annotations

import datetime
import json
import sys
from collections import Counter
from collections.abc import Mapping
from dataclasses import fields
from enum import Enum
from typing import TYPE_CHECKING, Any

import numpy as np

from .._core import __commit__, __version__
from .._support.extras import extra
from .._support.units import UNITS, unit_in_contact
from ..bodies import CoatedPlane, Counterbody, RollingBody, is_body
from ..bodies.si_hints import unit_doubt
from ..coupled.softening_result import BOUNDS
from ..sliding import RoughSurface
from ..solution import FIELDS, VECTOR_FIELDS
from .dimensions import label
from .draws import interval_variables
from .kinds import ROLLING, SLIDING
from .plan import LoadCase, Plan
from .run import Outcome

if TYPE_CHECKING:
    import xarray
    from numpy.typing import NDArray

__all__ = ["RESERVED", "RESERVED_BY_SLIDING", "build_dataset"]

_TEXTS = {
    "status": "status of the solve",
    "warnings": "warnings about the result",
    "error": "error of a failed point",
}

#: Names of results. Parameters of a function that makes a body cannot have these names.
RESERVED = frozenset({*ROLLING.results, *BOUNDS, *_TEXTS, *FIELDS, *VECTOR_FIELDS, "phi", "theta", "direction"})

#: The same for functions of rough surfaces.
RESERVED_BY_SLIDING = frozenset({*SLIDING.results, *_TEXTS})


def build_dataset(plan: Plan, outcomes: Mapping[int, Outcome]) -> xarray.Dataset:
    """Return all results of a plan over its dimensions; points that failed or have no outcome are NaN.

    Parameters
    ----------
    plan : Plan
        Points of the study.
    outcomes : mapping of int to Outcome
        Outcomes by the index of the point.
    """
    with extra("studies"):
        import xarray

    names = [dimension.name for dimension in plan.dimensions]
    coordinates = {
        d.name: ([d.name], d.labels(), _attributes(_unit(plan, d.unit), _spelled(d.name))) for d in plan.dimensions
    }
    fixed: dict[str, Any] = {
        name: ([], value, _attributes(_unit(plan, UNITS.get(name)), _spelled(name)))
        for name, value in plan.fixed.items()
        if isinstance(value, int | float) and not isinstance(value, bool)
    }
    table = [outcomes.get(i, Outcome()) for i in range(len(plan.cases))]
    variables: dict[str, Any] = {}
    units = plan.kind.units(line_contact=plan.line_contact)
    for name, (unit, description) in plan.kind.results.items():
        column = [value if (value := outcome.scalars.get(name)) is not None else np.nan for outcome in table]
        variables[name] = (names, np.array(column, dtype=np.float64), _attributes(units.get(name, unit), description))
    for name, (unit, description) in plan.added_columns.items():
        column = [value if (value := outcome.scalars.get(name)) is not None else np.nan for outcome in table]
        unit = unit_in_contact(unit, line_contact=plan.line_contact and unit == "W")
        variables[name] = (names, np.array(column, dtype=np.float64), _attributes(unit, description))
    for name in BOUNDS if any(bound in outcome.scalars for outcome in table for bound in BOUNDS) else ():
        column = [value if (value := outcome.scalars.get(name)) is not None else np.nan for outcome in table]
        variables[name] = (
            names,
            np.array(column, dtype=np.float64),
            _attributes(units["resisting_torque"], BOUNDS[name]),
        )
    best_estimates = {name: values for name, (_, values, _) in variables.items()}
    intervals = interval_variables([outcome.draws for outcome in table], best_estimates, plan.confidence)
    for name, (result, values, description) in intervals.items():
        variables[name] = (names, values, _attributes(units[result], f"{plan.kind.results[result][1]}, {description}"))
    variables["status"] = (names, _texts([o.scalars.get("status", "FAILED") for o in table]), _texts_of("status"))
    variables["warnings"] = (names, _texts([o.scalars.get("warnings", "") for o in table]), _texts_of("warnings"))
    variables["error"] = (names, _texts([o.error for o in table]), _texts_of("error"))
    variables = {
        name: (dims, values.reshape(plan.shape), attrs)
        for name, (dims, values, attrs) in variables.items()
        if name not in coordinates and name not in fixed
    }
    if plan.fields:
        angles, fields = _fields(plan, table)
        coordinates |= angles
        variables |= fields
    return xarray.Dataset(variables, coordinates | fixed, attrs=_provenance(plan) | {"statuses": _counted(table)})


def _fields(plan: Plan, table: list[Outcome]) -> tuple[dict[str, Any], dict[str, Any]]:
    """Return coordinates and fields. Each window is centered in the largest one, with NaN around it."""
    windows = [next(iter(outcome.fields.values())).shape[-2:] for outcome in table if outcome.fields]
    # The lowest point is node count // 2 of every window: there is at most one more node on one side than on the other.
    rows, columns = (max((window[axis] for window in windows), default=1) for axis in (0, 1))
    names = [dimension.name for dimension in plan.dimensions]
    coordinates = _angles(table, rows, columns)
    variables: dict[str, Any] = {}
    for name in plan.fields:
        is_vector = name in VECTOR_FIELDS
        unit, description = (VECTOR_FIELDS if is_vector else FIELDS)[name]
        values = np.full((len(table), *((2,) if is_vector else ()), rows, columns), np.nan)
        for i, outcome in enumerate(table):
            if outcome.fields:
                _insert_centered(values[i], outcome.fields[name])
        dims = [*names, *(["direction"] if is_vector else []), "phi", "theta"]
        variables[name] = (dims, values.reshape(*plan.shape, *values.shape[1:]), _attributes(unit, description))
        if is_vector:
            coordinates["direction"] = (["direction"], np.array(["x", "z"], dtype=object))
    return coordinates, variables


def _angles(table: list[Outcome], rows: int, columns: int) -> dict[str, Any]:
    """Return the angles of the nodes if all points have the same spacing, else node numbers from the lowest point."""
    angles: dict[str, Any] = {}
    for name, count, prefix in (("phi", rows, ""), ("theta", columns, "theta_")):
        numbers = np.arange(count) - count // 2
        nodes = {outcome.scalars[f"{prefix}nodes_per_revolution"] for outcome in table if outcome.fields}
        if len(nodes) == 1:
            values = 0.5 * np.pi + 2.0 * np.pi / float(nodes.pop() or np.nan) * numbers
            angles[name] = ([name], values, _attributes("rad", name))
        else:
            angles[name] = ([name], numbers, _attributes("1", "number of nodes from the lowest point"))
    return angles


def _insert_centered(whole: NDArray[np.float64], part: NDArray[np.float64]) -> None:
    first = [n // 2 - m // 2 for n, m in zip(whole.shape[-2:], part.shape[-2:], strict=True)]
    whole[..., first[0] : first[0] + part.shape[-2], first[1] : first[1] + part.shape[-1]] = part


def _counted(table: list[Outcome]) -> str:
    counts = Counter(str(outcome.scalars.get("status", "FAILED")) for outcome in table)
    return ", ".join(f"{count} {status}" for status, count in counts.items())


def _unit(plan: Plan, unit: str | None) -> str | None:
    """Return the unit of a parameter in the plan's type of contact, or None if it has no unit."""
    return None if unit is None else unit_in_contact(unit, line_contact=plan.line_contact)


def _provenance(plan: Plan) -> dict[str, str]:
    bodies = plan.bodies()
    cases = [case for case in plan.cases if isinstance(case, LoadCase)]
    pairs = list({(id(case.body), id(on := case.arguments.get("on"))): (case.body, on) for case in cases}.values())
    if plan.kind is ROLLING:
        title = f"rolling resistance of a coated {' or '.join(sorted(set(map(_kind, bodies))))}"
        layered = bodies
    else:
        title = "friction of a rough surface that slides"
        layered = [on for _, on in pairs]
    attributes = {
        "title": title,
        "source": f"viscoroll {__version__}",
        "version": __version__,
        "commit": __commit__,
        "python": sys.version.split()[0],
        "created": datetime.datetime.now(datetime.UTC).isoformat(timespec="seconds"),
        "mesh": _mesh_text(cases),
        "material": _joined(list(dict.fromkeys(material for body in layered for material in _materials(body)))),
        plan.kind.noun: _joined([_parameters(body) for body in bodies]),
    }
    if counts := {len(case.draws) for case in cases} - {0}:
        attributes |= {"draws": f"{max(counts)}, {plan.method}", "confidence": repr(plan.confidence)}
    if is_body(other := plan.fixed.get("on")) and other.curved_directions == 2:
        attributes |= {"other_ball": _parameters(other), "other_radius": repr(other.surface)}
    if doubt := next(filter(None, (_unit_doubt(body, on) for body, on in pairs)), ""):
        attributes["unit_hint"] = doubt
    varied = {dimension.name for dimension in plan.dimensions}
    for name in sorted(plan.kind.arguments - {"mesh"} - varied):
        if name in plan.fixed and not isinstance(plan.fixed[name], int | float):
            attributes[name] = label(plan.fixed[name])
    if callable(plan.fixed.get("on")):
        kinds = {type(case.arguments["on"]).__name__ for case in cases}
        attributes["on"] = f"{' or '.join(sorted(kinds))}({attributes['on']})"
    return attributes | {"inputs": json.dumps(plan.identity(), ensure_ascii=False)}


def _kind(body: RollingBody) -> str:
    return type(body).__name__.removeprefix("Coated").lower()


def _materials(body: RollingBody | CoatedPlane) -> list[str]:
    base = getattr(body, "base", None)
    layers = [*body.layers, *([] if base is None else [base])]
    return [_clean(layer.shear_modulus) for layer in layers]


def _unit_doubt(body: RollingBody | RoughSurface, on: Counterbody | None) -> str:
    if isinstance(body, RoughSurface):
        return "" if on is None else unit_doubt(on)
    return unit_doubt(body, on)


def _parameters(body: RollingBody | Counterbody | RoughSurface) -> str:
    if isinstance(body, RoughSurface):
        return repr(body)
    values = {parameter.name: getattr(body, parameter.name) for parameter in fields(body)}
    return ", ".join(f"{name}={v.name if isinstance(v, Enum) else _clean(v)}" for name, v in values.items())


def _mesh_text(cases: list[LoadCase]) -> str:
    shapes = {case.body.heights.shape for case in cases if isinstance(case.body, RoughSurface)}
    if shapes:
        return "varies" if len(shapes) > 1 else " x ".join(str(count) for count in shapes.pop())
    meshes = {case.arguments.get("mesh") for case in cases}
    if len(meshes) > 1:
        return "varies, see nodes_per_revolution, theta_nodes_per_revolution, max_order"
    mesh = next(iter(meshes), None)
    if mesh is None:
        return "chosen for each point, see nodes_per_revolution"
    return str(mesh)


def _joined(texts: list[str], *, most: int = 8) -> str:
    more = f"; and {len(texts) - most} more" if len(texts) > most else ""
    return "; ".join(texts[:most]) + more


def _clean(value: object) -> str:
    """Return the text of a value without memory addresses."""
    text = repr(value)
    return text if " at 0x" not in text else " ".join(p for p in text.replace(">", "").split() if "0x" not in p)


def _attributes(unit: str | None, description: str) -> dict[str, str]:
    return ({"units": unit} if unit is not None else {}) | {"long_name": description}


def _spelled(name: str) -> str:
    return name.replace("_", " ")


def _texts(values: list[Any]) -> NDArray[np.object_]:
    return np.array(values, dtype=object)


def _texts_of(name: str) -> dict[str, str]:
    return {"long_name": _TEXTS[name]}
