"""Published measurements of materials, for use without a measurement of one's own."""

from __future__ import annotations

from dataclasses import dataclass
from importlib import resources
from pathlib import Path
from textwrap import fill
from typing import Any

import numpy as np

from .._support.arguments import as_kelvin
from .._support.celsius import kelvin_range, kelvin_text
from .._support.errors import InvalidInput
from .._support.text import shown
from .._support.toml import read_toml
from ..materials import LossFactor, MasterCurve, Prony
from .material_file import load_material
from .ramps import TemperatureRamp

__all__ = ["EXAMPLES", "PublishedMaterial", "example_material"]

#: Difference between nominal and actual temperature of a sweep [K].
_DRIFT = 0.5

#: Width of a line of the description [characters].
_WIDTH = 92

#: Names of the published materials.
EXAMPLES = ("pressure_sensitive_adhesive", "vinyl_nitrile_foam")


@dataclass(frozen=True, slots=True, kw_only=True, eq=False, repr=False)
class PublishedMaterial:
    """Material that one laboratory measured and published; other samples, or those of other makers, may differ.

    Attributes
    ----------
    name : str
        Name that `example_material` accepts.
    what, citation, address, license : str
        Description of the material, its publication, the address of the data, and their license.
    measured : str
        Measured quantities, method and range.
    not_measured : tuple of str
        Quantities that were not measured and must be assumed.
    temperature : (float, float)
        Lowest and highest temperature of the measurement [K].
    poisson_ratio : float or None
        Measured Poisson's ratio [-]; None if it was not measured.
    """

    name: str
    what: str
    citation: str
    address: str
    license: str
    measured: str
    not_measured: tuple[str, ...]
    temperature: tuple[float, float]
    poisson_ratio: float | None
    _path: Path
    _document: dict[str, Any]

    def at(self, *, temperature: float) -> MasterCurve | Prony | LossFactor:
        """Return the shear modulus at a temperature.

        Parameters
        ----------
        temperature : float
            Temperature [K], within the measured range. Between measured temperatures, the logarithms of times or
            moduli are interpolated.

        Raises
        ------
        ValueError
            If the temperature is outside the measured range.
        """
        kelvin = as_kelvin("temperature", temperature)
        low, high = self.temperature
        if not low - _DRIFT <= kelvin <= high + _DRIFT:
            raise InvalidInput(
                "temperature",
                f"must be in the measured range of {self.name}, {kelvin_range(low, high)}",
                f"{kelvin_text(kelvin)}",
            )
        if "tensile_ramp" in self._document:
            return self._ramp().at(temperature=min(max(kelvin, low), high))
        return load_material(self._path, temperature=kelvin)

    def _ramp(self) -> TemperatureRamp:
        table = self._document["tensile_ramp"]
        assert self.poisson_ratio is not None
        storage, loss = (np.asarray(table[name]) / (2.0 * (1.0 + self.poisson_ratio)) for name in ("storage", "loss"))
        return TemperatureRamp(
            frequency=table["frequency"], temperature=np.asarray(table["temperature"]), storage=storage, loss=loss
        )

    def __repr__(self) -> str:
        """Return a description with source, license, measured range and unknowns."""
        low, high = self.temperature
        known = "not measured" if self.poisson_ratio is None else f"{self.poisson_ratio:.4g}"
        told = [
            ("citation", self.citation),
            ("source", self.address),
            ("license", self.license),
            ("measured", self.measured),
            *(("not measured", text) for text in self.not_measured),
        ]
        head = f"{self.name}: {self.what},\n  {kelvin_range(low, high)}, Poisson's ratio {known}"
        return "\n".join([head, *(_wrapped(f"  {name:14}", text) for name, text in told)])


def _wrapped(name: str, text: str) -> str:
    return fill(text, _WIDTH, initial_indent=name, subsequent_indent=" " * len(name), break_on_hyphens=False)


def example_material(name: str) -> PublishedMaterial:
    """Return a published material with its citation, its range and the quantities that were not measured.

    Parameters
    ----------
    name : {"pressure_sensitive_adhesive", "vinyl_nitrile_foam"}
        Name of the material. The page "Published materials" describes each.

    Returns
    -------
    PublishedMaterial
        The material; its ``at(temperature=...)`` is the shear modulus of a layer.

    Raises
    ------
    ValueError
        If the name is unknown.

    Examples
    --------
    >>> adhesive = example_material("pressure_sensitive_adhesive")
    >>> modulus = adhesive.at(temperature=293.15).complex_modulus(10.0)
    >>> print(f"{modulus.real / 1e3:.0f} kPa, tan delta {modulus.imag / modulus.real:.2f}")
    314 kPa, tan delta 1.00
    """
    if name not in EXAMPLES:
        raise InvalidInput("name", f"must be one of {', '.join(EXAMPLES)}", shown(name))
    path = Path(str(resources.files("viscoroll").joinpath("examples", "materials", f"{name}.toml")))
    document = read_toml(path)
    kelvin = document["tensile_ramp" if "tensile_ramp" in document else "shift"]["temperature"]
    texts = {key: document[key] for key in ("what", "citation", "address", "license", "measured")}
    return PublishedMaterial(
        name=name,
        **texts,
        not_measured=tuple(document["not_measured"]),
        temperature=(float(kelvin[0]), float(kelvin[-1])),
        poisson_ratio=document.get("poisson_ratio"),
        _path=path,
        _document=document,
    )
