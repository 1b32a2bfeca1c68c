"""Rough surfaces that slide on viscoelastic layers: contact area and friction."""

from .result import Persson, SlidingResult
from .rough_surface import RoughSurface
from .slide import persson_estimate, slide

__all__ = ["Persson", "RoughSurface", "SlidingResult", "persson_estimate", "slide"]
