"""Modulus of a filled rubber: a frequency-dependent matrix in parallel with a strain-dependent network."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, TypeGuard

import numpy as np

from .. import _core
from .._support.arguments import as_float, as_positive, require_type
from .._support.errors import InvalidType
from .moduli import Elastic, LossFactor, ShearModulus
from .modulus_like import ShearModulusLike, as_modulus, to_core
from .networks import Network

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["SoftenedModulus", "SofteningModulus", "depends_on_strain", "strain_amplitude"]

#: Decades above and below ω₀ = Ω R/a over which the network has a constant loss factor. The frequencies of a contact
#: lie within a few decades of ω₀; the lowest is Ω. The static modulus is the value below the range.
_DECADES = 4.0

#: Range of loss factors of `LossFactor`. Only a network with a few percent of its modulus at rest has a larger loss
#: factor; the upper limit replaces it. A network with a smaller loss factor is treated as elastic.
_LOSS_FACTORS = (1e-6, 2.0)


@dataclass(frozen=True, slots=True, kw_only=True)
class SofteningModulus(ShearModulus):
    """Modulus that decreases with strain, μ* = μ*_matrix(ω) + N'(g) + i N''(g).

    The modulus has no value without a strain amplitude g. Layers may use it, but only `viscoroll.strain_softening`,
    which determines their strain, can solve such a body.

    Parameters
    ----------
    matrix : ShearModulus, callable or float
        Modulus of the matrix [Pa], which remains at large strain. Its relaxed modulus must support the load.
    network : KrausNetwork, MasingNetwork or StrainSweep
        Filler network, which strain breaks.

    Examples
    --------
    >>> from viscoroll import StandardLinearSolid
    >>> from viscoroll.materials import MasingNetwork
    >>> rubber = StandardLinearSolid(instantaneous_modulus=6e6, relaxed_modulus=3e6, relaxation_time=0.125)
    >>> tread = SofteningModulus(matrix=rubber, network=MasingNetwork(storage=6e6, critical_strain=0.01))
    >>> tread.at(0.01, reference_frequency=8.0).complex_modulus([8.0]).round(-4)
    array([7410000.+2370000.j])
    """

    matrix: ShearModulusLike
    network: Network

    def __post_init__(self) -> None:
        """Check matrix and network."""
        object.__setattr__(self, "matrix", as_modulus(self.matrix))
        if isinstance(self.matrix, SofteningModulus):
            raise InvalidType(
                "matrix", "must be a modulus that does not depend on strain", "a viscoroll.materials.SofteningModulus"
            )
        require_type("network", self.network, Network)
        self.at(0.0, reference_frequency=1.0)

    def at(self, amplitude: float, *, reference_frequency: float, loss_scale: float = 1.0) -> SoftenedModulus:
        """Return the modulus at one strain amplitude, for all harmonics.

        A modulus N' + iN'' that does not depend on frequency is not causal. The network is therefore represented by |N|
        (iω/ω₀)^((2/π) atan N''/N'), a `LossFactor`, which has the value N' + iN'' at ω₀. Loss factors above 2, which
        occur if little of the network is left, are replaced by 2.

        Parameters
        ----------
        amplitude : float
            Amplitude g of shear strain [-], ≥ 0.
        reference_frequency : float
            ω₀ = Ω R/a [rad/s], > 0, with the angular speed Ω, the radius R and the half-width a of the contact.
        loss_scale : float, default 1
            Factor c on N'' [-], > 0.

        Returns
        -------
        SoftenedModulus
            A modulus that depends on frequency only.
        """
        scale = as_positive("loss_scale", loss_scale)
        storage, loss = (float(part) for part in self.network.at(as_float("amplitude", amplitude)))
        network = _causal(storage, scale * loss, reference_frequency)
        return SoftenedModulus(matrix=self.matrix, network=network, amplitude=float(amplitude))

    def _to_core(self) -> _core.ShearModulus:
        raise InvalidType(
            "shear_modulus",
            "must not depend on strain here",
            "a viscoroll.materials.SofteningModulus: pass the body to viscoroll.strain_softening, "
            "or use the modulus at(amplitude, reference_frequency=...)",
        )


@dataclass(frozen=True, slots=True, kw_only=True)
class SoftenedModulus(ShearModulus):
    """Modulus of a filled rubber at one strain amplitude: matrix and network in parallel.

    Parameters
    ----------
    matrix : ShearModulus, callable or float
        Modulus of the matrix [Pa].
    network : LossFactor or Elastic, optional
        Modulus of the network at that amplitude; None if the network is completely broken.
    amplitude : float, optional
        The strain amplitude [-]. `viscoroll.slide` compares it with the slopes of the surface.
    """

    matrix: ShearModulusLike
    network: LossFactor | Elastic | None
    amplitude: float | None = None

    def network_modulus(self, angular_frequency: NDArray[np.float64]) -> NDArray[np.complex128]:
        """Return the contribution N*(ω) of the network to the modulus [Pa]."""
        if self.network is None:
            return np.zeros(angular_frequency.shape, np.complex128)
        return self.network.complex_modulus(angular_frequency)

    def _to_core(self) -> _core.ShearModulus:
        if self.network is None:
            return to_core(self.matrix)
        return _core.custom_modulus(self._sum)

    def _sum(self, angular_frequency: NDArray[np.float64]) -> NDArray[np.complex128]:
        return _core.complex_modulus(to_core(self.matrix), angular_frequency) + self.network_modulus(angular_frequency)


def strain_amplitude(modulus: ShearModulusLike) -> float | None:
    """Return the strain amplitude [-] at which the modulus of a filled rubber holds, or None if it is not known."""
    return modulus.amplitude if isinstance(modulus, SoftenedModulus) else None


def depends_on_strain(modulus: ShearModulusLike) -> TypeGuard[SofteningModulus]:
    """Return whether a modulus decreases with strain."""
    return isinstance(modulus, SofteningModulus)


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
