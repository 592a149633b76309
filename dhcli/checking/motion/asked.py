"""Whose motion a question asks about: frames, axes, a point, rates; the words behind the name of the kind."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from dhcli.algebra.floats import Floats
from dhcli.checking.exercise import Case, Exercise
from dhcli.checking.kinds.linked import needed
from dhcli.checking.wanted import NotAskedError
from dhcli.errors import NotationError, Place, Problem, RobotError, plural
from dhcli.frozen import frozen
from dhcli.kinematics.frames import ORIGIN, Point, ends, frame
from dhcli.kinematics.robot import Robot
from dhcli.kinematics.validity import Finding
from dhcli.kinematics.velocity.form import Form
from dhcli.kinematics.velocity.view import MotionView, joints_between
from dhcli.notation.dimensions import read_at
from dhcli.notation.matrix import parse_matrix
from dhcli.notation.quantity import to_length
from dhcli.notation.scope import Scope
from dhcli.notation.tree import ZERO, Expr
from dhcli.notation.walk import symbols_in
from dhcli.notation.writer import write
from dhcli.regex import regex

_TAIL = regex(
    r"(?P<head>.*?)\s*(?:(?:of\s+)?(?P<start>base|\d{1,4})\s*\.\.\s*(?P<end>tool|base|\d{1,4}))?"
    r"(?:\s+in\s+frame\s+(?P<axes>base|tool|\d{1,4}))?(?:\s+at\s*(?P<point>\(.*?\)))?"
    r"(?:\s+with\s+rates\s*(?P<rates>\(.*\)))?",
    re.DOTALL,
)
_FORM = regex(r"(?P<word>linear|angular|space|body|analytic\s+(?P<angles>[a-z]{3}))?")

MOST = 10.0
"""Metres, or metres a second; more has no arm."""


@frozen
class Motion:
    """What is asked about the motion of a robot.

    Attributes:
        head: What stands in front, in single blanks.
        start: The frame that is held still; empty for the first numbered one.
        end: The frame that moves; empty for the last numbered one.
        axes: The frame along whose axes vectors are written; empty for `start`.
        point: A point of the end frame [m].
        rates: Joint rates that are given; None where none are.
    """

    head: str
    start: str = ""
    end: str = ""
    axes: str = ""
    point: Point = ORIGIN
    rates: tuple[Expr, ...] | None = None

    def view(self, robot: Robot, form: str = "") -> MotionView:
        """The view of a robot that is meant.

        Args:
            robot: The robot.
            form: `space` and `body` take the point and the axes of theirs.

        Raises:
            UnknownNameError: The robot has no such frame.
            RobotError: The frames stand in the wrong order, or no joint lies between them.
        """
        start, end = ends(robot, self.start or None, self.end or None)
        if robot.frames.index(start) >= robot.frames.index(end):
            raise RobotError(f"frame {end} does not move against frame {start}", f"write {end}..{start}")
        if not joints_between(robot, start, end):
            raise RobotError(f"no joint of {robot.name} lies between frames {start} and {end}")
        if form in ("space", "body"):
            seen = start if form == "space" else end
            return MotionView(start, end, seen, seen)
        return MotionView(start, end, frame(robot, self.axes) if self.axes else start, end, self.point)

    def check(self, robot: Robot | None, form: str = "") -> tuple[Robot, MotionView]:
        """The robot, which must be there, and its view."""
        return needed(robot), self.view(needed(robot), form)

    def joints(self, robot: Robot | None) -> tuple[str, ...]:
        """The joints between its frames, of a robot that must be there."""
        robot, view = self.check(robot)
        return joints_between(robot, view.start, view.end)

    def where(self, exercise: Exercise) -> str:
        """Of which frame and point, along which axes, in words."""
        point = in_units(self.point, ("m",) * 3, exercise)
        words = ["of " + (f"the point {point} of " if self.point != ORIGIN else "")]
        words.append(f"frame {self.end} seen from frame {self.start}" if self.end else "the end frame")
        if self.axes:
            words.append(f", along the axes of frame {self.axes}")
        return "".join(words)


def in_units(found: Sequence[Expr], units: Sequence[str], exercise: Exercise) -> str:
    """Numbers of a question in brackets, with the units in which it is read; letters and zeros stand as they are.

    Args:
        found: The numbers, in metres, radians and seconds.
        units: The unit of each, such as `m/s`.
        exercise: Whose sheet they stand on; on one without units lengths have none.
    """
    known = ["" if exercise.unit == "none" and unit.startswith("m") else unit for unit in units]
    bare = [bool(unit) and one != ZERO and not symbols_in((one,)) for one, unit in zip(found, known, strict=True)]
    if len(set(known)) == 1:
        return f"({', '.join(map(write, found))})" + (f" {known[0]}" if any(bare) else "")
    pairs = zip(found, known, bare, strict=True)
    return f"({', '.join(f'{write(one)} {unit}' if has_unit else write(one) for one, unit, has_unit in pairs)})"


def beyond_any_arm(
    case: Case, where: tuple[str | int, ...], found: Sequence[Expr], units: Sequence[str]
) -> Iterator[Finding]:
    """Numbers of a question that no arm has, as of an author who has millimetres in mind.

    Args:
        case: The part with its exercise; without units lengths are what one likes.
        where: Path to the part.
        found: The numbers, in metres, radians and seconds.
        units: The unit of each.
    """
    for one, unit in zip(found, units, strict=True):
        if case.exercise.unit == "none" or not unit.startswith("m") or symbols_in((one,)):
            continue
        if (size := abs(Floats({}).value(one))) > MOST:
            message = f"{case.part.id}: {write(one)} {unit} is beyond any arm"
            hint = f"numbers in ask: are in metres and seconds: did you mean {size / 1000:g} {unit}?"
            yield Finding((*where, "ask"), message, hint, is_warning=True)


def read_motion(text: str, scope: Scope, place: Place | None) -> Motion:
    """Read a question about motion, such as `jacobian linear of 0..3 in frame 3 at (0, 0, c)`.

    Raises:
        NotAskedError: It is none.
        NotationError: A coordinate cannot be read.
    """
    match = _TAIL.fullmatch(" ".join(text.split()))
    if match is None:
        raise NotAskedError(text)
    rates = vector(match["rates"], scope, place) if match["rates"] else None
    return Motion(
        match["head"].strip(),
        match["start"] or "",
        match["end"] or "",
        match["axes"] or "",
        three(match["point"], scope, place) if match["point"] else ORIGIN,
        rates,
    )


def vector(text: str, scope: Scope, place: Place | None) -> tuple[Expr, ...]:
    """Numbers in brackets, lengths in metres.

    Raises:
        NotationError: They cannot be read.
    """
    cells = [cell.expr for row in parse_matrix(f"[{text.strip()[1:-1]}]", scope, place) for cell in row]
    return tuple(read_at(place, to_length, cell) for cell in cells)


def three(text: str, scope: Scope, place: Place | None) -> tuple[Expr, Expr, Expr]:
    """Three numbers in brackets.

    Raises:
        NotationError: They are not three.
    """
    found = vector(text, scope, place)
    if len(found) != 3:  # noqa: PLR2004
        raise NotationError(
            Problem(f"{text.strip()} has {plural(len(found), 'number')}, not three", place, "along x, y and z")
        )
    return found[0], found[1], found[2]


def form_of(word: str) -> tuple[Form, str]:
    """The rows that a word asks for, and the word itself where it asks for a point and axes as well.

    Raises:
        NotAskedError: It asks for none.
    """
    match = _FORM.fullmatch(word.strip())
    if match is None:
        raise NotAskedError(word)
    if match["angles"]:
        return Form(analytic=match["angles"]), ""
    name = match["word"] or ""
    if name in ("space", "body"):
        return Form(angular_first=True), name
    return (Form(name) if name in ("linear", "angular") else Form()), ""  # type: ignore[arg-type]
