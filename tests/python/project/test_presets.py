"""The test presets of CMake select C++ tests by parts of their names, which must not be outdated."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[3]

#: Names of the C++ tests: suite and test.
NAMES = [
    ".".join(found)
    for path in sorted((ROOT / "tests" / "cpp").glob("*.cpp"))
    for found in re.findall(r"^TEST(?:_P|_F)?\((\w+),\s+(\w+)\)", path.read_text(encoding="utf-8"), re.MULTILINE)
]

#: Parts of names that presets include or exclude.
PARTS = sorted(
    {
        part
        for preset in json.loads((ROOT / "CMakePresets.json").read_text(encoding="utf-8"))["testPresets"]
        for selection in preset.get("filter", {}).values()
        for part in selection["name"].split("|")
    }
)


def test_some_tests_are_selected():
    assert len(NAMES) > 100
    assert len(PARTS) > 5


@pytest.mark.parametrize("part", PARTS)
def test_a_selected_name_belongs_to_a_test(part):
    assert any(part in name for name in NAMES)
