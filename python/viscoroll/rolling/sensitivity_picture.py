"""Loss and sensitivities over frequency, with matplotlib (the extra `viscoroll[plot]`)."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

import numpy as np

from .._support.arguments import Floats
from .._support.pictures import Picture, draw_picture
from ..materials.modulus_like import measured_range_of
from ..solution.loss_spectrum import loss_spectrum
from .perturbed import Given, bands_of, material_positions

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from ..solution import Solution
    from .modulus_sensitivity import ModulusSensitivity

__all__ = ["measured_range", "plot_moduli"]

#: Bands per decade for the loss: about five across the loss peak of a single relaxation time (1.1 decades).
_PER_DECADE = 4

#: Lowest and highest frequency [rad/s].
Range = tuple[float, float]


def measured_range(result: Solution) -> Range | None:
    """Return the frequency range common to all tables of measured moduli [rad/s], or None without such tables."""
    given = Given.of(result)
    return measured_range_of(position.material(given).shear_modulus for position in material_positions(given))


def plot_moduli(
    result: Solution,
    moduli: tuple[ModulusSensitivity, ...],
    which: int,
    answer: str,
    measured: Range | None,
    ax: Axes | None,
) -> Picture | Axes:
    """Draw the dissipated power over frequency, and below it the sensitivity of one answer to the moduli.

    Frequencies without measurements are gray. If axes are given, only the sensitivities are drawn.
    """

    def draw(axes: Axes) -> None:
        for i, modulus in enumerate(moduli):
            for values, line, part in ((modulus.storage, "-", "G'"), (modulus.loss, "--", "G''")):
                label = f"{modulus.name}, {part}"
                axes.step(modulus.frequency, values[which], line, where="mid", color=f"C{i}", label=label)
        axes.axhline(0.0, color="0.6", linewidth=0.8)
        axes.set_xscale("log")
        axes.set_xlabel("frequency [rad/s]")
        axes.set_ylabel(f"relative change of {answer.replace('_', ' ')}\nper relative change of the modulus [-]")
        _shade_unmeasured(axes, measured)
        axes.legend(fontsize="small")

    def compose(picture: Picture) -> None:
        above, below = picture.subplots(2, 1, sharex=True, height_ratios=(2, 3))
        for line, (name, frequency, fraction) in zip(("-", "--"), _losses(result), strict=False):
            above.plot(frequency, 100.0 * fraction, line, color="0.3", label=f"loss in {name}")
        above.set_ylabel("power dissipated\n[% per decade]")
        above.set_ylim(0.0, None)
        draw(below)
        _shade_unmeasured(above, measured)
        above.label_outer()
        above.legend(fontsize="small")

    return draw_picture(draw, ax, figsize=(6.4, 5.4), compose=compose)


def _losses(result: Solution) -> Iterator[tuple[str, Floats, Floats]]:
    """Yield for each body its name, frequencies [rad/s], and the fraction of its loss per decade around each [-]."""
    firsts = {position.which: position for position in reversed(list(material_positions(Given.of(result))))}
    for which, position in sorted(firsts.items()):
        spectrum = loss_spectrum(result, of="body" if which == "body" else "counterbody")
        bands = bands_of(position.rolling_speed(result), result.mesh, _PER_DECADE)
        power = [float(spectrum.power @ bands.weight(i, spectrum.frequency)) for i in range(bands.centers.size)]
        name = "rolling body" if which == "body" else "counterbody"
        yield name, bands.centers, np.array(power) / spectrum.power.sum() * _PER_DECADE


def _shade_unmeasured(axes: Axes, measured: Range | None) -> None:
    if measured is None:
        return
    low, high = axes.get_xlim()
    axes.axvspan(min(low, measured[0]), measured[0], color="0.9", label="not measured", zorder=0)
    axes.axvspan(measured[1], max(high, measured[1]), color="0.9", zorder=0)
    axes.set_xlim(low, high)
