"""A program played over arrays of other libraries, each step by their own functions: JAX, PyTorch and their like.

Nothing here looks at a value, so that what is played can be traced, compiled and differentiated by them.
"""

from __future__ import annotations

import operator
import sys
from collections.abc import Callable, Sequence
from typing import Any, TypeAlias

from dhcli.algebra.program import Program
from dhcli.notation.functions import FUNCTIONS

Array: TypeAlias = Any
"""An array of any library that array-api-compat knows, or what it traces in the place of one."""

Namespace: TypeAlias = Any
"""The functions of that library, by the names of the array API."""

_SIGNS: dict[str, Callable[..., Any]] = {
    "add": operator.add,
    "subtract": operator.sub,
    "multiply": operator.mul,
    "divide": operator.truediv,
    "power": operator.pow,
    "negative": operator.neg,
    "positive": lambda column: column,
}
"""Steps with a sign of their own, which take numbers of Python beside arrays without changing their kind."""


def library_of(array: object) -> str:
    """The library that an array is of, `jax`; empty for numpy's own arrays and for what is no array."""
    name = type(array).__module__.partition(".")[0]
    if name == "numpy":
        return ""
    torch = sys.modules.get("torch")
    is_array = hasattr(array, "__array_namespace__") or (torch is not None and isinstance(array, torch.Tensor))
    return {"jaxlib": "jax"}.get(name, name) if is_array else ""


def play(program: Program, variables: Array, xp: Namespace) -> Array:
    """The results of a program.

    Args:
        program: What to play, with cosines and sines: those of half angles have no derivative at 180°.
        variables: Values of the variables, shape (..., variables).
        xp: The functions of its library.

    Returns:
        Shape (..., results), of the same library, kind and device.
    """
    registers: dict[int, Array] = dict(enumerate(_columns(variables), program.inputs.start))
    for step in program.instructions:
        *read, written = step.operands
        function = _SIGNS.get(step.ufunc) or getattr(xp, FUNCTIONS.get(step.ufunc, step.ufunc))
        registers[int(written)] = function(*(registers[o] if isinstance(o, int) else o for o in read))
    like = xp.sum(variables, axis=-1)  # for its shape, kind and device; there may be no variable
    registers |= {register: xp.full_like(like, value) for register, value in program.constants.items()}
    return xp.stack([registers[k] for k in range(program.inputs.start)], axis=-1)


def _columns(variables: Array) -> Sequence[Array]:
    """Each variable by itself, shape (...)."""
    return [variables[..., k] for k in range(variables.shape[-1])]
