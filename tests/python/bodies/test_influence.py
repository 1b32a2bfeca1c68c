"""Influence tables and the rotated compliance, compared with direct sums of the paper's equations."""

from __future__ import annotations

import itertools

import numpy as np
import pytest
import viscoroll as vr
from reference import boundary
from reference import layers as reference
from viscoroll import enums

SPEED, MESH, HALF_WIDTHS = 2.5, vr.Mesh(nodes_per_revolution=48, max_order=40), (2, 3)


@pytest.fixture(scope="module")
def nodes():
    return boundary.nodes(MESH.spacing, *HALF_WIDTHS)


def order_compliance(ball):
    return lambda m, n: vr.modal.surface_compliance(ball, SPEED, m.astype(int), n.astype(int))


def table_matrix(ball, **options):
    """Expand the tables over all pairs of nodes; shape (3, 3, nodes, nodes)."""
    reach = tuple(2 * h for h in HALF_WIDTHS)
    tables = vr.modal.influence_tables(ball, SPEED, MESH, reach=reach, **options)
    j, k = (a.ravel() for a in np.meshgrid(*(np.arange(-h, h + 1) for h in HALF_WIDTHS), indexing="ij"))
    return tables[:, :, j[:, None] - j + reach[0], k[:, None] - k + reach[1]]


def test_tables_are_the_direct_sum_of_all_orders(two_layer_ball, nodes):
    # Other tests check single orders. This test checks aliasing, symmetries and transforms against equation (53).
    expected = boundary.compliance_matrix(
        order_compliance(two_layer_ball), MESH.max_order, two_layer_ball.outer_radius, MESH.spacing, *nodes
    )
    matrix = table_matrix(two_layer_ball)
    # Tolerance: round-off of sums of 6561 terms; the series in n are resolved to 1e-13.
    np.testing.assert_allclose(matrix, expected, rtol=0.0, atol=1e-12 * expected[0, 0].max())


def test_tables_agree_with_an_independent_computation_from_the_moduli(two_layer_ball, nodes):
    layers = [
        reference.Layer(20e-3, 22e-3, lambda w: reference.prony(6e6, [0.5], [0.125], w), 0.45, 1000.0),
        reference.Layer(22e-3, 23e-3, lambda w: np.full(np.shape(w), 2e6 + 0j), 0.3, 1500.0),
    ]

    def compliance(m, n):
        # The fields are real: compliances of opposite orders are complex conjugates.
        half = reference.extrapolated_compliance(layers, SPEED, m[MESH.max_order :], n[MESH.max_order :], (5, 10, 20))
        return np.concatenate([half[:0:-1, ::-1].conj(), half])

    expected = boundary.compliance_matrix(compliance, MESH.max_order, two_layer_ball.outer_radius, MESH.spacing, *nodes)
    # Tolerance: error of the reference, which is extrapolated from 5, 10 and 20 radial sub-intervals, at order 40.
    tables = table_matrix(two_layer_ball, curvature=enums.Curvature.PAPER)
    np.testing.assert_allclose(tables, expected, rtol=0.0, atol=1e-8 * expected[0, 0].max())


@pytest.mark.parametrize(("nodes_per_revolution", "max_order"), [(48, 24), (48, 96), (48, 130), (49, 25), (49, 120)])
def test_aliasing_for_any_ratio_of_orders_to_nodes(paper_ball, nodes_per_revolution, max_order):
    mesh = vr.Mesh(nodes_per_revolution=nodes_per_revolution, max_order=max_order)
    tables = vr.modal.influence_tables(paper_ball, SPEED, mesh, reach=1)
    nodes = boundary.nodes(mesh.spacing, 1, 1)
    expected = boundary.compliance_matrix(
        order_compliance(paper_ball), max_order, paper_ball.outer_radius, mesh.spacing, *nodes
    )
    center = expected[:, :, :, 4].reshape(3, 3, 3, 3)
    np.testing.assert_allclose(tables, center, rtol=0.0, atol=1e-12 * center[0, 0].max())


def test_tables_do_not_depend_on_threads_or_reach(paper_ball):
    small = vr.modal.influence_tables(paper_ball, SPEED, MESH, reach=(2, 1), threads=1)
    np.testing.assert_array_equal(small, vr.modal.influence_tables(paper_ball, SPEED, MESH, reach=(2, 1), threads=3))
    large = vr.modal.influence_tables(paper_ball, SPEED, MESH, reach=(5, 6), threads=3)
    np.testing.assert_allclose(small, large[:, :, 3:8, 5:8], rtol=0.0, atol=1e-14 * large.max())


def test_tables_are_mirror_symmetric_in_theta(two_layer_ball):
    tables = vr.modal.influence_tables(two_layer_ball, SPEED, MESH, reach=5)
    odd = np.array([[1, 1, -1], [1, 1, -1], [-1, -1, 1]])[:, :, None, None]
    np.testing.assert_allclose(tables[..., ::-1], odd * tables, rtol=0.0, atol=1e-14 * tables.max())


