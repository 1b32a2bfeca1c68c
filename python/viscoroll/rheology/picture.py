"""Plots of measured moduli (require the extra `viscoroll[plot]`)."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, TypeAlias

import numpy as np

from .._support.arguments import Floats
from .._support.celsius import ZERO_CELSIUS, celsius_text
from .._support.pictures import Picture, draw_picture
from ..materials import Prony
from .shift_laws import ShiftFactors, ShiftLaw

if TYPE_CHECKING:
    from matplotlib.axes import Axes

__all__ = ["plot_fit", "plot_strain_sweep", "plot_superposition"]

_STORAGE, _LOSS = "tab:blue", "tab:orange"

#: Angular frequency [rad/s] or strain [-], storage modulus [Pa] and loss modulus [Pa].
_Measured: TypeAlias = tuple[Floats, Floats, Floats]


def plot_fit(
    measured: _Measured, series: Prony, *, errors: tuple[Floats, Floats], ax: Axes | None = None
) -> Picture | Axes:
    """Plot data and fit, and the relative errors of storage and loss below; without the errors if `ax` is given."""

    def compose(picture: Picture) -> None:
        above, below = picture.subplots(2, 1, sharex=True, height_ratios=(3, 1))
        _draw_moduli(above, measured, series)
        above.label_outer()
        for color, error in zip((_STORAGE, _LOSS), errors, strict=True):
            below.semilogx(measured[0], 100.0 * error, ".", color=color, markersize=4)
        below.axhline(0.0, color="gray", linewidth=0.8)
        below.set(xlabel="angular frequency [rad/s]", ylabel="fit / data - 1 [%]")

    return draw_picture(lambda axes: _draw_moduli(axes, measured, series), ax, figsize=(7.0, 6.0), compose=compose)


def _draw_moduli(axes: Axes, measured: _Measured, series: Prony) -> None:
    frequency, storage, loss = measured
    omega = np.geomspace(frequency[0] / 10.0, frequency[-1] * 10.0, 400)
    modulus = series.complex_modulus(omega)
    for color, data, curve, name in (
        (_STORAGE, storage, modulus.real, "storage"),
        (_LOSS, loss, modulus.imag, "loss"),
    ):
        axes.loglog(frequency, data, ".", color=color, markersize=4, label=f"{name}, measured")
        axes.loglog(omega, curve, "-", color=color, linewidth=1, label=f"{name}, Prony series")
    axes.set(xlabel="angular frequency [rad/s]", ylabel="shear modulus [Pa]")
    axes.legend()


def plot_strain_sweep(measured: _Measured, fitted: _Measured, *, ax: Axes | None = None) -> Picture | Axes:
    """Plot measured and fitted moduli over the strain amplitude."""

    def draw(axes: Axes) -> None:
        for data, style, name in ((measured, "o", "measured"), (fitted, "-", "fitted")):
            strain, storage, loss = data
            axes.loglog(100.0 * strain, storage, style, color=_STORAGE, markersize=4, label=f"storage, {name}")
            axes.loglog(100.0 * strain, loss, style, color=_LOSS, markersize=4, label=f"loss, {name}")
        axes.set(xlabel="amplitude of shear strain [%]", ylabel="shear modulus [Pa]")
        axes.legend()

    return draw_picture(draw, ax, figsize=(7.0, 4.0))


def plot_superposition(
    sweeps: list[_Measured],
    factors: ShiftFactors,
    laws: Iterable[ShiftLaw],
    *,
    reference: float,
    ax: Axes | None = None,
) -> Picture | Axes:
    """Plot shifted sweeps at the reference temperature [K], and the shift factors with fitted laws.

    If `ax` is given, only the sweeps are plotted.
    """

    def compose(picture: Picture) -> None:
        left, right = picture.subplots(1, 2)
        _draw_sweeps(left, sweeps, reference)
        _draw_factors(right, factors, laws)

    return draw_picture(lambda axes: _draw_sweeps(axes, sweeps, reference), ax, figsize=(11.0, 4.5), compose=compose)


def _draw_sweeps(axes: Axes, sweeps: list[_Measured], reference: float) -> None:
    for frequency, storage, loss in sweeps:
        (line,) = axes.loglog(frequency, storage, ".", markersize=4)
        axes.loglog(frequency, loss, "x", markersize=3, color=line.get_color())
    axes.set_xlabel(f"angular frequency at {celsius_text(reference)} [rad/s]")
    axes.set_ylabel("storage (dots) and loss (crosses) [Pa]")


def _draw_factors(axes: Axes, factors: ShiftFactors, laws: Iterable[ShiftLaw]) -> None:
    temperature = np.array(factors.temperature)
    axes.plot(temperature - ZERO_CELSIUS, factors.log10_factor, "ko", markersize=4, label="sweeps")
    fine = np.linspace(temperature[0], temperature[-1], 200)
    for law, style in zip(laws, ("-", "--"), strict=True):
        name = f"{law.name}, residual {law.residual:.2g} decades"
        axes.plot(fine - ZERO_CELSIUS, law(fine), style, linewidth=1, label=name)
    axes.set_xlabel("temperature [°C]")
    axes.set_ylabel("log₁₀ of the shift factor")
    axes.legend()
