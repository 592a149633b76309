"""Lines that a person types on a terminal, with the editing and the recall that the system's own library gives.

`readline` takes a millisecond to import, and is there wherever Python talks to a terminal of Unix; a console of Windows
edits and recalls by itself.
"""

from __future__ import annotations

import sys
from collections.abc import Sequence
from types import ModuleType

from dhcli.cli.shell.console import write_out
from dhcli.notation.brackets import OPENING

_SETTINGS = ("set enable-bracketed-paste off", "tab: self-insert")
"""Pasted rows come line by line as if they were typed, and the tabs in a table from a spreadsheet are blanks."""
_SETTINGS_OF_LIBEDIT = ("bind ^I ed-insert",)


_GOES_ON = (",", ";", "=", "+", "-", "*", "/", "&")
"""What a line ends in that goes on in the next one."""


class Typing:
    """Asks for lines; what was typed before comes back with the arrow keys."""

    def __init__(self) -> None:
        """Prepare the terminal, where there is one that can be."""
        self._editor = _editor()

    def line(self, prompt: str) -> str | None:
        """One line without its end; None at the end of the input.

        Raises:
            KeyboardInterrupt: Ctrl-C was pressed.
        """
        while True:
            try:
                return input(prompt)
            except EOFError:
                write_out("\n")
                return None
            except UnicodeDecodeError:
                write_out("that is no text in the encoding of this terminal\n")

    def keep(self, text: str) -> None:
        """Let a text be recalled in place of the lines that it was typed in."""
        if self._editor is not None and text:
            self._editor.add_history(text)


def recalled(lines: Sequence[str], *, is_matrix: bool) -> str:
    """Lines of one answer as the single line that is recalled and edited.

    Args:
        lines: As they were typed.
        is_matrix: Whether a line end parts rows, unless an open bracket or a sign before it says otherwise.
    """
    text = ""
    for line in filter(None, map(str.strip, lines)):
        is_open = any(text.count(one) > text.count(OPENING[one]) for one in "({")  # in [ ] a line end parts rows too
        goes_on = is_open or "[[" in text or "\\begin" in text or text.endswith(_GOES_ON)
        text += line if not text else f"{' ' if goes_on or not is_matrix else '; '}{line}"
    return text


def _editor() -> ModuleType | None:
    """The library that edits lines; None where lines come from elsewhere than the terminal of this process."""
    try:
        if sys.stdin.fileno() != 0 or sys.stdout.fileno() != 1 or not sys.stdin.isatty():
            return None
        import readline
    except (ImportError, OSError, ValueError):
        return None
    is_libedit = "libedit" in (readline.__doc__ or "")
    for setting in _SETTINGS_OF_LIBEDIT if is_libedit else _SETTINGS:
        readline.parse_and_bind(setting)
    readline.set_auto_history(False)
    return readline
