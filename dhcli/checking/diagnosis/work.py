"""How somebody works out a matrix: the factors, how they are put together, and what is written down of it.

A mistake changes one of the three. The right work and every mistaken one are evaluated by the same code, over floats to
compare them with an answer, and over terms to write an answer that holds the mistake; see `bench`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import field
from enum import Enum, IntEnum
from fractions import Fraction
from functools import partial
from typing import TypeAlias, TypeVar

from dhcli.checking.kinds.linked import needed
from dhcli.checking.wanted import Wanted
from dhcli.frozen import frozen
from dhcli.kinematics.conventions import Convention, Row
from dhcli.kinematics.frames import View, span_of
from dhcli.kinematics.moves import Chain
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


@frozen
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

    __eq__ = object.__eq__  # each equals itself only
    __hash__ = object.__hash__


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
        steps = (*self.steps[:index], step, *self.steps[index + 1 :])
        # half the time of `replace`, for what is made more often than anything else
        return Work(self.question, steps, self.multiplied, self.inverted, self.rewritten, self.entry)


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


class Level(IntEnum):
    """At what stage of the work a mistake is made."""

    TABLE = 1
    PRODUCT = 2
    MATRIX = 3


Made: TypeAlias = Iterator[tuple[str, Work]]
"""Where a mistake is made, such as `2` or `2 1`, and the work that holds it."""

Maker: TypeAlias = Callable[[Work, Setting], Made]


def right_work(question: Wanted, robot: Robot | None, setting: Setting) -> Work:
    """The right way to an answer; the moves of a single link, or of a product, are factors of their own.

    Raises:
        RobotError: The question needs a robot and there is none.
    """
    source = question.source
    if not isinstance(source, View):
        steps = tuple(Factor(str(k), (move,)) for k, move in enumerate(source.chain, 1))
        return Work(question, steps, inverted=question.inverse)
    robot = needed(robot)
    first, last = span_of(robot, source)
    steps = steps_between(robot, setting, min(first, last), max(first, last))
    return Work(question, steps, inverted=question.inverse is not (first > last))


def steps_between(robot: Robot, setting: Setting, first: int, last: int) -> tuple[Factor, ...]:
    """The factors from one frame of a robot to a later one, without those that move nothing."""
    ends = [("base", robot.base, None), ("tool", robot.tool, None)]
    parts = [ends[0], *((str(link.number), link.moves, link.row) for link in robot.links), ends[1]]
    every = (setting.factor((LINK, part[0]), partial(Factor, *part)) for part in parts[first:last])
    return tuple(step for step in every if step is not None and step.chain)
