"""Closed forms that are valid for two bodies of which one is rigid, or for two identical ones."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, fields, replace
from functools import partial
from typing import TYPE_CHECKING, Any, TypeAlias, TypeVar

import numpy as np

from .._core import InnerBoundary
from .._support.arguments import as_float_array, require_type
from ..bodies import CoatedCylinder, CoatedPlane, CoatedSphere, CoatedWheel, Counterbody, Layer, RollingBody
from ..bodies.layered import materials_of
from ..materials.modulus_like import standard_linear_solid_of
from ._at_rest import Coating, reach_at_rest
from ._closed_form import (
    ClosedForm,
    have_real_poisson_ratios,
    is_defined_at_all_frequencies,
    is_homogeneous,
    relaxed_constants,
    shared_loss_time,
)
from ._inputs import Floats, float_if_scalar, positives
from ._torques import ContactSize, low_speed_form, thin_coating_form
from .contact import PointContact, hertz, thin_compressible_layer, thin_incompressible_layer
from .ellipse import hertz_ellipse
from .half_space import greenwood_tabor_torque, persson_torque
from .hunter import hunter
from .line_contact import hertz_line, thin_compressible_layer_line, thin_incompressible_layer_line
from .low_speed import sphere_loss_time
from .winkler import winkler_torque, winkler_torque_line

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

__all__ = ["ClosedForm", "applicable"]

#: Smallest ratio of width to thickness of a flat tread whose side faces change the result by at most 10 %. The change
#: is proportional to h/w; it is 27 % at three thicknesses.
_WIDE = 10.0


#: Ratio of the moduli at rest above which the stiffer body counts as rigid.
_STIFF = 1e3

#: Thickness of the layer that replaces a half-space, divided by the radius.
_DEEP = 1e6

_Round = TypeVar("_Round", CoatedSphere, CoatedCylinder)

#: Closed forms by name, or None for a form that does not apply to the materials.
_Forms: TypeAlias = "dict[str, ClosedForm | None]"


@dataclass(frozen=True, slots=True)
class _Cover:
    """Layers between two bodies, from the core or base outwards, with the radius of the equivalent body on a plane."""

    layers: Sequence[Layer]
    thickness: float
    outer_radius: float
    inner_boundary: InnerBoundary = InnerBoundary.RIGID


def applicable(body: RollingBody, *, on: Counterbody | None = None) -> dict[str, ClosedForm]:
    """Return the closed forms of the resisting torque that are valid for the materials and layers of a body.

    Parameters
    ----------
    body : CoatedSphere, CoatedCylinder or CoatedWheel
        Rolling body.
    on : CoatedPlane, Groove, CoatedSphere, CoatedCylinder or CoatedWheel, optional
        Counterbody; by default the rigid plane.

    Returns
    -------
    dict of str to ClosedForm
        Valid closed forms by name; empty for pairs without one. The `is_valid` of each form checks loads and speeds.

    Raises
    ------
    TypeError
        If `body` is not a rolling body, or `on` is not a counterbody.
    ValueError
        If a material is not defined at rest.

    Notes
    -----
    Balls:

    * ``"low_speed"``: all layers share one loss time and have real Poisson's ratios, or there is a single material with
      a bulk modulus.
    * ``"greenwood_tabor"`` (the paper's equation (64), all work dissipated) and ``"persson"``: a single material.
    * ``"winkler"``: a single compressible material whose relaxation function is a sum of exponentials, on a rigid core.

    Rollers: ``"low_speed"``, ``"hunter"`` for a single standard linear solid, and ``"winkler_line"``. Flat wheels: the
    same forms, per unit length times the width. Crowned wheels: ``"low_speed"``, ``"greenwood_tabor"`` and
    ``"persson"``.

    Rigid balls and rollers on layers on a rigid plane have the forms of coated ones on a rigid plane; on a half-space,
    the same forms except that of springs.

    Two balls or two rollers: if one is rigid, the forms of the coated one with 1/R = 1/R₁ + 1/R₂; if both are
    identical, the forms of one on the plane between them.

    A body counts as rigid if its modulus at rest is at least 1000 times that of the other body, such as steel on
    rubber, because its share of the deformation is then below 0.1 %.

    Examples
    --------
    >>> from viscoroll import CoatedSphere, Layer
    >>> from viscoroll.materials import KelvinVoigt
    >>> gel = Layer(thickness=19e-3, shear_modulus=KelvinVoigt(modulus=1e4, viscosity=10.0), poisson_ratio=0.5)
    >>> forms = applicable(CoatedSphere(core_radius=1e-3, layers=[gel]))
    >>> sorted(forms)
    ['greenwood_tabor', 'low_speed', 'persson']
    >>> f"{forms['low_speed'](0.01, 0.1) * 1e9:.1f} nN m"
    '20.0 nN m'
    """
    require_type("body", body, RollingBody)
    require_type("on", on, Counterbody, optional=True)
    counterbody = CoatedPlane() if on is None else on
    find = _FORMS.get((type(body), type(counterbody)))
    forms = {} if find is None else find(*_with_rigid(body, counterbody))
    return {name: form for name, form in forms.items() if form is not None}


def _with_rigid(body: RollingBody, on: Counterbody) -> tuple[RollingBody, Counterbody]:
    """Return both bodies, one of them rigid if it is much stiffer than the other."""
    softest, softest_on = (_lowest_modulus(one) for one in (body, on))
    if math.isfinite(softest) and softest >= _STIFF * softest_on:
        return _rigid(body), on
    if math.isfinite(softest_on) and softest_on >= _STIFF * softest:
        return body, _rigid(on)
    return body, on


def _lowest_modulus(body: RollingBody | Counterbody) -> float:
    """Return the lowest shear modulus at rest of the layers of a body [Pa]; infinite for a rigid body."""
    return min((relaxed_constants(material)[0] for material in materials_of(body)), default=math.inf)


def _rigid(body: Any) -> Any:
    """Return a rigid body with the same surface."""
    values = {
        "core_radius": getattr(body, "outer_radius", None),
        "inner_boundary": InnerBoundary.RIGID,
        "layers": (),
        "base": None,
    }
    return replace(body, **{field.name: values[field.name] for field in fields(body) if field.name in values})


def _on_plane(of_cover: Callable[[_Cover], _Forms], body: CoatedSphere | CoatedCylinder, plane: CoatedPlane) -> _Forms:
    """Return the forms of a ball or roller on a plane, if exactly one of them is rigid."""
    if not plane.is_deformable:
        return of_cover(_cover_of(body, body.outer_radius)) if body.layers else {}
    if body.layers or (plane.layers and plane.base is not None):
        return {}
    radius = body.outer_radius
    if plane.base is None:
        return of_cover(_Cover(plane.layers, plane.thickness, radius))
    deep = Layer(
        thickness=_DEEP * radius,
        shear_modulus=plane.base.shear_modulus,
        poisson_ratio=plane.base.poisson_ratio,
        bulk_modulus=plane.base.bulk_modulus,
    )
    forms = of_cover(_Cover([deep], deep.thickness, radius))
    return {name: form for name, form in forms.items() if not name.startswith("winkler")}


def _of_two(of_cover: Callable[[_Cover], _Forms], body: _Round, on: _Round) -> _Forms:
    """Return the forms of two balls or two rollers, if exactly one of them is rigid or both are identical."""
    coated = [one for one in (body, on) if one.layers]
    if coated and on == body:
        return of_cover(_cover_of(body, body.outer_radius))
    if len(coated) != 1:
        return {}
    radius = body.outer_radius * on.outer_radius / (body.outer_radius + on.outer_radius)
    forms = of_cover(_cover_of(coated[0], radius))
    return {name: form and _faster(form, body.outer_radius / radius) for name, form in forms.items()}


def _cover_of(body: CoatedSphere | CoatedCylinder, radius: float) -> _Cover:
    return _Cover(body.layers, body.thickness, radius, getattr(body, "inner_boundary", InnerBoundary.RIGID))


def _faster(form: ClosedForm, ratio: float) -> ClosedForm:
    """Return the form of a ball that rotates faster by the factor `ratio`, so that the surface speeds agree."""

    def torque(load: ArrayLike, angular_speed: ArrayLike) -> Floats:
        return form.torque(load, ratio * as_float_array("angular_speed", angular_speed))

    def is_valid(load: ArrayLike, angular_speed: ArrayLike) -> NDArray[np.bool_]:
        return form.is_valid(load, ratio * as_float_array("angular_speed", angular_speed))

    return ClosedForm(torque=torque, is_valid=is_valid, validity=form.validity)


def _of_ball(ball: _Cover) -> _Forms:
    contact_radius = partial(
        reach_at_rest, ball, thick=hertz, squeezed=thin_incompressible_layer, springs=thin_compressible_layer
    )
    time = _loss_time(ball)
    forms: _Forms = {
        "low_speed": None if time is None else low_speed_form(ball, time, contact_radius, "contact radius")
    }
    if is_homogeneous(ball.layers):
        forms |= _half_space(ball, contact_radius, layer_size=ball.thickness)
        if ball.inner_boundary is InnerBoundary.RIGID:
            forms["winkler"] = thin_coating_form(ball, winkler_torque, contact_radius, "contact radius")
    return forms


def _half_space(
    body: Coating, contact_size: ContactSize, *, layer_size: float, crown_radius: float | None = None
) -> _Forms:
    """Return the half-space forms, valid for contacts up to a fifth of the size of the layer, `layer_size` [m]."""
    layer, radius = body.layers[0], body.outer_radius
    modulus, nu = relaxed_constants(layer)

    def greenwood_tabor(load: ArrayLike, angular_speed: ArrayLike) -> Floats:
        torque = greenwood_tabor_torque(
            load=load, radius=radius, shear_modulus=modulus, poisson_ratio=nu, crown_radius=crown_radius
        )
        return float_if_scalar(torque * np.ones_like(positives("angular_speed", angular_speed, "rad/s")))

    def persson(load: ArrayLike, angular_speed: ArrayLike) -> Floats:
        return persson_torque(
            load=load,
            angular_speed=angular_speed,
            radius=radius,
            shear_modulus=layer.shear_modulus,
            poisson_ratio=layer.poisson_ratio,
            bulk_modulus=layer.bulk_modulus,
            crown_radius=crown_radius,
        )

    def is_valid(load: ArrayLike, angular_speed: ArrayLike) -> NDArray[np.bool_]:
        any_speed = positives("angular_speed", angular_speed, "rad/s") > 0.0
        valid: NDArray[np.bool_] = (contact_size(load) <= 0.2 * layer_size) & any_speed
        return valid

    small = (
        "contact radius at most a fifth of the thickness; no inertia"
        if crown_radius is None
        else "longer semi-axis at most a fifth of the thickness and of half the width; no inertia"
    )
    lagging = ClosedForm(torque=persson, is_valid=is_valid, validity=f"pressure distribution at rest; {small}")
    return {
        "greenwood_tabor": ClosedForm(
            torque=greenwood_tabor, is_valid=is_valid, validity=f"all deformation work dissipated; {small}"
        ),
        "persson": lagging if is_defined_at_all_frequencies(layer.shear_modulus) else None,
    }


def _loss_time(ball: _Cover) -> float | None:
    """Return t [s] of the surface compliance C(0) (1 - iωt) of the ball, or None if it does not have this form."""
    time = shared_loss_time(ball.layers)
    if time is None or have_real_poisson_ratios(ball.layers):
        return time
    if not is_homogeneous(ball.layers):
        return None
    modulus, nu = relaxed_constants(ball.layers[0])
    return sphere_loss_time(shear_modulus=modulus, poisson_ratio=nu, shear_viscosity=time * modulus)


def _of_roller(roller: Coating) -> _Forms:
    half_width = partial(_half_width, roller)
    time = shared_loss_time(roller.layers) if have_real_poisson_ratios(roller.layers) else None
    one_material = is_homogeneous(roller.layers)
    return {
        "low_speed": None if time is None else low_speed_form(roller, time, half_width, "contact half-width"),
        "hunter": _hunter(roller, half_width) if one_material else None,
        "winkler_line": thin_coating_form(roller, winkler_torque_line, half_width, "contact half-width")
        if one_material
        else None,
    }


def _half_width(roller: Coating, load: ArrayLike) -> NDArray[np.float64]:
    return reach_at_rest(
        roller,
        load,
        thick=hertz_line,
        squeezed=thin_incompressible_layer_line,
        springs=thin_compressible_layer_line,
    )


def _hunter(roller: Coating, half_width: ContactSize) -> ClosedForm | None:
    layer, radius = roller.layers[0], roller.outer_radius
    material, nu = standard_linear_solid_of(layer.shear_modulus), layer.poisson_ratio
    if material is None or nu is None:
        return None

    retardation = material.relaxation_time * material.instantaneous_modulus / material.relaxed_modulus

    def torque(load: ArrayLike, angular_speed: ArrayLike) -> Floats:
        speed = positives("angular_speed", angular_speed, "rad/s") * radius
        return hunter(load=load, speed=speed, radius=radius, shear_modulus=material, poisson_ratio=nu).moment

    def is_valid(load: ArrayLike, angular_speed: ArrayLike) -> NDArray[np.bool_]:
        # The core must also be deeper than the wake of the contact, whose length is f V τ.
        wake = positives("angular_speed", angular_speed, "rad/s") * radius * retardation
        valid: NDArray[np.bool_] = (half_width(load) <= 0.2 * roller.thickness) & (wake <= 0.5 * roller.thickness)
        return valid

    small = (
        "contact half-width at most a fifth of the thickness, distance rolled within the retardation time at most half "
        "the thickness; no inertia"
    )
    return ClosedForm(torque=torque, is_valid=is_valid, validity=small)


def _of_wheel(wheel: CoatedWheel, plane: CoatedPlane) -> _Forms:
    if not wheel.layers or plane.is_deformable:
        return {}
    roller = _Cover(wheel.layers, wheel.thickness, wheel.outer_radius)
    time = shared_loss_time(wheel.layers) if have_real_poisson_ratios(wheel.layers) else None
    half_length = partial(_along_path, wheel, roller)
    slow = None if time is None else low_speed_form(wheel, time, half_length, "contact half-length")
    if math.isinf(wheel.crown_radius):
        of_roller = _of_roller(roller).items()
        return {name: form and _over_width(form, wheel) for name, form in of_roller} | {"low_speed": slow}
    if not is_homogeneous(wheel.layers):
        return {"low_speed": slow}
    layer_size = min(wheel.thickness, 0.5 * wheel.width)
    longer_axis = partial(_longer_axis, wheel)
    return {
        "low_speed": slow,
        **_half_space(wheel, longer_axis, layer_size=layer_size, crown_radius=wheel.crown_radius),
    }


def _over_width(form: ClosedForm, wheel: CoatedWheel) -> ClosedForm:
    """Return a form of line contact for a flat wheel that is wide enough to neglect its side faces."""

    def torque(load: ArrayLike, angular_speed: ArrayLike) -> Floats:
        return form(np.asarray(load) / wheel.width, angular_speed) * wheel.width

    def is_valid(load: ArrayLike, angular_speed: ArrayLike) -> NDArray[np.bool_]:
        valid: NDArray[np.bool_] = form.is_valid(np.asarray(load) / wheel.width, angular_speed)
        return valid & (wheel.width >= _WIDE * wheel.thickness)

    return ClosedForm(
        torque=torque, is_valid=is_valid, validity=f"{form.validity}; width at least {_WIDE:g} thicknesses"
    )


def _along_path(wheel: CoatedWheel, roller: Coating, load: ArrayLike) -> NDArray[np.float64]:
    """Estimate half of the contact length at rest [m], the larger one of an ellipse and of a line over the width."""
    line = _half_width(roller, np.asarray(load) / wheel.width)
    if math.isinf(wheel.crown_radius):
        return line
    aspect = math.sqrt(wheel.outer_radius / wheel.crown_radius)

    def of_ball(thin: Callable[..., PointContact], *, load: ArrayLike, **layer: float) -> PointContact:
        """Return a thin-layer contact on an ellipse with the aspect ratio of the contours of the gap."""
        return thin(load=np.asarray(load) * aspect, **layer)

    ellipse = reach_at_rest(
        wheel,
        load,
        thick=partial(hertz_ellipse, crown_radius=wheel.crown_radius),
        squeezed=partial(of_ball, thin_incompressible_layer),
        springs=partial(of_ball, thin_compressible_layer),
    )
    return np.maximum(line, ellipse)


def _longer_axis(wheel: CoatedWheel, load: ArrayLike) -> NDArray[np.float64]:
    modulus, nu = relaxed_constants(wheel.layers[0])
    radii = {"radius": wheel.outer_radius, "crown_radius": wheel.crown_radius}
    contact = hertz_ellipse(load=load, **radii, shear_modulus=modulus, poisson_ratio=nu)
    return np.asarray(np.maximum(contact.semi_axis_x, contact.semi_axis_z))


#: Functions that return the closed forms of a pair, by the types of body and counterbody.
_FORMS: dict[tuple[type, type], Callable[[Any, Any], _Forms]] = {
    (CoatedSphere, CoatedPlane): partial(_on_plane, _of_ball),
    (CoatedCylinder, CoatedPlane): partial(_on_plane, _of_roller),
    (CoatedWheel, CoatedPlane): _of_wheel,
    (CoatedSphere, CoatedSphere): partial(_of_two, _of_ball),
    (CoatedCylinder, CoatedCylinder): partial(_of_two, _of_roller),
}
