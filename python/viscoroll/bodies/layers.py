"""Materials of the bodies: bonded viscoelastic layers and half-spaces."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace
from typing import Any, TypeVar

from .. import _core
from .._support.arguments import as_positive, require_type, store_floats
from .._support.errors import InvalidType
from .._support.tables import ParameterTable
from .._support.text import shown
from ..materials import SofteningModulus
from ..materials.modulus_like import ShearModulusLike, as_modulus, to_core

__all__ = ["HalfSpace", "Layer", "as_layers", "at_rest"]


@dataclass(frozen=True, slots=True, kw_only=True)
class Layer(ParameterTable):
    """One homogeneous, isotropic, linear viscoelastic layer.

    Exactly one of `poisson_ratio` and `bulk_modulus` must be given.

    Parameters
    ----------
    thickness : float
        Thickness [m], > 0, and at least 1e-9 of the radius of the rolling body.
    shear_modulus : ShearModulus, callable or float
        μ*(ω) [Pa]: a modulus of this package, a number for an elastic modulus, or a function. The function receives an
        array of angular frequencies [rad/s], which are ≥ 0 and include 0, and returns complex values [Pa] with a loss
        modulus ≥ 0, either one for each frequency or one for all.
    poisson_ratio : float, optional
        Real, constant Poisson's ratio ν in (-1, 0.5]; 0.5 means incompressible.
    bulk_modulus : float, optional
        Real, constant bulk modulus [Pa], > 0. Poisson's ratio is then complex and depends on frequency.
    density : float, default 0
        Density [kg/m³], ≥ 0; 0 neglects inertia.
    conductivity : float, optional
        Thermal conductivity [W/(m K)], > 0; only temperatures need it.

    Examples
    --------
    >>> from viscoroll import Elastic
    >>> Layer(thickness=1e-3, shear_modulus=Elastic(modulus=3e6), poisson_ratio=0.5)
    Layer(thickness=0.001, shear_modulus=Elastic(modulus=3000000.0), poisson_ratio=0.5, bulk_modulus=None, \
density=0.0, conductivity=None)
    """

    thickness: float
    shear_modulus: ShearModulusLike
    poisson_ratio: float | None = None
    bulk_modulus: float | None = None
    density: float = 0.0
    conductivity: float | None = None

    def __post_init__(self) -> None:
        """Store the numbers as floats and check the parameters."""
        store_floats(self, ("thickness", "density"), optional=("poisson_ratio", "bulk_modulus", "conductivity"))
        object.__setattr__(self, "shear_modulus", as_modulus(self.shear_modulus))
        if self.conductivity is not None:
            as_positive("layer.conductivity", self.conductivity, "W/(m K)")
        at_rest(self)._to_core()

    def _to_core(self) -> _core.Layer:
        return _core.Layer(thickness=self.thickness, **_material(self))


@dataclass(frozen=True, slots=True, kw_only=True)
class HalfSpace(ParameterTable):
    """Infinitely deep material below a plane surface; exactly one of `poisson_ratio` and `bulk_modulus` must be given.

    Parameters
    ----------
    shear_modulus, poisson_ratio, bulk_modulus, density
        Same as in `Layer`.

    Examples
    --------
    >>> from viscoroll import Elastic
    >>> HalfSpace(shear_modulus=Elastic(modulus=1e7), poisson_ratio=0.5).density
    0.0
    """

    shear_modulus: ShearModulusLike
    poisson_ratio: float | None = None
    bulk_modulus: float | None = None
    density: float = 0.0

    def __post_init__(self) -> None:
        """Store the numbers as floats and check the parameters."""
        store_floats(self, ("density",), optional=("poisson_ratio", "bulk_modulus"))
        object.__setattr__(self, "shear_modulus", as_modulus(self.shear_modulus))
        _core.CoatedPlane(layers=[], base=at_rest(self)._to_core())

    def _to_core(self) -> _core.HalfSpace:
        return _core.HalfSpace(**_material(self))


#: Type of an object with a shear modulus: layer or half-space.
Material = TypeVar("Material", bound="Layer | HalfSpace")


def _material(of: Layer | HalfSpace) -> dict[str, Any]:
    given = {name: getattr(of, name) for name in ("poisson_ratio", "bulk_modulus", "density")}
    return {"shear_modulus": to_core(of.shear_modulus), **given}


def at_rest(of: Material) -> Material:
    """Return a layer at vanishing strain: a modulus that depends on strain is replaced by its value at zero strain."""
    if not isinstance(of.shear_modulus, SofteningModulus):
        return of
    return replace(of, shear_modulus=of.shear_modulus.at(0.0, reference_frequency=1.0))


def as_layers(layers: object) -> tuple[Layer, ...]:
    """Return layers as a tuple; a single layer becomes a tuple of one.

    Raises
    ------
    TypeError
        If an element is not a layer.
    """
    layers = (layers,) if isinstance(layers, Layer) else layers
    if not isinstance(layers, Iterable):
        raise InvalidType("layers", "must be a sequence of viscoroll.Layer", shown(layers))
    layers = tuple(layers)
    for j, layer in enumerate(layers):
        require_type(f"layers[{j}]", layer, Layer)
    return layers
