"""Consecutive rotations about parallel axes become one, before anything is multiplied.

This is why cosines meet `theta2 + theta3` here and never a product of four that would have to be contracted back.
`fold(merge(chain))` equals `fold(chain)`; only the form differs.
"""

from __future__ import annotations

from dhcli.algebra.arithmetic import times
from dhcli.algebra.terms import TERMS
from dhcli.kinematics.fold import fold, fold_rows
from dhcli.kinematics.moves import PLANES, Chain, Fixed, Move, Rot, Trans
from dhcli.notation.angle import Angle
from dhcli.notation.factors import AXES
from dhcli.notation.tree import ZERO, Expr, Number


def merge(chain: Chain) -> Chain:
    """Rewrite a chain so that each bundle of parallel joints turns once, by the sum of its angles.

    Two rotations belong together when the constant part B = [C | p] between them maps the second axis to plus or
    minus the first: `Rot(a, t1) B Rot(b, t2) = Trans(Rot(a, t1) p) Rot(a, t1 ± t2) C`. A translation behind the last
    rotation of a bundle stays where it is, so that it stays in its bracket.
    """
    merged: list[Move] = []
    for move in chain:
        if isinstance(move, Rot):
            if move.angle.is_zero:
                continue
            head = _partner(merged, move)
            if head is not None:
                _join(merged, head, move)
                continue
        merged.append(move)
    return tuple(merged)


def _partner(merged: list[Move], turn: Rot) -> int | None:
    """Index of the nearest rotation that a new one can be joined to, or None."""
    axis = _unit(turn)
    fallback = None
    for index in range(len(merged) - 1, -1, -1):
        move = merged[index]
        if isinstance(move, Trans):
            continue
        if isinstance(move, Rot) and abs(axis[AXES.index(move.axis)]) == 1 and _may_join(merged, index, turn):
            if move.angle.quarter_turns() is None:
                return index
            fallback = index
        turned = _turned(move, axis)
        if turned is None:
            break
        axis = turned
    return fallback


def _may_join(merged: list[Move], head: int, turn: Rot) -> bool:
    """Two joints always; a constant only if nothing between has to be turned by a joint for it."""
    moving = merged[head]
    if not isinstance(moving, Rot) or (turn.angle.names and (moving.angle.names or _is_plain(moving.angle))):
        return True
    if _is_plain(moving.angle):
        return True
    between = fold_rows(tuple(merged[head + 1 :]), TERMS)
    return all(between[k][3] == 0 for k in PLANES[moving.axis])


def _is_plain(angle: Angle) -> bool:
    return angle.quarter_turns() is not None


def _join(merged: list[Move], index: int, turn: Rot) -> None:
    """Put one rotation in the place of two, with what stood between them carried to the left."""
    head = merged[index]
    assert isinstance(head, Rot)  # noqa: S101  _partner returns rotations only
    between = tuple(merged[index + 1 :])
    rows = fold(between, TERMS)
    position = (rows[0][3], rows[1][3], rows[2][3])
    carried = fold((Rot(head.axis, head.angle), Trans(*position)), TERMS)
    sign = _sign(between, turn, head)
    total = head.angle + turn.angle * sign
    del merged[index:]
    offset = Trans(carried[0][3], carried[1][3], carried[2][3])
    if any(length != ZERO for length in offset.offset):
        merged.append(offset)
    merged.append(Rot(head.axis, total))
    merged.extend(constant for move in between if (constant := _without_offset(move)) is not None)


def _sign(between: Chain, turn: Rot, head: Rot) -> int:
    axis = _unit(turn)
    for move in reversed(between):
        turned = _turned(move, axis)
        assert turned is not None  # noqa: S101  _partner has walked the same way
        axis = turned
    return axis[AXES.index(head.axis)]


def _without_offset(move: Move) -> Move | None:
    """The rotation that a constant move leaves behind once its translation has been carried away."""
    if isinstance(move, Trans):
        return None
    if isinstance(move, Fixed):
        return Fixed(tuple((row[0], row[1], row[2], ZERO) for row in move.rows))
    return move


def _unit(turn: Rot) -> tuple[int, int, int]:
    x, y, z = (int(name == turn.axis) for name in AXES)
    return x, y, z


def _turned(move: Move, axis: tuple[int, int, int]) -> tuple[int, int, int] | None:
    """An axis seen from before a constant move, or None if it does not stay an axis exactly."""
    if isinstance(move, Trans):
        return axis
    rows = fold_rows((move,), TERMS)
    image: list[int] = []
    for row in rows:
        total = 0
        for entry, component in zip(row[:3], axis, strict=True):
            term = times(_structural(entry), component)
            if not isinstance(term, int):
                return None
            total += term
        image.append(total)
    return image[0], image[1], image[2]


def _structural(entry: Expr | int) -> Expr | int:
    if isinstance(entry, Number) and entry.value in (-1, 0, 1):
        return int(entry.value)
    return entry
