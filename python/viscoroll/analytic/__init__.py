"""Closed forms for comparison with the solver, each valid in a limit. The solver does not use them.

    >>> from viscoroll import StandardLinearSolid, analytic
    >>> rubber = StandardLinearSolid(instantaneous_modulus=6e6, relaxed_modulus=3e6, relaxation_time=0.125)
    >>> time = analytic.loss_time(rubber)
    >>> torque = analytic.low_speed_torque(load=100.0, angular_speed=1e-3, radius=21e-3, loss_time=time)
    >>> f"{torque * 1e3:.4f} mN m"
    '0.2625 mN m'

Contacts at rest: `hertz`, `hertz_ellipse`, `thin_compressible_layer`, `thin_incompressible_layer`. Resisting torques:
`low_speed_torque` with one of the times `loss_time`, `sphere_loss_time` and `brilliantov_poschel_time`;
`greenwood_tabor_torque` and `persson_torque`, also for crowned wheels; `winkler_torque` for a thin coating. For
rollers, per unit length: `hertz_line`, `thin_compressible_layer_line` and `thin_incompressible_layer_line` at rest,
`winkler_torque_line` for a thin coating, `hunter` on a half-plane, and the traction of `carter_force`. With adhesion:
`jkr`, `maugis`, `jkr_line` and `thin_adhesive_layer_line` at rest, and `adhesive_hunter` for a roller on a half-plane.
`applicable` returns the torques that are valid for a body. Loads and speeds may be arrays.

All quantities are in SI units, and all moduli are shear moduli unless a name says otherwise.
"""

from .adhesion import AdhesiveContact, jkr, jkr_line, maugis, thin_adhesive_layer_line
from .adhesive_hunter import AdhesiveRollingContact, adhesive_hunter
from .applicable import ClosedForm, applicable
from .contact import PointContact, hertz, thin_compressible_layer, thin_incompressible_layer
from .ellipse import EllipticContact, hertz_ellipse
from .half_space import greenwood_tabor_torque, persson_torque
from .hunter import HunterContact, hunter
from .line_contact import (
    LineContact,
    carter_force,
    hertz_line,
    thin_compressible_layer_line,
    thin_incompressible_layer_line,
)
from .low_speed import brilliantov_poschel_time, loss_time, low_speed_torque, sphere_loss_time
from .winkler import winkler_torque, winkler_torque_line

__all__ = [
    "AdhesiveContact",
    "AdhesiveRollingContact",
    "ClosedForm",
    "EllipticContact",
    "HunterContact",
    "LineContact",
    "PointContact",
    "adhesive_hunter",
    "applicable",
    "brilliantov_poschel_time",
    "carter_force",
    "greenwood_tabor_torque",
    "hertz",
    "hertz_ellipse",
    "hertz_line",
    "hunter",
    "jkr",
    "jkr_line",
    "loss_time",
    "low_speed_torque",
    "maugis",
    "persson_torque",
    "sphere_loss_time",
    "thin_adhesive_layer_line",
    "thin_compressible_layer",
    "thin_compressible_layer_line",
    "thin_incompressible_layer",
    "thin_incompressible_layer_line",
    "winkler_torque",
    "winkler_torque_line",
]
