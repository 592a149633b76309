"""Statements of geometry about an arm at one point, decided in residues."""

from __future__ import annotations

from dhcli.kinematics.singular.arm import Point, Triple
from dhcli.kinematics.singular.modular import cross, dot, minus


def in_line(at: Point, i: int, j: int) -> bool:
    """Whether two hinges have one axis."""
    between = minus(at.on_axis(j), at.on_axis(i), at.field.prime)
    return bool(at.parallel(i, j)) and not any(cross(at.angular[i], between, at.field.prime))


def in_plane(at: Point, i: int, j: int, point: Triple) -> bool:
    """Whether a point lies in the plane of two parallel axes."""
    prime = at.field.prime
    normal = cross(at.angular[i], minus(at.on_axis(j), at.on_axis(i), prime), prime)
    return not dot(normal, minus(point, at.on_axis(i), prime), prime)


def volume(at: Point, i: int, j: int, k: int) -> int:
    """Zero if three axes are parallel to one plane."""
    prime = at.field.prime
    return dot(at.angular[i], cross(at.angular[j], at.angular[k], prime), prime)


def alike(at: Point, one: int, other: int, *, slide: bool) -> bool:
    """Whether a slide is parallel to another slide, or to an axis."""
    direction = at.linear[other] if slide else at.angular[other]
    return not any(cross(at.linear[one], direction, at.field.prime))
