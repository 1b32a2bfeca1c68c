"""Results for many draws of the materials, linear in their moduli, with a frozen contact.

Draws differ in few directions. The deviations of all moduli from those of the result (storage and loss modulus, at rest
and at frequencies of the contact) are divided by their standard deviations and split into directions by a singular
value decomposition. The derivative along each direction is one solve of the frozen contact, so that the number of
solves is the number of directions, whatever the number of draws.
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
from ..materials.moduli import ShearModulusLike, to_core
from ..solution import Solution
from .frozen import FrozenContact
from .perturbed import Given, Place, bands_of, places_of

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["Pair", "propagated"]

#: Rolling body and counterbody.
Pair: TypeAlias = tuple[RollingBody, Counterbody | None]

#: Frequencies per decade at which draws are compared: as dense as the entries of measured tables.
_PER_DECADE = 10

#: Neglected fraction of the standard deviation of all deviations; relative deviation that counts as 0.
_LEFT_OUT = 0.01
_ALIKE = 1e-9

#: Largest relative change of a modulus in a difference quotient, whose error is half of this step times the curvature.
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
    here = Given.of(result)
    givens = [here, *(_drawn(here, draw) for draw in draws)]
    moduli = [_DrawnModulus.at(place, result, givens) for place in places_of(here)]
    features = np.hstack([modulus.features for modulus in moduli])
    contact = FrozenContact(result, answers, threads)
    contact.own_answers(here)

    def answers_with(share: Floats) -> Floats:
        given = here
        for modulus in moduli:
            if modulus.features.any():
                given = modulus.place.with_changed(given, shear_modulus=modulus.with_share(share))
        return contact.answers(given)

    values = np.tile([float(getattr(result, answer)) for answer in answers], (len(draws), 1))
    start = answers_with(np.zeros(len(draws)))  # a function, as below: the core sums both in the same way
    directions = list(_directions(features))
    for i, (score, share) in enumerate(directions):
        if progress is not None:
            progress("draws", i / len(directions))
        step = _STEP / float(np.abs(share @ features).max())
        values += np.outer(score, (answers_with(step * share) - start) / step)
    return values


def _directions(features: Floats) -> Iterator[tuple[Floats, Floats]]:
    """Yield the coordinates of the draws along a direction, and the weights of the draws that give it, largest first.

    Each feature is divided by its own standard deviation, so that features with a large scatter, as at frequencies
    without measurements, do not hide the others.
    """
    size = np.sqrt(np.mean(features**2, axis=0))
    if not (scattered := size > _ALIKE).any():
        return
    left, singular, _ = np.linalg.svd(features[:, scattered] / size[scattered], full_matrices=False)
    beyond = np.sqrt(np.cumsum(singular[::-1] ** 2)[::-1] / np.sum(singular**2))
    for i in range(int((beyond > _LEFT_OUT).sum())):
        yield left[:, i] * singular[i], left[:, i] / singular[i]


@dataclass(frozen=True, slots=True, eq=False)
class _DrawnModulus:
    """Modulus of one layer, with its draws.

    Attributes
    ----------
    place : Place
        Position of the layer.
    moduli : tuple
        Modulus of the result, followed by those of the draws.
    features : ndarray, shape (draws, features)
        Relative deviations of storage and loss modulus at rest and at frequencies of the contact [-].
    """

    place: Place
    moduli: tuple[ShearModulusLike, ...]
    features: Floats

    @classmethod
    def at(cls, place: Place, result: Solution, givens: Sequence[Given]) -> _DrawnModulus:
        """Return the modulus at a position of the input of a result, with its draws."""
        moduli = tuple(place.material(given).shear_modulus for given in givens)
        bands = bands_of(place.rolling_speed(result), result.mesh, _PER_DECADE)
        values = _values(moduli, np.concatenate([[0.0], bands.middles]))
        parts = np.hstack([values.real, values.imag])
        parts = parts[:, parts[0] > 0.0]
        return cls(place, moduli, parts[1:] / parts[0] - 1.0)

    def with_share(self, share: Floats) -> Callable[[Floats], NDArray[np.complex128]]:
        """Return the modulus of the result plus a weighted sum of the deviations of the draws."""

        def modulus(frequency: Floats) -> NDArray[np.complex128]:
            values = _values(self.moduli, frequency)
            return np.asarray(values[0] + share @ (values[1:] - values[0]))

        return modulus


def _drawn(given: Given, draw: Pair) -> Given:
    """Return the input with the bodies of a draw; raise a ValueError if they differ in more than shear moduli."""
    drawn = replace(given, body=draw[0], on=draw[1])
    restored, places = drawn, list(places_of(given))
    if len(places) == len(list(places_of(drawn))):
        for place in places:
            restored = place.with_changed(restored, shear_modulus=place.material(given).shear_modulus)
    if (restored.body, restored.on) != (given.body, given.on):
        raise InvalidInput(
            "draws",
            "must differ only in shear moduli for draws='linear'",
            f"{shown(draw)} for {shown((given.body, given.on))}",
        )
    return drawn


def _values(moduli: Sequence[ShearModulusLike], frequency: Floats) -> NDArray[np.complex128]:
    """Return the moduli at frequencies, one row per modulus [Pa]."""
    return np.array([_core.complex_modulus(to_core(modulus), frequency) for modulus in moduli])
