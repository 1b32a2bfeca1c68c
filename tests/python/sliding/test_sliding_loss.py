"""Loss inside the layers under sliding rough surfaces, and the temperature that follows from it."""

from __future__ import annotations

import itertools

import numpy as np
import pytest
import viscoroll as vr

from tests.sliding_cases import MAT, ON_HALF_SPACE, SIDE, TWO_LAYERS, half_space, paraboloid, rough, slid


@pytest.mark.parametrize("on", [MAT, TWO_LAYERS, ON_HALF_SPACE, half_space(0.3)], ids=["mat", "two", "coated", "half"])
@pytest.mark.parametrize("shape", [(24, 20), (25, 21), (40, 1)])
@pytest.mark.parametrize("friction", [0.0, 0.5])
def test_the_volume_integral_is_the_power_of_the_result(on, shape, friction):
    r = slid(rough(shape), on, friction=friction)
    loss = r.loss()
    area = SIDE * (0.7 * SIDE if shape[1] > 1 else 1.0)
    assert loss.attrs["bulk_power"] == pytest.approx(r.power_density * area, rel=1e-12)
    assert loss.attrs["power"] == pytest.approx(r.power_density * area, rel=1e-7)
    assert loss.layer_power.sum() == pytest.approx(loss.attrs["power"], rel=1e-12)
    assert (loss.layer_power > 0.0).all()
    # Both materials are standard linear solids, each with one relaxation time.
    np.testing.assert_allclose(loss.relaxation_power.sum("term"), loss.layer_power, rtol=1e-12)


@pytest.mark.parametrize("shape", [(27, 21), (41, 1)])
def test_the_density_is_the_work_of_the_stresses(shape):
    # The work of the stress on the strain along the path of a material point, from the fields at the nodes. On an odd
    # number of nodes, their waves contain all of it; the product of two waves has twice as many.
    r = slid(rough(shape), TWO_LAYERS, friction=0.4)
    depths = [1e-5, 6e-5, 1.2e-4]
    x = np.arange(2 * shape[0] + 1) * SIDE / (2 * shape[0] + 1)
    inside = r.interior(depth=depths, x=x)
    waves = 2j * np.pi * np.fft.fftfreq(x.size, x[1])
    twice = np.array([1.0, 1.0, 1.0, 2.0, 2.0, 2.0])
    # Material passes towards -x.
    rate = -np.fft.ifft(waves[:, np.newaxis] * np.fft.fft(inside.strain.to_numpy(), axis=2), axis=2).real
    work = np.einsum("c,cdxz->dz", twice, inside.stress.to_numpy() * rate) * x[1]
    density = r.loss(depth=depths).loss_density.to_numpy()
    np.testing.assert_allclose(density, work, atol=1e-6 * work.max())


def test_elastic_layers_and_layers_at_rest_dissipate_nothing():
    steel = vr.CoatedPlane(
        layers=[
            vr.Layer(thickness=2e-4, shear_modulus=vr.Elastic(modulus=1e6), poisson_ratio=0.3),
            vr.Layer(thickness=1e-4, shear_modulus=vr.Elastic(modulus=3e6), poisson_ratio=0.5),
        ]
    )
    for r in (slid(rough((24, 20)), steel, friction=0.3), slid(rough((24, 20)), TWO_LAYERS, speed=0.0)):
        loss = r.loss()
        assert np.abs(loss.layer_power).max() < 1e-15 * r.mean_pressure * SIDE**2 * 0.02
        assert loss.loss_density.max() < 1e-12 * r.mean_pressure


