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
MANY = 1_000_000
LOOPS = 100_000
"""A peer that takes one pose at a time is run for at most so many."""

CLOSE = 1e-12
PART = 100_000


def one(rounds: int, robots: tuple[str, ...] = (PUMA, PANDA)) -> Iterator[Row]:
    """One pose, beside each peer."""
    for robot in map(load_robot, robots):
        q = joint_values(robot, 1)[0]
        values = q.tolist()
        for peer in PEERS:
            work = f"one pose of {robot.name}"
            ours = Task("forward(robot, q)", lambda robot=robot, values=values: np.array(forward(robot, values).rows))
            yield beside(work, ours, peer, lambda robot=robot, peer=peer: peer.build(robot), q, rounds)


def batch(rounds: int, sizes: tuple[int, ...] = SIZES) -> Iterator[Row]:
    """Batches of PUMA 560: the time of a pose stays what it is as the batch grows."""
    robot = load_robot(PUMA)
    for size in sizes:
        for peer in PEERS:
            if peer.stacks or size <= LOOPS:
                yield of_many(robot, size, peer, rounds)


def joints(rounds: int, size: int = MANY) -> Iterator[Row]:
    """Batches of Panda up to joint 2, 3, ... 7: the time of a pose grows by about the same with each joint."""
    panda = load_robot(PANDA)
    for count in range(2, len(panda.variables) + 1):
        arm = replace(
            panda,
            name=f"{count} joints",
            variables=panda.variables[:count],
            links=panda.links[:count],
            limits={},
            poses={},
        )
        row = of_many(arm, size, PEERS[0], rounds)
        if row.pairs:
            row = replace(row, note=f"{row.note}, {number(row.seconds / size / count * 1e9)} ns a joint")
        yield row


def of_many(robot: Robot, size: int, peer: Peer, rounds: int) -> Row:
    """One row of a batch."""
    q = joint_values(robot, size)
    ours = Task("forward_batch(robot, Q)", lambda: forward_batch(robot, q))
    row = beside(
        f"{size:.0e} poses of {robot.name}".replace("e+0", "e"), ours, peer, lambda: peer.many(robot), q, rounds
    )
    return replace(row, note=f"{number(row.seconds / size * 1e9)} ns a pose") if row.pairs else row


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
