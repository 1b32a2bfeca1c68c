"""Figure 4: radial sub-intervals, the paper's product (32) compared with the exact step of a layer."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from .. import paper
from .._core import Compliance, Curvature
from .._support.arguments import Floats
from .._support.extras import extra
from .._support.pictures import Picture
from ..modal import surface_compliance
from ..rolling import solve
from . import plain
from .item import Runner, Table, Verdict

if TYPE_CHECKING:
    from ..bodies import Mesh

__all__ = ["Figure4", "compute_figure4"]

#: Positions α of the nodes of (32) within their sub-intervals. The paper does not specify α in [0, 1].
_ALPHAS = (0.0, 0.5, 1.0)
#: Values of the paper: best estimate of the torque [N m], to which its errors are relative; bound of the error [-] and
#: number of sub-intervals from which on it holds.
_BEST_ESTIMATE, _BOUND, _ENOUGH = 11.44e-3, 3e-5, 10


@dataclass(frozen=True, slots=True, kw_only=True)
class Figure4:
    """Torques [N m] of the product by α and number of sub-intervals, of the exact step, and of the solver."""

    counts: list[int]
    by_product: dict[float, list[float]]
    exact: float
    solver: float

    def errors(self, alpha: float) -> Floats:
        """Return the relative errors of the product against the exact step [-], by number of sub-intervals."""
        return np.asarray(np.abs(np.array(self.by_product[alpha]) / self.exact - 1.0))

    def tables(self) -> dict[str, Table]:
        """Return a table with one row for each number of sub-intervals."""
        columns: dict[str, list[float]] = {"sub_intervals [1]": list(self.counts)}
        for alpha, torques in self.by_product.items():
            columns[f"torque_alpha_{alpha:g} [N m]"] = torques
            columns[f"error_alpha_{alpha:g} [1]"] = self.errors(alpha).tolist()
        return {"": columns | {"exact_torque [N m]": [self.exact] * len(self.counts)}}

    def draw(self) -> Picture:
        """Plot the errors as a function of the number of sub-intervals."""
        figure = Picture(figsize=(6.6, 4.6), layout="constrained")
        axes = figure.subplots()
        for alpha in self.by_product:
            axes.loglog(self.counts, self.errors(alpha) * 100.0, ".-", label=f"product (32), $\\alpha$ = {alpha:g}")
        axes.hlines(
            _BOUND * 100.0, _ENOUGH, max(self.counts), color="k", linestyle="--", label="paper: bound for $n_r$ ≥ 10"
        )
        axes.axhline(
            abs(self.exact / self.solver - 1.0) * 100.0,
            color="0.5",
            linestyle=":",
            label="exact step: NumPy against C++",
        )
        axes.set(xlabel="radial sub-intervals $n_r$", ylabel="error of $T_r$ against the exact step [%]")
        axes.legend(fontsize="small")
        return figure

    def verdicts(self) -> list[Verdict]:
        """Compare the errors with the paper's bound, and the exact step with the solver."""
        enough = np.array(self.counts) >= _ENOUGH
        worst = {alpha: float(self.errors(alpha)[enough].max()) for alpha in self.by_product}
        found = ", ".join(f"{error * 100.0:.2g} % (position {alpha:g})" for alpha, error in worst.items())
        offset = self.exact / _BEST_ESTIMATE - 1.0
        difference = abs(self.exact / self.solver - 1.0)
        return [
            Verdict(
                statement="error of the torque at most 3·10⁻³ % with n_r ≥ 10 sub-intervals",
                found=f"{found} relative to the exact step, where the position is that of A_k within its sub-interval; "
                f"the exact step on this mesh differs by {offset * 100.0:+.1f} % from the paper's best estimate of "
                "11.44 mN m",
                agrees=worst[0.5] <= _BOUND,
            ),
            Verdict(
                statement="n_r = 50 sub-intervals; viscoroll uses one exact step",
                found=f"the exact steps in NumPy and C++ differ by a fraction of {difference:.0e}",
                agrees=difference < 1e-6,
                by_mesh=False,
            ),
        ]


