"""Tables for notebooks are complete, with units and escaped texts."""

from __future__ import annotations

import numpy as np
import pytest
import viscoroll as vr
from viscoroll._support.tables import handy, html_table
from viscoroll.solution.scalars import SCALARS, label_of
from viscoroll.solution.text import scalar_text

LAYER = vr.Layer(thickness=1e-3, shear_modulus=3e6, poisson_ratio=0.5, conductivity=0.2)


def cells(html):
    """Return the text of the innermost cells."""
    return [part.partition("</td>")[0] for part in html.split('<td style="text-align: left">') if "</td>" in part]


def test_texts_are_escaped():
    class Strange:
        def __call__(self, omega):
            return 1e6 + 0.0 * omega

        def __repr__(self):
            return "<script>alert('&')</script>"

    layer = vr.Layer(thickness=1e-3, shear_modulus=Strange(), poisson_ratio=0.5)
    assert "&lt;script&gt;" in layer._repr_html_()
    assert "<script>" not in layer._repr_html_()
    assert html_table("a<b", [["<i>"]], head=["&"]).count("&lt;") == 2


def test_all_scalars_of_a_result_have_their_units(paper_ball):
    r = vr.solve(paper_ball, load=50.0, angular_speed=2.5, mesh=vr.Mesh(nodes_per_revolution=100), friction=0.2)
    found = cells(r._repr_html_())
    # Scalars that are None: a ball has no faces, the torque at finite strain is unknown with friction, and there is no
    # adhesion. The load is given, the only loss in the layers is that of the ball, and a centered contact causes no
    # lateral force.
    absent = {name for name in SCALARS if getattr(r, name) is None}
    assert {"face_distance", "overspeed", "finite_strain_torque", "adhesion_power"} <= absent
    absent |= {"load", "counterbody_bulk_power", "lateral_force", "spin_moment", "driving_force"}
    assert not {label_of(name, r.body) for name in absent - {"driving_force"}} & set(found)
    for name in SCALARS.keys() - absent - {"centrifugal_displacement"}:
        place = found.index(label_of(name, r.body))
        assert found[place + 1] == scalar_text(r, name)
    assert "warning" in found


def test_units_of_rollers_are_per_length(rubber):
    roller = vr.CoatedCylinder(
        core_radius=50e-3, layers=[vr.Layer(thickness=10e-3, shear_modulus=rubber, poisson_ratio=0.5)]
    )
    r = vr.solve(roller, load=5e3, angular_speed=1.0, mesh=vr.Mesh(nodes_per_revolution=400))
    assert "P = 5 kN/m" in r._repr_html_()
    found = cells(r._repr_html_())
    assert found[found.index("dissipated power") + 1].endswith(" W/m")
    assert found[found.index("drive torque of linear theory") + 1].endswith(" N m/m")


@pytest.mark.parametrize(
    ("values", "unit", "texts"),
    [
        ([0.0], "N m", (["0"], "N m")),
        ([-1.5e-3, 20e-6], "N m", (["-1.5", "0.02"], "mN m")),
        ([0.999], "m", (["999"], "mm")),
        ([5e3, None], "N/m", (["5", "undetermined"], "kN/m")),
        ([2.5e-9], "Pa", (["2.5e-09"], "Pa")),
        ([2.3e-5], "m^2", (["23"], "mm²")),
        ([1234.5678], "1", (["1234.6"], "")),
        ([293.156], "K", (["293.16"], "K")),
        ([None], "m/s", (["undetermined"], "m/s")),
    ],
)
def test_units_give_numbers_of_moderate_size(values, unit, texts):
    assert handy(values, unit) == texts


@pytest.mark.parametrize(
    ("given", "texts"),
    [
        (LAYER, ["thickness", "0.001", "m", "Elastic", "3e+06", "Pa", "conductivity", "W/(m K)"]),
        (vr.CoatedSphere(core_radius=0.02, layers=[LAYER]), ["outer radius", "0.021"]),
        (vr.CoatedPlane(layers=[LAYER], base=vr.HalfSpace(shear_modulus=1e7, poisson_ratio=0.4)), ["HalfSpace", "0.4"]),
        (vr.Groove(radius=30e-3), ["radius", "0.03"]),
        (vr.MasterCurve(np.arange(1.0, 9.0), np.full(8, 1e6), np.full(8, 1e5)), ["1, 2, 3, 4, …, 8 (8)", "rad/s"]),
        (vr.Prony(instantaneous_modulus=1e6, weights=[0.5], relaxation_times=[0.1]), ["0.5", "0.1", "s"]),
        (vr.LossFactor(modulus=1e6, loss_factor=0.1, reference_frequency=100.0), ["loss factor", "rad/s"]),
        (vr.Drive(torque=0.1), ["torque", "N m"]),
        (vr.Mesh(nodes_per_revolution=100), ["nodes per revolution", "100"]),
    ],
)
def test_inputs_have_values_and_units(given, texts):
    html = given._repr_html_()
    assert f'<caption style="text-align: left">{type(given).__name__}</caption>' in html
    for text in texts:
        assert f">{text}<" in html, text
    assert html.count("<table>") == html.count("</table>")
