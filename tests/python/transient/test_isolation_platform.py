"""Test the mechanics and the rubber's loss in the worked example docs/jobs/isolation_platform.py."""

from __future__ import annotations

from functools import cache
from pathlib import Path

import numpy as np
import pytest
import viscoroll as vr
from shared_cases import one_layer

DOCS = Path(__file__).parents[3] / "docs" / "jobs"
MESH = vr.Mesh(nodes_per_revolution=100)
RELEASED = 80e-3  # displacement at which the platform is released [m]


@pytest.fixture(autouse=True)
def _docs(monkeypatch):
    monkeypatch.syspath_prepend(str(DOCS))


def page_and_platform(modulus=None):
    import isolation_platform as page

    return page, page.Platform(layers=(one_layer() if modulus is None else one_layer(modulus),))


@cache
def free_swing():
    """Return the platform, its motion during two periods after release, and the history of one contact."""
    page, platform = page_and_platform()
    time = np.linspace(0.0, 2.1 * platform.period, 701)
    slope = float(np.arcsin(RELEASED / platform.length))
    return platform, *page.by_newmark(platform, time, np.zeros_like(time), MESH, slope)


def test_energy_lost_by_the_swing_equals_the_work_of_rolling():
    platform, motion, _ = free_swing()
    energy = platform.energy(motion.slope, motion.rate)
    rolled = motion.rolled(platform)
    assert rolled[-1] > 0.3 * energy[0]
    # With the work by the trapezoidal rule, average acceleration conserves the energy of a linear swing. This swing
    # is nearly linear.
    np.testing.assert_allclose(energy[0] - energy, rolled, rtol=0, atol=1e-5 * rolled[-1])


def test_work_of_rolling_is_dissipated_and_stored_in_the_rubber():
    platform, motion, history = free_swing()
    start = vr.RollingHistory(
        platform.ball,
        on=platform.dish,
        load=motion.load[0],
        distance=platform.distance(motion.slope[0]),
        mesh=MESH,
        averaged_meshes=2,
    ).current
    end = history.current
    stored = end.stored_energy - start.stored_energy
    pressed = platform.mass * 9.81 / platform.balls * (end.penetration - start.penetration)
    work = 2 * platform.balls * (end.dissipated_energy + stored - pressed)
    # Trapezoidal rule with steps of up to 0.2 mm, a tenth of the contact; loads change by 1 %.
    assert motion.rolled(platform)[-1] == pytest.approx(work, rel=3e-3)


def test_a_cycle_dissipates_as_much_as_a_harmonic_one():
    """Compare the cycle between two maxima with the second cycle of a harmonic motion of their mean amplitude."""
    platform, motion, _ = free_swing()
    displacement = motion.displacement(platform)
    turns = [np.argmax(np.where(abs(motion.time / platform.period - k) < 0.3, displacement, -1)) for k in (1, 2)]
    first, last = displacement[turns]
    rolled = np.diff(motion.rolled(platform)[turns])[0]
    duration = np.diff(motion.time[turns])[0]
    time = np.linspace(0.0, 2.0 * duration, 801)
    slope = np.arcsin(0.5 * (first + last) / platform.length)
    distance = platform.dish_radius * slope * np.cos(2.0 * np.pi * time / duration)
    load = platform.mass * 9.81 / platform.balls
    h = vr.roll(platform.ball, on=platform.dish, time=time, distance=distance, load=load, mesh=MESH, averaged_meshes=2)
    lost = np.diff(np.interp([duration, 2.0 * duration], h.time, h.dissipated_energy))[0]
    # The swing decays by a sixth in this cycle. The error is of second order in this decay, because the loss is
    # nearly proportional to the amplitude.
    assert rolled == pytest.approx(2 * platform.balls * lost, rel=1e-2)


def test_forces_on_the_platform_balance():
    """Each ball transmits P along the normal and M / R along the dish; their sum is the force on the platform."""
    platform, motion, _ = free_swing()
    slope, along = motion.slope, motion.moment / platform.ball_radius
    level = platform.balls * (motion.load * np.sin(slope) + along * np.cos(slope))
    np.testing.assert_allclose(motion.force(platform), level, rtol=0, atol=1e-7 * np.abs(level).max())
    upward = platform.balls * (motion.load * np.cos(slope) - along * np.sin(slope)) / platform.mass - 9.81
    lift = platform.length * (1.0 - np.cos(slope))
    step = motion.time[1]
    second = (lift[2:] - 2.0 * lift[1:-1] + lift[:-2]) / step**2
    # In the first millimeter, the moment rises within a few steps, which second-order differences do not resolve.
    np.testing.assert_allclose(second[50:], upward[1:-1][50:], rtol=0, atol=1e-2 * np.abs(upward).max())


def test_small_elastic_swings_have_the_period_of_a_pendulum():
    page, platform = page_and_platform(vr.Elastic(modulus=3e6))
    time = np.linspace(0.0, 1.1 * platform.period, 301)
    motion, _ = page.by_newmark(platform, time, np.zeros_like(time), MESH, 5e-3 / platform.length)
    falling = np.nonzero((motion.slope[:-1] > 0.0) & (motion.slope[1:] <= 0.0))[0][0]
    share = motion.slope[falling] / (motion.slope[falling] - motion.slope[falling + 1])
    quarter = time[falling] + share * (time[1] - time[0])
    assert platform.period == pytest.approx(2.0 * np.pi * np.sqrt(2.0 * (0.4 - 0.021) / 9.81))
    # The discrete contacts of two coarse meshes add some thousandths of the restoring force.
    assert 4.0 * quarter == pytest.approx(platform.period, rel=1e-2)


def test_energy_balances_with_the_steady_torque():
    page, platform = page_and_platform()
    surface = vr.studies.RollingResistance(
        load=(90.0, 110.0), angular_speed=(0.02, 20.0), radius=21e-3, coefficients=np.array([[-4.5, 0.2], [0.1, 0.0]]),
        error=0.0, largest_error=0.0,
    )  # fmt: skip
    time = np.linspace(0.0, 2.0 * platform.period, 1001)
    motion = page.by_solve_ivp(platform, time, np.zeros_like(time), surface, 0.03)
    energy = platform.energy(motion.slope, motion.rate)
    np.testing.assert_allclose(energy[0] - energy, motion.rolled(platform), rtol=0, atol=1e-3 * np.ptp(energy))


def test_a_motion_beyond_the_rim_is_rejected():
    page, platform = page_and_platform()
    time, ground = page.ground_motion(duration=3.0, peak=6.0)
    with pytest.raises(
        ValueError, match=r"distance must be in \[-0\.06, 0\.06\] m, within the rim of the dish, got -?0\.06\d+ m"
    ):
        page.by_newmark(platform, time, ground, MESH)


def test_the_example_runs(tmp_path, capsys):
    import isolation_platform as page

    numbers = page.main(nodes=80, accuracy=0.05, duration=3.0, picture=str(tmp_path / "loop.png"))
    assert (tmp_path / "loop.png").stat().st_size > 1000
    assert "largest displacement, by histories" in capsys.readouterr().out
    forces = [numbers[f"break-away force after a dwell of {stand} s [N]"] for stand in ("0", "0.1", "1", "10")]
    assert forces == sorted(forces)
    by_histories, by_steady = (
        numbers[f"largest displacement, {by} [mm]"] for by in ("by histories", "by steady torque")
    )
    assert by_histories == pytest.approx(by_steady, rel=0.3)
