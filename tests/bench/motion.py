"""Jacobians and singularities: many at once, one, in symbols and in factors, beside the peers that are installed."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from importlib.util import find_spec

import numpy as np
import sympy
from measure import Row, Task, number, side_by_side
from peers import SLIDE, TURN, Array, Peer, links
from poses import by_numpy_alone, by_the_loop, equal, joint_values
from sympy.core.cache import clear_cache

from dhcli import Robot, forward, forward_batch, jacobian, load_robot, singularities, symbolic, symbolic_jacobian
from dhcli.algebra.symbolic import to_sympy
from dhcli.kinematics.conventions import Convention
from dhcli.kinematics.singular.result import Singularities
from dhcli.kinematics.velocity.jacobian import Jacobian
from dhcli.notation.tree import Expr
from dhcli.notation.walk import operations

ROBOTS = ("planar-2r", "articulated", "cylindrical", "spherical-wrist", "stanford", "puma560")
ROBOTS = (*ROBOTS, "puma200", "zhou-6r", "ur5e", "panda")
ARMS = ("stanford", "puma560", "panda")
MANY = 50_000
CLOSE = 1e-9


def batch(rounds: int, robots: tuple[str, ...] = ARMS, size: int = MANY) -> Iterator[Row]:
    """Many Jacobians by numpy alone, beside as many poses and beside each peer."""
    with by_numpy_alone():
        yield from beside_each(rounds, robots, size)


def fast(rounds: int, robots: tuple[str, ...] = ARMS, size: int = MANY) -> Iterator[Row]:
    """The same by the compiled loop."""
    if not find_spec("numba"):
        yield Row(f"{size} Jacobians", "by the loop", "numba")
        return
    with by_the_loop():
        for row in beside_each(rounds, robots, size):
            yield replace(row, ours=f"{row.ours}, by the loop")


def beside_each(rounds: int, robots: tuple[str, ...], size: int) -> Iterator[Row]:
    """Many Jacobians of each robot beside as many poses, and beside each peer."""
    for robot in map(load_robot, robots):
        q = joint_values(robot, size)
        ours = Task("jacobian(robot, Q)", lambda robot=robot, q=q: jacobian(robot, q))
        poses = Task("forward_batch(robot, Q)", lambda robot=robot, q=q: forward_batch(robot, q))
        work = f"{size} Jacobians of {robot.name}"
        row = side_by_side(work, ours, poses, lambda one, other: len(one) == len(other), rounds=rounds)
        yield with_least(row, f"; {number(min(own for own, _ in row.pairs) / size * 1e9)} ns a Jacobian")
        for peer in PEERS:
            yield with_least(beside_peer(robot, q[: peer.most], peer, rounds))


def beside_peer(robot: Robot, q: Array, peer: JacobianPeer, rounds: int) -> Row:
    """Many Jacobians beside a peer, or a row that says that it is not there."""
    work, ours = f"{len(q)} Jacobians of {robot.name}", Task("jacobian(robot, Q)", lambda: jacobian(robot, q))
    if not peer.version:
        return Row(work, ours.name, peer.name)
    many = peer.many(robot)
    return side_by_side(work, ours, Task(peer.name, lambda: many(q)), equal, rounds=rounds)


def with_least(row: Row, more: str = "") -> Row:
    """A row with the ratio of the least times, on which a busy machine tells the least."""
    if not row.pairs:
        return row
    own, theirs = (min(times) for times in zip(*row.pairs, strict=True))
    return replace(row, note=f"least: {number(theirs / own)}{more}")


def one(rounds: int, robots: tuple[str, ...] = ROBOTS) -> Iterator[Row]:
    """One Jacobian, beside one pose."""
    for robot in map(load_robot, robots):
        q = joint_values(robot, 1)[0].tolist()
        row = side_by_side(
            f"one Jacobian of {robot.name}",
            Task("jacobian(robot, q)", lambda robot=robot, q=q: jacobian(robot, q)),
            Task("forward(robot, q)", lambda robot=robot, q=q: forward(robot, q)),
            lambda matrix, pose: matrix.shape[0] > len(pose.rows),
            rounds=rounds,
        )
        yield with_least(row)


def symbols(rounds: int, robots: tuple[str, ...] = ROBOTS) -> Iterator[Row]:
    """J_v in symbols, beside sympy differentiating the position, which is not simplified."""
    for robot in map(load_robot, robots):
        row = side_by_side(
            f"Jacobian of {robot.name}",
            Task("symbolic_jacobian", lambda robot=robot: symbolic_jacobian(robot)),
            Task("sympy, position.jacobian(q)", lambda robot=robot: differentiated(robot)),
            agree,
            rounds=rounds,
        )
        count = sum(operations(entry) for line in symbolic_jacobian(robot).rows[:3] for entry in line)
        yield replace(row, note=f"operations of v: {count}")


def factors(rounds: int, robots: tuple[str, ...] = ("planar-2r", "scara", "articulated")) -> Iterator[Row]:
    """The determinant in factors, beside `simplify` of sympy's; with six joints that takes minutes."""
    for robot in map(load_robot, robots):
        yield side_by_side(
            f"singularities of {robot.name}",
            Task("singularities", lambda robot=robot: singularities(anew(robot))),
            Task("sympy, det and simplify", lambda robot=robot: simplified(robot)),
            same_determinant,
            rounds=rounds,
        )
    for robot in map(load_robot, ("stanford", "puma560", "ur5e", "zhou-6r", "puma200")):
        row = side_by_side(
            f"singularities of {robot.name}",
            Task("singularities", lambda robot=robot: singularities(anew(robot))),
            Task("symbolic", lambda robot=robot: symbolic(robot)),
            lambda found, pose: found.rank == len(pose.rows) + 2,
            rounds=rounds,
        )
        yield replace(row, note="words and proof of every factor included")


