"""A program played by one compiled loop, where numba is installed and it pays; numpy does it everywhere else."""

from __future__ import annotations

import math
import sys
from collections.abc import Iterator, Sequence
from contextlib import suppress
from importlib.util import find_spec
from itertools import zip_longest
from pathlib import Path
from threading import Lock
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np

from dhcli.algebra.loop import ADD, ADD_TO, MULTIPLY, MULTIPLY_BY, RAISE_TO, SET, SUBTRACT, TAKE_FROM, TURN, loop
from dhcli.algebra.program import Instruction, Program

if TYPE_CHECKING:
    from numpy.typing import NDArray

Step: TypeAlias = tuple[int, int, int, int]
"""What to do, two registers that are read, one that is written; see `loop`."""

WIDTH = 264
"""Rows at a time: so few that all registers of a robot stay in the nearest cache, and no power of two, so that they do
not crowd into the same sets of it."""

PAYS = 2_000_000
"""Rows that one process has numpy play before it imports numba: that takes half a second, which few need to pay."""


class Kernel:
    """A program in the numbers that the loop takes."""

    def __init__(self, program: Program) -> None:
        """Write the steps as numbers.

        Args:
            program: What to play, with cosines and sines, not with tangents.

        Raises:
            KeyError: It has a step that the loop does not know.
        """
        self._spare = program.registers
        steps = [((SET, 0, 0, register), value) for register, value in program.constants.items()]
        steps += self._encoded(program.instructions)
        self._steps = np.array([step for step, _ in steps], dtype=np.int64).reshape(-1, 4)
        self._constants = np.array([constant for _, constant in steps], dtype=np.float64)

    def play(self, q: NDArray[np.float64], found: NDArray[Any], *, most: float = math.inf, width: int = WIDTH) -> bool:
        """Play it over rows.

        Args:
            q: Values of the variables, shape (N, variables), in C order; radians and metres.
            found: Where the results go, shape (N, results), in C order; float64 or float32.
            most: Up to which size they are taken; by default whatever they are.
            width: Rows at a time.

        Returns:
            Whether all went well; if not, a value was too large, and the rows must be played in another way.
        """
        rows = q.view()
        rows.flags.writeable = False  # so that there is one kind of array, and one loop compiled for it
        play = loop if _LOADED.loop is None else _LOADED.loop
        return bool(play(self._steps, self._constants, self._spare + 1, width, rows, most, found))

    def _encoded(self, instructions: Sequence[Instruction]) -> Iterator[tuple[Step, float]]:
        """Each step in four numbers, and its constant; a cosine and the sine of the same angle are one step."""
        steps = iter(zip_longest(instructions, instructions[1:]))
        for step, following in steps:
            *read, written = step.operands
            if step.ufunc == "sin":
                yield (TURN, int(read[0]), self._spare, int(written)), 0.0
            elif step.ufunc != "cos":
                yield _coded(step.ufunc, read, int(written))
            elif following and (following.ufunc, following.operands[0]) == ("sin", read[0]):
                yield (TURN, int(read[0]), int(written), int(following.operands[1])), 0.0
                next(steps)
            else:
                yield (TURN, int(read[0]), int(written), self._spare), 0.0


def _coded(ufunc: str, read: Sequence[float], written: int) -> tuple[Step, float]:
    """A step that is no cosine and no sine in four numbers, and its constant."""
    constant = next((operand for operand in read if not isinstance(operand, int)), 0.0)
    if len(read) == 1:
        constant = {"negative": -1.0, "positive": 1.0}[ufunc]
        code = MULTIPLY_BY
    elif all(isinstance(operand, int) for operand in read):
        code = {"add": ADD, "subtract": SUBTRACT, "multiply": MULTIPLY}[ufunc]
    elif not isinstance(read[0], int):
        code = {"subtract": TAKE_FROM}[ufunc]
    else:
        code = {"add": ADD_TO, "subtract": ADD_TO, "multiply": MULTIPLY_BY, "power": RAISE_TO}[ufunc]
        constant = -constant if ufunc == "subtract" else constant
    places = [operand for operand in read if isinstance(operand, int)]
    return (code, places[0], places[-1], written), constant


class _Loader:
    """The compiled loop, once it pays to have it.

    Attributes:
        loop: The loop; None before, and where there is no numba.
    """

    def __init__(self) -> None:
        """Nothing yet."""
        self.loop: Any = None
        self._is_tried = False
        self._played = 0
        self._lock = Lock()

    def is_ready(self, count: int) -> bool:
        """Whether the loop is at hand for so many more rows: compiled if numba is loaded, or by now worth it."""
        if self._is_tried:
            return self.loop is not None
        self._played += count
        if "numba" not in sys.modules and self._played < PAYS:
            return False
        with self._lock:
            if not self._is_tried:
                self.loop = _compiled_loop()
                self._is_tried = True
        return self.loop is not None


_LOADED = _Loader()


def is_ready(count: int) -> bool:
    """Whether the compiled loop is to play so many rows."""
    return _LOADED.is_ready(count)


def _compiled_loop() -> Any:  # noqa: ANN401  a function of numba
    """The loop, compiled now or as it was kept on disk; None where numba is not installed, or does not work."""
    if find_spec("numba") is None:
        return None
    try:
        import numba
    except ImportError:  # a numba for another numpy
        return None
    for is_kept in (True, True, False):
        try:
            compiled = numba.njit(cache=is_kept, nogil=True, error_model="numpy", fastmath={"contract"})(loop)
            for kind in (numba.float64, numba.float32):
                compiled.compile(_signature(kind))
        except Exception:  # noqa: BLE001  whatever reading a broken file raises
            with suppress(Exception):
                _forget(Path(str(compiled.stats.cache_path)))
        else:
            compiled.disable_compile()
            return compiled
    return None


def _signature(kind: Any) -> Any:  # noqa: ANN401  types of numba
    """What the loop takes and gives, with results of a kind."""
    from numba import types

    number, count = types.float64, types.int64
    steps, constants = types.Array(count, 2, "C"), types.Array(number, 1, "C")
    values = types.Array(number, 2, "C", readonly=True)
    return types.boolean(steps, constants, count, count, values, number, types.Array(kind, 2, "C"))


def _forget(folder: Path) -> None:
    """Remove what is kept of the loop on disk."""
    for file in folder.glob(f"{Path(loop.__code__.co_filename).stem}.{loop.__name__}-*.nb[ic]"):
        file.unlink()
