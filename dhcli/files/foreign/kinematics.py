"""The kinematics file of a ROS description: where the frame of each joint stands, x y z roll pitch yaw.

Each joint turns about the z axis of its frame. Calibrations of Universal Robots are written so.
"""

from __future__ import annotations

import math
from collections.abc import Iterator

from dhcli.errors import FileError, Place, plural
from dhcli.files.urdf.model import Joint
from dhcli.files.urdf.robots import robot_of_joints
from dhcli.files.yaml.fields import Fields, Problems
from dhcli.files.yaml.placed import PlacedMapping, PlacedNode, read_yaml
from dhcli.kinematics.robot import Robot

KEYS = ("x", "y", "z", "roll", "pitch", "yaw")
_KINDS = {"R": "continuous", "P": "prismatic", "F": "fixed"}


def read_kinematics(text: str, source: str, name: str, joints: str, *, as_typed: bool) -> Robot:
    """A robot from a kinematics file.

    Args:
        text: The YAML.
        source: What it is called in errors.
        name: What the robot is called.
        joints: What each joint does: R turns about its z axis, as all do by default, P slides along it, F stands still.
        as_typed: Whether 1.5708 stays what it is, and is not taken as 90°.

    Raises:
        FileError: With all problems.
    """
    root = read_yaml(text, source, is_foreign=True)
    problems = Problems()
    found = list(_joints(problems, root))
    if not found:
        problems.add(
            Place(source), "names no joint", "write kinematics: {shoulder: {x: 0, y: 0, z: 0.1, roll: 0, ...}}"
        )
    letters = joints or "R" * len(found)
    if len(letters) != len(found) or set(letters) - _KINDS.keys():
        hint = "a letter for each: R turns, P slides, F stands still"
        problems.add(Place(source), f"{plural(len(found), 'joint')}, and --joints {joints}", hint)
    problems.raise_if_any(FileError)
    for joint, letter in zip(found, letters, strict=True):
        joint.kind = _KINDS[letter]
    return robot_of_joints(tuple(found), name, name, f"the kinematics file {source}", as_typed=as_typed)


def _joints(problems: Problems, root: PlacedNode) -> Iterator[Joint]:
    entries = {key.text: node for key, node in root.entries} if isinstance(root, PlacedMapping) else {}
    inner = entries.get("kinematics", root)
    before = "base"
    for key, node in inner.entries if isinstance(inner, PlacedMapping) else ():
        if not isinstance(node, PlacedMapping):
            continue  # hash: calib_123
        fields = problems.mapping(node, key.text, known=KEYS, required=KEYS)
        x, y, z, roll, pitch, yaw = (_number(fields, name) for name in KEYS)
        yield Joint(key.text, "", key.place, before, key.text, (x, y, z), (roll, pitch, yaw), ("0", "0", "1"))
        before = key.text


def _number(fields: Fields, key: str) -> str:
    """A plain number as it was typed."""
    scalar = fields.scalar(key)
    if scalar is None:
        return "0"
    try:
        value = float(scalar.text)
    except ValueError:
        value = math.nan
    if not math.isfinite(value) or "_" in scalar.text:
        fields.problems.add(scalar.place, f"{key}: {scalar.text!r:.60} is no number", "metres and radians")
        return "0"
    return scalar.text.strip()
