"""Rough surfaces: statistics, changes, files and messages."""

from __future__ import annotations

import netCDF4
import numpy as np
import pytest
from viscoroll import InvalidInput, RoughSurface

SIDE = 1e-3


def rough(nodes=128, **other):
    options = {"hurst": 0.8, "rolloff": SIDE / 4, "cutoff": SIDE / 32, "rms_slope": 0.1, "seed": 1} | other
    return RoughSurface.self_affine(nodes, SIDE, **options)


def test_statistics_of_a_sinusoid():
    surface = RoughSurface.of(
        lambda x, z: 2e-6 * np.cos(2 * np.pi * x / SIDE) * np.cos(6 * np.pi * z / SIDE), nodes=(32, 48), side=SIDE
    )
    assert surface.rms_height == pytest.approx(1e-6)
    assert surface.rms_slope == pytest.approx(1e-6 * 2 * np.pi / SIDE * np.sqrt(1 + 9))
    along, across = surface.slopes()
    x = np.arange(32)[:, np.newaxis] / 32 * SIDE
    z = np.arange(48) / 48 * SIDE
    slope = -2e-6 * 2 * np.pi / SIDE * np.sin(2 * np.pi * x / SIDE) * np.cos(6 * np.pi * z / SIDE)
    assert np.abs(along - slope).max() < 1e-12
    assert along.shape == across.shape == (32, 48)
    assert surface.sides == pytest.approx((SIDE, SIDE))
    assert not surface.heights.flags.writeable


def test_differences_give_the_slope_of_a_surface_that_is_not_periodic():
    surface = RoughSurface(0.02 * np.arange(50.0) * 1e-5, spacing=1e-5, periodic=False)
    assert surface.rms_slope == pytest.approx(0.02)
    with pytest.raises(InvalidInput, match=r"surface.periodic must be True; use surface.mirrored\(\)"):
        surface.slopes()


@pytest.mark.parametrize("nodes", [128, 129])
def test_a_self_affine_surface_has_its_spectrum(nodes):
    surface = rough(nodes)
    assert surface.rms_slope == pytest.approx(0.1)
    assert rough(nodes, rms_slope=None, rms_height=1e-6).rms_height == pytest.approx(1e-6)
    wavenumber, density = surface.spectrum()
    q = wavenumber * SIDE / (2 * np.pi)
    assert density[q > 33].max() < 1e-20 * density.max()
    inside = (q > 6) & (q < 30)
    fitted = np.polyfit(np.log(q[inside]), np.log(density[inside]), 1)[0]
    assert fitted == pytest.approx(-2 - 2 * 0.8, abs=0.02)
    flat = density[(q > 0.9) & (q < 3.3)]
    assert flat.max() < 1.001 * flat.min()
    # The integral over all wave vectors is the mean square height.
    squares = np.abs(np.fft.fft2(surface.heights, norm="forward")) ** 2
    assert squares.sum() - squares[0, 0] == pytest.approx(surface.rms_height**2)


def test_a_self_affine_surface_does_not_depend_on_the_mesh():
    coarse, fine = rough(128), rough(256)
    assert np.abs(fine.heights[::2, ::2] - coarse.heights).max() < 1e-12 * coarse.rms_height
    assert np.abs(coarse.resampled(256).heights - fine.heights).max() < 1e-12 * coarse.rms_height
    assert np.abs(fine.resampled(129).resampled(128).heights - coarse.heights).max() < 1e-12 * coarse.rms_height
    assert rough(seed=2).heights[0, 0] != coarse.heights[0, 0]


def test_a_mesh_that_loses_waves_is_rejected():
    with pytest.raises(
        InvalidInput, match="nodes must resolve all waves of the surface; apply cutoff first, got 48 x 48"
    ):
        rough().resampled(48)
    smooth = rough().cutoff(SIDE / 16)
    assert smooth.resampled(48).rms_height == pytest.approx(smooth.rms_height)


def test_a_cutoff_removes_short_waves():
    surface = rough()
    smooth = surface.cutoff(SIDE / 10)
    wavenumber, density = smooth.spectrum()
    _, before = surface.spectrum()
    q = wavenumber * SIDE / (2 * np.pi)
    assert density[q > 11].max() < 1e-20 * density.max()
    assert density[q < 9] == pytest.approx(before[q < 9])
    measured = RoughSurface(surface.heights, surface.spacing, periodic=False).cutoff(SIDE / 10)
    assert not measured.periodic
    assert measured.rms_slope < surface.rms_slope


def test_detrending_removes_polynomials():
    x, z = np.meshgrid(np.linspace(0, 1, 30), np.linspace(0, 1, 20), indexing="ij")
    plane = RoughSurface(3e-6 + 1e-6 * x - 2e-6 * z, 1e-6, periodic=False)
    bowl = RoughSurface(1e-6 * (x**2 - x * z + 2 * z), 1e-6, periodic=False)
    assert plane.detrended(0).heights.mean() == pytest.approx(0.0, abs=1e-20)
    assert np.abs(plane.detrended().heights).max() < 1e-19
    assert np.abs(bowl.detrended(1).heights).max() > 1e-8
    assert np.abs(bowl.detrended(2).heights).max() < 1e-19
    with pytest.raises(InvalidInput, match="degree must be 0, 1 or 2, got 3"):
        plane.detrended(3)


