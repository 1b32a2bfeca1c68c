"""Fields inside the layers under sliding rough surfaces: closed forms, means, and the interior of a rolling ball."""

from __future__ import annotations

import numpy as np
import pytest
import viscoroll as vr
from viscoroll.solution.interior_files import save_interior

from tests.reference import sliding as reference
from tests.reference import sliding_inside
from tests.sliding_cases import (
    MAT,
    ON_HALF_SPACE,
    RUBBER,
    SIDE,
    SOFT,
    SOFT_SOLID,
    SOLID,
    TWO_LAYERS,
    half_space,
    paraboloid,
    rough,
    slid,
)


@pytest.mark.parametrize("on", [MAT, TWO_LAYERS, ON_HALF_SPACE, half_space(0.3)], ids=["mat", "two", "coated", "half"])
@pytest.mark.parametrize("shape", [(24, 20), (25, 21), (40, 1)])
@pytest.mark.parametrize("friction", [0.0, 0.5])
def test_mean_stresses_are_those_of_the_surface(on, shape, friction):
    # Equilibrium of the material above a depth.
    r = slid(rough(shape), on, friction=friction)
    assert 0.05 < r.contact_share < 0.95
    means = r.interior(depth=[0.0, 3e-5, 8e-5, 1.5e-4]).stress.mean(("x", "z")).transpose("depth", "component")
    down = means.sel(component=["rr", "rphi", "rtheta"])
    np.testing.assert_allclose(down, np.broadcast_to([-5e4, -5e4 * friction, 0.0], down.shape), atol=1e-9 * 5e4)


@pytest.mark.parametrize("poisson_ratio", [0.5, 0.3])
@pytest.mark.parametrize("waves", [(1, 0), (2, 1), (1, -3), (0, 2)])
@pytest.mark.parametrize("speed", [0.0, 0.03])
def test_a_wave_in_full_contact_on_a_half_space(poisson_ratio, waves, speed):
    # Pressure and friction of the wave follow from its height, h = C p, and the stresses from Airy's function.
    shape, friction = (20, 16), 0.4 if speed > 0.0 else 0.0
    sides = (SIDE, 0.6 * SIDE)
    x, z = np.meshgrid(*(side * np.arange(n) / n for side, n in zip(sides, shape, strict=True)), indexing="ij")
    k_x, k_z = (2.0 * np.pi * i / side for i, side in zip(waves, sides, strict=True))
    k, height = np.hypot(k_x, k_z), 1e-6
    phase = np.exp(1j * (k_x * x + k_z * z))
    surface = vr.RoughSurface(height * phase.real, tuple(side / n for side, n in zip(sides, shape, strict=True)))
    mean = 1e6
    r = slid(surface, half_space(poisson_ratio), pressure=mean, speed=speed, friction=friction)
    assert r.contact_share == 1.0
    cosine, sine = k_x / k, k_z / k
    in_plane = reference.half_space_in_plane(k, SOLID(-k_x * speed), poisson_ratio)
    pressure = height / (in_plane @ [1.0, friction * cosine])[0]
    depths = np.array([0.0, 0.2, 0.7, 2.0, 6.0]) / k
    inside = r.interior(depth=depths)
    for number, depth in enumerate(depths):
        wave = sliding_inside.half_space_wave(
            k, poisson_ratio, pressure, friction * cosine * pressure, -friction * sine * pressure, depth
        )
        amplitudes = sliding_inside.in_the_frame_of_the_map(wave, cosine, sine)
        expected = (amplitudes[:, np.newaxis, np.newaxis] * phase).real
        sideways = poisson_ratio / (1.0 - poisson_ratio)
        expected -= mean * np.array([1.0, sideways, sideways, friction, 0.0, 0.0])[:, np.newaxis, np.newaxis]
        # The series over the orders have an error of 1e-8 of the pressure, and the contact a tolerance of 1e-9.
        np.testing.assert_allclose(inside.stress[:, number], expected, atol=3e-8 * mean)
    # The surface follows the wave, apart from the sinking of its mean.
    inwards = -inside.displacement.sel(direction="r")[0]
    np.testing.assert_allclose(inwards - inwards.mean(), surface.heights, atol=3e-8 * height)


