"""Result of rolling with filled rubber, whose moduli depend on strain: numbers, tables, files and pictures."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Literal, TypeAlias

import numpy as np

from .._support.errors import InvalidInput
from .._support.extras import extra
from .._support.files import save, write_csv, write_netcdf
from .._support.plotting import plots
from .._support.tables import handy, html_table, number_text, unit_text
from .._support.text import shown
from ..solution.inside import Of, inside_of
from ..solution.text import scalar_text
from .softened_state import SofteningLayer, State

if TYPE_CHECKING:
    import xarray
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from ..rolling import Result

__all__ = ["BOUNDS", "NetworkLoss", "StrainSoftening", "as_network_loss"]

#: Labels of the two torques of filled rubber in files and studies, in the order of `StrainSoftening.torque_bounds`.
BOUNDS = {
    "harmonic_torque": "resisting torque with the network loss summed over harmonics",
    "network_torque": "resisting torque with the loss of a rate-independent network",
}

#: Loss of a network: that of a rate-independent network, or the sum over harmonics.
NetworkLoss: TypeAlias = Literal["network", "harmonic"]


def as_network_loss(name: str, value: object) -> NetworkLoss:
    """Return the given kind of loss of a network.

    Raises
    ------
    ValueError
        If it is not one of the two kinds.
    """
    if value not in ("network", "harmonic"):
        raise InvalidInput(name, "must be 'network' or 'harmonic'", shown(value))
    return value


@dataclass(frozen=True, slots=True, kw_only=True, eq=False, repr=False)
class StrainSoftening:
    """Rolling with moduli that depend on the strain of the solution.

    Values of layers are those of the layers that soften: first those of the rolling body from the inside outwards, then
    those of the counterbody, its base first. With `sublayers`, the parts count as layers.

    Attributes
    ----------
    result : Result
        Contact solved with the moduli found.
    loss : str
        Loss of the network, "network" or "harmonic".
    layer_amplitudes : tuple of float
        ḡ, amplitude of shear strain at which each modulus is evaluated: the mean weighted by the network's loss [-].
    largest_amplitudes : tuple of float
        Largest amplitude in each layer [-].
    layer_moduli : tuple of (float, float)
        N' and N'' at ḡ [Pa], before the loss scale is applied to N''.
    loss_scales : tuple of float
        c, factor on N'' with which the harmonics dissipate as much as the network [-]; 1 with "harmonic".
    network_share : float
        Fraction of the loss of these layers by shear that is due to the network [-].
    torque_bounds : (float, float)
        Resisting torques [N m], for rollers [N m/m]: with the loss of the network summed over harmonics, as in the tire
        industry, and with that of a rate-independent network. The true torque may lie outside: the effect of rotating
        strain axes is unknown.
    iterations : int
        Number of contacts solved.
    history : tuple of tuple of float
        Amplitudes found in each pass [-].
    warnings : tuple of str
        Texts of the warnings that were issued.
    """

    result: Result
    loss: NetworkLoss
    layer_amplitudes: tuple[float, ...]
    largest_amplitudes: tuple[float, ...]
    layer_moduli: tuple[tuple[float, float], ...]
    loss_scales: tuple[float, ...]
    network_share: float
    torque_bounds: tuple[float, float]
    iterations: int
    history: tuple[tuple[float, ...], ...]
    warnings: tuple[str, ...]
    _layers: tuple[SofteningLayer, ...]
    _state: State | None

    @property
    def bounds(self) -> dict[str, float]:
        """Both torques by their names in files and studies; see `BOUNDS`."""
        return dict(zip(BOUNDS, self.torque_bounds, strict=True))

    def amplitude(self, *, of: Of | None = None) -> xarray.Dataset:
        """Return the amplitude of strain over the cross-section.

        Parameters
        ----------
        of : "body" or "counterbody", optional
            Rolling body or counterbody; by default the first body with a layer that softens.

        Returns
        -------
        xarray.Dataset
            `amplitude` [-] over (depth, theta) in the layers that soften, with the number of the `layer` and the arc
            `z` sideways [m].

        Raises
        ------
        ValueError
            If that body has no layer that softens.
        """
        with extra("files"):
            import xarray

        known = {layer.of for layer in self._layers}
        if self._state is None or (of is not None and of not in known):
            raise InvalidInput("of", "must be a body with a layer that softens with strain", shown(of))
        body = self._layers[0].of if of is None else of
        inside = inside_of(self.result, body)
        chosen = [found for found, layer in zip(self._state.layers, self._layers, strict=True) if layer.of == body]
        theta = np.unique(chosen[0].path.theta)
        values = np.concatenate([found.amplitudes.reshape(-1, len(theta)) for found in reversed(chosen)])
        depth = np.concatenate([found.path.depth[:: len(theta)] for found in reversed(chosen)])
        layers = [found.path.layer for found in reversed(chosen) for _ in found.path.depth[:: len(theta)]]
        return xarray.Dataset(
            {"amplitude": (("depth", "theta"), values, {"units": "1", "long_name": "amplitude of shear strain"})},
            {
                "depth": ("depth", depth, {"units": "m"}),
                "layer": ("depth", layers),
                "theta": ("theta", theta, {"units": "rad"}),
                "z": (
                    "theta",
                    inside.radius * (0.5 * np.pi - theta),
                    {"units": "m", "long_name": "arc length sideways"},
                ),
            },
            attrs={"of": body, "resisting_torque": self.result.resisting_torque},
        )

    def rows(self) -> list[tuple[str, float, str]]:
        """Return the results as name, value and SI unit, layer by layer."""
        torque = self.result.unit("resisting_torque")
        rows = [
            ("resisting_torque", self.result.resisting_torque, torque),
            *((name, value, torque) for name, value in self.bounds.items()),
            ("network_share", self.network_share, "1"),
        ]
        for j, (storage, loss) in enumerate(self.layer_moduli):
            prefix = f"layer_{j}_"
            rows += [
                (f"{prefix}amplitude", self.layer_amplitudes[j], "1"),
                (f"{prefix}largest_amplitude", self.largest_amplitudes[j], "1"),
                (f"{prefix}storage", storage, "Pa"),
                (f"{prefix}loss", loss, "Pa"),
                (f"{prefix}loss_scale", self.loss_scales[j], "1"),
            ]
        return rows

    def save(self, path: str | Path) -> None:
        """Write the results to a file.

        Parameters
        ----------
        path : path-like
            ``.csv`` (one row per number, with its unit) or ``.nc`` (amplitudes over the section, with these numbers as
            attributes).

        Raises
        ------
        ValueError
            If the suffix is another one.
        ImportError
            If the extra `viscoroll[files]` is missing, for ``.nc``.
        """
        save(self, path, _FORMATS)

    @plots("only the network")
    def plot(self, ax: Axes | None = None) -> Figure | Axes:
        """Draw the moduli of the network over strain with operating points, and the amplitude over the section.

        The method raises a ValueError if no layer softens.
        """
        from .softening_picture import OperatingPoint, plot_softening

        if self._state is None:
            raise ValueError("the picture requires a layer that softens with strain, got linear layers only")
        values = zip(self._layers, self.layer_amplitudes, self.largest_amplitudes, strict=True)
        points = [OperatingPoint(layer.modulus.network, amplitude, largest) for layer, amplitude, largest in values]
        return plot_softening(points, self.amplitude(), ax)

    def __repr__(self) -> str:
        """Return a summary that fits on one screen."""
        (torque, harmonic, matched), unit = handy(
            [self.result.resisting_torque, *self.torque_bounds], self.result.unit("resisting_torque")
        )
        lines = [
            f"StrainSoftening at P = {scalar_text(self.result, 'load')}, "
            f"Ω = {self.result.angular_speed:g} rad/s ({self.iterations} contacts solved):",
            f"  resisting torque T_r   {torque} {unit} (loss: {self.loss})",
            f"  its estimates          {harmonic} (harmonic sum), {matched} {unit} (network)",
            f"  network                {self.network_share:.1%} of the shear loss of these layers",
        ]
        for j, (storage, loss) in enumerate(self.layer_moduli):
            lines.append(
                f"  {self._layers[j].of} layer {self._layers[j].number:<10} strain {self.layer_amplitudes[j]:.3%}, "
                f"largest {self.largest_amplitudes[j]:.3%}: N' = {storage:.4g} Pa, N'' = {self.loss_scales[j]:.3f} · "
                f"{loss:.4g} Pa"
            )
        return "\n".join([*lines, *(f"  warning                {text}" for text in self.warnings)])

    def _repr_html_(self) -> str:
        """Return the results as a table for notebooks."""
        rows = [(name.replace("_", " "), number_text(value), unit_text(unit)) for name, value, unit in self.rows()]
        return html_table("Strain softening", rows)


def _write_table(found: StrainSoftening, path: Path) -> None:
    names, values, units = zip(*found.rows(), strict=True)
    write_csv({"quantity": names, "value": values, "unit": units}, path)


def _write_section(found: StrainSoftening, path: Path) -> None:
    write_netcdf(found.amplitude().assign_attrs({name: value for name, value, _ in found.rows()}), path)


#: Functions that write the results, by suffix.
_FORMATS = {".csv": _write_table, ".nc": _write_section}
