"""An oracle that knows nothing of dhcli: formulas are read by Python, evaluated in floats, and compared at points."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterator, Mapping
from functools import cache
from random import Random
from types import CodeType

POINTS = 40
NAMES: dict[str, object] = {
    **{name: getattr(math, name) for name in ("cos", "sin", "tan", "acos", "asin", "atan", "atan2", "sqrt", "pi")},
    "__builtins__": {},
}
FUNCTIONS = frozenset(NAMES)
_WORD = re.compile(r"[A-Za-z_]\w*")


@cache
def compiled(text: str) -> CodeType | None:
    """A formula as Python reads it; None if it does not."""
    try:
        return compile(text.replace("^", "**"), "formula", "eval")
    except (SyntaxError, ValueError):
        return None


def value(text: str, at: Mapping[str, float]) -> float:
    """The value of a formula at a point; NaN where it has none."""
    code = compiled(text)
    try:
        found = eval(code, NAMES, dict(at)) if code is not None else math.nan  # noqa: S307  formulas of these tests
    except (ArithmeticError, ValueError, NameError, TypeError):
        return math.nan
    return float(found) if isinstance(found, int | float) else math.nan


def names(text: str) -> frozenset[str]:
    """The names of a formula that need a value."""
    return frozenset(_WORD.findall(text)) - FUNCTIONS


def points(found: frozenset[str], seed: int) -> Iterator[dict[str, float]]:
    """Points all round the circle; names that begin with a Greek letter's name are angles, others lengths."""
    draw = Random(seed)  # noqa: S311  the same each time
    for _ in range(POINTS):
        yield {
            name: draw.uniform(-math.pi, math.pi) if name.startswith(("theta", "alpha")) else draw.uniform(0.2, 1.3)
            for name in sorted(found)
        }


def close(one: float, other: float) -> bool:
    """Whether two numbers are the same."""
    return abs(one - other) <= 1e-8 * max(1.0, abs(one), abs(other))


def same_turn(one: float, other: float) -> bool:
    """Whether two angles are the same modulo a full turn."""
    return abs(math.remainder(one - other, math.tau)) <= 1e-8


def agreement(typed: str, right: str, same: Callable[[float, float], bool] = close, seed: int = 1) -> float:
    """At which share of the points where the right formula has a value another one has the same."""
    found = [(value(typed, at), value(right, at)) for at in points(names(typed) | names(right), seed)]
    told = [(one, other) for one, other in found if math.isfinite(other)]
    return sum(math.isfinite(one) and same(one, other) for one, other in told) / len(told) if told else math.nan


def distance(typed: str, right: str, seed: int = 1) -> float:
    """How far two formulas are apart at most, as a share of the size of the right one."""
    found = [(value(typed, at), value(right, at)) for at in points(names(typed) | names(right), seed)]
    size = max((abs(other) for _, other in found), default=0.0)
    apart = [abs(one - other) for one, other in found]
    return math.inf if not all(map(math.isfinite, apart)) or not size else max(apart) / size
