"""What a vanishing factor means: the picture of the arm there, the joints that move alike, and the motion that is lost.

Each sentence is a statement of geometry that holds at a random point where the factor is zero and at no random point
elsewhere; nothing is known of the names of robots.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from itertools import combinations

from dhcli.errors import joined
from dhcli.frozen import frozen
from dhcli.kinematics.singular.arm import Point, Triple, alike, in_line, in_plane, volume
from dhcli.kinematics.singular.modular import Table, cross, dot, minus, null_space


@frozen
class Place:
    """The point that sentences are about: its place in the chain, and what it is called."""

    place: int
    words: str


class Geometry:
    """Sentences about an arm at a special point, next to a generic one."""

    def __init__(self, here: Point, elsewhere: Point, place: Place, numbers: Sequence[int]) -> None:
        """Take both points.

        Args:
            here: The arm where something vanishes.
            elsewhere: The arm at a random point.
            place: The point that sentences are about.
            numbers: The number of each joint's axis.
        """
        self.here, self.elsewhere, self.place, self.numbers = here, elsewhere, place, numbers
        hinges = here.arm.is_hinge
        self.hinges = [j for j in range(len(hinges)) if hinges[j]]
        self.slides = [j for j, joint in enumerate(here.arm.joints) if joint not in here.arm.robot.angles]

    def becomes(self, holds: Callable[[Point], bool]) -> bool:
        """Whether a statement is true here and false elsewhere."""
        return holds(self.here) and not holds(self.elsewhere)

    def sentences(self, joints: Sequence[int]) -> Iterator[str]:
        """What is special here, the plainest first.

        Args:
            joints: The joints whose columns are dependent, about which it must be.
        """
        hinges = [j for j in self.hinges if j in joints]
        pairs = sorted(combinations(hinges, 2), key=lambda pair: (pair[1] - pair[0], -pair[0]))
        yield from self._in_line(pairs)
        yield from self._on_axes(hinges)
        yield from self._parallel(pairs)
        yield from self._stretched(hinges, pairs)
        yield from self._planes(hinges)
        yield from self._of_slides(joints)
        for i, j, k in combinations(hinges, 3):
            if self.becomes(lambda at, i=i, j=j, k=k: not volume(at, i, j, k)):  # type: ignore[misc]
                yield f"{self._axes(i, j, k)} are parallel to one plane"
        yield from self._velocities(joints)

    def _velocities(self, joints: Sequence[int]) -> Iterator[str]:
        """The point moved along one line by two joints, or in one plane by three."""
        for i, j in combinations(joints, 2):
            if self.becomes(lambda at, i=i, j=j: not any(self._normal(at, i, j))):  # type: ignore[misc]
                yield f"joints {joined((self.numbers[i], self.numbers[j]))} move {self.place.words} along one line"
        for i, j, k in combinations(joints, 3):
            if self.becomes(
                lambda at, i=i, j=j, k=k: not dot(self._normal(at, i, j), self._moved(at, k), at.field.prime)  # type: ignore[misc]
            ):
                yield f"joints {joined(self.numbers[n] for n in (i, j, k))} move {self.place.words} in one plane"

    def _moved(self, at: Point, joint: int) -> Triple:
        return at.velocity(joint, self._point(at))

    def _normal(self, at: Point, i: int, j: int) -> Triple:
        return cross(self._moved(at, i), self._moved(at, j), at.field.prime)

    def _axes(self, *joints: int) -> str:
        return f"axes {joined(self.numbers[j] for j in joints)}"

    def _in_line(self, pairs: Sequence[tuple[int, int]]) -> Iterator[str]:
        for i, j in pairs:
            if self.becomes(lambda at, i=i, j=j: in_line(at, i, j)):  # type: ignore[misc]
                yield f"{self._axes(i, j)} fall in line"

    def _on_axes(self, hinges: Sequence[int]) -> Iterator[str]:
        for i in hinges:
            if self.becomes(lambda at, i=i: not any(at.velocity(i, self._point(at)))):  # type: ignore[misc]
                yield f"{self.place.words} lies on axis {self.numbers[i]}"

    def _parallel(self, pairs: Sequence[tuple[int, int]]) -> Iterator[str]:
        for i, j in pairs:
            if self.becomes(lambda at, i=i, j=j: bool(at.parallel(i, j))):  # type: ignore[misc]
                yield f"{self._axes(i, j)} are parallel"

    def _stretched(self, hinges: Sequence[int], pairs: Sequence[tuple[int, int]]) -> Iterator[str]:
        """Three parallel axes, or two and the point, in one plane."""
        parallel = self.elsewhere.parallel
        for i, j, k in combinations(hinges, 3):
            alike = parallel(i, j) and parallel(j, k)
            if alike and self.becomes(lambda at, i=i, j=j, k=k: in_plane(at, i, j, at.on_axis(k))):  # type: ignore[misc]
                yield f"{self._axes(i, j, k)} lie in one plane: the arm is stretched or folded"
        for i, j in pairs:
            if parallel(i, j) and self.becomes(lambda at, i=i, j=j: in_plane(at, i, j, self._point(at))):  # type: ignore[misc]
                yield f"{self._axes(i, j)} and {self.place.words} lie in one plane: the arm is stretched or folded"

    def _planes(self, hinges: Sequence[int]) -> Iterator[str]:
        """The point in a plane that goes through one axis and lies along another."""
        for i in hinges:
            for j in self.hinges:
                if i != j and self.becomes(
                    lambda at, i=i, j=j: not dot(at.angular[j], at.velocity(i, self._point(at)), at.field.prime)  # type: ignore[misc]
                ):
                    through = f"the plane through axis {self.numbers[i]} parallel to axis {self.numbers[j]}"
                    yield f"{self.place.words} lies in {through}"
                    return

    def _of_slides(self, joints: Sequence[int]) -> Iterator[str]:
        for slide in self.slides:
            for j in joints:
                if j == slide:
                    continue
                other = j in self.slides
                if self.becomes(lambda at, s=slide, j=j, o=other: alike(at, s, j, slide=o)):  # type: ignore[misc]
                    what = "slide" if other else "axis"
                    yield f"slide {self.numbers[slide]} is parallel to {what} {self.numbers[j]}"

    def _point(self, at: Point) -> Triple:
        return at.origins[self.place.place]

    def dependent(self, kept: Sequence[int]) -> tuple[int, ...]:
        """The joints whose columns are dependent here, of all rows of the task."""
        rows = self.here.rows(self._point(self.here))
        basis = null_space([rows[k] for k in kept], self.here.field)
        return tuple(j for j in range(len(self.here.linear)) if any(vector[j] for vector in basis))

    def moving_alike(self, kept: Sequence[int]) -> tuple[str, tuple[int, ...]]:
        """The fewest joints whose dependence is the reason, and by what: their velocities, their turning, or both.

        Where others turn the body about the point at will, those that move the point are asked alone; where others
        move it at will, those that only turn the body.
        """
        rows = self.here.rows(self._point(self.here))
        generic = self.elsewhere.rows(self._point(self.elsewhere))
        count = range(len(rows[0]))
        for name, part in (("v", [k for k in kept if k < 3]), ("ω", [k for k in kept if k > 2])):  # noqa: PLR2004
            if part and len(part) < len(kept):
                only = [j for j in count if not any(generic[k][j] for k in kept if k not in part)]
                every = [j for j in count if any(generic[k][j] for k in part)]
                for joints in (only, every):
                    found = self._dependent_in(part, joints, rows, generic)
                    if found:
                        return name, found
        return "", self.dependent(kept)

    def _dependent_in(self, part: Sequence[int], joints: Sequence[int], rows: Table, generic: Table) -> tuple[int, ...]:
        """Joints that are dependent in some rows here and not elsewhere."""
        if not joints:
            return ()
        field = self.here.field
        if null_space([[generic[k][j] for j in joints] for k in part], field):
            return ()
        basis = null_space([[rows[k][j] for j in joints] for k in part], field)
        return tuple(joint for c, joint in enumerate(joints) if any(vector[c] for vector in basis))

    def lost(self, kept: Sequence[int], part: str) -> str:
        """The motion that the arm cannot make here, in words; empty if it has none.

        What no joint can do is the wrench on which none of them works: a force at the point, a moment, or both, of
        which that is told which is the reason.

        Args:
            kept: The rows of the task.
            part: Whether the reason lies in `v` or in `ω`, or nothing if in both.
        """
        here, prime = self.here, self.here.field.prime
        rows = here.rows(self._point(here))
        basis = null_space([[rows[k][j] for k in kept] for j in range(len(here.linear))], here.field)
        if not basis:
            return ""
        full = [0] * 6
        for k, value in zip(kept, basis[0], strict=True):
            full[k] = value % prime
        force: Triple = (full[0], full[1], full[2])
        moment: Triple = (full[3], full[4], full[5])
        along = self._line(force) if any(force) else ""
        about = self._direction(moment, turning=True) if any(moment) else ""
        if any(moment) and (part == "ω" or not any(force) or (about and not along)):
            rest = f", with {self.place.words} at rest" if kept[0] < 3 else ""  # noqa: PLR2004  rows of v
            return f"turning about {about or 'one direction'}{rest}"
        return f"moving {self.place.words} {along or 'in one direction'}"

    def _line(self, vector: Triple) -> str:
        """A direction of a velocity by what else points along it, or by a plane that it lies in."""
        if named := self._direction(vector, turning=False):
            return named
        here, prime = self.here, self.here.field.prime
        for j in self.hinges:
            normal = cross(here.angular[j], minus(self._point(here), here.on_axis(j), prime), prime)
            if any(normal) and not dot(normal, vector, prime):
                return f"in one direction of the plane through it and axis {self.numbers[j]}"
        return ""

    def _direction(self, vector: Triple, *, turning: bool) -> str:
        """A direction by what else points along it."""
        here, prime, of = self.here, self.here.field.prime, self.numbers
        for j in self.hinges:
            if not any(cross(here.angular[j], vector, prime)):
                return f"axis {of[j]}" if turning else f"along axis {of[j]}"
        if not turning:
            for j in self.hinges:
                axis = here.angular[j]
                reach = minus(self._point(here), here.on_axis(j), prime)
                share = dot(axis, reach, prime)
                across = minus(reach, tuple(share * a for a in axis), prime)
                if any(across) and not any(cross(across, vector, prime)):
                    return f"along the line from axis {of[j]} to it"
            for j in self.slides:
                if not any(cross(here.linear[j], vector, prime)):
                    return f"along slide {of[j]}"
        directions = [(j, here.angular[j], "axis") for j in self.hinges]
        directions += [(j, here.linear[j], "slide") for j in self.slides]
        for (i, one, a), (j, other, b) in sorted(combinations(directions, 2), key=lambda p: p[1][0] - p[0][0]):
            normal = cross(one, other, prime)
            if any(normal) and not any(cross(normal, vector, prime)):
                named = f"axes {of[i]} and {of[j]}" if a == b == "axis" else f"{a} {of[i]} and {b} {of[j]}"
                return f"the perpendicular to {named}" if turning else f"perpendicular to {named}"
        return ""
