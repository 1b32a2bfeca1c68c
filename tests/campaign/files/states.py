"""Saved states of histories: a damaged state must be rejected, or be the same to the last bit."""

from __future__ import annotations

import tempfile
from functools import cache
from pathlib import Path
from random import Random

import numpy as np
import viscoroll as vr
from viscoroll import paper

from .contents import MOTIONS
from .judging import command_failure, reading_failure
from .mutations import mutated

__all__ = ["check"]

_NAME = "roll.state"


@cache
def _original() -> tuple[bytes, np.ndarray]:
    """Return content and numbers of the state file of a ball after some rolling."""
    ball = paper.ball(density=0.0)
    stepper = vr.RollingHistory(ball, load=100.0, mesh=vr.Mesh(nodes_per_revolution=60), averaged_meshes=1)
    stepper.advance(time=0.1, angle=0.2, load=100.0)
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, _NAME)
        stepper.state.save(path)
        return path.read_bytes(), stepper.state.numbers


def check(seed: int, folder: Path) -> str | None:
    """Write one damaged state into a folder, and return what is wrong with the way it is read, or None."""
    random = Random(seed)
    content, numbers = _original()
    path = folder / _NAME
    path.write_bytes(mutated(content, random, is_text=False))

    def differs(state: vr.RollingState) -> str | None:
        same = np.array_equal(state.numbers.view(np.uint64), numbers.view(np.uint64))
        return None if same else "numbers differ from the file"

    if failure := reading_failure(vr.RollingState.load, path, differs):
        return failure
    if random.random() < 0.05:
        (folder / "motion.toml").write_bytes(MOTIONS[1])
        return command_failure(("roll", folder / "motion.toml", "--checkpoint", path), folder)
    return None
