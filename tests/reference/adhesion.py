"""Rolling and static contacts with adhesion in plain NumPy, beside closed forms: python -m tests.reference.adhesion.

Lengths are in mm, loads per length in N/mm, moduli in MPa and works in N/mm, so that moments per length are in N. A
row states its reference, the value found, and the largest difference that the row allows. "Length" is the cohesive
length E* w / σ₀² of the law.

Moments from Σ ξ p have errors because the contact ends at nodes; those by the power balance have not.
"""

from __future__ import annotations

import sys

import numpy as np

from .adhesive_contact import Contact, Law, NoStateError, cells, press, ring_influence, solve, strip_influence
from .adhesive_edges import ELASTIC_ZONE, Creep, edge, edge_factors, edge_laws

__all__ = ["Roller", "ball_at_rest"]


class Roller:
    """Rigid roller on a half-plane with discrete retardation times; one time is a standard linear solid.

    Parameters
    ----------
    radius, work : float
        R and w.
    creep : Creep
        Creep compliance 1/E*, with retardation lengths V λⱼ in place of times.
    """

    def __init__(self, *, radius=10.0, work=1e-2, creep):
        self.radius, self.work, self.creep = radius, work, creep

    @classmethod
    def standard(cls, length, *, modulus=4.0, ratio=2.0, **keywords):
        """Return a roller on a standard linear solid of relaxed E*, E₀*/E*, and l = V τ."""
        relaxed = 1.0 / modulus
        delayed = [(relaxed - relaxed / ratio, ratio * length)] if ratio > 1.0 else []
        return cls(creep=Creep(relaxed / ratio, delayed), **keywords)

    def strength(self, cohesive_length):
        """Return the strength with the cohesive length E* w / σ₀²."""
        return np.sqrt(self.work / self.creep.relaxed / cohesive_length)

    def jkr_half_width(self, load):
        """Return the half-width of JKR with the relaxed modulus."""
        modulus = 1.0 / self.creep.relaxed
        low, high = (2.0 * self.work * self.radius**2 / (np.pi * modulus)) ** (1 / 3), 1e3 * self.radius
        for _ in range(100):
            a = 0.5 * (low + high)
            balance = 0.25 * np.pi * modulus * a**2 / self.radius - np.sqrt(2.0 * np.pi * modulus * a * self.work)
            low, high = (a, high) if balance < load else (low, a)
        return low

    def mesh(self, spacing, reach):
        """Return an unloaded contact on cells between -reach and reach."""
        x = cells(-reach, reach, spacing)
        offsets = x[:, np.newaxis] - x[np.newaxis, :]
        influence = strip_influence(offsets, spacing, self.creep.instantaneous, self.creep.delayed)
        return Contact(x, np.full(x.size, spacing), influence, x**2 / (2.0 * self.radius), np.zeros(x.size), 0.0)

    def without_adhesion(self, load, spacing):
        """Return the contact at w = 0."""
        a = np.sqrt(4.0 * load * self.radius * self.creep.relaxed / np.pi)
        return press(self.mesh(spacing, 1.6 * a), load, 0.8 * a)

    def plain(self, load, cohesive_length, nodes, reach=None):
        """Solve with one law, halving the cohesive length from the half-width on; `nodes` is its length per spacing."""
        a = self.jkr_half_width(load)
        contact = self.mesh(cohesive_length / nodes, reach or 1.35 * a + 2.0 * cohesive_length)
        press(contact, load + np.sqrt(2.0 * np.pi / self.creep.relaxed * a * self.work), 0.8 * a)
        current = max(a, cohesive_length)
        while True:
            solve(contact, Law(self.strength(current), self.work), load=load)
            if current <= cohesive_length:
                return contact
            current = max(0.5 * current, cohesive_length)

    def with_two_laws(self, load, zone, nodes, actual=0.0):
        """Solve with a law for each edge; `nodes` is the length of the zones per spacing.

        The edges have an `actual` cohesive length. Return the contact and its moment by the power balance.
        """
        # The plain contact is smaller than the one with two laws.
        reach = 2.0 * self.jkr_half_width(load) + 2.0 * zone
        contact = self.plain(load, zone / ELASTIC_ZONE, nodes / ELASTIC_ZONE, reach)
        strength = self.strength(actual) if actual else np.inf
        for _ in range(3):  # the size of the contact, on which the laws depend
            touched = contact.x[contact.touching]
            middle = touched.mean()
            half_width = contact.half_width + EFFECTIVE_EDGE * zone
            center = contact.pressure[np.argmin(np.abs(contact.x - middle))]
            opening, closing = edge_laws(self.creep, self.work, strength, zone, 1.0, half_width, center)
            law = Law(*np.where(contact.x < middle, np.array(closing)[:, np.newaxis], np.array(opening)[:, np.newaxis]))
            solve(contact, law, load=load)
        return contact, self.moment_by_power(contact, opening[1] - closing[1])

    def moment_by_power(self, contact, excess=0.0):
        """Return M = R (∫ p u' dξ + w_open - w_close)."""
        spacing = contact.x[1] - contact.x[0]
        offsets = contact.x[:, np.newaxis] - contact.x[np.newaxis, :]
        ends = [
            strip_influence(offsets + side, spacing, self.creep.instantaneous, self.creep.delayed)
            for side in (0.5 * spacing, -0.5 * spacing)
        ]
        return self.radius * (float(contact.pressure @ (ends[0] - ends[1]) @ contact.pressure) + excess)

    def pull_off(self, cohesive_length, nodes, load=0.0):
        """Return the smallest load, by reducing the approach from a state at `load`."""
        contact = self.plain(load, cohesive_length, nodes)
        law = Law(self.strength(cohesive_length), self.work)
        return smallest_load(contact, law, 0.02 * self.jkr_half_width(load) ** 2 / self.radius)


