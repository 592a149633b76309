"""What the commands around exercises share: which exercise is meant, how near is near enough, and the exit code."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import TYPE_CHECKING

from dhcli.checking.exercise import Exercise, Part
from dhcli.checking.marked import SheetMark
from dhcli.checking.tolerance import Tolerance
from dhcli.checking.verdicts import Verdict
from dhcli.cli.shell.chosen import Chosen
from dhcli.cli.shell.wishes import Goal, Near, RobotQuestion
from dhcli.errors import DhcliError, ExitStatus, Place, Problem, UnknownNameError, did_you_mean

if TYPE_CHECKING:
    from dhcli.kinematics.robot import Robot

PLAIN_FORMS = ("rpy", "quaternion", "axis-angle", "rotation-vector")


def exercise_of(chosen: Chosen, asked: RobotQuestion, answer: str = "") -> tuple[Exercise, str]:
    """The exercise of a name, or a question about the robot of that name, and the table or the frames to compare.

    Args:
        chosen: The exercise, or the robot with its joint values and frames.
        asked: The question about it where it is a robot.
        answer: The answer; where nothing says what of a pose it is, its shape does.

    Raises:
        UnknownNameError: Neither an exercise nor a robot has this name.
        DhcliError: Options of a question stand with an exercise, or a robot without a question.
    """
    from dhcli.cli.shell.given import robot_of
    from dhcli.files.library.entries import Kind
    from dhcli.files.library.kinds import kind_of
    from dhcli.files.yaml.exercises import load_exercise

    name = chosen.robot
    if kind_of(name) is Kind.EXERCISES:
        if is_asked(chosen, asked):
            raise DhcliError(
                f"{name} is an exercise and says itself what is asked", "leave --q, --symbolic and so on out"
            )
        return load_exercise(name), ""
    try:
        robot = robot_of(chosen)
    except UnknownNameError as error:
        from dhcli.files.library.near import unknown

        raise unknown(name, (Kind.ROBOTS, Kind.EXERCISES), error) from None
    return _about(robot, chosen, asked, answer)


def is_asked(chosen: Chosen, asked: RobotQuestion) -> bool:
    """Whether anything was typed that asks something about a robot."""
    return chosen.more or asked != RobotQuestion()


def _about(robot: Robot, chosen: Chosen, asked: RobotQuestion, answer: str) -> tuple[Exercise, str]:
    from dhcli.checking.kinds.made import question_about, question_about_table, question_answered
    from dhcli.cli.shell.given import values_of
    from dhcli.kinematics.frames import ends

    if asked.goal is not None:
        return _about_joints(robot, chosen, asked, asked.goal), ""
    if asked.table is not None:
        from dhcli.files.yaml.tables import read_table

        table = read_table(asked.table, robot)
        return question_about_table(robot, table.convention, _comparison(asked), table.note), table.text
    if asked.frames is not None:
        return _about_frames(robot, chosen, asked, asked.frames)
    if asked.compare is not None:
        raise DhcliError("--compare says how a table is compared, and there is none", "--table FILE")
    if not asked.symbolic and not chosen.stands and robot.variables:
        hint = f"dhcli check {robot.typed} --q 0.3,... or --symbolic, and --answer '[...]'"
        raise DhcliError(f"{robot.name} is a robot: say at which joint values, or ask for symbols", hint)
    values = values_of(robot, chosen, symbolic=asked.symbolic)
    start, end = ends(robot, chosen.from_, chosen.end)
    asks = [f"{piece}pose {start}..{end}" for piece in _pieces(asked)]
    exercises = [question_about(robot, ask, numeric=not asked.symbolic, given=values) for ask in asks]
    return question_answered(exercises, answer), ""


def _about_frames(robot: Robot, chosen: Chosen, asked: RobotQuestion, path: str) -> tuple[Exercise, str]:
    """A question about frames, and those of the file."""
    from dhcli.checking.kinds.made import question_about_frames
    from dhcli.cli.shell.given import lengths_of
    from dhcli.files.yaml.frames import read_frames

    views = (chosen.q, chosen.from_, chosen.to, chosen.tool, asked.form, asked.entry, asked.compare)
    if asked.symbolic or any(view is not None for view in views):
        raise DhcliError("--frames asks for frames in a pose", "only --pose NAME and --set go with it")
    frames = read_frames(path, robot)
    given, pose = lengths_of(robot, chosen, symbolic=True), chosen.pose or frames.pose
    return question_about_frames(robot, frames.convention, pose, frames.note, given), frames.text


def _comparison(asked: RobotQuestion) -> str:
    """How a table is compared: as the same robot unless the options say otherwise."""
    from dhcli.checking.tables.comparing import COMPARED, SAME_ROBOT

    how = asked.compare or SAME_ROBOT
    if how not in COMPARED:
        raise UnknownNameError(f"tables are not compared as '{how}'", did_you_mean(how, COMPARED))
    return how


def _about_joints(robot: Robot, chosen: Chosen, asked: RobotQuestion, goal: Goal) -> Exercise:
    """A question about the joint values that reach a pose."""
    from dhcli.checking.exercise import Exercise, Part
    from dhcli.checking.kinds.joints import JointsQuestion
    from dhcli.checking.solving.goal import TASKS, given_target
    from dhcli.cli.shell.goal import asked as pose_asked

    if asked.table or asked.frames or asked.symbolic or asked.form or asked.entry:
        raise DhcliError("--ik asks for joint values", "leave --table, --frames, --symbolic, --as and --entry out")
    question = pose_asked(robot, goal, chosen)
    if question.task not in TASKS:
        raise DhcliError(Problem(f"--ik checks no {question.task}", Place("--task"), ", ".join(TASKS)))
    target = given_target(question.task, question.pose, (question.start, question.end))
    words = tuple(word.strip() for word in (asked.branch or "").split(",") if word.strip())
    which = "all" if words == ("all",) else "branch" if words else "any"
    part = Part("joints", JointsQuestion(target, which, words if which == "branch" else ()))
    return Exercise(robot.name, robot.title, robot.source, "", (part,), robot, question.lengths, numeric=True)


def _pieces(asked: RobotQuestion) -> tuple[str, ...]:
    """What may be answered, as `ask:` begins with it."""
    from dhcli.geometry.euler import AXES

    if asked.form is not None and asked.entry is not None:
        raise DhcliError("--as and --entry both say what is answered", "use one of them")
    if asked.entry is not None:
        row, _, column = asked.entry.replace(" ", ",").partition(",")
        if row not in set("1234") or column.strip() not in set("1234"):
            raise DhcliError(Problem(f"'{asked.entry}' is no entry of a 4x4", Place("--entry"), "row,column: 1,4"))
        return (f"entry {row} {column.strip()} of ",)
    if asked.form is None:
        return ("", "position of ", "rotation of ")
    forms = {name: f"{name} of " for name in ("position", "rotation", *PLAIN_FORMS)} | {"matrix": ""}
    forms |= {axes: f"euler {axes} of " for axes in AXES}
    if asked.form not in forms:
        raise UnknownNameError(f"there is no form {asked.form}", did_you_mean(asked.form, forms))
    return (forms[asked.form],)


def with_tolerance(exercise: Exercise, near: Near) -> Exercise:
    """The same exercise with other tolerances.

    Raises:
        NotationError: The tolerance of a position is no length.
        DhcliError: A tolerance is negative, or no number.
    """
    changes: dict[str, float | int] = {}
    if near.tol_rotation is not None:
        changes["rotation"] = _not_negative("--tol-rotation", near.tol_rotation)
    if near.tol_position is not None:
        changes["position"] = _not_negative("--tol-position", _length(near.tol_position))
    if near.decimals is not None:
        changes["decimals"] = near.decimals
    if not changes:
        return exercise

    def changed(tolerance: Tolerance) -> Tolerance:
        return replace(tolerance, **changes)  # type: ignore[arg-type]

    parts = tuple(replace(p, tolerance=changed(p.tolerance)) if p.tolerance else p for p in exercise.parts)
    return replace(exercise, tolerance=changed(exercise.tolerance), parts=parts)


def exit_code(verdict: Verdict) -> ExitStatus:
    """0 for what is solved, 2 for what cannot be read, else 1."""
    if verdict is Verdict.CANNOT_READ:
        return ExitStatus.BAD_INPUT
    return ExitStatus.DONE if verdict.passed else ExitStatus.NOT_RIGHT


def remember(marked: SheetMark) -> None:
    """Note the verdicts among the progress of this user, for exercises of the library."""
    from dhcli.cli.shell.console import tell
    from dhcli.files.progress import record

    if "/" in marked.exercise.id:
        message = record(marked.exercise.id, {p.part.id: p.mark.verdict for p in marked.parts})
        if message:
            tell(f"dhcli: {message}")


def first_open(exercise: Exercise, best: Mapping[str, str]) -> Part:
    """The first part that is not solved yet; the first of all if all are."""
    solved = {Verdict.RIGHT.word, Verdict.EQUIVALENT.word}
    return next((part for part in exercise.asked if best.get(part.id) not in solved), exercise.asked[0])


def _not_negative(option: str, value: float) -> float:
    if not value >= 0:  # NaN is not either
        raise DhcliError(Problem("a tolerance is a number that is not negative", Place(option)))
    return value


def _length(text: str) -> float:
    from dhcli.algebra.floats import Floats
    from dhcli.notation.dimensions import read_at
    from dhcli.notation.parser import parse
    from dhcli.notation.quantity import to_length
    from dhcli.notation.scope import Scope

    place = Place("--tol-position", text=text)
    return Floats().value(read_at(place, to_length, parse(text, Scope(), place)))
