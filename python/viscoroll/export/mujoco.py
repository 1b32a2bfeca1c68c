"""Input for MuJoCo: a contact pair with rolling friction."""

from __future__ import annotations

from .._support.errors import InvalidInput
from .contact import ContactModel, OperatingPoint, Stiffness, Style

__all__ = ["STYLES"]

#: Smallest friction coefficient: MuJoCo raises smaller ones to this value (mjMINMU in mujoco.h) [m].
_SMALLEST = 1e-5


def _pair(point: OperatingPoint, stiffness: Stiffness) -> ContactModel:  # noqa: ARG001  (solref has its own stiffness)
    """Return a contact pair, which limits the rolling torque on each ball to ρ P, where ρ is a length.

    The coefficients of a pair are those of both tangential directions, torsion, and both rolling directions; a pair
    takes them as they are, whereas those of two geoms are combined by the larger value. The limit is an ellipse of
    force and torque, so the rolling torque is ρ P as long as the tangential force is far below its own limit. Friction
    is regularized: with the default solimp and a small ρ, the torque of a rolling ball stays below its limit, 30 % of
    it at ρ = 0.1 mm; with the values that are written here it is within 1 % (`export/test_dem.py`). Source: MuJoCo
    documentation, "Computation" (contact, friction cones, solver parameters) and the XML reference of contact/pair.
    """
    rho = point.torque / point.load
    if rho < _SMALLEST:
        raise InvalidInput(
            "code",
            f"must be another than mujoco for a rolling friction below {_SMALLEST:g} m, "
            "or the model in MuJoCo in smaller units of length",
            f"{rho:.3g} m",
        )
    other = "other" if point.balls.are_two else "floor"
    return ContactModel(
        lines=(
            '<option cone="elliptic" impratio="100"/>',
            "<contact>",
            f'  <pair geom1="ball" geom2="{other}" condim="6" solimp="0.9999 0.9999 0.001"',
            f'        friction="1 1 0.005 {rho!r} {rho!r}"/>',
            "</contact>",
        ),
        parameters={"rolling friction": rho},
        law=lambda load, speed: rho * load + 0.0 * speed,
        torque_law="T = rho P, where rho, the last two values of friction, is a length in m; the first three are yours",
        source="MuJoCo documentation, XML reference of contact/pair, and Computation, friction cones",
    )


STYLES: dict[str, Style] = {"pair": _pair}
