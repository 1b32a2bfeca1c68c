"""Solution of cases in separate processes, which may hang or crash."""

from __future__ import annotations

import contextlib
import math
import multiprocessing
import re
import sys
import time
import traceback
import warnings
from collections.abc import Callable, Iterable, Iterator
from dataclasses import asdict, dataclass, field
from functools import partial
from multiprocessing.connection import Connection, wait
from typing import Any, TypeVar

import viscoroll as vr
from viscoroll import enums

from .bodies import with_loads
from .cases import Case, draw
from .invariants import violations
from .twins import at_its_penetration, twins

try:
    import resource
except ImportError:  # Windows, where only the elapsed time ends a case
    resource = None  # type: ignore[assignment]

__all__ = ["FAILURES", "KINDS", "SLOW", "Outcome", "attempt", "run", "run_case"]

Solution = TypeVar("Solution")

#: Kinds of outcomes. Those from the third on are failures, and so is a solution with violations.
KINDS = ("solved", "rejected", "improper message", "no convergence", "hang", "crash", "error")
FAILURES = KINDS[2:]

#: Processor time [s] above which a case is solved without its twins.
SLOW = 2.0

#: Additional elapsed time [s] for a process, since waiting uses no processor time.
PATIENCE = 30.0

#: Internal terms that no message may contain.
_INTERNAL = re.compile(
    r"unknown forces|eliminat|krylov|gmres|bicgstab|newton|preconditi|matrix|active set|singular|eigen|fftw"
    r"|std::|\bnan\b",
    re.IGNORECASE,
)


@dataclass(kw_only=True)
class Outcome:
    """Outcome of a case.

    Attributes
    ----------
    case : str
        "SEED:NUMBER".
    kind : str
        One of `KINDS`.
    stage : str
        Last solve: the case itself, or the twin of that name.
    message : str
        Message of the exception.
    violations : dict
        Conditions that the solution, or that of a twin, violates, with the error relative to the tolerance.
    seconds : float
        Processor time of the case itself.
    has_friction : bool
        Whether the case has friction.
    nodes : int
        Number of nodes in contact.
    source : str
        The call.
    """

    case: str
    kind: str = "solved"
    stage: str = "case"
    message: str = ""
    violations: dict[str, float] = field(default_factory=dict)
    seconds: float = 0.0
    has_friction: bool = False
    nodes: int = 0
    source: str = ""

    @property
    def failed(self) -> bool:
        """Return whether anything is wrong."""
        return self.kind in FAILURES or bool(self.violations)

    def to_dict(self) -> dict[str, Any]:
        """Return all members for JSON, which has no infinity."""
        values = asdict(self)
        values["violations"] = {name: min(error, sys.float_info.max) for name, error in self.violations.items()}
        return values


def run_case(case: Case, before_each: Callable[[Outcome], object] = lambda _: None) -> Outcome:
    """Solve a case and, unless it is slow, its twins, and check the solutions.

    Parameters
    ----------
    case : Case
        The case.
    before_each : callable
        Called before each solve with the outcome so far.
    """
    outcome = Outcome(case=case.name, has_friction=case.has_friction, source=case.source())
    before_each(outcome)
    start = time.process_time()
    result = attempt(vr.solve, case, outcome)
    outcome.seconds = time.process_time() - start
    if result is None:
        if outcome.kind == "rejected":
            _judge_rejection(case, outcome, before_each)
        return outcome
    outcome.nodes = int(result.contact.sum())
    outcome.violations |= violations(case, result)
    # the coating just supports this load
    warned = case.unphysical_argument == "load" and enums.WarningKind.LARGE_STRAIN in result.warnings
    if case.unphysical_argument and not warned:
        outcome.violations[f"unphysical {case.unphysical_argument} accepted"] = math.inf
    for twin in (*twins(case), *at_its_penetration(case, result)) if outcome.seconds < SLOW else ():
        outcome.stage = twin.kind
        before_each(outcome)
        other = attempt(vr.solve, twin.case, outcome)
        if other is None:
            return outcome
        found = twin.differences(result, other)
        outcome.violations |= {f"{twin.kind}: {name}": error for name, error in found.items()}
    outcome.stage = "case"
    return outcome


def attempt(solve: Callable[..., Solution], case: Any, outcome: Outcome) -> Solution | None:
    """Solve a case, and record its exceptions and warnings in the outcome."""
    try:
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            result = solve(case.body, **case.arguments)
    except vr.ConvergenceError as error:
        outcome.message = str(error)
        is_full_stick = math.isinf(case.arguments.get("friction", 0.0))
        outcome.kind = "rejected" if is_full_stick else "no convergence"
    except ValueError as error:
        outcome.message = str(error)
        outcome.kind = "rejected" if _is_proper(outcome.message, case) else "improper message"
    except Exception:
        outcome.kind, outcome.message = "error", traceback.format_exc()
    else:
        for warning in caught:
            if not warning.category.__module__.startswith("viscoroll"):
                outcome.violations[f"warning: {warning.message}"] = math.inf
        return result
    return None


def _is_proper(message: str, case: Any) -> bool:
    """Return whether a message names a given argument, without internal terms."""
    name = re.match(r"([a-z_]+)[\w.\[\]]* must be ", message)
    given = case.arguments.keys() | {"layers", "core_radius", "width", "crown_radius", "sides"}
    given |= {"driving_force", "driving_torque"}  # arguments of transient drives
    return name is not None and name[1] in given and not _INTERNAL.search(message)


