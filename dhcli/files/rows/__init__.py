"""Rows of numbers in files of any length: CSV, JSON Lines and .npy, block by block."""
