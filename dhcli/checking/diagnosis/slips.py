"""Single mistakes in a part: which there are, what answer they lead to, and which of them its pose cannot show."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

from dhcli.checking.diagnosis.mistakes import MISTAKES, Level, Mistake
from dhcli.checking.diagnosis.result import Slip
from dhcli.checking.diagnosis.work import Setting, Step, Work, right_work, terms
from dhcli.checking.exercise import Exercise, Part
from dhcli.checking.expected import entries_text
from dhcli.checking.questions import CountQuestion, MatrixQuestion, Span, TableQuestion
from dhcli.checking.tables.cells import table_text
from dhcli.checking.truth import is_length
from dhcli.errors import DhcliError, UnknownNameError, did_you_mean
from dhcli.kinematics.conventions import Convention
from dhcli.kinematics.robot import Robot
from dhcli.notation.writer import write


@dataclass(frozen=True, slots=True)
class Candidate:
    """Slips, and the work that holds them.

    Attributes:
        slips: One slip, or two.
        mistake: The record of the last of them.
        work: The way to the answer with them.
    """

    slips: tuple[Slip, ...]
    mistake: Mistake
    work: Work


def slips(exercise: Exercise, part: Part) -> tuple[Slip, ...]:
    """Every single mistake that changes the right answer to a part; nothing where one of several is chosen."""
    question = part.question
    if isinstance(question, MatrixQuestion):
        from dhcli.checking.diagnosis.search import search_of

        return tuple(candidate.slips[0] for candidate in search_of(exercise, question).visible)
    if isinstance(question, TableQuestion):
        return tuple(candidate.slips[0] for candidate in table_candidates(exercise, question))
    if isinstance(question, CountQuestion):
        return tuple(slip for slip, _ in count_slips(question))
    from dhcli.checking.diagnosis.asked_again import asked_again

    return tuple(one.slip for one in asked_again(exercise, part))


def answer_with(exercise: Exercise, part: Part, name: str) -> str:
    """The answer that a student with one mistake would type.

    Args:
        exercise: The exercise.
        part: The part.
        name: Name of a slip, such as `alpha-sign 2`.

    Raises:
        UnknownNameError: No such mistake can be made here; the hint names those that can.
    """
    question = part.question
    if isinstance(question, MatrixQuestion):
        for candidate in candidates(right_work(question, exercise.robot), setting_of(exercise)):
            if candidate.slips[0].name == name:
                return typed_text(exercise, candidate.work)
    elif isinstance(question, TableQuestion) and exercise.robot is not None:
        for candidate in table_candidates(exercise, question):
            if candidate.slips[0].name == name:
                rows = tuple(step.row for step in candidate.work.steps if step.row is not None)
                return table_text(rows, exercise.robot.columns, exercise.writing)
    elif isinstance(question, CountQuestion):
        for slip, value in count_slips(question):
            if slip.name == name:
                return str(value)
    else:
        from dhcli.checking.diagnosis.asked_again import asked_again

        for one in asked_again(exercise, part):
            if one.slip.name == name:
                return one.answer
    known = [slip.name for slip in slips(exercise, part)]
    hint = did_you_mean(name, known) or f"mistakes here: {', '.join(known)}"
    raise UnknownNameError(f"{part.id}: the mistake '{name}' cannot be made here", hint)


def hidden(exercise: Exercise, part: Part) -> tuple[Slip, ...]:
    """Mistakes whose answer is right at the values given although it is wrong at others."""
    if not isinstance(part.question, MatrixQuestion):
        return ()
    from dhcli.checking.diagnosis.search import search_of

    return tuple(candidate.slips[0] for candidate in search_of(exercise, part.question).hidden)


def setting_of(exercise: Exercise) -> Setting:
    """What mistakes in an exercise depend on."""
    robot = exercise.robot
    return Setting(
        convention=robot.convention if robot else Convention.PRODUCT,
        variables=robot.variables if robot else (),
        values=exercise.values,
        numeric=exercise.numeric,
        writing=exercise.writing,
        unit=exercise.metres if exercise.unit != "none" else exercise.metres * 0,
    )


def candidates(
    work: Work, setting: Setting, earlier: Candidate | None = None, among: Sequence[Mistake] = MISTAKES
) -> Iterator[Candidate]:
    """Every single mistake in a work, of all kinds or some; behind another one, those of its level or a later one."""
    for mistake in among:
        if earlier is not None and (mistake.level < earlier.mistake.level or mistake.alone or earlier.mistake.alone):
            continue
        for where, changed in mistake.made(work, setting):
            slip = slip_of(mistake, where)
            yield Candidate((*(earlier.slips if earlier else ()), slip), mistake, changed)


def slip_of(mistake: Mistake, where: str) -> Slip:
    """A mistake in its place."""
    entry, _, term = where.partition(" ")
    place = {"where": where, "row": entry.split(",")[0].split(".")[0], "entry": entry, "term": term}
    name = f"{mistake.id} {where}".strip()
    return Slip(name, mistake.words.format(**place), mistake.hint.format(**place), mistake.rank)


def table_candidates(exercise: Exercise, question: TableQuestion) -> tuple[Candidate, ...]:
    """Single mistakes in the cells of the right table; none where the robot has no table in this convention."""
    robot = exercise.robot
    if robot is None or robot.convention is not question.convention:
        return ()
    work = table_work(robot)
    found = candidates(work, replace(setting_of(exercise), numeric=False))
    rows = [step.row for step in work.steps]
    return tuple(
        candidate
        for candidate in found
        if candidate.mistake.level is Level.TABLE and [step.row for step in candidate.work.steps] != rows
    )


def table_work(robot: Robot) -> Work:
    """The rows of a robot, to make mistakes in."""
    steps = tuple(Step(str(link.number), link.moves, link.row) for link in robot.links)
    return Work(MatrixQuestion(Span(robot.frames[1], robot.frames[-2])), steps)


def count_slips(question: CountQuestion) -> tuple[tuple[Slip, int], ...]:
    """Slips in a count, each with the number it gives."""
    from dhcli.mobility.slips import slips as slips_of_count

    if question.found is None:
        return ()
    try:
        found = slips_of_count(question.what, question.found)
    except DhcliError:
        return ()
    hint = "go through what was counted: links with the ground, joints, and the freedoms of each"
    return tuple((Slip(words.replace(" ", "-"), words, hint), value) for words, value in found.items())


def typed_text(exercise: Exercise, work: Work) -> str:
    """What a student types: expressions, or numbers in the unit of the sheet to six decimals."""
    question = work.question
    if not exercise.numeric:
        rows = [[write(entry, "short", exercise.writing) for entry in row] for row in terms(work, {})]
    else:
        from dhcli.checking.diagnosis.search import search_of

        unit = float(exercise.metres)
        entries = search_of(exercise, question).entries(work)
        rows = [
            [_six_decimals(entry / unit if is_length(question, r, c) else entry) for c, entry in enumerate(row)]
            for r, row in enumerate(entries)
        ]
    return entries_text(rows)


def _six_decimals(value: float) -> str:
    """A number as people type it, without the minus of a zero."""
    return f"{round(value, 6) + 0:.6f}"