def test_viscoelastic_tables_are_asymmetric_in_phi(paper_ball):
    radial = vr.modal.influence_tables(paper_ball, SPEED, MESH, reach=6)[0, 0]
    # The material leaves the loaded patch towards larger phi, where it has not yet recovered.
    behind, ahead = radial[7:, 6], radial[5::-1, 6]
    assert (np.abs(behind - ahead) > 1e-3 * radial.max()).any()
    elastic = vr.CoatedSphere(
        core_radius=20e-3,
        layers=[vr.Layer(thickness=1e-3, shear_modulus=vr.Elastic(modulus=3e6), poisson_ratio=0.5)],
    )
    radial = vr.modal.influence_tables(elastic, SPEED, MESH, reach=6)[0, 0]
    np.testing.assert_allclose(radial[::-1], radial, rtol=0.0, atol=1e-14 * radial.max())


@pytest.mark.parametrize("reach", [25, (0, 25), -1])
def test_reach_is_limited_to_half_a_revolution(paper_ball, reach):
    with pytest.raises(ValueError, match=r"reach must be in \[0, 24\] \(at most half of the nodes per revolution\)"):
        vr.modal.influence_tables(paper_ball, SPEED, MESH, reach=reach)


def test_different_spacings_in_phi_and_theta(two_layer_ball):
    """The load on a patch equals equal loads on three adjacent patches of a third of its width in theta."""
    wide = vr.modal.influence_tables(two_layer_ball, SPEED, vr.Mesh(nodes_per_revolution=120), reach=4)
    mesh = vr.Mesh(nodes_per_revolution=120, theta_nodes_per_revolution=360)
    narrow = vr.modal.influence_tables(two_layer_ball, SPEED, mesh, reach=(4, 13))
    offsets = 13 + 3 * np.arange(-4, 5)
    together = (narrow[..., offsets - 1] + narrow[..., offsets] + narrow[..., offsets + 1]) / 3.0
    # Both tables contain all orders, to nine digits of their central values.
    np.testing.assert_allclose(together, wide, rtol=0.0, atol=1e-8 * wide.max())


def test_truncated_sums_converge_to_the_sum_of_all_orders(paper_ball):
    """The truncation orders are odd multiples of half the nodes per revolution, at which errors cancel in pairs."""
    all_orders = vr.modal.influence_tables(paper_ball, SPEED, vr.Mesh(nodes_per_revolution=48), reach=3)
    errors = [
        np.abs(
            vr.modal.influence_tables(paper_ball, SPEED, vr.Mesh(nodes_per_revolution=48, max_order=n), reach=3)
            - all_orders
        )
        for n in (72, 216, 648, 1944)
    ]
    largest = [error.max() / all_orders.max() for error in errors]
    # The truncation error is proportional to the square of the transform of a patch at the truncation order, 1/N_t^2: a
    # ninth for three times the order.
    assert all(finer < coarser / 4.0 for coarser, finer in itertools.pairwise(largest))
    assert largest[-1] < 1e-5


@pytest.mark.parametrize("nodes", [2_000, 50_000, 1_000_000])
def test_fine_meshes_agree_with_a_half_space(nodes):
    """For patches much smaller than the coating is thick, compare with Love's square patch on a half-space."""
    modulus = 3e6
    layer = vr.Layer(thickness=20e-3, shear_modulus=vr.Elastic(modulus=modulus), poisson_ratio=0.5)
    ball = vr.CoatedSphere(core_radius=0.0, layers=[layer], inner_boundary=enums.InnerBoundary.SOLID)
    mesh = vr.Mesh(nodes_per_revolution=nodes)
    radial = vr.modal.influence_tables(ball, 1.0, mesh, reach=6)[0, 0]
    side = 20e-3 * mesh.spacing
    # A. E. H. Love, Phil. Trans. R. Soc. A 228 (1929) 377-420; K. L. Johnson, Contact Mechanics, equation (3.25).
    x, y = (side * offset for offset in np.meshgrid(np.arange(-6, 7), np.arange(-6, 7), indexing="ij"))

    def corner(x, y):
        return x * np.arcsinh(y / np.abs(x)) + y * np.arcsinh(x / np.abs(y))

    h = 0.5 * side
    love = corner(x + h, y + h) + corner(x - h, y - h) - corner(x + h, y - h) - corner(x - h, y + h)
    love *= 0.5 / (2.0 * np.pi * modulus * side**2)  # (1 - nu) / (2 pi G) per unit force
    # Tolerance: curvature of the ball over a few spacings.
    np.testing.assert_allclose(radial, love, rtol=0.0, atol=max(10.0 * mesh.spacing, 1e-8) * love.max())


def test_coating_thinner_than_the_mesh_spacing():
    """A thin incompressible coating is most compliant at orders far above those that the mesh resolves."""
    layer = vr.Layer(thickness=0.25e-3, shear_modulus=vr.Elastic(modulus=3e6), poisson_ratio=0.5)
    ball = vr.CoatedSphere(core_radius=20e-3, layers=[layer])  # a fifth of a spacing
    all_orders = vr.modal.influence_tables(ball, 1.0, vr.Mesh(nodes_per_revolution=100), reach=2)[0, 0]
    truncated = vr.modal.influence_tables(ball, 1.0, vr.Mesh(nodes_per_revolution=100, max_order=8050), reach=2)[0, 0]
    # Tolerance: orders above 8050 contribute (100 / 8050)^2 of a half-space's compliance at the center.
    np.testing.assert_allclose(all_orders, truncated, rtol=0.0, atol=1e-3 * truncated.max())
