"""Torque of rollers at finite strain against linear theory: `python -m tests.campaign.finite_strain --set table`.

For every case, the command solves ladders of strains by finite elements, and linear theory at the same loads. It
prints the ratio of the torques, T_FE / T_lin, and the ratio to the corrected linear torque

    (1 + c) T_lin(P, (1 + c) Ω),    c = [u_x(leading end) - u_x(trailing end)] / (contact length).

The core radius is 1 m, the relaxed modulus 1 Pa and τ = 1 s. `--set` selects cases: "table" are those of
docs/finite-strain.md, "beyond" other thicknesses, a modulus ratio of 5 and a weak rubber with two terms, and "elastic"
other elastic laws. Each ladder takes 5 to 15 s on one core. `--csv FILE` appends the rows to a file.
"""

from __future__ import annotations

import argparse
import csv
import sys
import time
import warnings
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import viscoroll as vr

#: Strains of each ladder. Small contacts have a mesh of their own, because a mesh for 25 % has few nodes there.
LADDERS = ((0.01,), (0.03,), (0.06, 0.10), (0.15, 0.20, 0.25))

#: Ωτ of slow rolling, of the largest torque and of fast rolling for each thickness per core radius.
SPEEDS = {
    0.05: {"low": 0.004, "max": 0.04, "high": 0.4},
    0.12: {"low": 0.006, "max": 0.06, "high": 0.6},
    0.25: {"low": 0.008, "max": 0.09, "high": 0.9},
    1.0: {"low": 0.012, "max": 0.15, "high": 1.5},
}
#: Ωτ₁ of the weak rubber.
WEAK_SPEEDS = {
    0.05: {"low": 0.001, "max": 0.012},
    0.12: {"low": 0.0012, "max": 0.018},
    0.25: {"low": 0.0015, "max": 0.025},
    1.0: {"low": 0.002, "max": 0.04},
}


@dataclass(frozen=True)
class Case:
    """Thickness per core radius, rubber ("sls", "ratio 5" or "weak"), name and value of Ωτ, and laws."""

    thickness: float
    rubber: str
    speed_name: str
    speed: float
    law: str
    elasticity: vr.finite_strain.Elasticity | None = None

    @property
    def roller(self):
        """Roller of the case."""
        if self.rubber == "weak":
            modulus = vr.Prony(instantaneous_modulus=1.25, weights=[0.1, 0.1], relaxation_times=[1.0, 10.0])
        else:
            ratio = 5.0 if self.rubber == "ratio 5" else 2.0
            modulus = vr.StandardLinearSolid(instantaneous_modulus=ratio, relaxed_modulus=1.0, relaxation_time=1.0)
        layer = vr.Layer(thickness=self.thickness, shear_modulus=modulus, poisson_ratio=0.5)
        return vr.CoatedCylinder(core_radius=1.0, layers=[layer])

    def __str__(self):
        """Return the case in words."""
        elastic = f", {self.elasticity}" if self.elasticity else ""
        return f"h/R_c = {self.thickness:g}, {self.rubber} {self.speed_name}, {self.law}{elastic}"


def cases(name):
    """Return the cases of a set."""
    laws = ("newton", "simo", "abaqus")
    if name == "elastic":
        elasticities = (vr.finite_strain.MooneyRivlin(fraction=0.3), vr.finite_strain.Yeoh(coefficient=0.05))
        return [Case(0.25, "sls", s, SPEEDS[0.25][s], "simo", e) for e in elasticities for s in ("low", "max")]
    if name == "table":
        chosen = [(h, "sls", s) for h in (0.25, 0.05) for s in ("low", "max")]
        found = [Case(h, rubber, s, SPEEDS[h][s], law) for h, rubber, s in chosen for law in laws]
        return found + [Case(h, "sls", "high", SPEEDS[h]["high"], "simo") for h in (0.25, 0.05)]
    found = [Case(h, "sls", s, SPEEDS[h][s], law) for h in (1.0, 0.12) for s in ("low", "max") for law in laws]
    found += [Case(h, "sls", "high", SPEEDS[h]["high"], "newton") for h in (1.0, 0.12, 0.25, 0.05)]
    found += [Case(h, "weak", s, WEAK_SPEEDS[h][s], "newton") for h in (0.25, 0.05, 1.0, 0.12) for s in ("low", "max")]
    found += [Case(h, "ratio 5", s, SPEEDS[h][s], "newton") for h in (0.25, 1.0, 0.05) for s in ("low", "max")]
    return found


def overspeed(result):
    """Return c of linear theory, from the displacements at the ends of the contact at a depth of 1e-3 h."""
    radius, thickness = result.body.outer_radius, result.body.thickness
    x = np.ravel(result.x)
    touching = x[np.ravel(result.contact)]
    half = 0.5 * radius * result.mesh.spacing
    ends = np.array([touching.max() + half, touching.min() - half]) / radius
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", vr.ResultWarning)
        inside = result.interior(depth=[1e-3 * thickness], phi=0.5 * np.pi - ends, theta=[0.5 * np.pi])
    radial, backward = (inside.displacement.sel(direction=name).to_numpy().ravel() for name in ("r", "phi"))
    forward = radial * np.sin(ends) - backward * np.cos(ends)
    return float(forward[0] - forward[1]) / (radius * (ends[0] - ends[1]))


