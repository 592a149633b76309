"""Rules for variants: every seed gives a good pose, its solution is right, and no text gives a number away."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping

from dhcli.checking.exercise import Exercise, Part
from dhcli.checking.judge import Judge
from dhcli.checking.variants import hidden_by_numbers, vary
from dhcli.checking.verdicts import Verdict
from dhcli.errors import DhcliError
from dhcli.kinematics.derived import in_floats
from dhcli.kinematics.limits import is_within_limits
from dhcli.kinematics.robot import Value
from dhcli.kinematics.validity import Finding
from dhcli.notation.names import canonical
from dhcli.notation.quantity import value_text
from dhcli.regex import regex

SEEDS = tuple(str(number) for number in range(1, 201))
"""So many students are tried."""

_ASSIGNED = regex(r"(?<!\w)(\\?[^\W\d_]+_?\{?\d*\}?)\s*=\s*([-−]?\d[\d.]*)")  # noqa: RUF001  the sign of a document


def written(exercise: Exercise) -> Iterator[Finding]:
    """Every broken rule about what stands in the file, for which nothing is drawn; nothing without variants."""
    if exercise.variants:
        yield from _within_limits(exercise)
        yield from _texts(exercise)


def _within_limits(exercise: Exercise) -> Iterator[Finding]:
    robot = exercise.robot
    if robot is None:
        return
    for name, range_ in exercise.variants.items():
        outside = [value for value in range_.values if not is_within_limits(robot, name, in_floats(value))]
        if outside:
            shown = " to ".join(map(value_text, robot.limits[name]))
            message = f"{name}: {value_text(outside[0])} is outside its limits, {shown}"
            yield Finding(("variants", name), message, "narrow the range")


def _texts(exercise: Exercise) -> Iterator[Finding]:
    """A number in a text stays what it is while the value beside it varies."""
    texts: dict[tuple[str | int, ...], str] = {("task",): exercise.task}
    for part in exercise.parts:
        texts["parts", part.index, "prompt"] = part.prompt
        texts |= {("parts", part.index, "hints", k): hint for k, hint in enumerate(part.hints)}
    fixed = {value_text(v) for name, v in exercise.values.items() if name not in exercise.variants}
    loose = {name: value_text(v) for name, v in exercise.given.items() if name in exercise.variants}
    for where, text in texts.items():
        assigned = {canonical(found[1]) for found in _ASSIGNED.finditer(text) if not _is_zero_pose(found[2], exercise)}
        for name in assigned.intersection(exercise.variants):
            hint = "dhcli writes the drawn numbers below the task; leave it out here"
            yield Finding(where, f"{name} varies, and this text gives it a number", hint)
        for name, shown in loose.items():
            if shown not in fixed and re.search(rf"(?<![\d.]){re.escape(shown)}", text):
                message = f"this text says {shown}, which is {name} in the file and another number in a variant"
                yield Finding(where, message, f"write {name}", is_warning=True)


def _is_zero_pose(number: str, exercise: Exercise) -> bool:
    """Whether a number tells of the pose at zero, as tasks do, `theta1 = theta2 = 0`, and is none of those drawn."""
    return not number.strip("-−0.") and not any(in_floats(v) == 0 for v in exercise.given.values())  # noqa: RUF001


def findings(judge: Judge) -> Iterator[Finding]:
    """The first seed that draws nothing, whose pose hides a mistake, or whose solution is not right.

    The same numbers are tried once; nothing is told of an exercise without variants.
    """
    tried: list[Mapping[str, Value]] = []
    blind = False
    for seed in SEEDS if judge.exercise.variants else ():
        try:
            drawn = vary(judge, seed)
        except DhcliError as error:
            yield Finding(("variants",), error.problems[0].message, error.problems[0].hint)
            return
        if drawn.exercise.given in tried:
            continue
        tried.append(drawn.exercise.given)
        if not blind and (hidden := hidden_by_numbers(drawn, judge)):
            blind = True
            where, name = min(hidden)
            message = f"variant {seed}: no pose was found that shows every mistake; at this one {where} hides {name}"
            yield Finding(("variants",), message, "widen the ranges, or narrow the tolerance", is_warning=True)
        for part in drawn.exercise.asked:
            verdict = _own_verdict(drawn, part)
            if verdict is not Verdict.RIGHT and verdict is not None:
                message = f"variant {seed}: the solution of {part.id} is judged {verdict.word}"
                yield Finding(
                    ("variants",), message, f"dhcli solution {judge.exercise.id} --variant {seed} --part {part.id}"
                )
                return


def _own_verdict(judge: Judge, part: Part) -> Verdict | None:
    """How its own solution is judged; None where it has none, which is told for the exercise itself."""
    try:
        return judge.mark(part, judge.expected(part)).verdict
    except DhcliError:
        return None
