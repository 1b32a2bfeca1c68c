"""Sensitivity of a result to the modulus of a material, by frequency."""

from __future__ import annotations

from dataclasses import dataclass

from .._support.arguments import Floats

__all__ = ["ModulusSensitivity"]


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class ModulusSensitivity:
    """Relative change of results per relative change of the modulus of a material, by frequency.

    Attributes
    ----------
    name : str
        Name of the modulus: ``"layers[0].shear_modulus"``, or ``"on.layers[0].shear_modulus"`` in a counterbody.
    frequency : ndarray, shape (bands,)
        Centers of overlapping bands whose weights add up to 1 at every frequency [rad/s]. The lowest band contains all
        lower frequencies, including rest, and the highest band all higher ones.
    storage, loss : ndarray, shape (answers, bands)
        Relative change of each answer divided by the relative change of G' or G'' in a band [-].
    """

    name: str
    frequency: Floats
    storage: Floats
    loss: Floats
