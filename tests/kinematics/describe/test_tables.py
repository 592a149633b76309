"""From axes to tables: every robot, drawn anywhere, and arms whose axes lie as they never should."""

from __future__ import annotations

import math
import random
from fractions import Fraction
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhcli.algebra.floats import Floats
from dhcli.errors import RobotError
from dhcli.files.yaml.robots import load_robot
from dhcli.geometry.twists import about, along, displacements
from dhcli.geometry.vectors import dot
from dhcli.kinematics.conventions import Convention, moves_of
from dhcli.kinematics.describe.asked import Asked
from dhcli.kinematics.describe.choices import Choices
from dhcli.kinematics.describe.description import describe, known_values
from dhcli.kinematics.describe.drawn import Drawing, Frame, Line, drawing_of
from dhcli.kinematics.describe.exact import exact_angle
from dhcli.kinematics.describe.linear import LettersError, Point
from dhcli.kinematics.describe.normals import Lie
from dhcli.kinematics.describe.process import Walk, frames_of, walk
from dhcli.kinematics.describe.repairing import repaired
from dhcli.kinematics.describe.retold import retold
from dhcli.kinematics.fold import fold
from dhcli.kinematics.moves import Chain
from dhcli.notation.tree import ONE
from tests.coupled import COUPLED
from tests.nightly import cases_for_nights, in_turn, paired
from tests.row_by_row import row_by_row

if TYPE_CHECKING:
    from numpy.typing import NDArray

ROBOTS = sorted({path.stem for path in (Path(__file__).parents[3] / "robots").glob("*.yaml")} - {*COUPLED})
OPEN = ("dh-link", "dh-link-modified")
"""Robots whose twist is a letter, so that no direction is known."""
JOINTED = [name for name in ROBOTS if name not in (*OPEN, "assembly-blocks")]
TABLES = [name for name in ROBOTS if load_robot(name).convention is not Convention.PRODUCT]
CONVENTIONS = (Convention.STANDARD, Convention.MODIFIED)


def chain_of(walked: Walk, convention: Convention) -> Chain:
    """The moves from base to end."""
    rows = [move for row in walked.rows(convention) for move in moves_of(row, convention)]
    return (*walked.base(convention), *rows, *walked.tool(convention))


def end_by_screws(drawing: Drawing, q: dict[str, float]) -> NDArray[np.float64]:
    """The end frame by a product of exponentials in numpy: no table, no convention, no fold."""
    pose = np.eye(4)
    for line in drawing.lines:
        direction = np.array(line.direction)
        point = np.array((line.through or {}).get(ONE, (0.0, 0.0, 0.0)))
        twist = about(point, direction, line.pitch.get(ONE, 0.0)) if line.turns else along(direction)
        pose = pose @ displacements(twist[None], np.array([q[line.name]]))[0]
    end = drawing.end
    home = np.eye(4)
    home[:3, 0], home[:3, 1], home[:3, 2] = end.x, end.y, end.z
    home[:3, 3] = end.origin.get(ONE, (0.0, 0.0, 0.0))
    return pose @ home


def random_direction(draw: random.Random) -> tuple[float, float, float]:
    """A unit vector anywhere."""
    vector = np.array([draw.gauss(0, 1) for _ in range(3)])
    x, y, z = (vector / np.linalg.norm(vector)).tolist()
    return x, y, z


def nasty_arm(draw: random.Random) -> Drawing:
    """Axes that are parallel, antiparallel, nearly parallel, meeting, coincident or skew; some slide, some screw."""
    lines: list[Line] = []
    direction, point = (0.0, 0.0, 1.0), np.zeros(3)
    for k in range(draw.randint(2, 7)):
        kind = draw.choice(("parallel", "anti", "same", "meet", "skew", "near", "right"))
        before = np.array(direction)
        if kind in ("parallel", "anti"):
            point = point + np.array([draw.uniform(-1, 1) for _ in range(3)])
            direction = tuple((-before if kind == "anti" else before).tolist())
        elif kind == "same":
            point = point + draw.uniform(-1, 1) * before
        elif kind == "meet":
            point, direction = point + draw.uniform(-1, 1) * before, random_direction(draw)
        elif kind == "skew":
            point, direction = point + np.array(random_direction(draw)), random_direction(draw)
        elif kind == "right":
            direction = draw.choice(((1.0, 0.0, 0.0), (0.0, -1.0, 0.0), (0.0, 0.0, 1.0)))
            point = point + np.array([draw.choice((0.0, 0.5)) for _ in range(3)])
        else:
            tilted = before + 1e-2 * np.array(random_direction(draw))
            direction = tuple((tilted / np.linalg.norm(tilted)).tolist())
        x, y, z = point.tolist()
        slides, pitch = draw.random() < 0.2, {ONE: draw.uniform(-0.1, 0.1)} if draw.random() < 0.2 else {}
        through: Point | None = None if slides else {ONE: (x, y, z)}
        lines.append(Line(f"q{k}", direction, through, turns=not slides, pitch={} if slides else pitch))
    z = random_direction(draw)
    x = np.cross(z, random_direction(draw))
    a, b, c = (x / np.linalg.norm(x)).tolist()
    end = Frame((a, b, c), z, {ONE: random_direction(draw)})
    return Drawing(tuple(lines), end)


