"""The function `slide`: arguments, warnings, results and messages."""

from __future__ import annotations

import numpy as np
import pytest
import viscoroll as vr

SIDE = 1e-3
RUBBER = vr.StandardLinearSolid(instantaneous_modulus=10e6, relaxed_modulus=1e6, relaxation_time=1e-4)
HALF_SPACE = vr.HalfSpace(shear_modulus=RUBBER, poisson_ratio=0.5)
WAVY = vr.RoughSurface.of(
    lambda x, z: 4e-6 * np.cos(2 * np.pi * x / SIDE) * np.cos(2 * np.pi * z / SIDE), nodes=64, side=SIDE
)


def slid(surface=WAVY, **options):
    given = {"on": HALF_SPACE, "pressure": 1e4, "speed": 0.1, "threads": 1} | options
    return vr.slide(surface, **given)


def test_a_load_is_the_pressure_times_the_area_of_a_period():
    by_pressure, by_load = slid(), slid(pressure=None, load=1e4 * SIDE**2)
    assert by_load.mean_pressure == pytest.approx(1e4)
    assert by_load.pressure == pytest.approx(by_pressure.pressure)
    profile = vr.RoughSurface(WAVY.heights[:, 0], SIDE / 64)
    assert slid(profile, pressure=None, load=1e4 * SIDE).mean_pressure == pytest.approx(1e4)


def test_the_result_is_consistent():
    r = slid()
    assert r.converged
    assert r.pressure.shape == r.gap.shape == WAVY.heights.shape
    assert r.pressure.mean() == pytest.approx(1e4, rel=1e-9)
    assert r.pressure.min() == 0.0
    assert r.max_pressure == r.pressure.max()
    assert r.contact_share == r.contact.mean()
    assert r.mean_gap == pytest.approx(r.gap.mean())
    assert np.abs(r.gap[r.contact]).max() < 1e-7 * np.ptp(WAVY.heights)
    assert r.power_density == pytest.approx(0.1 * 1e4 * r.friction_coefficient)
    along, _ = WAVY.slopes()
    assert r.traction_friction == pytest.approx(-(r.pressure * along).mean() / 1e4, rel=1e-9)
    assert r.friction_error == abs(r.traction_friction - r.friction_coefficient)
    assert r.side_force_coefficient == pytest.approx(0.0, abs=1e-9)
    assert r.warnings == {}
    # In front of each peak, the pressure is higher than behind it.
    assert r.friction_coefficient > 0.0
    assert r.pressure[:32].sum() > r.pressure[33:].sum()


def test_the_memory_length_is_the_speed_times_the_retardation_time():
    # The retardation time of a standard linear solid is tau G_0 / G_inf.
    assert slid().memory_length == pytest.approx(0.1 * 1e-4 * 10.0)
    assert slid(speed=0.0).memory_length == 0.0
    assert slid(on=vr.HalfSpace(shear_modulus=vr.Elastic(modulus=1e6), poisson_ratio=0.5)).memory_length == 0.0
    with pytest.warns(vr.ResultWarning, match="the surface slides in its own track"):
        assert "own_track" in slid(speed=2.0).warnings


def test_a_half_space_is_a_plane_without_layers():
    plane = vr.CoatedPlane(base=HALF_SPACE)
    assert (slid(on=plane).pressure == slid().pressure).all()


@pytest.mark.parametrize("density", [0.0, 1e3])
def test_profiles_slide_on_all_layers(density):
    # The series of the compliance depend on inertia and on the layers. A map of identical columns is a profile.
    softer = vr.materials.FractionalZener(
        instantaneous_modulus=5e6, relaxed_modulus=5e5, relaxation_time=1e-3, order=0.6
    )
    layers = [
        vr.Layer(thickness=1e-4, shear_modulus=material, poisson_ratio=0.5, density=density)
        for material in (softer, RUBBER)
    ]
    heights = 4e-6 * np.cos(2 * np.pi * np.arange(64) / 64)
    for on in (vr.CoatedPlane(layers=layers), vr.HalfSpace(shear_modulus=RUBBER, poisson_ratio=0.5, density=density)):
        profile = slid(vr.RoughSurface(heights, SIDE / 64), on=on, speed=0.03)
        rows = slid(vr.RoughSurface(np.tile(heights[:, np.newaxis], 16), SIDE / 64), on=on, speed=0.03)
        assert 0.0 < profile.contact_share < 1.0
        assert profile.friction_coefficient == pytest.approx(rows.friction_coefficient, rel=1e-6)
        assert profile.max_pressure == pytest.approx(rows.max_pressure, rel=1e-6)


def test_results_do_not_depend_on_the_threads():
    surface = vr.RoughSurface.self_affine(
        192, SIDE, hurst=0.8, rolloff=SIDE / 4, cutoff=SIDE / 24, rms_slope=0.1, seed=4
    )
    assert (slid(surface, threads=2).pressure == slid(surface, threads=1).pressure).all()


