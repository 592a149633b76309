"""The loop that plays a program over many poses, in plain Python: compiled by numba it is the fastest way there is.

It plays any program, so it is compiled once, and no robot waits for a compiler.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]
    Places = NDArray[np.int64]

ADD, SUBTRACT, MULTIPLY, ADD_TO, TAKE_FROM, MULTIPLY_BY, RAISE_TO, TURN, SET = range(9)
"""What a step does: of two registers; of one and a constant; cosine and sine of one; a constant alone."""

QUARTERS = 2.0 / math.pi
LONG, MIDDLE, SHORT = (float.fromhex(f"0x1.{part}") for part in ("921fb544p+0", "0b4611a6p-34", "3198a2e037073p-69"))
"""π/2 in three parts, the first two of 33 bits, so that their products with fewer than 2**20 quarters are exact."""

MOST_QUARTERS = 2.0**20
"""Right angles up to which an angle is reduced here, 1.6 million radians; what is larger is left to numpy."""

TILE = 8
"""Rows that are turned into columns at a time: as many as a line of the cache holds numbers."""

S3, S5, S7, S9, S11, S13, S15 = ((-1) ** k / math.factorial(2 * k + 1) for k in range(1, 8))
C2, C4, C6, C8, C10, C12, C14, C16 = ((-1) ** k / math.factorial(2 * k) for k in range(1, 9))
"""Taylor's coefficients: at 45° the first term that is left out is 5e-17 of the sine and 2e-18 of the cosine."""


def loop(  # noqa: PLR0913, PLR0917  only numbers and arrays: it is compiled
    steps: Places, constants: Floats, size: int, width: int, q: Floats, most: float, found: Floats
) -> bool:
    """Play a program.

    Args:
        steps: What to do, shape (steps, 4): one of the codes above, two registers that are read, one that is written;
            TURN reads one and writes the cosine to the second, the sine to the third; SET reads none.
        constants: A number for each step, shape (steps,).
        size: How many registers there are; the first are the results, the next ones begin as the values of a row.
        width: Rows at a time.
        q: Values of the variables, shape (N, variables); radians and metres.
        most: Up to which size they are taken; if that is infinite, whatever they are.
        found: Where the results go, shape (N, results).

    Returns:
        Whether all values were taken and all angles could be reduced; otherwise what was found is not all right.
    """
    registers = np.empty((size, width))  # numba lays it where no vector of numbers crosses a line of the cache
    results = found.shape[1]
    near = True
    for first in range(0, len(q), width):
        count = min(width, len(q) - first)
        whole = count - count % TILE
        for j in range(0, whole, TILE):
            for k in range(q.shape[1]):
                for i in range(TILE):
                    registers[results + k, j + i] = q[first + j + i, k]
        for j in range(whole, count):
            for k in range(q.shape[1]):
                registers[results + k, j] = q[first + j, k]
        if most < math.inf:
            for k in range(q.shape[1]):
                for j in range(count):
                    near &= abs(registers[results + k, j]) <= most
            if not near:
                return False
        for i in range(len(steps)):
            code, a, b, c = steps[i, 0], steps[i, 1], steps[i, 2], steps[i, 3]
            constant = constants[i]
            if code == ADD:
                for j in range(count):
                    registers[c, j] = registers[a, j] + registers[b, j]
            elif code == SUBTRACT:
                for j in range(count):
                    registers[c, j] = registers[a, j] - registers[b, j]
            elif code == MULTIPLY:
                for j in range(count):
                    registers[c, j] = registers[a, j] * registers[b, j]
            elif code == ADD_TO:
                for j in range(count):
                    registers[c, j] = registers[a, j] + constant
            elif code == TAKE_FROM:
                for j in range(count):
                    registers[c, j] = constant - registers[a, j]
            elif code == MULTIPLY_BY:
                for j in range(count):
                    registers[c, j] = registers[a, j] * constant
            elif code == RAISE_TO:
                for j in range(count):
                    registers[c, j] = registers[a, j] ** constant
            elif code == SET:
                for j in range(count):
                    registers[c, j] = constant
            else:
                far = False
                for j in range(count):
                    x = registers[a, j]
                    quarters = np.floor(x * QUARTERS + 0.5)
                    far |= abs(quarters) >= MOST_QUARTERS
                    y = ((x - quarters * LONG) - quarters * MIDDLE) - quarters * SHORT
                    z = y * y
                    s = z * (S3 + z * (S5 + z * (S7 + z * (S9 + z * (S11 + z * (S13 + z * S15))))))
                    s = y + y * s
                    t = z * (C2 + z * (C4 + z * (C6 + z * (C8 + z * (C10 + z * (C12 + z * (C14 + z * C16)))))))
                    t = 1.0 + t
                    halves = np.floor(quarters * 0.5)  # half turns; each turns both signs
                    sign = 1.0 - 2.0 * (halves - 2.0 * np.floor(halves * 0.5))
                    odd = quarters - 2.0 * halves  # 1 where cosine and sine change places, else 0
                    registers[b, j] = sign * ((1.0 - odd) * t - odd * s)
                    registers[c, j] = sign * ((1.0 - odd) * s + odd * t)
                near &= not far
        for j in range(count):
            for k in range(results):
                found[first + j, k] = registers[k, j]
    return near
