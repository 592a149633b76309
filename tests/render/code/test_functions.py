"""Functions as code: what they give is what `forward` and `jacobian` give, in every language."""

from __future__ import annotations

import random
import re
from collections.abc import Iterator
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from dhcli import forward, jacobian, list_robots, load_robot
from dhcli.cli.shell import written
from dhcli.kinematics.frames import View
from dhcli.kinematics.generated import Function, forward_function, jacobian_function
from dhcli.kinematics.robot import Robot
from dhcli.kinematics.values import joint_values
from dhcli.kinematics.velocity.form import GEOMETRIC, Form
from dhcli.kinematics.velocity.view import MotionView
from dhcli.render.code.functions import function_code
from dhcli.render.code.language import RESERVED
from dhcli.render.code.languages import LANGUAGES
from dhcli.render.look import Look
from tests.nightly import in_turn
from tests.render.code.running import HERE, Call, namespace, results

NEAR = 1e-14


def code(function: Function, language: str) -> str:
    """The file."""
    return function_code(function, Look(language))


@cache
def lengths(robot: Robot) -> dict[str, float]:
    """A value for each length that has none."""
    return {name: 0.1 + 0.05 * k for k, (name, value) in enumerate(robot.parameters.items()) if value is None}


def drawn(robot: Robot, seed: int = 3) -> dict[str, float]:
    """Joint values, the same every time."""
    draw = random.Random(seed)  # noqa: S311  a fixed seed
    return {j.name: draw.uniform(-3, 3) if j.kind == "revolute" else draw.uniform(0.1, 0.9) for j in robot.joints}


def arguments(function: Function, q: dict[str, float]) -> list[float]:
    """What the function takes, in its order: lengths without a value before those with one."""
    ordered = sorted(function.lengths, key=lambda name: function.lengths[name] is not None)
    own = {**function.lengths, **lengths(function.robot)}
    return [*(q[name] for name in function.joints), *(float(own[name] or 0) for name in ordered)]


def cases(language: str) -> Iterator[tuple[Call, Any, str]]:
    """Calls of every robot's pose and Jacobian, with what they should give; by day in every other language."""
    for name in in_turn(list_robots(), HERE.index(language), 2):
        robot = load_robot(name)
        q, given_lengths = drawn(robot), lengths(robot)
        pose = forward_function(robot, View.of(robot), {})
        yield (
            Call(code(pose, language), "forward", arguments(pose, q), (4, 4)),
            forward(robot, q, parameters=given_lengths).matrix,
            name,
        )
        if robot.variables:
            moving = jacobian_function(robot, MotionView.of(robot), GEOMETRIC, {})
            shape = (6, len(moving.moving))
            yield (
                Call(code(moving, language), "jacobian", arguments(moving, q), shape),
                jacobian(robot, q, parameters=given_lengths),
                name,
            )


@pytest.mark.parametrize("language", HERE)
def test_every_robot_is_computed_as_dhcli_computes_it(language: str, tmp_path: Path) -> None:
    """Pose and Jacobian, lengths as arguments."""
    calls, wanted, names = zip(*cases(language), strict=True)
    for name, found, right in zip(names, results(language, calls, tmp_path), wanted, strict=True):
        assert np.abs(np.array(found) - right).max() <= NEAR, name


def in_python(text: str) -> str:
    """A function in MATLAB or Julia as one in Python: its lines, and its matrix row by row."""
    lines = ["from math import *"]
    for line in text.replace("^", "**").splitlines():
        bare = line.strip()
        if found := re.fullmatch(r"function (?:\w = )?(\w+)\((.*)\)", bare):
            lines.append(f"def {found[1]}({found[2]}):")
        elif bare.startswith("if nargin"):
            continue
        elif bare in ("return [", "T = [", "J = ["):
            lines.append("  M = []")
        elif re.fullmatch(r".*\d\.0 .*|\(.*|.*\)", bare) and " = " not in bare and ";" not in bare:
            cells = re.findall(r"\([^()]*(?:\([^()]*\)[^()]*)*\)|\S+", bare)
            lines.append(f"  M.append([{', '.join(cells)}])")
        elif bare.endswith((";", "];")) and " = " not in bare:
            lines.append(f"  M.append([{bare.rstrip('];')}])")
        elif " = " in bare:
            lines.append(f"  {bare.rstrip(';')}")
    return "\n".join([*lines, "  return M"])


