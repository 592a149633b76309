"""Words that are no names: the functions that are read, those that are not, and units that nobody here measures in.

A word of several letters that means nothing must never become a factor: `abs(-3)` is not `-3*abs`, `3 km` not
three times a length called km, and `factorial(10**7)` no product.
"""

from __future__ import annotations

from collections.abc import Iterable

from dhcli.errors import nearest
from dhcli.notation.dimensions import UNITS
from dhcli.notation.names import GREEK_NAMES, canonical, parts

FUNCTIONS = (
    {name: name for name in ("cos", "sin", "tan", "sqrt", "acos", "asin", "atan", "atan2", "cosd", "sind")}
    | {
        "arccos": "acos",
        "arcsin": "asin",
        "arctan": "atan",
        "arctan2": "atan2",
    }
    | {
        written: name
        for name in ("cos", "sin", "tan", "sqrt", "acos", "asin", "atan")
        for written in (name.capitalize(), name.upper())
    }
    | {"ArcCos": "acos", "ArcSin": "asin", "ArcTan": "atan", "Atan2": "atan2"}
)
"""Functions by the names people write, in capitals as spreadsheets do; their ATAN2 takes x first, and is refused."""

_UNREAD = {
    "abs": "write the number without its sign",
    "sec": "write 1/cos(theta1)",
    "csc": "write 1/sin(theta1)",
    "cot": "write cos(theta1)/sin(theta1)",
    "pow": "write a1^2",
    "hypot": "write sqrt(a1^2 + a2^2)",
    "sqr": "write a1^2, or sqrt(a1) for the root",
    "radians": "write 30° or 0.5 rad",
    "degrees": "write 30° or 0.5 rad",
    "deg2rad": "write 30° or 0.5 rad",
    "rad2deg": "write 30° or 0.5 rad",
    "tand": "write tan(30°)",
    "acosd": "write acos(0.5)",
    "asind": "write asin(0.5)",
    "atand": "write atan(0.5)",
    "atan2d": "write atan2(1, 2)",
    "ATAN2": "a spreadsheet has x first: write atan2(y, x)",
} | dict.fromkeys(
    (
        *("exp", "ln", "lg", "log", "log2", "log10", "sinh", "cosh", "tanh", "asinh", "acosh", "atanh", "sinc", "sgn"),
        *("sign", "floor", "ceil", "round", "trunc", "fix", "min", "max", "mod", "rem", "sum", "prod", "factorial"),
        *("norm", "det", "transpose", "cbrt", "Abs", "Exp", "Log", "arccot", "arcsec", "acot"),
    ),
    "",
)
"""Functions that formulas of robots do without, each with what to write instead where there is something."""

_NO_NUMBERS = frozenset(("nan", "inf", "infinity", "infty", "none", "null"))

FOREIGN_UNITS = {
    **dict.fromkeys(("km", "kilometre", "kilometer", "kilometres", "kilometers"), "write 1000 m"),
    **dict.fromkeys(("dm", "decimetre", "decimeter"), "write 10 cm"),
    **dict.fromkeys(("um", "micron", "microns", "nm"), "write 0.001 mm"),
    **dict.fromkeys(("millimetre", "millimeter", "millimetres", "millimeters"), "write mm"),
    **dict.fromkeys(("centimetre", "centimeter", "centimetres", "centimeters"), "write cm"),
    **dict.fromkeys(("metre", "meter", "metres", "meters"), "write m"),
    **dict.fromkeys(("inches", "ft", "foot", "feet", "yd", "yard", "yards", "mil", "mils"), "write in, or mm"),
    **dict.fromkeys(("mrad", "grad", "gon", "turn", "turns", "rev", "revs", "arcmin", "arcsec"), "write ° or rad"),
    **dict.fromkeys(("kg", "ms", "sec", "Nm", "Hz"), ""),
}
"""Units that people write and that are not read, with what to write instead."""


def is_usual(name: str) -> bool:
    """Whether a name looks like one in a formula: a letter or a Greek letter, alone or with an index, or `px`."""
    stem, index = parts(name)
    if stem in GREEK_NAMES or len(stem) == 1:
        return True
    return len(stem) == 2 and stem[1] in "xyz" and not index  # noqa: PLR2004  px, py, pz


def refusal(word: str, known: Iterable[str], *, called: bool = False, measured: bool = False) -> tuple[str, str]:
    """Why a word, behind a number or in front of a bracket, can be no name, with a hint; empty if it may."""
    if word.lower() in _NO_NUMBERS:
        return f"{word} is no number that a robot can have", ""
    if measured and word in FOREIGN_UNITS:
        return f"{word} is not a unit that is read", FOREIGN_UNITS[word] or "units: mm, cm, m, in, deg, rad"
    if word in _UNREAD:
        return f"{word} is a function that is not read", _UNREAD[word] or nearest_meaning(word, known)
    if called and not is_usual(word):
        return f"{word} is not a function that is known", nearest_meaning(word, known)
    return "", ""


def nearest_meaning(word: str, known: Iterable[str]) -> str:
    """A hint at the function, the unit or the name that a word may have meant; the functions there are if none."""
    candidates = (*known, *dict.fromkeys(FUNCTIONS.values()), *sorted(UNITS - {"°", "m"}), "pi")
    found = nearest(canonical(word), candidates)
    if found:
        return "did you mean " + " or ".join(dict.fromkeys(found)) + "?"
    return "functions: " + ", ".join(dict.fromkeys(FUNCTIONS.values()))
