"""Text of a result: printed summary, notebook table, and lines for other tables."""

from __future__ import annotations

from .._support.tables import handy, html_table, number_text, unit_text
from ..bodies.si_hints import unit_doubt
from .loss_spectrum import extrapolated_loss
from .scalars import SCALARS
from .solution import Solution

__all__ = ["result_html", "result_lines", "result_summary", "result_title", "result_warnings", "with_unit"]


def result_summary(result: Solution) -> str:
    """Return a summary that fits on one screen."""
    rows = [
        *_torque_rows(result),
        ("rolling resistance coefficient", f"{result.rolling_resistance_coefficient:.6g}"),
        ("driving torque T", _quantity(result, "driving_torque")),
        (
            "driving force Q, lateral force",
            f"{_quantity(result, 'driving_force')}, {_quantity(result, 'lateral_force')}",
        ),
        *_shape_rows(result),
        (
            "largest pressure",
            f"{result.max_pressure:.5g} Pa, relative error {result.max_pressure_error:.2g} (estimate)",
        ),
        *_friction_rows(result),
        ("power dissipated in the layers", _quantity(result, "bulk_power")),
        *_pair_rows(result),
        *_extrapolation_rows(result),
        *_error_rows(result),
        ("mesh", str(result.mesh)),
        ("nodes in contact", f"{int(result.contact.sum())} of {result.contact.size}"),
        ("effort", f"{result.iterations} iterations with {result.operator_applications} operator applications"),
        ("status", f"{result.status.name}, residual {result.residual:.1e}"),
        *(("warning", message) for message in result_warnings(result)),
    ]
    width = max(len(label) for label, _ in rows)
    model = f"{result.compliance.name} compliance, {result.curvature.name} curvature"
    head = f"Result of {_prescribed_text(result)} at Ω = {result.angular_speed:g} rad/s ({model})"
    return "\n".join([head, *(f"  {label:<{width}}  {value}" for label, value in rows)])


def result_warnings(result: Solution) -> list[str]:
    """Return the warnings of a result, with a hint if lengths or moduli are implausible in SI units."""
    return [*result.warnings.values(), *filter(None, [unit_doubt(result.body, result.on)])]


def result_lines(result: Solution) -> list[tuple[str, str]]:
    """Return the label of each scalar result with a convenient unit, and its value as text."""
    lines = []
    for label, value, unit in _scalar_rows(result):
        (text,), handy_unit = handy([value], unit)
        lines.append((with_unit(label.partition(",")[0], handy_unit), text))
    return lines


def with_unit(label: str, unit: str) -> str:
    """Return a label with its unit in brackets, if it has one."""
    return f"{label} [{unit}]" if unit_text(unit) else label


def result_title(result: Solution) -> str:
    """Return the input on one line."""
    return (
        f"{_prescribed_text(result)}, Ω = {result.angular_speed:g} rad/s, friction {result.friction:g}, "
        f"{result.compliance.name.lower()} compliance, {result.curvature.name.lower()} curvature"
    )


def _prescribed_text(result: Solution) -> str:
    """Return the given load or penetration with its unit."""
    symbol = "P" if result.prescribed == "load" else "penetration"
    return f"{symbol} = {getattr(result, result.prescribed):g} {result.unit(result.prescribed)}"


def result_html(result: Solution) -> str:
    """Return the table of the result for a notebook."""
    rows = [(label, number_text(value), unit_text(unit)) for label, value, unit in _scalar_rows(result)]
    rows += [("mesh", str(result.mesh), ""), ("status", result.status.name, "")]
    rows += [("warning", message, "") for message in result_warnings(result)]
    return html_table(f"Result of {result_title(result)}", rows)


