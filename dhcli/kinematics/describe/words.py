"""The process in words: what each step finds, by which rule, what was free and what was chosen."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from dhcli.geometry.vectors import Vector, dot
from dhcli.kinematics.conventions import ORDER, Convention
from dhcli.kinematics.describe.linear import Point, coordinates_of, is_plain, length_of
from dhcli.kinematics.describe.normals import Lie
from dhcli.kinematics.describe.process import Leg, Walk, axis_word
from dhcli.notation.styles import Joints
from dhcli.notation.tree import Expr, Number
from dhcli.notation.writer import write, write_angle


@dataclass(frozen=True, slots=True)
class Step:
    """One thing found on the way.

    Attributes:
        number: Step of the process: 1 z axes, 2 base, 3 x axes, 4 the table, 5 the matrices, 6 their product.
        subject: What is found, such as x2.
        said: How, in a sentence.
        rule: The rule that asks for it, empty where none does.
        free: What was free, and what was chosen.
        cells: The cells that follow, such as `a2 = 0`.
    """

    number: int
    subject: str
    said: str
    rule: str = ""
    free: str = ""
    cells: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class Speaker:
    """How lines, frames and lengths are named.

    Attributes:
        walk: The way from base to end.
        convention: Which axis a frame stands on.
        first: Number of the first link.
        joints: How joint angles are written.
    """

    walk: Walk
    convention: Convention
    first: int
    joints: Joints

    def steps(self) -> Iterator[Step]:
        """The process from the first axis to the product."""
        yield Step(1, "z axes", "; ".join(self._axes()), f"DH1: {self._dh1()}")
        for leg in self.walk.legs:
            number = 2 if leg.number == 0 else 3
            yield Step(number, self.x(leg.number), *self._found(leg))
        yield Step(3, "y axes", "y = z × x makes every frame right-handed")
        yield Step(4, "the table", "the cells above, a row for each link")
        yield Step(5, "A_i", ORDER[self.convention].removeprefix("A_i = "))
        count = len(self.walk.legs) - 1
        named = [f"A_{self.first + k}" for k in range(count)]
        whole = named if len(named) <= 3 else [named[0], named[1], "...", named[-1]]  # noqa: PLR2004
        yield Step(6, f"T_{self.first - 1}{self.first + count - 1}", " ".join(whole) or "the identity")

    def z(self, line: int) -> str:
        """The name of the z axis on a line."""
        if line == 0:
            return "the base's z"
        if line == len(self.walk.lines) - 1 and self.convention is Convention.MODIFIED:
            return "the end's z"
        standard = self.convention is Convention.STANDARD
        return f"z{line - standard + self.first - 1}"

    def x(self, leg: int) -> str:
        """The name of the x axis of a normal."""
        return f"x{leg + self.first - 1}"

    def point(self, point: Point) -> str:
        """A point as it is written; the base's origin is o."""
        shown = coordinates_of(point)
        return f"({', '.join(self._length(expr, point) for expr in shown)})" if point else "o"

    def _length(self, expr: Expr, letters: Point) -> str:
        if is_plain(letters) and isinstance(expr, Number):
            return f"{float(expr.value):.6g}"
        return write(expr, "short", self.joints)

    def _dh1(self) -> str:
        return (
            "z_{i-1} is the axis of joint i" if self.convention is Convention.STANDARD else "z_i is the axis of joint i"
        )

    def _axes(self) -> Iterator[str]:
        for k, line in enumerate(self.walk.lines[1:-1], 1):
            where = f"through {self.point(line.through or {})}"
            kind = "" if line.turns else ", a slide: only its direction matters"
            yield f"{self.z(k)} ({line.name}) {axis_word(line.direction)} {where}{kind}"

    def _found(self, leg: Leg) -> tuple[str, str, str, tuple[str, ...]]:
        k, found = leg.number, leg.normal
        one, two = self.z(k), self.z(k + 1)
        said, free = _CASES[found.lie](self, leg)
        if k == len(self.walk.legs) - 1 and free:
            free = f"{free}; the end frame decides"
        opposite = ", in opposite senses" if found.same < 0 else ""
        return f"{one} and {two} {said}{opposite}", self._rule(k), free, self._cells(leg)

    def _rule(self, leg: int) -> str:
        own = self.z(leg) if self.convention is Convention.STANDARD else self.z(leg + 1)
        return f"DH2, DH3: {self.x(leg)} is perpendicular to {own} and meets it"

    def _cells(self, leg: Leg) -> tuple[str, ...]:
        k = leg.number + self.first - 1
        a, alpha = (
            write(leg.along_x.length, "short", self.joints),
            write_angle(leg.along_x.turn, "short", self.joints),
        )
        d, theta = (
            write(leg.along_z.length, "short", self.joints),
            write_angle(leg.along_z.turn, "short", self.joints),
        )
        x_cells = (
            ()
            if leg.number == 0 and leg.along_x.is_none and self.convention is Convention.STANDARD
            else (f"a{k} = {a}", f"α{k} = {alpha}")
        )
        z_cells = () if leg.number == 0 else (f"d{k} = {d}", f"θ{k} = {theta}")
        return (*x_cells, *z_cells)


def _skew(speaker: Speaker, leg: Leg) -> tuple[str, str]:
    start, end = speaker.point(leg.normal.start), speaker.point(leg.normal.end)
    return f"are skew: the normal leads from {start} to {end}, along {axis_word(leg.normal.x)}", ""


def _meet(speaker: Speaker, leg: Leg) -> tuple[str, str]:
    at, x = speaker.point(leg.normal.start), axis_word(leg.normal.x)
    names = f"{speaker.z(leg.number)} × {speaker.z(leg.number + 1)}"
    nearer = dot(leg.normal.x, leg.previous)
    chosen = f"{x}, nearer the x before" if nearer > 1e-12 else f"{x}"  # noqa: PLR2004
    return f"meet at {at}: x = ±({names}), {chosen}", f"the sense of {speaker.x(leg.number)}"


def _parallel(speaker: Speaker, leg: Leg) -> tuple[str, str]:
    apart = write(length_of(leg.normal.apart), "short", speaker.joints)
    where = f"through {speaker.point(leg.normal.start)}, along {axis_word(leg.normal.x)}"
    said = f"are parallel, {apart} apart: a normal stands anywhere; {where}"
    return said, f"d along {speaker.z(leg.number)}"


def _same(speaker: Speaker, leg: Leg) -> tuple[str, str]:
    kept = (
        "the base's x" if leg.number == 0 else "the x before" if _is_near(leg.normal.x, leg.previous) else "the end's x"
    )
    return (
        f"are one line: {kept}, {axis_word(leg.normal.x)}, at {speaker.point(leg.normal.start)}",
        f"{speaker.x(leg.number)} and its origin",
    )


def _is_near(one: Vector, other: Vector) -> bool:
    return dot(one, other) > 1 - 1e-12


_CASES = {Lie.SKEW: _skew, Lie.MEET: _meet, Lie.PARALLEL: _parallel, Lie.SAME: _same}
