"""What geometry says of an answer that no known mistake explains: how far it is turned and shifted, never a guess.

An answer in expressions is compared at general points: what is the same at each of them, or there equal to a name of
the robot, is so everywhere.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from dhcli.checking.diagnosis.typed import TypedMatrix
from dhcli.checking.exercise import Exercise
from dhcli.checking.orientations import not_orthonormal
from dhcli.checking.wanted import Wanted
from dhcli.frozen import frozen
from dhcli.geometry.rigid import Rigid
from dhcli.geometry.vectors import UNITS, Vector, dot, length, plus, scaled
from dhcli.kinematics.entries import rounded
from dhcli.kinematics.fold import fold
from dhcli.kinematics.frames import View, between, span_of
from dhcli.notation.styles import Joints
from dhcli.notation.tree import Symbol
from dhcli.notation.writer import write

SAME = 1e-7
"""What two numbers at a general point may differ by, as a share; entries were compared to nine digits."""
LIKE = 0.02
"""What a length that is named beside a number may differ from it by, as a share, however few digits were typed."""
MULTIPLES = (1, -1, 2, -2)

HALVES = ("the rotation is right;", "the position is right;")
"""How remarks begin that are said more precisely here."""


@frozen
class Frame:
    """A frame in which a shift may be told: the name of its axes, and its rotation at each point."""

    name: str
    rotations: tuple[Rigid, ...]

    def axis(self, letter: str) -> str:
        """One of its axes in words: `x1`, `x of the base`."""
        return f"{letter}{self.name}" if self.name.isdigit() else f"{letter} of {self.name}"


def geometry(exercise: Exercise, question: Wanted, typed: TypedMatrix) -> str:
    """By what a wrong answer is off, in words; nothing where that is not one turn and one shift."""
    has_rotation = question.piece in ("pose", "rotation")
    has_position = question.piece in ("pose", "position", "point")
    values, truths, slack = typed.values, typed.search.truth, typed.slacks[-1]
    is_finite = all(math.isfinite(x) for matrix in values for row in matrix for x in row)
    if not is_finite or not (has_rotation or has_position):
        return ""
    said = []
    if has_rotation:
        fault = _not_rotation(values) if typed.is_general else ""
        if fault:
            return fault
        turn = _turn(exercise, question, typed) if typed.is_general else ""
        is_right = all(_near(v, t, slack[0][0]) for v, t in zip(values, truths, strict=True))
        if not is_right and not turn and question.piece == "rotation":
            return ""
        said.append("the rotation is right" if is_right else turn)
    if has_position:
        gaps = tuple(_gap(v, t) for v, t in zip(values, truths, strict=True))
        limit = slack[0][-1]
        is_right = all(abs(x) <= limit for gap in gaps for x in gap)
        shift = "the position is right" if is_right else _shift(exercise, question, typed, gaps, limit)
        said.append(shift)
    return "; ".join(filter(None, said)) if any("off by" in one for one in said) else ""


def _not_rotation(values: Sequence[Sequence[Sequence[float]]]) -> str:
    faults = [not_orthonormal([row[:3] for row in matrix[:3]], SAME) for matrix in values]
    fault, _, size = faults[0].partition(" has length ")
    return f"{fault} has not length 1" if size else fault


def _turn(exercise: Exercise, question: Wanted, typed: TypedMatrix) -> str:
    """About which axis an orientation is off, and by what angle: in the reference first, then about its own axes."""
    reference, own = _ends(exercise, question)
    pairs = [(_rotation(v), _rotation(t)) for v, t in zip(typed.values, typed.search.truth, strict=True)]
    ways = (
        (reference, [answer @ right.inverse() for answer, right in pairs]),
        (own, [right.inverse() @ answer for answer, right in pairs]),
    )
    for place, turns in ways:
        axis = _common_axis(turns)
        angle = _angle_text(exercise, typed, [turn.angle_about(axis) for turn in turns]) if axis else ""
        if axis and angle:
            return f"the rotation is off by {angle} about {_axis_text(axis, place)}"
    return ""


def _common_axis(turns: Sequence[Rigid]) -> Vector | None:
    """The axis about which all of them turn, its largest coordinate positive."""
    found: Vector | None = None
    for turn in turns:
        (_, b, c), (d, _, f), (g, h, _) = turn.rows
        axis = (h - f, c - g, d - b)
        if length(axis) <= SAME:  # half a turn, or none: the column of R + 1 that is longest
            columns = [plus(turn.column(k), UNITS[k]) for k in range(3)]
            axis = max(columns, key=length)
        largest = max(axis, key=abs)
        axis = scaled(axis, math.copysign(1 / length(axis), largest))
        if found is not None and abs(abs(dot(found, axis)) - 1) > SAME:
            return None
        found = found or axis
    return found


def _angle_text(exercise: Exercise, typed: TypedMatrix, angles: Sequence[float]) -> str:
    """An angle that is constant, or follows a joint; nothing if it does neither."""
    if all(_is_turn(angle - angles[0]) for angle in angles):
        return f"{round(math.degrees(angles[0]), 2) + 0:g}°"
    for name in sorted(n for n in typed.search.names if exercise.scope.is_angle(n)):
        values = [over.symbol(name) for over in typed.search.points]
        for times in MULTIPLES:
            for more in (0, 90, -90, 180):
                offset = math.radians(more)
                if all(_is_turn(a - times * v - offset) for a, v in zip(angles, values, strict=True)):
                    plain = _times(times, name, exercise.writing)
                    return f"{plain} {'-' if more < 0 else '+'} {abs(more)}°" if more else plain
    return ""


def _shift(exercise: Exercise, question: Wanted, typed: TypedMatrix, gaps: Sequence[Vector], limit: float) -> str:
    """How far a position is off along the axes of a frame, in names; one axis alone is best."""
    reference, _ = _ends(exercise, question)
    tries: list[tuple[int, bool, bool, list[str]]] = []
    for place in _frames(exercise, question, typed):
        seen = [r.inverse().turned(gap) for r, gap in zip(place.rotations, gaps, strict=True)]
        letters = [k for k in range(3) if any(abs(vector[k]) > limit for vector in seen)]
        texts = [_length_text(exercise, typed, [vector[k] for vector in seen], limit) for k in letters]
        if all(texts):
            said = [f"{text} along {place.axis('xyz'[k])}" for text, k in zip(texts, letters, strict=True)]
            tries.append((len(said), place.name != reference, letters != [2], said))  # z is the axis of a joint
    best = min(tries, default=(0, False, False, []))[-1]
    if not best or (len(best) > 1 and not typed.is_general):  # in numbers the axes of the reference have been told
        return ""
    return "the position is off by " + ", ".join(best)


def _length_text(exercise: Exercise, typed: TypedMatrix, shares: Sequence[float], limit: float) -> str:
    """A length that is the value of a name, or of twice a name, or constant; nothing if it is none of these."""
    known = typed.search.names if typed.is_general else exercise.values.keys()
    names = sorted(name for name in known if not exercise.scope.is_angle(name))
    values = {name: [over.symbol(name) for over in typed.search.points] for name in names}
    found = [
        _times(times, name, exercise.writing)
        for name in names
        for times in MULTIPLES
        if all(
            limit < abs(v) and abs(s - times * v) <= min(limit, LIKE * abs(v))
            for s, v in zip(shares, values[name], strict=True)
        )
    ]
    if not typed.is_general:
        return _told_in_numbers(exercise, shares[0], found)
    if found:
        return found[0]
    if len(typed.search.points) > 1 and all(abs(s - shares[0]) <= limit for s in shares):
        return exercise.distance(shares[0])
    return ""


def _told_in_numbers(exercise: Exercise, share: float, names: Sequence[str]) -> str:
    """A length of the sheet and the name it has; without a name it has been told already."""
    if not names:
        return ""
    return f"{exercise.about(share)} (as much as {' or '.join(names)})"


def _times(times: int, name: str, writing: Joints) -> str:
    text = write(Symbol(name), "short", writing)
    return ("-" if times < 0 else "") + (text if abs(times) == 1 else f"{abs(times)}*{text}")


def _axis_text(axis: Vector, place: str) -> str:
    for letter, share in zip("xyz", axis, strict=True):
        if share > 1 - SAME:
            return Frame(place, ()).axis(letter)
    name = f"frame {place}" if place.isdigit() else place
    return f"the axis ({', '.join(rounded(share, 2) for share in axis)}) of {name}"


def _frames(exercise: Exercise, question: Wanted, typed: TypedMatrix) -> Iterator[Frame]:
    """The frames in which a shift is told: the reference, the frame described, and those between them."""
    reference, own = _ends(exercise, question)
    count = len(typed.search.points)
    yield Frame(reference, (Rigid(),) * count)
    robot, source = exercise.robot, question.source
    if robot is not None and isinstance(source, View) and not question.inverse:
        first, last = span_of(robot, source)
        for k in range(first + 1, last):
            chain = between(robot, robot.frames[first], robot.frames[k])
            yield Frame(_spoken(robot.frames[k]), tuple(_rotation(fold(chain, over)) for over in typed.search.points))
    matrices = (bench.matrix(typed.search.right) for bench in typed.search.benches)
    yield Frame(own, tuple(_rotation(matrix) for matrix in matrices))


def _ends(exercise: Exercise, question: Wanted) -> tuple[str, str]:
    """The names of the frame that is looked from, and of the one described."""
    if not isinstance(question.source, View) or exercise.robot is None:
        return "the reference", "the frame itself"
    start, end = question.source.start, question.source.end
    return (_spoken(end), _spoken(start)) if question.inverse else (_spoken(start), _spoken(end))


def _spoken(name: str) -> str:
    return name if name.isdigit() else f"the {name}"


def _rotation(matrix: Sequence[Sequence[float]]) -> Rigid:
    rows = tuple((row[0], row[1], row[2]) for row in matrix[:3])
    return Rigid((rows[0], rows[1], rows[2]))


def _gap(typed: Sequence[Sequence[float]], right: Sequence[Sequence[float]]) -> Vector:
    x, y, z = (a[-1] - b[-1] for a, b in zip(typed[:3], right[:3], strict=True))
    return x, y, z


def _near(typed: Sequence[Sequence[float]], right: Sequence[Sequence[float]], limit: float) -> bool:
    rows = zip(typed[:3], right[:3], strict=True)
    return all(abs(a - b) <= limit for r, s in rows for a, b in zip(r[:3], s[:3], strict=True))


def _is_turn(angle: float) -> bool:
    """Whether an angle is a whole number of turns."""
    return abs(math.remainder(angle, 2 * math.pi)) <= SAME
