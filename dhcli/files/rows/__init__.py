"""Rows of numbers in files of any length: CSV, JSON Lines and .npy, block by block."""

from __future__ import annotations

from dhcli.kinematics.placement import ORIENTATIONS

INDEX = "row"
"""What the column is called that says where in its file a row stood: dhcli writes it, and reads nothing from it."""

POSITION = ("p_x", "p_y", "p_z")
"""What the columns of a position are called."""

TURNS = {
    **{form: tuple(f"{form}_{k}" for k in (1, 2, 3)) for form in ORIENTATIONS},
    "rpy": ("roll", "pitch", "yaw"),
    "quaternion": ("q_w", "q_x", "q_y", "q_z"),
    "rotation-vector": ("r_x", "r_y", "r_z"),
    "axis-angle": ("axis_x", "axis_y", "axis_z", "angle"),
}
"""The columns of each way to say an orientation beside a position; angles in radians."""

MATRIX = tuple(head for i in (1, 2, 3) for head in (*(f"r{i}{k}" for k in (1, 2, 3)), f"p_{'xyz'[i - 1]}"))
"""The columns of a pose: three rows of three direction cosines and a length [m]."""
