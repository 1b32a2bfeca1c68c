"""Moduli from the hardness that data sheets give, with the scatter that this has, and loss from the rebound."""

from __future__ import annotations

import math

from .._support.arguments import as_float
from .._support.least_squares import Parameter
from .._support.text import shown

__all__ = ["hardness_to_modulus", "rebound_to_loss_factor"]

#: Hardness that instruments and laboratories differ by at the least [Shore].
_REPRODUCIBILITY = 2.0

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
        harder = "; give what is harder in Shore D" if shore_scale == "A" and shore > high else ""
        raise ValueError(f"hardness must be in [{low:g}, {high:g}] Shore {shore_scale}, got {shore:g}{harder}")
    if shore_scale == "D":
        value = _qi(shore + 50.0)
        return Parameter(value=value, lower=0.5 * value, upper=2.0 * value, unit="Pa")
    bounds = [law(shore + change) for law in (_gent, _qi) for change in (-_REPRODUCIBILITY, _REPRODUCIBILITY)]
    return Parameter(value=math.sqrt(_gent(shore) * _qi(shore)), lower=min(bounds), upper=max(bounds), unit="Pa")


def rebound_to_loss_factor(rebound: float) -> float:
    """Estimate the loss factor from the rebound resilience that data sheets give.

    The pendulum that strikes the rubber and returns is half a swing of an oscillator, which keeps e^(-π η) of its
    energy. The blow lasts some milliseconds: the loss factor is one of some hundred rad/s.

    Parameters
    ----------
    rebound : float
        Share of the energy that the pendulum keeps [-], in [0.01, 1): 0.55 for the 55 % of a data sheet.

    Returns
    -------
    float
        Loss factor η = tan δ [-].

    Raises
    ------
    TypeError
        Where the rebound is not a number.
    ValueError
        Where it is not in the range.

    Examples
    --------
    >>> round(rebound_to_loss_factor(0.55), 3)
    0.19
    """
    share = as_float("rebound", rebound)
    if not 0.01 <= share < 1.0:
        percent = f"; {share:g} % is {share / 100.0:g}" if 1.0 < share <= 100.0 else ""
        raise ValueError(f"rebound must be in [0.01, 1), a share of the energy, got {share:g}{percent}")
    return -math.log(share) / math.pi


def _gent(shore: float) -> float:
    """Shear modulus [Pa] by the force of the spring of a durometer on a flat punch."""
    return 0.0981e6 * (56.0 + 7.62336 * shore) / (0.137505 * (254.0 - 2.54 * shore)) / _INCOMPRESSIBLE


def _qi(shore: float) -> float:
    return float(10.0 ** (0.0235 * shore - 0.6403) * 1e6 / _INCOMPRESSIBLE)
