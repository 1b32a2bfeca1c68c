"""The license of what is distributed: sources are under the MIT license, a wheel also under those of what is inside."""

from __future__ import annotations

import os
from collections.abc import Mapping
from typing import Any

INSIDE = {  # of every wheel: headers of Eigen and pybind11
    "MIT": "LICENSE",
    "BSD-3-Clause": "licenses/pybind11.txt",
    "MPL-2.0": "licenses/Eigen.txt",
}
TRANSFORMS = {
    "FFTW": {"GPL-2.0-or-later": "licenses/FFTW.txt"},
    "PocketFFT": {"BSD-3-Clause": "licenses/PocketFFT.txt"},
}


class Provider:
    """Gives `license` and `license-files` to scikit-build-core, by the transform that VISCOROLL_FFT names."""

    def __init__(self) -> None:
        self._of_sources = False

    def build_state(self, build_state: str) -> None:
        """Note what is built."""
        self._of_sources = build_state == "sdist"

    def dynamic_metadata(self, _settings: Mapping[str, Any], _project: Mapping[str, Any]) -> dict[str, Any]:
        """Return both fields."""
        transform = os.environ.get("VISCOROLL_FFT", "FFTW")
        if transform not in TRANSFORMS:
            raise ValueError(f"VISCOROLL_FFT must be one of {', '.join(TRANSFORMS)}, got {transform}")
        if self._of_sources:
            return {"license": "MIT", "license-files": ["LICENSE", "licenses/*"]}
        return {
            "license": " AND ".join(sorted(INSIDE.keys() | TRANSFORMS[transform].keys())),
            "license-files": [*INSIDE.values(), *TRANSFORMS[transform].values(), "licenses/README.md"],
        }

    def dynamic_wheel(self, _settings: Mapping[str, Any]) -> dict[str, bool]:
        """Say that a wheel has others than the sources."""
        return {"license": True, "license-files": True}
