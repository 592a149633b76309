"""One projection for everything: parallel, by azimuth and elevation, scaled to fit the paper."""

from __future__ import annotations

import math
from collections.abc import Iterable

from dhcli.errors import DhcliError, Problem, did_you_mean
from dhcli.frozen import frozen
from dhcli.geometry.vectors import Vector, dot
from dhcli.scene.vectors import Flat

VIEWS = {"iso": (37.0, 26.0), "front": (0.0, 0.0), "side": (-90.0, 0.0), "top": (-90.0, 90.0)}
"""Named views: azimuth and elevation of the eye [deg]."""


class ViewError(DhcliError):
    """A view that there is not."""


@frozen
class Camera:
    """Where a figure is seen from.

    Attributes:
        azimuth: Of the eye, about z from x [deg].
        elevation: Of the eye above the plane of x and y [deg].
        right: The direction in space that points to the right on paper.
        up: The one that points up.
        towards: The one that points at the reader.
        scale: Pixels for a metre.
        centre: What lies at the middle of the paper, in pixels before it is moved there.
        middle: The middle of the paper in pixels.
    """

    azimuth: float
    elevation: float
    right: Vector
    up: Vector
    towards: Vector
    scale: float = 1.0
    centre: Flat = (0.0, 0.0)
    middle: Flat = (0.0, 0.0)

    @classmethod
    def at(cls, azimuth: float, elevation: float) -> Camera:
        """A camera that looks at the origin."""
        ca, sa = _cos_sin(azimuth)
        ce, se = _cos_sin(elevation)
        return cls(azimuth, elevation, (-sa, ca, 0.0), (-se * ca, -se * sa, ce), (ce * ca, ce * sa, se))

    def flat(self, point: Vector) -> Flat:
        """Where a point is on paper, to the right and down [px]."""
        return (
            self.middle[0] + self.scale * dot(point, self.right) - self.centre[0],
            self.middle[1] - self.scale * dot(point, self.up) - self.centre[1],
        )

    def flat_direction(self, direction: Vector) -> Flat:
        """A direction on paper, as long as it looks for a length of one."""
        return dot(direction, self.right), -dot(direction, self.up)

    def depth(self, point: Vector) -> float:
        """How near a point is to the reader [m]."""
        return dot(point, self.towards)

    def fitted(self, points: Iterable[Vector], room: tuple[float, float, float, float], most: float) -> Camera:
        """The same view with all points inside a rectangle.

        Args:
            points: What must be seen.
            room: Left, top, right and bottom of the rectangle [px].
            most: The largest scale [px/m].
        """
        flats = [self.flat_direction(point) for point in points] or [(0.0, 0.0)]
        left, right = min(x for x, _ in flats), max(x for x, _ in flats)
        top, bottom = min(y for _, y in flats), max(y for _, y in flats)
        width, height = room[2] - room[0], room[3] - room[1]
        scale = min(width / max(right - left, 1e-300), height / max(bottom - top, 1e-300), most)
        centre = scale * (left + right) / 2, scale * (top + bottom) / 2
        middle = (room[0] + room[2]) / 2, (room[1] + room[3]) / 2
        return Camera(self.azimuth, self.elevation, self.right, self.up, self.towards, scale, centre, middle)


def view_given(view: object) -> tuple[float, float]:
    """A view as a name, a text or two numbers: azimuth and elevation in degrees.

    Raises:
        ViewError: It is none of them; the hint lists the names.
    """
    if isinstance(view, str):
        return read_view(view)
    pair = view if isinstance(view, tuple | list) else ()
    try:
        return read_view(",".join(str(float(angle)) for angle in pair))
    except (TypeError, ValueError, OverflowError, ViewError):
        raise ViewError(Problem(f"{view!r:.60} is no view", None, _known())) from None


def _known() -> str:
    return f"{', '.join(VIEWS)}, or azimuth and elevation in degrees such as 30,20"


def read_view(text: str) -> tuple[float, float]:
    """A view by its name, or as azimuth and elevation in degrees, `30,20`.

    Raises:
        ViewError: It is neither; the hint lists the names.
    """
    word = text.strip().lower()
    if word in VIEWS:
        return VIEWS[word]
    hint = _known()
    pieces = word.replace("°", "").split(",")
    if len(pieces) != 2:  # noqa: PLR2004  two angles
        near = did_you_mean(word, VIEWS)
        hint = f"{near} {hint}" if near.startswith("did") else hint
        raise ViewError(Problem(f"there is no view '{text.strip()}'", None, hint))
    try:
        azimuth, elevation = (float(piece) for piece in pieces)
    except ValueError:
        raise ViewError(Problem(f"'{text.strip()}' is no view", None, hint)) from None
    if not (math.isfinite(azimuth) and -90 <= elevation <= 90):  # noqa: PLR2004  straight down to straight up
        raise ViewError(Problem(f"'{text.strip()}' is no view: an elevation is from -90 to 90", None, hint))
    return math.remainder(azimuth, 360.0), elevation


def _cos_sin(degrees: float) -> tuple[float, float]:
    if degrees % 90 == 0:
        quarter = int(degrees // 90) % 4
        return (1.0, 0.0, -1.0, 0.0)[quarter], (0.0, 1.0, 0.0, -1.0)[quarter]
    return math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
