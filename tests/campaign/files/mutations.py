"""Random damage to the content of a file."""

from __future__ import annotations

import codecs
import re
from collections.abc import Callable, Sequence
from random import Random

__all__ = ["mutated"]

#: Numbers that may replace another number in a text file.
_NUMBERS = (
    "1e400", "-1e400", "1e307", "-1e307", "1e303", "1e200", "1e-320", "1e39", "nan", "-nan", "inf", "-inf", "0", "-1",
    "-0.0", "1_0", "0x10", "1,5", "400", "-400", "2", "3.5", "9" * 400, "9" * 5000, "true", '"1.0"', '"x"',
)  # fmt: skip

#: Texts that may appear anywhere in a text file.
_TOKENS = (
    *_NUMBERS,
    "null", "''", '""', '"nan"', "[]", "{}", "[[1.0]]", "[1.0, [2.0]]", "[1.0, true]", '[1.0, "2.0"]',
    '{ type = "elastic", modulus = 1e6 }', '{"a": 1}', "1979-05-27", "07:32:00", "\N{ARABIC-INDIC DIGIT THREE}",
    "\N{GREEK SMALL LETTER DELTA}", "\N{PILE OF POO}", "\0", "\r", "\t", "\n", ";", ",", "=", "[", "]", "{", "}", '"',
    "#", "\\", "..", "/", "../..", "[ball]", "[[ball.layers]]", "[table]", "[" * 20, "[" * 4000 + "]" * 4000,
    "{a=" * 2000 + "1" + "}" * 2000, '{"a":' * 4000 + "1" + "}" * 4000, "a." * 3000 + "a = 1", "x" * 20000,
)  # fmt: skip

_NUMBER = re.compile(rb"(?<![\w.])[-+]?\d+(\.\d*)?([eE][-+]?\d+)?(?![\w.])")
_WORD = re.compile(rb"[A-Za-z_][A-Za-z_0-9]+")
_ASSIGNED = re.compile(rb"(?<=[=:])[ \t]*[^\n=:]+?(?=[ \t]*(#|,?\r?\n|$))")

_Mutation = Callable[[bytes, Random], bytes]


def mutated(content: bytes, random: Random, *, is_text: bool = True) -> bytes:
    """Return the content with one to three random mutations.

    Parameters
    ----------
    content : bytes
        Content of a valid file.
    random : Random
        Source of the choices.
    is_text : bool
        Whether to mutate numbers, words and values of a text as well; otherwise bytes only.
    """
    pool = (*_OF_BYTES, *_OF_TEXTS) if is_text else _OF_BYTES
    for _ in range(random.choice((1, 1, 1, 2, 3))):
        content = random.choice(pool)(content, random)
    return content


def _place(content: bytes, random: Random) -> int:
    return random.randint(0, len(content))


def _part(content: bytes, random: Random, longest: int = 200) -> tuple[int, int]:
    start = _place(content, random)
    return start, min(len(content), start + random.randint(1, longest))


def _flip(content: bytes, random: Random) -> bytes:
    if not content:
        return content
    flipped = bytearray(content)
    for _ in range(random.choice((1, 1, 2, 8))):
        flipped[random.randrange(len(flipped))] ^= 1 << random.randrange(8)
    return bytes(flipped)


def _overwrite(content: bytes, random: Random) -> bytes:
    start, stop = _part(content, random, 16)
    return content[:start] + random.randbytes(stop - start) + content[stop:]


def _truncate(content: bytes, random: Random) -> bytes:
    return content[: _place(content, random)]


def _delete(content: bytes, random: Random) -> bytes:
    start, stop = _part(content, random)
    return content[:start] + content[stop:]


def _repeat(content: bytes, random: Random) -> bytes:
    start, stop = _part(content, random)
    return content[:stop] + content[start:stop] + content[stop:]


def _exchange(content: bytes, random: Random) -> bytes:
    places = sorted(_place(content, random) for _ in range(4))
    a, b, c, d = places
    return content[:a] + content[c:d] + content[b:c] + content[a:b] + content[d:]


def _append(content: bytes, random: Random) -> bytes:
    return content + random.choice((b"\0", b"\n", b"\xff\xfe", random.randbytes(8), content[:64]))


def _empty(content: bytes, random: Random) -> bytes:
    return random.choice((b"", b"\n", b"\0" * 16, codecs.BOM_UTF8, codecs.BOM_UTF16_LE))


def _insert_token(content: bytes, random: Random) -> bytes:
    place = _place(content, random)
    return content[:place] + random.choice(_TOKENS).encode() + content[place:]


def _replaced(pattern: re.Pattern[bytes], tokens: Sequence[str]) -> _Mutation:
    """Return a mutation that replaces a part of a text by one of several texts."""

    def replace(content: bytes, random: Random) -> bytes:
        found = list(pattern.finditer(content))
        if not found:
            return _insert_token(content, random)
        one = random.choice(found)
        return content[: one.start()] + random.choice(tokens).encode() + content[one.end() :]

    return replace


def _swapped(pattern: re.Pattern[bytes]) -> _Mutation:
    """Return a mutation that swaps two parts of a text."""

    def swap(content: bytes, random: Random) -> bytes:
        found = list(pattern.finditer(content))
        if len(found) < 2:
            return _exchange(content, random)
        one, two = sorted(random.sample(found, 2), key=lambda match: match.start())
        between = content[one.end() : two.start()]
        return content[: one.start()] + two[0] + between + one[0] + content[two.end() :]

    return swap


def _lines(content: bytes, random: Random) -> bytes:
    """Delete, repeat or move a line."""
    lines = content.splitlines(keepends=True)
    if not lines:
        return content
    one = lines.pop(random.randrange(len(lines)))
    for _ in range(random.randrange(3)):
        lines.insert(random.randint(0, len(lines)), one)
    return b"".join(lines)


def _encode(content: bytes, random: Random) -> bytes:
    text = content.decode("utf-8", errors="replace")
    return text.encode(random.choice(("utf-16", "utf-16-le", "utf-32", "utf-8-sig", "cp1252")), errors="replace")


_OF_BYTES: tuple[_Mutation, ...] = (_flip, _overwrite, _truncate, _delete, _repeat, _exchange, _append, _empty)
_OF_TEXTS: tuple[_Mutation, ...] = (
    *(_replaced(pattern, _NUMBERS) for pattern in (_NUMBER, _NUMBER, _NUMBER, _ASSIGNED)),
    *(_replaced(pattern, _TOKENS) for pattern in (_NUMBER, _WORD, _ASSIGNED)),
    *(_swapped(pattern) for pattern in (_NUMBER, _WORD, _ASSIGNED)),
    _insert_token,
    _lines,
    _encode,
)
