"""Forward kinematics for people who learn it, teach it or use it.

>>> from dhcli import load_robot, forward, symbolic
>>> scara = load_robot("scara")
>>> print(forward(scara, [0.3, 0.5, 0.1]))
0.6967  -0.7174  0  -0.2321
0.7174   0.6967  0   0.4259
     0        0  1      0.3
     0        0  0        1
>>> symbolic(scara).position
(-l2*s1 - l3*s12, l2*c1 + l3*c12, l1 - d3)
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from dhcli.checking.judge import check as check
    from dhcli.errors import DhcliError as DhcliError
    from dhcli.files.yaml.exercises import load_exercise as load_exercise
    from dhcli.files.yaml.robots import load_robot as load_robot
    from dhcli.geometry.many import axis_angles as axis_angles
    from dhcli.geometry.many import quaternions as quaternions
    from dhcli.geometry.many import roll_pitch_yaw as roll_pitch_yaw
    from dhcli.kinematics.batch import forward_batch as forward_batch
    from dhcli.kinematics.forward import forward as forward
    from dhcli.kinematics.forward import symbolic as symbolic
    from dhcli.kinematics.pose import Pose as Pose
    from dhcli.kinematics.robot import Robot as Robot
    from dhcli.kinematics.sweep.asked import sweep as sweep

__version__ = "0.1.0"

_HOMES = {
    "DhcliError": "dhcli.errors",
    "Pose": "dhcli.kinematics.pose",
    "Robot": "dhcli.kinematics.robot",
    "axis_angles": "dhcli.geometry.many",
    "check": "dhcli.checking.judge",
    "forward": "dhcli.kinematics.forward",
    "forward_batch": "dhcli.kinematics.batch",
    "load_exercise": "dhcli.files.yaml.exercises",
    "load_robot": "dhcli.files.yaml.robots",
    "quaternions": "dhcli.geometry.many",
    "roll_pitch_yaw": "dhcli.geometry.many",
    "sweep": "dhcli.kinematics.sweep.asked",
    "symbolic": "dhcli.kinematics.forward",
}

__all__ = [
    "DhcliError",
    "Pose",
    "Robot",
    "__version__",
    "axis_angles",
    "check",
    "forward",
    "forward_batch",
    "load_exercise",
    "load_robot",
    "quaternions",
    "roll_pitch_yaw",
    "sweep",
    "symbolic",
]


def __getattr__(name: str) -> object:
    """Import a public name when it is first asked for, so that `import dhcli` costs nothing."""
    if name not in _HOMES:
        raise AttributeError(f"module 'dhcli' has no attribute {name!r}")
    return getattr(import_module(_HOMES[name]), name)


def __dir__() -> list[str]:
    return sorted((*globals(), *_HOMES))
