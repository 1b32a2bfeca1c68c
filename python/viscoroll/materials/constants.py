"""Materials of finite-element programs: constants read from their input, and written as their input."""

from __future__ import annotations

import re
from dataclasses import dataclass
from os import PathLike
from pathlib import Path
from typing import Literal

import numpy as np

from .._support.arguments import as_int, as_kelvin, as_poisson_ratio, as_positive, store_floats, store_positive
from .._support.celsius import ZERO_CELSIUS
from .._support.encodings import binary_format, decoded_utf16
from .._support.errors import InvalidInput, InvalidType, in_file
from .._support.text import shown
from . import abaqus, ansys, comsol, ls_dyna
from .deck import UNITS, Deck, Found, UnitSystem
from .fewer_terms import fewer_terms
from .moduli import MasterCurve, Prony, ShearModulus
from .modulus_like import as_modulus, relaxation_of
from .shift import Arrhenius, WilliamsLandelFerry, shift_factor, shifted
from .softening import SofteningModulus

__all__ = ["MaterialConstants", "holds_constants", "read_constants"]

TemperatureUnit = Literal["K", "C"]

_PROGRAMS = {"abaqus": "Abaqus", "ansys": "Ansys", "ls-dyna": "LS-DYNA", "comsol": "COMSOL"}
_WRITERS = {"abaqus": abaqus.write, "ansys": ansys.write, "ls-dyna": ls_dyna.write, "comsol": comsol.write}

#: First characters of a keyword or command by which the text of a program is recognized.
_SIGNS = {
    "ls-dyna": re.compile(r"^\*MAT_", re.IGNORECASE | re.MULTILINE),
    "abaqus": re.compile(r"^\s*\*\s*(MATERIAL|ELASTIC|HYPERELASTIC|VISCOELASTIC)\b", re.IGNORECASE | re.MULTILINE),
    "ansys": re.compile(r"^\s*(TB|MP|MPDATA)\s*,", re.IGNORECASE | re.MULTILINE),
    "comsol": re.compile(r"\A(\s*([%#].*)?\n)*\s*[\d.][^%#\n]*[,;\s]+\S+", re.IGNORECASE),
}

#: Smallest ratio of the bulk to the shear modulus. Poisson's ratio is -0.9955 there; less is an error of units.
_SMALLEST_BULK = 1e-3

#: Shear modulus at rest [Pa] below which the units of a text are probably not those assumed.
_SOFTEST = 1e3


