"""Plans that were found before: those of the library's robots are shipped, others are kept in the user's cache.

A plan is kept under the numbers of the arm it is for, so that it is found again wherever the arm comes from, and is
none for an arm that has changed. It is kept as data (JSON), and found anew where it cannot be read.
"""

from __future__ import annotations

import json
import zlib
from collections.abc import Iterable, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

from dhcli.frozen import frozen
from dhcli.kinematics.inverse.arm import Arm
from dhcli.kinematics.inverse.idealised import idealised
from dhcli.kinematics.inverse.matrices import Actions
from dhcli.kinematics.inverse.pairings import Cut
from dhcli.kinematics.inverse.steps import All, Equation, One, Plan, Step, Two
from dhcli.kinematics.inverse.tasks import Task
from dhcli.storage.cache import cache, cached

FORMAT = 4
"""Goes up with every change of what a plan is made of, or of how it is found."""

SHIPPED = Path(__file__).with_name("plans.jsonl")
"""Plans of the library's robots, a line each: its name, a space, the plan."""

FOLDER = "plans"
"""Where in the cache the others are."""

_DIGITS = 12
"""To so many digits the numbers of two arms are the same."""


@frozen
class Kept:
    """A plan, and what was found out with it.

    Attributes:
        plan: The plan.
        spare: How many joints the arm has more than the task needs.
    """

    plan: Plan
    spare: int


def recalled(arm: Arm, task: Task, hold: Sequence[int]) -> Kept | None:
    """The plan that was found before, or None."""
    content = content_of(arm, task, hold)
    name = name_of(content)
    line = _shipped(name) or cached(FOLDER, name)
    return None if line is None else read(line, content, arm)


def remember(kept: Kept, task: Task, hold: Sequence[int]) -> None:
    """Keep a plan in the user's cache."""
    content = content_of(kept.plan.actions.arm, task, hold)
    cache(written(kept, content), FOLDER, name_of(content))


def content_of(arm: Arm, task: Task, hold: Sequence[int]) -> str:
    """All that a plan depends on, as text."""
    axes = [[int(axis.turns), *_rounded((*axis.direction, *axis.point))] for axis in arm.axes]
    return json.dumps([FORMAT, task.name, list(hold), arm.joints, axes, _rounded(arm.home[:3].reshape(-1).tolist())])


def _rounded(numbers: Iterable[float]) -> list[float]:
    return [round(number, _DIGITS) + 0.0 for number in numbers]


def name_of(content: str) -> str:
    """What a plan is called by that depends on this content."""
    given = content.encode()
    return f"{zlib.crc32(given):08x}{zlib.adler32(given):08x}"


def _shipped(name: str) -> str | None:
    try:
        with SHIPPED.open(encoding="utf-8") as lines:
            return next((line.partition(" ")[2] for line in lines if line.startswith(name)), None)
    except (OSError, ValueError):
        return None


def written(kept: Kept, content: str) -> str:
    """A plan as a line of text."""
    body = [kept.spare, _plan(kept.plan)]
    text = json.dumps(body, separators=(",", ":"))
    return json.dumps([zlib.crc32((content + text).encode()), body], separators=(",", ":"))


def read(line: str, content: str, arm: Arm) -> Kept | None:
    """A plan from a line of text; None where it is not what was written for this content."""
    try:
        check, body = json.loads(line)
        text = json.dumps(body, separators=(",", ":"))
        if check != zlib.crc32((content + text).encode()):
            return None
        spare, plan = body
        return Kept(_as_plan(plan, arm), spare)
    except (ValueError, TypeError, KeyError, IndexError, RecursionError):
        return None


def _plan(plan: Plan) -> list[Any]:
    meant = None if plan.meant is None else _plan(plan.meant)
    return [plan.held, plan.slack, [_step(step) for step in plan.steps], meant]


def _as_plan(data: list[Any], arm: Arm) -> Plan:
    held, slack, steps, meant = data
    plan = Plan(Actions(arm), tuple(held), tuple(map(_as_step, steps)), slack)
    if meant is None:
        return plan
    ideal = idealised(arm)
    if ideal is None:
        raise ValueError(meant)
    return replace(plan, meant=_as_plan(meant, ideal))


def _step(step: Step) -> list[Any]:
    match step:
        case One():
            equations = [[_cut(e.cut), e.x, e.y, e.size] for e in step.equations]
            return ["one", step.joint, step.kind, equations, [_cut(cut) for cut in step.cuts]]
        case Two():
            return ["two", step.joint, step.other, [[_cut(cut), number] for cut, number in step.equations]]
        case All():
            return ["all", step.joints, step.others, step.things, step.three, step.two, step.rows, step.turn]


def _as_step(data: list[Any]) -> Step:
    match data:
        case ["one", joint, kind, equations, cuts]:
            made = tuple(Equation(_as_cut(cut), tuple(x), tuple(y), size) for cut, x, y, size in equations)
            return One(joint, kind, made, tuple(map(_as_cut, cuts)))
        case ["two", joint, other, [(first, i), (second, k)]]:
            return Two(joint, other, ((_as_cut(first), i), (_as_cut(second), k)))
        case ["all", *parts]:
            return All(*map(_tuples, parts))
        case _:
            raise ValueError(data)


def _cut(cut: Cut) -> list[Any]:
    return [cut.kind, cut.first, cut.second, cut.between, cut.around]


def _as_cut(data: list[Any]) -> Cut:
    kind, *runs = data
    first, second, between, around = map(tuple, runs)
    return Cut(kind, first, second, between, around)


def _tuples(part: Any) -> Any:  # noqa: ANN401  lists in lists, as JSON has them
    return tuple(map(_tuples, part)) if isinstance(part, list) else part
