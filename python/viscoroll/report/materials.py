"""Materials of a case file, with the sources of their moduli."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from .._support.celsius import kelvin_range, kelvin_text
from .._support.text import key_path_text
from ..materials import read_constants
from ..rheology import example_material, hardness_to_modulus, rebound_to_loss_factor
from ..rheology.material_file import material_summary

if TYPE_CHECKING:
    from .._support.least_squares import Parameter

__all__ = ["Material", "materials_of"]

#: Keys of tables that hold a modulus.
_MODULI = ("shear_modulus", "matrix", "network")


@dataclass(frozen=True, slots=True)
class Material:
    """A modulus of a case file.

    Attributes
    ----------
    place : str
        Path of its table in the file.
    kind : str
        Type of the modulus.
    rows : tuple of (str, str)
        Names and texts that describe its source.
    """

    place: str
    kind: str
    rows: tuple[tuple[str, str], ...]


def materials_of(document: Mapping[str, Any], folder: Path) -> list[Material]:
    """Return the moduli of a case file with those inside moduli that soften.

    Parameters
    ----------
    document : mapping
        Content of a valid file, with numbers in SI units in place of texts with units.
    folder : Path
        Folder of the file.
    """
    return [*_found(document, folder, ())]


def _found(value: Any, folder: Path, path: tuple[str | int, ...]) -> Iterator[Material]:
    if path and path[-1] in _MODULI:
        yield _material(value, folder, key_path_text(path))
    if isinstance(value, Mapping):
        for name, inner in value.items():
            yield from _found(inner, folder, (*path, name))
    elif isinstance(value, list):
        for index, inner in enumerate(value):
            yield from _found(inner, folder, (*path, index))


def _material(given: Any, folder: Path, place: str) -> Material:
    if isinstance(given, str):
        given = {"type": "measured", "file": given}
    elif not isinstance(given, Mapping):
        given = {"type": "elastic"}
    rows = _SOURCES.get(given["type"], _typed)(given, folder)
    if "temperature" in given:
        rows.append(("temperature", kelvin_text(float(given["temperature"]))))
    return Material(place, given["type"].replace("_", " "), tuple(rows))


def _typed(given: Mapping[str, Any], _folder: Path) -> list[tuple[str, str]]:
    return [("source", f"file {given['file']}" if "file" in given else "numbers in the case file")]


def _hardness(given: Mapping[str, Any], _folder: Path) -> list[tuple[str, str]]:
    scale = given.get("scale", "A")
    modulus = hardness_to_modulus(given["hardness"], scale=scale)
    rows = [
        ("source", f"estimate from a hardness of {given['hardness']:g} Shore {scale}"),
        ("shear modulus", _interval(modulus)),
    ]
    if "rebound" in given:
        loss_factor = _interval(rebound_to_loss_factor(given["rebound"]))
        rows.append(("loss factor", f"{loss_factor}, estimate from a rebound of {100.0 * given['rebound']:g} %"))
    return rows


def _interval(estimate: Parameter) -> str:
    unit, scale = ("", 1.0) if estimate.unit == "1" else (" MPa", 1e-6)
    best, lower, upper = (scale * value for value in (estimate.value, estimate.lower, estimate.upper))
    return f"{best:.3g}{unit}, in [{lower:.3g}, {upper:.3g}]{unit}"


def _published(given: Mapping[str, Any], _folder: Path) -> list[tuple[str, str]]:
    found = example_material(given["name"])
    return [
        ("material", found.what),
        ("citation", found.citation),
        ("address of the data", found.address),
        ("license", found.license),
        ("measured", found.measured),
        ("range", kelvin_range(*found.temperature)),
        *(("not measured", text) for text in found.not_measured),
    ]


def _measured(given: Mapping[str, Any], folder: Path) -> list[tuple[str, str]]:
    return [("file", given["file"]), *material_summary(folder / given["file"]).items()]


def _constants(given: Mapping[str, Any], folder: Path) -> list[tuple[str, str]]:
    options = {name: given[name] for name in ("name", "units", "temperature_unit", "relaxed_modulus") if name in given}
    found = read_constants(folder / given["file"], **options)
    rows = [("file", given["file"]), ("program", found.program or "unknown"), ("name", found.name)]
    return rows + [("note", note) for note in found.notes]


#: Functions that describe the source of a modulus, by its type.
_SOURCES = {"hardness": _hardness, "published": _published, "measured": _measured, "constants": _constants}
