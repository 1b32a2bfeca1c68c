"""Relations that hold in any solution."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np
import viscoroll as vr
from numpy.typing import NDArray
from viscoroll import enums

from .bodies import curvature, deforms
from .cases import Case

__all__ = ["depth_of", "violations"]

#: The solver stops at residuals of 1e-8; conditions at single nodes are allowed a hundred times as much.
TOLERANCE = 1e-6


def violations(case: Case, result: vr.Result) -> dict[str, float]:
    """Return the conditions that a solution violates, each with its error relative to the tolerance."""
    if not _is_finite(result):
        return {"not finite": math.inf}
    checks = (_contact, _status, _powers, _pair, _symmetry, *((_friction, _drive) if case.has_friction else ()))
    errors = {name: error / TOLERANCE for check in checks for name, error in check(case, result)}
    return {name: error for name, error in errors.items() if not error <= 1.0}


def _is_finite(result: vr.Result) -> bool:
    given = {"friction"}  # infinite for full stick
    scalars = [v for name, v in result.scalars().items() if isinstance(v, float) and name not in given]
    arrays = (result.pressure, result.gap, result.displacement, result.shear_traction, result.slip_velocity)
    return all(math.isfinite(value) for value in scalars) and all(np.isfinite(array).all() for array in arrays)


def _areas(result: vr.Result) -> NDArray[np.float64]:
    """Return the areas on which tractions act [m²], for a roller per length [m]."""
    radius = result.body.outer_radius
    if isinstance(result.body, vr.CoatedCylinder):
        return np.full(result.z.shape, radius * result.mesh.spacing)
    # the columns of a wheel end at its faces
    if isinstance(result.body, vr.CoatedWheel):
        return np.full(result.z.shape, radius * result.mesh.spacing * abs(result.z[0, 1] - result.z[0, 0]))
    flat = radius**2 * result.mesh.spacing * result.mesh.theta_spacing
    # the nodes lie between both bodies, on a paraboloid
    if deforms(result.on):
        return np.full(result.z.shape, flat)
    if result.patch_load is enums.PatchLoad.FLAT and result.curvature is not enums.Curvature.EXACT:
        return np.full(result.z.shape, flat)
    return flat * np.sqrt(1.0 - (result.z / radius) ** 2)


def depth_of(result: vr.Result) -> float:
    """Return the approach of the bodies [m]; on a half-plane, which has no datum, the depth of the contact's arc."""
    if result.penetration is None:
        return _arm(result) ** 2 / (2.0 * result.body.outer_radius)
    return result.penetration + result.centrifugal_displacement


def _contact(case: Case, result: vr.Result) -> Iterator[tuple[str, float]]:
    depth = depth_of(result)
    peak = float(result.pressure.max())
    inside, outside = result.contact, ~result.contact
    yield "pressure < 0", -float(result.pressure.min()) / peak
    yield "gap < 0", -float(result.gap.min()) / depth
    yield "gap in contact", float(np.abs(result.gap[inside]).max(initial=0.0)) / depth
    yield "pressure outside contact", float(result.pressure[outside].max(initial=0.0)) / peak
    yield "load balance", abs(float((result.pressure * _areas(result)).sum()) / result.load - 1.0)
    yield "penetration <= 0", 0.0 if depth > 0.0 else 1.0
    yield "penetration >= thickness", 0.0 if (result.penetration or 0.0) < case.thickness else 1.0


def _status(case: Case, result: vr.Result) -> Iterator[tuple[str, float]]:
    accuracy = case.arguments.get("accuracy")
    consistent = {
        enums.Status.CONVERGED: accuracy is None or result.error_estimate <= accuracy,
        enums.Status.ACCURACY_NOT_REACHED: accuracy is not None and result.error_estimate > accuracy,
    }
    yield "iteration limit reached", float(result.status is enums.Status.MAX_ITERATIONS)
    yield "status contradicts error estimate", float(not consistent.get(result.status, True))
    yield "residual", result.residual


def _friction(case: Case, result: vr.Result) -> Iterator[tuple[str, float]]:
    slip, stick = result.slip, result.stick
    speed = np.hypot(*result.slip_velocity)
    fastest = max(float(speed.max()), _slip_of_the_shape(result))
    yield "slip of sticking nodes", float(speed[stick].max(initial=0.0)) / fastest
    yield "stick and slip", float(np.any((stick & slip) | ((stick | slip) != result.contact)))
    if math.isinf(result.friction):
        yield "slip in full stick", float(slip.any())
        return
    traction = np.hypot(*result.shear_traction)
    limit = result.friction * result.pressure
    peak = float(limit.max())
    against = np.sum(result.shear_traction * result.slip_velocity, axis=0) / fastest
    # The direction of a slow slip is lost in round-off, so it has a small weight: |t| |S| + t . S, which is 0 if
    # opposite.
    yield "traction > friction", float((traction - limit).max()) / peak
    yield "slip below the limit", float((limit - traction)[slip].max(initial=0.0)) / peak
    yield "slip not opposite to traction", float((traction * speed / fastest + against)[slip].max(initial=0.0)) / peak


