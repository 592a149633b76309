"""What the rules look at: the chain of an arm in places between its moves, and one random point of it in residues."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import field
from functools import cached_property
from typing import TypeAlias

from dhcli.algebra.residues import Field, Residues
from dhcli.algebra.terms import TERMS
from dhcli.frozen import frozen
from dhcli.kinematics.fold import fold_rows
from dhcli.kinematics.frames import between
from dhcli.kinematics.moves import Chain, Rot, inverse, names
from dhcli.kinematics.robot import Robot
from dhcli.kinematics.singular.modular import Table, cross, dot, minus
from dhcli.kinematics.velocity.jacobian import columns_over
from dhcli.kinematics.velocity.steps import Columns, fold_columns
from dhcli.kinematics.velocity.view import Part, Way
from dhcli.notation.angle import Angle
from dhcli.notation.tree import Expr

Triple: TypeAlias = tuple[int, int, int]


@frozen
class Arm:
    """A chain, its joints, and the places between its moves where axes and points are taken.

    Attributes:
        robot: The robot.
        start: The frame held still.
        end: The frame that moves.
        joints: The joints between the two, in joint order.
        chain: The moves between the two, with exact values put in.
        constants: Angles that stand in it by a name, see `constants`.
    """

    robot: Robot
    start: str
    end: str
    joints: tuple[str, ...]
    chain: Chain
    constants: Mapping[str, Angle] = field(default_factory=dict)

    @cached_property
    def homes(self) -> tuple[tuple[int, ...], ...]:
        """For each joint the places of the moves that hold it."""
        held = [names((move,)) for move in self.chain]
        return tuple(tuple(k for k, inside in enumerate(held) if joint in inside) for joint in self.joints)

    @cached_property
    def is_hinge(self) -> tuple[bool, ...]:
        """For each joint whether it turns about one axis, by its own angle."""
        found = []
        for joint, home in zip(self.joints, self.homes, strict=True):
            move = self.chain[home[0]]
            single = len(home) == 1 and isinstance(move, Rot)
            found.append(single and abs(dict(move.angle.terms)[joint]) == 1)  # type: ignore[union-attr]
        return tuple(found)

    @cached_property
    def turning(self) -> tuple[int, ...]:
        """Places where the axes are new ones: the start, and before and behind the moves of each joint."""
        places = {0, *(k + add for home in self.homes for k in home for add in (0, 1))}
        return tuple(sorted(places))

    @cached_property
    def places(self) -> tuple[int, ...]:
        """Places whose point may be a new one: behind every move that is no rotation, and the end."""
        moved = {k + 1 for k, move in enumerate(self.chain) if not isinstance(move, Rot)}
        return tuple(sorted({0, len(self.chain), *moved}))

    @cached_property
    def parts(self) -> tuple[Part, ...]:
        """The chain ready to be folded with its columns."""
        return tuple(Way((), self.chain).parts(self.joints, self.robot.angles, merged=False))

    def velocities(self, over: Residues) -> tuple[tuple[Triple, ...], tuple[Triple, ...]]:
        """For each joint the velocity of the end's origin, and the angular velocity, along the axes of the start."""
        linear, angular = columns_over(self.parts, len(self.joints), over)
        prime = over.field.prime
        return tuple(_triple(v, prime) for v in linear), tuple(_triple(w, prime) for w in angular)

    def frame_at(self, place: int) -> str:
        """The frame that stands at a place, or nothing where none does."""
        here = 0
        step = 1 if self.robot.frames.index(self.start) <= self.robot.frames.index(self.end) else -1
        first, last = self.robot.frames.index(self.start), self.robot.frames.index(self.end)
        found = self.start if place == 0 else ""
        for k in range(first, last, step):
            here += len(between(self.robot, self.robot.frames[k], self.robot.frames[k + step]))
            if here == place:
                found = self.robot.frames[k + step]
        return found

    def column(self, joint: int, axes: int, place: int, until: int | None = None) -> Columns[Expr]:
        """The column of a joint in terms.

        Args:
            joint: Which.
            axes: The place whose axes it is written along.
            place: The place of the reference point.
            until: Where the chain is cut off, with the point there; `place` means nothing then.
        """
        moving = self.chain if until is None else self.chain[:until]
        behind = inverse(self.chain[place:]) if until is None else ()
        way = Way(inverse(self.chain[:axes]), moving, behind)
        name = self.joints[joint]
        (part,) = way.parts((name,), self.robot.angles, merged=True)
        return fold_columns(part.steps, 1, TERMS)