@dataclass(frozen=True, slots=True, kw_only=True)
class MaterialConstants:
    """Viscoelastic material of a finite-element program, in SI units.

    `read_constants` returns it, and `to_text` writes it for another program.

    Parameters
    ----------
    shear_modulus : ShearModulus or float
        Shear modulus at the reference temperature of `shift`; a number [Pa] is an elastic modulus.
    poisson_ratio : float, optional
        Poisson's ratio in (-1, 0.5] if it is constant, so that the bulk modulus relaxes like the shear modulus.
    bulk_modulus : float, optional
        Bulk modulus [Pa] if it is constant, so that only the shear modulus relaxes; at least 0.001 of the
        instantaneous shear modulus.
    shift : WilliamsLandelFerry or Arrhenius, optional
        Shift of relaxation times with temperature.
    density : float, optional
        Mass density [kg/m³], > 0.
    name : str, default "material"
        Name or number of the material: printable characters other than commas and quotation marks, of which the first
        is neither * nor $.
    program : str, optional
        Program from whose text the constants were read.
    notes : tuple of str, optional
        Statements about constants that were read in another form, or left out.

    Raises
    ------
    TypeError
        If a parameter has a wrong type, or the modulus is a function or a strain-dependent `SofteningModulus`.
    ValueError
        If a number is out of range, or a program could not read the name.

    Examples
    --------
    >>> from viscoroll import Prony
    >>> rubber = Prony(instantaneous_modulus=6e6, weights=[0.5], relaxation_times=[0.1])
    >>> constants = MaterialConstants(shear_modulus=rubber, poisson_ratio=0.45)
    >>> print(constants.to_text("comsol"))
    % Viscoelastic material, written by viscoroll. Units: m-kg-s.
    % nu is constant: the bulk modulus relaxes like the shear modulus.
    % G = 3000000.0
    % nu = 0.45
    1 3000000.0 0.1
    <BLANKLINE>
    """

    shear_modulus: ShearModulus
    poisson_ratio: float | None = None
    bulk_modulus: float | None = None
    shift: WilliamsLandelFerry | Arrhenius | None = None
    density: float | None = None
    name: str = "material"
    program: str = ""
    notes: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        """Store the numbers as floats and check the parameters."""
        object.__setattr__(self, "shear_modulus", _rate_dependent(self.shear_modulus))
        if self.poisson_ratio is not None and self.bulk_modulus is not None:
            raise InvalidInput("bulk_modulus", "must be left out with poisson_ratio", shown(self.bulk_modulus))
        units = {"bulk_modulus": "Pa", "density": "kg/m³"}
        store_positive(self, {name: unit for name, unit in units.items() if getattr(self, name) is not None})
        store_floats(self, (), optional=("poisson_ratio",))
        if self.poisson_ratio is not None:
            as_poisson_ratio("poisson_ratio", self.poisson_ratio)
        smallest = _SMALLEST_BULK * _largest_known(self.shear_modulus)
        if self.bulk_modulus is not None and self.bulk_modulus < smallest:
            rule = f"must be >= {smallest:.3g} Pa, 0.001 of the shear modulus: check its unit"
            raise InvalidInput("bulk_modulus", rule, f"{self.bulk_modulus:g}")
        if not isinstance(self.shift, WilliamsLandelFerry | Arrhenius | None):
            raise InvalidType("shift", "must be WilliamsLandelFerry, Arrhenius or None", shown(self.shift))
        if not isinstance(self.name, str):
            raise InvalidType("name", "must be a text", shown(self.name))
        if self.name != _label(self.name):
            rule = "must be of printable characters without , and quotation marks, and not begin with *, $ or a space"
            raise InvalidInput("name", rule, shown(self.name))

    def at(self, *, temperature: float) -> ShearModulus:
        """Return the shear modulus at a temperature [K].

        Raises
        ------
        ValueError
            If the material has no shift, or its law does not extend to the temperature.
        """
        kelvin = as_kelvin("temperature", temperature)
        if self.shift is None:
            raise InvalidInput("temperature", "must be left out: the material has no shift", f"{kelvin:g} K")
        return shifted(self.shear_modulus, shift_factor(self.shift, kelvin))  # type: ignore[return-value]

    def to_text(
        self,
        program: str,
        *,
        terms: int | None = None,
        tolerance: float = 0.02,
        frequencies: tuple[float, float] | None = None,
        units: str = "m-kg-s",
        temperature_unit: TemperatureUnit = "K",
    ) -> str:
        """Return the material as input of a program.

        A sum of exponentials is written without error. Any other modulus, and a series of more than `terms` terms, is
        fitted by a series. Abaqus also takes tables, which are then written as FREQUENCY=TABULAR.

        Parameters
        ----------
        program : {"abaqus", "ansys", "ls-dyna", "comsol"}
            Program that reads the text.
        terms : int, optional
            Largest number of terms, ≥ 1, besides the relaxed modulus. Required for moduli that are not sums of
            exponentials.
        tolerance : float, default 0.02
            Largest relative error of the fitted complex modulus [-], > 0, at any frequency of the range.
        frequencies : (float, float), optional
            Range of angular frequencies [rad/s] of a fit; by default that of the relaxation times or of the table.
        units : str, default "m-kg-s"
            Units of the text: "m-kg-s", "mm-t-s", "mm-kg-ms", "mm-g-ms", "cm-g-us" or "in-lbf-s".
        temperature_unit : {"K", "C"}, default "K"
            Unit of the temperatures of the text.

        Returns
        -------
        str
            Text with comments that state units, conventions and the error of a fit.

        Raises
        ------
        ValueError
            If the program cannot represent the material, or the tolerance is not reached with that many terms.
        """
        if program not in _WRITERS:
            raise InvalidInput("program", f"must be one of {', '.join(_WRITERS)}", shown(program))
        return _WRITERS[program](self._deck(program, terms, tolerance, frequencies, units, temperature_unit))

    def _deck(
        self,
        program: str,
        terms: int | None,
        tolerance: float,
        frequencies: tuple[float, float] | None,
        units: str,
        temperature_unit: str,
    ) -> Deck:
        scale = _units(units)
        comments = [f"Viscoelastic material, written by viscoroll. Units: {units}."]
        if self.poisson_ratio is not None:
            comments.append("nu is constant: the bulk modulus relaxes like the shear modulus.")
        if self.bulk_modulus is not None:
            comments.append("K is constant: only the shear modulus relaxes.")
        modulus = self.shear_modulus
        relaxation = relaxation_of(modulus)
        table: tuple[tuple[float, float, float], ...] = ()
        weights: tuple[float, ...] = ()
        times: tuple[float, ...] = ()
        if program == "abaqus" and isinstance(modulus, MasterCurve) and terms is None:
            if modulus.frequency[0] != 0.0:
                rule = "must have a first entry at frequency 0, the long-term modulus, or terms must be given"
                raise InvalidInput("shear_modulus.frequency", rule, f"{modulus.frequency[0]:g}")
            table = tuple(zip(modulus.frequency, modulus.storage, modulus.loss, strict=True))[1:]
            relaxed = instantaneous = modulus.storage[0]
        else:
            exact = relaxation is not None and relaxation.viscosity == 0.0
            if terms is not None and as_int("terms", terms) < 1:
                raise InvalidInput("terms", "must be >= 1", terms)
            if not exact and terms is None:
                raise InvalidInput("terms", "must be given: this modulus is not a sum of exponentials and is fitted")
            if relaxation is None or not exact or (terms is not None and relaxation.times.size - 1 > terms):
                assert terms is not None
                limit = as_positive("tolerance", tolerance)
                fit, comment = fewer_terms(modulus, terms=terms, tolerance=limit, frequencies=frequencies)
                comments.append(comment)
                relaxation = fit._relaxation()
            moduli = relaxation.moduli.tolist()
            relaxed = moduli[-1]
            instantaneous = float(np.sum(relaxation.moduli))
            if isinstance(modulus, Prony) and exact and relaxation.times.size - 1 == len(modulus.weights):
                instantaneous, weights = modulus.instantaneous_modulus, tuple(modulus.weights)
            else:
                weights = tuple(value / instantaneous for value in moduli[:-1])
            times = tuple(relaxation.times[:-1].tolist())
        offset = ZERO_CELSIUS if _temperature_unit(temperature_unit) == "C" else 0.0
        if offset and isinstance(self.shift, Arrhenius):
            raise InvalidInput("temperature_unit", "must be 'K' with the Arrhenius law", "'C'")
        return Deck(
            name=self.name or "material",
            instantaneous=instantaneous / scale.stress,
            weights=weights,
            times=tuple(time / scale.time for time in times),
            relaxed=max(0.0, relaxed) / scale.stress,
            table=tuple((w * scale.time, s / scale.stress, l_ / scale.stress) for w, s, l_ in table),
            poisson_ratio=self.poisson_ratio,
            bulk_modulus=None if self.bulk_modulus is None else self.bulk_modulus / scale.stress,
            density=None if self.density is None else self.density / scale.density,
            shift=self.shift,
            reference_temperature=0.0 if self.shift is None else self.shift.reference_temperature - offset,
            comments=tuple(comments),
        )

    def __repr__(self) -> str:
        """Return the constants in lines of text."""
        known = [f"{self.name}: shear modulus {self.shear_modulus!r}"]
        if self.program:
            known[0] = f"{self.program} {known[0]}"
        if self.poisson_ratio is not None:
            known.append(f"  Poisson's ratio {self.poisson_ratio:.6g}, constant: the bulk modulus relaxes as well")
        if self.bulk_modulus is not None:
            known.append(f"  bulk modulus {self.bulk_modulus:.6g} Pa, constant: only the shear modulus relaxes")
        if self.shift is not None:
            known.append(f"  shift {self.shift!r}")
        if self.density is not None:
            known.append(f"  density {self.density:.6g} kg/m³")
        return "\n".join([*known, *(f"  note: {note}" for note in self.notes)])


