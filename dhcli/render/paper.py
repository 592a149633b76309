"""What text is written on: how wide it is, whether it has colours, and which letters it knows."""

from __future__ import annotations

import os
import shutil
import unicodedata
from typing import TextIO

from dhcli.frozen import frozen
from dhcli.notation.names import GREEK
from dhcli.safe import one_line

WIDE = 100
"""Columns of a pipe or a file: fixed, so that what a program reads never depends on a window."""

LEAST = 20
"""Columns of the narrowest window that is drawn for; a narrower one, which nobody reads, breaks its lines itself."""

_NEEDED = "⎡θ°─"
_INKS = {"bold": "1", "dim": "2", "underline": "4", "red": "31", "green": "32", "yellow": "33", "cyan": "36"}
_IN_ASCII = str.maketrans(
    GREEK
    | dict(zip("₀₁₂₃₄₅₆₇₈₉", "0123456789", strict=True))
    | {"°": "deg", "π": "pi", "√": "sqrt", "−": "-", "–": "-", "—": "-", "·": "*", "…": "...", "×": "x", "′": "'"}  # noqa: RUF001
    | {"⎡": "[", "⎢": "[", "⎣": "[", "⎤": "]", "⎥": "]", "⎦": "]", "±": "+-", "Σ": "sum ", "²": "^2", "→": "->"}
    | {"✓": "+", "≡": "=", "≈": "~=", "✗": "x", "█": "#", "µ": "u", "Δ": "Delta", "∓": "-+", "½": "1/2"}
    | {"─": "-", "━": "-", "│": "|", "┼": "+", "╷": " ", "╵": " ", "“": '"', "”": '"', "‘": "'", "’": "'"}  # noqa: RUF001
    | {
        "ß": "ss",
        "ø": "o",
        "Ø": "O",
        "ł": "l",
        "Ł": "L",
        "đ": "d",
        "Đ": "D",
        "æ": "ae",
        "œ": "oe",
        "≤": "<=",
        "≥": ">=",
    }
)


@frozen
class Paper:
    """What text is written on.

    Attributes:
        width: Columns.
        colour: Whether it has colours.
        unicode: Whether it knows more letters than ASCII.
        terminal: Whether it is a window that a person looks at.
    """

    width: int = WIDE
    colour: bool = False
    unicode: bool = True
    terminal: bool = False

    @classmethod
    def of(cls, stream: TextIO) -> Paper:
        """The paper that a stream writes on; a terminal's own width, a fixed one for everything else."""
        terminal = stream.isatty()
        width = max(LEAST, shutil.get_terminal_size((80, 24)).columns) if terminal else WIDE
        colour = is_colour_wanted() and (bool(os.environ.get("FORCE_COLOR")) or terminal)
        return cls(width, colour, _knows(stream.encoding, _NEEDED), terminal)

    def spell(self, text: str) -> str:
        """A text in the letters that the paper knows, on one line, without what would steer a terminal."""
        text = one_line(text)
        return text if self.unicode or text.isascii() else in_ascii(text)

    def ink(self, text: str, *inks: str) -> str:
        """A text in colour; any of bold, dim, underline, red, green, yellow, cyan."""
        if not self.colour or not inks or not text:
            return text
        return f"\x1b[{';'.join(_INKS[ink] for ink in inks)}m{text}\x1b[0m"

    def aside(self, text: str) -> list[str]:
        """A line that leads on, for who looks at a window; none for a file or a pipe."""
        if not self.terminal:
            return []
        from textwrap import wrap

        lines = wrap(self.spell(text), self.width, break_on_hyphens=False)
        return [self.ink(line, "dim") for line in lines]


def is_colour_wanted() -> bool:
    """Whether colours, bold letters among them, may be used where they can be: NO_COLOR and a dumb terminal say no."""
    is_dumb = os.environ.get("TERM") == "dumb" and not os.environ.get("FORCE_COLOR")
    return not os.environ.get("NO_COLOR") and not is_dumb


def in_ascii(text: str) -> str:
    """A text in ASCII: Greek letters by name, brackets and lines by what looks like them, accents left out."""
    text = text.replace(" · ", ", ").translate(_IN_ASCII)  # between blanks a dot separates, else it multiplies
    if not text.isascii():
        text = unicodedata.normalize("NFKD", text)
        text = "".join(letter for letter in text if not unicodedata.combining(letter))
    return text.encode("ascii", "replace").decode("ascii")


def _knows(encoding: str | None, letters: str) -> bool:
    try:
        letters.encode(encoding or "ascii")
    except (UnicodeEncodeError, LookupError):
        return False
    return True
