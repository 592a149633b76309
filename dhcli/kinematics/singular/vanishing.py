"""Points in residues at which chosen factors are zero, with everything else at random."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence

from dhcli.algebra.arithmetic import CannotHoldError
from dhcli.algebra.residues import STEPS, Field, Residues, random_below, random_field
from dhcli.kinematics.moves import Rot
from dhcli.kinematics.singular.arm import Arm, Point
from dhcli.kinematics.singular.modular import square_root
from dhcli.notation.angle import Angle
from dhcli.notation.tree import Expr, Trig
from dhcli.notation.walk import symbols, symbols_in

TRIES = 6
"""Random points at which a factor may have no root among residues, each a coin tossed."""


class Chosen(Residues):
    """Residues in which some names have a value that was chosen."""

    def __init__(self, angles: Iterable[Angle], field: Field | None = None) -> None:
        """Choose nothing yet."""
        super().__init__(angles=angles, field=field)

    def put_unit(self, name: str, unit: int) -> None:
        """Let an angle have a unit for its e^{iθ}."""
        root = unit
        if self._scale != 1:
            raise CannotHoldError
        self._units[name] = (root, self.field.inverse(root))

    def put_number(self, name: str, value: int) -> None:
        """Let a length have a value."""
        self._numbers[name] = value % self.field.prime

    def unit_of(self, angle: Angle) -> int:
        """e^{iφ} of an angle."""
        cos, sin = self.cos_sin(angle)
        return (cos + self.field.i * sin) % self.field.prime


FIELDS = 40
"""Fields in which the roots are looked for of a factor that is the same at every random point of one field.

Every other one has them: one factor in 10^12 goes without words.
"""


def fresh(arm: Arm, field: Field | None = None) -> Chosen:
    """A random point for an arm, in the field of the day or another one."""
    return Chosen((move.angle for move in arm.chain if isinstance(move, Rot)), field)


def here_and_elsewhere(arm: Arm, factors: Sequence[Expr], elsewhere: Point) -> tuple[Point, Point] | None:
    """An arm where factors are zero, and at a random point of the same field; None if no such point is found.

    Args:
        arm: The arm.
        factors: As in `vanishing`.
        elsewhere: The arm at a random point of some field.
    """
    alone = any(len(symbols(factor)) == 1 for factor in factors)  # nothing else of it is at random
    for tried in range(FIELDS if alone else 1):
        if tried:
            elsewhere = Point.of(arm, fresh(arm, random_field()))
        here = next(vanishing(arm, factors, elsewhere.field), None)
        if here is not None:
            return Point.of(arm, here), elsewhere
    return None


def vanishing(arm: Arm, factors: Sequence[Expr], field: Field | None = None) -> Iterator[Chosen]:
    """Points at which all the factors are zero, by each of their roots.

    Args:
        arm: The arm.
        factors: Sums, cosines, sines, or names of slides; simple ones are best given first.
        field: Where the points are; by default in the field of the day.

    Where a joint stands in fractions of its angle no such point is looked for.
    """
    for turn in range(4):
        try:
            over = _vanishing(arm, factors, turn, field)
        except CannotHoldError:
            return
        if over is not None:
            yield over


def _vanishing(arm: Arm, factors: Sequence[Expr], turn: int, field: Field | None) -> Chosen | None:
    for _ in range(TRIES):
        over = fresh(arm, field)
        if all(_solve(arm, over, factors, k, turn >> min(k, 1) & 1) for k in range(len(factors))) and not any(
            over.value(factor) for factor in factors
        ):
            return over
    return None


def _solve(arm: Arm, over: Chosen, factors: Sequence[Expr], which: int, turn: int) -> bool:
    """Choose the value of one name so that a factor is zero; those of factors before it stay as they are."""
    factor = factors[which]
    if not over.value(factor):
        return True
    fixed = symbols_in(factors[:which])
    later = symbols_in(factors[which + 1 :])
    free = sorted(symbols(factor) - fixed, key=lambda name: (name in later, name in arm.joints))
    joints = sorted(free, key=lambda name: (name in later, name not in arm.joints, name))
    if isinstance(factor, Trig):
        return any(_by_right_angle(over, factor, name, turn) for name in joints if name in arm.joints)
    lengths = [name for name in free if name not in arm.robot.angles]
    angles = [name for name in joints if name in arm.robot.angles]
    return any(_linear(over, factor, name) for name in lengths) or any(_by_unit(over, factor, n, turn) for n in angles)


def _by_right_angle(over: Chosen, factor: Trig, name: str, turn: int) -> bool:
    """A sine is zero at 0 and 180°, a cosine at 90° and -90°."""
    terms = dict(factor.angle.terms)
    if abs(terms[name]) != 1:
        return False
    field = over.field
    over.put_unit(name, 1)
    steps = (0 if factor.function == "sin" else STEPS // 4) + (STEPS // 2) * turn
    unit = field.root_of_unity(steps) * field.inverse(over.unit_of(factor.angle)) % field.prime
    over.put_unit(name, unit if terms[name] > 0 else field.inverse(unit))
    return _stays_chosen(over, factor, name)


def _linear(over: Chosen, factor: Expr, name: str) -> bool:
    """A length in which a factor is affine."""
    prime = over.field.prime
    over.put_number(name, 0)
    at_zero = over.value(factor)
    over.put_number(name, 1)
    slope = (over.value(factor) - at_zero) % prime
    if not slope:
        over.put_number(name, random_below(prime))
        return False
    over.put_number(name, -at_zero * over.field.inverse(slope))
    return over.value(factor) == 0


def _by_unit(over: Chosen, factor: Expr, name: str, turn: int) -> bool:
    """An angle that occurs once in every product: A·z + B/z + C = 0."""
    field, prime = over.field, over.field.prime
    seen = []
    for unit in (1, prime - 1, field.i):
        over.put_unit(name, unit)
        seen.append(over.value(factor))
    half = field.inverse(2)
    constant = (seen[0] + seen[1]) * half % prime
    cosine, sine = (seen[0] - constant) % prime, (seen[2] - constant) % prime
    a = (cosine - field.i * sine) * half % prime
    b = (cosine + field.i * sine) * half % prime
    root = square_root(constant * constant - 4 * a * b, field)
    if root is not None and a:
        root = -root if turn else root
        over.put_unit(name, (root - constant) * half % prime * field.inverse(a) % prime or 1)
    return _stays_chosen(over, factor, name)


def _stays_chosen(over: Chosen, factor: Expr, name: str) -> bool:
    """Whether a factor is zero now; else its angle is at random again, and not somewhere special for nothing."""
    if over.value(factor) == 0:
        return True
    over.put_unit(name, random_below(over.field.prime - 2) + 2)
    return False


def right_angles(arm: Arm, turns: Mapping[str, int]) -> Chosen:
    """A point at which some joints stand at multiples of a right angle."""
    over = fresh(arm)
    for name, quarters in turns.items():
        over.put_unit(name, over.field.root_of_unity(quarters * STEPS // 4))
    return over


def variables_of(factors: Iterable[Expr], joints: Collection[str]) -> tuple[str, ...]:
    """The joints that factors hold, in joint order."""
    held = symbols_in(factors)
    return tuple(name for name in joints if name in held)
