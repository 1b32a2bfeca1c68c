"""Excel workbooks written with the standard library, so that tests need no package that writes them."""

from __future__ import annotations

import zipfile
from xml.sax.saxutils import escape

_TYPES = (
    '<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">'
    '<Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>'
    '<Default Extension="xml" ContentType="application/xml"/>'
    '<Override PartName="/xl/workbook.xml" '
    'ContentType="application/vnd.openxmlformats-officedocument.spreadsheetml.sheet.main+xml"/>{sheets}</Types>'
)
_SHEET_TYPE = (
    '<Override PartName="/xl/worksheets/sheet{number}.xml" '
    'ContentType="application/vnd.openxmlformats-officedocument.spreadsheetml.worksheet+xml"/>'
)
_RELATIONS = '<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">{}</Relationships>'
_OFFICE = "http://schemas.openxmlformats.org/officeDocument/2006/relationships"
_MAIN = "http://schemas.openxmlformats.org/spreadsheetml/2006/main"


def write_xlsx(path, sheets):
    """Write a workbook: a mapping from the names of sheets to rows of texts, numbers and None."""
    numbers = range(1, len(sheets) + 1)
    relation = '<Relationship Id="rId{0}" Type="' + _OFFICE + '/worksheet" Target="worksheets/sheet{0}.xml"/>'
    entry = '<sheet name="{1}" sheetId="{0}" r:id="rId{0}"/>'
    listed = "".join(entry.format(number, escape(name)) for number, name in zip(numbers, sheets, strict=True))
    first = f'<Relationship Id="rId1" Type="{_OFFICE}/officeDocument" Target="xl/workbook.xml"/>'
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        types = "".join(_SHEET_TYPE.format(number=number) for number in numbers)
        archive.writestr("[Content_Types].xml", _TYPES.format(sheets=types))
        archive.writestr("_rels/.rels", _RELATIONS.format(first))
        archive.writestr(
            "xl/workbook.xml", f'<workbook xmlns="{_MAIN}" xmlns:r="{_OFFICE}"><sheets>{listed}</sheets></workbook>'
        )
        archive.writestr(
            "xl/_rels/workbook.xml.rels", _RELATIONS.format("".join(relation.format(number) for number in numbers))
        )
        for number, rows in zip(numbers, sheets.values(), strict=True):
            body = "".join(_row(index, row) for index, row in enumerate(rows, 1))
            archive.writestr(
                f"xl/worksheets/sheet{number}.xml",
                f'<worksheet xmlns="{_MAIN}"><sheetData>{body}</sheetData></worksheet>',
            )


def _row(index, row):
    cells = []
    for column, value in enumerate(row):
        place = f"{chr(ord('A') + column)}{index}"
        if isinstance(value, str):
            cells.append(f'<c r="{place}" t="inlineStr"><is><t>{escape(value)}</t></is></c>')
        elif value is not None:
            cells.append(f'<c r="{place}"><v>{value!r}</v></c>')
    return f'<row r="{index}">{"".join(cells)}</row>'
