"""How near is near enough: physical tolerances, and the digits a student typed."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TypeAlias

from dhcli.checking.verdicts import Verdict
from dhcli.frozen import frozen
from dhcli.notation.angle import magnitude
from dhcli.notation.quantity import LENGTH_UNITS
from dhcli.notation.tree import Expr, Number, Power, Product, Unit, negate

SLACK = 1e-9
ZERO = 1e-12
LEAST_DECIMALS = 2
CLOSE_FACTOR = 10.0

Place: TypeAlias = tuple[int, int]
"""Row and column of an entry, from 0."""

NOT_EXACT = "this task wants exact values, such as sqrt(2)/2 for 0.7071"
"""What is said of a value that is only near the right one where exact ones are asked for."""


@frozen
class Tolerance:
    """Largest errors that count as right.

    Attributes:
        rotation: Of a direction cosine.
        position: Of a length [m]; None for a thousandth of the robot's size.
        angle: Of an angle in a table [degrees].
        decimals: Decimals that the task asks for, or None.
        exact: Whether only exact values count, `sqrt(2)/2` and not 0.7071.
    """

    rotation: float = 1e-3
    position: float | None = None
    angle: float = 0.05
    decimals: int | None = None
    exact: bool = False


DEFAULT = Tolerance()


def judge(typed: float, truth: float, tolerance: float) -> Verdict:
    """A number against the truth: RIGHT on a closed interval, CLOSE within ten times it, else WRONG."""
    error = abs(typed - truth)
    if error <= tolerance * (1 + SLACK):
        return Verdict.RIGHT
    return Verdict.CLOSE if error <= CLOSE_FACTOR * tolerance * (1 + SLACK) else Verdict.WRONG


def typed_decimals(expr: Expr) -> int | None:
    """Decimals of an entry that is a plain decimal number, or None."""
    number = expr if isinstance(expr, Number) else negate(expr)
    return number.places if isinstance(number, Number) else None


def without_unit(expr: Expr, unit: float) -> tuple[Expr, float]:
    """A typed length, or an area, as its number and the metres in its unit; a bare one is in that of the sheet."""
    if isinstance(expr, Product) and len(expr.factors) == 2:  # noqa: PLR2004  a number and its unit
        number, measure = expr.factors
        base, power = (measure.base, measure.exponent) if isinstance(measure, Power) else (measure, 1)
        if isinstance(base, Unit) and base.name in LENGTH_UNITS:
            return number, float(LENGTH_UNITS[base.name] ** power)
    return expr, unit


def is_rounding_of(expr: Expr, truth: float, least: int = LEAST_DECIMALS) -> bool:
    """Whether an entry is the truth rounded or cut off to the decimals typed, so many of them significant."""
    places = typed_decimals(expr)
    if places is None or not isinstance(expr, Number) or significant_decimals(expr) < least:
        return False
    unit = 10.0**-places
    typed = float(expr.value)
    rounded = abs(typed - truth) <= unit / 2 * (1 + SLACK)
    cut = typed * truth >= 0 and -SLACK <= abs(truth) - abs(typed) < unit
    return rounded or cut


def significant_decimals(expr: Expr) -> int:
    """Decimals typed, leading zeros of a number below 1 left out: two in 0.70 and in 0.070, one in 0.05, else none."""
    places, number = typed_decimals(expr), expr if isinstance(expr, Number) else negate(expr)
    if places is None or not isinstance(number, Number):
        return 0
    size = magnitude(number.value)
    scaled = size * 10**places
    digits = str(int(scaled))
    return places if size >= 1 else min(places, len(digits)) if scaled else 0


def agreeing(numbers: Mapping[Place, tuple[Expr, float]]) -> dict[Place, bool]:
    """Which numbers of an answer are the truth with fewer decimals, and whether each has enough of them.

    Two are enough where one number of the answer has two that are significant; a small one beside it may have zeros
    for them: a student who keeps two decimals writes 0.09. Where none has, nothing is shown.

    Args:
        numbers: What was typed and what is right, in one unit; without the zeros that everybody has.
    """
    most = max((significant_decimals(expr) for expr, _ in numbers.values()), default=0)
    return {
        place: min(typed_decimals(expr) or 0, most) >= LEAST_DECIMALS
        for place, (expr, truth) in numbers.items()
        if is_rounding_of(expr, truth, least=0)
    }
