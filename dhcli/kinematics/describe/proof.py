"""The proof that two chains are the same motion: in residues where letters and angles are exact, else in floats."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Literal

from dhcli.algebra.arithmetic import CannotHoldError
from dhcli.algebra.floats import Floats
from dhcli.algebra.residues import Residues
from dhcli.errors import RobotError
from dhcli.frozen import frozen
from dhcli.kinematics.fold import fold
from dhcli.kinematics.moves import Chain, Rot, angle_names, expressions, names
from dhcli.notation.angle import Angle

CLOSE = 1e-13
"""Largest difference of a direction cosine, and of a coordinate for each metre of reach."""

POSES = 20


@frozen
class Proof:
    """How it was proved that nothing has changed.

    Attributes:
        kind: `exact` for all values of all names; `numbers` at drawn poses.
        error: The largest difference found; 0 for an exact proof.
    """

    kind: Literal["exact", "numbers"]
    error: float = 0.0


def proved(first: Chain, second: Chain, values: Mapping[str, Angle | float], close: float = CLOSE) -> Proof:
    """Prove that two chains lead to the same frame for all values of their names.

    Args:
        first: One chain.
        second: The other.
        values: Values of letters that a comparison in floats uses; the others are drawn.
        close: What counts as the same there.

    Raises:
        RobotError: They are two motions; this is a fault of dhcli's, and nothing is written.
    """
    angles = [move.angle for move in (*first, *second) if isinstance(move, Rot)]
    try:
        over = Residues(tuple(expressions((*first, *second))), angles)
        same = all(
            over.value(a) == over.value(b)
            for one, two in zip(fold(first, over), fold(second, over), strict=True)
            for a, b in zip(one, two, strict=True)
        )
        if same:
            return Proof("exact")
    except (CannotHoldError, ZeroDivisionError):
        pass
    error = _difference(first, second, values)
    if not error <= close:
        raise RobotError(f"the two descriptions differ by {error:.2g} of the reach", "this is a fault of dhcli's")
    return Proof("numbers", error)


def _difference(first: Chain, second: Chain, values: Mapping[str, Angle | float]) -> float:
    import random  # slow to import, and most proofs need no floats

    draw = random.Random(29)  # noqa: S311  the same poses every time
    turning = angle_names((*first, *second))
    worst = 0.0
    for _ in range(POSES):
        drawn = {
            name: draw.uniform(-math.pi, math.pi) if name in turning else draw.uniform(0.2, 1.3)
            for name in sorted(names((*first, *second)))
        }
        over = Floats({**drawn, **values})
        one, two = fold(first, over), fold(second, over)
        reach = max(1e-3, reach_of(first, over))
        for r, s in zip(one[:3], two[:3], strict=True):
            worst = max(worst, *(abs(a - b) for a, b in zip(r[:3], s[:3], strict=True)), abs(r[3] - s[3]) / reach)
    return worst


def reach_of(chain: Chain, over: Floats) -> float:
    """The sum of all lengths on the way."""
    total = 0.0
    for move in chain:
        if not isinstance(move, Rot):
            offset = move.offset if hasattr(move, "offset") else tuple(row[3] for row in move.rows)
            total += math.sqrt(sum(over.value(expr) ** 2 for expr in offset))
    return total