def test_the_loss_of_a_finite_surface_converges_to_the_power_of_the_result():
    # The sums end at a shortest wave. What they leave out decreases with it.
    nodes, side = 64, 1.5e-3
    surface = vr.RoughSurface(paraboloid(nodes, side / nodes, 2e-3), side / nodes, periodic=False)
    r = slid(surface, MAT, pressure=None, load=0.05, speed=0.05, friction=0.3)
    waves = side / nodes * np.array([4.0, 2.0, 1.0])
    missing = [
        1.0 - loss.attrs["power"] / loss.attrs["bulk_power"] for loss in (r.loss(shortest_wave=w) for w in waves)
    ]
    assert all(fine < 0.7 * coarse for coarse, fine in itertools.pairwise(missing))
    assert 0.0 <= missing[-1] < 2e-3
    assert r.loss().attrs == r.loss(shortest_wave=waves[-1]).attrs


def test_messages():
    periodic = slid(rough((24, 20)))
    with pytest.raises(ValueError, match="shortest_wave must be left out under a periodic surface"):
        periodic.loss(shortest_wave=1e-5)
    tip = vr.RoughSurface(paraboloid(31, 5e-5, 5e-3), 5e-5, periodic=False)
    finite = slid(tip, pressure=None, load=0.05)
    with pytest.raises(ValueError, match=r"shortest_wave must be in \[.*\] m, got 1"):
        finite.loss(shortest_wave=1.0)
    given = {"conductivity": 0.2, "convection": 10.0, "ambient": 293.15}
    with pytest.raises(ValueError, match="period must be left out under a periodic surface"):
        periodic.temperature(period=1.0, **given)
    with pytest.raises(ValueError, match="period must be given under a surface of finite size"):
        finite.temperature(**given)
    with pytest.raises(ValueError, match=r"result\.on must have a finite thickness for a steady temperature"):
        slid(rough((24, 20)), half_space(0.5)).temperature(**given)
    with pytest.raises(ValueError, match=r"result\.speed must be > 0 m/s for a temperature"):
        slid(rough((24, 20)), speed=0.0).temperature(**given)
    with pytest.raises(ValueError, match="convection must be > 0"):
        periodic.temperature(**given | {"convection": 0.0})


def test_the_temperature_under_a_profile():
    # All heat leaves through the surface: its rise is the power per area divided by the coefficient. Below, the heat of
    # deeper layers flows upwards through the conductivity.
    r = slid(rough((40, 1)), TWO_LAYERS)
    t = r.temperature(conductivity=[0.1, 0.3], convection=25.0, ambient=293.15)
    assert t.heat_unit == "W/m²"
    assert t.heat == pytest.approx(r.power_density, rel=1e-12)
    assert t.surface_maximum == pytest.approx(r.power_density / 25.0, rel=1e-9)
    assert t.heat_to_surroundings == pytest.approx(t.heat, rel=1e-9)
    # The heat generated below a depth flows up through it, so that the rise grows downwards by the sum of flux / k.
    cells = 1800
    depths = 1.8e-4 * (np.arange(cells) + 0.5) / cells
    heat = r.loss(depth=depths).power_density.to_numpy()[:, 0] * 1.8e-4 / cells
    flux = heat[::-1].cumsum()[::-1] - 0.5 * heat
    growth = (flux / np.where(depths < 8e-5, 0.3, 0.1)).sum() * 1.8e-4 / cells
    assert t.maximum - t.surface_maximum == pytest.approx(growth, rel=1e-4)


def test_the_temperature_across_a_map():
    profile = rough((32, 1))
    given = {"conductivity": 0.2, "convection": 10.0, "ambient": 293.15}
    extended = vr.RoughSurface(np.repeat(profile.heights, 12, axis=1), (profile.spacing[0], 3e-5))
    line, wide = (slid(surface, MAT).temperature(**given) for surface in (profile, extended))
    assert wide.heat_unit == "W/m"
    assert wide.heat == pytest.approx(line.heat * 12 * 3e-5, rel=1e-6)
    assert wide.maximum == pytest.approx(line.maximum, rel=1e-6)

    rows = rough((32, 24)).heights
    tilted, image = (
        slid(vr.RoughSurface(heights, (SIDE / 32, 4e-5)), MAT) for heights in (rows, np.roll(rows[:, ::-1], 1, axis=1))
    )
    warm, mirrored = (r.temperature(core="isothermal", **given) for r in (tilted, image))
    assert warm.heat == pytest.approx(tilted.power_density * 24 * 4e-5, rel=1e-9)
    assert warm.heat_to_core + warm.heat_to_surroundings == pytest.approx(warm.heat, rel=1e-9)
    rise = warm.rise.to_numpy()
    reversed_rise = np.roll(mirrored.rise.to_numpy()[:, ::-1], 1, axis=1)
    np.testing.assert_allclose(rise, reversed_rise, atol=1e-6 * rise.max())
    assert np.abs(rise - np.roll(rise[:, ::-1], 1, axis=1)).max() > 1e-3 * rise.max()


