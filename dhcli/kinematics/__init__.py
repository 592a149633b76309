"""Robots, their chains of moves, and the poses that follow.

After loading, every robot is a chain of elementary moves; nothing asks any more which convention it came from.
"""
