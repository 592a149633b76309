"""The robots of the library whose variables move several rows: what needs an axis for each of them is not for these."""

from __future__ import annotations

from dhcli import list_robots, load_robot
from dhcli.kinematics.coupling import is_coupled

COUPLED = tuple(name for name in list_robots() if is_coupled(load_robot(name)))
