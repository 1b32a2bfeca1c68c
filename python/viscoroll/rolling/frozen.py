"""Solution of a contact for changed input, with the nodes in contact, stick and slip unchanged (frozen contact)."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from .. import _core
from .._support.arguments import Floats
from .._support.errors import InvalidInput
from ..bodies import core_counterbody
from ..solution import Solution
from .perturbed import Given

__all__ = ["NOT_FROZEN", "FrozenContact"]

#: Scalars that are not computed with a frozen contact.
NOT_FROZEN = frozenset({"overspeed", "finite_strain_angular_speed", "finite_strain_torque_error"})

#: Largest relative difference from the result when the frozen contact is solved for the same input. The difference can
#: be 1e-5 with `Curvature.EXACT` if the influence tables cover a larger contact.
_SAME = 1e-4


class FrozenContact:
    """Solver of the contact equations of a result for changed input (`docs/theory/sensitivities.md`).

    Parameters
    ----------
    result : Solution
        Result whose nodes in contact, stick and slip are kept.
    answers : sequence of str
        Names of the scalar results to return.
    threads : int
        Number of threads; 0 for all cores.
    """

    def __init__(self, result: Solution, answers: Sequence[str], threads: int) -> None:
        if result.adhesion is not None:
            raise InvalidInput("adhesion", "must be left out for sensitivities, whose contact keeps its nodes")
        self._result, self._answers, self._threads = result, tuple(answers), threads

    def own_values(self, given: Given) -> Floats:
        """Return the scalars for the input of the result itself, shape (answers,), in SI units.

        Raises
        ------
        ConvergenceError
            If the solution differs from the result: after `Status.MAX_ITERATIONS`, or with `SlipKinematics.FLAT`.
        """
        again = self._solved(given)
        self._require_same(again)
        return self._read(again)

    def values(self, given: Given) -> Floats:
        """Return the scalars for another input, shape (answers,), in SI units."""
        return self._read(self._solved(given))

    def _require_same(self, again: _core.Result) -> None:
        """Raise a ConvergenceError if the frozen contact does not reproduce the result."""
        result = self._result
        changes = {"max_pressure": again.max_pressure - result.max_pressure}
        sizes = {"max_pressure": result.max_pressure}
        if result.friction > 0.0:
            changes["driving_force"] = again.driving_force - result.driving_force
            sizes["driving_force"] = min(result.friction, 1.0) * result.load
        for name, change in changes.items():
            if not abs(change) <= _SAME * sizes[name]:
                raise _core.ConvergenceError(
                    f"{name} changes by {abs(change) / sizes[name]:.2g} when the same contact is solved again: the "
                    "result is not a converged solution; check its status"
                )

    def _read(self, solution: _core.Result) -> Floats:
        return np.array([self._value(solution, answer) for answer in self._answers])

    def _value(self, solution: _core.Result, answer: str) -> float:
        """Return a scalar. The torque at finite strain is taken as proportional to that of linear theory."""
        if answer != "finite_strain_torque":
            return float(getattr(solution, answer))
        corrected = self._result.finite_strain_torque
        assert corrected is not None
        return solution.resisting_torque * (corrected / self._result.resisting_torque)

    def _solved(self, given: Given) -> _core.Result:
        result = self._result
        return _core.solve_frozen(
            given.body._to_core(),
            core_counterbody(given.on),
            _core.LoadCase(
                load=given.load,
                penetration=given.penetration,
                angular_speed=given.angular_speed,
                friction=given.friction,
                drive=given.drive._to_core(),
            ),
            _core.Options(
                mesh=result.mesh._to_core(),
                compliance=result.compliance,
                curvature=result.curvature,
                patch_load=result.patch_load,
                finite_strain=False,
                threads=self._threads,
            ),
            contact=result.contact.astype(np.uint8),
            stick=result.stick.astype(np.uint8),
            pressure=np.ascontiguousarray(result.pressure),
            shear_traction=np.ascontiguousarray(result.shear_traction),
            penetration=result.penetration or 0.0,
            creepage=result.creepage or 0.0,
            progress=None,
        )
