"""Sweeps of histories: dimensions, energy beside flat ground, cache, progress and failures."""

from __future__ import annotations

import numpy as np
import pytest
import viscoroll as vr
from shared_cases import one_layer
from viscoroll.studies import sweep_histories

ROLLER = vr.CoatedCylinder(core_radius=50e-3, layers=[one_layer(thickness=10e-3)])
MESH = vr.Mesh(nodes_per_revolution=300)


def over_bump(speed, height, material=None):
    body = (
        ROLLER
        if material is None
        else vr.CoatedCylinder(core_radius=50e-3, layers=[one_layer(material, thickness=10e-3)])
    )
    return {
        "body": body,
        "time": np.array([0.0, 40e-3 / speed]),
        "distance": [0.0, 40e-3],
        "load": 5e3,
        "ground": None if height == 0.0 else vr.Profile.half_sine(height, length=20e-3, at=22e-3),
        "mesh": MESH,
        "averaged_meshes": 1,
    }


def test_results_are_those_of_single_histories():
    counts = []
    study = sweep_histories(
        over_bump,
        speed=[0.06, 0.6],
        height=[0.0, 1e-3],
        progress=lambda stage, fraction: counts.append((stage, fraction)),
    )
    assert study.largest_resisting_force.dims == ("speed", "height")
    assert study.largest_resisting_force.units == "N/m"
    assert study.obstacle_energy.units == "J/m"
    flat, bump = (vr.roll(**over_bump(0.6, height)) for height in (0.0, 1e-3))
    point = study.sel(speed=0.6, height=1e-3)
    assert float(point.largest_resisting_force) == bump.resisting_force.max()
    lost = bump.dissipated_energy[-1] - flat.dissipated_energy[-1]
    assert float(point.obstacle_energy) == pytest.approx(lost, rel=1e-12)
    np.testing.assert_array_equal(study.obstacle_energy.sel(height=0.0), 0.0)
    assert counts[-1] == ("motions", 1.0)
    assert len(counts) == 4  # the histories on flat ground are points of the study themselves


def test_a_cache_keeps_the_histories(tmp_path, monkeypatch):
    cache = tmp_path / "bumps.nc"
    first = sweep_histories(over_bump, speed=[0.6], height=[0.5e-3, 1e-3], cache=cache, progress=False)
    computed = []
    roll = vr.studies.histories.roll
    monkeypatch.setattr(vr.studies.histories, "roll", lambda **given: computed.append(1) or roll(**given))
    again = sweep_histories(over_bump, speed=[0.6], height=[0.5e-3, 1e-3], cache=cache, progress=False)
    assert not computed
    np.testing.assert_array_equal(again.obstacle_energy, first.obstacle_energy)
    sweep_histories(over_bump, speed=[0.6], height=[0.5e-3, 1e-3, 1.5e-3], cache=cache, progress=False)
    assert len(computed) == 1


def test_profiles_of_many_points_have_different_keys(tmp_path):
    """NumPy shortens the text of long arrays."""

    def motion(lump):
        distance = np.linspace(0.0, 40e-3, 2001)
        height = np.where(np.abs(distance - 20e-3) < 5e-3, lump, 0.0)
        return over_bump(0.6, 1e-3) | {"ground": vr.Profile(distance, height)}

    study = sweep_histories(motion, lump=[0.2e-3, 0.4e-3], cache=tmp_path / "lumps.nc", progress=False)
    assert np.diff(study.largest_resisting_force)[0] > 0.0


def test_a_failed_point_has_its_message():
    with pytest.warns(vr.ResultWarning, match="among 2 points: 1 FAILED; see error"):
        study = sweep_histories(
            over_bump, speed=0.6, height=0.0, material={"rubber": None, "wrong": "soft"}, progress=False
        )
    assert np.isnan(study.largest_load.sel(material="wrong"))
    assert "shear_modulus must be a modulus" in str(study.error.sel(material="wrong").item())


def test_messages():
    with pytest.raises(TypeError, match="motion, called with speed: missing a required argument: 'height'"):
        sweep_histories(over_bump, speed=[0.1], progress=False)
    with pytest.raises(vr.InvalidInput, match="motion must return a mapping of arguments of roll, got 3"):
        sweep_histories(lambda speed: 3, speed=[0.1], progress=False)
