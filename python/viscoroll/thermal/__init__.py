"""Temperature of the layers in steady rolling. `viscoroll.Result.temperature` computes it."""

from .temperature import Temperature

__all__ = ["Temperature"]
