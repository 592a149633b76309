"""Where a robot is singular, as data."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field
from typing import Literal

from dhcli.frozen import frozen
from dhcli.kinematics.velocity.form import Which
from dhcli.notation.styles import THETAS, Joints
from dhcli.notation.tree import Expr
from dhcli.notation.writer import write

Finding = Literal["factors", "conditions", "everywhere", "never", "unreadable"]

MOST_JOINTS = 9
"""Arms with more joints have too many determinants."""


@frozen
class Factor:
    """A factor of a determinant that joints can make zero, or a condition of several expressions that are zero at once.

    Attributes:
        zeros: What is zero there: one expression, or several at once.
        exponent: How often it stands in the determinant.
        joints: The joints on which it depends.
        angles: The same in the values of joints, where it can be said so: `theta5 is 0 or 180°`.
        words: The picture of the arm there.
        dependent: Joints whose columns are dependent there.
        lost: The motion that cannot be made there.
    """

    zeros: tuple[Expr, ...]
    exponent: int = 1
    joints: tuple[str, ...] = ()
    angles: str = ""
    words: str = ""
    dependent: tuple[str, ...] = ()
    lost: str = ""

    def text(self, style: str = "short", joints: Joints = THETAS) -> str:
        """`s5 = 0`, `s2 = 0 and s6 = 0`."""
        return " and ".join(f"{write(zero, style, joints)} = 0" for zero in self.zeros)


@frozen
class Singularities:
    """Where a Jacobian loses rank.

    Attributes:
        finding: What was found: factors of a determinant, conditions where there is no determinant, a rank that is
            never full or always, or no list that anybody would read.
        start: The frame held still.
        end: The frame that moves.
        part: The rows that are the task.
        rows: Labels of those rows of the six that the joints can move at all.
        joints: The joints, a column each.
        rank: The rank at almost all joint values.
        still: Joints that do not move the task at all.
        place: The point whose velocity the sentences speak of, in words.
        determinant: The determinant in factors, or None.
        factors: What makes the rank fall; each alone.
        probed: Joints at multiples of a right angle where the rank falls, for an arm without a readable list.
        writing: The robot's joint angles, for shorthand.
    """

    finding: Finding
    start: str
    end: str
    part: Which
    rows: tuple[str, ...]
    joints: tuple[str, ...]
    rank: int
    still: tuple[str, ...] = ()
    place: str = ""
    determinant: Expr | None = None
    factors: tuple[Factor, ...] = ()
    probed: tuple[Mapping[str, int], ...] = ()
    writing: Joints = field(default=THETAS, compare=False, repr=False)

    def __str__(self) -> str:
        """The determinant and its zeros, or the conditions."""
        lines = [] if self.determinant is None else [f"det = {write(self.determinant, 'short', self.writing)}"]
        lines += [factor.text("short", self.writing) for factor in self.factors]
        return "\n".join(lines) or self.finding
