"""Estimates from data sheets: shear modulus from hardness with its scatter, and loss factor from rebound."""

from __future__ import annotations

import math

from .._support.arguments import as_float
from .._support.errors import InvalidInput
from .._support.least_squares import Parameter
from .._support.text import shown

__all__ = ["hardness_to_modulus", "rebound_to_loss_factor"]

#: Smallest difference between instruments and between laboratories [Shore].
_REPRODUCIBILITY = 2.0

#: Rounding of the rebound in data sheets, which give it in whole percent.
_ROUNDED = 0.005

#: Offset of Qi's scale, on which Shore A and D coincide: S = S_A = S_D + 50.
_A_OF_D = 50.0

#: Young's modulus / shear modulus of an incompressible material.
_INCOMPRESSIBLE = 3.0


def hardness_to_modulus(hardness: float, *, scale: str = "A") -> Parameter:
    """Estimate the static shear modulus of a rubber from its Shore hardness.

    The estimate is rough: an indenter is not a rheometer, and the two relations in use differ by a factor of 1.2 to 2.
    For Shore A the value is the geometric mean of the relations of Gent and of Qi, and the interval contains both at ±2
    Shore. For Shore D only the relation of Qi is available, and the interval ranges from half to twice its value.

    Parameters
    ----------
    hardness : float
        Shore A in [20, 90], or Shore D in [30, 85].
    scale : {"A", "D"}, default "A"
        Shore scale, in upper or lower case.

    Returns
    -------
    Parameter
        Shear modulus [Pa] with its bounds, a third of Young's modulus. It is nearly the modulus at rest and contains no
        information about the loss.

    Raises
    ------
    TypeError
        If the hardness is not a number.
    ValueError
        If the scale is unknown, or the hardness is outside the range of the relations.

    References
    ----------
    A. N. Gent, "On the relation between indentation hardness and Young's modulus", Rubber Chem. Technol. 31 (1958) 896.
    H. J. Qi, K. Joyce, M. C. Boyce, "Durometer hardness and the stress-strain behavior of elastomeric materials",
    Rubber Chem. Technol. 76 (2003) 419: log₁₀ E/MPa = 0.0235 S - 0.6403, S = S_A, or S_D + 50.

    Examples
    --------
    >>> shear = hardness_to_modulus(60.0)
    >>> print(f"{shear.value / 1e6:.2f} MPa in [{shear.lower / 1e6:.2f}, {shear.upper / 1e6:.2f}]")
    1.54 MPa in [1.11, 2.19]
    """
    ranges = {"A": (20.0, 90.0), "D": (30.0, 85.0)}
    shore_scale = scale.upper() if isinstance(scale, str) else scale
    if shore_scale not in ranges:
        raise InvalidInput("scale", "must be 'A' or 'D'", shown(scale))
    try:
        shore = as_float("hardness", hardness)
    except TypeError as error:
        raise TypeError(f"{error}; pass the scale separately, scale='A' or scale='D'") from None
    low, high = ranges[shore_scale]
    if not low <= shore <= high:
        harder = ""
        if shore_scale == "A" and high < shore <= 100.0:
            harder = f"; use scale='D' for harder materials: {shore:g} Shore A is about {shore - _A_OF_D:g} Shore D"
        raise InvalidInput("hardness", f"must be in [{low:g}, {high:g}] Shore {shore_scale}", f"{shore:g}{harder}")
    if shore_scale == "D":
        value = _qi(shore + _A_OF_D)
        return Parameter(value=value, lower=0.5 * value, upper=2.0 * value, unit="Pa")
    bounds = [law(shore + change) for law in (_gent, _qi) for change in (-_REPRODUCIBILITY, _REPRODUCIBILITY)]
    return Parameter(value=math.sqrt(_gent(shore) * _qi(shore)), lower=min(bounds), upper=max(bounds), unit="Pa")


def rebound_to_loss_factor(rebound: float) -> Parameter:
    """Estimate the loss factor from the rebound resilience of a data sheet (ISO 4662, DIN 53512 or ASTM D2632).

    The impact of the pendulum or plunger is half a cycle of an oscillator, which retains the fraction e^(-π η) of its
    energy. The impact lasts some milliseconds, so the loss factor holds at some hundred rad/s.

    The interval covers two uncertainties: the rounding to whole percent, and the end of the impact. The impact ends
    after half a cycle, or earlier, when the force vanishes. A Kelvin-Voigt solid with the damping ratio ζ = η/2 then
    retains the fraction exp(-2 ζ (π - 2 arcsin ζ) / √(1 - ζ²)). The interval does not cover other instruments or
    temperatures: "resilience values from one type of rebound instrument may not, in general, be predicted from results
    on another type of rebound instrument" (ASTM D2632, 4.1).

    Parameters
    ----------
    rebound : float
        Fraction of the energy that is retained [-], in [0.02, 1): 0.55 for a data sheet value of 55 %.

    Returns
    -------
    Parameter
        Loss factor η = tan δ [-] with its bounds.

    Raises
    ------
    TypeError
        If the rebound is not a number.
    ValueError
        If the rebound is out of range.

    Examples
    --------
    >>> loss = rebound_to_loss_factor(0.55)
    >>> print(f"{loss.value:.2f} in [{loss.lower:.2f}, {loss.upper:.2f}]")
    0.19 in [0.19, 0.21]
    """
    share = as_float("rebound", rebound)
    if not 0.02 <= share < 1.0:
        percent = f"; {share:g} % is {share / 100.0:g}" if 1.0 < share <= 100.0 else ""
        raise InvalidInput("rebound", "must be in [0.02, 1), as a fraction of the energy", f"{share:g}{percent}")
    highest = min(share + _ROUNDED, 1.0)
    return Parameter(
        value=_half_swing(share), lower=_half_swing(highest), upper=_until_free(max(share - _ROUNDED, 0.0)), unit="1"
    )


def _half_swing(share: float) -> float:
    """Return the loss factor of an oscillator that retains a fraction of its energy over half a cycle."""
    return -math.log(share) / math.pi


def _until_free(share: float) -> float:
    """Return the loss factor of a Kelvin-Voigt solid that retains a fraction of the energy until its force vanishes."""
    least, most = 0.0, 1.0 - 1e-9
    for _ in range(60):  # bisections, to double precision
        ratio = 0.5 * (least + most)
        kept = math.exp(-2.0 * ratio * (math.pi - 2.0 * math.asin(ratio)) / math.sqrt(1.0 - ratio**2))
        least, most = (ratio, most) if kept > share else (least, ratio)
    return 2.0 * least


def _gent(shore: float) -> float:
    """Return the shear modulus [Pa] from the spring force of a durometer on a flat punch."""
    return 0.0981e6 * (56.0 + 7.62336 * shore) / (0.137505 * (254.0 - 2.54 * shore)) / _INCOMPRESSIBLE


def _qi(shore: float) -> float:
    return float(10.0 ** (0.0235 * shore - 0.6403) * 1e6 / _INCOMPRESSIBLE)
