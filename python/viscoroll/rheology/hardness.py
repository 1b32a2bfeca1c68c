"""Estimates from data sheets: shear modulus from hardness with its scatter, and loss factor from rebound."""

from __future__ import annotations

from .. import _core
from .._support.arguments import as_float
from .._support.errors import InvalidInput
from .._support.least_squares import Parameter
from .._support.text import shown

__all__ = ["hardness_to_modulus", "rebound_to_loss_factor"]


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
    shore_scale = _core.ShoreScale.__members__.get(scale.upper()) if isinstance(scale, str) else None
    if shore_scale is None:
        raise InvalidInput("scale", "must be 'A' or 'D'", shown(scale))
    try:
        shore = as_float("hardness", hardness)
    except TypeError as error:
        raise TypeError(f"{error}; pass the scale separately, scale='A' or scale='D'") from None
    return _estimate(_core.hardness_to_modulus(shore, shore_scale), "Pa")


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
    return _estimate(_core.rebound_to_loss_factor(as_float("rebound", rebound)), "1")


def _estimate(numbers: tuple[float, float, float], unit: str) -> Parameter:
    value, lower, upper = numbers
    return Parameter(value=value, lower=lower, upper=upper, unit=unit)
