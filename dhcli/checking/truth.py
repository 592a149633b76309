"""The right answer to a question, computed from the robot."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import islice
from typing import TypeVar

from dhcli.algebra.arithmetic import Arithmetic, settled, sum_of_products
from dhcli.algebra.floats import Floats
from dhcli.algebra.points import CIRCLE, GENERAL, SEED, draws
from dhcli.algebra.terms import TERMS
from dhcli.checking.credit import only_costs
from dhcli.checking.exercise import Case, Exercise
from dhcli.checking.kinds.linked import needed
from dhcli.checking.wanted import Composed, Wanted
from dhcli.errors import RobotError
from dhcli.frozen import frozen
from dhcli.kinematics.fold import fold
from dhcli.kinematics.forward import put_in, textbook_form
from dhcli.kinematics.frames import View, between, frame
from dhcli.kinematics.merge import merge
from dhcli.kinematics.moves import Chain, angle_names, expressions, inverse, names
from dhcli.kinematics.robot import Robot, Value
from dhcli.kinematics.values import numbers
from dhcli.notation.tree import Expr, Symbol, number
from dhcli.notation.walk import symbols_in, walk

N = TypeVar("N")

SAMPLES = 3
"""Points at which an entry that is always 0 or 1 is told from the others."""


@frozen
class Truth:
    """The right answer to a question about a matrix.

    Attributes:
        rows: The entries in textbook form.
        numbers: The entries in floats at the given values, or None while a name has no value.
        size: Sum of the lengths of all translations at the given values [m], the scale of a tolerance.
        structural: Which entries are the same for everybody and only cost something: the bottom row, those that are 0
            and, beside entries with names, the direction cosines that are 1 or -1.
    """

    rows: tuple[tuple[Expr, ...], ...]
    numbers: tuple[tuple[float, ...], ...] | None
    size: float
    structural: tuple[tuple[bool, ...], ...]

    def is_structural(self, row: int, column: int) -> bool:
        """Whether an entry is the same for everybody, so that it only costs something."""
        return self.structural[row][column]


def truth_of(question: Wanted, case: Case) -> Truth:
    """The right answer to a question about a matrix, computed once.

    Raises:
        RobotError: The question needs a robot and the exercise has none.
    """
    return case.memo.of(("truth", question), lambda: _compute(question, case))


def unvalued(question: Wanted, exercise: Exercise) -> tuple[str, ...]:
    """Names without which an answer in numbers cannot be computed, and that have no value."""
    return exercise.unvalued(names(chain_of(question, exercise.robot)) | _point_names(question))


def _compute(question: Wanted, case: Case) -> Truth:
    exercise = case.exercise
    chain = chain_of(question, exercise.robot)
    values = dict(exercise.values)
    named = names(chain) | _point_names(question)
    is_known = not named - values.keys()
    try:
        rows = _in_symbols(chain, question, case)
    except RobotError:
        if not exercise.numeric or not is_known:
            raise
        rows = _sampled(chain, question, named)  # too long for anybody to read, but numbers are not
    structural = _structural(question, rows)
    if not is_known:
        return Truth(rows, None, 0.0, structural)
    over = Floats(numbers(values))

    def multiplied() -> tuple[tuple[float, ...], ...]:
        # Merged once more with the values, so that angles which add up to 60° give exactly 1/2; merging letters first
        # leaves little to merge in numbers, where every rotation between two others has to be looked through.
        return fold(merge(put_in(merge(chain), values)), over)

    matrix = case.memo.of(("product", question.source, question.inverse), multiplied)
    return Truth(rows, piece_of(matrix, question, over), _size(chain, question, exercise, values), structural)


def _in_symbols(chain: Chain, question: Wanted, case: Case) -> tuple[tuple[Expr, ...], ...]:
    """The answer in textbook form, for which the values given do not matter; variants of an exercise share it."""
    lasting = case.memo.lasting
    known = lasting.get(question)
    if not isinstance(known, tuple) or known[0] != chain:
        known = lasting[question] = chain, piece_of(textbook_form(chain), question, TERMS)
    rows: tuple[tuple[Expr, ...], ...] = known[1]
    return rows


def _sampled(chain: Chain, question: Wanted, named: frozenset[str]) -> tuple[tuple[Expr, ...], ...]:
    """A name for each entry of an answer that is too long to be written; one that is 0, 1 or -1 everywhere is that."""
    turning = angle_names(chain)
    reach = {name: CIRCLE if name in turning else GENERAL for name in sorted(named)}
    points = [Floats(values) for values in islice(draws(reach, SEED), SAMPLES)]
    several = [piece_of(fold(merge(chain), over), question, over) for over in points]

    def entry(row: int, column: int) -> Expr:
        found = {round(one[row][column], 9) + 0.0 for one in several}
        return number(int(found.pop())) if found in ({0.0}, {1.0}, {-1.0}) else Symbol("…")

    return tuple(tuple(entry(r, c) for c in range(len(several[0][r]))) for r in range(len(several[0])))


def chain_of(question: Wanted, robot: Robot | None) -> Chain:
    """The moves whose product is asked about.

    Raises:
        RobotError: The question needs a robot and there is none.
    """
    if isinstance(question.source, View):
        robot = needed(robot)
        start, end = frame(robot, question.source.start), frame(robot, question.source.end)
        chain = between(robot, start, end)
    else:
        chain = question.source.chain
    return inverse(chain) if question.inverse else chain


def piece_of(rows: tuple[tuple[N, ...], ...], question: Wanted, over: Arithmetic[N]) -> tuple[tuple[N, ...], ...]:
    """What a question asks of a matrix, in the arithmetic of its entries."""
    row, column = question.index
    if question.piece == "pose":
        return rows
    if question.piece == "rotation":
        return tuple(line[:3] for line in rows[:3])
    if question.piece == "position":
        return tuple(line[3:] for line in rows[:3])
    if question.piece == "entry":
        return ((rows[row][column],),)
    if question.piece == "axis":
        return tuple((line[row],) for line in rows[:3])
    coordinates = (*map(over.length, question.point), int(question.piece == "point"))
    return tuple((settled(sum_of_products(line, coordinates), over),) for line in rows[:3])


def is_length(question: Wanted, row: int, column: int) -> bool:
    """Whether an entry of the answer is a length; the others are direction cosines or fixed."""
    if question.piece in ("position", "point"):
        return True
    if question.piece == "vector":  # a direction, unless its coordinates are lengths
        return any(question.measured) or any(type(node) is Symbol for one in question.point for node in walk(one))
    if question.piece == "entry":
        row, column = question.index
    return question.piece in ("pose", "entry") and column == 3 and row < 3  # noqa: PLR2004


def unit_of(question: Wanted, row: int, column: int, exercise: Exercise) -> float:
    """Metres in a bare number of an entry on the sheet; 1 where it is no length."""
    return float(exercise.metres) if is_length(question, row, column) else 1.0


def entries_on_sheet(question: Wanted, rows: Sequence[Sequence[Expr]], exercise: Exercise) -> list[list[Expr]]:
    """Entries in symbols as a sheet has them: bare numbers of lengths in its unit."""
    return [
        [exercise.on_sheet(entry) if is_length(question, r, c) else entry for c, entry in enumerate(row)]
        for r, row in enumerate(rows)
    ]


def _structural(question: Wanted, rows: tuple[tuple[Expr, ...], ...]) -> tuple[tuple[bool, ...], ...]:
    is_constant = not symbols_in(entry for row in rows for entry in row)

    def fixed(row: int, column: int) -> bool:
        if question.piece == "pose" and row == 3:  # noqa: PLR2004  the bottom row
            return True
        is_cosine = not is_length(question, row, column)
        return only_costs(rows[row][column], is_cosine=is_cosine, is_constant=is_constant)

    return tuple(tuple(fixed(r, c) for c in range(len(rows[r]))) for r in range(len(rows)))


def names_of(exercise: Exercise) -> frozenset[str]:
    """Every name that the questions of an exercise and what it gives are about."""
    found = frozenset((*exercise.given, *exercise.names, *exercise.scope.names))
    return found.union(*(part.question.names for part in exercise.parts))


def names_in(question: Wanted) -> frozenset[str]:
    """Names that a question brings along, besides those of the robot."""
    moves = names(question.source.chain) if isinstance(question.source, Composed) else frozenset[str]()
    return moves | _point_names(question)


def _point_names(question: Wanted) -> frozenset[str]:
    return symbols_in(question.point)


def _size(chain: Chain, question: Wanted, exercise: Exercise, values: Mapping[str, Value]) -> float:
    over = Floats(numbers(values))
    lengths = [abs(over.value(expr)) for move in chain for expr in expressions((move,)) if _is_offset(move, expr)]
    lengths += [abs(over.value(expr)) for expr in question.point]
    total = sum(lengths)
    if total:
        return total
    return max((abs(over.length(v)) for v in exercise.given.values() if isinstance(v, Expr)), default=0.0)


def _is_offset(move: object, expr: Expr) -> bool:
    """Whether an expression of a move is a length; in a matrix the fourth column is."""
    from dhcli.kinematics.moves import Fixed

    return not isinstance(move, Fixed) or any(row[3] is expr for row in move.rows)
