"""How a motion acts on directions, points, lines and circles, written out over columns.

Four kinds of thing, each a list of entries; an entry is a float or a column of numbers, one for each pose:

- a direction, v: 3 entries, the form is v·v';
- a point p as (1, p, p²/2), and with it planes and spheres: 5 entries (w, v, k), the form is v·v' - w k' - k w',
  for two points minus half the square of their distance;
- a line (l, p x l): 6 entries, the form is l·m' + m·l';
- a point with a direction, or a circle: 10 entries (l, p·l, p x l, p (p·l) - l p²/2), the bivectors of the second
  kind, the form is m·m' + l·n' + n·l' - s s'.

Every motion keeps the form, and acts linearly: a turn about an axis is linear in cosine and sine, a slide quadratic in
its length. Zeros and ones are structural where they come from the robot, and cost nothing.

Source: the third kind is Plücker's, the second that of Lie and Möbius; the fourth holds Raghavan and Roth's ten
equations of 1990, which come with the four of the second.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, TypeAlias

if TYPE_CHECKING:
    from dhcli.kinematics.inverse.arm import Array, Axis

Entry: TypeAlias = "float | Array"
Thing: TypeAlias = Sequence[Entry]

DIRECTION, POINT, LINE, CIRCLE = range(4)
"""The four kinds."""

SIZES = (3, 5, 6, 10)
"""How many entries a thing of each kind has."""

VECTORS = ((0,), (1,), (0, 3), (0, 4, 7))
"""Where the vectors among the entries begin; the other entries are numbers that no turn changes."""


def times(a: Entry, b: Entry) -> Entry:
    """A product; nothing is computed where a factor is 0, 1 or -1."""
    if type(b) is float:
        a, b = b, a
    if type(a) is float:
        if a == 0.0:
            return 0.0
        if a == 1.0:
            return b
        if a == -1.0:
            return -b
    return a * b


def plus(a: Entry, b: Entry) -> Entry:
    """A sum; nothing is computed where a term is 0."""
    if type(a) is float and a == 0.0:
        return b
    if type(b) is float and b == 0.0:
        return a
    return a + b


def minus(a: Entry, b: Entry) -> Entry:
    """A difference; nothing is computed where the second term is 0."""
    if type(b) is float and b == 0.0:
        return a
    if type(a) is float and a == 0.0:
        return -b
    return a - b


def dot(a: Thing, b: Thing) -> Entry:
    """The scalar product of two vectors."""
    return plus(plus(times(a[0], b[0]), times(a[1], b[1])), times(a[2], b[2]))


def cross(a: Thing, b: Thing) -> list[Entry]:
    """The vector product."""
    return [minus(times(a[i], b[j]), times(a[j], b[i])) for i, j in ((1, 2), (2, 0), (0, 1))]


def _sum(*vectors: Thing) -> list[Entry]:
    total = list(vectors[0])
    for vector in vectors[1:]:
        total = [plus(a, b) for a, b in zip(total, vector, strict=True)]
    return total


def _scaled(factor: Entry, vector: Thing) -> list[Entry]:
    return [times(factor, part) for part in vector]


def translated(kind: int, thing: Thing, t: Thing) -> list[Entry]:
    """A thing moved by a vector t, which may hold columns."""
    if kind == DIRECTION:
        return list(thing)
    if kind == LINE:
        return [*thing[:3], *_sum(thing[3:], cross(t, thing[:3]))]
    half = times(0.5, dot(t, t))
    if kind == POINT:
        w, v, k = thing[0], thing[1:4], thing[4]
        return [w, *_sum(v, _scaled(w, t)), plus(plus(k, dot(t, v)), times(w, half))]
    along, s, m, n = thing[:3], thing[3], thing[4:7], thing[7:10]
    tl = dot(t, along)
    moved = _sum(n, cross(t, m), _scaled(plus(s, tl), t), _scaled(times(-1.0, half), along))
    return [*along, plus(s, tl), *_sum(m, cross(t, along)), *moved]


def rotated(kind: int, thing: Thing, rows: Sequence[Thing]) -> list[Entry]:
    """A thing turned about the origin by a matrix of three rows."""
    turned = list(thing)
    for k in VECTORS[kind]:
        turned[k : k + 3] = [dot(row, thing[k : k + 3]) for row in rows]
    return turned


def expanded(kind: int, thing: Thing, axis: Axis) -> tuple[list[Entry], list[Entry], list[Entry]]:
    """The three parts of a thing moved by a joint: at rest, with c, with s; for a slide with d and d²/2."""
    if not axis.turns:
        return _slid(kind, thing, axis.direction)
    a, away = axis.direction, tuple(-part for part in axis.point)
    here = translated(kind, thing, away)
    rest: list[Entry] = list(here)
    cosine: list[Entry] = [0.0] * len(here)
    sine: list[Entry] = [0.0] * len(here)
    for k in VECTORS[kind]:
        v = here[k : k + 3]
        rest[k : k + 3] = along = _scaled(dot(a, v), a)
        cosine[k : k + 3] = [minus(whole, part) for whole, part in zip(v, along, strict=True)]
        sine[k : k + 3] = cross(a, v)
    back = axis.point
    return translated(kind, rest, back), translated(kind, cosine, back), translated(kind, sine, back)


def _slid(kind: int, thing: Thing, a: Thing) -> tuple[list[Entry], list[Entry], list[Entry]]:
    none = [0.0] * len(thing)
    first: list[Entry] = list(none)
    second: list[Entry] = list(none)
    if kind == POINT:
        first[1:4], first[4] = _scaled(thing[0], a), dot(a, thing[1:4])
        second[4] = thing[0]
    elif kind == LINE:
        first[3:] = cross(a, thing[:3])
    elif kind == CIRCLE:
        along, tl = thing[:3], dot(a, thing[:3])
        first[3], first[4:7] = tl, cross(a, along)
        first[7:10] = _sum(cross(a, thing[4:7]), _scaled(thing[3], a))
        second[7:10] = _sum(_scaled(times(2.0, tl), a), _scaled(-1.0, along))
    return list(thing), first, second


def carried(kind: int, thing: Thing, axis: Axis, value: tuple[Entry, Entry], *, back: bool) -> list[Entry]:
    """A thing moved by a joint whose value is known.

    Args:
        kind: What kind of thing.
        thing: Its entries.
        axis: The joint.
        value: Cosine and sine, or length and half its square.
        back: Whether the motion is undone.
    """
    c, s = value
    if not axis.turns:
        length = -c if back else c
        return translated(kind, thing, [times(length, part) for part in axis.direction])
    s = -s if back else s
    a, away = axis.direction, tuple(-part for part in axis.point)
    here = translated(kind, thing, away)
    for k in VECTORS[kind]:
        v = here[k : k + 3]
        along = _scaled(dot(a, v), a)
        across = [minus(whole, part) for whole, part in zip(v, along, strict=True)]
        here[k : k + 3] = _sum(along, _scaled(c, across), _scaled(s, cross(a, v)))
    return translated(kind, here, axis.point)


def form(kind: int, x: Thing, y: Thing) -> Entry:
    """What every motion keeps of two things."""
    if kind == DIRECTION:
        return dot(x, y)
    if kind == LINE:
        return plus(dot(x[:3], y[3:]), dot(x[3:], y[:3]))
    if kind == POINT:
        return minus(minus(dot(x[1:4], y[1:4]), times(x[0], y[4])), times(x[4], y[0]))
    lines = plus(dot(x[:3], y[7:10]), dot(x[7:10], y[:3]))
    return minus(plus(dot(x[4:7], y[4:7]), lines), times(x[3], y[3]))
