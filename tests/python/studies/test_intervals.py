"""Studies of an uncertain material: intervals, their computation, and their use."""

from __future__ import annotations

import numpy as np
import pytest
import viscoroll as vr
import xarray
from campaign.intervals import ANSWERS, REFERENCE, Noise, coated, coverage, measured, of_curve, true_modulus
from scipy.stats import t as student
from viscoroll.studies.draws import drawn_scalars
from viscoroll.studies.picture import plot_study

#: The tests use rollers, which are solved fast.
CASE = {"load": 1e3, "angular_speed": 3.0, "mesh": vr.Mesh(nodes_per_revolution=1000), "progress": False}
DRAWS = 20


def drawn_material(seed, temperature):
    """Return draws of a rubber's modulus, fitted to data with 3 % noise."""
    curves = vr.rheology.superpose(measured(seed, Noise()), reference=REFERENCE).draws(DRAWS)
    return curves.map(lambda curve: curve.series_at(temperature=temperature))


@pytest.fixture(scope="module")
def material():
    return drawn_material(1, 333.15)


def drawn(dataset, name):
    return np.array([dataset[f"{name}{bound}"].item() for bound in ("", "_mean", "_lower", "_upper")])


def roller(modulus, thickness=2e-3):
    layer = vr.Layer(thickness=thickness, shear_modulus=modulus, poisson_ratio=0.5)
    return vr.CoatedCylinder(core_radius=20e-3, layers=[layer])


def on_a_stiff_layer(modulus):
    stiff = vr.Layer(thickness=1e-3, shear_modulus=5e7, poisson_ratio=0.45)
    return vr.CoatedCylinder(core_radius=20e-3, layers=[stiff, *roller(modulus).layers])


CASES = {
    "roller": (roller, {}),
    "two layers": (on_a_stiff_layer, {}),
    "friction": (roller, {"friction": 0.3, "drive": vr.Drive(creepage=2e-3)}),
    "ball": (coated, {"load": 20.0, "mesh": vr.Mesh(nodes_per_revolution=400)}),
}


@pytest.mark.parametrize("case", CASES)
def test_linear_intervals_agree_with_solved_draws(material, case):
    """The ends agree to a tenth of the half width of 2 %; second-order terms and joining nodes cause differences."""
    factory, given = CASES[case]
    linear, whole = (
        vr.sweep(factory, modulus=material, draws=method, **CASE | given) for method in ("linear", "solve")
    )
    for name in ("resisting_torque", "dissipated_power", "penetration"):
        (value, *bounds), (same, *others) = drawn(linear, name), drawn(whole, name)
        assert value == same
        np.testing.assert_allclose(bounds, others, atol=0.1 * (bounds[2] - bounds[1]) / 2.0)
    assert "contact_area_lower" not in linear
    assert "contact_area_lower" in whole


def test_intervals_agree_with_separate_solves(material):
    """Student's quantile for as many draws gives the interval around the result."""
    found = vr.sweep(roller, modulus=material, draws="solve", confidence=0.8, **CASE)
    given = {name: value for name, value in CASE.items() if name != "progress"}
    torques = [vr.solve(roller(modulus), **given).resisting_torque for modulus in material]
    value, mean, lower, upper = drawn(found, "resisting_torque")
    assert mean == pytest.approx(np.mean(torques), rel=1e-9)
    half = student.ppf(0.9, DRAWS - 1) * np.std(torques, ddof=1)
    assert (value - lower, upper - value) == pytest.approx((half, half), rel=1e-6)


def test_intervals_contain_the_true_value():
    """At least 9 of 12 intervals contain the truth: with 95 % coverage, 4 or more misses have a probability of 2e-3.

    `tests/campaign/intervals.py` tests two hundred data sets at five temperatures.
    """
    truth = vr.sweep(roller(true_modulus(333.15)), **CASE)
    inside = [coverage(vr.sweep(roller, modulus=drawn_material(seed, 333.15), **CASE), truth)[0] for seed in range(12)]
    for answer, share in zip(ANSWERS, np.mean(inside, axis=0), strict=True):
        assert share >= 0.75 or answer == "max_pressure", answer  # the largest pressure is at the edge here


