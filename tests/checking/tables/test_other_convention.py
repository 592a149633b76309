"""A table that is right in the other convention is told so, wherever its last row ends, and `--why` says the same."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from dhcli.checking.judge import Judge
from dhcli.checking.kinds.made import question_about_table
from dhcli.checking.tables.cells import dh_table_text
from dhcli.checking.verdicts import Mark, Verdict
from dhcli.kinematics.conventions import NAMES as CONVENTIONS
from dhcli.kinematics.conventions import OTHER
from tests.checking.tables.robots_with_tables import NAMES, Rows, invariants, mutations, robot, rows_of
from tests.nightly import examples
from tests.row_by_row import row_by_row

WITH_JOINTS = tuple(name for name in NAMES if len(robot(name).variables) > 1)


def relabelled(name: str, rows: Rows | None = None) -> Mark:
    """The judgement of a robot's own rows, or of others, under the other convention, with the slip behind it."""
    arm = robot(name)
    exercise = question_about_table(arm, OTHER[arm.convention])
    text = dh_table_text(rows or rows_of(name), arm.columns, arm.writing)
    return Judge(exercise).check(exercise.parts[0], text)


@row_by_row("name", WITH_JOINTS)
def test_a_robots_own_rows_under_the_other_convention_are_recognised(name: str) -> None:
    """A last row with a length, or with a twist, is no reason to look for slips in its cells."""
    mark, arm = relabelled(name), robot(name)
    if mark.verdict.passed:  # all its twists and lengths lie where both conventions agree
        return
    other = OTHER[arm.convention]
    assert mark.remarks[0] == f"right for {CONVENTIONS[arm.convention]}; this exercise uses {other.value}"
    assert mark.diagnosis is not None
    assert mark.diagnosis.ids == ("convention",)
    assert mark.diagnosis.names == (
        f"the rows are those of {CONVENTIONS[arm.convention]}, and {other.value} was asked",
    )


@pytest.mark.parametrize("name", ["planar-2r", "articulated", "scara-zhou", "zhou-3r", "puma560", "panda"])
def test_some_robots_are_another_one_when_relabelled(name: str) -> None:
    """Else the test above would be about nothing."""
    assert relabelled(name).verdict is Verdict.WRONG


@examples(0.5)
@given(st.sampled_from(WITH_JOINTS), st.data())
def test_a_table_with_a_slip_is_called_right_elsewhere_only_if_its_axes_are(name: str, data: st.DataObject) -> None:
    """Distances and angles of neighbouring axes, by numpy alone, at general lengths."""
    arm = robot(name)
    _, rows = data.draw(st.sampled_from(mutations(rows_of(name), arm.variables)))
    exercise = question_about_table(arm, arm.convention)
    mark = Judge(exercise).mark(exercise.parts[0], dh_table_text(rows, arm.columns, arm.writing))
    if mark.remarks and mark.remarks[0].startswith("right for"):
        point = {n: 0.3 + 0.1 * k for k, n in enumerate((*arm.parameters, "b9"))}
        right = invariants(rows_of(name), arm.convention, arm.variables, point)
        assert np.allclose(right, invariants(rows, OTHER[arm.convention], arm.variables, point), atol=1e-5)
