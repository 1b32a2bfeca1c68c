"""Fields in an elastic half-space: stresses of Hertz's pressure on the axis, and of shear by Cerruti's solution."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
import viscoroll as vr

MODULUS, RADIUS = 5e6, 50e-3


def rolled(poisson_ratio, contact, nodes, friction=0.0):
    """Roll a rigid ball on an elastic half-space, with the given contact radius [m]."""
    load = 8.0 * MODULUS * contact**3 / (3.0 * (1.0 - poisson_ratio) * RADIUS)
    base = vr.HalfSpace(shear_modulus=vr.Elastic(modulus=MODULUS), poisson_ratio=poisson_ratio)
    return vr.solve(
        vr.CoatedSphere(core_radius=RADIUS),
        on=vr.CoatedPlane(layers=[], base=base),
        load=load,
        angular_speed=1.0,
        friction=friction,
        mesh=vr.Mesh(nodes_per_revolution=nodes),
    )


@pytest.mark.parametrize(("poisson_ratio", "shear", "depth"), [(0.3, 0.310, 0.48), (0.5, 0.266, 0.55)])
def test_hertz_under_a_ball(poisson_ratio, shear, depth):
    """Largest shear and stresses on the axis (K. L. Johnson, Contact Mechanics, equation 3.45 and section 4.2)."""
    contact = 0.01 * RADIUS
    r = rolled(poisson_ratio, contact, 12500)  # twenty nodes per contact radius
    peak = 1.5 * r.load / (math.pi * contact**2)
    assert r.max_pressure == pytest.approx(peak, rel=2e-3)
    zeta = np.concatenate([[0.2, 0.3], np.arange(0.40, 0.66, 0.02), [1.0, 2.0]])
    inside = r.interior(depth=contact * zeta, phi=[0.5 * math.pi], theta=[0.5 * math.pi]).squeeze()
    radial = inside.stress.sel(component="rr")
    down = -1.0 / (1.0 + zeta**2)
    around = -((1.0 + poisson_ratio) * (1.0 - zeta * np.arctan(1.0 / zeta)) - 0.5 / (1.0 + zeta**2))
    np.testing.assert_allclose(radial / peak, down, atol=3e-3)  # error of the patches
    for component in ("phiphi", "thetatheta"):
        np.testing.assert_allclose(inside.stress.sel(component=component) / peak, around, atol=3e-3)
    largest = 0.5 * (inside.principal_stress[0] - inside.principal_stress[2]).to_numpy() / peak
    assert largest.max() == pytest.approx(shear, rel=5e-3)
    assert zeta[largest.argmax()] == pytest.approx(depth, abs=0.02)


def cerruti(x, y, z, poisson_ratio):
    """Return the stresses xx, yy, zz, xy, yz, zx of a unit force along x, z down (Johnson, equation 3.76)."""
    rho = np.sqrt(x**2 + y**2 + z**2)
    s = rho + z
    m = 1.0 - 2.0 * poisson_ratio
    return np.array(
        [
            -3 * x**3 / rho**5
            + m * (x / rho**3 - 3 * x / (rho * s**2) + x**3 / (rho**3 * s**2) + 2 * x**3 / (rho**2 * s**3)),
            -3 * x * y**2 / rho**5
            + m * (x / rho**3 - x / (rho * s**2) + x * y**2 / (rho**3 * s**2) + 2 * x * y**2 / (rho**2 * s**3)),
            -3 * x * z**2 / rho**5,
            -3 * x**2 * y / rho**5
            + m * (-y / (rho * s**2) + x**2 * y / (rho**3 * s**2) + 2 * x**2 * y / (rho**2 * s**3)),
            -3 * x * y * z / rho**5,
            -3 * x**2 * z / rho**5,
        ]
    ) / (2.0 * math.pi)


@pytest.mark.parametrize("poisson_ratio", [0.3, 0.5])
@pytest.mark.parametrize("across", [False, True])
def test_shear_tractions_agree_with_cerruti(poisson_ratio, across):
    """All six stresses below a round patch of asymmetric shear, compared with the sum over its point forces."""
    contact = 0.02 * RADIUS
    r = rolled(poisson_ratio, contact, 3000, friction=0.3)
    x, z = r.x, r.z
    bump = np.where(r.contact, 1e5 * (1.0 + 0.5 * (x + 2.0 * z) / contact), 0.0)
    nothing = np.zeros_like(bump)
    r = replace(r, pressure=nothing, shear_traction=np.array([nothing, bump] if across else [bump, nothing]))
    patch = (RADIUS * r.mesh.spacing) ** 2
    depths = contact * np.array([0.6, 1.0, 2.0])
    steps = np.array([-1.2, -0.4, 0.0, 0.7]) / RADIUS * contact
    found = r.interior(depth=depths, phi=0.5 * math.pi - steps, theta=0.5 * math.pi - 1.3 * steps, of="counterbody")
    here_x, here_z = found.x.to_numpy()[:, None], found.z.to_numpy()[None, :]
    # The reaction of the ball's tractions loads the plane. φ points backward, θ to -z and r upwards.
    for level, depth in enumerate(depths):
        along, aside = here_x[..., None, None] - x, here_z[..., None, None] - z
        if across:
            along, aside = aside, along
        stress = -patch * (cerruti(along, aside, depth, poisson_ratio) * bump).sum(axis=(-1, -2))
        xx, yy, zz, xy, yz, zx = stress
        expected = (
            {"rr": zz, "phiphi": yy, "thetatheta": xx, "rphi": yz, "rtheta": zx, "phitheta": xy}
            if across
            else {"rr": zz, "phiphi": xx, "thetatheta": yy, "rphi": zx, "rtheta": yz, "phitheta": xy}
        )
        size = max(np.abs(values).max() for values in expected.values())
        for component, values in expected.items():
            got = found.stress.sel(component=component).isel(depth=level)
            np.testing.assert_allclose(got, values, atol=5e-3 * size, err_msg=f"{component} at {depth / contact:.1f} a")


@pytest.mark.parametrize("poisson_ratio", [0.3, 0.5])
def test_stresses_of_shear_under_a_roller_follow_from_those_of_pressure(poisson_ratio):
    """For tractions q of Hertz's shape, σ_zz is q τ_xz/p and τ_xz is q σ_xx/p of Hertz's p (Johnson, section 7.1)."""
    radius, load = 79.5e-3, 500.0
    base = vr.HalfSpace(shear_modulus=vr.Elastic(modulus=MODULUS), poisson_ratio=poisson_ratio)
    r = vr.solve(
        vr.CoatedCylinder(core_radius=radius),
        on=vr.CoatedPlane(base=base),
        load=load,
        angular_speed=1.0,
        friction=0.3,
        mesh=vr.Mesh(nodes_per_revolution=20000),
    )
    a = r.semi_axis_x
    shape = np.sqrt(np.clip(1.0 - (r.x / a) ** 2, 0.0, None))
    nothing = np.zeros_like(shape)
    r = replace(r, pressure=nothing, shear_traction=np.array([1e5 * shape, nothing]))
    y, x = np.array([0.2, 0.5, 1.0, 2.0])[:, None] * a, np.array([0.0, 0.4, -0.9]) * a
    inside = r.interior(depth=y[:, 0], phi=0.5 * math.pi - x / radius, of="counterbody").isel(theta=0)
    difference = a**2 - x**2 + y**2
    root = np.sqrt(difference**2 + 4.0 * x**2 * y**2)
    m, n = np.sqrt(0.5 * (root + difference)), np.sign(x) * np.sqrt(0.5 * (root - difference))
    along = -(m * (1.0 + (y**2 + n**2) / (m**2 + n**2)) - 2.0 * y) / a
    shear = -n * (m**2 - y**2) / (m**2 + n**2) / a
    # The reaction of the roller's tractions loads the plane.
    np.testing.assert_allclose(inside.stress.sel(component="rr"), -1e5 * shear, atol=2e2)
    np.testing.assert_allclose(inside.stress.sel(component="rphi"), -1e5 * along, atol=2e2)
