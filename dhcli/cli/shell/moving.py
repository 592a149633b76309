"""The options of the commands about motion as a view and a form; what contradicts itself is refused."""

from __future__ import annotations

from dhcli.cli.shell.chosen import Chosen
from dhcli.cli.shell.given import open_scope, point_of
from dhcli.errors import DhcliError
from dhcli.kinematics.frames import ORIGIN
from dhcli.kinematics.robot import Robot
from dhcli.kinematics.velocity.form import Form, Triple, Which
from dhcli.kinematics.velocity.view import MotionView

PARTS: dict[str, Which] = {"linear": "linear", "angular": "angular", "all": "all"}
ORDERS = {"linear-first": False, "angular-first": True}


def view_of(robot: Robot, chosen: Chosen, axes: str | None, at: str | None, option: str) -> MotionView:
    """Between which frames, along which axes, of which point.

    Args:
        robot: The robot.
        chosen: The frame held still, and the frame that moves.
        axes: The frame of the axes.
        at: A point of the end frame, `x,y,z`, or, but for `--point`, the name of a frame.
        option: What it was typed behind.

    Raises:
        DhcliError: There is no such frame, or the point cannot be read.
    """
    if axes is not None and (axes == "-" or "." in axes):
        hint = f"rows of a file: dhcli jacobian {robot.typed} --rows {axes}"
        if option == "--at":  # of rates and torques, which go by one Jacobian
            hint = f"one pose is taken: --q VALUES; a Jacobian for each of the {hint}"
        raise DhcliError(f"--in {axes} is no frame: it says along which axes", hint)
    is_frame = at is not None and option != "--point" and "," not in at
    point = ORIGIN if at is None or is_frame else point_of(at, option, open_scope(robot))
    view = MotionView.of(robot, start=chosen.from_, end=chosen.end, axes=axes, place=at if is_frame else None)
    return MotionView(view.start, view.end, view.axes, view.place, point)


def part_of(text: str | None) -> Which | None:
    """The rows that are meant.

    Raises:
        DhcliError: There is no such part.
    """
    if text is not None and text not in PARTS:
        raise DhcliError(f"there is no part {text}", f"parts: {', '.join(PARTS)}")
    return None if text is None else PARTS[text]


def form_of(part: str | None, order: str | None, analytic: str | None) -> Form:
    """Which rows a Jacobian has, in which order.

    Raises:
        DhcliError: There is no such part, order or triple of angles, or two of them contradict each other.
    """
    if order is not None and order not in ORDERS:
        raise DhcliError(f"there is no order {order}", f"orders: {', '.join(ORDERS)}")
    if analytic is not None and part == "linear":
        raise DhcliError("--analytic is about the angular rows, and --part linear leaves them out", "use one of them")
    name = "" if analytic is None else Triple.called(analytic).name
    return Form(part_of(part) or "all", ORDERS[order or "linear-first"], name)


def twist_view(robot: Robot, view: MotionView, others: dict[str, object], *, space: bool, body: bool) -> MotionView:
    """The view of a space or body Jacobian: both say axes and point, and put ω first.

    Raises:
        DhcliError: Something else says them too.
    """
    mine = "--space" if space else "--body"
    if space and body:
        raise DhcliError("--space and --body are two different Jacobians", "use one of them")
    if given := [option for option, value in others.items() if value is not None]:
        verb = "does" if len(given) == 1 else "do"
        raise DhcliError(f"{' and '.join(given)} {verb} not go with {mine}", f"{mine} says axes, point and order")
    frame = view.start if space else view.end
    return MotionView.of(robot, start=view.start, end=view.end, axes=frame, place=frame)
