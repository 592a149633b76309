"""What a part asks for, in words: the numbers in them are those that the marking means."""

from __future__ import annotations

from dhcli.checking.verdicts import Verdict
from dhcli.files.yaml.exercises import read_exercise
from tests.judging import mark
from tests.row_by_row import row_by_row


@row_by_row("unit", ["mm", "m", "none"])
@row_by_row(
    ("piece", "typed", "shown"),
    [
        ("point", "(0.2, 0, 0)", "(0.2, 0, 0)"),
        ("point", "(200, 0, 0)", "(200, 0, 0)"),
        ("vector", "(0.6, 0, 0.8)", "(0.6, 0, 0.8)"),
    ],
)
def test_points_and_vectors_are_shown_in_the_unit_in_which_the_answer_is_judged(
    piece: str, typed: str, shown: str, unit: str
) -> None:
    """Turned by half a turn, what is shown comes back with its sign changed; a direction has no unit."""
    exercise = read_exercise(
        f"""
        format: 1
        title: x
        source: x
        task: x
        numeric: true
        unit: {unit}
        tolerance: {{position: 0.00001}}
        parts:
          - {{id: turned, ask: '{piece} {typed} of product "Rot(z, 180°)"'}}
        """,
        "x.yaml",
        "x",
    )
    [part] = exercise.parts
    assert f"the {piece} {shown}" in part.question.describe(exercise)
    x, y, z = (float(number) for number in shown[1:-1].split(","))
    assert mark(exercise, part, f"{-x}, {-y}, {z}").verdict is Verdict.RIGHT
