"""A linkage as data: links, the joints that tie them, and where these are in one assembled position."""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import cached_property

from dhcli.errors import Problem, did_you_mean, plural
from dhcli.frozen import frozen
from dhcli.geometry.vectors import Vector, dot, length
from dhcli.kinematics.validity import Finding
from dhcli.mobility.pairs import SPATIAL, LinkageError, Pair, Space

TINY = 1e-12
"""Below this a direction is no direction."""

SQUARE = 0.01
"""Cosine of two directions that are at right angles as far as a rounded drawing tells."""


@frozen
class Joint:
    """What ties two links, in world coordinates of the assembled position.

    Attributes:
        pair: What kind of joint it is.
        links: The two links it ties.
        name: What it is called; the loader numbers those without a name.
        point: A point on its axis, a pin, a ball's centre, the first centre of curvature [m].
        axis: Its direction, of any length.
        axis2: The second axis of a universal joint.
        other: The far end of a bar, the second centre of curvature, the second wheel's centre [m].
        slide: The direction of a slot, which is cut into the first link.
        pitch: Advance of a screw in one turn [m].
        carrier: The link in which both wheels of a gear pair turn.
        radii: Radii of the two wheels, in the order of the links.
        internal: Whether one of the wheels has its teeth inside.
    """

    pair: Pair
    links: tuple[str, str]
    name: str = ""
    point: Vector | None = None
    axis: Vector | None = None
    axis2: Vector | None = None
    other: Vector | None = None
    slide: Vector | None = None
    pitch: float | None = None
    carrier: str | None = None
    radii: tuple[float, float] | None = None
    internal: bool = False

    def needs(self, space: Space) -> tuple[str, ...]:
        """The fields that give its geometry in a space."""
        return self.pair.flat_needs if space.is_planar else self.pair.needs

    def is_placed(self, space: Space) -> bool:
        """Whether all of its geometry is known."""
        return all(getattr(self, name) is not None for name in self.needs(space))


@frozen
class NamedPoint:
    """A point that the description gives a name.

    Attributes:
        name: Its name, such as that of a pin.
        at: Where it is [m].
        link: The link that holds it where no joint does, such as the free end of a bar; else empty.
    """

    name: str
    at: Vector
    link: str = ""


class InvalidLinkageError(LinkageError):
    """A description that is no linkage.

    Attributes:
        findings: Every broken rule.
    """

    def __init__(self, findings: tuple[Finding, ...]) -> None:
        """Collect the findings of one linkage."""
        self.findings = findings
        super().__init__(Problem(finding.message, None, finding.hint) for finding in findings)


@frozen
class Linkage:
    """Links tied by joints; one that exists is connected and has a ground.

    Attributes:
        name: What it is called in the library.
        space: Where it moves; gives λ.
        joints: Its joints.
        ground: The link that stands still.
        output: The link whose motion is asked for; empty if none is.
        title: What it is called in words.
        source: Where it comes from.
        notes: What else a reader should know.
        reading: How a short pattern was read, such as `open chain with the ground`.
        points: The points that have a name, with those that no joint holds; for pictures.

    Raises:
        InvalidLinkageError: With every finding, if it is not a linkage.
    """

    name: str
    space: Space
    joints: tuple[Joint, ...]
    ground: str
    output: str = ""
    title: str = ""
    source: str = ""
    notes: str = ""
    reading: str = ""
    points: tuple[NamedPoint, ...] = ()

    def __post_init__(self) -> None:
        """Refuse to exist with anything wrong."""
        if findings := tuple(_findings(self)):
            raise InvalidLinkageError(findings)

    def __repr__(self) -> str:
        """One line, as the prompt shows it."""
        return f"<Linkage {self.name}: {self.title}, {plural(len(self.links), 'link')} {self.pattern}>"

    @cached_property
    def links(self) -> tuple[str, ...]:
        """All links, the ground first, the others as the joints name them."""
        return tuple(dict.fromkeys((self.ground, *(link for joint in self.joints for link in joint.links))))

    @cached_property
    def is_placed(self) -> bool:
        """Whether the geometry of every joint is known, so that its true mobility can be found."""
        return all(joint.is_placed(self.space) for joint in self.joints)

    @cached_property
    def loops(self) -> int:
        """The number of independent loops: joints less than a tree would have."""
        return len(self.joints) - len(self.links) + 1

    @cached_property
    def pattern(self) -> str:
        """The joints in short: `4R`, `3R 1P`, `6U 6P 6S`."""
        counts: dict[str, int] = {}
        for joint in self.joints:
            word = joint.pair.letter or f" {joint.pair.name}"
            counts[word] = counts.get(word, 0) + 1
        return " ".join(f"{count}{word}" for word, count in counts.items())


