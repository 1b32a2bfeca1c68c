"""Pictures of strain softening: operating points on the curves of the network, and strain over the section."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from .._support.pictures import Picture, draw_picture
from ..materials.networks import Network

if TYPE_CHECKING:
    import xarray
    from matplotlib.axes import Axes

__all__ = ["OperatingPoint", "plot_softening"]

_MM = 1e3
_MPA = 1e-6
_PERCENT = 100.0


@dataclass(frozen=True, slots=True)
class OperatingPoint:
    """Operating point of a network: its law, the amplitude of its moduli, and the largest amplitude [-]."""

    network: Network
    amplitude: float
    largest: float


def plot_softening(points: Sequence[OperatingPoint], section: xarray.Dataset, ax: Axes | None = None) -> Picture | Axes:
    """Draw the moduli of the networks over strain, and the amplitude over the section; into `ax` only the former."""

    def compose(picture: Picture) -> None:
        left, right = picture.subplots(1, 2)
        _draw_networks(left, points)
        _draw_section(right, section)

    return draw_picture(lambda axes: _draw_networks(axes, points), ax, figsize=(11.0, 4.5), compose=compose)


def _draw_networks(axes: Axes, points: Sequence[OperatingPoint]) -> None:
    """Draw N' and N'' of each law, with a dot at the amplitude of each layer and a line to its largest amplitude."""
    strain = np.geomspace(0.1 * min(one.amplitude for one in points), 3.0 * max(one.largest for one in points), 200)
    for number, network in enumerate(dict.fromkeys(one.network for one in points)):
        for moduli, color, name in zip(network.at(strain), ("tab:blue", "tab:orange"), ("N'", "N''"), strict=True):
            label = name if number == 0 else None
            axes.plot(strain * _PERCENT, moduli * _MPA, color=color, label=label)
    for one in points:
        stored, lost = (float(part) * _MPA for part in one.network.at(one.amplitude))
        axes.plot([one.amplitude * _PERCENT] * 2, [stored, lost], "ko")
        axes.plot([one.amplitude * _PERCENT, one.largest * _PERCENT], [stored] * 2, color="k", linewidth=1.0)
    axes.set(xscale="log", xlabel="amplitude of shear strain [%]", ylabel="modulus of the network [MPa]")
    axes.set_ylim(bottom=0.0)
    axes.legend()


def _draw_section(axes: Axes, section: xarray.Dataset) -> None:
    depth, values = section.depth * _MM, section.amplitude * _PERCENT
    if section.sizes["theta"] == 1:
        axes.plot(values[:, 0], depth, "o-", color="tab:red")
        axes.set_xlabel("amplitude of shear strain [%]")
    else:
        image = axes.contourf(section.z * _MM, depth, values, levels=24, cmap="inferno")
        axes.figure.colorbar(image, ax=axes, label="amplitude of shear strain [%]")
        axes.set_xlabel("across the track [mm]")
    axes.set_ylabel("depth [mm]")
    axes.invert_yaxis()
