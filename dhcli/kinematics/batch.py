"""Forward kinematics of many poses at once: the fold is recorded once and played over numpy columns, block by block."""

from __future__ import annotations

from functools import lru_cache
from typing import TYPE_CHECKING, TypeAlias

import numpy as np

from dhcli.algebra.columns import Columns
from dhcli.algebra.program import Program, assemble
from dhcli.algebra.tape import Tape
from dhcli.errors import RobotError
from dhcli.kinematics.fold import fold
from dhcli.kinematics.forward import Given
from dhcli.kinematics.frames import between, ends
from dhcli.kinematics.merge import merge
from dhcli.kinematics.moves import Chain
from dhcli.kinematics.robot import Robot, check_robot
from dhcli.kinematics.values import numbers, parameter_values, require
from dhcli.notation.angle import Angle

BLOCK = 4096
"""Poses at a time: enough to make a call of numpy cheap beside its work, few enough to keep the columns in the cache.

2048 to 8192 differ little where this was tried; PUMA 560 takes 34 columns of 32 kB, of which most rest.
"""

MODEST = 10.0
"""Joint values [rad] up to which parallel joints are merged; the sum of larger angles lacks digits of its parts."""

Known: TypeAlias = tuple[tuple[str, Angle | float], ...]
"""Names and values of what is no joint: exact angles, metres."""

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray


def forward_batch(
    robot: Robot,
    Q: ArrayLike,  # noqa: N803  the field's name for a matrix of joint values
    *,
    start: str | int | None = None,
    end: str | int | None = None,
    parameters: Given | None = None,
    out: NDArray[np.float64] | None = None,
) -> NDArray[np.float64]:
    """Poses of a frame of a robot for many joint values, in numbers.

    Args:
        robot: The robot.
        Q: Joint values, shape (N, n), a row for each pose in joint order; radians and metres.
        start: The frame it is seen from; the first numbered one by default.
        end: The frame described; the last numbered one by default.
        parameters: Lengths and angles to use instead of the robot's own.
        out: Where to put the result, shape (N, 4, 4).

    Returns:
        The poses, shape (N, 4, 4), translation in metres; NaN or infinite where a joint value is.

    Raises:
        RobotError: Q or `out` has another shape, Q holds something else than real numbers, `out` cannot be written
            to, or a length has no value.
        UnknownNameError: The robot has no such frame or length.
    """
    check_robot(robot)
    q = joint_rows(robot, Q)
    poses = np.empty((len(q), 4, 4)) if out is None else _checked(out, (len(q), 4, 4))
    chain = between(robot, *ends(robot, start, end))
    lengths = parameter_values(robot, parameters or {})
    require(robot, chain, {**lengths, **dict.fromkeys(robot.variables, Angle())})
    values = tuple(numbers(lengths).items())
    columns: dict[tuple[bool, int], Columns] = {}
    for first in range(0, len(q), BLOCK):
        block = q[first : first + BLOCK]
        kind = bool(np.abs(block).max(initial=0.0) <= MODEST), len(block)
        if kind not in columns:
            columns[kind] = Columns(recorded(chain, robot.variables, values, merged=kind[0]), len(block))
        poses[first : first + BLOCK] = columns[kind].play(block.T).reshape(4, 4, -1).transpose(2, 0, 1)
    return poses


def joint_rows(robot: Robot, Q: ArrayLike) -> NDArray[np.float64]:  # noqa: N803
    """Joint values of many poses as an array, shape (N, n).

    Raises:
        RobotError: They have another shape, or something is no real number.
    """
    wanted = len(robot.variables)
    try:
        if np.iscomplexobj(Q):
            raise RobotError("Q holds complex numbers", "joint values are real: Q.real, if that is what is meant")
        q = np.asarray(Q, dtype=np.float64)
    except (ValueError, TypeError):
        raise RobotError("Q is no array of numbers", f"wanted: rows of {wanted} numbers, all as long") from None
    if q.ndim != 2 or q.shape[1] != wanted:  # noqa: PLR2004  rows and columns
        raise RobotError(f"{robot.name} has {wanted} joints; Q has the shape {q.shape}, not (N, {wanted})")
    return q


@lru_cache(maxsize=32)
def recorded(chain: Chain, variables: tuple[str, ...], values: Known, *, merged: bool) -> Program:
    """The steps from joint values to the 16 entries of a pose; with parallel joints merged they are far fewer."""
    tape = Tape(variables, dict(values))
    rows = fold(merge(chain) if merged else chain, tape)
    return assemble(tape, [entry for row in rows for entry in row])


def _checked(out: object, shape: tuple[int, ...]) -> NDArray[np.float64]:
    """Where a result goes, if it fits.

    Raises:
        RobotError: It is no array, or one of another shape or kind, or one that nobody may write to.
    """
    if not isinstance(out, np.ndarray):
        raise RobotError(f"out is no numpy array but {type(out).__name__}", f"np.empty({shape}) makes one")
    if out.shape != shape or out.dtype != np.float64:
        raise RobotError(f"out has the shape {out.shape} of {out.dtype}, not {shape} of float64")
    if not out.flags.writeable:
        raise RobotError("out is read-only", "give an array of your own, or leave out= out")
    return out
