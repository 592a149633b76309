"""Slips in one step of a derivation: in its arctangents and arccosines, their signs, and what is added to them."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace

from dhcli.checking.diagnosis.result import Slip
from dhcli.kinematics.inverse.derive_rules import Step
from dhcli.notation.tree import ZERO, Call, Expr, Sum, add, multiply, negate, power
from dhcli.notation.walk import put_for, walk

ORDINALS = ("first", "second", "third", "fourth", "fifth", "sixth", "seventh", "eighth")
"""Of the inverse tangents in one formula, of which there are two at most as a rule."""


def slips_in_step(step: Step, name: str) -> Iterator[tuple[Slip, Step]]:
    """What may go wrong in one step."""
    calls = _calls(step, "atan2")
    for k, call in enumerate(calls[: len(ORDINALS)]):
        yield from _in_arctangent(step, name, call, f"the {ORDINALS[k]} atan2" if len(calls) > 1 else "atan2", k)
    if isinstance(step.spread, Call) and step.spread.function == "acos":
        yield from _in_arccosine(step, name, step.spread)
    if step.two:
        words = f"one branch of {name} is left out"
        whole = step.value if step.spread is None else add(step.value, step.spread)
        yield (
            Slip(f"one-branch {name}", words, "how many angles have this cosine, or this tangent?"),
            replace(step, value=whole, spread=None, two=""),
        )
    terms = step.value.terms if isinstance(step.value, Sum) else ()
    for term in terms[1:]:
        if any(isinstance(node, Call) for node in walk(term)):
            other = add(*(negate(one) if one is term else one for one in terms))
            words = f"an angle is added in {name} that has to be subtracted, or the other way round"
            yield (
                Slip(f"angle-sign {name}", words, "draw the triangle: which angle is the larger one?"),
                replace(step, value=other),
            )


def _in_arctangent(step: Step, name: str, call: Call, shown: str, number: int) -> Iterator[tuple[Slip, Step]]:
    y, x = call.arguments
    about = f"{name} {number + 1}" if number else name
    if (call == step.value or step.spread is None) and x != ZERO:
        one = Call("atan", (multiply(y, power(x, -1)),))
        words = f"atan stands for {shown} in {name}: it loses the quadrants where its second argument is negative"
        yield (
            Slip(f"atan-for-atan2 {about}", words, "which quadrants does atan know?"),
            replace(with_other(step, call, one), two=step.two if step.two != "opposite" else ""),
        )
    words = f"the arguments of {shown} in {name} have changed places: the sine comes first"
    yield (
        Slip(f"atan2-swapped {about}", words, "which argument of atan2 belongs to the sine?"),
        with_other(step, call, Call("atan2", (x, y))),
    )
    for slip, changed in _with_signs(step, call, shown, name):
        yield replace(slip, name=f"{slip.name} {about}"), with_other(step, call, changed)


def _with_signs(step: Step, call: Call, shown: str, name: str) -> Iterator[tuple[Slip, Call]]:
    """The other sign of an argument of an atan2; where half a turn more is a value as well, either is the same."""
    y, x = call.arguments
    hint = f"look at the signs in {shown}"
    terms = step.value.terms[1:] if isinstance(step.value, Sum) else ()
    if step.two == "opposite" and ZERO not in (x, y):
        yield (
            Slip("atan2-sign", f"the sign of one argument of {shown} in {name} is turned round", hint),
            _negated(call, 0),
        )
        return
    if y != ZERO and not any(term in (call, negate(call)) for term in terms):  # else that of the angle itself
        words = f"the sign of the first argument of {shown} in {name} is turned round"
        yield Slip("atan2-sign-of-sine", words, hint), _negated(call, 0)
    if x != ZERO:
        words = f"the sign of the second argument of {shown} in {name} is turned round"
        yield Slip("atan2-sign-of-cosine", words, hint), _negated(call, 1)


def _negated(call: Call, at: int) -> Call:
    """A function with the other sign of one of its arguments."""
    arguments = tuple(negate(one) if k == at else one for k, one in enumerate(call.arguments))
    return Call(call.function, arguments)


def _in_arccosine(step: Step, name: str, spread: Call) -> Iterator[tuple[Slip, Step]]:
    words = f"the sign in the law of cosines is wrong in {name}: the inner angle of the triangle is 180° less it"
    yield (
        Slip(f"cosine-sign {name}", words, "is it the inner angle of the triangle or the outer one?"),
        replace(step, spread=Call("acos", (negate(spread.arguments[0]),))),
    )
    if step.value != ZERO:
        words = f"{name} is computed without the offset: only the direction of the point was taken"
        turned = Call("acos", (ZERO,)) if step.rule == "ONE" else ZERO
        yield (
            Slip(f"offset-left-out {name}", words, "does the arm lie in the plane through the first axis?"),
            replace(step, spread=turned),
        )


def _calls(step: Step, function: str) -> list[Call]:
    exprs = [step.value, *([step.spread] if step.spread is not None else [])]
    found = [node for expr in exprs for node in walk(expr) if isinstance(node, Call) and node.function == function]
    return list(dict.fromkeys(found))


def with_other(step: Step, old: Expr, new: Expr) -> Step:
    """A step with one expression in the place of another."""
    return changed_step(step, lambda expr: put_for(expr, {old: new}))


def changed_step(step: Step, change: Callable[[Expr], Expr]) -> Step:
    """A step with its formula changed, on both sides of its sign."""
    return replace(step, value=change(step.value), spread=None if step.spread is None else change(step.spread))
