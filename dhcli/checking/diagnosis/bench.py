"""The evaluation of works: at one point in floats, where what they share is multiplied once, and in terms."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TypeVar

from dhcli.algebra.arithmetic import plus
from dhcli.algebra.floats import Floats
from dhcli.algebra.terms import TERMS
from dhcli.checking.diagnosis.work import Factor, Matrix, Multiplied, Work
from dhcli.checking.truth import piece_of
from dhcli.geometry.motion import inverse as undone
from dhcli.kinematics.fold import fold
from dhcli.kinematics.forward import put_in, textbook_form
from dhcli.kinematics.moves import names
from dhcli.kinematics.values import Values
from dhcli.notation.tree import Expr

N = TypeVar("N")

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

    def needed(self, index: int, total: Matrix[float]) -> Matrix[float]:
        """What would have to stand in the place of one factor of the right work, so that its product is another."""
        tail = self._tails[len(self._base) - 1 - index]
        return product(product(inverse(self._heads[index]), total), inverse(tail))

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
    """The product of two homogeneous matrices, without zeros and ones to be looked for.

    A search multiplies thousands of them in floats, and this takes a fifth of the time of `geometry.motion.product`.
    """
    (a, b, c, d), (e, f, g, h), (i, j, k, m) = right[:3]
    rows = []
    for r, s, t, p in left[:3]:
        rows.append((r * a + s * e + t * i, r * b + s * f + t * j, r * c + s * g + t * k, r * d + s * h + t * m + p))  # type: ignore[operator]
    return (*rows, right[3])


def inverse(matrix: Matrix[N]) -> Matrix[N]:
    """The inverse of a rigid motion."""
    return (*map(tuple, undone(matrix)), matrix[3])  # type: ignore[arg-type]


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
