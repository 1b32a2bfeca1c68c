"""Bodies whose materials relax no faster than the steps of a computation over time resolve."""

from __future__ import annotations

from dataclasses import replace
from typing import TypeVar

import numpy as np

from ..bodies import HalfSpace, Layer
from ..bodies.layered import LayeredBody, materials_of, with_materials
from ..materials import Prony
from ..materials.modulus_like import relaxation_of

__all__ = ["resolved"]

Body = TypeVar("Body", bound=LayeredBody)


def resolved(body: Body, shortest: float) -> Body:
    """Return a body in which no material relaxes in less than a given time.

    All faster relaxation, and the dashpot of a Kelvin-Voigt solid, becomes one term with this relaxation time and the
    same viscosity. The modulus is that of the material at frequencies far below the reciprocal of the time, and the
    material has an instantaneous compliance. Moduli that are not sums of exponentials are left as they are.

    Parameters
    ----------
    body : LayeredBody
        Rolling body or counterbody.
    shortest : float
        Shortest relaxation time [s], > 0.
    """
    return with_materials(body, [_resolved(material, shortest) for material in materials_of(body)])


def _resolved(material: Layer | HalfSpace, shortest: float) -> Layer | HalfSpace:
    relaxation = relaxation_of(material.shear_modulus)
    if relaxation is None:
        return material
    is_fast = relaxation.times < shortest
    viscosity = relaxation.viscosity + float(np.sum((relaxation.moduli * relaxation.times)[is_fast]))
    if viscosity == 0.0:
        return material
    *moduli, relaxed = relaxation.moduli[~is_fast]
    times = relaxation.times[~is_fast][:-1]
    series = Prony.from_moduli(
        relaxed_modulus=relaxed,
        moduli=[*moduli, viscosity / shortest],
        relaxation_times=[*times, shortest],
    )
    return replace(material, shear_modulus=series)
