"""A derivation as a C function that fills in every solution."""

from __future__ import annotations

import re
from dataclasses import replace
from fractions import Fraction

from dhcli.kinematics.inverse.derivation import Derivation
from dhcli.kinematics.inverse.derive_rules import Step
from dhcli.notation.styles import identifier
from dhcli.notation.tree import ZERO, Call, Expr, Power, Product, Sum
from dhcli.notation.walk import children
from dhcli.render.code.derivation import Spelled, entries_used, joints_found, lengths_used, spelled_steps
from dhcli.render.look import Look
from dhcli.safe import comment

_WHOLE = re.compile(r"(?<![\w.])(?<![eE][-+])(\d+)(?![\w.])")
_KEYWORDS = frozenset(
    (
        *("auto", "break", "case", "char", "const", "continue", "default", "do", "double", "else", "enum", "extern"),
        *("float", "for", "goto", "if", "inline", "int", "long", "register", "restrict", "return", "short", "signed"),
        *("sizeof", "static", "struct", "switch", "typedef", "union", "unsigned", "void", "volatile", "while"),
        *("T", "solutions", "found", "cosine", "pi", "y0", "y1", "yn", "j0", "j1", "jn"),
    )
)
"""Words that no length may be called in this file: those of C, its Bessel functions, and those used here."""


def derivation_c(result: Derivation, _look: Look) -> str:
    """A function of the pose and the lengths that fills in all solutions and returns how many there are."""
    joints = joints_found(result)
    lengths = [_name(length) for length in lengths_used(result)]
    given = "".join(f"double {name}, " for name in lengths)
    said = f"Every solution of {result.robot.name}, a row each: radians and metres, in joint order."
    lines = [
        "#include <math.h>",
        "",
        comment(said, "//").rstrip(),
        comment(f"Returns how many there are, at most {result.branches}.", "//").rstrip(),
        f"int inverse(const double T[4][4], {given}double solutions[][{len(joints)}])",
        "{",
        "    const double pi = 3.14159265358979323846;",
        *(f"    const double {name} = T[{row - 1}][{column - 1}];" for name, row, column in entries_used(result)),
        "    int found = 0;",
    ]
    margin, ends = "    ", list[str]()
    exact = replace(result, steps=tuple(map(_in_products, result.steps)))
    for one in spelled_steps(exact, "matlab"):
        body, opened = _assigned(one, _name(one.name), margin)
        lines += body
        if opened:
            ends.append(f"{margin}}}")
            margin += "    "
    lines += [f"{margin}solutions[found][{k}] = {_name(name)};" for k, name in enumerate(joints)]
    lines += [f"{margin}found += 1;", *reversed(ends), "    (void)pi;", "    return found;", "}"]
    return "\n".join(lines) + "\n"


def _assigned(one: Spelled, name: str, margin: str) -> tuple[list[str], bool]:
    """The lines that give an unknown its values, and whether they open a loop."""
    step, value, spread = one.step, _words(one.value), _words(one.spread)
    if not step.two:
        return [f"{margin}const double {name} = {value};"], False
    inner = margin + "    "
    lines = [f"{margin}for (int choice_{name} = 0; choice_{name} < 2; choice_{name} += 1) {{"]
    if step.two == "opposite":
        return [*lines, f"{inner}const double {name} = {value} + choice_{name}*pi;"], True
    if isinstance(step.spread, Call):
        lines += [f"{inner}const double cosine = {spread.removeprefix('acos')};"]
        lines += [f"{inner}if (fabs(cosine) > 1)", f"{inner}    continue;"]
        spread = "acos(cosine)"
    elif one.square:
        lines += [f"{inner}if ({_words(one.square)} < 0)", f"{inner}    continue;"]
    before = "" if step.value == ZERO else f"{value} + "
    return [*lines, f"{inner}const double {name} = {before}(choice_{name} ? -1 : 1)*{spread};"], True


def _name(name: str) -> str:
    plain = identifier(name)
    return f"{plain}_" if plain in _KEYWORDS else plain


def _words(text: str) -> str:
    """Whole numbers as floating ones, for 1/2 is 0 in C; a name that C has gets an underscore."""
    text = _WHOLE.sub(r"\1.0", text)
    return re.sub(r"[A-Za-z_]\w*", lambda word: f"{word[0]}_" if word[0] in _KEYWORDS - {"pi"} else word[0], text)


def _in_products(step: Step) -> Step:
    """A step with products for powers, for C has no sign for them."""
    return replace(
        step,
        value=_multiplied(step.value),
        spread=None if step.spread is None else _multiplied(step.spread),
        condition=None if step.condition is None else _multiplied(step.condition),
    )


def _multiplied(expr: Expr) -> Expr:
    if not children(expr):
        return expr
    if isinstance(expr, Call):
        return Call(expr.function, tuple(map(_multiplied, expr.arguments)))
    parts = tuple(map(_multiplied, children(expr)))
    if isinstance(expr, Sum):
        return Sum(parts)
    if isinstance(expr, Product):
        flat = [factor for part in parts for factor in (part.factors if isinstance(part, Product) else (part,))]
        return Product(tuple(flat))
    base, exponent = parts[0], expr.exponent if isinstance(expr, Power) else Fraction(1)
    if exponent.denominator == 1 and abs(exponent) > 1:
        one = base if exponent > 0 else Power(base, Fraction(-1))
        return Product((one,) * abs(exponent.numerator))
    return Power(base, exponent)