@pytest.mark.parametrize("language", ["matlab", "julia"])
def test_formulas_for_languages_that_are_not_here_are_the_same(language: str) -> None:
    """Read line by line as Python; the rules of each language are its own."""
    robot = load_robot("puma560")
    function = forward_function(robot, View.of(robot), {})
    q = drawn(robot)
    found = namespace(in_python(code(function, language)))["forward"](*arguments(function, q))
    assert np.abs(np.array(found) - forward(robot, q).matrix).max() <= NEAR


def test_numpy_takes_arrays_of_joint_values() -> None:
    """Of any shape, beside single numbers."""
    robot = load_robot("puma560")
    function = namespace(code(forward_function(robot, View.of(robot), {}), "numpy"))["forward"]
    turns = np.linspace(-1, 1, 6).reshape(2, 3)
    found = function(turns, 0.1, 0.2, turns, 0.4, 0.5)
    assert found.shape == (2, 3, 4, 4)
    assert np.abs(found[1, 2] - forward(robot, [1.0, 0.1, 0.2, 1.0, 0.4, 0.5]).matrix).max() <= NEAR


def test_puma_takes_75_operations_and_12_cosines_and_sines() -> None:
    """Where a matrix written entry by entry has 141 and 118."""
    robot = load_robot("puma560")
    function = forward_function(robot, View.of(robot), {})
    assert function.operations <= 75
    assert function.turns == 12
    text = code(function, "python")
    assert text.count("math.") == 12
    assert len(re.findall(r"[*/]| [+-] ", text.partition('"""\n')[2])) == function.operations


def test_named_parts_are_used_more_than_once_or_are_cosines() -> None:
    """Nothing has a name that is said once only."""
    function = jacobian_function(load_robot("panda"), MotionView.of(load_robot("panda")), GEOMETRIC, {})
    text = code(function, "python")
    for one in function.formulas.definitions:
        uses = len(re.findall(rf"\b{one.name}\b", text)) - 1
        assert uses > 1 or (uses == 1 and one.name[0] in "cs")


@given(q=st.lists(st.floats(-10, 10), min_size=6, max_size=6))
def test_values_put_in_are_constants(q: list[float]) -> None:
    """Lengths as numbers, and two joints that stand still: the others stay arguments, in their order."""
    robot = load_robot("stanford")
    held = joint_values(robot, {"theta1": 0.25, "d3": 0.5})
    function = forward_function(robot, View.of(robot), held, with_values=True)
    assert function.joints == ("theta2", "theta4", "theta5", "theta6")
    assert not function.lengths
    found = namespace(code(function, "python"))["forward"](q[1], *q[3:])
    wanted = forward(robot, [0.25, q[1], 0.5, *q[3:]])
    assert np.abs(np.array(found) - wanted.matrix).max() <= 1e-13


@pytest.mark.parametrize(
    ("viewing", "form"),
    [
        ({"axes": 3}, GEOMETRIC),
        ({"axes": 6}, Form(angular_first=True)),
        ({"place": 0}, Form(angular_first=True)),
        ({"point": (0.1, 0.0, 0.2)}, Form("linear")),
        ({}, Form(analytic="rpy")),
        ({}, Form(analytic="zyz")),
    ],
)
def test_a_jacobian_of_any_form_is_a_function(viewing: dict[str, Any], form: Form) -> None:
    """Along other axes, of another point, with rates of angles."""
    robot = load_robot("puma560")
    view = MotionView.of(robot, **viewing)
    function = jacobian_function(robot, view, form, {})
    q = drawn(robot, 8)
    found = namespace(code(function, "python"))["jacobian"](*arguments(function, q))
    wanted = jacobian(robot, q, part=form.part, angular_first=form.angular_first, analytic=form.analytic, **viewing)
    assert np.abs(np.array(found) - wanted).max() <= 1e-13


