"""Internal forces of the cover and their derivatives."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from .history import memory_matrix
from .laws import Elasticity, Law, Strain, measure, viscous_map

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

    from .mesh import RingMesh

    Floats = NDArray[np.float64]

__all__ = ["Cover", "CoverMaterial", "CoverState"]

#: Derivatives of C₁₁, C₂₂ and C₁₂ by the components of the Green strain that are conjugate to the stress.
_TWICE = np.array([2.0, 2.0, 1.0])


@dataclass(frozen=True, eq=False)
class CoverMaterial:
    """Material of one layer; moduli are in any common unit.

    Attributes
    ----------
    relaxed : float
        Relaxed shear modulus.
    moduli, lags : ndarray, shape (k,)
        Moduli of the terms, and angles by which the roller turns in their relaxation times [rad].
    volume_compliance : float
        Reciprocal of the first Lamé constant; 0 for an incompressible layer.
    """

    relaxed: float
    moduli: Floats
    lags: Floats
    volume_compliance: float


@dataclass(frozen=True, eq=False)
class CoverState:
    """Stresses and derivatives at given displacements; arrays begin with (elements, Gauss points).

    Attributes
    ----------
    gradient : ndarray, shape (m n, 6, 2, 2)
        Columns ∂x/∂R and ∂x/(R ∂φ) of the deformation gradient, as rows.
    strain : Strain
        Right Cauchy-Green tensor.
    pressure : ndarray, shape (m n, 6)
        Multiplier of incompressibility.
    stress, viscous : ndarray, shape (m n, 6, 3)
        Second Piola-Kirchhoff stress and its viscous part.
    local : ndarray, shape (m n, 6, 3, 3)
        Derivative of the stress by C at constant memory.
    by_memory, measure_slope : ndarray, shape (m n, 6, 3, 3)
        Derivatives of the stress by the memory and of the strain measure by C.
    operator : ndarray, shape (m n, 6, 3, 18)
        Derivatives of the Green strain by the displacements of the nodes.
    """

    gradient: Floats
    strain: Strain
    pressure: Floats
    stress: Floats
    viscous: Floats
    local: Floats
    by_memory: Floats
    measure_slope: Floats
    operator: Floats


class Cover:
    """Cover of a roller in steady rotation: internal forces as a function of displacements and pressures.

    Unknowns are the displacements of the nodes along the ground and upwards, of shape (nodes, 2), and three pressures
    of each element.

    Parameters
    ----------
    mesh : RingMesh
        Mesh; lengths are in units of the outer radius.
    materials : sequence of CoverMaterial
        One material for each layer.
    law : Law
        Law of the viscous stress.
    elasticity : Elasticity
        Elastic law of the relaxed network and, apart from the law `newton`, of the strain measure.
    """

    def __init__(self, mesh: RingMesh, materials: Sequence[CoverMaterial], law: Law, elasticity: Elasticity) -> None:
        self.mesh, self.law, self.elasticity = mesh, law, elasticity
        m, n = mesh.shape
        self._relaxed = np.tile([materials[j].relaxed for j in mesh.layers], m)
        self._volume = np.tile([materials[j].volume_compliance for j in mesh.layers], m)
        #: For each layer: its columns along the radius, and its memory matrix if it is viscoelastic.
        self._memories = [
            (np.repeat(mesh.layers == layer, 3), memory_matrix(mesh.gauss_angles, material.moduli, material.lags))
            for layer, material in enumerate(materials)
            if len(material.moduli)
        ]
        diagonal = np.zeros((2 * m, 3 * n))
        for columns, matrix in self._memories:
            diagonal[:, columns] = np.diag(matrix)[:, None]
        self._diagonal = mesh.by_element(diagonal)[..., 0]
        self.dofs = (2 * mesh.nodes[:, :, None] + np.arange(2)).reshape(m * n, 18)

    def memory(self, values: Floats) -> Floats:
        """Return Σ μ_i H_i of a strain measure at the Gauss points, or its linear change."""
        ring = self.mesh.by_ring(values)
        result = np.zeros_like(ring)
        for columns, matrix in self._memories:
            part = ring[:, columns]
            result[:, columns] = (matrix @ part.reshape(len(part), -1)).reshape(part.shape)
        return self.mesh.by_element(result)

    def state(self, displacement: Floats, pressures: Floats) -> CoverState:
        """Return stresses and derivatives for displacements, of shape (nodes, 2), and pressures, (elements, 3)."""
        mesh = self.mesh
        gradient = mesh.directions + mesh.slopes @ displacement[mesh.nodes][:, None]
        product = gradient @ gradient.swapaxes(-1, -2)
        strain = Strain(np.stack([product[..., 0, 0], product[..., 1, 1], product[..., 0, 1]], axis=-1))
        pressure = pressures @ mesh.pressure_shapes.T
        relaxed, relaxed_slope = self.elasticity.relaxed(strain)
        value, measure_slope = measure(self.law, self.elasticity, strain)
        viscous, by_memory, by_strain = viscous_map(self.law, strain, self.memory(value))
        # The pressure adds p J C⁻¹.
        scaled = (pressure * strain.jacobian)[..., None]
        modulus = self._relaxed[:, None, None]
        local = modulus[..., None] * relaxed_slope + by_strain
        local += scaled[..., None] * (
            strain.inverse_slope + 0.5 * strain.inverse[..., :, None] * strain.log_slope[..., None, :]
        )
        slopes = mesh.slopes
        operator = np.stack(
            [
                slopes[..., 0, :, None] * gradient[..., None, 0, :],
                slopes[..., 1, :, None] * gradient[..., None, 1, :],
                slopes[..., 1, :, None] * gradient[..., None, 0, :]
                + slopes[..., 0, :, None] * gradient[..., None, 1, :],
            ],
            axis=2,
        ).reshape(*gradient.shape[:2], 3, 18)
        return CoverState(
            gradient=gradient,
            strain=strain,
            pressure=pressure,
            stress=modulus * relaxed + scaled * strain.inverse + viscous,
            viscous=viscous,
            local=local,
            by_memory=by_memory,
            measure_slope=measure_slope,
            operator=operator,
        )

    def forces(self, state: CoverState) -> Floats:
        """Return the internal forces of the nodes, of shape (2 nodes,)."""
        loaded = self.mesh.weights[..., None] * state.stress
        return self.assemble(np.einsum("egkd,egk->ed", state.operator, loaded, optimize=True))

    def volume_errors(self, state: CoverState) -> Floats:
        """Return the residuals of J - 1 = p/λ, weighted with the pressure shapes, of shape (elements, 3)."""
        error = state.strain.jacobian - 1.0 - self._volume[:, None] * state.pressure
        return (self.mesh.weights * error) @ self.mesh.pressure_shapes

    def assemble(self, values: Floats) -> Floats:
        """Sum values of the elements, of shape (elements, 18), into the nodes."""
        size = 4 * self.mesh.shape[0] * len(self.mesh.radii)
        return np.asarray(np.bincount(self.dofs.ravel(), values.ravel(), minlength=size), dtype=float)

    def blocks(self, state: CoverState) -> tuple[Floats, Floats, Floats]:
        """Return the element matrices of the local part of the tangent.

        The local part includes the diagonal of the memory.

        Returns
        -------
        stiffness : ndarray, shape (elements, 18, 18)
            Derivatives of the forces by the displacements.
        coupling : ndarray, shape (elements, 18, 3)
            Derivatives of the forces by the pressures, and transposed those of the volume by the displacements.
        volume : ndarray, shape (elements, 3, 3)
            Derivatives of the residuals of the volume by the pressures.
        """
        mesh, weights = self.mesh, self.mesh.weights
        slope = state.local + self._diagonal[..., None, None] * (state.by_memory @ state.measure_slope)
        slope = (weights[..., None, None] * slope) * _TWICE
        elements = len(weights)
        flat = state.operator.reshape(elements, 18, 18)
        stiffness = flat.swapaxes(1, 2) @ (slope @ state.operator).reshape(elements, 18, 18)
        # The geometric part: S : (∂N/∂X ⊗ ∂N/∂X), equal for both components of the displacement.
        s = weights[..., None] * state.stress
        tensor = np.stack([s[..., 0], s[..., 2], s[..., 2], s[..., 1]], axis=-1).reshape(elements, 6, 2, 2)
        flat_slopes = mesh.slopes.reshape(elements, 12, 9)
        geometric = flat_slopes.swapaxes(1, 2) @ (tensor @ mesh.slopes).reshape(elements, 12, 9)
        stiffness.reshape(elements, 9, 2, 9, 2)[:, :, 0, :, 0] += geometric
        stiffness.reshape(elements, 9, 2, 9, 2)[:, :, 1, :, 1] += geometric
        cofactor = (weights * state.strain.jacobian)[..., None] * state.strain.inverse
        coupling = np.einsum("egkd,egk,gq->edq", state.operator, cofactor, mesh.pressure_shapes, optimize=True)
        shapes = mesh.pressure_shapes
        volume = -np.einsum("e,eg,gp,gq->epq", self._volume, weights, shapes, shapes, optimize=True)
        return stiffness, coupling, volume

    def memory_forces(self, state: CoverState, change: Floats) -> Floats:
        """Return the part of the change of the forces that `blocks` omits: memory of other points.

        Parameters
        ----------
        change : ndarray, shape (2 nodes,)
            Change of the displacements.
        """
        strain = _TWICE * (state.operator @ change[self.dofs][:, None, :, None])[..., 0]
        measured = (state.measure_slope @ strain[..., None])[..., 0]
        nonlocal_part = self.memory(measured) - self._diagonal[..., None] * measured
        stress = self.mesh.weights[..., None] * (state.by_memory @ nonlocal_part[..., None])[..., 0]
        return self.assemble(np.einsum("egkd,egk->ed", state.operator, stress, optimize=True))

    def dissipation(self, state: CoverState) -> Floats:
        """Return the dissipated energy per angle and volume at the Gauss points, of shape (2 m, 3 n).

        It is the work of the viscous stress between neighboring points of a ring, half of which each of them takes.
        """
        green = 0.5 * self.mesh.by_ring(state.strain.c)
        viscous = self.mesh.by_ring(state.viscous) * np.array([1.0, 1.0, 2.0])
        increments = np.roll(green, -1, axis=0) - green
        work = 0.5 * np.einsum("jik,jik->ji", viscous + np.roll(viscous, -1, axis=0), increments)
        return np.asarray(0.5 * (work + np.roll(work, 1, axis=0)) / self.angle_weights[:, None])

    @property
    def angle_weights(self) -> Floats:
        """Half of the angle between the neighbors of each Gauss point on a ring [rad]."""
        angle = self.mesh.gauss_angles
        return 0.5 * ((np.roll(angle, -1) - np.roll(angle, 1)) % (2.0 * np.pi))
