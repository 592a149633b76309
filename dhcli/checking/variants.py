"""Numbers drawn by a seed: every student has an own pose, and the same seed gives the same numbers everywhere.

The draw is a hash of text, not a generator of random numbers: it depends on no machine, no version of Python and no
order in which things are done. A draw that a mistake could hide behind is thrown away, and the next one taken: first
by plain rules (see `degenerate`), then by making every mistake that dhcli knows and looking whether it shows.
"""

from __future__ import annotations

import unicodedata
from collections.abc import Iterator, Mapping
from dataclasses import replace
from itertools import islice
from typing import NoReturn, TypeAlias

from dhcli.checking.exercise import Exercise
from dhcli.checking.judge import Judge
from dhcli.checking.written import Range
from dhcli.errors import DhcliError
from dhcli.kinematics.robot import Value

Unclear: TypeAlias = frozenset[tuple[str, str]]
"""Mistakes that a pose does not show plainly, each as the name of a part and that of a slip."""

MOST_DRAWS = 1000
"""Draws after which the ranges are held to be at fault."""

MOST_LOOKED_AT = 20
"""Draws that break no rule, among which the first that shows every mistake is taken, or that which shows most."""

REFERENCE = ""
"""The seed of nobody: its draws tell which mistakes an exercise hides whatever its numbers are."""

LONGEST_SEED = 100


def vary(judge: Judge, seed: str) -> Judge:
    """The exercise with the numbers of a seed, and its judge.

    Args:
        judge: The judge of an exercise with `variants`.
        seed: Any text on one line, such as the name of a student; blanks around it do not count.

    Returns:
        That of a copy whose `given` holds the drawn values, and whose `variant` is the seed. What the document prints
        is not in it, for that answers the numbers of the file.

    Raises:
        DhcliError: The exercise has no variants, the text is no seed, or its ranges hold hardly any pose at which
            mistakes show.
    """
    exercise, seed = judge.exercise, unicodedata.normalize("NFC", seed.strip())
    if not exercise.variants:
        raise DhcliError(f"{exercise.id} has no variants: its numbers are the same for everybody", "leave it out")
    if not seed or not seed.isprintable() or len(seed) > LONGEST_SEED:
        hint = f"such as alice, on one line and at most {LONGEST_SEED} characters long"
        raise DhcliError("the name of a variant is a short text", hint)
    return _plainest(judge, _fair(judge, seed)) or _refuse(judge, seed)


def variant_of(judge: Judge, asked: str | None, written: str = "", sheet: str = "") -> Judge:
    """The exercise with the numbers that were asked for, or that a sheet was written with; as it is by neither.

    Raises:
        DhcliError: The two differ, or see `vary`.
    """
    if asked is not None and written and asked != written:
        raise DhcliError(f"{sheet} is a sheet of variant {written}, not of {asked}", "leave --variant out")
    seed = asked if asked is not None else written or None
    return judge if seed is None else vary(judge, seed)


def hidden_by_numbers(drawn: Judge, judge: Judge) -> Unclear:
    """The mistakes that a draw does not show though others do, such as the numbers of the file.

    Returns:
        Each as the name of a part and that of a slip; not those that the question hides whatever the numbers are.
    """
    if not judge.exercise.numeric:
        return frozenset()
    values = tuple(drawn.exercise.given[name] for name in judge.exercise.variants)
    unclear = judge.memo.of(("unclear", values), drawn.unclear)
    return unclear and unclear - judge.memo.of("always unclear", lambda: _always(judge))


def _always(judge: Judge) -> Unclear:
    """The mistakes that none of some draws shows: it is the question that hides them."""
    found: Unclear | None = None
    for drawn in islice(_fair(judge, REFERENCE), MOST_LOOKED_AT):
        found = drawn.unclear() if found is None else found & drawn.unclear()
        if not found:
            break
    return found or frozenset()


def _fair(judge: Judge, seed: str) -> Iterator[Judge]:
    """The draws of a seed in their order, without those that a rule forbids."""
    from dhcli.checking.degenerate import flaw  # few sheets have a variant

    for attempt in range(MOST_DRAWS):
        drawn = _draw(judge.exercise, seed, attempt)
        if not flaw(judge.exercise, drawn):
            yield _judge_of(judge, seed, drawn)


def _plainest(judge: Judge, fair: Iterator[Judge]) -> Judge | None:
    """The first draw that shows every mistake that can be shown, or else the first of those that show most."""
    best: tuple[int, Judge] | None = None
    seen: list[Mapping[str, Value]] = []
    for drawn in islice(fair, MOST_LOOKED_AT):
        if drawn.exercise.given in seen:
            continue
        seen.append(drawn.exercise.given)
        count = len(hidden_by_numbers(drawn, judge))
        if not count:
            return drawn
        if best is None or count < best[0]:
            best = count, drawn
    return best and best[1]


def _refuse(judge: Judge, seed: str) -> NoReturn:
    from dhcli.checking.degenerate import flaw

    exercise = judge.exercise
    ranges = ", ".join(f"{name}: {range_.text}" for name, range_ in exercise.variants.items())
    last = flaw(exercise, _draw(exercise, seed, MOST_DRAWS - 1))
    message = f"{exercise.id}: {MOST_DRAWS} draws gave no pose at which mistakes show; the last: {last}"
    raise DhcliError(message, f"widen the variants, {ranges}")


def _draw(exercise: Exercise, seed: str, attempt: int) -> dict[str, Value]:
    return {name: _drawn(range_, exercise, seed, name, attempt) for name, range_ in exercise.variants.items()}


def _judge_of(judge: Judge, seed: str, drawn: Mapping[str, Value]) -> Judge:
    """The judge of an exercise with the values drawn; what the document prints answers the numbers of the file."""
    parts = tuple(replace(part, printed=None) for part in judge.exercise.parts)
    return judge.with_given({**judge.exercise.given, **drawn}, variant=seed, parts=parts)


def _drawn(range_: Range, exercise: Exercise, seed: str, name: str, attempt: int) -> Value:
    """A value by hash; the exercise goes in by its last name, which is the same from the library and from a file."""
    from hashlib import sha256  # it loads all of OpenSSL

    words = "\n".join((seed, exercise.id.split("/")[-1], name, str(attempt)))
    number = int.from_bytes(sha256(words.encode()).digest())
    return range_.values[number % len(range_.values)]