def test_draws_can_be_stopped(material):
    """Ctrl-C stops a point between two solves of its draws."""

    def stop(stage, fraction):
        if stage == "draws" and fraction > 0.0:
            raise KeyboardInterrupt

    given = {name: value for name, value in CASE.items() if name != "progress"}
    result = vr.solve(roller(material.best_estimate), **given)
    with pytest.raises(KeyboardInterrupt):
        drawn_scalars(result, [(roller(one), None) for one in material], "linear", given, progress=stop)


def test_draws_of_two_materials_combine(material):
    """The draws are independent, so the squares of the scatter of both layers add up."""
    other = drawn_material(5, 343.15)

    def both(inner, outer):
        return vr.CoatedCylinder(core_radius=20e-3, layers=[*roller(inner).layers, *roller(outer).layers])

    def width(**moduli):
        found = vr.sweep(both, **moduli, **CASE)
        return (found.resisting_torque_upper - found.resisting_torque_lower).item()

    together = width(inner=material, outer=other)
    alone = np.hypot(width(inner=material, outer=other.best_estimate), width(inner=material.best_estimate, outer=other))
    assert together == pytest.approx(alone, rel=0.4)  # the correlation of 20 draws has a standard deviation of 0.2
    with pytest.raises(
        ValueError, match="draws must be equally many for each parameter, got 20 for inner, 2 for outer"
    ):
        width(inner=material, outer=vr.materials.Draws(other.best_estimate, other[:2]))


def test_draws_of_a_mat(material):
    """A counterbody may have draws: under a rigid roller, the scatter is that of a roller with the same coating."""
    mats = material.map(lambda modulus: vr.CoatedPlane(layers=roller(modulus).layers))
    # On a coarse mesh, nodes at the edge of the contact make the power scatter.
    fine = CASE | {"mesh": vr.Mesh(nodes_per_revolution=4000)}
    found = vr.sweep(vr.CoatedCylinder(core_radius=22e-3), on=mats, **fine)
    own = vr.sweep(roller, modulus=material, **fine)
    for name, allowed in (("penetration", 0.05), ("dissipated_power", 0.3)):
        half = [(study[f"{name}_upper"] / study[name] - 1.0).item() for study in (found, own)]
        # The cover of 2 mm is flat on the plane and curved on the roller's radius of 20 mm.
        assert half[0] == pytest.approx(half[1], rel=allowed)


def test_a_cache_keeps_draws(tmp_path, material, monkeypatch):
    given = CASE | {"load": [500.0, 1e3], "cache": tmp_path / "study.nc"}
    first = vr.sweep(roller, modulus=material, **given)
    assert first.resisting_torque_lower.attrs["units"] == "N m/m"
    assert first.resisting_torque_lower.attrs["long_name"].endswith("lower end of the 0.95 interval")
    assert (first.attrs["draws"], first.attrs["confidence"]) == ("20, linear", "0.95")
    monkeypatch.setattr("viscoroll.studies.run.drawn_scalars", None)  # no further solves
    xarray.testing.assert_identical(first, vr.sweep(roller, modulus=material, **given))
    wider = vr.sweep(roller, modulus=material, confidence=0.99, **given)
    half, wide = (study.resisting_torque - study.resisting_torque_lower for study in (first, wider))
    np.testing.assert_allclose(wide / half, student.ppf(0.995, DRAWS - 1) / student.ppf(0.975, DRAWS - 1))


def test_draws_that_fail_leave_no_interval(material):
    """The result remains, with a warning; an interval without the failed draws would be biased."""
    soft = vr.materials.Draws(material.best_estimate, [material[0], vr.Elastic(modulus=1e3)])
    with pytest.warns(vr.ResultWarning, match=r"among 1 points: .*1 NO_INTERVAL"):
        found = vr.sweep(roller, modulus=soft, draws="solve", **CASE)
    assert found.resisting_torque > 0.0
    assert "resisting_torque_lower" not in found
    assert found.error.item().startswith("draws: InvalidInput: load must be")
    thick = vr.materials.Draws(2e-3, [2e-3, 2.1e-3])
    with pytest.warns(vr.ResultWarning, match="1 NO_INTERVAL"):
        found = vr.sweep(roller, modulus=material.best_estimate, thickness=thick, **CASE)
    assert "draws must differ only in shear moduli for draws='linear'" in found.error.item()


