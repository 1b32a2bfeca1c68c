"""Encodings of text files, and formats of files that contain no text."""

from __future__ import annotations

import codecs

__all__ = ["OLE", "UNKNOWN", "ZIP", "binary_format", "decoded_utf16"]

#: First bytes of ZIP archives, and of files of older Microsoft Office.
ZIP = b"PK\x03\x04"
OLE = b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1"

#: First bytes of files that contain no text, with the names of the formats.
_BINARY = (
    (ZIP, "a ZIP archive"),
    (OLE, "a file of an older Microsoft Office"),
    (b"%PDF", "a PDF document"),
    (b"\x89HDF\r\n\x1a\n", "an HDF5 file"),
    (b"CDF", "a NetCDF file"),
    (b"\x89PNG", "a PNG image"),
    (b"\xff\xd8\xff", "a JPEG image"),
    (b"GIF8", "a GIF image"),
    (b"II*\x00", "a TIFF image"),
    (b"MM\x00*", "a TIFF image"),
    (b"\x1f\x8b", "a gzip archive"),
    (b"7z\xbc\xaf\x27\x1c", "a 7z archive"),
    (b"Rar!", "a RAR archive"),
    (b"SQLite format 3", "an SQLite database"),
    (b"MATLAB 5.0", "a MATLAB file"),
    (b"{\\rtf", "an RTF document"),
)

#: Description of a file without text whose first bytes are not in this list.
UNKNOWN = "a binary file of unknown format"

#: Byte order marks of UTF-16.
_UTF16 = (codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)


def binary_format(content: bytes) -> str | None:
    """Return the format of a file without text, with its article, or None for a text."""
    found = next((name for start, name in _BINARY if content.startswith(start)), None)
    if found is None and b"\x00" in content and decoded_utf16(content) is None:
        return UNKNOWN
    return found


def decoded_utf16(content: bytes) -> str | None:
    """Return the text of a file in UTF-16, with or without a byte order mark, or None for other files."""
    if content.startswith(_UTF16):
        return content.decode("utf-16", errors="replace")
    byte_order = _utf16_without_mark(content)
    return None if byte_order is None else content.decode(byte_order, errors="replace")


def _utf16_without_mark(content: bytes) -> str | None:
    """Return the encoding of a text in UTF-16 without a byte order mark: every second byte of ASCII text is zero."""
    start = content[:2000]
    half = len(start) // 2
    if half < 2 or len(content) % 2:
        return None
    for encoding, zeros, others in (("utf-16-le", start[1::2], start[::2]), ("utf-16-be", start[::2], start[1::2])):
        if zeros.count(0) > 0.7 * half and others.count(0) == 0:
            return encoding
    return None
