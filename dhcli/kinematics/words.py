"""An orientation in plain words, where it is plain; a file of its own because every numeric pose is shown with it."""

from __future__ import annotations

from dhcli.kinematics.pose import Pose

TINY = 1e-9
"""How far a direction cosine may be from 1 for an axis to lie along another."""


def in_words(pose: Pose[float]) -> tuple[str, ...]:
    """Axes that point along an axis of the reference: `x' points along +y`; empty where none does."""
    said = []
    for k, name in enumerate("xyz"):
        column = [row[k] for row in pose.rotation]
        for value, along in zip(column, "xyz", strict=True):
            if abs(abs(value) - 1) < TINY:
                said.append(f"{name}' points along {'+' if value > 0 else '-'}{along}")
    return tuple(said)
