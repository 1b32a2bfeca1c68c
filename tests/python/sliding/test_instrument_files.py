"""Files of instruments, and nodes that were not measured."""

from __future__ import annotations

import json
import struct

import numpy as np
import pytest
import viscoroll as vr
from viscoroll import RoughSurface

from tests.shared_cases import command

#: Value of nodes that were not measured in a SUR file: two below zmin.
UNMEASURED = -32768


def sur_file(counts, spacing, factor):
    """Return a file of Digital Surf with lengths in µm: header of 512 bytes, then rows along x of 16-bit integers.

    The layout is that of the reader of SurfaceTopography, which describes the format from its own sources.
    """
    rows, columns = counts.shape
    text = [name.encode().ljust(16) for name in ("X", "Y", "Z", *(["um"] * 6))]
    header = struct.pack("<12s4H", b"DIGITAL SURF", 0, 1, 1, 2)
    header += struct.pack("<30s30s", b"asphalt".ljust(30), b"test".ljust(30))
    header += struct.pack("<5H8xH", 0, 0, 0, 1, 1, 16)
    header += struct.pack("<4iI", UNMEASURED + 2, counts.max(), columns, rows, rows * columns)
    header += struct.pack("<3f", spacing, spacing, factor) + b"".join(text) + struct.pack("<3f", 1.0, 1.0, 1.0)
    header += struct.pack("<3H12x", 0, 0, 0) + struct.pack("<7H", 0, 0, 0, 27, 11, 2026, 5)
    header += struct.pack("<f10x2H128s3f34x", 0.0, 0, 0, b"", 0.0, 0.0, 0.0)
    assert len(header) == 512
    return header + counts.astype("<i2").tobytes()


@pytest.fixture
def scanned(tmp_path):
    """Write a SUR file with a few unmeasured nodes; return its path and the heights [m] in the order (x, z)."""
    rng = np.random.default_rng(3)
    counts = np.rint(400.0 * rng.standard_normal((30, 40))).astype(int)
    counts[5:7, 8] = UNMEASURED
    path = tmp_path / "asphalt.sur"
    path.write_bytes(sur_file(counts, 2.0, 0.01))
    heights = np.where(counts == UNMEASURED, np.nan, 1e-8 * counts)
    return path, heights


def test_an_instrument_format_is_read(scanned):
    pytest.importorskip("SurfaceTopography")
    path, heights = scanned
    with pytest.raises(vr.InvalidInput, match="heights must be finite unless fill is True, got 2 undefined nodes"):
        RoughSurface.read(path, format="sur")
    surface = RoughSurface.read(path, format="sur", fill=True)
    assert surface.heights.shape == (40, 30)
    assert surface.spacing == pytest.approx((2e-6, 2e-6))
    assert not surface.periodic
    # x grows with the columns of the file. The file has the height per count as a 32-bit number.
    assert np.nanmax(np.abs(surface.heights - heights.T)) < 1e-6 * np.nanmax(np.abs(heights))


def test_an_instrument_file_is_solved_in_one_command(scanned):
    pytest.importorskip("SurfaceTopography")
    path, _ = scanned
    case = path.with_suffix(".toml")
    case.write_text(
        f"""
[surface]
file = "{path.name}"
format = "sur"
fill = true
detrend = 1
cutoff = "20 µm"
[plane.base]
poisson_ratio = 0.5
shear_modulus = {{ type = "kelvin_voigt", modulus = 1e6, viscosity = 1e4 }}
[sliding]
pressure = "20 kPa"
speed = "1 mm/s"
""",
        encoding="utf-8",
    )
    (found,) = json.loads(command("slide", case, "--json").stdout)
    surface = RoughSurface.read(path, format="sur", fill=True).detrended(1).mirrored().cutoff(20e-6)
    rubber = vr.materials.KelvinVoigt(modulus=1e6, viscosity=1e4)
    on = vr.HalfSpace(shear_modulus=rubber, poisson_ratio=0.5)
    r = vr.slide(surface, on=on, pressure=20e3, speed=1e-3)
    assert found["friction_coefficient"] == pytest.approx(r.friction_coefficient, rel=1e-9)
    assert found["friction_coefficient"] > 0.0


def test_messages_about_formats(scanned):
    pytest.importorskip("SurfaceTopography")
    path, _ = scanned
    with pytest.raises(vr.InvalidInput, match=r"format must be one of al3d, .*, got 'surf'"):
        RoughSurface.read(path, format="surf")
    path.write_bytes(b"no surface")
    with pytest.raises(vr.InvalidInput, match=r"path must be a file of the format sur, got asphalt.sur"):
        RoughSurface.read(path, format="sur")
    with pytest.raises(FileNotFoundError):
        RoughSurface.read(path.with_name("absent.sur"), format="sur")


def test_filled_nodes_are_harmonic():
    # Linear and bilinear heights are harmonic on the mesh, so that filling restores them.
    x, z = np.meshgrid(np.arange(20.0), np.arange(16.0), indexing="ij")
    heights = 1e-6 * (x - 2.0 * z + 0.1 * x * z)
    damaged = heights.copy()
    damaged[4:12, 5:9] = np.nan
    damaged[15, 3] = np.inf
    assert np.abs(RoughSurface(damaged, 1e-6, fill=True).heights - heights).max() < 1e-13
    # At a corner, the node has the mean of the neighbors that exist.
    damaged = heights.copy()
    damaged[0, 0] = np.nan
    found = RoughSurface(damaged, 1e-6, fill=True).heights[0, 0]
    assert found == pytest.approx(0.5 * (heights[0, 1] + heights[1, 0]), abs=1e-15)
    profile = RoughSurface([0.0, np.nan, np.nan, 3.0], 1.0, fill=True)
    assert profile.heights[:, 0] == pytest.approx([0.0, 1.0, 2.0, 3.0])
    with pytest.raises(vr.InvalidInput, match="heights must have at least one defined node, got none"):
        RoughSurface([np.nan, np.nan], 1.0, fill=True)
