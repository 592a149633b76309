"""Products of moves and matrices without a robot: each frame on the way, and what becomes of points and vectors."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import field, replace
from functools import cached_property
from typing import Literal, TypeAlias, cast

from dhcli.algebra.floats import Floats
from dhcli.errors import NotationError, Place, Problem, RobotError, did_you_mean
from dhcli.frozen import frozen
from dhcli.geometry.orthonormal import not_a_rotation
from dhcli.geometry.printed import nearest_rotation
from dhcli.geometry.words import in_words
from dhcli.kinematics.forward import put_in
from dhcli.kinematics.frames import Point
from dhcli.kinematics.moves import (
    Chain,
    Fixed,
    Move,
    Rot,
    Trans,
    every_angle,
    from_factor,
    names,
    sharpened,
    spelled,
)
from dhcli.kinematics.placement import Placement, locked_warnings, placements
from dhcli.kinematics.pose import Pose
from dhcli.kinematics.question import AnyPose, SeenPoint, folded
from dhcli.kinematics.robot import Value
from dhcli.notation.factors import Factor
from dhcli.notation.names import canonical
from dhcli.notation.parser import parse
from dhcli.notation.pasted import pose_matrix
from dhcli.notation.products import moves_of, parse_factors
from dhcli.notation.quantity import DimensionError, to_angle, to_plain_length
from dhcli.notation.scope import Scope, usual
from dhcli.notation.tree import ZERO, Expr
from dhcli.notation.walk import symbols
from dhcli.regex import regex

MOST_IN_LETTERS = 80
"""Moves whose frames are all computed in letters; the formula of each may be as long as there are moves before it."""
_JSON = regex(r"\s*\{\s*\"")
_SHORT = 60
"""Characters of a matrix that stands in a heading as it was typed."""

Order: TypeAlias = Literal["current", "fixed"]


@frozen
class Stage:
    """One move of a product.

    Attributes:
        text: The move as it was typed.
        chain: It and the moves before it, in the order in which they are multiplied.
        end: The frame that they reach.
        symbolic: Whether they are multiplied in terms; else in floats.
        about: Whether the move is about the current frame or about the fixed one.
    """

    text: str
    chain: Chain
    end: str
    symbolic: bool
    about: Order = "current"

    @cached_property
    def pose(self) -> AnyPose:
        """The frame that the move and those before it reach; most questions want the last one only."""
        return folded(self.chain, "0", self.end, symbolic=self.symbolic)


@frozen
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


@frozen
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


@frozen
class Product:
    """Moves as they were typed.

    Attributes:
        groups: The moves; a rotation about any axis is three in a group.
        texts: How each was typed.
        abouts: Whether each is about the fixed or the current frame, where that is said with it.
        remarks: What was taken for something else, such as 1.5708 rad for 90°.
    """

    groups: tuple[Chain, ...]
    texts: tuple[str, ...]
    abouts: tuple[Order | Literal[""], ...]
    remarks: tuple[str, ...] = ()

    @property
    def moves(self) -> Chain:
        """All moves as they were typed."""
        return tuple(move for group in self.groups for move in group)


def read_product(text: str, place: Place, symbols: Sequence[str] = ()) -> Product:
    """Read a product of moves and matrices, or one matrix as dhcli or another program has printed it.

    Args:
        text: What a person wrote.
        place: Where the text stands, for errors.
        symbols: Names that may stand in it besides those that look like names, a letter with an index.

    Raises:
        NotationError: It cannot be read, or a matrix in it is no pose.
    """
    groups: list[Chain] = []
    texts: list[str] = []
    abouts: list[Order | Literal[""]] = []
    remarks: list[str] = []
    for factors in moves_of(_factors(text, place, usual(symbols), remarks)):
        moves = sharpened(tuple(_checked(factor, text, place) for factor in factors), remarks)
        alone = moves[0] if len(moves) == 1 else None
        groups.append(moves)
        texts.append(spelled(alone) if isinstance(alone, Rot | Trans) else _title(factors))
        abouts.append(factors[0].about)
    return Product(tuple(groups), tuple(texts), tuple(abouts), tuple(dict.fromkeys(remarks)))


def _checked(factor: Factor, text: str, place: Place) -> Move:
    move = from_factor(factor)
    if isinstance(move, Fixed) and (fault := not_a_rotation(move.rows)):
        hint = f"its first three columns must be perpendicular unit vectors, right-handed{_nearest(move.rows)}"
        raise NotationError(Problem(f"this matrix is no pose: {fault}", _place_in(text, factor.start, place), hint))
    return move


def _nearest(rows: Sequence[Sequence[Expr]]) -> str:
    """The rotation nearest to a matrix of numbers, and how far away it is; empty where there is none."""
    if any(symbols(entry) for row in rows for entry in row[:3]):
        return ""
    numbers = [[Floats().value(entry) for entry in row[:3]] for row in rows[:3]]
    nearest = nearest_rotation(numbers)
    if nearest is None:
        return ""
    apart = max(abs(x - y) for row, near in zip(numbers, nearest, strict=True) for x, y in zip(row, near, strict=True))
    shown = "; ".join(" ".join(f"{round(x, 6) + 0.0:g}" for x in row) for row in nearest)
    return f"; the nearest rotation is {shown}, an entry of it {apart:.2g} away"


def _factors(text: str, place: Place, scope: Scope, remarks: list[str]) -> tuple[Factor, ...]:
    """The factors of a product; a text that is none may be one matrix, with what a program writes around it."""
    try:
        return parse_factors(text, scope, place, remarks)
    except NotationError:
        matrix = pose_matrix(text)
        if matrix is None and _JSON.match(text):
            hint = 'wanted: a "matrix" of four rows of four, as dhcli fk ROBOT --q ... --format json writes it'
            raise NotationError(Problem("this JSON holds no 4x4 matrix", place, hint)) from None
        if matrix is None:
            raise
    return parse_factors(matrix, scope, place, remarks)


def _title(factors: Sequence[Factor]) -> str:
    """What a matrix or a rotation is called in a heading: itself where it was typed short, in one line."""
    text = factors[0].text
    if len(factors) == 1 and not text.startswith(("[", "quat")):
        return "[4x4 matrix]"
    back = "^-1" * (factors[0].inverse and not factors[0].about)
    return f"{text}{back}" if len(text) <= _SHORT and "\n" not in text else "[4x4 matrix]"


def values_for(product: Product, settings: Mapping[str, str], place: Place) -> dict[str, Value]:
    """Values of names in a product, an angle or a length by what each stands for.

    Raises:
        RobotError: The product has no such name.
        NotationError: A value that cannot be read, or is of the wrong kind.
    """
    chain = product.moves
    angles = every_angle(chain)
    known = {canonical(name): name for name in names(chain)}
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

    Raises:
        RobotError: An entry is not a real number, or there are too many moves for formulas.
    """
    groups = [put_in(group, values) for group in product.groups]
    moves = tuple(move for group in groups for move in group)
    points, vectors = (put_in(tuple(Trans(*triple) for triple in t), values) for t in (wanted.points, wanted.vectors))
    exact = wanted.symbolic or bool(names((*moves, *points, *vectors)))
    if exact and len(moves) > MOST_IN_LETTERS:
        message = f"{len(moves)} moves are more than the {MOST_IN_LETTERS} that are multiplied in letters"
        raise RobotError(message, "give every letter a value with --set, or multiply a part at a time")
    chain: Chain = ()
    steps = []
    for i, (text, group, about) in enumerate(zip(product.texts, groups, product.abouts, strict=True), 1):
        chain = (*group, *chain) if (about or wanted.order) == "fixed" else (*chain, *group)
        steps.append(Stage(text, chain, str(i), exact, about or wanted.order))
    turning = tuple(turned for move in chain if (turned := _turning(move)) is not None)

    def seen(triple: Point, end: Move, before: Chain) -> SeenPoint:
        frame = str(len(steps))
        return SeenPoint(triple, folded((*before, end), "0", frame, symbolic=exact).position, frame, "0")

    said = placements(steps[-1].pose, wanted.forms)
    return Transform(
        tuple(steps),
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
