"""Questions as data, and the short texts that ask them in an exercise file.

`link 1` · `pose 0..3` · `product "Rot(z, 90°) Trans(1, 2, 3)"` · `inverse of link i` are matrices; `rotation of`,
`position of`, `entry 1 4 of`, `axis x of`, `point (1, 2, 3) of` and `vector (1, 0, 0) of` choose what is asked of one.
`table modified` · `factors 2` · `cell alpha 2` · `scalar 2*a1` · `count mobility four-bar` · `choice` are the others.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Literal, TypeAlias

from dhcli.errors import NotationError, Place, Problem, RobotError, nearest
from dhcli.kinematics.conventions import COLUMNS, Convention
from dhcli.kinematics.frames import frame
from dhcli.kinematics.moves import Chain, read_chain
from dhcli.kinematics.robot import Robot
from dhcli.notation.matrix import parse_matrix
from dhcli.notation.parser import parse_quantity
from dhcli.notation.quantity import DimensionError, to_length
from dhcli.notation.scope import Scope
from dhcli.notation.tree import Expr

if TYPE_CHECKING:
    from dhcli.mobility.counting import Counts
    from dhcli.mobility.linkage import Linkage


@dataclass(frozen=True, slots=True)
class Span:
    """The pose of one frame of the robot seen from another.

    Attributes:
        start: The frame it is seen from.
        end: The frame described.
        link: Whether it was asked for as a link, `A_i`.
    """

    start: str
    end: str
    link: bool = False


@dataclass(frozen=True, slots=True)
class Composed:
    """A product of moves, without a robot."""

    chain: Chain
    text: str


Source: TypeAlias = Span | Composed

Piece = Literal["pose", "rotation", "position", "entry", "axis", "point", "vector"]
"""What is asked of a matrix."""


@dataclass(frozen=True, slots=True)
class MatrixQuestion:
    """A matrix, or a piece of one.

    Attributes:
        source: Where the matrix comes from.
        inverse: Whether its inverse is meant.
        piece: What is asked of it.
        index: Row and column of an entry from 0; for an axis its column and 0.
        point: Coordinates of a point or a vector in the frame described.
    """

    source: Source
    inverse: bool = False
    piece: Piece = "pose"
    index: tuple[int, int] = (0, 0)
    point: tuple[Expr, ...] = ()

    @property
    def shape(self) -> tuple[int, int]:
        """Rows and columns of the answer."""
        return {"pose": (4, 4), "rotation": (3, 3), "entry": (1, 1)}.get(self.piece, (3, 1))


@dataclass(frozen=True, slots=True)
class TableQuestion:
    """The DH table of the robot in one of the conventions."""

    convention: Convention


@dataclass(frozen=True, slots=True)
class CellQuestion:
    """One cell of the robot's DH table."""

    column: str
    link: str


@dataclass(frozen=True, slots=True)
class FactorsQuestion:
    """The elementary moves of a link, in order."""

    link: str


@dataclass(frozen=True, slots=True)
class ScalarQuestion:
    """An angle, a length or a number, computed from an expression."""

    expr: Expr
    text: str


@dataclass(frozen=True, slots=True)
class CountQuestion:
    """A count of a linkage: its mobility, links, joints or constraints.

    Attributes:
        what: What is counted.
        linkage: A pattern such as `6R`, or the name of a linkage.
        found: What that is; whoever loads the exercise has looked it up.
    """

    what: str
    linkage: str
    found: Linkage | Counts | None = None


@dataclass(frozen=True, slots=True)
class ChoiceQuestion:
    """One of several statements; `right` counts from 1."""

    options: tuple[str, ...]
    right: int


Question: TypeAlias = (
    MatrixQuestion | TableQuestion | CellQuestion | FactorsQuestion | ScalarQuestion | CountQuestion | ChoiceQuestion
)

KINDS = (
    "link 1",
    "pose 0..3",
    'product "Rot(z, 90°)"',
    "inverse of link 1",
    "rotation of pose 0..3",
    "position of pose 0..3",
    "entry 1 4 of pose 0..3",
    "axis x of pose 0..3",
    "point (1, 2, 3) of pose 0..3",
    "vector (1, 0, 0) of pose 0..3",
    "table standard",
    "cell alpha 2",
    "factors 2",
    "scalar 2*a1",
    "count mobility four-bar",
    "choice",
)
"""One of each kind, for messages and for people who write exercises."""

_PIECE = re.compile(
    r"(?P<piece>rotation|position|entry\s+(?P<row>[1-3])\s+(?P<column>[1-4])|axis\s+(?P<axis>[xyz])"
    r"|(?P<kind>point|vector)\s*(?P<point>\(.*\)))\s+(?:of\s+)?(?P<rest>.+)",
    re.DOTALL,
)
_POSE = re.compile(r"(?:pose\s+)?(?P<start>base|\d{1,4})\s*\.\.\s*(?P<end>tool|base|\d{1,4})")
_LINK = re.compile(r"link\s+(?P<link>\d{1,4})")
_PRODUCT = re.compile(r"product\s+[\"“'](?P<text>.+)[\"”']", re.DOTALL)
MOST_DIGITS = 4
LONGEST = 2000
"""Characters of a question."""
_INVERSE = re.compile(r"inverse\s+of\s+(?P<rest>.+)", re.DOTALL)


