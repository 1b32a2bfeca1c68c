"""Pictures of measured moduli (the extra `viscoroll[plot]`)."""

from __future__ import annotations

from typing import TYPE_CHECKING, Protocol

import numpy as np

from .._support.arguments import Floats
from .._support.pictures import Picture, drawn
from ..materials import Prony
from .reading import RheologyData
from .shift_laws import ShiftFactors, ShiftLaw

if TYPE_CHECKING:
    from matplotlib.axes import Axes

__all__ = ["plot_fit", "plot_superposition"]

_STORAGE, _LOSS = "tab:blue", "tab:orange"


class _Fit(Protocol):
    """A Prony series beside what it was fitted to, as `PronyFit` is."""

    @property
    def series(self) -> Prony: ...
    @property
    def frequency(self) -> Floats: ...
    @property
    def storage(self) -> Floats: ...
    @property
    def loss(self) -> Floats: ...
    @property
    def storage_error(self) -> Floats: ...
    @property
    def loss_error(self) -> Floats: ...


class _Sweeps(Protocol):
    """Sweeps shifted onto one another, as a `Superposition` is."""

    @property
    def data(self) -> RheologyData: ...
    @property
    def reference(self) -> float: ...
    @property
    def factors(self) -> ShiftFactors: ...
    @property
    def vertical(self) -> tuple[float, ...]: ...
    @property
    def wlf(self) -> ShiftLaw: ...
    @property
    def arrhenius(self) -> ShiftLaw: ...


def plot_fit(fit: _Fit, ax: Axes | None = None) -> Picture | Axes:
    """Draw data and fit above, relative errors below; into axes of the caller's data and fit alone."""
    return drawn(
        lambda axes: _draw_moduli(axes, fit), ax, figsize=(7.0, 6.0), compose=lambda whole: _compose_fit(whole, fit)
    )


def _compose_fit(picture: Picture, fit: _Fit) -> None:
    above, below = picture.subplots(2, 1, sharex=True, height_ratios=(3, 1))
    _draw_moduli(above, fit)
    above.label_outer()
    for color, error in ((_STORAGE, fit.storage_error), (_LOSS, fit.loss_error)):
        below.semilogx(fit.frequency, 100.0 * error, ".", color=color, markersize=4)
    below.axhline(0.0, color="gray", linewidth=0.8)
    below.set_ylabel("fit / data - 1 [%]")
    below.set_xlabel("angular frequency [rad/s]")


def _draw_moduli(axes: Axes, fit: _Fit) -> None:
    omega = np.geomspace(fit.frequency[0] / 10.0, fit.frequency[-1] * 10.0, 400)
    modulus = fit.series.complex_modulus(omega)
    for color, data, curve, name in (
        (_STORAGE, fit.storage, modulus.real, "storage"),
        (_LOSS, fit.loss, modulus.imag, "loss"),
    ):
        axes.loglog(fit.frequency, data, ".", color=color, markersize=4, label=f"{name}, measured")
        axes.loglog(omega, curve, "-", color=color, linewidth=1, label=f"{name}, Prony series")
    axes.set(xlabel="angular frequency [rad/s]", ylabel="shear modulus [Pa]")
    axes.legend()


def plot_superposition(curve: _Sweeps, ax: Axes | None = None) -> Picture | Axes:
    """Draw the shifted sweeps, and their shift factors with both laws; into axes of the caller's the sweeps alone."""
    return drawn(
        lambda axes: _draw_sweeps(axes, curve),
        ax,
        figsize=(11.0, 4.5),
        compose=lambda whole: _compose_sweeps(whole, curve),
    )


def _compose_sweeps(picture: Picture, curve: _Sweeps) -> None:
    left, right = picture.subplots(1, 2)
    _draw_sweeps(left, curve)
    _draw_factors(right, curve)


def _draw_sweeps(axes: Axes, curve: _Sweeps) -> None:
    for sweep, shift, lift in zip(curve.data.isotherms, curve.factors.log10_factor, curve.vertical, strict=True):
        reduced = sweep.frequency * 10.0**shift
        (line,) = axes.loglog(reduced, sweep.storage * 10.0**-lift, ".", markersize=4)
        axes.loglog(reduced, sweep.loss * 10.0**-lift, "x", markersize=3, color=line.get_color())
    axes.set_xlabel(f"angular frequency at {curve.reference:g} °C [rad/s]")
    axes.set_ylabel("storage (dots) and loss (crosses) [Pa]")


def _draw_factors(axes: Axes, curve: _Sweeps) -> None:
    temperature = np.array(curve.factors.temperature)
    axes.plot(temperature, curve.factors.log10_factor, "ko", markersize=4, label="sweeps")
    fine = np.linspace(temperature[0], temperature[-1], 200)
    for law, style in ((curve.wlf, "-"), (curve.arrhenius, "--")):
        axes.plot(fine, law(fine), style, linewidth=1, label=f"{law.name}, residual {law.residual:.2g} decades")
    axes.set_xlabel("temperature [°C]")
    axes.set_ylabel("log₁₀ of the shift factor")
    axes.legend()
