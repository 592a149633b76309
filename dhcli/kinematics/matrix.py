"""A matrix in numbers or expressions that shows itself: what a pose and a Jacobian have in common."""

from __future__ import annotations

from abc import abstractmethod
from typing import TYPE_CHECKING, Any, Generic, TypeAlias, TypeVar

from dhcli.algebra.floats import Floats
from dhcli.errors import RobotError
from dhcli.kinematics.entries import DIGITS, rounded
from dhcli.notation.styles import Joints, identifier
from dhcli.notation.tree import Expr, Symbol
from dhcli.notation.walk import symbols_in
from dhcli.notation.writer import write

if TYPE_CHECKING:
    import numpy as np
    import sympy
    from numpy.typing import DTypeLike, NDArray

N = TypeVar("N")
Rows: TypeAlias = tuple[tuple[N, ...], ...]


class Matrix(Generic[N]):
    """Entries in rows, floats or expressions.

    Attributes:
        rows: The entries.
    """

    __slots__ = ()

    rows: Rows[N]

    @abstractmethod
    def cells(self, style: str = "short", digits: int = DIGITS) -> tuple[tuple[str, ...], ...]:
        """The entries as text, row by row: expressions in a notation, numbers rounded for people."""

    @abstractmethod
    def _numbers(self) -> Rows[float]:
        """The entries in floats."""

    @property
    def is_symbolic(self) -> bool:
        """Whether the entries are expressions."""
        return any(isinstance(entry, Expr) for row in self.rows for entry in row)

    @property
    def matrix(self) -> NDArray[np.float64]:
        """The entries as a numpy array: of a pose (4, 4), of a Jacobian (rows, joints).

        Raises:
            RobotError: An entry holds a symbol.
        """
        import numpy as np

        return np.array(self._numbers(), dtype=np.float64)

    def __array__(self, dtype: DTypeLike | None = None, copy: bool | None = None) -> NDArray[Any]:  # noqa: FBT001
        """Let numpy read it as it reads nested lists."""
        import numpy as np

        if self.is_symbolic and (dtype is None or np.dtype(dtype) == np.dtype(object)):
            return np.array(self.rows, dtype=object)
        return np.array(self._numbers(), dtype=dtype)

    def to_sympy(self) -> sympy.Matrix:
        """The entries as a sympy matrix.

        Its symbols are real ones, so that sympy simplifies more. `.subs({"theta1": 0})` means another symbol, of which
        sympy knows nothing, and changes nothing: `.subs({pose.sympy_symbols["theta1"]: 0})` puts a value in.
        """
        from dhcli.algebra.symbolic import to_sympy_matrix

        return to_sympy_matrix(self.rows)

    @property
    def sympy_symbols(self) -> dict[str, sympy.Symbol]:
        """The symbols of `to_sympy()` by their names there, `theta1`, `a2`."""
        from dhcli.algebra.symbolic import to_sympy

        return {identifier(name): to_sympy(Symbol(name)) for name in self._symbols()}

    def latex(self, digits: int = DIGITS) -> str:
        """The matrix for a paper, without dollar signs."""
        body = " \\\\ ".join(" & ".join(row) for row in self.cells("latex", digits))
        return f"\\begin{{bmatrix}} {body} \\end{{bmatrix}}"

    def __str__(self) -> str:
        """The matrix in columns, each as wide as its widest cell, without a heading."""
        cells = self.cells()
        widths = [max(map(len, column)) for column in zip(*cells, strict=True)]
        return "\n".join("  ".join(c.rjust(w) for c, w in zip(row, widths, strict=True)) for row in cells)

    def _repr_latex_(self) -> str:
        return f"$\\displaystyle {self.latex()}$"

    def _symbols(self) -> list[str]:
        return sorted(symbols_in([entry for row in self.rows for entry in row if isinstance(entry, Expr)]))

    def _written(self, joints: Joints, style: str, digits: int) -> tuple[tuple[str, ...], ...]:
        return tuple(
            tuple(write(e, style, joints) if isinstance(e, Expr) else rounded(float(e), digits) for e in row)  # type: ignore[arg-type]
            for row in self.rows
        )

    def _floats(self, name: str, hint: str) -> Rows[float]:
        """The entries in floats.

        Args:
            name: What it is called, in an error.
            hint: Where numbers come from.

        Raises:
            RobotError: An entry holds a symbol.
        """
        if free := self._symbols():
            raise RobotError(f"{name} is in symbols: {', '.join(free)}", hint)
        over = Floats()
        return tuple(tuple(over.value(e) if isinstance(e, Expr) else float(e) for e in row) for row in self.rows)  # type: ignore[arg-type]