def anew(robot: Robot) -> Robot:
    """The same robot, of which nothing was asked before; what it was asked is kept with it."""
    return replace(robot, title=robot.title)


def differentiated(robot: Robot) -> sympy.Matrix:
    """The Jacobian of the position in sympy, with nothing remembered from before; the pose is ours."""
    clear_cache()
    position = sympy.Matrix([to_sympy(entry) for entry in symbolic(robot).position])
    return position.jacobian([sympy.Symbol(name, real=True) for name in robot.variables])


def simplified(robot: Robot) -> sympy.Expr:
    """The determinant of the rows of v that move, simplified, with nothing remembered from before."""
    clear_cache()
    rows = [row for row in symbolic_jacobian(robot).rows[:3] if any(str(entry) != "0" for entry in row)]
    return sympy.simplify(sympy.Matrix([[to_sympy(entry) for entry in row] for row in rows]).det())


def agree(ours: Jacobian[Expr], theirs: sympy.Matrix) -> bool:
    """Whether the rows of v say the same at a point."""
    point = {name: 0.3 + 0.17 * k for k, name in enumerate(sorted(theirs.free_symbols, key=str))}
    return all(abs(float(entry)) < CLOSE for entry in (ours.to_sympy()[:3, :] - theirs).subs(point))


def same_determinant(found: Singularities, theirs: sympy.Expr) -> bool:
    """Whether the factors multiply to it at a point."""
    if found.determinant is None:
        return False
    ours = to_sympy(found.determinant)
    point = {name: 0.3 + 0.17 * k for k, name in enumerate(sorted(theirs.free_symbols, key=str))}
    return abs(float((ours - theirs).subs(point))) < CLOSE


def by_numpy(robot: Robot) -> Callable[[Array], Array]:
    """The columns z × (p - o) over stacks of matrices, as a person who knows numpy writes it."""
    chain = links(robot)

    def columns(q: Array) -> Array:
        pose = np.broadcast_to(np.eye(4), (len(q), 4, 4))
        axes = []
        for link in chain:
            before = pose
            matrix = np.zeros((len(q), 4, 4))
            for i, row in enumerate((*link.rows(q, robot.convention), (0, 0, 0, 1))):
                for k, entry in enumerate(row):
                    matrix[:, i, k] = entry
            pose = before @ matrix
            at = pose if robot.convention is Convention.MODIFIED else before
            if link.moves:
                axes.append((link, at[:, :3, 2], at[:, :3, 3]))
        found = np.zeros((len(q), 6, len(axes)))
        for link, axis, origin in axes:
            if link.moves == SLIDE:
                found[:, :3, link.joint] = axis
            else:
                found[:, :3, link.joint] = np.cross(axis, pose[:, :3, 3] - origin)
                found[:, 3:, link.joint] = axis
        return found

    return columns


