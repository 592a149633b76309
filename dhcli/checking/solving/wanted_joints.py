"""What is asked for of joint values, as marking and the search for slips need it."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Protocol

from dhcli.checking.exercise import Case
from dhcli.checking.returned import Reading
from dhcli.checking.solving.goal import Target
from dhcli.checking.solving.reading import Vector
from dhcli.checking.solving.vectors import Range
from dhcli.checking.verdicts import Mark


class WantedJoints(Protocol):
    """A question about joint values; see `JointsQuestion`."""

    @property
    def target(self) -> Target:
        """The pose."""
        ...

    @property
    def which(self) -> str:
        """Whether all solutions are asked for, or one: any, or that of a branch."""
        ...

    @property
    def branch(self) -> tuple[str, ...]:
        """The words of the branch asked for."""
        ...

    @property
    def within_limits(self) -> bool:
        """Whether they must be inside the limits of the joints."""
        ...

    def range_of(self, case: Case) -> Range:
        """What the robot does there."""
        ...

    def wanted(self, case: Case) -> list[int]:
        """The solutions asked for, by number."""
        ...

    def text_of(self, case: Case, rows: Iterable[tuple[float, ...]]) -> str:
        """Joint values as they are typed."""
        ...

    def mark(self, case: Case, reading: Reading[tuple[Vector, ...]]) -> Mark:
        """Judge an answer."""
        ...
