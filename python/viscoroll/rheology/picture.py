"""Pictures of measured moduli (the extra `viscoroll[plot]`)."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .._support.pictures import Picture, drawn

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from .prony_fit import PronyFit
    from .superposition import Superposition

__all__ = ["draw_moduli", "draw_sweeps", "plot_fit", "plot_superposition"]

_STORAGE, _LOSS = "tab:blue", "tab:orange"


def plot_fit(fit: PronyFit) -> Picture:
    """Draw data and fit above, relative errors below."""
    figure = Picture(figsize=(7.0, 6.0), layout="constrained")
    above, below = figure.subplots(2, 1, sharex=True, height_ratios=(3, 1))
    _draw_moduli(above, fit)
    for color, error in ((_STORAGE, fit.storage_error), (_LOSS, fit.loss_error)):
        below.semilogx(fit.frequency, 100.0 * error, ".", color=color, markersize=4)
    below.axhline(0.0, color="gray", linewidth=0.8)
    below.set_ylabel("fit / data - 1 [%]")
    below.set_xlabel("angular frequency [rad/s]")
    return figure


def draw_moduli(fit: PronyFit, ax: Axes) -> Axes:
    """Draw data and fit alone into axes of the caller's."""
    drawn(lambda axes: _draw_moduli(axes, fit), ax, figsize=(7.0, 4.5))
    ax.set_xlabel("angular frequency [rad/s]")
    return ax


def _draw_moduli(axes: Axes, fit: PronyFit) -> None:
    omega = np.geomspace(fit.frequency[0] / 10.0, fit.frequency[-1] * 10.0, 400)
    modulus = fit.series.complex_modulus(omega)
    for color, data, curve, name in (
        (_STORAGE, fit.storage, modulus.real, "storage"),
        (_LOSS, fit.loss, modulus.imag, "loss"),
    ):
        axes.loglog(fit.frequency, data, ".", color=color, markersize=4, label=f"{name}, measured")
        axes.loglog(omega, curve, "-", color=color, linewidth=1, label=f"{name}, Prony series")
    axes.set_ylabel("shear modulus [Pa]")
    axes.legend()


def plot_superposition(curve: Superposition) -> Picture:
    """Draw the shifted sweeps, and their shift factors with both laws."""
    figure = Picture(figsize=(11.0, 4.5), layout="constrained")
    left, right = figure.subplots(1, 2)
    _draw_sweeps(left, curve)
    _draw_factors(right, curve)
    return figure


def draw_sweeps(curve: Superposition, ax: Axes) -> Axes:
    """Draw the shifted sweeps alone into axes of the caller's."""
    drawn(lambda axes: _draw_sweeps(axes, curve), ax, figsize=(7.0, 4.5))
    return ax


def _draw_sweeps(axes: Axes, curve: Superposition) -> None:
    for sweep, shift, lift in zip(curve.data.isotherms, curve.factors.log10_factor, curve.vertical, strict=True):
        reduced = sweep.frequency * 10.0**shift
        (line,) = axes.loglog(reduced, sweep.storage * 10.0**-lift, ".", markersize=4)
        axes.loglog(reduced, sweep.loss * 10.0**-lift, "x", markersize=3, color=line.get_color())
    axes.set_xlabel(f"angular frequency at {curve.reference:g} °C [rad/s]")
    axes.set_ylabel("storage (dots) and loss (crosses) [Pa]")


def _draw_factors(axes: Axes, curve: Superposition) -> None:
    temperature = np.array(curve.factors.temperature)
    axes.plot(temperature, curve.factors.log10_factor, "ko", markersize=4, label="sweeps")
    fine = np.linspace(temperature[0], temperature[-1], 200)
    for law, style in ((curve.wlf, "-"), (curve.arrhenius, "--")):
        axes.plot(fine, law(fine), style, linewidth=1, label=f"{law.name}, residual {law.residual:.2g} decades")
    axes.set_xlabel("temperature [°C]")
    axes.set_ylabel("log₁₀ of the shift factor")
    axes.legend()
