"""Rolling resistance as a fitted surface over load and speed, for programs that cannot solve for it."""

from __future__ import annotations

import json
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from .. import _core
from .._core import Extrapolation
from .._support.arguments import Floats, as_float, as_float_array, as_floats, as_member
from .._support.extras import extra
from .._support.files import save, write_csv, write_netcdf, write_text
from .._support.text import one_line, shown

if TYPE_CHECKING:
    import xarray
    from numpy.typing import ArrayLike

__all__ = ["RollingResistance", "radius_of"]

#: Highest degree that is tried along either axis.
_HIGHEST_DEGREE = 10


@dataclass(frozen=True, slots=True, kw_only=True, eq=False, repr=False)
class RollingResistance:
    """Torque T(P, Ω) = power lost / Ω, a polynomial of ln P and ln Ω for ln T, with its error.

    From the power lost, not from the pressure's offset: with friction or a force on the center these differ. In C++
    it is ``viscoroll::RollingResistance``, which nlohmann/json gets from the .json file.

    Attributes
    ----------
    load, angular_speed : tuple of float
        From and to, [N] and [rad/s].
    radius : float
        r_o [m].
    coefficients : ndarray
        Of Chebyshev polynomials of ln P (rows) and ln Ω (columns), each mapped to [-1, 1].
    error, largest_error : float
        Root mean square and largest relative error of points that were left out of the fit one by one [-].
    """

    load: tuple[float, float]
    angular_speed: tuple[float, float]
    radius: float
    coefficients: Floats
    error: float
    largest_error: float

    @classmethod
    def from_study(cls, study: xarray.Dataset) -> RollingResistance:
        """Fit the surface to a study over load and speed.

        Parameters
        ----------
        study : xarray.Dataset
            Of `viscoroll.sweep`, with the dimensions load and angular_speed, at least three values each, and no other
            of more than one value; no point may have failed.

        Returns
        -------
        RollingResistance
            The polynomial of the degrees that predict left-out points best.

        Raises
        ------
        ValueError
            For rollers, other dimensions, too few values, several balls, and points that failed.
        """
        torque, load, speed = _points(study)
        radius = float(study.attrs["outer_radius"]) if "outer_radius" in study.attrs else radius_of(study)
        best = None
        for rows in range(1, min(load.size - 1, _HIGHEST_DEGREE + 1)):
            for columns in range(1, min(speed.size - 1, _HIGHEST_DEGREE + 1)):
                fit = _fitted(load, speed, np.log(torque), rows, columns)
                if best is None or fit[1] < best[1]:
                    best = fit
        assert best is not None
        coefficients, error, largest = best
        return cls(
            load=(float(load[0]), float(load[-1])),
            angular_speed=(float(speed[0]), float(speed[-1])),
            radius=radius,
            coefficients=coefficients,
            error=error,
            largest_error=largest,
        )

    def __call__(
        self, load: ArrayLike, angular_speed: ArrayLike, *, outside: Extrapolation | str = Extrapolation.ERROR
    ) -> Floats:
        """Evaluate the torque against the turning, odd in the speed.

        Below the lowest speed that was fitted, Ω₁, it goes to 0 in proportion to the speed, T(P, Ω₁) Ω/Ω₁: so it does
        in the end for every material whose relaxation ends.

        Parameters
        ----------
        load, angular_speed : array_like
            P [N], ≥ 0, and Ω [rad/s], of either sign, of shapes that broadcast.
        outside : Extrapolation or str, default Extrapolation.ERROR
            Loads outside the fitted range and speeds above it are refused (ERROR), or have T/P of the nearest load and
            speed within (HOLD): a lifted ball, P = 0, then has no torque.

        Returns
        -------
        ndarray
            Power lost per speed, of the sign of Ω [N m].

        Raises
        ------
        ValueError
            Outside the range, where that is refused.
        """
        loads, speeds = np.broadcast_arrays(
            as_float_array("load", load), as_float_array("angular_speed", angular_speed)
        )
        torques = self._to_core().torques(
            loads.flatten(), speeds.flatten(), as_member("outside", outside, Extrapolation)
        )
        return np.asarray(torques.reshape(loads.shape))

    def _to_core(self) -> _core.RollingResistance:
        return _core.RollingResistance(
            load=self.load,
            angular_speed=self.angular_speed,
            radius=self.radius,
            coefficients=self.coefficients.tolist(),
            error=self.error,
            largest_error=self.largest_error,
        )

    def save(self, path: str | Path) -> None:
        """Write the surface: .json holds all that `load_file` reads, .nc and .csv a table of 41 by 41 torques.

        Raises
        ------
        ValueError
            For another suffix.
        """
        save(self, path, _FORMATS)

    @classmethod
    def load_file(cls, path: str | Path) -> RollingResistance:
        """Read a surface from the .json file that `save` wrote.

        Raises
        ------
        ValueError
            Where the file holds something else.
        """
        wanted = f"{path} must hold a rolling resistance of viscoroll"
        try:
            found = _core.RollingResistance(**_numbers(json.loads(Path(path).read_text(encoding="utf-8"))))
        except KeyError as error:
            raise ValueError(f"{wanted} (without a value of {error})") from None
        except RecursionError:
            raise ValueError(f"{wanted} (nested too deeply)") from None
        except (TypeError, ValueError) as error:
            raise ValueError(one_line(f"{wanted} ({error})")) from None
        return cls(
            load=(found.load[0], found.load[1]),
            angular_speed=(found.angular_speed[0], found.angular_speed[1]),
            radius=found.radius,
            coefficients=np.array(found.coefficients),
            error=found.error,
            largest_error=found.largest_error,
        )

    def to_xarray(self, *, count: int = 41) -> xarray.Dataset:
        """Return `count` by `count` torques [N m] over load [N] and angular_speed [rad/s], at equal ratios."""
        with extra("studies"):
            import xarray

        loads, speeds = np.geomspace(*self.load, count), np.geomspace(*self.angular_speed, count)
        loads[[0, -1]], speeds[[0, -1]] = self.load, self.angular_speed
        torque = self(loads[:, None], speeds)
        return xarray.Dataset(
            {"torque": (("load", "angular_speed"), torque, {"units": "N m", "long_name": "power lost per speed"})},
            {"load": ("load", loads, {"units": "N"}), "angular_speed": ("angular_speed", speeds, {"units": "rad/s"})},
            attrs={"outer_radius": self.radius, "error": self.error, "largest_error": self.largest_error},
        )

    def __repr__(self) -> str:
        """Return ranges, error, and what happens towards rest."""
        return (
            f"RollingResistance over {self.load[0]:g} to {self.load[1]:g} N and {self.angular_speed[0]:g} to "
            f"{self.angular_speed[1]:g} rad/s, radius {self.radius:g} m: error {self.error:.2%}, "
            f"{self.largest_error:.2%} at most; slower in proportion to the speed, where the fit has its power "
            f"{self._power_at_lowest_speed():.2f}"
        )

    def _power_at_lowest_speed(self) -> float:
        """Return d ln T / d ln Ω there, at the middle of the loads: 1 where the torque is in proportion already."""
        slopes = np.polynomial.chebyshev.chebder(self.coefficients, axis=1)
        of_mapped = np.polynomial.chebyshev.chebval2d(0.0, -1.0, slopes)
        return float(of_mapped * 2.0 / np.log(self.angular_speed[1] / self.angular_speed[0]))


