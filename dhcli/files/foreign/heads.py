"""The heads of a DH table in a file: which column is which, in which unit, and what they say about the convention."""

from __future__ import annotations

from collections.abc import Container, Sequence

from dhcli.frozen import frozen
from dhcli.kinematics.conventions import COLUMNS, Convention, column_of
from dhcli.notation.names import canonical, parts
from dhcli.notation.quantity import ANGLE_UNITS, LENGTH_UNITS
from dhcli.regex import regex

LONGEST = 4000
"""Letters of a line that may be a row of heads."""

_SIGNS = ("&", "|", "\t", ";", ",")
_LATEX_END = regex(r"\\\\.*|^\s*\\(?:hline|(?:top|mid|bottom)rule)\s*")
"""What stands around the cells of a row in LaTeX."""
_IN_REMARK = regex(r"[:=\[(] ?(?P<heads>[^:=\[\]]{7,200}[^:=\[\]) ])")
"""In a remark the heads may stand behind words, `# columns: a, alpha, d, theta`, or in brackets."""
_UNIT = regex(r"(?P<name>[^\[(]*)[\[(]\s*(?P<unit>[^\])]*?)\s*[\])]?\s*")
COUNTED = regex(r"(?:[^\W\d]{1,20}[ _.-]?|[0-9]{1,3} ?(?:-|->|→) ?)?([0-9]{1,3})")
"""The number of a row, or its name with a number: `2`, `L2`, `link 2`, `1-2`."""
_INDEX = regex(r"(?<=\w)[\[(] ?([ijn](?: ?[-−] ?1)?) ?[\])]")  # noqa: RUF001  a minus sign
"""The index of a head in brackets: `alpha(i-1)`."""
_WORDS = {
    "link length": "a",
    "length": "a",
    "link twist": "alpha",
    "twist": "alpha",
    "link offset": "d",
    "joint angle": "theta",
    "angle": "theta",
    "offset": "offset",
    **dict.fromkeys(("joint offset", "theta offset", "theta_offset", "joint_offset", "q_offset"), "offset"),
    "beta": "beta",
    "type": "kind",
    "joint type": "kind",
    "kind": "kind",
    "sigma": "kind",
    **dict.fromkeys(("lower", "lower limit", "min", "minimum", "qmin", "q_min", "theta_min", "qlim_min"), "lower"),
    **dict.fromkeys(("upper", "upper limit", "max", "maximum", "qmax", "q_max", "theta_max", "qlim_max"), "upper"),
    **dict.fromkeys(("range", "joint range", "limits", "joint limits", "motion range", "working range"), "range"),
}
_BESIDES = frozenset(("mass", "weight", "center", "centre", "com", "cog", "dynamics", "inertia", "speed", "velocity"))
_BESIDES |= {"torque", "effort", "motor", "gear", "comment", "comments", "remark", "remarks", "note", "notes"}
"""Words in heads of columns that say nothing of where links are."""
_NUMBERING = regex(r"(?:link|joint|axis|frame|row)?s?[ _]?(?:i|j|n|no\.?|nr\.?|number|#|name)?")
_KNOWN = frozenset((*COLUMNS, *_WORDS.values(), ""))


@frozen
class Heads:
    """The heads of a table.

    Attributes:
        line: Number of their line, from 1.
        sign: What stands between cells.
        columns: What each column holds: a, alpha, d, theta, offset, kind, or nothing of interest.
        units: The unit of each column; empty where none is said.
        convention: What the indices say: modified where a and alpha have i-1.
        besides: Heads of columns that say nothing of where links are.
    """

    line: int
    sign: str
    columns: tuple[str, ...]
    units: tuple[str, ...]
    convention: Convention | None
    besides: tuple[str, ...] = ()


def heads_of(text: str) -> Heads | None:
    """The heads in a text: its first line that names all four columns; in a page, of the first table that has them."""
    lines = text.split("\n")
    for number, line in enumerate(lines, 1):
        stripped = line.strip()
        if not stripped or len(stripped) > LONGEST:
            continue
        found = _heads(stripped, number, "".join(lines[number : number + 1]).split())
        if found is not None:
            return found
    return None


def needed(columns: Container[str]) -> Sequence[str]:
    """The columns that a table must have: all four, or an offset in the place of theta, which it is added to."""
    return COLUMNS[:-1] if "offset" in columns and "theta" not in columns else COLUMNS


def cells_of(line: str, sign: str) -> list[str]:
    """The cells of a line, without quotes and the bars at its ends."""
    line = line.replace("\r", " ").strip()  # csv refuses it within a line
    if sign == "|":
        line = line.removeprefix("|").removesuffix("|")
        return [cell.strip().strip("`$").strip() for cell in line.split("|")]
    if sign == "&":
        return [cell.replace("$", "").strip() for cell in _LATEX_END.sub("", line).split("&")]
    if sign == " ":
        return line.rstrip(",;").split()
    import csv  # most files are none

    return [cell.strip().strip("`$").strip() for cell in next(csv.reader([line], delimiter=sign), [])]


def _heads(line: str, number: int, below: Sequence[str]) -> Heads | None:
    """The heads in a line, if it has them; a word before others is one where a number stands below it."""
    remark = line.lstrip("#%/ ")
    texts = [line] if remark == line else [remark, *(match["heads"] for match in _IN_REMARK.finditer(remark))]
    for text, sign in ((text, sign) for text in texts for sign in (*_SIGNS, " ") if sign in text or sign == " "):
        cells = cells_of(text, sign)
        if len(cells) < len(COLUMNS):
            continue
        found = [named(cell) for cell in cells]
        columns = tuple(one.column for one in found)
        known = columns[1:] if len(below) == len(columns) and COUNTED.fullmatch(below[0]) else columns
        if all(columns.count(column) == 1 for column in needed(columns)) and (sign != " " or set(known) <= _KNOWN):
            besides = tuple(cell for cell, one in zip(cells, found, strict=True) if one.is_beside)
            return Heads(number, sign, columns, tuple(one.unit for one in found), _convention(found), besides)
    return None


@frozen
class Named:
    """What one head says: its column, or its own text where it is none that is known."""

    column: str
    unit: str = ""
    has_index: bool = False
    before: bool = False
    is_beside: bool = False


def named(head: str) -> Named:
    """The column, the unit and the index of a head such as `α_{i-1} [deg]`."""
    head = _INDEX.sub(r"_{\1}", head)
    match = _UNIT.fullmatch(head)
    unit = match["unit"] if match else ""
    if match is None or unit not in ANGLE_UNITS | LENGTH_UNITS.keys():
        name, unit = head, ""
    else:
        name = match["name"]
    name = name.strip().strip("*").replace("−", "-")  # noqa: RUF001  a minus sign
    name = "beta" if parts(canonical(name))[0] == "beta" else name
    if name.lower() in _WORDS:
        return Named(_WORDS[name.lower()], unit)
    if _NUMBERING.fullmatch(name.lower()):
        return Named("")
    if _BESIDES.intersection(name.lower().split()):
        return Named("", is_beside=True)
    column, before = column_of(name)
    return Named(column or name, unit, len(name) > len(column), before)


def _convention(named: Sequence[Named]) -> Convention | None:
    """What the indices of a and alpha say."""
    links = [one for one in named if one.column in ("a", "alpha")]
    if all(one.before for one in links):
        return Convention.MODIFIED
    said = all(one.has_index for one in named if one.column in COLUMNS) and not any(one.before for one in links)
    return Convention.STANDARD if said else None