def test_linear_intervals_of_widely_scattered_draws_are_rejected():
    """With draws ten times as soft and as stiff, the interval would include negative torques."""
    found_one = vr.StandardLinearSolid(instantaneous_modulus=6e6, relaxed_modulus=3e6, relaxation_time=0.1)
    far = vr.materials.Draws(found_one, [vr.Elastic(modulus=3e5), vr.Elastic(modulus=3e7)])
    with pytest.warns(vr.ResultWarning, match="1 NO_INTERVAL"):
        found = vr.sweep(roller, modulus=far, **CASE)
    assert "draws must change the penetration by at most 25% for draws='linear'" in found.error.item()
    assert "resisting_torque_lower" not in found


def test_a_largest_pressure_at_the_edge_has_no_linear_interval():
    """If the material enters stiff, the first nodes have the largest pressure: at 50 °C, but not at 70 °C."""
    draws = vr.rheology.superpose(measured(3, Noise()), reference=REFERENCE).draws(3)
    given = {"load": 30.0, "angular_speed": 3.0, "mesh": vr.Mesh(nodes_per_revolution=1500), "progress": False}
    found = vr.sweep(of_curve, curve=draws, temperature=[323.15, 343.15], **given)
    assert np.isnan(found.max_pressure_lower).values.tolist() == [True, False]
    assert np.isfinite(found.penetration_lower).all()


def test_draws_of_other_parameters_can_be_solved(material):
    """The thickness may vary as well if each draw is solved."""
    thick = vr.materials.Draws(2e-3, [1.9e-3, 2.1e-3])
    found = vr.sweep(roller, modulus=material.best_estimate, thickness=thick, draws="solve", **CASE)
    assert found.resisting_torque_lower < found.resisting_torque < found.resisting_torque_upper


def test_draws_of_filled_rubber_are_solved(material):
    network = vr.materials.KrausNetwork(storage=1e6, loss=2e5, critical_strain=0.02)
    filled = vr.materials.Draws(material.best_estimate, material[:2]).map(
        lambda matrix: vr.materials.SofteningModulus(matrix=matrix, network=network)
    )
    found = vr.sweep(roller, modulus=filled, draws="solve", **CASE)
    given = {name: value for name, value in CASE.items() if name != "progress"}
    torques = [vr.strain_softening(roller(modulus), **given).result.resisting_torque for modulus in filled]
    assert found.resisting_torque_mean.item() == pytest.approx(np.mean(torques), rel=1e-9)


def test_bad_arguments(material):
    with pytest.raises(ValueError, match="draws must be 'linear' or 'solve', got 'whole'"):
        vr.sweep(roller, modulus=material, draws="whole", **CASE)
    with pytest.raises(ValueError, match=r"confidence must be in \(0, 1\), got 95"):
        vr.sweep(roller, modulus=material, confidence=95, **CASE)
    with pytest.raises(TypeError, match=r"load must be a real number, got .*2 draws of 20"):
        vr.sweep(roller, modulus=material, **CASE | {"load": vr.materials.Draws(20.0, [19.0, 21.0])})
    with pytest.raises(TypeError, match="give its best_estimate, or pass all draws to sweep"):
        roller(material)
    network = vr.materials.KrausNetwork(storage=1e6, loss=2e5, critical_strain=0.02)
    filled = material.map(lambda matrix: vr.materials.SofteningModulus(matrix=matrix, network=network))
    with pytest.raises(ValueError, match="draws must be 'solve' if layers soften with strain, got 'linear'"):
        vr.sweep(roller, modulus=filled, **CASE)


def test_a_picture_has_bands(material):
    found = vr.sweep(roller, modulus=material, **CASE | {"load": [500.0, 700.0, 1e3], "angular_speed": [1.0, 3.0]})
    (axes,) = plot_study(found).axes
    assert len(axes.collections) == 2
    edge = axes.collections[1].get_paths()[0].vertices
    lower = 1e3 * found.resisting_torque_lower.sel(angular_speed=3.0)  # [mN]
    assert edge[:, 1].min() == pytest.approx(lower.min().item())
    assert axes.get_title().endswith("bands contain the true value with a probability of 0.95")
    assert not plot_study(found, variable="contact_area").axes[0].collections
    texts = vr.sweep(roller, modulus=[material, material.map(lambda m: m)], **CASE)
    assert len(plot_study(texts).axes[0].collections) == 1
