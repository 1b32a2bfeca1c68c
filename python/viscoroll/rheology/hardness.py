"""Moduli from the hardness that data sheets give, with the scatter that this has, and loss from the rebound."""

from __future__ import annotations

import math

from .._support.arguments import as_float
from .._support.least_squares import Parameter
from .._support.text import shown

__all__ = ["hardness_to_modulus", "rebound_to_loss_factor"]

#: Hardness that instruments and laboratories differ by at the least [Shore].
_REPRODUCIBILITY = 2.0

#: Data sheets give rebounds in whole percent.
_ROUNDED = 0.005

#: Qi's scale of hardness, on which Shore A and D meet: S = S_A = S_D + 50.
_A_OF_D = 50.0

#: Young's modulus / shear modulus of what keeps its volume.
_INCOMPRESSIBLE = 3.0


def hardness_to_modulus(hardness: float, *, scale: str = "A") -> Parameter:
    """Estimate the static shear modulus of a rubber from its Shore hardness.

    No more than an order: an indenter is not a rheometer, and the two relations in use differ by a factor of 1.2 to 2.
    For Shore A the value is the geometric mean of Gent's and of Qi's, and the interval holds both at ±2 Shore; for
    Shore D there is Qi's alone, and the interval is half to twice as much.

    Parameters
    ----------
    hardness : float
        Shore A in [20, 90], or Shore D in [30, 85].
    scale : {"A", "D"}
        Which of the two, in either case.

    Returns
    -------
    Parameter
        Shear modulus [Pa] with its bounds, a third of Young's modulus. It is one at rest, or nearly: it says nothing of
        the loss.

    Raises
    ------
    TypeError
        Where the hardness is not a number.
    ValueError
        For another scale, and hardness outside the range of the relations.

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
        raise ValueError(f"scale must be 'A' or 'D', got {shown(scale)}")
    try:
        shore = as_float("hardness", hardness)
    except TypeError as error:
        raise TypeError(f"{error}; its scale is given apart, as scale='A' or scale='D'") from None
    low, high = ranges[shore_scale]
    if not low <= shore <= high:
        harder = ""
        if shore_scale == "A" and high < shore <= 100.0:
            harder = (
                f"; give what is harder in Shore D, where {shore:g} Shore A is about {shore - _A_OF_D:g}: scale='D'"
            )
        raise ValueError(f"hardness must be in [{low:g}, {high:g}] Shore {shore_scale}, got {shore:g}{harder}")
    if shore_scale == "D":
        value = _qi(shore + _A_OF_D)
        return Parameter(value=value, lower=0.5 * value, upper=2.0 * value, unit="Pa")
    bounds = [law(shore + change) for law in (_gent, _qi) for change in (-_REPRODUCIBILITY, _REPRODUCIBILITY)]
    return Parameter(value=math.sqrt(_gent(shore) * _qi(shore)), lower=min(bounds), upper=max(bounds), unit="Pa")


def rebound_to_loss_factor(rebound: float) -> Parameter:
    """Estimate the loss factor from the rebound resilience that data sheets give, by ISO 4662, DIN 53512 or ASTM D2632.

    What strikes the rubber and returns, a pendulum or a plunger, is half a swing of an oscillator, which keeps
    e^(-π η) of its energy. The blow lasts some milliseconds: the loss factor is one of some hundred rad/s.

    The interval is of what a rounded percent and the end of the blow leave open: after half a swing, or sooner, where
    the force is gone, which of a Kelvin-Voigt solid of damping ratio ζ = η/2 leaves the share
    exp(-2 ζ (π - 2 arcsin ζ) / √(1 - ζ²)). What another instrument or temperature would give is not in it: "resilience
    values from one type of rebound instrument may not, in general, be predicted from results on another type of rebound
    instrument" (ASTM D2632, 4.1).

    Parameters
    ----------
    rebound : float
        Share of the energy that is kept [-], in [0.02, 1): 0.55 for the 55 % of a data sheet.

    Returns
    -------
    Parameter
        Loss factor η = tan δ [-] with its bounds.

    Raises
    ------
    TypeError
        Where the rebound is not a number.
    ValueError
        Where it is not in the range.

    Examples
    --------
    >>> loss = rebound_to_loss_factor(0.55)
    >>> print(f"{loss.value:.2f} in [{loss.lower:.2f}, {loss.upper:.2f}]")
    0.19 in [0.19, 0.21]
    """
    share = as_float("rebound", rebound)
    if not 0.02 <= share < 1.0:
        percent = f"; {share:g} % is {share / 100.0:g}" if 1.0 < share <= 100.0 else ""
        raise ValueError(f"rebound must be in [0.02, 1), a share of the energy, got {share:g}{percent}")
    highest = min(share + _ROUNDED, 1.0)
    return Parameter(
        value=_half_swing(share), lower=_half_swing(highest), upper=_until_free(max(share - _ROUNDED, 0.0)), unit="1"
    )


def _half_swing(share: float) -> float:
    """Loss factor of what keeps a share of its energy in half a swing."""
    return -math.log(share) / math.pi


def _until_free(share: float) -> float:
    """Loss factor of the Kelvin-Voigt solid that keeps a share of the energy until its force is gone."""
    least, most = 0.0, 1.0 - 1e-9
    for _ in range(60):  # of doubles
        ratio = 0.5 * (least + most)
        kept = math.exp(-2.0 * ratio * (math.pi - 2.0 * math.asin(ratio)) / math.sqrt(1.0 - ratio**2))
        least, most = (ratio, most) if kept > share else (least, ratio)
    return 2.0 * least


def _gent(shore: float) -> float:
    """Shear modulus [Pa] by the force of the spring of a durometer on a flat punch."""
    return 0.0981e6 * (56.0 + 7.62336 * shore) / (0.137505 * (254.0 - 2.54 * shore)) / _INCOMPRESSIBLE


def _qi(shore: float) -> float:
    return float(10.0 ** (0.0235 * shore - 0.6403) * 1e6 / _INCOMPRESSIBLE)