def _rate_dependent(modulus: object) -> ShearModulus:
    """Return a modulus unchanged and a number as an elastic modulus; reject functions and moduli that need a strain."""
    rule = "must be a modulus of viscoroll at vanishing strain, or a number"
    try:
        accepted = as_modulus(modulus)  # type: ignore[arg-type]
    except InvalidType as error:
        raise InvalidType("shear_modulus", rule, error.value) from None
    if not isinstance(accepted, ShearModulus) or isinstance(accepted, SofteningModulus):
        raise InvalidType("shear_modulus", rule, shown(modulus))
    return accepted


def _largest_known(modulus: ShearModulus) -> float:
    """Return the instantaneous modulus [Pa] of a sum of exponentials, and the modulus at rest of others."""
    relaxation = relaxation_of(modulus)
    return float(modulus.complex_modulus(0.0).real if relaxation is None else np.sum(relaxation.moduli))


def _label(name: str) -> str:
    """Return a name without characters that end a name, or make a line a keyword or comment, in any program."""
    kept = "".join(c if c.isprintable() and c not in ",\"'" else " " for c in name)
    return kept.lstrip("*$ ").rstrip()


def holds_constants(path: Path) -> bool:
    """Return whether a file contains a keyword or command of viscoelastic constants of Abaqus, Ansys or LS-DYNA."""
    try:
        text = _decoded(path)
    except InvalidInput:  # a binary file
        return False
    return any(sign.search(text) for program, sign in _SIGNS.items() if program != "comsol")


