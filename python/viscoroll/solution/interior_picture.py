"""Pictures of the interior: section through the contact, and loss density."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .._support.pictures import Picture, draw_picture
from .._support.result_warnings import silenced
from .inside import Inside, Of, inside_of
from .interior_fields import interior
from .loss import contact_size, loss
from .solution import Solution

if TYPE_CHECKING:
    import xarray
    from matplotlib.axes import Axes

__all__ = ["plot_loss", "plot_section"]

_MM = 1e3
_MPA = 1e-6

#: Number of depths at which fields are evaluated.
_DEPTHS = 41


def plot_section(result: Solution, of: Of | None = None) -> Picture:
    """Draw the section θ = π/2 through the contact: von Mises stress, and the pressure above it."""
    body = inside_of(result, of)
    spacing = result.body.outer_radius * result.mesh.spacing
    # The section begins below the surface, at which the steps of the pressure from patch to patch would show.
    shallowest = min(0.25 * spacing, 0.1 * body.thickness)
    deepest = min(body.thickness, 4.0 * max(result.semi_axis_x, spacing))
    depths = np.linspace(shallowest, deepest, _DEPTHS)
    phi = body.node_angles()[0]
    with silenced():
        fields = interior(result, depth=depths, phi=phi, theta=[0.5 * np.pi], of=body.of)
    fields = fields.isel(theta=0).drop_duplicates("depth")

    figure = Picture(figsize=(10.0, 6.0), layout="constrained")
    above, below = figure.subplots(2, 1, sharex=True, height_ratios=[1.0, 2.0])
    along = fields.x * _MM
    middle = result.pressure.shape[1] // 2
    above.fill_between(along, result.pressure[:, middle] * _MPA, color="tab:red", alpha=0.3)
    above.plot(along, result.pressure[:, middle] * _MPA, color="tab:red")
    above.set(ylabel="pressure [MPa]")
    above.set_title(
        f"$P$ = {result.load:g} {result.unit('load')},  $Ω$ = {result.angular_speed:g} rad/s,  "
        f"{result.compliance.name} compliance",
        fontsize="medium",
    )
    image = below.contourf(along, fields.depth * _MM, fields.von_mises * _MPA, levels=24, cmap="viridis")
    _draw_layers(below, body)
    below.set(xlabel="along the surface, rolling to the right [mm]", ylabel="depth [mm]")
    below.set_ylim(deepest * _MM, 0.0)
    figure.colorbar(image, ax=below, label="von Mises stress [MPa]")
    return figure


def plot_loss(result: Solution, ax: Axes | None = None, of: Of | None = None) -> Picture | Axes:
    """Draw the energy dissipated per volume and passage over the cross-section, or over the depth in line contact."""
    inside = inside_of(result, of)
    reach = min(inside.thickness, 6.0 * contact_size(result))
    losses = loss(result, depth=np.linspace(0.0, reach, _DEPTHS), of=inside.of).drop_duplicates("depth")
    return draw_picture(lambda axes: _draw_loss(axes, inside, losses), ax, figsize=(10.0, 4.0))


def _draw_loss(axes: Axes, inside: Inside, losses: xarray.Dataset) -> None:
    result = inside.result
    deepest = float(losses.depth.max())
    label = "energy dissipated per passage [kJ/m³]"
    if inside.line_contact:
        axes.plot(losses.loss_density.isel(theta=0) * 1e-3, losses.depth * _MM, color="tab:red")
        axes.set(xlabel=label)
    else:
        image = axes.contourf(losses.z * _MM, losses.depth * _MM, losses.loss_density * 1e-3, levels=24, cmap="inferno")
        reach = (2.0 * (result.semi_axis_z or 0.0) + 2.0 * deepest) * _MM
        axes.set(xlim=(-reach, reach), xlabel="across the track [mm]")
        axes.figure.colorbar(image, ax=axes, label=label)
    _draw_layers(axes, inside)
    axes.set(ylabel="depth [mm]")
    axes.set_ylim(deepest * _MM, 0.0)
    axes.set_title(f"{inside.bulk_power:.3g} {result.unit('bulk_power')} dissipated in the layers", fontsize="medium")


def _draw_layers(axes: Axes, inside: Inside) -> None:
    """Draw the boundaries of the layers."""
    depths = inside.depth(inside.body.boundaries)
    for depth in depths[np.isfinite(depths)]:
        axes.axhline(depth * _MM, color="k", linewidth=2.0 if depth == depths[0] else 1.0)
