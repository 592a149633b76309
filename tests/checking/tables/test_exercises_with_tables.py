"""The exercises that ask for a table: the task fixes one motion, so that no flipped twist or shifted zero passes."""

from __future__ import annotations

from pathlib import Path

import pytest

from dhcli import load_exercise
from dhcli.checking.judge import Judge
from dhcli.checking.kinds.table import TableQuestion
from dhcli.checking.verdicts import Verdict
from tests.nightly import some

ROOT = Path(__file__).parents[3] / "exercises"
FREE = ("yim/dh-process",)
"""Where frames are to be chosen, so that the task fixes none."""
WITH_TABLES = sorted(
    name
    for path in ROOT.glob("*/*.yaml")
    if "ask: table " in path.read_text("utf-8") and (name := f"{path.parent.name}/{path.stem}") not in FREE
)
OF_FREEDOM = ("alpha-sign", "theta-sign", "offset-added", "offset-forgotten", "offset-sign")
"""Slips that may leave the same robot, counted or drawn otherwise."""


@pytest.mark.parametrize("name", WITH_TABLES)
def test_what_the_task_fixes_is_no_freedom(name: str) -> None:
    """Each twist the other way, each joint from another zero or in the other sense: WRONG, with its slip named."""
    judge = Judge(load_exercise(name))
    part = next(part for part in judge.exercise.parts if isinstance(part.question, TableQuestion))
    assert part.compare == "same-motion"
    slips = [slip.name for slip in judge.slips(part) if slip.name.startswith(OF_FREEDOM)]
    assert slips or name == "bajd/scara-as-dh-table"  # its robot is given as products
    for slip in some(slips, 9):
        mark = judge.check(part, judge.answer_with(part, slip))
        assert mark.verdict is Verdict.WRONG, slip
        assert mark.diagnosis is not None, slip
        assert slip in mark.diagnosis.ids, slip


def test_each_twist_of_the_puma_200_turned_round_is_wrong() -> None:
    """All four passed as the same robot."""
    judge = Judge(load_exercise("zhou/puma200-table"))
    part = judge.exercise.part("table")
    flipped = [slip.name for slip in judge.slips(part) if slip.name.startswith("alpha-sign ")]
    assert flipped == ["alpha-sign 2", "alpha-sign 4", "alpha-sign 5", "alpha-sign 6"]
    for slip in flipped:
        assert judge.mark(part, judge.answer_with(part, slip)).verdict is Verdict.WRONG
