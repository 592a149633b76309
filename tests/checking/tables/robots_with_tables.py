"""Tables, what keeps their motion, and an oracle that knows nothing of the product: numpy and rows of numbers."""

from __future__ import annotations

import random
from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from itertools import pairwise
from pathlib import Path

import numpy as np
from hypothesis import strategies as st
from numpy.typing import NDArray

from dhcli import load_robot
from dhcli.geometry.rigid import Rigid
from dhcli.kinematics.axes import Arm
from dhcli.kinematics.conventions import Convention, Row, moves_of
from dhcli.kinematics.robot import Robot
from dhcli.kinematics.same_robot import Match
from dhcli.notation.angle import Angle
from dhcli.notation.tree import ZERO, Expr, Symbol, add, negate, number
from dhcli.notation.walk import symbols
from tests.coupled import COUPLED

Rows = tuple[Row, ...]
Matrix = NDArray[np.float64]

ROOT = Path(__file__).parents[3] / "robots"
NAMES = tuple(
    path.stem
    for path in sorted(ROOT.glob("*.yaml"))
    if "convention: product" not in path.read_text(encoding="utf-8") and path.stem not in COUPLED
)
HALF_TURN = Angle.in_degrees(180)
ROBOTS: dict[str, Robot] = {}


def robot(name: str) -> Robot:
    """A robot of the library, loaded once."""
    if name not in ROBOTS:
        ROBOTS[name] = load_robot(str(ROOT / f"{name}.yaml"))
    return ROBOTS[name]


def rows_of(name: str) -> Rows:
    """Its table."""
    return tuple(link.row for link in robot(name).links if link.row is not None)


def arm(rows: Rows, convention: Convention, variables: Sequence[str]) -> Arm:
    """The chain of a table."""
    return Arm.of(tuple(move for row in rows for move in moves_of(row, convention)), tuple(variables))


# --- what keeps the motion -------------------------------------------------------------------------------------------


def flip_x(rows: Rows, i: int, convention: Convention) -> Rows:
    """Turn x_i round."""
    one, two = rows[i], rows[i + 1]
    if convention is Convention.STANDARD:
        one = Row(negate(one.a), -one.alpha, one.d, one.theta + HALF_TURN)
        two = Row(two.a, two.alpha, two.d, two.theta - HALF_TURN)
    else:
        one = Row(one.a, one.alpha, one.d, one.theta + HALF_TURN)
        two = Row(negate(two.a), -two.alpha, two.d, two.theta - HALF_TURN)
    return (*rows[:i], one, two, *rows[i + 2 :])


def flip_z(rows: Rows, i: int, convention: Convention) -> Rows:
    """Turn z_i round; what turns or slides along it then counts backwards."""
    one, two = rows[i], rows[i + 1]
    if convention is Convention.STANDARD:
        one = Row(one.a, one.alpha + HALF_TURN, one.d, one.theta)
        two = Row(two.a, two.alpha - HALF_TURN, negate(two.d), -two.theta)
    else:
        one = Row(one.a, one.alpha + HALF_TURN, negate(one.d), -one.theta)
        two = Row(two.a, two.alpha - HALF_TURN, two.d, two.theta)
    return (*rows[:i], one, two, *rows[i + 2 :])


def _between(rows: Rows, i: int, convention: Convention) -> Row:
    """The row whose twist and length lie between axis z_{i-1} and z_i, or z_i and z_{i+1}."""
    return rows[i] if convention is Convention.STANDARD else rows[i + 1]


def shift(rows: Rows, i: int, convention: Convention, by: Expr) -> Rows:
    """Split two offsets differently, along parallel axes; nothing where they are not parallel."""
    between = _between(rows, i, convention).alpha
    if between.quarter_turns() not in (0, 2):
        return rows
    back = negate(by) if between.quarter_turns() == 0 else by
    one, two = rows[i], rows[i + 1]
    one = Row(one.a, one.alpha, add(one.d, by), one.theta)
    two = Row(two.a, two.alpha, add(two.d, back), two.theta)
    return (*rows[:i], one, two, *rows[i + 2 :])


def twist(rows: Rows, i: int, convention: Convention, by: Angle) -> Rows:
    """Split two angles differently, about one axis; nothing where there are two."""
    between = _between(rows, i, convention)
    if between.alpha.quarter_turns() not in (0, 2) or between.a != ZERO:
        return rows
    back = -by if between.alpha.quarter_turns() == 0 else by
    one, two = rows[i], rows[i + 1]
    one = Row(one.a, one.alpha, one.d, one.theta + by)
    two = Row(two.a, two.alpha, two.d, two.theta + back)
    return (*rows[:i], one, two, *rows[i + 2 :])


Move = Callable[[Rows, Convention], Rows]


@st.composite
def keeping(draw: st.DrawFn, lengths: Sequence[Expr] = (number(Fraction(1, 8)), Symbol("delta"))) -> Move:
    """A move between neighbouring rows that keeps T(q)."""
    share = draw(st.floats(0, 0.999))
    kind = draw(st.sampled_from(("flip_x", "flip_z", "shift", "twist")))
    by, angle = draw(st.sampled_from(lengths)), Angle.in_degrees(draw(st.sampled_from((90, -90, 180, 30))))

    def move(rows: Rows, convention: Convention) -> Rows:
        if len(rows) < 2:
            return rows
        i = int(share * (len(rows) - 1))
        if kind in ("flip_x", "flip_z"):
            return {"flip_x": flip_x, "flip_z": flip_z}[kind](rows, i, convention)
        return shift(rows, i, convention, by) if kind == "shift" else twist(rows, i, convention, angle)

    return move


