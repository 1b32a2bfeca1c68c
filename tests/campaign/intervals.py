"""Coverage of intervals: `python -m tests.campaign.intervals`.

The command simulates noisy sweeps of a known rubber at five temperatures, superposes them, draws moduli by a bootstrap,
and solves rolling at these temperatures. It reports the share of the data sets whose interval contains the result of
the rubber itself on the same mesh, for each temperature and in total, and the share of the power dissipated at
unmeasured frequencies, which the draws do not represent. With `--moduli`, it reports the coverage of the moduli. It
fails if the intervals of the torque contain the truth in less than nine of ten cases.
"""

from __future__ import annotations

import argparse
import sys
import time
import warnings
from dataclasses import dataclass

import numpy as np
import viscoroll as vr
from viscoroll.rheology import Isotherm, RheologyData

#: Least coverage of intervals of 95 %.
LEAST = 0.9

ANSWERS = ("resisting_torque", "dissipated_power", "penetration", "max_pressure")

#: Temperatures of the sweeps and of their master curve [K].
TEMPERATURES = (303.15, 313.15, 323.15, 333.15, 343.15)
REFERENCE = 323.15

#: Relaxation times [s] of a rubber of 25 terms over twelve decades; they are no powers of ten, unlike those of fits.
_TIMES = 0.7 * np.logspace(-9, 3, 25)
_SHAPE = np.exp(-0.5 * ((np.log10(_TIMES) + 5.0) / 1.8) ** 2)
RUBBER = vr.Prony(
    instantaneous_modulus=1e9, weights=0.9995 * _SHAPE / _SHAPE.sum(), relaxation_times=_TIMES * 10.0**-1.6
)
LAW = vr.materials.WilliamsLandelFerry(c1=10.0, c2=110.0, reference_temperature=REFERENCE)

#: Measured range of each sweep [rad/s].
LOWEST, HIGHEST = 0.1, 100.0

#: With 500 nodes per revolution, the contact at the lowest temperature has 55 nodes, and a fitted series has 1.8 % less
#: torque than the rubber, because both differ in phase at the highest frequency of the mesh. With 1000 nodes, the
#: difference is 0.2 %.
CASE = {"load": 30.0, "angular_speed": 3.0, "mesh": vr.Mesh(nodes_per_revolution=1000), "progress": False}


@dataclass(frozen=True)
class Noise:
    """Relative standard deviation of each measured modulus [-]."""

    storage: float = 0.03
    loss: float = 0.03


def true_modulus(temperature):
    """Return the rubber at a temperature [K]."""
    shift = float(LAW(temperature))
    return vr.Prony(
        instantaneous_modulus=RUBBER.instantaneous_modulus,
        weights=RUBBER.weights,
        relaxation_times=np.asarray(RUBBER.relaxation_times) * shift,
    )


def measured(seed, noise):
    """Return simulated rheometer data: three decades at each temperature, with seven points per decade."""
    generator = np.random.default_rng(seed)
    omega = np.geomspace(LOWEST, HIGHEST, 22)
    sweeps = []
    for temperature in TEMPERATURES:
        modulus = true_modulus(temperature).complex_modulus(omega)
        storage = modulus.real * (1.0 + noise.storage * generator.standard_normal(omega.size))
        loss = modulus.imag * (1.0 + noise.loss * generator.standard_normal(omega.size))
        sweeps.append(Isotherm(temperature=temperature, frequency=omega, storage=storage, loss=loss))
    return RheologyData(isotherms=tuple(sweeps), source="made", is_tensile=False, poisson_ratio=0.5, dropped=0)


def coated(modulus):
    """Return a ball with a core of 20 mm and 2 mm of this material."""
    return vr.CoatedSphere(
        core_radius=20e-3, layers=[vr.Layer(thickness=2e-3, shear_modulus=modulus, poisson_ratio=0.5)]
    )


def of_curve(curve, temperature):
    """Return the ball of a superposition at a temperature [K]."""
    return coated(curve.series_at(temperature=temperature))


def of_truth(temperature):
    """Return the ball of the rubber itself."""
    return coated(true_modulus(temperature))


def true_study():
    """Return the results of the rubber itself."""
    return vr.sweep(of_truth, temperature=TEMPERATURES, **CASE)


def unmeasured():
    """Return the share of the power dissipated at unmeasured frequencies, for each temperature [-]."""
    shifts = np.array([float(LAW(temperature)) for temperature in TEMPERATURES])
    given = {name: value for name, value in CASE.items() if name != "progress"}
    spectra = [vr.solve(of_truth(temperature), **given).loss_spectrum() for temperature in TEMPERATURES]
    ends = ((LOWEST * shifts.min() / shift, HIGHEST * shifts.max() / shift) for shift in shifts)
    return [spectrum.share_outside(low, high) for spectrum, (low, high) in zip(spectra, ends, strict=True)]


def study(seed, noise, *, draws=100, method="linear"):
    """Return results with intervals from one data set."""
    curve = vr.rheology.superpose(measured(seed, noise), reference=REFERENCE)
    return vr.sweep(of_curve, curve=curve.draws(draws, seed=seed), temperature=TEMPERATURES, draws=method, **CASE)


