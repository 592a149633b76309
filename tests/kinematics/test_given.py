"""What a program may give for the parts of a robot: taken as what it plainly means, or refused in words."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from typing import Any

import numpy as np
import pytest

from dhcli import (
    DhcliError,
    Pose,
    Robot,
    forward,
    forward_batch,
    inverse,
    inverse_batch,
    jacobian,
    joint_rates,
    load_exercise,
    load_robot,
    quaternions,
    torques,
    velocity_of,
)
from dhcli.files.yaml.linkages import load_linkage
from dhcli.files.yaml.robots import read_robot
from dhcli.kinematics.moves import Rot, Trans
from dhcli.notation.angle import Angle
from dhcli.notation.tree import ZERO, number
from tests.row_by_row import row_by_row

SCARA = load_robot("scara")
Q = [0.3, 0.5, 0.1]
ROBOT = """\
format: 1
title: t
source: s
convention: standard
variables: [{name}]
parameters: {{l1: 1 m}}
links:
  - {{a: l1, alpha: 0, d: 0, theta: {theta}}}
"""


LONG = Trans(ZERO, ZERO, number(Fraction(1, 4)))


@pytest.mark.parametrize("tool", ["Trans(0, 0, 250 mm)", [LONG], LONG])
def test_a_tool_is_moves_or_a_text_that_spells_them(tool: Any) -> None:  # noqa: ANN401
    """It is never left out in silence."""
    with_tool = forward(replace(SCARA, tool=tool), Q, end="tool").position
    plain = forward(SCARA, Q).position
    assert with_tool == pytest.approx((plain[0], plain[1], plain[2] + 0.25))


def test_a_text_with_lengths_of_the_robot_knows_them() -> None:
    """Their names are those of its parameters, and others are not declared."""
    assert forward(replace(SCARA, base="Trans(0, 0, l1)"), Q, start="base").position[2] == pytest.approx(0.7)
    with pytest.raises(DhcliError, match="l9 is not declared"):
        replace(SCARA, base="Trans(0, 0, l9)")


def test_lengths_may_be_floats_or_texts_and_angles_radians() -> None:
    """As the arguments of `forward` may."""
    values = forward(replace(SCARA, parameters={"l1": 0.5, "l2": "300 mm", "l3": np.float64(0.2)}), Q).position
    assert values == pytest.approx(forward(SCARA, Q, parameters={"l1": 0.5}).position)
    turned = replace(SCARA, tool=(Rot("z", Angle.of("beta")),), parameters={**SCARA.parameters, "beta": 0.25}, poses={})
    assert forward(turned, Q, end="tool").rpy.yaw == pytest.approx(0.3 + 0.5 + 0.25)
    as_text = replace(turned, parameters={**SCARA.parameters, "beta": "30°"})
    assert forward(as_text, Q, end="tool").rpy.yaw == pytest.approx(0.3 + 0.5 + np.pi / 6)


def test_lists_are_as_good_as_tuples() -> None:
    """For links, variables, poses and limits, and the convention may be its name."""
    same = replace(
        SCARA,
        links=list(SCARA.links),
        variables=list(SCARA.variables),
        poses={"home": [0, "30°", 0.1]},
        limits={"theta1": ["-170°", 3.0]},
        convention="product",  # type: ignore[arg-type]
    )
    assert forward(same, "home").position == pytest.approx(forward(SCARA, [0, np.pi / 6, 0.1]).position)
    assert hash(same) == hash(replace(SCARA, poses={}))


@row_by_row(
    ("change", "said"),
    [
        ({"tool": [None]}, "tool: None is no move"),
        ({"base": 5}, "base: 5 is no list"),
        ({"tool": "Trans(1, 2"}, "tool:"),
        ({"tool": {"x": 1}}, "tool: {'x': 1} is no list"),
        ({"links": [None]}, "links: None is no Link"),
        ({"links": "abc"}, "links: 'abc' is no list"),
        ({"variables": "abc"}, "variables: 'abc' is no list"),
        ({"variables": [1]}, "variables: 1 is no name"),
        ({"parameters": [1]}, "parameters: \\[1\\] is no mapping"),
        ({"parameters": {1: 2}}, "parameters: 1 is no name"),
        ({"parameters": {"l1": float("nan")}}, "l1: nan is no value"),
        ({"parameters": {"l1": 10**400}}, "l1: 1000"),
        ({"parameters": {"l1": object()}}, "is no value"),
        ({"parameters": {"l1": 1j}}, "l1: 1j is no value"),
        ({"parameters": {"l1": "30°"}}, "l1: "),
        ({"limits": {"theta1": 5}}, "limits.theta1: 5 is no list"),
        ({"limits": {"theta1": (1,)}}, "limits.theta1: 1 value"),
        ({"poses": {"x": "0, 0, 0"}}, "poses.x: '0, 0, 0' is no list"),
        ({"convention": "standrd"}, "did you mean standard"),
        ({"convention": None}, "convention: None"),
    ],
)
def test_anything_else_is_refused_in_words(change: dict[str, Any], said: str) -> None:
    """With what would be right; never by an error of Python's."""
    with pytest.raises(DhcliError, match=said):
        replace(SCARA, **change)


