"""Robots whose variables share moves, described move by move and carried back to their own variables."""

from __future__ import annotations

import random
from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhcli.algebra.floats import Floats
from dhcli.errors import RobotError
from dhcli.files.urdf.robots import read_urdf
from dhcli.files.urdf.writing import urdf_text
from dhcli.files.yaml.robots import load_robot, read_robot
from dhcli.files.yaml.writing import described_text
from dhcli.kinematics.describe.asked import FORMS, Asked, Form
from dhcli.kinematics.describe.description import describe, known_values
from dhcli.kinematics.fold import fold
from dhcli.kinematics.robot import Robot
from dhcli.notation.angle import Angle
from tests.kinematics.describe.test_tables import end_by_screws
from tests.kinematics.test_coupled import ARMS, IDS, PAIR, PALLETIZER, SCREW, drawn, moved
from tests.nightly import cases_for_nights

if TYPE_CHECKING:
    from numpy.typing import NDArray

TABLES = ("standard", "modified", "product")


def pose_of(robot: Robot, q: Sequence[float] | NDArray[np.float64]) -> NDArray[np.float64]:
    """The pose of a robot, base to tool, for values of its variables in order."""
    return np.array(fold(robot.chain, Floats({**known_values(robot), **dict(zip(robot.variables, q, strict=True))})))


@pytest.mark.parametrize("robot", ARMS, ids=IDS)
@pytest.mark.parametrize("form", FORMS)
def test_a_robot_with_shared_moves_is_the_same_robot_in_every_form(robot: Robot, form: Form) -> None:
    """Against elementary matrices written out by hand, in its own variables, with its poses; proved exactly."""
    found = describe(robot, Asked(form))
    assert found.robot.variables == robot.variables
    assert found.robot.poses == robot.poses
    assert found.proof.kind == "exact"
    for seed in range(3):
        q = drawn(robot, seed)
        assert pose_of(found.robot, q) == pytest.approx(moved(robot, q), abs=1e-14)


@pytest.mark.parametrize("form", TABLES)
def test_a_written_table_loads_with_its_shared_rows(form: Form) -> None:
    """And moves as it did."""
    again = read_robot(described_text(describe(PALLETIZER, Asked(form))), "x", "arm")
    q = drawn(PALLETIZER)
    assert again.variables == PALLETIZER.variables
    assert pose_of(again, q) == pytest.approx(moved(PALLETIZER, q), abs=1e-14)


def test_screws_of_shared_moves_are_those_of_the_joints_they_make() -> None:
    """By a product of exponentials, with what the rods do to joints 3 and 4."""
    found = describe(replace(PALLETIZER), Asked("screws", numbers=True))
    j1, j2, j3, j4 = drawn(PALLETIZER)
    assert found.shared == {"theta3": Angle.of("j3") - Angle.of("j2"), "theta4": -Angle.of("j3")}
    joints = {"j1": j1, "j2": j2, "theta3": j3 - j2, "theta4": -j3, "j4": j4}
    assert [screw.name for screw in found.screws] == list(joints)
    assert found.drawing is not None
    expected = moved(PALLETIZER, (j1, j2, j3, j4))
    assert end_by_screws(found.drawing, joints) == pytest.approx(expected, abs=1e-14)


def test_it_is_drawn_in_a_pose_of_its_own_variables() -> None:
    """Joint 3 stands at j3 - j2 there, which is what the offsets of the drawing take off again."""
    pose = {"j2": Angle.in_degrees(90), "j3": Angle.in_degrees(30)}
    found = describe(PALLETIZER, Asked("axes", pose=pose))
    assert found.drawing is not None
    at = {line.name: line.drawn for line in found.drawing.lines}
    assert at["theta3"] == Angle.in_degrees(-60)
    assert at["theta4"] == Angle.in_degrees(-30)
    q = drawn(PALLETIZER)
    assert pose_of(found.robot, q) == pytest.approx(moved(PALLETIZER, q), abs=1e-14)


def test_axes_that_shared_moves_turn_about_are_straightened_too() -> None:
    """A twist of a ten-thousandth of a radian between the links of a palletizer goes, within its bound."""
    bent = load_robot("palletizer")
    row = bent.links[1].row
    assert row is not None
    text = described_text(describe(bent, Asked("standard"))).replace(
        "alpha: 0, d: 0, theta: j2", "alpha: 0.0001 rad, d: 0, theta: j2"
    )
    robot = read_robot(text, "x", "arm")
    found = describe(robot, Asked("standard", straighten=1e-3))
    assert found.straightened is not None
    assert [change.joint for change in found.straightened.changes]
    q = drawn(robot)
    assert found.robot.variables == robot.variables
    gap = np.abs(pose_of(found.robot, q) - pose_of(robot, q)).max()
    assert 0 < gap <= max(found.straightened.tip, found.straightened.turn)


