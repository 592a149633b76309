"""Single mistakes in a work: which there are, and what each is called."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

from dhcli.checking.diagnosis.mistakes import BY_ID, MISTAKES
from dhcli.checking.diagnosis.record import Mistake
from dhcli.checking.diagnosis.result import Slip
from dhcli.checking.diagnosis.work import Factor, Level, Maker, Setting, Work
from dhcli.checking.exercise import Exercise, Memo
from dhcli.checking.wanted import Wanted
from dhcli.frozen import frozen
from dhcli.kinematics.conventions import Convention, Row
from dhcli.kinematics.frames import View
from dhcli.kinematics.robot import Robot


@frozen
class Candidate:
    """Slips, and the work that holds them.

    Attributes:
        slips: One slip, or two.
        mistake: The record of the last of them.
        work: The way to the answer with them.
    """

    slips: tuple[Slip, ...]
    mistake: Mistake[Maker]
    work: Work


def setting_of(exercise: Exercise) -> Setting:
    """What mistakes in an exercise depend on."""
    robot = exercise.robot
    return Setting(
        convention=robot.convention if robot else Convention.PRODUCT,
        variables=robot.variables if robot else (),
        values=exercise.values,
        numeric=exercise.numeric,
        writing=exercise.writing,
        robot=robot,
        unit=exercise.metres if exercise.unit != "none" else exercise.metres * 0,
    )


def candidates(
    work: Work,
    setting: Setting,
    earlier: Candidate | None = None,
    among: Sequence[Mistake[Maker]] = MISTAKES,
    name: str = "",
) -> Iterator[Candidate]:
    """Single mistakes in a work.

    Args:
        work: The work.
        setting: What they depend on.
        earlier: A mistake that has been made already: then those of its level or a later one.
        among: Kinds of mistakes, all by default.
        name: Name of the mistake that is meant: then those of its kind alone.
    """
    for mistake in _called(name) if name else among:
        if earlier is not None and (mistake.level < earlier.mistake.level or mistake.alone or earlier.mistake.alone):
            continue
        for where, changed in mistake.made(work, setting):
            yield Candidate((*(earlier.slips if earlier else ()), mistake.slip(where)), mistake, changed)


def _called(name: str) -> tuple[Mistake[Maker], ...]:
    """The kind of mistake with a name such as `alpha-sign 2`; nothing if there is none."""
    kind = BY_ID.get(name.partition(" ")[0])
    return (kind,) if kind else ()


def table_candidates(
    exercise: Exercise, convention: Convention, name: str = "", work: Work | None = None
) -> tuple[Candidate, ...]:
    """Single mistakes in the cells of the right table, or those of the kind that is named.

    None where the robot has no table in this convention. An angle that stands in two rows is not among them: it cannot
    be read. Of cells that several mistakes lead to, one that is made in several rows is not named. They share the rows
    of the right table that they leave alone, those of `work` where it is given.
    """
    robot = exercise.robot
    if robot is None or robot.convention is not convention:
        return ()
    work = work or table_work(robot)
    right = _rows(work)
    unchanged = _changed(right, right)
    seen: set[object] = {unchanged}
    kept: list[Candidate] = []
    setting = replace(setting_of(exercise), numeric=False)
    among = [mistake for mistake in MISTAKES if mistake.level is Level.TABLE]
    for candidate in candidates(work, setting, among=among, name=name):
        rows, mistake = _rows(candidate.work), candidate.mistake
        changed = _changed(rows, right)
        angles = [angle for row in rows for angle in row.theta.names & set(robot.variables)]
        is_readable = len(angles) == len(set(angles))
        is_known = changed == unchanged or (mistake.alone and changed in seen)
        if mistake.level is Level.TABLE and is_readable and not is_known:
            kept.append(candidate)
            seen.add(changed)
    return tuple(kept)


def table_slips(memo: Memo, convention: Convention) -> tuple[Candidate, ...]:
    """All of them for an exercise, worked out once."""
    return memo.of(
        ("table slips", convention),
        lambda: table_candidates(memo.exercise, convention, work=right_table(memo)),
    )


def right_table(memo: Memo) -> Work | None:
    """The rows of the robot that these leave alone, the same objects; None where there is no robot."""
    robot = memo.exercise.robot
    return memo.of("right table", lambda: table_work(robot)) if robot is not None else None


def _changed(rows: Sequence[Row], right: Sequence[Row]) -> tuple[object, ...]:
    """How many rows there are, and those that are not the right ones, each with its place: a short key to a table."""
    both = enumerate(zip(rows, right, strict=False))
    return (len(rows), *((k, row) for k, (row, own) in both if row is not own and row != own))


def _rows(work: Work) -> tuple[Row, ...]:
    return tuple(step.row for step in work.steps if step.row is not None)


def table_work(robot: Robot) -> Work:
    """The rows of a robot, to make mistakes in."""
    steps = tuple(Factor(str(link.number), link.moves, link.row) for link in robot.links)
    return Work(Wanted(View(robot.frames[1], robot.frames[-2])), steps)
