"""Pictures of measured moduli (the extra `viscoroll[plot]`)."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .._extras import extra

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from .prony_fit import PronyFit
    from .superposition import Superposition

__all__ = ["plot_fit", "plot_superposition"]

_STORAGE, _LOSS = "tab:blue", "tab:orange"


def plot_fit(fit: PronyFit) -> Figure:
    """Draw data and fit above, relative errors below."""
    with extra("plot"):
        from matplotlib.figure import Figure

    figure = Figure(figsize=(7.0, 6.0), layout="constrained")
    above, below = figure.subplots(2, 1, sharex=True, height_ratios=(3, 1))
    omega = np.geomspace(fit.frequency[0] / 10.0, fit.frequency[-1] * 10.0, 400)
    modulus = fit.series.complex_modulus(omega)
    for color, data, curve, error, name in (
        (_STORAGE, fit.storage, modulus.real, fit.storage_error, "storage"),
        (_LOSS, fit.loss, modulus.imag, fit.loss_error, "loss"),
    ):
        above.loglog(fit.frequency, data, ".", color=color, markersize=4, label=f"{name}, measured")
        above.loglog(omega, curve, "-", color=color, linewidth=1, label=f"{name}, Prony series")
        below.semilogx(fit.frequency, 100.0 * error, ".", color=color, markersize=4)
    above.set_ylabel("shear modulus [Pa]")
    above.legend()
    below.axhline(0.0, color="gray", linewidth=0.8)
    below.set_ylabel("fit / data - 1 [%]")
    below.set_xlabel("angular frequency [rad/s]")
    return figure


def plot_superposition(curve: Superposition) -> Figure:
    """Draw the shifted sweeps, and their shift factors with both laws."""
    with extra("plot"):
        from matplotlib.figure import Figure

    figure = Figure(figsize=(11.0, 4.5), layout="constrained")
    left, right = figure.subplots(1, 2)
    for sweep, shift, lift in zip(curve.data.isotherms, curve.factors.log10_factor, curve.vertical, strict=True):
        reduced = sweep.frequency * 10.0**shift
        (line,) = left.loglog(reduced, sweep.storage * 10.0**-lift, ".", markersize=4)
        left.loglog(reduced, sweep.loss * 10.0**-lift, "x", markersize=3, color=line.get_color())
    left.set_xlabel(f"angular frequency at {curve.reference:g} °C [rad/s]")
    left.set_ylabel("storage (dots) and loss (crosses) [Pa]")
    _draw_factors(right, curve)
    return figure


def _draw_factors(axes: Axes, curve: Superposition) -> None:
    temperature = np.array(curve.factors.temperature)
    axes.plot(temperature, curve.factors.log10_factor, "ko", markersize=4, label="sweeps")
    fine = np.linspace(temperature[0], temperature[-1], 200)
    for law, style in ((curve.wlf, "-"), (curve.arrhenius, "--")):
        axes.plot(fine, law(fine), style, linewidth=1, label=f"{law.name}, residual {law.residual:.2g} decades")
    axes.set_xlabel("temperature [°C]")
    axes.set_ylabel("log₁₀ of the shift factor")
    axes.legend()
