"""Random arms of many classes, as inverse kinematics sees them: axes anywhere, but for what makes the class."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from dhcli.kinematics.inverse.arm import Arm, Axis
from dhcli.kinematics.inverse.found import Found
from dhcli.kinematics.inverse.polishing import SINGULAR, extent, jacobian, product
from dhcli.kinematics.inverse.running import FULL
from dhcli.kinematics.inverse.tasks import TASKS, TaskName, for_task


@dataclass(frozen=True)
class Class:
    """A class of arms.

    Attributes:
        joints: R or P for each joint.
        parallel: Runs of joints whose axes are parallel.
        meeting: Runs of joints whose axes meet in a point.
        task: What is wanted of the end.
    """

    joints: str
    parallel: tuple[tuple[int, ...], ...] = ()
    meeting: tuple[tuple[int, ...], ...] = ()
    task: TaskName = "pose"


CLASSES = {
    "spherical wrist": Class("RRRRRR", meeting=((3, 4, 5),)),
    "spherical wrist, two parallel": Class("RRRRRR", ((1, 2),), ((3, 4, 5),)),
    "spherical wrist, two meet": Class("RRRRRR", meeting=((3, 4, 5), (0, 1))),
    "spherical base": Class("RRRRRR", meeting=((0, 1, 2),)),
    "spherical middle": Class("RRRRRR", meeting=((1, 2, 3),)),
    "three parallel": Class("RRRRRR", ((1, 2, 3),)),
    "first three parallel": Class("RRRRRR", ((0, 1, 2),)),
    "three parallel, two meet": Class("RRRRRR", ((1, 2, 3),), ((4, 5),)),
    "offset wrist": Class("RRRRRR", ((1, 2),), ((3, 4), (0, 1))),
    "offset wrist, three pairs meet": Class("RRRRRR", ((1, 2),), ((0, 1), (2, 3), (4, 5))),
    "two parallel": Class("RRRRRR", ((1, 2),)),
    "two meet": Class("RRRRRR", meeting=((4, 5),)),
    "general": Class("RRRRRR"),
    "slide first": Class("PRRRRR"),
    "two slides": Class("RPPRRR"),
    "slide third": Class("RRPRRR"),
    "slide fourth": Class("RRRPRR"),
    "slide third, wrist": Class("RRPRRR", meeting=((3, 4, 5),)),
    "slides third and last": Class("RRPRRP"),
    "slides second and fourth": Class("RPRPRR"),
    "three slides, wrist": Class("PPPRRR", meeting=((3, 4, 5),)),
    "five joints": Class("RRRRR"),
    "four joints": Class("RRRR"),
    "three joints": Class("RRR"),
    "four joints, one slides": Class("RRPR"),
    "three joints, position": Class("RRR", task="position"),
    "two turns and a slide, position": Class("RRP", task="position"),
    "a slide between, position": Class("RPR", task="position"),
    "a turn between slides, position": Class("PRP", task="position"),
    "two joints, position": Class("RR", task="position"),
    "three joints, orientation": Class("RRR", task="orientation"),
    "five joints, axis": Class("RRRRR", task="axis"),
    "five joints, one slides, axis": Class("RRPRR", task="axis"),
    "four joints, axis": Class("RRRR", task="axis"),
    "two joints, direction": Class("RR", task="direction"),
}


def random_arm(kind: Class, rng: np.random.Generator) -> Arm:
    """An arm of a class."""
    count = len(kind.joints)
    along = rng.normal(size=(count, 3))
    along /= np.linalg.norm(along, axis=1, keepdims=True)
    points = rng.uniform(-0.7, 0.7, (count, 3))
    for run in kind.parallel:
        along[list(run)] = along[run[0]]
    for run in kind.meeting:
        points[list(run)] = points[run[0]]
    axes = []
    for k, letter in enumerate(kind.joints):
        point = points[k] if letter == "R" else np.zeros(3)
        axes.append(Axis(f"q{k + 1}", letter == "R", tuple(along[k].tolist()), tuple(point.tolist())))
    home = np.eye(4)
    turn = np.linalg.qr(rng.normal(size=(3, 3)))[0]
    home[:3, :3] = turn * np.sign(np.linalg.det(turn))
    home[:3, 3] = rng.uniform(-0.7, 0.7, 3)
    return for_task(Arm(tuple(axes), count, np.eye(4), home, 1.0), TASKS[kind.task])


def measured(arm: Arm, by: float, rng: np.random.Generator) -> Arm:
    """An arm as it is when it has been built: each axis turned and moved a little."""
    axes = []
    for axis in arm.axes[: arm.joints]:
        along = np.array(axis.direction) + by * rng.normal(size=3)
        along /= np.linalg.norm(along)
        point = np.array(axis.point) + by * rng.normal(size=3) * axis.turns
        axes.append(replace(axis, direction=tuple(along.tolist()), point=tuple(point.tolist())))
    return replace(arm, axes=(*axes, *arm.axes[arm.joints :]))


def odd(kind: Class, arm: Arm, found: Found, poses: int) -> int:
    """How many of some poses have an odd number of solutions, a double root counted twice: one of them was lost.

    Solutions come in pairs where six joints meet the six conditions of a pose; elsewhere none is odd.
    """
    if kind.task != "pose" or len(kind.joints) != FULL:
        return 0
    _, slope = jacobian(arm, TASKS[kind.task], found.motions)
    double = np.linalg.svd(slope, compute_uv=False)[:, -1] < SINGULAR * extent(arm, found.motions) ** -2
    return int((np.bincount(found.index, 1 + double, minlength=poses) % 2).sum())


def random_motions(arm: Arm, count: int, rng: np.random.Generator) -> tuple[np.ndarray, np.ndarray]:
    """Joint motions, shape (count, n), and the products they come to, shape (count, 4, 4)."""
    shape = count, arm.joints
    motions = np.where(arm.turning, rng.uniform(-np.pi, np.pi, shape), rng.uniform(-1, 1, shape))
    return motions, product(arm, motions)
