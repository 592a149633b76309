"""For each kind of question, answers made by a seed, each with the verdicts that an oracle of floats allows it."""

from __future__ import annotations

import json
import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from random import Random
from typing import Any

from dhcli.checking.exercise import Exercise, Part
from dhcli.files.yaml.exercises import read_exercise
from tests.checking.floats import agreement, distance, same_turn, value
from tests.checking.mutations import mutated
from tests.judging import expected

RIGHT, ROUNDED, CLOSE, WRONG, UNREAD = "RIGHT", "ROUNDED", "CLOSE", "WRONG", "CAN'T READ"

GIVEN = {"theta1": "35°", "theta2": "-110°"}
AT = {"theta1": math.radians(35), "theta2": math.radians(-110), "a1": 0.4, "a2": 0.3}
ROTATION, POSITION = 1e-3, 1e-3 * (AT["a1"] + AT["a2"])
MATRICES = {
    "pose": "pose 0..2",
    "link": "link 2",
    "rotation": "rotation of pose 0..2",
    "position": "position of pose 0..2",
    "entry": "entry 1 4 of pose 0..2",
    "axis": "axis x of pose 0..2",
    "point": "point (a2, 0, a1) of pose 0..2",
    "vector": "vector (0, 1, 0) of pose 0..2",
    "inverse": "inverse of pose 0..2",
}


@dataclass(frozen=True)
class Answer:
    """An answer, what was done to the right one, and the verdicts that are fair."""

    exercise: Exercise
    part: Part
    text: str
    made: str
    fair: frozenset[str]


Maker = Callable[[Random], Answer]


def document(ask: str, **more: Any) -> dict[str, Any]:  # noqa: ANN401  keys of an exercise
    """An exercise of one part, as its file holds it."""
    part = {"id": "a", "ask": ask, **{key: more.pop(key) for key in ("options", "right", "exact") if key in more}}
    found = {"format": 1, "title": "x", "source": "x", "task": "x", "robot": "planar-2r", **more, "parts": [part]}
    return {key: value for key, value in found.items() if value is not None}


FILES: dict[int, str] = {}
"""The text of each exercise that was made, by its identity; none of them is ever forgotten."""


@cache
def asked(text: str) -> tuple[Exercise, Part]:
    """The exercise that a document describes, and its part."""
    exercise = read_exercise(text, "x.yaml", "x")
    FILES[id(exercise)] = text
    return exercise, exercise.parts[0]


def exercise_of(ask: str, **more: Any) -> tuple[Exercise, Part]:  # noqa: ANN401  keys of an exercise
    """The same, made once."""
    lines = (f"{key}: {json.dumps(part, ensure_ascii=False)}\n" for key, part in document(ask, **more).items())
    return asked("".join(lines))


def cells_of(text: str) -> list[list[str]]:
    """The cells of an answer in dhcli's own writing."""
    if not text.startswith("[["):
        return [[text]]
    return [row.split(", ") for row in text[2:-2].split("], [")]


def written(rows: list[list[str]]) -> str:
    """Cells as they are typed."""
    return rows[0][0] if len(rows) == len(rows[0]) == 1 else "[" + ", ".join(f"[{', '.join(r)}]" for r in rows) + "]"


NOTHING = ("zero of decimals", "no root", "no arc")
"""Mutations whose numbers may be refused before anything is compared."""


def fair_formula(typed: str, right: str, made: str) -> set[str]:
    """What a formula may be judged, by where it agrees with the right one."""
    fair = _by_agreement(typed, right)
    return fair | {UNREAD} if WRONG in fair and any(kind in made for kind in NOTHING) else fair


def _by_agreement(typed: str, right: str) -> set[str]:
    if right == "0" or not math.isfinite(distance(typed, right)):
        share = agreement(typed, right)
        return {RIGHT} if share == 1 else {WRONG, UNREAD}
    if agreement(typed, right) == 1:
        return {RIGHT}
    return {WRONG, ROUNDED} if distance(typed, right) < 0.05 else {WRONG}


