"""Laws of a filler network, whose storage and loss depend on the strain amplitude and not on the frequency."""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from dataclasses import dataclass, fields
from typing import TYPE_CHECKING

import numpy as np

from .._support.arguments import as_float_array, as_float_in, as_not_negative, store_floats, store_positive
from .._support.errors import InvalidInput, Range
from .._support.tables import ParameterTable

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from .._support.arguments import Floats

__all__ = ["KrausNetwork", "MasingNetwork", "Network"]

#: Relative amplitude below which a series replaces the closed form of the hyperbolic loss, whose cancellation there
#: leaves fewer than ten digits.
_SERIES_BELOW = 0.03
_SERIES_TERMS = 12


class Network(ParameterTable, ABC):
    """Base class of the network laws: storage and loss as functions of the single amplitude of shear strain."""

    __slots__ = ()

    def at(self, amplitude: ArrayLike) -> tuple[Floats, Floats]:
        """Return storage and loss modulus at a strain amplitude.

        Parameters
        ----------
        amplitude : array_like
            Amplitude g of shear strain [-], ≥ 0, of any shape.

        Returns
        -------
        storage, loss : ndarray
            N' and N'' [Pa], of the same shape.

        Raises
        ------
        ValueError
            If an amplitude is negative or infinite.
        """
        strain = as_float_array("amplitude", amplitude)
        if not (np.isfinite(strain).all() and (strain >= 0.0).all()):
            raise InvalidInput("amplitude", "must be >= 0", f"{strain.min():g} to {strain.max():g}")
        return self._moduli(strain)

    @abstractmethod
    def _moduli(self, strain: Floats) -> tuple[Floats, Floats]:
        """Return N' and N'' [Pa] at strain amplitudes."""

    @property
    @abstractmethod
    def yield_strain(self) -> float:
        """Strain at which the storage modulus is about half of its value at rest [-]; infinite if it never is."""

    @property
    def known_strains(self) -> tuple[float, float]:
        """Smallest and largest strain amplitude for which the law is valid [-]."""
        return 0.0, math.inf


@dataclass(frozen=True, slots=True, kw_only=True)
class KrausNetwork(Network):
    """Network with Kraus's law, N' = N'₀ / (1 + u²) and N'' = 2 N''_m u / (1 + u²) with u = (g/γ_c)^m.

    The bonds of the network break at a rate proportional to g^m and form again at a rate proportional to g^-m. The loss
    has its maximum at γ_c, where the storage modulus is half of N'₀.

    Parameters
    ----------
    storage : float
        N'₀ = G'₀ - G'_∞ [Pa], > 0: storage modulus at small strain minus that at large strain.
    loss : float
        N''_m = G''_m - G''_∞ [Pa], ≥ 0: largest loss modulus minus that at large strain.
    critical_strain : float
        Critical amplitude γ_c of shear strain [-], > 0.
    exponent : float, default 0.6
        Exponent m [-], in (0, 1]; 0.5 to 0.65 for carbon black.

    References
    ----------
    G. Kraus, "Mechanical losses in carbon-black-filled rubbers", J. Appl. Polym. Sci.: Appl. Polym. Symp. 39 (1984)
    75-92. The formulas were not checked against the paper.

    Examples
    --------
    >>> network = KrausNetwork(storage=8e6, loss=0.8e6, critical_strain=0.01)
    >>> [float(modulus) for modulus in network.at(0.01)]
    [4000000.0, 800000.0]
    """

    storage: float
    loss: float
    critical_strain: float
    exponent: float = 0.6

    def __post_init__(self) -> None:
        """Store numbers as floats and check them."""
        store_floats(self, [field.name for field in fields(self)])
        store_positive(self, {"storage": "Pa", "critical_strain": ""})
        as_not_negative("loss", self.loss, "Pa")
        as_float_in(Range(0.0, 1.0, excludes_minimum=True), "exponent", self.exponent)

    @property
    def yield_strain(self) -> float:
        """Strain at which the storage modulus is half of its value at rest [-]."""
        return self.critical_strain

    def _moduli(self, strain: Floats) -> tuple[Floats, Floats]:
        u = (strain / self.critical_strain) ** self.exponent
        return self.storage / (1.0 + u**2), 2.0 * self.loss * u / (1.0 + u**2)


@dataclass(frozen=True, slots=True, kw_only=True)
class MasingNetwork(Network):
    """Network of springs and dry sliders in parallel, whose first loading is τ = N γ / (1 + γ/γ_c).

    The loss follows from the first loading. By Masing's rule, each branch of the loop is the first loading enlarged by
    a factor of 2. N' and N'' are the first harmonic, and the area of the loop is π g² N''. The largest loss modulus,
    0.1514 N at g = 1.567 γ_c, is typical of carbon black.

    Parameters
    ----------
    storage : float
        Modulus N of the network at small strain [Pa], > 0.
    critical_strain : float
        Critical strain γ_c [-], > 0.

    References
    ----------
    Closed forms in docs/theory/filled-rubber.md.

    Examples
    --------
    >>> network = MasingNetwork(storage=6e6, critical_strain=0.01)
    >>> [round(float(modulus)) for modulus in network.at(0.01)]
    [2911688, 868647]
    """

    storage: float
    critical_strain: float

    def __post_init__(self) -> None:
        """Store numbers as floats and check them."""
        store_floats(self, [field.name for field in fields(self)])
        store_positive(self, {"storage": "Pa", "critical_strain": ""})

    @property
    def yield_strain(self) -> float:
        """Strain at which the storage modulus is about half of its value at rest [-]."""
        return self.critical_strain

    def _moduli(self, strain: Floats) -> tuple[Floats, Floats]:
        storage, loss = hyperbolic_moduli(strain / self.critical_strain)
        return self.storage * storage, self.storage * loss


def hyperbolic_moduli(x: Floats) -> tuple[Floats, Floats]:
    """Return N'/N and N''/N of a Masing network with the first loading x/(1 + x), at relative amplitudes x [-].

    The moduli are N'/N = (8/x²) [(1 + x/2)/√(1 + x) - 1], evaluated here in a form without cancellation, and N''/N = [8
    (x - ln(1 + x))/x² - 4/(1 + x)]/π.
    """
    root = np.sqrt(1.0 + x)
    storage = 2.0 / (root * (1.0 + 0.5 * x + root))
    small = x < _SERIES_BELOW
    safe = np.where(small, 1.0, x)
    closed = 8.0 * (safe - np.log1p(safe)) / safe**2 - 4.0 / (1.0 + safe)
    powers = np.arange(1, _SERIES_TERMS + 1)
    series = ((-np.where(small, x, 0.0)[..., None]) ** powers * (8.0 / (powers + 2.0) - 4.0)).sum(axis=-1)
    return storage, np.where(small, series, closed) / math.pi
