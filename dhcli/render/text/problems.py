"""Errors and warnings on the terminal: where, what, the line with a marker under it, and what would be right."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from dhcli.errors import Place, Problem
from dhcli.render.paper import Paper

_MARGIN = 8
"""Columns kept free beside a source line that is cut to the width of the paper."""


def problems_text(problems: Iterable[Problem], paper: Paper) -> str:
    """All problems, each as `dhcli: place: message`, the line, a marker, and the hint."""
    return "".join(f"{line}\n" for problem in problems for line in problem_lines(problem, paper))


def problem_lines(problem: Problem, paper: Paper) -> Iterator[str]:
    """One problem on its lines."""
    where = f"{paper.spell(str(problem.place))}: " if problem.place and str(problem.place) else ""
    yield f"{paper.ink('dhcli:', 'bold', 'red')} {where}{paper.ink(paper.spell(problem.message), 'bold')}"
    yield from shown_below(problem, paper)


def shown_below(problem: Problem, paper: Paper) -> Iterator[str]:
    """Under a problem: the line with its marker, and the hint."""
    if problem.place is not None and problem.place.text.strip():
        yield from marked(problem.place, paper)
    if problem.hint:
        yield f"  {paper.ink('hint:', 'cyan')} {paper.spell(problem.hint)}"


def warning_line(message: str, paper: Paper) -> str:
    """A warning on one line."""
    return f"{paper.ink('dhcli: warning:', 'bold', 'yellow')} {paper.spell(message)}\n"


def marked(place: Place, paper: Paper) -> Iterator[str]:
    """The source line and a caret under the column, cut to the width of the paper if it is longer."""
    column = (place.column or 1) - 1
    room = max(paper.width - _MARGIN, 2 * _MARGIN)
    start = max(0, column - room // 2) if len(place.text) > room else 0
    shown = place.text[start : start + room]
    before = paper.spell(shown[: column - start])
    line = before + paper.spell(shown[column - start :])
    yield f"  {line.rstrip()}"
    if place.column is not None:
        yield f"  {' ' * _cells(before)}{paper.ink('^', 'bold', 'red')}"


def _cells(text: str) -> int:
    """How many columns a text takes; the wide letters of East Asia take two."""
    if text.isascii():
        return len(text)
    from unicodedata import east_asian_width

    return sum(2 if east_asian_width(letter) in "WF" else 1 for letter in text)
