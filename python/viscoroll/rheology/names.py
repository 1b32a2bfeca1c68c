"""Names and units of columns, as instruments and people write them."""

from __future__ import annotations

import re
from dataclasses import dataclass

import numpy as np

from .._support.celsius import ZERO_CELSIUS
from .._support.text import one_line

__all__ = ["Column", "is_unit", "normalized", "parse_header", "role_of"]

#: Decimal places [K] to which converted temperatures are rounded: only round-off is removed.
PLACES = 9

#: 0 °F [K].
_ZERO_FAHRENHEIT = ZERO_CELSIUS - 160.0 / 9.0

#: Units of each kind of quantity, with the factor and the offset that convert them to rad/s, Pa, K or a ratio.
UNITS_OF: dict[str, dict[str, tuple[float, float]]] = {
    "frequency": {
        "Hz": (2.0 * np.pi, 0.0),
        "rad/s": (1.0, 0.0),
        "mHz": (2e-3 * np.pi, 0.0),
        "kHz": (2e3 * np.pi, 0.0),
        "MHz": (2e6 * np.pi, 0.0),
        "rad s-1": (1.0, 0.0),
        "rad.s-1": (1.0, 0.0),
    },
    "modulus": {
        "Pa": (1.0, 0.0),
        "kPa": (1e3, 0.0),
        "MPa": (1e6, 0.0),
        "GPa": (1e9, 0.0),
        "mPa": (1e-3, 0.0),
        "N/mm2": (1e6, 0.0),
    },
    "temperature": {
        "°C": (1.0, ZERO_CELSIUS),
        "C": (1.0, ZERO_CELSIUS),
        "degC": (1.0, ZERO_CELSIUS),
        "Celsius": (1.0, ZERO_CELSIUS),
        "K": (1.0, 0.0),
        "Kelvin": (1.0, 0.0),
        "°F": (5.0 / 9.0, _ZERO_FAHRENHEIT),
        "F": (5.0 / 9.0, _ZERO_FAHRENHEIT),
        "degF": (5.0 / 9.0, _ZERO_FAHRENHEIT),
    },
    "strain": {"%": (0.01, 0.0), "1": (1.0, 0.0), "-": (1.0, 0.0)},
    "ratio": {"": (1.0, 0.0), "-": (1.0, 0.0), "1": (1.0, 0.0)},
}

#: Largest absolute value of each kind of quantity, in the units above: far beyond any measurement, including the
#: frequencies of master curves, and far enough below the largest float for products and squares of moduli.
_LARGEST = {"frequency": 1e100, "modulus": 1e20, "temperature": 1e4, "strain": 1e6, "ratio": 1e20}

#: Kind of quantity of each column.
_KIND = {
    "frequency": "frequency",
    "second_frequency": "frequency",
    "strain": "strain",
    "storage": "modulus",
    "loss": "modulus",
    "tan_delta": "ratio",
    "temperature": "temperature",
    "sweep": "ratio",
}

_FREQUENCY = {"f", "freq", "frequency", "test frequency", "frequenz"}
_ANGULAR = {
    "w",
    "ω",
    "omega",
    "angular frequency",
    "ang. frequency",
    "ang frequency",
    "angular freq",
    "angularfrequency",
    "kreisfrequenz",
}
_TEMPERATURE = {"t", "temp", "temperature", "sample temperature", "sample temp", "temperatur"}
_TAN_DELTA = {
    "tan delta",
    "tan(delta)",
    "tan δ",
    "tan(δ)",
    "tan d",
    "tand",
    "tandelta",
    "loss factor",
    "damping factor",
}
_STORAGE = {"storage modulus", "storage", "speichermodul"}
_LOSS = {"loss modulus", "loss", "verlustmodul"}
_SWEEP = {"set", "sweep"}
_STRAIN = {
    "strain",
    "shear strain",
    "oscillation strain",
    "oscillatory strain",
    "dynamic strain",
    "strain amplitude",
    "double strain amplitude",
    "\N{GREEK SMALL LETTER GAMMA}",
    "gamma",
}
_TENSILE = re.compile(r"(e|tensile|young'?s?|extensional|flexural|bending|compression)\b|e['_\"]|e(stor|loss)")
_SHEAR = re.compile(r"(g|shear)\b|g['_\"]|g(stor|loss)")


#: Typographic primes and apostrophes by code point, and a pair of single ones, with their plain replacements.
_PRIMES = (("\u2032", "'"), ("\u2019", "'"), ("\u00b4", "'"), ("\u2033", '"'), ("''", '"'))


