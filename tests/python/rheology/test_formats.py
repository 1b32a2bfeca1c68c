"""Files that are no text: workbooks of Excel, JSON of TRIOS, and files that the readers reject by name."""

from __future__ import annotations

import json
import sys
from pathlib import Path

import numpy as np
import pytest
import viscoroll as vr
from workbooks import write_xlsx

DATA = Path(__file__).parent / "data"

NAMES = ["Angular frequency", "Storage modulus", "Loss modulus", "Temperature"]
ROWS = [[0.1, 1.0e6, 1e5, 20.0], [1.0, 1.25e6, 1.5e5, 20.0], [10.0, 1.5e6 + 1e-3, 2e5, 20.1]]
CREEP = [["Step time", "Strain"], ["s", "%"], [10.0, 0.5], [20.0, 0.6]]


def test_sheets_of_a_workbook_are_data_sets(tmp_path):
    path = tmp_path / "sweeps.xlsx"
    first = [["Instrument", "made for this test"], [], NAMES, ["rad/s", "Pa", "Pa", "°C"], *ROWS]
    second = [["ω [rad/s]", "G' [MPa]", "G'' [MPa]", "T [°C]"], [0.1, 0.5, 0.05, 40.0], [1.0, 0.6, 0.06, 40.0]]
    write_xlsx(path, {"At 20": first, "Notes": [["nothing"]], "Creep test": CREEP, "At 40": second})
    data = vr.rheology.read_rheology(path, tensile=False)
    assert [sweep.frequency.size for sweep in data.isotherms] == [3, 2]
    np.testing.assert_array_equal(data.isotherms[0].storage, [row[1] for row in ROWS])
    np.testing.assert_allclose(data.isotherms[1].storage, [5e5, 6e5], rtol=1e-15)
    assert "2: creep (Creep test), 2 points" in repr(data)
    (one,) = vr.rheology.read_rheology(path, tensile=False, step=3).isotherms
    assert one.temperature == pytest.approx(313.15, abs=1e-9)


def test_workbooks_of_the_older_format():
    data = vr.rheology.read_rheology(DATA / "sweeps.xls", tensile=False)  # written with xlwt 1.3.0
    assert [sweep.frequency.tolist() for sweep in data.isotherms] == [[0.1, 1.0, 10.0], [0.1, 1.0, 10.0]]
    np.testing.assert_array_equal(data.isotherms[1].loss, [1e5, 1.2e5, 1.4e5])


def test_without_the_extra_the_message_says_how_to_install_it(monkeypatch):
    monkeypatch.setitem(sys.modules, "python_calamine", None)
    with pytest.raises(ImportError, match=r"requires python_calamine, .* pip install 'viscoroll\[excel\]'"):
        vr.rheology.read_rheology(DATA / "sweeps.xls")


def test_damaged_workbooks_are_rejected(tmp_path):
    path = tmp_path / "cut.xlsx"
    write_xlsx(path, {"A": [NAMES]})
    path.write_bytes(path.read_bytes()[:300])
    with pytest.raises(ValueError, match="must be an Excel workbook, but cannot be read as one"):
        vr.rheology.read_rheology(path)


def trios_json(rows, steps):
    """Return a document in the layout of the TRIOS JSON Export Schema."""
    headers = {
        key: {"DisplayName": name, "ValueType": "Number", "Unit": {"Name": unit}}
        for key, name, unit in (
            ("w", "Angular frequency", "rad/s"),
            ("s", "Storage modulus", "MPa"),
            ("l", "Loss modulus", "MPa"),
            ("T", "Temperature", "°C"),
            ("t", "Step time", "s"),
            ("e", "Strain", "%"),
        )
    }
    headers["Procedure_Step_Id"] = {"DisplayName": "Step Id", "ValueType": "String"}
    return {
        "Schema": {"Url": "https://software.tainstruments.com/schemas/TRIOSJSONExportSchema"},
        "Sample": {"Name": "made for this test"},
        "Procedure": {"Steps": steps},
        "Results": {"Processed": {"ColumnHeaders": headers, "Rows": rows, "ResultsSteps": steps}},
    }


def test_json_of_trios(tmp_path):
    steps = [{"Name": "Frequency sweep", "Id": "a"}, {"Name": "Creep", "Id": "b"}]
    sweep = [
        {"w": w, "s": s, "l": {"Value": loss}, "T": 20.0, "Procedure_Step_Id": "a"}
        for w, s, loss in ((0.1, 1.0, 0.1), (1.0, 1.1, 0.11))
    ]
    creep = [{"t": 10.0, "e": 0.5, "T": 20.0, "Procedure_Step_Id": "b"}]
    path = tmp_path / "sweep.json"
    path.write_text(json.dumps(trios_json(sweep + creep, steps)), encoding="utf-8")
    data = vr.rheology.read_rheology(path, tensile=False)
    (found,) = data.isotherms
    np.testing.assert_allclose(found.storage, [1e6, 1.1e6], rtol=1e-15)
    np.testing.assert_allclose(found.loss, [1e5, 1.1e5], rtol=1e-15)
    assert found.temperature == 293.15
    assert "2: creep (Creep), 1 points" in repr(data)


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (b"%PDF-1.7\n", "got a PDF document"),
        (b"\x89HDF\r\n\x1a\n0000", "got an HDF5 file"),
        (b"\x89PNG\r\n", "got a PNG image"),
        (b"PK\x03\x04abc", "got a ZIP archive"),
        (b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1abc", "got a file of an older Microsoft Office"),
        (b"\x01\x02\x00\x03\x04\x00", "got a binary file of unknown format"),
        (b'{"a": 1}', "must have Results with ColumnHeaders and Rows, .* got the members 'a'"),
        (b'{"a"', "must be valid JSON"),
    ],
)
def test_other_files_are_rejected_by_their_format(tmp_path, content, message):
    path = tmp_path / "data.dat"
    path.write_bytes(content)
    with pytest.raises(ValueError, match=message):
        vr.rheology.read_rheology(path)


def test_projects_of_an_instrument_are_named(tmp_path):
    path = tmp_path / "sweep.tri"
    path.write_bytes(b"\x01\x00\x02")
    with pytest.raises(ValueError, match="got a TRIOS file"):
        vr.rheology.read_rheology(path)


@pytest.mark.parametrize("encoding", ["utf-16-le", "utf-16-be"])
def test_utf16_without_a_byte_order_mark(tmp_path, encoding):
    path = tmp_path / "sweep.csv"
    path.write_bytes("f (Hz),G' (Pa),G'' (Pa)\n1,1e6,1e5\n10,2e6,1e5\n".encode(encoding))
    assert vr.rheology.read_rheology(path).isotherms[0].frequency.size == 2
