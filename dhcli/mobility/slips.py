"""Counts as an exercise asks for them, and the slips that give wrong ones.

A count question names what is counted and a linkage. On a miss the count is done again under each named slip: the
ground not counted, joints counted as links, the plane taken for space, C taken for f.
"""

from __future__ import annotations

from collections.abc import Iterator

from dhcli.mobility.counting import Counts
from dhcli.mobility.finding import mobility_of
from dhcli.mobility.linkage import Linkage
from dhcli.mobility.pairs import LinkageError
from dhcli.mobility.patterns import other_reading, read_pattern
from dhcli.notation.tree import Expr, Number

QUANTITIES = ("mobility", "gruebler", "links", "joints", "constraints", "freedoms")
"""What can be counted: true mobility, F of the formula, n, j, ΣC and Σf."""


def count(what: str, linkage: Linkage | Counts | str) -> int:
    """The right answer to a count question.

    Args:
        what: One of `QUANTITIES`.
        linkage: A linkage, counts, or a pattern such as `6R`; names are found by `files.linkages.find_linkage`.

    Raises:
        LinkageError: There is no such quantity, it holds names, or the mobility is not decided.
    """
    linkage = read_pattern(linkage) if isinstance(linkage, str) else linkage
    counts = Counts.of(linkage) if isinstance(linkage, Linkage) else linkage
    if what == "mobility":
        found = mobility_of(linkage)
        if found.mobility is None:
            raise LinkageError(f"the mobility of {counts.title} is not known: {found.certificate or found.settles}")
        return found.mobility
    quantities = {
        "gruebler": counts.by_freedoms,
        "links": counts.n,
        "joints": counts.j,
        "constraints": counts.sum_c,
        "freedoms": counts.sum_f,
    }
    if what not in quantities:
        raise LinkageError(f"there is no count of {what}", f"counts: {', '.join(QUANTITIES)}")
    return _whole(quantities[what], what)


def slips(what: str, linkage: Linkage | Counts | str) -> dict[str, int]:
    """Wrong values of a count by the slip that gives them, the likeliest first, without those that happen to be right.

    Args:
        what: One of `QUANTITIES`.
        linkage: As for `count`.
    """
    linkage = read_pattern(linkage) if isinstance(linkage, str) else linkage
    right = count(what, linkage)
    found: dict[str, int] = {}
    for name, value in _slips(what, linkage):
        if value != right:
            found.setdefault(name, value)
    return found


def _slips(what: str, linkage: Linkage | Counts) -> Iterator[tuple[str, int]]:
    counts = Counts.of(linkage) if isinstance(linkage, Linkage) else linkage
    n, j, lambda_ = _whole(counts.n, "links"), _whole(counts.j, "joints"), counts.space.lambda_
    sum_f, sum_c = _whole(counts.sum_f, "freedoms"), _whole(counts.sum_c, "constraints")
    other = 3 if lambda_ == 6 else 6  # noqa: PLR2004  space
    wrong_space = "the plane taken for space" if other == 6 else "space taken for the plane"  # noqa: PLR2004  space
    pins = len({joint.point for joint in linkage.joints}) if isinstance(linkage, Linkage) and linkage.is_placed else j
    match what:
        case "links":
            yield "the ground is not counted", n - 1
            yield "joints counted as links", j
            yield "links counted as an open chain", j + 1
        case "joints":
            yield "links counted as joints", n
            yield "a pin of several links counted once", pins
        case "freedoms":
            yield "constraints C taken for freedoms f", sum_c
            yield "joints counted, not their freedoms", j
        case "constraints":
            yield "freedoms f taken for constraints C", sum_f
            yield wrong_space, other * j - sum_f
        case _:
            formula = lambda_ * (n - j - 1) + sum_f
            if what == "mobility":
                yield "the formula is believed", formula
            yield "the ground is not counted", formula - lambda_
            yield "joints counted as links", lambda_ * (j - j - 1) + sum_f
            yield wrong_space, other * (n - j - 1) + sum_f
            yield "constraints C taken for freedoms f", lambda_ * (n - j - 1) + sum_c
            yield "freedoms f taken for constraints C", lambda_ * (n - 1) - sum_f
            yield "the 1 of n - j - 1 is forgotten", formula + lambda_
            if pins != j:
                yield "a pin of several links counted once", lambda_ * (n - pins - 1) + sum_f - (j - pins)
            if (
                isinstance(linkage, Linkage)
                and (closed := other_reading(linkage)) is not None
                and closed.gruebler is not None
            ):
                yield f"read as {closed.reading}", closed.gruebler
            yield from _about_truth(what, linkage)


def _about_truth(what: str, linkage: Linkage | Counts) -> Iterator[tuple[str, int]]:
    """Slips that take the truth for the formula, or know it only in part."""
    found = mobility_of(linkage)
    if found.idle and found.mobility is not None:
        yield "idle freedoms are left out", found.mobility - len(found.idle)
    if what == "gruebler" and found.mobility is not None:
        yield "the true mobility, not the F of the formula", found.mobility
    if what == "mobility" and found.instantaneous is not None:
        yield "what moves for an instant only is counted", found.instantaneous


def _whole(expr: Expr, what: str) -> int:
    if not isinstance(expr, Number):
        raise LinkageError(f"the count of {what} is a formula, {expr}")
    return int(expr.value)
