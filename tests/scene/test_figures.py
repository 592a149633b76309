"""Figures of every robot and linkage of the library, and of robots that are odd."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace
from functools import cache
from itertools import cycle

import pytest

from dhcli import DhcliError, Robot, load_robot
from dhcli.errors import RobotError
from dhcli.files.yaml.linkages import load_linkage, read_linkage
from dhcli.mobility.linkage import Linkage
from dhcli.scene.camera import ViewError, read_view
from dhcli.scene.ink import CELL, LINE, Ink
from dhcli.scene.labels import PRINT, Rect
from dhcli.scene.linkages import caption_of, linkage_figure
from dhcli.scene.primitives import Drum
from dhcli.scene.shapes import Figure, Text
from dhcli.scene.staging import ArmAt, Paper, Staged, figure_of, foot
from dhcli.scene.words import spelled
from tests.nightly import NIGHT, in_turn, paired
from tests.scene.examples import LINKAGES, ROBOTS, long_robot, odd_robots


@cache
def _staged(name: str) -> Staged:
    return ArmAt(load_robot(name)).staged()


@cache
def _figure(name: str, pose: str | None = None, view: str | None = None) -> Figure:
    if name in LINKAGES:
        linkage = load_linkage(name)
        assert isinstance(linkage, Linkage)
        return linkage_figure(linkage)
    if pose is view is None:
        return figure_of(_staged(name))
    return figure_of(ArmAt(load_robot(name), pose=pose, view=read_view(view) if view else None).staged())


def _rect(text: Text) -> Rect:
    wide, high = PRINT.box(text.words)
    x, y = text.at[0], text.at[1] - 0.26 * text.size
    return Rect(x - wide / 2 + 1e-6, y - high / 2 + 1e-6, x + wide / 2 - 1e-6, y + high / 2 - 1e-6)


def _check(figure: Figure) -> None:
    """What holds for every figure."""
    assert figure.shapes
    for shape in figure.shapes:
        for x, y in shape.points:
            assert math.isfinite(x)
            assert math.isfinite(y)
            assert -1 <= x <= figure.width + 1, shape
            assert -1 <= y <= figure.height + 1, shape
    boxes = [_rect(text) for text in figure.texts if text.look != "caption"]
    assert not any(a.meets(b) for i, a in enumerate(boxes) for b in boxes[i + 1 :])
    low = figure.height - 34
    assert all(b.left >= 0 and b.right <= figure.width and b.top >= 0 and b.bottom <= low for b in boxes)


@pytest.mark.parametrize("name", [*ROBOTS, *LINKAGES])
def test_nothing_of_a_figure_leaves_its_paper_and_no_label_is_on_another(name: str) -> None:
    """Neither body nor line nor label; the caption is under all of them."""
    _check(_figure(name))


def test_hardly_a_label_stands_on_a_line() -> None:
    """At most 3 in 100, over all robots, some from other sides, and all linkages; at night at all poses from three."""
    labels = on_ink = 0
    for figure in _all():
        ink = Ink(figure.width, figure.height)
        ink.add([shape for shape in figure.shapes if shape.look != "leader"])
        for text in figure.texts:
            if text.look != "caption":
                rect = _rect(text)
                labels += 1
                on_ink += _has_line(ink, Rect(rect.left + 4, rect.top + 6, rect.right - 4, rect.bottom - 6))
    assert labels > 400
    assert on_ink <= 0.03 * labels


def _all() -> Iterator[Figure]:
    sides: list[tuple[str, str | None]] = [
        *((name, None) for name in ROBOTS),
        *zip(ROBOTS[::8], cycle(("iso", "front")), strict=False),
    ]
    for name, view in paired(ROBOTS, (None, "iso", "front")) if NIGHT else sides:
        for pose in load_robot(name).poses if NIGHT else (None,):
            yield _figure(name, pose, view)
    yield from map(_figure, LINKAGES)


def _has_line(ink: Ink, rect: Rect) -> bool:
    columns = range(max(0, int(rect.left / CELL)), min(ink.columns, int(rect.right / CELL) + 1))
    rows = range(max(0, int(rect.top / CELL)), min(ink.rows, int(rect.bottom / CELL) + 1))
    return any(ink.cells[j * ink.columns + i] == LINE for j in rows for i in columns)


@pytest.mark.parametrize("name", ROBOTS)
def test_every_frame_joint_and_length_has_its_label(name: str) -> None:
    """None is left out for want of room."""
    scene, figure = _staged(name).scene, _figure(name)
    written = [(text.look, text.words) for text in figure.texts if text.look != "caption"]
    for arrow in scene.arrows:
        assert (arrow.letter, arrow.words) in written
    for solid in scene.solids:
        assert not isinstance(solid, Drum) or ("turn", spelled(solid.name)) in written
    assert len(written) == len(scene.arrows) + len(scene.dimensions) + sum(isinstance(s, Drum) for s in scene.solids)


@pytest.mark.parametrize(("name", "view"), paired(list(odd_robots()), ("iso", "top", "0,-30")))
def test_an_odd_robot_is_drawn_all_the_same(name: str, view: str) -> None:
    """From every side, also where its lengths are nothing or far apart."""
    _check(figure_of(ArmAt(odd_robots()[name], view=read_view(view)).staged()))


def test_many_joints_are_drawn_with_all_their_labels() -> None:
    """Of fifty joints a hundred and fifty, none on another; by day of thirty."""
    count = 50 if NIGHT else 30
    figure = figure_of(ArmAt(long_robot(count), [0.3] * count, view=(37.0, 26.0)).staged())
    _check(figure)
    assert sum(text.look == "turn" for text in figure.texts) == count


def test_lengths_without_values_are_drawn_by_example_and_the_caption_says_so() -> None:
    """Nobody takes an example for the robot's own."""
    assert "example: a_i = 0.4 m" in ArmAt(load_robot("dh-link")).staged().caption
    assert "example" not in ArmAt(load_robot("puma560")).staged().caption


