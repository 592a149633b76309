"""The process in words: what each step finds, by which rule, what was free and what was chosen."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator

from dhcli.frozen import frozen
from dhcli.geometry.vectors import angle_about, dot
from dhcli.kinematics.conventions import ORDER, Convention
from dhcli.kinematics.describe.exact import exact_angle
from dhcli.kinematics.describe.linear import Point, along, coordinates_of, is_plain, length_of, moved
from dhcli.kinematics.describe.normals import Lie
from dhcli.kinematics.describe.process import Leg, Walk, axis_word
from dhcli.notation.styles import Joints
from dhcli.notation.tree import Expr, Number
from dhcli.notation.writer import write, write_angle

_CLOSE = 1e-9
"""What floating point leaves of 0 where a choice is told."""


@frozen
class Step:
    """One thing found on the way.

    Attributes:
        number: Step of the process: 1 z axes, 2 base and end, 3 x axes, 4 the table, 5 the matrices, 6 their product.
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

    def lines(self) -> Iterator[str]:
        """The step as it is written: what is found, the cells that follow, what was free."""
        yield f"{self.subject}: {self.said}" + (f" ({self.rule})" if self.rule else "")
        if self.cells:
            yield f"so {', '.join(self.cells)}"
        if self.free:
            yield f"free: {self.free}"


def written(steps: Iterable[Step]) -> tuple[str, ...]:
    """Steps as they stand on a page, a text for each number."""
    texts: dict[int, list[str]] = {}
    for step in steps:
        head, *rest = step.lines()
        before = texts.setdefault(step.number, [])
        before.append(f"   {head}" if before else f"{step.number}  {head}")
        before += [f"     {line}" for line in rest]
    return tuple("\n".join(lines) for lines in texts.values())


@frozen
class Speaker:
    """How lines, frames and lengths are named.

    Attributes:
        walk: The way from base to end.
        convention: Which axis a frame stands on.
        first: Number of the first link.
        joints: How joint angles are written.
        measured: A length in metres as it is written, where that is in another unit.
    """

    walk: Walk
    convention: Convention
    first: int
    joints: Joints
    measured: Callable[[Expr], Expr] = lambda length: length

    def steps(self) -> Iterator[Step]:
        """The process from the first axis to the product."""
        yield from self.drawn()
        yield Step(4, "table", "the cells above, a row for each link")
        yield Step(5, "A_i", ORDER[self.convention].removeprefix("A_i = "))
        count = len(self.walk.legs) - 1
        named = [f"A_{self.first + k}" for k in range(count)]
        whole = named if len(named) <= 3 else [named[0], named[1], "...", named[-1]]  # noqa: PLR2004
        yield Step(6, f"T_{self.first - 1}{self.first + count - 1}", " ".join(whole) or "the identity")

    def drawn(self) -> Iterator[Step]:
        """The first three steps, which draw the frames."""
        standard = self.convention is Convention.STANDARD
        own, other = ("z_{i-1}", "z_{i-1}") if standard else ("z_i", "z_{i+1}")
        yield Step(1, "z axes", f"DH1: {own} is the axis of joint i")
        yield from self._axes()
        *inner, last = self.walk.legs
        yield self._step(2, inner[0] if inner else last)
        rules = f"DH2: x_i is perpendicular to {other}. DH3: x_i meets it"
        yield Step(3, "x axes", f"each on the common normal of two z axes. {rules}")
        for leg in (*inner[1:], last) if inner else ():
            yield self._step(3, leg)
        yield Step(3, "y axes", "y = z × x makes every frame right-handed")

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
        return f"x{self.number(leg)}"

    def number(self, leg: int) -> int:
        """The number of the frame whose x axis lies along a normal."""
        return leg + self.first - 1

    def point(self, point: Point) -> str:
        """A point as it is written; the base's origin is o."""
        shown = coordinates_of(point)
        return f"({', '.join(self._coordinate(expr, point) for expr in shown)})" if point else "o"

    def length(self, expr: Expr) -> str:
        """A length as it is written."""
        return write(self.measured(expr), "short", self.joints)

    def _coordinate(self, expr: Expr, letters: Point) -> str:
        shown = self.measured(expr)
        if is_plain(letters) and isinstance(shown, Number):
            return f"{float(shown.value):.6g}"
        return write(shown, "short", self.joints)

    def _axes(self) -> Iterator[Step]:
        for k, line in enumerate(self.walk.lines[1:-1], 1):
            where = f"through {self.point(line.through or {})}"
            kind = "" if line.turns else ", a slide: only its direction matters"
            kind = ", a screw: its slide goes into d" if line.pitch else kind
            against = f", {line.name} counts the other way" if line.rate < 0 else ""
            yield Step(1, self.z(k), f"{axis_word(line.direction)} {where}, of {line.name}{kind}{against}")

    def _step(self, number: int, leg: Leg) -> Step:
        k, found = leg.number, leg.normal
        said, free = _CASES[found.lie](self, leg)
        if k == len(self.walk.legs) - 1 and free:
            free = f"{free.partition(';')[0]}; the end frame decides"
        rule = "special case: parallel axes" if found.lie is Lie.PARALLEL else ""
        opposite = ", in opposite senses" if found.same < 0 else ""
        both = f"{self.z(k)} and {self.z(k + 1)}"
        return Step(number, self.x(k), f"{both} {said}{opposite}{self._turned(leg)}", rule, free, self._cells(leg))

    def _turned(self, leg: Leg) -> str:
        """Where the x axis stands against the one before, if it does not lie along it as drawn."""
        line = self.walk.lines[leg.number]
        turn = exact_angle(angle_about(line.direction, leg.before.x, leg.normal.x))
        if not leg.number or turn.is_zero:
            return ""
        angle = write_angle(turn, "short", self.joints)
        return f"; as drawn, {angle} from {self.x(leg.number - 1)} about {self.z(leg.number)}"

    def _cells(self, leg: Leg) -> tuple[str, ...]:
        k = self.number(leg.number)
        a, d = (self.length(way.length) for way in (leg.along_x, leg.along_z))
        alpha, theta = (write_angle(way.turn, "short", self.joints) for way in (leg.along_x, leg.along_z))
        is_row = leg.number or self.convention is Convention.MODIFIED or not leg.along_x.is_none
        is_last = leg.number == len(self.walk.legs) - 1 and self.convention is Convention.MODIFIED
        x_cells = (f"a{k} = {a}", f"α{k} = {alpha}") if is_row and not (is_last and leg.along_x.is_none) else ()
        z_cells = (f"d{k} = {d}", f"θ{k} = {theta}") if leg.number else ()
        return (*x_cells, *z_cells)


