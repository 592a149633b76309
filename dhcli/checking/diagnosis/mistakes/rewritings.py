"""What may be done to a finished matrix before it is written down."""

from __future__ import annotations

from typing import TypeVar

from dhcli.checking.diagnosis.bench import inverse
from dhcli.checking.diagnosis.work import Matrix

N = TypeVar("N")


class Swapped:
    """Two rows, or two columns of the rotation, in each other's place."""

    def __init__(self, first: int, second: int, *, rows: bool) -> None:
        """Take which two."""
        self._order = [0, 1, 2, 3]
        self._order[first], self._order[second] = second, first
        self._rows = rows

    def __call__(self, matrix: Matrix[N]) -> Matrix[N]:
        """The matrix rewritten."""
        if self._rows:
            return tuple(matrix[k] for k in self._order)
        return tuple(tuple(row[k] for k in self._order) for row in matrix)


class Negated:
    """One entry with the other sign."""

    def __init__(self, row: int, column: int) -> None:
        """Take which."""
        self._row, self._column = row, column

    def __call__(self, matrix: Matrix[N]) -> Matrix[N]:
        """The matrix rewritten."""
        row = list(matrix[self._row])
        row[self._column] = -row[self._column]  # type: ignore[operator]
        return (*matrix[: self._row], tuple(row), *matrix[self._row + 1 :])


class Negative:
    """Some rows with the other sign, so that whatever is computed from them has it, or a column above the last row."""

    def __init__(self, rows: tuple[int, ...] = (), column: int | None = None) -> None:
        """Take which."""
        self._rows, self._column = rows, column

    def __call__(self, matrix: Matrix[N]) -> Matrix[N]:
        """The matrix rewritten."""

        def is_turned(r: int, c: int) -> bool:
            return r in self._rows or (c == self._column and r < len(matrix) - 1)

        return tuple(
            tuple(-entry if is_turned(r, c) else entry for c, entry in enumerate(row))  # type: ignore[operator]
            for r, row in enumerate(matrix)
        )


def with_transpose(matrix: Matrix[N]) -> Matrix[N]:
    """The rotation transposed, the position as it was."""
    rows = ((*(matrix[c][r] for c in range(3)), matrix[r][3]) for r in range(3))
    return (*rows, matrix[3])


def with_position_negated(matrix: Matrix[N]) -> Matrix[N]:
    """For an inverse, the position of the matrix itself with the other sign."""
    right = inverse(matrix)
    rows = ((*matrix[k][:3], -right[k][3]) for k in range(3))  # type: ignore[operator]
    return (*rows, matrix[3])


def without_rotation(matrix: Matrix[N]) -> Matrix[N]:
    """The position alone."""
    zero, one = matrix[3][0], matrix[3][3]
    return (*((*(one if r == c else zero for c in range(3)), matrix[r][3]) for r in range(3)), matrix[3])


def with_position_below(matrix: Matrix[N]) -> Matrix[N]:
    """The last column as the last row."""
    zero, one = matrix[3][0], matrix[3][3]
    return (*((*matrix[r][:3], zero) for r in range(3)), (*(matrix[r][3] for r in range(3)), one))
