"""Whatever `dhcli new` writes: `dhcli lint` asks for what is left to write, and for nothing else.

Exercises about each robot of the library stand in tests/files/yaml/test_exercise_template.py.
"""

from __future__ import annotations

import json
from itertools import product
from pathlib import Path

import pytest

from dhcli import load_exercise, load_robot
from dhcli.checking.judge import Judge
from dhcli.kinematics.conventions import Convention
from tests.cli.running import Run
from tests.nightly import in_turn

LEFT = ("is empty", "still says 'write here")
"""What lint says of a blank."""
WORDS = [*("".join(word) for count in (1, 2, 3) for word in product("RP", repeat=count)), "RRRRRR", "RP" * 10]
URDF = """\
<robot name="two">
  <link name="base"/><link name="upper"/><link name="hand"/>
  <joint name="turn" type="revolute">
    <parent link="base"/><child link="upper"/><origin xyz="0 0 0.3" rpy="1.5707963 0 0"/><axis xyz="0 0 1"/>
    <limit lower="-2" upper="2" effort="1" velocity="1"/>
  </joint>
  <joint name="slide" type="prismatic">
    <parent link="upper"/><child link="hand"/><origin xyz="0.2 0 0"/><axis xyz="0 1 0"/>
    <limit lower="0" upper="0.5" effort="1" velocity="1"/>
  </joint>
</robot>
"""


def to_mend(dhcli: Run, path: Path) -> list[str]:
    """What lint finds in a file besides blanks."""
    found = dhcli("lint", str(path), "--format", "json").envelope["data"]["findings"]
    return [one["message"] for one in found if not any(blank in one["message"] for blank in LEFT)]


def fill_in(path: Path) -> None:
    """Put words in the blanks of an exercise, and in the test that is left empty its right answer."""
    text = path.read_text("utf-8").replace('""]', "look]").replace('title: ""', "title: x").replace("write here", "x")
    text = text.replace('source: ""', "source: x")
    blank = '  - {part: tip, answer: "", verdict: RIGHT}\n'
    assert blank in text
    path.write_text(text.replace(blank, ""), "utf-8")
    exercise = load_exercise(path)
    answer = Judge(exercise).expected(exercise.part("tip"))
    path.write_text(text.replace('answer: ""', f"answer: {json.dumps(answer)}"), "utf-8")


@pytest.mark.parametrize("convention", [convention.value for convention in Convention])
def test_a_robot_of_any_joints_in_any_convention(dhcli: Run, tmp_path: Path, convention: str) -> None:
    """Also in small letters."""
    for word in (*in_turn(WORDS, list(Convention).index(Convention(convention)), 3), "rrp"):
        written = dhcli("new", "robot", f"a-{word}", "--convention", convention, "--joints", word)
        assert written.code == 0, written.err
        assert to_mend(dhcli, tmp_path / f"robots/a-{word}.yaml") == []


@pytest.mark.parametrize("form", ["joints", "bars", "chain", "loop"])
def test_a_linkage_in_any_form(dhcli: Run, tmp_path: Path, form: str) -> None:
    """Written where it is found by its name."""
    assert dhcli("new", "linkage", "press", "--form", form).code == 0
    assert to_mend(dhcli, tmp_path / "robots/linkages/press.yaml") == []


@pytest.mark.parametrize("name", ["arms/two.urdf", "my arms/zwei größte.urdf", "[arms], {x}: y/#two.urdf", "~/~.urdf"])
@pytest.mark.parametrize("output", ["", "elsewhere/one.yaml", "-"])
def test_an_exercise_about_a_file(dhcli: Run, tmp_path: Path, name: str, output: str) -> None:
    """Whatever it is called, and wherever the exercise is written."""
    robot = tmp_path / name
    robot.parent.mkdir()
    (tmp_path / "elsewhere").mkdir()
    robot.write_text(URDF, "utf-8")
    done = dhcli("new", "exercise", "c/one", "--robot", name, *(["-o", output] if output else []))
    assert done.code == 0, done.err
    path = tmp_path / ("one.yaml" if output == "-" else output or "exercises/c/one.yaml")
    if output == "-":
        path.write_text(done.out, "utf-8")
    fill_in(path)
    assert to_mend(dhcli, path) == []


