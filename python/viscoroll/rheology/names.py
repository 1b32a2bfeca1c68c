"""Names and units of columns, as instruments and people write them."""

from __future__ import annotations

import re
from dataclasses import dataclass

import numpy as np

from .._support.celsius import ZERO_CELSIUS
from .._support.text import one_line

__all__ = ["Column", "header_column", "is_unit", "is_unit_of", "normalized", "parse_header", "role_of"]

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
        "rad/sec": (1.0, 0.0),
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
    "strain": {"%": (0.01, 0.0), "1": (1.0, 0.0), "-": (1.0, 0.0), "mm/mm": (1.0, 0.0)},
    "angle": {"°": (np.pi / 180.0, 0.0), "deg": (np.pi / 180.0, 0.0), "rad": (1.0, 0.0), "mrad": (1e-3, 0.0)},
    "time": {
        "s": (1.0, 0.0),
        "sec": (1.0, 0.0),
        "ms": (1e-3, 0.0),
        "min": (60.0, 0.0),
        "h": (3600.0, 0.0),
        "d": (86400.0, 0.0),
    },
    "compliance": {
        "1/Pa": (1.0, 0.0),
        "1/kPa": (1e-3, 0.0),
        "1/MPa": (1e-6, 0.0),
        "1/GPa": (1e-9, 0.0),
        "Pa-1": (1.0, 0.0),
        "kPa-1": (1e-3, 0.0),
        "MPa-1": (1e-6, 0.0),
        "GPa-1": (1e-9, 0.0),
        "m2/N": (1.0, 0.0),
        "mm2/N": (1e-6, 0.0),
    },
    "viscosity": {"Pa s": (1.0, 0.0), "Pa.s": (1.0, 0.0), "mPa.s": (1e-3, 0.0), "mPa s": (1e-3, 0.0)},
    "ratio": {"": (1.0, 0.0), "-": (1.0, 0.0), "1": (1.0, 0.0)},
}

#: Largest absolute value of each kind of quantity, in the units above: far beyond any measurement, including the
#: frequencies of master curves, and far enough below the largest float for products and squares of moduli.
_LARGEST = {
    "frequency": 1e100,
    "modulus": 1e20,
    "temperature": 1e4,
    "strain": 1e6,
    "ratio": 1e20,
    "angle": 1e3,
    "time": 1e20,
    "compliance": 1e20,
    "viscosity": 1e40,
}

#: Ways to write 1/s, which is rad/s in a column of angular frequency, and not defined in one of frequency.
_PER_SECOND = {"1/s", "s-1", "/s"}

#: Kind of quantity of each column.
_KIND = {
    "frequency": "frequency",
    "second_frequency": "frequency",
    "strain": "strain",
    "storage": "modulus",
    "loss": "modulus",
    "complex": "modulus",
    "tan_delta": "ratio",
    "phase": "angle",
    "temperature": "temperature",
    "sweep": "ratio",
    "time": "time",
    "stress": "modulus",
    "relaxation": "modulus",
    "compliance": "compliance",
    "viscosity": "viscosity",
}

_FREQUENCY = {"f", "freq", "frequency", "test frequency", "frequenz", "fréquence", "周波数"}
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
    "fréquence angulaire",
    "pulsation",
    "角周波数",
}

#: Further names of columns by role, in English, German, French and Japanese.
_NAMES = {
    "temperature": {
        "t",
        "temp",
        "temperature",
        "sample temperature",
        "sample temp",
        "temperatur",
        "température",
        "温度",
    },
    "tan_delta": {
        "tan delta",
        "tan(delta)",
        "tan δ",
        "tan(δ)",
        "tan d",
        "tand",
        "tandelta",
        "loss factor",
        "damping factor",
        "verlustfaktor",
        "facteur de perte",
        "損失正接",
    },
    "phase": {
        "phase",
        "phase angle",
        "delta",
        "δ",
        "loss angle",
        "phasenwinkel",
        "phasenverschiebungswinkel",
        "angle de phase",
        "déphasage",
        "位相角",
    },
    "storage": {"storage modulus", "storage", "speichermodul", "module de conservation", "貯蔵弾性率"},
    "loss": {"loss modulus", "loss", "verlustmodul", "module de perte", "損失弾性率"},
    "complex": {
        "complex modulus",
        "complex shear modulus",
        "complex tensile modulus",
        "dynamic modulus",
        "komplexer modul",
        "komplexer schubmodul",
        "module complexe",
        "複素弾性率",
    },
    "sweep": {"set", "sweep"},
    "strain": {
        "strain",
        "shear strain",
        "oscillation strain",
        "oscillatory strain",
        "dynamic strain",
        "strain amplitude",
        "double strain amplitude",
        "\N{GREEK SMALL LETTER GAMMA}",
        "gamma",
        "dehnung",
        "scherdeformation",
        "deformation",
        "déformation",
        "ひずみ",
    },
    "time": {"time", "step time", "test time", "zeit", "temps", "時間"},
    "stress": {"stress", "shear stress", "schubspannung", "spannung", "contrainte", "応力"},
    "relaxation": {
        "relaxation modulus",
        "stress relaxation modulus",
        "g(t)",
        "e(t)",
        "relaxationsmodul",
        "module de relaxation",
        "緩和弾性率",
    },
    "compliance": {
        "compliance",
        "creep compliance",
        "j(t)",
        "d(t)",
        "nachgiebigkeit",
        "kriechnachgiebigkeit",
        "complaisance",
        "complaisance de fluage",
        "クリープコンプライアンス",
    },
    "viscosity": {"viscosity", "viskosität", "viscosité", "粘度"},
}
_TENSILE = re.compile(
    r"(e|d(?=\(t\))|tensile|young'?s?|extensional|flexural|bending|compression)\b|e['_\"]|e(stor|loss)"
)
_SHEAR = re.compile(r"(g|j(?=\(t\))|shear)\b|g['_\"]|g(stor|loss)")


