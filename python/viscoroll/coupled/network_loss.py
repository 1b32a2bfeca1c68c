"""Dissipation of a rate-independent network along strain paths with rotating axes: parallel springs and sliders.

The stress of an element is proportional to the strain until its elastic strain reaches the yield strain; the element
then slides (as in plasticity with the von Mises stress). The weights of the elements give the hyperbolic first loading
curve x/(1 + x); see docs/theory/filled-rubber.md.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from ..materials.networks import hyperbolic_moduli

if TYPE_CHECKING:
    from .._support.arguments import Floats

__all__ = ["iwan_loss", "turning_ratio"]

#: Number of elements that yield on a straight path of the given amplitude, and of those that yield only on other paths.
#: The relative error of the loss is 1e-7 on straight paths and 2e-5 in contacts.
_ELEMENTS = (24, 6)

#: Number of rounds of a closed path from rest; after the first round, the stress is almost periodic.
_ROUNDS = 2

_TINY = 1e-300  # smallest divisor of a length

#: Largest yield strain of an element that slides, divided by the amplitude of the path: the radius of the smallest ball
#: around any path, √(2n/(n + 1)) by Jung's theorem with the dimension n = 5 of a deviator.
_LARGEST_YIELD = math.sqrt(10.0 / 6.0)


def turning_ratio(
    p: Floats, amplitude: Floats, yield_strain: float, *, elements: tuple[int, int] = _ELEMENTS
) -> Floats:
    """Return χ, the ratio of the network's loss on paths to that on straight paths of the same amplitude.

    Parameters
    ----------
    p : ndarray, shape (points, steps, 6)
        Strain along a closed path [-].
    amplitude : ndarray, shape (points,)
        Amplitudes g of `half_range` [-].
    yield_strain : float
        Yield strain γ_c of the hyperbolic law [-]; infinite for the limit of small strain.
    elements : (int, int), default (24, 6)
        Number of elements that yield on a straight path of that amplitude, and of those that yield only on others.

    Returns
    -------
    ndarray, shape (points,)
        χ [-]; 1 on a straight path.
    """
    moving = amplitude > 1e-12 * max(float(amplitude.max(initial=0.0)), _TINY)
    ratio = np.ones(len(p))
    if moving.any():
        g = amplitude[moving]
        # At an amplitude of 0 both losses are 0. An amplitude of 1e-3 γ_c gives the limit of χ at small strain.
        scale = np.minimum(yield_strain, 1e3 * g)
        x = g / scale
        lost = iwan_loss(p[moving] / scale[:, None, None], x, elements=elements)
        ratio[moving] = lost / (math.pi * x**2 * hyperbolic_moduli(x)[1])
    return ratio


def iwan_loss(p: Floats, amplitude: Floats, *, rounds: int = _ROUNDS, elements: tuple[int, int] = _ELEMENTS) -> Floats:
    """Return the energy dissipated in one round of closed paths, divided by the modulus and γ_c² [-].

    The path is straight between its steps. The elements are integrated exactly on each straight part.

    Parameters
    ----------
    p : ndarray, shape (points, steps, 6)
        Strain divided by γ_c [-].
    amplitude : ndarray, shape (points,)
        Amplitude of the paths divided by γ_c [-], > 0.
    rounds : int, default 2
        Number of rounds from rest; only the last one counts.
    elements : (int, int), default (24, 6)
        Same as in `turning_ratio`.

    Returns
    -------
    ndarray, shape (points,)
        Energy per volume / (N γ_c²) [-].
    """
    yields, weights = _elements(amplitude, *elements)
    stress = np.zeros((*yields.shape, p.shape[2]))
    lost = np.zeros(len(p))
    changes = np.moveaxis(np.diff(p, axis=1, append=p[:, :1]), 1, 0)
    stress, _ = _stepped(stress, p[:, 0], yields)
    for turn in range(rounds):
        for change in changes:
            stress, dissipated = _stepped(stress, change, yields)
            if turn == rounds - 1:
                lost += (weights * dissipated).sum(axis=1)
    return lost


def _stepped(stress: Floats, change: Floats, yields: Floats) -> tuple[Floats, Floats]:
    """Return the stress after a straight step of strain and the energy dissipated in it, both divided by the modulus.

    The stress of a sliding element rotates towards the direction of the step: the tangent of half the angle between
    them decreases like exp(-sliding length/yield strain). The energy is the integral of the stress along the step.
    """
    length = np.sqrt((change**2).sum(axis=1))[:, None]
    direction = change / np.maximum(length, _TINY)
    trial = stress + change[:, None, :]
    slides = np.einsum("pyk,pyk->py", trial, trial) > yields**2
    if not slides.any():
        return trial, np.zeros(yields.shape)
    parallel = np.einsum("pyk,pk->py", stress, direction)
    across = np.einsum("pyk,pyk->py", stress, stress) - parallel**2
    # Component along the step at which the yield strain is reached, and length of the rest of the step.
    at_yield = np.sqrt(np.maximum(yields**2 - across, 0.0))
    sliding_length = np.where(slides, np.clip(length - (at_yield - parallel), 0.0, length), 0.0)
    half = np.sqrt(np.maximum(across, 0.0)) / (yields + at_yield)
    decay = np.exp(-sliding_length / yields)
    ratio = (1.0 + half**2) / (1.0 + (half * decay) ** 2)
    cosine = (1.0 - (half * decay) ** 2) / (1.0 + (half * decay) ** 2)
    turned = (decay * ratio)[:, :, None] * (stress - parallel[:, :, None] * direction[:, None, :])
    sliding = turned + (yields * cosine)[:, :, None] * direction[:, None, :]
    return np.where(slides[:, :, None], sliding, trial), yields**2 * np.where(
        slides, sliding_length / yields - np.log(ratio), 0.0
    )


def _elements(amplitude: Floats, within: int, further: int) -> tuple[Floats, Floats]:
    """Return yield strains and weights of the elements, (points, elements), for a path amplitude per point.

    The weight -F''(y) dy = 2 dy/(1 + y)³ is 2 (1 - t) dt with t = y/(1 + y). As a function of y, the loss has a square
    root or a kink at the amplitude. Up to the amplitude, t is therefore a sine of angles that are Gauss points.
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
