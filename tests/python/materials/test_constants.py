"""Constants of Abaqus, Ansys, LS-DYNA and COMSOL: conventions by hand, round trips, limited terms and messages."""

from __future__ import annotations

import math

import numpy as np
import pytest
import viscoroll as vr
from viscoroll.materials import Arrhenius, MaterialConstants, WilliamsLandelFerry, read_constants

PROGRAMS = ("abaqus", "ansys", "ls-dyna", "comsol")
UNITS = ("m-kg-s", "mm-t-s", "mm-kg-ms", "mm-g-ms", "cm-g-us", "in-lbf-s")
OMEGA = np.concatenate([[0.0], np.geomspace(1e-3, 1e8, 200)])

#: Five terms over eight decades, from 1.2 GPa to 1.1 MPa.
SERIES = vr.Prony(
    instantaneous_modulus=1.2345678901e9,
    weights=[0.3, 0.2, 0.25, 0.1, 0.1491],
    relaxation_times=[1e-7 / 3, 1e-5, 1e-3 / 7, 0.1, 30 / 7],
)
WLF = WilliamsLandelFerry(c1=17.44, c2=51.6, reference_temperature=296.15)
COMPRESSIBILITIES = [{"poisson_ratio": 0.41}, {"bulk_modulus": 2.3e9}]


@pytest.mark.parametrize("units", UNITS)
@pytest.mark.parametrize("compressibility", COMPRESSIBILITIES)
def test_a_material_passes_through_all_programs(compressibility, units):
    constants = MaterialConstants(shear_modulus=SERIES, shift=WLF, density=1100.0, name="rubber", **compressibility)
    for program in PROGRAMS:
        text = constants.to_text(program, units=units, temperature_unit="C")
        constants = read_constants(text, units=units, temperature_unit="C")
        assert len(constants.notes) == (program == "ls-dyna")  # its relaxed modulus is a term that never relaxes
        # The fields of LS-DYNA hold 14 digits; the relaxed modulus, a thousandth of the sum, keeps 13.
        expected = SERIES.complex_modulus(OMEGA)
        np.testing.assert_allclose(constants.shear_modulus.complex_modulus(OMEGA), expected, rtol=1e-12)
    for name, value in compressibility.items():
        assert getattr(constants, name) == pytest.approx(value, rel=1e-12)
    assert constants.density == pytest.approx(1100.0, rel=1e-12)
    assert constants.shift(310.0) == pytest.approx(WLF(310.0), rel=1e-12)
    shifted = constants.at(temperature=310.0).complex_modulus(OMEGA)
    np.testing.assert_allclose(shifted, SERIES.complex_modulus(WLF(310.0) * OMEGA), rtol=1e-12)


def modulus(instantaneous, weights, times):
    """Return the modulus over OMEGA from the definition of a Prony series."""
    x = 1j * np.outer(OMEGA, times)
    return instantaneous * (1.0 - np.sum(weights) + (x / (1.0 + x)) @ np.array(weights))


# In each text, G(t) = 2 MPa (0.3 + 0.2 exp(-t / 0.5 s) + 0.5 exp(-t / 10 s)), so that G_0 = 2 MPa and G_inf = 0.6 MPa.
ABAQUS_LONG_TERM = """\
** comment
*Material, name="Soft pad"
*Elastic
 1.68, 0.4
*Viscoelastic,
 time=PRONY
0.2, 0.2, 0.5
0.5, 0.5, 10.
*Trs, definition=WLF
 20., 8.86, 101.6
*Density
1.1e-9,
*Step
*Static
0.1, 1.
"""
ABAQUS_INSTANTANEOUS = """\
*HYPERELASTIC, NEO HOOKE, MODULI=INSTANTANEOUS
1.0, 0.001
*VISCOELASTIC, FREQUENCY=PRONY
0.2, , 0.5
0.5, 0., 10.
""".replace("FREQUENCY=PRONY", "TIME=PRONY")
ANSYS = """\
! comment
e0 = 5.6 $ nu = 0.4
MP,EX,matid,e0
mp,prxy,matid,nu
TB,PRONY,matid,1,2,SHEAR
TBDATA,,0.2,0.5,0.5,10
TB,PRONY,matid,1,2,BULK
TBDATA,1,0.2,0.5
TBDATA,3,0.5,10
TB,SHIFT,matid,1,3,WLF
TBDATA,1,20,8.86,101.6
"""
LS_DYNA = """\
*KEYWORD
$ comment
*MAT_GENERAL_VISCOELASTIC_TITLE
soft pad
$     MID        RO      BULK       PCF        EF      TREF         A         B
         7   1.10E-9    2000.0                        293.15  -20.4009     101.6

       0.6       0.0
       0.4       2.0
       1.0       0.1
*END
"""
COMSOL = """\
% G = 0.6
% nu = 0.4
1 0.4 0.5
2 1.0 10
"""