@row_by_row("name", [None, 5, b"scara", ["scara"], "a\0b", "a\0b.yaml", ""])
@row_by_row("load", [load_robot, load_exercise, load_linkage])
def test_a_name_is_a_text(load: Any, name: Any) -> None:  # noqa: ANN401
    """What is none is refused by all three."""
    with pytest.raises(DhcliError):
        load(name)


@row_by_row("rows", [(), None, 5, "abcd", ((1, 2), (3, 4)), ((1, 2, 3, 4),) * 3, (None,) * 4, [["a"] * 4] * 4])
def test_a_pose_is_a_matrix_of_four_by_four(rows: Any) -> None:  # noqa: ANN401
    """From its first moment."""
    with pytest.raises(DhcliError, match="a pose"):
        Pose(rows)


def test_a_pose_takes_lists_and_arrays() -> None:
    """And is the same pose."""
    assert Pose(np.eye(4)) == Pose([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])  # type: ignore[arg-type]
    assert hash(Pose(np.eye(4).tolist())) == hash(Pose(tuple(map(tuple, np.eye(4).tolist()))))


@pytest.mark.parametrize("name", ["elbow-joint", "a+b", "a b", "2x", "x;y"])
def test_a_name_that_reads_as_something_else_is_refused(name: str) -> None:
    """In a file, where it stands and what to write; and from a program."""
    with pytest.raises(DhcliError) as caught:
        read_robot(ROBOT.format(name=f'"{name}"', theta=name), "x.yaml", "x")
    first = caught.value.problems[0]
    assert "is not a name" in first.message
    assert (first.place.line, first.place.column) == (5, 13)  # type: ignore[union-attr]
    with pytest.raises(DhcliError, match="is not a name"):
        replace(SCARA, variables=(name, *SCARA.variables[1:]))


@pytest.mark.parametrize("name", ["theta1", "θ1", "elbow_joint", "theta_{1}", "x2y"])
def test_names_of_the_usual_forms_are_names(name: str) -> None:
    """Greek, or with an index."""
    robot = read_robot(ROBOT.format(name=f'"{name}"', theta=f'"{name}"'), "x.yaml", "x")
    assert isinstance(robot, Robot)


@pytest.mark.parametrize("width", ["c8", "c16"])
def test_complex_numbers_are_refused_wherever_real_ones_are_wanted(width: str) -> None:
    """`float` would take the real part of numpy's, and warn."""
    arm, q = load_robot("scara"), [0.1, 0.2, 0.3]
    pose = forward(arm, q)

    def odd(given: Any) -> Any:  # noqa: ANN401
        return np.array(given, width)

    for ask in (
        lambda: forward(arm, odd(q)),
        lambda: forward(arm, q, parameters={"l1": odd(1)[()]}),
        lambda: forward_batch(arm, odd([q])),
        lambda: jacobian(arm, odd(q)),
        lambda: inverse(arm, odd(pose.matrix)),
        lambda: inverse(arm, pose, near=odd(q)),
        lambda: inverse_batch(arm, odd([pose.matrix])),
        lambda: quaternions(odd([pose.matrix])),
        lambda: joint_rates(arm, q, odd([0.1, 0, 0])),
        lambda: velocity_of(arm, q, odd([0.1, 0, 0])),
        lambda: torques(arm, q, force=odd([1, 0, 0])),
        lambda: pose @ odd([1, 0, 0]),
    ):
        with pytest.raises(DhcliError):
            ask()


def test_what_a_mask_hides_and_times_are_no_numbers() -> None:
    """Joint values would be those behind the mask; an array with a mask that hides nothing is as good as any."""
    arm, q = load_robot("scara"), np.array([[0.1, 0.2, 0.3]])
    poses = forward_batch(arm, q)
    for ask, given in ((forward_batch, q), (jacobian, q), (inverse, poses[0]), (inverse_batch, poses)):
        with pytest.raises(DhcliError, match="a mask hides some of the numbers"):
            ask(arm, np.ma.array(given, mask=given > 0.1))
        with pytest.raises(DhcliError, match=r"no array of numbers|is no pose"):
            ask(arm, np.zeros(given.shape, "M8[s]"))
        ask(arm, np.ma.array(given))
