"""What may be given for a pose, and what is said of something else."""

from __future__ import annotations

import numpy as np
import pytest

from dhcli import inverse, load_robot
from dhcli.errors import RobotError


@pytest.mark.parametrize(("shape", "task"), [((3,), "position"), ((3, 3), "orientation")])
def test_numbers_of_another_task_are_told_its_name(shape: tuple[int, ...], task: str) -> None:
    """Three numbers are a position, nine cosines an orientation; a pose is both."""
    with pytest.raises(RobotError, match=f'task="{task}"'):
        inverse(load_robot("ur5e"), np.zeros(shape))
