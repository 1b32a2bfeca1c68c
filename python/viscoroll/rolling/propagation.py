"""Results for many draws (samples) of uncertain moduli, to first order in the moduli, with a frozen contact.

The moduli of many draws usually vary along few independent directions. The deviations of all moduli from those of the
result (storage and loss modulus, at rest and at frequencies of the contact) are divided by their standard deviations. A
singular value decomposition then yields the directions. The derivative along each direction needs one solve of the
frozen contact, so that the number of solves does not depend on the number of draws.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, TypeAlias

import numpy as np

from .. import _core
from .._support.arguments import Floats
from .._support.errors import InvalidInput
from .._support.progress import Report
from .._support.text import shown
from ..bodies import Counterbody, RollingBody
from ..materials.modulus_like import ShearModulusLike, to_core
from ..solution import Solution
from .frozen import FrozenContact
from .perturbed import Given, MaterialPosition, bands_of, material_positions

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["Pair", "propagated"]

#: Rolling body and counterbody.
Pair: TypeAlias = tuple[RollingBody, Counterbody | None]

#: Number of frequencies per decade at which draws are compared: as many as measured tables usually have.
_PER_DECADE = 10

#: Fraction of the standard deviation of all deviations that the neglected directions may have.
_NEGLECTED = 0.01

#: Relative deviation of moduli below which the moduli count as equal.
_EQUAL = 1e-9

#: Largest relative change of a modulus in a forward difference quotient, whose error is half of this step times the
#: second derivative.
_STEP = 1e-4


def propagated(
    result: Solution,
    draws: Sequence[Pair],
    answers: Sequence[str],
    *,
    threads: int = 0,
    progress: Report | None = None,
) -> Floats:
    """Return scalars of a result for draws of its materials, to first order in their moduli.

    Parameters
    ----------
    result : Solution
        Result whose contact is frozen.
    draws : sequence of pairs
        Rolling body and counterbody of each draw; they differ from those of the result only in shear moduli.
    answers : sequence of str
        Names of scalars of the result.
    threads : int, default 0
        Number of threads; 0 for all cores.
    progress : callable, optional
        Called as progress(stage, fraction) before each solve; an exception that it raises ends the computation.

    Returns
    -------
    ndarray, shape (draws, answers)
        Scalars of each draw, in SI units.

    Raises
    ------
    ValueError
        If draws differ in more than shear moduli.
    ConvergenceError
        If the frozen contact does not reproduce the result, as in `Sensitivity`.
    """
    own = Given.of(result)
    givens = [own, *(_input_of_draw(own, draw) for draw in draws)]
    moduli = [_DrawnModulus.at(position, result, givens) for position in material_positions(own)]
    features = np.hstack([modulus.features for modulus in moduli])
    contact = FrozenContact(result, answers, threads)
    contact.own_values(own)

    def values_with(weights: Floats) -> Floats:
        given = own
        for modulus in moduli:
            if modulus.features.any():
                given = modulus.position.with_changed(given, shear_modulus=modulus.with_weights(weights))
        return contact.values(given)

    values = np.tile([float(getattr(result, answer)) for answer in answers], (len(draws), 1))
    # Here also, the moduli are Python functions: the core treats them like those below, so that its error cancels.
    start = values_with(np.zeros(len(draws)))
    directions = list(_directions(features))
    for i, (score, weights) in enumerate(directions):
        if progress is not None:
            progress("draws", i / len(directions))
        step = _STEP / float(np.abs(weights @ features).max())
        values += np.outer(score, (values_with(step * weights) - start) / step)
    return values


def _directions(features: Floats) -> Iterator[tuple[Floats, Floats]]:
    """Yield for each direction the coordinates of the draws along it, and the weights of the draws that form it.

    A direction is the sum of the deviations of the draws with these weights. The direction with the largest scatter
    comes first. Each feature is divided by its standard deviation, so that features with a large scatter, as at
    frequencies without measurements, do not dominate.
    """
    size = np.sqrt(np.mean(features**2, axis=0))
    if not (scattered := size > _EQUAL).any():
        return
    left, singular, _ = np.linalg.svd(features[:, scattered] / size[scattered], full_matrices=False)
    beyond = np.sqrt(np.cumsum(singular[::-1] ** 2)[::-1] / np.sum(singular**2))
    for i in range(int((beyond > _NEGLECTED).sum())):
        yield left[:, i] * singular[i], left[:, i] / singular[i]


@dataclass(frozen=True, slots=True, eq=False)
class _DrawnModulus:
    """Modulus of one layer, with its draws.

    Attributes
    ----------
    position : MaterialPosition
        Position of the layer.
    rolling_speed : float
        Lowest frequency of the load on the layer [rad/s].
    moduli : tuple
        Modulus of the result, followed by those of the draws.
    features : ndarray, shape (draws, features)
        Relative deviations of storage and loss modulus at rest and at frequencies of the contact [-].
    """

    position: MaterialPosition
    rolling_speed: float
    moduli: tuple[ShearModulusLike, ...]
    features: Floats

    @classmethod
    def at(cls, position: MaterialPosition, result: Solution, givens: Sequence[Given]) -> _DrawnModulus:
        """Return the modulus at a position, for the result (first of `givens`) and for the draws."""
        moduli = tuple(position.material(given).shear_modulus for given in givens)
        speed = position.rolling_speed(result)
        bands = bands_of(speed, result.mesh, _PER_DECADE)
        values = _values(moduli, speed, np.concatenate([[0.0], bands.centers]))
        parts = np.hstack([values.real, values.imag])
        parts = parts[:, parts[0] > 0.0]
        return cls(position, speed, moduli, parts[1:] / parts[0] - 1.0)

    def with_weights(self, weights: Floats) -> Callable[[Floats], NDArray[np.complex128]]:
        """Return the modulus of the result plus a weighted sum of the deviations of the draws."""

        def modulus(frequency: Floats) -> NDArray[np.complex128]:
            values = _values(self.moduli, self.rolling_speed, frequency)
            return np.asarray(values[0] + weights @ (values[1:] - values[0]))

        return modulus


def _input_of_draw(given: Given, draw: Pair) -> Given:
    """Return the input with the bodies of a draw; raise a ValueError if they differ in more than shear moduli."""
    drawn = replace(given, body=draw[0], on=draw[1])
    restored, positions = drawn, list(material_positions(given))
    if len(positions) == len(list(material_positions(drawn))):
        for position in positions:
            restored = position.with_changed(restored, shear_modulus=position.material(given).shear_modulus)
    if (restored.body, restored.on) != (given.body, given.on):
        raise InvalidInput(
            "draws",
            "must differ only in shear moduli for draws='linear'",
            f"{shown(draw)} for {shown((given.body, given.on))}",
        )
    return drawn


def _values(moduli: Sequence[ShearModulusLike], speed: float, frequency: Floats) -> NDArray[np.complex128]:
    """Return the moduli at frequencies, one row per modulus [Pa], when a body rolls at an angular speed [rad/s]."""
    return np.array([_core.modulus_in_rolling(to_core(modulus), speed, frequency) for modulus in moduli])
