"""Dissimilar elastic rollers with friction: Bentall and Johnson (1967), computed with CONTACT."""

from __future__ import annotations

import pytest
from published import bentall_johnson as source

FLAT = 25.0  # factor on the printed radii, so a/R is a fifth


def creepages(model, name, scale=1.0, **options):
    """Return all creepages [1e-4], converted to the printed size."""
    return {
        f"creepage [1e-4], {name}: {case}": 1e4 * scale**0.5 * source.roll(model, case, **options).creepage
        for case in source.CASES
    }


def test_flat_half_plane(judge):
    # Bentall and Johnson solve flat theory. The resolution of 200 nodes limits two cases: in one, all nodes slip, in
    # opposite directions at both ends; in the other, all stick, and the traction is unbounded at the leading edge. One
    # more node across changes them by 0.3 and 1.5 %.
    model = source.on_half_plane(scale=FLAT)
    judge(creepages(model, "flat half-plane", FLAT, slip_kinematics="flat"))


def test_sticking_share(judge):
    # One node of 200 is 0.005.
    model = source.on_half_plane(scale=FLAT)
    judge(
        {
            f"share that sticks, flat half-plane: {case}": source.sticking(
                source.roll(model, case, slip_kinematics="flat")
            )
            for case in source.CASES
            if case.startswith("μ = 0.05")
        }
    )


def test_largest_pressure(judge):
    # If everything sticks, traction raises the pressure in the middle by 0.7 %.
    model = source.on_half_plane(scale=FLAT)
    found = {case: source.roll(model, case, slip_kinematics="flat").max_pressure for case in source.CASES}
    judge({f"largest pressure [MPa], flat half-plane: {case}": 1e-6 * FLAT**0.5 * p for case, p in found.items()})


def test_half_plane_at_the_printed_size(judge):
    judge(creepages(source.on_half_plane(), "half-plane, printed size"))


def test_two_solid_rollers(judge):
    judge(creepages(source.on_each_other(), "two solid rollers"))


@pytest.mark.parametrize("case", ["μ = 0.05, no force", "μ = 0.05, force ¾ μP, aluminum braked"])
def test_deviation_from_flat_theory_is_curvature(case):
    # The deviation of the creepage is proportional to a/R: rollers four times as large halve it. The arc of a rigid
    # roller exceeds its chord by about (a/R)²; the layers of a solid roller are curved as well.
    flat = 5.0 * source.roll(source.on_half_plane(scale=25.0), case, slip_kinematics="flat").creepage
    for pose in (source.on_half_plane, source.on_each_other):
        near, far = (scale**0.5 * source.roll(pose(scale=scale), case).creepage - flat for scale in (1.0, 4.0))
        assert far == pytest.approx(0.5 * near, rel=0.15)


def test_creepage_of_free_rolling_agrees_with_the_closed_form():
    # 0.457 κ a/R with κ = 2β = 0.2877, as the user guide evaluates it; 600 nodes have an error of 0.1 %.
    model = source.on_half_plane(scale=4.0, across=600)
    creepage = 2.0 * source.roll(model, "μ = 1e-4, no force", slip_kinematics="flat").creepage
    assert creepage == pytest.approx(0.457 * 0.2877 * source.HALF_WIDTH / (0.5 * source.RADIUS), rel=2e-3)