def read_constants(
    source: str | Path,
    *,
    name: str | None = None,
    units: str = "m-kg-s",
    temperature_unit: TemperatureUnit = "K",
    relaxed_modulus: float | None = None,
) -> MaterialConstants:
    r"""Read a viscoelastic material from the input of Abaqus, Ansys, LS-DYNA or COMSOL.

    The function recognizes the program by its keywords. The page "Constants of other programs" states the convention
    of each program and shows one material in all of them.

    Parameters
    ----------
    source : str or Path
        Path of a file in UTF-8, UTF-16 or Latin-1, or a text of more than one line.
    name : str, optional
        Name or number of the material; required if the text has several viscoelastic materials.
    units : str, default "m-kg-s"
        Units of the text: "m-kg-s" (Pa, s), "mm-t-s" (MPa, s), "mm-kg-ms" (GPa, ms), "mm-g-ms" (MPa, ms), "cm-g-us"
        (Mbar, μs) or "in-lbf-s" (psi, s).
    temperature_unit : {"K", "C"}, default "K"
        Unit of the temperatures of the text.
    relaxed_modulus : float, optional
        Long-term shear modulus [Pa] of a table of branches without it.

    Returns
    -------
    MaterialConstants
        Shear modulus, Poisson's ratio or bulk modulus, shift and density in SI units, and notes. A note lists keywords
        of the material that were not read, for example because of a typing error.

    Raises
    ------
    TypeError
        If `source` is neither a path nor a text, or another argument has a wrong type.
    ValueError
        If the program is not recognized, a constant is missing or out of range, or the material is of a form that is
        not read. The message names line and keyword.
    OSError
        If the file cannot be read.

    Notes
    -----
    Abaqus: \*VISCOELASTIC with TIME=PRONY, FREQUENCY=PRONY or FREQUENCY=TABULAR, \*ELASTIC or \*HYPERELASTIC (NEO
    HOOKE, MOONEY-RIVLIN, YEOH), and \*TRS. Ansys: TB,PRONY with MP,EX and MP,NUXY, TB,ELASTIC or TB,HYPER, and
    TB,SHIFT. LS-DYNA: \*MAT_076 and \*MAT_006. COMSOL: tables of branches of the generalized Maxwell model.

    References
    ----------
    Abaqus Keywords Reference Guide; Mechanical APDL Material Reference, "Viscoelasticity"; LS-DYNA Keyword User's
    Manual, volume II; COMSOL Structural Mechanics Module User's Guide, "Viscoelasticity".

    Examples
    --------
    >>> deck = '''*MATERIAL, NAME=RUBBER
    ... *ELASTIC, MODULI=INSTANTANEOUS
    ... 18E6, 0.5
    ... *VISCOELASTIC, TIME=PRONY
    ... 0.3, 0, 0.1
    ... '''
    >>> read_constants(deck).shear_modulus
    Prony(instantaneous_modulus=6000000.0, weights=(0.3,), relaxation_times=(0.1,))
    """
    scale = _units(units)
    offset = ZERO_CELSIUS if _temperature_unit(temperature_unit) == "C" else 0.0
    relaxed = None if relaxed_modulus is None else as_positive("relaxed_modulus", relaxed_modulus, "Pa")
    if not isinstance(source, str | PathLike):
        raise InvalidType("source", "must be a path or a text", shown(source))
    if not isinstance(name, str | None):
        raise InvalidType("name", "must be a text or None", shown(name))
    if not str(source).strip():
        raise InvalidInput("source", "must be a path or a text of more than one line", shown(source))
    is_text = isinstance(source, str) and "\n" in source
    text = str(source) if is_text else _decoded(Path(source))
    try:
        program = next((program for program, sign in _SIGNS.items() if sign.search(text)), None)
        if program is None:
            raise InvalidInput("text", f"must be input of {', '.join(_PROGRAMS.values())}", shown(text[:60]))
        if program == "comsol":
            found = comsol.read(text, scale, relaxed)
        else:
            found = {"abaqus": abaqus.read, "ansys": ansys.read, "ls-dyna": ls_dyna.read}[program](text, scale)
        chosen = _chosen(found, name, _PROGRAMS[program])
        return _constants(chosen, _PROGRAMS[program], offset)
    except ValueError as error:
        raise error if is_text else in_file(error, source) from None


