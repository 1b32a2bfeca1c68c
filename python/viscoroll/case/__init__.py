"""Cases, studies and motions in TOML files, and computations with a case (the extra `viscoroll[cli]`)."""

from .._support.lazy import lazy_names

__getattr__, __dir__, __all__ = lazy_names(__name__, __path__)