def test_a_caption_calls_joints_by_their_names_and_a_robot_once() -> None:
    """θ1 is short for theta1, and joint1 would be another name than joint_1."""
    robot = Robot.from_dh([(1, 0, 0, "joint_1"), (1, 0, 0, "theta2")], variables=["joint_1", "theta2"], name="two")
    assert ArmAt(robot, [0.5, 0]).staged().caption == "standard DH · joint_1 = 28.65°, θ2 = 0°"
    under = [text.words[0].text for text in figure_of(ArmAt(robot, [0.5, 0]).staged()).texts if text.look == "caption"]
    assert under[0].startswith("two · standard DH · ")


def test_a_figure_says_its_pose_convention_and_view() -> None:
    """By the pose's name, also where its values are typed."""
    caption = _figure("puma560").caption
    assert caption == "puma560 · modified DH · pose nominal · az 37°, el 18°"
    typed = ArmAt(load_robot("puma560"), "0, -45°, 0, 0, -45°, 0").staged().caption
    assert "pose nominal" in typed
    assert "θ2 = -40°" in ArmAt(load_robot("puma560"), "0, -40°, 0, 0, -45°, 0").staged().caption


@pytest.mark.parametrize("name", ["puma560", "planar-2r", "spherical-wrist"])
def test_a_worksheet_keeps_view_and_bodies_and_gives_no_frame_away(name: str) -> None:
    """Its bodies are those of the solution, at the same place; of labels there are the numbers of the joints."""
    robot = load_robot(name)
    staged = ArmAt(robot).staged()
    solution, sheet = figure_of(staged), figure_of(staged, worksheet=True)
    looks = {shape.look for shape in sheet.shapes}
    assert not looks & {"x", "z", "dim", "slide", "turn", "halo"}
    bodies = ("drum", "cap", "plate", "face")
    assert [s for s in sheet.shapes if s.look in bodies] == [s for s in solution.shapes if s.look in bodies]
    numbers = {text.words[0].text for text in sheet.texts if text.look == "number"}
    assert numbers == {str(robot.first + i) for i in range(len(robot.joints))}


def test_an_axis_towards_the_reader_is_a_dot_in_a_ring_and_one_away_a_cross() -> None:
    """A planar arm is seen from above, unless one asks for it from below."""
    above, below = _figure("planar-2r"), _figure("planar-2r", view="-90,-90")
    rings = [sum(shape.look == "z-ring" for shape in figure.shapes) for figure in (above, below)]
    assert rings == [3, 3]
    assert sum(shape.look == "z-head" for shape in above.shapes) == 3
    assert sum(shape.look == "z" for shape in below.shapes) == 6


def test_pins_keep_the_names_of_the_file_also_the_loose_ones() -> None:
    """P0 and Q4 of the scissor are the free ends of bars."""
    written = {"".join(run.text for run in text.words) for text in _figure("scissor").texts}
    assert {"P0", "Q4", "C3", "fall3"} <= written


def test_a_linkage_without_points_is_drawn_as_a_graph_and_says_so() -> None:
    """There is no geometry in it, but what ties what."""
    figure = _figure("six-r-arm")
    assert "no points are known" in figure.caption
    assert {"ground", "gripper"} <= {text.words[0].text for text in figure.texts}
    assert sum(text.words[0].text == "R" for text in figure.texts) == 6


