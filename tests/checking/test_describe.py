"""What a part asks for, in words: the numbers in them are those that the marking means."""

from __future__ import annotations

import pytest

from dhcli.checking.verdicts import Verdict
from dhcli.files.yaml.exercises import read_exercise
from tests.judging import mark


@pytest.mark.parametrize(("unit", "shown"), [("mm", "(200, 0, 0)"), ("m", "(0.2, 0, 0)"), ("none", "(0.2, 0, 0)")])
@pytest.mark.parametrize("piece", ["point", "vector"])
def test_points_and_vectors_are_shown_in_the_unit_in_which_the_answer_is_judged(
    piece: str, unit: str, shown: str
) -> None:
    """Turned by half a turn, what is shown comes back with its sign changed."""
    exercise = read_exercise(
        f"""
        format: 1
        title: x
        source: x
        task: x
        numeric: true
        unit: {unit}
        tolerance: {{position: 0.0001}}
        parts:
          - {{id: turned, ask: '{piece} (0.2, 0, 0) of product "Rot(z, 180°)"'}}
        """,
        "x.yaml",
        "x",
    )
    [part] = exercise.parts
    assert f"the {piece} {shown}" in part.question.describe(exercise)
    assert mark(exercise, part, f"-{shown[1:-1]}").verdict is Verdict.RIGHT
