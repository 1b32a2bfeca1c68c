"""What the modulus of a material does to a result, by frequency."""

from __future__ import annotations

from dataclasses import dataclass

from .._support.arguments import Floats

__all__ = ["ModulusSensitivity"]


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class ModulusSensitivity:
    """What the modulus of a material does, by frequency.

    Attributes
    ----------
    name : str
        Whose: ``"layers[0].shear_modulus"``, of a counterpart ``"on.layers[0].shear_modulus"``.
    frequency : ndarray, shape (bands,)
        Middles of bands that overlap, and add up to 1 at every frequency [rad/s]. The lowest holds all that is below,
        rest among it, the highest all that is above.
    storage, loss : ndarray, shape (answers, bands)
        Relative change of each answer by that of G' or G'' around a frequency [-].
    """

    name: str
    frequency: Floats
    storage: Floats
    loss: Floats
