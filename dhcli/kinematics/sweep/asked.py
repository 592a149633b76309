"""A sweep as a program asks for it: of a robot, over ranges in text or in numbers."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import TYPE_CHECKING, TypeAlias

from dhcli.errors import Place, RobotError
from dhcli.kinematics.frames import View
from dhcli.kinematics.given import three_coordinates
from dhcli.kinematics.robot import Robot, Value, check_robot
from dhcli.kinematics.sweep.plan import plan
from dhcli.kinematics.sweep.ranges import read_over
from dhcli.kinematics.sweep.result import Sweep
from dhcli.kinematics.sweep.target import target_of
from dhcli.kinematics.values import JointInput, joint_values, parameter_values

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

Ranges: TypeAlias = str | Iterable[str] | Mapping[str, str]
"""`"theta1=-90°..90° step 5°"`, several of them, or a mapping of names to ranges."""


def sweep(  # noqa: PLR0913  as many as a sweep has sides; all but the first three by name
    robot: Robot,
    over: Ranges = (),
    q: JointInput = None,
    *,
    start: str | int | None = None,
    end: str | int | None = None,
    point: Iterable[float | str] = (0, 0, 0),
    parameters: Mapping[str, float | str | Value] | None = None,
    each: Callable[[NDArray[np.float64]], None] | None = None,
    threads: int = 1,
) -> Sweep:
    """Sweep joints over a grid: how far a point of a robot reaches, the box it stays in, and a pose for each extreme.

    >>> from dhcli import load_robot, sweep
    >>> found = sweep(load_robot("planar-2r"), {"theta1": "-90°..90° step 5°", "theta2": "0..pi/2 n 10"})
    >>> found.grid.count, round(found.farthest.distance, 4), found.box[1]
    (370, 0.7, (-0.7, 0.7))

    Args:
        robot: The robot.
        over: What each joint is swept over, as `dhcli sweep --over` takes it; bare numbers are radians and metres. By
            default all joints that move the point and that `q` leaves open, over their limits.
        q: Where the other joints stand, in any form that `forward` takes, `{"theta2": "30°"}`; else at 0.
        start: The frame it is seen from; the first numbered one by default.
        end: The frame the point is fixed in; the last numbered one by default.
        point: Its coordinates in that frame, shape (3,) [m]; the origin by default.
        parameters: Lengths and angles to use instead of the robot's own.
        each: What to call with every block of rows, shape (N, n + 3): joint values and position; radians and metres.
        threads: How many threads share the work; the same is found, and rows come in the same order.

    Returns:
        What was found; distances and positions in metres, joint values exact.

    Raises:
        RobotError: Ranges are no texts, a joint has no limits to sweep over, a length no value, the grid is too large,
            or that is no number of threads.
        NotationError: A range cannot be read, with its column.
        UnknownNameError: The robot has no such frame, joint or length.
    """
    check_robot(robot)
    values = {**parameter_values(robot, parameters), **joint_values(robot, q)}
    target = target_of(robot, View.of(robot, start, end, point=three_coordinates(point)), values)
    overs = [read_over(robot, text, place=Place("over")) for text in _texts(over)]
    grid = plan(target, overs, values, Place("over") if overs else None)

    from dhcli.kinematics.sweep.run import sweep as go_through  # numpy: not for what is refused before it starts

    return go_through(target, grid, each, threads=threads)


def _texts(over: object) -> list[str]:
    """The ranges as texts, one a joint.

    Raises:
        RobotError: That is none.
    """
    if isinstance(over, Mapping):
        over = [f"{name}={text}" for name, text in over.items()]
    texts = [over] if isinstance(over, str) else list(over) if isinstance(over, Iterable) else None
    if texts is None or not all(isinstance(text, str) for text in texts):
        message = f"over says in text what each joint is swept over, and {over!r:.60} does not"
        raise RobotError(message, "'theta1=-90°..90° step 5°', several of them in a list, or {'theta1': '-90°..90°'}")
    return texts
