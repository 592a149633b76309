"""What decides where the rules leave a choice: the frame before, the normal after, or frames that are known already."""

from __future__ import annotations

from collections.abc import Sequence

from dhcli.errors import UnknownNameError, did_you_mean
from dhcli.frozen import frozen
from dhcli.geometry.vectors import Vector
from dhcli.kinematics.describe.drawn import Frame, Line, same_direction
from dhcli.kinematics.describe.linear import Point, Ruler, along, moved, shifted
from dhcli.kinematics.describe.normals import origin_on

NEXT_D, PREVIOUS_X = "next-d", "previous-x"
WORDS = {
    NEXT_D: "between parallel axes the normal stands where the next d is 0",
    PREVIOUS_X: "x keeps the side of the x before, so that a may be negative",
}
"""What may be chosen otherwise than usually, as it is asked for."""


@frozen
class Choices:
    """How free choices are made; by default each d is 0 and each a positive, as far as they may be.

    Attributes:
        next_d: Whether the normal of parallel axes stands where the next d is 0, and not the own one.
        previous_x: Whether x lies on the side of the x before, also where a becomes negative.
        like: Frames to end up with, one for each normal, of which each x lies along its normal and each origin on it.
    """

    next_d: bool = False
    previous_x: bool = False
    like: tuple[Frame, ...] = ()

    @property
    def is_signed(self) -> bool:
        """Whether a may be negative."""
        return self.previous_x or bool(self.like)

    def near(self, k: int, here: Frame, lines: Sequence[Line], ruler: Ruler) -> Frame:
        """The frame that decides about the normal from line k to line k+1, its origin on line k.

        Args:
            k: Which line the normal starts from.
            here: The frame before, which stands on line k.
            lines: All lines, from that of the base to that of the end.
            ruler: What decides about lengths.
        """
        direction = lines[k].direction
        if self.like:
            frame = self.like[k]
            return Frame(frame.x, here.z, _beside(here.origin, frame.origin, direction, ruler))
        if self.next_d and 0 < k < len(lines) - 2:
            return Frame(here.x, here.z, _beside(here.origin, _next_origin(k + 1, lines, ruler), direction, ruler))
        return here


USUAL = Choices()
"""What is chosen where nobody says anything."""


def read_choices(text: str) -> Choices:
    """Choices by their names, with commas between.

    Raises:
        UnknownNameError: There is none of a name.
    """
    names = [name for part in text.split(",") if (name := part.strip().lower())]
    for name in names:
        if name not in WORDS:
            raise UnknownNameError(f"there is no choice {name}", did_you_mean(name, WORDS))
    return Choices(next_d=NEXT_D in names, previous_x=PREVIOUS_X in names)


def _beside(start: Point, other: Point, direction: Vector, ruler: Ruler) -> Point:
    """The point on the line through a start that is as far along it as another point."""
    return ruler.cleaned_point(shifted(start, direction, along(moved(other, start, -1), direction)))


def _next_origin(k: int, lines: Sequence[Line], ruler: Ruler) -> Point:
    """Where the frames behind line k have to stand: at the first normal that is not free, else at the end."""
    for j in range(k, len(lines) - 1):
        if not same_direction(lines[j].direction, lines[j + 1].direction):
            return origin_on(lines, j, ruler)
    return lines[-1].through or {}
