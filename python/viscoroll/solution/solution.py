"""Solution of a contact: its scalars, and its fields on the mesh."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, fields
from typing import TYPE_CHECKING, Any, Literal, Self

import numpy as np

from .. import _core
from .._core import Compliance, Curvature, PatchLoad, Status, WarningKind
from .._support.extras import extra
from .._support.scalars import with_scalars
from .._support.units import unit_in_contact
from ..bodies import Adhesion, Counterbody, Drive, Mesh, RollingBody
from .scalars import SCALARS, ScalarFields

if TYPE_CHECKING:
    import xarray
    from numpy.typing import NDArray

__all__ = ["FIELDS", "VECTOR_FIELDS", "Refinement", "Solution", "described", "given_of", "node_angles", "node_spacings"]


@dataclass(frozen=True, slots=True, kw_only=True)
class Refinement:
    """One of the meshes that the solver tried when it chose the mesh itself.

    Attributes
    ----------
    mesh : Mesh
        Mesh of this step.
    contact_nodes : int
        Number of nodes in contact.
    resisting_torque : float
        Resisting torque T_r [N m].
    penetration : float or None
        Penetration r_o - H [m]; None if it is undetermined.
    energy_balance_error : float
        Relative energy-balance error [-].
    error_estimate : float
        The larger of the energy-balance error and the changes from the previous mesh [-]; 1 on the first mesh.
    """

    mesh: Mesh
    contact_nodes: int
    resisting_torque: float
    penetration: float | None
    energy_balance_error: float
    error_estimate: float

    @classmethod
    def _from_core(cls, step: _core.Refinement) -> Refinement:
        values = {field.name: getattr(step, field.name) for field in fields(cls)}
        return cls(**values | {"mesh": Mesh._from_core(step.mesh)})


#: Unit and description of each scalar field on the mesh, by name.
FIELDS = {
    "x": ("m", "forward coordinate of the undeformed node"),
    "z": ("m", "lateral coordinate of the undeformed node"),
    "pressure": ("Pa", "contact pressure"),
    "displacement": ("m", "vertical displacement of the surface, upwards"),
    "gap": ("m", "height of the surface above the counterbody"),
    "contact": ("1", "whether the node is in contact"),
    "stick": ("1", "whether the node sticks to the counterbody"),
    "slip": ("1", "whether the node is in contact and slips"),
}

#: Unit and description of each vector field, with components along x and z.
VECTOR_FIELDS = {
    "shear_traction": ("Pa", "traction of the counterbody on the rolling body"),
    "slip_velocity": ("m/s", "velocity of the rolling body relative to the counterbody, in contact"),
}


@with_scalars(_core.result_scalars())
@dataclass(frozen=True, slots=True, kw_only=True, eq=False, repr=False)
class Solution(ScalarFields):
    """Solution of one load case on the candidate window.

    In line contact (`CoatedCylinder`), fields have one column, and forces are per length [N/m], as are torques
    [N m/m], powers [W/m] and the contact area [m]; `unit` returns the unit of a result.

    Fields are read-only arrays of shape (nodes in φ, nodes in θ). Material crosses the contact towards growing φ, from
    the leading edge (x > 0) to the trailing edge.

    Attributes
    ----------
    body, on, angular_speed, friction, drive, adhesion, compliance, curvature, patch_load
        Input; angular_speed in [rad/s].
    prescribed : {"load", "penetration"}
        Which of load and penetration was given; the other one is a result.
    status : Status
        Outcome of the solve.
    %(scalars)s
    mesh : Mesh
        Mesh of this solution.
    refinements : tuple of Refinement
        Meshes that the solver tried, from coarse to fine.
    warnings : dict of WarningKind to str
        Texts of the warnings (`ResultWarning`) of the solve, by kind.
    x, z : ndarray
        Coordinates of the undeformed nodes [m]: x forward, z sideways.
    pressure : ndarray
        Contact pressure, positive [Pa].
    displacement : ndarray
        Vertical displacement of the surface, positive upwards [m]; relative to that of the lowest point if the
        penetration is undetermined.
    gap : ndarray
        Height of the surface above the counterbody [m].
    contact, stick, slip : ndarray of bool
        Nodes that are in contact, and those of them that stick and that slip. Without friction, all nodes in contact
        slip.
    shear_traction : ndarray, shape (2, nodes in φ, nodes in θ)
        Traction of the counterbody on the rolling body, along x and z [Pa].
    slip_velocity : ndarray, shape (2, nodes in φ, nodes in θ)
        Velocity of the rolling body's surface relative to the counterbody, along x and z [m/s]; zero outside the
        contact and without friction.
    """

    body: RollingBody
    on: Counterbody | None
    prescribed: Literal["load", "penetration"]
    angular_speed: float
    friction: float
    drive: Drive
    adhesion: Adhesion | None
    compliance: Compliance
    curvature: Curvature
    patch_load: PatchLoad
    status: Status
    mesh: Mesh
    refinements: tuple[Refinement, ...]
    warnings: dict[WarningKind, str]
    x: NDArray[np.float64]
    z: NDArray[np.float64]
    pressure: NDArray[np.float64]
    displacement: NDArray[np.float64]
    gap: NDArray[np.float64]
    contact: NDArray[np.bool_]
    stick: NDArray[np.bool_]
    slip: NDArray[np.bool_]
    shear_traction: NDArray[np.float64]
    slip_velocity: NDArray[np.float64]

    def __post_init__(self) -> None:
        """Make the arrays read-only."""
        for name in (*FIELDS, *VECTOR_FIELDS):
            getattr(self, name).flags.writeable = False

    def __reduce__(self) -> tuple[Callable[..., Solution], tuple[type[Solution], dict[str, Any]]]:
        """Copy and pickle through the constructor, which makes the arrays of the copy read-only."""
        return _rebuilt, (type(self), {field.name: getattr(self, field.name) for field in fields(self)})

    @classmethod
    def _from_core(cls, solution: _core.Result, **inputs: Any) -> Self:
        names = {field.name for field in fields(cls)} - inputs.keys()
        values = {name: getattr(solution, name) for name in names}
        values["mesh"] = Mesh._from_core(solution.mesh)
        values["refinements"] = tuple(Refinement._from_core(step) for step in solution.refinements)
        for name in ("contact", "stick", "slip"):
            values[name] = getattr(solution, name).view(np.bool_)
        return cls(**inputs, **values)

    @property
    def unprescribed(self) -> Literal["load", "penetration"]:
        """Which of load and penetration is a result."""
        return "load" if self.prescribed == "penetration" else "penetration"

    def unit(self, name: str) -> str:
        """Return the unit of a scalar result; for a roller, forces and powers are per length.

        Raises
        ------
        KeyError
            If the name is not that of a scalar result.

        Examples
        --------
        >>> from viscoroll import paper, solve
        >>> solve(paper.ball(), load=100.0, angular_speed=2.5, accuracy=0.05).unit("bulk_power")
        'W'
        """
        return unit_in_contact(SCALARS[name][0], line_contact=self.body.line_contact)

    def scalars(self) -> dict[str, float | int | str | None]:
        """Return scalar results, input and mesh sizes by name in SI units, and names of status, options, warnings."""
        values: dict[str, float | int | str | None] = {name: getattr(self, name) for name in SCALARS}
        values |= {
            "angular_speed": self.angular_speed,
            "friction": self.friction,
            "status": self.status.name,
            "contact_nodes": int(self.contact.sum()),
            "nodes_per_revolution": self.mesh.nodes_per_revolution,
            "theta_nodes_per_revolution": _theta_nodes_per_revolution(self),
            "max_order": self.mesh.max_order,
            "compliance": self.compliance.name,
            "curvature": self.curvature.name,
            "patch_load": self.patch_load.name,
            "warnings": ", ".join(kind.name for kind in self.warnings),
        }
        return values

    def to_xarray(self) -> xarray.Dataset:
        """Return fields and scalars as a dataset over the angles φ and θ of the nodes.

        Returns
        -------
        xarray.Dataset
            Fields with units over `phi` and `theta` [rad], scalars as attributes.

        Raises
        ------
        ImportError
            If the extra `viscoroll[files]` is missing.
        """
        with extra("files"):
            import xarray

        angles = zip(("phi", "theta"), node_angles(self), strict=True)
        coordinates = {name: (name, values, {"units": "rad"}) for name, values in angles}
        variables = {
            name: (dimensions, getattr(self, name), described(*text))
            for table, dimensions in ((FIELDS, ("phi", "theta")), (VECTOR_FIELDS, ("direction", "phi", "theta")))
            for name, text in table.items()
        }
        attributes = {name: value for name, value in self.scalars().items() if value is not None}
        return xarray.Dataset(variables, coordinates | {"direction": ["x", "z"]}, attrs=attributes)


def described(unit: str, text: str) -> dict[str, str]:
    """Return the attributes of a field in a dataset: its unit and description."""
    return {"units": unit, "long_name": text}


def given_of(solution: Solution) -> dict[str, float | str]:
    """Return the input of a solution as attributes for datasets of its interior."""
    return {
        "load": solution.load,
        "angular_speed": solution.angular_speed,
        "compliance": solution.compliance.name,
        "curvature": solution.curvature.name,
    }


def node_angles(solution: Solution) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return φ of the rows and θ of the columns of the fields [rad]."""
    phi, theta = (
        0.5 * np.pi + spacing * (np.arange(count) - count // 2)
        for count, spacing in zip(solution.pressure.shape, node_spacings(solution), strict=True)
    )
    return phi, theta


def node_spacings(solution: Solution) -> tuple[float, float]:
    """Return the angles between rows and between columns of the fields [rad]."""
    return solution.mesh.spacing, 2.0 * np.pi / _theta_nodes_per_revolution(solution)


def _theta_nodes_per_revolution(solution: Solution) -> float:
    """Return 2π/Δθ: that of the mesh, or for a wheel the value for which whole columns fill its width."""
    columns = solution.z.shape[1]
    if solution.body.width is not None and columns > 1:
        return float(2.0 * np.pi * solution.body.outer_radius * (columns - 1) / np.ptp(solution.z[0]))
    return solution.mesh.theta_nodes_per_revolution or solution.mesh.nodes_per_revolution


def _rebuilt(kind: type[Solution], values: dict[str, Any]) -> Solution:
    return kind(**values)
