"""How somebody works out a matrix: the factors, how they are put together, and what is written down of it.

A mistake changes one of the three. The right work and every mistaken one are evaluated by the same code, over floats to
compare them with an answer, and over terms to write an answer that holds the mistake.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field, replace
from enum import Enum
from fractions import Fraction
from functools import partial
from typing import TypeAlias, TypeVar

from dhcli.algebra.arithmetic import plus, times
from dhcli.algebra.floats import Floats
from dhcli.algebra.terms import TERMS
from dhcli.checking.truth import piece_of
from dhcli.checking.wanted import Wanted
from dhcli.errors import RobotError
from dhcli.frozen import frozen
from dhcli.kinematics.conventions import Convention, Row
from dhcli.kinematics.fold import fold
from dhcli.kinematics.forward import put_in, textbook_form
from dhcli.kinematics.frames import View, frame
from dhcli.kinematics.moves import Chain, names
from dhcli.kinematics.robot import Robot
from dhcli.kinematics.values import Values
from dhcli.notation.styles import THETAS, Joints
from dhcli.notation.tree import Expr

N = TypeVar("N")

Matrix: TypeAlias = tuple[tuple[N, ...], ...]
"""A homogeneous matrix, shape (4, 4), of any kind of number."""

Rewriting: TypeAlias = Callable[[Matrix[N]], Matrix[N]]
"""What is done to a finished matrix before it is written down."""


class Multiplied(Enum):
    """How the factors are put together."""

    IN_ORDER = "the matrix product"
    UNROTATED = "rotations multiplied, positions only added"
    ELEMENTWISE = "entry by entry"


@dataclass(frozen=True, slots=True, eq=False)
class Factor:
    """One factor: a link, the base, the tool, or a single move. It equals itself only, so that it is a cheap key.

    Attributes:
        name: Number of the link, `base`, `tool`, or the number of a move.
        chain: Its moves.
        row: Its DH row, if it has one.
    """

    name: str
    chain: Chain
    row: Row | None = None


@frozen
class Work:
    """A way to an answer.

    Attributes:
        question: What is asked of the matrix.
        steps: The factors from left to right.
        multiplied: How they are put together.
        inverted: Whether the product is inverted.
        rewritten: What is done to the matrix afterwards, first to last.
        entry: Row and column of an entry of the answer that is not what comes out, and what stands there.
    """

    question: Wanted
    steps: tuple[Factor, ...]
    multiplied: Multiplied = Multiplied.IN_ORDER
    inverted: bool = False
    rewritten: tuple[Rewriting[float] | Rewriting[Expr], ...] = ()
    entry: tuple[int, int, Expr] | None = None

    def with_step(self, index: int, step: Factor) -> Work:
        """The same work with another factor in one place."""
        return replace(self, steps=(*self.steps[:index], step, *self.steps[index + 1 :]))


LINK = "link"
"""Under which the factors of a robot are kept, each with its name."""


@frozen
class Setting:
    """What a mistake may depend on besides the work.

    Attributes:
        convention: How rows become moves.
        variables: The joint variables.
        values: Values that the task gives, exact.
        numeric: Whether the answer is in numbers.
        writing: How joint angles are written.
        unit: Metres in a bare length of the sheet; 0 where there is no unit.
        robot: The robot, if there is one.
        factors: Factors made so far: one that several works hold is one object, and evaluated once.
    """

    convention: Convention = Convention.PRODUCT
    variables: tuple[str, ...] = ()
    values: Values = field(default_factory=dict)
    numeric: bool = False
    writing: Joints = THETAS
    unit: Fraction = Fraction(1)
    robot: Robot | None = None
    factors: dict[object, Factor | None] = field(default_factory=dict, init=False, repr=False, compare=False)

    def share_links(self, other: Setting) -> None:
        """Take the links of the same robot from another setting, so that what is made of them can be shared, too."""
        links = {key: one for key, one in other.factors.items() if isinstance(key, tuple) and key[0] == LINK}
        self.factors.update(links)

    def factor(self, key: object, make: Callable[[], Factor | None]) -> Factor | None:
        """The factor of a key, made when it is first asked for; None where a mistake changes nothing."""
        if key not in self.factors:
            self.factors[key] = make()
        return self.factors[key]


def right_work(question: Wanted, robot: Robot | None, setting: Setting) -> Work:
    """The right way to an answer; the moves of a single link, or of a product, are factors of their own.

    Args:
        question: What is asked.
        robot: The robot, if there is one.
        setting: Keeps the links, which all works share.

    Raises:
        RobotError: The question needs a robot and there is none.
    """
    source = question.source
    if not isinstance(source, View):
        steps = tuple(Factor(str(k), (move,)) for k, move in enumerate(source.chain, 1))
        return Work(question, steps, inverted=question.inverse)
    if robot is None:
        raise RobotError("this question needs a robot", "name one under robot:")
    first, last = (robot.frames.index(frame(robot, name)) for name in (source.start, source.end))
    steps = steps_between(robot, setting, min(first, last), max(first, last))
    return Work(question, steps, inverted=question.inverse is not (first > last))


def steps_between(robot: Robot, setting: Setting, first: int, last: int) -> tuple[Factor, ...]:
    """The factors from one frame of a robot to a later one, without those that move nothing.

    Args:
        robot: The robot.
        setting: Keeps the factors, which all works share.
        first: Place of the one frame in the order of the robot.
        last: Place of the other.
    """
    ends = [("base", robot.base, None), ("tool", robot.tool, None)]
    parts = [ends[0], *((str(link.number), link.moves, link.row) for link in robot.links), ends[1]]
    every = (setting.factor((LINK, part[0]), partial(Factor, *part)) for part in parts[first:last])
    return tuple(step for step in every if step is not None and step.chain)


MOST_SHARED = 2_000
"""Products that are kept at a point: those with one mistake are looked at for every question, pairs are too many."""

MOST_KNOWN = 10_000
"""Matrices of factors that are kept, some ten megabytes: where ranges are fine, hardly two of a class are alike."""


class Folds:
    """The matrices of some factors at points seen before; a factor depends on few names, so that many are alike."""

    def __init__(self, steps: Iterable[Factor], known: dict[object, Matrix[float]]) -> None:
        """Take the factors, and where to keep what comes out; others may keep theirs there, too."""
        self._names = {step: tuple(sorted(names(step.chain))) for step in steps}
        self._known = known

    def put(self, found: dict[object, Matrix[float]], over: Floats) -> None:
        """Put the matrix of each factor at a point to those that were found already."""
        values = {name: over.symbol(name) for held in self._names.values() for name in held}
        for step, held in self._names.items():
            if step in found:
                continue
            key = step, tuple(values[name] for name in held)
            if key not in self._known:
                if len(self._known) >= MOST_KNOWN:
                    self._known.clear()
                self._known[key] = fold(step.chain, over)
            found[step] = self._known[key]


class Bench:
    """Evaluates works at one point, in floats; what they share with the right one is multiplied once."""

    def __init__(
        self,
        right: Work,
        over: Floats,
        folds: Folds | None = None,
        known: dict[object, Matrix[float]] | None = None,
    ) -> None:
        """Make ready for works at a point.

        Args:
            right: The work that most others resemble.
            over: The values of the names.
            folds: Factors that other points share.
            known: Matrices of factors and of products at this point, which other benches share.
        """
        self._over = over
        self._base = right.steps
        self._known: dict[object, Matrix[float]] = {} if known is None else known
        if folds:
            folds.put(self._known, over)
        self._heads: list[Matrix[float]] = [_UNIT]
        self._tails: list[Matrix[float]] = [_UNIT]
        for step in self._base:
            self._heads.append(product(self._heads[-1], self.matrix_of(step)))
        for step in reversed(self._base):
            self._tails.append(product(self.matrix_of(step), self._tails[-1]))

    def entries(self, work: Work) -> Matrix[float]:
        """What is written down in the end, in the shape of the question."""
        rows = piece_of(self.matrix(work), work.question, self._over)
        return rows if work.entry is None else _with_entry(rows, work.entry, self._over.value(work.entry[2]))

    def matrix(self, work: Work) -> Matrix[float]:
        """The finished matrix, shape (4, 4)."""
        return _finished(work, self._multiplied(work))

    def matrix_of(self, step: Factor) -> Matrix[float]:
        """The matrix of one factor."""
        if step not in self._known:
            self._known[step] = fold(step.chain, self._over)
        return self._known[step]

    def _multiplied(self, work: Work) -> Matrix[float]:
        if work.multiplied is Multiplied.ELEMENTWISE:
            return _elementwise([self.matrix_of(step) for step in work.steps])
        total = self._known.get(work.steps)
        if total is None:
            total = self._in_order(work.steps)
            if len(self._known) < MOST_SHARED:
                self._known[work.steps] = total
        if work.multiplied is Multiplied.UNROTATED:
            return _added(total, [self.matrix_of(step) for step in work.steps])
        return total

    def _in_order(self, steps: tuple[Factor, ...]) -> Matrix[float]:
        """The product; what stands first and last in the right one, too, is multiplied already."""
        base = self._base
        shared = min(len(steps), len(base))
        head = next((k for k in range(shared) if steps[k] is not base[k]), shared)
        tail = next((k for k in range(shared - head) if steps[-1 - k] is not base[-1 - k]), shared - head)
        total = self._heads[head]
        for step in steps[head : len(steps) - tail]:
            total = product(total, self.matrix_of(step))
        return product(total, self._tails[tail]) if tail else total


def terms(work: Work, values: Values) -> Matrix[Expr]:
    """What is written down in the end, in terms with some values put in, in the shape of the question."""
    chain = tuple(move for step in work.steps for move in step.chain)
    if work.multiplied is Multiplied.ELEMENTWISE:
        matrix = _elementwise([textbook_form(put_in(step.chain, values)) for step in work.steps])
    else:
        matrix = textbook_form(put_in(chain, values))
    if work.multiplied is Multiplied.UNROTATED:
        matrix = _added(matrix, [textbook_form(put_in(step.chain, values)) for step in work.steps])
    rows = piece_of(_finished(work, matrix), work.question, TERMS)
    return rows if work.entry is None else _with_entry(rows, work.entry, work.entry[2])


def product(left: Matrix[N], right: Matrix[N]) -> Matrix[N]:
    """The product of two homogeneous matrices."""
    (a, b, c, d), (e, f, g, h), (i, j, k, m) = right[:3]
    rows = []
    for r, s, t, p in left[:3]:
        rows.append((r * a + s * e + t * i, r * b + s * f + t * j, r * c + s * g + t * k, r * d + s * h + t * m + p))  # type: ignore[operator]
    return (*rows, right[3])


def inverse(matrix: Matrix[N]) -> Matrix[N]:
    """The inverse of a rigid motion: R transposed and -R^T p."""
    rows = []
    for k in range(3):
        column = [matrix[r][k] for r in range(3)]
        back: N | int = 0
        for r in range(3):
            back = plus(back, times(column[r], matrix[r][3]))
        rows.append((*column, times(-1, back)))
    return (*rows, matrix[3])  # type: ignore[arg-type]


def _finished(work: Work, matrix: Matrix[N]) -> Matrix[N]:
    if work.inverted:
        matrix = inverse(matrix)
    for rewriting in work.rewritten:
        matrix = rewriting(matrix)  # type: ignore[arg-type, assignment]
    return matrix


def _with_entry(rows: Matrix[N], place: tuple[int, int, Expr], value: N) -> Matrix[N]:
    row, column, _ = place
    line = rows[row]
    return (*rows[:row], (*line[:column], value, *line[column + 1 :]), *rows[row + 1 :])


def _elementwise(matrices: Sequence[Matrix[N]]) -> Matrix[N]:
    total = matrices[0]
    for matrix in matrices[1:]:
        total = tuple(tuple(a * b for a, b in zip(r, s, strict=True)) for r, s in zip(total, matrix, strict=True))  # type: ignore[operator]
    return total


def _added(matrix: Matrix[N], factors: Sequence[Matrix[N]]) -> Matrix[N]:
    """The rotation of a product with the sum of the factors' positions."""
    rows = []
    for k in range(3):
        position: N | int = 0
        for factor in factors:
            position = plus(position, factor[k][3])
        rows.append((*matrix[k][:3], position))
    return (*rows, matrix[3])  # type: ignore[arg-type]


_UNIT: Matrix[float] = tuple(tuple(float(r == c) for c in range(4)) for r in range(4))
