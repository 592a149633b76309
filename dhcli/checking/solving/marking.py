"""Joint vectors judged: one by where it leads and its branch, a set by every solution in it."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from dhcli.checking.exercise import Case
from dhcli.checking.solving.question import WantedJoints
from dhcli.checking.solving.reading import Vector
from dhcli.checking.solving.vectors import Range
from dhcli.checking.verdicts import Mark, Verdict
from dhcli.errors import plural

if TYPE_CHECKING:
    from dhcli.kinematics.inverse.solutions import Solutions


def mark_one(
    question: WantedJoints, case: Case, field: Range, found: Solutions, wanted: Sequence[int], typed: Sequence[Vector]
) -> Mark:
    """Judge one joint vector."""
    from dhcli.kinematics.inverse.solutions import shown_beyond

    (one,) = typed
    landing = field.landing(one.values, case.tolerance)
    verdict, at = landing.verdict, landing.solution
    remarks = [] if verdict is Verdict.RIGHT else [landing.words]
    if verdict is Verdict.RIGHT and at is not None and at not in wanted:
        verdict = Verdict.WRONG
        branch = found.branches[at]
        if question.branch and not all(word in branch.split(", ") for word in question.branch):
            asked = " and ".join(question.branch)
            remarks.append(f"the pose is reached, on another branch: {branch or 'another'}; {asked} is asked for")
    if landing.verdict is Verdict.RIGHT and at is not None and found.beyond[at]:
        outside = ", ".join(shown_beyond(field.robot, beyond) for beyond in found.beyond[at])
        remarks.append(f"outside the limits of the joints: {outside}")
    earned = float(verdict is Verdict.RIGHT)
    expected = question.text_of(case, [field.solutions[wanted[0]]])
    return Mark(verdict, one.shown, (), tuple(filter(None, remarks)), earned, expected)


def mark_set(
    question: WantedJoints, case: Case, field: Range, found: Solutions, wanted: Sequence[int], typed: Sequence[Vector]
) -> Mark:
    """Judge a set of joint vectors: it earns by each solution, and what is none of them costs as much."""
    seen: dict[int, int] = {}
    remarks, strangers, near = list[str](), 0, 0
    for row, one in enumerate(typed, 1):
        landing = field.landing(one.values, case.tolerance)
        at = landing.solution
        if landing.verdict is not Verdict.RIGHT:
            near += landing.verdict is Verdict.CLOSE
            strangers += 1
            remarks.append(f"row {row} is no solution: {landing.words}")
        elif at in seen:
            remarks.append(f"row {row} repeats row {seen[at]}: they differ by whole turns")
        elif at is not None and at in wanted:
            seen[at] = row
        elif at is None:
            remarks.append(f"row {row} reaches the pose beside the solutions told apart here")
        else:
            strangers += 1
            remarks.append(f"row {row} reaches the pose outside the limits of the joints")
    missing = [k for k in wanted if k not in seen]
    verdict = Verdict.RIGHT
    if missing or strangers:
        verdict = Verdict.CLOSE if near == strangers == len(missing) else Verdict.WRONG
    if missing and not strangers:
        remarks.insert(0, f"{plural(len(seen), 'solution')} of {len(wanted)}{_lost(found, seen, missing)}")
    elif missing:
        remarks.insert(0, f"{plural(len(seen), 'solution')} of {len(wanted)}")
    earned = len(seen) / (len(wanted) + strangers)
    expected = question.text_of(case, (field.solutions[k] for k in wanted))
    shown = "; ".join(one.shown for one in typed)
    return Mark(verdict, shown, (), tuple(remarks), 1.0 if verdict is Verdict.RIGHT else earned, expected)


def _lost(found: Solutions, seen: dict[int, int], missing: Sequence[int]) -> str:
    """The branch that is left out, where one word tells it."""
    there = {word for k in seen for word in found.branches[k].split(", ")}
    lost = [word for word in found.branches[missing[0]].split(", ") if word]
    words = [w for w in lost if w not in there and all(w in found.branches[k].split(", ") for k in missing)]
    return f": the branch {words[0]} is left out" if words else ""
