"""Newton's method for a cover in contact with a rigid surface."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from .._core import ConvergenceError
from .._support.extras import extra
from .cover import Cover, CoverState

if TYPE_CHECKING:
    from numpy.typing import NDArray
    from scipy.sparse import csc_matrix

    from .contact import RigidSurface

    Floats = NDArray[np.float64]

__all__ = ["Equilibrium", "Rolling", "Target"]

#: Largest residual of a solution, relative to the largest nodal force.
_TOLERANCE = 1e-9

#: Newton steps after which a solution has failed. With a good prediction, 4 to 8 suffice.
_MOST_STEPS = 30

#: Largest change of a displacement in one step, in units of the thickness of the cover.
_LARGEST_STEP = 0.5


@dataclass(frozen=True, eq=False)
class Target:
    """Condition that closes the equations: a penetration or a load, in units of outer radius and modulus.

    Attributes
    ----------
    value : float
    is_load : bool
    """

    value: float
    is_load: bool = False


@dataclass(frozen=True, eq=False)
class Rolling:
    """Unknowns of one equilibrium.

    Attributes
    ----------
    displacement : ndarray, shape (nodes, 2)
    pressures : ndarray, shape (elements, 3)
    forces : ndarray, shape (surface nodes,)
        Nodal contact forces.
    penetration : float
    newton_steps, linear_iterations : int
    """

    displacement: Floats
    pressures: Floats
    forces: Floats
    penetration: float
    newton_steps: int = 0
    linear_iterations: int = 0

    def toward(self, earlier: Rolling, penetration: float) -> Rolling:
        """Return the linear extrapolation from an earlier equilibrium through this one to a penetration."""
        share = (penetration - self.penetration) / (self.penetration - earlier.penetration)

        def beyond(name: str) -> Any:
            value = getattr(self, name)
            return value + share * (value - getattr(earlier, name))

        return replace(self, **{name: beyond(name) for name in ("displacement", "pressures", "forces", "penetration")})


class Equilibrium:
    """Equations of a cover in contact with a rigid surface.

    The unknowns are, in this order, the displacements of all nodes but those on the core, the pressures, the contact
    forces of the candidate nodes, and the penetration.

    Parameters
    ----------
    cover : Cover
    surface : RigidSurface
    """

    def __init__(self, cover: Cover, surface: RigidSurface) -> None:
        self.cover, self.surface = cover, surface
        mesh = cover.mesh
        self._positions = mesh.positions
        self._nodes = mesh.surface
        self._thickness = mesh.radii[-1] - mesh.radii[0]
        fixed = np.zeros(len(self._positions), dtype=bool)
        fixed[mesh.core] = True
        self._free = np.flatnonzero(~np.repeat(fixed, 2))
        #: Column of each displacement among the unknowns; -1 on the core.
        self._column = np.full(2 * len(self._positions), -1)
        self._column[self._free] = np.arange(len(self._free))
        elements = len(mesh.nodes)
        self._first_force = len(self._free) + 3 * elements
        self._size = self._first_force + len(self._nodes) + 1
        dofs = self._column[cover.dofs]
        pressures = len(self._free) + np.arange(3 * elements).reshape(elements, 3)
        self._surface_columns = self._column[2 * self._nodes[:, None] + np.arange(2)]
        u_rows, u_columns = _grid(dofs, dofs)
        c_rows, c_columns = _grid(dofs, pressures)
        v_rows, v_columns = _grid(pressures, pressures)
        self._rows = np.concatenate([u_rows, c_rows, c_columns, v_rows])
        self._columns = np.concatenate([u_columns, c_columns, c_rows, v_columns])
        self._kept = (self._rows >= 0) & (self._columns >= 0)
        self._rows, self._columns = self._rows[self._kept], self._columns[self._kept]

    def start(self, penetration: float) -> Rolling:
        """Return the undeformed cover at a penetration."""
        return Rolling(
            displacement=np.zeros_like(self._positions),
            pressures=np.zeros((len(self.cover.mesh.nodes), 3)),
            forces=np.zeros(len(self._nodes)),
            penetration=penetration,
        )

    def solve(self, guess: Rolling, target: Target) -> tuple[Rolling, CoverState]:
        """Solve from a guess.

        Raises
        ------
        ConvergenceError
            If Newton's method does not converge.
        """
        cover, free = self.cover, self._free
        displacement, pressures = guess.displacement.copy(), guess.pressures.copy()
        forces, penetration = guess.forces.copy(), guess.penetration
        if not target.is_load:
            penetration = target.value
        gaps, _, _ = self.surface.gap(self._surface_positions(displacement), penetration)
        # A force of the order of the modulus times the spacing weighs against a gap.
        stiffness = float(cover.mesh.slopes.max()) * float(np.mean(np.diff(cover.mesh.angles)))
        active = forces - stiffness * gaps > 0.0
        iterations = 0
        for step in range(_MOST_STEPS):
            state = cover.state(displacement, pressures)
            gaps, normals, slopes = self.surface.gap(self._surface_positions(displacement), penetration)
            internal = cover.forces(state)
            forces = np.where(active, forces, 0.0)
            residual = np.zeros(self._size)
            balance = internal.copy()
            np.add.at(balance, 2 * self._nodes[:, None] + np.arange(2), -forces[:, None] * normals)
            residual[: len(free)] = balance[free]
            residual[len(free) : self._first_force] = cover.volume_errors(state).ravel()
            residual[self._first_force : -1] = np.where(active, gaps, 0.0)
            residual[-1] = forces @ normals[:, 1] - target.value if target.is_load else penetration - target.value
            scale = max(float(np.abs(internal).max()), 1e-12)
            converged = np.abs(residual[: len(free)]).max() < _TOLERANCE * scale and np.abs(
                residual[len(free) :]
            ).max() < _TOLERANCE * max(penetration, 1e-12)
            wrong = (active & (forces < 0.0)) | (~active & (gaps < 0.0))
            if converged and step > 0 and not wrong.any():
                return Rolling(displacement, pressures, forces, penetration, step, iterations), state
            matrix = self._matrix(state, forces, normals, slopes, active, target)
            change, used = self._correct(state, matrix, residual)
            iterations += used
            largest = np.abs(change[: len(free)]).max()
            if not np.isfinite(largest):
                break
            share = min(1.0, _LARGEST_STEP * self._thickness / max(largest, 1e-300))
            displacement.reshape(-1)[free] -= share * change[: len(free)]
            pressures -= share * change[len(free) : self._first_force].reshape(pressures.shape)
            forces -= share * change[self._first_force : -1]
            penetration -= share * change[-1]
            gaps, _, _ = self.surface.gap(self._surface_positions(displacement), penetration)
            active = np.where(active, forces > 0.0, gaps < 0.0)
            if not active.any():
                active = gaps <= gaps.min()
        raise ConvergenceError(f"the contact did not converge within {_MOST_STEPS} Newton steps")

    def _surface_positions(self, displacement: Floats) -> Floats:
        return np.asarray(self._positions[self._nodes] + displacement[self._nodes])

    def _matrix(
        self,
        state: CoverState,
        forces: Floats,
        normals: Floats,
        slopes: Floats,
        active: NDArray[np.bool_],
        target: Target,
    ) -> csc_matrix:
        """Return the local part of the tangent."""
        with extra("studies"):
            from scipy.sparse import coo_matrix
        stiffness, coupling, volume = self.cover.blocks(state)
        values = np.concatenate([stiffness.ravel(), coupling.ravel(), coupling.ravel(), volume.ravel()])[self._kept]
        columns = self._surface_columns[active]
        multipliers = self._first_force + np.arange(len(self._nodes))
        m = multipliers[active]
        pair = np.repeat(m[:, None], 2, axis=1)
        normal = normals[active]
        turn_rows, turn_columns = _grid(columns, columns)
        last = self._size - 1
        parts = [
            (self._rows, self._columns, values),
            (columns.ravel(), pair.ravel(), -normal.ravel()),
            (turn_rows, turn_columns, -(forces[active, None, None] * slopes[active]).ravel()),
            (pair.ravel(), columns.ravel(), normal.ravel()),
            (m, np.full(len(m), last), -normal[:, 1]),
            (multipliers[~active], multipliers[~active], np.ones(np.count_nonzero(~active))),
        ]
        if target.is_load:
            parts.append((np.full(len(m), last), m, normal[:, 1]))
        else:
            parts.append((np.array([last]), np.array([last]), np.ones(1)))
        rows, cols, entries = (np.concatenate([part[k] for part in parts]) for k in range(3))
        return coo_matrix((entries, (rows, cols)), shape=(self._size, self._size)).tocsc()

    def _correct(self, state: CoverState, matrix: csc_matrix, residual: Floats) -> tuple[Floats, int]:
        """Solve with the whole tangent, preconditioned by the factors of its local part."""
        with extra("studies"):
            from scipy.sparse.linalg import LinearOperator, gmres, splu
        cover, free = self.cover, self._free
        factors = splu(matrix)
        full, count = np.zeros(2 * len(self._positions)), 0

        def times(vector: Floats) -> Floats:
            full[free] = vector[: len(free)]
            result = matrix @ vector
            result[: len(free)] += cover.memory_forces(state, full)[free]
            return np.asarray(result)

        def counted(_: object) -> None:
            nonlocal count
            count += 1

        shape = (self._size, self._size)
        solution, _ = gmres(
            LinearOperator(shape, matvec=lambda v: times(factors.solve(v))),
            residual,
            rtol=1e-6,
            restart=40,
            maxiter=2,
            callback=counted,
            callback_type="pr_norm",
        )
        return factors.solve(solution), count


def _grid(rows: NDArray[np.intp], columns: NDArray[np.intp]) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
    """Return row and column of every entry of blocks, for the rows and columns of each block."""
    shape = (len(rows), rows.shape[1], columns.shape[1])
    return (
        np.broadcast_to(rows[:, :, None], shape).ravel(),
        np.broadcast_to(columns[:, None, :], shape).ravel(),
    )