@pytest.mark.parametrize(
    ("text", "name", "poisson_ratio", "bulk_modulus"),
    [
        (ABAQUS_LONG_TERM, "Soft pad", 0.4, None),
        (ABAQUS_INSTANTANEOUS, "material", None, 2e9),
        (ANSYS, "matid", 0.4, None),
        (LS_DYNA, "soft pad", None, 2e9),
        (COMSOL, "material", 0.4, None),
    ],
    ids=["abaqus", "abaqus-instantaneous", "ansys", "ls-dyna", "comsol"],
)
def test_conventions_by_hand(text, name, poisson_ratio, bulk_modulus):
    constants = read_constants(text, units="mm-t-s", temperature_unit="K" if text is LS_DYNA else "C")
    expected = modulus(2e6, [0.2, 0.5], [0.5, 10.0])
    np.testing.assert_allclose(constants.shear_modulus.complex_modulus(OMEGA), expected, rtol=1e-12)
    assert constants.name == name
    assert constants.poisson_ratio == (None if poisson_ratio is None else pytest.approx(poisson_ratio, rel=1e-12))
    assert constants.bulk_modulus == (None if bulk_modulus is None else pytest.approx(bulk_modulus, rel=1e-12))
    if constants.shift is not None:  # 17 K above the reference: log10 a_T = -8.86 * 17 / 118.6
        assert constants.shift(310.15) == pytest.approx(10.0 ** (-8.86 * 17.0 / 118.6), rel=1e-5)
    if text in (ABAQUS_LONG_TERM, LS_DYNA):
        assert constants.density == pytest.approx(1100.0, rel=1e-12)


def test_one_term_of_material_6():
    simple = read_constants("*MAT_006\n1, 1100.0, 2.0e9, 2.0D6, 6.0+5, 4.0\n")
    expected = modulus(2e6, [0.7], [0.25])
    np.testing.assert_allclose(simple.shear_modulus.complex_modulus(OMEGA), expected, rtol=1e-12)
    assert (simple.bulk_modulus, simple.density) == (2e9, 1100.0)


def test_table_over_frequency_in_hertz():
    # At 3 Hz, G'' / G_inf = 0.4 and 1 - G' / G_inf = -1.5; G_inf = 3e6 / (2 * 1.5) = 1 MPa.
    text = """\
*MATERIAL, NAME=TABLE
*ELASTIC
3e6, 0.5
*VISCOELASTIC, FREQUENCY=TABULAR
0.4, -1.5, 0., 0., 3.
0.1, -0.2, 0., 0., 0.1
"""
    table = read_constants(text)
    assert table.poisson_ratio == 0.5
    found = table.shear_modulus.complex_modulus([0.0, 0.2 * math.pi, 6.0 * math.pi])
    np.testing.assert_allclose(found, [1e6, 1.2e6 + 1e5j, 2.5e6 + 4e5j], rtol=1e-14)
    again = read_constants(table.to_text("abaqus", units="mm-kg-ms"), units="mm-kg-ms").shear_modulus
    np.testing.assert_allclose(again.frequency, table.shear_modulus.frequency, rtol=1e-14)
    np.testing.assert_allclose(again.storage, table.shear_modulus.storage, rtol=1e-14)
    np.testing.assert_allclose(again.loss, table.shear_modulus.loss, rtol=1e-14)


