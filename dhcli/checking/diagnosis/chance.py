"""Whether an answer says enough for the name of a slip not to be chance.

Among thousands of candidates some lie near any answer that was typed to one decimal. So before a slip is named, it is
estimated how many candidates an answer would meet that came about in some other way: those that are wrong in the same
entries, times the share of the range of each of these entries that the digits typed leave open.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence

from dhcli.checking.diagnosis.work import Matrix
from dhcli.checking.truth import is_length
from dhcli.checking.wanted import Wanted
from dhcli.frozen import frozen

MOST = {"singles": 0.05, "pairs": 0.01}
"""How many candidates may be met by chance. One slip is likely in itself; two at once have to show more."""

EXACT = 1e-9
WHOLE = 0.1
"""How often people who guess write 0, or 1 and -1 for a direction: no pair is believed because of those, and no slip
where every entry is one of them, unless the right ones are, too."""

OUTER = 8
"""A part of so many is left out of a range at either end."""


@frozen
class Evidence:
    """The entries of an answer at one point, in a row.

    Attributes:
        values: The entries.
        slack: What each may be off.
        truth: The right ones.
        lengths: Whether each is a length; else it is a direction cosine.
    """

    values: Sequence[float]
    slack: Sequence[float]
    truth: Sequence[float]
    lengths: Sequence[bool]

    @property
    def wrong(self) -> tuple[int, ...]:
        """The places of the entries that are not right."""
        return self.is_wrong_at(self.values)

    def is_wrong_at(self, values: Sequence[float]) -> tuple[int, ...]:
        """The places in which other entries are not right."""
        places = enumerate(zip(values, self.truth, self.slack, strict=True))
        return tuple(k for k, (value, right, limit) in places if not abs(value - right) <= limit + EXACT)


def is_chance(stage: str, given: Iterable[Sequence[float]], typed: Evidence) -> bool:
    """Whether any answer with these digits would meet the candidates of a stage, `singles` or `pairs`, too often."""
    wrong = typed.wrong
    left = [one for one in given if typed.is_wrong_at(one) == wrong]
    shares: dict[bool, list[float]] = {True: [], False: []}
    is_guess = stage == "pairs" or (_are_whole(typed.values, typed) and not _are_whole(typed.truth, typed))
    for k in wrong:
        spread = _spread([typed.truth[k], *(one[k] for one in left)], typed.values[k])
        share = min(1.0, 2 * typed.slack[k] / spread) if spread > EXACT else 1.0
        shares[typed.lengths[k]].append(
            max(share, WHOLE) if is_guess and _is_whole(typed.values[k], is_length=typed.lengths[k]) else share
        )
    free = 2 if len(typed.values) <= 3 else 3  # noqa: PLR2004  of a direction, and of a rotation
    return len(left) * math.prod((*shares[True], *sorted(shares[False])[:free])) > MOST[stage]


def _is_whole(value: float, *, is_length: bool) -> bool:
    """Whether an entry is one that people type who guess."""
    return any(abs(value - whole) <= EXACT for whole in ((0,) if is_length else (0, 1, -1)))


def _are_whole(values: Sequence[float], typed: Evidence) -> bool:
    return all(_is_whole(value, is_length=length) for value, length in zip(values, typed.lengths, strict=True))


def _spread(values: list[float], typed: float) -> float:
    """The range of values without the outermost, such as millimetres taken for metres; it reaches to what was typed.

    Where the others are all the same, the outermost are all there is.
    """
    values.sort()
    cut = len(values) // OUTER
    if values[-1 - cut] - values[cut] <= EXACT:
        cut = 0
    return max(typed, values[-1 - cut]) - min(typed, values[cut])


def lengths_of(question: Wanted, entries: Matrix[float]) -> tuple[bool, ...]:
    """Whether each entry is a length, row by row."""
    return tuple(is_length(question, r, c) for r, row in enumerate(entries) for c in range(len(row)))
