"""Robots made in Python, copied, saved and found."""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhcli import DhcliError, Robot, forward, inverse, list_robots, load_robot
from dhcli.errors import RobotError
from dhcli.files.urdf.writing import urdf_text
from dhcli.files.yaml.robots import read_robot
from dhcli.files.yaml.writing import described_text
from dhcli.kinematics import robot as robot_module
from dhcli.kinematics.describe.asked import Asked
from dhcli.kinematics.describe.description import describe
from dhcli.kinematics.validity import check
from tests.row_by_row import row_by_row

if TYPE_CHECKING:
    from numpy.typing import NDArray

ROOT = Path(__file__).parents[2]
PLANAR = [("a1", 0, 0, "theta1"), {"a": 0.3, "alpha": "0°", "theta": "theta2"}]


def test_a_robot_made_of_rows_is_the_one_of_the_file() -> None:
    """Tuples and mappings, numbers and letters."""
    robot = Robot.from_dh(PLANAR, variables=["theta1", "theta2"], parameters={"a1": 0.4})
    assert np.allclose(forward(robot, [0.3, 0.5]).matrix, forward(load_robot("planar-2r"), [0.3, 0.5]).matrix)


def test_modified_rows_take_radians_and_units() -> None:
    """The same row twice."""
    rows = [(0, np.pi / 2, "300 mm", "theta1 - 90°")]
    text = [(0, "90°", 0.3, "theta1 - 90°")]
    found = [Robot.from_dh(r, variables=["theta1"], convention="modified") for r in (rows, text)]
    assert np.allclose(forward(found[0], [0.2]).matrix, forward(found[1], [0.2]).matrix, atol=1e-15)


def test_a_copy_has_another_tool_and_other_lengths() -> None:
    """The robot itself stays."""
    robot = load_robot("planar-2r")
    longer = robot.copy(tool="Trans(0.1, 0, 0)", parameters={"a1": "500 mm"}, name="longer")
    assert forward(longer, [0, 0], end="tool").position == pytest.approx((0.9, 0, 0))
    assert (robot.tool, longer.name) == ((), "longer")
    assert longer.copy(tool="").tool == ()


def test_a_copy_takes_one_of_the_tools_by_name() -> None:
    """And is from no file any more."""
    robot = Robot.from_text(FILE + "tools: {gripper: 'Trans(0.2, 0, 0)'}\n")
    assert robot.copy(tool="gripper").tool == robot.tools["gripper"]
    assert load_robot("planar-2r").copy(name="other").path is None


FILE = "format: 1\ntitle: t\nsource: s\nconvention: product\nvariables: [q1]\nlinks: ['Rot(z, q1) Trans(0.4, 0, 0)']\n"


def test_a_robot_is_read_from_text_and_remembers_its_file(tmp_path: Path) -> None:
    """The two are equal; only where they come from differs."""
    path = tmp_path / "arm.yaml"
    path.write_text(FILE, "utf-8")
    read, loaded = Robot.from_text(FILE, name="arm"), load_robot(path)
    assert read == loaded
    assert (read.path, loaded.path, loaded.copy().path) == (None, path, None)
    with pytest.raises(DhcliError, match="text:1:1: format: is missing"):
        Robot.from_text("title: t\n")