@pytest.mark.parametrize("name", ["incompressible", "compressible", "two layers"])
def test_a_wave_in_full_contact_on_layers(name):
    layers = {
        "incompressible": [(2e-4, SOLID, 0.5)],
        "compressible": [(2e-4, SOLID, 0.3)],
        "two layers": [(8e-5, SOLID, 0.3), (1e-4, SOFT_SOLID, 0.4)],
    }[name]
    moduli = {SOLID: RUBBER, SOFT_SOLID: SOFT}
    on = vr.CoatedPlane(
        layers=[vr.Layer(thickness=h, shear_modulus=moduli[solid], poisson_ratio=nu) for h, solid, nu in layers[::-1]]
    )
    nodes, height, speed, friction, mean = 24, 5e-7, 0.03, 0.4, 4e5
    x = SIDE * np.arange(nodes) / nodes
    k = 2.0 * np.pi * 2 / SIDE
    r = slid(vr.RoughSurface(height * np.cos(k * x), SIDE / nodes), on, pressure=mean, speed=speed, friction=friction)
    assert r.contact_share == 1.0
    at_speed = [(h, solid(-k * speed), nu) for h, solid, nu in layers]
    unit = sliding_inside.layered_wave(k, at_speed, 1.0, friction, 0.0)
    pressure = height / unit.inwards
    depths = np.array([0.0, 5e-5, 7.9e-5, 1.2e-4, 1.8e-4])
    inside = r.interior(depth=depths).isel(z=0)
    relaxed = [(h, solid(0.0), nu) for h, solid, nu in layers]
    for number, depth in enumerate(depths):
        wave = sliding_inside.layered_wave(k, at_speed, pressure, friction * pressure, depth)
        amplitudes = sliding_inside.in_the_frame_of_the_map(wave, 1.0, 0.0)
        expected = (amplitudes[:, np.newaxis] * np.exp(1j * k * x)).real
        bottoms = np.cumsum([h for h, _, _ in layers])
        nu = layers[int(np.searchsorted(bottoms, depth))][2]
        sideways = nu / (1.0 - nu)
        expected -= mean * np.array([1.0, sideways, sideways, friction, 0.0, 0.0])[:, np.newaxis]
        np.testing.assert_allclose(inside.stress[:, number], expected, atol=3e-8 * mean)
        # Below the mean pressure and friction, the material from here to the base is compressed and sheared.
        below = [(min(h, max(0.0, b - depth)), g, n) for (h, g, n), b in zip(relaxed, bottoms, strict=True)]
        sunk = sum(mean * (1 - 2 * n) / (2 * g.real * (1 - n)) * h for h, g, n in below)
        pulled = sum(friction * mean / g.real * h for h, g, _ in below)
        inwards, along = ((a * np.exp(1j * k * x)).real for a in (wave.inwards, wave.along))
        moved = inside.displacement[:, number]
        np.testing.assert_allclose(-moved.sel(direction="r"), inwards + sunk, atol=3e-8 * (height + sunk))
        np.testing.assert_allclose(-moved.sel(direction="phi"), along + pulled, atol=3e-8 * (height + pulled))


@pytest.mark.parametrize("shape", [(24, 20), (25, 21), (32, 1)])
def test_the_surface_has_the_gap_of_the_contact(shape):
    r = slid(rough(shape), TWO_LAYERS, friction=0.3)
    displacement = r.interior(depth=[0.0]).displacement.sel(direction="r")[0].to_numpy()
    apart = displacement + r.surface.heights + r.gap
    np.testing.assert_allclose(apart - apart.mean(), 0.0, atol=1e-7 * np.ptp(r.surface.heights))


def test_a_profile_is_a_map_that_is_constant_across():
    profile = rough((32, 1))
    extended = vr.RoughSurface(np.repeat(profile.heights, 12, axis=1), (profile.spacing[0], 3e-5))
    line, wide = (slid(surface, TWO_LAYERS, friction=0.4) for surface in (profile, extended))
    depths = [0.0, 5e-5, 8e-5]
    of_line, of_map = (r.interior(depth=depths) for r in (line, wide))
    for name in ("stress", "strain", "displacement"):
        expected = of_line[name].isel(z=0)
        largest = float(np.abs(expected).max())
        assert float(np.abs(of_map[name] - expected).max()) < 1e-7 * largest, name
    lost, lost_below_map = line.loss(), wide.loss()
    width = 12 * 3e-5
    assert lost_below_map.attrs["power"] == pytest.approx(lost.attrs["power"] * width, rel=1e-7)
    assert lost_below_map.loss_density.max() == pytest.approx(float(lost.loss_density.max()), rel=1e-3)