def serial(name: str, pairs: tuple[Pair, ...], *, title: str = "", source: str = "") -> Linkage:
    """An open chain: a ground, and one moving link behind each joint."""
    links = ("ground", *(str(i) for i in range(1, len(pairs) + 1)))
    joints = tuple(Joint(pair, (links[i], links[i + 1]), str(i + 1)) for i, pair in enumerate(pairs))
    return Linkage(name, SPATIAL, joints, "ground", links[-1], title=title, source=source)


def _findings(linkage: Linkage) -> Iterator[Finding]:
    """Everything that keeps a description from being a linkage."""
    if not linkage.joints:
        yield Finding(("joints",), "a linkage has at least one joint")
        return
    known = list(dict.fromkeys(link for joint in linkage.joints for link in joint.links))
    for key in ("ground", "output"):
        link = getattr(linkage, key)
        if key == "ground" and not link:
            yield Finding(("joints",), "no link is the ground", "name one of them ground, or say ground: NAME")
        elif link and link not in known:
            hint = did_you_mean(link, known) or f"links: {', '.join(known)}"
            yield Finding((key,), f"{key}: no joint ties a link called {link}", hint)
    for i, joint in enumerate(linkage.joints):
        for message, hint in _joint_findings(joint, linkage, known):
            yield Finding(("joints", i), f"joint {joint.name or i + 1}: {message}", hint)
    yield from _apart(linkage, known)


def _joint_findings(joint: Joint, linkage: Linkage, known: list[str]) -> Iterator[tuple[str, str]]:
    first, second = joint.links
    if first == second:
        yield f"ties {first} to itself", "a joint ties two links"
    try:
        linkage.space.freedoms(joint.pair)
    except LinkageError as error:
        yield error.problems[0].message, error.problems[0].hint
    for key in ("axis", "axis2", "slide"):
        vector = getattr(joint, key)
        if vector is not None and length(vector) < TINY:
            yield f"{key} has length zero, so that it points nowhere", ""
    if linkage.space.name == "planar":
        yield from _out_of_plane(joint)
    if joint.axis and joint.axis2:
        yield from _two_axes(joint.pair, abs(_cosine(joint.axis, joint.axis2)))
    if (
        joint.point
        and joint.other
        and math.dist(joint.point, joint.other) < TINY
        and joint.pair.name in ("bar", "rolling")
    ):
        yield "its two points are the same", ""
    if joint.pair.name == "gear" and joint.carrier is None:
        yield "a gear mesh needs its carrier", "carrier: the link in which both wheels turn"
    if joint.carrier is not None and joint.carrier not in known:
        yield f"no joint ties a link called {joint.carrier}", did_you_mean(joint.carrier, known)
    elif joint.carrier in joint.links:
        yield f"the carrier {joint.carrier} is one of the wheels", "it is the link in which both wheels turn"
    if joint.radii is not None and min(joint.radii) <= 0:
        yield "a radius is not above zero", ""


def _two_axes(pair: Pair, cosine: float) -> Iterator[tuple[str, str]]:
    """Two axes that do not stand as the joint needs them."""
    if pair.name == "line-contact" and cosine > SQUARE:
        yield "the line of contact does not lie in the plane", "axis is the plane's normal, axis2 at right angles to it"
    elif cosine > 1 - TINY:
        yield "the two axes are parallel", "they cross at an angle"


def _out_of_plane(joint: Joint) -> Iterator[tuple[str, str]]:
    """Geometry that does not fit into the plane z = 0."""
    turns = joint.pair.name != "prismatic"
    if joint.axis and turns and (joint.axis[0] or joint.axis[1]):
        yield "its axis is not at right angles to the plane", "leave it out, or say space: spatial"
    vectors = (joint.point, joint.other, joint.slide, None if turns else joint.axis)
    if any(vector and vector[2] for vector in vectors):
        yield "it leaves the plane z = 0", "a planar linkage has z = 0 everywhere; or say space: spatial"


def _cosine(a: Vector, b: Vector) -> float:
    lengths = length(a) * length(b)
    return dot(a, b) / lengths if lengths > TINY else 0.0


def _apart(linkage: Linkage, known: list[str]) -> Iterator[Finding]:
    """Links that nothing connects with the ground; then a count would mean nothing."""
    neighbours: dict[str, set[str]] = {link: set() for link in known}
    for joint in linkage.joints:
        neighbours[joint.links[0]].add(joint.links[1])
        neighbours[joint.links[1]].add(joint.links[0])
    if linkage.ground not in neighbours:
        return
    reached, waiting = {linkage.ground}, [linkage.ground]
    while waiting:
        new = neighbours[waiting.pop()] - reached
        reached |= new
        waiting += new
    if lost := [link for link in known if link not in reached]:
        some = ", ".join(lost[:5]) + ", ..." * (len(lost) > 5)  # noqa: PLR2004  as many as a person reads
        yield Finding(
            ("joints",),
            f"nothing connects {some} with the ground {linkage.ground}",
            "it is two linkages, or a joint is missing",
        )
