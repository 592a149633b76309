"""A pose put together from the options for its position and its turn."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from dhcli.cli.shell.given import point_of
from dhcli.cli.shell.typed_digits import Rows, slack_of
from dhcli.errors import DhcliError, Place, Problem, UnknownNameError, plural
from dhcli.geometry.euler import EulerAngles, Order, RollPitchYaw, euler
from dhcli.geometry.rotations import Quaternion
from dhcli.geometry.vectors import ORIGIN, UNITS, facing
from dhcli.kinematics.derived import in_floats
from dhcli.notation.brackets import split
from dhcli.notation.dimensions import read_at
from dhcli.notation.parser import parse
from dhcli.notation.quantity import Bare, has_angle_unit, to_angle
from dhcli.notation.scope import Scope
from dhcli.notation.tree import Expr
from dhcli.regex import regex

if TYPE_CHECKING:
    from dhcli.geometry.rotations import Rotation

_NEARLY_ONE = 1e-2
"""A quaternion this near to length 1 is one whose digits were cut off; others are given to a scale of their own."""

_FINE = regex(r"\s*[-+]?[0-9]*\.[0-9]{3,}\s*")
"""A number without a unit, with three decimals or more."""

_IN_NUMBERS = "a pose to reach is in numbers; --derive gives the formulas in letters"


def from_parts(parts: Mapping[str, str], bare: Bare) -> tuple[Rows, float]:
    """A pose, shape (4, 4) [m], and by how much the digits typed leave an entry open.

    Args:
        parts: What was typed of `position`, `rpy`, `quaternion`, `euler` and `pointing`.
        bare: What a number without a unit is, where an angle is wanted.

    Raises:
        DhcliError: The turn is given twice, or something cannot be read.
    """
    rows = _rows(parts, bare)
    return rows, slack_of(parts, rows, lambda texts: _rows(texts, bare), rough=_is_rough(parts, bare))


def _rows(parts: Mapping[str, str], bare: Bare) -> Rows:
    if len(parts.keys() - {"position"}) > 1:
        raise DhcliError("the orientation is given in two ways", "one of --rpy, --quaternion, --euler or --pointing")
    place = _vector(parts["position"], "--position") if "position" in parts else ORIGIN
    turn: Rotation[float] = UNITS
    if "rpy" in parts:
        turn = RollPitchYaw(*_angles(parts["rpy"], "--rpy", bare)).rotation()
    elif "quaternion" in parts:
        q = _numbers(parts["quaternion"], "--quaternion", 4)
        size = math.hypot(*q)
        turn = Quaternion(*(part / size for part in q)).rotation()
    elif "euler" in parts:
        order, _, angles = parts["euler"].strip().partition(" ")
        turn = EulerAngles(_order(order), _angles(angles, "--euler", bare)).rotation()
    elif "pointing" in parts:
        turn = facing(_numbers(parts["pointing"], "--pointing", 3))
    return (*((*row, length) for row, length in zip(turn, place, strict=True)), (0.0, 0.0, 0.0, 1.0))


def _is_rough(parts: Mapping[str, str], bare: Bare) -> bool:
    """Whether the turn tells that its numbers are rounded.

    A quaternion has a length of 1 to few digits only; hardly any angle has three decimals in radians and no more.
    """
    if (quaternion := parts.get("quaternion")) is not None:
        return 0 < abs(math.hypot(*_numbers(quaternion, "--quaternion", 4)) - 1) < _NEARLY_ONE
    angles = [*split(parts.get("rpy", "")), *split(parts.get("euler", "").strip().partition(" ")[2])]
    return bare == "rad" and any(_FINE.fullmatch(angle) for _, angle in angles)


def _vector(text: str, option: str) -> tuple[float, float, float]:
    x, y, z = (in_floats(part) for part in known(point_of(text, option), Place(option)))
    return x, y, z


def known(parts: Sequence[Expr], place: Place) -> Sequence[Expr]:
    """Expressions of a pose, in which no letter may be left.

    Raises:
        DhcliError: One has no value.
    """
    from dhcli.notation.walk import symbols_in

    if free := sorted(symbols_in(parts)):
        raise DhcliError(Problem(f"{', '.join(free)} has no value", place, _IN_NUMBERS))
    return parts


def _angles(text: str, option: str, bare: Bare) -> tuple[float, float, float]:
    pieces = list(split(text))
    if len(pieces) != 3:  # noqa: PLR2004
        hint = "write --euler 'zyz 0,30°,90°'" if option == "--euler" else "write 0,90°,0"
        raise DhcliError(Problem(f"three angles are wanted, not {len(pieces)}", Place(option), hint))
    exprs = [parse(piece, Scope(), Place(option)) for _, piece in pieces]
    a, b, c = (read_at(Place(option), to_angle, expr, bare=bare).constant() for expr in exprs)
    for expr, angle in zip(exprs, (a, b, c), strict=True):
        if bare == "rad" and not has_angle_unit(expr) and abs(angle) > 2 * math.pi:
            hint = f"write {angle:g}°, or --deg"
            raise DhcliError(Problem(f"{angle:g} rad is more than a turn", Place(option), hint))
    return a, b, c


def _numbers(text: str, option: str, count: int) -> tuple[float, ...]:
    pieces = [piece for _, piece in split(text)]
    if len(pieces) != count:
        message = f"{plural(count, 'number')} are wanted, not {len(pieces)}"
        raise DhcliError(Problem(message, Place(option)))
    values = tuple(in_floats(part) for part in known([parse(p, Scope(), Place(option)) for p in pieces], Place(option)))
    if not any(values):
        raise DhcliError(Problem("it has no length", Place(option), "one of its numbers must not be 0"))
    return values


def _order(name: str) -> Order:
    """An order of three axes as it was typed, `zyz` or `fixed-xyz`."""
    try:
        return euler(name.removeprefix("fixed-"), fixed=name.startswith("fixed-"))
    except UnknownNameError as error:
        problem = error.problems[0]
        hint = f"write --euler 'zyz 0,30°,90°', or fixed-zyz; {problem.hint}"
        raise UnknownNameError(Problem(problem.message, Place("--euler"), hint)) from None