def test_terms_that_never_relax_join_the_relaxed_modulus_with_a_note():
    text = "% G = 1e6\n1 2e6 inf\n2 1e6 0.1\n"
    for constants in (read_constants(text), read_constants(text.replace("% G = 1e6\n", ""), relaxed_modulus=1e6)):
        assert constants.shear_modulus.relaxation_times == (0.1,)
        assert constants.shear_modulus.complex_modulus(0.0).real == pytest.approx(3e6, rel=1e-12)
        assert any("never relaxes" in note for note in constants.notes)


def test_series_from_absolute_moduli():
    series = vr.Prony.from_moduli(relaxed_modulus=1e5, moduli=[2e5, 3e5, 4e5], relaxation_times=[0.1, math.inf, 2.0])
    np.testing.assert_allclose(series.complex_modulus(OMEGA), modulus(1e6, [0.2, 0.4], [0.1, 2.0]), rtol=1e-12)
    with pytest.raises(vr.InvalidInput, match=r"^moduli\[1\] must be >= 0 Pa, got -1$"):
        vr.Prony.from_moduli(relaxed_modulus=1e5, moduli=[1.0, -1.0], relaxation_times=[1.0, 1.0])
    with pytest.raises(vr.InvalidInput, match=r"^relaxation_times must be as many as moduli \(2\), got 1$"):
        vr.Prony.from_moduli(relaxed_modulus=1e5, moduli=[1.0, 1.0], relaxation_times=[1.0])
    with pytest.raises(vr.InvalidInput, match="moduli must add up to more than 0 Pa"):
        vr.Prony.from_moduli(relaxed_modulus=0.0, moduli=[], relaxation_times=[])


@pytest.mark.parametrize("program", PROGRAMS)
def test_few_terms_reach_the_tolerance(program):
    solid = vr.materials.FractionalZener(
        instantaneous_modulus=6e6, relaxed_modulus=3e6, relaxation_time=0.01, order=0.5
    )
    constants = MaterialConstants(shear_modulus=solid, bulk_modulus=2e9, density=1100.0)
    text = constants.to_text(program, terms=6, tolerance=0.01, frequencies=(1.0, 1e4))
    series = read_constants(text).shear_modulus
    assert len(series.weights) <= 6
    omega = np.geomspace(1.0, 1e4, 333)
    error = np.abs(series.complex_modulus(omega) / solid.complex_modulus(omega) - 1.0)
    assert error.max() < 0.01
    with pytest.raises(vr.InvalidInput, match=r"^tolerance must be >= .* with 1 terms from 1 to 1e\+04 rad/s"):
        constants.to_text(program, terms=1, tolerance=0.01, frequencies=(1.0, 1e4))


def test_long_series_are_shortened_for_a_program_that_limits_them():
    times = np.geomspace(1e-6, 1e4, 40)
    constants = MaterialConstants(
        shear_modulus=vr.Prony(instantaneous_modulus=1e8, weights=np.full(40, 0.02), relaxation_times=times),
        bulk_modulus=2e9,
        density=1100.0,
    )
    with pytest.raises(vr.InvalidInput, match="terms must be <= 17 for LS-DYNA"):
        constants.to_text("ls-dyna")
    shorter = read_constants(constants.to_text("ls-dyna", terms=14)).shear_modulus
    omega = np.geomspace(1e-5, 1e7, 200)
    error = np.abs(shorter.complex_modulus(omega) / constants.shear_modulus.complex_modulus(omega) - 1.0)
    assert error.max() < 0.02


def test_arrhenius_of_ls_dyna():
    law = Arrhenius(activation_energy=50e3, reference_temperature=293.15)
    constants = MaterialConstants(shear_modulus=SERIES, bulk_modulus=2e9, shift=law, density=1100.0)
    found = read_constants(constants.to_text("ls-dyna"))
    assert found.shift(303.15) == pytest.approx(law(303.15), rel=1e-12)
    for program in ("abaqus", "ansys", "comsol"):
        with pytest.raises(vr.InvalidInput, match="shift must be WilliamsLandelFerry or None"):
            constants.to_text(program)


