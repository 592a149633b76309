"""The three answers about a linkage in one value: what the formula gives, the truth, and why they differ."""

from __future__ import annotations

from dhcli.mobility.counting import Counts
from dhcli.mobility.linkage import Linkage
from dhcli.mobility.pairs import LinkageError
from dhcli.mobility.patterns import other_reading
from dhcli.mobility.result import Mobility

MOST_LINKS = 5_000
"""Links of a linkage whose geometry is looked at; a table of paths grows like their square."""

ONLY_COUNTS = (
    "Counts alone give the formula; whether it is true depends on the geometry, which a linkage file can hold."
)
ONLY_GRAPH = (
    "The joint graph gives the formula; whether it is true depends on where the joints are: add points and axes."
)
TOO_LARGE = "The joint graph gives the formula; with more than 5,000 links the geometry is not analysed."
ALL = "The geometry settles it, for this position and this assembly."
OPEN_CHAIN = "An open chain has no loop: every joint moves freely, so the formula is the truth."


def mobility_of(what: Linkage | Counts, tolerance: float = 0.0) -> Mobility:
    """The freedoms of a linkage: what the formula gives, how many it truly has, and why they differ.

    >>> from dhcli import load_linkage, mobility_of
    >>> found = mobility_of(load_linkage("bennett"))
    >>> found.gruebler, found.mobility, found.motion
    (-2, 1, '0T1R')

    Args:
        what: A linkage with or without geometry, or bare counts.
        tolerance: Relative error of rounded input, 3·10^-decimals of a drawing; 0 for exact input.

    Raises:
        LinkageError: It is no linkage, or the tolerance or the geometry makes no sense.
    """
    if not isinstance(what, Linkage | Counts):
        hint = f"load_linkage({what!r}) loads one" if isinstance(what, str) else "load_linkage loads one"
        raise LinkageError(f"a Linkage is wanted, not {what!r:.60}", hint)
    if not 0 <= tolerance < 0.1:  # noqa: PLR2004  a tenth of the size is no drawing
        raise LinkageError(f"a tolerance of {tolerance:g} is not read", "it is relative to the size, such as 0.003")
    if isinstance(what, Counts):
        return _counted(what)
    counts = Counts.of(what)
    if what.loops == 0 and not any(joint.pair.name in ("gear", "rolling") for joint in what.joints):
        formula = counts.gruebler or 0
        found = _geometry(what, counts, tolerance) if what.is_placed and len(what.links) <= MOST_LINKS else None
        return found or Mobility(
            counts,
            what,
            other=other_reading(what),
            mobility=formula,
            bounds=(formula, formula),
            certificate="exact: there is no loop, so every joint moves freely",
            instantaneous=formula,
            redundant=0,
            output=what.output,
            settles=OPEN_CHAIN,
        )
    if not what.is_placed or len(what.links) > MOST_LINKS:
        settles = ONLY_GRAPH if not what.is_placed else TOO_LARGE
        return Mobility(counts, what, other=other_reading(what), bounds=None, settles=settles)
    return _geometry(what, counts, tolerance)


def _counted(counts: Counts) -> Mobility:
    """What counts alone settle: links that form a tree, nothing else."""
    n, j, formula = counts.n, counts.j, counts.gruebler
    if formula is not None and j == n - 1 and formula >= 0:
        certificate = "exact: with one joint less than links there is no loop"
        return Mobility(
            counts,
            mobility=formula,
            bounds=(formula, formula),
            certificate=certificate,
            instantaneous=formula,
            redundant=0,
            settles=OPEN_CHAIN,
        )
    return Mobility(counts, settles=ONLY_COUNTS)


def _geometry(linkage: Linkage, counts: Counts, tolerance: float) -> Mobility:
    """All that the geometry tells."""
    from dhcli.mobility.reasons import reasons  # numpy is imported only where there is geometry
    from dhcli.mobility.truth import true_mobility

    truth = true_mobility(linkage, tolerance)
    formula = counts.gruebler
    assert formula is not None  # noqa: S101  a joint graph has numbers
    largest = truth.rank.values[0] if truth.rank.values else 1.0
    return Mobility(
        counts,
        linkage,
        mobility=truth.mobility,
        bounds=truth.bounds,
        certificate=truth.certificate,
        instantaneous=truth.instantaneous,
        idle=tuple(str(idle) for idle in truth.idle),
        lambdas=truth.lambdas,
        redundant=None if truth.mobility is None else truth.mobility - formula,
        output=linkage.output,
        motion=truth.motion,
        branches=truth.branches,
        order=truth.order,
        singular_values=tuple(value / largest for value in truth.rank.values) if largest > 0 else truth.rank.values,
        kept=truth.rank.kept,
        dropped=truth.rank.dropped,
        reasons=reasons(linkage, truth, formula, tolerance),
        settles=ALL,
    )
