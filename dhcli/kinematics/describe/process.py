"""The process of Denavit and Hartenberg: from lines to a table, one common normal after the other.

The motion from base to end is `Z0 X0 Z1 X1 ... Zn Xn Zn+1`, where Xk is the normal from line k to line k+1 and Zk the
way along line k from one normal to the next. A standard row i is Zi Xi, a modified one Xi-1 Zi.
"""

from __future__ import annotations

from fractions import Fraction
from itertools import pairwise
from math import pi

from dhcli.frozen import frozen
from dhcli.geometry.vectors import UNITS, Vector, angle_about, cross, length, minus
from dhcli.kinematics.conventions import Convention, Row
from dhcli.kinematics.describe.choices import USUAL, Choices
from dhcli.kinematics.describe.drawn import Drawing, Frame, Line
from dhcli.kinematics.describe.exact import exact_angle
from dhcli.kinematics.describe.linear import Form, along, length_of, moved
from dhcli.kinematics.describe.normals import Lie, Normal, far_feet, how_far, normal, placed, through_end
from dhcli.kinematics.describe.products import screwed
from dhcli.kinematics.moves import Chain, Rot
from dhcli.kinematics.moves import along as shift
from dhcli.notation.angle import Angle
from dhcli.notation.factors import Axis
from dhcli.notation.tree import ZERO, Expr, Number, Symbol, multiply


@frozen
class Along:
    """A way along an axis: a turn about it and a length along it."""

    turn: Angle = Angle()
    length: Expr = ZERO

    def moves(self, axis: Axis) -> Chain:
        """As moves; none for what is zero."""
        turned: Chain = () if self.turn.is_zero else (Rot(axis, self.turn),)
        return turned if self.length == ZERO else (*turned, shift(axis, self.length))

    @property
    def is_none(self) -> bool:
        """Whether it leads nowhere."""
        return self.turn.is_zero and self.length == ZERO


@frozen
class Leg:
    """One normal, and the way along the line to its foot."""

    number: int
    normal: Normal
    along_z: Along
    along_x: Along
    before: Frame


@frozen
class Walk:
    """The way from the base to the end.

    Attributes:
        lines: All lines, from that of the base to that of the end.
        legs: One for each line but the last.
        last: The way along the end's own z axis.
        warnings: What a person should know.
        farthest: How far the farthest foot is, in sizes of the robot: by so much roundings grow.
        bent: By how much axes that are parallel but for roundings were turned [rad].
    """

    lines: tuple[Line, ...]
    legs: tuple[Leg, ...]
    last: Along
    warnings: tuple[str, ...]
    farthest: float = 1.0
    bent: float = 0.0

    def base(self, convention: Convention) -> Chain:
        """What stands before the first row."""
        first = self.legs[0]
        if convention is Convention.MODIFIED:
            return first.along_z.moves("z")
        return (*first.along_z.moves("z"), *first.along_x.moves("x"))

    def rows(self, convention: Convention) -> tuple[Row, ...]:
        """The rows of the table."""
        legs = self.legs[1:]
        across = self.legs[:-1] if convention is Convention.MODIFIED else legs
        return tuple(
            Row(other.along_x.length, other.along_x.turn, leg.along_z.length, leg.along_z.turn)
            for leg, other in zip(legs, across, strict=True)
        )

    def tool(self, convention: Convention) -> Chain:
        """What stands behind the last row."""
        last = self.last.moves("z")
        return (*self.legs[-1].along_x.moves("x"), *last) if convention is Convention.MODIFIED else last


def walk(drawing: Drawing, choices: Choices = USUAL) -> Walk:
    """Go from the base to the end, normal by normal.

    Args:
        drawing: The robot as it is drawn; the base is the frame that it is drawn in.
        choices: What decides where the rules leave a choice.

    Raises:
        LettersError: A direction depends on how long letters are against each other.
    """
    ruler, here = drawing.ruler, Frame()
    lines = placed(drawing, here)
    legs: list[Leg] = []
    warnings: list[str] = []
    for k, (first, second) in enumerate(pairwise(lines)):
        near = choices.near(k, here, lines, ruler)
        found = normal(first, second, near, ruler, is_signed=choices.is_signed)
        if k == len(lines) - 2:
            found = through_end(found, drawing.end, ruler)
        if warning := far_feet(found, first, second, ruler):
            warnings.append(warning)
        u, v = first.direction, second.direction
        turn = angle_about(u, here.x, found.x)
        way = ruler.cleaned(along(moved(found.start, here.origin, -1), u))
        twist = exact_angle(_angle(found, u, v))
        legs.append(Leg(k, found, with_variable(first, turn, way), Along(twist, length_of(found.apart)), here))
        here = Frame(found.x, v, found.end)
    end = drawing.end
    rest = ruler.cleaned(along(moved(end.origin, here.origin, -1), here.z))
    last = Along(exact_angle(angle_about(here.z, here.x, end.x)), length_of(rest))
    farthest = max(1.0, *(how_far(leg.normal, ruler) for leg in legs))
    given = (*(line.direction for line in drawing.lines), end.z)
    bent = max(length(minus(line.direction, was)) for line, was in zip(lines[1:], given, strict=True))
    return Walk(lines, tuple(legs), last, tuple(warnings), farthest, bent)


def _angle(found: Normal, u: Vector, v: Vector) -> float:
    return angle_about(found.x, u, v) if found.lie in (Lie.SKEW, Lie.MEET) else (0.0 if found.same > 0 else pi)


def with_variable(line: Line, turn: float, way: Form) -> Along:
    """The way along a line, with the variable of its joint: in the pose drawn it is as drawn."""
    turned, offset = exact_angle(turn), length_of(way)
    if line.name in ("base", "end"):
        return Along(turned, offset)
    if line.turns:
        drawn = line.drawn if isinstance(line.drawn, Angle) else Angle()
        slid = screwed(line, length_of(line.pitch)) if line.pitch else ZERO
        return Along(Angle(((line.name, line.rate),)) + _rounded(turned - drawn * line.rate), slid + offset)
    drawn_length = line.drawn if isinstance(line.drawn, Expr) else ZERO
    moving = multiply(Number(line.rate), Symbol(line.name))
    return Along(turned, moving + (offset - multiply(Number(line.rate), drawn_length)))


def _rounded(angle: Angle) -> Angle:
    """An offset within half a turn."""
    if angle.radians:
        return angle
    degrees = angle.degrees % 360
    return Angle(degrees=degrees - 360 if degrees > Fraction(180) else degrees)


def frames_of(walked: Walk, convention: Convention) -> tuple[Frame, ...]:
    """The frames of a convention: x along each normal, on the line behind it or, in the modified one, before it."""
    pairs = zip(walked.legs, pairwise(walked.lines), strict=True)
    if convention is Convention.MODIFIED:
        return tuple(Frame(leg.normal.x, line.direction, leg.normal.start) for leg, (line, _) in pairs)
    return tuple(Frame(leg.normal.x, line.direction, leg.normal.end) for leg, (_, line) in pairs)


def axis_word(direction: Vector) -> str:
    """A direction in words: `+z` where it lies along an axis, else its components."""
    for unit, name in zip(UNITS, "xyz", strict=True):
        if max(map(abs, cross(unit, direction))) < 1e-12:  # noqa: PLR2004
            return f"{'+' if direction['xyz'.index(name)] > 0 else '-'}{name}"
    return "(" + ", ".join(f"{value:.4g}" if abs(value) > 1e-12 else "0" for value in direction) + ")"  # noqa: PLR2004
