"""Search for the steady states of self-heating, and for the folds at which they end."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from .._core import ConvergenceError
from .._support.errors import Range
from .._support.progress import Report
from .._support.quantities import quantity_text
from .._support.result_warnings import silenced
from .._support.units import UNITS
from ..bodies import RollingBody
from ..materials.shift import Shift, scaled, shift_factor, shifted
from ..rolling import solve
from ..solution.loss import default_max_order
from ..thermal.temperature import Temperature, temperature
from .softening import strain_softening
from .softening_result import NetworkLoss, StrainSoftening
from .softening_search import softens

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from ..rolling import Result

__all__ = ["Fold", "StateSearch", "SteadyState"]

#: The search sums the loss up to the order 12 r_o/a; these orders contain 0.999 of the loss.
_ORDERS_PER_CONTACT = 12.0
_PROFILE_STEPS = 4  # largest number of iterations of the differences between layer temperatures and their mean

#: Smallest and largest temperature rise, divided by the rise at `limit`, and number of rises in the search for a fold.
_FOLD_RISES = (3e-3, 1.0, 16)
#: Largest number of steps by a factor of 2 from the given load or speed, in the search for a fold and otherwise.
_FOLD_REACH, _REACH = 12, 60


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class SteadyState:
    """Steady state in which the surfaces remove as much heat as rolling dissipates.

    Attributes
    ----------
    mean_temperature : float
        Mean temperature of the layers, weighted by the loss [K].
    layer_temperatures : tuple of float
        Temperatures at which the modulus of each layer is evaluated [K]; with `sublayers`, of each part of a layer.
    result : Result
        Contact, solved with the moduli at these temperatures.
    temperature : Temperature
        Temperature field of the body, as a rise over the surroundings.
    stable : bool
        Whether a small increase in temperature decays.
    softening : StrainSoftening or None
        Strain and moduli of the layers that soften with strain; None without such layers.
    """

    mean_temperature: float
    layer_temperatures: tuple[float, ...]
    result: Result
    temperature: Temperature
    stable: bool
    softening: StrainSoftening | None = None

    def __repr__(self) -> str:
        """Return a summary in one line."""
        kind = "stable" if self.stable else "unstable"
        torque = quantity_text(self.result.resisting_torque, self.result.unit("resisting_torque"))
        return (
            f"SteadyState({kind}, mean {self.mean_temperature:.2f} K, at most "
            f"{self.temperature.ambient + self.temperature.maximum:.2f} K, T_r = {torque})"
        )


@dataclass(frozen=True, slots=True, kw_only=True)
class Fold:
    """Load or speed at which the coldest stable state merges with an unstable state; above it, neither exists.

    Attributes
    ----------
    load : float
        Load [N], for rollers [N/m].
    angular_speed : float
        Angular speed Ω [rad/s].
    mean_temperature : float
        Mean temperature of the layers, weighted by the loss [K].
    maximum : float
        Largest temperature in the layers [K].
    strain : float
        Penetration divided by thickness [-]; above 0.2 linear theory is inaccurate.
    """

    load: float
    angular_speed: float
    mean_temperature: float
    maximum: float
    strain: float


@dataclass(frozen=True, slots=True)
class _Point:
    """Solution with the moduli at an assumed mean temperature.

    `excess` is the resulting mean temperature minus the assumed one [K]; it is 0 in a steady state.
    """

    excess: float
    layer_temperatures: tuple[float, ...]
    result: Result
    temperature: Temperature
    softening: StrainSoftening | None


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class StateSearch:
    """Search for steady states; stores the solution at each mean temperature, speed and load."""

    body: RollingBody
    shifts: list[Shift]
    vertical: Shift | None
    load: float
    angular_speed: float
    ground_speed: float | None
    softening: NetworkLoss
    thermal: dict[str, Any]
    options: dict[str, Any]
    ambient: float
    limit: float
    find_root: Callable[..., float]
    points: dict[tuple[float, float, float], _Point]

    def at(self, mean: float, *, angular_speed: float | None = None, load: float | None = None) -> _Point:
        """Return contact and temperature with the moduli at a mean temperature.

        Iteration determines the differences between the layer temperatures and their mean.
        """
        speed = self.angular_speed if angular_speed is None else angular_speed
        force = self.load if load is None else load
        key = (mean, speed, force)
        if key in self.points:
            return self.points[key]
        profile = np.zeros(len(self.body.layers))
        for _ in range(_PROFILE_STEPS if len(self.body.layers) > 1 else 1):
            temperatures = mean + profile
            result, soft = self._solved(self._heated(temperatures), force, speed)
            found = temperature(
                result, of="body", **self.thermal, max_order=default_max_order(result, _ORDERS_PER_CONTACT)
            )
            next_profile = np.array(found.layer_means) - found.mean
            converged = np.abs(next_profile - profile).max() < 1e-3 * max(found.maximum, 1e-9)
            profile = next_profile
            if converged:
                break
        point = _Point(self.ambient + found.mean - mean, tuple(temperatures.tolist()), result, found, soft)
        self.points[key] = point
        return point

    def _solved(self, body: RollingBody, load: float, speed: float) -> tuple[Result, StrainSoftening | None]:
        """Return the contact of a body; layers that soften have the moduli at the strain of the solution."""
        if not softens(body, self.options.get("on")):
            return solve(body, load=load, **self._as_given(speed), **self.options), None
        soft = strain_softening(body, load=load, **self._as_given(speed), loss=self.softening, **self.options)
        return soft.result, soft

    def _as_given(self, angular_speed: float) -> dict[str, Any]:
        """Return an angular speed as an argument of `solve`: as the speed of the ground if that was given."""
        if self.ground_speed is None:
            return {"angular_speed": angular_speed}
        return {"speed": self.ground_speed * (angular_speed / self.angular_speed)}

    def _heated(self, temperatures: NDArray[np.float64]) -> RollingBody:
        """Return the body with the moduli at given layer temperatures."""
        layers = []
        for layer, shift, kelvin in zip(self.body.layers, self.shifts, temperatures.tolist(), strict=True):
            modulus = shifted(layer.shear_modulus, shift_factor(shift, kelvin))
            if self.vertical is not None:
                modulus = scaled(modulus, shift_factor(self.vertical, kelvin, "vertical_shift"))
            layers.append(replace(layer, shear_modulus=modulus))
        return replace(self.body, layers=layers)

    def sweep(self, count: int, report: Report | None) -> tuple[list[tuple[float, float]], list[float]]:
        """Return pairs of mean temperatures between which the excess changes sign, and temperatures with excess 0."""
        # The rises are spaced logarithmically from a thousandth of the range, to resolve states with small rises.
        rises = (self.limit - self.ambient) * np.geomspace(1e-3, 1.0, count)
        grid = [self.ambient, *(self.ambient + rises).tolist()]
        excess = []
        for number, mean in enumerate(grid):
            excess.append(self.at(mean).excess)
            if report is not None:
                report("temperatures", (number + 1) / len(grid))
        grid, excess = self._with_turning_points(grid, excess)
        pairs = zip(grid[:-1], grid[1:], excess[:-1], excess[1:], strict=True)
        return (
            [(low, high) for low, high, a, b in pairs if a * b < 0.0],
            [mean for mean, value in zip(grid, excess, strict=True) if value == 0.0],
        )

    def _with_turning_points(self, grid: list[float], excess: list[float]) -> tuple[list[float], list[float]]:
        """Add extrema of the excess close to 0 between points of equal sign: two states may be next to them."""
        points: dict[float, float] = dict(zip(grid, excess, strict=True))
        for i in range(1, len(grid) - 1):
            before, middle, after = excess[i - 1 : i + 2]
            toward_zero = (middle - before) * middle < 0.0 and (after - middle) * middle > 0.0
            if not toward_zero or before * middle <= 0.0 or middle * after <= 0.0:
                continue
            curve = np.polynomial.Polynomial.fit(grid[i - 1 : i + 2], [before, middle, after], 2)
            extremum = float(curve.deriv().roots().real[0])
            if abs(curve(extremum)) < 0.3 * abs(middle) or curve(extremum) * middle < 0.0:
                points[extremum] = self.at(extremum).excess
        ordered = sorted(points.items())
        return [mean for mean, _ in ordered], [value for _, value in ordered]

    def state(self, low: float, high: float) -> SteadyState:
        """Return the steady state between two mean temperatures, with a relative tolerance of 1e-4 on the rise."""
        ends = (low - self.ambient, high - self.ambient)
        rise = self.find_root(lambda rise: self.at(self.ambient + rise).excess, *ends, xtol=1e-6, rtol=1e-4)
        mean = self.ambient + rise
        point = self.at(mean)
        return SteadyState(
            mean_temperature=mean,
            layer_temperatures=point.layer_temperatures,
            result=point.result,
            temperature=point.temperature,
            softening=point.softening,
            stable=self.at(high).excess <= self.at(low).excess,
        )

    def speed_at(self, mean: float, *, near: float | None = None, reach: int = _REACH) -> float:
        """Return the speed that has a steady state with a given mean temperature.

        Heat at a given temperature increases with speed, so that the speed is unique.
        """
        first = self.angular_speed if near is None else near
        return self._root(mean, first, lambda speed: self.at(mean, angular_speed=speed), "speed", reach)

    def load_at(self, mean: float, *, near: float | None = None, reach: int = _REACH) -> float:
        """Return the load that has a steady state with a given mean temperature.

        Heat at a given temperature increases with load, so that the load is unique.
        """
        first = self.load if near is None else near
        return self._root(mean, first, lambda load: self.at(mean, load=load), "load", reach)

    def _root(self, mean: float, first: float, at: Callable[[float], _Point], name: str, reach: int) -> float:
        """Return the load or speed at which the excess is 0, by steps of a factor of 2 from the first one."""
        if not mean > self.ambient:
            raise Range(self.ambient, unit="K", excludes_minimum=True).error("temperatures", f"{mean:g} K")

        def excess(logarithm: float) -> float:
            return at(float(np.exp(logarithm))).excess

        low = high = float(np.log(first))
        warming = excess(low) > 0.0
        for _ in range(reach):
            low, high = (low - 0.7, low) if warming else (high, high + 0.7)
            if (excess(low if warming else high) > 0.0) != warming:
                return float(np.exp(self.find_root(excess, low, high, xtol=1e-4)))
        raise ConvergenceError(f"no {name} has a steady state at {mean:g} K")

    def fold(self, name: Literal["load", "speed"]) -> Fold | None:
        """Return the fold: the first maximum, over mean temperatures, of the load or speed with that steady state."""
        from scipy.optimize import minimize_scalar

        rises: list[float] = []
        values: list[float] = []

        def found_at(mean: float) -> float:
            near = values[-1] if values else None
            return (self.load_at if name == "load" else self.speed_at)(mean, near=near, reach=_FOLD_REACH)

        with silenced():
            for rise in (self.limit - self.ambient) * np.geomspace(*_FOLD_RISES):
                try:
                    values.append(found_at(self.ambient + rise))
                except (ValueError, ConvergenceError):  # no load that the layers support, or no speed
                    return None
                rises.append(float(rise))
                if len(values) > 2 and values[-2] >= max(values[-3], values[-1]):
                    break
            else:
                return None
            ends = (np.log(rises[-3]), np.log(rises[-1]))
            best = minimize_scalar(
                lambda x: -found_at(self.ambient + float(np.exp(x))),
                bounds=ends,
                method="bounded",
                options={"xatol": 3e-3},
            )
            mean = self.ambient + float(np.exp(best.x))
            load, speed = (-float(best.fun), self.angular_speed) if name == "load" else (self.load, -float(best.fun))
            point = self.at(mean, load=load, angular_speed=speed)
        return Fold(
            load=load,
            angular_speed=speed,
            mean_temperature=mean,
            maximum=self.ambient + point.temperature.maximum,
            strain=point.result.strain or 0.0,
        )

    def no_state_message(self) -> str:
        """Return the message that there is no steady state, with the largest speed that has one."""
        rises = (self.limit - self.ambient) * np.geomspace(0.03, 1.0, 8)
        speeds = [self.speed_at(self.ambient + rise) for rise in rises]
        best = int(np.argmax(speeds))
        name = "angular_speed" if self.ground_speed is None else "speed"
        largest, given = (self._as_given(speed)[name] for speed in (speeds[best], self.angular_speed))
        unit = UNITS[name]
        return (
            f"{name} must be at most about {largest:.3g} {unit} for a steady temperature below "
            f"{self.limit:g} K ({self.ambient + rises[best]:.4g} K at that speed), got {given:g} {unit}: "
            "rolling dissipates more heat than the surfaces remove"
        )
