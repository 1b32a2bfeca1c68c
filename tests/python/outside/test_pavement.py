"""Layered planes with ν < ½ under a disc: ELLEA1 at rest, ELLVA on the move."""

from __future__ import annotations

from outside import pavement as source

PLACES = (-2.0, -1.0, -0.5, 0.0, 0.5, 1.0, 2.0)  # of the disc, past the point [m]
STEP = 0.05  # of their load along its path [m]


def name_of(place: float) -> str:
    return f"{abs(place):g} m {'past' if place > 0.0 else 'before'}" if place else "beside the point"


def test_disc_at_rest(judge):
    # Their four digits, and 1.6e-4 of the deflection at the surface.
    found = {}
    for depth in (0, 50, 100, 200, 500, 1000):
        deflection, vertical, level = source.at_rest(1e-3 * depth)
        found[f"deflection [mm], {depth} mm deep"] = 1e3 * deflection
        if depth:
            found[f"vertical pressure [MPa], {depth} mm deep"] = 1e-6 * vertical
        if depth in (50, 100):
            found[f"level pressure [MPa], {depth} mm deep"] = 1e-6 * level
    judge(found)


def test_moving_disc(judge):
    # 75 000 waves of a modulus that Python evaluates: some seconds.
    found = zip(PLACES, source.moving(PLACES), strict=True)
    judge({f"deflection [mm], moving disc {name_of(place)}": 1e3 * deflection for place, deflection in found})


def test_moving_disc_summed_as_there(judge):
    # Moduli of the age of each load take up to 0.8 % off, and their load is half a step of its way behind: so both are
    # found with the library's compliance, and 0.2 % are left where the disc is near.
    found = zip(PLACES, source.moving_quasi_elastic([place - 0.5 * STEP for place in PLACES]), strict=True)
    judge({f"the same as they sum it, {name_of(place)}": 1e3 * deflection for place, deflection in found})