def in_symbols(kind: str) -> Maker:
    """One cell of a matrix in formulas changed."""

    def make(draw: Random) -> Answer:
        exercise, part = exercise_of(MATRICES[kind])
        rows = cells_of(expected(exercise, part, "full"))
        free = [(r, c) for r, row in enumerate(rows) for c, cell in enumerate(row) if any(map(str.isalpha, cell))]
        r, c = draw.choice(free)
        right = rows[r][c]
        rows[r][c], made = mutated(right, draw)
        return Answer(exercise, part, written(rows), made, frozenset(fair_formula(rows[r][c], right, made)))

    return make


OFF = (0.0, 0.5, -0.9, 0.99, 1.5, -4.0, 9.0, 12.0, -60.0)
"""Errors in tolerances."""


def in_numbers(kind: str) -> Maker:
    """A cell of a matrix in numbers off by so many tolerances, all lengths in another unit, or both."""

    def make(draw: Random) -> Answer:
        unit = draw.choice(("m", "mm", "cm"))
        metres = {"m": 1.0, "mm": 1e-3, "cm": 1e-2}[unit]
        symbols = cells_of(expected(*exercise_of(MATRICES[kind]), "full"))
        exercise, part = exercise_of(MATRICES[kind], given=GIVEN, numeric=True, unit=unit)
        columns = len(symbols[0])
        lengths = kind in ("position", "point", "entry")
        size = {"link": AT["a2"], "point": 2 * (AT["a1"] + AT["a2"])}.get(kind, AT["a1"] + AT["a2"])
        off, other = draw.choice(OFF), draw.choice((1.0, 1.0, {"m": 1e3, "mm": 1e-3, "cm": 10.0}[unit]))
        places = [(r, c) for r in range(min(len(symbols), 3)) for c in range(columns)]
        wrong = draw.choice(places)
        rows, moved = [], False
        for r, row in enumerate(symbols):
            rows.append([])
            for c, cell in enumerate(row):
                exact = value(cell, AT)
                is_length = lengths or (columns == 4 and c == 3 and r < 3)
                tolerance = 1e-3 * size if is_length else ROTATION
                number = exact + (off * tolerance if (r, c) == wrong else 0.0)
                if is_length:
                    moved = moved or abs(exact) > tolerance
                    number *= other
                    text = draw.choice((f"{number / metres:.12f}", f"{number * 1000:.9f} mm" if other == 1 else ""))
                    rows[r].append(text or f"{number / metres:.12f}")
                else:
                    rows[r].append(f"{number:.12f}" if r < 3 else cell)
        made = f"off {off}, times {other}, unit {unit}"
        return Answer(exercise, part, written(rows), made, frozenset(_fair_number(off, other if moved else 1.0)))

    return make


def _fair_number(off: float, other: float) -> set[str]:
    if other != 1:
        return {UNREAD} if abs(off) <= 1 else {WRONG}
    return {RIGHT} if abs(off) <= 1 else {CLOSE} if abs(off) <= 10 else {WRONG}


def scalar(draw: Random) -> Answer:
    """A formula of lengths, in symbols."""
    exercise, part = exercise_of("scalar a1*cos(theta1) + a2*sin(theta1 + theta2)")
    right = "a1*cos(theta1) + a2*sin(theta1 + theta2)"
    text, made = mutated(right, draw)
    return Answer(exercise, part, text, made, frozenset(fair_formula(text, right, made)))


ARCS = (
    "atan2(py, px)", "atan(py/px)", "acos(px/sqrt(px^2 + py^2))", "asin(py/sqrt(px^2 + py^2))",
    "2*atan(py/(px + sqrt(px^2 + py^2)))", "atan2(-py, -px) + pi", "atan2(px, py)", "pi/2 - atan2(px, py)",
    "-atan2(-py, px)", "atan2(py, px) - 2*pi", "atan2(2*py, 2*px)", "atan2(py^2, px^2)", "acos(2) + 0*atan2(py, px)",
    "atan(py/px) + pi", "atan2(py*px, px*px)",
)  # fmt: skip


