"""Materials from measurements: reading, shifting, fitting and checking (requires the extra `viscoroll[studies]`)."""

from importlib import resources
from pathlib import Path

from .._support.errors import InvalidInput
from .checks import Check, check_modulus, check_range, rolling_range
from .hardness import hardness_to_modulus, rebound_to_loss_factor
from .material_file import load_material, save_material
from .network_fit import NetworkFit, fit_network
from .prony_fit import PronyFit, fit_prony
from .published import PublishedMaterial, example_material
from .ramps import TemperatureRamp
from .reading import Isotherm, RheologyData, read_rheology
from .shift_laws import ShiftFactors, ShiftLaw
from .shifting import superpose
from .spectrum_fit import SpectrumFit, fit_spectrum
from .strain_sweeps import read_strain_sweep
from .superposition import Superposition
from .time_tests import TimeData, TimeTest, read_time_tests

__all__ = [
    "Check",
    "Isotherm",
    "NetworkFit",
    "PronyFit",
    "PublishedMaterial",
    "RheologyData",
    "ShiftFactors",
    "ShiftLaw",
    "SpectrumFit",
    "Superposition",
    "TemperatureRamp",
    "TimeData",
    "TimeTest",
    "check_modulus",
    "check_range",
    "example_data",
    "example_material",
    "fit_network",
    "fit_prony",
    "fit_spectrum",
    "hardness_to_modulus",
    "load_material",
    "read_rheology",
    "read_strain_sweep",
    "read_time_tests",
    "rebound_to_loss_factor",
    "rolling_range",
    "save_material",
    "superpose",
]


def example_data(name: str) -> Path:
    """Return the path of a file of measured data that is part of the package.

    Parameters
    ----------
    name : {"pressure_sensitive_adhesive.txt"}
        Name of the file: frequency sweeps of a pressure-sensitive adhesive from -40 to 150 °C, exported by TA's TRIOS.
        Its license is in the same folder.

    Raises
    ------
    ValueError
        If there is no such file.
    """
    path = Path(str(resources.files("viscoroll").joinpath("examples", name)))
    if name not in ("pressure_sensitive_adhesive.txt",):
        raise InvalidInput("name", "must be 'pressure_sensitive_adhesive.txt'", repr(name))
    return path
