"""A rigid ball that rolls on a flat rubber layer, frictionless: python -m tests.reference.rolling_plane [spacing [m]].

The method uses closed forms of the layer's compliance, periodic transforms, its own grid on the plane, and any gap.
Three gaps that agree to second order in x/R change the moment by some tenths of a percent
(docs/theory/planes-and-pairs.md).
"""

from __future__ import annotations

import sys

import numpy as np
from scipy.sparse.linalg import LinearOperator, gmres

RADIUS, THICKNESS, LOAD = 21e-3, 1e-3, 100.0
INSTANTANEOUS, RELAXED, TIME = 6e6, 3e6, 0.125  # the shear modulus is RELAXED + (difference) i w TIME / (1 + i w TIME)

#: Height above the plane [m] at (x, z) [m], and the moment arm of the pressure, R times the slope of the height along
#: x.
GAPS = {
    "paraboloid": lambda x, z: ((x**2 + z**2) / (2 * RADIUS), x),
    # Nodes on the ball, whose arcs along the ball are taken as distances on the plane.
    "arcs": lambda x, z: (
        RADIUS * (1 - np.cos(z / RADIUS) * np.cos(x / RADIUS)),
        RADIUS * np.cos(z / RADIUS) * np.sin(x / RADIUS),
    ),
    "sphere": lambda x, z: (
        RADIUS - np.sqrt(RADIUS**2 - x**2 - z**2),
        x / np.sqrt(1 - (x**2 + z**2) / RADIUS**2),
    ),
}


def compliance(k, omega, base_modulus):
    """Return the normal compliance [m³/N] of the layer: Johnson's on a rigid base, Burmister's on a half-space."""
    rate = 1j * omega * TIME
    modulus = RELAXED + (INSTANTANEOUS - RELAXED) * rate / (1 + rate)
    s, e = k * THICKNESS, np.exp(-2 * k * THICKNESS)
    if base_modulus is None:
        return (1 - e**2 - 4 * s * e) / (2 * modulus * k * (1 + e**2 + (2 + 4 * s**2) * e))
    c = (modulus - base_modulus) / (modulus + base_modulus)
    return (1 + 4 * c * s * e - c**2 * e**2) / (2 * modulus * k * (1 - 2 * (c + 2 * c * s**2) * e + c**2 * e**2))


def influence(speed, base_modulus, spacing, half):
    """Return displacements [m/N] due to a force on a square patch, at offsets up to ± 2 half of (ξ, ζ), ξ backward."""
    wake = speed * TIME * INSTANTANEOUS / RELAXED
    across = 30e-3 if base_modulus is None else 60e-3
    count_x = 2 * int(np.ceil((0.5 * across + 22 * wake + 4 * half * spacing) / spacing / 2))
    count_z = 2 * int(np.ceil(across / spacing / 2))
    k_x = 2 * np.pi * np.fft.rfftfreq(count_x, spacing)[None, :]
    k_z = 2 * np.pi * np.fft.fftfreq(count_z, spacing)[:, None]
    total, round_trip = 0.0, 2 * np.pi / spacing
    for p in range(-2, 3):  # aliases of shorter waves on the grid
        for q in range(-2, 3):
            x, z = k_x + p * round_trip, k_z + q * round_trip
            k = np.maximum(np.hypot(x, z), 1e-3 / across)
            patch = np.sinc(x * spacing / (2 * np.pi)) * np.sinc(z * spacing / (2 * np.pi))
            total = total + compliance(k, speed * x, base_modulus) * patch
            # 1/k has infinitely many images and is replaced by its potential at a depth
            if base_modulus is not None and p == q == 0:
                total = total - np.exp(-k * THICKNESS) / (2 * base_modulus * k)
    periodic = np.fft.irfft2(total, s=(count_z, count_x)) / spacing**2
    offset = np.arange(-2 * half, 2 * half + 1)
    kernel = periodic[np.ix_(offset % count_z, offset % count_x)].T
    if base_modulus is not None:
        distance = np.sqrt((spacing * offset[:, None]) ** 2 + (spacing * offset) ** 2 + THICKNESS**2)
        kernel = kernel + 1 / (4 * np.pi * base_modulus * distance)
    return kernel


def rolling_moment(speed, base_modulus=None, gap="paraboloid", spacing=50e-6, reach=4.4e-3):
    """Return the moment [N m] of the pressure, and the depth [m], from contact on a square of ± `reach`."""
    half = int(np.ceil(reach / spacing))
    axis = spacing * np.arange(-half, half + 1)
    height, arm = GAPS[gap](-axis[:, None], axis[None, :])  # x = -ξ
    size = 6 * half + 2
    kernel = np.zeros((size, size))
    offset = np.arange(-2 * half, 2 * half + 1)
    kernel[np.ix_(offset % size, offset % size)] = influence(speed, base_modulus, spacing, half)
    symbol = np.fft.rfft2(kernel)

    def transformed(values, factor):
        return np.fft.irfft2(np.fft.rfft2(values, s=(size, size)) * factor, s=(size, size))[: len(axis), : len(axis)]

    def pressed(touching, right):
        def embedded(values, factor):
            whole = np.zeros(touching.shape)
            whole[touching] = values
            return transformed(whole, factor)[touching]

        count = int(touching.sum())
        system = LinearOperator((count, count), lambda v: embedded(v, symbol))
        inverse = LinearOperator((count, count), lambda v: embedded(v, 1 / symbol))
        force, info = gmres(system, right[touching], M=inverse, rtol=1e-10, restart=200, maxiter=20)
        assert info == 0
        whole = np.zeros(touching.shape)
        whole[touching] = force
        return whole

    touching = height < 0.4 * height[half, 0]
    for _ in range(60):
        lifted, bent = pressed(touching, np.ones_like(height)), pressed(touching, height)
        depth = (LOAD + bent.sum()) / lifted.sum()
        force = depth * lifted - bent
        overclosed = height + transformed(force, symbol) - depth < 0
        now = np.where(touching, force > 0, overclosed)
        assert not now[[0, -1]].any()
        assert not now[:, [0, -1]].any()
        if (now == touching).all():
            return (arm * force).sum(), depth
        touching = now
    raise AssertionError("the contact did not settle")


def main(spacing: float = 50e-6) -> None:
    """Print the moments of the three gaps, with twice the spacing and with the spacing."""
    for speed, base in ((2.1e-3, None), (10.5e-3, None), (52.5e-3, None), (0.21, None), (52.5e-3, 1e7), (52.5e-3, 1e8)):
        for gap in GAPS:
            found = [1e3 * rolling_moment(speed, base, gap, step)[0] for step in (2 * spacing, spacing)]
            moments = f"{found[0]:.4f}, {found[1]:.4f} mN m"
            print(f"V = {1e3 * speed:5.1f} mm/s, base {base}, {gap:10}: {moments}", flush=True)


if __name__ == "__main__":
    main(*map(float, sys.argv[1:]))
