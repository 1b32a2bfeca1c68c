"""Rolling resistance as a fitted function of load and speed, for programs that cannot run the solver."""

from __future__ import annotations

import json
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from .. import _core
from .._core import Extrapolation
from .._support.arguments import Floats, as_float, as_float_array, as_floats, as_member
from .._support.errors import InvalidInput, InvalidType
from .._support.extras import extra
from .._support.files import save, write_csv, write_netcdf, write_text
from .._support.text import one_line, shown

if TYPE_CHECKING:
    import xarray
    from numpy.typing import ArrayLike

__all__ = ["RollingResistance", "radius_of"]

#: Highest degree of the polynomials along each axis.
_HIGHEST_DEGREE = 10


@dataclass(frozen=True, slots=True, kw_only=True, eq=False, repr=False)
class RollingResistance:
    """Torque T(P, Ω) = power loss / Ω as a polynomial for ln T in ln P and ln Ω, with an error estimate.

    The torque follows from the dissipated power, not from the moment arm of the pressure: the two differ with friction
    or a force on the center. The C++ equivalent is ``viscoroll::RollingResistance``; nlohmann/json can read it from the
    .json file.

    Attributes
    ----------
    load, angular_speed : tuple of float
        Lower and upper end of the fitted ranges, [N] and [rad/s].
    radius : float
        Outer radius r_o of the body [m].
    coefficients : ndarray
        Coefficients of Chebyshev polynomials in ln P (rows) and ln Ω (columns), each mapped to [-1, 1].
    error, largest_error : float
        Root mean square and largest relative error of the points, each predicted by a fit without it [-].
    """

    load: tuple[float, float]
    angular_speed: tuple[float, float]
    radius: float
    coefficients: Floats
    error: float
    largest_error: float

    @classmethod
    def from_study(cls, study: xarray.Dataset) -> RollingResistance:
        """Fit the polynomial to a study over load and speed, and return it.

        Parameters
        ----------
        study : xarray.Dataset
            Dataset from `viscoroll.sweep` with the dimensions load and angular_speed, with at least three values each,
            and no other dimension of more than one value. No point may have failed.

        Returns
        -------
        RollingResistance
            Polynomial with the degrees that best predict left-out points.

        Raises
        ------
        ValueError
            For studies of rollers or of several radii, with other dimensions, too few values, or failed points.
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
        """Return the torque that resists the rotation, an odd function of the speed.

        Below the lowest fitted speed Ω₁, the torque is proportional to the speed, T(P, Ω₁) Ω/Ω₁. This is the limit for
        every material whose relaxation ends.

        Parameters
        ----------
        load, angular_speed : array_like
            Load P [N], ≥ 0, and angular speed Ω [rad/s], of either sign. The shapes must broadcast.
        outside : Extrapolation or str, default Extrapolation.ERROR
            Rule for loads outside the fitted range and speeds above it. ERROR rejects them. HOLD uses T/P of the
            nearest load and speed in the range; the torque is then 0 at P = 0, for a lifted body.

        Returns
        -------
        ndarray
            Power loss divided by angular speed, with the sign of Ω [N m].

        Raises
        ------
        ValueError
            Outside the range, if `outside` is ERROR.
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
        """Write the fit as .json, for `load_file`, or a table of 41 by 41 torques as .nc or .csv.

        Parameters
        ----------
        path : path-like
            Path of the file; its suffix selects the format.

        Raises
        ------
        ValueError
            For another suffix.
        """
        save(self, path, _FORMATS)

    @classmethod
    def load_file(cls, path: str | Path) -> RollingResistance:
        """Read a fit from a .json file that `save` wrote.

        Parameters
        ----------
        path : path-like
            Path of the .json file.

        Returns
        -------
        RollingResistance
            The fit that was saved.

        Raises
        ------
        ValueError
            If the file has other content.
        """
        wanted = f"{path} must contain a rolling resistance saved by viscoroll"
        try:
            found = _core.RollingResistance(**_numbers(json.loads(Path(path).read_text(encoding="utf-8"))))
        except KeyError as error:
            raise ValueError(f"{wanted} ({error} is missing)") from None
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
        """Return `count` by `count` torques [N m] over load [N] and angular_speed [rad/s], spaced geometrically."""
        with extra("studies"):
            import xarray

        loads, speeds = np.geomspace(*self.load, count), np.geomspace(*self.angular_speed, count)
        loads[[0, -1]], speeds[[0, -1]] = self.load, self.angular_speed
        torque = self(loads[:, None], speeds)
        return xarray.Dataset(
            {
                "torque": (
                    ("load", "angular_speed"),
                    torque,
                    {"units": "N m", "long_name": "power dissipated per angular speed"},
                )
            },
            {"load": ("load", loads, {"units": "N"}), "angular_speed": ("angular_speed", speeds, {"units": "rad/s"})},
            attrs={"outer_radius": self.radius, "error": self.error, "largest_error": self.largest_error},
        )

    def __repr__(self) -> str:
        """Return a text with ranges, errors and the behavior below the lowest speed."""
        return (
            f"RollingResistance over {self.load[0]:g} to {self.load[1]:g} N and {self.angular_speed[0]:g} to "
            f"{self.angular_speed[1]:g} rad/s, radius {self.radius:g} m: error {self.error:.2%}, "
            f"largest {self.largest_error:.2%}; below the lowest speed proportional to the speed (exponent of the "
            f"fit there {self._exponent_at_lowest_speed():.2f})"
        )

    def _exponent_at_lowest_speed(self) -> float:
        """Return d ln T / d ln Ω at the lowest speed and middle load: 1 if the torque is proportional to Ω there."""
        slopes = np.polynomial.chebyshev.chebder(self.coefficients, axis=1)
        slope = np.polynomial.chebyshev.chebval2d(0.0, -1.0, slopes)
        return float(slope * 2.0 / np.log(self.angular_speed[1] / self.angular_speed[0]))


