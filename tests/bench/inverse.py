"""Inverse kinematics in figures: `python tests/bench/inverse.py [--arms N]`.

How long a pose takes, in a batch and by itself, with every solution and the check that each reaches the pose; how long
a plan takes; and of random arms of many classes how many of the joint values that poses were made from are found again.
"""

from __future__ import annotations

import argparse
import os
import sys
import time
from pathlib import Path

os.environ.update(dict.fromkeys(("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"), "1"))
sys.path.insert(0, str(Path(__file__).parents[2]))

import numpy as np

from dhcli import forward, forward_batch, inverse, inverse_batch, load_robot
from dhcli.kinematics.inverse.planning import find_plan
from dhcli.kinematics.inverse.prepared import prepare
from dhcli.kinematics.inverse.running import run
from dhcli.kinematics.inverse.tasks import TASKS
from tests.kinematics.inverse.arms import CLASSES, odd, random_arm, random_motions

ROBOTS = ("puma560", "ur5e", "zhou-6r", "stanford", "cylindrical-wrist", "scara-yim", "planar-2r")
POSES = 20_000
PER_ARM = 20
TRIES = np.tile(np.pi * np.array([0.0, 0.5, -0.5, 1.0]), (6, 1))


def robots() -> None:
    """A line for each robot."""
    print(f"{'robot':20} {'us a pose':>10} {'solutions':>10} {'found':>8} {'one pose':>9} {'plan':>7}")
    for name in ROBOTS:
        robot = load_robot(name)
        q = np.random.default_rng(1).uniform(-2, 2, (POSES, len(robot.variables)))
        poses = forward_batch(robot, q)
        prepare.cache_clear()
        start = time.process_time()
        inverse_batch(robot, poses[:1])
        plan = time.process_time() - start
        start = time.process_time()
        found, index = inverse_batch(robot, poses)
        spent = time.process_time() - start
        gap = np.abs(np.angle(np.exp(1j * (found - q[index])))).max(axis=1)
        best = np.full(POSES, np.inf)
        np.minimum.at(best, index, gap)
        single = forward(robot, list(q[0]))
        start = time.process_time()
        for _ in range(20):
            inverse(robot, single)
        one = (time.process_time() - start) / 20
        share = f"{(best < 1e-6).mean():.2%}"
        figures = f"{spent / POSES * 1e6:10.1f} {len(index) / POSES:10.2f} {share:>8}"
        print(f"{name:20} {figures} {one * 1e3:6.1f} ms {plan * 1e3:4.0f} ms")


def classes(arms: int) -> None:
    """A line for each class of random arms."""
    print(f"\n{'class':34} {'rules':10} {'found':>14} {'odd':>4} {'us a pose':>10} {'plan':>7}")
    for name, kind in CLASSES.items():
        total = found = alone = 0
        planning = solving = 0.0
        rules = set[str]()
        for seed in range(arms):
            rng = np.random.default_rng(seed)
            arm = random_arm(kind, rng)
            motions, goal = random_motions(arm, PER_ARM, rng)
            start = time.process_time()
            plan = find_plan(arm)
            planning += time.process_time() - start
            rules.add("+".join(sorted(plan.rules)))
            start = time.process_time()
            result = run(plan, TASKS[kind.task], goal, TRIES)
            solving += time.process_time() - start
            gap = result.motions - motions[result.index]
            gap = np.abs(np.where(arm.turning, gap - 2 * np.pi * np.round(gap / (2 * np.pi)), gap)).max(axis=1)
            best = np.full(PER_ARM, np.inf)
            np.minimum.at(best, result.index, gap)
            total += PER_ARM
            found += int((best < 1e-6).sum())
            alone += odd(kind, arm, result, PER_ARM)
        figures = f"{f'{found}/{total}':>14} {alone:4} {solving / total * 1e6:10.0f}"
        print(f"{name:34} {'/'.join(sorted(rules)):10} {figures} {planning / arms * 1e3:4.0f} ms")


def main() -> None:
    """Print both tables."""
    parser = argparse.ArgumentParser("python tests/bench/inverse.py", description=__doc__)
    parser.add_argument("--arms", type=int, default=20, help="random arms of each class (default: 20)")
    asked = parser.parse_args()
    robots()
    classes(asked.arms)


if __name__ == "__main__":
    main()
