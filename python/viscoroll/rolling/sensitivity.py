"""Derivatives of a result by each input, with the nodes in contact and in stick unchanged."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from .._support.arguments import Floats, as_count, as_floats
from .._support.errors import InvalidInput
from .._support.extras import extra
from .._support.files import save, write_csv, write_netcdf
from .._support.progress import ProgressLike, counted
from .._support.text import shown
from ..solution import Solution
from ..solution.scalars import SCALARS
from .frozen import NOT_FROZEN, FrozenContact
from .modulus_sensitivity import ModulusSensitivity
from .perturbed import (
    Bands,
    Change,
    Given,
    MaterialPosition,
    Part,
    bands_of,
    change_of_modulus,
    material_positions,
    numbers_of,
)

if TYPE_CHECKING:
    import xarray
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

__all__ = ["Sensitivity", "sensitivity"]

#: Relative step of a parameter in a central difference quotient. The truncation error is of the order of its square;
#: round-off of the solutions contributes about 1e-6.
_STEP = 1e-4

#: Scalars whose sensitivity is computed by default.
_ANSWERS = ("resisting_torque", "load", "penetration", "max_pressure")


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class Sensitivity:
    """Relative change of scalar results per relative change of the input: -0.8 means 0.8 % less for 1 % more.

    Attributes
    ----------
    answers : tuple of str
        Names of the scalars of the result.
    parameters : tuple of str
        Names of the changed parameters in the input.
    values : ndarray, shape (parameters, answers)
        d ln(answer) / d ln(parameter) [-].
    moduli : tuple of ModulusSensitivity
        Sensitivities to the moduli, by frequency.
    result : Result
        Result to which the sensitivities belong.
    """

    answers: tuple[str, ...]
    parameters: tuple[str, ...]
    values: Floats
    moduli: tuple[ModulusSensitivity, ...]
    result: Solution

    def __getitem__(self, parameter: str) -> dict[str, float]:
        """Return the sensitivity of all answers to one parameter; for a modulus, to a change at all frequencies."""
        return dict(zip(self.answers, map(float, self._rows()[parameter]), strict=True))

    def _rows(self) -> dict[str, Floats]:
        rows = dict(zip(self.parameters, self.values, strict=True))
        for modulus in self.moduli:
            rows[modulus.name] = modulus.storage.sum(axis=1) + modulus.loss.sum(axis=1)
        return rows

    def __repr__(self) -> str:
        """Return a table with the most influential parameter first."""
        rows = sorted(self._rows().items(), key=lambda row: -abs(row[1][0]))
        width = max(len(name) for name, _ in rows)
        head = " " * width + "".join(f"  {answer}" for answer in self.answers)
        widths = [len(answer) for answer in self.answers]
        lines = (
            f"{name:<{width}}" + "".join(f"  {value:+{wide}.3f}" for wide, value in zip(widths, row, strict=True))
            for name, row in rows
        )
        return "\n".join(["relative change of each column per relative change of each row", head, *lines])

    def to_xarray(self) -> xarray.Dataset:
        """Return all sensitivities as a dataset.

        Returns
        -------
        xarray.Dataset
            `sensitivity` over (parameter, answer), and for the modulus with index i `storage_i` and `loss_i` over
            (frequency_i, answer), with the frequency in [rad/s].

        Raises
        ------
        ImportError
            If the extra `viscoroll[studies]` is missing.
        """
        with extra("studies"):
            import xarray

        coordinates: dict[str, Any] = {"answer": list(self.answers), "parameter": list(self.parameters)}
        data: dict[str, Any] = {"sensitivity": (("parameter", "answer"), self.values)}
        for i, modulus in enumerate(self.moduli):
            along = f"frequency_{i}"
            coordinates[along] = (along, modulus.frequency, {"units": "rad/s", "long_name": modulus.name})
            for kind, values in (("storage", modulus.storage), ("loss", modulus.loss)):
                name = f"{kind} of {modulus.name}"
                data[f"{kind}_{i}"] = ((along, "answer"), values.T, {"units": "1", "long_name": name})
        return xarray.Dataset(data, coordinates)

    def save(self, path: str | Path) -> None:
        """Write a file: .csv with one row per parameter and band, or .nc with the same content as `to_xarray`.

        Raises
        ------
        ValueError
            If the suffix is another one.
        """
        save(self, path, _FORMATS)

    def plot(
        self, ax: Axes | None = None, *, answer: str | None = None, measured: tuple[float, float] | None = None
    ) -> Figure | Axes:
        """Draw the dissipated power over frequency, and the sensitivity of one answer to the moduli at each frequency.

        Parameters
        ----------
        ax : matplotlib.axes.Axes, optional
            Axes for the sensitivities only. By default, both are drawn in a new figure.
        answer : str, optional
            Name of the scalar, by default the first of `answers`.
        measured : (float, float), optional
            Lowest and highest frequency at which the moduli are measured [rad/s]; other frequencies are gray. By
            default the range of the tables of the moduli, if there are any.

        Returns
        -------
        matplotlib.figure.Figure or matplotlib.axes.Axes
            A new figure, or `ax`.

        Raises
        ------
        ValueError
            If the answer is unknown, or the frequencies are not positive and increasing.
        ImportError
            If the extra `viscoroll[plot]` is missing.
        """
        from .sensitivity_picture import measured_range, plot_moduli

        answer = self.answers[0] if answer is None else answer
        if answer not in self.answers:
            raise InvalidInput("answer", f"must be one of {', '.join(self.answers)}", shown(answer))
        known = measured_range(self.result) if measured is None else _as_range(measured)
        return plot_moduli(self.result, self.moduli, self.answers.index(answer), answer, known, ax)


def sensitivity(
    self: Solution,
    *,
    answers: Sequence[str] | None = None,
    bands_per_decade: int = 1,
    threads: int = 0,
    progress: ProgressLike = None,
) -> Sensitivity:
    """Return the derivatives of torque, penetration or load, and pressure by each parameter.

    The nodes in contact, stick and slip are kept. The remaining equations are smooth, and each solve of them takes a
    fraction of the time of the first solve. The derivatives are those of the whole problem on this mesh, because nodes
    that join the contact affect only second derivatives (`docs/theory/sensitivities.md`). Derivatives by lengths have
    the error of the mesh, because the positions of the nodes depend on lengths.

    Parameters
    ----------
    answers : sequence of str, optional
        Scalars of the result; by default resisting torque, largest pressure and, if determined, penetration; the load
        instead if the penetration is given.
    bands_per_decade : int, default 1
        Number of frequency bands per decade in which the moduli are changed, ≥ 1.
    threads : int, default 0
        Number of threads; 0 for all cores.
    progress : bool or callable, optional
        True shows a progress bar; a callable is called as progress(stage, fraction).

    Returns
    -------
    Sensitivity
        Sensitivities to load or penetration, angular_speed, friction and drive unless they are 0, and to thickness,
        Poisson's ratio or bulk modulus, density and shear modulus of all materials.

    Raises
    ------
    ValueError
        If an answer is not a scalar of this result.
    ConvergenceError
        If the same input does not reproduce the result: after `Status.MAX_ITERATIONS`, or with `SlipKinematics.FLAT`.

    Examples
    --------
    >>> from viscoroll import Mesh, paper, solve
    >>> r = solve(paper.ball(), load=100.0, angular_speed=2.5, mesh=Mesh(nodes_per_revolution=500))
    >>> print(f"{r.sensitivity()['angular_speed']['resisting_torque']:.2f}")
    -0.85
    """
    answers = _answers(self, answers)
    per_decade = as_count("bands_per_decade", bands_per_decade, 1)
    given = Given.of(self)
    quotients = _Quotients(self, given, answers, threads)
    numbers = list(numbers_of(given))
    moduli = [
        (position, bands_of(position.rolling_speed(self), self.mesh, per_decade))
        for position in material_positions(given)
    ]
    total = len(numbers) + sum(2 * bands.centers.size for _, bands in moduli)
    with counted(progress, total=total, unit="parameter") as advance:

        def each(change: Change, *, downwards: bool = False) -> Floats:
            found = quotients(change, downwards=downwards)
            advance()
            return found

        def by_band(position: MaterialPosition, bands: Bands, part: Part) -> Floats:
            speed = position.rolling_speed(self)
            changes = (
                change_of_modulus(given, position, bands, band, part, rolling_speed=speed)
                for band in range(bands.centers.size)
            )
            return np.array([each(change) for change in changes]).T

        values = [each(number.change, downwards=number.downwards) for number in numbers]
        found = tuple(
            ModulusSensitivity(
                name=f"{position.name}.shear_modulus",
                frequency=bands.centers,
                storage=by_band(position, bands, "storage"),
                loss=by_band(position, bands, "loss"),
            )
            for position, bands in moduli
        )
    return Sensitivity(
        answers=answers,
        parameters=tuple(number.name for number in numbers),
        values=np.array(values),
        moduli=found,
        result=self,
    )


def _as_range(measured: tuple[float, float]) -> tuple[float, float]:
    low, high = as_floats("measured", measured) if np.ndim(measured) == 1 and len(measured) == 2 else (0.0, 0.0)
    if not 0.0 < low < high:
        raise InvalidInput("measured", "must be two increasing frequencies > 0 rad/s", shown(measured))
    return low, high


def _answers(result: Solution, wanted: Sequence[str] | None) -> tuple[str, ...]:
    """Return the names of scalars of a result; raise a ValueError for other names."""
    scalars = result.scalars()
    if wanted is None:
        return tuple(answer for answer in _ANSWERS if scalars[answer] is not None and answer != result.prescribed)
    for answer in wanted:
        if (
            answer not in SCALARS.keys() - NOT_FROZEN
            or answer == result.prescribed
            or not isinstance(scalars[answer], float)
        ):
            raise InvalidInput("answers", "must be names of scalars of this result", shown(answer))
    return tuple(wanted)


class _Quotients:
    """Difference quotients of the answers, with the frozen contact of a result."""

    def __init__(self, result: Solution, given: Given, answers: tuple[str, ...], threads: int) -> None:
        self._contact = FrozenContact(result, answers, threads)
        self._here = self._contact.own_values(given)

    def __call__(self, change: Change, *, downwards: bool) -> Floats:
        """Return d ln(answer) / d ln(parameter), from changes of the parameter both ways or only downwards."""
        below = self._contact.values(change(-_STEP))
        if downwards:
            quotient = (3.0 * self._here - 4.0 * below + self._contact.values(change(-2.0 * _STEP))) / (2.0 * _STEP)
        else:
            quotient = (self._contact.values(change(_STEP)) - below) / (2.0 * _STEP)
        relative: Floats = np.divide(quotient, self._here, out=np.zeros_like(quotient), where=self._here != 0.0)
        return relative


def _write_csv(found: Sensitivity, path: Path) -> None:
    rows = [(name, "", row) for name, row in zip(found.parameters, found.values, strict=True)]
    for modulus in found.moduli:
        for part, values in (("storage", modulus.storage), ("loss", modulus.loss)):
            rows += [(f"{modulus.name} {part}", w, row) for w, row in zip(modulus.frequency, values.T, strict=True)]
    columns: dict[str, Sequence[Any]] = {
        "parameter": [name for name, _, _ in rows],
        "frequency [rad/s]": [frequency for _, frequency, _ in rows],
    }
    columns |= {answer: [row[i] for _, _, row in rows] for i, answer in enumerate(found.answers)}
    write_csv(columns, path)


def _write_netcdf(found: Sensitivity, path: Path) -> None:
    write_netcdf(found.to_xarray(), path)


_FORMATS = {".csv": _write_csv, ".nc": _write_netcdf}
