"""The mistakes that dhcli knows, each a record: how it is made, what it is called, and where a student should look.

To add one is to write the function that makes it, with its record as decorator. In a pair the earlier level is made
first. Of two mistakes that are the same wherever one looks, such as the transpose of a plain turn and the turn the
other way, the earlier has the name. Those in a single value are in `values`; those about counts stand beside what they
count, in `mobility.slips`.
"""

from __future__ import annotations

from dhcli.checking.diagnosis.mistakes.between_rows import BETWEEN_ROWS
from dhcli.checking.diagnosis.mistakes.in_terms import IN_TERMS
from dhcli.checking.diagnosis.mistakes.matrices import IN_THE_WHOLE, IN_WRITING
from dhcli.checking.diagnosis.mistakes.moves import IN_MOVES
from dhcli.checking.diagnosis.mistakes.products import IN_PRODUCTS, OF_FRAMES
from dhcli.checking.diagnosis.mistakes.rows import IN_ROWS
from dhcli.checking.diagnosis.mistakes.turns import IN_TURNS
from dhcli.checking.diagnosis.mistakes.units import IN_UNITS

__all__ = ["BY_ID", "EVERY", "IN_TERMS", "MISTAKES"]

MISTAKES = (
    *IN_THE_WHOLE,
    *OF_FRAMES,
    *IN_ROWS,
    *IN_UNITS,
    *IN_TURNS,
    *BETWEEN_ROWS,
    *IN_MOVES,
    *IN_PRODUCTS,
    *IN_WRITING,
)
"""Every mistake about a matrix or a table, in the order in which they are tried and named."""

EVERY = (*MISTAKES, *IN_TERMS)
"""Also those in the terms of a formula, which are looked for only in entries that are wrong."""

BY_ID = {mistake.id: mistake for mistake in EVERY}
