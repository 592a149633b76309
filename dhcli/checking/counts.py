"""Counts of a linkage: a whole number, and on a miss the slips that give exactly the number typed."""

from __future__ import annotations

import math

from dhcli.algebra.floats import Floats
from dhcli.checking.pasted import UnreadableError, without_label
from dhcli.checking.questions import CountQuestion
from dhcli.checking.verdicts import Mark, Verdict
from dhcli.errors import DhcliError, Place
from dhcli.notation.parser import parse
from dhcli.notation.scope import Scope
from dhcli.notation.tree import Unit
from dhcli.notation.walk import walk

LARGEST = 10**6
COUNTED = " comes out when "
"""What a remark says between a number and the slip that gives it."""


def right_count(question: CountQuestion) -> int:
    """The right answer.

    Raises:
        DhcliError: The linkage was not looked up, or its count is not decided.
    """
    from dhcli.mobility.slips import count

    if question.found is None:
        raise DhcliError(f"the linkage {question.linkage} was not looked up", "load the exercise from its file")
    return count(question.what, question.found)


def mark_count(question: CountQuestion, answer: str, place: Place | None = None) -> Mark:
    """Judge a count; a calculation such as `3*(4 - 1) - 2*4` is worked out.

    Raises:
        UnreadableError: It is no whole number.
    """
    right = right_count(question)
    text = without_label(answer)
    expr = parse(text, Scope(), place or Place("answer"))
    if any(isinstance(node, Unit) for node in walk(expr)):
        raise UnreadableError("a count is a whole number and has no unit")
    value = Floats().value(expr)
    if not math.isfinite(value) or value != round(value) or abs(value) > LARGEST:
        raise UnreadableError("a count is a whole number")
    typed = int(value)
    if typed == right:
        return Mark(Verdict.RIGHT, str(typed), earned=1.0, expected=str(right))
    return Mark(Verdict.WRONG, str(typed), remarks=_slips(question, typed), expected=str(right))


def _slips(question: CountQuestion, typed: int) -> tuple[str, ...]:
    from dhcli.mobility.slips import slips

    if question.found is None:
        return ()
    names = [name for name, value in slips(question.what, question.found).items() if value == typed]
    return (f"{typed}{COUNTED}{' or when '.join(names)}",) if names else ()
