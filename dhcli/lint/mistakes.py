"""Rules about mistakes: those an exercise tests itself with, and those that its pose cannot show."""

from __future__ import annotations

from collections.abc import Iterator

from dhcli.checking.exercise import Part
from dhcli.checking.judge import Judge
from dhcli.checking.written import Trial
from dhcli.errors import DhcliError
from dhcli.kinematics.validity import Finding
from dhcli.kinematics.values import numbers
from dhcli.lint.kept import kept
from dhcli.notation.angle import Angle
from dhcli.notation.quantity import value_text

POSES = ((25, 40, 70, 35, 60, 15), (35, 20, 50, 65, 30, 80), (20, 65, 35, 50, 80, 60))
"""Angles in degrees, none at a right angle or half of one, no two that add up to one: they hide little."""

MOST_NAMED = 3
"""Mistakes that a finding names; of more, it tells how many."""


def typed(judge: Judge, trial: Trial) -> str:
    """The answer of a test: as typed, or as its mistake leads to.

    Raises:
        UnknownNameError: There is no such mistake here.
    """
    part = judge.exercise.part(trial.part)
    return judge.answer_with(part, trial.mistake) if trial.mistake else trial.answer


def findings(judge: Judge) -> Iterator[Finding]:
    """What the pose of an exercise in numbers hides, with a pose that shows it; an error where it is half of all."""
    for part in judge.exercise.asked if judge.exercise.numeric else ():
        yield from kept(_hidden(judge, part, ("parts", part.index)), ("parts", part.index), part.id)


def _hidden(judge: Judge, part: Part, where: tuple[str | int, ...]) -> Iterator[Finding]:
    """What it hides of one part."""
    if unseen := judge.hidden(part):
        names = ", ".join(slip.name for slip in unseen[:MOST_NAMED]) + (", ..." if len(unseen) > MOST_NAMED else "")
        blind = len(unseen) > len(judge.slips(part))
        what = "a mistake" if len(unseen) == 1 else f"{len(unseen)} mistakes"
        message = f"{part.id}: this pose does not show {what}: {names}"
        hint = _better(judge, part) or ("" if blind else "nothing to do if it is meant so")
        yield Finding(where, message, hint, is_warning=not blind)


def _better(judge: Judge, part: Part) -> str:
    """A pose that hides fewer, as it would be given; nothing where none is found."""
    exercise = judge.exercise
    now = len(judge.hidden(part))
    best: tuple[int, str] = (now, "")
    for degrees in POSES:
        given = dict(exercise.given)
        turning = [name for name, value in given.items() if isinstance(value, Angle)]
        for name, angle in zip(turning, degrees, strict=False):
            given[name] = Angle.in_degrees(angle)
        if numbers(given) == numbers(exercise.given):
            continue
        try:
            left = len(judge.with_given(given).hidden(part))
        except DhcliError:
            continue
        if left < best[0]:
            best = left, ", ".join(f"{name}: {value_text(given[name])}" for name in turning)
    shown = f"hides {best[0]} only" if best[0] else "shows it" if now == 1 else f"shows all {now}"
    return f"given: {{{best[1]}}} {shown}" if best[1] else ""
