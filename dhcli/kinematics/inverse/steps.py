"""What a plan is made of."""

from __future__ import annotations

from typing import Literal, TypeAlias

from dhcli.frozen import frozen
from dhcli.kinematics.inverse.matrices import Actions
from dhcli.kinematics.inverse.pairings import Cut

Kind = Literal["both", "opposite", "pair", "length", "lengths"]
"""How a joint is read off: cosine and sine from two equations, two opposite angles from `a c + b s = 0`, two angles
from `a c + b s = e`, a length from a linear or from a quadratic equation."""


@frozen
class Equation:
    """One equation in one unknown.

    Attributes:
        cut: Where the loop is cut.
        x: The thing that the second run leaves fixed.
        y: The thing that the first run leaves fixed.
        size: What its coefficients come to in an ordinary pose.
    """

    cut: Cut
    x: tuple[float, ...]
    y: tuple[float, ...]
    size: float


@frozen
class One:
    """A joint read off equations in which nothing else is unknown.

    Attributes:
        joint: The joint.
        kind: How.
        equations: The equations that serve in an ordinary pose, one or two.
        cuts: Every cut that gives an equation in this joint alone, for poses in which those chosen vanish.
    """

    joint: int
    kind: Kind
    equations: tuple[Equation, ...]
    cuts: tuple[Cut, ...]


@frozen
class Two:
    """A joint from two equations that hold one other joint, which is eliminated.

    Attributes:
        joint: The joint found.
        other: The joint eliminated; it follows by itself.
        equations: A cut and the number of an equation of it, twice.
    """

    joint: int
    other: int
    equations: tuple[tuple[Cut, int], tuple[Cut, int]]


@frozen
class All:
    """Three joints at once from the fourteen equations that two joints and the pose stand against.

    Attributes:
        joints: The joint that becomes an eigenvalue, and two that its eigenvector gives.
        others: The two joints that are eliminated.
        things: For each kind used, the things carried, one a row.
        three: The walk that meets the three joints, and whether it undoes them.
        two: The walk that meets the two joints, and whether it undoes them.
        rows: Which of the equations are independent.
        turn: Angles by which the three joints are counted from another zero, so that no root is at infinity.
    """

    joints: tuple[int, int, int]
    others: tuple[int, int]
    things: tuple[tuple[int, tuple[tuple[float, ...], ...]], ...]
    three: tuple[tuple[int, ...], bool]
    two: tuple[tuple[int, ...], bool]
    rows: tuple[int, ...]
    turn: tuple[float, float, float]


Step: TypeAlias = One | Two | All


def found_by(step: Step) -> tuple[int, ...]:
    """The joints that a step finds."""
    return step.joints if isinstance(step, All) else (step.joint,)


@frozen
class Plan:
    """In which order the joints of an arm are found, and from what.

    Attributes:
        actions: How the joints act.
        held: Joints whose values are given.
        steps: The steps.
        slack: How far its equations are from holding, where axes that are nearly parallel were taken to be.
        meant: The plan of the arm that a measured one was meant to be, where that is an easier one; its solutions are
            beside those wanted.
    """

    actions: Actions
    held: tuple[int, ...]
    steps: tuple[Step, ...]
    slack: float = 0.0
    meant: Plan | None = None

    @property
    def known(self) -> list[int]:
        """The joints that are given, and those that its steps find."""
        return [*self.held, *(j for step in self.steps for j in found_by(step))]

    @property
    def rules(self) -> tuple[str, ...]:
        """The rules used, such as ONE."""
        return tuple(dict.fromkeys(type(step).__name__.upper() for step in self.steps))