#: Typographic primes and apostrophes by code point, and a pair of single ones, with their plain replacements.
_PRIMES = (("\u2032", "'"), ("\u2019", "'"), ("\u00b4", "'"), ("\u2033", '"'), ("''", '"'))


#: A frequency in a header, such as "1.000 Hz".
_HELD = r"(\d+(?:[.,]\d*)?) *(m|k)?Hz"


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
        Quantity, such as "frequency", "storage" or "time"; "second_frequency" for a second column of frequency.
    frequency : float or None
        Frequency that the header states [Hz], as in ``E'(1.000 Hz)``; None without one.
    """

    index: int
    name: str
    unit: str
    role: str
    frequency: float | None = None

    @property
    def is_tensile(self) -> bool | None:
        """Whether the name denotes a modulus of tension; None if it denotes neither tension nor shear."""
        name = normalized(self.name).removeprefix("complex ")
        symbol = name.split(" ")[-1]
        # A symbol can follow the words, as in "Relaxation modulus G(t)".
        for part in (name, symbol if role_of(symbol) == self.role else ""):
            if _TENSILE.match(part.lstrip("|")):
                return True
            if _SHEAR.match(part.lstrip("|")):
                return False
        return None

    @property
    def has_unit(self) -> bool:
        """Whether the file gives a known unit."""
        return self._unit() is not None

    @property
    def is_angular(self) -> bool:
        """Whether the unit of a frequency is one of angular frequency."""
        return (self._unit() or "").startswith("rad")

    @property
    def _is_named_angular(self) -> bool:
        return normalized(self.name.replace("_", " ")) in _ANGULAR

    def _unit(self) -> str | None:
        """Return the unit in the table of units, or None if it is missing or unknown."""
        if self._is_named_angular and _plain_unit(self.unit) in _PER_SECOND:
            return "rad/s"
        return _known_unit(_KIND[self.role], self.unit)

    def converted(self, values: list[float], path: object) -> np.ndarray:
        """Return the values in rad/s, Pa or K, and strain as a ratio.

        Raises
        ------
        ValueError
            If the unit is missing, unknown or at odds with the name, or if a value is too large for a measurement.
        """
        known = UNITS_OF[_KIND[self.role]]
        unit = self._unit()
        if unit is None:
            found = f"unit {self.unit!r}" if self.unit else "no unit"
            allowed = ", ".join(f"{name!r}" for name in known)
            name = one_line(self.name)
            raise ValueError(
                f"{path}: column {self.name!r} ({self.role}) must have a unit of {allowed}, got {found}; "
                f'pass columns={{"{self.role}": ("{name}", unit)}}, '
                f"in the shell --columns {self.role}={name}:unit"
            )
        if self._is_named_angular and unit.endswith("Hz"):
            raise ValueError(
                f"{path}: column {self.name!r} must be in 'rad/s' according to its name, got {self.unit!r}"
            )
        factor, offset = known[unit]
        self._require_size(values, (_LARGEST[_KIND[self.role]] - abs(offset)) / factor, unit, path)
        converted = np.asarray(values) * factor + offset
        if self.role == "temperature" and (converted < 0.0).any():
            coldest = values[int(np.argmin(converted))]
            raise ValueError(f"{path}: column {self.name!r} must be above absolute zero, got {coldest:g} {unit}")
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
    """Return the role of the column with a name, or with a name and its symbol; None if the name is unknown."""
    found = _role(normalized(name)) or _role(normalized(name.replace("_", " ")))
    if found is None and " " in name.strip():
        words, symbol = name.strip().rsplit(None, 1)
        found = _role(normalized(words))
        if found != _role(normalized(symbol)):
            return None
    return found


def _role(plain: str) -> str | None:
    bare = re.sub(r"^(tensile|shear|young's|flexural|bending|extensional|compression|[eg]) ", "", plain)
    if plain in _FREQUENCY | _ANGULAR:
        return "frequency"
    for role, known in _NAMES.items():
        if plain in known or (role in ("storage", "loss", "relaxation", "compliance") and bare in known):
            return role
    if re.fullmatch(r"[eg]('|_?stor(age)?|_?prime| prime)", plain):
        return "storage"
    if re.fullmatch(r"[eg](\"|_?loss|_?doubleprime| double prime)", plain):
        return "loss"
    if re.fullmatch(r"(\|[eg]\*?\||[eg]\*)", plain):
        return "complex"
    return None


def parse_header(cell: str) -> tuple[str, str]:
    """Split a header such as "E' (MPa)", "Temp./°C", "E' in MPa" or "freq_hz" into name and unit; "" without a unit."""
    cell = cell.strip().lstrip("#").strip()
    for pattern in (r"(.+?)\s*\[([^\]]*)\]", r"(.+?)\s*\(([^()]*)\)"):
        found = re.fullmatch(pattern, cell)
        if not found or role_of(cell) or re.fullmatch(_HELD, found[2]):
            continue
        if role_of(found[2]) and role_of(found[1]) == role_of(found[2]):  # "Storage modulus (G')"
            return found[2].strip(), ""
        if is_unit(found[2]) or role_of(found[1]):
            return found[1].strip(), found[2].strip()
    for pattern in (r"(.+?)\s*/\s*(.+)", r"(.+?) in (\S+)", r"(.+?),\s*(.+)"):
        found = re.fullmatch(pattern, cell)
        if found and (is_unit(found[2]) or (found[2].strip() in ("1", "-") and role_of(found[1]))):
            return found[1].strip(), found[2].strip()
    found = re.fullmatch(r"(.+?)\s*/\s*(.+)", cell)
    if found and role_of(found[1]) and not role_of(cell) and not role_of(found[2]):  # a unit that is unknown
        return found[1].strip(), found[2].strip()
    found = re.fullmatch(r"(.+)_([^_]+)", cell)
    if found and found[2].lower() in _LOWER_UNITS and role_of(found[1]):
        return found[1], found[2]
    return cell, ""


def header_column(index: int, cell: str, role: str | None = None) -> Column | None:
    """Return the column of a header cell, or None if its role is unknown.

    Netzsch's Proteus appends the frequency of a sweep to the name of a modulus: ``E'(1.000 Hz)/MPa``.
    """
    name, unit = parse_header(cell)
    frequency = None
    if held := re.fullmatch(rf"(.+?)\s*\({_HELD}\)", name):
        name = held[1].strip()
        frequency = float(held[2].replace(",", ".")) * {"m": 1e-3, "k": 1e3, None: 1.0}[held[3]]
    found = role or role_of(name)
    if found == "temperature" and normalized(name) == "t" and _known_unit("time", unit):
        found = "time"
    return None if found is None else Column(index, name, unit, found, frequency)


def is_unit(text: str) -> bool:
    """Return whether a text is a unit of a kind of quantity, other than 1 and -."""
    plain = _plain_unit(text)
    kinds = (kind for kind in UNITS_OF if kind != "ratio")
    return plain == "%" or (
        plain not in ("1", "-", "") and (plain in _PER_SECOND or any(_known_unit(kind, plain) for kind in kinds))
    )


def is_unit_of(kind: str, text: str) -> bool:
    """Return whether a text is a unit of a kind of quantity."""
    return _known_unit(kind, text) is not None


def _plain_unit(text: str) -> str:
    """Return a unit without brackets, with plain signs for degrees, exponents and products."""
    plain = text.strip().strip("[]()").strip().replace("º", "°").replace("²", "2").replace("⁻¹", "-1")
    return re.sub(r"^(deg|°) (?=[CFcf]$)", r"\1", plain.replace("^", "").replace("·", "."))


def _known_unit(kind: str, text: str) -> str | None:
    """Return the unit in the table that a text denotes, ignoring case unless this is ambiguous (mPa and MPa)."""
    plain = _plain_unit(text)
    if plain in UNITS_OF[kind]:
        return plain
    alike = [unit for unit in UNITS_OF[kind] if unit.lower() == plain.lower()]
    return alike[0] if len(alike) == 1 else None


#: All units in lower case, as they end names such as "freq_hz".
_LOWER_UNITS = {unit.lower() for units in UNITS_OF.values() for unit in units} - {"", "-", "1"}
