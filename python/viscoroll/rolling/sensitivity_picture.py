"""Sensitivities over frequency, with matplotlib (the extra `viscoroll[plot]`)."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from .._support.pictures import Picture, drawn
from .modulus_sensitivity import ModulusSensitivity

if TYPE_CHECKING:
    from matplotlib.axes import Axes

__all__ = ["plot_moduli"]


def plot_moduli(moduli: Sequence[ModulusSensitivity], which: int, answer: str, ax: Axes | None) -> Picture | Axes:
    """Draw what storage and loss modulus of each material do to one of the answers, by frequency."""

    def draw(axes: Axes) -> None:
        for i, modulus in enumerate(moduli):
            for values, line, part in ((modulus.storage, "-", "G'"), (modulus.loss, "--", "G''")):
                label = f"{modulus.name}, {part}"
                axes.step(modulus.frequency, values[which], line, where="mid", color=f"C{i}", label=label)
        axes.axhline(0.0, color="0.6", linewidth=0.8)
        axes.set_xscale("log")
        axes.set_xlabel("frequency [rad/s]")
        axes.set_ylabel(f"change of {answer} by that of the modulus [-]".replace("_", " "))
        axes.legend(fontsize="small")

    return drawn(draw, ax, figsize=(6.0, 3.6))
