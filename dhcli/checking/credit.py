"""The rules of credit: what an answer that is not right earns of what its part is worth; an author may set them."""

from __future__ import annotations

from dataclasses import fields

from dhcli.checking.verdicts import Verdict
from dhcli.frozen import frozen
from dhcli.notation.tree import Expr, Number

_BY = {"cells": "cell by cell", "rows": "row by row", "whole": "as a whole"}
UNITS = tuple(_BY)
"""What earns credit in a table: each cell that is right, each row, or the table alone."""


@frozen
class Shares:
    """What an answer earns of the credit of its part, each from 0 to 1.

    Attributes:
        rotation: What the rotation of a pose is worth, its position being worth the rest; None where the rotation is
            one item and each coordinate another (in numbers), or each entry is one (in symbols).
        close: What an item within ten times the tolerance earns of what a right one does.
        rounded: What an item earns that is right to the digits typed, which are too few.
        unit: What an answer earns that is right throughout in another unit.
        moves: What the moves of a link earn in the wrong order; some of them alone earn their part of it.
        table: What earns in a table: `cells`, `rows` or the `whole`.
    """

    rotation: float | None = None
    close: float = 0.0
    rounded: float = 1.0
    unit: float = 0.5
    moves: float = 0.0
    table: str = "cells"

    def of(self, verdict: Verdict) -> float:
        """What an item earns by its verdict."""
        if verdict.passed:
            return 1.0
        return {Verdict.ROUNDED: self.rounded, Verdict.CLOSE: self.close}.get(verdict, 0.0)

    def beside(self, others: Shares) -> tuple[str, ...]:
        """What is otherwise than in others, in words."""
        rotation = 0.0 if self.rotation is None else self.rotation
        said = {
            "rotation": f"the rotation of a pose earns {rotation:.3g}, its position {1 - rotation:.3g}",
            "close": f"what is CLOSE earns {self.close:.3g}",
            "rounded": f"what is ROUNDED earns {self.rounded:.3g}",
            "unit": f"what is right in another unit earns {self.unit:.3g}",
            "moves": f"the right moves in the wrong order earn {self.moves:.3g}",
            "table": f"a table earns {_BY[self.table]}",
        }
        changed = (field.name for field in fields(self) if getattr(self, field.name) != getattr(others, field.name))
        return tuple(said[name] for name in changed)


USUAL = Shares()
"""What answers earn where nobody has set it."""


def only_costs(entry: Expr, *, is_cosine: bool, is_constant: bool) -> bool:
    """Whether an entry in symbols earns nothing where it is right, and costs what others earn where it is wrong.

    Zeros are typed by whoever has worked out nothing; so are ones that are the same for everybody, such as those in the
    column of the axis about which a joint turns.

    Args:
        entry: What is right.
        is_cosine: Whether it is a direction cosine, for which 1 and -1 are such numbers too.
        is_constant: Whether the whole answer is numbers; then its ones are what was asked for.
    """
    if not isinstance(entry, Number):
        return False
    return not entry.value or (is_cosine and not is_constant and abs(entry.value) == 1)


def credits_text(value: float) -> str:
    """`1 credit`, `2.5 credits`."""
    return f"{plain(value)} credit{'s' * (value != 1)}"


def plain(value: float) -> str:
    """A credit for people."""
    return f"{value:.2f}".rstrip("0").rstrip(".")
