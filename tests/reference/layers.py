"""Sections 7 and 8: from complex moduli to the surface compliance of single orders (m, n).

The functions are in the package, which draws figure 4 with them.
"""

from __future__ import annotations

from viscoroll.reproduce.plain import (
    Layer,
    extrapolated_compliance,
    product_compliance,
    prony,
    sub_intervals,
    surface_compliance,
    system_matrix,
)

__all__ = [
    "Layer",
    "extrapolated_compliance",
    "product_compliance",
    "prony",
    "sub_intervals",
    "surface_compliance",
    "system_matrix",
]