def angle(draw: Random) -> Answer:
    """An angle by an inverse function of coordinates, which have both signs."""
    exercise, part = exercise_of("scalar atan2(py, px)", robot=None, names=["px", "py"])
    text, shift = draw.choice(ARCS), draw.choice(("", "", " + 2*pi", " - 4*pi", " + pi/6", " + 0.001 rad"))
    text += shift
    plain = text.replace(" rad", "")
    share = _agreement_of_angles(plain, "atan2(py, px)")
    return Answer(exercise, part, text, text, frozenset({RIGHT} if share == 1 else {WRONG, UNREAD}))


def _agreement_of_angles(typed: str, right: str) -> float:
    found = [{"px": x, "py": y} for x, y in _coordinates()]
    agreed = [same_turn(value(typed, at), value(right, at)) for at in found if math.isfinite(value(typed, at))]
    return sum(agreed) / len(found)


def _coordinates() -> Iterator[tuple[float, float]]:
    draw = Random(3)  # noqa: S311  the same each time
    for _ in range(40):
        yield draw.uniform(-2, 2), draw.uniform(-2, 2)


def angle_in_numbers(draw: Random) -> Answer:
    """An angle in degrees or radians, off by so much."""
    given = {"px": "0.3 m", "py": "-0.4 m"}
    exercise, part = exercise_of(
        "scalar atan2(py, px)", robot=None, names=["px", "py"], given=given, numeric=True, unit="mm"
    )
    off, turns = draw.choice(OFF), draw.choice((-1, 0, 0, 2))
    degrees = math.degrees(math.atan2(-0.4, 0.3)) + 0.05 * off + 360 * turns
    text = draw.choice((f"{degrees:.9f}", f"{degrees:.9f}°", f"{math.radians(degrees):.12f} rad", f"{degrees:.9f} deg"))
    wrong = draw.choice((False, False, False, True))
    if wrong:
        return Answer(exercise, part, f"{degrees:.9f} m", "a length", frozenset({UNREAD}))
    return Answer(exercise, part, text, f"off {off}", frozenset(_fair_number(off, 1.0)))


def cell(draw: Random) -> Answer:
    """A twist of a table: the same modulo a full turn."""
    exercise, part = exercise_of("cell alpha 2", robot="puma560")
    turns, off = draw.choice((-(10**15), -2, 0, 0, 1)), draw.choice((0.0, 0.04, 0.2, 1.0, 90.0, 180.0))
    degrees = -90 + 360 * turns
    number = Fraction(degrees) + Fraction(str(off))
    text = draw.choice(("{n}", "{n}°", "{n}*pi/180", "({n}) deg")).format(n=_decimal(number))
    fair = {UNREAD} if abs(turns) > 2 else {RIGHT} if off <= 0.05 else {CLOSE} if off <= 0.5 else {WRONG}
    return Answer(exercise, part, text, f"off {off}°", frozenset(fair))


def cell_of_length(draw: Random) -> Answer:
    """A length of a table in a unit."""
    unit = draw.choice(("m", "mm", "cm"))
    exercise, part = exercise_of("cell a 1", unit=unit, numeric=True)
    off, own = draw.choice((0.0, 0.9, -3.0, 40.0)), draw.choice(("", " m", " mm", " cm"))
    metres = {"m": 1.0, "mm": 1e-3, "cm": 1e-2}[own.strip() or unit]
    number = 0.4 * (1 + off * 1e-3)
    fair = {RIGHT} if abs(off) <= 1 else {CLOSE} if abs(off) <= 10 else {WRONG}
    return Answer(exercise, part, f"{number / metres:.9f}{own}", f"off {off} in {unit}", frozenset(fair))


def _decimal(number: Fraction) -> str:
    return str(int(number)) if number.denominator == 1 else f"{int(number * 100)}/100"


