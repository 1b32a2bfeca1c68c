"""Profiles: their shapes, their files and their messages."""

from __future__ import annotations

import sys

import numpy as np
import pytest
import viscoroll as vr
from viscoroll.ground import Axle, Profile


def test_height_is_linear_between_points_and_constant_beyond():
    profile = Profile([0.0, 1.0, 1.0, 3.0], [0.0, 2.0, 1.0, 0.0])
    np.testing.assert_array_equal(profile.height_at([-1.0, 0.5, 1.0, 2.0, 9.0]), [0.0, 1.0, 1.0, 0.5, 0.0])
    assert profile.height_at(0.25).shape == ()


def test_periodic_profile_repeats():
    profile = Profile([0.0, 1.0, 2.0], [0.0, 1.0, 0.0], periodic=True)
    np.testing.assert_allclose(profile.height_at([-0.5, 2.5, 7.0]), [0.5, 0.5, 1.0])


def test_shapes_follow_their_formulas():
    s = np.linspace(0.0, 0.1, 1234)
    bump = Profile.half_sine(1e-3, length=20e-3, at=40e-3)
    inside = np.abs(s - 40e-3) < 10e-3
    exact = np.where(inside, 1e-3 * np.cos(np.pi * (s - 40e-3) / 20e-3), 0.0)
    np.testing.assert_allclose(bump.height_at(s), exact, atol=2e-9)
    waves = Profile.corrugation(1e-4, period=12e-3)
    np.testing.assert_allclose(waves.height_at(s), 1e-4 * np.sin(2.0 * np.pi * s / 12e-3), atol=2e-9)
    joint = Profile.joint(1e-3, width=6e-3, at=40e-3)
    np.testing.assert_array_equal(joint.height_at(s), np.where((s >= 37e-3) & (s < 43e-3), -1e-3, 0.0))
    step = Profile.step(0.5e-3, at=40e-3)
    np.testing.assert_array_equal(step.height_at(s), np.where(s >= 40e-3, 0.5e-3, 0.0))
    of = Profile.of(lambda x: 1e-3 * x**2, start=0.0, stop=1.0)
    assert of.height_at(0.5) == pytest.approx(0.25e-3)


@pytest.mark.parametrize(
    ("profile", "length"),
    [
        (Profile.half_sine(1e-3, length=20e-3, at=40e-3), 20e-3),
        (Profile.joint(1e-3, width=6e-3, at=40e-3), 6e-3),
        (Profile.corrugation(1e-4, period=12e-3), 12e-3),
        (Profile.step(1e-3, at=0.0), np.inf),
        (Profile([0.0, 1.0], [0.0, 0.0]), np.inf),
    ],
)
def test_shortest_feature(profile, length):
    assert profile.shortest_feature == pytest.approx(length, rel=2e-3)


def test_largest_slope_leaves_steps_out():
    assert Profile.step(1e-3, at=0.0).largest_slope == 0.0
    assert Profile.half_sine(1e-3, length=20e-3, at=0.0).largest_slope == pytest.approx(np.pi / 20, rel=1e-4)


def test_equal_profiles_have_equal_hashes():
    one, other = (Profile.half_sine(1e-3, length=20e-3, at=40e-3) for _ in range(2))
    assert one == other
    assert hash(one) == hash(other)
    assert one != Profile.half_sine(1e-3, length=20e-3, at=41e-3)


