"""Slips in one step of a derivation: in its arctangents and arccosines, their signs, and what is added to them."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace

from dhcli.checking.diagnosis.result import Slip
from dhcli.frozen import frozen
from dhcli.kinematics.inverse.derive_rules import Step
from dhcli.notation.tree import ZERO, Call, Expr, Sum, add, multiply, negate, power
from dhcli.notation.walk import put_for, walk

ORDINALS = ("first", "second", "third", "fourth", "fifth", "sixth", "seventh", "eighth")
"""Of the inverse tangents in one formula, of which there are two at most as a rule."""


def slips_in_step(step: Step, name: str) -> Iterator[tuple[Slip, Step]]:
    """What may go wrong in one step."""
    calls = _calls(step, "atan2")
    for k, call in enumerate(calls[: len(ORDINALS)]):
        yield from _in_arctangent(step, call, Arctangent(name, k, len(calls)))
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
            yield angle_sign(name), replace(step, value=other)


@frozen
class Arctangent:
    """One of the inverse tangents in a formula, for the words of slips.

    Attributes:
        name: What the formula is for.
        number: Which it is, from 0.
        count: How many there are.
    """

    name: str
    number: int
    count: int

    @property
    def shown(self) -> str:
        """How it is called."""
        return f"the {ORDINALS[self.number]} atan2" if self.count > 1 else "atan2"

    def slip(self, kind: str) -> Slip:
        """A slip in its arguments, by its kind."""
        words, hint = _IN_ARCTANGENT[kind]
        about = f"{self.name} {self.number + 1}" if self.number else self.name
        return Slip(f"{kind} {about}", words.format(self.shown, self.name), hint.format(self.shown))


SWAPPED, SINE, COSINE, EITHER = "atan2-swapped", "atan2-sign-of-sine", "atan2-sign-of-cosine", "atan2-sign"
_SIGNS = "look at the signs in {}"
_IN_ARCTANGENT = {
    "atan-for-atan2": (
        "atan stands for {} in {}: it loses the quadrants where its second argument is negative",
        "which quadrants does atan know?",
    ),
    SWAPPED: (
        "the arguments of {} in {} have changed places: the sine comes first",
        "which argument of atan2 belongs to the sine?",
    ),
    SINE: ("the sign of the first argument of {} in {} is turned round", _SIGNS),
    COSINE: ("the sign of the second argument of {} in {} is turned round", _SIGNS),
    EITHER: ("the sign of one argument of {} in {} is turned round", _SIGNS),
}


def _in_arctangent(step: Step, call: Call, about: Arctangent) -> Iterator[tuple[Slip, Step]]:
    y, x = call.arguments
    if (call == step.value or step.spread is None) and x != ZERO:
        one = Call("atan", (multiply(y, power(x, -1)),))
        changed = replace(with_other(step, call, one), two=step.two if step.two != "opposite" else "")
        yield about.slip("atan-for-atan2"), changed
    yield about.slip(SWAPPED), with_other(step, call, exchanged(call))
    for kind, other in _with_signs(step, call):
        yield about.slip(kind), with_other(step, call, other)


def _with_signs(step: Step, call: Call) -> Iterator[tuple[str, Call]]:
    """The other sign of an argument of an atan2; where half a turn more is a value as well, either is the same."""
    y, x = call.arguments
    terms = step.value.terms[1:] if isinstance(step.value, Sum) else ()
    if step.two == "opposite" and ZERO not in (x, y):
        yield EITHER, negated(call, 0)
        return
    if y != ZERO and not any(term in (call, negate(call)) for term in terms):  # else that of the angle itself
        yield SINE, negated(call, 0)
    if x != ZERO:
        yield COSINE, negated(call, 1)


def exchanged(call: Call) -> Call:
    """A function of two arguments with these in each other's place."""
    return Call(call.function, call.arguments[::-1])


def negated(call: Call, at: int) -> Call:
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


def angle_sign(name: str) -> Slip:
    """The slip of whoever adds two angles for taking one off the other."""
    words = f"an angle is added in {name} that has to be subtracted, or the other way round"
    return Slip(f"angle-sign {name}", words, "draw the triangle: which angle is the larger one?")


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
