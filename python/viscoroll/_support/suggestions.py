"""Suggestions for unknown names of parameters in files and sweeps."""

from __future__ import annotations

from collections.abc import Collection
from difflib import get_close_matches

__all__ = ["suggestion"]

_SHEAR = "E / (2 (1 + nu))"
_YOUNG = "E Y youngs_modulus young_modulus elastic_modulus"

#: Names that users try, in upper or lower case; the correct name of the parameter; its formula if the value differs.
_SYNONYMS = (
    ("h t height", "thickness", ""),
    (f"{_YOUNG} tensile_modulus", "shear_modulus", _SHEAR),
    (f"{_YOUNG} tensile_modulus", "modulus", _SHEAR),
    ("E0 E_0", "instantaneous_modulus", "E0 / (2 (1 + nu))"),
    ("E_inf", "relaxed_modulus", "E_inf / (2 (1 + nu))"),
    ("G mu modulus material", "shear_modulus", ""),
    ("G mu shear_modulus", "modulus", ""),
    ("G0 G_0 mu0 mu_0 glassy_modulus", "instantaneous_modulus", ""),
    ("G_inf mu_inf rubbery_modulus equilibrium_modulus long_term_modulus", "relaxed_modulus", ""),
    ("nu poisson poissons_ratio", "poisson_ratio", ""),
    ("K", "bulk_modulus", ""),
    ("rho", "density", ""),
    ("eta", "viscosity", ""),
    ("tau", "relaxation_time", ""),
    ("tau taus", "relaxation_times", ""),
    ("tan_delta tandelta", "loss_factor", ""),
    ("hardness shore durometer", "shear_modulus", "hardness_to_modulus(...).value"),
    ("rebound resilience", "loss_factor", "rebound_to_loss_factor(...).value"),
    ("R radius r_o outer_radius", "core_radius", "outer radius - thickness of the layers"),
    ("D diameter", "outer_diameter", ""),
    ("D diameter", "core_radius", "diameter / 2 - thickness of the layers"),
    ("layer coating coatings tread tire tyre cover", "layers", ""),
    ("thickness h t shear_modulus E G poisson_ratio nu", "layers", "[Layer(...)]"),
    ("hub_radius", "core_radius", ""),
    ("w b breadth", "width", ""),
    ("R_c crown crowning", "crown_radius", ""),
    ("P F W force normal_force normal_load weight", "load", ""),
    ("mass", "load", "9.81 mass"),
    ("d depth indentation approach overlap deflection", "penetration", ""),
    ("V v velocity linear_speed belt_speed line_speed", "speed", ""),
    ("V v speed velocity linear_speed belt_speed line_speed", "angular_speed", "V / r_o"),
    ("omega w angular_velocity", "angular_speed", ""),
    ("rpm", "angular_speed", "2 pi rpm / 60"),
    ("V v speed velocity", "distance", "V time"),
    ("displacement path", "distance", ""),
    ("mu friction_coefficient coefficient_of_friction", "friction", ""),
    (
        "torque creepage driving_force driving_torque",
        "drive",
        "Drive(force=...), Drive(torque=...) or Drive(creepage=...)",
    ),
    ("plane belt ground groove counterbody counterface", "on", ""),
    ("belt ground floor mat", "plane", ""),
    ("ball2 ball_2 second_ball", "other_ball", ""),
    ("sphere bead particle", "ball", ""),
    ("roller roll idler drum", "cylinder", ""),
    ("caster castor tire tyre rim", "wheel", ""),
    ("dish bowl track", "groove", ""),
    ("tol rtol tolerance", "accuracy", ""),
    ("n nodes", "nodes_per_revolution", ""),
)


def suggestion(name: str, known: Collection[str]) -> str:
    """Return a suggestion for an unknown name, as code, or an empty text.

    Parameters
    ----------
    name : str
        The unknown name.
    known : collection of str
        The valid names.

    Examples
    --------
    >>> suggestion("speed", ["load", "angular_speed"]), suggestion("laod", ["load", "angular_speed"])
    ('angular_speed = V / r_o', 'load')
    """
    for names, parameter, formula in _SYNONYMS:
        if parameter in known and name.lower() in names.lower().split():
            return f"{parameter} = {formula}" if formula else parameter
    return " or ".join(get_close_matches(name.lower(), sorted(known), 2))