def test_between_the_nodes_the_fields_are_those_of_the_same_waves():
    # Resampled without contact changes: the same pressure on twice the nodes has the same waves.
    r = slid(rough((24, 20)), TWO_LAYERS)
    depth = [4e-5]
    fields = r.interior(depth=depth, x=r.interior(depth=depth).x + 0.3 * r.surface.spacing[0])
    spectrum = np.fft.fft(r.interior(depth=depth).stress.to_numpy(), axis=2)
    waves = np.fft.fftfreq(24, 1.0 / 24)
    spectrum[:, :, 12] = 0.0  # the highest wave has no phase
    shifted = np.fft.ifft(spectrum * np.exp(2j * np.pi * waves * 0.3 / 24)[:, np.newaxis], axis=2).real
    difference = np.abs(fields.stress.to_numpy() - shifted).max()
    assert difference < 0.02 * r.max_pressure  # that wave, which decays with depth
    one_period = r.interior(depth=depth, x=[1e-4, 1e-4 + SIDE, 1e-4 - 3 * SIDE], z=[2e-4]).stress
    np.testing.assert_allclose(one_period, one_period.isel(x=[0, 0, 0]), atol=1e-9 * r.max_pressure)


@pytest.mark.parametrize("nodes", [61, 60])
@pytest.mark.parametrize("speed", [0.0525, 0.0])
def test_a_finite_paraboloid_is_a_ball_on_a_mat(nodes, speed):
    # Nodes, layers and patches are those of the rolling ball. The angles of the ball have their origin at its middle.
    radius, load = 21e-3, 30.0
    mat = vr.CoatedPlane(layers=[vr.Layer(thickness=1e-3, shear_modulus=RUBBER, poisson_ratio=0.45)])
    mesh = vr.Mesh(nodes_per_revolution=900)
    spacing = radius * mesh.spacing
    surface = vr.RoughSurface(paraboloid(nodes, spacing, radius), spacing=spacing, periodic=False)
    r = slid(surface, mat, pressure=None, load=load, speed=speed)
    rolled = vr.solve(
        vr.CoatedSphere(core_radius=radius), load=load, angular_speed=max(speed, 1e-9) / radius, on=mat, mesh=mesh
    )
    depths = [2e-4, 1e-3]
    away = np.array([-20, -3, 0, 5, 18])
    angles = 0.5 * np.pi - away * mesh.spacing
    expected = rolled.interior(depth=depths, phi=angles, theta=angles)
    places = spacing * (nodes // 2 + away)
    inside = r.interior(depth=depths, x=places, z=places)
    for name in ("stress", "strain", "displacement"):
        largest = np.abs(expected[name]).max().item()
        # The tolerances of both contacts, and the sums over different orders
        np.testing.assert_allclose(inside[name], expected[name].to_numpy(), atol=2e-5 * largest)
    if speed > 0.0:
        lost, of_ball = r.loss(depth=depths), rolled.loss(depth=depths)
        assert lost.attrs["power"] == pytest.approx(of_ball.attrs["power"], rel=2e-3)
        assert lost.loss_density.max() == pytest.approx(of_ball.loss_density.max().item(), rel=5e-3)


def test_an_asperity_of_a_long_period_is_a_ball_on_a_mat():
    # Between the contacts of two periods, the free surface is ten thicknesses of the layer long, and ten times the
    # distance of 1 mm in which the rubber recovers. With 81 nodes in place of 121, the difference is five times as
    # large.
    radius, load, speed = 21e-3, 5.0, 0.01
    mat = vr.CoatedPlane(layers=[vr.Layer(thickness=1e-3, shear_modulus=RUBBER, poisson_ratio=0.45)])
    mesh = vr.Mesh(nodes_per_revolution=1200)
    spacing = radius * mesh.spacing
    nodes = 121
    period = vr.RoughSurface(paraboloid(nodes, spacing, radius), spacing=spacing)
    r = slid(period, mat, pressure=None, load=load, speed=speed)
    rolled = vr.solve(vr.CoatedSphere(core_radius=radius), load=load, angular_speed=speed / radius, on=mat, mesh=mesh)
    depths = [3e-4, 1e-3]
    away = np.array([-8, -3, 0, 4, 9])
    angles = 0.5 * np.pi - away * mesh.spacing
    expected = rolled.interior(depth=depths, phi=angles, theta=angles).stress
    places = spacing * (nodes // 2 + away)
    stress = r.interior(depth=depths, x=places, z=places).stress
    # The rest is the error of the mesh: nodes press on patches under the ball, and are samples of waves under the
    # period, with 15 nodes from the middle of the contact to its end.
    assert np.abs(stress.to_numpy() - expected.to_numpy()).max() < 5e-4 * rolled.max_pressure


def test_bonds_are_between_layers_and_at_the_base():
    r = slid(rough((24, 20)), TWO_LAYERS, friction=0.3)
    bonds = r.bonds()
    np.testing.assert_allclose(bonds.depth, [1.8e-4, 8e-5, 8e-5])
    assert bonds.layer.to_numpy().tolist() == [0, 1, 0]
    along = bonds.stress.sel(component=["rr", "rphi", "rtheta"])
    # Tractions and displacements are continuous.
    np.testing.assert_allclose(along[:, 1], along[:, 2], atol=1e-12 * r.max_pressure)
    np.testing.assert_allclose(bonds.displacement[:, 1], bonds.displacement[:, 2], rtol=1e-12)
    np.testing.assert_allclose(bonds.displacement[:, 0], 0.0, atol=1e-20)
    assert (bonds.shear_traction >= 0.0).all()
    assert bonds.opening_traction.min() == 0.0
    with pytest.raises(ValueError, match=r"result\.on must have a rigid base or several layers to have bonds"):
        slid(rough((24, 20)), half_space(0.5)).bonds()


def test_threads_do_not_change_the_fields():
    r = slid(rough((24, 20)), TWO_LAYERS, friction=0.3)
    one, two = (r.interior(depth=[2e-5, 1e-4], threads=threads) for threads in (1, 2))
    assert (one.stress == two.stress).all()
    first, second = (r.loss(threads=threads) for threads in (1, 2))
    assert (first.loss_density == second.loss_density).all()
    assert first.attrs == second.attrs


def test_messages(tmp_path):
    r = slid(rough((24, 20)))
    with pytest.raises(ValueError, match=r"depth must be in \[0, 0\.0002\] m"):
        r.interior(depth=[3e-4])
    with pytest.raises(ValueError, match="x must be one-dimensional"):
        r.interior(depth=[1e-4], x=[[0.0]])
    line = slid(rough((32, 1)))
    with pytest.raises(ValueError, match=r"z must be 0 m under a profile, got 0\.001 m"):
        line.interior(depth=[1e-4], z=[1e-3])
    tip = vr.RoughSurface(paraboloid(31, 5e-5, 5e-3), 5e-5, periodic=False)
    finite = slid(tip, pressure=None, load=0.05)
    with pytest.raises(ValueError, match="depth must be > 0 m under a surface of finite size, got 0 m"):
        finite.interior(depth=[0.0])
    with pytest.raises(ValueError, match=r"x must be in \[-0\.00\d+, 0\.00\d+\] m, got 0\.01"):
        finite.interior(depth=[1e-4], x=[0.01])
    with pytest.warns(vr.ResultWarning, match="less than a quarter of the node spacing"):
        finite.interior(depth=[1e-5])
    save_interior(r.interior(depth=[1e-4, 2e-4]), tmp_path / "inside.vtu")
    save_interior(r.interior(depth=[1e-4, 2e-4]), tmp_path / "inside.nc")


def test_the_displacement_of_a_half_plane_under_a_finite_profile_is_undefined():
    x = np.linspace(-1.0, 1.0, 81) * 1e-3
    r = slid(vr.RoughSurface(-(x**2) / 0.04, x[1] - x[0], periodic=False), half_space(0.5), pressure=None, load=20.0)
    inside = r.interior(depth=[2e-4])
    assert np.isnan(inside.displacement).all()
    # The load is carried at every depth, most of it near the contact.
    below = r.interior(depth=[2e-4], x=1e-3 + np.linspace(-2.5, 2.5, 1001) * 1e-3).stress.sel(component="rr")
    assert -below.sum() * 5e-6 == pytest.approx(20.0, rel=5e-3)
