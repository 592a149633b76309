"""Inverse kinematics beside other libraries: `python tests/bench/inverse_peers.py [--arms N] [--poses N]`.

For arms of each class, and for robots of the library, all of whose joints turn: which share of all solutions that
anybody finds each finds, how many it gives that are none, and how long a pose takes, all in this one run on one core.
Known are the solutions that forward kinematics confirms; ik-geo
says of most of those that are none that they are only the nearest. A peer that is not installed is left out:
`pip install EAIK==1.2.2 ssik==8.2.0 ik-geo==1.0.3 roboticstoolbox-python==1.5.0`.
"""

from __future__ import annotations

import argparse
import os
import sys
import time
from collections.abc import Callable, Iterator
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from typing import Any

os.environ.update(dict.fromkeys(("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"), "1"))
sys.path.insert(0, str(Path(__file__).parents[2]))

import numpy as np

from dhcli import load_robot
from dhcli.kinematics.inverse.arm import Arm
from dhcli.kinematics.inverse.planning import find_plan
from dhcli.kinematics.inverse.polishing import product, residuals
from dhcli.kinematics.inverse.question import ask
from dhcli.kinematics.inverse.running import run
from dhcli.kinematics.inverse.tasks import TASKS
from tests.kinematics.inverse.arms import CLASSES, random_arm, random_motions

Array = np.ndarray[Any, np.dtype[np.float64]]
Solver = Callable[[Array], list[Array]]
"""Solutions (K, 6) of each of the poses (N, 4, 4) of the end, its zero pose without a turn."""

ROBOTS = ("puma560", "ur5e", "zhou-6r")
KINDS = (
    *("spherical wrist", "spherical wrist, two parallel", "spherical wrist, two meet", "spherical base"),
    *("three parallel", "three parallel, two meet", "two parallel", "two meet", "offset wrist", "general"),
)
IK_GEO = {
    "spherical wrist": "spherical",
    "spherical wrist, two parallel": "spherical_two_parallel",
    "spherical wrist, two meet": "spherical_two_intersecting",
    "three parallel": "three_parallel",
    "three parallel, two meet": "three_parallel_two_intersecting",
    "two parallel": "two_parallel",
    "two meet": "two_intersecting",
    "general": "gen_six_dof",
    "puma560": "spherical_two_parallel",
    "ur5e": "three_parallel_two_intersecting",
}
"""Which of its classes an arm is; its user has to say so."""

EXACT = 1e-6
"""What reaches its pose to this is a solution that is known [reaches, direction cosines]."""

NEARLY = 1e-4
"""What misses its pose by more is none; peers that search stop early."""

SAME = 1e-2
"""Joint values closer than this to a known solution are that one; known ones are closer to each other beside a singular
pose only [rad]."""

APART = 1e-3
"""Known solutions closer than this are counted once [rad]."""

TRIES = np.tile(np.pi * np.array([0.0, 0.5, -0.5, 1.0]), (6, 1))


def axes_and_offsets(arm: Arm) -> tuple[Array, Array]:
    """Directions of the axes, shape (6, 3), and the ways from each to the next, shape (7, 3), in the zero pose."""
    along = np.array([axis.direction for axis in arm.axes[:6]])
    points = np.array([np.zeros(3), *(axis.point for axis in arm.axes[:6]), arm.home[:3, 3]])
    return along, np.diff(points, axis=0)


def by_dhcli(_name: str, arm: Arm) -> Solver:
    """This program, with the check that each solution reaches its pose."""
    plan = find_plan(arm)
    turn = np.eye(4)
    turn[:3, :3] = arm.home[:3, :3]
    back = np.linalg.inv(arm.home)

    def solve(poses: Array) -> list[Array]:
        found = run(plan, TASKS["pose"], poses @ turn @ back, TRIES)
        return np.split(found.motions, np.searchsorted(found.index, np.arange(1, len(poses))))

    return solve


def by_eaik(_name: str, arm: Arm) -> Solver | None:
    """EAIK, C++; None where it knows no decomposition."""
    from eaik.IK_HP import HPRobot

    robot = HPRobot(*axes_and_offsets(arm))
    if not robot.hasKnownDecomposition():
        return None
    return lambda poses: [np.array(found.Q).reshape(-1, 6) for found in robot.IK_batched(poses, 1)]


def by_ssik(name: str, arm: Arm) -> Solver | None:
    """Ssik, C++; arms of other classes than these it prepares for minutes each, and they are left out."""
    import ssik

    if name not in {*ROBOTS, *(kind for kind in KINDS if kind.startswith("spherical wrist"))}:
        return None
    robot = ssik.Manipulator.from_axes(*axes_and_offsets(arm))
    return lambda poses: [np.array([one.q for one in robot.solve(pose)]).reshape(-1, 6) for pose in poses]


def by_ik_geo(name: str, arm: Arm) -> Solver | None:
    """IK-Geo, Rust; None for a class that it does not have."""
    import ik_geo

    if name not in IK_GEO:
        return None
    robot = getattr(ik_geo.Robot, IK_GEO[name])(*(part.tolist() for part in axes_and_offsets(arm)))

    def solve(poses: Array) -> list[Array]:
        found = [robot.get_ik(pose[:3, :3].T.tolist(), pose[:3, 3].tolist()) for pose in poses]  # columns
        return [np.array([q for q, _ in each]).reshape(-1, 6) for each in found]

    return solve