@pytest.mark.parametrize("name", ["planar-2r", "panda", "axes.yaml", "arm.urdf"])
def test_a_robot_is_validated_once_when_it_is_loaded(
    name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Whatever it is written as; that it knows its file is no reason to look again."""
    if "." in name:
        described = describe(load_robot("planar-2r"), Asked("axes"))
        text = described_text(described) if name.endswith(".yaml") else urdf_text(described.robot)
        (tmp_path / name).write_text(text, "utf-8")
    else:
        text = (ROOT / "robots" / f"{name}.yaml").read_text("utf-8").replace("\ntitle:", "\ntitle: a new")
        name = f"{name}.yaml"
        (tmp_path / name).write_text(text, "utf-8")
    seen: list[Robot] = []
    monkeypatch.setattr(robot_module, "check", lambda robot: (seen.append(robot), check(robot)))
    loaded = load_robot(tmp_path / name)
    assert [one for one in seen if one.title] == [loaded]
    assert loaded.path == tmp_path / name
    assert loaded.joints == loaded.copy().joints


def test_a_chain_of_a_urdf_is_read_from_text() -> None:
    """As from its file."""
    path = Path(__file__).parents[1] / "data" / "urdf" / "three-joints.urdf"
    read = Robot.from_urdf(path.read_text("utf-8"), tip="camera", name="three-joints")
    assert read.links == load_robot(path, tip="camera").links
    with pytest.raises(DhcliError, match="which one"):
        Robot.from_text(path.read_text("utf-8"))


def matrix_exponential(screw: NDArray[np.float64], angle: float) -> NDArray[np.float64]:
    """By its series, which knows no axis."""
    wx, wy, wz, *v = screw
    twist = np.zeros((4, 4))
    twist[:3, :3] = [[0, -wz, wy], [wz, 0, -wx], [-wy, wx, 0]]
    twist[:3, 3] = v
    total = term = np.eye(4)
    for k in range(1, 40):
        term = term @ twist * angle / k
        total = total + term
    return total


UR5_HOME = np.array([[-1, 0, 0, 0.817], [0, 0, 1, 0.191], [0, 1, 0, -0.006], [0, 0, 0, 1]])
UR5_SCREWS = np.array(
    [
        [0, 0, 1, 0, 0, 0],
        [0, 1, 0, -0.089, 0, 0],
        [0, 1, 0, -0.089, 0, 0.425],
        [0, 1, 0, -0.089, 0, 0.817],
        [0, 0, -1, -0.109, 0.817, 0],
        [0, 1, 0, 0.006, 0, 0.817],
    ]
)
"""Lynch and Park, Modern Robotics, example 4.5."""


@pytest.mark.parametrize("frame", ["space", "body"])
def test_a_robot_of_screws_moves_as_the_product_of_their_exponentials(frame: str) -> None:
    """The UR5 of the book, in the base and with the same screws moved into its end frame."""
    q = [0.3, -0.8, 1.1, 0.4, -1.3, 0.7]
    expected = np.linalg.multi_dot([*map(matrix_exponential, UR5_SCREWS, q), UR5_HOME])
    screws = UR5_SCREWS
    if frame == "body":
        back = np.linalg.inv(UR5_HOME)
        rotation, (x, y, z) = back[:3, :3], back[:3, 3]
        adjoint = np.zeros((6, 6))
        adjoint[:3, :3] = adjoint[3:, 3:] = rotation
        adjoint[3:, :3] = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]]) @ rotation
        screws = UR5_SCREWS @ adjoint.T
    robot = Robot.from_screws(screws, UR5_HOME, frame=frame)
    assert robot.variables == ("theta1", "theta2", "theta3", "theta4", "theta5", "theta6")
    assert np.allclose(forward(robot, q).matrix, expected, atol=1e-14)


@row_by_row(
    ("screws", "home", "said"),
    [
        ([(0, 0, 1, 0, 0)], "", "5 numbers, not six"),
        ([3], "", "screw 1: 3 is no list"),
        ([], "", "0 variables and 0 screws"),
        ([(0, 0, 0, 0, 0, 0)], "", "is zero"),
        ([(0, 0, 1, 0, 0, float("nan"))], "", "nan is no value"),
        ([(0, 0, 1, 0, 0, 0)], np.eye(3), "shape (4, 4)"),
        ([(0, 0, 1, 0, 0, 0)], np.diag([1, 1, 2, 1]), "home"),
        ([(0, 0, 1, 0, 0, 0)], UR5_HOME.T, "the last row of a pose is 0 0 0 1 (see that rows and columns"),
        ([(0, 0, 1, 0, 0, 0)], "Trans(l, 0, 0)", "no value"),
        ([(0, 0, 1, 0, 0, 0)], 5, "home"),
    ],
)
def test_what_is_no_screw_or_no_home_is_refused(screws: list[object], home: object, said: str) -> None:
    """With what it is."""
    with pytest.raises(DhcliError) as caught:
        Robot.from_screws(screws, home)  # type: ignore[arg-type]
    assert said in str(caught.value)
    with pytest.raises(DhcliError, match="did you mean space"):
        Robot.from_screws([(0, 0, 1, 0, 0, 0)], "", frame="spice")


def test_a_length_of_a_table_may_stay_open() -> None:
    """And a product made in Python shows itself though nobody wrote it."""
    robot = Robot.from_dh([("a1", 0, 0, "theta1")], variables=["theta1"], parameters={"a1": None})
    assert robot.parameters == {"a1": None}
    assert Robot.from_screws([(0, 0, 1, 0, 0, 0)], "Trans(0.7, 0, 0)").links[0].product == (
        "Rot(z, theta1) * Trans(0.7, 0, 0)"
    )


@pytest.mark.parametrize("alpha", [90, -90.0, 180])
def test_degrees_among_radians_are_refused(alpha: float) -> None:
    """Nobody means 90 rad, and the arm would be another without a word."""
    with pytest.raises(RobotError, match=rf"row 1: {alpha:g} rad is .* turns(.|\n)*write '{alpha:g}°'"):
        Robot.from_dh([(0.3, alpha, 0, "q1")], variables=["q1"])
    assert Robot.from_dh([(0.3, math.radians(alpha), 0, "q1")], variables=["q1"]).joints


def test_numbers_that_a_file_would_take_for_right_angles_are_saved_as_they_are(tmp_path: Path) -> None:
    """1.571 rad is 90° to its digits, and 0.866 nearly a cosine; the file says that it means them."""
    robot = Robot.from_dh([(0.3, 1.571, 0, "q1")], variables=["q1"])
    robot.save(tmp_path / "x.yaml")
    again = load_robot(tmp_path / "x.yaml")
    assert again.links == robot.links
    assert "exact: false" in (tmp_path / "x.yaml").read_text("utf-8")
    load_robot("puma560").save(tmp_path / "p.yaml")
    assert "exact" not in (tmp_path / "p.yaml").read_text("utf-8")


@pytest.mark.parametrize("name", ["x.yaml", "x.urdf"])
def test_what_is_saved_is_loaded(name: str, tmp_path: Path) -> None:
    """And not over a file that stands there."""
    path = tmp_path / name
    robot = load_robot("stanford")
    robot.save(path)
    q = [0.1, 0.2, 0.3, 0.4, 0.5, 0.6]
    assert np.allclose(forward(load_robot(path), q).matrix, forward(robot, q).matrix, atol=1e-14)
    with pytest.raises(DhcliError, match=r"stands|exists"):
        robot.save(path)


def test_what_was_spelled_in_another_way_is_equal_when_it_is_loaded_again(tmp_path: Path) -> None:
    """A product keeps its author's spelling, which makes no other robot."""
    head = "{format: 1, title: t, source: s, convention: product, variables: [q1], links: "
    made = {
        "text": Robot.from_text(head + "['Rot(z, q1)   Trans(400 mm, 0, 0)']}", name="text"),
        "screws": Robot.from_screws([(0, 0, 1, 0, 0, 0)], "Trans(0.7, 0, 0)", name="screws"),
    }
    for name, robot in made.items():
        robot.save(tmp_path / f"{name}.yaml")
        assert load_robot(tmp_path / f"{name}.yaml") == robot, name
    assert made["text"] != made["screws"]


def test_the_name_of_a_file_is_no_urdf() -> None:
    """What reads it is named."""
    with pytest.raises(DhcliError, match="no XML") as caught:
        Robot.from_urdf("arm.urdf")
    assert "load_robot('arm.urdf')" in str(caught.value.problems[0].hint)


def test_the_library_is_listed_and_its_own_robot_found_behind_one_of_the_same_name(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """`builtin:` means what dhcli brings along."""
    (tmp_path / "robots").mkdir()
    load_robot("planar-2r").save(tmp_path / "robots" / "puma560.yaml")
    monkeypatch.chdir(tmp_path)
    assert "puma560" in list_robots()
    assert len(load_robot("puma560").variables) == 2
    assert len(load_robot("builtin:puma560").variables) == 6
    with pytest.raises(DhcliError, match="there is no robot"):
        load_robot("builtin:nothing")


def test_keys_that_begin_with_x_are_the_authors_own() -> None:
    """Others are not."""
    head = "format: 1\ntitle: t\nsource: s\nconvention: product\nvariables: [q1]\nlinks: ['Rot(z, q1)']\n"
    assert read_robot(f"{head}x-colour: red\nx-more: {{a: [1]}}\n", "x", "x").variables == ("q1",)
    with pytest.raises(DhcliError, match="colour: unknown key"):
        read_robot(f"{head}colour: red\n", "x", "x")


@pytest.mark.parametrize(
    ("rows", "said"),
    [
        ([(0, 0, 0)], "3 cells, not four"),
        ([{"a": 0, "alfa": 0}], "did you mean alpha"),
        ([(0, "90", 0, "theta1")], "has no unit"),
        ([("b", 0, 0, "theta1")], "b"),
    ],
)
def test_rows_that_are_none_are_refused(rows: list[object], said: str) -> None:
    """With the row."""
    with pytest.raises(DhcliError) as caught:
        Robot.from_dh(rows, variables=["theta1"])  # type: ignore[arg-type]
    assert said in str(caught.value)


def test_a_tool_or_a_base_may_be_a_pose_or_its_matrix() -> None:
    """As a calibration gives it, in whatever holds numbers."""
    robot, q = load_robot("ur5e"), [0.1, -0.7, 0.4, 1, 0.3, -0.2]
    pose = forward(robot, "work")
    matrix = pose.matrix
    expected = forward(robot, q).matrix
    for given in (pose, matrix, matrix.tolist()):
        with_tool = robot.copy(tool=given)
        assert np.allclose(forward(with_tool, q, end="tool").matrix, expected @ matrix, atol=1e-14)
        assert np.allclose(forward(robot.copy(base=given), q, start="base").matrix, matrix @ expected, atol=1e-14)
        assert replace(robot, tool=given) == with_tool
    back = inverse(robot.copy(tool=pose), expected @ matrix, end="tool")
    assert len(back) == 8
    assert robot.copy(tool=robot.tool) == robot


@pytest.mark.parametrize(
    ("tool", "said"),
    [
        (np.eye(3), "tool: a pose is a matrix of shape (4, 4)"),
        (UR5_HOME.T, "tool: the last row of a pose is 0 0 0 1 (see that rows and columns are not exchanged)"),
        (np.diag([1, 2, 1, 1]), "tool: column 2 is not a unit vector"),
        (np.full((4, 4), np.nan), "tool: nan is no value"),
        (5, "tool: 5 is no list"),
        ([[1, 2], 3], "tool: [1, 2] is no move"),
        ("grip", "grip"),
    ],
)
def test_what_is_no_tool_is_refused(tool: object, said: str) -> None:
    """With what it is."""
    with pytest.raises(DhcliError) as caught:
        load_robot("ur5e").copy(tool=tool)
    assert said in str(caught.value)
