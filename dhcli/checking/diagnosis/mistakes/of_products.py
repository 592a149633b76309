"""Mistakes in putting the factors together."""

from __future__ import annotations

from dhcli.checking.diagnosis import products
from dhcli.checking.diagnosis.mistakes.record import Level, Mistake
from dhcli.checking.diagnosis.result import Rank

P = Level.PRODUCT

IN_PRODUCTS = (
    Mistake(
        "order-reversed",
        P,
        "the factors are multiplied in the reverse order",
        "in which order are the factors multiplied?",
        products.reversed_order,
        Rank.WHOLE,
    ),
    Mistake(
        "last-first",
        P,
        "the last factor is multiplied from the left, as for a move about the fixed axes",
        "from which side is each new factor multiplied?",
        products.last_first,
    ),
    Mistake(
        "factor-missing",
        P,
        "factor {where} is missing in the product",
        "count the factors of the product",
        products.missing,
    ),
    Mistake(
        "factor-twice",
        P,
        "factor {where} stands twice in the product",
        "count the factors of the product",
        products.twice,
    ),
    Mistake(
        "translation-not-rotated",
        P,
        "the positions are added without turning them into the reference frame",
        "in which frame is each shift measured?",
        products.unrotated,
    ),
    Mistake(
        "element-wise",
        P,
        "the matrices are multiplied entry by entry, not rows by columns",
        "how are two matrices multiplied?",
        products.elementwise,
    ),
)
"""In the product of the links, or of the moves of one."""
