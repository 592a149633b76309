"""Describing a robot anew: from what it is given as to any other form, and the proof that nothing has changed."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field, replace

from dhcli.errors import RobotError
from dhcli.frozen import frozen
from dhcli.kinematics.conventions import COLUMNS, TABLES, Convention, Row
from dhcli.kinematics.coupling import uncoupled
from dhcli.kinematics.describe.asked import DRAWN, NAMES, Asked, Form
from dhcli.kinematics.describe.drawn import Drawing, SharedMovesError, drawing_of
from dhcli.kinematics.describe.linear import LettersError
from dhcli.kinematics.describe.process import walk
from dhcli.kinematics.describe.products import chains_of
from dhcli.kinematics.describe.proof import CLOSE, Proof, proved
from dhcli.kinematics.describe.repairing import repaired, with_table
from dhcli.kinematics.describe.screws import ScrewAxis, Side, lines_of, screws_of
from dhcli.kinematics.describe.straight import Straightened, straightened
from dhcli.kinematics.describe.words import Speaker, Step
from dhcli.kinematics.forward import with_own_values
from dhcli.kinematics.moves import Chain, spelled
from dhcli.kinematics.robot import Link, Robot, Value
from dhcli.kinematics.values import numbers
from dhcli.notation.angle import Angle

_MISSED = 2e-12
"""What it costs that axes count as meeting or parallel which miss that by less than 1e-12 of the size."""

_ROUGH = (
    "the table differs by {:.1g} of the reach: axes that meet, or are parallel, to 1e-12 of the size count as such, "
    "or a normal lies far away"
)


@frozen
class Described:
    """A robot in another description.

    Attributes:
        given: The robot.
        form: The description wanted.
        robot: It, from frame base to frame tool, as a table or as a product.
        drawing: Its axes in the pose drawn; None where the rows were only grouped anew.
        screws: Its screws, of forms that are screws.
        steps: The process in words, of tables from axes.
        proof: That it is the same motion from base to tool.
        notes: What a person should know.
        warnings: What they should be warned of.
        told: Whether the steps were asked for.
        shared: What each joint of the drawing moves by that has no variable of its own, in terms of the variables.
        straightened: What was taken for parallel or meeting, if that was asked for; then the proof is about the robot
            behind that, and the motion not that of the one given.
    """

    given: Robot
    form: Form
    robot: Robot
    proof: Proof
    drawing: Drawing | None = None
    screws: tuple[ScrewAxis, ...] = ()
    steps: tuple[Step, ...] = ()
    notes: tuple[str, ...] = ()
    warnings: tuple[str, ...] = ()
    told: bool = False
    shared: Mapping[str, Value] = field(default_factory=dict)
    straightened: Straightened | None = None


def describe(robot: Robot, asked: Asked) -> Described:
    """Describe a robot anew.

    Raises:
        RobotError: It has no such description, or a letter lacks a value that decides.
    """
    if robot.tools:
        found = describe(replace(robot, tools={}), asked)
        return replace(found, notes=(*found.notes, "the tools of the file are left out"))
    is_table = asked.form in TABLES
    other = {"standard": Convention.MODIFIED, "modified": Convention.STANDARD}.get(asked.form)
    if is_table and robot.convention is other and not asked.from_axes:
        return _regrouped(with_own_values(robot) if asked.numbers else robot, asked.form)
    try:
        return _drawn_anew(robot, asked)
    except SharedMovesError:
        return _by_moves(robot, asked)


def _drawn_anew(robot: Robot, asked: Asked) -> Described:
    """The description by way of the axes."""
    if asked.straighten is not None:
        return replace(_straight(with_own_values(robot), asked, asked.straighten), given=robot)
    try:
        return _from_axes(with_own_values(robot) if asked.numbers else robot, asked)
    except LettersError as error:
        if asked.numbers or None in robot.parameters.values():
            raise
        found = _from_axes(with_own_values(robot), asked)
        return replace(found, notes=(f"in numbers: {error.problems[0].message}", *found.notes))


def _by_moves(robot: Robot, asked: Asked) -> Described:
    """The description of the arm with a variable for each move, carried back to the robot's own variables."""
    free = uncoupled(robot)
    poses = {name: free.values(dict(zip(robot.variables, q, strict=True))) for name, q in robot.poses.items()}
    arm = replace(free.robot, poses={name: tuple(values.values()) for name, values in poses.items()})
    found = _drawn_anew(arm, replace(asked, pose=None if asked.pose is None else free.values(asked.pose)))
    _proof(robot, free.back(arm))  # what is proved of the arm then holds for the robot
    return replace(found, given=robot, robot=free.back(found.robot), shared=free.shared_by(found.robot))


def _straight(robot: Robot, asked: Asked, within: float) -> Described:
    """The description of the robot that another one is when its axes are straightened."""
    drawing, told = straightened(_drawn(robot, asked), within, robot.limits)
    as_asked = replace(asked, straighten=None)
    if not told.changes:
        return replace(describe(robot, as_asked), straightened=told)
    found = describe(as_product(robot, drawing), as_asked)
    made = f"Made by `dhcli describe {robot.name} --as {asked.form} --straighten {within:g}`:"
    said = "\n".join((made, *told.lines()))
    notes = said + (f"\n{robot.notes.rstrip()}" if robot.notes else "")
    return replace(found, robot=replace(found.robot, notes=notes), straightened=told)