def _judge_rejection(case: Case, outcome: Outcome, before_each: Callable[[Outcome], object]) -> None:
    """Test whether a rejected load is supportable, by extrapolation from smaller loads.

    The penetration grows with the power 2/3 of the load on a thick layer, and more slowly on a thin one; the contact
    radius grows with the power 1/3. For line contacts, the powers are 1 and 1/2. Shells that bend are left out.
    """
    shell = getattr(case.body, "inner_boundary", None) is enums.InnerBoundary.HOLLOW
    if not outcome.message.startswith("load ") or case.unphysical_argument or shell:
        return
    outcome.stage = "smaller load"
    depth_power, radius_power = (1.0, 1.0 / 2.0) if case.body.line_contact else (2.0 / 3.0, 1.0 / 3.0)
    for factor in (10.0, 100.0, 1000.0):
        smaller = with_loads(case.arguments, 1.0 / factor)
        before_each(outcome)
        try:
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")
                result = vr.solve(case.body, **smaller)
        except (ValueError, vr.ConvergenceError):
            continue
        depth = factor**depth_power * (result.penetration or 0.0) / case.thickness
        radius = factor**radius_power * max(result.semi_axis_x, result.semi_axis_z or 0.0) / _smallest_radius(case)
        if depth < 0.5 and radius < 0.5:
            outcome.violations["supportable load rejected"] = 0.5 / max(depth, radius)
        break
    outcome.stage = "case"


def _smallest_radius(case: Case) -> float:
    """Return the smaller convex radius of the bodies [m]; a contact beyond 60° of it supports no load."""
    names = ("outer_radius", "radius", "path_radius")
    others = [abs(radius) for name in names if (radius := getattr(case.on, name, None)) is not None]
    return min([case.body.outer_radius, *others])


def run(
    seed: int,
    numbers: Iterable[int],
    *,
    jobs: int,
    limit: float,
    draw: Callable[[int, int], Any] = draw,
    run_case: Callable[..., Outcome] = run_case,
) -> Iterator[Outcome]:
    """Solve cases in several processes; yield outcomes as they arrive.

    Parameters
    ----------
    seed : int
        Seed of the cases.
    numbers : iterable of int
        Numbers of the cases.
    jobs : int
        Number of processes.
    limit : float
        Processor time that one solve may take [s].
    draw : callable
        Called in each process as draw(seed, number); returns the case.
    run_case : callable
        Called in each process as run_case(case, before_each); by default `run_case` of this module.
    """
    waiting = iter(numbers)
    workers = [_Worker(seed, limit, partial(_serve, seed, limit, draw, run_case)) for _ in range(jobs)]
    try:
        busy = {worker for worker in workers if worker.start_next(waiting)}
        while busy:
            ready = wait([worker.connection for worker in busy], timeout=1.0)
            for worker in list(busy):
                outcome = worker.receive() if worker.connection in ready else worker.overdue()
                if outcome is not None:
                    yield outcome
                    if not worker.start_next(waiting):
                        busy.remove(worker)
    finally:
        for worker in workers:
            worker.stop()


class _Worker:
    """A process that solves one case after another, and is replaced when it ends."""

    def __init__(self, seed: int, limit: float, serve: Callable[[Connection], None]) -> None:
        self._seed, self._limit, self._serve = seed, limit, serve
        self._number = -1
        self._so_far: Outcome | None = None
        self._start()

    def _start(self) -> None:
        context = multiprocessing.get_context("spawn")
        self.connection, theirs = context.Pipe()
        self._process = context.Process(target=self._serve, args=(theirs,), daemon=True)
        self._process.start()
        theirs.close()

    def start_next(self, waiting: Iterator[int]) -> bool:
        """Start the next case, if there is one."""
        for self._number in waiting:
            self._so_far = None
            self._deadline = time.monotonic() + PATIENCE * self._limit
            self.connection.send(self._number)
            return True
        return False

    def receive(self) -> Outcome | None:
        """Return the outcome of the case, or None if the worker continues."""
        try:
            is_end, outcome = self.connection.recv()
        except (EOFError, OSError):
            return self._died()
        self._deadline = time.monotonic() + PATIENCE * self._limit
        self._so_far = outcome
        return outcome if is_end else None

    def overdue(self) -> Outcome | None:
        """Terminate a process without progress, and return its outcome."""
        if time.monotonic() < self._deadline:
            return None
        self._process.kill()
        return self._died(waited=True)

    def _died(self, *, waited: bool = False) -> Outcome:
        self._process.join()
        code = self._process.exitcode
        self._start()
        outcome = self._so_far or Outcome(case=f"{self._seed}:{self._number}")
        hung = waited or (resource is not None and code is not None and -code in _OUT_OF_TIME)
        outcome.kind, outcome.message = ("hang", "") if hung else ("crash", f"exit code {code}")
        if hung and outcome.stage == "case":
            outcome.seconds = self._limit
        return outcome

    def stop(self) -> None:
        """Terminate the process."""
        self._process.kill()
        self._process.join()
        self.connection.close()


_OUT_OF_TIME = (24,)  # SIGXCPU


def _serve(
    seed: int,
    limit: float,
    draw: Callable[[int, int], Any],
    run_case: Callable[..., Outcome],
    connection: Connection,
) -> None:
    """Solve the cases whose numbers arrive, until the connection ends."""

    def before_each(outcome: Outcome) -> None:
        connection.send((False, outcome))
        if resource is not None:
            spent = math.ceil(time.process_time() + limit)
            resource.setrlimit(resource.RLIMIT_CPU, (spent, resource.getrlimit(resource.RLIMIT_CPU)[1]))

    if resource is not None:
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    with contextlib.suppress(EOFError, KeyboardInterrupt):
        while True:
            case = draw(seed, connection.recv())
            connection.send((True, run_case(case, before_each)))
