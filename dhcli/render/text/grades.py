"""The report of a class for the person who teaches it: parts, slips, the credit earned, and what is left over."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import groupby
from textwrap import wrap

from dhcli.checking.credit import plain
from dhcli.checking.verdicts import Verdict
from dhcli.classroom.grades import Graded
from dhcli.classroom.report import STEPS, ClassReport, PartFigures
from dhcli.errors import plural
from dhcli.render.look import Look
from dhcli.render.paper import Paper
from dhcli.render.text.table import table_text

_SLIPS = 3
"""Slips of a part that the page shows; JSON has all of them."""
_OTHERS = 20
"""Files that are no sheets that the page names; JSON has all of them."""
_BAR = 30
"""Longest bar of the distribution."""
_LEAST = 20
"""Fewest columns that a text is folded to."""


def class_table(report: ClassReport, look: Look) -> str:
    """A table for each exercise, the commonest slips, the distribution, and the sheets that were not graded."""
    paper = look.paper
    sections = [_head(paper.spell(summary(report)), paper)]
    for exercise, figures in groupby(report.parts, key=lambda one: one.exercise):
        parts = list(figures)
        sections.append(
            _head(f"{exercise} · {plural(sum(parts[0].verdicts.values()), 'sheet')}", paper) + _parts(parts, paper)
        )
        if any(part.slips for part in parts):
            sections.append(_head("Commonest slips", paper) + _slips(parts, paper))
    if report.mean is not None:
        sections.append(_head(f"Credit earned, {100 * report.mean:.0f} % on average", paper) + _spread(report, paper))
    if report.failed:
        same: dict[str, list[str]] = {}
        for row in report.failed:
            same.setdefault(_reason(row), []).append(f" {paper.spell(row.sheet)}\n")
        reasons = ("".join(sheets) + _folded(reason, "   ", paper) for reason, sheets in same.items())
        sections.append(_head("Not graded", paper) + "".join(reasons))
    if report.folder.empty:
        names = "".join(f" {paper.spell(name)}\n" for name in report.folder.empty)
        sections.append(_head("Folders without a sheet", paper) + names)
    if report.notices:
        lines = "".join(_folded(notice, " ", paper) for notice in report.notices)
        sections.append(_head("Worth a look", paper) + lines)
    if others := report.folder.others:
        more = [f"and {len(others) - _OTHERS} more"] if len(others) > _OTHERS else []
        names = "".join(_folded(name, " ", paper) for name in (*others[:_OTHERS], *more))
        head = f"Not looked at: {plural(len(others), 'other file')}, for sheets end in .yaml or .yml"
        sections.append(_head(head, paper) + names)
    return "\n".join(sections)


def summary(report: ClassReport) -> str:
    """How many sheets there are, and how many could not be graded."""
    text = f"{report.folder.path}: {plural(len(report.rows), 'sheet')}, {len(report.graded)} graded"
    return f"{text}, {len(report.failed)} not" if report.failed else text


def _head(text: str, paper: Paper) -> str:
    return f"{paper.ink(paper.spell(text), 'bold')}\n"


def _parts(parts: list[PartFigures], paper: Paper) -> str:
    """Verdicts of each part; a verdict that nobody got has no column."""
    seen = [verdict for verdict in Verdict if any(verdict in part.verdicts for part in parts)]
    rows = [
        (
            *(part.part, plain(part.credit), plain(part.mean)),
            *(str(part.verdicts.get(verdict, "")) for verdict in seen),
        )
        for part in parts
    ]
    return table_text(["part", "credit", "mean", *(verdict.word for verdict in seen)], rows, paper)


def _slips(parts: list[PartFigures], paper: Paper) -> str:
    """The commonest slips of each part, with how many sheets have them; those of the most sheets first."""
    found = [(count, part, slip) for part in parts for slip, count in part.slips[:_SLIPS]]
    rows = [
        (part.part, f"{count} of {sum(part.verdicts.values())}", slip)
        for count, part, slip in sorted(found, key=lambda one: -one[0])
    ]
    widths = [max(len(row[k]) for row in rows) for k in (0, 1)]
    heads = (f" {part.ljust(widths[0])}   {count.rjust(widths[1])}   " for part, count, _ in rows)
    return "".join(_folded(slip, head, paper) for head, (_, _, slip) in zip(heads, rows, strict=True))


def _folded(text: str, head: str, paper: Paper) -> str:
    """A text behind what stands before it, folded to the width of a terminal; what is piped is not folded."""
    text = paper.spell(text)
    room = max(paper.width - len(head) - 1, _LEAST) if paper.terminal else len(text) + 1
    lines = wrap(text, room) or [""]
    return "".join(f"{(' ' * len(head) if i else head)}{line}\n" for i, line in enumerate(lines))


def _spread(report: ClassReport, paper: Paper) -> str:
    most = max(report.spread)
    sign = "█" if paper.unicode else "#"
    bars = [sign * -(-count * _BAR // max(most, _BAR)) for count in report.spread]
    return "".join(
        f" {name:>7}   {bar}{' ' * bool(bar)}{count}\n"
        for name, bar, count in zip(_steps(), bars, report.spread, strict=True)
    )


def _steps() -> Iterator[str]:
    """What the classes of the distribution are called."""
    for low, high in zip(STEPS, (*STEPS[1:], None), strict=True):
        yield f"{low} %" if high is None else f"{low}-{high - 1} %"


def _reason(row: Graded) -> str:
    """The first problem with its line and its hint, and how many more there are."""
    first = row.problems[0]
    numbers = (first.place.line, first.place.column) if first.place else ()
    where = ":".join(str(number) for number in numbers if number is not None)
    more = f" (and {len(row.problems) - 1} more)" if len(row.problems) > 1 else ""
    hint = f"; {first.hint}" if first.hint else ""
    return f"{where}{': ' if where else ''}{first.message}{hint}{more}"