def _decoded(path: Path) -> str:
    content = path.read_bytes()
    if (binary := binary_format(content)) is not None:
        names = ", ".join(_PROGRAMS.values())
        raise InvalidInput("text", f"must be input of {names}", binary).of_file(path)
    if (text := decoded_utf16(content)) is not None:
        return text
    try:
        return content.decode("utf-8-sig")
    except UnicodeDecodeError:
        return content.decode("latin-1")  # comments in other encodings do not matter


def _units(name: str) -> UnitSystem:
    if not isinstance(name, str) or name not in UNITS:
        raise InvalidInput("units", f"must be one of {', '.join(UNITS)}", shown(name))
    return UNITS[name]


def _temperature_unit(unit: str) -> str:
    if unit not in ("K", "C"):
        raise InvalidInput("temperature_unit", "must be 'K' or 'C'", shown(unit))
    return unit


def _chosen(found: list[Found], name: str | None, program: str) -> Found:
    names = ", ".join(shown(one.name) for one in found)
    if not found:
        raise InvalidInput("text", f"must have a viscoelastic material of {program}", "none")
    if name is None:
        if len(found) > 1:
            raise InvalidInput("name", "must be given for a text with several viscoelastic materials", names)
        return found[0]
    matching = [one for one in found if one.name.upper() == name.upper()]
    if len(matching) != 1:
        raise InvalidInput("name", f"must be that of one viscoelastic material, {names}", shown(name))
    return matching[0]


def _reference(found: Found, given: float, offset: float) -> float:
    """Return the reference temperature of a shift [K], or raise an error about its line and the unit."""
    try:
        return as_kelvin("reference_temperature", given + offset)
    except InvalidInput as error:
        if found.shift_line is None:
            raise
        hint = "" if offset else 'give temperature_unit="C" if the temperatures of the text are in °C'
        raise found.shift_line.error("must have a reference temperature >= 100 K", error.value).with_more(
            hint
        ) from None


def _constants(found: Found, program: str, offset: float) -> MaterialConstants:
    shift: WilliamsLandelFerry | Arrhenius | None = None
    if found.wlf is not None:
        c1, c2, reference = found.wlf
        shift = WilliamsLandelFerry(c1=c1, c2=c2, reference_temperature=_reference(found, reference, offset))
    if found.arrhenius is not None:
        energy, reference = found.arrhenius
        shift = Arrhenius(activation_energy=energy, reference_temperature=_reference(found, reference, offset))
    modulus = found.modulus
    stiffness = modulus.storage[-1] if isinstance(modulus, MasterCurve) else modulus.instantaneous_modulus
    notes = list(found.notes)
    if stiffness < _SOFTEST:
        notes.append(f"the largest shear modulus is {stiffness:.3g} Pa: give units= if the text is not in m, kg and s")
    return MaterialConstants(
        shear_modulus=modulus,
        poisson_ratio=found.poisson_ratio,
        bulk_modulus=found.bulk_modulus,
        shift=shift,
        density=found.density or None,
        name=" ".join(_label(found.name).split()) or "material",
        program=program,
        notes=tuple(notes),
    )
