"""Rolling of filled rubber: limits without iteration, scaling, convergence, and input checks."""

from __future__ import annotations

import math

import matplotlib as mpl
import numpy as np
import pytest
import viscoroll as vr
from shared_cases import RUBBER, coated_ball, one_layer
from viscoroll.coupled.softening_search import SofteningSearch, softening_layers

mpl.use("Agg")

NETWORK = vr.materials.MasingNetwork(storage=6e6, critical_strain=0.01)
TREAD = vr.materials.SofteningModulus(matrix=RUBBER, network=NETWORK)

#: A strain above 0.2 is expected in these cases.
pytestmark = pytest.mark.filterwarnings("ignore::viscoroll.ResultWarning")


def roller(shear_modulus=TREAD, *, thickness=10e-3, poisson_ratio=0.5):
    layer = one_layer(shear_modulus, thickness=thickness, poisson_ratio=poisson_ratio)
    return vr.CoatedCylinder(core_radius=50e-3, layers=[layer])


def softened(body, load=2e3, nodes=600, **others):
    return vr.strain_softening(body, load=load, angular_speed=2.5, mesh=vr.Mesh(nodes_per_revolution=nodes), **others)


@pytest.fixture(scope="module")
def soft_roller():
    return softened(roller())


def test_without_a_network_the_result_is_that_of_solve():
    linear = vr.solve(roller(RUBBER), load=2e3, angular_speed=2.5, mesh=vr.Mesh(nodes_per_revolution=600))
    found = softened(roller(RUBBER))
    assert found.torque_bounds == (linear.resisting_torque, linear.resisting_torque)
    np.testing.assert_array_equal(found.result.pressure, linear.pressure)


def test_a_network_of_large_critical_strain_is_linear():
    network = vr.materials.StrainSweep(
        strain=[1e-4, 1e-2, 1.0], storage=[5e6] * 3, loss=[4e5] * 3, matrix=vr.Elastic(modulus=3e6), frequency=1.0
    )
    tread = vr.materials.SofteningModulus(matrix=RUBBER, network=network)
    found = softened(roller(tread), loss="harmonic")
    contact = found.result
    frequency = 2.5 * contact.body.outer_radius / contact.semi_axis_x
    linear = tread.at(0.5, reference_frequency=frequency)
    expected = vr.solve(roller(linear), load=2e3, angular_speed=2.5, mesh=contact.mesh)
    # The frequency belongs to the previous iteration, whose half-width is accurate to one node.
    assert contact.resisting_torque == pytest.approx(expected.resisting_torque, rel=2e-3)
    assert contact.penetration == pytest.approx(expected.penetration, rel=2e-3)


def test_a_network_without_loss_gives_the_torque_of_its_moduli():
    network = vr.materials.KrausNetwork(storage=6e6, loss=0.0, critical_strain=0.01)
    found = softened(roller(vr.materials.SofteningModulus(matrix=RUBBER, network=network)))
    assert found.loss_scales == (1.0,)
    assert found.network_share == 0.0
    assert found.torque_bounds[0] == pytest.approx(found.torque_bounds[1], rel=1e-9)


def test_the_amplitude_is_a_fixed_point(soft_roller):
    """A solve with the moduli at the found amplitude has the same amplitude, to the tolerance."""
    modulus = soft_roller.result.body.layers[0].shear_modulus
    storage = NETWORK.at(soft_roller.layer_amplitudes[0])[0]
    assert modulus.network.modulus == pytest.approx(storage, rel=1e-12)
    assert soft_roller.history[-1] == pytest.approx(soft_roller.layer_amplitudes, rel=1e-3)
    assert soft_roller.iterations <= 20


