"""Shear moduli of viscoelastic materials, strain-dependent filler networks and time-temperature shifts."""

from .._support.lazy import lazy_names

__getattr__, __dir__, __all__ = lazy_names(__name__, __path__)