def compute_figure4(runner: Runner) -> Figure4:
    """Solve with the compliance of each number of sub-intervals, with everything else unchanged."""
    counts = [1, 2, 5, 10, 20] if runner.coarse else [*range(1, 21), 25, 30, 35, 40, 45, 50]
    ball = paper.ball(density=0.0)
    layer = plain.Layer(ball.core_radius, ball.outer_radius, lambda omega: plain.prony(6e6, [0.5], [0.125], omega), 0.5)
    contact = _RadialContact(runner.mesh, ball.outer_radius)
    orders = contact.orders
    at_rest = 3e6

    def product(point: tuple[float, int]) -> float:
        alpha, count = point
        compliance = plain.surface_compliance([layer], paper.ANGULAR_SPEED, 0, orders, count, alpha)
        return contact.torque(compliance[:, 0, 0].real * at_rest)

    points = [(alpha, count) for alpha in _ALPHAS for count in counts]
    torques = dict(zip(points, runner.map(product, points), strict=True))
    exact = surface_compliance(ball, paper.ANGULAR_SPEED, 0, orders, curvature=Curvature.PAPER)[:, 0, 0].real * at_rest
    solver = solve(
        ball,
        load=paper.LOAD,
        angular_speed=paper.ANGULAR_SPEED,
        mesh=runner.mesh,
        compliance=Compliance.RADIAL,
        curvature=Curvature.PAPER,
    )
    return Figure4(
        counts=counts,
        by_product={alpha: [torques[alpha, count] for count in counts] for alpha in _ALPHAS},
        exact=contact.torque(exact),
        solver=solver.resisting_torque,
    )


class _RadialContact:
    """Example of the paper without inertia, in plain NumPy, for any radial compliance.

    The compliance of a single layer is G(k) / μ*(mΩ) with k² = m² + n², so the function G defines it.
    """

    def __init__(self, mesh: Mesh, radius: float) -> None:
        assert mesh.max_order is not None, "the paper's meshes have a truncation order"
        self._max_order = mesh.max_order
        top = int(np.ceil(np.hypot(mesh.max_order, mesh.max_order)))
        #: Orders k at which G is evaluated; steps of 2 % resolve it to 1e-8.
        self.orders = np.unique([*range(41), *np.geomspace(40, top, 1 + int(50 * np.log(top / 40))).astype(int), top])
        self._mesh, self._radius = mesh, radius
        # Half of the window: 4.2 mm, for a contact of 3 mm.
        self._half = int(np.ceil(0.2 / mesh.spacing))

    def torque(self, function: Floats) -> float:
        """Return the resisting torque [N m] for the values [m] of G at `orders`."""
        spacing, half, radius = self._mesh.spacing, self._half, self._radius
        table = self._table(function)
        offset = np.arange(-half, half + 1)
        row, column = (a.ravel() for a in np.meshgrid(offset, offset, indexing="ij"))
        matrix = table[row[:, None] - row + 2 * half, column[:, None] - column + 2 * half]
        phi, theta = 0.5 * np.pi + spacing * row, 0.5 * np.pi + spacing * column
        profile = radius * np.sin(theta) * np.sin(phi)
        force, _ = plain.solve_normal_contact(matrix, profile, paper.LOAD)
        return float(-(radius * np.sin(theta) * np.cos(phi) * force).sum())

    def _table(self, function: Floats) -> Floats:
        """Return the sum of equation (53) over all orders, for all offsets between two nodes of the window."""
        with extra("studies"):
            from scipy.interpolate import CubicSpline

        spacing, top = self._mesh.spacing, self._max_order
        orders = np.arange(-top, top + 1)
        modulus = plain.prony(6e6, [0.5], [0.125], np.abs(orders) * paper.ANGULAR_SPEED)
        modulus = np.where(orders < 0, modulus.conj(), modulus)
        compliance = CubicSpline(self.orders, function)(np.hypot(orders[:, None], orders)) / modulus[:, None]
        patch = np.sinc(orders * spacing / (2.0 * np.pi)) / (2.0 * np.pi * self._radius)
        waves = np.exp(1j * spacing * np.outer(np.arange(-2 * self._half, 2 * self._half + 1), orders)) * patch
        return np.asarray((waves @ compliance @ waves.T).real)