def test_iteration_from_a_larger_strain_converges_to_the_same_amplitude(soft_roller):
    search = search_of(roller(), nodes=600)
    start = search.at(np.array([0.5]), np.ones(1))
    state = search.converged(start, matched=True, tolerance=1e-4)
    assert state.amplitudes == pytest.approx(soft_roller.layer_amplitudes, rel=3e-3)  # tolerance 1e-3 / (1 - 0.42)
    assert state.result.resisting_torque == pytest.approx(soft_roller.torque_bounds[1], rel=3e-3)


def test_scaling_of_moduli(soft_roller):
    """Three times the moduli under three times the load give the same strain."""
    rubber = vr.StandardLinearSolid(instantaneous_modulus=18e6, relaxed_modulus=9e6, relaxation_time=0.125)
    network = vr.materials.MasingNetwork(storage=18e6, critical_strain=0.01)
    found = softened(roller(vr.materials.SofteningModulus(matrix=rubber, network=network)), load=6e3)
    assert found.layer_amplitudes == pytest.approx(soft_roller.layer_amplitudes, rel=1e-6)
    assert np.array(found.torque_bounds) / 3.0 == pytest.approx(soft_roller.torque_bounds, rel=1e-6)


def test_scaling_of_lengths(soft_roller):
    """A line load and lengths twice as large give the same strain."""
    layer = one_layer(TREAD, thickness=20e-3)
    found = softened(vr.CoatedCylinder(core_radius=0.1, layers=[layer]), load=4e3)
    assert found.layer_amplitudes == pytest.approx(soft_roller.layer_amplitudes, rel=1e-6)
    assert np.array(found.torque_bounds) / 4.0 == pytest.approx(soft_roller.torque_bounds, rel=1e-6)


def test_sublayers_equal_separate_layers():
    cut = softened(roller(), sublayers=2, loss="harmonic")
    halves = [one_layer(TREAD, thickness=5e-3)] * 2
    given = softened(vr.CoatedCylinder(core_radius=50e-3, layers=halves), loss="harmonic")
    assert cut.layer_amplitudes == given.layer_amplitudes
    assert cut.result.resisting_torque == given.result.resisting_torque


def test_sublayers_change_the_torque_little(soft_roller):
    """docs/theory/filled-rubber.md: the torque changes by about 3 % at equal load."""
    cut = softened(roller(), sublayers=3)
    assert cut.torque_bounds == pytest.approx(soft_roller.torque_bounds, rel=0.04)


def search_of(body, *, nodes, load=2e3):
    return SofteningSearch(
        body=body,
        on=None,
        layers=softening_layers(body, None),
        load=load,
        angular_speed=2.5,
        options={"angular_speed": 2.5, "mesh": vr.Mesh(nodes_per_revolution=nodes)},
        depths=4,
        report=None,
    )


#: Bodies whose strain at given load varies with the modulus as G^-α, and the tolerance of this limit.
SLOPES = {
    "thick roller": (lambda m: roller(m, thickness=40e-3), 100.0, 12000, 1 / 2, 0.02),
    "thin compressible roller": (lambda m: roller(m, thickness=1e-4, poisson_ratio=0.0), 2e4, 3000, 2 / 3, 0.02),
    "thin incompressible roller": (lambda m: roller(m, thickness=1e-4), 4e4, 16000, 3 / 5, 0.04),
    "thick ball": (lambda m: coated_ball(m, core_radius=6e-3, thickness=15e-3), 0.2, 3000, 1 / 3, 0.03),
}


@pytest.mark.parametrize("name", SLOPES)
def test_slope_of_the_iteration(name):
    """The slope d ln g/d ln G is -α, computed from two moduli of an elastic layer."""
    make, load, nodes, alpha, tolerance = SLOPES[name]
    network = vr.materials.KrausNetwork(storage=1e7, loss=0.0, critical_strain=0.01)
    body = make(vr.materials.SofteningModulus(matrix=vr.Elastic(modulus=1e7), network=network))
    search = search_of(body, nodes=nodes, load=load)
    strains = np.array([0.001, 0.1])
    found = [search.at(np.array([strain]), np.ones(1)).layers[0].found.amplitude for strain in strains]
    moduli = 1e7 + network.at(strains)[0]
    slope = math.log(found[1] / found[0]) / math.log(moduli[1] / moduli[0])
    assert -slope == pytest.approx(alpha, rel=tolerance)


