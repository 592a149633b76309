"""Which rows a Jacobian has, and in what order."""

from __future__ import annotations

from typing import Literal, TypeVar

from dhcli.errors import RobotError
from dhcli.frozen import frozen
from dhcli.kinematics.velocity.analytic import Triple

N = TypeVar("N")

Which = Literal["all", "linear", "angular"]
PARTS = ("all", "linear", "angular")

LINEAR = ("v_x", "v_y", "v_z")
ANGULAR = ("ω_x", "ω_y", "ω_z")


def check_part(part: object) -> None:
    """Refuse what is no part of a Jacobian.

    Raises:
        RobotError: There is no such part.
    """
    if not isinstance(part, str) or part not in PARTS:
        raise RobotError(f"a Jacobian has no part {part!s:.60}", f"parts: {', '.join(PARTS)}")


@frozen
class Form:
    """Which rows a Jacobian has, and in what order.

    Attributes:
        part: All six rows, or those of v or ω alone.
        angular_first: Whether ω stands above v, as in Lynch and Park.
        analytic: Name of the angles whose rates stand in the place of ω, `rpy` or `zyz`; empty for ω itself.
    """

    part: Which = "all"
    angular_first: bool = False
    analytic: str = ""

    @property
    def labels(self) -> tuple[str, ...]:
        """What each row is."""
        angular = ANGULAR
        if self.analytic:
            triple = Triple.called(self.analytic)
            one, two, three = (triple.angles[k] + "'" for k in triple.order)
            angular = (one, two, three)
        return self.chosen(LINEAR, angular)

    @property
    def rows(self) -> tuple[int, ...]:
        """The number of each row among the six, v above ω, from 0."""
        return self.chosen((0, 1, 2), (3, 4, 5))

    def chosen(self, linear: tuple[N, ...], angular: tuple[N, ...]) -> tuple[N, ...]:
        """The rows that are asked for, in their order."""
        upper = linear if self.part != "angular" else ()
        lower = angular if self.part != "linear" else ()
        return (*lower, *upper) if self.angular_first else (*upper, *lower)


GEOMETRIC = Form()
