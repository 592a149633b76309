"""Errors and warnings on the terminal: where, what, the line with a marker under it, and what would be right."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from dhcli.errors import Place, Problem, joined, listed
from dhcli.render.paper import Paper

_MARGIN = 8
"""Columns kept free beside a source line that is cut to the width of the paper."""

_APART = 2
"""Problems with the same words that are told one by one; of more the first is told, and where the others stand."""


def problems_text(problems: Iterable[Problem], paper: Paper) -> str:
    """All problems, each as `dhcli: place: message`, the line, a marker, and the hint; what is often said only once."""
    lines: list[str] = []
    for problem, places in gathered(problems):
        lines += problem_lines(problem, paper)
        lines += [f"  {paper.spell(f'the same {others_text(places)}')}"] if places else []
    return "".join(f"{line}\n" for line in lines)


def gathered(problems: Iterable[Problem]) -> list[tuple[Problem, list[Place]]]:
    """The problems, and of those with the same words the first, with the places of the others."""
    given = list(problems)
    alike: dict[tuple[str, ...], list[Place | None]] = {}
    for problem in given:
        alike.setdefault(_words(problem), []).append(problem.place)
    found, told = list[tuple[Problem, list[Place]]](), set[tuple[str, ...]]()
    for problem in given:
        words = _words(problem)
        places = [place for place in alike[words] if place is not None]
        if not _APART < len(places) == len(alike[words]):
            found.append((problem, []))
        elif words not in told:
            found.append((problem, places[1:]))
        told.add(words)
    return found


def _words(problem: Problem) -> tuple[str, ...]:
    """What a problem says, and in which file: a line is one of the file that is named with the first."""
    place = problem.place
    return problem.message, problem.hint, place.source if place and place.line is not None else ""


def others_text(places: Sequence[Place]) -> str:
    """Where else in a file something stands: `in lines 2 to 5 and 9`; the names of places that have no lines."""
    lines = sorted({place.line for place in places if place.line is not None})
    if not lines:
        return f"at {listed([str(place) for place in places])}"
    runs: list[list[int]] = []
    for line in lines:
        if runs and line == runs[-1][-1] + 1:
            runs[-1].append(line)
        else:
            runs.append([line])
    words = [word for run in runs for word in ([f"{run[0]} to {run[-1]}"] if len(run) > _APART else run)]
    return f"in line{'s' * (len(lines) > 1)} {joined(words)}"


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