def coverage(found, truth):
    """Return whether intervals contain the truth (1 or 0), and errors per half width, shape (answers, temperatures).

    Results without an interval, such as a largest pressure at the edge, give NaN.
    """
    lower, upper, true, middle = (
        np.array([dataset[f"{answer}{bound}"].values for answer in ANSWERS])
        for dataset, bound in ((found, "_lower"), (found, "_upper"), (truth, ""), (found, ""))
    )
    holds = np.where(np.isnan(lower), np.nan, (lower <= true) & (true <= upper))
    return holds, (middle - true) / (0.5 * (upper - lower))


def torques(sets, draws, noise, method):
    """Print how often intervals of results contain the truth; return the share for the torque."""
    truth = true_study()
    inside, errors, widths, times = [], [], [], []
    for seed in range(sets):
        start = time.process_time()
        found = study(seed, noise, draws=draws, method=method)
        times.append(time.process_time() - start)
        holds, error = coverage(found, truth)
        inside.append(holds)
        errors.append(error)
        widths.append([(0.5 * (found[f"{a}_upper"] - found[f"{a}_lower"]) / found[a]).values for a in ANSWERS])
        print(f"\r{seed + 1} of {sets}", end="", file=sys.stderr, flush=True)
    print(file=sys.stderr)
    share, bias, width = np.nanmean(inside, axis=0), np.nanmean(errors, axis=0), np.nanmean(widths, axis=(0, 2))
    print(
        f"{sets} data sets with noise {noise.storage:.0%} and {noise.loss:.0%} (storage, loss), {draws} draws, "
        f"{method}: 95 % intervals at {', '.join(f'{t:g}' for t in TEMPERATURES)} K"
    )
    for answer, row, off, half in zip(ANSWERS, share, bias, width, strict=True):
        by_temperature = ", ".join(f"{value:.1%}" for value in row)
        print(
            f"{answer}: {np.nanmean(row):.1%} contain the true value ({by_temperature}); half-width {half:.2%}; "
            f"mean error {np.nanmean(off):+.2f} half-widths"
        )
    print(
        f"power dissipated at frequencies without measurements: {', '.join(f'{share:.0%}' for share in unmeasured())}"
    )
    print(f"processor time per data set: median {np.median(times):.1f} s, largest {max(times):.1f} s")
    return float(share[0].mean())


def moduli(sets, draws, noise):
    """Print how often intervals of moduli of a single curve contain the truth; return the share of both."""
    omega, probe = np.geomspace(1e-1, 1e5, 61), np.geomspace(0.3, 3e4, 25)
    modulus, true = RUBBER.complex_modulus(omega), RUBBER.complex_modulus(probe)
    inside, errors, start = [], [], time.process_time()
    for seed in range(sets):
        generator = np.random.default_rng(seed)
        storage = modulus.real * (1.0 + noise.storage * generator.standard_normal(omega.size))
        loss = modulus.imag * (1.0 + noise.loss * generator.standard_normal(omega.size))
        fit = vr.rheology.fit_prony(Isotherm(temperature=REFERENCE, frequency=omega, storage=storage, loss=loss))
        low, high = fit.confidence_band(probe, count=draws, seed=seed)
        inside.append(
            [(low.real <= true.real) & (true.real <= high.real), (low.imag <= true.imag) & (true.imag <= high.imag)]
        )
        found = fit.series.complex_modulus(probe)
        errors.append([found.real / true.real - 1.0, found.imag / true.imag - 1.0])
    share, error = np.array(inside), np.array(errors)
    print(f"{sets} data sets, {draws} draws each, {time.process_time() - start:.0f} s")
    for k, name in enumerate(("storage", "loss")):
        by_frequency = share[:, k].mean(axis=0)
        print(
            f"{name}: {share[:, k].mean():.1%} contain the true value, {by_frequency.min():.1%} to "
            f"{by_frequency.max():.1%} by frequency; error {np.sqrt((error[:, k] ** 2).mean()):.2%} rms, "
            f"largest {np.abs(error[:, k]).max():.1%}"
        )
    return float(share.mean())


def main():
    """Run the tests."""
    parser = argparse.ArgumentParser(prog="python -m tests.campaign.intervals", description=__doc__)
    parser.add_argument("--sets", type=int, default=200, help="number of data sets")
    parser.add_argument("--draws", type=int, default=100, help="number of draws for each data set")
    parser.add_argument(
        "--storage-noise", type=float, default=0.03, help="relative standard deviation of the storage modulus"
    )
    parser.add_argument(
        "--loss-noise", type=float, default=0.03, help="relative standard deviation of the loss modulus"
    )
    parser.add_argument("--whole", action="store_true", help="solve the contact for each draw")
    parser.add_argument("--moduli", action="store_true", help="test the intervals of moduli instead of torques")
    arguments = parser.parse_args()
    warnings.simplefilter("ignore", vr.ResultWarning)
    noise = Noise(arguments.storage_noise, arguments.loss_noise)
    if arguments.moduli:
        share = moduli(arguments.sets, arguments.draws, noise)
    else:
        share = torques(arguments.sets, arguments.draws, noise, "solve" if arguments.whole else "linear")
    return int(share < LEAST)


if __name__ == "__main__":
    raise SystemExit(main())
