"""Laws of a network of filler, which softens and loses by the amplitude of strain and not by frequency."""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from dataclasses import dataclass, fields
from typing import TYPE_CHECKING

import numpy as np

from .._support.arguments import as_float_array, as_not_negative, store_floats, store_positive
from .._support.tables import ParameterTable

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from .._support.arguments import Floats

__all__ = ["KrausNetwork", "MasingNetwork", "Network"]

#: Below it the closed form of the hyperbolic loss cancels to less than ten digits, and its series is taken.
_SERIES_BELOW = 0.03
_SERIES_TERMS = 12


class Network(ParameterTable, ABC):
    """Base of the laws: storage and loss over the amplitude of shear strain, single, not from peak to peak."""

    __slots__ = ()

    def at(self, amplitude: ArrayLike) -> tuple[Floats, Floats]:
        """Return storage and loss modulus.

        Parameters
        ----------
        amplitude : array_like
            g, amplitude of shear strain [-], ≥ 0, of any shape.

        Returns
        -------
        storage, loss : ndarray
            N', N'' [Pa], of the same shape.

        Raises
        ------
        ValueError
            For an amplitude that is negative or infinite.
        """
        strain = as_float_array("amplitude", amplitude)
        if not (np.isfinite(strain).all() and (strain >= 0.0).all()):
            raise ValueError(f"amplitude must be >= 0, got {strain.min():g} to {strain.max():g}")
        return self._moduli(strain)

    @abstractmethod
    def _moduli(self, strain: Floats) -> tuple[Floats, Floats]:
        """Return N' and N'' [Pa] at amplitudes of strain."""

    @property
    @abstractmethod
    def yield_strain(self) -> float:
        """Strain at which the storage modulus is about half of that at rest [-]; infinite where it never is."""

    @property
    def known_strains(self) -> tuple[float, float]:
        """Amplitudes between which the law is known [-]."""
        return 0.0, math.inf


@dataclass(frozen=True, slots=True, kw_only=True)
class KrausNetwork(Network):
    """Kraus' law, N' = N'₀ / (1 + u²) and N'' = 2 N''_m u / (1 + u²) with u = (g/γ_c)^m.

    Bonds of the network break as g^m and form again as g^-m; its loss is largest at γ_c, where its storage is half.

    Parameters
    ----------
    storage : float
        N'₀ = G'₀ - G'_∞, storage modulus at small less that at large strain [Pa], > 0.
    loss : float
        N''_m = G''_m - G''_∞, largest loss modulus less that at large strain [Pa], ≥ 0.
    critical_strain : float
        γ_c, amplitude of shear strain [-], > 0.
    exponent : float, default 0.6
        m [-], in (0, 1]; carbon black has 0.5 to 0.65.

    References
    ----------
    G. Kraus, "Mechanical losses in carbon-black-filled rubbers", J. Appl. Polym. Sci.: Appl. Polym. Symp. 39 (1984)
    75-92. The formulas were not held against the paper itself.

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
        """Store the numbers as floats and check them."""
        store_floats(self, [field.name for field in fields(self)])
        store_positive(self, {"storage": "Pa", "critical_strain": ""})
        as_not_negative("loss", self.loss, "Pa")
        if not 0.0 < self.exponent <= 1.0:
            raise ValueError(f"exponent must be in (0, 1], got {self.exponent!r}")

    @property
    def yield_strain(self) -> float:
        """Strain at which the storage modulus is half of that at rest [-]."""
        return self.critical_strain

    def _moduli(self, strain: Floats) -> tuple[Floats, Floats]:
        u = (strain / self.critical_strain) ** self.exponent
        return self.storage / (1.0 + u**2), 2.0 * self.loss * u / (1.0 + u**2)


@dataclass(frozen=True, slots=True, kw_only=True)
class MasingNetwork(Network):
    """Springs and dry sliders side by side, whose first loading is τ = N γ / (1 + γ/γ_c); the loss follows from it.

    Masing's rule, every branch the first one doubled, gives the loop; N' and N'' are its first harmonic, and the area
    of the loop is π g² N''. The largest loss, 0.1514 N at 1.567 γ_c, is what carbon black has.

    Parameters
    ----------
    storage : float
        N, modulus of the network at small strain [Pa], > 0.
    critical_strain : float
        γ_c [-], > 0.

    References
    ----------
    Closed forms of docs/theory/filled-rubber.md.

    Examples
    --------
    >>> network = MasingNetwork(storage=6e6, critical_strain=0.01)
    >>> [round(float(modulus)) for modulus in network.at(0.01)]
    [2911688, 868647]
    """

    storage: float
    critical_strain: float

    def __post_init__(self) -> None:
        """Store the numbers as floats and check them."""
        store_floats(self, [field.name for field in fields(self)])
        store_positive(self, {"storage": "Pa", "critical_strain": ""})

    @property
    def yield_strain(self) -> float:
        """Strain at which the storage modulus is about half of that at rest [-]."""
        return self.critical_strain

    def _moduli(self, strain: Floats) -> tuple[Floats, Floats]:
        storage, loss = hyperbolic_moduli(strain / self.critical_strain)
        return self.storage * storage, self.storage * loss


def hyperbolic_moduli(x: Floats) -> tuple[Floats, Floats]:
    """Return N'/N and N''/N of a hyperbolic Masing network, whose first loading is x/(1 + x), at amplitudes x [-].

    N'/N = (8/x²) [(1 + x/2)/√(1 + x) - 1], here without its cancellation, and
    N''/N = [8 (x - ln(1 + x))/x² - 4/(1 + x)]/π.
    """
    root = np.sqrt(1.0 + x)
    storage = 2.0 / (root * (1.0 + 0.5 * x + root))
    small = x < _SERIES_BELOW
    safe = np.where(small, 1.0, x)
    closed = 8.0 * (safe - np.log1p(safe)) / safe**2 - 4.0 / (1.0 + safe)
    powers = np.arange(1, _SERIES_TERMS + 1)
    series = ((-np.where(small, x, 0.0)[..., None]) ** powers * (8.0 / (powers + 2.0) - 4.0)).sum(axis=-1)
    return storage, np.where(small, series, closed) / math.pi