def test_warnings_of_slopes_and_meshes():
    with pytest.warns(vr.ResultWarning, match="the rms slope of the surface is 0.503"):
        assert set(slid(WAVY.scaled(20.0 * np.sqrt(2.0)), pressure=1e6).warnings) >= {"large_slope"}
    coarse = vr.RoughSurface.self_affine(64, SIDE, hurst=0.8, rolloff=SIDE / 4, cutoff=SIDE / 32, rms_slope=0.1, seed=4)
    with pytest.warns(vr.ResultWarning, match="waves shorter than four spacings have"):
        assert set(slid(coarse).warnings) == {"coarse_mesh"}
    with pytest.warns(vr.ResultWarning, match="the contact still changed after 1 iterations"):
        slid(max_iterations=1)


def test_the_slope_in_contact():
    r = slid()
    along, across = WAVY.slopes()
    expected = np.sqrt((along[r.contact] ** 2 + across[r.contact] ** 2).mean())
    assert r.contact_slope == pytest.approx(expected, rel=1e-12)
    # Differences of second order give the slope of a finite surface.
    x = (np.arange(65) - 32) / 64 * SIDE
    bowl = slid(vr.RoughSurface(-(x[:, np.newaxis] ** 2 + x**2) / 5e-3, SIDE / 64, periodic=False), pressure=1e2)
    touching = (x[:, np.newaxis] ** 2 + x**2)[bowl.contact]
    assert bowl.contact_slope == pytest.approx(2 * np.sqrt(touching.mean()) / 5e-3, rel=1e-9)


def test_filled_rubber_has_the_modulus_at_the_strain_of_the_contact():
    network = vr.materials.MasingNetwork(storage=6e6, critical_strain=0.01)
    filled = vr.materials.SofteningModulus(matrix=RUBBER, network=network)
    slope = slid().contact_slope

    def at(strain):
        return vr.HalfSpace(shear_modulus=filled.at(strain, reference_frequency=1e3), poisson_ratio=0.5)

    assert "strain_amplitude" not in slid(on=at(slope), pressure=1e5).warnings
    with pytest.warns(vr.ResultWarning, match="the modulus of a filled rubber holds at a strain amplitude of 0.001"):
        assert "strain_amplitude" in slid(on=at(1e-3), pressure=1e5).warnings
    with pytest.raises(TypeError, match=r"use the modulus at\(amplitude, reference_frequency=...\)"):
        slid(on=vr.HalfSpace(shear_modulus=filled, poisson_ratio=0.5))


def test_progress_and_cancellation():
    stages = []
    slid(progress=lambda stage, fraction: stages.append((stage, fraction)))
    assert all(0.0 <= fraction <= 1.0 for _, fraction in stages)

    class StopError(Exception):
        pass

    def stop(stage, fraction):
        raise StopError

    large = vr.RoughSurface.self_affine(768, SIDE, hurst=0.8, rolloff=SIDE / 4, cutoff=SIDE / 32, rms_slope=0.1, seed=4)
    with pytest.raises(StopError):
        slid(large, progress=stop)


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"pressure": 0.0}, "pressure must be > 0 Pa, got 0"),
        ({"pressure": None}, "exactly one of pressure and load must be given"),
        ({"load": 1.0}, "exactly one of pressure and load must be given"),
        ({"speed": -1.0}, "speed must be >= 0 m/s, got -1"),
        ({"tolerance": 0.5}, r"tolerance must be in \[1e-13, 0.001\], got 0.5"),
        ({"max_iterations": 0}, "max_iterations must be >= 1, got 0"),
        (
            {"on": vr.HalfSpace(shear_modulus=RUBBER, poisson_ratio=0.5, density=1e3), "speed": 500.0},
            "^speed must be below the critical speed 95.5.* m/s",
        ),
        ({"on": vr.CoatedPlane()}, "on must be a plane with layers or a deformable base, got a rigid plane"),
        ({"surface": vr.RoughSurface(np.zeros(4), 1e-6)}, r"heights.rows must be in \[8, 16384\], got 4"),
        ({"surface": vr.RoughSurface(np.zeros((8, 2)), 1e-6)}, r"heights.columns must be 1 or in \[8, 16384\], got 2"),
    ],
)
def test_messages(options, message):
    with pytest.raises(ValueError, match=message):
        slid(**options)


def test_wrong_types():
    with pytest.raises(TypeError, match=r"surface must be a viscoroll\.RoughSurface"):
        slid(WAVY.heights)
    with pytest.raises(TypeError, match=r"on must be a viscoroll\.CoatedPlane or viscoroll\.HalfSpace"):
        slid(on=RUBBER)


def test_text_and_pictures():
    r = slid()
    text = repr(r)
    assert text.startswith("Sliding at 0.1 m/s under a mean pressure of 10000 Pa")
    for label in ("friction coefficient due to losses", "real contact area", "Persson's estimates"):
        assert label in text
    assert r._repr_html_().startswith("<")
    assert len(r.plot().axes) == 2
    assert len(slid(vr.RoughSurface(WAVY.heights[:, 0], SIDE / 64)).plot().axes) == 1
