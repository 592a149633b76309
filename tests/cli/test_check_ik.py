"""`dhcli check ROBOT --ik`: joint values for a pose, without an exercise."""

from __future__ import annotations

import json

import pytest

from tests.cli.running import Run

PLACE = ("check", "planar-2r", "--ik", "--position", "0.5,0.3,0")


@pytest.mark.parametrize(
    ("options", "code", "said"),
    [
        (("--answer", "2.477°, 67.98°"), 0, "RIGHT"),
        (("--answer", "59.45°, -67.98°"), 0, "RIGHT"),
        (("--answer", "30°, 45°"), 1, "away from the place asked for"),
        (("--branch", "elbow up", "--answer", "2.477°, 67.98°"), 1, "on another branch"),
        (("--branch", "all", "--answer", "2.477°, 67.98°"), 1, "1 solution of 2"),
        (("--branch", "all", "--answer", "2.477°, 67.98°; 59.45°, -67.98°"), 0, "RIGHT"),
        (("--answer", "1°"), 2, "there are 2 joints"),
    ],
)
def test_joint_values_for_a_place_are_judged(dhcli: Run, options: tuple[str, ...], code: int, said: str) -> None:
    """By where they lead, and by the branch."""
    done = dhcli(*PLACE, *options)
    assert done.code == code, done
    assert said in done.out


def test_a_target_is_given_as_to_ik(dhcli: Run) -> None:
    """As moves, a matrix, or where joint values stand."""
    for pose in (
        ("--target", "Trans(0.5,0.2,0.3) Rot(y,110°)"),
        ("--q", "0.3,-0.5,0.7,1,0.8,-2"),
        ("--pose", "nominal"),
    ):
        found = json.loads(dhcli("ik", "puma560", *pose, "--format", "json").out)
        values = [f"{value} rad" for value in found["data"]["solutions"][0]["q"]]
        done = dhcli("check", "puma560", "--ik", *pose, "--answer", ", ".join(values))
        assert done.code == 0, done


@pytest.mark.parametrize(
    ("options", "said"),
    [
        (("check", "planar-2r", "--ik", "--answer", "1,2"), "no pose is given"),
        (("check", "planar-2r", "--ik", "--position", "0.9,0.3,0", "--answer", "1,2"), "laid end to end"),
        (("check", "planar-2r", "--position", "0.5,0.3,0", "--answer", "1,2"), "add --ik"),
        ((*PLACE, "--branch", "elbow rigt", "--answer", "1,2"), "elbow up"),
        ((*PLACE, "--symbolic", "--answer", "1,2"), "--ik asks for joint values"),
        (("check", "planar-2r", "--ik", "--target", "-", "--answer", "-"), "cannot both come from standard input"),
    ],
)
def test_what_cannot_be_asked_says_why(dhcli: Run, options: tuple[str, ...], said: str) -> None:
    """No pose, one out of reach, options that need --ik, a branch that no solution has."""
    done = dhcli(*options)
    assert done.code == 2
    assert said in done.err
