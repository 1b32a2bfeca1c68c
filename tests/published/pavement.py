"""Layered planes with ν < ½ under a disc: ELLEA1 at rest, ELLVA for moving loads (E. Levenberg, printed by ALVA).

The plane consists of asphalt on a base on soil. The fields are sums over the library's orders of this plane. The
pressure q of a disc of radius a has the Hankel transform q a J₁(ka)/k; the displacement of a point off the path is a
sum over all directions of waves.
"""

from __future__ import annotations

import csv
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import viscoroll as vr
from scipy.optimize import nnls
from scipy.special import j0, j1
from viscoroll.solution.interior_fields import order_fields

RADIUS, PRESSURE = 0.15, 1.1e6  # radius and pressure of the disc [m], [Pa]
BASE, SOIL = (0.6, 200e6, 0.35), (40e6, 0.40)  # thickness [m], Young's modulus [Pa], Poisson's ratio
ASPHALT_THICKNESS, ASPHALT_RATIO, ASPHALT = 0.15, 0.30, 3000e6

# speed of the disc [m/s]; distance of the point from the disc's path [m]
SPEED, BESIDE = 60.0 / 3.6, 0.3

#: Creep of the asphalt in tension, D∞ + (D₀ - D∞) / (1 + (t/τ)^n) [1/Pa, s].
GLASSY, RUBBERY, EXPONENT, RETARDATION = 2.5e-11, 1e-8, 0.35, 1e3

_LARGEST_ORDER = 990_000  # the library allows a million


def printed(name: str) -> dict[str, np.ndarray]:
    """Return the columns of a file of data."""
    with (Path(__file__).parent / "data" / name).open(encoding="utf-8") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    return {column: np.array([float(row[column]) for row in rows]) for column in rows[0]}


def plane(asphalt) -> vr.CoatedPlane:
    """Return the layered plane; `asphalt` is the shear modulus of the asphalt."""
    thickness, young, ratio = BASE
    base = vr.Layer(thickness=thickness, shear_modulus=_elastic(young, ratio), poisson_ratio=ratio)
    top = vr.Layer(thickness=ASPHALT_THICKNESS, shear_modulus=asphalt, poisson_ratio=ASPHALT_RATIO)
    soil = vr.HalfSpace(shear_modulus=_elastic(*SOIL), poisson_ratio=SOIL[1])
    return vr.CoatedPlane(layers=[base, top], base=soil)


def _elastic(young: float, ratio: float) -> vr.Elastic:
    return vr.Elastic(modulus=young / (2.0 * (1.0 + ratio)))


@dataclass(frozen=True)
class Waves:
    """Wave numbers up to a largest one: Gauss points in intervals of `step`, shorter for long waves, rounded to orders.

    Attributes
    ----------
    radius : float
        Radius on which the waves are integer orders [m].
    number : ndarray
        k [1/m].
    load : ndarray
        Weight times transform of the disc's pressure, k q(k) dk [Pa].
    """

    radius: float
    number: np.ndarray
    load: np.ndarray

    @classmethod
    def up_to(cls, highest: float, step: float) -> Waves:
        """Return wave numbers up to `highest`, with four per interval of `step` [1/m]."""
        edges = np.concatenate([[0.0], np.geomspace(1e-3, 1.0, 15), np.arange(1.0 + step, highest, step)])
        places, weights = np.polynomial.legendre.leggauss(4)
        half = 0.5 * np.diff(edges)[:, None]
        radius = _LARGEST_ORDER / highest
        k = np.maximum(np.rint((edges[:-1, None] + half * (1.0 + places)).ravel() * radius), 1.0) / radius
        return cls(radius, k, (half * weights).ravel() * j1(k * RADIUS) * RADIUS * PRESSURE)

    def fields(self, body: vr.CoatedPlane, depth: float, *, along=None, across=None, speed: float = 1.0):
        """Return displacement and stress per unit surface stress, by default for waves along the path."""
        along = self.number if along is None else along
        across = np.zeros_like(along) if across is None else across
        orders = [np.rint(waves * self.radius).astype(int).ravel() for waves in (along, across)]
        turning = speed / self.radius
        displacement, stress, _ = order_fields(body, turning, *orders, depth=[depth], rolling_radius=self.radius)
        return displacement[:, 0, :, 0], stress[:, 0, :, 0]  # at an interface, the upper layer