@dataclass(frozen=True, slots=True)
class Column:
    """One column of a table.

    Attributes
    ----------
    index : int
        Position of the column.
    name, unit : str
        Name and unit in the file; the unit is empty if there is none.
    role : str
        "frequency", "strain", "storage", "loss", "tan_delta", "temperature" or "sweep"; "second_frequency" for a second
        column of frequency.
    """

    index: int
    name: str
    unit: str
    role: str

    @property
    def is_tensile(self) -> bool | None:
        """Whether the name denotes a modulus of tension; None if it denotes neither tension nor shear."""
        name = normalized(self.name)
        if _TENSILE.match(name):
            return True
        return False if _SHEAR.match(name) else None

    @property
    def has_unit(self) -> bool:
        """Whether the file gives a known unit."""
        return _known_unit(_KIND[self.role], self.unit) is not None

    @property
    def is_angular(self) -> bool:
        """Whether the unit of a frequency is one of angular frequency."""
        return (_known_unit("frequency", self.unit) or "").startswith("rad")

    def converted(self, values: list[float], path: object) -> np.ndarray:
        """Return the values in rad/s, Pa or K, and strain as a ratio.

        Raises
        ------
        ValueError
            If the unit is missing, unknown or at odds with the name, or if a value is too large for a measurement.
        """
        known = UNITS_OF[_KIND[self.role]]
        unit = _known_unit(_KIND[self.role], self.unit)
        if unit is None:
            found = f"unit {self.unit!r}" if self.unit else "no unit"
            allowed = ", ".join(f"{name!r}" for name in known)
            name = one_line(self.name)
            raise ValueError(
                f"{path}: column {self.name!r} ({self.role}) must have a unit of {allowed}, got {found}; "
                f'pass columns={{"{self.role}": ("{name}", unit)}}, '
                f"in the shell --columns {self.role}={name}:unit"
            )
        if normalized(self.name) in _ANGULAR and unit.endswith("Hz"):
            raise ValueError(
                f"{path}: column {self.name!r} must be in 'rad/s' according to its name, got {self.unit!r}"
            )
        factor, offset = known[unit]
        self._require_size(values, (_LARGEST[_KIND[self.role]] - abs(offset)) / factor, unit, path)
        converted = np.asarray(values) * factor + offset
        return np.round(converted, PLACES) if offset else converted  # -50 °C are 223.15 K, not 223.14999999999998 K

    def plain(self, values: list[float], path: object) -> np.ndarray:
        """Return the values of a column without a unit, such as tan δ; raise a ValueError if one is too large."""
        self._require_size(values, _LARGEST[_KIND[self.role]], "", path)
        return np.asarray(values)

    def _require_size(self, values: list[float], largest: float, unit: str, path: object) -> None:
        for value in values:
            if abs(value) > largest:
                most = f"{largest:.4g} {unit}".strip()
                raise ValueError(
                    f"{path}: column {self.name!r} ({self.role}) must be at most {most} in magnitude, got {value:g}"
                )


def normalized(name: str) -> str:
    """Return a name in lower case, with plain primes and single spaces."""
    for prime, plain in _PRIMES:
        name = name.replace(prime, plain)
    return re.sub(r"\s+", " ", name.strip().strip("#").lower()).rstrip(".").strip()


def role_of(name: str) -> str | None:
    """Return the role of the column with a name, or None if the name is unknown."""
    plain = normalized(name)
    bare = re.sub(r"^(tensile|shear|young's|flexural|bending|extensional|compression|[eg]) ", "", plain)
    if plain in _FREQUENCY | _ANGULAR:
        return "frequency"
    if plain in _TEMPERATURE:
        return "temperature"
    if plain in _TAN_DELTA:
        return "tan_delta"
    if plain in _SWEEP:
        return "sweep"
    if plain in _STRAIN:
        return "strain"
    if bare in _STORAGE or re.fullmatch(r"[eg]('|_?stor(age)?|_?prime| prime)", plain):
        return "storage"
    if bare in _LOSS or re.fullmatch(r"[eg](\"|_?loss|_?doubleprime| double prime)", plain):
        return "loss"
    return None


def parse_header(cell: str) -> tuple[str, str]:
    """Split a header such as "E' (MPa)", "f [Hz]", "Temp./°C" or "E' in MPa" into name and unit; "" without a unit."""
    cell = cell.strip().lstrip("#").strip()
    for pattern in (r"(.+?)\s*\[([^\]]*)\]", r"(.+?)\s*\(([^()]*)\)", r"(.+?)\s*/\s*(.+)", r"(.+?) in (\S+)"):
        found = re.fullmatch(pattern, cell)
        if found and is_unit(found[2]):
            # Netzsch appends the frequency of a sweep to the modulus: E'(1.000 Hz)/MPa
            return re.sub(r"\s*\([\d.,]+ *Hz\)$", "", found[1]).strip(), found[2].strip()
    return cell, ""


def is_unit(text: str) -> bool:
    """Return whether a text is a unit of frequency, modulus or temperature, or a percent sign."""
    kinds = ("frequency", "modulus", "temperature")
    return text.strip().strip("[]()") == "%" or any(_known_unit(kind, text) is not None for kind in kinds)


def _known_unit(kind: str, text: str) -> str | None:
    """Return the unit in the table that a text denotes, ignoring case unless this is ambiguous (mPa and MPa)."""
    plain = text.strip().strip("[]()").strip().replace("º", "°").replace("²", "2").replace("⁻¹", "-1")
    if plain in UNITS_OF[kind]:
        return plain
    alike = [unit for unit in UNITS_OF[kind] if unit.lower() == plain.lower()]
    return alike[0] if len(alike) == 1 else None