def _slip_of_the_shape(result: vr.Result) -> float:
    """Return the slip [m/s] due to the ball's curvature alone, as the scale of small slips."""
    arm = _arm(result) / result.body.outer_radius
    return result.angular_speed * result.body.outer_radius * arm**2


def _arm(result: vr.Result) -> float:
    """Return the half length of the contact [m], for a single node the spacing."""
    return max(result.semi_axis_x, result.mesh.spacing * result.body.outer_radius)


def _drive(case: Case, result: vr.Result) -> Iterator[tuple[str, float]]:
    drive = result.drive
    area = _areas(result)
    force = -float((result.shear_traction[0] * area).sum())
    bound = min(result.friction, 1.0) * result.load
    # otherwise the force also depends on slopes under the pressure
    if not deforms(case.on):
        # a track that rises ahead of the pressure resists
        force -= curvature(case.on) * result.resisting_torque
        yield "driving force", abs(force - result.driving_force) / bound
    if drive.force is not None:
        yield "force balance", abs(result.driving_force - drive.force) / bound
    if drive.torque is not None:
        yield "torque balance", abs(result.driving_torque - drive.torque) / (bound * result.body.outer_radius)
    if drive.creepage is not None:
        assert result.creepage is not None
        yield "creepage", abs(result.creepage - drive.creepage) / max(abs(drive.creepage), 1e-6)


def _powers(case: Case, result: vr.Result) -> Iterator[tuple[str, float]]:
    rolling = result.load * _arm(result) * result.angular_speed
    yield "power gained in the coating", -result.bulk_power / rolling
    yield "power gained by slip", -result.slip_power / rolling
    if all(isinstance(layer.shear_modulus, vr.Elastic) for layer in case.materials):
        yield "power dissipated in an elastic coating", abs(result.bulk_power) / rolling


def _pair(case: Case, result: vr.Result) -> Iterator[tuple[str, float]]:
    """Check that both bodies receive the power that they dissipate: in total, and without friction each one.

    The tolerance of the moment of the pressure is a moment arm of one spacing. The relative tolerance of a dissipated
    power is that of one node in the half length of the contact.
    """
    if case.on is None:
        return
    radius, bend = result.body.outer_radius, curvature(case.on)
    spacing = result.mesh.spacing * radius
    rolling = result.angular_speed * radius
    speed = rolling if result.linear_speed is None else result.linear_speed
    # A rotating counterbody has its own moment arm; a deformable track receives its loss by a force, the moment /
    # radius.
    is_soft_track = isinstance(case.on, vr.CoatedPlane | vr.Groove) and deforms(case.on)
    turning = abs(speed) * max(abs(bend), 1.0 / radius if is_soft_track else 0.0)
    levers = result.load * spacing * np.array([result.angular_speed, turning])
    losses = np.array([result.rolling_bulk_power, result.counterbody_bulk_power])
    share = min(spacing / _arm(result), 1.0)
    height = radius if result.center_height is None else result.center_height
    own = result.driving_torque * result.angular_speed
    others = (bend * (result.driving_torque + result.driving_force * height) + result.driving_force) * speed
    drive = result.drive
    guided = (result.lateral_force * drive.lateral_creepage + result.spin_moment * drive.spin) * rolling
    unknown = float(levers.sum()) + share * result.dissipated_power
    yield "total power of a pair", TOLERANCE * abs(own + others - guided - result.dissipated_power) / unknown
    if not case.has_friction:
        first, other = levers + share * losses.sum()
        yield "power of the rolling body", TOLERANCE * abs(own - losses[0]) / first
        yield "power of the counterbody", TOLERANCE * abs(others - losses[1]) / other if other > 0.0 else 0.0


def _symmetry(case: Case, result: vr.Result) -> Iterator[tuple[str, float]]:
    """Check that both sides agree without lateral creepage and spin."""
    if result.drive.lateral_creepage or result.drive.spin:
        return
    peak = float(result.pressure.max())
    forward, sideways = result.shear_traction
    yield "symmetry of pressure", float(np.abs(result.pressure - result.pressure[:, ::-1]).max()) / peak
    if case.has_friction:
        limit = min(result.friction, 4.0) * peak
        yield "symmetry of forward traction", float(np.abs(forward - forward[:, ::-1]).max()) / limit
        yield "antisymmetry of lateral traction", float(np.abs(sideways + sideways[:, ::-1]).max()) / limit