def smallest_load(contact, law, step):
    """Reduce the approach until the load increases, and return the smallest load; a step without a state is halved."""
    least, shortest = contact.load, 1e-3 * step
    while step > shortest:
        try:
            solve(contact, law, approach=contact.approach - step)
        except NoStateError:
            step *= 0.5
            continue
        if contact.load > least:
            break
        least = contact.load
    return least


def ball_at_rest(parameter, load, *, spacing=0.02, pulled=False):
    """Return radius and approach of a ball on an elastic half-space, and its smallest load if it is then `pulled` off.

    Radii, loads and approaches have Maugis's units; the strength of the cubic law has the given Maugis parameter.
    """
    modulus, work, strength = 0.75, 1.0 / np.pi, 0.5 * parameter
    outer = 1.3 * np.sqrt(2.0 * 3.0 * work / strength) + 2.2
    fine = np.arange(0.0, min(outer, 2.6), spacing)
    coarse = fine[-1] + np.cumsum(np.full(400, spacing) * 1.02 ** np.arange(400))
    edges = np.concatenate([fine, coarse[: 1 + np.searchsorted(coarse, outer)]])
    radii, areas = 0.5 * (edges[1:] + edges[:-1]), np.pi * np.diff(edges**2)
    contact = Contact(radii, areas, ring_influence(radii, edges, modulus), 0.5 * radii**2, np.zeros(radii.size), 0.0)
    press(contact, max(load, 0.0) + 2.0, 1.0)
    current = 0.2
    while True:
        current = min(current, strength)
        solve(contact, Law(current, work), load=load)
        if current == strength:
            break
        current *= 1.3
    radius, approach = edges[1:][contact.touching][-1], contact.approach
    return radius, approach, smallest_load(contact, Law(strength, work), 0.02) if pulled else None


#: Error of Σ ξ p of a contact that ends at nodes, where it is 1 % of the moment of either edge.
STAIRCASE = 0.2

