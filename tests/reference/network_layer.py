"""A roller on a layer of filled rubber in plane strain: `python -m tests.reference.network_layer` prints a table.

The layer lies on a rigid base. Its rubber is a standard linear solid with constant Poisson's ratio, parallel to springs
and sliders that yield by von Mises, separate for each Gauss point. Steady rolling is periodic along the layer, with
waves along it and quadratic elements through it. A part of the network is included in the linear solid; an iteration
finds the rest of its stress. The contact has no tension, at a given depth of the roller. The command prints load and
moment of two contacts, which takes minutes.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

#: Number of springs with sliders. Their yield strains y are Gauss points in y/(1 + y).
_SLIDERS = 24


@dataclass
class Layer:
    """Thickness and radius [mm], shear moduli [Pa], speed [mm/s], length of a period [mm] and its nodes."""

    poisson_ratio: float = 0.3
    bulk_modulus: float | None = None  # replaces Poisson's ratio
    radius: float = 20.0
    thickness: float = 1.0
    speed: float = 100.0
    relaxed: float = 1e6
    arm: float = 0.5e6
    relaxation_time: float = 10e-3
    network: float = 2e6
    critical_strain: float = 0.01
    length: float = 24.0
    nodes: int = 1024
    elements: int = 8
    share: float = 0.5  # part of the network in the linear solid
    compliance: np.ndarray = field(init=False)

    def __post_init__(self):
        """Assemble the stiffness of every wave."""
        n = self.nodes
        self.k = 2.0 * np.pi * np.fft.rfftfreq(n, self.length / n)
        omega = -self.k * self.speed  # the material passes at -x, in the frame of the roller
        arm = 1j * omega * self.relaxation_time
        self.rubber = self.relaxed + self.arm * arm / (1.0 + arm)
        nodes, weights = np.polynomial.legendre.leggauss(3)
        size = self.thickness / self.elements
        s = 0.5 * (1.0 + nodes)
        values = np.array([(1 - s) * (1 - 2 * s), 4 * s * (1 - s), s * (2 * s - 1)])
        slopes = np.array([4 * s - 3, 4 - 8 * s, 4 * s - 1]) / size
        count = 2 * self.elements + 1
        gauss = 3 * self.elements
        self.values, self.slopes = np.zeros((gauss, count)), np.zeros((gauss, count))
        for e in range(self.elements):
            self.values[3 * e : 3 * e + 3, 2 * e : 2 * e + 3] = values.T
            self.slopes[3 * e : 3 * e + 3, 2 * e : 2 * e + 3] = slopes.T
        self.weights = np.tile(0.5 * size * weights, self.elements)
        free = count - 1  # the first node is fixed to the base
        self.operator, self.inverse = [], []
        ratio = 2.0 * self.poisson_ratio / (1.0 - 2.0 * self.poisson_ratio)
        for k, rubber in zip(self.k, self.rubber, strict=True):
            # Strain (xx, yy, xy doubled) at Gauss points due to displacement (u, v).
            b = np.zeros((3, gauss, 2 * free), complex)
            b[0, :, :free] = 1j * k * self.values[:, 1:]
            b[1, :, free:] = self.slopes[:, 1:]
            b[2, :, :free] = self.slopes[:, 1:]
            b[2, :, free:] = 1j * k * self.values[:, 1:]
            g = rubber + self.share * self.network
            extra = ratio * rubber if self.bulk_modulus is None else self.bulk_modulus - 2.0 / 3.0 * rubber
            stiffness = np.zeros((2 * free, 2 * free), complex)
            # The network has only deviatoric stress; the rubber also resists a change of volume.
            trace = b[0] + b[1]
            w = self.weights[:, None]
            for c, factor in ((0, 2.0), (1, 2.0), (2, 1.0)):
                stiffness += g * factor * (b[c].conj().T @ (w * b[c]))
            bulk = extra - 2.0 / 3.0 * self.share * self.network
            stiffness += bulk * (trace.conj().T @ (w * trace))
            self.operator.append(b)
            self.inverse.append(np.linalg.inv(stiffness))
        # vertical compliance of the surface
        self.compliance = np.array([inv[-1, -1] for inv in self.inverse])
        self.yields, self.share_of = _sliders()

    def displaced(self, pressure, stress):
        """Return strain (3, Gauss, nodes) and height of the surface under pressure and a given stress."""
        load, given = np.fft.rfft(pressure), np.fft.rfft(stress, axis=2)
        strain, height = np.empty(given.shape, complex), np.empty(len(self.k), complex)
        for i, (b, inverse) in enumerate(zip(self.operator, self.inverse, strict=True)):
            force = -sum(b[c].conj().T @ (self.weights * given[c, :, i]) for c in range(3))
            force[-1] -= load[i]
            u = inverse @ force
            strain[:, :, i], height[i] = b @ u, u[-1]
        return np.fft.irfft(strain, self.nodes, axis=2), np.fft.irfft(height, self.nodes)

    def network_stress(self, strain):
        """Return the stress (xx, yy, xy) of springs and sliders along the layer, whose material moves along -x."""
        mean = (strain[0] + strain[1]) / 3.0
        # p = (√2 e_xx, √2 e_yy, √2 e_zz, 2 e_xy), so that simple shear γ has length γ.
        root = np.sqrt(2.0)
        p = np.stack([root * (strain[0] - mean), root * (strain[1] - mean), -root * mean, strain[2]])[:, :, ::-1]
        yields = self.critical_strain * self.yields[:, None]
        q = np.zeros((4, len(self.yields), p.shape[1]))
        # There is no strain before the first round, after which the permanent set remains.
        before = np.zeros(p.shape[:2])
        out = np.empty((4, *p.shape[1:]))
        for turn in range(2):
            for i in range(p.shape[2]):
                q += (p[:, :, i] - before)[:, None, :]
                q *= np.minimum(1.0, yields / np.maximum(np.sqrt((q**2).sum(axis=0)), 1e-300))
                before = p[:, :, i]
                if turn:
                    out[:, :, i] = np.einsum("y,cyp->cp", self.share_of, q)
        out = self.network * out[:, :, ::-1]
        return np.stack([root * out[0], root * out[1], out[3]])

    def contact(self, free, depth):
        """Return the pressure, without tension, that deforms the surface from heights `free` to the roller."""
        x = (np.arange(self.nodes) - self.nodes // 2) * self.length / self.nodes
        gap = x**2 / (2.0 * self.radius) - depth - free
        kernel = np.fft.irfft(-self.compliance, self.nodes)
        inside = gap < 0.0
        for _ in range(60):
            where = np.flatnonzero(inside)
            matrix = kernel[(where[:, None] - where) % self.nodes]
            pressure = np.zeros(self.nodes)
            pressure[where] = np.linalg.solve(matrix, gap[where])
            height = np.fft.irfft(np.fft.rfft(pressure) * -self.compliance, self.nodes)
            kept = (pressure > 0.0) | (~inside & (gap - height < 0.0))
            if (kept == inside).all():
                return x, pressure
            inside = kept
        return x, np.maximum(pressure, 0.0)

    def pass_of(self, depth, *, tolerance=1e-4, most=200):
        """Return load [Pa mm] and moment of the pressure [Pa mm²] at a depth of the roller [mm]."""
        stress = np.zeros((3, len(self.weights), self.nodes))
        before = np.inf
        for _ in range(most):
            free = self.displaced(np.zeros(self.nodes), stress)[1]
            x, pressure = self.contact(free, depth)
            strain = self.displaced(pressure, stress)[0]
            mean = (strain[0] + strain[1]) / 3.0
            linear = self.share * self.network * np.stack([2 * (strain[0] - mean), 2 * (strain[1] - mean), strain[2]])
            stress = self.network_stress(strain) - linear
            spacing = self.length / self.nodes
            load, moment = pressure.sum() * spacing, (pressure * x).sum() * spacing
            if abs(load - before) < tolerance * load:
                return load, moment
            before = load
        raise RuntimeError(f"no end after {most} steps")


def _sliders():
    """Return yield strains / γ_c and the share of each, a modulus: weights 2 dy/(1 + y)³."""
    t, weight = np.polynomial.legendre.leggauss(_SLIDERS)
    t, weight = 0.5 * (1.0 + t), 0.5 * weight
    return t / (1.0 - t), 2.0 * (1.0 - t) * weight


def main():
    """Print load and moment."""
    print("   ratio   depth [mm]     P [Pa mm]    M [Pa mm²]")
    for ratio, depth in ((0.3, 0.003), (0.3, 0.02), (0.3, 0.1), (0.45, 0.02)):
        load, moment = Layer(poisson_ratio=ratio, nodes=4096).pass_of(depth, tolerance=1e-5)
        print(f"{ratio:8g} {depth:12g} {load:13.6g} {moment:13.6g}", flush=True)


if __name__ == "__main__":
    main()
