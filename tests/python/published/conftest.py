"""Shared fixtures of comparisons with published results: the rows of the page that name each test."""

from __future__ import annotations

from collections.abc import Callable, Mapping

import pytest
from published import rows


@pytest.fixture
def judge(request: pytest.FixtureRequest) -> Callable[[Mapping[str, float]], None]:
    """Return a function that compares named numbers with the rows that name this test."""

    def held(found: Mapping[str, float]) -> None:
        rows.judge(f"published/{request.path.name}::{request.node.originalname}", found)

    return held
