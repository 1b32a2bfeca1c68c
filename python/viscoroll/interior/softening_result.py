"""What rolling of filled rubber with the moduli of its own strain is: numbers, tables, files, pictures."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Literal, TypeAlias

import numpy as np

from .._support.extras import extra
from .._support.files import save, write_csv, write_netcdf
from .._support.plotting import plots
from .._support.tables import html_table, number_text, unit_text
from .._support.text import shown
from ..solution.inside import Of, inside_of
from .softened_state import SofteningLayer, State

if TYPE_CHECKING:
    import xarray
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from ..rolling import Result

__all__ = ["BOUNDS", "Matching", "StrainSoftening", "as_matching"]

#: Both torques of filled rubber in files and studies, as `StrainSoftening.torque_bounds` has them: name and what it is.
BOUNDS = {
    "harmonic_torque": "resisting torque, the network's loss summed over harmonics",
    "network_torque": "resisting torque, the network's loss that of a network without rate",
}

#: How the loss of a network is taken: as a network without rate loses, or summed over harmonics.
Matching: TypeAlias = Literal["network", "harmonic"]


def as_matching(name: str, value: object) -> Matching:
    """Return how a network's loss is taken.

    Raises
    ------
    ValueError
        For another word.
    """
    if value not in ("network", "harmonic"):
        raise ValueError(f"{name} must be 'network' or 'harmonic', got {shown(value)}")
    return value


@dataclass(frozen=True, slots=True, kw_only=True, eq=False, repr=False)
class StrainSoftening:
    """Rolling with the moduli that belong to its own strain.

    Values of layers are those of the layers that soften, of what rolls from the inside outwards, then of what it rolls
    on, its base first; with `sublayers`, of these.

    Attributes
    ----------
    result : Result
        The contact, with the moduli found.
    loss : str
        How its network loses, "network" or "harmonic".
    layer_amplitudes : tuple of float
        ḡ, amplitude of shear strain that each modulus was taken at, the mean weighted by the network's loss [-].
    largest_amplitudes : tuple of float
        Largest amplitude in each layer [-].
    layer_moduli : tuple of (float, float)
        N' and N'' at ḡ [Pa], before N'' is scaled.
    loss_scales : tuple of float
        c, by which N'' is multiplied for harmonics to lose what the network does [-]; 1 with "harmonic".
    network_share : float
        Share of the network in what these layers lose by shear [-].
    torque_bounds : (float, float)
        Resisting torque summed over harmonics, as the industry has it, and matched to the network [N m], of a roller
        [N]. What is not known of strain whose axes turn lies between the two, or beyond.
    iterations : int
        Contacts solved.
    history : tuple of tuple of float
        Amplitudes after every pass [-].
    warnings : tuple of str
        What to know before relying on this, as Python's warnings said it.
    """

    result: Result
    loss: Matching
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
        """Both torques by their names in files and studies, see `BOUNDS`."""
        return dict(zip(BOUNDS, self.torque_bounds, strict=True))

    def amplitude(self, *, of: Of | None = None) -> xarray.Dataset:
        """Return the amplitude of strain over the section.

        Parameters
        ----------
        of : "ball" or "counterpart", optional
            Of which body; by default the first that softens.

        Returns
        -------
        xarray.Dataset
            `amplitude` [-] over (depth, theta) in the layers that soften, with the number of the `layer` and the arc
            `z` sideways [m].

        Raises
        ------
        ValueError
            Where nothing of that body softens.
        """
        with extra("files"):
            import xarray

        known = {layer.of for layer in self._layers}
        if self._state is None or (of is not None and of not in known):
            raise ValueError(f"of must be a body with a layer that softens, got {shown(of)}")
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
                "z": ("theta", inside.radius * (0.5 * np.pi - theta), {"units": "m", "long_name": "arc sideways"}),
            },
            attrs={"of": body, "resisting_torque": self.result.resisting_torque},
        )

    def rows(self) -> list[tuple[str, float, str]]:
        """Return what was found as name, value and SI unit, layer by layer."""
        torque = self.result.unit("resisting_torque")
        rows = [
            ("resisting_torque", self.result.resisting_torque, torque),
            *((name, value, torque) for name, value in self.bounds.items()),
            ("network_share", self.network_share, "1"),
        ]
        for j, (storage, loss) in enumerate(self.layer_moduli):
            place = f"layer_{j}_"
            rows += [
                (f"{place}amplitude", self.layer_amplitudes[j], "1"),
                (f"{place}largest_amplitude", self.largest_amplitudes[j], "1"),
                (f"{place}storage", storage, "Pa"),
                (f"{place}loss", loss, "Pa"),
                (f"{place}loss_scale", self.loss_scales[j], "1"),
            ]
        return rows

    def save(self, path: str | Path) -> None:
        """Write what was found to a file.

        Parameters
        ----------
        path : path-like
            ``.csv``, a row for each number with its unit, or ``.nc``, the amplitudes over the section with these
            numbers as attributes.

        Raises
        ------
        ValueError
            For another suffix.
        ImportError
            For ``.nc``, without the extra `viscoroll[files]`.
        """
        save(self, path, _FORMATS)

    @plots("the network alone")
    def plot(self, ax: Axes | None = None) -> Figure | Axes:
        """Draw the network over strain with where the contact works, and the amplitude over the section.

        Where nothing softens, that is a ValueError.
        """
        from .softening_picture import Work, plot_softening

        if self._state is None:
            raise ValueError("layers must soften for a picture of it, got none that do")
        values = zip(self._layers, self.layer_amplitudes, self.largest_amplitudes, strict=True)
        work = [Work(layer.modulus.network, amplitude, largest) for layer, amplitude, largest in values]
        return plot_softening(work, self.amplitude(), ax)

    def __repr__(self) -> str:
        """Return a summary of one screen."""
        unit = self.result.unit("resisting_torque")
        harmonic, matched = self.torque_bounds
        lines = [
            f"StrainSoftening at P = {self.result.load:g} {self.result.unit('load')}, "
            f"Ω = {self.result.angular_speed:g} rad/s ({self.iterations} contacts solved):",
            f"  resisting torque T_r   {self.result.resisting_torque:.6g} {unit} (loss of the {self.loss})",
            f"  bounds of it           {harmonic:.6g} (harmonic sum), {matched:.6g} {unit} (network)",
            f"  network's share        {self.network_share:.1%} of what these layers lose",
        ]
        for j, (storage, loss) in enumerate(self.layer_moduli):
            lines.append(
                f"  {self._layers[j].of} layer {self._layers[j].number:<10} strain {self.layer_amplitudes[j]:.3%}, at "
                f"most {self.largest_amplitudes[j]:.3%}: N' = {storage:.4g} Pa, N'' = {self.loss_scales[j]:.3f} · "
                f"{loss:.4g} Pa"
            )
        return "\n".join([*lines, *(f"  warning                {text}" for text in self.warnings)])

    def _repr_html_(self) -> str:
        """Return what was found, as a table for notebooks."""
        rows = [(name.replace("_", " "), number_text(value), unit_text(unit)) for name, value, unit in self.rows()]
        return html_table("Strain softening", rows)


def _write_table(found: StrainSoftening, path: Path) -> None:
    names, values, units = zip(*found.rows(), strict=True)
    write_csv({"quantity": names, "value": values, "unit": units}, path)


def _write_section(found: StrainSoftening, path: Path) -> None:
    write_netcdf(found.amplitude().assign_attrs({name: value for name, value, _ in found.rows()}), path)


#: What writes strain softening, by suffix.
_FORMATS = {".csv": _write_table, ".nc": _write_section}
