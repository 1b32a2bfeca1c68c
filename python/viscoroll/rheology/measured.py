"""Interface of measured moduli as functions of frequency."""

from __future__ import annotations

from typing import TYPE_CHECKING, Protocol

import numpy as np

from .._support.arguments import Floats, as_float_array
from .._support.errors import InvalidInput, InvalidType
from .._support.text import shown

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

__all__ = ["MeasuredModulus", "measured"]


class MeasuredModulus(Protocol):
    """Measured moduli: columns of angular frequency [rad/s] and shear moduli [Pa] of the same length."""

    @property
    def frequency(self) -> ArrayLike:
        """Angular frequency [rad/s]."""

    @property
    def storage(self) -> ArrayLike:
        """Storage modulus [Pa]."""

    @property
    def loss(self) -> ArrayLike:
        """Loss modulus [Pa]."""


def measured(curve: MeasuredModulus) -> tuple[Floats, Floats, Floats]:
    """Return frequency, storage and loss of measured moduli, sorted by frequency and without entries at frequency 0.

    Raises
    ------
    TypeError
        If `curve` lacks one of these attributes.
    ValueError
        If the columns differ in length, have fewer than three points above 0 rad/s, or contain moduli that are not
        positive.
    """
    try:
        columns = [as_float_array(name, getattr(curve, name)) for name in ("frequency", "storage", "loss")]
    except AttributeError:
        hint = "; pass superpose(...) of the data, or one of its isotherms" if hasattr(curve, "isotherms") else ""
        raise InvalidType("curve", "must have frequency, storage and loss", f"{shown(curve)}{hint}") from None
    frequency, storage, loss = columns
    if frequency.ndim != 1 or not frequency.shape == storage.shape == loss.shape:
        raise InvalidInput("curve", "must have columns of equal length", f"{[column.shape for column in columns]}")
    order = np.argsort(frequency, kind="stable")
    order = order[frequency[order] > 0.0]
    if order.size < 3:
        raise InvalidInput("curve", "must have at least 3 points above 0 rad/s", order.size)
    for name, column in (("storage", storage), ("loss", loss)):
        if not (np.isfinite(column[order]).all() and (column[order] > 0.0).all()):
            raise InvalidInput(f"curve.{name}", "must be > 0 Pa at every point", f"{column[order].min():g}")
    return frequency[order], storage[order], loss[order]
