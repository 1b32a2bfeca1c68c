"""Summary of randomized tests on one page."""

from __future__ import annotations

import re
from collections import Counter, defaultdict
from collections.abc import Sequence

from .runner import KINDS, Outcome

__all__ = ["summary"]


def summary(outcomes: Sequence[Outcome], examples: int = 3) -> str:
    """Return counts by kind, classes of failures with examples, and times."""
    frictional = [outcome for outcome in outcomes if outcome.has_friction]
    lines = [f"{len(outcomes)} cases, {len(frictional)} with friction", ""]
    for kind in KINDS:
        count = sum(outcome.kind == kind for outcome in outcomes)
        with_friction = sum(outcome.kind == kind for outcome in frictional)
        lines.append(f"  {kind:<20} {count:6d}   with friction {with_friction:6d}")
    violating = [outcome for outcome in outcomes if outcome.violations]
    lines += [f"  {'with violations':<20} {len(violating):6d}", ""]
    lines += _classes(outcomes, examples)
    times = sorted(outcomes, key=lambda outcome: -outcome.seconds)
    lines.append(f"time without twins: {sum(outcome.seconds for outcome in outcomes):.0f} s; longest cases:")
    lines += [f"  {outcome.seconds:6.1f} s  {outcome.case}  ({outcome.nodes} nodes)" for outcome in times[:5]]
    return "\n".join(lines)


def _classes(outcomes: Sequence[Outcome], examples: int) -> list[str]:
    """Return each class of failure with the cases that have it."""
    members: defaultdict[str, list[str]] = defaultdict(list)
    for outcome in outcomes:
        if outcome.failed and outcome.kind != "solved":
            members[f"{outcome.kind} [{outcome.stage}] {_shape(outcome.message)}".strip()].append(outcome.case)
        for name, error in outcome.violations.items():
            members[f"violated: {name}"].append(f"{outcome.case} ({error:.1g})")
    counts = Counter({name: len(cases) for name, cases in members.items()})
    lines: list[str] = []
    for name, count in counts.most_common():
        lines += [f"{count:6d}  {name}", f"        {', '.join(members[name][:examples])}"]
    return [*lines, ""] if lines else []


def _shape(message: str) -> str:
    """Return a message without its numbers."""
    last = message.strip().splitlines()[-1] if message else ""
    return re.sub(r"-?\d+(\.\d+)?(e[-+]?\d+)?", "#", last)[:150]
