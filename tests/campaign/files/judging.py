"""Readers of files in this process: stop the computations behind them, and judge their errors and numbers."""

from __future__ import annotations

import io
import re
import sys
import traceback
import warnings
from collections.abc import Callable, Iterator, Mapping
from contextlib import ExitStack, contextmanager, redirect_stderr, redirect_stdout
from dataclasses import fields, is_dataclass
from pathlib import Path
from typing import Any
from unittest.mock import patch

import numpy as np
import viscoroll.cli.app  # noqa: F401  (imported before its parts are patched)
from viscoroll.__main__ import main

__all__ = ["command_failure", "infinite", "reading_failure"]

#: Functions that compute with the content of a file, by the name under which a reader calls them.
_COMPUTATIONS = (
    "viscoroll.case.case.solve",
    "viscoroll.case.case.self_heating",
    "viscoroll.case.case.strain_softening",
    "viscoroll.case.design.outcome_of",
    "viscoroll.case.measured.run_all",
    "viscoroll.case.compare.run_all",
    "viscoroll.case.motion.roll",
    "viscoroll.rheology.fit_prony",
    "viscoroll.rheology.superpose",
    "viscoroll.studies.picture.plot_study",
    "viscoroll.studies.study.run_plan",
    "viscoroll.studies.study.sweep",
)

#: Largest number of points of a study; a reader of more points has shown how it uses the file.
_MAX_POINTS = 100

#: Words of internal Python errors, which do not help a user to correct the file.
_INTERNAL = re.compile(
    r"allow_pickle|'NoneType'|has no attribute|index out of range|unhashable|not subscriptable|unexpected keyword"
    r"|positional argument|inhomogeneous|unpack|\bndarray|object of type|not iterable|not supported between"
    r"|int too large|argument must be|'<class|Error\("
)


class _Done(BaseException):
    """Raised after the file has been read, in place of a computation."""


@contextmanager
def _stopped_computations() -> Iterator[None]:
    """Stop a reader before it computes."""
    from viscoroll.case import study

    points = 0
    build = study.build_case

    def build_case(*arguments: Any) -> Any:
        nonlocal points
        points += 1
        if points > _MAX_POINTS:
            raise _Done
        return build(*arguments)

    with ExitStack() as stack:
        for name in _COMPUTATIONS:
            stack.enter_context(patch(name, side_effect=_Done))
        stack.enter_context(patch.object(study, "build_case", build_case))
        stack.enter_context(warnings.catch_warnings(action="error"))
        yield


def reading_failure(
    read: Callable[[Path], Any], path: Path, judge: Callable[[Any], str | None] = lambda _: None
) -> str | None:
    """Read a file and return what is wrong with the outcome in one line, or None.

    Parameters
    ----------
    read : callable
        Reader; if it starts a computation, the computation is stopped.
    path : Path
        The file.
    judge : callable
        Called with the content as the reader returned it; returns what is wrong with it, or None.
    """
    try:
        with _stopped_computations():
            found = read(path)
    except _Done:
        return None
    except (ValueError, TypeError, OSError) as error:
        return _message_failure(error, path.name)
    except Exception as error:
        return f"uncaught {_located(error)}"
    return judge(found)


def command_failure(words: tuple[object, ...], folder: Path) -> str | None:
    """Run a command of the shell on a damaged file and return what is wrong with its outcome in one line, or None."""
    output, messages = io.StringIO(), io.StringIO()
    code: object = None
    try:
        with (
            _stopped_computations(),
            patch.object(sys, "argv", ["viscoroll", *map(str, words)]),
            redirect_stdout(output),
            redirect_stderr(messages),
        ):
            main()
    except _Done:
        return None
    except SystemExit as ended:
        code = ended.code
    except BaseException as error:
        return f"{words[0]} raises {_located(error)}"
    said = messages.getvalue()
    if code in (None, 0):
        return None
    if code != 2:
        return f"{words[0]} exits with status {code!r}: {said[-200:]!r}"
    if "Traceback" in said or "viscoroll: " not in said or _INTERNAL.search(said):
        return f"{words[0]} prints {said[-300:]!r}"
    return None


def infinite(found: object, *, without: tuple[str, ...] = (), place: str = "") -> str | None:
    """Return the path to a number in the content that is not finite, or None.

    Parameters
    ----------
    found : object
        Dataclasses, sequences, mappings and arrays of numbers.
    without : tuple of str
        Names of members that may be infinite or undefined.
    place : str
        Path to the object itself.
    """
    if isinstance(found, float | np.ndarray):
        numbers = np.asarray(found)
        bad = numbers.dtype.kind == "f" and not np.isfinite(numbers).all()
        return f"read as {numbers[~np.isfinite(numbers)].flat[0]:g}: {place}" if bad else None
    if is_dataclass(found):
        parts: Any = {member.name: getattr(found, member.name) for member in fields(found)}
    elif isinstance(found, Mapping):
        parts = found
    elif isinstance(found, list | tuple):
        parts = {f"[{index}]": value for index, value in enumerate(found)}
    else:
        return None
    for name, value in parts.items():
        if name not in without and (bad_part := infinite(value, without=without, place=f"{place}.{name}".strip("."))):
            return bad_part
    return None


def _message_failure(error: Exception, name: str) -> str | None:
    """Return what is wrong with the message of a rejection, or None."""
    message = str(error)
    if isinstance(error, OSError) and error.filename is not None:
        return None
    if name not in message:
        return f"message does not name the file: {_located(error)}"
    if "\n" in message or not message.isprintable():
        return f"message has several lines: {_located(error)}"
    if _INTERNAL.search(message.replace(repr(name), "")):
        return f"message has internal terms: {_located(error)}"
    return None


def _located(error: BaseException) -> str:
    """Return class, location and message of an exception in one line."""
    frames = traceback.extract_tb(error.__traceback__)
    own = [frame for frame in frames if "viscoroll" in frame.filename] or frames
    where = f" in {Path(own[-1].filename).name}:{own[-1].name}" if own else ""
    text = f"{type(error).__name__}{where}: {str(error)!r}"
    return text[:300]
