"""What `dhcli draw` is asked to draw: a robot or linkage by name, the arm of an exercise, and where its joints are."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhcli.cli.shell.chosen import Chosen
from dhcli.errors import DhcliError, Place, Problem

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


def of_exercise(name: str, variant: str | None, *, solution: bool) -> tuple[Robot, dict[str, object], bool]:
    """The arm of an exercise at the values that the task gives, and whether its frames are an answer and left out.

    Raises:
        DhcliError: It has no robot; its solution is asked for before it was tried.
    """
    from dataclasses import replace

    from dhcli.checking.figures import held_back, shown
    from dhcli.checking.judge import Judge
    from dhcli.checking.variants import variant_of
    from dhcli.cli.commands.solution import ask_once
    from dhcli.files.yaml.exercises import load_exercise

    exercise = variant_of(Judge(load_exercise(name)), variant).exercise
    if exercise.robot is None or (level := shown(exercise)) is None:
        raise DhcliError(f"{exercise.id} has no robot: there is nothing to draw", f"dhcli show {exercise.typed}")
    if solution:
        ask_once(exercise, held_back(exercise))
    arm = replace(exercise.robot, title=exercise.title)
    lengths = {name: value for name, value in exercise.given.items() if name in arm.parameters}
    joints = {name: value for name, value in exercise.given.items() if name in arm.variables}
    given: dict[str, object] = {"parameters": lengths}
    if arm.variables and len(joints) == len(arm.variables):
        given["q"] = joints
    return arm, given, level == "axes" and not solution


def posed(what: Robot | Linkage, chosen: Chosen, *, to: str | None, beside: str | None) -> dict[str, object]:
    """Joint values, pose and lengths, as far as a robot has them."""
    from dhcli.kinematics.robot import Robot

    if not isinstance(what, Robot):
        if chosen.more or to is not None or beside is not None:
            raise DhcliError(f"{what.name} is a linkage: --q, --pose, --to, --beside and --set are for robots")
        return {}
    from dhcli.cli.shell.given import lengths_of, values_of
    from dhcli.kinematics.values import joint_values

    goal: dict[str, object] = (
        {} if to is None else {"to": joint_values(what, to, bare=chosen.bare, place=Place("--to"))}
    )
    if beside is not None:
        from dhcli.files.yaml.robots import load_robot

        goal["beside"] = load_robot(beside)
    lengths = lengths_of(what, chosen, symbolic=True)
    if chosen.q is None:
        return {"pose": chosen.pose, "parameters": lengths, **goal}
    joints = {name: value for name, value in values_of(what, chosen).items() if name in what.variables}
    return {"q": joints, "parameters": lengths, **goal}


def refuse_table(what: Robot | Linkage, name: str | None) -> None:
    """Say where the table stands in formats that have no room beside the figure."""
    from dhcli.kinematics.robot import Robot

    if not isinstance(what, Robot):
        raise DhcliError(f"{what.name} is a linkage: it has no DH table")
    if name == "page":
        raise DhcliError("a page always has the table beside", "leave --table out")
    raise DhcliError("--table stands beside a figure in a file", f"dhcli show {what.name} --draw has both in letters")


def sides(text: str) -> tuple[int, int]:
    """`820x640` in numbers."""
    import re

    match = re.fullmatch(r"\s*(\d{1,5})\s*[x×,]\s*(\d{1,5})\s*", text, re.ASCII)
    if match is None:
        raise DhcliError(Problem(f"'{text}' is no size", Place("--size"), "write width and height, such as 820x640"))
    return int(match[1]), int(match[2])
