"""The peers: each computes poses of a DH robot that it builds from the numbers of our robot file."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from importlib.metadata import PackageNotFoundError, version
from types import ModuleType
from typing import Any

import numpy as np

from dhcli import Robot
from dhcli.algebra.floats import Floats
from dhcli.kinematics.conventions import Convention
from dhcli.kinematics.values import numbers, parameter_values

Array = np.ndarray[Any, np.dtype[np.float64]]

SLIDE, TURN = "d", "theta"


@dataclass(frozen=True)
class Link:
    """A row of a DH table in numbers.

    Attributes:
        a: Length [m].
        alpha: Twist [rad].
        d: Offset [m]; what is added to the variable, if that is it.
        theta: Angle [rad]; the same.
        moves: `d`, `theta`, or empty if nothing moves.
        joint: Number of the variable from 0.
    """

    a: float
    alpha: float
    d: float
    theta: float
    moves: str
    joint: int

    def rows(self, q: Array, convention: Convention, numpy: ModuleType = np) -> tuple[tuple[Any, ...], ...]:
        """The first three rows of the DH matrix, for joint values of shape (n,) or (N, n); `numpy` may be jax's."""
        value = q[..., self.joint]
        theta = self.theta + value * (self.moves == TURN)
        d = self.d + value * (self.moves == SLIDE)
        c, s, ca, sa = numpy.cos(theta), numpy.sin(theta), np.cos(self.alpha), np.sin(self.alpha)
        if convention is Convention.MODIFIED:
            return (c, -s, 0, self.a), (s * ca, c * ca, -sa, -sa * d), (s * sa, c * sa, ca, ca * d)
        return (c, -s * ca, s * sa, self.a * c), (s, c * ca, -c * sa, self.a * s), (0, sa, ca, d)

    def steps(self, convention: Convention) -> Iterator[tuple[str, float, str]]:
        """The four moves in their order: `Rx`, `tx`, `tz` or `Rz`, the constant, and what moves if that is it."""
        x = (("Rx", self.alpha, ""), ("tx", self.a, ""))
        z = (("tz", self.d, self.moves * (self.moves == SLIDE)), ("Rz", self.theta, self.moves * (self.moves == TURN)))
        return iter((*x, *z) if convention is Convention.MODIFIED else (*z[::-1], *x[::-1]))


def links(robot: Robot) -> list[Link]:
    """The DH table of a robot of our library in numbers; every joint must stand alone in its cell."""
    known = Floats({**numbers(parameter_values(robot, {})), **dict.fromkeys(robot.variables, 0.0)})
    joint_of = {joint.link: joint for joint in robot.joints}
    found = []
    for link in robot.links:
        row, joint = link.row, joint_of.get(link.number)
        if row is None:
            raise SystemExit(f"{robot.name} has no DH table")
        moves = "" if joint is None else TURN if joint.kind == "revolute" else SLIDE
        number = 0 if joint is None else robot.variables.index(joint.name)
        lengths = float(known.length(row.a)), float(known.length(row.d))
        found.append(Link(lengths[0], row.alpha.constant(), lengths[1], row.theta.constant(), moves, number))
    return found


def by_numpy(robot: Robot) -> Callable[[Array], Array]:
    """DH matrices multiplied with `@`, as most people write it; for one pose or a stack of them."""
    chain = links(robot)

    def matrix(link: Link, q: Array) -> Array:
        rows = (*link.rows(q, robot.convention), (0, 0, 0, 1))
        if q.ndim == 1:
            return np.array(rows)
        A = np.empty((len(q), 4, 4))  # noqa: N806  the field's name
        for i, row in enumerate(rows):
            for k, entry in enumerate(row):
                A[:, i, k] = entry
        return A

    def product(q: Array) -> Array:
        pose = matrix(chain[0], q)
        for link in chain[1:]:
            pose = pose @ matrix(link, q)
        return pose

    return product


def by_toolbox(robot: Robot) -> Callable[[Array], Array]:
    """Elementary transforms of the Robotics Toolbox, its constants folded, evaluated by its own C++."""
    from roboticstoolbox import ET, ETS

    chain = ETS()
    for link in links(robot):
        for move, constant, moving in link.steps(robot.convention):
            chain *= getattr(ET, move)(constant)
            if moving:
                chain *= getattr(ET, move)()
    return chain.compile().eval


def by_pinocchio(robot: Robot) -> Callable[[Array], Array]:
    """A model of pinocchio, one joint at a time, and the frame at its end."""
    import pinocchio as pin

    model = pin.Model()
    joint, fixed = 0, pin.SE3.Identity()
    for link in links(robot):
        for move, constant, moving in link.steps(robot.convention):
            axis = np.eye(3)[0 if move.endswith("x") else 2]
            turn = pin.AngleAxis(constant, axis).matrix() if move.startswith("R") else np.eye(3)
            shift = axis * constant if move.startswith("t") else np.zeros(3)
            fixed = fixed * pin.SE3(turn, shift)
            if moving:
                kind = pin.JointModelRZ() if moving == TURN else pin.JointModelPZ()
                joint, fixed = model.addJoint(joint, kind, fixed, f"q{link.joint}"), pin.SE3.Identity()
    data = model.createData()

    def pose(q: Array) -> Array:
        pin.forwardKinematics(model, data, q)
        return (data.oMi[joint] * fixed).homogeneous

    return pose


def by_jax(robot: Robot) -> Callable[[Array], Array]:
    """DH matrices multiplied for one pose, mapped over the stack and compiled by XLA, in double precision."""
    import jax

    jax.config.update("jax_enable_x64", val=True)
    chain = links(robot)

    def product(q: jax.Array) -> jax.Array:
        pose = jax.numpy.eye(4)
        for link in chain:
            pose = pose @ jax.numpy.array((*link.rows(q, robot.convention, jax.numpy), (0, 0, 0, 1)))
        return pose

    one, many = jax.jit(product), jax.jit(jax.vmap(product))
    return lambda q: np.asarray(one(q) if q.ndim == 1 else many(q))


@dataclass(frozen=True)
class Peer:
    """Something else that computes poses.

    Attributes:
        name: What it is called in the table.
        package: The package that must be installed.
        build: From one of our robots to a function from joint values, shape (n,), to a pose, shape (4, 4).
        stacks: Whether that function takes many, shape (N, n), at once; else it is called in a loop.
        most: How many it is asked for: of ten million some take minutes, and ten gigabytes.
    """

    name: str
    package: str
    build: Callable[[Robot], Callable[[Array], Array]]
    stacks: bool = True
    most: int = 1_000_000

    @property
    def version(self) -> str:
        """The version installed, or empty."""
        try:
            return version(self.package)
        except PackageNotFoundError:
            return ""

    def many(self, robot: Robot) -> Callable[[Array], Array]:
        """A function from joint values, shape (N, n), to poses, shape (N, 4, 4)."""
        pose = self.build(robot)
        return pose if self.stacks else lambda q: loop(pose, q)


def loop(pose: Callable[[Array], Array], q: Array) -> Array:
    """Poses one by one into a stack."""
    poses = np.empty((len(q), 4, 4))
    for k, values in enumerate(q):
        poses[k] = pose(values)
    return poses


PEERS = (
    Peer("numpy, matrices multiplied", "numpy", by_numpy),
    Peer("Robotics Toolbox, ets.eval", "roboticstoolbox-python", by_toolbox, most=10_000_000),
    Peer("JAX, jit and vmap", "jax", by_jax),
    Peer("pinocchio, forwardKinematics", "pin", by_pinocchio, stacks=False, most=100_000),
)