def _skew(speaker: Speaker, leg: Leg) -> tuple[str, str]:
    start, end, x = speaker.point(leg.normal.start), speaker.point(leg.normal.end), axis_word(leg.normal.x)
    return f"are skew: the normal leads from {start} to {end}, {x}", ""


def _meet(speaker: Speaker, leg: Leg) -> tuple[str, str]:
    at, x, own = speaker.point(leg.normal.start), axis_word(leg.normal.x), speaker.x(leg.number)
    names = f"{speaker.z(leg.number)} × {speaker.z(leg.number + 1)}"
    nearer = dot(leg.normal.x, leg.before.x) > _CLOSE
    chosen = f"{x}, nearer {_before(speaker, leg)}, is chosen" if nearer else f"{x} is chosen"
    return f"meet at {at}: {own} is ±({names})", f"the sense of {own}; {chosen}"


def _parallel(speaker: Speaker, leg: Leg) -> tuple[str, str]:
    k = speaker.number(leg.number)
    apart = speaker.length(length_of(leg.normal.apart))
    said = f"are parallel, {apart} apart: {axis_word(leg.normal.x)}, through {speaker.point(leg.normal.start)}"
    if not leg.number:
        return said, "the height of the normal; 0 is chosen"
    return said, f"d{k}, as a normal stands anywhere; {_chosen(speaker, leg)}"


def _same(speaker: Speaker, leg: Leg) -> tuple[str, str]:
    x, own = axis_word(leg.normal.x), speaker.x(leg.number)
    said = f"are one line: {x}, at {speaker.point(leg.normal.start)}"
    is_kept = dot(leg.normal.x, leg.before.x) > 1 - _CLOSE
    chosen = f"{_before(speaker, leg)} is kept" if is_kept else f"{x} is chosen"
    return said, f"{own} and its origin; {chosen}" + (f", {_chosen(speaker, leg)}" if leg.number else "")


def _before(speaker: Speaker, leg: Leg) -> str:
    return speaker.x(leg.number - 1) if leg.number else "the base's x"


def _chosen(speaker: Speaker, leg: Leg) -> str:
    """Which of the two offsets along a free normal is 0, if one of them is."""
    k = speaker.number(leg.number)
    after = speaker.walk.legs[leg.number + 1 : leg.number + 2]
    if not _gap(leg, speaker.walk):
        return f"d{k} is 0 there"
    if after and not _gap(after[0], speaker.walk):
        return f"d{k + 1} is 0 there"
    return f"d{k} is chosen"


def _gap(leg: Leg, walked: Walk) -> bool:
    """Whether the foot of a normal is elsewhere on its line than the origin before."""
    way = along(moved(leg.normal.start, leg.before.origin, -1), walked.lines[leg.number].direction)
    return any(abs(value) > _CLOSE for value in way.values())


_CASES = {Lie.SKEW: _skew, Lie.MEET: _meet, Lie.PARALLEL: _parallel, Lie.SAME: _same}
