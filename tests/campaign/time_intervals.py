"""Coverage of intervals of relaxation and creep: `python -m tests.campaign.time_intervals`.

The command simulates stress relaxation, creep and frequency sweeps of a known rubber at three temperatures with noise,
fits one spectrum to each set of tests, draws materials by a bootstrap, and solves rolling. It reports the share of the
data sets whose interval contains the true modulus and the true torque. It fails if the intervals of 95 % contain the
truth in less than 90 % or more than 99 % of the cases on average, or if the torque of tests over time and that of
sweeps differ by more than their intervals in more than a tenth of the data sets.
"""

from __future__ import annotations

import argparse
import sys

import numpy as np
import viscoroll as vr
from viscoroll._support.intervals import interval_half_width
from viscoroll.rheology import Isotherm, TimeTest, fit_spectrum

#: Least and largest coverage of intervals of 95 %: 100 data sets give the share to 2 %.
LEAST, MOST = 0.9, 0.99

TEMPERATURES = (303.15, 323.15, 343.15)
REFERENCE = 323.15
LAW = vr.materials.WilliamsLandelFerry(c1=10.0, c2=110.0, reference_temperature=REFERENCE)

#: Relaxation times [s] of a rubber of 23 terms over eleven decades; they are no powers of ten, unlike those of fits.
_TIMES = 0.7 * np.logspace(-6, 5, 23)
_SHAPE = np.exp(-0.5 * ((np.log10(_TIMES) + 0.5) / 2.0) ** 2)
_MODULUS, _WEIGHTS = 1e7, 0.9 * _SHAPE / _SHAPE.sum()

#: Times of the tests over time [s] and frequencies of the sweeps [rad/s].
TIMES, FREQUENCIES = np.geomspace(0.1, 1e3, 30), np.geomspace(1e-3, 10.0, 30)

#: Frequencies at which moduli are compared: those of all measurements without the ends [rad/s].
PROBES = np.geomspace(3e-3, 3.0, 7)

CASE = {"load": 30.0, "angular_speed": 0.01, "mesh": vr.Mesh(nodes_per_revolution=500), "progress": False}

KINDS = ("relaxation", "creep", "both", "sweeps", "all")


def true_modulus(temperature=REFERENCE):
    """Return the rubber at a temperature [K]."""
    times = _TIMES * float(LAW(temperature))
    return vr.Prony(instantaneous_modulus=_MODULUS, weights=_WEIGHTS, relaxation_times=times)


def relaxation(time, temperature):
    """Return G(t) of the rubber [Pa]."""
    times = _TIMES * float(LAW(temperature))
    return _MODULUS * (1.0 - _WEIGHTS.sum() + np.exp(-time[:, None] / times) @ _WEIGHTS)


def creep(time, temperature):
    """Return 1/J(t) of the rubber [Pa], from the eigenvalues of the rate equations of its terms.

    With the strains e_k of the dashpots, τ_k de_k/dt = e - e_k, and the total strain e = (σ + Σ g_k e_k)/G₀ at the
    stress σ = 1. The equations are symmetric in √(g_k τ_k) e_k.
    """
    times, terms = _TIMES * float(LAW(temperature)), _MODULUS * _WEIGHTS
    vector = np.sqrt(terms / times)
    rates, modes = np.linalg.eigh(np.diag(1.0 / times) - np.outer(vector, vector) / _MODULUS)
    amplitudes = (modes.T @ vector) ** 2
    compliance = 1.0 / _MODULUS - (np.expm1(-np.outer(time, rates)) / rates) @ amplitudes / _MODULUS**2
    return 1.0 / compliance


def measured(seed, noise, kind):
    """Return simulated tests of a kind, one of `KINDS`, at all temperatures."""
    generator = np.random.default_rng(seed)

    def noisy(values):
        return values * (1.0 + noise * generator.standard_normal(values.size))

    tests = []
    for kelvin in TEMPERATURES:
        modulus = true_modulus(kelvin).complex_modulus(FREQUENCIES)
        every = {
            "relaxation": TimeTest(
                kind="relaxation", time=TIMES, modulus=noisy(relaxation(TIMES, kelvin)), temperature=kelvin
            ),
            "creep": TimeTest(kind="creep", time=TIMES, modulus=noisy(creep(TIMES, kelvin)), temperature=kelvin),
            "sweeps": Isotherm(
                temperature=kelvin, frequency=FREQUENCIES, storage=noisy(modulus.real), loss=noisy(modulus.imag)
            ),
        }
        wanted = {"both": ("relaxation", "creep"), "all": tuple(every)}.get(kind, (kind,))
        tests += [every[name] for name in wanted]
    return tests


