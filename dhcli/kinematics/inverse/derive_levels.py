"""The equations of a derivation: the pose asked for, with links taken off at both ends, is what the others make."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property

from dhcli.frozen import frozen
from dhcli.kinematics.forward import textbook_form
from dhcli.kinematics.frames import between
from dhcli.kinematics.inverse.derive_terms import length
from dhcli.kinematics.moves import Chain, Fixed, Rot, angle_names, inverse
from dhcli.kinematics.robot import Robot
from dhcli.notation.tree import ZERO, Expr, Symbol, Trig, add, power
from dhcli.notation.walk import symbols, symbols_in, unknowns

POSITION = ("px", "py", "pz")
ROTATION = tuple(f"r{i}{j}" for i in "123" for j in "123")
"""Names of the entries of the pose asked for."""


@frozen
class Equation:
    """One equation.

    Attributes:
        level: The frames between which it compares, such as ("1", "6").
        entry: Row and column from 1; of squares that are added, the rows.
        left: What the pose asked for comes to.
        right: What the links between make of it.
        squared: Whether entries of the position are squared and added.
    """

    level: tuple[str, str]
    entry: tuple[int, ...]
    left: Expr
    right: Expr
    squared: bool = False

    @cached_property
    def unknowns(self) -> frozenset[Symbol | Trig]:
        """What may be unknown in it."""
        return unknowns(self.left, self.right)


def asked_pose() -> Fixed:
    """The pose asked for, in letters."""
    rows = ((*(Symbol(f"r{i}{j}") for j in (1, 2, 3)), Symbol(p)) for i, p in zip((1, 2, 3), POSITION, strict=True))
    return Fixed(tuple(rows))  # type: ignore[arg-type]


def entries(robot: Robot, start: str, end: str, *, place_only: bool) -> list[Equation]:
    """The entries of every level, those that say something, the shortest first."""
    frames = list(robot.frames[robot.frames.index(start) : robot.frames.index(end) + 1])
    found = []
    for a in range(len(frames)):
        for b in range(a + 1, len(frames)):
            low, high = frames[a], frames[b]
            left_chain = (*inverse(between(robot, start, low)), asked_pose(), *inverse(between(robot, high, end)))
            left, right = textbook_form(left_chain), textbook_form(between(robot, low, high))
            for i in range(3):
                for j in range(4):
                    one = Equation((low, high), (i + 1, j + 1), left[i][j], right[i][j])
                    if _says(one, robot, place_only=place_only):
                        found.append(one)
    return sorted(found, key=lambda one: length(one.left) + length(one.right))


def _says(one: Equation, robot: Robot, *, place_only: bool) -> bool:
    held = symbols(one.left) | symbols(one.right)
    if place_only and held.intersection(ROTATION):
        return False
    return bool(held.intersection(robot.variables)) and (one.left != one.right)


def squares(
    robot: Robot, start: str, end: str, *, place_only: bool
) -> Iterator[tuple[Equation, list[Expr], list[Expr]]]:
    """Positions seen from a joint that turns: their squares do not hold it.

    Yields:
        The equation to show, and the entries on the left and on the right that are squared and added.
    """
    frames = list(robot.frames[robot.frames.index(start) : robot.frames.index(end) + 1])
    whole = between(robot, start, end)
    ends_at = [len(between(robot, start, frame)) for frame in frames]
    for k, move in enumerate(whole):
        if not isinstance(move, Rot) or not angle_names((move,)).intersection(robot.variables):
            continue
        low = frames[max(i for i, at in enumerate(ends_at) if at <= k)]
        for high, stop in zip(frames, ends_at, strict=True):
            if stop <= k + 1:
                continue
            left = _position((*inverse(whole[:k]), asked_pose(), *inverse(whole[stop:])))
            right = _position(whole[k + 1 : stop])
            axis = "xyz".index(move.axis)
            for rows in ((0, 1, 2), tuple(i for i in range(3) if i != axis)):
                ls, rs = [left[i] for i in rows], [right[i] for i in rows]
                held = symbols_in((*ls, *rs))
                if place_only and held.intersection(ROTATION):
                    continue
                level = Equation((low, high), tuple(i + 1 for i in rows), _sum(ls), _sum(rs), squared=True)
                yield level, ls, rs


def _position(chain: Chain) -> list[Expr]:
    return [row[3] for row in textbook_form(chain)[:3]]


def _sum(parts: list[Expr]) -> Expr:
    return add(*(power(part, 2) for part in parts)) if parts else ZERO
