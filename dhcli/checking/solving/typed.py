"""The formula for one joint out of a derivation, and as it may be typed."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

from dhcli.errors import RobotError
from dhcli.kinematics.inverse.derivation import Derivation
from dhcli.kinematics.inverse.derive_rules import Step
from dhcli.kinematics.inverse.derive_terms import name_of
from dhcli.notation.tree import PI, ZERO, Call, Expr, Power, Product, Sum, Symbol, add, negate
from dhcli.notation.walk import children, put_for
from dhcli.notation.writer import write


def formula_of(derivation: Derivation, joints: tuple[str, ...]) -> Step:
    """The step that finds a joint or a sum of joints; a sum found before stands in it with its own formula.

    Raises:
        RobotError: No step finds it.
    """
    sums: dict[str, Step] = {}
    for step in derivation.steps:
        own = (step.atom,) if isinstance(step.atom, str) else tuple(name for name, _ in step.atom)
        plain = isinstance(step.atom, str) or all(factor == 1 for _, factor in step.atom)
        if own == joints and plain:
            if step.rule != "SUM":
                return step
            for name, whole in sums.items():
                value = put_for(step.value, {Symbol(name): whole.value})
                if value != step.value:
                    return replace(step, value=value, spread=whole.spread, two=whole.two)
            return step
        sums[name_of(step.atom)] = step
    raise RobotError(f"no step of the derivation finds {' + '.join(joints)}")


def values_of(step: Step) -> tuple[Expr, ...]:
    """Every value that a step has."""
    if step.spread is not None:
        return add(step.value, step.spread), add(step.value, negate(step.spread))
    return (step.value, add(step.value, PI)) if step.two else (step.value,)


def typed_text(derivation: Derivation, joints: tuple[str, ...]) -> str:
    """The formula for a joint as it may be typed: `±acos(...)`, or two values."""
    step, writing = formula_of(derivation, joints), derivation.robot.writing
    value = write(with_roots(step.value), "short", writing)
    if step.spread is not None:
        spread = write(with_roots(step.spread), "short", writing)
        return f"±{spread}" if step.value == ZERO else f"{value} ± {spread}"
    if step.two != "opposite":
        return value
    if isinstance(step.value, Call) and step.value.function == "atan2":
        return f"{value}, {write(Call('atan2', tuple(map(negate, step.value.arguments))), 'short', writing)}"
    return f"{value}, {write(add(step.value, PI), 'short', writing)}"


def exprs_of(derivation: Derivation, joints: tuple[str, ...]) -> tuple[Expr, ...]:
    """The expressions in the formula for a joint."""
    step = formula_of(derivation, joints)
    return (step.value,) if step.spread is None else (step.value, step.spread)


def with_roots(expr: Expr) -> Expr:
    """An expression with `1/sqrt(x)` for x to the power -1/2, which nobody writes."""
    if not children(expr):
        return expr
    if isinstance(expr, Call):
        return Call(expr.function, tuple(map(with_roots, expr.arguments)))
    parts = tuple(map(with_roots, children(expr)))
    if isinstance(expr, Power):
        if expr.exponent.denominator == 2 and expr.exponent < 0:  # noqa: PLR2004
            return Power(Power(parts[0], Fraction(1, 2)), Fraction(expr.exponent.numerator))
        return Power(parts[0], expr.exponent)
    return Sum(parts) if isinstance(expr, Sum) else Product(parts)