def ball(modulus):
    """Return a ball with a core of 20 mm and 2 mm of this material."""
    return vr.CoatedSphere(
        core_radius=20e-3, layers=[vr.Layer(thickness=2e-3, shear_modulus=modulus, poisson_ratio=0.5)]
    )


def torque_interval(draws):
    """Return the torque of draws of a fit and half the width of its interval of 95 % [N m]."""
    found = vr.sweep(lambda fit: ball(fit.series), fit=draws, draws="linear", **CASE)
    lower, upper = float(found["resisting_torque_lower"]), float(found["resisting_torque_upper"])
    return float(found["resisting_torque"]), 0.5 * (upper - lower)


def moduli_inside(seed, noise, kind, draws):
    """Return whether intervals of storage and loss contain the truth, and the draws of the fit."""
    fit = fit_spectrum(measured(seed, noise, kind), reference=REFERENCE)
    drawn = fit.draws(draws, seed=seed)
    moduli = np.array([one.series.complex_modulus(PROBES) for one in drawn])
    found, true = fit.series.complex_modulus(PROBES), true_modulus().complex_modulus(PROBES)
    half = [interval_half_width(part, 0.95) for part in (moduli.real, moduli.imag)]
    inside = [np.abs(found.real - true.real) <= half[0], np.abs(found.imag - true.imag) <= half[1]]
    return np.array(inside), drawn


def main():
    """Run the tests."""
    parser = argparse.ArgumentParser(prog="python -m tests.campaign.time_intervals", description=__doc__)
    parser.add_argument("--sets", type=int, default=100, help="number of data sets")
    parser.add_argument("--draws", type=int, default=50, help="number of draws for each data set")
    parser.add_argument("--noise", type=float, default=0.01, help="relative standard deviation of all moduli")
    parser.add_argument("--kinds", nargs="+", choices=KINDS, default=list(KINDS[:4]), help="tests that are fitted")
    arguments = parser.parse_args()
    truth = vr.solve(ball(true_modulus()), **CASE).resisting_torque
    has_failed = False
    torques = {}
    for kind in arguments.kinds:
        inside, found = [], []
        for seed in range(arguments.sets):
            holds, drawn = moduli_inside(seed, arguments.noise, kind, arguments.draws)
            inside.append(holds)
            found.append(torque_interval(drawn))
            print(f"\r{kind}: {seed + 1} of {arguments.sets}", end="", file=sys.stderr, flush=True)
        print(file=sys.stderr)
        share, torques[kind] = np.mean(inside, axis=0), np.array(found)
        covered = np.abs(torques[kind][:, 0] - truth) <= torques[kind][:, 1]
        width = np.mean(torques[kind][:, 1] / truth)
        print(
            f"{kind}: true value in the interval for {share[0].mean():.1%} (storage), {share[1].mean():.1%} (loss), "
            f"{covered.mean():.1%} (torque, half-width {width:.2%}) of {arguments.sets} data sets; lowest at one "
            f"frequency {share.min():.1%}"
        )
        has_failed |= not LEAST <= share.mean() <= MOST or not covered.mean() >= LEAST
    for kind in torques.keys() - {"sweeps"} if "sweeps" in torques else ():
        difference = np.abs(torques[kind][:, 0] - torques["sweeps"][:, 0])
        agree = np.mean(difference <= np.hypot(torques[kind][:, 1], torques["sweeps"][:, 1]))
        print(f"{kind}: torque equals that of sweeps within both intervals in {agree:.1%} of the data sets")
        has_failed |= agree < LEAST
    return int(has_failed)


if __name__ == "__main__":
    raise SystemExit(main())
