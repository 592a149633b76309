"""Recordings played over arrays of other libraries: nothing is looked at, so that JAX and PyTorch can trace it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from dhcli.algebra.arrays import Array, Namespace, play
from dhcli.errors import RobotError, plural
from dhcli.kinematics.recorded import Recording
from dhcli.kinematics.robot import Robot


def trace(
    robot: Robot, recording: Recording, q: Array, library: str, only: Mapping[str, object]
) -> tuple[Array, Array, Namespace]:
    """Work out what was recorded, each joint by itself, so that angles of any size keep their digits.

    Args:
        robot: The robot.
        recording: What to work out.
        q: Joint values, shape (..., n); radians and metres.
        library: The library that they are of.
        only: Arguments that numpy's arrays alone can have, which must not be given.

    Returns:
        The results, shape (..., results), of the same library, kind and device; the joint values; and the functions of
        the library.

    Raises:
        RobotError: Q has another shape or holds no floats, one of those arguments is given, or array-api-compat is not
            installed.
    """
    try:
        from array_api_compat import array_namespace
    except ImportError:
        hint = "pip install 'dhcli[arrays]' brings it; numpy.asarray(Q) needs nothing"
        raise RobotError(f"arrays of {library} need array-api-compat, which is not installed", hint) from None
    given = [name for name, value in only.items() if value is not None]
    if given:
        raise RobotError(f"{' and '.join(given)} are for arrays of numpy", f"what {library} gives is as Q is")
    xp = array_namespace(q)
    wanted = len(robot.variables)
    if q.ndim == 0 or q.shape[-1] != wanted:
        shape = tuple(q.shape)
        raise RobotError(f"{robot.name} has {plural(wanted, 'joint')}; Q has the shape {shape}, not (..., {wanted})")
    if not xp.isdtype(q.dtype, "real floating"):
        raise RobotError(f"Q holds numbers of {q.dtype}, not floats", "joint values are real: Q.astype(float)")
    return play(recording.program(merged=False), q, xp), q, xp


def shaped(found: Array, q: Array, xp: Namespace, shape: Sequence[int]) -> Array:
    """Results, shape (..., results), as one table for each row of joint values: shape (..., *shape)."""
    return xp.reshape(found, (*q.shape[:-1], *shape))
