"""Sliding of rough surfaces in TOML files, checked with pydantic (the extra `viscoroll[cli]`)."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from .._support.errors import InvalidInput
from .._support.progress import ProgressLike, counted
from .._support.result_warnings import silenced
from .._support.toml import read_toml
from ..bodies import CoatedPlane
from ..bodies.layered import materials_of, with_materials
from ..materials.shift import shift_factor, shifted
from ..sliding import RoughSurface, SlidingResult, slide
from .case import Kelvin, PlaneTable
from .moduli import Shift
from .tables import FileName, FileTables, StrictTable, checked, errors_in

__all__ = ["SlidingCase", "SlidingFile", "build_sliding", "load_sliding"]

#: Keys of a random surface, besides `cutoff` and `rms_height` or `rms_slope`.
_RANDOM = ("nodes", "side", "hurst", "rolloff", "seed")


class Surface(StrictTable):
    """The table `surface`: a file of heights, or a random self-affine surface.

    Parameters
    ----------
    file : str
        File of heights (.npy, .csv, .txt, .nc, or with format that of an instrument); see
        `viscoroll.RoughSurface.read`.
    format : str, optional
        Format of an instrument, such as sur or x3p.
    fill : bool, optional
        Whether to fill nodes of a file that were not measured.
    spacing : float, optional
        Distance of the nodes of a file [m]; required unless the file contains it.
    periodic : bool, optional
        Whether the surface of a file repeats itself; otherwise it is continued by its mirror images unless it is
        finite.
    finite : bool, optional
        Whether the layers are free around the surface of a file, which is then solved as it is.
    detrend : int, optional
        Degree of the polynomial that is subtracted from the heights of a file: 0, 1 or 2.
    cutoff : float, optional
        Shortest wavelength of the surface [m]. Required for a random surface; shorter waves of a file are removed.
    """

    documented_by = (RoughSurface.self_affine,)

    file: FileName | None = None
    format: str | None = None
    fill: bool = False
    spacing: float | None = None
    periodic: bool = False
    finite: bool = False
    detrend: int | None = None
    cutoff: float | None = None
    nodes: int | None = None
    side: float | None = None
    hurst: float | None = None
    rolloff: float | None = None
    rms_slope: float | None = None
    rms_height: float | None = None
    seed: int | None = None

    def surface(self) -> RoughSurface:
        """Return the surface, periodic unless it is finite."""
        random = [name for name in (*_RANDOM, "rms_slope", "rms_height") if getattr(self, name) is not None]
        if self.file is None:
            return self._random()
        if random:
            raise InvalidInput(f"surface.{random[0]}", "must be left out with file")
        if self.finite and self.periodic:
            raise InvalidInput("surface", "must not be both finite and periodic")
        try:
            found = RoughSurface.read(
                self.file, format=self.format, spacing=self.spacing, periodic=self.periodic, fill=self.fill
            )
            found = found if self.detrend is None else found.detrended(self.detrend)  # type: ignore[arg-type]
            found = found if found.periodic or self.finite else found.mirrored()
            return found if self.cutoff is None else found.cutoff(self.cutoff)
        except InvalidInput as error:
            raise error.inside("surface") from None

    def _random(self) -> RoughSurface:
        for name in ("format", "spacing", "detrend", "finite"):
            if getattr(self, name) not in (None, False):
                raise InvalidInput(f"surface.{name}", "must be left out without file")
        missing = [name for name in (*_RANDOM, "cutoff") if getattr(self, name) is None]
        if missing:
            raise InvalidInput(f"surface.{missing[0]}", "must be given without file")
        if (self.rms_slope is None) == (self.rms_height is None):
            raise InvalidInput("surface", "must have exactly one of rms_slope and rms_height without file")
        given = {name: getattr(self, name) for name in (*_RANDOM, "cutoff", "rms_slope", "rms_height")}
        try:
            return RoughSurface.self_affine(given.pop("nodes"), given.pop("side"), **given)
        except InvalidInput as error:
            raise error.inside("surface") from None


class Sliding(StrictTable):
    """The table `sliding`: pressure and speeds.

    Parameters
    ----------
    pressure : float, optional
        Mean pressure [Pa], > 0. Exactly one of pressure and load must be given.
    load : float, optional
        Load on one period, or on the finite surface [N], > 0.
    speed : float or list
        Sliding speed, or a list of speeds [m/s]. At 0 the layers are relaxed.
    temperature : float, optional
        Temperature of the layers [K]; needs shift. By default, that of the moduli in the file.
    shift : optional
        Law of the shift factor of all layers, same as in the table thermal.
    friction : float, optional
        Coulomb's coefficient of friction at the interface [-], ≥ 0.
    tolerance : float, optional
        Relative residual of the contact equations [-].
    """

    pressure: float | None = None
    load: float | None = None
    speed: float | list[float]
    temperature: Kelvin | None = None
    shift: Shift | None = None
    friction: float = 0.0
    tolerance: float = 1e-9

    def at_temperature(self, plane: CoatedPlane) -> CoatedPlane:
        """Return the plane with its moduli at the temperature."""
        if (self.temperature is None) != (self.shift is None):
            raise InvalidInput("sliding", "must have both temperature and shift, or neither")
        if self.temperature is None or self.shift is None:
            return plane
        factor = shift_factor(self.shift, self.temperature, "sliding.shift")
        materials = (replace(one, shear_modulus=shifted(one.shear_modulus, factor)) for one in materials_of(plane))
        return with_materials(plane, tuple(materials))


class SlidingFile(FileTables):
    """A file of a rough surface that slides on a plane."""

    surface: Surface
    plane: PlaneTable
    sliding: Sliding


@dataclass(frozen=True, slots=True, kw_only=True)
class SlidingCase:
    """A rough surface that slides at one speed or several, as a file describes it.

    Attributes
    ----------
    surface : RoughSurface
        Surface.
    on : CoatedPlane
        Plane.
    pressure, load : float or None
        Mean pressure [Pa], or load on one period or the finite surface [N].
    speeds : tuple of float
        Sliding speeds [m/s].
    friction : float
        Coefficient of friction at the interface [-].
    tolerance : float
        Relative residual.
    """

    surface: RoughSurface
    on: CoatedPlane
    pressure: float | None
    load: float | None
    speeds: tuple[float, ...]
    friction: float
    tolerance: float

    def arguments(self) -> dict[str, Any]:
        """Return the arguments of `viscoroll.slide` except the surface.

        Raises
        ------
        ValueError
            If the case has several speeds.
        """
        if len(self.speeds) > 1:
            raise InvalidInput("sliding.speed", "must be one number; several speeds belong to the table sweep")
        return {name: getattr(self, name) for name in ("on", "pressure", "load", "friction", "tolerance")} | {
            "speed": self.speeds[0]
        }

    def slide(self, *, progress: ProgressLike = None) -> list[SlidingResult]:
        """Solve the contact at every speed, without issuing the warnings, which the results contain."""
        results = []
        with silenced(), counted(progress, total=len(self.speeds), unit="speed") as advance:
            for speed in self.speeds:
                results.append(
                    slide(
                        self.surface,
                        on=self.on,
                        pressure=self.pressure,
                        load=self.load,
                        speed=speed,
                        friction=self.friction,
                        tolerance=self.tolerance,
                    )
                )
                advance()
        return results


def load_sliding(path: str | Path) -> SlidingCase:
    """Read a sliding case from a TOML file; ``viscoroll.case.example_text("sliding")`` is a commented example.

    Raises
    ------
    ValueError
        If the file is not valid. The message is one line and names the key in the file.
    OSError
        If the file cannot be read.
    """
    path = Path(path)
    with errors_in(path):
        return build_sliding(read_toml(path), path.parent)


def build_sliding(
    document: dict[str, Any], folder: Path | None, surfaces: dict[str, RoughSurface] | None = None
) -> SlidingCase:
    """Return the sliding case that the content of a file describes; parameters as in `viscoroll.case.build_case`.

    Surfaces that `surfaces` contains are not made again; new ones are added.
    """
    file = checked(SlidingFile, document, folder)
    sliding = file.sliding
    if (sliding.pressure is None) == (sliding.load is None):
        raise InvalidInput("sliding", "must have exactly one of pressure and load")
    speeds = sliding.speed if isinstance(sliding.speed, list) else [sliding.speed]
    if not speeds:
        raise InvalidInput("sliding.speed", "must have at least one speed", "[]")
    known = {} if surfaces is None else surfaces
    key = repr(document["surface"])
    if key not in known:
        known[key] = file.surface.surface()
    return SlidingCase(
        surface=known[key],
        on=sliding.at_temperature(file.plane),
        pressure=sliding.pressure,
        load=sliding.load,
        speeds=tuple(speeds),
        friction=sliding.friction,
        tolerance=sliding.tolerance,
    )
