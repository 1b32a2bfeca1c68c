"""Long-time limit of a loss factor from a compression set or a creep test, against Laplace transforms."""

from __future__ import annotations

import warnings

import mpmath
import numpy as np
import pytest
import viscoroll as vr
from viscoroll.case import load_case
from viscoroll.materials.shift import scaled, shifted

DAY = 86400.0
PAD = {"modulus": 1e6, "loss_factor": 0.1, "reference_frequency": 100.0}
SET = {"compression_set": 0.2, "compression_time": DAY}
CREEP = {"creep_ratio": 1.3, "creep_start": 60.0, "creep_time": 1e6}


def terms(material):
    relaxation = material._relaxation()
    moduli, times = relaxation.moduli[:-1], relaxation.times[:-1]
    return float(relaxation.moduli[-1]), moduli.tolist(), times.tolist()


def operational_modulus(material):
    """Return μ(s) = M_∞ + Σ M_k s τ_k / (1 + s τ_k) as a function."""
    relaxed, moduli, times = terms(material)
    return lambda s: relaxed + sum(m * s * t / (1 + s * t) for m, t in zip(moduli, times, strict=True))


def remaining_strain(material, duration, recovery):
    """Return the strain at `recovery` after a strain of 1 over `duration`, by an inverse Laplace transform."""
    _, moduli, times = terms(material)
    modulus = operational_modulus(material)
    held = [m * t * -np.expm1(-duration / t) for m, t in zip(moduli, times, strict=True)]

    def transform(s):
        return sum(h / (1 + s * t) for h, t in zip(held, times, strict=True)) / modulus(s)

    return float(mpmath.invertlaplace(transform, recovery, method="talbot"))


def creep_strain(material, time):
    modulus = operational_modulus(material)
    return float(mpmath.invertlaplace(lambda s: 1 / (s * modulus(s)), time, method="talbot"))


@pytest.mark.parametrize(
    ("loss_factor", "decades", "compression_set", "duration", "recovery"),
    [
        (0.1, 3.0, 0.2, DAY, None),
        (0.1, 3.0, 0.02, 3 * DAY, None),
        (0.3, 1.0, 0.6, DAY, 600.0),
        (0.02, 3.0, 0.9, DAY, 1.0),
    ],
)
def test_the_material_has_the_set(loss_factor, decades, compression_set, duration, recovery):
    pad = vr.LossFactor(
        modulus=1e6, loss_factor=loss_factor, reference_frequency=100.0, decades=decades,
        compression_set=compression_set, compression_time=duration, recovery_time=recovery,
    )  # fmt: skip
    found = remaining_strain(pad, duration, 1800.0 if recovery is None else recovery)
    assert found == pytest.approx(compression_set, rel=1e-5)  # terms below 1e-6 of the shortest time are left out


def test_a_slow_relaxation_between_recovery_and_compression_is_the_set():
    """To first order in the relaxation, G(t_c + t_r) = (1 - set) G(t_r)."""
    pad = vr.LossFactor(**PAD | {"loss_factor": 0.01}, compression_set=0.02, compression_time=DAY)
    relaxed, moduli, times = terms(pad)
    later, sooner = (relaxed + np.dot(moduli, np.exp(-t / np.array(times))) for t in (DAY + 1800.0, 1800.0))
    assert later / sooner == pytest.approx(0.98, abs=5e-4)


def test_the_material_creeps_as_measured():
    pad = vr.LossFactor(**PAD, **CREEP)
    assert creep_strain(pad, 1e6) / creep_strain(pad, 60.0) == pytest.approx(1.3, rel=1e-5)


def test_the_loss_factor_within_its_range_remains():
    """The last decade of the range is close to the slow relaxation, whose loss is smaller here."""
    plain, pad = vr.LossFactor(**PAD), vr.LossFactor(**PAD, **SET)
    for low, error in ((1e0, 0.005), (1e-1, 0.06)):
        modulus = pad.complex_modulus(np.geomspace(low, 1e5, 200))
        np.testing.assert_allclose(modulus.imag / modulus.real, 0.1, rtol=error)
    assert pad.complex_modulus(100.0).real == pytest.approx(1e6, rel=1e-12)
    rest = [float(one.complex_modulus(0.0).real) for one in (plain, pad)]
    assert rest[1] < 0.95 * rest[0]