def by_toolbox(_name: str, arm: Arm) -> Solver:
    """Robotics Toolbox: Levenberg and Marquardt from random joint values, C; one solution."""
    from roboticstoolbox import ET, ETS
    from spatialmath import SE3

    along, offsets = axes_and_offsets(arm)
    chain = ETS()
    turn = np.eye(3)
    for joint, (axis, offset) in enumerate(zip(along, offsets[:-1], strict=True)):
        helper = np.eye(3)[int(np.argmin(np.abs(axis)))]
        x = np.cross(helper, axis) / np.linalg.norm(np.cross(helper, axis))
        now = np.column_stack([x, np.cross(axis, x), axis])
        chain *= ET.SE3(SE3.Rt(turn.T @ now, turn.T @ offset)) * ET.Rz(jindex=joint)
        turn = now
    chain *= ET.SE3(SE3.Rt(turn.T, turn.T @ offsets[-1]))

    def solve(poses: Array) -> list[Array]:
        found = [chain.ik_LM(pose, tol=1e-12) for pose in poses]
        return [np.array(one.q if one.success else []).reshape(-1, 6) for one in found]

    return solve


PEERS: dict[str, tuple[str, Callable[[str, Arm], Solver | None]]] = {
    "dhcli": ("dhcli", by_dhcli),
    "EAIK": ("EAIK", by_eaik),
    "ssik": ("ssik", by_ssik),
    "ik-geo": ("ik-geo", by_ik_geo),
    "RTB LM": ("roboticstoolbox-python", by_toolbox),
}


def arms(count: int) -> Iterator[tuple[str, list[Arm]]]:
    """The arms of each line."""
    for name in ROBOTS:
        yield name, [ask(load_robot(name), "pose")[0].ready.arm]
    for name in KINDS:
        yield name, [random_arm(CLASSES[name], np.random.default_rng(seed)) for seed in range(count)]


def line(name: str, made: list[Arm], peers: list[str], poses: int) -> str:
    """What each peer found of all that are known, how many strangers it gave, and its microseconds a pose."""
    known = 0
    found, strangers, seconds = (dict.fromkeys(peers, 0) for _ in range(3))
    spent = dict.fromkeys(peers, 0.0)
    refused = set[str]()
    for seed, arm in enumerate(made):
        _, goal = random_motions(arm, poses, np.random.default_rng(100 + seed))
        wanted = goal @ arm.home
        wanted[:, :3, :3] = wanted[:, :3, :3] @ arm.home[:3, :3].T
        answers = {}
        for peer in peers:
            solver = PEERS[peer][1](name, arm)
            if solver is None:
                refused.add(peer)
                continue
            solver(wanted[:1])
            start = time.perf_counter()
            answers[peer] = solver(wanted)
            spent[peer] += time.perf_counter() - start
            seconds[peer] += poses
        for k in range(poses):
            union = np.empty((0, 6))
            own: dict[str, Array] = {}
            for peer, answer in answers.items():
                rows = answer[k]
                there = np.repeat(goal[k : k + 1], len(rows), axis=0)
                left = residuals(TASKS["pose"], arm.home, product(arm, rows), there) if len(rows) else np.empty(0)
                strangers[peer] += int((left > NEARLY).sum())
                own[peer] = rows[left <= NEARLY]
                for row in rows[left <= EXACT]:
                    if not (apart(union, row) < APART).any():
                        union = np.vstack([union, row])
            known += len(union)
            for peer, rows in own.items():
                found[peer] += sum(bool((apart(rows, row) < SAME).any()) for row in union)
    cells = []
    for peer in peers:
        if peer in refused:
            cells.append(f"{'refused':>22}")
            continue
        strange = f" +{strangers[peer]}" if strangers[peer] else ""
        cells.append(f"{100 * found[peer] / known:7.2f} %{strange:>5}{spent[peer] / seconds[peer] * 1e6:6.0f} us")
    return f"{name:30} {known:6} " + " ".join(cells)


def apart(rows: Array, row: Array) -> Array:
    """How far joint values are from others, whole turns aside."""
    return np.abs(np.angle(np.exp(1j * (rows - row)))).max(axis=1, initial=0.0)


def main() -> None:
    """Print the table."""
    parser = argparse.ArgumentParser("python tests/bench/inverse_peers.py", description=__doc__)
    parser.add_argument("--arms", type=int, default=8, help="random arms of each class (default: 8)")
    parser.add_argument("--poses", type=int, default=40, help="poses of each arm (default: 40)")
    asked = parser.parse_args()
    there = []
    for peer, (package, _) in PEERS.items():
        try:
            there.append((peer, version(package)))
        except PackageNotFoundError:
            print(f"{peer} is not installed")
    print(f"{'class':30} {'known':>6} " + " ".join(f"{f'{peer} {number}':>22}" for peer, number in there))
    for name, made in arms(asked.arms):
        print(line(name, made, [peer for peer, _ in there], asked.poses), flush=True)


if __name__ == "__main__":
    main()
