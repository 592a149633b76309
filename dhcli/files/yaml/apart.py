"""Answers of a sheet read apart, where one of them is no YAML: a stray quote in it is no reason to judge none."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from dhcli.errors import FileError, Problem
from dhcli.files.yaml.placed import PlacedMapping, PlacedNode, read_yaml
from dhcli.frozen import frozen
from dhcli.regex import regex

MOST = 100
"""Answers that are read apart; no exercise has more parts."""

_HEAD = regex(r"answers:\s*(?:#.*)?")
_KEY = regex(r"(?P<indent> {1,16})(?P<name>[\w-]{1,60}):(?:\s.*)?")
_AS_WRITTEN = regex(r"[\w-]{1,60}:\s*\|\s*")
"""The line of a part as `start` writes it; `x: 3` may belong to an answer."""
_INDENT = regex(r"[ \t]*")
LEVEL = "  "
"""What indents a part on a sheet; an answer on lines of its own stands twice as far in."""


@frozen
class Unread:
    """An answer that is no YAML.

    Attributes:
        text: Its lines.
        problem: What is wrong in it, with line and column.
    """

    text: str
    problem: Problem


def read_apart(text: str, source: str) -> tuple[PlacedNode, Mapping[str, Unread]]:
    """Read a sheet, and which of its answers are no YAML; in the tree these are empty.

    Args:
        text: The sheet.
        source: What to call it in messages.

    Raises:
        FileError: It is no YAML besides its answers, or nobody can say which answer it is.
    """
    try:
        return read_yaml(text, source), {}
    except FileError as error:
        lines = list(_without_tabs(text.removeprefix("\ufeff").splitlines()))
        unread = dict[str, Unread]()
        for name, start, end in list(_blocks(lines))[: MOST + 1]:
            problem = _problem(name, ["", *lines[start:end]], start, source)
            if problem is None:
                continue
            unread[name] = Unread("\n".join(lines[start:end]).partition(":")[2].strip(), problem)
            lines[start:end] = [f"{lines[start].partition(':')[0]}: ''", *[""] * (end - start - 1)]
        if len(unread) > MOST:
            raise
        try:
            return read_yaml("\n".join(lines), source), unread
        except FileError:
            raise error from None


def _without_tabs(lines: list[str]) -> Iterator[str]:
    """The lines with blanks for the tabs that indent answers, which YAML does not take and an editor may write."""
    head = _head(lines)
    for i, line in enumerate(lines):
        indent = match[0] if (match := _INDENT.match(line)) else ""
        if i <= head or "\t" not in indent:
            yield line
            continue
        is_part = _AS_WRITTEN.fullmatch(line, len(indent))
        yield (LEVEL if is_part else 2 * LEVEL) + line[len(indent) :]


def _head(lines: list[str]) -> int:
    """The line that the answers stand below, or none."""
    return next((i for i, line in enumerate(lines) if _HEAD.fullmatch(line)), len(lines))


def _blocks(lines: list[str]) -> Iterator[tuple[str, int, int]]:
    """The name of each answer, its first line and the one behind its last, from 0."""
    head = _head(lines)
    keys = [(i, found) for i in range(head + 1, len(lines)) if (found := _KEY.fullmatch(lines[i]))]
    indent = min((found["indent"] for _, found in keys), key=len, default="")
    first = [(i, found["name"]) for i, found in keys if found["indent"] == indent]
    ends = [*(i for i, _ in first[1:]), len(lines)][: len(first)]
    yield from ((name, start, end) for (start, name), end in zip(first, ends, strict=True))


def _problem(name: str, lines: list[str], above: int, source: str) -> Problem | None:
    """What is wrong in the lines of one answer; None where they are one."""
    try:
        root = read_yaml("\n" * (above - 1) + "\n".join(lines), source, is_foreign=True)
    except FileError as error:
        return error.problems[0]
    is_one = isinstance(root, PlacedMapping) and [key.text for key, _ in root.entries] == [name]
    return None if is_one else Problem("these lines are no answer", root.place)
