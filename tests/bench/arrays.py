"""Arrays of other libraries: poses that JAX and PyTorch compute by our steps, beside what is written for them."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace

import numpy as np
from measure import Row, Task, side_by_side
from peers import PEERS, Array, Peer
from poses import equal, joint_values, many, nanoseconds

from dhcli import Robot, forward_batch, load_robot
from dhcli.files.urdf.writing import urdf_text

PUMA = "puma560"
SIZES = (1000, 100_000)

ROUGH = 1e-6
"""PyTorch Kinematics keeps the constants of a chain in single precision [m]."""


def rows(rounds: int, sizes: tuple[int, ...] = SIZES) -> Iterator[Row]:
    """Poses in arrays of JAX, compiled, beside JAX; of PyTorch beside PyTorch Kinematics."""
    robot = load_robot(PUMA)
    (jax,) = (peer for peer in PEERS if peer.package == "jax")
    for size in sizes:
        yield beside(robot, size, "jit(forward_batch)", by_our_jax, jax, equal, rounds)
        yield beside(robot, size, "forward_batch, tensors", by_our_torch, KINEMATICS, roughly, rounds)


def beside(  # one row
    robot: Robot,
    size: int,
    name: str,
    build: Callable[[Robot], Callable[[Array], Array]],
    peer: Peer,
    same: Callable[[Array, Array], bool],
    rounds: int,
) -> Row:
    """Ours beside a peer, or a row that says that the peer is not there."""
    if not peer.version:
        return Row(many(size, robot), name, peer.name)
    q, ours, theirs = joint_values(robot, size), build(robot), peer.build(robot)
    row = side_by_side(
        many(size, robot), Task(name, lambda: ours(q)), Task(peer.name, lambda: theirs(q)), same, rounds=rounds
    )
    return replace(row, note=f"{nanoseconds(row, size)} a pose")


def by_our_jax(robot: Robot) -> Callable[[Array], Array]:
    """Our steps, compiled by XLA in double precision."""
    import jax

    jax.config.update("jax_enable_x64", val=True)
    compiled = jax.jit(lambda q: forward_batch(robot, q))
    return lambda q: np.asarray(compiled(jax.numpy.asarray(q)))


def by_our_torch(robot: Robot) -> Callable[[Array], Array]:
    """Our steps on tensors, one after another."""
    import torch

    torch.set_num_threads(1)
    return lambda q: np.asarray(forward_batch(robot, torch.as_tensor(q)))


def by_kinematics(robot: Robot) -> Callable[[Array], Array]:
    """A serial chain of PyTorch Kinematics, from the URDF that we write, in double precision."""
    import pytorch_kinematics
    import torch

    chain = pytorch_kinematics.build_serial_chain_from_urdf(urdf_text(robot).encode(), "tool0").to(dtype=torch.float64)
    return lambda q: np.asarray(chain.forward_kinematics(torch.as_tensor(q)).get_matrix())


def roughly(ours: Array, theirs: Array) -> bool:
    """Whether poses agree as far as single precision goes."""
    return bool(np.abs(ours - theirs).max() < ROUGH)


KINEMATICS = Peer("PyTorch Kinematics", "pytorch-kinematics", by_kinematics)