def test_the_other_sign_of_the_shift_of_ls_dyna_has_a_note():
    found = read_constants(LS_DYNA.replace("-20.4009", " 20.4009"), units="mm-t-s")
    assert found.shift(310.15) < 1.0
    assert any("slows relaxation" in note for note in found.notes)


def test_other_relaxation_of_the_bulk_modulus_has_a_note():
    for text in (ABAQUS_LONG_TERM.replace("0.5, 0.5, 10.", "0.5, 0.1, 10."), ANSYS.replace("3,0.5,10", "3,0.1,10")):
        found = read_constants(text, units="mm-t-s", temperature_unit="C")
        assert found.bulk_modulus is not None
        assert any("bulk modulus is left out" in note for note in found.notes)


def test_soft_moduli_suggest_other_units():
    assert any("give units=" in note for note in read_constants(COMSOL).notes)
    assert read_constants(COMSOL, units="mm-t-s").notes == ()


def test_materials_are_chosen_by_name():
    text = ABAQUS_LONG_TERM.split("*Step")[0] + "*MATERIAL, NAME=STEEL\n*ELASTIC\n2e5, 0.3\n"
    assert read_constants(text, units="mm-t-s", temperature_unit="C").name == "Soft pad"
    both = text + text.replace("Soft pad", "other")
    assert read_constants(both, name="OTHER", units="mm-t-s", temperature_unit="C").name == "other"
    with pytest.raises(vr.InvalidInput, match=r"name must be given for a text with several .*'Soft pad', 'other'"):
        read_constants(both, units="mm-t-s", temperature_unit="C")


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("a\nb\n", "text must be input of Abaqus, Ansys, LS-DYNA, COMSOL, got 'a"),
        (
            "*ELASTIC\n1e6, 0.4\n*VISCOELASTIC, TIME=CREEP TEST DATA\n",
            r"line 3 \(\*VISCOELASTIC\) must have TIME=PRONY",
        ),
        ("*MATERIAL, NAME=A\n*VISCOELASTIC, TIME=PRONY\n0.1,0,1\n", r"\*MATERIAL, NAME=A must have \*ELASTIC or"),
        (
            "*ELASTIC\n1e6, 0.4\n*VISCOELASTIC, TIME=PRONY\n0.1, 0.0, 1.0\n0.1, x, 2.0\n",
            r"line 5 \(\*VISCOELASTIC\) must have finite numbers, got 'x'",
        ),
        (
            "*ELASTIC\n1e6, 0.4\n*VISCOELASTIC, TIME=PRONY\n0.6, 0.0, 1.0\n0.4, 0.0, 2.0\n",
            r"line 3 \(\*VISCOELASTIC\) must have sums of g_i and of k_i < 1 with MODULI=LONG TERM, got 1",
        ),
        (
            "*ELASTIC\n1e6, 0.4\n2e6, 0.4\n*VISCOELASTIC, TIME=PRONY\n0.6, 0.0, 1.0\n",
            r"line 1 \(\*ELASTIC\) must have one data line, for one temperature, got 2 lines",
        ),
        (
            "*ELASTIC, TYPE=ORTHOTROPIC\n1e6, 0.4\n*VISCOELASTIC, TIME=PRONY\n0.6, 0.0, 1.0\n",
            r"line 1 \(\*ELASTIC\) must have TYPE=ISOTROPIC, got ORTHOTROPIC",
        ),
        (
            "*HYPERELASTIC, OGDEN\n1e6, 0.4\n*VISCOELASTIC, TIME=PRONY\n0.6, 0.0, 1.0\n",
            r"line 1 \(\*HYPERELASTIC\) must have coefficients of one of NEO HOOKE",
        ),
        (
            "*ELASTIC, MODULI=INSTANTANEOUS\n1e6,.4\n*VISCOELASTIC, FREQUENCY=PRONY\n0.6,0.0,1.0\n",
            r"line 1 \(\*ELASTIC\) must have MODULI=LONG TERM in the frequency domain",
        ),
        ("TB,PRONY,1,1,1,SHEAR\nTBDATA,1,0.5,0.1\n", r"line 1 \(TB\) must have MP,EX and MP,NUXY"),
        ("MP,EX,1,1e6\nTB,PRONY,1,3,1,SHEAR\n", r"line 2 \(TB\) must have constants of one temperature"),
        (
            "MP,EX,1,1e6\nMP,NUXY,1,0.4\nTB,PRONY,1,1,1,SHEAR\nTBDATA,1,0.5\n",
            r"line 3 \(TB\) must have a relative modulus and a time in pairs as constant 2",
        ),
        ("TB,SHIFT,1,1,3,TN\n", r"line 1 \(TB\) must have the option WLF, got TN"),
        ("*MAT_076\n1,1,1\n5\n", r"line 3 \(\*MAT_076\) must be blank"),
        ("*MAT_076\n1,1,1\n0\n1e6,-1\n", r"line 4 \(\*MAT_076\) must have BETAI >= 0, got -1"),
        ("*MAT_006\n1,1,1\n", r"line 2 \(\*MAT_006\) must have the fields MID, RO, BULK, G0, GI and BETA"),
        ("*MAT_001\n1,1,1\n", "text must have a viscoelastic material of LS-DYNA, got none"),
        ("1 1e6 0.1\n2 1e6 0.2\n", "relaxed_modulus must be given with a table of branches"),
        ("% G = 1e6\n1 1e6 0.1 7\n", r"line 2 \(branch\) must have a shear modulus and a relaxation time"),
        ("% G = 1e6\n1 1e6 -0.1\n", r"line 2 \(branch\) must have a weight >= 0 and a relaxation time > 0"),
    ],
)
def test_messages_name_line_and_keyword(text, message):
    with pytest.raises(vr.InvalidInput, match=f"^{message}"):
        read_constants(text)


