"""What a network without rate loses on a path of strain that turns: springs and dry sliders side by side, in shear.

Each element follows the strain until it is off by its yield strain, and is dragged along from there (as in plasticity
with von Mises' stress). Weights are those of the hyperbolic first loading x/(1 + x), docs/theory/filled-rubber.md.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from ..materials.networks import hyperbolic_moduli

if TYPE_CHECKING:
    from .._support.arguments import Floats

__all__ = ["iwan_loss", "turning_ratio"]

#: Elements that yield on a straight path of the amplitude, and those that only a path which turns makes yield: a line
#: to 1e-7, contacts to 2e-5.
_ELEMENTS = (24, 6)

#: Rounds from rest; a contact's path has all but come round with the first.
_ROUNDS = 2

_TINY = 1e-300  # what a length is divided by at least

#: Radius of the smallest ball around any path, per amplitude: Jung's √(2n/(n + 1)), n = 5 of a deviator.
_LARGEST_YIELD = math.sqrt(10.0 / 6.0)


def turning_ratio(
    p: Floats, amplitude: Floats, yield_strain: float, *, elements: tuple[int, int] = _ELEMENTS
) -> Floats:
    """Return χ, what a network loses on paths over what it loses to and fro at their amplitudes.

    Parameters
    ----------
    p : ndarray, shape (points, steps, 6)
        Strain [-], a closed path.
    amplitude : ndarray, shape (points,)
        g, of `half_range` [-].
    yield_strain : float
        γ_c of the hyperbolic law [-]; infinite for the limit of small strain.
    elements : (int, int), default (24, 6)
        That yield on a straight path of the amplitude, and beyond.

    Returns
    -------
    ndarray, shape (points,)
        χ [-]; 1 on a line.
    """
    moving = amplitude > 1e-12 * max(float(amplitude.max(initial=0.0)), _TINY)
    ratio = np.ones(len(p))
    if moving.any():
        g = amplitude[moving]
        # At small strain a law without any softening would lose nothing: the limit of χ is that of little softening.
        scale = np.minimum(yield_strain, 1e3 * g)
        x = g / scale
        lost = iwan_loss(p[moving] / scale[:, None, None], x, elements=elements)
        ratio[moving] = lost / (math.pi * x**2 * hyperbolic_moduli(x)[1])
    return ratio


def iwan_loss(p: Floats, amplitude: Floats, *, rounds: int = _ROUNDS, elements: tuple[int, int] = _ELEMENTS) -> Floats:
    """Return the energy lost in one round of closed paths, by the modulus and γ_c² [-].

    Between two places the strain goes straight, and along such a step the elements are followed exactly.

    Parameters
    ----------
    p : ndarray, shape (points, steps, 6)
        Strain by γ_c [-].
    amplitude : ndarray, shape (points,)
        Of the paths, by γ_c [-], > 0.
    rounds : int, default 2
        Rounds made from rest, of which the last counts.
    elements : (int, int), default (24, 6)
        As of `turning_ratio`.
    """
    yields, weights = _elements(amplitude, *elements)
    stress = np.zeros((*yields.shape, p.shape[2]))
    lost = np.zeros(len(p))
    changes = np.moveaxis(np.diff(p, axis=1, append=p[:, :1]), 1, 0)
    stress, _ = _after(stress, p[:, 0], yields)
    for turn in range(rounds):
        for change in changes:
            stress, dissipated = _after(stress, change, yields)
            if turn == rounds - 1:
                lost += (weights * dissipated).sum(axis=1)
    return lost


def _after(stress: Floats, change: Floats, yields: Floats) -> tuple[Floats, Floats]:
    """Return stress by modulus after a straight step of strain, and what was lost in it by the modulus.

    An element that is dragged turns towards the step: the tangent of half the angle between the two falls like
    exp(-way/yield strain), and its share along the step, summed up, is what it loses.
    """
    length = np.sqrt((change**2).sum(axis=1))[:, None]
    along = change / np.maximum(length, _TINY)
    tried = stress + change[:, None, :]
    slides = np.einsum("pyk,pyk->py", tried, tried) > yields**2
    if not slides.any():
        return tried, np.zeros(yields.shape)
    share = np.einsum("pyk,pk->py", stress, along)
    across = np.einsum("pyk,pyk->py", stress, stress) - share**2
    # Where along the step the yield strain is reached, and what is left of the step from there.
    ahead = np.sqrt(np.maximum(yields**2 - across, 0.0))
    way = np.where(slides, np.clip(length - (ahead - share), 0.0, length), 0.0)
    half = np.sqrt(np.maximum(across, 0.0)) / (yields + ahead)
    fall = np.exp(-way / yields)
    ratio = (1.0 + half**2) / (1.0 + (half * fall) ** 2)
    cosine = (1.0 - (half * fall) ** 2) / (1.0 + (half * fall) ** 2)
    turned = (fall * ratio)[:, :, None] * (stress - share[:, :, None] * along[:, None, :])
    dragged = turned + (yields * cosine)[:, :, None] * along[:, None, :]
    return np.where(slides[:, :, None], dragged, tried), yields**2 * np.where(slides, way / yields - np.log(ratio), 0.0)


def _elements(amplitude: Floats, within: int, further: int) -> tuple[Floats, Floats]:
    """Return yield strains and weights of elements, (points, elements), for paths of an amplitude each.

    The weight -F''(y) dy = 2 dy/(1 + y)³ is 2 (1 - t) dt with t = y/(1 + y). Losses end at the amplitude as √ or as a
    kink, so up to there t goes as a sine.
    """
    angle, angle_weight = _gauss(within, 0.5 * math.pi)
    part, part_weight = _gauss(further, 1.0)
    ends = amplitude / (1.0 + amplitude)
    beyond = _LARGEST_YIELD * amplitude
    rest = beyond / (1.0 + beyond) - ends
    t = np.concatenate([ends[:, None] * np.sin(angle), ends[:, None] + rest[:, None] * part], axis=1)
    dt = np.concatenate([ends[:, None] * np.cos(angle) * angle_weight, rest[:, None] * part_weight], axis=1)
    return t / (1.0 - t), 2.0 * (1.0 - t) * dt


def _gauss(count: int, length: float) -> tuple[Floats, Floats]:
    nodes, weights = np.polynomial.legendre.leggauss(count)
    return 0.5 * length * (1.0 + nodes), 0.5 * length * weights
