"""Rows of numbers in files of any length: CSV, JSON Lines and .npy, block by block."""

INDEX = "row"
"""What the column is called that says where in its file a row stood: dhcli writes it, and reads nothing from it."""

POSITION = ("p_x", "p_y", "p_z")
"""What the columns of a position are called."""
