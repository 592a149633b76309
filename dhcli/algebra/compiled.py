"""A program as one Python function: for one value at a time, where a loop over its steps would cost more than they do.

This is the only place where dhcli makes code while it runs. What is written into it are the numbers of registers and
the signs and names below, never a text of a file or a person: constants are handed to it as floats.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import TypeAlias

from dhcli.algebra.program import Program, Register

Play: TypeAlias = Callable[[Sequence[float]], tuple[float, ...]]
"""From values of the variables to the results of a program."""

SIGNS = {
    "add": "{} + {}",
    "subtract": "{} - {}",
    "multiply": "{} * {}",
    "divide": "{} / {}",
    "negative": "-{}",
    "positive": "{}",
}
"""How the steps with a sign of their own are written."""

FUNCTIONS: dict[str, Callable[..., float]] = {
    "cos": math.cos,
    "sin": math.sin,
    "tan": math.tan,
    "arccos": math.acos,
    "arcsin": math.asin,
    "arctan": math.atan,
    "arctan2": math.atan2,
    "power": math.pow,
}
"""What the others call."""

_FORMS = SIGNS | {
    name: f"{name}({{}}, {{}})" if name in {"arctan2", "power"} else f"{name}({{}})" for name in FUNCTIONS
}


def compiled(program: Program) -> Play:
    """The function that plays a program over floats.

    It takes as many numbers as the program has variables, radians and metres, and gives all results, none of them a
    minus zero. Where a step has no value it raises ValueError, ZeroDivisionError or OverflowError, as `math` does.
    """
    constants: dict[float, int] = {}
    text = source(program, constants)
    names: dict[str, object] = {f"k{number:d}": float(value) for value, number in constants.items()}
    exec(text, {"__builtins__": {}, **FUNCTIONS, **names}, names)  # noqa: S102  see above: no text of anybody is in it
    return names["play"]  # type: ignore[return-value]


def source(program: Program, constants: dict[float, int]) -> str:
    """The text of the function.

    Args:
        program: What to play.
        constants: Where to put the constants, each with its number: they are `k0`, `k1` ... in the text.
    """

    def spelled(operand: Register | float) -> str:
        if isinstance(operand, int):
            return f"r{operand:d}"
        return f"k{constants.setdefault(operand, len(constants)):d}"

    lines = []
    for step in program.instructions:
        *read, written = step.operands
        lines.append(f"  {spelled(written)} = {_FORMS[step.ufunc].format(*map(spelled, read))}")
    results = range(program.inputs.start)
    found = [spelled(program.constants[k]) if k in program.constants else f"{spelled(k)} + 0.0" for k in results]
    taken = [spelled(k) for k in range(program.inputs.start, program.inputs.stop)]
    # a default is a name of the function's own, which is found faster than one of the module
    handed = [f"{name}={name}" for name in (*FUNCTIONS, *(f"k{number:d}" for number in constants.values()))]
    head = f"def play(q, {', '.join(handed)}):"
    return "\n".join((head, f"  [{', '.join(taken)}] = q", *lines, f"  return ({''.join(f'{e}, ' for e in found)})"))
