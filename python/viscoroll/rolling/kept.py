"""A contact solved again for other input, with who touches, sticks and slips as they are."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from .. import _core
from .._support.arguments import Floats
from ..bodies import core_counterpart
from ..solution import Solution
from .perturbed import Given

__all__ = ["KeptContact"]

#: What a result may change by as it is solved again: tables that reach farther change the exact sphere's by 1e-5.
_SAME = 1e-4


class KeptContact:
    """The nodes of a result, on which its equations are solved for other input (`docs/theory/sensitivities.md`).

    Parameters
    ----------
    result : Solution
        Whose nodes touch, stick and slip.
    answers : sequence of str
        Scalars that are wanted.
    threads : int
        Number of threads; 0 for all cores.
    """

    def __init__(self, result: Solution, answers: Sequence[str], threads: int) -> None:
        self._result, self._answers, self._threads = result, tuple(answers), threads

    def own_answers(self, given: Given) -> Floats:
        """Return the answers of the input that gave the result.

        Raises
        ------
        ConvergenceError
            Where they are not the result's: after `Status.MAX_ITERATIONS`, or with `SlipKinematics.FLAT`.
        """
        again = self._solved(given)
        self._require_same(again)
        return self._read(again)

    def answers(self, given: Given) -> Floats:
        """Return the answers of another input."""
        return self._read(self._solved(given))

    def _require_same(self, again: _core.Result) -> None:
        """Refuse a result that is another one than what its input gives in the same contact."""
        result = self._result
        changes = {"max_pressure": again.max_pressure - result.max_pressure}
        sizes = {"max_pressure": result.max_pressure}
        if result.friction > 0.0:
            changes["driving_force"] = again.driving_force - result.driving_force
            sizes["driving_force"] = min(result.friction, 1.0) * result.load
        for name, change in changes.items():
            if not abs(change) <= _SAME * sizes[name]:
                raise _core.ConvergenceError(
                    f"{name} changes by {abs(change) / sizes[name]:.2g} as the contact is solved again as it is: it is "
                    "not that of a solution"
                )

    def _read(self, solution: _core.Result) -> Floats:
        return np.array([getattr(solution, answer) for answer in self._answers])

    def _solved(self, given: Given) -> _core.Result:
        result = self._result
        return _core.solve_kept(
            given.ball._to_core(),
            core_counterpart(given.on),
            load=given.load,
            angular_speed=given.angular_speed,
            mesh=result.mesh._to_core(),
            friction=given.friction,
            drive=given.drive._to_core(),
            compliance=result.compliance,
            curvature=result.curvature,
            patch_load=result.patch_load,
            contact=result.contact.astype(np.uint8),
            stick=result.stick.astype(np.uint8),
            pressure=np.ascontiguousarray(result.pressure),
            shear_traction=np.ascontiguousarray(result.shear_traction),
            penetration=result.penetration or 0.0,
            creepage=result.creepage or 0.0,
            threads=self._threads,
            progress=None,
        )
