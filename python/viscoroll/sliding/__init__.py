"""Rough surfaces that slide on viscoelastic layers: contact area and friction."""

from .result import SlidingResult
from .rough_surface import RoughSurface
from .slide import persson_estimate, slide
from .solution import Persson

__all__ = ["Persson", "RoughSurface", "SlidingResult", "persson_estimate", "slide"]
