"""What `dhcli draw` is asked to draw: a robot or linkage by name, the arm of an exercise, and where its joints are."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Any

from dhcli.cli.shell.chosen import Chosen
from dhcli.errors import DhcliError, FileError, Place, Problem

if TYPE_CHECKING:
    from dhcli.kinematics.robot import Robot
    from dhcli.mobility.linkage import Linkage


def find(chosen: Chosen) -> Robot | Linkage:
    """The robot or linkage that was typed.

    Raises:
        DhcliError: It is neither, or a linkage of which only counts are known.
    """
    from dhcli.files.library.kinds import kind_of

    name = chosen.robot
    if kind_of(name).noun == "linkage":
        from dhcli.files.yaml.linkages import load_linkage
        from dhcli.mobility.linkage import Linkage

        linkage = load_linkage(name)
        if not isinstance(linkage, Linkage):
            raise DhcliError(f"of {name} only counts are known: there is nothing to draw", "dhcli dof counts it")
        return linkage
    from dhcli.cli.shell.given import robot_of

    return robot_of(chosen)


def of_exercise(name: str, variant: str | None, *, solution: bool, yes: bool) -> list[dict[str, Any]]:
    """What the picture of an exercise shows: its arm at the values that the task gives, and the linkages it counts.

    Args:
        name: The exercise.
        variant: The name that its numbers are drawn by, if they are.
        solution: Whether what it leaves to the student is shown.
        yes: Whether that is so also where it was never tried.

    Returns:
        The fields of a picture for each of them. Frames that are an answer are left out, and names and numbers of
        links and joints.

    Raises:
        DhcliError: There is nothing to draw; its solution is asked for before it was tried.
    """
    from dhcli.checking.figures import held_back, linkages, shown
    from dhcli.checking.judge import Judge
    from dhcli.checking.variants import variant_of
    from dhcli.cli.shell.untried import ask_once
    from dhcli.files.yaml.exercises import load_exercise

    exercise = variant_of(Judge(load_exercise(name)), variant).exercise
    level, counted = shown(exercise), linkages(exercise)
    if level is None and not counted:
        what = "is to have no picture" if exercise.picture == "none" else "has no robot and no linkage with points"
        raise DhcliError(f"{exercise.id} {what}", f"dhcli show {exercise.typed}")
    if solution and not yes:
        counts = tuple(part for part in exercise.asked if part.question.linkage_counted)
        held = held_back(exercise) if level is not None else ()
        ask_once(exercise, (*held, *counts))
    found: list[dict[str, Any]] = []
    if exercise.robot is not None and level is not None:
        arm = replace(exercise.robot, title=exercise.title)
        lengths = {name: value for name, value in exercise.given.items() if name in arm.parameters}
        joints = {name: value for name, value in exercise.given.items() if name in arm.variables}
        drawn = (part.question.pose_drawn(exercise) for part in exercise.asked)
        joints = next((dict(pose) for pose in drawn if pose), joints)
        found.append({"what": arm, "parameters": lengths, "worksheet": level == "axes" and not solution})
        if arm.variables and len(joints) == len(arm.variables):
            found[0]["q"] = joints
    return found + [{"what": linkage, "worksheet": not solution} for linkage in counted]


def posed(
    what: Robot | Linkage, chosen: Chosen, *, to: str | None, beside: str | None, rows: str | None
) -> dict[str, object]:
    """Joint values, pose and lengths, as far as a robot has them."""
    from dhcli.kinematics.robot import Robot

    if not isinstance(what, Robot):
        if chosen.more or to is not None or beside is not None or rows is not None:
            raise DhcliError(f"{what.name} is a linkage: --q, --pose, --to, --rows, --beside and --set are for robots")
        return {}
    from dhcli.cli.shell.given import lengths_of, values_of
    from dhcli.cli.shell.joints import typed_joints

    goal: dict[str, object] = {} if to is None else {"to": typed_joints(what, to, chosen.bare, "--to")}
    if beside is not None:
        from dhcli.files.yaml.robots import load_robot

        goal["beside"] = load_robot(beside)
    lengths = lengths_of(what, chosen, symbolic=True)
    if rows is not None:
        if chosen.pose is not None or to is not None:
            raise DhcliError("--rows says where all joints are", "leave --pose and --to out")
        return {"path": _read_rows(what, rows, chosen), "parameters": lengths, **goal}
    if chosen.q is None:
        return {"pose": chosen.pose, "parameters": lengths, **goal}
    joints = {name: value for name, value in values_of(what, chosen).items() if name in what.variables}
    return {"q": joints, "parameters": lengths, **goal}


MOST_ROWS = 100_000
"""Rows of a motion that are drawn; of more, nobody sees the way."""


def _read_rows(robot: Robot, path: str, chosen: Chosen) -> tuple[tuple[float, ...], ...]:
    """Joint values of the rows of a file.

    Raises:
        FileError: The file is no table for this robot, a row is bad, or there are none or too many.
    """
    from dhcli.cli.shell.batch import joint_table
    from dhcli.cli.shell.many import Many
    from dhcli.files.rows.formats import joint_rows
    from dhcli.files.rows.source import open_source

    found: list[tuple[float, ...]] = []
    with open_source(path) as source:
        for block in joint_rows(source, joint_table(robot, chosen, Many())).blocks():
            if block.bad:
                raise FileError(block.bad)
            found += map(tuple, block.values.tolist())
            if len(found) > MOST_ROWS:
                raise FileError(Problem(f"has more than {MOST_ROWS:,} rows", Place(path), "draw every tenth"))
    if not found:
        raise FileError(Problem("holds no joint values", Place(path)))
    return tuple(found)


def refuse_table(what: Robot | Linkage, name: str | None) -> None:
    """Say where the table stands in formats that have no room beside the figure."""
    from dhcli.kinematics.robot import Robot

    if not isinstance(what, Robot):
        raise DhcliError(f"{what.name} is a linkage: it has no DH table")
    if name == "page":
        raise DhcliError("a page always has the table beside", "leave --table out")
    raise DhcliError("--table stands beside a figure in a file", f"dhcli show {what.typed} --draw has both in letters")