@row_by_row("seed", cases_for_nights(range(1000), *range(40)))
def test_an_arm_with_axes_as_bad_as_they_come_has_tables_that_move_as_it_does(seed: int) -> None:
    """Both tables of each arm against exponentials of its lines, to 1e-13 of its size."""
    draw = random.Random(seed)  # noqa: S311  the same arms every time
    drawing = nasty_arm(draw)
    walked = walk(drawing)
    q = {line.name: draw.uniform(-3, 3) for line in drawing.lines}
    expected = end_by_screws(drawing, q)
    size = max(1.0, *(abs(foot) for leg in walked.legs for v in leg.normal.end.values() for foot in v))
    for convention in CONVENTIONS:
        found = np.array(fold(chain_of(walked, convention), Floats(q)))
        assert np.abs(found - expected).max() <= 1e-13 * size * len(q)


@row_by_row("seed", in_turn(range(40), 0, 2))
def test_every_frame_keeps_the_rules_of_its_normal(seed: int) -> None:
    """DH2: x is perpendicular to both lines. DH3: it passes through both."""
    drawing = nasty_arm(random.Random(1000 + seed))  # noqa: S311  the same
    walked = walk(drawing)
    for leg, frame in zip(walked.legs, frames_of(walked, Convention.STANDARD), strict=True):
        first, second = walked.lines[leg.number], walked.lines[leg.number + 1]
        for line in (first, second):
            x = np.array(frame.x)
            point = np.array((line.through or {}).get(ONE, (0.0, 0.0, 0.0)))
            foot = np.array(leg.normal.end.get(ONE, (0.0, 0.0, 0.0)))
            size = 1 + np.abs(foot).max()
            if leg.number + 1 == len(walked.lines) - 1 and leg.normal.lie is Lie.SAME:
                continue  # the end's own x, perpendicular to its z
            assert abs(x @ np.array(line.direction)) < 1e-9
            normal = np.cross(x, np.array(line.direction))
            assert abs(normal @ (foot - point)) < 1e-9 * size


@row_by_row("name", TABLES)
def test_a_table_and_its_regrouped_table_are_one_motion_in_residues(name: str) -> None:
    """Standard to modified and back, whatever letters stand in it."""
    robot = load_robot(name)
    other = Convention.MODIFIED if robot.convention is Convention.STANDARD else Convention.STANDARD
    found = describe(robot, Asked(other.value))
    assert found.proof.kind == "exact"
    back = repaired(found.robot, robot.convention)
    assert back[1] == tuple(link.row for link in robot.links)
    assert (back[0], back[2]) == (robot.base, robot.tool)


def test_most_tables_need_neither_base_nor_tool_when_they_are_regrouped() -> None:
    """Counted over the library."""
    found = [
        describe(robot, Asked("modified" if robot.convention is Convention.STANDARD else "standard"))
        for robot in map(load_robot, TABLES)
    ]
    bare = [item for item in found if not item.robot.base and not item.robot.tool]
    assert (len(bare), len(found)) == (17, 23)


@row_by_row(("name", "form"), paired(JOINTED, ["standard", "modified"]))
def test_every_robot_of_the_library_is_described_in_every_form_with_its_letters(name: str, form: str) -> None:
    """Proved for all values, steps included."""
    robot = load_robot(name)
    found = describe(robot, Asked(form, steps=True))  # type: ignore[arg-type]
    assert found.proof.kind == "exact"
    assert found.robot.parameters == robot.parameters


@pytest.mark.parametrize("name", ["puma560", "stanford", "zhou-3r", "scara-yim", "puma560-standard", "articulated"])
def test_the_process_finds_the_table_of_the_book_cell_for_cell(name: str) -> None:
    """From nothing but the axes in the zero pose and the end frame."""
    robot = load_robot(name)
    found = describe(robot, Asked(robot.convention.value, steps=True, pose={}))  # type: ignore[arg-type]
    assert [link.row for link in found.robot.links] == [link.row for link in robot.links]
    assert found.robot.base == found.robot.tool == ()


@pytest.mark.parametrize(
    ("choices", "names"),
    [
        (Choices(next_d=True), ("cylindrical", "cylindrical-wrist")),
        (Choices(previous_x=True), ("ur5e",)),
        (
            Choices(),
            ("cartesian", "planar-2r", "puma560-unimation", "scara-zhou", "spherical-wrist", "zhou-3r-modified"),
        ),
    ],
)
def test_more_tables_come_out_cell_for_cell_where_the_choice_of_their_author_is_made(
    choices: Choices, names: tuple[str, ...]
) -> None:
    """Fifteen of twenty with those above, from the zero pose; the others have frames that a rule of their own puts."""
    for robot in map(load_robot, names):
        found = describe(robot, Asked(robot.convention.value, pose={}, choices=choices))  # type: ignore[arg-type]
        assert [link.row for link in found.robot.links] == [link.row for link in robot.links], robot.name
        assert found.proof.kind == "exact"


