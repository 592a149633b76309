"""Poses in numbers: one in the process, and many at once, beside the peers that are installed, all on one core."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace

import numpy as np
from measure import Row, Task, number, side_by_side
from peers import PEERS, Array, Peer

from dhcli import Robot, forward, forward_batch, load_robot

PUMA, PANDA = "puma560", "panda"
SIZES = (10_000, 100_000, 1_000_000, 10_000_000)
MANY = 100_000
LOOPS = 100_000
"""A peer that takes one pose at a time is run for at most so many."""

CLOSE = 1e-12
PART = 100_000


def one(rounds: int, robots: tuple[str, ...] = (PUMA,)) -> Iterator[Row]:
    """One pose, beside each peer."""
    for robot in map(load_robot, robots):
        q = joint_values(robot, 1)[0]
        values = q.tolist()
        for peer in PEERS:
            work = f"one pose of {robot.name}"
            ours = Task("forward(robot, q)", lambda robot=robot, values=values: np.array(forward(robot, values).rows))
            yield beside(work, ours, peer, lambda robot=robot, peer=peer: peer.build(robot), q, rounds)


def batch(rounds: int, sizes: tuple[int, ...] = SIZES) -> Iterator[Row]:
    """Batches of PUMA 560, beside each peer, all into new memory."""
    robot = load_robot(PUMA)
    for size in sizes:
        for peer in PEERS:
            if peer.stacks or size <= LOOPS:
                yield of_many(robot, size, peer, rounds)


def growth(rounds: int, sizes: tuple[int, ...] = SIZES, size: int = MANY) -> Iterator[Row]:
    """The time of a pose over the number of poses, without and with new memory, and over the number of joints."""
    puma, panda = load_robot(PUMA), load_robot(PANDA)
    for count in sizes:
        yield into_place(puma, count, rounds)
    for count in range(2, len(panda.variables) + 1):
        variables, links = panda.variables[:count], panda.links[:count]
        arm = replace(panda, name=f"{count} joints", variables=variables, links=links, limits={}, poses={})
        row = of_many(arm, size, PEERS[0], rounds)
        yield replace(row, note=f"{row.note}, {nanoseconds(row, size * count)} a joint") if row.pairs else row


def of_many(robot: Robot, size: int, peer: Peer, rounds: int) -> Row:
    """One row of a batch."""
    q = joint_values(robot, size)
    ours = Task("forward_batch(robot, Q)", lambda: forward_batch(robot, q))
    row = beside(many(size, robot), ours, peer, lambda: peer.many(robot), q, rounds)
    return replace(row, note=f"{nanoseconds(row, size)} a pose") if row.pairs else row


def into_place(robot: Robot, size: int, rounds: int) -> Row:
    """A batch into memory that is there already, beside one into new memory, which the system must hand out first."""
    q, poses = joint_values(robot, size), np.zeros((size, 4, 4))
    ours = Task("forward_batch(..., out=T)", lambda: forward_batch(robot, q, out=poses))
    peer = Task("forward_batch(robot, Q)", lambda: forward_batch(robot, q))
    row = side_by_side(many(size, robot), ours, peer, equal, rounds=rounds)
    return replace(row, note=f"{nanoseconds(row, size)} a pose")


def many(size: int, robot: Robot) -> str:
    """The work of a batch: `1e5 poses of puma560`."""
    return f"{size:.0e} poses of {robot.name}".replace("e+0", "e")


def nanoseconds(row: Row, count: int) -> str:
    """Our time for one of so many [ns]."""
    return f"{number(row.seconds / count * 1e9)} ns"


def beside(
    work: str, ours: Task[Array], peer: Peer, build: Callable[[], Callable[[Array], Array]], q: Array, rounds: int
) -> Row:
    """Ours beside a peer, or a row that says that the peer is not there."""
    if not peer.version:
        return Row(work, ours.name, peer.name)
    pose = build()
    return side_by_side(work, ours, Task(peer.name, lambda: pose(q)), equal, rounds=rounds)


def equal(ours: Array, theirs: Array) -> bool:
    """Whether two poses, or two stacks of them, agree; part by part, for a stack is a gigabyte."""
    if ours.shape != theirs.shape:
        return False
    parts = [slice(first, first + PART) for first in range(0, len(ours), PART)]
    return all(np.allclose(ours[part], theirs[part], rtol=0, atol=CLOSE) for part in parts)


def joint_values(robot: Robot, size: int) -> Array:
    """Values over a turn, or a metre, for every joint; shape (size, n)."""
    spans = [2 * np.pi if joint.kind == "revolute" else 1.0 for joint in robot.joints]
    return np.random.default_rng(1).uniform(size=(size, len(spans))) * spans
