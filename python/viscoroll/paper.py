"""The example of the paper and the numbers printed in it.

G.-P. Zéhil and H. P. Gavin, "Rolling resistance of a rigid sphere with viscoelastic coatings", section 14.
"""

from __future__ import annotations

from .bodies import CoatedSphere, Layer, Mesh
from .materials import StandardLinearSolid

__all__ = ["ANGULAR_SPEED", "LOAD", "TABLE_2", "TABLE_3", "TABLE_4", "ball", "table_2_meshes"]

#: P of section 14 [N].
LOAD = 100.0

#: Ω of section 14 [rad/s].
ANGULAR_SPEED = 2.5

#: Truncation orders N_t that head the columns of table 2.
_ORDERS = (250, 500, 750, 1000, 1250, 1500)

#: Table 2: resisting torque [N m] by nodes per revolution 2π/Δ and truncation order. For truncation orders below π/Δ
#: the paper prints "N/A".
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

#: Table 3: ends of the 95 % intervals of a_p [N^(1-b) m] and b_p [-] of T_r = a_p P^b_p, by thickness h [m]. The
#: columns "H = 1 mm" and "H = 5 mm" of the paper are exchanged: the power laws then agree with table 2 at 100 N and
#: 1 mm.
TABLE_3: dict[float, dict[str, tuple[float, float]]] = {
    5e-3: {"a": (4.766e-5, 5.037e-5), "b": (1.418, 1.430)},
    1e-3: {"a": (2.097e-5, 2.321e-5), "b": (1.344, 1.368)},
}

#: Table 4: ends of the 95 % intervals of a_h [N m], b_h [m^-c] and c_h [-] of T_r = a_h tanh(b_h h^c_h), by load [N].
TABLE_4: dict[float, dict[str, tuple[float, float]]] = {
    25.0: {"a": (0.670e-2, 0.677e-2), "b": (69.702, 78.446), "c": (0.809, 0.827)},
    50.0: {"a": (1.997e-2, 2.018e-2), "b": (64.898, 71.332), "c": (0.821, 0.835)},
    75.0: {"a": (3.770e-2, 3.811e-2), "b": (61.842, 67.310), "c": (0.827, 0.840)},
    100.0: {"a": (5.895e-2, 5.972e-2), "b": (58.431, 64.205), "c": (0.828, 0.842)},
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
