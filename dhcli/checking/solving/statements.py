"""The statements of an answer that gives names to what is long in a formula, in the order in which they are used."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import replace

from dhcli.notation.names import canonical
from dhcli.notation.scope import Scope
from dhcli.regex import regex

STATEMENT = regex(r"\s*(?P<name>\\?[^\W\d][\w{}\\()+ ]*?(?:\^2|\*\*2|²)?)\s*=(?!=)\s*(?P<rest>.*)", re.DOTALL)
"""A name and what it is, in any number of lines."""

SQUARE = regex(r"(?P<base>[^\W\d]\w{0,20})\s{0,9}(?:\^2|\*\*2|²)")
"""A name that is defined by its square, `r^2 = px^2 + py^2`."""


def statements_in(text: str, asked: Sequence[str]) -> list[str]:
    """The statements of a text, those that define what is long before the answers, wherever they stand."""
    every = [part for line in text.splitlines() for part in line.split(";") if part.strip()] or [text]

    def answers(statement: str) -> bool:
        match = STATEMENT.fullmatch(statement)
        return match is None or canonical(match["name"].replace(" ", "")) in asked

    asked_for = [statement for statement in every if answers(statement)]
    return [*_in_order([statement for statement in every if not answers(statement)]), *asked_for]


def with_own_capitals(scope: Scope, statements: Sequence[str]) -> Scope:
    """A scope in which capitals that an answer defines are names of their own: `A1 = a1 + a2*c2` makes A1 no a1."""
    matches = filter(None, map(STATEMENT.fullmatch, statements))
    own = {canonical(match["name"]) for match in matches if match["name"][0].isupper()} & scope.aliases.keys()
    if not own:
        return scope
    return replace(scope, aliases={alias: name for alias, name in scope.aliases.items() if alias not in own})


def _in_order(definitions: list[str]) -> Iterator[str]:
    """Definitions, each behind those that it uses: `D = r^2 - a1, r^2 = px^2 + py^2`; in a circle, as they stand."""
    left = list(definitions)
    while left:
        free = (one for one in left if not any(_uses(one, two) for two in left if two != one))
        chosen = next(free, left[0])
        left.remove(chosen)
        yield chosen


def _uses(one: str, other: str) -> bool:
    """Whether what one definition defines something by is the name that another one defines."""
    name = other.partition("=")[0].strip()
    square = SQUARE.fullmatch(name)
    base = re.escape(square["base"] if square else name)
    return re.search(rf"(?<![^\W\d]){base}(?![A-Za-z0-9_])", one.partition("=")[2]) is not None