#: Distance from the contact to the edge without a zone that has the same pressure far away, relative to the zone.
EFFECTIVE_EDGE = 0.276

#: Largest errors of the moment with zones of these lengths, relative to the half-width.
BARS = {0.7: 0.06, 0.35: 0.012, 0.18: 0.005}

#: Moments of the adhesive closed form at l = 0.2, 1, 5, 20 for R = 10, E* = 4, w = 0.01 and P = 0.2.
CLOSED_FORM = {0.2: 0.1715270, 1.0: 0.1020172, 5.0: 0.0266126, 20.0: 0.00777120}


def _rows_of_edges():
    """Compare with the solver's edges, which are polynomials (tests/cpp/test_edge_works.cpp), and with limits."""
    for regular in (0.0, 0.3, 3.0):
        for opens in (True, False):
            work, intensity = edge(Creep(1.0, []), 1.0, opens=opens, regular=regular)
            name = "opening" if opens else "closing"
            yield f"G/w, elastic, {name}, B l/K = {regular:g}", 1.0, 0.5 * intensity**2 / work, 2e-4
    rows = {
        (2.0, 10.0, 0.0): (1.265277, 0.776878),
        (10.0, 1.0, 0.5): (8.200416, 0.120663),
        (70.0, 100.0, 0.0): (3.347200, 0.253336),
        (70.0, 10.0, 2.0): (19.52837, 0.0477686),
    }
    for (ratio, time, regular), references in rows.items():
        creep = Creep(1.0 / ratio, [(1.0 - 1.0 / ratio, ratio)])
        for opens, reference in zip((True, False), references, strict=True):
            work, intensity = edge(creep, time, opens=opens, regular=regular)
            name = f"G_{'open' if opens else 'close'}/w, f = {ratio:g}, {time:g} τ, B l/K = {regular:g}"
            yield name, reference, 0.5 * intensity**2 / work, 5e-4
    # Complete contacts with one law and a cohesive length of a tenth of the half-width.
    contacts = {0.03: (1.048, 0.958), 0.1: (1.146, 0.877), 0.3: (1.342, 0.753), 1.0: (1.591, 0.656)}
    for length, references in contacts.items():
        roller = Roller.standard(length)
        factors = edge_factors(roller.creep, 1e-2, roller.strength(1.0), 1.0)
        for name, reference, factor in zip(("open", "close"), references, factors, strict=True):
            yield f"G_{name}/w of a contact, f = 2, l/length = {length:g}", reference, factor, 5e-2


def _rows_at_rest():
    roller = Roller.standard(1.0, ratio=1.0)
    a = roller.jkr_half_width(0.2)
    exact = np.pi * 4.0 / 20.0 * a**4 / 8.0 - np.sqrt(2.0 * np.pi * 4.0 * a * 1e-2) * a**2 / 2.0
    for fraction, excess in ((0.2, 0.014), (0.1, 0.003)):
        found = roller.plain(0.2, fraction * a, 8).second_moment()
        yield f"JKR line, second moment of p, length/a = {fraction:g}", exact * (1.0 + excess), found, 6e-3
    yield "JKR line, pull-off, length = 0.1", -0.27679, roller.pull_off(0.1, 8), 3e-3
    contact = roller.plain(0.2, 0.1, 6)
    middle = contact.x[contact.touching].mean()
    for works in (1.5, 1.1):
        solve(contact, Law(roller.strength(0.1), np.where(contact.x < middle, 1e-2, works * 1e-2)), load=0.2)
        yield f"elastic moment, w_open = {works:g} w_close", 0.1 * (works - 1.0), contact.moment, 3e-2
    # A cubic law of 1.35 times the strength acts as Dugdale's law at rest.
    for parameter, load, radius, approach in (
        (1.0, 0.0, 1.6361, 1.12989),
        (1.0, 1.0, 1.8093, 1.67586),
        (0.5, 0.0, 1.5174, 1.16513),
        (0.1, 0.0, 1.3362, 1.29243),
    ):
        found = ball_at_rest(1.35 * parameter, load)
        yield f"Maugis-Dugdale ball, λ = {parameter:g}, P = {load:g}, radius", radius, found[0], 3e-2
        yield f"Maugis-Dugdale ball, λ = {parameter:g}, P = {load:g}, approach", approach, found[1], 3e-3