def _scalar_rows(result: Solution) -> list[tuple[str, float | None, str]]:
    """Return label, value [SI] and unit of all scalar results."""
    absent = set() if result.face_distance is not None else {"face_distance"}  # only wheels have faces
    if _is_line_contact(result):
        absent |= {"contact_area", "semi_axis_x", "semi_axis_z", "contact_width"}  # its one dimension is the length
    if result.finite_strain_torque is None:
        absent |= {"overspeed", *(name for name in SCALARS if name.startswith("finite_strain_"))}
    rows = [
        (label, getattr(result, name), result.unit(name)) for name, (_, label) in SCALARS.items() if name not in absent
    ]
    if (extrapolated := extrapolated_loss(result)) is not None:
        rows.append(("share of the dissipated power at frequencies outside the measured table", extrapolated, "1"))
    return rows


def _is_line_contact(result: Solution) -> bool:
    return result.semi_axis_z is None


def _quantity(result: Solution, name: str) -> str:
    return f"{getattr(result, name):.6g} {result.unit(name)}"


def _torque_rows(result: Solution) -> list[tuple[str, str]]:
    """Return the torque nearest to reality, and that of linear theory."""
    linear = _quantity(result, "resisting_torque")
    if result.finite_strain_torque is None:
        return [("resisting torque T_r", linear)]
    error = f"relative error {result.finite_strain_torque_error:.2g} (estimate)"
    return [
        ("torque at finite strain", f"{_quantity(result, 'finite_strain_torque')}, {error}"),
        ("resisting torque T_r of linear theory", linear),
        ("overspeed of the surface in the contact", f"{result.overspeed:.3g}"),
        *(
            [("angular speed of the body", _quantity(result, "finite_strain_angular_speed"))]
            if result.finite_strain_angular_speed != result.angular_speed
            else []
        ),
    ]


def _shape_rows(result: Solution) -> list[tuple[str, str]]:
    penetration = "undetermined"
    if result.penetration is not None:
        penetration = f"{result.penetration:.6g} m, {result.strain:.1%} of the thickness"
    length = f"{result.contact_length:.5g} m, relative error {result.contact_length_error:.2g} (estimate)"
    rows = [("penetration", penetration), ("contact length along the path (nip length)", length)]
    if not _is_line_contact(result):
        rows.append(("contact semi-axes x, z", f"{result.semi_axis_x:.4g}, {result.semi_axis_z:.4g} m"))
    if result.prescribed == "penetration":
        rows.insert(0, ("normal load P", _quantity(result, "load")))
    if result.face_distance is not None:
        reached = "0 m (the contact reaches a face)" if result.face_distance == 0.0 else f"{result.face_distance:.4g} m"
        rows.append(("contact width, distance from the faces", f"{result.contact_width:.4g} m, {reached}"))
    return rows


def _error_rows(result: Solution) -> list[tuple[str, str]]:
    if result.model_error is None:
        return [("relative error of the mesh", f"{result.error_estimate:.2g} (estimate)")]
    errors = f"{result.error_estimate:.2g}, {result.model_error:.2g} (estimates)"
    return [("relative error of the mesh, of linear theory", errors)]


def _extrapolation_rows(result: Solution) -> list[tuple[str, str]]:
    extrapolated = extrapolated_loss(result)
    return [] if extrapolated is None else [("share outside the measured table", f"{extrapolated:.2%}")]


def _pair_rows(result: Solution) -> list[tuple[str, str]]:
    if result.on is None:
        return []
    powers = f"{_quantity(result, 'rolling_bulk_power')}, {_quantity(result, 'counterbody_bulk_power')}"
    return [("in the rolling body, in the counterbody", powers)]


def _friction_rows(result: Solution) -> list[tuple[str, str]]:
    if result.friction == 0.0:
        return []
    sticking = int(result.stick.sum()) / int(result.contact.sum())
    return [
        ("friction", f"{result.friction:g}, {sticking:.0%} of the nodes in contact stick"),
        ("creepage, speed of the center V_s", f"{result.creepage:.6g}, {_quantity(result, 'linear_speed')}"),
        ("power dissipated by slip", _quantity(result, "slip_power")),
    ]
