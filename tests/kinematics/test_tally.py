"""What is said once about many rows."""

import numpy as np
import pytest

from dhcli import load_robot
from dhcli.errors import plural
from dhcli.kinematics.tally import Tally

RADIANS = (True,) * 6


def test_good_rows_need_no_word() -> None:
    """Nothing is said, of no row at all too."""
    tally = Tally(load_robot("puma560"))
    tally.take(np.zeros((0, 6)), RADIANS)
    tally.take(np.zeros((5, 6)), RADIANS)
    assert list(tally.warnings()) == []


def test_rows_outside_the_limits_are_counted_over_all_blocks() -> None:
    """Each row once, however many joints are outside; and each joint by itself."""
    tally = Tally(load_robot("puma560"))
    for block in ([[3, 0, 0, 0, 0, 0], [3, 2, 0, 0, 0, 0]], [[0, 0, 0, 0, 0, 0], [0, 2, 0, 0, 0, 0]]):
        tally.take(np.array(block, dtype=float), RADIANS)
    assert list(tally.warnings()) == ["3 of 4 rows outside the limits of a joint: theta1 in 2, theta2 in 2"]


@pytest.mark.parametrize("count", [1, 63, 64, 65, 200])
def test_one_row_outside_is_found_wherever_it_stands(count: int) -> None:
    """Below and above, in the first row, in the last, and behind the last that is full of others."""
    for row in {0, count // 2, count // 64 * 64 - 1, count - 1}:
        q = np.zeros((count, 6))
        q[row, 0], q[row, 5] = -3, 300
        tally = Tally(load_robot("puma560"))
        tally.take(q, (False,) * 6)
        said = f"1 of {plural(count, 'row')} outside the limits of a joint: theta1 in 1, theta6 in 1"
        assert list(tally.warnings()) == [said]


def test_degrees_taken_for_radians_are_asked_about() -> None:
    """But not where the column says degrees."""
    for in_radians, said in ((RADIANS, 1), ((False,) * 6, 0)):
        tally = Tally(load_robot("puma560"))
        tally.take(np.full((2, 6), 90.0), in_radians)
        assert sum("did you mean degrees" in warning for warning in tally.warnings()) == said
