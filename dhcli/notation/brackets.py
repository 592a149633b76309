"""Brackets: what opens and closes them, and how deep one is behind each."""

OPENING = {"(": ")", "[": "]", "{": "}"}
"""Brackets and what closes them."""

STEPS = {**dict.fromkeys(OPENING, 1), **dict.fromkeys(OPENING.values(), -1)}
"""How much deeper one is behind a bracket."""
