from __future__ import annotations
def find_all(samples, loop, unknown, missing): return None
