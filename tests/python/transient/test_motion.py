"""Input checks of `roll`, its files and its pictures."""

from __future__ import annotations

import numpy as np
import pytest
import viscoroll as vr
from shared_cases import coated_ball
from viscoroll import enums, paper
from viscoroll.transient.series import HISTORY_SCALARS

BALL = paper.ball(density=0.0)
COARSE = vr.Mesh(nodes_per_revolution=100)
GOOD = {"time": [0.0, 1.0], "angle": [0.0, 1.0], "load": 100.0, "mesh": COARSE}
BAD = [
    ({"time": [1.0, 0.0]}, r"time\[1\] must be >= time\[0\] = 1 s, got 0 s"),
    ({"time": [0.0, np.nan]}, r"time\[1\] must be finite, got nan"),
    ({"angle": [0.0, np.inf]}, r"angle\[1\] must be finite, got inf"),
    ({"angle": [0.0, 1.0, 2.0]}, r"angle must be as long as time \(2\), got 3"),
    ({"angle": None, "distance": [0.0, 1.0, 2.0]}, r"distance must be as long as time \(2\), got 3"),
    ({"load": [100.0]}, r"load must be as long as time \(2\), got 1"),
    ({"load": [100.0, -1.0]}, r"load\[1\] must be >= 0 N, got -1"),
    ({"load": 1e7}, "load must be small enough for the coating"),
    ({"time": [0.0], "angle": [0.0]}, "time must have at least two waypoints, got 1"),
    ({"averaged_meshes": 0}, r"averaged_meshes must be in \[1, 16\], got 0"),
    ({"steps_per_spacing": 0}, r"steps_per_spacing must be in \[1, 64\], got 0"),
    ({"curvature": enums.Curvature.EXACT}, "curvature must be SPHERE or PAPER"),
    ({"friction": -0.3}, "friction must be >= 0, got -0.3"),
    ({"friction": 5.0}, "friction must be <= 4 .*, got 5"),
    ({"friction": np.inf}, "friction must be finite in transient rolling, .*, got inf"),
    ({"spectrum_tolerance": 0.0}, r"spectrum_tolerance must be in \(0, 1\), got 0"),
    (
        {"angle": [0.0, 1e9]},
        r"angle must be within 1.57e\+05 rad of the previous angle \(ten million steps\), got 1e\+09",
    ),
    ({"checkpoint": "state.txt"}, r"checkpoint must end in .state, got 'state.txt'"),
    ({"checkpoint": "nowhere/ball.state"}, r"checkpoint must be in a folder that exists, got 'nowhere/ball.state'"),
    ({"contact_times": [2.0]}, r"contact_times must be in \[0, 1\] s, got 2"),
]


@pytest.mark.parametrize(("change", "message"), BAD)
def test_bad_input(change, message):
    with pytest.raises(ValueError, match=message):
        vr.roll(BALL, **GOOD | change)


def test_a_load_jump_on_kelvin_voigt_is_rejected():
    ball = coated_ball(vr.materials.KelvinVoigt(modulus=3e6, viscosity=1e5))
    with pytest.raises(ValueError, match=r"start must be RELAXED for a coating without instantaneous compliance"):
        vr.roll(ball, **GOOD, start=enums.Start.UNDEFORMED)
    jump = {"time": [0, 0.5, 0.5, 1], "angle": [0, 0.1, 0.1, 0.2], "load": [100, 100, 120, 120]}
    with pytest.raises(ValueError, match=r"time must be > the current time, 0.5 s, because a coating"):
        vr.roll(ball, **GOOD | jump)


def test_coatings_that_transient_rolling_cannot_solve():
    slow = vr.materials.KelvinVoigt(modulus=3e6, viscosity=1e5)
    layers = [
        vr.Layer(thickness=1e-3, shear_modulus=modulus, poisson_ratio=0.45)
        for modulus in (slow, vr.Elastic(modulus=2e6))
    ]
    with pytest.raises(
        ValueError, match=r"layers\[0\].shear_modulus must be a material with instantaneous compliance .*, got KelvinV"
    ):
        vr.roll(vr.CoatedSphere(core_radius=20e-3, layers=layers), **GOOD)
    with pytest.raises(
        ValueError, match=r"on.layers\[0\].shear_modulus must be a material with instantaneous compliance"
    ):
        vr.roll(vr.CoatedSphere(core_radius=20e-3, layers=[]), on=vr.CoatedPlane(layers=layers), **GOOD)
    with pytest.raises(ValueError, match=r"angle must be changed so slowly that inertia is negligible, at most"):
        vr.roll(paper.ball(density=1000.0), **GOOD | {"angle": [0.0, 1000.0]})
    like = vr.CoatedSphere(
        core_radius=20e-3,
        layers=[
            vr.Layer(thickness=5e-4, shear_modulus=vr.StandardLinearSolid(
                instantaneous_modulus=s * 6e6, relaxed_modulus=s * 3e6, relaxation_time=0.125), poisson_ratio=0.5)
            for s in (1.0, 1.0)
        ],
    )  # fmt: skip
    a, b = (vr.roll(ball, **GOOD) for ball in (like, BALL))
    np.testing.assert_allclose(a.resisting_torque, b.resisting_torque, rtol=1e-7, atol=1e-9)


def test_results_are_saved_and_drawn(tmp_path):
    h = vr.roll(BALL, **GOOD, contact_times=[0.5, 1.0])
    assert [c.time for c in h.contacts] == [0.5, 1.0]
    assert h.contacts[0].pressure.max() > 1e5
    data = h.to_xarray()
    assert data.resisting_torque.attrs["units"] == "N m"
    assert data.sizes["time"] == len(h.time)
    for suffix in (".csv", ".nc"):
        h.save(tmp_path / f"h{suffix}")
    head = (tmp_path / "h.csv").read_text().splitlines()[0]
    assert head.startswith("time [s],angle [rad],load [N],resisting_torque [N m]")
    with pytest.raises(ValueError, match=r"path must end in \.csv or \.nc"):
        h.save(tmp_path / "h.txt")
    h.plot().savefig(tmp_path / "h.png")
    assert "UNDEFORMED" not in repr(h)
    assert "RELAXED start" in repr(h)


def test_instants_are_received_as_they_are_computed():
    parts = []
    h = vr.roll(BALL, **GOOD, contact_times=[0.5], receive=parts.append)
    assert len(parts[0]["time"]) == 1
    assert max(len(part["time"]) for part in parts) <= 8
    for name in HISTORY_SCALARS:
        np.testing.assert_array_equal(np.concatenate([part[name] for part in parts]), getattr(h, name))


def test_a_receiver_can_end_a_history(tmp_path):
    parts = []

    def receive(part):
        parts.append(part)
        if len(parts) == 3:
            raise InterruptedError

    with pytest.raises(InterruptedError):
        vr.roll(BALL, **GOOD, receive=receive, checkpoint=tmp_path / "history.state")
    last = vr.RollingState.load(tmp_path / "history.state")
    again = vr.roll(BALL, **GOOD, start=last)
    assert again.time[0] == parts[-1]["time"][-1]
    assert again.resisting_torque[-1] == vr.roll(BALL, **GOOD).resisting_torque[-1]
