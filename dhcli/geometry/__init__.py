"""Rigid motions and rotations, twists and ranks: geometry that knows no robot.

Motions run over any arithmetic; every form of a rotation is one class, for one rotation and for a column of many.
"""
