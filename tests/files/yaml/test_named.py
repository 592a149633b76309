"""What an exercise names in files of their own: where it is looked for, and how what is wrong in it is told."""

from __future__ import annotations

from pathlib import Path

import pytest

from dhcli.errors import FileError
from dhcli.files.yaml.exercises import load_exercise
from dhcli.mobility.linkage import Linkage
from tests.cli.running import run

ARM = """\
format: 1
title: An arm
source: a test
convention: standard
variables: [t1]
links:
  - {a: 1, alpha: 0, d: 0, theta: t1}
"""
TASK = """\
format: 1
title: A task
source: a test
robot: ROBOT
task: What is it?
parts:
  - {id: tip, ask: position of pose 0..1, hints: [look], credit: 1}
tests:
  - {part: tip, answer: "c1, s1, 0", verdict: RIGHT}
"""
COUNT = """\
format: 1
title: A count
source: a test
task: How many?
parts:
  - {id: m, ask: count mobility LINKAGE, hints: [count], credit: 1}
"""
PRESS = """\
format: 1
title: A press
source: a test
links: 4
ground: 1
joints:
  - {between: [1, 2], type: R}
"""


@pytest.fixture(autouse=True)
def here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """An empty folder to work in."""
    monkeypatch.chdir(tmp_path)
    return tmp_path


def put(path: str, text: str) -> Path:
    """A file in a folder that is made for it."""
    there = Path(path)
    there.parent.mkdir(parents=True, exist_ok=True)
    there.write_text(text, "utf-8")
    return there


def told(path: Path) -> list[str]:
    """The problems of an exercise that does not load."""
    with pytest.raises(FileError) as error:
        load_exercise(path)
    return [str(problem) for problem in error.value.problems]


def test_a_problem_in_the_file_of_a_robot_is_told_with_its_line_there_and_here() -> None:
    """Each at the line of the exercise that names it."""
    put("course/arm.yaml", ARM.replace("alpha: 0", "alpha: 9") + "colour: red\n")
    task = put("course/task.yaml", TASK.replace("ROBOT", "arm.yaml"))
    assert told(task) == [
        "course/task.yaml:4:8: robot: course/arm.yaml:7:19: alpha: the angle 9 has no unit (write 9° or 0.15708 rad)",
        "course/task.yaml:4:8: robot: course/arm.yaml:8:1: colour: unknown key (did you mean source?)",
    ]


def test_a_second_robot_is_told_of_in_the_same_way() -> None:
    """At its own line, and no line of its file is taken for one of the exercise."""
    put("arm.yaml", ARM)
    put("leg.yaml", ARM.replace("a: 1,", "a: 1 furlong,"))
    task = put("task.yaml", TASK.replace("ROBOT", "arm.yaml\nalso: {robot: leg.yaml, note: as right}"))
    (only,) = told(task)
    assert only.startswith("task.yaml:5:15: also: leg.yaml:7:")
    put("leg.yaml", ARM)
    assert load_exercise(task).also is not None


def test_lint_tells_both_places_to_people_and_to_programs() -> None:
    """The place of the finding is that in the file that was looked at."""
    put("arm.yaml", ARM.replace("alpha: 0", "alpha: 9"))
    put("task.yaml", TASK.replace("ROBOT", "arm.yaml\nalso: {robot: arm.yaml, note: as right}"))
    said = run("lint", "task.yaml")
    assert "task.yaml:4:8: error: robot: arm.yaml:7:19: alpha: the angle 9 has no unit\n" in said.out
    assert "task.yaml:5:15: error: also: arm.yaml:7:19: alpha: the angle 9 has no unit\n" in said.out
    findings = run("lint", "task.yaml", "--format", "json").envelope["data"]["findings"]
    places = [(one["source"], one["line"], one["message"]) for one in findings if "alpha" in one["message"]]
    assert places == [
        ("task.yaml", 4, "robot: arm.yaml:7:19: alpha: the angle 9 has no unit"),
        ("task.yaml", 5, "also: arm.yaml:7:19: alpha: the angle 9 has no unit"),
    ]


def test_the_path_of_a_linkage_begins_at_the_file_that_names_it_too() -> None:
    """And one of the course is found by its name from anywhere."""
    written = run("new", "linkage", "my-press", "-o", "-").out
    put("course/my-press.yaml", written)
    task = put("course/task.yaml", COUNT.replace("LINKAGE", "./my-press.yaml"))
    assert load_exercise(task).parts[0].question.linkage_counted is not None
    put("root/robots/linkages/my-press.yaml", written)
    put("root/robots/my-arm.yaml", ARM)
    for name in ("my-press", "my-arm"):
        inside = put(f"root/exercises/course/{name}.yaml", COUNT.replace("LINKAGE", name))
        assert isinstance(load_exercise(inside).parts[0].question.linkage_counted, Linkage)
    (missing,) = told(put("course/other.yaml", COUNT.replace("LINKAGE", "./leg.yaml")))
    assert missing.startswith("course/other.yaml:6:18: ask: course/leg.yaml: there is no such file")


def test_a_linkage_with_mistakes_is_told_with_the_line_in_its_file() -> None:
    """As a robot is."""
    put("press.yaml", PRESS.replace("type: R", "type: Q"))
    problems = told(put("task.yaml", COUNT.replace("LINKAGE", "press.yaml")))
    assert problems
    assert all(one.startswith("task.yaml:6:18: ask: press.yaml:") for one in problems)


@pytest.mark.parametrize(("text", "name"), [(TASK, "ROBOT"), (COUNT, "LINKAGE")])
def test_a_file_reads_nothing_from_standard_input(text: str, name: str) -> None:
    """Whoever grades a class types no robot."""
    text = text.replace("count mobility LINKAGE", "'count mobility -'").replace(name, "'-'")
    (only,) = told(put("task.yaml", text))
    assert "- is standard input, and a file names a file" in only


@pytest.mark.parametrize("text", [TASK.replace("ROBOT", "~/arm.yaml"), COUNT.replace("LINKAGE", "~/press.yaml")])
def test_a_home_that_is_not_expanded_is_told_with_what_to_write(text: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """A file is read by others too, whose home is another; variables are left alone."""
    monkeypatch.setenv("HOME", "/home/me")
    (only,) = told(put("course/task.yaml", text))
    assert "~ stays as it is here, write /home/me/" in only
    (only,) = told(put("course/task.yaml", text.replace("~/", "$HOME/")))
    assert "/home/me" not in only


def test_a_path_that_begins_in_the_course_is_told_with_the_name_that_is_found() -> None:
    """A path begins at the folder of the file; the robot is read all the same, and nothing follows."""
    put("robots/arm.yaml", ARM)
    path = put("exercises/course/task.yaml", TASK.replace("ROBOT", "robots/arm.yaml"))
    with pytest.raises(FileError) as caught:
        load_exercise(path)
    (problem,) = caught.value.problems
    assert problem.message == "robot: there is no file robots/arm.yaml here, where this file stands"
    assert problem.hint.startswith("write arm:")
