"""A solved contact: its numbers and fields, and all that looks into them."""

from .loss_spectrum import LossSpectrum, loss_spectrum

__all__ = ["LossSpectrum", "loss_spectrum"]