def _numbers(document: object) -> dict[str, Any]:
    """Return the numbers of a surface in the content of a JSON file, by name."""
    if not isinstance(document, dict):
        raise TypeError(f"the file must be an object with names, got {shown(document)}")
    ranges = {name: as_floats(name, document[name]) for name in ("load", "angular_speed")}
    for name, ends in ranges.items():
        if len(ends) != 2:
            raise ValueError(f"{name} must hold the two ends of a range, got {shown(document[name])}")
    rows = document["coefficients"]
    if not isinstance(rows, list):
        raise TypeError(f"coefficients must be a list of rows, got {shown(rows)}")
    coefficients = [as_floats(f"coefficients[{index}]", row) for index, row in enumerate(rows)]
    numbers = {name: as_float(name, document[name]) for name in ("radius", "error", "largest_error")}
    return {**ranges, "coefficients": coefficients, **numbers}


def _write_json(surface: RollingResistance, path: Path) -> None:
    what = "ln T = sum c_ij T_i(x) T_j(y), x and y the logarithms of load and speed mapped to [-1, 1]"
    document = {"what": what, **asdict(surface), "coefficients": surface.coefficients.tolist()}
    write_text(json.dumps(document, indent=1), path)


def _write_table(surface: RollingResistance, path: Path) -> None:
    """Write a row for each pair of load and speed."""
    torque = surface.to_xarray()["torque"]
    load, speed = (
        values.ravel().tolist() for values in np.meshgrid(torque["load"], torque["angular_speed"], indexing="ij")
    )
    columns = {"load [N]": load, "angular_speed [rad/s]": speed, "torque [N m]": torque.to_numpy().ravel().tolist()}
    write_csv(columns, path)


