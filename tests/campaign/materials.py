"""Random moduli of every kind, and the same moduli in other units."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import viscoroll as vr
from numpy.typing import NDArray
from viscoroll import enums

__all__ = ["Scaled", "Springpot", "draw_modulus", "modulus_at", "scaled_modulus"]


@dataclass(frozen=True, kw_only=True)
class Springpot:
    """A function of frequency unknown to the package: G + K (iωτ)^α with a loss that ends at low frequency."""

    modulus: float
    stiffness: float
    time: float
    order: float

    def __call__(self, omega: NDArray[np.float64]) -> NDArray[np.complex128]:
        """Return the complex modulus [Pa] at angular frequencies [rad/s]."""
        return self.modulus + self.stiffness * (1j * omega * self.time) ** self.order


def draw_modulus(
    rng: np.random.Generator, modulus: float, time: float, speed: float
) -> vr.materials.ShearModulus | Springpot:
    """Return a modulus of a random kind.

    Parameters
    ----------
    rng : Generator
        Random numbers of the case.
    modulus : float
        Modulus at high frequency [Pa].
    time : float
        Time in which material crosses the contact [s]; the material's own times are a fraction or a multiple of it.
    speed : float
        Angular speed [rad/s], whose multiples a table must contain.
    """
    tau = time * 10.0 ** rng.uniform(-2.0, 2.0)
    relaxed = modulus * 10.0 ** -rng.choice([rng.uniform(0.05, 1.0), rng.uniform(1.0, 4.0)], p=[0.8, 0.2])
    kinds: list[Callable[[], vr.materials.ShearModulus | Springpot]] = [
        lambda: vr.Elastic(modulus=modulus),
        lambda: vr.StandardLinearSolid(instantaneous_modulus=modulus, relaxed_modulus=relaxed, relaxation_time=tau),
        lambda: _prony(rng, modulus, relaxed, tau),
        lambda: vr.materials.KelvinVoigt(modulus=modulus, viscosity=modulus * time * 10.0 ** rng.uniform(-3.0, 0.0)),
        lambda: vr.materials.FractionalZener(
            instantaneous_modulus=modulus, relaxed_modulus=relaxed, relaxation_time=tau, order=rng.uniform(0.2, 1.0)
        ),
        lambda: vr.materials.HavriliakNegami(
            instantaneous_modulus=modulus,
            relaxed_modulus=relaxed,
            relaxation_time=tau,
            order=rng.uniform(0.2, 1.0),
            asymmetry=rng.uniform(0.2, 1.0),
        ),
        lambda: _table(rng, modulus, relaxed, tau, speed),
        lambda: Springpot(
            modulus=modulus, stiffness=modulus * 10.0 ** rng.uniform(-2.0, 0.0), time=time, order=rng.uniform(0.1, 0.6)
        ),
    ]
    return kinds[rng.integers(len(kinds))]()


def _prony(rng: np.random.Generator, modulus: float, relaxed: float, tau: float) -> vr.Prony:
    terms = int(rng.integers(2, 6))
    weights = (1.0 - relaxed / modulus) * rng.dirichlet(np.ones(terms))
    times = tau * 10.0 ** rng.uniform(-2.0, 1.0, terms)
    return vr.Prony(
        instantaneous_modulus=modulus,
        weights=np.clip(weights, 1e-9, None).tolist(),
        relaxation_times=times.tolist(),
    )


def _table(rng: np.random.Generator, modulus: float, relaxed: float, tau: float, speed: float) -> vr.MasterCurve:
    """Return the measured curve of a fractional solid: few entries or many, with held ends or a sufficient range."""
    solid = vr.materials.FractionalZener(
        instantaneous_modulus=modulus, relaxed_modulus=relaxed, relaxation_time=tau, order=rng.uniform(0.3, 1.0)
    )
    held = bool(rng.integers(2))
    lowest, highest = (-2.0, 3.0) if held else (-1.0, 7.0)  # meshes have at most a million nodes
    count = int((highest - lowest) * rng.integers(3, 12)) + 1
    frequency = np.concatenate([[0.0], speed * np.logspace(lowest, highest, count)])
    values = solid.complex_modulus(frequency)
    extrapolation = enums.Extrapolation.HOLD if held else enums.Extrapolation.ERROR
    return vr.MasterCurve(frequency.tolist(), values.real.tolist(), values.imag.tolist(), extrapolation=extrapolation)


@dataclass(frozen=True, kw_only=True)
class Scaled:
    """A function of frequency in other units."""

    function: Callable[[Any], Any]
    stress: float
    time: float

    def __call__(self, omega: NDArray[np.float64]) -> NDArray[np.complex128]:
        """Return the complex modulus [Pa] at angular frequencies [rad/s]."""
        values: NDArray[np.complex128] = self.stress * self.function(self.time * omega)
        return values


def modulus_at(modulus: Any, frequency: float) -> complex:
    """Return the complex modulus [Pa] at an angular frequency [rad/s]."""
    omega = np.array([frequency])
    values = modulus.complex_modulus(omega) if isinstance(modulus, vr.materials.ShearModulus) else modulus(omega)
    return complex(values[0])


def scaled_modulus(modulus: Any, *, stress: float, time: float) -> Any:
    """Return the modulus with all stresses and all times multiplied."""
    match modulus:
        case vr.Elastic():
            return replace(modulus, modulus=stress * modulus.modulus)
        case vr.StandardLinearSolid() | vr.materials.FractionalZener() | vr.materials.HavriliakNegami():
            return replace(
                modulus,
                instantaneous_modulus=stress * modulus.instantaneous_modulus,
                relaxed_modulus=stress * modulus.relaxed_modulus,
                relaxation_time=time * modulus.relaxation_time,
            )
        case vr.Prony():
            return replace(
                modulus,
                instantaneous_modulus=stress * modulus.instantaneous_modulus,
                relaxation_times=time * np.asarray(modulus.relaxation_times),
            )
        case vr.materials.KelvinVoigt():
            return replace(modulus, modulus=stress * modulus.modulus, viscosity=stress * time * modulus.viscosity)
        case vr.MasterCurve():
            return replace(
                modulus,
                frequency=np.asarray(modulus.frequency) / time,
                storage=stress * np.asarray(modulus.storage),
                loss=stress * np.asarray(modulus.loss),
            )
        case _:
            return Scaled(function=modulus, stress=stress, time=time)
