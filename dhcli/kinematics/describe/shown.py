"""How many decimals of its numbers a description needs before a person, who reads none of those behind."""

from __future__ import annotations

import math

from dhcli.algebra.floats import Floats
from dhcli.frozen import frozen
from dhcli.kinematics.describe.description import Described, known_values
from dhcli.kinematics.describe.proof import reach_of
from dhcli.kinematics.moves import names

OFF = 1e-6
"""How far the tip may be off for what is rounded [m]; of a robot smaller than a metre, as a part of its size."""
LEAST = 4
_CELLS = 4
"""Numbers in the row of a table; those of base and tool are counted as two rows more."""


@frozen
class Shown:
    """What a person is shown of numbers.

    Attributes:
        places: Decimals.
        off: How far the tip is off at most for the rest of them [m]; None where nobody knows how large the robot is.
    """

    places: int
    off: float | None


def shown(result: Described) -> Shown:
    """The fewest decimals that keep the tip where it is, to a micrometre or a millionth of the robot.

    Every number may be off by half of its last decimal: a length moves the tip by as much, and an angle, or a
    direction, by so much of everything that lies behind it. Lengths without a value are left out.
    """
    robot, known = result.robot, known_values(result.robot)
    inside = names(robot.chain)
    over = Floats(dict.fromkeys(inside, 0.0) | known)
    size = reach_of(robot.chain, over) or 1.0
    each = _CELLS * (len(robot.links) + 2) * (1.0 + size) / 2
    places = max(LEAST, math.ceil(math.log10(each / (OFF * min(size, 1.0)))))
    is_known = inside <= known.keys() | robot.angles | set(robot.variables)
    return Shown(places, each * 10.0**-places if is_known else None)
