"""Which solutions `ik` is asked for: near to what, with which joints held, on which branches."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress
from dataclasses import astuple, replace
from typing import TYPE_CHECKING

from dhcli.cli.shell.chosen import Chosen
from dhcli.cli.shell.joints import typed_joints
from dhcli.cli.shell.wishes import Goal
from dhcli.errors import DhcliError, Place, Problem, RobotError, UnknownNameError, did_you_mean
from dhcli.kinematics.derived import in_floats
from dhcli.kinematics.robot import Robot
from dhcli.kinematics.values import joint_values

if TYPE_CHECKING:
    from dhcli.kinematics.inverse.derivation import Derivation
    from dhcli.kinematics.inverse.solutions import Solutions
    from dhcli.notation.quantity import Bare


def near_of(robot: Robot, text: str | None, bare: Bare) -> list[float] | None:
    """Joint values that solutions should be near to, in joint order [rad, m]."""
    if text is None:
        return None
    values = typed_joints(robot, text, bare, "--near")
    return [in_floats(values[name]) if name in values else 0.0 for name in robot.variables]


def held_of(robot: Robot, texts: Sequence[str], bare: Bare) -> dict[str, float]:
    """Values of joints that are held."""
    held: dict[str, float] = {}
    for text in texts:
        if "=" not in text:
            raise DhcliError(Problem(f"{text} is not NAME=VALUE", Place("--hold"), "write --hold theta7=30°"))
        values = joint_values(robot, text, bare=bare, place=Place("--hold"))
        held |= {name: in_floats(value) for name, value in values.items()}
    return held


def only_branches(found: Solutions, wanted: Sequence[str]) -> Solutions:
    """The solutions whose branch has all of some words.

    Raises:
        UnknownNameError: No solution's branch has one of them; the hint lists those there are.
    """
    if not wanted or not len(found):
        return found
    words = [part.strip() for text in wanted for part in text.split(",") if part.strip()]
    parts = [tuple(branch.split(", ")) for branch in found.branches]
    there = dict.fromkeys(word for own in parts for word in own)
    for word in words:
        if word not in there:
            hint = did_you_mean(word, there)
            listed = f"branches here: {', '.join(there) or 'one without a name'}"
            hint = f"{hint} {listed}" if hint.startswith("did") else listed
            raise UnknownNameError(Problem(f"no solution is {word}", Place("--branch"), hint))
    kept = [k for k, own in enumerate(parts) if all(word in own for word in words)]
    return replace(found.take(kept), why="" if kept else f"no solution is {' and '.join(words)}")


def derived(robot: Robot, goal: Goal, chosen: Chosen, *, with_own: bool = False) -> Derivation:
    """The formulas for a robot, for all of its pose or for the position; lengths that are typed stand in numbers.

    Args:
        robot: The robot.
        goal: The pose, of which nothing may be given.
        chosen: The robot, as it was asked for.
        with_own: Whether the robot's own lengths stand in numbers as well.

    Raises:
        DhcliError: A pose is given, or something else of it counts, or there are no formulas.
    """
    from dhcli.cli.shell.given import lengths_of
    from dhcli.kinematics.forward import with_values
    from dhcli.kinematics.inverse.derive import NoFormError, derive

    if any((chosen.q, chosen.pose, *astuple(replace(goal, task=None)))):
        raise DhcliError("a derivation is in letters and takes no pose", "leave it out, or --derive and --code")
    if goal.task not in {None, "pose", "position"}:
        raise DhcliError(Problem(f"a derivation knows no task {goal.task}", Place("--task"), "pose or position"))
    own = robot.known if with_own else {}
    robot = with_values(robot, {**own, **lengths_of(robot, chosen, symbolic=True)})
    try:
        return derive(robot, start=chosen.from_, end=chosen.end, task=goal.task or "")
    except NoFormError:
        found = None if chosen.from_ or chosen.end else _derived_as_table(robot, goal.task or "")
        if found is None:
            raise
        return found


def _derived_as_table(robot: Robot, task: str) -> Derivation | None:
    """The formulas for the DH table of a robot that is given by products, as a URDF is; None where there are none.

    Its joint values are the same, and its frames stand where the wrist can be taken off.
    """
    from dhcli.kinematics.conventions import Convention
    from dhcli.kinematics.describe.asked import Asked
    from dhcli.kinematics.describe.description import describe  # few robots have no formulas as they are
    from dhcli.kinematics.inverse.derive import derive

    if robot.convention is not Convention.PRODUCT:
        return None
    for form in ("standard", "modified"):
        with suppress(RobotError):
            table = describe(robot, Asked(form))
            if not table.shared:
                return derive(table.robot, start="base", end="tool", task=task)
    return None