@row_by_row("seed", in_turn(range(20), 0, 2))
@row_by_row("choices", [Choices(next_d=True), Choices(previous_x=True), Choices(next_d=True, previous_x=True)])
def test_whatever_is_chosen_the_motion_is_the_same(seed: int, choices: Choices) -> None:
    """Against exponentials of the lines; and the choice shows in the table."""
    draw = random.Random(500 + seed)  # noqa: S311  the same arms every time
    drawing = nasty_arm(draw)
    walked = walk(drawing, choices)
    q = {line.name: draw.uniform(-3, 3) for line in drawing.lines}
    size = max(1.0, *(abs(foot) for leg in walked.legs for v in leg.normal.end.values() for foot in v))
    for convention in CONVENTIONS:
        found = np.array(fold(chain_of(walked, convention), Floats(q)))
        assert np.abs(found - end_by_screws(drawing, q)).max() <= 1e-13 * size * len(q)
    for leg in walked.legs[1:-1]:
        if choices.previous_x and leg.normal.lie is not Lie.SAME:
            assert dot(leg.normal.x, leg.before.x) >= -1e-12


ONE_A_ROW = [
    name
    for name in TABLES
    if name not in OPEN and all(link.row is not None for link in load_robot(name).links) and name != "panda"
]


@pytest.mark.parametrize("name", ONE_A_ROW)
def test_the_process_is_told_as_every_table_of_the_library_has_gone_it(name: str) -> None:
    """Cell for cell, whatever the pose in which it is drawn: every free choice is that of the table."""
    robot = load_robot(name)
    for pose in robot.poses.values():
        walked = retold(robot, dict(zip(robot.variables, pose, strict=True)))
        assert walked.rows(robot.convention) == tuple(link.row for link in robot.links)
        assert walked.base(robot.convention) == ()
        assert walked.tool(robot.convention) == ()


@pytest.mark.parametrize("name", ["panda", "scara", "dh-link"])
def test_a_table_with_a_row_without_a_joint_is_not_told(name: str) -> None:
    """Nor a product, nor where the twist is a letter."""
    with pytest.raises(RobotError):
        retold(load_robot(name))


@pytest.mark.parametrize("name", ["puma560", "scara", "stanford", "ur5e", "panda"])
def test_a_robot_drawn_in_any_pose_has_tables_that_are_the_same_motion(name: str) -> None:
    """A robot is drawn where it stands; offsets make up for it."""
    robot = load_robot(name)
    for pose in robot.poses:
        drawn = dict(zip(robot.variables, robot.poses[pose], strict=True))
        for form in ("standard", "modified"):
            found = describe(robot, Asked(form, pose=drawn))  # type: ignore[arg-type]
            assert found.proof.error <= 1e-13


def test_letters_that_decide_a_direction_are_refused_and_numbers_taken_where_there_are_some() -> None:
    """Two lengths across each other: the normal points along their diagonal."""
    robot = load_robot("planar-2r")
    drawing = drawing_of(robot.chain, robot.variables, known_values(robot))
    first = Line("theta1", (0.0, 0.0, 1.0), {})
    across = next(iter(drawing.lines[1].through or {}))
    both = {across: (1.0, 0.0, 0.0), ONE: (0.0, 0.25, 0.0)}
    with pytest.raises(LettersError, match="ratio"):
        walk(Drawing((first, Line("theta2", (0.0, 0.0, 1.0), both)), Frame(), {}))


def test_nearly_parallel_axes_are_warned_of() -> None:
    """A tilt of a thousandth of a degree, and the normal lies far away."""
    tilt = math.radians(1e-3)
    second = Line("q2", (0.0, math.sin(tilt), math.cos(tilt)), {ONE: (0.3, 0.4, 0.0)})
    walked = walk(Drawing((Line("q1", (0.0, 0.0, 1.0), {}), second), Frame(origin={ONE: (0.5, 0.0, 0.0)})))
    (warning,) = (warning for warning in walked.warnings if "q1 and q2" in warning)
    assert "are 0.001° from parallel" in warning
    assert "--straighten takes them as parallel" in warning


@pytest.mark.parametrize(("radians", "degrees"), [(math.pi / 2, 90), (-math.pi, 180), (math.pi / 6, 30), (0.1, None)])
def test_an_angle_is_in_degrees_where_they_say_it(radians: float, degrees: int | None) -> None:
    """Else it stays the float it is."""
    angle = exact_angle(radians)
    assert angle.constant() == pytest.approx(radians if degrees != 180 else math.pi, abs=1e-15)
    assert angle.degrees == (degrees or Fraction(0))
