"""Whether an answer that is typed line by line is plainly complete, so that it may be judged."""

from __future__ import annotations

import re

from dhcli.checking.pasted import is_bracketed
from dhcli.notation.brackets import STEPS, depths
from dhcli.regex import regex

_GOES_ON = ("+", "-", "*", "/", "^", "=", ",", ";", "·", "...")
"""What the line of an unfinished answer ends in."""

_HALF = regex(r"\s{0,9}(?:J_?\{?)?(?:v|w|ω|omega|R)[\w}]{0,4}\s{0,9}=", re.IGNORECASE)
"""The name of one half of a Jacobian, or of the rotation of a pose: the other half may come in the next line."""
_NUMBERS = regex(r"[-+−.\d][-+−.\deE/°]{0,40}(?:[ \t]{1,9}[-+−.\d][-+−.\deE/°]{0,40}){1,9}")  # noqa: RUF001


def is_closed(text: str) -> bool:
    """Whether its brackets close, and no operand is still to come."""
    depth = sum(STEPS.get(letter, 0) for letter in text)
    if "\\begin" in text:
        return depth <= 0 and text.count("\\end") >= text.count("\\begin")
    return depth <= 0 and not text.strip().endswith(_GOES_ON)


def is_whole_matrix(text: str, blank: tuple[int, int]) -> bool:
    """Whether all rows of a matrix stand there, or all numbers of a list.

    Args:
        text: What was typed so far.
        blank: Rows and columns of the answer; a list is a row.
    """
    rows, columns = blank
    if not is_closed(text):
        return False
    between = ",;\n" if rows == 1 or "[[" in text else ";\n"
    if _HALF.match(text) and _entries_in(text, between) < (columns if rows == 1 else rows):
        return False
    if _HALF.match(text) and text.count("=") > 1:
        return text.rstrip(" '.").endswith(("]", ")"))
    if rows * columns == 1 or "\\end" in text or text.strip().startswith("[") or ends_in_bracket(text):
        return True
    apart = _outside_brackets(text)
    if rows > 1:
        return rows - 1 == apart.count(";")
    return columns - 1 in (apart.count(","), apart.count(";")) or (
        bool(_NUMBERS.fullmatch(text.strip())) and len(text.split()) == columns
    )


def ends_in_bracket(text: str) -> bool:
    """Whether a text ends in the bracket around several cells, whatever word or name stands before it."""
    bare = text.strip()
    start = min((at for letter in "([" if (at := bare.find(letter)) >= 0), default=-1)
    return start >= 0 and not set(bare[:start]) & set(",;&\n") and is_bracketed(bare[start:])


def _entries_in(text: str, signs: str) -> int:
    """How many pieces stand between signs in the brackets of a text, one bracket behind each name."""
    within = zip(text, depths(text), strict=True)
    return sum(letter in signs and depth == 1 for letter, depth in within) + text.count("=")


def _outside_brackets(text: str) -> str:
    """What of a text stands outside brackets."""
    return "".join(letter for letter, depth in zip(text, depths(text), strict=True) if not depth)
