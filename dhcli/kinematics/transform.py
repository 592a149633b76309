"""Products of moves and matrices without a robot: each frame on the way, and what becomes of points and vectors."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Literal, TypeAlias, cast

from dhcli.errors import NotationError, Place, Problem, RobotError, did_you_mean
from dhcli.geometry.orthonormal import not_a_rotation
from dhcli.geometry.words import in_words
from dhcli.kinematics.forward import put_in, spelled
from dhcli.kinematics.frames import Point
from dhcli.kinematics.moves import Chain, Fixed, Move, Rot, Trans, angle_names, expressions, from_factor, names
from dhcli.kinematics.placement import Placement, locked_warnings, placements
from dhcli.kinematics.pose import Pose
from dhcli.kinematics.question import AnyPose, SeenPoint, folded
from dhcli.kinematics.robot import Value
from dhcli.kinematics.sharpened import sharpened
from dhcli.notation.factors import Factor, parse_factors
from dhcli.notation.names import canonical
from dhcli.notation.parser import parse
from dhcli.notation.pasted import pose_matrix
from dhcli.notation.quantity import DimensionError, to_angle, to_plain_length
from dhcli.notation.scope import Scope, usual
from dhcli.notation.tree import ZERO, Trig
from dhcli.notation.walk import walk

MOST_IN_LETTERS = 80
"""Moves whose frames are all computed in letters; the formula of each may be as long as there are moves before it."""
_SHORT = 60
"""Characters of a matrix that stands in a heading as it was typed."""

Order: TypeAlias = Literal["current", "fixed"]


@dataclass(frozen=True)
class Stage:
    """One move of a product.

    Attributes:
        text: The move as it was typed.
        chain: It and the moves before it, in the order in which they are multiplied.
        end: The frame that they reach.
        symbolic: Whether they are multiplied in terms; else in floats.
    """

    text: str
    chain: Chain
    end: str
    symbolic: bool

    @cached_property
    def pose(self) -> AnyPose:
        """The frame that the move and those before it reach; most questions want the last one only."""
        return folded(self.chain, "0", self.end, symbolic=self.symbolic)


@dataclass(frozen=True, slots=True)
class Transform:
    """A product of moves.

    Attributes:
        steps: The moves in the order typed.
        order: Whether each move is about the current frame or about the fixed one.
        points: Points of the last frame, seen from the first.
        vectors: Vectors of the last frame, seen from the first: turned, not shifted.
        placements: The pose in other ways.
        words: Axes that point along an axis of the first frame, in words.
        warnings: What a person should know all the same.
    """

    steps: tuple[Stage, ...]
    order: Order
    points: tuple[SeenPoint, ...] = ()
    vectors: tuple[SeenPoint, ...] = ()
    placements: Mapping[str, Placement] = field(default_factory=dict)
    words: tuple[str, ...] = ()
    warnings: tuple[str, ...] = ()

    @property
    def pose(self) -> AnyPose:
        """The frame that all moves together reach."""
        return self.steps[-1].pose


@dataclass(frozen=True, slots=True)
class Wanted:
    """What to find out about a product.

    Attributes:
        order: `current` multiplies each move from the right, `fixed` from the left.
        symbolic: Whether to stay exact, roots and all, where numbers would do.
        points: Points of the last frame [m].
        vectors: Vectors of the last frame.
        forms: Other ways to say the pose, names of `placement.FORMS`.
    """

    order: Order = "current"
    symbolic: bool = False
    points: Sequence[Point] = ()
    vectors: Sequence[Point] = ()
    forms: Sequence[str] = ()


@dataclass(frozen=True, slots=True)
class Product:
    """Moves as they were typed.

    Attributes:
        moves: The moves.
        texts: How each was typed.
        remarks: What was taken for something else, such as 1.5708 rad for 90°.
    """

    moves: Chain
    texts: tuple[str, ...]
    remarks: tuple[str, ...] = ()


def read_product(text: str, place: Place, symbols: Sequence[str] = ()) -> Product:
    """Read a product of moves and matrices, or one matrix as dhcli or another program has printed it.

    Args:
        text: What a person wrote.
        place: Where the text stands, for errors.
        symbols: Names that may stand in it besides those that look like names, a letter with an index.

    Raises:
        NotationError: It cannot be read, or a matrix in it is no pose.
    """
    moves: list[Move] = []
    texts: list[str] = []
    remarks: list[str] = []
    for factor in _factors(text, place, usual(symbols), remarks):
        move = from_factor(factor)
        if isinstance(move, Fixed):
            where = _place_in(text, factor.start, place)
            if fault := not_a_rotation(move.rows):
                hint = "its first three columns must be perpendicular unit vectors, right-handed"
                raise NotationError(Problem(f"this matrix is no pose: {fault}", where, hint))
            (move,) = sharpened((move,), remarks)
        moves.append(move)
        texts.append(spelled(move) if isinstance(move, Rot | Trans) else _title(factor.text))
    return Product(tuple(moves), tuple(texts), tuple(dict.fromkeys(remarks)))


def _factors(text: str, place: Place, scope: Scope, remarks: list[str]) -> tuple[Factor, ...]:
    """The factors of a product; a text that is none may be one matrix, with what a program writes around it."""
    try:
        return parse_factors(text, scope, place, remarks)
    except NotationError:
        matrix = pose_matrix(text)
        if matrix is None:
            raise
    return parse_factors(matrix, scope, place, remarks)


def _title(matrix: str) -> str:
    """What a matrix is called in a heading: itself where it was typed short, in one line."""
    return matrix if len(matrix) <= _SHORT and matrix.startswith("[") and "\n" not in matrix else "[4x4 matrix]"


def values_for(product: Product, settings: Mapping[str, str], place: Place) -> dict[str, Value]:
    """Values of names in a product, an angle or a length by what each stands for.

    Raises:
        RobotError: The product has no such name.
        NotationError: A value that cannot be read, or is of the wrong kind.
    """
    chain = product.moves
    inside = {n for e in expressions(chain) for node in walk(e) if type(node) is Trig for n in node.angle.names}
    angles = angle_names(chain) | inside
    known = {canonical(name): name for name in names(chain) | inside}
    values: dict[str, Value] = {}
    for written, text in settings.items():
        name = known.get(canonical(written))
        if name is None:
            hint = did_you_mean(written, known.values()) or "no name stands in it"
            raise RobotError(Problem(f"{written} does not stand in the product", place, hint))
        expr = parse(text, Scope(), place)
        try:
            values[name] = to_angle(expr, bare="refuse") if name in angles else to_plain_length(expr)
        except DimensionError as error:
            raise NotationError(Problem(f"{error.message}, for {name}", place, error.hint)) from None
    return values


def compose(product: Product, values: Mapping[str, Value], wanted: Wanted) -> Transform:
    """Compose moves, in numbers where every name has a value.

    Args:
        product: The moves in the order typed.
        values: Values of names.
        wanted: What to find out.

    Raises:
        RobotError: An entry is not a real number, or there are too many moves for formulas.
    """
    moves = put_in(product.moves, values)
    points, vectors = (put_in(tuple(Trans(*triple) for triple in t), values) for t in (wanted.points, wanted.vectors))
    exact = wanted.symbolic or bool(names((*moves, *points, *vectors)))
    if exact and len(moves) > MOST_IN_LETTERS:
        message = f"{len(moves)} moves are more than the {MOST_IN_LETTERS} that are multiplied in letters"
        raise RobotError(message, "give every letter a value with --set, or multiply a part at a time")
    so_far = [moves[: i + 1] if wanted.order == "current" else moves[i::-1] for i in range(len(moves))]
    steps = tuple(
        Stage(text, chain, str(i), exact) for i, (text, chain) in enumerate(zip(product.texts, so_far, strict=True), 1)
    )
    chain = so_far[-1]
    turning = tuple(turned for move in chain if (turned := _turning(move)) is not None)

    def seen(triple: Point, end: Move, before: Chain) -> SeenPoint:
        frame = str(len(moves))
        return SeenPoint(triple, folded((*before, end), "0", frame, symbolic=exact).position, frame, "0")

    said = placements(steps[-1].pose, wanted.forms)
    return Transform(
        steps,
        wanted.order,
        points=tuple(seen(point, end, chain) for point, end in zip(wanted.points, points, strict=True)),
        vectors=tuple(seen(vector, end, turning) for vector, end in zip(wanted.vectors, vectors, strict=True)),
        placements=said,
        words=() if exact else in_words(cast("Pose[float]", steps[-1].pose).rotation),
        warnings=(*product.remarks, *locked_warnings(said)),
    )


def _turning(move: Move) -> Move | None:
    """What a move does to a vector: translations do nothing."""
    if isinstance(move, Trans):
        return None
    return Fixed(tuple((*row[:3], ZERO) for row in move.rows)) if isinstance(move, Fixed) else move


def _place_in(text: str, start: int, place: Place) -> Place:
    """Where a factor begins, by line and column if the text has several lines."""
    before = text[:start]
    line = before.count("\n")
    column = start - (before.rfind("\n") + 1) + 1
    shown = text.split("\n")[line]
    return replace(place, line=line + 1 if "\n" in text else place.line, column=column, text=shown)
