"""Chains in which a rotation that is printed with a few decimals has become one."""

from __future__ import annotations

from dhcli.kinematics.moves import Chain, Fixed, Move


def sharpened(chain: Chain, remarks: list[str] | None) -> Chain:
    """A chain with the nearest rotations in the place of those that are printed with a few decimals.

    Args:
        chain: The moves; a matrix that is no rotation stays as it is.
        remarks: Where to say so; None leaves the chain as it is.
    """
    if remarks is None:
        return chain
    return tuple(_sharp(move, remarks) if isinstance(move, Fixed) else move for move in chain)


def _sharp(move: Fixed, remarks: list[str]) -> Move:
    from dhcli.geometry.orthonormal import not_a_rotation  # most robots have no literal matrix
    from dhcli.geometry.printed import sharp_rows

    if not_a_rotation(move.rows):
        return move
    rows, remark = sharp_rows(move.rows)
    if not remark:
        return move
    remarks.append(remark)
    return Fixed(tuple((row[0], row[1], row[2], row[3]) for row in rows))