def test_a_view_from_the_end_is_a_function() -> None:
    """The inverse matrix between two frames takes the joints between them."""
    robot = load_robot("puma560")
    function = forward_function(robot, View.of(robot, 1, 3, inverse=True), {})
    assert function.joints == ("theta2", "theta3")
    found = namespace(code(function, "python"))["forward"](0.4, -0.7)
    wanted = forward(robot, [0, 0.4, -0.7, 0, 0, 0], start=3, end=1).matrix
    assert np.abs(np.array(found) - wanted).max() <= NEAR


WORDS = ("int", "lambda", "T", "t1", "Math", "np", "double", "q12", "nargin", "end", "E", "math", "let", "j0", "pow")


@pytest.mark.parametrize("language", HERE)
def test_no_name_is_a_word_of_the_language(language: str, tmp_path: Path) -> None:
    """A length that is called as a keyword, a module, a function, the result or a part of the formulas."""
    calls = []
    for word in WORDS:
        rows = [(word, 0, 0, "theta1"), ("a_{i-1}", "90°", 0, "theta2")]
        robot = Robot.from_dh(rows, variables=["theta1", "theta2"], parameters={word: 0.4, "a_{i-1}": 0.3})
        text = code(forward_function(robot, View.of(robot), {}), language)
        calls.append(Call(text, "forward", [0.3, 0.9, 0.4, 0.3], (4, 4)))
    wanted = forward(robot, [0.3, 0.9]).matrix
    for word, found in zip(WORDS, results(language, calls, tmp_path), strict=True):
        assert np.abs(np.array(found) - wanted).max() <= NEAR, word


@pytest.mark.parametrize("language", LANGUAGES)
def test_each_name_has_a_spelling_of_its_own(language: str) -> None:
    """Two that would be spelled alike, Greek letters, and every word that is kept."""
    names = ["a_{1}", "a_1", "θ", "theta", "alpha_{i-1}", *RESERVED[language]]
    spelled = LANGUAGES[language].spelling(names).names
    assert len(set(spelled.values())) == len(names)
    assert all(re.fullmatch(r"[A-Za-z_]\w*", name, re.ASCII) for name in spelled.values())
    assert not set(spelled.values()) & RESERVED[language]


def test_what_somebody_wrote_stays_in_the_comment() -> None:
    """A title with line ends and quotes ends no comment of any language."""
    robot = replace(load_robot("planar-2r"), title='x"""\nimport os\n*/ end', source="\\u000aimport os\u2028import os")
    function = forward_function(robot, View.of(robot), {})
    for language in LANGUAGES:
        for line in code(function, language).splitlines():
            assert not line.strip().startswith(("import os", "*/", "end x"))
    found = namespace(code(function, "python"))["forward"](0.0, 0.0)
    assert found[0][3] == pytest.approx(0.7)


@pytest.mark.parametrize("end", ["\\", "\\ ", "\\\n", "??/"])
def test_a_comment_of_c_does_not_go_on_in_the_next_line(end: str) -> None:
    """Behind a backslash, also where C99 spells it so, the head of the function would be part of the comment."""
    robot = replace(load_robot("planar-2r"), source=f"notes{end}")
    lines = code(forward_function(robot, View.of(robot), {}), "c").splitlines()
    assert any(line.startswith("// Source: notes") for line in lines)
    assert not [line for line in lines if line.rstrip().endswith(("\\", "??/"))]


@pytest.mark.parametrize("language", ["python", "numpy"])
def test_nothing_is_imported_that_is_not_used(language: str) -> None:
    """As by a pose of numbers alone, which has no cosine left."""
    for name in ("assembly-blocks", "scara"):
        robot = load_robot(name)
        source = code(forward_function(robot, View.of(robot), {}), language)
        used = {"python": "math", "numpy": "np"}[language]
        assert (f"{used}." in source) == bool(re.search(rf"^import .*\b{used}$", source, re.MULTILINE))
        assert namespace(source)["forward"](*[0.1] * len(robot.variables)) is not None


def test_the_command_knows_every_language() -> None:
    """Its list and that of the writers are one."""
    assert set(written.LANGUAGES) == set(LANGUAGES)
