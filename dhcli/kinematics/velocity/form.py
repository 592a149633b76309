"""Which rows a Jacobian has, in what order, and the angles whose rates may stand in the place of ω."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal, TypeVar

from dhcli.algebra.arithmetic import plus, times
from dhcli.errors import RobotError, UnknownNameError, did_you_mean
from dhcli.frozen import frozen
from dhcli.geometry.euler import AXES

N = TypeVar("N")

Which = Literal["all", "linear", "angular"]
PARTS = ("all", "linear", "angular")

LINEAR = ("v_x", "v_y", "v_z")
ANGULAR = ("ω_x", "ω_y", "ω_z")

CYCLIC = frozenset(((0, 1, 2), (1, 2, 0), (2, 0, 1)))

TRIPLES = {"rpy": (2, 1, 0)} | {axes: tuple(map("xyz".index, axes)) for axes in AXES}
"""Orders of axes by name, each turned about where those before have put it: rpy is yaw, pitch, roll about z, y, x."""

TINY = 1e-9
"""Below this a sine or cosine counts as zero."""


def part_of(linear: object, angular: object) -> Which:
    """The rows for which something is given, of v and of ω."""
    return "angular" if linear is None else "linear" if angular is None else "all"


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


@frozen
class Triple:
    """Three angles α, β, γ that say an orientation: R = Rot(a, α) Rot(b, β) Rot(c, γ).

    Attributes:
        name: `rpy`, `zyz` and so on.
        axes: The three axes, 0 to 2.
    """

    name: str
    axes: tuple[int, int, int]

    @classmethod
    def called(cls, name: str) -> Triple:
        """The triple that a person means.

        Raises:
            UnknownNameError: There is none of this name.
        """
        plain = name.strip().lower()
        if plain not in TRIPLES:
            hint = did_you_mean(plain, TRIPLES) or "rpy, or three axes such as zyz, none the same as the one before it"
            raise UnknownNameError(f"there are no angles called {name:.60}", hint)
        first, second, third = TRIPLES[plain]
        return cls(plain, (first, second, third))

    @property
    def is_proper(self) -> bool:
        """Whether the last axis is the first again, as in zyz; these are singular at β = 0, the others at ±90°."""
        return self.axes[0] == self.axes[2]

    @property
    def angles(self) -> tuple[str, str, str]:
        """What α, β and γ are called."""
        return ("yaw", "pitch", "roll") if self.name == "rpy" else ("phi", "theta", "psi")

    @property
    def order(self) -> tuple[int, int, int]:
        """In which order the three are given: roll, pitch, yaw is counted from the last."""
        return (2, 1, 0) if self.name == "rpy" else (0, 1, 2)

    @property
    def singular(self) -> str:
        """Where there are no rates."""
        return f"{self.angles[1]} is {'0 or 180°' if self.is_proper else '±90°'}"

    @property
    def vanishing(self) -> str:
        """The determinant of B, by which ω = B (α', β', γ'): where it is 0 there are no rates."""
        second = self.angles[1]
        size = f"sin({second})" if self.is_proper else f"cos({second})"
        three = [self.rates(axis, (1, 0), (1, 0)) for axis in ((1, 0, 0), (0, 1, 0), (0, 0, 1))]
        (a, b, c), (d, e, f), (g, h, i) = three
        sign = a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)
        return size if sign > 0 else f"-{size}"

    @property
    def _third(self) -> tuple[int, int]:
        """The axis that is neither a nor b, and the sign with which a × b points along it."""
        first, second, _ = self.axes
        third = 3 - first - second
        return third, 1 if (first, second, third) in CYCLIC else -1

    def rates(
        self, omega: Sequence[N | int], alpha: tuple[N | int, N | int], beta: tuple[N | int, N | int]
    ) -> tuple[N | int, N | int, N | int]:
        """α', β', γ' in the order in which they are given: B⁻¹ ω.

        Args:
            omega: Angular velocity along the axes of the reference, three numbers of any kind.
            alpha: Cosine and sine of α.
            beta: One over the sine of β, in zyz and its like, or over its cosine, which vanish where there are no
                rates; and the other of the two.

        Source: B of Siciliano, Sciavicco, Villani and Oriolo, eq. 3.64, for every order of axes.
        """
        first, second, _ = self.axes
        third, sign = self._third
        cos, sin = alpha
        u, v = (second, third) if sign > 0 else (third, second)
        # ω along the axes that Rot(a, α) has reached
        turned = {
            u: plus(times(cos, omega[u]), times(sin, omega[v])),
            v: plus(times(cos, omega[v]), times(times(-1, sin), omega[u])),
        }
        last = times(turned[third], beta[0])
        if self.is_proper:
            last = times(-sign, last)
        share = times(beta[1], last)
        along = plus(omega[first], times(-1 if self.is_proper else -sign, share))
        three = (along, turned[second], last)
        one, two, three_ = self.order
        return three[one], three[two], three[three_]

    def seen(self, rotation: Sequence[Sequence[N | int]]) -> tuple[N | int, N | int, N | int]:
        """What an orientation says of α and β: r·cos α and r·sin α with r >= 0, and the other of cos β and sin β.

        Where r, which is |sin β| in zyz and |cos β| in zyx, is 0, there are no rates.

        Args:
            rotation: Three rows of direction cosines, numbers of any kind.
        """
        first, second, last = self.axes
        third, sign = self._third
        if self.is_proper:
            return times(-sign, rotation[third][first]), rotation[second][first], rotation[first][first]
        return rotation[last][last], times(-sign, rotation[second][last]), times(sign, rotation[first][last])
