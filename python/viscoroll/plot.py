"""Pictures, with matplotlib (the extra `viscoroll[plot]`)."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from matplotlib.figure import Figure

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from .result import Result

__all__ = ["plot_contact"]

_MM = 1e3
_MPA = 1e-6


def plot_contact(result: Result) -> Figure:
    """Draw the contact pressure: its map, and its profile along the rolling direction.

    Parameters
    ----------
    result : Result
        A solution.

    Returns
    -------
    matplotlib.figure.Figure
        Two axes side by side; the figure belongs to no window.
    """
    figure = Figure(figsize=(11.0, 4.6), layout="constrained")
    pressure_map, profile = figure.subplots(1, 2, width_ratios=[1.0, 1.15])
    _draw_map(pressure_map, result)
    _draw_profile(profile, result)
    figure.suptitle(
        f"P = {result.load:g} N, Ω = {result.angular_speed:g} rad/s:  "
        f"T_r = {result.resisting_torque * 1e3:.4g} mN m,  penetration {result.penetration * _MM:.3g} mm"
    )
    return figure


def _offset(result: Result) -> float:
    return result.resisting_torque / result.load


def _draw_map(axes: Axes, result: Result) -> None:
    x, z = result.x * _MM, result.z * _MM
    mesh = axes.pcolormesh(x, z, result.pressure * _MPA, shading="gouraud", cmap="magma_r", rasterized=True)
    axes.contour(x, z, result.contact.astype(float), levels=[0.5], colors="k", linewidths=1.0)
    offset = _offset(result) * _MM
    axes.axvline(0.0, color="0.5", linewidth=0.8, linestyle=":")
    axes.plot(offset, 0.0, "o", color="tab:cyan", markeredgecolor="k", label=f"resultant, x = {offset:.3g} mm")
    axes.set(xlabel="x [mm], rolling to the right", ylabel="z [mm]", aspect="equal")
    axes.set_xlim(x.min(), x.max())
    axes.legend(loc="upper left", fontsize="small")
    axes.figure.colorbar(mesh, ax=axes, label="contact pressure [MPa]")


def _draw_profile(axes: Axes, result: Result) -> None:
    middle = result.x.shape[1] // 2
    x = result.x[:, middle] * _MM
    pressure = result.pressure[:, middle] * _MPA
    axes.fill_between(x, pressure, color="tab:red", alpha=0.15)
    axes.plot(x, pressure, ".-", color="tab:red", label="pressure")
    axes.axvline(_offset(result) * _MM, color="tab:cyan", label="resultant")
    axes.axvline(0.0, color="0.5", linewidth=0.8, linestyle=":")
    axes.set(xlabel="x [mm], rolling to the right", ylabel="contact pressure in the middle plane [MPa]")
    axes.set_ylim(bottom=0.0)
    gap = axes.twinx()
    gap.plot(x, np.maximum(result.gap[:, middle], 0.0) * _MM, color="tab:blue", linewidth=1.0)
    gap.set_ylabel("gap below the surface [mm]", color="tab:blue")
    gap.set_ylim(bottom=0.0)
    axes.legend(loc="upper left", fontsize="small")
