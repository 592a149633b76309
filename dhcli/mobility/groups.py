"""Things that turn out to be one: links that are welded, pins at one place of a link."""

from __future__ import annotations


class Groups:
    """Numbers that stand for the same thing; each by itself at first.

    Source: Tarjan 1975, union and find with the ways halved.
    """

    def __init__(self) -> None:
        """Begin with each number by itself."""
        self._above: dict[int, int] = {}

    def of(self, one: int) -> int:
        """The number that all of a group share."""
        while (above := self._above.get(one, one)) != one:
            self._above[one] = one = self._above.get(above, above)
        return one

    def join(self, one: int, other: int) -> None:
        """Make two groups one."""
        self._above[self.of(one)] = self.of(other)
