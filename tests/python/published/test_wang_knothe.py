"""Two viscoelastic rollers with traction: Wang and Knothe (1993), computed with CONTACT."""

from __future__ import annotations

import pytest
from published import wang_knothe as source

#: Nearly flat bodies, a/R = 0.0025, with four nodes per element of CONTACT.
FINE = {"scale": 25.0, "refinement": 4.0}


@pytest.fixture(scope="module")
def fine():
    return {name: source.roll(time, **FINE) for name, time in source.CREEP_TIMES.items()}


def test_creepage(judge, fine):
    # CONTACT's elements are coarse: its elastic limits differ from Carter's closed form by 1.3 and 0.8 %.
    judge({f"creepage [%], {name}": 100.0 * creepage for name, (creepage, _) in fine.items()})


def test_largest_pressure(judge, fine):
    judge({f"largest pressure [MPa], {name}": 1e-6 * pressure for name, (_, pressure) in fine.items()})


def test_elastic_limits_agree_with_carter(judge, fine):
    # 320 nodes across have an error of 0.2 %, of first order.
    relaxed, stiff = (100.0 * fine[name][0] for name in list(fine)[:: len(fine) - 1])
    judge(
        {
            "creepage [%], relaxed modulus, Carter's closed form": relaxed,
            "creepage [%], instantaneous modulus, Carter's closed form": stiff,
        }
    )
    # values printed in CONTACT's user guide
    for modulus, pressure in ((source.RELAXED, 60.3), (source.INSTANTANEOUS, 85.3)):
        assert source.carter(modulus)[1] == pytest.approx(1e6 * pressure, rel=1e-3)


@pytest.mark.parametrize("time", source.CREEP_TIMES.values(), ids=source.CREEP_TIMES)
def test_curvature_of_the_printed_size_is_small(time, fine):
    # a/R = 0.063 changes the pressure by 0.14 % and the creepage by 0.7 %.
    creepage, pressure = source.roll(time, scale=1.0, refinement=4.0)
    flat_creepage, flat_pressure = source.roll(time, **FINE)
    assert pressure == pytest.approx(flat_pressure, rel=2e-3)
    assert creepage == pytest.approx(flat_creepage, rel=1e-2)
