"""Files that break one rule: a clean text, one thing in it changed, and what lint says of it."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import pytest

from dhcli.lint.files import lint

ONE_JOINT = """\
format: 1
title: An arm
source: a test
convention: standard
variables: [theta1]
parameters: {a1: 0.4 m}
links:
  - {a: a1, alpha: 0, d: 0, theta: theta1}
"""
"""A robot file with nothing wrong in it."""


@dataclass(frozen=True)
class Broken:
    """A clean file with one thing changed.

    Attributes:
        old: What stands in the clean file.
        new: What stands there instead.
        at: Line and column of the finding.
        message: The finding, word for word.
        hint: What would be right.
        is_warning: Whether an author may leave it.
    """

    old: str
    new: str
    at: str
    message: str
    hint: str = ""
    is_warning: bool = False


def cases(*broken: Broken) -> pytest.MarkDecorator:
    """A test for each of the files."""
    return pytest.mark.parametrize(
        "broken", broken, ids=[f"{one.message[:50]} ({one.new.strip()[:20]})" for one in broken]
    )


def findings(folder: Path, text: str, name: str = "own.yaml") -> list[Broken]:
    """What lint says of a file with this text, each finding with its place."""
    path = folder / name
    path.write_text(text, "utf-8")
    found = []
    for told in lint([str(path)]).told:
        problem = told.problem
        assert problem.place is not None
        assert problem.place.source == str(path)
        at = ":".join(str(number) for number in (problem.place.line, problem.place.column) if number)
        found.append(Broken("", "", at, problem.message, problem.hint, told.is_warning))
    return found


_CLEAN: set[tuple[str, str]] = set()
"""Files without a finding, by text and name."""


def assert_told(folder: Path, clean: str, broken: Broken, name: str = "own.yaml") -> None:
    """The clean file has no finding, and with the change it has just the one expected."""
    assert clean.count(broken.old) == 1, broken.old
    if (clean, name) not in _CLEAN:
        assert findings(folder, clean, name) == []
        _CLEAN.add((clean, name))
    (found,) = findings(folder, clean.replace(broken.old, broken.new), name)
    expected = Broken("", "", broken.at, broken.message, broken.hint, broken.is_warning)
    assert found == expected, f"{found}\n{expected}"