def test_messages_of_arguments(tmp_path):
    constants = MaterialConstants(shear_modulus=SERIES, poisson_ratio=0.5)
    with pytest.raises(vr.InvalidInput, match="program must be one of abaqus, ansys, ls-dyna, comsol, got 'nastran'"):
        constants.to_text("nastran")
    with pytest.raises(vr.InvalidInput, match="density must be given for LS-DYNA"):
        constants.to_text("ls-dyna")
    with pytest.raises(vr.InvalidInput, match="bulk_modulus must be given for LS-DYNA"):
        MaterialConstants(shear_modulus=SERIES, poisson_ratio=0.5, density=1.0).to_text("ls-dyna")
    with pytest.raises(vr.InvalidInput, match="poisson_ratio or bulk_modulus must be given"):
        MaterialConstants(shear_modulus=SERIES).to_text("ansys")
    with pytest.raises(vr.InvalidInput, match="bulk_modulus must be left out with poisson_ratio"):
        MaterialConstants(shear_modulus=SERIES, poisson_ratio=0.4, bulk_modulus=1e9)
    with pytest.raises(vr.InvalidInput, match="terms must be given: this modulus is not a sum of exponentials"):
        MaterialConstants(shear_modulus=vr.materials.KelvinVoigt(modulus=1e6, viscosity=1.0)).to_text("comsol")
    with pytest.raises(vr.InvalidInput, match="temperature must be left out: the material has no shift"):
        constants.at(temperature=300.0)
    with pytest.raises(vr.InvalidInput, match=r"units must be one of m-kg-s, .* got 'mm'"):
        read_constants(COMSOL, units="mm")
    path = tmp_path / "deck.inp"
    path.write_text("*ELASTIC\n1e6\n*VISCOELASTIC\n")
    with pytest.raises(vr.InvalidInput, match=rf"^{path}: line 3 \(\*VISCOELASTIC\)"):
        read_constants(path)


