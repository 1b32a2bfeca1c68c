"""Both compliances of the library compared with finite strain: `python -m tests.reference.finite_strain_table`.

The program prints a table for every geometry, which takes about twenty minutes on one core. With `--first-order`, it
prints within half a minute the first geometry with coarse first-order elements and the contact of
`finite_strain_obstacle`. Only this file of tests/reference and `finite_strain_slow` import the package. Lengths are
in mm, moduli in units of G. Results are compared at equal load.
"""

from __future__ import annotations

import argparse

import numpy as np
import viscoroll as vr
from viscoroll import enums

from .finite_strain import Coating
from .finite_strain_obstacle import press_node_by_node
from .finite_strain_torque import VISCOSITIES, slow_torques

GEOMETRIES = (  # core radius, outer radius, Poisson's ratio
    (20.0, 21.0, 0.5),
    (20.0, 21.0, 0.3),
    (20.75, 21.0, 0.5),
    (20.75, 21.0, 0.3),
    (20.0, 25.0, 0.5),
    (20.0, 25.0, 0.3),
)
STRAINS = (0.02, 0.06, 0.10, 0.15, 0.20)
FIRST_ORDER_SIZES = (1 / 12, 1 / 12, 1 / 8, 1 / 8, 1 / 8)  # element size / thickness
THIN_STRAINS = (0.04, 0.08, 0.16, 0.24)
#: Standard linear solid with tau = eta/G = 1 s.
RUBBER = vr.StandardLinearSolid(instantaneous_modulus=2e6, relaxed_modulus=1e6, relaxation_time=1.0)
# Omega tau r_o / a at the lowest of three speeds, each twice the previous one
LOWEST_SPEED = 0.015


def press_to(geometry, strains, **sizes):
    """Yield coating, state, strain and load at penetrations within 0.1 % of `strains` times the thickness."""
    core_radius, outer_radius, _ = geometry
    before, edge, wanted = None, None, None
    for strain in strains:
        depth = strain * (outer_radius - core_radius)
        edge = np.sqrt(1.5 * depth / outer_radius) if edge is None else edge * np.sqrt(depth / wanted)
        wanted, penetration = depth, 0.0
        while abs(penetration / depth - 1.0) > 1e-3:
            coating = Coating(*geometry, edge, **sizes)
            state, penetration, load = coating.press(coating.guess_from(*before) if before else None)
            before = coating, state
            edge *= np.sqrt(depth / penetration)
        yield coating, state, penetration / coating.thickness, load


def ball(geometry, modulus):
    core_radius, outer_radius, poisson_ratio = geometry
    layer = vr.Layer(thickness=1e-3 * (outer_radius - core_radius), shear_modulus=modulus, poisson_ratio=poisson_ratio)
    return vr.CoatedSphere(core_radius=1e-3 * core_radius, layers=[layer])


def penetration(geometry, load, edge, compliance, nodes=100):
    """Return penetration / thickness of an elastic coating; `nodes` is their number from center to edge."""
    mesh = vr.Mesh(nodes_per_revolution=round(2.0 * np.pi * nodes / edge))
    elastic = ball(geometry, vr.Elastic(modulus=1e6))
    result = vr.solve(elastic, load=load, angular_speed=1e-3, mesh=mesh, compliance=compliance)
    return 1e3 * result.penetration / (geometry[1] - geometry[0])


def low_speed_results(solid, load, edge, names, nodes=100, **options):
    """Return results of a body of RUBBER as the speed goes to zero; torques are in units of P Omega r_o eta/G.

    Meshes have `nodes` from the center of the contact to its edge [rad]. They must resolve r_o Omega tau, so a parabola
    through three speeds is extrapolated. With C_RR, the limit of the resisting torque of a ball is known: it is the
    mean of y/r_o weighted by the pressure, since u_r = y - H in contact and the power is that of -p d^2u_r/dphi^2. The
    error is 3e-4 with 100 nodes.
    """
    mesh = vr.Mesh(nodes_per_revolution=round(2.0 * np.pi * nodes / edge))
    rows = []
    for speed in LOWEST_SPEED * 100 / nodes * edge * np.array([1.0, 2.0, 4.0]):
        result = vr.solve(solid, load=load, angular_speed=speed, mesh=mesh, **options)
        unit = load * speed * solid.outer_radius
        rows.append([getattr(result, name) / (unit if name.endswith("_torque") else 1.0) for name in names])
    return np.array([8.0, -6.0, 1.0]) / 3.0 @ np.array(rows)


