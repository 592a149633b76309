"""How each part of a figure looks: colours by day and by night, widths, dashes. Every writer reads this table."""

from __future__ import annotations

from typing import NamedTuple


class Ink(NamedTuple):
    """A colour by day and by night."""

    day: str
    night: str


class Look(NamedTuple):
    """The look of a line or an area.

    Attributes:
        fill: The name of the colour inside; empty for none.
        stroke: The name of the colour of the line; empty for none.
        width: Of the line [px].
        dash: Lengths of dashes and gaps [px].
        round: Whether ends and corners are round.
    """

    fill: str = ""
    stroke: str = ""
    width: float = 1.0
    dash: tuple[float, ...] = ()
    round: bool = False


COLOURS = {
    "paper": Ink("#ffffff", "#16181d"),
    "line": Ink("#15171c", "#d9dce3"),
    "metal": Ink("#d6d9de", "#4a4f59"),
    "shine": Ink("#fafafb", "#7b818d"),
    "shadow": Ink("#bcc0c7", "#33373f"),
    "cap": Ink("#f1f2f4", "#6d737e"),
    "ground": Ink("#ffffff", "#1d2026"),
    "hatch": Ink("#a9adb5", "#5a606b"),
    "x": Ink("#c4122f", "#ff7b8a"),
    "y": Ink("#16803c", "#6bd68d"),
    "z": Ink("#1146b4", "#86b1ff"),
    "dim": Ink("#4f535b", "#b3b8c2"),
    "thin": Ink("#9a9ea6", "#737985"),
    "turn": Ink("#8a4b00", "#f0b45c"),
    "hand": Ink("#111111", "#f2f2f2"),
    "theirs": Ink("#7b2fbf", "#c79bff"),
    "theirs-pale": Ink("#cfaef0", "#7a4fb0"),
    "density-1": Ink("#dfe9f7", "#202b3c"),
    "density-2": Ink("#b9d0ee", "#28405f"),
    "density-3": Ink("#86aede", "#325c8d"),
    "density-4": Ink("#4f86c6", "#4b86c4"),
    "density-5": Ink("#2a5f9e", "#8fc0f2"),
    "caption": Ink("#84888f", "#8d939d"),
}

LOOKS = {
    "link": Look("metal"),
    "ground-link": Look("hatch"),
    "ground-sheet": Look("ground", "hatch", 1.2, (), round=True),
    "edge": Look("", "line", 1.2),
    "knob": Look("metal", "line", 1.2),
    "drum": Look("shade", "line", 1.3),
    "ball": Look("shade", "line", 1.3),
    "cap": Look("cap", "line", 1.3),
    "face": Look("metal", "line", 1.2, (), round=True),
    "face-light": Look("cap", "line", 1.2, (), round=True),
    "face-dark": Look("shadow", "line", 1.2, (), round=True),
    "sheet": Look("metal", "line", 1.2, (), round=True),
    "bar": Look("metal", "line", 1.4, (), round=True),
    "wheel": Look("", "line", 1.4),
    "pin": Look("paper", "line", 1.6),
    "pin-ground": Look("paper", "line", 1.3, (), round=True),
    "ground-line": Look("", "line", 1.5),
    "hatch-line": Look("", "line", 0.9),
    "plate": Look("ground", "line", 1.1),
    "hatch": Look("", "hatch", 0.8),
    "break": Look("", "line", 1.5, (), round=True),
    "hand": Look("", "hand", 5.0, (), round=True),
    "halo": Look("", "paper", 4.2),
    "x": Look("", "x", 2.0),
    "y": Look("", "y", 2.0),
    "z": Look("", "z", 2.0),
    "x-head": Look("x"),
    "y-head": Look("y"),
    "z-head": Look("z"),
    "x-ring": Look("paper", "x", 1.8),
    "y-ring": Look("paper", "y", 1.8),
    "z-ring": Look("paper", "z", 1.8),
    "dim": Look("", "dim", 1.1, (4.5, 2.8)),
    "dim-head": Look("dim"),
    "slide": Look("", "turn", 1.2, (4.5, 2.8)),
    "slide-head": Look("turn"),
    "extension": Look("", "thin", 0.8),
    "leader": Look("", "thin", 0.8),
    "turn": Look("", "turn", 1.5, (), round=True),
    "turn-head": Look("turn"),
    "axis": Look("", "line", 0.9, (12.0, 3.0, 2.0, 3.0)),
    "axis-dot": Look("line"),
    "trace": Look("", "x", 1.6),
    "theirs": Look("", "theirs", 2.4, (), round=True),
    "theirs-axis": Look("", "theirs-pale", 9.0),
    "theirs-axis-head": Look("theirs-pale"),
    "theirs-ring": Look("", "theirs-pale", 4.5),
    "theirs-mark": Look("", "theirs", 1.8),
    "rule": Look("", "line", 1.0),
    "moment": Look(),
    "cloud": Look("density-4"),
    **{f"density-{level}": Look(f"density-{level}") for level in range(1, 6)},
}

TEXTS = {
    "x": "x", "y": "y", "z": "z", "dim": "dim", "slide": "turn", "turn": "turn", "number": "line", "mark": "line",
    "theirs": "theirs", "caption": "caption", "cell": "line", "head": "line",
}  # fmt: skip
"""The colour of each kind of text."""

UPRIGHT = frozenset({"caption", "number", "cell"})