def test_a_mirrored_surface_is_periodic():
    surface = RoughSurface(rough().heights[:20, :30], 1e-6, periodic=False)
    whole = surface.mirrored()
    assert whole.periodic
    assert whole.heights.shape == (40, 60)
    assert (whole.heights[-1] == whole.heights[0]).all()
    assert RoughSurface(np.arange(8.0), 1.0, periodic=False).mirrored().heights.shape == (16, 1)


def test_text_and_array_files(tmp_path):
    heights = rough(32, cutoff=SIDE / 8).heights
    np.save(tmp_path / "map.npy", heights)
    np.savetxt(tmp_path / "map.csv", heights, delimiter=",", header="made by a test", fmt="%.17g")
    (tmp_path / "map.txt").write_text("\n".join(" ; ".join(f"{h:.17g}" for h in row) for row in heights) + "\n\n")
    for name in ("map.npy", "map.csv", "map.txt"):
        surface = RoughSurface.read(tmp_path / name, spacing=(2e-6, 3e-6))
        assert (surface.heights == heights).all()
        assert surface.spacing == (2e-6, 3e-6)
        assert not surface.periodic
        with pytest.raises(InvalidInput, match=f"spacing must be given: {name} does not contain it"):
            RoughSurface.read(tmp_path / name)


@pytest.mark.parametrize(("unit", "factor"), [("m", 1.0), ("µm", 1e-6), ("nm", 1e-9)])
def test_netcdf_files(tmp_path, unit, factor):
    path = tmp_path / "map.nc"
    with netCDF4.Dataset(path, "w") as data:
        for name, count, step in (("x", 12, 2.0), ("y", 10, 3.0)):
            data.createDimension(name, count)
            places = data.createVariable(name, "f8", (name,))
            places[:] = 5.0 + step * np.arange(count)
            places.units = "µm"
        stored = data.createVariable("heights", "f4", ("x", "y"))
        stored.units = unit
        stored[:] = np.arange(120.0).reshape(12, 10)
        data.createVariable("quality", "i1", ("x", "y"))[:] = 1
    surface = RoughSurface.read(path, periodic=True)
    assert surface.heights == pytest.approx(np.arange(120.0).reshape(12, 10) * factor)
    assert surface.spacing == pytest.approx((2e-6, 3e-6))
    assert surface.periodic
    assert RoughSurface.read(path, spacing=1e-6).spacing == (1e-6, 1e-6)


@pytest.mark.parametrize(
    ("name", "content", "message"),
    [
        ("a.csv", "1,2\n3\n", "path must have 2 numbers in every line, got a.csv, line 2: 1"),
        ("a.csv", "1,2\nx,4\n", "path must contain numbers only, got a.csv, line 2: 'x,4'"),
        ("a.txt", "# nothing\n", "path must contain heights, got a.txt without numbers"),
        ("a.npy", "no array", "path must be a file that numpy.save wrote, got a.npy"),
        ("a.sur", "", "path must end in .npy, .csv, .txt or .nc, got 'a.sur'"),
        ("a.csv", "1,nan\n2,3\n", "heights must be finite unless fill is True, got 1 undefined nodes"),
    ],
)
def test_damaged_files(tmp_path, name, content, message):
    (tmp_path / name).write_text(content)
    with pytest.raises(InvalidInput) as error:
        RoughSurface.read(tmp_path / name, spacing=1e-6)
    assert message in str(error.value)


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (
            lambda: RoughSurface(np.zeros((2, 2, 2)), 1.0),
            r"heights must have one or two dimensions, got shape \(2, 2, 2\)",
        ),
        (lambda: RoughSurface(np.zeros(8), 0.0), "spacing must be > 0 m, got 0"),
        (lambda: RoughSurface(np.zeros(8), (1.0, 1.0, 1.0)), "spacing must be one number or a tuple of two"),
        (lambda: rough(hurst=1.5), r"hurst must be in \[0, 1\], got 1.5"),
        (lambda: rough(cutoff=SIDE / 100), "cutoff must be >= 1.5625e-05 m, two spacings, got 1e-05"),
        (lambda: rough(rolloff=SIDE / 40), "rolloff must be in"),
        (lambda: rough(seed=-1), "seed must be >= 0, got -1"),
        (lambda: rough(rms_height=1.0), "exactly one of rms_slope and rms_height must be given"),
    ],
)
def test_messages(make, message):
    with pytest.raises(ValueError, match=message):
        make()


def test_pictures_and_text():
    surface = rough()
    assert repr(surface).startswith("RoughSurface(128 x 128 nodes, 0.001 x 0.001 m, periodic, rms height ")
    assert len(surface.plot().axes) == 2
    assert len(RoughSurface(np.arange(8.0), 1.0).plot().axes) == 1
