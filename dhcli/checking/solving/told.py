"""What is said of a formula for a joint that is not right: where it holds, and what it loses."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from dhcli.checking.solving import covering
from dhcli.checking.solving.covering import Asked, Case, Outcome
from dhcli.checking.verdicts import HALF_TURN_OFF
from dhcli.notation.tree import Expr


def told(
    outcome: Outcome, cases: Sequence[Case], asked: Asked, candidates: Sequence[tuple[str, Expr]], text: str
) -> Iterator[str]:
    """What a formula gets right, and what it loses."""
    right = covering.where(outcome.hits, cases, asked, candidates)
    only = f"right where {right} only" if right else f"right for {outcome.share:.0%} of the solutions"
    if not any(outcome.hits):
        if outcome.silent == len(cases):
            yield "it has no real value at any of the poses tried"
        else:
            yield "it gives no solution at any of the poses tried"
    elif outcome.is_sound:
        by = next((name for name in ("acos", "asin", "atan(", "sqrt") if name in text and "±" not in text), "")
        yield (f"{only}: {by.strip('(')} gives one of two" if by else f"{only}: some values are missing")
    elif outcome.wrapped:
        yield f"{only}: {HALF_TURN_OFF if 'atan(' in text else 'elsewhere it is half a turn off'}"
    elif outcome.is_covering:
        yield "no value is missing, but some of its values solve nothing"
    else:
        yield only
    if any(outcome.hits) and 0 < outcome.silent < len(cases):
        yield "it has no real value at some poses that are reached"
