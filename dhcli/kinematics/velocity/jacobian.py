"""The Jacobian of a robot: columns of linear and angular velocity, over any kind of number."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TypeVar

from dhcli.algebra.arithmetic import Arithmetic, settled
from dhcli.kinematics.robot import Robot
from dhcli.kinematics.velocity.steps import Vector, fold_columns
from dhcli.kinematics.velocity.view import Part, View, joints_between, parts

N = TypeVar("N")


def columns_over(made: Sequence[Part], count: int, over: Arithmetic[N]) -> tuple[list[Vector[N]], list[Vector[N]]]:
    """Linear and angular velocity for each joint, three numbers each, structural integers kept."""
    linear: list[Vector[N]] = [[0, 0, 0] for _ in range(count)]
    angular: list[Vector[N]] = [[0, 0, 0] for _ in range(count)]
    for part in made:
        folded = fold_columns(part.steps, len(part.joints), over)
        for k, joint in enumerate(part.joints):
            linear[joint], angular[joint] = folded.linear[k], folded.angular[k]
    return linear, angular


def six_rows(made: Sequence[Part], count: int, over: Arithmetic[N]) -> tuple[tuple[N, ...], ...]:
    """Rows v above rows ω, shape (6, count)."""
    linear, angular = columns_over(made, count, over)
    return tuple(tuple(settled(vector[k], over) for vector in vectors) for vectors in (linear, angular) for k in range(3))
