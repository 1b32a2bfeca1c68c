"""What tests of benchmarks have in common: the rows of the page that name them."""

from __future__ import annotations

from collections.abc import Callable, Mapping

import pytest
from outside import rows


@pytest.fixture
def judge(request: pytest.FixtureRequest) -> Callable[[Mapping[str, float]], None]:
    """Hold numbers, by what they are, against the rows that name this test."""

    def held(found: Mapping[str, float]) -> None:
        rows.judge(f"outside/{request.path.name}::{request.node.originalname}", found)

    return held
