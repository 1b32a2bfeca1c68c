"""Operating points of a contact, and contact stiffness, for discrete-element codes."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, TypeAlias

import numpy as np

from .._support.arguments import Floats
from .._support.errors import InvalidInput, InvalidType
from .._support.text import shown
from ..coupled import StrainSoftening
from ..coupled.softening_result import BOUNDS
from ..rolling import Result
from .balls import Balls, balls_of, balls_of_study

if TYPE_CHECKING:
    import xarray

__all__ = ["ContactModel", "OperatingPoint", "Stiffness", "Style", "operating_points"]


@dataclass(frozen=True, slots=True, kw_only=True)
class OperatingPoint:
    """Steady rolling of a ball on a plane or on another ball, at one load and speed.

    Two balls rotate in opposite senses with the relative angular speed Ω_rel = V/R; on a plane Ω_rel = Ω. The codes
    apply equal and opposite torques to both balls. The total dissipated power is then correct; the force between the
    balls determines how it is divided between them.

    Attributes
    ----------
    balls : Balls
        Radii of the balls.
    load : float
        Normal load P [N].
    angular_speed : float
        Angular speed Ω of the first ball [rad/s].
    torque : float
        T, dissipated power divided by Ω_rel [N m].
    penetration : float
        Penetration δ [m].
    bounds : (float, float) or None
        For filled rubber, T with the loss of the network summed over harmonics, and T with a rate-independent
        network [N m]: T, which follows from the power, times the ratio of the resisting torques.
    """

    balls: Balls
    load: float
    angular_speed: float
    torque: float
    penetration: float
    bounds: tuple[float, float] | None = None

    @property
    def radius(self) -> float:
        """Radius R of the ball, or effective radius R₁R₂/(R₁+R₂) of two balls [m]."""
        return self.balls.radius

    @property
    def relative_speed(self) -> float:
        """Relative angular speed Ω_rel [rad/s]."""
        return self.angular_speed * (self.balls.radii[0] / self.radius)

    @property
    def coefficient(self) -> float:
        """Rolling friction coefficient T / (P R) [-]."""
        return self.torque / (self.load * self.radius)


@dataclass(frozen=True, slots=True, kw_only=True)
class Stiffness:
    """Two laws of the load as a function of penetration; the fit minimizes the relative error of the load.

    Attributes
    ----------
    hertz : float
        k of P = k √R δ^(3/2) [Pa], four thirds of the effective modulus E*.
    hooke : float
        k of P = k δ [N/m].
    hertz_error, hooke_error : float
        Largest relative error of the load over the points [-]; 0 for a single point.
    points : int
        Number of points.
    """

    hertz: float
    hooke: float
    hertz_error: float
    hooke_error: float
    points: int

    @property
    def effective_modulus(self) -> float:
        """Effective modulus E* of Hertz's law P = 4/3 E* √R δ^(3/2) [Pa]."""
        return 0.75 * self.hertz

    @classmethod
    def fitted(cls, points: list[OperatingPoint]) -> Stiffness:
        """Fit both laws to load and penetration of the points."""
        load = np.array([point.load for point in points])
        depth = np.array([point.penetration for point in points])
        root = math.sqrt(points[0].radius)
        hertz, hertz_error = _relative_fit(root * depth**1.5, load)
        hooke, hooke_error = _relative_fit(depth, load)
        return cls(hertz=hertz, hooke=hooke, hertz_error=hertz_error, hooke_error=hooke_error, points=len(points))


@dataclass(frozen=True, slots=True, kw_only=True)
class ContactModel:
    """Contact model of one code: its input lines, and the torque law that they imply.

    Attributes
    ----------
    lines : tuple of str
        Lines of the input.
    parameters : dict of str to float
        Numbers in the lines, by the names that the code uses.
    law : callable
        T(P, Ω_rel) [N m] that the code computes, for arrays of loads [N] and relative speeds [rad/s].
    torque_law : str
        Same law in words, with the radius to which it refers.
    source : str
        File or manual that defines the law.
    """

    lines: tuple[str, ...]
    parameters: dict[str, float]
    law: Callable[[Floats, Floats], Floats]
    torque_law: str
    source: str


#: Function that writes the input for one model of a code.
Style: TypeAlias = Callable[[OperatingPoint, Stiffness], ContactModel]


def operating_points(source: Result | StrainSoftening | xarray.Dataset) -> list[OperatingPoint]:
    """Return the operating points of a result, or of all points of a study that did not fail.

    Raises
    ------
    TypeError
        If `source` is neither a result nor a study.
    ValueError
        If the body is not a ball on a plane or ball, or the study has no points or varies anything but load and angular
        speed.
    """
    if not isinstance(source, Result | StrainSoftening) and not hasattr(source, "data_vars"):
        raise InvalidType(
            "source", "must be a viscoroll.Result, a StrainSoftening, or a study of viscoroll.sweep", shown(source)
        )
    bounds: list[list[float]] = []
    if isinstance(source, StrainSoftening):
        bounds, source = [[bound] for bound in source.torque_bounds], source.result
        bounds.append([source.resisting_torque])
    if isinstance(source, Result):
        balls = balls_of(source.body, source.on)
        assert source.penetration is not None
        columns = [[source.load], [source.angular_speed], [source.dissipated_power], [source.penetration]]
    else:
        balls = balls_of_study(source)
        names = ("load", "angular_speed", "dissipated_power", "penetration")
        arrays = np.broadcast_arrays(*(_over_all(source, name) for name in names))
        columns = [array.ravel().tolist() for array in arrays]
        if all(name in source for name in BOUNDS):
            torques = (_over_all(source, name) for name in (*BOUNDS, "resisting_torque"))
            bounds = [array.ravel().tolist() for array in np.broadcast_arrays(*torques)]
    speed_ratio = balls.radii[0] / balls.radius  # Ω_rel / Ω
    if not bounds:
        bounds = [[math.nan] * len(columns[0])] * 3
    points = []
    for p, w, q, d, harmonic, network, solved in zip(*columns, *bounds, strict=True):
        torque = q / (w * speed_ratio)
        both = None if math.isnan(solved) else (torque * harmonic / solved, torque * network / solved)
        if q > 0.0:
            points.append(
                OperatingPoint(balls=balls, load=p, angular_speed=w, torque=torque, penetration=d, bounds=both)
            )
    if not points:
        raise InvalidInput("source", "must have a point with dissipated power > 0 W", "none")
    return points


def _over_all(study: xarray.Dataset, name: str) -> Floats:
    return np.asarray(study[name].broadcast_like(study["dissipated_power"]).values, dtype=np.float64)


def _relative_fit(unit_load: Floats, load: Floats) -> tuple[float, float]:
    ratio = unit_load / load
    stiffness = float(ratio.sum() / (ratio**2).sum())
    return stiffness, float(np.abs(stiffness * ratio - 1.0).max()) if load.size > 1 else 0.0