def test_what_is_too_large_for_a_picture_is_refused_with_its_size() -> None:
    """Two hundred bars would be a blot."""
    bars = "\n".join(f"  b{i}: [P{i}, P{i + 1}]" for i in range(100))
    points = ", ".join(f"P{i}: [{i}, {i % 2}]" for i in range(101))
    text = f"format: 1\ntitle: T\nsource: S\nspace: planar\npoints: {{{points}}}\nbars:\n{bars}\nground: b0\n"
    linkage = read_linkage(text, "long.yaml", "long")
    assert isinstance(linkage, Linkage)
    with pytest.raises(DhcliError, match="long has 100 links, more than the 60"):
        linkage_figure(linkage)


@pytest.mark.parametrize("text", ["isometric", "30", "30,100", "a,b", "nan,0", "1,2,3", ""])
def test_a_view_that_does_not_exist_is_refused_with_those_that_do(text: str) -> None:
    """By name, or two angles of which the second is a height above the ground."""
    with pytest.raises(ViewError):
        read_view(text)


def test_values_and_a_pose_are_not_given_both() -> None:
    """One of the two would be silently dropped."""
    with pytest.raises(RobotError, match="two answers"):
        ArmAt(load_robot("scara"), [0, 0, 0], pose="pick").staged()
    with pytest.raises(RobotError, match="no pose called nowhere"):
        ArmAt(load_robot("scara"), pose="nowhere").staged()


@pytest.mark.nightly
@pytest.mark.parametrize("name", ROBOTS)
def test_every_pose_from_three_sides(name: str) -> None:
    """The same laws, and no crash."""
    for pose in load_robot(name).poses:
        for view in (None, "front", "128,20"):
            _check(_figure(name, pose, view))


def test_a_long_caption_stands_on_two_lines_and_loses_nothing() -> None:
    """It is broken between its parts; only what two lines cannot hold is cut."""
    parts = [
        "one part of it, which says more than most",
        "over it another arm: frame 6 is the first that differs",
        "and what is left",
    ]
    texts = foot("A title of some length", " · ".join(parts), Paper())
    lines = ["".join(run.text for run in text.words) for text in texts]
    assert len(lines) == 2
    assert " · ".join(lines) == " · ".join(("A title of some length", *parts))
    assert texts[0].at[1] < texts[1].at[1] < Paper().height
    (short,) = foot("A title", "", Paper())
    assert short.at == texts[1].at
    assert "".join(run.text for run in foot("word " * 200, "", Paper())[-1].words).endswith("…")


@pytest.mark.parametrize("name", in_turn([name for name in ROBOTS if load_robot(name).variables], 0, 2))
def test_no_number_of_an_axis_stands_in_the_hand(name: str) -> None:
    """Neither between the fingers nor on them: the axis goes on behind them."""
    figure = figure_of(_staged(name), worksheet=True)
    fingers = [point for shape in figure.shapes if shape.look == "hand" for point in shape.points]
    assert fingers
    xs, ys = zip(*fingers, strict=True)
    hand = Rect(min(xs), min(ys), max(xs), max(ys))
    for text in figure.texts:
        if text.look == "number":
            x, y = text.at[0], text.at[1] - 0.26 * text.size
            half = 0.3 * text.size  # of the digit itself
            assert not hand.meets(Rect(x - half, y - half, x + half, y + half)), text


def test_an_open_chain_without_points_goes_there_and_back_along_straight_lines() -> None:
    """No line crosses the sheet from the end of one row to the start of the next."""
    figure = _figure("six-r-arm")
    for shape in figure.shapes:
        if shape.look == "edge":
            (x1, y1), (x2, y2) = shape.points
            assert abs(x1 - x2) < 1e-6 or abs(y1 - y2) < 1e-6


def test_the_ground_that_is_a_plate_is_hatched_along_its_outer_side() -> None:
    """In the Hoberman ring between B1 and C0, away from the middle."""
    figure = _figure("hoberman")
    middle = figure.width / 2, (figure.height - 34) / 2
    strokes = [shape.points for shape in figure.shapes if shape.look == "hatch-line"]
    assert strokes
    assert all(math.dist(a, middle) < math.dist(b, middle) + 9 for a, b in strokes)
    pins = [
        (sum(x for x, _ in s.points) / len(s.points), sum(y for _, y in s.points) / len(s.points))
        for s in figure.shapes
        if s.look == "pin"
    ]
    assert (
        min(math.dist(a, middle) for a, _ in strokes) > sorted(math.dist(pin, middle) for pin in pins)[len(pins) // 2]
    )


def test_a_title_that_is_the_name_stands_once_below_a_linkage() -> None:
    """As it does below an arm."""
    bars = load_linkage("watt")
    assert isinstance(bars, Linkage)
    assert caption_of(bars).startswith(f"watt · {len(bars.links)} links, ")
    assert caption_of(replace(bars, title="watt")) == caption_of(bars).removeprefix("watt · ")
