"""How the pieces of an expression are spelled in each notation, and which joint angles have a short index."""

from __future__ import annotations

import keyword
from collections.abc import Callable, Mapping
from dataclasses import field

from dhcli.frozen import frozen
from dhcli.notation.names import GREEK_NAMES, natural_key, parts
from dhcli.regex import regex


@frozen
class Style:
    """How the pieces of an expression are spelled in one notation.

    Attributes:
        name: What the user calls it.
        times: The sign between factors.
        caret: The sign before an exponent.
        pi: The number π.
        root: Format of a square root.
        symbol: Spelling of a name.
        trig: Format of cosine and sine: function name and angle.
        degrees: Format of an angle in degrees, or None to write multiples of π.
        latex: Whether brackets grow and fractions are stacked.
        prefix: What stands before the names of functions.
        functions: Names of functions that the language calls otherwise.
        decimal: Whether numbers that are not whole are decimals, as programs compute them.
        power: Format of a power, base and exponent, where the language has no sign for it.
    """

    name: str
    times: str = "*"
    caret: str = "^"
    pi: str = "pi"
    root: str = "sqrt({})"
    symbol: Callable[[str], str] = str
    trig: str = "{}({})"
    degrees: str | None = "{}°"
    latex: bool = False
    prefix: str = ""
    functions: Mapping[str, str] = field(default_factory=dict)
    decimal: bool = False
    power: str = ""


_DERIVED = regex(r"(?P<p>p)(?P<axis>[xyz])|(?P<stem>[a-z]+?)_?(?P<sum>[0-9]+m[0-9]+)")
"""Names that the formulas of a derivation have besides those of the robot."""

_PYTHON = frozenset(keyword.kwlist)
RESERVED: Mapping[str, frozenset[str]] = {
    "numpy": _PYTHON | {"np"},
    "sympy": _PYTHON | {"E", "I", "N", "O", "Q", "S", "Matrix", "nan", "oo", "zoo"},
    "matlab": frozenset(
        (
            *("break", "case", "catch", "classdef", "continue", "else", "elseif", "end", "for", "function", "global"),
            *("if", "otherwise", "parfor", "persistent", "return", "spmd", "switch", "try", "while"),
            *("i", "j", "eps", "ans", "inf", "nan", "Inf", "NaN", "syms", "true", "false"),
        )
    ),
}
"""Keywords and constants of each language; a name that is one gets an underscore behind it."""

SPOKEN_FOR = frozenset().union(*RESERVED.values())


def identifier(name: str, language: str = "sympy") -> str:
    """A name that a programming language accepts: `alpha_{i-1}` is `alpha_im1`, `lambda` is `lambda_`, `E` is `E_`."""
    plain = plain_name(name)
    return plain + "_" if plain in RESERVED[language] else plain


def plain_name(name: str) -> str:
    """A name in letters, digits and underscores, as all languages spell names."""
    return name.replace("{", "").replace("}", "").replace("-", "m").replace("+", "p").replace(",", "_")


def _in_matlab(name: str) -> str:
    return identifier(name, "matlab")


def _in_numpy(name: str) -> str:
    return identifier(name, "numpy")


def latex_name(name: str) -> str:
    r"""A name as LaTeX sets it: `theta1` is `\theta_{1}`, `shoulder` is upright."""
    stem, subscript = parts(name)
    if found := _DERIVED.fullmatch(name):  # px of a position, theta12m4 for theta1 + theta2 - theta4
        stem, subscript = found["p"] or found["stem"], found["axis"] or found["sum"].replace("m", "-")
    if stem in GREEK_NAMES:
        stem = "\\" + stem
    elif len(stem) > 1:
        stem = rf"\mathrm{{{stem}}}"
    return f"{stem}_{{{subscript}}}" if subscript else stem


STYLES: Mapping[str, Style] = {
    style.name: style
    for style in (
        Style("short"),
        Style("full"),
        Style(
            "latex",
            times=" ",
            pi="\\pi",
            root="\\sqrt{{{}}}",
            symbol=latex_name,
            trig="\\{}\\left({}\\right)",
            degrees="{}^{{\\circ}}",
            latex=True,
        ),
        Style("matlab", symbol=_in_matlab, degrees=None),
        Style("numpy", caret="**", pi="np.pi", symbol=_in_numpy, degrees=None, prefix="np."),
        Style("sympy", caret="**", symbol=identifier, degrees=None),
    )
}
"""The notations by the name the user gives them."""


@frozen
class Joints:
    """The joint angles of a robot, for shorthand: `c12` may stand for cos(theta1 + theta2).

    Attributes:
        order: Every variable in joint order; factors and angles are written in this order.
        index: The angles that have a short index, such as theta2 with `2`.
    """

    order: tuple[str, ...] = ()
    index: Mapping[str, str] = field(default_factory=dict)

    @classmethod
    def of(cls, variables: tuple[str, ...], angles: tuple[str, ...]) -> Joints:
        """Joints of a robot with these variables, some of which are angles.

        An angle has an index if it ends in a digit that no other angle ends in; ten joints and more have none.
        """
        index = {name: parts(name)[1] for name in angles}
        digits = list(index.values())
        return cls(variables, {n: d for n, d in index.items() if len(d) == 1 and d.isdigit() and digits.count(d) == 1})

    def place(self, name: str) -> tuple[int, object]:
        """Sort key of a name: variables in joint order, then everything else in natural order."""
        return (self.order.index(name), ()) if name in self.order else (len(self.order), natural_key(name))


class _AnyThetas(Mapping[str, str]):
    """Where no robot is given, theta1 to theta9 have their digit as index."""

    def __getitem__(self, name: str) -> str:
        stem, index = parts(name)
        if stem != "theta" or len(index) != 1 or not index.isdigit():
            raise KeyError(name)
        return index

    def __iter__(self):  # type: ignore[no-untyped-def]  # noqa: ANN204
        return (f"theta{digit}" for digit in range(1, 10))

    def __len__(self) -> int:
        return 9

    def __repr__(self) -> str:  # in the signature of each result
        return "<theta1 to theta9>"


THETAS = Joints((), _AnyThetas())
"""Joints to write with when no robot is at hand."""
