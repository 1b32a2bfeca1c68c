"""Adhesion of two smooth, clean surfaces."""

from __future__ import annotations

from dataclasses import asdict, dataclass, field, fields

from .. import _core
from .._support.arguments import store_floats
from .._support.errors import InvalidInput
from .._support.tables import ParameterTable
from .._support.units import UNITS

__all__ = ["Adhesion"]


@dataclass(frozen=True, slots=True, kw_only=True)
class Adhesion(ParameterTable):
    """Attraction of two surfaces across their gap g: strength · (1 - g/range)² up to the range, above a hard wall.

    The work of adhesion is strength · range / 3. Without strength and range, the range is taken to be so short that
    results do not depend on it. Materials without an instantaneous modulus, and those that relax over more than two
    decades of time, need the strength.

    Parameters
    ----------
    work : float
        Work of adhesion w [J/m²], > 0, gained where the surfaces come together. Clean rubber on glass has 0.05 to 0.1.
    strength : float, optional
        Attraction at contact [Pa], > 0.
    range : float, optional
        Gap at which the attraction ends [m], > 0, instead of `strength`.
    separation_work : float, optional
        Work to separate the surfaces again [J/m²], ≥ `work`; by default `work`. The difference is dissipated at the
        trailing edge.

    Raises
    ------
    TypeError
        If a value is not a real number.
    ValueError
        If a value is out of range, or both strength and range are given.

    References
    ----------
    docs/theory/adhesion.md; L. Pastewka and M. O. Robbins, Proc. Natl. Acad. Sci. USA 111 (2014) 3298-3303.

    Examples
    --------
    >>> Adhesion(work=0.05)
    Adhesion(work=0.05, strength=None, range=None, separation_work=None)
    """

    work: float = field(metadata={"unit": "J/m^2"})
    strength: float | None = field(default=None, metadata={"unit": "Pa"})
    range: float | None = field(default=None, metadata={"unit": "m"})
    separation_work: float | None = field(default=None, metadata={"unit": "J/m^2"})

    def __post_init__(self) -> None:
        """Store the numbers as floats and check the parameters."""
        store_floats(self, ["work"], optional=["strength", "range", "separation_work"], prefix="adhesion.")
        try:
            self._to_core()
        except InvalidInput as error:
            raise error.inside("adhesion") from None

    def _to_core(self) -> _core.Adhesion:
        return _core.Adhesion(**asdict(self))


UNITS.update({parameter.name: parameter.metadata["unit"] for parameter in fields(Adhesion)})
