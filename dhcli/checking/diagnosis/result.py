"""What a diagnosis says. Plain data, so that a mark may carry it anywhere."""

from __future__ import annotations

from enum import IntEnum

from dhcli.frozen import frozen


class Rank(IntEnum):
    """How soon a mistake is named where several give the same answer: what is plain before what is far-fetched."""

    WHOLE = 0
    PLACE = 1
    SYMPTOM = 2


@frozen
class Slip:
    """A mistake in its place.

    Attributes:
        name: What exercises call it, such as `alpha-sign 2`.
        words: What has happened.
        hint: Where to look, without the answer.
        rank: How soon it is named.
    """

    name: str
    words: str
    hint: str
    rank: Rank = Rank.PLACE


@frozen
class Diagnosis:
    """Why an answer is wrong.

    Attributes:
        causes: Slips that give just this answer, one or two together; each cause is enough by itself.
        follows: Earlier parts from whose answers this one is right.
    """

    causes: tuple[tuple[Slip, ...], ...] = ()
    follows: tuple[str, ...] = ()

    @property
    def names(self) -> tuple[str, ...]:
        """Each cause in words."""
        return tuple(" and ".join(slip.words for slip in cause) for cause in self.causes)

    @property
    def ids(self) -> tuple[str, ...]:
        """Each cause as exercises call it."""
        return tuple(" + ".join(slip.name for slip in cause) for cause in self.causes)

    @property
    def hints(self) -> tuple[str, ...]:
        """Where to look, each place once."""
        return tuple(dict.fromkeys(slip.hint for cause in self.causes for slip in cause))
