"""The example of the paper and the numbers printed in it.

G.-P. Zéhil and H. P. Gavin, "Rolling resistance of a rigid sphere with viscoelastic coatings", section 14.
"""

from __future__ import annotations

from .geometry import CoatedSphere, Layer
from .materials import StandardLinearSolid
from .mesh import Mesh

__all__ = ["ANGULAR_SPEED", "LOAD", "TABLE_2", "ball", "table_2_meshes"]

#: P of section 14 [N].
LOAD = 100.0

#: Ω of section 14 [rad/s].
ANGULAR_SPEED = 2.5

#: Truncation orders N_t that head the columns of table 2.
_ORDERS = (250, 500, 750, 1000, 1250, 1500)

#: Table 2: resisting torque [N m] by nodes per revolution 2π/Δ and truncation order. The entries left out are "N/A":
#: fewer orders than π/Δ.
TABLE_2: dict[tuple[int, int], float] = {
    (nodes, order): torque * 1e-3
    for nodes, torques in {
        100: (10.50, 10.36, 10.43, 10.46, 10.44, 10.43),
        150: (11.42, 11.47, 11.50, 11.44, 11.43, 11.42),
        200: (11.22, 11.01, 11.01, 11.03, 11.01, 11.01),
        300: (11.09, 11.10, 11.11, 11.10, 11.11, 11.10),
        400: (11.33, 11.31, 11.32, 11.32, 11.31, 11.32),
        500: (11.41, 11.38, 11.39, 11.40, 11.40, 11.39),
        600: (None, 11.42, 11.41, 11.42, 11.43, 11.42),
        700: (None, 11.45, 11.44, 11.45, 11.44, 11.45),
        800: (None, 11.45, 11.44, 11.44, 11.44, 11.44),
    }.items()
    for order, torque in zip(_ORDERS, torques, strict=True)
    if torque is not None
}


def ball(*, thickness: float = 1e-3, core_radius: float = 20e-3, density: float = 1000.0) -> CoatedSphere:
    """Return the ball of section 14: one incompressible standard linear solid on a rigid core.

    Parameters
    ----------
    thickness : float, default 1e-3
        h [m].
    core_radius : float, default 20e-3
        r_i [m].
    density : float, default 1000
        ρ [kg/m³].
    """
    rubber = StandardLinearSolid(instantaneous_modulus=6e6, relaxed_modulus=3e6, relaxation_time=0.125)
    layer = Layer(thickness=thickness, shear_modulus=rubber, poisson_ratio=0.5, density=density)
    return CoatedSphere(core_radius=core_radius, layers=[layer])


def table_2_meshes() -> dict[tuple[int, int], Mesh]:
    """Return the mesh of every entry of table 2."""
    return {key: Mesh(nodes_per_revolution=key[0], max_order=key[1]) for key in TABLE_2}
