"""Tables of published materials, for the web page that runs without Python.

The C++ library does not contain the published materials. This module tabulates their moduli at round temperatures, and
`page/tabulated.js` looks them up.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import fields
from enum import Enum
from typing import Any

from .._support.celsius import ZERO_CELSIUS
from .._support.text import snake_case
from ..materials import ShearModulus
from ..rheology import example_material
from ..rheology.published import EXAMPLES

__all__ = ["published_materials"]

#: Tabulated temperatures [K].
_TEMPERATURES = [ZERO_CELSIUS + celsius for celsius in range(-10, 60, 10)]


def published_materials() -> dict[str, Any]:
    """Return tables of case files by name and temperature [K], such as "293.15", that can be written as JSON."""
    return {
        name: {str(kelvin): _table(example_material(name).at(temperature=kelvin)) for kelvin in _TEMPERATURES}
        for name in EXAMPLES
    }


def _table(modulus: ShearModulus) -> dict[str, Any]:
    """Return the table of a case file for a modulus."""
    parameters = {field.name: _plain(getattr(modulus, field.name)) for field in fields(modulus)}  # type: ignore[arg-type]
    return {"type": snake_case(type(modulus).__name__), **parameters}


def _plain(value: object) -> object:
    """Return an enum member as its name in case files, and a sequence as a list of floats."""
    if isinstance(value, Enum):
        return value.name.lower()
    return list(map(float, value)) if isinstance(value, Iterable) else value