def linear(roller, load, angular_speed):
    """Return the solution of linear theory."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", vr.ResultWarning)
        return vr.solve(roller, load=load, angular_speed=angular_speed, accuracy=0.003)


def rows_of(case, strains, *, across, through):
    """Return one row for each strain of a ladder."""
    roller = case.roller
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", vr.ResultWarning)
        found = vr.finite_strain.ladder(
            roller,
            penetrations=[strain * case.thickness for strain in strains],
            angular_speed=case.speed,
            law=case.law,
            elasticity=case.elasticity,
            elements_across=across,
            elements_through=through,
        )
    rows = []
    for strain, result in zip(strains, found, strict=True):
        first = linear(roller, result.load, case.speed)
        c = overspeed(first)
        second = linear(roller, result.load, (1.0 + c) * case.speed)
        corrected = (1.0 + c) * second.resisting_torque
        rows.append(
            {
                "h/R_c": case.thickness,
                "rubber": case.rubber,
                "speed": case.speed_name,
                "law": case.law,
                "elasticity": str(case.elasticity or ""),
                "strain": strain,
                "load": result.load,
                "torque": result.resisting_torque,
                "balance": result.power_balance_error,
                "overspeed": result.overspeed,
                "linear torque": first.resisting_torque,
                "linear overspeed": c,
                "raw ratio": result.resisting_torque / first.resisting_torque,
                "corrected ratio": result.resisting_torque / corrected,
                "penetration ratio": result.penetration / first.penetration,
                "length ratio": result.contact_length / first.contact_length,
                "pressure ratio": result.max_pressure / first.max_pressure,
            }
        )
    return rows


def report(case, rows, seconds):
    """Print the rows of a case."""
    print(f"{case}  ({seconds:.0f} s, power balance {max(row['balance'] for row in rows):.1%})")
    for name in ("raw ratio", "corrected ratio", "overspeed", "linear overspeed"):
        print(f"  {name:17}", *(f"{row[name]:7.3f}" for row in rows), flush=True)


def summary(rows):
    """Print the root-mean-square errors and the ranges by strain."""
    print(f"{'strain':>8}{'raw rms':>10}{'corrected rms':>15}{'corrected range':>18}")
    for strain in sorted({row["strain"] for row in rows}):
        some = [row for row in rows if row["strain"] == strain]
        raw, corrected = (np.array([row[name] for row in some]) for name in ("raw ratio", "corrected ratio"))
        rms = [float(np.sqrt(np.mean((ratio - 1.0) ** 2))) for ratio in (raw, corrected)]
        print(f"{strain:8.2f}{rms[0]:10.1%}{rms[1]:15.1%}{corrected.min():10.3f} - {corrected.max():.3f}")


def draw(source, target):
    """Draw the ratios of torques of a CSV file against strain."""
    from matplotlib.figure import Figure

    with source.open(encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    picture = Figure(figsize=(10.0, 4.2), layout="constrained")
    both = picture.subplots(1, 2, sharey=True)
    colors = {"low": "tab:blue", "max": "tab:red", "high": "tab:green"}
    styles = {"newton": "-", "simo": "--", "abaqus": ":"}
    titles = {"raw ratio": "linear theory", "corrected ratio": "with overspeed"}
    lines = {tuple(row[name] for name in ("h/R_c", "rubber", "speed", "law")) for row in rows}
    for axes, (column, title) in zip(both, titles.items(), strict=True):
        for line in sorted(lines):
            some = [row for row in rows if (row["h/R_c"], row["rubber"], row["speed"], row["law"]) == line]
            x, y = ([float(row[name]) for row in some] for name in ("strain", column))
            axes.plot(x, y, color=colors[line[2]], linestyle=styles[line[3]], linewidth=1)
        axes.axhline(1.0, color="black", linewidth=0.8)
        axes.set(xlabel="strain, penetration / thickness", title=title)
    both[0].set_ylabel("torque by finite elements / by theory")
    picture.savefig(target)


def main():
    """Run the command."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--set", choices=("table", "beyond", "elastic"), default="table")
    parser.add_argument("--across", type=int, default=40, help="elements across the largest contact")
    parser.add_argument("--through", type=int, default=6, help="elements through the cover")
    parser.add_argument("--csv", type=Path, help="file to which the rows are appended")
    parser.add_argument("--picture", type=Path, help="draw the rows of the CSV file to this picture, and solve nothing")
    given = parser.parse_args()
    if given.picture is not None:
        if given.csv is None:
            parser.error("--picture needs --csv")
        draw(given.csv, given.picture)
        return 0
    rows = []
    for case in cases(given.set):
        start = time.perf_counter()
        found = [
            row for strains in LADDERS for row in rows_of(case, strains, across=given.across, through=given.through)
        ]
        report(case, found, time.perf_counter() - start)
        rows += found
        if given.csv is not None:
            header = not given.csv.exists()
            with given.csv.open("a", newline="", encoding="utf-8") as file:
                writer = csv.DictWriter(file, list(found[0]))
                if header:
                    writer.writeheader()
                writer.writerows(
                    {name: f"{value:.5g}" if isinstance(value, float) else value for name, value in row.items()}
                    for row in found
                )
    summary(rows)
    return 0


if __name__ == "__main__":
    sys.exit(main())
