"""Numbers drawn by a seed: every student has an own pose, and the same seed gives the same numbers everywhere.

The draw is a hash of text, not a generator of random numbers: it depends on no machine, no version of Python and no
order in which things are done. A draw that a mistake could hide behind is thrown away, and the next one taken: first
by plain rules (see `degenerate`), then by making every mistake that dhcli knows and looking whether it shows.
"""

from __future__ import annotations

import hashlib
import unicodedata
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from itertools import islice
from typing import TYPE_CHECKING, NoReturn

from dhcli.errors import DhcliError
from dhcli.kinematics.robot import Value

if TYPE_CHECKING:
    from dhcli.checking.diagnosis.draws import Unclear
    from dhcli.checking.exercise import Exercise

MOST_DRAWS = 1000
"""Draws after which the ranges are held to be at fault."""

MOST_LOOKED_AT = 20
"""Draws that break no rule, among which the first that shows every mistake is taken, or that which shows most."""

REFERENCE = ""
"""The seed of nobody: its draws tell which mistakes an exercise hides whatever its numbers are."""

LONGEST_SEED = 100


@dataclass(frozen=True, slots=True)
class Range:
    """The values that a name may take.

    Attributes:
        text: As the author wrote it, `20°..70° step 5°`.
        values: All of them, exact, at least one.
    """

    text: str
    values: tuple[Value, ...]


def vary(exercise: Exercise, seed: str) -> Exercise:
    """The exercise with the numbers of a seed.

    Args:
        exercise: An exercise with `variants`.
        seed: Any text on one line, such as the name of a student; blanks around it do not count.

    Returns:
        A copy whose `given` holds the drawn values, and whose `variant` is the seed. What the document prints is not
        in it, for that answers the numbers of the file.

    Raises:
        DhcliError: The exercise has no variants, the text is no seed, or its ranges hold hardly any pose at which
            mistakes show.
    """
    seed = unicodedata.normalize("NFC", seed.strip())
    if not exercise.variants:
        raise DhcliError(f"{exercise.id} has no variants: its numbers are the same for everybody", "leave it out")
    if not seed or not seed.isprintable() or len(seed) > LONGEST_SEED:
        hint = f"such as alice, on one line and at most {LONGEST_SEED} characters long"
        raise DhcliError("the name of a variant is a short text", hint)
    return _plainest(exercise, _fair(exercise, seed)) or _refuse(exercise, seed)


def variant_of(exercise: Exercise, asked: str | None, written: str = "", sheet: str = "") -> Exercise:
    """The exercise with the numbers that were asked for, or that a sheet was written with; as it is by neither.

    Args:
        exercise: The exercise.
        asked: The seed that was typed.
        written: The seed that stands on a sheet.
        sheet: What to call the sheet.

    Raises:
        DhcliError: The two differ, or see `vary`.
    """
    if asked is not None and written and asked != written:
        raise DhcliError(f"{sheet} is a sheet of variant {written}, not of {asked}", "leave --variant out")
    seed = asked if asked is not None else written or None
    return exercise if seed is None else vary(exercise, seed)


def hidden_by_numbers(drawn: Exercise, exercise: Exercise) -> Unclear:
    """The mistakes that a draw does not show though others do.

    Args:
        drawn: A draw of the exercise.
        exercise: The exercise with the numbers of its file.

    Returns:
        Each as the name of a part and that of a slip; not those that the question hides whatever the numbers are.
    """
    if not exercise.numeric:
        return frozenset()
    from dhcli.checking.diagnosis.draws import draws_of

    draws = draws_of(exercise)
    unclear = draws.unclear(drawn)
    return unclear and unclear - draws.always(islice(_fair(exercise, REFERENCE), MOST_LOOKED_AT))


def _fair(exercise: Exercise, seed: str) -> Iterator[Exercise]:
    """The draws of a seed in their order, without those that a rule forbids."""
    from dhcli.checking.degenerate import flaw  # few sheets have a variant

    for attempt in range(MOST_DRAWS):
        drawn = _draw(exercise, seed, attempt)
        if not flaw(drawn):
            yield drawn


def _plainest(exercise: Exercise, fair: Iterator[Exercise]) -> Exercise | None:
    """The first draw that shows every mistake that can be shown, or else the first of those that show most."""
    best: tuple[int, Exercise] | None = None
    seen: list[Mapping[str, Value]] = []
    for drawn in islice(fair, MOST_LOOKED_AT):
        if drawn.given in seen:
            continue
        seen.append(drawn.given)
        count = len(hidden_by_numbers(drawn, exercise))
        if not count:
            return drawn
        if best is None or count < best[0]:
            best = count, drawn
    return best and best[1]


def _refuse(exercise: Exercise, seed: str) -> NoReturn:
    from dhcli.checking.degenerate import flaw

    ranges = ", ".join(f"{name}: {range_.text}" for name, range_ in exercise.variants.items())
    last = flaw(_draw(exercise, seed, MOST_DRAWS - 1))
    message = f"{exercise.id}: {MOST_DRAWS} draws gave no pose at which mistakes show; the last: {last}"
    raise DhcliError(message, f"widen the variants, {ranges}")


def _draw(exercise: Exercise, seed: str, attempt: int) -> Exercise:
    drawn = {name: _drawn(range_, exercise, seed, name, attempt) for name, range_ in exercise.variants.items()}
    parts = tuple(replace(part, printed=None) for part in exercise.parts)
    return replace(exercise, given={**exercise.given, **drawn}, variant=seed, parts=parts)


def _drawn(range_: Range, exercise: Exercise, seed: str, name: str, attempt: int) -> Value:
    """A value by hash; the exercise goes in by its last name, which is the same from the library and from a file."""
    words = "\n".join((seed, exercise.id.split("/")[-1], name, str(attempt)))
    number = int.from_bytes(hashlib.sha256(words.encode()).digest())
    return range_.values[number % len(range_.values)]