def factors(draw: Random) -> Answer:
    """The moves of a link turned full turns further, in another order, with one forgotten, or with one too many."""
    exercise, part = exercise_of("factors 2", robot="scara-yim")
    moves = expected(exercise, part).replace(") ", ")|").split("|")
    right, made = True, draw.choice(("as it is", "full turn", "nothing", "order", "forgotten", "twice", "turned"))
    k = draw.randrange(len(moves))
    still = "Trans(0, 0, 0)", "Rot(x, 0)", "Rot(z, 0)"
    if made == "full turn":
        moves = [m[:-1] + draw.choice((" + 360°)", " - 720°)")) if m.startswith("Rot") else m for m in moves]
    elif made == "nothing":
        moves.insert(k, draw.choice(("Trans(0, 0, 0)", "Rot(y, 360°)", "Rot(x, 0)")))
    elif made == "order":
        kept = [m for m in moves if m not in still]
        moves, right = kept[::-1], len(kept) < 2
    elif made in ("forgotten", "twice", "turned"):
        right = moves[k] in still
        if made == "turned":
            right = False
            moves[k] = f"Rot(y, 5°) {moves[k]}"
        else:
            moves[k : k + 1] = [moves[k]] * 2 if made == "twice" else []
    text = " ".join(moves) or "Rot(x, 0)"
    return Answer(exercise, part, text, made, frozenset({RIGHT if right else WRONG}))


COUNTS = ("{n}", "{n}.0", "{m}+1", "2*{n}/2", "M = {n}", "{n}.0000000000000001", "{m}.9999999999999999", "{n}/1",
          "-{n}", "{m}", "{n} mm", "7 = {n}", "{n}.5", "{n}e0", "10*{n}", "sqrt({n}^2)")  # fmt: skip


def count(draw: Random) -> Answer:
    """A whole number by another way, another one, or one that is nearly whole."""
    exercise, part = exercise_of("count mobility 6R", robot=None)
    right = int(expected(exercise, part))
    text = draw.choice(COUNTS).format(n=right, m=right - 1)
    if "=" in text or "mm" in text:
        return Answer(exercise, part, text, text, frozenset({RIGHT} if text.startswith("M") else {UNREAD}))
    is_root, plain = text.startswith("sqrt"), text
    number = Fraction(right) if is_root else _exact(plain)
    fair = {RIGHT} if number == right else {WRONG} if number.denominator == 1 else {UNREAD}
    return Answer(exercise, part, text, text, frozenset(fair))


def _exact(text: str) -> Fraction:
    """Sums, products and quotients of decimals, exactly."""
    if "+" in text:
        return sum((Fraction(part) for part in text.split("+")), Fraction(0))
    total = Fraction(1)
    for part in text.replace("/", "*1/").split("*"):
        total *= 1 / Fraction(part[2:]) if part.startswith("1/") else Fraction(part)
    return total


def choice(draw: Random) -> Answer:
    """The number or the letter of a statement."""
    exercise, part = exercise_of("choice", options=["one", "two", "three"], right=2)
    text = draw.choice(("1", "2", "3", "b", "(b)", "2.", "2: two", "two", "TWO", "one", "4", "0", "2.0", "-2"))
    right = text in {"2", "b", "(b)", "2.", "2: two", "two", "TWO"}
    fair = {RIGHT} if right else {WRONG} if text in {"1", "3", "one"} else {UNREAD}
    return Answer(exercise, part, text, text, frozenset(fair))


KINDS: dict[str, Maker] = {
    **{f"{kind} in symbols": in_symbols(kind) for kind in MATRICES},
    **{f"{kind} in numbers": in_numbers(kind) for kind in MATRICES},
    "scalar": scalar,
    "angle": angle,
    "angle in numbers": angle_in_numbers,
    "cell": cell,
    "cell of a length": cell_of_length,
    "factors": factors,
    "count": count,
    "choice": choice,
}