def recounted(rows: Rows, variables: Sequence[str], index: int, sense: int, degrees: int, metres: Expr) -> Rows:
    """The table with another sense and zero of one joint."""
    name = variables[index]
    zero = add(negate(Symbol(name)) if sense < 0 else Symbol(name), metres)
    angle = Angle.of(name) * sense + Angle.in_degrees(degrees)

    def length(expr: Expr) -> Expr:
        from dhcli.notation.walk import substitute

        return substitute(expr, {name: zero}, {})

    return tuple(Row(length(row.a), row.alpha, length(row.d), row.theta.substitute({name: angle})) for row in rows)


# --- what changes it -------------------------------------------------------------------------------------------------


def mutations(rows: Rows, variables: Sequence[str]) -> list[tuple[str, Rows]]:
    """Each single slip of the classic kind that can be made in a table."""
    found: list[tuple[str, Rows]] = []
    for i, row in enumerate(rows):
        moving = bool(symbols(row.d) & set(variables))
        candidates = {
            "sign of alpha": Row(row.a, -row.alpha, row.d, row.theta),
            "alpha forgotten": Row(row.a, Angle(), row.d, row.theta),
            "sign of a": Row(negate(row.a), row.alpha, row.d, row.theta),
            "another length": Row(add(row.a, Symbol("b9")), row.alpha, row.d, row.theta),
            "another offset": Row(row.a, row.alpha, add(row.d, Symbol("b9")), row.theta),
        }
        if not moving:
            candidates["a and d swapped"] = Row(row.d, row.alpha, row.a, row.theta)
            candidates["sign of d"] = Row(row.a, row.alpha, negate(row.d), row.theta)
        if not row.theta.names:
            candidates["fixed angle"] = Row(row.a, row.alpha, row.d, row.theta + Angle.in_degrees(90))
        found += [
            (f"{what} in row {i + 1}", (*rows[:i], changed, *rows[i + 1 :]))
            for what, changed in candidates.items()
            if what != "sign of alpha" or row.alpha.quarter_turns() not in (0, 2)
            if changed != row
        ]
    return found


# --- an oracle -------------------------------------------------------------------------------------------------------


def _about(axis: str, angle: float) -> Matrix:
    c, s = np.cos(angle), np.sin(angle)
    if axis == "z":
        return np.array([[c, -s, 0, 0], [s, c, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]], dtype=np.float64)
    return np.array([[1, 0, 0, 0], [0, c, -s, 0], [0, s, c, 0], [0, 0, 0, 1]], dtype=np.float64)


def _along(axis: str, length: float) -> Matrix:
    shift = np.eye(4)
    shift["xyz".index(axis), 3] = length
    return shift


def value(what: Expr | Angle, values: Mapping[str, float]) -> float:
    """A cell in metres or radians, by Python's own arithmetic on the written form."""
    if isinstance(what, Angle):
        return (
            float(np.radians(float(what.degrees)))
            + float(what.radians)
            + sum(float(k) * values[n] for n, k in what.terms)
        )
    return float(eval(_plain(str(what)), {}, dict(values)))  # noqa: S307


def fk(rows: Rows, convention: Convention, values: Mapping[str, float]) -> Matrix:
    """The product of a table in numpy."""
    pose = np.eye(4)
    known = {**values, **{_plain(name): number for name, number in values.items()}}
    for row in rows:
        a, alpha, d, theta = (value(cell, known) for cell in (row.a, row.alpha, row.d, row.theta))
        turn, reach = _about("z", theta) @ _along("z", d), _along("x", a) @ _about("x", alpha)
        pose = pose @ turn @ reach if convention is Convention.STANDARD else pose @ reach @ turn
    return pose


def _plain(name: str) -> str:
    return name.replace("{", "").replace("}", "").replace("i-1", "im1")


def matrix(rigid: Rigid) -> Matrix:
    """A rigid motion for numpy."""
    return np.array([[*row, x] for row, x in zip(rigid.rows, rigid.offset, strict=True)] + [[0, 0, 0, 1]])


def holds(
    match: Match,
    truth: Rows,
    other: Rows,
    convention: Convention,
    variables: Sequence[str],
    point: Mapping[str, float],
    seed: int = 0,
) -> bool:
    """Whether `T'(q) = B T(σq + q0) E` at random q, computed by numpy alone."""
    draw = random.Random(seed)  # noqa: S311
    for _ in range(6):
        q = {name: draw.uniform(-3, 3) for name in variables}
        there = {n: s * q[n] + z for n, s, z in zip(variables, match.senses, match.zeros, strict=True)}
        right = matrix(match.base) @ fk(truth, convention, {**point, **there}) @ matrix(match.tool)
        if not np.allclose(right, fk(other, convention, {**point, **q}), atol=1e-6):
            return False
    return True


def invariants(rows: Rows, convention: Convention, variables: Sequence[str], point: Mapping[str, float]) -> list[float]:
    """Numbers that no base, tool, sense or zero can change: Klein and Killing forms of neighbouring joints."""
    zero = {**point, **dict.fromkeys(variables, 0.0)}
    twists = []
    for name in variables:
        step = 1e-6
        rate = (fk(rows, convention, {**zero, name: step}) - fk(rows, convention, {**zero, name: -step})) / (2 * step)
        twist = rate @ np.linalg.inv(fk(rows, convention, zero))
        twists.append((np.array([twist[2, 1], twist[0, 2], twist[1, 0]]), twist[:3, 3]))
    found = []
    for (w1, v1), (w2, v2) in pairwise(twists):
        found += [abs(float(w1 @ w2)), abs(float(w1 @ v2 + w2 @ v1))]
    return found
