"""What somebody else's table or matrix says of an arm: its frames and the way through them, to be laid over the arm."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from dhcli.algebra.floats import Floats
from dhcli.frozen import frozen
from dhcli.geometry.vectors import Vector
from dhcli.kinematics.moves import Chain
from dhcli.scene.skeleton import Given, moved
from dhcli.scene.vectors import WORLD, Frame

CLOSE = 1e-6
"""How near frames of two tables in full precision are the same."""

Pairs = tuple[tuple[str, str], ...]
"""Names of frames of the arm, each with the frame of the other that should stand in its place."""


@frozen
class Traced:
    """Frames over an arm.

    Attributes:
        name: What they are called, such as the name of a file.
        frames: The frames by name, in the world of the arm.
        line: The way through them [m]; one point, or none, where only a frame is known.
        pairs: Which of them are compared with which frames of the arm, from the base on.
        wrong: The first that is known to be wrong, by other rules than where the arm has it.
        note: What a caption should say of a frame that differs.
        close: Frames nearer than this are the same: directions, and places in parts of the arm's reach.
    """

    name: str
    frames: tuple[tuple[str, Frame], ...]
    line: tuple[Vector, ...]
    pairs: Pairs
    note: str = ""
    close: float = CLOSE
    wrong: str | None = None


def traced(name: str, segments: Iterable[tuple[str, Chain]], given: Given, pairs: Pairs) -> Traced:
    """The frames that segments of moves lead to, one after the other from the base."""
    floats, frame = Floats(given), WORLD
    frames: list[tuple[str, Frame]] = []
    line: list[Vector] = [frame.origin]
    for ends_in, moves in segments:
        for move in moves:
            frame = moved(frame, move, floats)
            if frame.origin != line[-1]:
                line.append(frame.origin)
        frames.append((ends_in, frame))
    return Traced(name, tuple(frames), tuple(line), pairs)


def paired(ours: Sequence[str], theirs: Sequence[str], *, alike: bool) -> Pairs:
    """Which frames are compared: all in turn, or only the last of two tables whose frames stand elsewhere."""
    if alike and len(ours) == len(theirs):
        return tuple(zip(ours, theirs, strict=True))
    return ((ours[-1], theirs[-1]),) if ours and theirs else ()
