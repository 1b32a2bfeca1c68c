"""Warnings about histories: times for which a material is not defined, and large strains."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from .._support.arguments import Floats
from ..bodies import Counterbody, Mesh, RollingBody
from ..bodies.layered import materials_of
from ..materials.shear_modulus import known_times_of
from .options import HistoryOptions

__all__ = ["ground_warnings", "local_height", "rest_warnings", "strain_warnings", "time_warnings"]

#: Largest strain that finite-strain computations support, and the model error per strain, the same as in `solve`
#: (`cpp/src/rolling/warnings.cpp`, `model_error` in result_scalars.def).
_LARGEST_STRAIN, _ERROR_PER_STRAIN = 0.2, 0.75

#: Smallest change of the modulus at rest of a constant loss factor that is worth a warning [-].
_WORTH_MENTION = 0.2


def _materials(body: RollingBody, on: Counterbody | None) -> Iterator[tuple[str, object]]:
    """Yield the name and the modulus of each material."""
    for name, one in (("body", body), ("on", on)):
        if one is None:
            continue
        materials = materials_of(one)
        for index, material in enumerate(materials, len(one.layers) - len(materials)):
            place = f"layers[{index}]" if index >= 0 else "base"
            yield f"{name}.{place}.shear_modulus", material.shear_modulus


def time_warnings(body: RollingBody, on: Counterbody | None, *, duration: float) -> list[str]:
    """Return a warning for each material that is not defined for times as long as the motion [s]."""
    messages = []
    for name, modulus in _materials(body, on):
        known = known_times_of(modulus)
        if known is not None and duration > known.longest:
            messages.append(
                f"the motion lasts {duration:.3g} s, but {known.meaning} up to {known.longest:.3g} s only ({name}): "
                "creep and recovery beyond are an extrapolation; use a creep or relaxation test (rheology.fit_spectrum)"
            )
    return messages


def rest_warnings(body: RollingBody, on: Counterbody | None) -> list[str]:
    """Return a warning for each material whose state after an infinite rest is an extrapolation."""
    messages = []
    for name, modulus in _materials(body, on):
        known = known_times_of(modulus)
        if known is None or known.extrapolated_rest is None:
            continue
        relaxed, given = known.extrapolated_rest
        if relaxed < (1.0 - _WORTH_MENTION) * given:
            messages.append(
                f"start = 'relaxed' is a rest of infinite time, but {known.meaning} up to {known.longest:.3g} s only "
                f"({name}): its modulus at rest, {relaxed:.3g} Pa in place of {given:.3g} Pa, is an extrapolation; use "
                "a creep or relaxation test (rheology.fit_spectrum), or start = 'undeformed'"
            )
    return messages


#: Nodes over the shortest feature of a profile, largest height relative to the radius, and largest slope, up to which
#: histories over uneven ground are accurate (docs/theory/ground.md, "Limits").
_NODES_PER_FEATURE, _LARGEST_HEIGHT, _LARGEST_SLOPE = 8.0, 0.03, 0.5


def local_height(body: RollingBody, options: HistoryOptions, distance: Floats, length: Floats) -> Floats:
    """Return by how much ground and tread raise the deepest point of each contact above the penetration [m].

    Parameters
    ----------
    distance, length : ndarray
        Distance rolled and contact length at every instant [m]. The contact may lie ahead of the axle or behind it.
    """
    aside = np.linspace(-1.0, 1.0, 17) * np.nan_to_num(length)[:, np.newaxis]
    raised = np.zeros_like(aside) if options.ground is None else options.ground.height_at(distance[:, None] + aside)
    raised = raised + (0.0 if options.tread is None else float(options.tread.height.max()))
    return np.asarray(np.max(raised - 0.5 * aside**2 / body.outer_radius, axis=1))


def ground_warnings(body: RollingBody, mesh: Mesh, options: HistoryOptions, distance: Floats) -> list[str]:
    """Return warnings about the profiles of ground and tread, and if the body rolls beyond a measured ground."""
    messages = []
    spacing = body.outer_radius * mesh.spacing
    for name, profile in (("ground", options.ground), ("tread", options.tread)):
        if profile is None:
            continue
        if (nodes := profile.shortest_feature / spacing) < _NODES_PER_FEATURE:
            messages.append(
                f"the shortest feature of {name} is {profile.shortest_feature:.3g} m, {nodes:.1f} node spacings "
                f"(recommended: at least {_NODES_PER_FEATURE:g}): use a finer mesh"
            )
        height = float(np.ptp(profile.height)) / body.outer_radius
        if height > _LARGEST_HEIGHT:
            messages.append(
                f"the heights of {name} differ by {height:.2g} of the radius (recommended: at most "
                f"{_LARGEST_HEIGHT:g}): linear theory may be inaccurate"
            )
        if profile.largest_slope > _LARGEST_SLOPE:
            messages.append(
                f"the largest slope of {name} is {profile.largest_slope:.2g} (recommended: at most "
                f"{_LARGEST_SLOPE:g}): linear theory assumes slopes much smaller than 1"
            )
    ground = options.ground
    if ground is not None and not ground.periodic:
        messages += [
            f"the body rolls beyond the end of ground at {end:.4g} m, where its height stays {height:.3g} m"
            for end, height, before, is_beyond in (
                (ground.distance[0], ground.height[0], ground.height[1], distance.min() < ground.distance[0]),
                (ground.distance[-1], ground.height[-1], ground.height[-2], distance.max() > ground.distance[-1]),
            )
            if is_beyond and height not in (0.0, before)
        ]
    return messages


def strain_warnings(body: RollingBody, on: Counterbody | None, penetration: Floats) -> list[str]:
    """Return a warning if the strain, penetration / coating thickness, exceeds what linear theory supports."""
    depth = sum(one.depth for one in (body, on) if one is not None)  # infinite with a half-space
    known = penetration[np.isfinite(penetration)]
    if not (known.size and 0.0 < depth < math.inf):
        return []
    strain = float(known.max()) / depth
    if strain <= _LARGEST_STRAIN:
        return []
    return [
        f"the strain, penetration / coating thickness, is up to {strain:.2g} (recommended: at most "
        f"{_LARGEST_STRAIN:g}): linear theory may have a relative error of {_ERROR_PER_STRAIN * strain:.2g}"
    ]