def test_a_larger_set_is_a_smaller_modulus_at_rest():
    sets = np.linspace(0.02, 0.9, 12)
    rest = [float(vr.LossFactor(**PAD, **SET | {"compression_set": s}).complex_modulus(0.0).real) for s in sets]
    assert (np.diff(rest) < 0.0).all()


def test_units_of_the_times():
    pad = vr.LossFactor(**PAD, **SET)
    slower = shifted(scaled(pad, 2.0), 10.0)
    assert (slower.compression_time, slower.recovery_time, slower.modulus) == (10 * DAY, None, 2e6)
    omega = np.geomspace(1e-3, 1e3, 7)
    given = vr.LossFactor(**PAD, **SET, recovery_time=1800.0)
    np.testing.assert_allclose(
        shifted(given, 10.0).complex_modulus(omega), given.complex_modulus(10.0 * omega), rtol=1e-9
    )


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({"compression_set": 20.0, "compression_time": DAY}, r"compression_set must be in \(0, 1\), .* 20 % is 0.2"),
        ({"compression_set": 0.0, "compression_time": DAY}, r"compression_set must be in \(0, 1\)"),
        ({"compression_set": 0.2}, "compression_time must be given with compression_set"),
        ({"compression_time": DAY}, "compression_time must be left out without compression_set, got 86400"),
        ({"recovery_time": 60.0}, "recovery_time must be left out without compression_set"),
        ({**SET, "recovery_time": 0.0}, "recovery_time must be > 0 s"),
        ({**SET, "compression_time": 50.0}, r"compression_time must be > 100 s = .*; reduce decades, got 50"),
        ({**SET, "compression_set": 0.999}, r"compression_set must be in \[2.*e-09, 0.99.*\] for this loss factor"),
        ({**SET, **CREEP}, "creep_ratio must be left out with compression_set, got 1.3"),
        ({**CREEP, "creep_ratio": 0.9}, "creep_ratio must be > 1, got 0.9"),
        ({"creep_ratio": 1.2, "creep_time": 1e5}, "creep_start must be given with creep_ratio"),
        ({**CREEP, "creep_time": 30.0}, "creep_time must be > creep_start = 60 s, got 30"),
        ({"creep_start": 60.0}, "creep_start must be left out without creep_ratio"),
    ],
)
def test_messages(given, message):
    with pytest.raises(vr.InvalidInput, match=message):
        vr.LossFactor(**PAD, **given)


def test_histories_warn_of_times_beyond_the_test_only():
    layer = vr.Layer(thickness=10e-3, shear_modulus=vr.LossFactor(**PAD, **SET), poisson_ratio=0.49)
    wheel = vr.CoatedCylinder(core_radius=40e-3, layers=[layer])
    for duration, count in ((0.9 * DAY, 0), (3 * DAY, 1)):
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            vr.roll(wheel, time=[0.0, duration], angle=[0.0, 0.0], load=1e3, start="undeformed",
                    mesh=vr.Mesh(nodes_per_revolution=100), averaged_meshes=1)  # fmt: skip
        texts = [str(one.message) for one in caught if "the motion lasts" in str(one.message)]
        assert len(texts) == count
        assert all("the compression set is measured up to 8.64e+04 s only" in text for text in texts)


def test_case_files_take_the_set(tmp_path):
    case = tmp_path / "case.toml"
    text = "type = 'loss_factor', modulus = 1e6, loss_factor = 0.1, reference_frequency = 100.0"
    case.write_text(
        "[ball]\ncore_radius = 20e-3\n[[ball.layers]]\nthickness = 2e-3\npoisson_ratio = 0.5\n"
        f"shear_modulus = {{ {text}, compression_set = 0.2, compression_time = 86400.0 }}\n"
        "[rolling]\nload = 50.0\nangular_speed = 2.5\n"
    )
    found = load_case(case).body.layers[0].shear_modulus
    assert found == vr.LossFactor(**PAD, **SET)
