"""What can be asked of a robot, and the answer as one typed result that every output format is drawn from."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import field, replace
from typing import TYPE_CHECKING, Literal, TypeAlias, cast

from dhcli.errors import RobotError
from dhcli.frozen import frozen
from dhcli.geometry.words import in_words
from dhcli.kinematics.forward import factors, pose_rows, put_in, textbook_form
from dhcli.kinematics.frames import Point, View, between, path, place_of
from dhcli.kinematics.limits import warnings
from dhcli.kinematics.moves import Chain, Trans, inverse, spelled
from dhcli.kinematics.pose import Pose
from dhcli.kinematics.robot import Link, Robot
from dhcli.kinematics.values import Values, require
from dhcli.notation.quarters import right_angles_among
from dhcli.notation.tree import Expr
from dhcli.notation.walk import symbols_in

if TYPE_CHECKING:  # what only some questions need is imported when they are asked
    from dhcli.kinematics.placement import Placement
    from dhcli.notation.let import Definition

AnyPose: TypeAlias = Pose[float] | Pose[Expr]
Listing: TypeAlias = Literal["frames", "links", "factors"]


@frozen
class Question:
    """What is asked of a robot.

    Attributes:
        view: Which frame, seen from where; and a point of it, if that is asked for.
        symbolic: Whether names without a value stay symbols.
        listing: Poses to list: every frame, every link's own matrix, or the elementary matrices of links.
        link: The one link whose factors are asked for; all between the frames by default.
        forms: Other ways to say the pose, names of `placement.FORMS`.
        let: Whether long or repeated brackets of the pose get names.
    """

    view: View
    symbolic: bool = False
    listing: Listing | None = None
    link: str | None = None
    forms: tuple[str, ...] = ()
    let: bool = False


@frozen
class SeenPoint:
    """A point in two frames.

    Attributes:
        given: Its coordinates in the frame `frame` [m].
        seen: Its coordinates in the frame `reference` [m].
        frame: The frame it was given in.
        reference: The frame it is seen from.
    """

    given: Point
    seen: tuple[float, ...] | tuple[Expr, ...]
    frame: str
    reference: str


@frozen
class ForwardKinematics:
    """What a question about a robot has for an answer.

    Attributes:
        robot: The robot asked.
        values: The values used.
        question: The question.
        pose: The pose between the two frames.
        poses: The poses listed, if a listing was asked for.
        point: The point, if one was asked for.
        placements: The pose in the other ways that were asked for.
        words: Axes that point along an axis of the reference, in words; empty in symbols.
        definitions: Names that stand in the pose for brackets, each in terms of those before it.
        warnings: What a person should know all the same, such as a joint beyond its limit.
    """

    robot: Robot
    values: Values
    question: Question
    pose: AnyPose
    poses: tuple[AnyPose, ...] = ()
    point: SeenPoint | None = None
    placements: Mapping[str, Placement] = field(default_factory=dict)
    words: tuple[str, ...] = ()
    definitions: tuple[Definition, ...] = ()
    warnings: tuple[str, ...] = ()


def answer(robot: Robot, values: Values, question: Question) -> ForwardKinematics:
    """Answer a question about a robot.

    Raises:
        RobotError: A value is missing, or beyond what a float can hold.
        UnknownNameError: The robot has no such frame or link.
    """
    view = question.view
    taken: list[str] = []
    if question.symbolic:
        values = right_angles_among(values, taken)
    links = _links(robot, view, question.link)
    if question.listing == "factors" and question.link is not None:
        view = replace(view, start=str(links[0].number - 1), end=str(links[0].number))
    fold_chain = _Folding(robot, values, question.symbolic)
    pose = fold_chain(view.chain(robot), view.reference, view.frame)
    said, locked = _said(pose, question.forms) if question.forms else ({}, ())
    definitions, pose = _with_names(pose) if question.let else ((), pose)
    return ForwardKinematics(
        robot,
        values,
        question,
        pose,
        poses=tuple(_listed(fold_chain, question, links, view)),
        point=None if view.point is None else _seen(fold_chain, view, view.point),
        placements=said,
        definitions=definitions,
        words=() if question.symbolic else in_words(cast("Pose[float]", pose).rotation),
        warnings=(*warnings(robot, values), *taken, *locked),
    )


class _Folding:
    """How chains become poses in one question: over floats, or over terms."""

    def __init__(self, robot: Robot, values: Values, symbolic: bool) -> None:  # noqa: FBT001
        self.robot, self.values, self.symbolic = robot, values, symbolic

    def __call__(self, chain: Chain, start: str, end: str, title: str = "") -> AnyPose:
        if self.symbolic:
            chain = put_in(chain, self.values)
        else:
            require(self.robot, chain, self.values)
        pose = folded(chain, start, end, symbolic=self.symbolic, values=self.values)
        return replace(pose, title=title, joints=self.robot.writing)


def folded(chain: Chain, start: str, end: str, *, symbolic: bool, values: Values | None = None) -> AnyPose:
    """The pose at the end of a chain, in terms or else in floats.

    Raises:
        RobotError: An entry is not a real number, or beyond what a float can hold.
    """
    if symbolic:
        return Pose(textbook_form(chain), start, end)
    return Pose(pose_rows(chain, values or {}), start, end)


def _said(pose: AnyPose, forms: tuple[str, ...]) -> tuple[Mapping[str, Placement], tuple[str, ...]]:
    """A pose in other ways, and what a person should know of them."""
    from dhcli.kinematics.placement import locked_warnings, placements

    said = placements(pose, forms)
    return said, locked_warnings(said)


def _with_names(pose: AnyPose) -> tuple[tuple[Definition, ...], AnyPose]:
    """A symbolic pose with names for its brackets."""
    if not pose.is_symbolic:
        raise RobotError("names for brackets are for a symbolic result", "add --symbolic")
    from dhcli.notation.let import name_parts

    definitions, rows = name_parts(cast("Pose[Expr]", pose).rows)
    return definitions, replace(cast("Pose[Expr]", pose), rows=rows)


def _links(robot: Robot, view: View, only: str | None) -> tuple[Link, ...]:
    """The links between two frames, or the one that is asked for."""
    if only is not None:
        return (robot.links[place_of(robot, only)],)
    numbered = {str(link.number): link for link in robot.links}
    first, last = sorted((robot.frames.index(view.start), robot.frames.index(view.end)))
    return tuple(numbered[name] for name in robot.frames[first + 1 : last + 1] if name in numbered)


def _listed(fold_chain: _Folding, question: Question, links: tuple[Link, ...], view: View) -> Iterator[AnyPose]:
    robot = fold_chain.robot
    if question.listing == "frames":
        for name in path(robot, view.reference, view.frame):
            yield fold_chain(between(robot, view.reference, name), view.reference, name)
    for link in links if question.listing == "links" else ():
        before, own = str(link.number - 1), str(link.number)
        moves, title = (inverse(link.moves), f"A_{own}^-1") if view.inverse else (link.moves, f"A_{own}")
        if view.inverse:
            before, own = own, before
        yield fold_chain(moves, before, own, title)
    for link in links if question.listing == "factors" else ():
        if question.symbolic:
            yield from factors(robot, link, fold_chain.values)
            continue
        for move in link.moves:
            title = spelled(move, robot.writing)
            yield fold_chain((move,), str(link.number - 1), str(link.number), title)


def _seen(fold_chain: _Folding, view: View, point: Point) -> SeenPoint:
    """A point of the frame described, seen from the other."""
    free = symbols_in(point) - fold_chain.values.keys()
    if not fold_chain.symbolic and (unknown := sorted(free - fold_chain.robot.angles - {*fold_chain.robot.variables})):
        raise RobotError(f"{', '.join(unknown)} of the point has no value", "write numbers, or ask with --symbolic")
    pose = fold_chain((*view.chain(fold_chain.robot), Trans(*point)), view.reference, view.frame)
    return SeenPoint(point, pose.position, view.frame, view.reference)
