"""Sensitivities over frequency, with matplotlib (the extra `viscoroll[plot]`)."""

from __future__ import annotations

from typing import TYPE_CHECKING

from .._support.pictures import Picture, drawn
from .._support.text import shown

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from .sensitivity import Sensitivity

__all__ = ["plot_sensitivity"]


def plot_sensitivity(found: Sensitivity, ax: Axes | None, *, answer: str) -> Picture | Axes:
    """Draw what storage and loss modulus of each material do to an answer, by frequency."""
    if answer not in found.answers:
        raise ValueError(f"answer must be one of {', '.join(found.answers)}, got {shown(answer)}")
    which = found.answers.index(answer)

    def draw(axes: Axes) -> None:
        for i, modulus in enumerate(found.moduli):
            color = f"C{i}"
            for values, line, part in ((modulus.storage, "-", "G'"), (modulus.loss, "--", "G''")):
                label = f"{modulus.name}, {part}"
                axes.step(modulus.frequency, values[which], line, where="mid", color=color, label=label)
        axes.axhline(0.0, color="0.6", linewidth=0.8)
        axes.set_xscale("log")
        axes.set_xlabel("frequency [rad/s]")
        axes.set_ylabel(f"change of {answer} by that of the modulus [-]".replace("_", " "))
        axes.legend(fontsize="small")

    return drawn(draw, ax, figsize=(6.0, 3.6))
