"""`--motors`: all that holds for joints holds for the motors that drive them; and `describe --as motors`."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from tests.cli.running import Run

DATA = Path(__file__).parents[1] / "data" / "coupled"
PAIR, BALL_SCREW = str(DATA / "two-and-three.yaml"), str(DATA / "ball-screw.yaml")


def told(dhcli: Run, *words: str) -> dict[str, object]:
    """What a command says in JSON."""
    done = dhcli(*words, "--format", "json")
    assert done.code == 0, done.err
    return json.loads(done.out)["data"]


def test_motor_values_put_the_end_where_their_joint_values_do(dhcli: Run) -> None:
    """In numbers, in letters, of many rows."""
    motors = told(dhcli, "fk", PAIR, "--motors", "--q", "0,31.324°,-33.342°")
    joints = told(dhcli, "fk", PAIR, "--q", "0,31.324°,-2.018°")
    assert np.asarray(motors["matrix"]) == pytest.approx(np.asarray(joints["matrix"]), abs=1e-15)
    assert "theta2 = 31.324° · theta3 = -2.018°" in dhcli("fk", PAIR, "--motors", "--q", "0,31.324°,-33.342°").out
    assert "a3*s(2*J2+J3)" in dhcli("fk", PAIR, "--motors", "-s", "--as", "position").out
    Path("q.csv").write_text("theta1[deg],J2[deg],J3[deg]\n0,31.324,-33.342\n", "utf-8")
    rows = dhcli("fk", PAIR, "--motors", "--rows", "q.csv", "--as", "position").out.split("\n")
    assert [float(x) for x in rows[1].split(",")] == pytest.approx([row[3] for row in motors["matrix"][:3]])  # type: ignore[index]


def test_poses_are_reached_by_motor_values(dhcli: Run) -> None:
    """In the columns of the motors, with the limits of both sides."""
    done = dhcli("ik", PAIR, "--motors", "--q", "0,70°,150°", "--task", "position")
    assert done.code == 0
    heads = next(line for line in done.out.split("\n") if "J2" in line and "#" in line)
    assert heads.split()[:4] == ["#", "theta1", "J2", "J3"]
    assert "theta3 20° above" in done.out
    assert dhcli("ik", PAIR, "--motors", "--q", "0,70°,150°", "--within-limits").code == 1


def test_torques_and_rates_are_those_of_the_motors(dhcli: Run) -> None:
    """By the transpose, and by the inverse."""
    of_joints = told(dhcli, "torques", PAIR, "--pose", "folded", "--force", "0,0,-10")
    of_motors = told(dhcli, "torques", PAIR, "--motors", "--pose", "folded", "--force", "0,0,-10")
    joints, motors = (dict(zip(found["joints"], found["torques"], strict=True)) for found in (of_joints, of_motors))  # type: ignore[call-overload]
    assert motors["J2"] == pytest.approx(joints["theta2"] + joints["theta3"])
    assert motors["J3"] == pytest.approx(joints["theta3"])
    out = dhcli("rates", PAIR, "--motors", "--pose", "folded", "--velocity", "0.1,0,0").out
    assert "J2'" in out
    assert "J3'" in out


def test_motors_are_described_both_ways(dhcli: Run) -> None:
    """In words, and in JSON with the ratios and their inverse."""
    out = dhcli("describe", PAIR, "--as", "motors").out
    assert "theta3 = J2 + J3" in out
    assert "J3 = theta3 - theta2" in out
    assert "tau_J2 = tau_theta2 + tau_theta3" in out
    data = told(dhcli, "describe", BALL_SCREW, "--as", "motors")
    assert set(data) == {"robot", "motors", "joints", "ratios", "shifts", "inverse", "formulas", "limits"}
    assert np.asarray(data["ratios"]) @ np.asarray(data["inverse"]) == pytest.approx(np.eye(4))
    assert "d3 = 20 mm/(360°) * m3 - 20 mm/(360°) * m4" in data["formulas"]  # type: ignore[operator]
    assert "theta3 = J2 + J3" in dhcli("show", PAIR).out


def test_a_file_with_motors_is_written_and_reads_the_same(dhcli: Run) -> None:
    """Limits, offsets and leads."""
    for path in (PAIR, BALL_SCREW):
        assert dhcli("describe", path, "--as", "product", "-o", "again.yaml", "--overwrite").code == 0
        assert told(dhcli, "describe", path, "--as", "motors") | {"robot": ""} == told(
            dhcli, "describe", "./again.yaml", "--as", "motors"
        ) | {"robot": ""}


def test_without_motors_the_option_is_refused(dhcli: Run) -> None:
    """With where they would stand."""
    done = dhcli("fk", "scara-yim", "--motors", "-s")
    assert (done.code, "not known which motors drive it" in done.err) == (2, True)
    assert "actuators" in done.err


def test_the_gears_of_the_puma_turn_each_other_in_the_wrist(dhcli: Run) -> None:
    """Motor 5 turns with joint 4, motor 6 with joint 4 and by 13/72 of joint 5; people read ratios, files fractions."""
    data = told(dhcli, "describe", "puma560-standard", "--as", "motors")
    back = np.asarray(data["inverse"])[3:, 3:]
    gears = np.array([76.03636, 71.923, 76.686])
    assert back == pytest.approx(np.array([[gears[0], 0, 0], [1, gears[1], 0], [1, gears[2] * 13 / 72, gears[2]]]))
    assert "theta4 = m4/76.03636" in dhcli("show", "puma560-standard").out
    assert dhcli("describe", "puma560-standard", "--as", "modified", "-o", "x.yaml").code == 0
    assert np.asarray(told(dhcli, "describe", "./x.yaml", "--as", "motors")["inverse"]) == pytest.approx(
        np.asarray(data["inverse"]), rel=1e-15
    )


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        (("J3 + J2", "J3 + J9"), "J9 is not a name that is known here"),
        (("J3 + J2", "J3*a1"), "theta3: a ratio is a number, and a1 is a letter"),
        (("J3 + J2", "2*J2"), "actuators: J3 drives no joint"),
        (("theta2: J2", "theta9: J2"), "actuators: theta9 is no joint of this robot"),
        (("  theta2: J2\n", ""), "2 motors, J2, J3, for 1 joint, theta3"),
        (("theta3: J3 + J2", "theta3: 2*theta2"), "theta3: theta2 is a joint, and joints are driven by motors"),
        (("theta2: J2\n  theta3: J3 + J2", "theta2: J2 - J3\n  theta3: 2*J3 - 2*J2"), "theta3 = -2*theta2 whatever"),
        (("J2: [-60°, 76°]", "J2: [-60°]"), "J2: two values are wanted"),
        (("J2: [-60°, 76°]", "J2: [-0.1 m, 0.2 m]"), "J2 turns, and its limit is an angle"),
        (("J2: [-60°, 76°]", "J2: [76°, -60°]"), "J2: the lower limit is not below the upper one"),
        (("motors: {J2: [-60°, 76°], J3", "motors: {a1: [-60°, 76°], J3"), "motors: a1 is used twice"),
        (("motors: {J2: [-60°, 76°], J3", "motors: {mm: [-60°, 76°], J3"), "motors: mm has a meaning of its own"),
        (("motors: {J2: [-60°, 76°], J3: [-70°, 200°]}", "motors: 3"), "motors: should be a mapping"),
        (("  motors: {J2: [-60°, 76°], J3: [-70°, 200°]}\n", ""), "motors is missing"),
    ],
)
def test_what_is_wrong_with_motors_is_told_with_its_line(dhcli: Run, changes: tuple[str, str], message: str) -> None:
    """And what would be right."""
    text = Path(PAIR).read_text("utf-8")
    assert changes[0] in text
    Path("x.yaml").write_text(text.replace(*changes), "utf-8")
    done = dhcli("show", "./x.yaml")
    assert done.code == 2
    assert message in done.err
    assert "x.yaml:" in done.err
