"""Poses in numbers: one in the process, and many at once, beside the peers that are installed."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import replace
from importlib.util import find_spec
from itertools import product
from types import SimpleNamespace

import numpy as np
from measure import Row, Task, number, side_by_side
from peers import PEERS, Array, Peer

from dhcli import Robot, forward, forward_batch, load_robot, sweep
from dhcli.algebra import kernel

PUMA, PANDA = "puma560", "panda"
SIZES = (1000, 10_000, 100_000, 1_000_000, 10_000_000)
MANY = 100_000
CLOSE = 1e-12
LOADER = kernel._LOADED
"""What has the compiled loop, or will."""

PART = 100_000


def one(rounds: int, robots: tuple[str, ...] = (PUMA,)) -> Iterator[Row]:
    """One pose of a robot that was asked before, and a batch of one, beside each peer."""
    for robot in map(load_robot, robots):
        q = joint_values(robot, 1)[0]
        values, row = q.tolist(), q[np.newaxis]
        work = f"one pose of {robot.name}"
        ours = [
            Task("forward(robot, q)", lambda robot=robot, values=values: np.array(forward(robot, values).rows)),
            Task("forward_batch(robot, [q])", lambda robot=robot, row=row: forward_batch(robot, row)[0]),
        ]
        for task in ours:
            task.work()  # the first is had without recording, the second records
            task.work()
        for task, peer in product(ours, PEERS):
            yield beside(work, task, peer, lambda robot=robot, peer=peer: peer.build(robot), q, rounds)


def batch(rounds: int, sizes: tuple[int, ...] = SIZES) -> Iterator[Row]:
    """Batches of PUMA 560 by numpy alone, beside each peer, all into new memory."""
    with by_numpy_alone():
        yield from beside_each(rounds, sizes)


def fast(rounds: int, sizes: tuple[int, ...] = SIZES) -> Iterator[Row]:
    """The same by the compiled loop, beside numpy alone, single precision and each peer."""
    robot = load_robot(PUMA)
    if find_spec("numba") is None:
        yield Row(many(sizes[0], robot), "dhcli[fast]", "numba")
        return
    with by_the_loop():
        for size in sizes:
            touch(size)
            q = joint_values(robot, size)
            ours = Task("dhcli[fast]", lambda q=q: forward_batch(robot, q))
            for peer, close in (
                (Task("numpy alone", lambda q=q: by_numpy(robot, q)), equal),
                (Task("in float32", lambda q=q: forward_batch(robot, q, dtype=np.float32)), nearly),
            ):
                row = side_by_side(many(size, robot), ours, peer, close, rounds=rounds)
                yield replace(row, note=f"{nanoseconds(row, size)} a pose")
        yield from beside_each(rounds, sizes)


def threads(rounds: int, sizes: tuple[int, ...] = (1_000_000, 4_000_000), count: int = 201) -> Iterator[Row]:
    """Two threads beside one: batches by numpy alone and by the compiled loop, into memory that is there; a sweep."""
    ways = (by_numpy_alone, by_the_loop) if find_spec("numba") else (by_numpy_alone,)
    for way, size in product(ways, sizes):
        with way():
            row = two_threads(load_robot(PUMA), size, rounds)
            yield replace(row, ours=f"{row.ours}, {way.__name__.replace('_', ' ')}")
    robot, over = load_robot(PUMA), {f"q{k}": f"-1..1 n {count}" for k in (1, 2, 3)}
    yield side_by_side(
        f"a grid of {count}x{count}x{count}",
        Task("threads=2, sweep", lambda: sweep(robot, over, point=(0, 0, 0.1), threads=2)),
        Task("threads=1", lambda: sweep(robot, over, point=(0, 0, 0.1))),
        lambda ours, theirs: ours == theirs,
        rounds=rounds,
    )


def two_threads(robot: Robot, size: int, rounds: int) -> Row:
    """One row of threads."""
    q, shared, alone = joint_values(robot, size), np.zeros((size, 4, 4)), np.zeros((size, 4, 4))
    ours = Task("threads=2", lambda: forward_batch(robot, q, out=shared, threads=2))
    peer = Task("threads=1", lambda: forward_batch(robot, q, out=alone))
    return side_by_side(many(size, robot), ours, peer, equal, rounds=rounds)


def sweeps(rounds: int, counts: tuple[int, ...] = (31, 101, 201)) -> Iterator[Row]:
    """A grid of three joints of PUMA 560, beside a batch of all its rows and the largest of their distances."""
    robot, point = load_robot(PUMA), np.array([0, 0, 0.1])
    for count in counts:
        axes = [np.linspace(-1, 1, count)] * 3
        over = dict.fromkeys(robot.variables[:3], f"-1..1 n {count}")

        def by_rows(axes: list[Array] = axes) -> float:
            q = np.zeros((len(axes[0]) ** 3, 6))
            q[:, :3] = np.stack([axis.ravel() for axis in np.meshgrid(*axes, indexing="ij")], axis=1)
            poses = by_numpy(robot, q)
            return float(np.linalg.norm(poses[:, :3, 3] + poses[:, :3, :3] @ point, axis=1).max())

        row = side_by_side(
            f"a grid of {count}x{count}x{count}",
            Task("sweep", lambda over=over: sweep(robot, over, point=point.tolist()).farthest.distance),
            Task("forward_batch, max", by_rows),
            lambda ours, theirs: abs(ours - theirs) < CLOSE,
            rounds=rounds,
        )
        yield replace(row, note=f"{nanoseconds(row, count**3)} a pose, of all its sides")


def beside_each(rounds: int, sizes: tuple[int, ...]) -> Iterator[Row]:
    """Batches of each size beside each peer."""
    robot = load_robot(PUMA)
    for size, peer in product(sizes, PEERS):
        if size <= peer.most:
            touch(size)
            yield of_many(robot, size, peer, rounds)


@contextmanager
def by_numpy_alone() -> Iterator[None]:
    """As where the extra is not installed."""
    loaded, kernel._LOADED = kernel._LOADED, SimpleNamespace(loop=None, is_ready=lambda count: False)
    try:
        yield
    finally:
        kernel._LOADED = loaded


@contextmanager
def by_the_loop() -> Iterator[None]:
    """As in a program that has imported numba."""
    import numba  # noqa: F401  what is asked for

    loaded, kernel._LOADED = kernel._LOADED, LOADER
    try:
        if not kernel.is_ready(0):
            raise SystemExit("numba is installed, but does not work")
        yield
    finally:
        kernel._LOADED = loaded


def by_numpy(robot: Robot, q: Array) -> Array:
    """Poses by numpy alone."""
    with by_numpy_alone():
        return forward_batch(robot, q)


def nearly(ours: Array, theirs: Array) -> bool:
    """Whether single precision says the same to its last digit."""
    return np.allclose(ours, theirs, rtol=6e-8, atol=1e-12)


def growth(rounds: int, sizes: tuple[int, ...] = SIZES, size: int = MANY) -> Iterator[Row]:
    """The time of a pose by numpy alone over the number of poses, with and without new memory, and of joints."""
    with by_numpy_alone():
        yield from _growth(rounds, sizes, size)


def _growth(rounds: int, sizes: tuple[int, ...], size: int) -> Iterator[Row]:
    puma, panda = load_robot(PUMA), load_robot(PANDA)
    for count in sizes:
        touch(count)
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


def touch(size: int) -> None:
    """Write once to as much memory as two results take, so that the system has it at hand.

    A virtual machine asks its host for every page that none of its programs touched before; that took ten times as long
    as to play the rows of ours that met it first, and is told of no library.
    """
    np.empty((2 * size, 4, 4)).fill(1.0)


def joint_values(robot: Robot, size: int) -> Array:
    """Values over a turn, or a metre, for every joint; shape (size, n)."""
    spans = [2 * np.pi if joint.kind == "revolute" else 1.0 for joint in robot.joints]
    return np.random.default_rng(1).uniform(size=(size, len(spans))) * spans