@frozen
class Point:
    """An arm at one point in residues: every name has a residue, every angle a unit.

    Attributes:
        arm: The arm.
        over: The residues.
        linear: For each joint the velocity of the end's origin, along the axes of the start.
        angular: For each joint the angular velocity.
        rotations: The axes at each place, three rows.
        origins: The point at each place.
    """

    arm: Arm
    over: Residues
    linear: tuple[Triple, ...]
    angular: tuple[Triple, ...]
    rotations: tuple[Table, ...]
    origins: tuple[Triple, ...]

    @classmethod
    def of(cls, arm: Arm, over: Residues) -> Point:
        """Evaluate an arm.

        Raises:
            CannotHoldError: A number of it is no residue.
        """
        prime, chain = over.field.prime, arm.chain
        rotations, origins = [], []
        rows: Table = [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0]]
        for place in range(len(chain) + 1):
            rotations.append([row[:3] for row in rows])
            origins.append((rows[0][3] % prime, rows[1][3] % prime, rows[2][3] % prime))
            if place < len(chain):
                move = [[over.value(entry) for entry in row] for row in fold_rows((chain[place],), over)]
                rows = [
                    [
                        (sum(row[k] * move[k][c] for k in range(3)) + (row[3] if c == 3 else 0)) % prime  # noqa: PLR2004
                        for c in range(4)
                    ]
                    for row in rows
                ]
        linear, angular = arm.velocities(over)
        return cls(arm, over, linear, angular, tuple(rotations), tuple(origins))

    @property
    def field(self) -> Field:
        """The field."""
        return self.over.field

    def velocity(self, joint: int, point: Triple) -> Triple:
        """The velocity, along the axes of the start, that a joint gives a point fixed to the end."""
        prime = self.field.prime
        reach = minus(point, self.origins[-1], prime)
        turned = cross(self.angular[joint], reach, prime)
        x, y, z = ((v + t) % prime for v, t in zip(self.linear[joint], turned, strict=True))
        return x, y, z

    def on_axis(self, joint: int) -> Triple:
        """A point on the axis of a hinge."""
        return self.origins[self.arm.homes[joint][0]]

    def along(self, vector: Sequence[int], place: int) -> Triple:
        """A vector of the start's axes along those at a place."""
        prime = self.field.prime
        x, y, z = (dot([row[k] for row in self.rotations[place]], vector, prime) for k in range(3))
        return x, y, z

    def rows(self, point: Triple | None = None) -> Table:
        """All six rows, v of a point above ω; of the end's origin by default."""
        count = range(len(self.linear))
        linear = self.linear if point is None else tuple(self.velocity(j, point) for j in count)
        return [[linear[j][k] for j in count] for k in range(3)] + [
            [self.angular[j][k] for j in count] for k in range(3)
        ]

    def parallel(self, i: int, j: int) -> int:
        """1 or -1 if two hinges turn about parallel axes, by which sense; 0 if not."""
        prime = self.field.prime
        for sign in (1, -1):
            if all((a - sign * b) % prime == 0 for a, b in zip(self.angular[i], self.angular[j], strict=True)):
                return sign
        return 0


def _triple(vector: Sequence[int], prime: int) -> Triple:
    x, y, z = (entry % prime for entry in vector)
    return x, y, z


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
