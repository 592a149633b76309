"""Answers made of right ones, seeded: rewritten, on one branch only, wrong, made of nothing, or torn."""

from __future__ import annotations

import re
from collections.abc import Callable
from random import Random

Mutation = Callable[[str, Random], str]

_TRIG = re.compile(r"(cos|sin)\(([^()]*)\)")
_NAME = re.compile(r"(?<![\w.])(?:[ad]\d|l\d|theta\d)(?!\w)")
_SIGN = re.compile(r"(?<=\S) [+-] (?=\S)")


def _at_one(pattern: re.Pattern[str], text: str, draw: Random, change: Callable[[re.Match[str]], str]) -> str:
    """One match of a pattern changed; the text as it is where there is none."""
    found = list(pattern.finditer(text))
    if not found:
        return text
    match = draw.choice(found)
    return text[: match.start()] + change(match) + text[match.end() :]


def _trig(forms: dict[str, str]) -> Mutation:
    return lambda text, draw: _at_one(_TRIG, text, draw, lambda m: forms[m[1]].format(a=m[2]))


def _name(form: str, *, of: str = "") -> Mutation:
    pattern = re.compile(rf"(?<![\w.]){of}\d(?!\w)") if of else _NAME
    return lambda text, draw: _at_one(pattern, text, draw, lambda m: form.format(n=m[0]))


def _whole(form: str) -> Mutation:
    return lambda text, _draw: form.format(t=text)


def _other_name(text: str, draw: Random) -> str:
    known = sorted(set(_NAME.findall(text)))
    return _at_one(_NAME, text, draw, lambda m: draw.choice([n for n in known if n[0] == m[0][0]]))


def _other_sign(text: str, draw: Random) -> str:
    return _at_one(_SIGN, text, draw, lambda m: " - " if m[0] == " + " else " + ")


MUTATIONS: dict[str, Mutation] = {
    # every form of the right expression
    "shifted": _trig({"cos": "sin({a} + pi/2)", "sin": "-cos({a} + pi/2)"}),
    "doubled angle": _trig({"cos": "(1 - 2*sin(({a})/2)^2)", "sin": "2*sin(({a})/2)*cos(({a})/2)"}),
    "full turn": _trig({"cos": "cos({a} - 2*pi)", "sin": "sin({a} + 4*pi)"}),
    "negated": _trig({"cos": "cos(-({a}))", "sin": "(-sin(-({a})))"}),
    "one": _whole("({t})*(sin(theta1)^2 + cos(theta1)^2)"),
    "nothing more": _whole("{t} + a1*(sin(theta1)^2 + cos(theta1)^2 - 1)"),
    "quotient": _trig({"cos": "sin({a})/tan({a})", "sin": "tan({a})*cos({a})"}),
    "arc of both": _name("atan2(sin({n}), cos({n}))", of="theta"),
    "root of a length": _name("sqrt({n}^2)", of="a"),
    "half twice": _whole("({t})/2 + 0.5*({t})"),
    # right on one branch only
    "root": _trig({"cos": "sqrt(1 - sin({a})^2)", "sin": "sqrt(1 - cos({a})^2)"}),
    "minus root": _trig({"cos": "(-sqrt(1 - sin({a})^2))", "sin": "(-sqrt(1 - cos({a})^2))"}),
    "half root": _trig({"cos": "sqrt((1 + cos(2*({a})))/2)", "sin": "sqrt((1 - cos(2*({a})))/2)"}),
    "acos": _name("acos(cos({n}))", of="theta"),
    "asin": _name("asin(sin({n}))", of="theta"),
    "atan": _name("atan(tan({n}))", of="theta"),
    "size": _whole("sqrt(({t})^2)"),
    # wrong
    "sine for cosine": _trig({"cos": "sin({a})", "sin": "cos({a})"}),
    "sign": _other_sign,
    "whole sign": _whole("-({t})"),
    "other name": _other_name,
    "added": _name("({n} + 0.1)"),
    "factor": _whole("1.02*({t})"),
    "a little": _whole("1.0001*({t})"),
    "squared": _name("{n}^2"),
    "forgotten": _name("0"),
    # made of nothing
    "zero": _whole("0*({t})"),
    "zero of decimals": _whole("1e6*(0.1*(cos(theta1) + 1) - 0.1*(1 + cos(theta1)))"),
    "no root": _whole("sqrt(-1) + 0*({t})"),
    "no arc": _whole("acos(2)*({t})"),
    "many decimals": _whole("({t})*(1 + 1000*(0.10 - 0.09))"),
}


def mutated(text: str, draw: Random) -> tuple[str, str]:
    """A formula changed in one way or in two, and what was done."""
    kinds = draw.choices(list(MUTATIONS), k=draw.choice((1, 1, 1, 2)))
    for kind in kinds:
        text = MUTATIONS[kind](text, draw)
    return text, ", ".join(kinds)


def torn(text: str, draw: Random) -> str:
    """A text with a few characters lost, doubled, or put in."""
    for _ in range(draw.randint(1, 4)):
        k = draw.randrange(len(text) + 1)
        text = draw.choice(
            (
                text[:k] + text[k + 1 :],
                text[:k] + text[k : k + 3] + text[k:],
                text[:k] + draw.choice("()[]{}+-*/^=.,;:°'\"\\&|_ \n0123456789θπ√⎡eEcsxyz") + text[k:],
            )
        )
    return text
