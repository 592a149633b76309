"""Recording a tape, making a program of it, and playing it over columns."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhcli.algebra.arithmetic import evaluate_settled
from dhcli.algebra.columns import Columns
from dhcli.algebra.program import Program, assemble
from dhcli.algebra.tape import Tape
from dhcli.notation.angle import Angle
from dhcli.notation.parser import parse
from tests.row_by_row import row_by_row

if TYPE_CHECKING:
    from numpy.typing import NDArray


def program(*texts: str, variables: str = "a b", **known: Angle | float) -> Program:
    """A program that works out some expressions."""
    tape = Tape(variables.split(), known, tangents=True)
    return assemble(tape, [evaluate_settled(parse(text), tape) for text in texts])


def played(*texts: str, variables: str = "a b", known: dict[str, Angle | float] | None = None) -> NDArray[np.float64]:
    """Values of some expressions at a = -1, 0, 4 and b = 2, 3, 0.5."""
    columns = Columns(program(*texts, variables=variables, **(known or {})), 3)
    return columns.play(np.array([[-1.0, 0.0, 4.0], [2.0, 3.0, 0.5]]))


@row_by_row(
    ("text", "wanted"),
    [
        ("a", [-1, 0, 4]),
        ("-a", [1, 0, -4]),
        ("a - b", [-3, -3, 3.5]),
        ("b - a", [3, 3, -3.5]),
        ("-a - b", [-1, -3, -4.5]),
        ("a + 1", [0, 1, 5]),
        ("a - 2", [-3, -2, 2]),
        ("2 - a", [3, 2, -2]),
        ("-2 - a", [-1, -2, -6]),
        ("-3*a*b", [6, 0, -6]),
        ("(a - b)*(b - a)", [-9, -9, -12.25]),
        ("a^2/b", [0.5, 0, 32]),
        ("sqrt(a)", [math.nan, 0, 2]),
        ("acos(a)", [math.pi, math.pi / 2, math.nan]),
        ("atan2(a, 0)", [-math.pi / 2, 0, math.pi / 2]),
        ("tan(-a)", [math.tan(1), 0, -math.tan(4)]),
        ("π*length", [6 * math.pi] * 3),
        (
            "cos(2*a - b/2 + 200°)",
            [math.cos(2 * a - b / 2 + math.radians(200)) for a, b in ((-1, 2), (0, 3), (4, 0.5))],
        ),
        ("sin(a + twist)", [math.sin(a + math.pi / 6) for a in (-1, 0, 4)]),
        ("cos(twist)*a", [-math.sqrt(3) / 2, 0, 2 * math.sqrt(3)]),
    ],
)
def test_what_is_played_is_what_was_written(text: str, wanted: list[float]) -> None:
    """Signs, constants on either side, functions, and NaN without a warning where there is no value."""
    known: dict[str, Angle | float] = {"length": 6.0, "twist": Angle.in_degrees(30)}
    assert played(text, known=known)[0] == pytest.approx(np.array(wanted), nan_ok=True, abs=1e-15)


def test_what_is_shared_is_worked_out_once() -> None:
    """A product of two results, the cosines of an angle that differ by right angles, and nothing that no one wants."""
    assert [step.ufunc for step in program("a*b + 1", "b*a - 1").instructions] == ["multiply", "add", "subtract"]
    turns = program("cos(a)", "cos(a + 90°)", "sin(-a)", "sin(180° - a)")
    assert [step.ufunc for step in turns.instructions].count("tan") == 1
    assert "negative" not in [step.ufunc for step in program("a*b - cos(b)").instructions]


def test_a_column_is_not_the_constant_of_its_number() -> None:
    """Times 1.0 and 2.0 are other steps than times the columns 1 and 2."""
    both = played("a*b", "a*1.0", "(a*b)*a", "2.0*a")
    assert both[0] == pytest.approx([-2, 0, 2])
    assert both[1] == pytest.approx([-1, 0, 4])
    assert both[2] == pytest.approx([2, 0, 8])
    assert both[3] == pytest.approx([-2, 0, 8])


def test_registers_are_used_again() -> None:
    """A long sum needs no more than its results, its variables and what is open at a time."""
    long = program(*["+".join(f"cos({k}*a)*sin({k}*b)" for k in range(1, 20))])
    assert len(long.instructions) > 200
    assert long.registers < 10


def test_a_result_may_be_a_constant_a_variable_or_another_result() -> None:
    """Each has a column of its own all the same, also when the columns are played again."""
    columns = Columns(program("0", "b", "a", "a*b", "b*a", "-a*b"), 2)
    for a, b in ((2.0, 3.0), (5.0, 7.0)):
        assert columns.play(np.array([[a, 1.0], [b, 1.0]])).tolist() == [
            [0, 0], [b, 1], [a, 1], [a * b, 1], [a * b, 1], [-a * b, -1],
        ]  # fmt: skip
