"""The kinematics of robot arms for people who learn it, teach it or use it.

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
    from dhcli.files.library.entries import list_robots as list_robots
    from dhcli.files.yaml.exercises import load_exercise as load_exercise
    from dhcli.files.yaml.linkages import load_linkage as load_linkage
    from dhcli.files.yaml.robots import load_robot as load_robot
    from dhcli.geometry.many import axis_angles as axis_angles
    from dhcli.geometry.many import quaternions as quaternions
    from dhcli.geometry.many import roll_pitch_yaw as roll_pitch_yaw
    from dhcli.kinematics.batch import forward_batch as forward_batch
    from dhcli.kinematics.forward import forward as forward
    from dhcli.kinematics.forward import symbolic as symbolic
    from dhcli.kinematics.inverse.asked import inverse as inverse
    from dhcli.kinematics.inverse.batch import inverse_batch as inverse_batch
    from dhcli.kinematics.inverse.path import follow as follow
    from dhcli.kinematics.inverse.solutions import Solutions as Solutions
    from dhcli.kinematics.inverse.solutions import in_numbers as in_numbers
    from dhcli.kinematics.inverse.turns import limits_of as limits_of
    from dhcli.kinematics.motors import in_motors as in_motors
    from dhcli.kinematics.pose import Pose as Pose
    from dhcli.kinematics.robot import Robot as Robot
    from dhcli.kinematics.singular.finding import singularities as singularities
    from dhcli.kinematics.singular.result import Singularities as Singularities
    from dhcli.kinematics.sweep.asked import sweep as sweep
    from dhcli.kinematics.velocity.jacobian import Jacobian as Jacobian
    from dhcli.kinematics.velocity.many import jacobian as jacobian
    from dhcli.kinematics.velocity.many import symbolic_jacobian as symbolic_jacobian
    from dhcli.kinematics.velocity.measures import manipulability as manipulability
    from dhcli.kinematics.velocity.rates import Rates as Rates
    from dhcli.kinematics.velocity.rates import joint_rates as joint_rates
    from dhcli.kinematics.velocity.rates import velocity_of as velocity_of
    from dhcli.kinematics.velocity.statics import symbolic_torques as symbolic_torques
    from dhcli.kinematics.velocity.statics import torques as torques
    from dhcli.mobility.finding import mobility_of as mobility_of
    from dhcli.mobility.result import Mobility as Mobility
    from dhcli.render.pictures.picture import Picture as Picture
    from dhcli.render.pictures.picture import draw as draw

__version__ = "0.1.0"

_HOMES = {
    "DhcliError": "dhcli.errors",
    "Jacobian": "dhcli.kinematics.velocity.jacobian",
    "Mobility": "dhcli.mobility.result",
    "Picture": "dhcli.render.pictures.picture",
    "Pose": "dhcli.kinematics.pose",
    "Rates": "dhcli.kinematics.velocity.rates",
    "Robot": "dhcli.kinematics.robot",
    "Singularities": "dhcli.kinematics.singular.result",
    "Solutions": "dhcli.kinematics.inverse.solutions",
    "axis_angles": "dhcli.geometry.many",
    "check": "dhcli.checking.judge",
    "draw": "dhcli.render.pictures.picture",
    "follow": "dhcli.kinematics.inverse.path",
    "forward": "dhcli.kinematics.forward",
    "forward_batch": "dhcli.kinematics.batch",
    "inverse": "dhcli.kinematics.inverse.asked",
    "inverse_batch": "dhcli.kinematics.inverse.batch",
    "jacobian": "dhcli.kinematics.velocity.many",
    "joint_rates": "dhcli.kinematics.velocity.rates",
    "list_robots": "dhcli.files.library.entries",
    "load_exercise": "dhcli.files.yaml.exercises",
    "in_motors": "dhcli.kinematics.motors",
    "in_numbers": "dhcli.kinematics.inverse.solutions",
    "limits_of": "dhcli.kinematics.inverse.turns",
    "load_linkage": "dhcli.files.yaml.linkages",
    "load_robot": "dhcli.files.yaml.robots",
    "manipulability": "dhcli.kinematics.velocity.measures",
    "mobility_of": "dhcli.mobility.finding",
    "quaternions": "dhcli.geometry.many",
    "roll_pitch_yaw": "dhcli.geometry.many",
    "singularities": "dhcli.kinematics.singular.finding",
    "sweep": "dhcli.kinematics.sweep.asked",
    "symbolic": "dhcli.kinematics.forward",
    "symbolic_jacobian": "dhcli.kinematics.velocity.many",
    "symbolic_torques": "dhcli.kinematics.velocity.statics",
    "torques": "dhcli.kinematics.velocity.statics",
    "velocity_of": "dhcli.kinematics.velocity.rates",
}

__all__ = [
    "DhcliError",
    "Jacobian",
    "Mobility",
    "Picture",
    "Pose",
    "Rates",
    "Robot",
    "Singularities",
    "Solutions",
    "__version__",
    "axis_angles",
    "check",
    "draw",
    "follow",
    "forward",
    "forward_batch",
    "in_motors",
    "in_numbers",
    "inverse",
    "inverse_batch",
    "jacobian",
    "joint_rates",
    "limits_of",
    "list_robots",
    "load_exercise",
    "load_linkage",
    "load_robot",
    "manipulability",
    "mobility_of",
    "quaternions",
    "roll_pitch_yaw",
    "singularities",
    "sweep",
    "symbolic",
    "symbolic_jacobian",
    "symbolic_torques",
    "torques",
    "velocity_of",
]


def __getattr__(name: str) -> object:
    """Import a public name when it is first asked for, so that `import dhcli` costs nothing."""
    if name not in _HOMES:
        raise AttributeError(f"module 'dhcli' has no attribute {name!r}")
    return getattr(import_module(_HOMES[name]), name)


def __dir__() -> list[str]:
    return sorted((*globals(), *_HOMES))
