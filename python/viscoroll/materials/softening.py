"""The modulus of a filled rubber: a matrix that knows frequency beside a network that knows the amplitude of strain."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from .. import _core
from .._support.arguments import as_float, as_positive, require_type
from .loss_factor import LossFactor
from .moduli import Elastic, ShearModulus, ShearModulusLike, as_modulus, to_core
from .networks import Network

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from .moduli import _CoreModulus

__all__ = ["SoftenedModulus", "SofteningModulus"]

#: Of the network as a law of frequency. Frequencies of a contact are a few decades around Ω R/a; the lowest is that of
#: a whole revolution, R/a below it, and what is static takes the modulus from below that.
_DECADES = 4.0

#: Loss factors that a law of frequency can have, as `LossFactor` has them; beyond the larger one the network is a few
#: percent of its modulus at rest. Below the smaller one it is elastic.
_LOSS_FACTORS = (1e-6, 2.0)


@dataclass(frozen=True, slots=True, kw_only=True)
class SofteningModulus(ShearModulus):
    """Modulus that falls with strain, μ* = μ*_matrix(ω) + N'(g) + i N''(g).

    It has no value without an amplitude g: layers may be made of it, but solved with it they are by
    `viscoroll.strain_softening` alone, which finds the strain that they have.

    Parameters
    ----------
    matrix : ShearModulus, callable or float
        What remains at large strain: rubber without its network, whose modulus at rest bears the load.
    network : KrausNetwork, MasingNetwork or StrainSweep
        What strain breaks.

    Examples
    --------
    >>> from viscoroll import MasingNetwork, StandardLinearSolid
    >>> rubber = StandardLinearSolid(instantaneous_modulus=6e6, relaxed_modulus=3e6, relaxation_time=0.125)
    >>> tread = SofteningModulus(matrix=rubber, network=MasingNetwork(storage=6e6, critical_strain=0.01))
    >>> tread.at(0.01, reference_frequency=8.0).complex_modulus([8.0]).round(-4)
    array([7410000.+2370000.j])
    """

    matrix: ShearModulusLike
    network: Network

    def __post_init__(self) -> None:
        """Check both parts."""
        object.__setattr__(self, "matrix", as_modulus(self.matrix))
        if isinstance(self.matrix, SofteningModulus):
            raise TypeError("matrix must be a modulus that does not depend on strain, got a viscoroll.SofteningModulus")
        require_type("network", self.network, Network)
        self.at(0.0, reference_frequency=1.0)

    def at(self, amplitude: float, *, reference_frequency: float, loss_scale: float = 1.0) -> SoftenedModulus:
        """Return the modulus at one amplitude of strain, for all harmonics.

        N' + iN'' without frequency is not causal; here it is |N| (iω/ω₀)^((2/π) atan N''/N'), `LossFactor`, which has
        this value at ω₀. Of a loss factor above 2, a network that has all but broken, 2 is taken.

        Parameters
        ----------
        amplitude : float
            g, of shear strain [-], ≥ 0.
        reference_frequency : float
            ω₀ [rad/s], > 0: Ω R/a, the speed by radius per half-width of the contact.
        loss_scale : float, default 1
            c, by which N'' is multiplied [-], > 0.

        Returns
        -------
        SoftenedModulus
            A function of frequency alone, as any other modulus.
        """
        scale = as_positive("loss_scale", loss_scale)
        storage, loss = (float(part) for part in self.network.at(as_float("amplitude", amplitude)))
        return SoftenedModulus(matrix=self.matrix, network=_causal(storage, scale * loss, reference_frequency))

    def _to_core(self) -> _core.CustomModulus:
        raise TypeError(
            "shear_modulus must be known without an amplitude of strain, got a viscoroll.SofteningModulus: give the "
            "body to viscoroll.strain_softening, or take its at(amplitude, reference_frequency=...) here"
        )


@dataclass(frozen=True, slots=True, kw_only=True)
class SoftenedModulus(ShearModulus):
    """A filled rubber at one amplitude of strain: matrix and network side by side.

    Parameters
    ----------
    matrix : ShearModulus, callable or float
        Of the rubber.
    network : LossFactor or Elastic, optional
        As it is at that amplitude; None where nothing is left of it.
    """

    matrix: ShearModulusLike
    network: LossFactor | Elastic | None

    def network_modulus(self, angular_frequency: NDArray[np.float64]) -> NDArray[np.complex128]:
        """Return N*(ω), the network's share of the modulus [Pa]."""
        if self.network is None:
            return np.zeros(angular_frequency.shape, np.complex128)
        return self.network.complex_modulus(angular_frequency)

    def _to_core(self) -> _CoreModulus:
        if self.network is None:
            return to_core(self.matrix)
        return _core.CustomModulus(self._sum)

    def _sum(self, angular_frequency: NDArray[np.float64]) -> NDArray[np.complex128]:
        return _core.complex_modulus(to_core(self.matrix), angular_frequency) + self.network_modulus(angular_frequency)


def _causal(storage: float, loss: float, reference_frequency: float) -> LossFactor | Elastic | None:
    if storage <= 0.0:
        return None
    least, most = _LOSS_FACTORS
    if loss < least * storage:
        return Elastic(modulus=storage)
    return LossFactor(
        modulus=storage,
        loss_factor=min(loss / storage, most),
        reference_frequency=reference_frequency,
        decades=_DECADES,
    )
