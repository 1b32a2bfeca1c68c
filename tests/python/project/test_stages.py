"""The stages of the C++ sources: no stage includes a later one."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

CPP = Path(__file__).parents[3] / "cpp"

#: Stages in the order of the method; stages of the same set do not include each other.
STAGES = (
    {"base"},
    {"materials"},
    {"modal"},
    {"section"},
    {"influence"},
    {"surface", "creep"},
    {"contact"},
    {"rolling", "sliding"},
    {"transient", "interior"},
)

#: Public headers of each stage: the first stage that may include them.
PUBLIC = {
    "base": {"cores", "errors", "fields", "observer"},
    "materials": {"materials", "modulus_functions", "modulus_types", "slow_terms"},
    "modal": {"cylinder", "inner_boundaries", "plane", "rolling_body", "sphere", "wheel", "modal"},
    "influence": {"formulation", "influence", "mesh"},
    "rolling": {"adhesion", "drive", "load_case", "options", "result", "result_scalars", "rolling_resistance", "solve"},
    "sliding": {"sliding", "sliding_scalars"},
    "transient": {"history_scalars", "profile", "rolling_history"},
    "interior": {"interior", "sliding_interior"},
}

RANK = {stage: rank for rank, stages in enumerate(STAGES) for stage in stages}
STAGE_OF_HEADER = {name: stage for stage, names in PUBLIC.items() for name in names}
PUBLIC_HEADERS = sorted(
    str(path.relative_to(CPP / "include")) for path in CPP.glob("include/viscoroll/*") if path.stem != "viscoroll"
)
SOURCES = sorted(str(path.relative_to(CPP / "src")) for path in CPP.glob("src/**/*.[ch]pp"))


def stage_of(path):
    """Return the stage of a file from its path in cpp/src or cpp/include."""
    if path.startswith("viscoroll/"):
        return STAGE_OF_HEADER[Path(path).stem]
    return path.split("/")[0]


def may_include(stage, other):
    return stage == other or RANK[other] < RANK[stage]


def includes(path):
    folder = CPP / ("include" if path.startswith("viscoroll/") else "src")
    return re.findall(r'^#include "(.+)"', (folder / path).read_text(), flags=re.MULTILINE)


def test_every_public_header_has_a_stage():
    assert {Path(path).stem for path in PUBLIC_HEADERS} == set(STAGE_OF_HEADER)


def test_every_folder_is_a_stage():
    assert {stage_of(path) for path in SOURCES} <= set(RANK)


@pytest.mark.parametrize("path", PUBLIC_HEADERS + SOURCES)
def test_no_stage_includes_a_later_one(path):
    own = stage_of(path)
    later = [other for other in includes(path) if not may_include(own, stage_of(other))]
    assert not later, f"{path} belongs to {own} and includes {later}"


def test_a_reversed_include_is_found():
    assert not may_include("surface", stage_of("viscoroll/solve.hpp"))
    assert not may_include("modal", stage_of("influence/table.hpp"))
    assert may_include("contact", stage_of("surface/window.hpp"))
