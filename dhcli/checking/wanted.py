"""Which matrix is asked for, and what of it: frames of a robot or a product of moves, and a piece of what comes out.

`link 1` · `pose 0..3` · `product "Rot(z, 90°) Trans(1, 2, 3)"` · `inverse of link i` are matrices; `rotation of`,
`position of`, `entry 1 4 of`, `axis x of`, `point (1, 2, 3) of` and `vector (1, 0, 0) of` choose what is asked of one;
`rotation from rpy(10°, 20°, 30°)` is that of turns in any form.
"""

from __future__ import annotations

import re
from dataclasses import replace
from typing import Literal, TypeAlias

from dhcli.checking.kinds.linked import needed
from dhcli.checking.units import has_length_unit
from dhcli.errors import NotationError, Place, Problem
from dhcli.frozen import frozen
from dhcli.kinematics.frames import View, frame
from dhcli.kinematics.moves import Chain, Trans, read_chain
from dhcli.kinematics.robot import Robot
from dhcli.notation.dimensions import read_at
from dhcli.notation.matrix import parse_matrix
from dhcli.notation.quantity import to_length
from dhcli.notation.scope import Scope
from dhcli.notation.tree import Expr
from dhcli.regex import regex


class NotAskedError(Exception):
    """A text that asks nothing that is known.

    Attributes:
        text: The text, or the piece of it that is not understood.
    """

    def __init__(self, text: str) -> None:
        """Say which text."""
        super().__init__(text)
        self.text = text


@frozen
class Composed:
    """A product of moves, without a robot."""

    chain: Chain
    text: str


Source: TypeAlias = View | Composed

Piece = Literal["pose", "rotation", "position", "entry", "axis", "point", "vector"]
"""What is asked of a matrix."""


@frozen
class Wanted:
    """A matrix, or a piece of one, that is asked for.

    Attributes:
        source: Where the matrix comes from.
        inverse: Whether its inverse is meant.
        piece: What is asked of it.
        index: Row and column of an entry from 0; for an axis its column and 0.
        point: Coordinates of a point or a vector in the frame described.
        measured: Whether each of these was written with a unit of length.
        is_link: Whether it was asked for as a link, `A_i`.
    """

    source: Source
    inverse: bool = False
    piece: Piece = "pose"
    index: tuple[int, int] = (0, 0)
    point: tuple[Expr, ...] = ()
    measured: tuple[bool, ...] = ()
    is_link: bool = False

    @property
    def shape(self) -> tuple[int, int]:
        """Rows and columns of the answer."""
        return {"pose": (4, 4), "rotation": (3, 3), "entry": (1, 1)}.get(self.piece, (3, 1))

    @property
    def whole(self) -> str:
        """The matrix in words, whatever is asked of it."""
        if isinstance(self.source, View):
            start, end = self.source.start, self.source.end
            whole = f"A_{end}" if self.is_link else f"T_{start}{end}"
            whole += f", frame {end} seen from frame {start}"
        else:
            whole = self.source.text
        return f"the inverse of {whole}" if self.inverse else whole

    @property
    def is_factor(self) -> bool:
        """Whether other matrices can be multiplied by the answer."""
        return self.piece in ("pose", "rotation")

    @property
    def needs_table(self) -> bool:
        """Whether it is a matrix of the robot."""
        return isinstance(self.source, View)

    def check(self, robot: Robot | None) -> None:
        """Make sure that a robot has its frames.

        Raises:
            DhcliError: There is no robot, or it has no such frame.
        """
        if isinstance(self.source, View):
            for name in (self.source.start, self.source.end):
                frame(needed(robot), name)


_PIECE = regex(
    r"(?P<piece>rotation|position|entry\s+(?P<row>[1-3])\s+(?P<column>[1-4])|axis\s+(?P<axis>[xyz])"
    r"|(?P<kind>point|vector)\s*(?P<point>\(.*\)))\s+(?:of\s+)?(?P<rest>.+)",
    re.DOTALL,
)
_POSE = regex(r"(?:pose\s+)?(?P<start>base|\d{1,4})\s*\.\.\s*(?P<end>tool|base|\d{1,4})")
_OF_LINK = regex(r"\blink\s+\d+\s*$")
_LINK = regex(r"link\s+(?P<link>\d{1,4})")
_FROM = regex(r"rotation\s+from\s+(?P<text>.+)", re.DOTALL)
_PRODUCT = regex(r"product\s+[\"“'](?P<text>.+)[\"”']", re.DOTALL)
_INVERSE = regex(r"inverse\s+of\s+(?P<rest>.+)", re.DOTALL)


def read_wanted(text: str, scope: Scope, place: Place | None) -> Wanted:
    """Read what is asked of which matrix, such as `position of pose 0..3`.

    Raises:
        NotAskedError: It asks for no matrix.
        NotationError: A coordinate or a product in it cannot be read.
    """
    wanted = _wanted(text, scope, place)
    return replace(wanted, is_link=isinstance(wanted.source, View) and _OF_LINK.search(text) is not None)


def _wanted(text: str, scope: Scope, place: Place | None) -> Wanted:
    if turns := _FROM.fullmatch(text):
        return _rotation_from(turns["text"], scope, place)
    match = _PIECE.fullmatch(text)
    if match is None:
        source, inverse = _source(text, scope, place)
        return Wanted(source, inverse)
    source, inverse = _source(match["rest"], scope, place)
    if match["row"]:
        return Wanted(source, inverse, "entry", (int(match["row"]) - 1, int(match["column"]) - 1))
    if match["axis"]:
        return Wanted(source, inverse, "axis", ("xyz".index(match["axis"]), 0))
    if match["kind"]:
        cells = [cell.expr for row in parse_matrix(f"[{match['point'][1:-1]}]", scope, place) for cell in row]
        if len(cells) != 3:  # noqa: PLR2004
            raise NotationError(Problem(f"a {match['kind']} has three coordinates, not {len(cells)}", place))
        kind: Piece = "point" if match["kind"] == "point" else "vector"
        measured = tuple(has_length_unit(cell) for cell in cells)
        return Wanted(
            source, inverse, kind, point=tuple(read_at(place, to_length, cell) for cell in cells), measured=measured
        )
    return Wanted(source, inverse, "rotation" if match["piece"] == "rotation" else "position")


def _rotation_from(text: str, scope: Scope, place: Place | None) -> Wanted:
    """The matrix of `rpy(10°, 20°, 30°)`, `Rot([1, 2, 2], 40°)` or any turns one after the other."""
    chain = read_chain(text, scope, place)
    if any(isinstance(move, Trans) for move in chain):
        raise NotationError(Problem("a rotation is made of turns, and Trans is none", place, "rotation from rpy(...)"))
    return Wanted(Composed(chain, text), piece="rotation")


def _source(text: str, scope: Scope, place: Place | None) -> tuple[Source, bool]:
    text, inverse = text.strip(), False
    while match := _INVERSE.fullmatch(text):
        text, inverse = match["rest"].strip(), not inverse
    if match := _LINK.fullmatch(text):
        return View(str(int(match["link"]) - 1), match["link"]), inverse
    if match := _POSE.fullmatch(text):
        if match["start"] == match["end"]:
            raise NotationError(Problem("a frame seen from itself is no question", place, "write pose 0..1"))
        return View(match["start"], match["end"]), inverse
    if match := _FROM.fullmatch(text):
        return _rotation_from(match["text"], scope, place).source, inverse
    if match := _PRODUCT.fullmatch(text):
        return Composed(read_chain(match["text"], scope, place), match["text"]), inverse
    raise NotAskedError(text)
