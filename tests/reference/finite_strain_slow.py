"""Balls and wheels at finite strain in slow rolling, against linear theory and the overspeed rule.

`python -m tests.reference.finite_strain_slow balls` prints the tables of balls in docs/finite-strain.md in three
minutes, and `wheels` those of wheels in ten minutes on one core. The torque at finite strain follows from the elastic
deformation and Newton's viscosity, so that no history is computed. All results are compared at the same load. `c` is
the stretch of the contact along the path per chord of the undeformed surface, as in linear theory.
"""

from __future__ import annotations

import argparse
import warnings
from dataclasses import dataclass

import viscoroll as vr

from . import finite_strain_table as table
from .finite_strain_torque import slow_torques
from .finite_strain_wheel import press_tread

#: Core radius, thickness and width of the treads [mm], with the strains.
TREADS = ((40.0, 10.0, 30.0, (0.1, 0.2)), (40.0, 10.0, 60.0, (0.1,)), (40.0, 4.0, 30.0, (0.1,)))


@dataclass(frozen=True)
class Row:
    """Torques in units of P Ω r_o η/G, overspeed, and relative error that the library states for its torque."""

    strain: float
    torque: float
    stretch: float
    linear_torque: float
    corrected_torque: float
    overspeed: float
    stated_error: float

    def __str__(self):
        """Return the row of a table."""
        ratios = (self.torque / self.linear_torque, self.torque / self.corrected_torque)
        return (
            f"| {self.strain:.1%} | {self.overspeed:.4f} | {self.stretch:.4f} | {ratios[0]:.3f} | {ratios[1]:.3f} | "
            f"{self.stated_error:.3f} |"
        )


def row_of(strain, torque, stretch, body, load, edge, nodes):
    """Return a row with the results of linear theory at the same load."""
    names = ("resisting_torque", "finite_strain_torque", "overspeed", "finite_strain_torque_error")
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", vr.ResultWarning)
        linear = table.low_speed_results(body, load, edge, names, nodes=nodes)
    return Row(strain, torque, stretch, *map(float, linear))


def ball_rows(geometry, strains, nodes=100, **sizes):
    """Yield the rows of a ball of given core radius, outer radius [mm] and Poisson's ratio."""
    for coating, state, strain, load in table.press_to(geometry, strains, **sizes):
        torque = float(slow_torques(coating, state, load)["newton"])
        body = table.ball(geometry, table.RUBBER)
        yield row_of(strain, torque, coating.stretch(state), body, load, coating.edge, nodes)


def wheel_rows(core_radius, thickness, width, strains, nodes=40, **sizes):
    """Yield the rows of a wheel with free faces; lengths are in mm."""
    for strain in strains:
        tread, load = press_tread(core_radius, core_radius + thickness, width, strain * thickness, **sizes)
        stretch, edge = tread.stretch()
        layer = vr.Layer(thickness=1e-3 * thickness, shear_modulus=table.RUBBER, poisson_ratio=0.5)
        body = vr.CoatedWheel(core_radius=1e-3 * core_radius, layers=[layer], width=1e-3 * width)
        yield row_of(strain, tread.slow_torque(load), stretch, body, load, edge, nodes)


def report(title, rows):
    """Print a table of rows."""
    print(f"\n{title}\n| strain | c, linear | c | T / T_lin | T / rule | error |\n" + "|---" * 6 + "|", flush=True)
    for row in rows:
        print(row, flush=True)


def main():
    """Run the command."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("bodies", choices=("balls", "wheels"))
    if parser.parse_args().bodies == "wheels":
        for core_radius, thickness, width, strains in TREADS:
            title = f"r_i = {core_radius:g} mm, h = {thickness:g} mm, width {width:g} mm"
            report(title, wheel_rows(core_radius, thickness, width, strains))
        return
    for geometry in table.GEOMETRIES:
        core_radius, outer_radius, poisson_ratio = geometry
        strains = table.THIN_STRAINS if core_radius == 20.75 else table.STRAINS
        report(
            f"r_i = {core_radius:g} mm, r_o = {outer_radius:g} mm, nu = {poisson_ratio:g}", ball_rows(geometry, strains)
        )


if __name__ == "__main__":
    main()