def read_question(text: str, scope: Scope, place: Place | None = None) -> Question:
    """Read the text that asks a question.

    Args:
        text: One of `KINDS`.
        scope: The names that points, products and scalars may use.
        place: Where the text stands, for errors.

    Raises:
        NotationError: It asks nothing that is known, or a part of it cannot be read.
    """
    text = text.strip()
    if len(text) > LONGEST:
        raise NotationError(Problem(f"a question of more than {LONGEST} characters is not read", place))
    word = text.split(None, 1)[0] if text else ""
    others: dict[str, Callable[[str], Question]] = {
        "table": lambda rest: _table(rest, place),
        "cell": lambda rest: _cell(rest, place),
        "factors": lambda rest: FactorsQuestion(_number(rest, place)),
        "scalar": lambda rest: ScalarQuestion(parse_quantity(rest, scope, _behind(place, text, rest)), rest),
        "count": lambda rest: _count(rest, place),
        "choice": lambda _: ChoiceQuestion((), 0),
    }
    if word in others:
        return others[word](text[len(word) :].strip())
    return _matrix_question(text, scope, place)


def _behind(place: Place | None, text: str, rest: str) -> Place | None:
    """Where the end of a text begins."""
    if place is None or place.column is None:
        return place
    return replace(place, column=place.column + len(text) - len(rest))


def check_question(question: Question, robot: Robot | None) -> None:
    """Make sure that a robot has what a question asks about.

    Raises:
        RobotError: There is no robot, or it has no such link or no table.
        UnknownNameError: It has no such frame.
    """
    match question:
        case MatrixQuestion(source=Span(start, end)):
            for name in (start, end):
                frame(_needed(robot), name)
        case CellQuestion(_, link) | FactorsQuestion(link):
            found = [one for one in _needed(robot).links if str(one.number) == link]
            if not found:
                raise RobotError(f"{_needed(robot).name} has no link {link}")
            if isinstance(question, CellQuestion) and found[0].row is None:
                raise RobotError(f"{_needed(robot).name} is given as products and has no table")
        case TableQuestion():
            _needed(robot)


def _needed(robot: Robot | None) -> Robot:
    if robot is None:
        raise RobotError("this question needs a robot", "name one under robot:")
    return robot


def _matrix_question(text: str, scope: Scope, place: Place | None) -> MatrixQuestion:
    match = _PIECE.fullmatch(text)
    if match is None:
        source, inverse = _source(text, scope, place)
        return MatrixQuestion(source, inverse)
    source, inverse = _source(match["rest"], scope, place)
    if match["row"]:
        return MatrixQuestion(source, inverse, "entry", (int(match["row"]) - 1, int(match["column"]) - 1))
    if match["axis"]:
        return MatrixQuestion(source, inverse, "axis", ("xyz".index(match["axis"]), 0))
    if match["kind"]:
        cells = [cell.expr for row in parse_matrix(f"[{match['point'][1:-1]}]", scope, place) for cell in row]
        if len(cells) != 3:  # noqa: PLR2004
            raise NotationError(Problem(f"a {match['kind']} has three coordinates, not {len(cells)}", place))
        kind: Piece = "point" if match["kind"] == "point" else "vector"
        return MatrixQuestion(source, inverse, kind, point=tuple(_length(cell, place) for cell in cells))
    return MatrixQuestion(source, inverse, "rotation" if match["piece"] == "rotation" else "position")


def _length(expr: Expr, place: Place | None) -> Expr:
    try:
        return to_length(expr)
    except DimensionError as error:
        raise NotationError(Problem(error.message, place, error.hint)) from None


def _source(text: str, scope: Scope, place: Place | None) -> tuple[Source, bool]:
    text, inverse = text.strip(), False
    while match := _INVERSE.fullmatch(text):
        text, inverse = match["rest"].strip(), not inverse
    if match := _LINK.fullmatch(text):
        return Span(str(int(match["link"]) - 1), match["link"], link=True), inverse
    if match := _POSE.fullmatch(text):
        if match["start"] == match["end"]:
            hint = "write pose 0..1"
            raise NotationError(Problem("a frame seen from itself is no question", place, hint))
        return Span(match["start"], match["end"]), inverse
    if match := _PRODUCT.fullmatch(text):
        return Composed(read_chain(match["text"], scope, place), match["text"]), inverse
    raise _unknown(text, place)


def _table(rest: str, place: Place | None) -> TableQuestion:
    if rest not in (Convention.STANDARD, Convention.MODIFIED):
        raise NotationError(Problem(f"there is no table '{rest}'", place, "write table standard or table modified"))
    return TableQuestion(Convention(rest))


def _cell(rest: str, place: Place | None) -> CellQuestion:
    column, _, link = rest.partition(" ")
    if column not in COLUMNS:
        raise NotationError(Problem(f"a DH table has no column '{column}'", place, "columns: " + ", ".join(COLUMNS)))
    return CellQuestion(column, _number(link, place))


def _count(rest: str, place: Place | None) -> CountQuestion:
    what, _, linkage = rest.partition(" ")
    if what not in ("mobility", "gruebler", "links", "joints", "constraints", "freedoms") or not linkage.strip():
        raise NotationError(Problem(f"'count {rest}' is not understood", place, "write count mobility four-bar"))
    return CountQuestion(what, linkage.strip())


def _number(text: str, place: Place | None) -> str:
    if not text.strip().isdecimal() or len(text.strip()) > MOST_DIGITS:
        raise NotationError(Problem(f"'{text.strip():.60}' is not the number of a link", place, "write link 1"))
    return text.strip()


def _unknown(text: str, place: Place | None) -> NotationError:
    if text.startswith("entry 4"):
        return NotationError(Problem("the bottom row of a pose is 0 0 0 1 for everybody", place, "ask for rows 1 to 3"))
    examples = {kind.split()[0]: kind for kind in KINDS}
    similar = nearest(text.split(None, 1)[0] if text else "", examples)
    hint = "did you mean " + " or ".join(examples[word] for word in similar) + "?" if similar else ""
    return NotationError(
        Problem(f"'{text:.60}' asks nothing that is known", place, hint or "write one of: " + " · ".join(KINDS))
    )