def test_an_exercise_about_the_robot_that_dhcli_brings_along(dhcli: Run, tmp_path: Path) -> None:
    """A robot of one's own may have the same name; it is another."""
    assert dhcli("new", "robot", "scara", "--joints", "RR").code == 0
    assert dhcli("new", "exercise", "c/one", "--robot", "builtin:scara").code == 0
    path = tmp_path / "exercises/c/one.yaml"
    fill_in(path)
    assert load_exercise(path).robot == load_robot("builtin:scara")
    assert to_mend(dhcli, path) == []


def test_an_exercise_cannot_name_a_robot_that_has_no_name(dhcli: Run, tmp_path: Path) -> None:
    """Standard input has none; nothing is written."""
    done = dhcli("new", "exercise", "c/one", "--robot", "-", stdin=URDF)
    assert (done.code, done.out) == (2, "")
    assert "standard input has no name" in done.err
    assert "save it: --robot ./arm.yaml" in done.err
    assert not list(tmp_path.iterdir())


def test_a_robot_with_two_tips_becomes_one_by_a_file_of_its_own(dhcli: Run, tmp_path: Path) -> None:
    """An exercise cannot choose between them; the hint has the command that does."""
    fork = URDF.replace("</robot>", '<link name="eye"/><joint name="see" type="fixed"><parent link="upper"/>')
    (tmp_path / "my fork.urdf").write_text(fork + '<child link="eye"/></joint></robot>', "utf-8")
    refused = dhcli("new", "exercise", "c/one", "--robot", "my fork.urdf")
    assert (refused.code, "has 2 tips" in refused.err) == (2, True)
    assert "dhcli new robot --from 'my fork.urdf' --tip hand makes a file of one" in refused.err
    assert dhcli("new", "robot", "fork", "--from", "my fork.urdf", "--tip", "hand").code == 0
    assert dhcli("new", "exercise", "c/one", "--robot", "fork").code == 0
    assert to_mend(dhcli, tmp_path / "exercises/c/one.yaml") == []


def test_a_robot_that_hides_one_of_dhcli_says_so(dhcli: Run) -> None:
    """Which can still be named."""
    done = dhcli("new", "robot", "scara", "--joints", "RR")
    assert (done.code, done.out) == (0, "")
    hides = "note: it hides the robot scara that dhcli brings along, which is builtin:scara now\n"
    assert done.err.endswith(f"next: dhcli show scara, then dhcli fk scara --symbolic\n{hides}")
    assert "RRP" in dhcli("show", "builtin:scara").out
    assert "hides" not in dhcli("new", "robot", "my-arm").err


@pytest.mark.parametrize(
    ("words", "taken"),
    [
        (("exercise", "my-course/panda", "--robot", "scara"), "panda is the name of the built-in robot panda, too"),
        (("robot", "bennett"), "bennett is the name of the built-in linkage bennett, too"),
        (("linkage", "planar-two-links"), "is the name of the built-in exercise yim/planar-two-links, too"),
        (("exercise", "my-course/mine", "--robot", "mine"), "mine is the name of the robot mine, too"),
    ],
)
def test_a_name_that_lint_would_refuse_is_refused_before_anything_is_written(
    dhcli: Run, tmp_path: Path, words: tuple[str, ...], taken: str
) -> None:
    """One name stands for one thing."""
    assert dhcli("new", "robot", "mine").code == 0
    before = sorted(tmp_path.rglob("*"))
    refused = dhcli("new", *words)
    assert refused.code == 2
    assert taken in refused.err
    assert sorted(tmp_path.rglob("*")) == before
