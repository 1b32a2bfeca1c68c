"""What a result is for each of many draws of its materials: linear in their moduli, with the contact as it is.

Draws differ in few ways. Deviations of all moduli from those of the result, storage and loss at rest and at frequencies
of the contact, each by its standard deviation, are split by singular values into directions, and the derivative along
each is one solution of the kept contact: as many solves as there are ways to differ, however many draws.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, TypeAlias

import numpy as np

from .. import _core
from .._support.arguments import Floats
from .._support.progress import Report
from .._support.text import shown
from ..bodies import Counterpart, RollingBody
from ..materials.moduli import ShearModulusLike, to_core
from ..solution import Solution
from .kept import KeptContact
from .perturbed import Given, Place, bands_of, places_of

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["Pair", "propagated"]

#: What rolls, and what it rolls on.
Pair: TypeAlias = tuple[RollingBody, Counterpart | None]

#: Frequencies at which draws are told apart: as dense as the entries of measured tables are.
_PER_DECADE = 10

#: Share of the deviations' standard deviation that no direction is spent on; a relative one below which there is none.
_LEFT_OUT = 0.01
_ALIKE = 1e-9

#: Largest relative change of a modulus in a difference quotient, whose error is half of it times the curvature.
_STEP = 1e-4


def propagated(
    result: Solution,
    draws: Sequence[Pair],
    answers: Sequence[str],
    *,
    threads: int = 0,
    progress: Report | None = None,
) -> Floats:
    """Return answers of a result for draws of its materials, to first order in their moduli.

    Parameters
    ----------
    result : Solution
        A solution.
    draws : sequence of pairs
        What rolls, and what it rolls on, which differ from those of the result in shear moduli alone.
    answers : sequence of str
        Scalars that the result has.
    threads : int, default 0
        Number of threads; 0 for all cores.
    progress : callable, optional
        Called as progress(stage, fraction) after each solve; what it raises ends them.

    Returns
    -------
    ndarray, shape (draws, answers)
        In SI units.

    Raises
    ------
    ValueError
        For draws that differ in more than moduli.
    ConvergenceError
        As of `Sensitivity`: where the same input does not give the result back.
    """
    here = Given.of(result)
    givens = [here, *(_drawn(here, draw) for draw in draws)]
    moduli = [_DrawnModulus.at(place, result, givens) for place in places_of(here)]
    features = np.hstack([modulus.features for modulus in moduli])
    contact = KeptContact(result, answers, threads)
    contact.own_answers(here)

    def answers_with(share: Floats) -> Floats:
        given = here
        for modulus in moduli:
            if modulus.features.any():
                given = modulus.place.with_changed(given, shear_modulus=modulus.with_share(share))
        return contact.answers(given)

    values = np.tile([float(getattr(result, answer)) for answer in answers], (len(draws), 1))
    start = answers_with(np.zeros(len(draws)))  # a function like the others, which the core sums as it does them
    directions = list(_directions(features))
    for i, (score, share) in enumerate(directions):
        if progress is not None:
            progress("draws", i / len(directions))
        step = _STEP / float(np.abs(share @ features).max())
        values += np.outer(score, (answers_with(step * share) - start) / step)
    return values


def _directions(features: Floats) -> Iterator[tuple[Floats, Floats]]:
    """Yield how far each draw goes along a direction, and the shares of all draws that make it, the longest way first.

    Each feature is taken by its own scatter: a wide one where nobody measured hides no other.
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
    """The modulus of one layer, and its draws.

    Attributes
    ----------
    place : Place
        Whose it is.
    moduli : tuple
        That of the result, then of each draw.
    features : ndarray, shape (draws, features)
        Relative deviations of storage and loss at rest and at frequencies of the contact [-].
    """

    place: Place
    moduli: tuple[ShearModulusLike, ...]
    features: Floats

    @classmethod
    def at(cls, place: Place, result: Solution, givens: Sequence[Given]) -> _DrawnModulus:
        """Return what is at a place of the input of a result, and of draws of it."""
        moduli = tuple(place.material(given).shear_modulus for given in givens)
        bands = bands_of(place.rolling_speed(result), result.mesh, _PER_DECADE)
        values = _values(moduli, np.concatenate([[0.0], bands.middles]))
        parts = np.hstack([values.real, values.imag])
        parts = parts[:, parts[0] > 0.0]
        return cls(place, moduli, parts[1:] / parts[0] - 1.0)

    def with_share(self, share: Floats) -> Callable[[Floats], NDArray[np.complex128]]:
        """Return the modulus of the result with shares of the draws' deviations from it."""

        def modulus(frequency: Floats) -> NDArray[np.complex128]:
            values = _values(self.moduli, frequency)
            return np.asarray(values[0] + share @ (values[1:] - values[0]))

        return modulus


def _drawn(given: Given, draw: Pair) -> Given:
    """Return the input with the bodies of a draw; refuse what is not a draw of its moduli."""
    drawn = replace(given, ball=draw[0], on=draw[1])
    restored, places = drawn, list(places_of(given))
    if len(places) == len(list(places_of(drawn))):
        for place in places:
            restored = place.with_changed(restored, shear_modulus=place.material(given).shear_modulus)
    if (restored.ball, restored.on) != (given.ball, given.on):
        raise ValueError(
            f"draws must differ in shear moduli alone where they are linear, got {shown(draw)} for "
            f"{shown((given.ball, given.on))}"
        )
    return drawn


def _values(moduli: Sequence[ShearModulusLike], frequency: Floats) -> NDArray[np.complex128]:
    """Return moduli at frequencies, a row for each [Pa]."""
    return np.array([_core.complex_modulus(to_core(modulus), frequency) for modulus in moduli])
