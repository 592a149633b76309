"""What a scene consists of; every point is anchored to a state, so that a moved joint moves what hangs on it."""

from __future__ import annotations

from typing import Literal, NamedTuple, TypeAlias

from dhcli.frozen import frozen
from dhcli.geometry.vectors import Vector
from dhcli.scene.vectors import Frame
from dhcli.scene.words import Words


class Anchor(NamedTuple):
    """A point that is fixed to a state.

    Attributes:
        state: Number of the state.
        at: Where it is, in the frame of that state.
    """

    state: int
    at: Vector


@frozen
class Rod:
    """A straight piece of a link.

    Attributes:
        start: One end.
        end: The other.
        thickness: Half of how thick it is [m].
        ground: Whether it is the link that stands still.
    """

    start: Anchor
    end: Anchor
    thickness: float
    ground: bool = False


@frozen
class Drum:
    """The body of a joint that turns: a cylinder about its axis.

    Attributes:
        name: The joint variable.
        centre: Its middle.
        axis: Direction of its axis in the same state; positive angles turn about it by the right-hand rule.
        radius: Its radius [m].
        half: Half of its length [m].
    """

    name: str
    centre: Anchor
    axis: Vector
    radius: float
    half: float


@frozen
class Box:
    """The body of a joint that slides.

    Attributes:
        name: The joint variable.
        centre: Its middle.
        axis: The direction in which it slides, in the same state.
        side: A direction at right angles.
        half: Half of its length along the axis; it is a little less wide [m].
    """

    name: str
    centre: Anchor
    axis: Vector
    side: Vector
    half: float


@frozen
class Ball:
    """A ball joint, or the cross of a universal joint."""

    centre: Anchor
    radius: float


@frozen
class Face:
    """A flat link with three corners or more.

    Attributes:
        corners: Its corners in order.
        ground: Whether it is the link that stands still.
    """

    corners: tuple[Anchor, ...]
    ground: bool = False


Solid: TypeAlias = Drum | Box | Ball | Face


@frozen
class Arrow:
    """An axis of a frame, its direction in the same state, its length in metres, with what is written at its tip."""

    start: Anchor
    direction: Vector
    letter: Literal["x", "y", "z"]
    words: Words
    length: float


@frozen
class Dimension:
    """A length of the table where its convention has it: d along z, a along x.

    Attributes:
        start: One end.
        end: The other.
        words: The length as it stands in the table.
        variable: Whether it is a joint variable.
        direct: Whether it is drawn where it is, and not beside: no link runs there.
    """

    start: Anchor
    end: Anchor
    words: Words
    variable: bool = False
    direct: bool = False


@frozen
class Plate:
    """The ground under an arm, or a broken end where the arm goes on.

    Attributes:
        centre: Where the arm stands on it.
        normal: The direction to the arm, in the same state.
        size: Half of its side [m].
        broken: Whether it is the break of a link that goes on, and no ground.
    """

    centre: Anchor
    normal: Vector
    size: float
    broken: bool = False


@frozen
class Hand:
    """The hand: a fork with two fingers.

    Attributes:
        wrist: Where it begins.
        forward: The direction of its fingers, in the same state.
        across: The direction in which they open.
        size: Its length [m].
    """

    wrist: Anchor
    forward: Vector
    across: Vector
    size: float


@frozen
class Mark:
    """A name at a point, such as that of a pin."""

    at: Anchor
    words: Words


@frozen
class Scene:
    """Everything that a figure shows, in space.

    Attributes:
        states: Frames that the points are anchored to.
        solids: Bodies of joints.
        rods: Pieces of links.
        arrows: Axes of frames; equal ones that coincide are one.
        dimensions: Lengths of the table.
        plate: The ground, if there is one.
        hand: The hand, if there is one.
        marks: Names of points.
        unit: The radius of a drum, from which everything else has its size [m].
        pinned: Point of the ground in the plane, drawn as a triangle; for arms that are seen from above.
    """

    states: tuple[Frame, ...]
    unit: float
    solids: tuple[Solid, ...] = ()
    rods: tuple[Rod, ...] = ()
    arrows: tuple[Arrow, ...] = ()
    dimensions: tuple[Dimension, ...] = ()
    plate: Plate | None = None
    hand: Hand | None = None
    marks: tuple[Mark, ...] = ()
    pinned: tuple[Anchor, ...] = ()

    def point(self, anchor: Anchor) -> Vector:
        """Where an anchored point is in the world [m]."""
        return self.states[anchor.state].point(anchor.at)

    def direction(self, state: int, local: Vector) -> Vector:
        """Where a direction of a state points in the world."""
        return self.states[state].direction(local)
