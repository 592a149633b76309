"""Numpy columns: a program is played over many poses at once, each instruction on whole columns."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from dhcli.algebra.program import Program

if TYPE_CHECKING:
    from numpy.typing import NDArray


class Columns:
    """The registers of a program, for blocks of up to one length."""

    def __init__(self, program: Program, length: int) -> None:
        """Make the registers, and hand them to the instructions once for all blocks."""
        self.program, self.length = program, length
        registers = np.empty((program.registers, length))
        for register, value in program.constants.items():
            registers[register] = value
        self._inputs = registers[program.inputs]
        self._results = registers[: program.inputs.start]
        self._calls = [
            (getattr(np, do.ufunc), [registers[o] if isinstance(o, int) else np.asarray(o) for o in do.operands])
            for do in program.instructions
        ]

    def play(self, values: NDArray[np.float64]) -> NDArray[np.float64]:
        """The results for a block; they stay until the next one.

        Args:
            values: Values of the variables, shape (variables, N), at most `length` of each; radians and metres.

        Returns:
            Shape (results, N); NaN where a result has no value.
        """
        count = values.shape[1]
        self._inputs[:, :count], self._inputs[:, count:] = values, 0.0
        with np.errstate(all="ignore"):
            for ufunc, columns in self._calls:
                ufunc(*columns)
        return self._results[:, :count]