def _named(robot: Robot, form: Form) -> Robot:
    """The robot with a title and a note that say what was made of what."""
    note = f"Made by `dhcli describe {robot.name} --as {form}`: the same motion from base to tool."
    known = "".join(f"\n{line}" for line in robot.notes.rstrip().split("\n")) if robot.notes else ""
    return replace(robot, title=f"{robot.title}, as {NAMES[form]}", notes=note + known, path=None)


def _regrouped(robot: Robot, form: Form) -> Described:
    convention = Convention(form)
    base, rows, tool = repaired(robot, convention)
    found = _table(robot, convention, rows, base, tool)
    notes = ("the pairs of its table are grouped anew; nothing is computed", *_left_over(robot, found))
    return Described(robot, form, found, _proof(robot, found), notes=notes)


def _table(robot: Robot, convention: Convention, rows: tuple[Row, ...], base: Chain, tool: Chain) -> Robot:
    links = with_table(rows, convention, robot.first)
    columns = robot.columns if robot.convention is not Convention.PRODUCT else COLUMNS
    named = _named(robot, "standard" if convention is Convention.STANDARD else "modified")
    return replace(named, convention=convention, links=links, base=base, tool=tool, columns=columns)


def _proof(robot: Robot, found: Robot, close: float = CLOSE) -> Proof:
    return proved(robot.chain, found.chain, known_values(robot), close)


def known_values(robot: Robot) -> dict[str, Angle | float]:
    """Values of the letters that have one."""
    return dict(numbers(robot.known))


def _from_axes(robot: Robot, asked: Asked) -> Described:
    screws = asked.form in ("screws", "body-screws")
    drawing = _drawn(robot, asked)
    if not drawing.lines and asked.form != "product":
        raise RobotError(f"{robot.name} has no joints, so it has no {asked.form}", "--as product writes it as moves")
    if asked.form in TABLES:
        return _by_process(robot, Convention(asked.form), asked, drawing)
    if screws:
        return _screws(robot, asked.form, drawing)
    found = as_product(_named(robot, asked.form), drawing)
    return Described(robot, asked.form, found, _proof(robot, found), drawing)


def _drawn(robot: Robot, asked: Asked) -> Drawing:
    """The robot in the pose in which it is drawn; for screws that is zero."""
    drawn = dict(zip(robot.variables, robot.poses.get(DRAWN, ()), strict=False)) if asked.pose is None else asked.pose
    pose = {} if asked.form in ("screws", "body-screws") else drawn
    return drawing_of(robot.chain, robot.variables, known_values(robot), pose)


def _by_process(robot: Robot, convention: Convention, asked: Asked, drawing: Drawing) -> Described:
    walked = walk(drawing, asked.choices)
    found = _table(robot, convention, walked.rows(convention), walked.base(convention), walked.tool(convention))
    names = tuple(line.name for line in drawing.lines)
    found = replace(found, variables=names, poses=_sorted(robot, names))
    speaker = Speaker(walked, convention, robot.first, found.writing)
    most = max(CLOSE * walked.farthest, _MISSED) + len(names) * walked.bent
    proof = _proof(robot, found, most)
    return Described(
        robot,
        asked.form,
        found,
        proof,
        drawing,
        steps=tuple(speaker.steps()),
        notes=_left_over(robot, found),
        warnings=(*walked.warnings, *(_ROUGH.format(proof.error) for _ in range(proof.error > CLOSE))),
        told=asked.steps,
    )


def _screws(robot: Robot, form: Form, drawing: Drawing) -> Described:
    side: Side = "space" if form == "screws" else "body"
    screws = screws_of(drawing, side)
    back = replace(drawing, lines=lines_of(screws, drawing.end, side))
    found = as_product(_named(robot, form), back)
    return Described(robot, form, found, _proof(robot, found), drawing, screws)


def as_product(robot: Robot, drawing: Drawing) -> Robot:
    """A robot as products of moves, from its drawing."""
    chains = tuple(chains_of(drawing))
    links = tuple(Link(robot.first + i, chain) for i, chain in enumerate(chains))
    names = tuple(line.name for line in drawing.lines)
    return replace(
        robot,
        convention=Convention.PRODUCT,
        variables=names,
        links=links,
        base=(),
        tool=(),
        poses=_sorted(robot, names),
        columns=COLUMNS,
    )


def _sorted(robot: Robot, names: tuple[str, ...]) -> Mapping[str, tuple[Value, ...]]:
    """The poses with their values in the order in which the chain meets the joints."""
    order = [robot.variables.index(name) for name in names]
    return {pose: tuple(values[i] for i in order) for pose, values in robot.poses.items()}


def _left_over(robot: Robot, found: Robot) -> tuple[str, ...]:
    """What went to the base and to the tool, and whether frame 0 or n has moved."""
    said = []
    for name, before, after in (("base", robot.base, found.base), ("tool", robot.tool, found.tool)):
        if after and after != before:
            said.append(f"to {name}: {' '.join(spelled(move, found.writing) for move in after)}")
        elif before and not after:
            said.append(f"the {name} is in the table now")
    return tuple(said)
