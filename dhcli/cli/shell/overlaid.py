"""`dhcli check --draw FILE`: an answer over the arm that is right, in a file."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from dhcli.errors import DhcliError

if TYPE_CHECKING:
    from dhcli.checking.exercise import Exercise, Part
    from dhcli.checking.marked import SheetMark
    from dhcli.checking.returned import Overlaid
    from dhcli.kinematics.robot import Robot, Value
    from dhcli.kinematics.values import Values
    from dhcli.render.pictures.picture import Picture

RIGHT = " (it is right all the same: other frames of the same robot)"
NO_FRAME = "only a table, frames, a pose, a rotation or a position of the arm can be drawn over it"


def check_overlaid(exercise: Exercise, part: str | None) -> None:
    """Refuse an exercise, or a part of one, whose answers are no frames.

    Raises:
        DhcliError: They are none.
    """
    parts = exercise.asked if part is None else (exercise.part(part),)
    if exercise.robot is None or not any(one.question.is_overlaid for one in parts):
        where = exercise.id if part is None else f"{exercise.id}, part {part}"
        raise DhcliError(f"{where} asks for nothing that can be drawn", NO_FRAME)


def draw_over(marked: SheetMark, answers: Mapping[str, str], path: str, *, overwrite: bool) -> None:
    """Draw the first wrong answer that says where frames are, or else the first such answer, and write the file.

    Raises:
        FileError: The file cannot be written.
    """
    from dhcli.cli.shell.console import tell
    from dhcli.cli.shell.pictures import write_picture

    parts = sorted(marked.parts, key=lambda one: one.mark.verdict.passed is True)
    for one in parts:
        picture = _picture(marked.exercise, one.part, answers, is_right=one.mark.verdict.passed is True)
        if picture is not None:
            write_picture(picture, path, overwrite=overwrite, of=f"part {one.part.id}")
            return
    tell(f"dhcli: nothing was drawn: no answer that can be read says where frames are ({NO_FRAME})")


def _picture(exercise: Exercise, part: Part, answers: Mapping[str, str], *, is_right: bool) -> Picture | None:
    """The picture, at the pose that shows the robot best, or the first at which a wrong answer shows."""
    from dhcli.checking.exercise import Case
    from dhcli.checking.judge import Judge
    from dhcli.render.pictures.picture import Picture
    from dhcli.scene.beside import first_difference
    from dhcli.scene.skeleton import Skeleton

    judge, robot = Judge(exercise), exercise.robot
    reading = judge.judged(part, answers.get(part.id, "")).reading
    if reading is None or robot is None:
        return None
    best: Picture | None = None
    for values in values_of(robot, exercise.given):
        over: Overlaid | None = part.question.overlaid(Case(part, judge.memo), reading, values)
        if over is None:
            return None
        note = RIGHT if is_right else ""
        traced = replace(over.traced, note=note, close=exercise.tolerance.rotation)
        joints: Any = {name: over.values[name] for name in robot.variables}
        picture = Picture(over.robot, joints, parameters=over.values, beside=traced)
        if is_right or first_difference(Skeleton.of(over.robot, over.values), traced) is not None:
            return picture
        best = best or picture
    return best


def values_of(robot: Robot, given: Values) -> Iterator[dict[str, Value]]:
    """Values for all names: what the task gives, and where it gives none the best pose, then the others."""
    from dhcli.scene.choice import best_pose, poses, with_examples

    known = {name: value for name, value in given.items() if name in (*robot.variables, *robot.parameters)}
    full, _ = with_examples(robot, {name: value for name, value in known.items() if name in robot.parameters})
    for _, joints in (best_pose(robot, full), *reversed(tuple(poses(robot, full)))):
        yield {**full, **joints, **known}
        if all(name in known for name in robot.variables):
            return