def low_speed_torques(geometry, load, edge, compliance):
    """Return sum x p and the driving torque of a ball, as `low_speed_results` does."""
    names = ("resisting_torque", "driving_torque")
    return low_speed_results(ball(geometry, RUBBER), load, edge, names, compliance=compliance)


def compare(geometry, strains, **sizes):
    """Yield a row for each strain: strain, its finite-strain torques, and the library's results at the same load."""
    for coating, state, strain, load in press_to(geometry, strains, **sizes):
        row = {"strain": strain, "load": load} | slow_torques(coating, state, load)
        for name, compliance in (("RR", enums.Compliance.RADIAL), ("WW", enums.Compliance.VERTICAL)):
            case = geometry, load, coating.edge, compliance
            row[f"penetration {name}"] = penetration(*case) / strain - 1.0
            row[f"offset {name}"], row[f"drive {name}"] = low_speed_torques(*case)
        yield row


def print_first_order():
    core_radius, outer_radius, _ = geometry = GEOMETRIES[0]
    print("| penetration / h | size / h | d, C_RR | d, C_WW |\n" + "|---" * 4 + "|")
    for strain, size in zip(STRAINS, FIRST_ORDER_SIZES, strict=True):
        depth = strain * (outer_radius - core_radius)
        turn = size * (outer_radius - core_radius) / outer_radius
        edge = np.sqrt(1.6 * depth / outer_radius)
        coating = Coating(*geometry, turn * round(edge / turn), finest=size, coarsest=size, growth=1.0, order=1)
        _, load = press_node_by_node(coating, depth)
        offs = [
            penetration(geometry, load, edge, by) / strain - 1.0
            for by in (enums.Compliance.RADIAL, enums.Compliance.VERTICAL)
        ]
        print(f"| {strain:.0%} | {size:.4f} | " + " | ".join(f"{off:+.2%}" for off in offs), "|", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--finest", type=float, default=0.002, help="smallest element, in thicknesses")
    parser.add_argument("--coarsest", type=float, default=0.2, help="largest element, in thicknesses")
    parser.add_argument("--first-order", action="store_true", help="use coarse elements of first order")
    sizes = vars(parser.parse_args())
    if sizes.pop("first_order"):
        print_first_order()
        return
    for geometry in GEOMETRIES:
        core_radius, outer_radius, poisson_ratio = geometry
        print(f"\nr_i = {core_radius} mm, r_o = {outer_radius} mm, nu = {poisson_ratio}", flush=True)
        print("| penetration / h | P/(G h^2) | d, C_RR | d, C_WW | " + " | ".join(VISCOSITIES), end=" | ")
        print("sum x p, C_RR | sum x p, C_WW | driving torque, C_WW |\n" + "|---" * 10 + "|")
        for row in compare(geometry, THIN_STRAINS if core_radius == 20.75 else STRAINS, **sizes):
            reduced = row["load"] / (outer_radius - core_radius) ** 2
            print(f"| {row['strain']:.2%} | {reduced:.4g}", end=" | ")
            print(f"{row['penetration RR']:+.2%} | {row['penetration WW']:+.2%}", end=" | ")
            print(" | ".join(f"{row[name]:.4f}" for name in VISCOSITIES), end=" | ")
            print(" | ".join(f"{row[name]:.4f}" for name in ("offset RR", "offset WW", "drive WW")), "|", flush=True)


if __name__ == "__main__":
    main()
