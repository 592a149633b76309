"""Names in generated code: never a keyword or a constant of the language, and read back as themselves."""

from __future__ import annotations

import ast
import keyword
from dataclasses import replace

import pytest
import sympy

from dhcli import load_robot
from dhcli.kinematics.robot import Robot
from dhcli.kinematics.validity import InvalidRobotError
from dhcli.notation.parser import parse
from dhcli.notation.scope import Scope
from dhcli.notation.styles import RESERVED, identifier
from dhcli.notation.tokens import is_name
from dhcli.notation.tree import Symbol, add
from dhcli.notation.writer import write
from tests.row_by_row import row_by_row

WORDS = ("is", "np", "E", "I", "end", "lambda", "None", "in_", "S", "for", "while", "eps", "a1", "l_x", "alpha_{i-1}")
STYLES = ("numpy", "sympy", "matlab")


@pytest.mark.parametrize("style", STYLES)
def test_no_name_in_code_is_a_keyword_or_constant(style: str) -> None:
    """Python compiles it, and sympy finds no constant in it."""
    names = [word for word in WORDS if is_name(word)]
    text = write(add(*map(Symbol, names)), style)
    assert not RESERVED[style] & set(text.replace("+", " ").split())
    if style != "matlab":
        tree = ast.parse(text, mode="eval")
        found = {node.id for node in ast.walk(tree) if isinstance(node, ast.Name)}
        assert len(found) == len(names)
        assert not any(map(keyword.iskeyword, found))


def test_sympy_takes_every_name_for_a_symbol() -> None:
    """`E` would be 2.718, and `I` imaginary."""
    for word in ("E", "I", "S", "lambda"):
        expr = sympy.sympify(identifier(word, "sympy"))
        assert expr == sympy.Symbol(identifier(word, "sympy"))


@row_by_row("style", STYLES)
@row_by_row("word", ["is", "np", "E", "I", "end", "lambda"])
def test_what_is_written_for_a_program_is_read_back(style: str, word: str) -> None:
    """The underscore belongs to the program, not to the name."""
    scope = Scope(lengths=(word, "a1"))
    expr = parse(f"a1 + 2*{word}", scope)
    assert parse(write(expr, style), scope) == expr


@row_by_row("name", ["elbow-joint", "a b", "1a", "a+b", "", "a.b", "_a", "a1;"])
def test_a_robot_refuses_names_that_are_none(name: str) -> None:
    """In words, from Python as from a file."""
    robot = load_robot("planar-2r")
    with pytest.raises(InvalidRobotError, match="is not a name"):
        replace(robot, parameters={**robot.parameters, name: None})
    assert isinstance(robot, Robot)
    assert not is_name(name)


@row_by_row("name", ["theta1", "θ_1", "\\theta_{1}", "l_x", "alpha_{i-1}", "shoulder", "d3", "a12"])
def test_names_of_formulas_are_names(name: str) -> None:
    """With indices of every kind."""
    assert is_name(name)
