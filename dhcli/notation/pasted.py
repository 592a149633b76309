"""Matrices as screens, programs and papers hold them: what stands around one goes, named entries become one."""

from __future__ import annotations

import json
import re

from dhcli.errors import NotationError, are
from dhcli.notation.commas import Shape, with_points
from dhcli.notation.matrix import bracketed, parse_matrix
from dhcli.notation.screens import equations, plain, with_factor
from dhcli.regex import regex

_LABEL = regex(
    r"\s*(?:\|[^|=\n]{1,9}\||[^=+*/\[\](){},;|<>\n-]|\{[^{}=\n]{0,20}\}|\([^()=\n]{0,20}\)){1,40}=\s*&?\s*(?=[^\s=])"
)
"""`T_03 =`, `{}^{0}_{3}T =`, `p_{x} &=`: names with indices, nothing that computes."""
_NAMED_MATRIX = regex(
    r"\s*(?:[^=\n]{0,200}=){1,4}[\s&]*(?=[^=\n&;,]{0,60}(?:\[|\\begin|\\left|array|np\.|Matrix|matrix))"
)
"""`A B = C D =` before a matrix, with a factor or without."""
_TABS = regex(r" *\t\s*")
_CONTINUED = regex(r"\.\.\.[^\S\n]*(?=\n)")
_SCREEN = regex(r"[⎡⎢⎣][^\n⎡⎢⎣⎤⎥⎦]*[⎤⎥⎦]")
_DECLARED = regex(r"^[^\S\n]*syms\b[^\n]*$", re.MULTILINE)
_ENTRY = regex(
    r"(?:^|[\n,;])[^\S\n]*(?:\{\})?(?:\^\{?[0-9]\}?)?(?:_\{?[0-9]\}?)?([rRnoapPT])_?\{?([1-3]{2}|[xyz])\}?[^\S\n]*&?=\s*&?"
)
"""What stands before an entry in a list of them; no blank lines, or each would be gone through from all before it."""
_BLOCKS = regex(
    r"\s{0,9}R[\w{}]{0,6}\s{0,9}=\s{0,9}(?P<rotation>\[[^=]{1,2000}?\])\s{0,9}[,;]?\s{0,9}(?:and\s{1,9})?"
    r"[pdto][\w{}]{0,6}\s{0,9}=\s{0,9}(?P<position>\[[^=]{1,2000}\](?:\^?\{?T\}?|')?)\s{0,9}"
)
"""Rotation and position beside each other, `R = [...], p = [...]`."""
_POSE, _ROTATION = (4, 4), (3, 3)


class EntriesError(ValueError):
    """A list of entries that makes no matrix: one is missing, or stands there twice."""


def without_label(text: str, shape: Shape | None = None) -> str:
    """A text without `T_03 =` in front, without what a screen shows around a matrix, and without decimal commas.

    Args:
        text: A matrix or a list.
        shape: Its rows and columns, where they are known.
    """
    text = plain(text)
    text = text.lstrip().removeprefix("=") if text.lstrip()[:1] == "=" else text  # as a spreadsheet begins a formula
    lines = _SCREEN.findall(text)
    if lines:
        return "\n".join(lines)
    text = _DECLARED.sub("", _CONTINUED.sub("", text))
    match = _NAMED_MATRIX.match(text) or _LABEL.match(text)
    return _without_tabs(with_points(with_factor(text[match.end() :] if match else text), shape), shape)