def _rows_in_rolling():
    for length, moment in ((0.2, 0.025749), (1.0, 0.026105), (5.0, 0.010317)):
        found = Roller.standard(length).without_adhesion(0.2, 0.01).moment
        yield f"roller without adhesion, l = {length:g}", moment, found, 1e-3
    for length, plain in ((0.2, -0.19), (1.0, -0.072), (5.0, -0.05), (20.0, -0.039)):
        roller = Roller.standard(length)
        contact = roller.plain(0.2, 0.1, 8)
        yield f"plain law, length = 0.1, l = {length:g}", CLOSED_FORM[length] * (1.0 + plain), contact.moment, 1e-2
        yield f"its moment by power, l = {length:g}", contact.moment, roller.moment_by_power(contact), 1e-2
    for length, moment in CLOSED_FORM.items():
        roller = Roller.standard(length)
        # The error of edges that act through two terms of the pressure is of the second order in their zones.
        for fraction, nodes in ((0.7, 12.5), (0.35, 12.5), (0.18, 12.5), (0.18, 25)):
            contact, by_power = roller.with_two_laws(0.2, fraction * roller.jkr_half_width(0.2), nodes)
            what = f"two laws, zones of {fraction:g} a, {nodes:g} nodes, l = {length:g}"
            yield what, moment, by_power, BARS[fraction]
            yield what + ", sum of moments", by_power, contact.moment, STAIRCASE
    creep = Creep(0.125, [(0.0625, 1.0), (0.0625, 20.0)])
    roller = Roller(creep=creep)
    resolved = roller.plain(0.2, 0.05, 6)
    contact, by_power = roller.with_two_laws(0.2, 0.25, 12.5, actual=0.05)
    yield "two relaxation times: edges resolved against two laws", resolved.moment, by_power, 0.02


def _rows_of_the_test_table():
    moments = {
        (5.0, 500.0): 1.037976,
        (5.0, 50.0): 4.295487,
        (5.0, 5.0): 2.637373,
        (0.1, 500.0): 0.001228,
        (0.1, 50.0): 0.009818,
        (0.1, 5.0): 0.064708,
    }
    for (load, speed), moment in moments.items():
        roller = Roller.standard(0.125 * speed, modulus=12.0, radius=50.0, work=1e-3)
        half_width = {5.0: 4.0, 0.1: 1.18}[load]
        contact, by_power = roller.with_two_laws(load, 0.18 * half_width, 12.5)
        yield f"roller, {load:g} N/mm, {speed:g} mm/s", moment, by_power, 0.01
        yield f"roller, {load:g} N/mm, {speed:g} mm/s, sum of moments", by_power, contact.moment, STAIRCASE


GROUPS = {
    "edges": _rows_of_edges,
    "rest": _rows_at_rest,
    "rolling": _rows_in_rolling,
    "table": _rows_of_the_test_table,
}


def main(groups):
    """Print the rows of some groups, and return how many miss their reference."""
    missed = 0
    for group in groups or GROUPS:
        for what, reference, found, bar in GROUPS[group]():
            error = found / reference - 1.0
            missed += abs(error) > bar
            verdict = "" if abs(error) <= bar else "  MISSED"
            print(f"{what:60s} {reference:12.6g} {found:12.6g} {error:+9.1e} (at most {bar:g}){verdict}", flush=True)
    return missed


if __name__ == "__main__":
    sys.exit(1 if main(sys.argv[1:]) else 0)
