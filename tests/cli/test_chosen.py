"""The options about a robot: the same everywhere, and a tool or a link of a URDF wherever a robot is taken."""

from __future__ import annotations

import json
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated

import numpy as np
import pytest
import typer

from dhcli.cli import app
from dhcli.cli.shell.spreading import But, spread
from tests.cli.running import Run
from tests.row_by_row import row_by_row

ROOT = Path(__file__).parents[2]
ABOUT_ROBOTS = ("fk", "ik", "jacobian", "rates", "torques", "singularities", "sweep", "draw", "describe", "check")
TOOL = "Trans(0,0,0.1) Rot(z,45°)"
OWN_WORDS = {("ik", "--q"), ("ik", "--pose"), ("draw", "--to"), ("describe", "--pose")}
"""Options that mean something else: the pose to reach, where a film goes, and in which pose a saved robot is drawn."""


def options(command: str) -> dict[str, str]:
    """The options of a command with their help."""
    return {param.opts[0]: param.help for param in app.load(command).params if param.opts[0].startswith("--")}


@row_by_row("command", ABOUT_ROBOTS)
def test_every_command_about_a_robot_takes_a_tool_and_a_urdf(command: str) -> None:
    """And the lengths of the robot."""
    assert {"--tool", "--base", "--tip", "--as-typed", "--set"} <= options(command).keys()


@row_by_row("command", [*ABOUT_ROBOTS, "dof", "show"])
def test_an_option_about_a_robot_is_told_in_the_same_words_everywhere(command: str) -> None:
    """In those of `fk`, but for the few that mean something else."""
    shared = ("--q", "--deg", "--pose", "--set", "--from", "--to", "--tool", "--base", "--tip", "--as-typed")
    mine, told = options(command), options("fk")
    assert {name: mine[name] for name in shared if name in mine and (command, name) not in OWN_WORDS} == {
        name: told[name] for name in shared if name in mine and (command, name) not in OWN_WORDS
    }


def numbers(dhcli: Run, *words: str) -> dict[str, object]:
    """What a command says in JSON."""
    done = dhcli(*words, "--format", "json")
    assert done.code == 0, done.err
    return json.loads(done.out)["data"]


@pytest.mark.parametrize(
    "words",
    [
        ("jacobian", "--pose", "nominal"),
        ("torques", "--pose", "nominal", "--force", "1,2,3"),
        ("rates", "--pose", "nominal", "--rates", "1,2,3,4,5,6"),
        ("ik", "--pose", "nominal"),
        ("sweep", "--over", "theta1 n 3"),
    ],
)
def test_a_tool_means_its_end_as_if_the_file_had_it(dhcli: Run, words: tuple[str, ...]) -> None:
    """It changes what comes out, and naming the frame says nothing new."""
    command, *rest = words
    typed = numbers(dhcli, command, "puma560", *rest, "--tool", TOOL)
    assert typed == numbers(dhcli, command, "puma560", *rest, "--tool", TOOL, "--to", "tool")
    if command != "ik":  # of which the solutions are the same six numbers: it moves the pose, too
        assert typed != numbers(dhcli, command, "puma560", *rest)


def test_the_solutions_for_a_tool_put_its_end_where_it_was(dhcli: Run) -> None:
    """Not the flange."""
    pose = numbers(dhcli, "fk", "puma560", "--pose", "nominal", "--tool", TOOL)["matrix"]
    rows = "; ".join(" ".join(map(repr, row)) for row in pose)  # type: ignore[attr-defined]
    found = numbers(dhcli, "ik", "puma560", "--target", f"[{rows}]", "--tool", TOOL)["solutions"]
    for solution in found:  # type: ignore[attr-defined]
        values = ",".join(map(repr, solution["q"]))
        there = numbers(dhcli, "fk", "puma560", "--q", values, "--tool", TOOL)["matrix"]
        assert np.asarray(there) == pytest.approx(np.asarray(pose), abs=1e-9)


def test_frames_that_do_not_reach_the_tool_are_refused_everywhere(dhcli: Run) -> None:
    """With what to write."""
    for command in ("jacobian", "ik"):
        done = dhcli(command, "puma560", "--pose", "nominal", "--tool", TOOL, "--to", "4")
        assert (done.code, "--to 4 does not reach it" in done.err) == (2, True)


def test_a_urdf_is_drawn_and_checked_between_the_links_named(dhcli: Run) -> None:
    """As fk takes it."""
    path = str(ROOT / "tests/data/urdf/three-joints.urdf")
    matrix = numbers(dhcli, "fk", path, "--q", "0,0,0", "--tip", "camera")["matrix"]
    assert dhcli("draw", path, "--tip", "camera").code == 0
    answer = ", ".join(str(row[3]) for row in matrix[:3])  # type: ignore[index]
    assert dhcli("check", path, "--q", "0,0,0", "--tip", "camera", "--answer", answer).code == 0
    assert dhcli("check", path, "--q", "0,0,0", "--answer", answer).code == 2


@dataclass(frozen=True)
class Pair:
    """Two options."""

    one: Annotated[str, typer.Option("--one", help="The one.")] = "1"
    two: Annotated[str, typer.Option("--two", help="The other.")] = "2"


def test_a_group_becomes_options_and_comes_back_whole() -> None:
    """Less those that a command has not, with help that is its own, under its heading."""

    def command(pair: Annotated[Pair, But(without=("two",), panel="Here")], more: int = 3) -> tuple[Pair, int]:
        return pair, more

    single = typer.Typer()
    single.command("it")(spread(command))
    found = typer.main.get_command(single)
    assert [(param.opts[0], getattr(param, "rich_help_panel", None)) for param in found.params[:2]] == [
        ("--one", "Here"),
        ("--more", None),
    ]
    assert found.main(["--one", "x"], standalone_mode=False) == (Pair("x", "2"), 3)