def test_arrays_are_copied_and_read_only():
    height = np.array([0.0, 1.0])
    profile = Profile([0.0, 1.0], height)
    height[1] = 5.0
    assert profile.height[1] == 1.0
    with pytest.raises(ValueError, match="read-only"):
        profile.height[0] = 1.0


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (([0.0], [0.0]), "distance must be a list of at least two distances, got 1 distances"),
        (([0.0, 1.0], [0.0]), r"height must be as long as distance \(2\), got 1"),
        (([0.0, np.nan], [0.0, 0.0]), r"distance\[1\] must be finite, got nan"),
        (([0.0, 1.0], [0.0, np.inf]), r"height\[1\] must be finite, got inf"),
        (([1.0, 0.0], [0.0, 0.0]), r"distance\[1\] must be >= distance\[0\] = 1 m, got 0 m"),
        (([1.0, 1.0], [0.0, 0.0]), "distance must be a list of different distances, got only 1 m"),
        (([[0.0, 1.0]], [0.0, 0.0]), r"distance must be one-dimensional, got shape \(1, 2\)"),
    ],
)
def test_messages_of_profiles(arguments, message):
    with pytest.raises(vr.InvalidInput, match=message):
        Profile(*arguments)


def test_messages_of_shapes():
    with pytest.raises(vr.InvalidInput, match="length must be > 0 m, got -1"):
        Profile.half_sine(1e-3, length=-1.0, at=0.0)
    with pytest.raises(vr.InvalidInput, match="points must be >= 2, got 1"):
        Profile.of(np.sin, start=0.0, stop=1.0, points=1)


def test_axle_messages():
    with pytest.raises(vr.InvalidInput, match=r"axle\.mass must be in \[0, 1e\+40\] kg|axle\.mass must be"):
        Axle(mass=-1.0)
    with pytest.raises(vr.InvalidInput, match="axle must be an axle with a mass, a spring or a damper"):
        Axle()
    with pytest.raises(TypeError, match="mass must be a real number"):
        Axle(mass="heavy")


def test_read_csv_and_npy(tmp_path):
    distance, height = np.linspace(0.0, 1.0, 11), np.linspace(0.0, 1e-3, 11)
    table = tmp_path / "floor.csv"
    table.write_text("distance,height\n" + "\n".join(f"{s},{h}" for s, h in zip(distance, height, strict=True)))
    array = tmp_path / "floor.npy"
    np.save(array, np.column_stack([distance, height]))
    assert Profile.read(table) == Profile.read(array) == Profile(distance, height)
    assert Profile.read(array, periodic=True).periodic


@pytest.mark.parametrize(
    ("name", "content", "message"),
    [
        ("a.txt", b"", "must end in"),
        ("a.csv", b"distance\n1\n", "must have numbers in the columns distance, height"),
        ("a.npy", b"no array", "a.npy"),
    ],
)
def test_other_files_are_rejected(tmp_path, name, content, message):
    path = tmp_path / name
    path.write_bytes(content)
    with pytest.raises(ValueError, match=message):
        Profile.read(path)


def test_arrays_of_another_shape_are_rejected(tmp_path):
    np.save(tmp_path / "a.npy", np.zeros(5))
    with pytest.raises(vr.InvalidInput, match=r"must be an array of shape \(points, 2\), got shape \(5,\)"):
        Profile.read(tmp_path / "a.npy")


def test_read_opencrg(tmp_path):
    crg = pytest.importorskip("pyopencrg")
    u = 0.01 * np.arange(101)
    road = crg.CrgRoad(np.outer(1e-3 * np.sin(u), [1.0, 1.0, 1.0]), u_inc=0.01, v_inc=0.1)
    road.save(tmp_path / "road.crg", fmt="KDBI")
    profile = Profile.read(tmp_path / "road.crg")
    np.testing.assert_allclose(profile.distance, u, atol=1e-9)
    np.testing.assert_allclose(profile.height, 1e-3 * np.sin(u), atol=1e-8)
    with pytest.raises(vr.InvalidInput, match="lateral must be in"):
        Profile.read(tmp_path / "road.crg", lateral=5.0)


def test_opencrg_without_its_package(tmp_path, monkeypatch):
    (tmp_path / "road.crg").write_bytes(b"")
    monkeypatch.setitem(sys.modules, "pyopencrg", None)
    with pytest.raises(ImportError, match="require pyopencrg"):
        Profile.read(tmp_path / "road.crg")