def test_base_ball():
    """Compare torques, relative to those of the rubber without network, with another program; "network" to 3 %."""
    ball = coated_ball(TREAD)
    mesh = vr.Mesh(nodes_per_revolution=600)
    linear = vr.solve(coated_ball(), load=100.0, angular_speed=2.5, mesh=mesh)
    found = vr.strain_softening(ball, load=100.0, angular_speed=2.5, mesh=mesh)
    harmonic, matched = np.array(found.torque_bounds) / linear.resisting_torque
    assert harmonic == pytest.approx(1.67, abs=0.015)
    assert matched == pytest.approx(1.43, abs=0.04)
    assert found.iterations <= 20


def test_identical_rollers_soften_equally():
    """Two identical rollers have the same strain."""
    found = softened(roller(), on=roller(), load=4e3)
    assert found.layer_amplitudes[0] == pytest.approx(found.layer_amplitudes[1], rel=1e-6)
    assert found.loss_scales[0] == pytest.approx(found.loss_scales[1], rel=1e-6)
    sides = [found.amplitude(of=of).amplitude.to_numpy() for of in ("body", "counterbody")]
    np.testing.assert_allclose(*sides, rtol=1e-6)


def test_a_half_space_softens_with_friction():
    plane = vr.CoatedPlane(
        layers=[one_layer(RUBBER, thickness=2e-3)], base=vr.HalfSpace(shear_modulus=TREAD, poisson_ratio=0.5)
    )
    found = softened(vr.CoatedCylinder(core_radius=50e-3), on=plane, load=1e3, nodes=1200, friction=0.3)
    assert found.result.friction == 0.3
    assert isinstance(found.result.on.base.shear_modulus, type(TREAD.at(0.1, reference_frequency=1.0)))
    assert 0.0 < found.layer_amplitudes[0] < found.largest_amplitudes[0]


def test_warnings_about_strain(soft_roller):
    assert any("linear theory is inaccurate above 0.2" in text for text in softened(coated_ball(TREAD), 100.0).warnings)
    sweep = vr.materials.StrainSweep(strain=[1e-4, 1e-3, 1e-2], storage=[9e6, 8e6, 6e6], loss=[4e5, 8e5, 9e5])
    tread = vr.materials.SofteningModulus(matrix=RUBBER, network=sweep)
    with pytest.warns(
        vr.ResultWarning, match="is outside the sweep, 0.0001 to 0.01; moduli outside are those at its ends"
    ):
        softened(roller(tread), loss="harmonic")
    assert "resisting torque T_r" in repr(soft_roller)
    assert "harmonic torque" in soft_roller._repr_html_()


def test_files_and_pictures(soft_roller, tmp_path):
    soft_roller.save(tmp_path / "soft.csv")
    rows = dict(line.split(",")[:2] for line in (tmp_path / "soft.csv").read_text().splitlines())
    assert float(rows["network_torque"]) == soft_roller.torque_bounds[1]
    soft_roller.save(tmp_path / "soft.nc")
    assert (tmp_path / "soft.nc").stat().st_size > 0
    assert len(soft_roller.plot().axes) == 2


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({"loss": "both"}, "loss must be 'network' or 'harmonic', got 'both'"),
        ({"sublayers": 0}, r"sublayers must be in \[1, 20\], got 0"),
        ({"depths": 1}, r"depths must be in \[2, 20\], got 1"),
        ({"tolerance": 1.0}, r"tolerance must be in \[1e-09, 0\.1\], got 1"),
    ],
)
def test_bad_arguments(given, message):
    with pytest.raises(ValueError, match=message):
        softened(roller(), **given)