@pytest.mark.parametrize(
    ("given", "error", "message"),
    [
        (
            {"shear_modulus": "x"},
            TypeError,
            "shear_modulus must be a modulus of viscoroll at vanishing strain, or a number",
        ),
        ({"shear_modulus": -1e6}, vr.InvalidInput, "modulus must be > 0 Pa, got -1e"),
        (
            {"shear_modulus": abs},
            TypeError,
            "shear_modulus must be a modulus of viscoroll at vanishing strain, or a number",
        ),
        ({"poisson_ratio": 0.7}, vr.InvalidInput, r"poisson_ratio must be in \(-1, 0.5\], got 0.7"),
        ({"poisson_ratio": -1.0}, vr.InvalidInput, r"poisson_ratio must be in \(-1, 0.5\], got -1"),
        ({"poisson_ratio": math.nan}, vr.InvalidInput, r"poisson_ratio must be in \(-1, 0.5\], got nan"),
        ({"poisson_ratio": "0.5"}, TypeError, "poisson_ratio must be a real number, got str '0.5'"),
        ({"bulk_modulus": math.nan}, vr.InvalidInput, "bulk_modulus must be > 0 Pa, got nan"),
        ({"bulk_modulus": 2.0}, vr.InvalidInput, r"bulk_modulus must be >= 1.23e\+06 Pa, 0.001 of the shear modulus"),
        ({"density": -1.0}, vr.InvalidInput, "density must be > 0 kg/m³, got -1"),
        ({"shift": lambda temperature: 1.0}, TypeError, "shift must be WilliamsLandelFerry, Arrhenius or None"),
        ({"name": 7}, TypeError, "name must be a text, got 7"),
        ({"name": "a\nb"}, vr.InvalidInput, "name must be of printable characters without , and quotation marks"),
        ({"name": "a, b"}, vr.InvalidInput, "name must be of printable characters without , and quotation marks"),
        ({"name": "*END"}, vr.InvalidInput, "name must be of printable characters without , and quotation marks"),
    ],
)
def test_invalid_constants_have_messages(given, error, message):
    with pytest.raises(error, match=f"^{message}"):
        MaterialConstants(**({"shear_modulus": SERIES} | given))


@pytest.mark.parametrize("program", PROGRAMS)
def test_a_number_is_an_elastic_modulus(program):
    constants = MaterialConstants(shear_modulus=1e6, poisson_ratio=0.25, density=1100.0)
    assert constants.shear_modulus == vr.Elastic(modulus=1e6)
    text = constants.to_text(program)
    assert "PRONY" not in text  # a table without terms is an error in Abaqus and Ansys
    if program == "ls-dyna":
        np.testing.assert_allclose(read_constants(text).shear_modulus.complex_modulus(OMEGA), 1e6, rtol=1e-12)
    else:  # G in COMSOL, E = 2 G (1 + nu) in Abaqus and Ansys
        assert ("% G = 1000000.0\n" if program == "comsol" else "2500000.0") in text


def test_names_of_decks_become_names_for_all_programs():
    found = read_constants(LS_DYNA.replace("soft pad", "pad, 60 Shore A"), units="mm-t-s")
    assert found.name == "pad 60 Shore A"
    assert "*MATERIAL, NAME=pad 60 Shore A\n" in found.to_text("abaqus")


@pytest.mark.parametrize(
    ("text", "where"),
    [
        (ABAQUS_LONG_TERM, r"line 9 \(\*TRS\)"),
        (ANSYS, r"line 10 \(TB\)"),
        (LS_DYNA.replace("293.15", "    20"), r"line 6 \(\*MAT_GENERAL_VISCOELASTIC_TITLE\)"),
        (COMSOL + "% T_ref = 20\n% C1 = 8.86\n% C2 = 101.6\n", r"line 5 \(T_ref\)"),
    ],
    ids=["abaqus", "ansys", "ls-dyna", "comsol"],
)
def test_low_reference_temperatures_suggest_their_unit(text, where):
    rule = 'must have a reference temperature >= 100 K, got 20 K; give temperature_unit="C" if'
    with pytest.raises(vr.InvalidInput, match=f"^{where} {rule}"):
        read_constants(text, units="mm-t-s")
    assert read_constants(text, units="mm-t-s", temperature_unit="C").shift.reference_temperature == 293.15


