"""How often bootstrap intervals hold the truth: python tests/interval_coverage.py [data sets [resamples]]."""

from __future__ import annotations

import sys
import time
from types import SimpleNamespace

import numpy as np
import viscoroll as vr

KNOWN = vr.Prony(
    instantaneous_modulus=2e7,
    weights=[0.05, 0.06, 0.08, 0.1, 0.12, 0.1, 0.09, 0.08, 0.06],
    relaxation_times=0.37 * np.logspace(-4, 0, 9),
)
NOISE = 0.03


def main(trials: int = 500, resamples: int = 300) -> None:
    """Count how often 95 % intervals hold the true moduli at 25 frequencies."""
    omega, probe = np.geomspace(0.1, 1e5, 61), np.geomspace(0.3, 3e4, 25)
    modulus, true = KNOWN.complex_modulus(omega), KNOWN.complex_modulus(probe)
    inside, errors = [], []
    start = time.process_time()
    for seed in range(trials):
        generator = np.random.default_rng(seed)
        storage = modulus.real * (1.0 + NOISE * generator.standard_normal(omega.size))
        loss = modulus.imag * (1.0 + NOISE * generator.standard_normal(omega.size))
        fit = vr.fit_prony(SimpleNamespace(frequency=omega, storage=storage, loss=loss))
        low, high = fit.confidence_band(probe, trials=resamples, seed=seed)
        inside.append(
            [(low.real <= true.real) & (true.real <= high.real), (low.imag <= true.imag) & (true.imag <= high.imag)]
        )
        found = fit.series.complex_modulus(probe)
        errors.append([found.real / true.real - 1.0, found.imag / true.imag - 1.0])
    share, error = np.array(inside), np.array(errors)
    print(f"{trials} data sets with {NOISE:.0%} noise, {resamples} resamples each, {time.process_time() - start:.0f} s")
    for k, name in enumerate(("storage", "loss")):
        by_frequency = share[:, k].mean(axis=0)
        print(
            f"{name}: covered {share[:, k].mean():.1%}, {by_frequency.min():.1%} to {by_frequency.max():.1%} by "
            f"frequency; error {np.sqrt((error[:, k] ** 2).mean()):.2%} rms, {np.abs(error[:, k]).max():.1%} at most"
        )


if __name__ == "__main__":
    main(*map(int, sys.argv[1:]))