def test_the_temperature_under_a_wave_across():
    # A layer of one wave of the source across: the response of a slab of finite differences, in plain NumPy.
    shape = (24, 24)
    x, z = np.meshgrid(*(SIDE * np.arange(n) / n for n in shape), indexing="ij")
    heights = 3e-7 * np.cos(2 * np.pi * x / SIDE) * (1.0 + 0.5 * np.sin(2 * np.pi * z / SIDE))
    r = slid(vr.RoughSurface(heights, SIDE / 24), MAT, pressure=4e5)
    assert r.contact_share == 1.0
    conductivity, film = 0.2, 1000.0
    t = r.temperature(conductivity=conductivity, convection=film, ambient=293.15, core="isothermal")
    thickness, cells = 2e-4, 400
    step = thickness / cells
    depths = step * (np.arange(cells) + 0.5)
    density = r.loss(depth=depths).power_density.to_numpy()
    source = np.fft.rfft(density, axis=1)
    waves = np.zeros_like(source)
    for j in range(source.shape[1]):
        k = 2.0 * np.pi * j / SIDE
        flux = conductivity / step
        matrix = np.diag(np.full(cells, 2.0 * flux + conductivity * k**2 * step))
        matrix -= np.diag(np.full(cells - 1, flux), 1) + np.diag(np.full(cells - 1, flux), -1)
        matrix[0, 0] += -flux + 1.0 / (1.0 / film + 0.5 / flux)
        matrix[-1, -1] += flux
        waves[:, j] = np.linalg.solve(matrix, source[:, j] * step)
    rise = np.fft.irfft(waves, shape[1], axis=1)
    places = t.rise.depth.to_numpy()[1:-1]
    expected = np.array([np.interp(places, depths, column) for column in rise.T]).T
    # Finite differences of second order
    np.testing.assert_allclose(t.rise[1:-1], expected, atol=1e-4 * rise.max())
    assert np.ptp(rise[200]) > 0.1 * rise.max()


def test_the_temperature_under_a_finite_surface():
    # Heat per length of the path: the energy of a passage every period.
    tip = vr.RoughSurface(paraboloid(32, 4e-5, 5e-3), 4e-5, periodic=False)
    r = slid(tip, pressure=None, load=0.05)
    given = {"conductivity": 0.2, "convection": 10.0, "ambient": 293.15}
    t, slower = (r.temperature(period=period, **given) for period in (0.5, 1.0))
    force = r.friction_coefficient * 0.05
    assert t.heat == pytest.approx(force / 0.5, rel=1e-9)
    assert slower.maximum == pytest.approx(0.5 * t.maximum, rel=1e-9)
    hottest = int(t.rise[-1].to_numpy().argmax())
    assert t.rise.z[hottest] == pytest.approx(16 * 4e-5, abs=4e-5)


def test_times_and_a_start():
    r = slid(rough((32, 1)), MAT)
    given = {"conductivity": 0.2, "convection": 10.0, "ambient": 293.15}
    t = r.temperature(time=[0.0, 1e5], **given)
    assert t.history is not None
    assert t.history.maximum[0] == pytest.approx(0.0, abs=1e-12)
    assert t.history.maximum[1] == pytest.approx(t.maximum, rel=1e-6)
