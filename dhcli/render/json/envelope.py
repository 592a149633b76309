"""JSON: one envelope for every command, for results and errors alike. Its keys are a contract."""

from __future__ import annotations

import json
from collections.abc import Iterable
from typing import Any

from dhcli.errors import Problem

VERSION = 1


def envelope(
    command: str, content: dict[str, Any] | None, problems: Iterable[Problem], warnings: Iterable[str] = ()
) -> str:
    """The result of a command, or what kept it from one."""
    listed = [
        *(problem_content(problem, "error") for problem in problems),
        *(problem_content(Problem(w), "warning") for w in warnings),
    ]
    whole = {"dhcli": VERSION, "command": command, "ok": content is not None, "data": content, "problems": listed}
    return _pretty(whole) + "\n"


def _pretty(value: object, margin: str = "") -> str:
    """JSON for people too: indented, but a row of a matrix on one line. NaN has no place in it."""
    inner = margin + "  "
    if isinstance(value, dict) and value:
        members = [f"{inner}{_plain(key)}: {_pretty(content, inner)}" for key, content in value.items()]
        return "{\n" + ",\n".join(members) + f"\n{margin}}}"
    if isinstance(value, list) and any(isinstance(item, dict | list) for item in value):
        return "[\n" + ",\n".join(inner + _pretty(item, inner) for item in value) + f"\n{margin}]"
    return _plain(value)


_plain = json.JSONEncoder(allow_nan=False).encode
"""JSON on one line, by one encoder for the thousands of values of a class. ASCII only: every stream can carry it."""


def problem_content(problem: Problem, severity: str) -> dict[str, Any]:
    """A problem as JSON holds it."""
    place = problem.place
    return {
        "severity": severity,
        "message": problem.message,
        "hint": problem.hint,
        "source": place.source if place else None,
        "line": place.line if place else None,
        "column": place.column if place else None,
    }