def rows_of(text: str, shape: Shape) -> str:
    """A matrix in brackets, where a text is dhcli's JSON or a list of entries such as `r11 = c1`, `px = a1*c1`.

    Raises:
        EntriesError: Entries are missing in the list, or stand in it twice.
    """
    if text.lstrip().startswith("{") and '"matrix"' in text:
        return _from_json(text)
    text = equations(plain(text))
    if shape == _POSE and (blocks := _BLOCKS.fullmatch(text)):
        return _from_blocks(blocks["rotation"], blocks["position"]) or text
    found = list(_ENTRY.finditer(text))
    if len(found) < 2 or text[: found[0].start()].strip():  # noqa: PLR2004  one name is the label of the whole answer
        return text
    ends = [*(match.start() for match in found[1:]), len(text)]
    entries: dict[str, str] = {}
    for match, end in zip(found, ends, strict=True):
        name = _place(match[1].lower(), match[2])
        if name in entries:
            raise EntriesError(f"{name} stands there twice")
        entries[name] = plain(text[match.end() : end].strip()).replace("\n", " ")
    rows = [[f"r{row}{column}" for column in "123"] + [f"p{axis}"] for row, axis in zip("123", "xyz", strict=True)]
    wanted = {_POSE: rows, _ROTATION: [row[:3] for row in rows]}.get(shape)
    if wanted is None:
        return text
    missing = [name for row in wanted for name in row if name not in entries]
    if missing:
        raise EntriesError(f"{', '.join(missing)} {are(len(missing))} missing")
    bottom = [["0", "0", "0", "1"]] if shape == _POSE else []
    return bracketed([*([entries[name] for name in row] for row in wanted), *bottom])


def pose_matrix(text: str) -> str | None:
    r"""A 4x4 matrix in brackets out of whatever stands around it, entries as they were written; None if there is none.

    >>> pose_matrix("T_01 =\n1,0,0,a1\n0,1,0,0\n0,0,1,0\n0,0,0,1\n")
    '[[1, 0, 0, a1], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]'
    """
    try:
        cells = parse_matrix(without_label(rows_of(text, _POSE)))
    except (NotationError, EntriesError):
        return None
    if [len(row) for row in cells] != [4] * 4:
        return None
    return bracketed([[cell.text.strip() for cell in row] for row in cells])


def _without_tabs(text: str, shape: Shape | None) -> str:
    """Rows of a spreadsheet with commas for the tabs between their cells, in which blanks multiply then."""
    if "\t" not in text or set(text) & set(",;&|"):
        return text
    rows = [_TABS.split(line.strip()) for line in text.split("\n") if line.strip()]
    width = len(rows[0])
    is_list = shape is not None and min(shape) == 1 == len(rows)
    wanted = max(shape) if shape and is_list else shape[1] if shape else width
    if any(len(row) != width for row in rows) or width != wanted or width == 1 or (len(rows) == 1 and not is_list):
        return text
    return "\n".join(", ".join(row) for row in rows)


def _from_blocks(rotation: str, position: str) -> str:
    """The pose of `R = [...]` and `p = [...]`, entries as they were written; empty where they are none."""
    try:
        rows, column = ([[cell.text for cell in row] for row in parse_matrix(text)] for text in (rotation, position))
    except NotationError:
        return ""
    shifts = [entry for row in column for entry in row]
    if [len(row) for row in rows] != [3] * 3 or len(shifts) != 3 or min(len(column), len(column[0])) > 1:  # noqa: PLR2004
        return ""
    return bracketed([*([*row, shift] for row, shift in zip(rows, shifts, strict=True)), ["0", "0", "0", "1"]])


def _place(letter: str, index: str) -> str:
    """`r12` for n, o and a as well: ny is r21."""
    if letter in "noa" and index in "xyz":
        return f"r{'xyz'.index(index) + 1}{'noa'.index(letter) + 1}"
    return letter + index


def _from_json(text: str) -> str:
    """The matrix of dhcli's own JSON, with its digits as they stand; the text itself if there is none."""
    try:
        found = json.loads(text, parse_float=str, parse_int=str)
    except (ValueError, RecursionError):
        return text
    rows = found.get("data", found) if isinstance(found, dict) else {}
    rows = rows.get("matrix") if isinstance(rows, dict) else None
    if not isinstance(rows, list) or not all(isinstance(row, list) for row in rows):
        return text
    return bracketed([[str(entry) for entry in row] for row in rows])
