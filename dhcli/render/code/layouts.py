"""What the columns of rows are called: of poses, of Jacobians, and of joint values."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace

from dhcli.files.rows import INDEX as _INDEX
from dhcli.files.rows import MATRIX, POSITION, TURNS
from dhcli.geometry.euler import AXES
from dhcli.kinematics.frames import View
from dhcli.kinematics.placement import FORMS
from dhcli.kinematics.pose import matrix_name
from dhcli.render.code.matrices import variable
from dhcli.render.code.rows import Group, Layout

_ROW = "[%s, %s, %s, %s]"

GROUPS = {
    "matrix": Group("matrix", MATRIX, f"[{_ROW}, {_ROW}, {_ROW}, [0.0, 0.0, 0.0, 1.0]]"),
    "position": Group.listed("position", POSITION),
    "rpy": Group("rpy", TURNS["rpy"], '{"roll": %s, "pitch": %s, "yaw": %s}'),
    "quaternion": Group("quaternion", TURNS["quaternion"], '{"w": %s, "x": %s, "y": %s, "z": %s}'),
    "rotation-vector": Group.listed("rotation-vector", TURNS["rotation-vector"]),
    **{form: Group.listed(form, TURNS[form]) for form in FORMS if form.endswith(AXES)},
    "axis-angle": Group("axis-angle", TURNS["axis-angle"], '{"axis": [%s, %s, %s], "angle": %s}'),
}
"""The numbers of each way to say a pose; JSON nests them as `--format json` does for one pose. Angles in radians."""


INDEX = Group(_INDEX, (_INDEX,), "%s", is_whole=True)
"""Where the joint values stand in their file."""


def pose_layout(forms: Sequence[str], views: Iterable[View], *, index: bool) -> Layout:
    """The columns for poses.

    Args:
        forms: The ways in which each pose is said.
        views: Each pose in a row, if there is more than one in it.
        index: Whether the first column says where the joint values stand.
    """
    said = tuple(_unlike(GROUPS[form], forms) for form in forms)
    keys = [variable(matrix_name(view.reference, view.frame)) for view in views]
    groups = tuple(Group.within(key, said) for key in keys) or said
    if index:
        return Layout((INDEX, *groups))
    width = (4, 4) if forms == ("matrix",) else (sum(len(group.heads) for group in said),)
    return Layout(groups, (len(keys), *width) if keys else width)


def jacobian_layout(labels: Sequence[str], joints: Sequence[str], *, index: bool) -> Layout:
    """The columns of Jacobians: row by row, `v_x_theta1`, `v_x_theta2`; JSON Lines nests them.

    Args:
        labels: What the rows of each are called.
        joints: What its columns are called.
        index: Whether the first column says where the joint values stand.
    """
    heads = tuple(f"{label.replace('ω', 'w')}_{joint}".replace("'", "") for label in labels for joint in joints)
    row = f"[{', '.join(['%s'] * len(joints))}]"
    group = Group("matrix", heads, f"[{', '.join([row] * len(labels))}]")
    return Layout((INDEX, group)) if index else Layout((group,), (len(labels), len(joints)))


def joint_layout(joints: Iterable[str]) -> Layout:
    """The columns of joint values that reach poses, behind where each pose stands."""
    return Layout((INDEX, _joints(joints)))


def point_layout(joints: Iterable[str]) -> Layout:
    """The columns of the points of a grid: every joint, then the position."""
    return Layout((_joints(joints), GROUPS["position"]))


def _joints(names: Iterable[str]) -> Group:
    return Group.named("q", {name: name for name in names})


def _unlike(group: Group, forms: Sequence[str]) -> Group:
    """A group whose columns are called like no others: beside a matrix, `p_x` of the position is `position_p_x`."""
    if group.key == "position" and "matrix" in forms:
        return replace(group, heads=tuple(f"position_{head}" for head in group.heads))
    return group
