"""Prose for people: folded where they read it in a window, as it stands in the file where a program reads it."""

from __future__ import annotations

from dhcli.render.paper import Paper
from dhcli.safe import one_line

WIDEST = 96
"""Columns at which prose is folded at most; longer lines are hard to read."""


def prose_lines(text: str, paper: Paper, first: str = "", rest: str = "") -> list[str]:
    """A text in lines: folded to a terminal, elsewhere as its lines stand.

    Args:
        text: The text.
        paper: What it is written on.
        first: What stands before its first line.
        rest: What stands before every other line.
    """
    lines = text.strip("\n").splitlines()
    if paper.terminal:
        from dhcli.files.yaml.prose import folded  # nothing is folded for a program

        spelled = "\n".join(map(paper.spell, lines))
        return folded(spelled, max(min(paper.width, WIDEST), len(rest) + 1), first, rest)
    return [f"{rest if i else first}{paper.spell(line)}" for i, line in enumerate(lines)]


def heading_text(text: str, paper: Paper) -> str:
    """A heading in bold, folded to a terminal; line ends of a name in it do not part it."""
    return "\n".join(paper.ink(line, "bold") for line in prose_lines(one_line(text), paper))