_FORMATS = {
    ".json": _write_json,
    ".nc": lambda surface, path: write_netcdf(surface.to_xarray(), path),
    ".csv": _write_table,
}


def _points(study: xarray.Dataset) -> tuple[Floats, Floats, Floats]:
    power = study["dissipated_power"]
    if study["load"].attrs.get("units") == "N/m":
        raise ValueError("study must be of a ball or wheel, whose load is in N, got loads in N/m, as of rollers")
    for name in ("load", "angular_speed"):
        if name not in power.dims or power.sizes[name] < 3:
            raise ValueError(f"study must have at least 3 values of {name}, got {power.sizes.get(name, 1)}")
    if more := [str(name) for name in power.dims if name not in ("load", "angular_speed") and power.sizes[name] > 1]:
        raise ValueError(f"study must vary load and angular_speed alone, got {', '.join(more)} too")
    power = power.squeeze([n for n in power.dims if n not in ("load", "angular_speed")])
    power = power.transpose("load", "angular_speed").sortby(["load", "angular_speed"])
    load, speed = power["load"].values.astype(float), power["angular_speed"].values.astype(float)
    torque = power.values / speed
    if not (torque > 0.0).all():
        raise ValueError(
            f"study must have a power lost > 0 W at every point, got {int((~(torque > 0.0)).sum())} others"
        )
    return torque, load, speed


def radius_of(study: xarray.Dataset) -> float:
    """Return r_o = H + penetration."""
    radius = (study["center_height"] + study["penetration"] - study["centrifugal_displacement"]).values
    if not np.ptp(radius) <= 1e-9 * radius.max():
        raise ValueError(f"study must have one ball, got radii from {radius.min():g} to {radius.max():g} m")
    return float(radius.flat[0])


def _fitted(load: Floats, speed: Floats, values: Floats, rows: int, columns: int) -> tuple[Floats, float, float]:
    """Return coefficients, and root mean square and largest of the errors of left-out points."""
    matrices = []
    for points, degree in ((load, rows), (speed, columns)):
        x = _mapped(points, points[0], points[-1])
        matrices.append(np.polynomial.chebyshev.chebvander(x, degree))
    a, b = matrices
    inverse_a, inverse_b = np.linalg.pinv(a), np.linalg.pinv(b)
    coefficients = inverse_a @ values @ inverse_b.T
    residual = a @ coefficients @ b.T - values
    leverage = np.outer(np.einsum("ij,ji->i", a, inverse_a), np.einsum("ij,ji->i", b, inverse_b))
    left_out = np.expm1(residual / np.maximum(1.0 - leverage, 1e-9))
    return coefficients, float(np.sqrt(np.mean(left_out**2))), float(np.abs(left_out).max())


def _mapped(values: Floats, low: float, high: float) -> Floats:
    return np.asarray(2.0 * np.log(values / low) / np.log(high / low) - 1.0)
