"""What can go wrong, said once: where, what, and what would be right.

Every error a user can cause is a `DhcliError` that carries one or more `Problem`s; a file with five mistakes
raises one error with five problems. The command line maps the class to an exit code, nothing else does.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from enum import IntEnum
from itertools import islice

from dhcli.frozen import frozen

MOST_CANDIDATES = 200
"""Names that a mistyped one is compared with; a file may hold more of both than time allows."""


class ExitStatus(IntEnum):
    """Exit codes of the command line; a contract that scripts rely on."""

    DONE = 0
    NOT_RIGHT = 1
    BAD_INPUT = 2
    BUG = 3
    HUNG_UP = 129
    INTERRUPTED = 130
    TERMINATED = 143


@frozen
class Place:
    """A position in something a person wrote.

    Attributes:
        source: File name, or the option or argument the text came from, such as `--q`.
        line: Line number from 1, or None where the text is a single line.
        column: Column number from 1, counted in characters, or None.
        text: The whole line, for a marker under it; empty if not worth showing.
    """

    source: str
    line: int | None = None
    column: int | None = None
    text: str = ""

    def __str__(self) -> str:
        """`file:line:column`, without the parts that are unknown."""
        return ":".join(str(part) for part in (self.source, self.line, self.column) if part is not None)

    @property
    def order(self) -> tuple[int, int]:
        """Line and column, to sort by; what has no line comes first."""
        return self.line or 0, self.column or 0


@frozen
class Problem:
    """One thing that is wrong: where, what, and what would be right.

    Attributes:
        message: What is wrong, in a sentence without a final stop.
        place: Where it stands, if it stands somewhere.
        hint: What would be right, or what to try next; may be empty.
    """

    message: str
    place: Place | None = None
    hint: str = ""

    def __str__(self) -> str:
        """One line: `place: message (hint)`."""
        where = f"{self.place}: " if self.place and str(self.place) else ""
        hint = f" ({self.hint})" if self.hint else ""
        return f"{where}{self.message}{hint}"

    @property
    def order(self) -> tuple[int, int]:
        """That of its place, in one file; what has no place comes first."""
        return self.place.order if self.place else (0, 0)


class DhcliError(Exception):
    """Base of every error that a user can cause.

    Attributes:
        problems: All problems found, at least one, in reading order.
    """

    status = ExitStatus.BAD_INPUT

    def __init__(self, problems: Problem | str | Iterable[Problem], hint: str = "") -> None:
        """Raise with one message, one problem, or all problems found."""
        if isinstance(problems, str):
            problems = Problem(problems, hint=hint)
        self.problems: tuple[Problem, ...] = (problems,) if isinstance(problems, Problem) else tuple(problems)
        super().__init__("\n".join(str(problem) for problem in self.problems))


class FileError(DhcliError):
    """A file that cannot be read, or whose content is not what it should be."""


class NotationError(DhcliError):
    """A text that the grammar does not read; its place points at the column."""


class RobotError(DhcliError):
    """A robot that cannot exist, or a question that it cannot answer."""


class UnknownNameError(DhcliError):
    """A robot, frame, joint or format that is not known; the hint lists what is."""


def plural(count: int, noun: str) -> str:
    """`1 row`, `3 rows`."""
    return f"{count} {noun}{'s' * (count != 1)}"


def are(count: int) -> str:
    """`is` behind one thing, `are` behind none and several."""
    return "is" if count == 1 else "are"


def listed(names: Sequence[str], most: int = 12) -> str:
    """Names in a row, and how many more there are beyond the most that are told."""
    more = f" and {len(names) - most} more" if len(names) > most else ""
    return ", ".join(names[:most]) + more


def joined(words: Iterable[object], last: str = "and") -> str:
    """`a, b and c`; a single one stands by itself."""
    *before, end = map(str, words)
    return f"{', '.join(before)} {last} {end}" if before else end


def bug(error: Exception, hint: str = "") -> Problem:
    """What is said of an error that no user can cause."""
    return Problem(f"this is a bug in dhcli: {type(error).__name__}: {error}", hint=hint)


def nearest(name: str, known: Iterable[str], most: int = 3, cutoff: float = 0.5) -> tuple[str, ...]:
    """The known names most like a mistyped one, best first.

    Args:
        name: What was typed.
        known: The names that would have been right.
        most: How many to return at the most.
        cutoff: How like it they must be, from 0 to 1.
    """
    from difflib import get_close_matches

    known = tuple(islice(known, MOST_CANDIDATES))
    lowered = {candidate.lower(): candidate for candidate in known}
    if name.lower() in lowered:
        return (lowered[name.lower()],)
    return tuple(lowered[match] for match in get_close_matches(name.lower(), lowered, n=most, cutoff=cutoff))


def did_you_mean(name: str, known: Iterable[str]) -> str:
    """A hint that names the nearest match, or lists what there is when it is short, or nothing."""
    known = tuple(known)
    matches = nearest(name, known)
    if matches:
        return "did you mean " + " or ".join(matches) + "?"
    if 0 < len(known) <= 12:  # noqa: PLR2004  a list that a person still reads
        return "known: " + ", ".join(known)
    return ""
