"""From a linkage to numbers: unit twists, a spanning tree, and the equations of its loops.

Every joint becomes a row of motions with one freedom each. A motion is a unit twist in the world frame; lengths are
divided by the root mean square distance of the joint points from their centre, so that ranks do not depend on units.
"""

from __future__ import annotations

from dataclasses import replace
from functools import cached_property
from typing import TYPE_CHECKING, TypeAlias

import numpy as np

from dhcli.frozen import frozen
from dhcli.geometry.twists import Array
from dhcli.mobility.linkage import Joint, Linkage
from dhcli.mobility.motions import motions_of
from dhcli.mobility.pairs import LinkageError

if TYPE_CHECKING:
    from numpy.typing import NDArray

Signs: TypeAlias = "NDArray[np.int8]"

TINY = 1e-9
"""Points nearer together than this part of their distance from the origin are one point."""


@frozen
class Step:
    """A joint in the spanning tree, or one that closes a loop.

    Attributes:
        joint: Index of the joint.
        tail: Index of its first link.
        head: Index of its second link.
        first: Index of its first motion.
        last: Index after its last motion.
    """

    joint: int
    tail: int
    head: int
    first: int
    last: int


@frozen
class Model:
    """A linkage in one position, ready for computing.

    Attributes:
        linkage: What it was made of.
        twists: Unit twist of every motion in the world frame, shape (m, 6), lengths scaled.
        steps: All joints that hold two links together; gear meshes are not among them.
        tree: For every link but the ground the step that leads to it and whether it is walked backwards, in an order
            in which each link comes behind the one it hangs on.
        chords: The steps that close a loop each.
        ties: Linear equations between motions, from gears and rolling, shape (g, m).
        centre: Middle of the joint points [m].
        scale: Their root mean square distance from it [m].
    """

    linkage: Linkage
    twists: Array
    steps: tuple[Step, ...]
    tree: tuple[tuple[Step, bool], ...]
    chords: tuple[Step, ...]
    ties: Array
    centre: Array
    scale: float

    @property
    def motions(self) -> int:
        """The number m of motions."""
        return len(self.twists)

    @cached_property
    def places(self) -> dict[int, int]:
        """The place among the steps of each joint that is one."""
        return {step.joint: place for place, step in enumerate(self.steps)}

    @cached_property
    def ends(self) -> NDArray[np.intp]:
        """First link, second link, first motion and number of motions of each step, shape (steps, 4)."""
        found = [(step.tail, step.head, step.first, step.last - step.first) for step in self.steps]
        return np.array(found, dtype=np.intp).reshape(-1, 4)

    @cached_property
    def paths(self) -> Signs:
        """Which motions lead from the ground to each link, with their sense: 1, -1 or 0; shape (links, m)."""
        found = np.zeros((len(self.linkage.links), self.motions), dtype=np.int8)
        for step, backwards in self.tree:
            start, end = (step.head, step.tail) if backwards else (step.tail, step.head)
            found[end] = found[start]
            found[end, step.first : step.last] = -1 if backwards else 1
        return found

    @cached_property
    def signs(self) -> Signs:
        """Which motions each loop runs through, with their sense, shape (loops, m)."""
        found = np.zeros((len(self.chords), self.motions), dtype=np.int8)
        for row, chord in enumerate(self.chords):
            found[row] = self.paths[chord.tail] - self.paths[chord.head]
            found[row, chord.first : chord.last] = 1
        return found

    @cached_property
    def basis(self) -> Array:
        """Orthonormal directions of the twists that the whole linkage can have, shape (3 or 6, 6).

        A planar linkage has three equations for each loop; the other three would be 0 = 0.
        """
        flat = np.abs(self.twists[:, [0, 1, 5]]).max(initial=0.0)
        return np.eye(6)[[2, 3, 4]] if flat == 0.0 else np.eye(6)

    @property
    def equations(self) -> int:
        """The number of equations of all loops, and ties: the rows of the Jacobian."""
        return len(self.basis) * len(self.chords) + len(self.ties)

    def jacobian(self, twists: Array | None = None) -> Array:
        """The loop equations' derivative: `V_a + V_joint - V_b = 0` for each chord, and the ties below.

        Args:
            twists: World twists of the motions, shape (m, 6); those of the given position by default.

        Returns:
            Shape (rows, m).
        """
        seen = (self.twists if twists is None else twists) @ self.basis.T
        loops = (self.signs[:, None, :] * seen.T[None, :, :]).reshape(-1, self.motions)
        return np.concatenate([loops, self.ties])

    def link_twists(self, rates: Array, twists: Array | None = None, links: slice = slice(None)) -> Array:
        """Twists of links, of all by default, for given rates of the motions, (m, k) to (links, 6, k)."""
        seen = self.twists if twists is None else twists
        return np.asarray((self.paths[links, None, :] * seen.T) @ rates)