@pytest.mark.parametrize(
    ("given", "error", "message"),
    [
        ({"source": ""}, vr.InvalidInput, "source must be a path or a text of more than one line, got ''"),
        ({"source": " \n"}, vr.InvalidInput, r"source must be a path or a text of more than one line, got ' \\n'"),
        ({"source": None}, TypeError, "source must be a path or a text, got None"),
        ({"source": b"*ELASTIC"}, TypeError, r"source must be a path or a text, got b'\*ELASTIC'"),
        ({"name": 1}, TypeError, "name must be a text or None, got 1"),
        ({"units": ["mm"]}, vr.InvalidInput, r"units must be one of .*, got \['mm'\]"),
        ({"temperature_unit": ["C"]}, vr.InvalidInput, r"temperature_unit must be 'K' or 'C', got \['C'\]"),
    ],
)
def test_arguments_of_wrong_types_have_messages(given, error, message):
    with pytest.raises(error, match=f"^{message}"):
        read_constants(**({"source": ABAQUS_LONG_TERM} | given))


@pytest.mark.parametrize(
    ("content", "format_"),
    [
        (b"PK\x03\x04*ELASTIC\n", "a ZIP archive"),
        (b"\x89HDF\r\n\x1a\n*ELASTIC\n", "an HDF5 file"),
        (b"*ELASTIC\n\x00\x01\x02\x03", "a binary file of unknown format"),
    ],
)
def test_binary_files_are_named(tmp_path, content, format_):
    path = tmp_path / "deck.odb"
    path.write_bytes(content)
    message = f"^{path}: text must be input of Abaqus, Ansys, LS-DYNA, COMSOL, got {format_}$"
    with pytest.raises(vr.InvalidInput, match=message):
        read_constants(path)


@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "utf-16", "utf-16-le", "utf-16-be", "latin-1"])
def test_encodings_of_decks(tmp_path, encoding):
    path = tmp_path / "deck.inp"
    path.write_text(ABAQUS_LONG_TERM.replace("** comment", "** Außenhaut"), encoding=encoding)
    assert read_constants(path, units="mm-t-s", temperature_unit="C").name == "Soft pad"


@pytest.mark.parametrize(
    ("text", "note"),
    [
        (ABAQUS_LONG_TERM.replace("*Trs", "*Tsr"), "not read: *TSR (line 9)"),
        (
            ABAQUS_LONG_TERM.replace("*Density", "*Damping").replace("*Step", "*Expansion\n1.\n*Step"),
            "not read: *DAMPING (line 11), *EXPANSION (line 13)",
        ),
        (ABAQUS_INSTANTANEOUS + "*TSR\n20., 8.86, 101.6\n", "not read: *TSR (line 6)"),
        (ANSYS.replace("TB,SHIFT", "TB,SHFT"), "not read: TB,SHFT (line 10)"),
        (
            ANSYS.replace("TB,SHIFT", "MP,ALPX,matid,1\nTBTEMP,20\nTB,SHIFT"),
            "not read: MP,ALPX (line 10), TBTEMP (line 11)",
        ),
        (
            LS_DYNA.replace("*END", "*MAT_ADD_THERMAL_EXPANSION\n$ comment\n7\n*END"),
            "not read: *MAT_ADD_THERMAL_EXPANSION (line 11)",
        ),
        (COMSOL + "% T_rfe = 293.15\n", "not read: T_rfe (line 5)"),
    ],
)
def test_a_note_lists_keywords_that_were_not_read(text, note):
    found = read_constants(text, units="mm-t-s", temperature_unit="K" if text.startswith("*KEY") else "C")
    assert [line for line in found.notes if line.startswith("not read")] == [note]


def test_keywords_outside_of_materials_are_not_listed():
    before = "*HEADING\ntitle\n*NODE\n1, 0., 0.\n*AMPLITUDE, NAME=A\n0., 1.\n"
    after = "*SURFACE INTERACTION, NAME=B\n*FRICTION\n0.1,\n*BOUNDARY\n1, 1\n"
    text = before + ABAQUS_LONG_TERM.replace("*Step", after + "*Step")
    assert read_constants(text, units="mm-t-s", temperature_unit="C").notes == ()
