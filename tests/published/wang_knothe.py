"""Two viscoelastic rollers with traction: G. Wang and K. Knothe, J. Appl. Mech. 60 (1993) 310-317.

Both rollers are of PA6, as in the example `visc_cylindr` of CONTACT (revision d431cdb, user guide, section 5.4), which
models half-planes of a standard linear solid. Its elements have 0.16 mm, and 80 of them cover the widest contact.
"""

from __future__ import annotations

import math

import viscoroll as vr

RADIUS = 0.1  # each roller [m]
LOAD = 600e3  # [N/m]
FRICTION, SHARE = 0.3, 0.6  # traction / (friction * load)
SPEED = 1.0  # [m/s]
INSTANTANEOUS, RELAXED, POISSON_RATIO = 1143e6, 571.5e6, 0.4
ELEMENT = 0.16e-3  # size in the source [m]

#: Creep times [s].
CREEP_TIMES = {
    "creep time 0 (relaxed throughout)": 0.0,
    "creep time 9 ms": 9e-3,
    "creep time 45 ms": 45e-3,
    "creep time 2 s": 2.0,
    "infinite creep time (instantaneous modulus)": None,
}


def modulus(creep_time: float | None):
    """Return PA6 by its creep time [s]: 0 is fully relaxed, None is instantaneous."""
    if not creep_time:
        return vr.Elastic(modulus=INSTANTANEOUS if creep_time is None else RELAXED)
    time = creep_time * RELAXED / INSTANTANEOUS  # the relaxation time is shorter than the creep time
    return vr.StandardLinearSolid(instantaneous_modulus=INSTANTANEOUS, relaxed_modulus=RELAXED, relaxation_time=time)


def roll(creep_time: float | None, *, scale: float = 100.0, refinement: float = 1.0) -> tuple[float, float]:
    """Return creepage [-] and largest pressure [Pa], converted to the printed size.

    Radii are `scale` times as large under loads smaller by the same factor: the contact width is the same, pressure and
    creepage decrease equally, and the bodies are nearly half-planes. At the printed size, a/R is 0.063.
    """
    radius = RADIUS * scale
    # at least a hundred contact widths
    thickness = min(0.98 * radius, 2.0)
    layer = vr.Layer(thickness=thickness, shear_modulus=modulus(creep_time), poisson_ratio=POISSON_RATIO)
    roller = vr.CoatedCylinder(core_radius=radius - thickness, layers=[layer])
    mesh = vr.Mesh(nodes_per_revolution=round(2.0 * math.pi * radius / ELEMENT * refinement))
    load = LOAD / scale
    drive = vr.Drive(force=SHARE * FRICTION * load)
    r = vr.solve(roller, on=roller, load=load, angular_speed=SPEED / radius, friction=FRICTION, drive=drive, mesh=mesh)
    return r.creepage * scale, r.max_pressure * scale


def carter(shear_modulus: float) -> tuple[float, float]:
    """Return creepage and largest pressure of elastic rollers, F. W. Carter (1926) and Hertz."""
    relative = 0.5 * RADIUS
    half_width = math.sqrt(4.0 * relative * LOAD * (1.0 - POISSON_RATIO) / (math.pi * shear_modulus))
    creepage = FRICTION * half_width / relative * (1.0 - math.sqrt(1.0 - SHARE))
    return creepage, 2.0 * LOAD / (math.pi * half_width)