def at_rest(depth: float) -> tuple[float, float, float]:
    """Return deflection [m], vertical and horizontal pressure [Pa] on the axis of a disc at rest, at a depth [m]."""
    # The pressure jumps at the edge of the disc, so shorter waves contribute 1e-4 of the deflection.
    waves = Waves.up_to(490.0, 1.5)
    displacement, stress = waves.fields(plane(_elastic(ASPHALT, ASPHALT_RATIO)), depth)
    horizontal = 0.5 * (stress[:, 1] + stress[:, 2])  # mean over all directions
    return tuple(float(waves.load @ part.real) for part in (displacement[:, 0], stress[:, 0], horizontal))


def creep(time):
    """Return the asphalt's compliance in tension after a time [s]."""
    return RUBBERY + (GLASSY - RUBBERY) / (1.0 + (np.asarray(time) / RETARDATION) ** EXPONENT)


def asphalt_modulus():
    """Return the complex shear modulus of this creep as a function of frequency, by a spectrum accurate to 1e-6."""
    times, retardation = np.geomspace(1e-9, 1e6, 400), np.geomspace(1e-10, 1e9, 77)
    wanted = creep(times) - GLASSY
    steps = 1.0 - np.exp(-times[:, None] / retardation)
    weights, _ = nnls(steps / wanted[:, None], np.ones_like(wanted))
    assert np.abs(steps @ weights / wanted - 1.0).max() < 1e-6

    def modulus(omega):
        compliance = GLASSY + (weights / (1.0 + 1j * np.asarray(omega)[..., None] * retardation)).sum(-1)
        return 1.0 / (2.0 * (1.0 + ASPHALT_RATIO) * compliance)

    return modulus


def moving(past) -> np.ndarray:
    """Return the deflection [m] of the point when the disc is `past` [m] beyond it, from complex moduli."""
    waves = Waves.up_to(62.0, 1.0)
    direction, turn = np.polynomial.legendre.leggauss(256)
    # Gauss points of the direction over a quarter turn.
    direction, turn = 0.25 * np.pi * (1.0 + direction), 0.25 * np.pi * turn
    along = np.maximum(np.rint(np.outer(waves.number, np.cos(direction)) * waves.radius), 1.0) / waves.radius
    across = np.outer(waves.number, np.sin(direction))
    displacement, _ = waves.fields(plane(asphalt_modulus()), 0.0, along=along, across=across, speed=SPEED)
    parts = displacement[:, 0].reshape(along.shape) * np.cos(across * BESIDE)
    parts *= waves.load[:, None] * turn * (2.0 / np.pi)  # four quarters of a turn
    return np.array([(parts * np.exp(1j * along * x)).real.sum() for x in np.atleast_1d(past)])


def moving_quasi_elastic(past, *, start: float = -5.0) -> np.ndarray:
    """Return the deflection computed as in ELLVA: elastic deflections with moduli 1/D(age), summed from `start`.

    Only the compliance is computed by the library.
    """
    waves = Waves.up_to(62.0, 0.5)
    places = np.linspace(start, -start, 201)
    shapes = waves.load[:, None] * j0(np.outer(waves.number, np.hypot(places, BESIDE)))
    ages = np.concatenate([[0.0], np.geomspace(1e-6, -2.0 * start / SPEED, 60)])
    bodies = [plane(_elastic(1.0 / creep(age), ASPHALT_RATIO)) for age in ages]
    deflections = np.array([waves.fields(body, 0.0)[0][:, 0].real @ shapes for body in bodies])

    def at(x: float) -> float:
        steps = np.concatenate([[0.0], np.geomspace(1e-6, (x - start) / SPEED, 400)])
        then = x - SPEED * 0.5 * (steps[1:] + steps[:-1])
        grown = np.array([np.interp(steps, ages, column) for column in deflections.T])
        later = sum(np.interp(place, places, gain) for place, gain in zip(then, np.diff(grown).T, strict=True))
        return np.interp(x, places, deflections[0]) + later

    return np.array([at(x) for x in np.atleast_1d(past)])
