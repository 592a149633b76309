"""A pose: where one frame is, seen from another."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Generic, TypeVar, overload

from dhcli.algebra.arithmetic import plus, times
from dhcli.errors import RobotError
from dhcli.notation.styles import THETAS, Joints
from dhcli.notation.tree import Expr
from dhcli.notation.writer import write

if TYPE_CHECKING:
    import numpy as np
    import sympy
    from numpy.typing import DTypeLike, NDArray

N = TypeVar("N")

DIGITS = 4
"""Decimals that a person is shown unless they ask for more."""


@dataclass(frozen=True, slots=True)
class Pose(Generic[N]):
    """A homogeneous matrix with the names of its two frames.

    Frame letters cancel as in a book: `T_ab @ T_bc` is `T_ac`, and `T_ab @ p_b` is `p_a`.

    Attributes:
        rows: Entries, shape (4, 4), floats or expressions; translation in metres.
        reference: The frame it is seen from.
        frame: The frame it describes.
        title: What it is called where that is more than its frames, such as `A_1` or `Rot(z, theta1)`.
        joints: The robot's joint angles, for shorthand.
    """

    rows: tuple[tuple[N, ...], ...]
    reference: str = "0"
    frame: str = "1"
    title: str = ""
    joints: Joints = field(default=THETAS, compare=False, repr=False)

    @property
    def is_symbolic(self) -> bool:
        """Whether the entries are expressions."""
        return isinstance(self.rows[0][0], Expr)

    @property
    def name(self) -> str:
        """`T_03`, or the title if it has one."""
        if self.title:
            return self.title
        short = len(self.reference) == 1 and len(self.frame) == 1
        return f"T_{self.reference}{self.frame}" if short else f"T_{{{self.reference},{self.frame}}}"

    @property
    def rotation(self) -> tuple[tuple[N, ...], ...]:
        """The direction cosines, shape (3, 3); columns are the axes of the frame described."""
        return tuple(row[:3] for row in self.rows[:3])

    @property
    def position(self) -> tuple[N, N, N]:
        """The origin of the frame described [m]."""
        return self.rows[0][3], self.rows[1][3], self.rows[2][3]

    @property
    def matrix(self) -> NDArray[np.float64]:
        """The entries as a numpy array, shape (4, 4); only for a pose in numbers."""
        import numpy as np

        return np.array(self.rows, dtype=np.float64)

    def __array__(self, dtype: DTypeLike | None = None, copy: bool | None = None) -> NDArray[Any]:  # noqa: FBT001
        """Let numpy read a pose as it reads nested lists."""
        import numpy as np

        return np.array(self.rows, dtype=object if self.is_symbolic and dtype is None else dtype)

    @overload
    def __matmul__(self, other: Pose[N]) -> Pose[N]: ...
    @overload
    def __matmul__(self, other: Sequence[N | int]) -> tuple[N, ...]: ...
    def __matmul__(self, other: Pose[N] | Sequence[N | int]) -> Pose[N] | tuple[N, ...]:
        """Chain two poses, or find where a point is.

        Args:
            other: A pose whose reference is this frame, or a point of this frame, shape (3,) [m].

        Returns:
            A pose, or the point seen from the reference, a tuple of 3.

        Raises:
            RobotError: The frames do not meet, or a point has not three coordinates.
        """
        if isinstance(other, Pose):
            if other.reference != self.frame:
                raise RobotError(
                    f"{self.name} ends in frame {self.frame}, {other.name} starts from {other.reference}",
                    "the inner frames of a product must be the same",
                )
            columns = list(zip(*other.rows, strict=True))
            rows = tuple(tuple(_dot(row, column) for column in columns) for row in self.rows)
            return Pose(rows, self.reference, other.frame, "", self.joints)
        if len(other) != 3:  # noqa: PLR2004
            raise RobotError(f"a point has three coordinates, not {len(other)}")
        return tuple(_dot(row, (*other, 1)) for row in self.rows[:3])

    def inverse(self) -> Pose[N]:
        """The reference seen from the frame described."""
        columns = [[row[k] for row in self.rows[:3]] for k in range(3)]
        zero = self.rows[3][0]
        back = tuple((*column, zero - _dot(column, self.position)) for column in columns)  # type: ignore[operator]
        return Pose((*back, self.rows[3]), self.frame, self.reference, "", self.joints)

    def to_sympy(self) -> sympy.Matrix:
        """The entries as a sympy matrix, shape (4, 4)."""
        from dhcli.algebra.symbolic import to_sympy_matrix

        return to_sympy_matrix(self.rows)

    def cells(self, style: str = "short", digits: int = DIGITS) -> tuple[tuple[str, ...], ...]:
        """The entries as text, shape (4, 4): expressions in a notation, numbers rounded for people."""
        return tuple(
            tuple(write(e, style, self.joints) if isinstance(e, Expr) else rounded(float(e), digits) for e in row)  # type: ignore[arg-type]
            for row in self.rows
        )

    def latex(self, digits: int = DIGITS) -> str:
        """The matrix for a paper, without dollar signs."""
        body = " \\\\ ".join(" & ".join(row) for row in self.cells("latex", digits))
        return f"\\begin{{bmatrix}} {body} \\end{{bmatrix}}"

    def __str__(self) -> str:
        """The matrix in columns, without a heading."""
        cells = self.cells()
        widths = [max(len(row[k]) for row in cells) for k in range(4)]
        return "\n".join("  ".join(c.rjust(w) for c, w in zip(row, widths, strict=True)) for row in cells)

    def __repr__(self) -> str:
        """The name and the matrix, as a notebook or the prompt shows it."""
        return f"{self.name}:\n{self}"

    def _repr_latex_(self) -> str:
        return f"$\\displaystyle {self.latex()}$"


def rounded(value: float, digits: int = DIGITS) -> str:
    """A number for people: rounded, no trailing zeros, no minus zero."""
    if value != value or value in (float("inf"), float("-inf")):  # noqa: PLR0124  NaN
        return str(value)
    text = f"{value:.{digits}f}"
    if "." in text:
        text = text.rstrip("0").rstrip(".")
    return "0" if text in ("-0", "") else text


def _dot(row: Sequence[N | int], column: Sequence[N | int]) -> N:
    """A sum of products; the row is of a matrix, so that the result is a number of its arithmetic."""
    total: N | int = times(row[0], column[0])
    for a, b in zip(row[1:], column[1:], strict=True):
        total = plus(total, times(a, b))
    return total  # type: ignore[return-value]
