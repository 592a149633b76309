"""`singular when`: the factors that make a Jacobian lose rank, in any order and up to constants."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import ClassVar, Self

from dhcli.algebra.equality import equal
from dhcli.checking.diagnosis.result import Slip
from dhcli.checking.exercise import Case, Causes, Exercise, Question, Reading, Shown
from dhcli.checking.motion.asked import Motion
from dhcli.checking.motion.task import found_for, read_task, square
from dhcli.checking.pasted import UnreadableError
from dhcli.checking.verdicts import Mark, Verdict
from dhcli.errors import NotationError, Place
from dhcli.kinematics.robot import Robot
from dhcli.kinematics.velocity.form import GEOMETRIC, Form
from dhcli.notation.angle import Angle
from dhcli.notation.parser import parse
from dhcli.notation.quantity import DimensionError, to_angle, to_length
from dhcli.notation.scope import Scope
from dhcli.notation.tree import Expr, Number, Power, Product, Symbol, Trig, add, multiply, negate
from dhcli.notation.trig import cosine, sine
from dhcli.notation.walk import substitute, symbols, walk
from dhcli.notation.writer import write, write_angle

_BETWEEN = re.compile(r"[,;\n]|\bor\b|\band\b")
HALF_TURN, TURN = 180, 360
LONGEST = 2000

Factors = tuple[Expr, ...]
"""What is zero at a singular pose, each alone."""


@dataclass(frozen=True, slots=True)
class Typed:
    """Factors as typed.

    Attributes:
        factors: What is zero, each alone; products taken apart.
        half: Joints of which one of two angles was given: the factor that vanishes at both.
    """

    factors: Factors
    half: Factors = ()


@dataclass(frozen=True, slots=True)
class SingularQuestion(Question[Typed]):
    """Where a Jacobian loses rank: the factors of its determinant that joints can make zero.

    Attributes:
        motion: Of which frame and point.
        form: All rows, or those of v or ω.
    """

    motion: Motion
    form: Form = GEOMETRIC

    words: ClassVar = ("singular",)
    examples: ClassVar = ("singular when linear of 0..3", "singular when 0..6")

    @classmethod
    def asked(cls, text: str, scope: Scope, place: Place | None) -> Self:
        """`singular when jacobian linear of 0..3`."""
        return cls(*read_task("singular when", text, scope, place))

    def check(self, robot: Robot | None) -> None:
        square(*self.motion.check(robot), self.form)

    @property
    def needs_table(self) -> bool:
        return True

    @property
    def has_cosines(self) -> bool:
        return True

    def describe(self, exercise: Exercise) -> str:
        rows = ", ".join(square(*self.motion.check(exercise.robot), self.form).rows)
        return f"when the Jacobian {self.motion.where}, rows {rows}, is singular: what is zero, each alone"

    def notes(self, _exercise: Exercise) -> Iterable[str]:
        yield "What is zero, with commas between: s1 = 0, a1 + a2*c2 = 0. Or theta1 = 0 or 180°."

    def expected(self, case: Case, style: str = "short") -> str:
        return self._text(case, self._right(case), style)

    def _text(self, case: Case, factors: Factors, style: str = "short") -> str:
        return ", ".join(f"{write(factor, style, case.exercise.writing)} = 0" for factor in factors) or "never"

    def _right(self, case: Case) -> Factors:
        return tuple(factor.zeros[0] for factor in found_for(case, self.motion, self.form).factors)

    def steps(self, case: Case) -> Iterable[Shown]:
        found, exercise = found_for(case, self.motion, self.form), case.exercise
        if found.determinant is not None:
            yield Shown(f"The determinant is {write(found.determinant, 'short', exercise.writing)}")
        for factor in found.factors:
            said = factor.text("short", exercise.writing) + (f": {factor.angles}" if factor.angles else "")
            lines = [said + (f"; {factor.words}" if factor.words else "")]
            if factor.lost:
                lines.append(f"what is lost there: {factor.lost}")
            yield Shown("\n".join(lines))

    def read(self, case: Case, text: str, place: Place | None = None) -> Typed:
        if len(text) > LONGEST:
            raise UnreadableError(f"an answer of more than {LONGEST} characters is not read")
        if text.strip().lower() in ("never", "nowhere"):
            return Typed(())
        found: list[Expr] = []
        angles, last = _Angles(), ""
        pieces = [piece.strip() for piece in _BETWEEN.split(text.strip().strip("{}[]")) if piece.strip()]
        if len(pieces) == 1 and pieces[0].count("=") > 1:
            raise UnreadableError("write each condition by itself, with a comma between")
        for piece in pieces:
            left, sign, right = (part.strip() for part in piece.partition("="))
            if not sign and last and _is_constant(left):  # theta3 = 0 or 180°
                left, sign, right = last, "=", left
            last = left if sign else ""
            one = self._piece(case, (left, right if sign else "0"), angles, place)
            found += one
        return Typed((*found, *angles.whole), tuple(angles.half))

    def _piece(self, case: Case, sides: tuple[str, str], angles: _Angles, place: Place | None) -> Sequence[Expr]:
        exercise, where = case.exercise, place or Place("answer")
        left, right = (parse(side, exercise.scope, where) for side in sides)
        named = symbols(left)
        joints = (
            frozenset(exercise.robot.angles) & frozenset(exercise.robot.variables) if exercise.robot else frozenset()
        )
        if named and named <= joints and not _has_trig(left):
            try:
                angles.take(to_angle(left) - to_angle(right, bare="deg"))
            except DimensionError as error:
                raise UnreadableError(error.message) from None
            return ()
        try:
            return _apart(add(to_length(left), negate(to_length(right))), exercise)
        except DimensionError as error:
            raise UnreadableError(error.message) from None

    def mark(self, case: Case, reading: Reading[Typed]) -> Mark:
        wanted = self._right(case)
        named = [factor for factor in wanted if any(_alike(factor, one, case) for one in reading.value.factors)]
        wrong = [one for one in reading.value.factors if not any(_alike(factor, one, case) for factor in wanted)]
        half = [one for one in reading.value.half if not any(_alike(one, other, case) for other in named)]
        text = self._text(case, (*reading.value.factors, *reading.value.half))
        is_right = len(named) == len(wanted) and not wrong and not half
        remarks = [f"{len(named)} of {len(wanted)} are right"] if not is_right else []
        if wrong:
            shown = ", ".join(write(one, "short", case.exercise.writing) for one in wrong)
            remarks.append(f"the rank does not fall where {shown} is zero")
        if half:
            remarks.append("one more angle belongs to each of those given: half a turn on")
        earned = max(0, len(named) - len(wrong)) / (len(wanted) or 1)
        verdict = Verdict.RIGHT if is_right else Verdict.WRONG
        return Mark(verdict, text, (), tuple(remarks), 1.0 if is_right else min(earned, 0.99), self._text(case, wanted))

    # --- Mistakes -----------------------------------------------------------------------------------------------

    def slips(self, case: Case) -> Iterable[Slip]:
        return (slip for slip, _ in self._wrong(case))

    def answer_with(self, case: Case, name: str) -> str | None:
        for slip, typed in self._wrong(case):
            if slip.name == name:
                angles = [
                    f"{write_angle(one.angle, 'short', case.exercise.writing)} = 0"
                    for one in typed.half
                    if isinstance(one, Trig)
                ]
                return ", ".join(filter(None, (self._text(case, typed.factors) if typed.factors else "", *angles)))
        return None

    def causes(self, case: Case, reading: Reading[Typed]) -> Causes:
        return tuple((slip,) for slip, typed in self._wrong(case) if self._same(case, typed, reading.value))

    def _same(self, case: Case, one: Typed, other: Typed) -> bool:
        return all(
            len(a) == len(b) and all(any(_alike(x, y, case) for y in b) for x in a)
            for a, b in ((one.factors, other.factors), (one.half, other.half))
        )

    def _wrong(self, case: Case) -> Iterator[tuple[Slip, Typed]]:
        right, writing = self._right(case), case.exercise.writing
        for k, factor in enumerate(right):
            text = write(factor, "short", writing)
            others = (*right[:k], *right[k + 1 :])
            if others:
                slip = Slip(
                    f"factor-forgotten {text}", f"{text} = 0 is missing", "go through the factors of the determinant"
                )
                yield slip, Typed(others)
            if isinstance(factor, Trig):
                words = f"{text} = 0 has two solutions in a turn, half a turn apart"
                yield Slip(f"half {text}", words, "where else is it zero?"), Typed(others, (factor,))
                other = cosine(factor.angle) if factor.function == "sin" else sine(factor.angle)
                slip = Slip(f"sin-cos {text}", f"sine and cosine have changed places in {text}", "draw the arm there")
                yield slip, Typed((*others, other))


class _Angles:
    """Angles that were given one by one; two that are half a turn apart make a factor."""

    def __init__(self) -> None:
        self._seen: dict[Expr, set[Fraction]] = {}

    def take(self, angle: Angle) -> None:
        """Take an angle that is to be zero."""
        if angle.radians:
            raise UnreadableError("write angles in degrees, or as multiples of pi")
        bare = Angle(angle.terms)
        quarter = angle.degrees % HALF_TURN
        if quarter not in (0, HALF_TURN // 2):
            raise UnreadableError(
                f"{write_angle(bare)} = {float(-angle.degrees):g}° cannot be judged; write what is zero"
            )
        factor = sine(bare) if quarter == 0 else cosine(bare)
        self._seen.setdefault(factor, set()).add(angle.degrees % TURN)

    @property
    def whole(self) -> list[Expr]:
        """Factors of which both angles were given."""
        return [factor for factor, seen in self._seen.items() if len(seen) > 1]

    @property
    def half(self) -> list[Expr]:
        """The others."""
        return [factor for factor, seen in self._seen.items() if len(seen) == 1]


def _is_constant(text: str) -> bool:
    try:
        return not symbols(parse(text, Scope(is_open=True)))
    except NotationError:  # what cannot be read is told where it is read
        return False


def _has_trig(expr: Expr) -> bool:
    return any(isinstance(node, Trig) for node in walk(expr))


def _apart(expr: Expr, exercise: Exercise) -> list[Expr]:
    """The factors of a product that hold a joint, each once."""
    variables = frozenset(exercise.robot.variables) if exercise.robot else frozenset[str]()
    factors = expr.factors if isinstance(expr, Product) else (expr,)
    bases = [factor.base if isinstance(factor, Power) and factor.exponent > 0 else factor for factor in factors]
    found = [base for base in bases if symbols(base) & variables]
    if not found:
        shown = write(expr, "short", exercise.writing)
        what = "a number" if isinstance(expr, Number) else "a length that does not change"
        raise UnreadableError(f"{shown} is {what}: write what the joints make zero")
    return found


def _alike(first: Expr, second: Expr, case: Case) -> bool:
    """Whether two factors are the same up to a constant: f(q) g(q') = g(q) f(q') for all q and q'."""
    robot = case.exercise.robot
    if robot is None:
        return False
    slides = {name: Symbol(f"{name}_b") for name in robot.variables if name not in robot.angles}
    turns = {name: Angle.of(f"{name}_b") for name in robot.variables if name in robot.angles}
    one, other = (substitute(expr, slides, turns) for expr in (first, second))
    return equal(multiply(first, other), multiply(second, one))