@pytest.mark.parametrize(
    ("robot", "followers"), [(PALLETIZER, ["j2", "j3"]), (SCREW, ["q"]), (ARMS[2], ["J2"])], ids=["rods", "screw", "J"]
)
def test_a_urdf_follows_where_moves_are_shared(robot: Robot, followers: list[str]) -> None:
    """A sum is one joint behind the other; what is read again has the same variables, limits and motion."""
    text = urdf_text(robot)
    again = read_urdf(text, "x", "arm", tip="tool0", as_typed=True)
    leaders = [line.split('"')[1] for line in text.splitlines() if "<mimic" in line]
    assert leaders == followers
    q = dict(zip(robot.variables, drawn(robot), strict=True))
    pose = pose_of(again, [q[again.called.get(own, own)] for own in again.variables])
    assert pose == pytest.approx(moved(robot, list(q.values())), abs=1e-12)


def test_a_urdf_keeps_what_motors_leave_to_a_joint() -> None:
    """The range of theta2 is that of its motor; theta3 has limits of its own, narrower than both motors leave it."""
    found = read_urdf(urdf_text(PAIR), "x", "arm", tip="tool0")
    ends = {name: [limit.constant() for limit in pair] for name, pair in found.limits.items()}  # type: ignore[union-attr]
    assert ends["theta2"] == pytest.approx(np.radians([-60, 76]))
    assert ends["theta3"] == pytest.approx(np.radians([-80, 200]))
    free = replace(PAIR, limits={})
    ends = {name: [x.constant() for x in pair] for name, pair in read_urdf(urdf_text(free), "x", "a").limits.items()}  # type: ignore[union-attr]
    assert ends["theta3"] == pytest.approx(np.radians([-130, 276]))
    assert "theta1" not in ends


HALF = """\
format: 1
title: t
source: s
convention: product
variables: [q1, q2]
links: ["Rot(z, q1/2) * Trans(1, 0, 0)", "Rot(z, q2 - q1/2) * Trans(1, 0, 0)"]
"""


def test_a_urdf_whose_joints_only_move_by_parts_of_a_variable_is_refused() -> None:
    """The least that a joint needs is one that moves by the variable itself."""
    with pytest.raises(RobotError, match="no joint moves by q1 itself") as caught:
        urdf_text(read_robot(HALF, "x", "x"))
    assert "--as product" in str(caught.value)
    assert describe(read_robot(HALF, "x", "x"), Asked("product")).proof.kind == "exact"


def test_a_file_of_axes_or_screws_with_shared_moves_is_refused() -> None:
    """There each joint has a variable of its own; the table says it in one file."""
    for form in ("axes", "screws", "body-screws"):
        with pytest.raises(RobotError, match="theta3 has no variable of its own") as caught:
            described_text(describe(PALLETIZER, Asked(form)))  # type: ignore[arg-type]
        assert "standard, modified or product" in str(caught.value)


def any_robot(draw: random.Random) -> str:
    """A file of a robot whose variables stand in rows as they like: twice, halved, against each other, in screws."""
    names = [f"q{i}" for i in range(1, draw.randint(2, 4) + 1)]
    rows = []
    for k in range(draw.randint(len(names), len(names) + 2)):
        own, other = names[k] if k < len(names) else draw.choice(names), draw.choice(names)
        angle = draw.choice([own, f"{own} - {other}" if own != other else f"2*{own}", f"-{own}", f"{own}/2"])
        moves = [f"Rot({draw.choice('xyz')}, {angle})"]
        moves += [f"Trans(0, 0, p*{own})"] * (draw.random() < 0.3 and other not in angle)
        moves += [f"Trans({draw.choice(['a', '0', 'b + 0.1'])}, {draw.choice(['0', 'b'])}, 0.2)"]
        moves += [f"Rot({draw.choice('xyz')}, {draw.choice([90, -90, 45, 30])}°)"] * (draw.random() < 0.4)
        rows.append(f"  - {' * '.join(moves)}")
    listed = "\n".join(rows)
    head = f"format: 1\ntitle: t\nsource: s\nconvention: product\nvariables: [{', '.join(names)}]"
    return f"{head}\nparameters: {{a: 0.3, b: 0.2, p: 0.01}}\nlinks:\n{listed}\n"


@pytest.mark.parametrize("seed", cases_for_nights(range(300), *range(6)))
def test_variables_that_stand_anywhere_keep_their_motion_in_every_form_and_file(seed: int) -> None:
    """What a file cannot hold is refused in words, and nothing is written that moves otherwise."""
    draw = random.Random(seed)  # noqa: S311  the same robots every time
    robot = read_robot(any_robot(draw), "x", "arm")
    q = {name: draw.uniform(-2, 2) for name in robot.variables}
    expected = pose_of(robot, list(q.values()))
    for form in FORMS:
        found = describe(robot, Asked(form))
        assert pose_of(found.robot, [q[name] for name in found.robot.variables]) == pytest.approx(expected, abs=1e-11)
        try:
            again = read_robot(described_text(found), "x", "arm")
        except RobotError as error:
            assert form not in TABLES
            assert "has no variable of its own" in str(error) or "a file of axes cannot say" in str(error)
            continue
        assert pose_of(again, [q[name] for name in again.variables]) == pytest.approx(expected, abs=1e-11)
    try:
        urdf = read_urdf(urdf_text(robot), "x", "arm", tip="tool0", as_typed=True)
    except RobotError as error:
        assert "of its own value" in str(error) or "itself, for others" in str(error)
    else:
        assert pose_of(urdf, [q[name] for name in urdf.variables]) == pytest.approx(expected, abs=1e-9)