def by_toolbox(robot: Robot) -> Callable[[Array], Array]:
    """`jacob0` of a DHRobot of the Robotics Toolbox; fixed rows go into its tool."""
    from roboticstoolbox import DHRobot, PrismaticDH, PrismaticMDH, RevoluteDH, RevoluteMDH
    from spatialmath import SE3

    modified = robot.convention is Convention.MODIFIED
    turn, slide = (RevoluteMDH, PrismaticMDH) if modified else (RevoluteDH, PrismaticDH)
    made, tool = [], SE3()
    for link in links(robot):
        if link.moves == TURN:
            made.append(turn(a=link.a, alpha=link.alpha, d=link.d, offset=link.theta))
        elif link.moves == SLIDE:
            made.append(slide(a=link.a, alpha=link.alpha, theta=link.theta, offset=link.d, qlim=[0, 1]))
        else:
            tool = tool * SE3.Rx(link.alpha) * SE3(link.a, 0, link.d) * SE3.Rz(link.theta)
    arm = DHRobot(made, tool=tool)
    return arm.jacob0


def by_pinocchio(robot: Robot) -> Callable[[Array], Array]:
    """The Jacobian of a frame of a pinocchio model, along the axes of the world."""
    import pinocchio as pin

    model = pin.Model()
    joint, fixed = 0, pin.SE3.Identity()
    for link in links(robot):
        for move, constant, moving in link.steps(robot.convention):
            axis = np.eye(3)[0 if move.endswith("x") else 2]
            rotation = pin.AngleAxis(constant, axis).matrix() if move.startswith("R") else np.eye(3)
            fixed = fixed * pin.SE3(rotation, axis * constant if move.startswith("t") else np.zeros(3))
            if moving:
                kind = pin.JointModelRZ() if moving == TURN else pin.JointModelPZ()
                joint, fixed = model.addJoint(joint, kind, fixed, f"q{link.joint}"), pin.SE3.Identity()
    end = model.addFrame(pin.Frame("end", joint, 0, fixed, pin.FrameType.OP_FRAME))
    data = model.createData()
    world = pin.ReferenceFrame.LOCAL_WORLD_ALIGNED
    return lambda q: pin.computeFrameJacobian(model, data, q, end, world)


def by_jax(robot: Robot) -> Callable[[Array], Array]:
    """`jacfwd` of the position and the rotation of one pose, mapped over the stack and compiled by XLA."""
    import jax

    jax.config.update("jax_enable_x64", val=True)
    chain = links(robot)

    def pose(q: jax.Array) -> jax.Array:
        found = jax.numpy.eye(4)
        for link in chain:
            found = found @ jax.numpy.array((*link.rows(q, robot.convention, jax.numpy), (0, 0, 0, 1)))
        return found

    def columns(q: jax.Array) -> jax.Array:
        slopes = jax.jacfwd(pose)(q)
        turning = jax.numpy.einsum("ikn,jk->ijn", slopes[:3, :3], pose(q)[:3, :3])
        skew = jax.numpy.stack([turning[2, 1], turning[0, 2], turning[1, 0]])
        return jax.numpy.concatenate([slopes[:3, 3], skew])

    many = jax.jit(jax.vmap(columns))
    return lambda q: np.asarray(many(q))


@dataclass(frozen=True)
class JacobianPeer(Peer):
    """Something else that computes Jacobians; `build` gives a function to shape (6, n).

    Attributes:
        most: A peer that takes half a millisecond for each is run for at most so many.
    """

    most: int = MANY

    def many(self, robot: Robot) -> Callable[[Array], Array]:
        """A function from joint values, shape (N, n), to Jacobians, shape (N, 6, n)."""
        single = self.build(robot)
        return single if self.stacks else lambda q: np.stack([single(values) for values in q])


PEERS = (
    JacobianPeer("numpy, z × (p - o)", "numpy", by_numpy),
    JacobianPeer("Robotics Toolbox, jacob0", "roboticstoolbox-python", by_toolbox, stacks=False, most=2000),
    JacobianPeer("pinocchio, computeFrameJacobian", "pin", by_pinocchio, stacks=False),
    JacobianPeer("JAX, jit, vmap, jacfwd", "jax", by_jax),
)
