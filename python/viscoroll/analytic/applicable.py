"""Which closed forms a ball or a roller has."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from .._core import InnerBoundary
from .._support.arguments import as_float_array, require_type
from ..bodies import CoatedCylinder, CoatedSphere, Layer, RollingBody
from ._closed_form import ClosedForm, at_rest, is_homogeneous, is_known_throughout, is_real, shared_loss_time
from ._inputs import Floats, plain, positives
from .applicable_roller import forms_of_roller
from .contact import hertz, thin_compressible_layer, thin_incompressible_layer
from .half_space import greenwood_tabor_torque, persson_torque
from .low_speed import low_speed_torque, sphere_loss_time
from .winkler import KNOWN_IN_TIME, longest_time, winkler_torque

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

__all__ = ["ClosedForm", "applicable"]


@dataclass(frozen=True, slots=True, kw_only=True)
class _Coating:
    """Layers between a ball and a plane, or two balls, whose gap is that of a ball of the outer radius on a plane."""

    layers: Sequence[Layer]
    thickness: float
    outer_radius: float
    inner_boundary: InnerBoundary


def applicable(ball: RollingBody, *, on: CoatedSphere | None = None) -> dict[str, ClosedForm]:
    """Find the closed forms of the resisting torque that suit the materials and layers of a ball or roller.

    Parameters
    ----------
    ball : CoatedSphere or CoatedCylinder
        Rigid core and layers.
    on : CoatedSphere, optional
        Another ball that a ball rolls on; without it a rigid plane.

    Returns
    -------
    dict of str to ClosedForm
        ``"low_speed"`` for layers that share one loss time at rest, each with a real Poisson's ratio, or for one
        material with a bulk modulus; ``"greenwood_tabor"`` (the paper's equation (64), all lost) and ``"persson"`` for
        one material throughout; ``"winkler"`` for one that is compressible and known in time, on a rigid core. Of a
        roller ``"low_speed"``, ``"hunter"`` for one standard linear solid, and ``"winkler_line"``. Of two balls those
        of the coated one where the other is rigid, with 1/R = 1/R₁ + 1/R₂, and those on the plane between two alike.
        Empty where none suits. Ask each form's `holds` about loads and speeds.

    Raises
    ------
    TypeError
        For something else than a ball, and for a roller on one.
    ValueError
        For materials that are not known at rest.

    Examples
    --------
    >>> from viscoroll import CoatedSphere, KelvinVoigt, Layer
    >>> gel = Layer(thickness=19e-3, shear_modulus=KelvinVoigt(modulus=1e4, viscosity=10.0), poisson_ratio=0.5)
    >>> forms = applicable(CoatedSphere(core_radius=1e-3, layers=[gel]))
    >>> sorted(forms)
    ['greenwood_tabor', 'low_speed', 'persson']
    >>> f"{forms['low_speed'](0.01, 0.1) * 1e9:.1f} nN m"
    '20.0 nN m'
    """
    require_type("on", on, CoatedSphere, optional=True)
    require_type("ball", ball, *((CoatedSphere, CoatedCylinder) if on is None else (CoatedSphere,)))
    if isinstance(ball, CoatedCylinder):
        return forms_of_roller(ball)
    if on is None or on == ball:
        return _forms(_coating(ball, ball.outer_radius))
    if ball.layers and on.layers:
        return {}
    radius = ball.outer_radius * on.outer_radius / (ball.outer_radius + on.outer_radius)
    forms = _forms(_coating(ball if ball.layers else on, radius))
    return {name: _faster(form, ball.outer_radius / radius) for name, form in forms.items()}


def _coating(ball: CoatedSphere, radius: float) -> _Coating:
    return _Coating(
        layers=ball.layers, thickness=ball.thickness, outer_radius=radius, inner_boundary=ball.inner_boundary
    )


def _forms(coating: _Coating) -> dict[str, ClosedForm]:
    if not coating.layers:
        return {}
    return _low_speed(coating) | (_half_space(coating) | _thin(coating) if is_homogeneous(coating.layers) else {})


def _faster(form: ClosedForm, turns: float) -> ClosedForm:
    """Return a form of a ball that turns so many times as fast, for its surface to be as fast."""

    def torque(load: ArrayLike, angular_speed: ArrayLike) -> Floats:
        return form.torque(load, turns * as_float_array("angular_speed", angular_speed))

    def holds(load: ArrayLike, angular_speed: ArrayLike) -> NDArray[np.bool_]:
        return form.holds(load, turns * as_float_array("angular_speed", angular_speed))

    return ClosedForm(torque=torque, holds=holds, validity=form.validity)


def _low_speed(ball: _Coating) -> dict[str, ClosedForm]:
    time = _loss_time(ball)
    if time is None:
        return {}

    def torque(load: ArrayLike, angular_speed: ArrayLike) -> Floats:
        return low_speed_torque(load=load, angular_speed=angular_speed, radius=ball.outer_radius, loss_time=time)

    def holds(load: ArrayLike, angular_speed: ArrayLike) -> NDArray[np.bool_]:
        a = _contact_radius(ball, load)
        path = positives("angular_speed", angular_speed, "rad/s") * ball.outer_radius * time
        met: NDArray[np.bool_] = (path <= 0.05 * a) & (is_real(ball.layers) | (a <= 0.2 * ball.thickness))
        return met

    moves = "the surface moves by less than 5 % of the contact radius in the loss time; no inertia"
    return {"low_speed": ClosedForm(torque=torque, holds=holds, validity=moves)}


def _half_space(ball: _Coating) -> dict[str, ClosedForm]:
    layer, radius = ball.layers[0], ball.outer_radius
    modulus, nu = at_rest(layer)

    def greenwood_tabor(load: ArrayLike, angular_speed: ArrayLike) -> Floats:
        torque = greenwood_tabor_torque(load=load, radius=radius, shear_modulus=modulus, poisson_ratio=nu)
        return plain(torque * np.ones_like(positives("angular_speed", angular_speed, "rad/s")))

    def persson(load: ArrayLike, angular_speed: ArrayLike) -> Floats:
        return persson_torque(
            load=load,
            angular_speed=angular_speed,
            radius=radius,
            shear_modulus=layer.shear_modulus,
            poisson_ratio=layer.poisson_ratio,
            bulk_modulus=layer.bulk_modulus,
        )

    def holds(load: ArrayLike, angular_speed: ArrayLike) -> NDArray[np.bool_]:
        any_speed = positives("angular_speed", angular_speed, "rad/s") > 0.0
        met: NDArray[np.bool_] = (_contact_radius(ball, load) <= 0.2 * ball.thickness) & any_speed
        return met

    small = "contact radius below a fifth of the thickness; no inertia"
    forms = {"greenwood_tabor": ClosedForm(torque=greenwood_tabor, holds=holds, validity=f"all work lost; {small}")}
    if is_known_throughout(layer.shear_modulus):
        forms["persson"] = ClosedForm(torque=persson, holds=holds, validity=f"pressure as at rest; {small}")
    return forms


def _thin(ball: _Coating) -> dict[str, ClosedForm]:
    layer, h = ball.layers[0], ball.thickness
    modulus, nu = at_rest(layer)
    material = layer.shear_modulus
    if not isinstance(material, KNOWN_IN_TIME) or nu == 0.5 or ball.inner_boundary is not InnerBoundary.RIGID:
        return {}

    def torque(load: ArrayLike, angular_speed: ArrayLike) -> Floats:
        return winkler_torque(
            load=load,
            angular_speed=angular_speed,
            radius=ball.outer_radius,
            thickness=h,
            shear_modulus=material,
            poisson_ratio=layer.poisson_ratio,
            bulk_modulus=layer.bulk_modulus,
        )

    def holds(load: ArrayLike, angular_speed: ArrayLike) -> NDArray[np.bool_]:
        contact = thin_compressible_layer(
            load=load, radius=ball.outer_radius, thickness=h, shear_modulus=modulus, poisson_ratio=nu
        )
        slow = positives("angular_speed", angular_speed, "rad/s") * longest_time(material) <= 0.2 * np.pi
        a = np.asarray(contact.radius)
        met: NDArray[np.bool_] = (a >= 5.0 * h) & ((1.0 - 2.0 * nu) * a >= h) & (a <= 0.2 * ball.outer_radius) & slow
        return met

    wide = (
        "contact radius a above 5 thicknesses h and h/(1-2ν), below a fifth of the radius; forgets in a tenth of a "  # noqa: RUF001
        "revolution; no inertia"
    )
    return {"winkler": ClosedForm(torque=torque, holds=holds, validity=wide)}


def _loss_time(ball: _Coating) -> float | None:
    """Return t of a compliance C(0) (1 - iωt), if the ball has one."""
    time = shared_loss_time(ball.layers)
    if time is None or is_real(ball.layers):
        return time
    if not is_homogeneous(ball.layers):
        return None
    modulus, nu = at_rest(ball.layers[0])
    return sphere_loss_time(shear_modulus=modulus, poisson_ratio=nu, shear_viscosity=time * modulus)


def _contact_radius(ball: _Coating, load: ArrayLike) -> NDArray[np.float64]:
    """Estimate the contact radius at rest [m], of layers as if mixed: the lesser of the thick and the thin limit.

    Of the thin limits the larger one counts, since a thin layer gives way in both manners at once.
    """
    h, radius = ball.thickness, ball.outer_radius
    mixed = [(layer.thickness / h, *at_rest(layer)) for layer in ball.layers]
    modulus = 1.0 / sum(share / g for share, g, _ in mixed)
    nu = min(sum(share * ratio for share, _, ratio in mixed), 0.5)
    thick = hertz(load=load, radius=radius, shear_modulus=modulus, poisson_ratio=nu).radius
    thin = thin_incompressible_layer(load=load, radius=radius, thickness=h, shear_modulus=modulus).radius
    if nu < 0.5:
        springs = thin_compressible_layer(
            load=load, radius=radius, thickness=h, shear_modulus=modulus, poisson_ratio=nu
        ).radius
        thin = np.maximum(thin, springs)
    return np.minimum(thick, thin)
