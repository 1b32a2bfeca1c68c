"""Fixture with a server of the page, for tests of its answers and of attacks."""

from __future__ import annotations

import threading
import tomllib

import pytest
from viscoroll.app import PageServer
from viscoroll.case import example_text


@pytest.fixture
def server():
    """Yield a running server whose page starts with the example case."""
    with PageServer(tomllib.loads(example_text())) as running:
        thread = threading.Thread(target=running.serve_forever, kwargs={"poll_interval": 0.01})
        thread.start()
        yield running
        running.shutdown()
        thread.join()
