"""Animations and pictures of histories over uneven ground."""

from __future__ import annotations

import numpy as np
import pytest
import viscoroll as vr
from matplotlib.animation import FFMpegWriter
from PIL import Image
from shared_cases import one_layer

ROLLER = vr.CoatedCylinder(core_radius=50e-3, layers=[one_layer(thickness=10e-3)])


@pytest.fixture(scope="module")
def history():
    return vr.roll(
        ROLLER, time=[0.0, 0.1], distance=[0.0, 60e-3], load=5e3, axle=vr.Axle(mass=500.0),
        ground=vr.Profile.half_sine(1e-3, length=20e-3, at=30e-3),
        tread=vr.Profile.corrugation(1e-4, period=2.0 * np.pi * 60e-3 / 20),
        mesh=vr.Mesh(nodes_per_revolution=300), averaged_meshes=1,
    )  # fmt: skip


def test_gif(history, tmp_path):
    history.animate(tmp_path / "roller.gif", seconds=0.5, frames_per_second=10)
    with Image.open(tmp_path / "roller.gif") as picture:
        assert picture.n_frames == 5
        assert picture.info["duration"] == 100  # ms
        first = np.asarray(picture.convert("RGB")).astype(int)
        picture.seek(4)
        assert np.abs(np.asarray(picture.convert("RGB")).astype(int) - first).max() > 100  # the picture changes
    assert [path.name for path in tmp_path.iterdir()] == ["roller.gif"]


def test_mp4(history, tmp_path, monkeypatch):
    if FFMpegWriter.isAvailable():
        history.animate(tmp_path / "roller.mp4", seconds=0.2)
        assert (tmp_path / "roller.mp4").stat().st_size > 1000
    monkeypatch.setattr(FFMpegWriter, "isAvailable", classmethod(lambda _: False))
    with pytest.raises(vr.InvalidInput, match=r"path must end in \.gif where the program ffmpeg is not installed"):
        history.animate(tmp_path / "roller.mp4")


def test_messages(history, tmp_path):
    with pytest.raises(vr.InvalidInput, match=r"path must end in \.gif or \.mp4, got 'roller\.png'"):
        history.animate(tmp_path / "roller.png")
    with pytest.raises(vr.InvalidInput, match="seconds must be > 0 s"):
        history.animate(tmp_path / "roller.gif", seconds=0.0)
    with pytest.raises(vr.InvalidInput, match="frames_per_second must be >= 1"):
        history.animate(tmp_path / "roller.gif", frames_per_second=0)


def test_plot_of_the_ground(history):
    axes = history.plot_ground().axes
    labels = [one.get_ylabel().partition(" [")[0] for one in axes]
    assert labels == ["height", "load", "push force", "contact length"]
    np.testing.assert_allclose(axes[2].lines[0].get_ydata() * 1e3, history.resisting_force, rtol=1e-12)
