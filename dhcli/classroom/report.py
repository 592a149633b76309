"""The figures of a class: verdicts and slips of each part, and how the credit is spread."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from math import fsum

from dhcli.checking.verdicts import Verdict
from dhcli.classroom.folder import Folder
from dhcli.classroom.grades import Graded, PartGrade
from dhcli.errors import listed, plural
from dhcli.frozen import frozen

STEPS = (0, 20, 40, 60, 80, 100)
"""Where the classes of the distribution begin [%]; the last one is full credit alone."""
_ROUNDING = 1e-9

MOST_NAMED = 5
"""Students that a notice names."""


@frozen
class PartFigures:
    """What a class did with one part.

    Attributes:
        exercise: Id of the exercise.
        part: Id of the part.
        credit: Credit there was to earn.
        mean: Credit earned on average.
        verdicts: How many sheets got each verdict; those that nobody got are not in it.
        slips: Mistakes with how many sheets they explain, the commonest first, then as sheets name them.
    """

    exercise: str
    part: str
    credit: float
    mean: float
    verdicts: Mapping[Verdict, int]
    slips: tuple[tuple[str, int], ...]


@frozen
class ClassReport:
    """The grades of a class and what they add up to.

    Attributes:
        folder: What was handed in.
        rows: Every sheet, graded or not.
        parts: The figures of each part, exercise by exercise.
        spread: How many sheets earned at least each of `STEPS`, and less than the next [%].
        mean: Mean share of the credit; None if nothing could be graded.
        notices: What a person should look at: variants that several sheets share, or one has not, sheets on
            which nothing but a unit is wrong, and students who handed in an exercise twice, or have one name.
    """

    folder: Folder
    rows: tuple[Graded, ...]
    parts: tuple[PartFigures, ...]
    spread: tuple[int, ...]
    mean: float | None
    notices: tuple[str, ...] = ()

    @property
    def graded(self) -> tuple[Graded, ...]:
        """The sheets that were graded."""
        return tuple(row for row in self.rows if not row.problems)

    @property
    def failed(self) -> tuple[Graded, ...]:
        """The sheets that were not."""
        return tuple(row for row in self.rows if row.problems)


def report_on(folder: Folder, rows: Sequence[Graded]) -> ClassReport:
    """Add up the grades of a class."""
    by_part: dict[tuple[str, str], list[PartGrade]] = {}
    for row in sorted(rows, key=lambda row: row.exercise):
        for part in row.parts:
            by_part.setdefault((row.exercise, part.part), []).append(part)
    shares = [row.earned / row.credit for row in rows if row.credit]
    steps = Counter(max(step for step in STEPS if step <= 100 * share + _ROUNDING) for share in shares)
    return ClassReport(
        folder,
        tuple(rows),
        tuple(_figures(exercise, part, grades) for (exercise, part), grades in by_part.items()),
        tuple(steps[step] for step in STEPS),
        fsum(shares) / len(shares) if shares else None,
        tuple(_notices(rows)),
    )


def _notices(rows: Sequence[Graded]) -> Iterator[str]:
    """What is odd about the sheets of a class, exercise by exercise."""
    by_exercise: dict[str, list[Graded]] = {}
    for row in rows:
        if row.exercise:
            by_exercise.setdefault(row.exercise, []).append(row)
    for exercise, sheets in sorted(by_exercise.items()):
        drawn: dict[str, list[Graded]] = {}
        handed_in: dict[str, list[Graded]] = {}
        for row in sheets:
            drawn.setdefault(row.variant, []).append(row)
            handed_in.setdefault(_owner(row), []).append(row)
        for variant, same in drawn.items():
            if variant and len({_owner(row) for row in same}) > 1:
                yield f"{exercise}: variant {variant}: {plural(len(same), 'sheet')} ({_whose(same)})"
        if "" in drawn and len(drawn) > 1:
            yield f"{exercise}: no variant: {plural(len(drawn['']), 'sheet')} ({_whose(drawn[''])})"
        for unit in sorted({row.other_unit for row in sheets} - {""}):
            same = [row for row in sheets if row.other_unit == unit]
            yield f"{exercise}: right but for the unit, {unit}: {plural(len(same), 'sheet')} ({_whose(same)})"
        twice = ((folder, len(same)) for folder, same in handed_in.items() if len(same) > 1)
        yield from (f"{exercise}: {count} sheets in {folder}" for folder, count in twice)
        namesakes = ((name, owners) for name, owners in _owners(sheets).items() if len(owners) > 1)
        yield from (
            f"{exercise}: {name} is the name on sheets of {listed(owners, MOST_NAMED)}" for name, owners in namesakes
        )


def _owner(row: Graded) -> str:
    """The folder of a student, or the sheet itself where all lie in one folder."""
    folder, slash, _ = row.sheet.partition("/")
    return folder if slash else row.sheet


def _owners(rows: Sequence[Graded]) -> dict[str, list[str]]:
    """Whose sheets bear a name, each once."""
    owners: dict[str, list[str]] = {}
    for row in rows:
        same = owners.setdefault(row.student, [])
        if _owner(row) not in same:
            same.append(_owner(row))
    return owners


def _whose(rows: Sequence[Graded]) -> str:
    """Names of students, not more than a line holds."""
    return listed(list({_owner(row): row.student for row in rows}.values()), MOST_NAMED)


def _figures(exercise: str, part: str, grades: Sequence[PartGrade]) -> PartFigures:
    verdicts = Counter(grade.verdict for grade in grades)
    slips = Counter(slip for grade in grades for slip in dict.fromkeys(grade.slips))
    return PartFigures(
        exercise,
        part,
        grades[0].credit,
        fsum(grade.earned for grade in grades) / len(grades),
        {verdict: verdicts[verdict] for verdict in Verdict if verdict in verdicts},
        tuple(slips.most_common()),
    )
