"""Programs as Python functions: they say what columns say, and nothing that anybody wrote gets into them."""

from __future__ import annotations

import ast
import math
import re

import numpy as np
import pytest

from dhcli import load_robot
from dhcli.algebra.arithmetic import evaluate_settled
from dhcli.algebra.columns import Columns
from dhcli.algebra.compiled import FUNCTIONS, compiled, source
from dhcli.algebra.program import Instruction, Program, assemble
from dhcli.algebra.tape import Tape
from dhcli.kinematics.recorded import recorded_pose
from dhcli.kinematics.robot import Robot
from dhcli.notation.parser import parse
from tests.kinematics.arms import moving_robots, with_values
from tests.row_by_row import row_by_row


def program(*texts: str) -> Program:
    """What works out some expressions of a and b."""
    tape = Tape(["a", "b"], {"length": 6.0})
    return assemble(tape, [evaluate_settled(parse(text), tape) for text in texts])


TEXTS = (
    "a*b - 2", "-a - b", "2/b", "cos(2*a + 200°)", "sin(-b)", "tan(a)", "atan2(a, b)", "acos(a/9)", "asin(b/9)",
    "atan(a)", "sqrt(b)", "0", "length*a", "b", "a*b - 2",
)  # fmt: skip


def test_a_function_says_what_columns_say() -> None:
    """Every step there is, constants, a variable as it is, and the same number twice."""
    made = program(*TEXTS)
    play, columns = compiled(made), Columns(made, 1)
    for a, b in ((0.3, 0.7), (-2.5, 1e-3), (0.0, 4.0)):
        assert play([a, b]) == pytest.approx(columns.play(np.array([[a], [b]]))[:, 0], abs=1e-15)


def test_no_result_is_a_minus_zero() -> None:
    """It would be shown as -0 by whoever prints a float."""
    assert [math.copysign(1, x) for x in compiled(program("-a", "-a*b", "-sin(a)"))([0.0, 3.0])] == [1, 1, 1]


def test_a_step_without_a_value_raises_what_math_raises() -> None:
    """The caller then asks in the general way, which can say what is wrong."""
    with pytest.raises(ValueError, match="math domain error"):
        compiled(program("acos(a)"))([2.0, 0.0])
    with pytest.raises(ValueError, match="unpack"):
        compiled(program("a*b"))([2.0])


WRITTEN = re.compile(r"(r\d+|k\d+|k\d+=k\d+|q|[-+*/=(),:\[\]]|\s|def play|return|0\.0)*")


@row_by_row("name", moving_robots())
def test_a_function_is_made_of_register_numbers_alone(name: str) -> None:
    """Whatever a robot calls its joints and lengths: registers, signs and the functions of a fixed list."""
    robot = load_robot(name)
    robot = robot.copy(parameters=with_values(robot))
    text = source(recorded_pose(robot, "base", "tool").program(merged=False), {})
    for function in FUNCTIONS:
        text = re.sub(rf"\b{function}\b(={function})?", "", text)
    assert WRITTEN.fullmatch(text), text


def test_names_and_titles_of_a_robot_do_not_reach_the_function() -> None:
    """Names that are functions, keywords and registers in Python are only names of joints and lengths here."""
    rows = [{"alpha": 0, "a": "print", "d": "k0", "theta": "play"}, {"alpha": 0, "a": "r1", "d": "exec", "theta": 0}]
    robot = Robot.from_dh(
        rows, variables=["play", "exec"], parameters={"print": 0.5, "k0": 0.25, "r1": 2.0}, name="__import__('os')"
    )
    text = source(recorded_pose(robot, "0", "2").program(merged=False), {})
    names = {node.id for node in ast.walk(ast.parse(text)) if isinstance(node, ast.Name)}
    assert all(re.fullmatch(r"[rk]\d+|q", name) for name in names - FUNCTIONS.keys())
    assert not {"print", "exec", "__import__", "os"} & names


def test_what_is_no_step_or_no_register_is_never_written() -> None:
    """A program made by hand, with a text in the place of each."""
    for bad in (
        Instruction("__import__('os').system", (1, 0)),
        Instruction("add", ("__import__('os')", 1, 0)),  # type: ignore[arg-type]
    ):
        with pytest.raises((KeyError, ValueError)):
            compiled(Program(2, slice(1, 2), {}, (bad,)))


def test_a_function_sees_no_builtins() -> None:
    """All that it can call was handed to it."""
    play = compiled(recorded_pose(load_robot("scara"), "0", "3").program(merged=False))
    assert play.__globals__["__builtins__"] == {}  # type: ignore[attr-defined]