def model_of(linkage: Linkage) -> Model:
    """Make the model of a linkage whose geometry is known.

    Raises:
        LinkageError: Nothing but gear teeth holds a link, or a wheel does not turn in its carrier.
    """
    points = [np.array(p) for joint in linkage.joints for p in (joint.point, joint.other) if p is not None]
    centre = np.mean(points, axis=0) if points else np.zeros(3)
    spread = float(np.sqrt(np.mean([np.sum((p - centre) ** 2) for p in points]))) if points else 0.0
    scale = spread if spread > TINY * (1 + float(np.abs(centre).max())) else 1.0
    index = {link: i for i, link in enumerate(linkage.links)}
    twists: list[Array] = []
    steps: list[Step] = []
    for i, joint in enumerate(linkage.joints):
        if joint.pair.name != "gear":
            own = motions_of(joint, centre, scale, planar=linkage.space.is_planar)
            steps.append(Step(i, index[joint.links[0]], index[joint.links[1]], len(twists), len(twists) + len(own)))
            twists += own
    tree, chords = _spanning(steps, linkage)
    stacked = np.array(twists) if twists else np.zeros((0, 6))
    bare = Model(linkage, stacked, tuple(steps), tree, chords, np.zeros((0, len(twists))), centre, scale)
    ties = [_mesh(bare, joint) for joint in linkage.joints if joint.pair.name == "gear"]
    ties += [_roll(bare, step) for step in steps if linkage.joints[step.joint].pair.name == "rolling"]
    return replace(bare, ties=np.array(ties)) if ties else bare


def _spanning(steps: list[Step], linkage: Linkage) -> tuple[tuple[tuple[Step, bool], ...], tuple[Step, ...]]:
    """A tree by breadth first, which keeps loops short, and the steps that are left over."""
    touching: list[list[Step]] = [[] for _ in linkage.links]
    for step in steps:
        touching[step.tail].append(step)
        touching[step.head].append(step)
    tree: list[tuple[Step, bool]] = []
    reached, used, waiting = {0}, set(), [0]
    for link in waiting:
        for step in touching[link]:
            other = step.head if step.tail == link else step.tail
            if other not in reached:
                reached.add(other)
                used.add(step.joint)
                waiting.append(other)
                tree.append((step, step.head == link))
    if len(reached) < len(linkage.links):
        lost = next(link for i, link in enumerate(linkage.links) if i not in reached)
        raise LinkageError(f"nothing but gear teeth holds {lost}", "a wheel turns in a carrier: add its joint")
    return tuple(tree), tuple(step for step in steps if step.joint not in used)


def _mesh(model: Model, joint: Joint) -> Array:
    """The equation of a gear mesh, r_a (ω_a - ω_c) + r_b (ω_b - ω_c) = 0; minus where teeth stand inside.

    Source: Willis' equation for two wheels on one carrier.
    """
    radii = joint.radii or (1.0, 1.0)
    first, second = (_turning(model, wheel, joint.carrier or "", joint) for wheel in joint.links)
    return np.asarray(radii[0] * first + (-radii[1] if joint.internal else radii[1]) * second) / max(radii)


def _turning(model: Model, wheel: str, carrier: str, joint: Joint) -> Array:
    """The angle of a wheel in its carrier as a sum of motions, shape (m,)."""
    links = model.linkage.links
    a, c = links.index(wheel), links.index(carrier)
    found = np.zeros(model.motions)
    for step in model.steps:
        if {step.tail, step.head} == {a, c} and step.last > step.first and model.twists[step.first, :3].any():
            found[step.first] = 1 if step.head == a else -1
            return found
    path = model.paths[a] - model.paths[c]
    turning = model.twists[:, :3][(path != 0) & model.twists[:, :3].any(axis=1)]
    if len(turning) and np.linalg.matrix_rank(turning, 1e-9) == 1:
        return np.asarray(path * (model.twists[:, :3] @ turning[0]))
    raise LinkageError(
        f"joint {joint.name}: the wheel {wheel} does not turn in the carrier {carrier}", "add its revolute joint"
    )


def _roll(model: Model, step: Step) -> Array:
    """Rolling: the line of centres is the carrier, -r_a θ1 + r_b θ2 = 0 with θ1 from a to the line, θ2 from it to b."""
    radii = model.linkage.joints[step.joint].radii or (1.0, 1.0)
    internal = model.linkage.joints[step.joint].internal
    found = np.zeros(model.motions)
    found[step.first], found[step.first + 1] = -radii[0], -radii[1] if internal else radii[1]
    return found / max(radii)