def _numbers(document: object) -> dict[str, Any]:
    """Return the numbers of a fit from the content of a JSON file, by name."""
    if not isinstance(document, dict):
        raise TypeError(f"the file must be a JSON object, got {shown(document)}")
    ranges = {name: as_floats(name, document[name]) for name in ("load", "angular_speed")}
    for name, ends in ranges.items():
        if len(ends) != 2:
            raise InvalidInput(name, "must be the two ends of a range", shown(document[name]))
    rows = document["coefficients"]
    if not isinstance(rows, list):
        raise InvalidType("coefficients", "must be a list of rows", shown(rows))
    coefficients = [as_floats(f"coefficients[{index}]", row) for index, row in enumerate(rows)]
    numbers = {name: as_float(name, document[name]) for name in ("radius", "error", "largest_error")}
    return {**ranges, "coefficients": coefficients, **numbers}


def _write_json(surface: RollingResistance, path: Path) -> None:
    what = "ln T = sum c_ij T_i(x) T_j(y), x and y the logarithms of load and speed mapped to [-1, 1]"
    document = {"what": what, **asdict(surface), "coefficients": surface.coefficients.tolist()}
    write_text(json.dumps(document, indent=1), path)


def _write_table(surface: RollingResistance, path: Path) -> None:
    """Write a CSV file with one row for each pair of load and speed."""
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
        raise InvalidInput("study", "must be for a ball or a wheel, with loads in N", "loads in N/m, as for rollers")
    for name in ("load", "angular_speed"):
        if name not in power.dims or power.sizes[name] < 3:
            raise InvalidInput("study", f"must have at least 3 values of {name}", power.sizes.get(name, 1))
    if more := [str(name) for name in power.dims if name not in ("load", "angular_speed") and power.sizes[name] > 1]:
        raise InvalidInput("study", "must vary only load and angular_speed", f"also {', '.join(more)}")
    power = power.squeeze([n for n in power.dims if n not in ("load", "angular_speed")])
    power = power.transpose("load", "angular_speed").sortby(["load", "angular_speed"])
    load, speed = power["load"].values.astype(float), power["angular_speed"].values.astype(float)
    torque = power.values / speed
    if not (torque > 0.0).all():
        raise InvalidInput(
            "study", "must have dissipated power > 0 W at every point", f"{int((~(torque > 0.0)).sum())} other points"
        )
    return torque, load, speed


def radius_of(study: xarray.Dataset) -> float:
    """Return the outer radius: center height plus penetration, less the centrifugal displacement [m]."""
    radius = (study["center_height"] + study["penetration"] - study["centrifugal_displacement"]).values
    if not np.ptp(radius) <= 1e-9 * radius.max():
        raise InvalidInput("study", "must have one outer radius", f"radii from {radius.min():g} to {radius.max():g} m")
    return float(radius.flat[0])


def _fitted(load: Floats, speed: Floats, values: Floats, rows: int, columns: int) -> tuple[Floats, float, float]:
    """Return the coefficients of a fit of given degrees, and root mean square and maximum of its errors [-].

    The error of each point is the relative error with which a fit to all other points predicts it.
    """
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
