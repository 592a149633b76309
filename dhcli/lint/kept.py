"""Findings of rules that may end in an error: no error of one part, or one file, hides what is wrong elsewhere."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from dhcli.errors import DhcliError
from dhcli.kinematics.validity import Finding


def kept(rules: Iterable[Finding], where: tuple[str | int, ...] = (), what: str = "") -> Iterator[Finding]:
    """The findings of rules as they come, and behind them what kept the rules from going on.

    Args:
        rules: The findings; an iterator, which may raise.
        where: Where an error is told.
        what: What it is about, such as the name of a part; empty for the whole file.
    """
    try:
        yield from rules
    except DhcliError as error:
        for problem in error.problems:
            yield Finding(where, f"{what}: {problem.message}" if what else problem.message, problem.hint)
