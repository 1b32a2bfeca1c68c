"""Pictures of the interior: section through the contact, and loss density."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .._support.pictures import Picture, draw_picture
from .._support.quantities import quantity_text
from .._support.result_warnings import silenced
from .._support.scales import Scale
from .inside import Inside, Of, inside_of
from .interior_fields import interior
from .loss import contact_size, loss
from .solution import Solution
from .text import scalar_text

if TYPE_CHECKING:
    import xarray
    from matplotlib.axes import Axes

__all__ = ["plot_loss", "plot_section"]


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
    middle = result.pressure.shape[1] // 2
    pressures = result.pressure[:, middle]
    length, pressure, stress = Scale.of(deepest, "m"), Scale.of(pressures, "Pa"), Scale.of(fields.von_mises, "Pa")
    along = fields.x / length.factor
    above.fill_between(along, pressures / pressure.factor, color="tab:red", alpha=0.3)
    above.plot(along, pressures / pressure.factor, color="tab:red")
    above.set(ylabel=pressure.text("pressure"))
    above.set_title(
        f"$P$ = {scalar_text(result, 'load')},  $Ω$ = {result.angular_speed:g} rad/s,  "
        f"{result.compliance.name} compliance",
        fontsize="medium",
    )
    image = below.contourf(
        along, fields.depth / length.factor, fields.von_mises / stress.factor, levels=24, cmap="viridis"
    )
    _draw_layers(below, body, length)
    below.set(xlabel=length.text("along the surface, rolling to the right"), ylabel=length.text("depth"))
    below.set_ylim(deepest / length.factor, 0.0)
    figure.colorbar(image, ax=below, label=stress.text("von Mises stress"))
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
    length, density = Scale.of(deepest, "m"), Scale.of(losses.loss_density, "J/m^3")
    depth, label = losses.depth / length.factor, density.text("energy dissipated per passage")
    lost = losses.loss_density / density.factor
    if inside.line_contact:
        axes.plot(lost.isel(theta=0), depth, color="tab:red")
        axes.set(xlabel=label)
    else:
        image = axes.contourf(losses.z / length.factor, depth, lost, levels=24, cmap="inferno")
        reach = (2.0 * (result.semi_axis_z or 0.0) + 2.0 * deepest) / length.factor
        axes.set(xlim=(-reach, reach), xlabel=length.text("across the track"))
        axes.figure.colorbar(image, ax=axes, label=label)
    _draw_layers(axes, inside, length)
    axes.set(ylabel=length.text("depth"))
    axes.set_ylim(deepest / length.factor, 0.0)
    power = quantity_text(inside.bulk_power, result.unit("bulk_power"))
    axes.set_title(f"{power} dissipated in the layers", fontsize="medium")


def _draw_layers(axes: Axes, inside: Inside, length: Scale) -> None:
    """Draw the boundaries of the layers."""
    depths = inside.depth(inside.body.boundaries)
    for depth in depths[np.isfinite(depths)]:
        axes.axhline(depth / length.factor, color="k", linewidth=2.0 if depth == depths[0] else 1.0)
