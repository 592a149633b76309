"""Findings about content: each on a line that editors can jump to, and under it what would be right."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from dhcli.errors import plural
from dhcli.lint.files import Linted
from dhcli.lint.one_file import Told
from dhcli.render.look import Look
from dhcli.render.paper import Paper
from dhcli.render.text.problems import shown_below


def lint_table(linted: Linted, look: Look) -> str:
    """Every finding, and the sum."""
    lines = [line for told in linted.told for line in _lines(told, look.paper)]
    found = f"{plural(linted.errors, 'error')}, {plural(linted.warnings, 'warning')}"
    total = f"{plural(len(linted.files), 'file')}: {found if linted.told else 'nothing to mend'}"
    return "\n".join([*lines, total]) + "\n"


def lint_content(linted: Linted, _look: Look) -> dict[str, Any]:
    """The findings as JSON holds them."""
    return {
        "files": list(linted.files),
        "errors": linted.errors,
        "warnings": linted.warnings,
        "findings": [_content(told) for told in linted.told],
    }


def _lines(told: Told, paper: Paper) -> Iterator[str]:
    problem = told.problem
    word = paper.ink("warning:", "bold", "yellow") if told.is_warning else paper.ink("error:", "bold", "red")
    yield f"{paper.spell(str(problem.place))}: {word} {paper.spell(problem.message)}"
    yield from shown_below(problem, paper)


def _content(told: Told) -> dict[str, Any]:
    from dhcli.render.json.envelope import problem_content

    return problem_content(told.problem, "warning" if told.is_warning else "error")
