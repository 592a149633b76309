"""Symbolic products: textbook form beside multiplying and simplifying in sympy, with the operations of both."""

from __future__ import annotations

import random
from collections.abc import Callable, Iterator
from fractions import Fraction

import sympy
from measure import Row, side_by_side

from dhcli import Pose, Robot, load_robot, symbolic
from dhcli.algebra.symbolic import to_sympy
from dhcli.kinematics.conventions import Convention
from dhcli.notation.angle import Angle
from dhcli.notation.walk import operations

ROBOTS = ("planar-2r", "scara-yim", "stanford", "puma560")
CLOSE = 1e-9


def rows(rounds: int, robots: tuple[str, ...] = ROBOTS) -> Iterator[Row]:
    """A row for each robot."""
    for name in robots:
        robot = load_robot(name)
        ours, theirs = symbolic(robot), multiplied(robot)
        compare(ours, theirs)
        own = sum(operations(entry) for row in ours.rows[:3] for entry in row)
        other = sum(map(binary_operations, theirs[:3, :]))
        yield side_by_side(
            f"symbolic T_0n of {name}",
            ("symbolic(robot)", task(symbolic, robot)),
            ("sympy, multiply and simplify", task(multiplied, robot)),
            rounds=rounds,
            note=f"operations: {own}, sympy's {other}",
        )


def binary_operations(expr: sympy.Expr) -> int:
    """+ - * / of a sympy expression, counted as ours are: functions and signs cost nothing."""
    counted = sympy.count_ops(expr, visual=True)
    return sum(int(counted.coeff(sympy.Symbol(name))) for name in ("ADD", "SUB", "MUL", "DIV"))


def task(work: Callable[[Robot], object], robot: Robot) -> Callable[[], object]:
    """The work on one robot, as a call without arguments."""
    return lambda: work(robot)


def multiplied(robot: Robot) -> sympy.Matrix:
    """The product of a robot's DH matrices as most people compute it."""
    product = sympy.eye(4)
    for link in robot.links:
        row = link.row
        a, d = to_sympy(row.a), to_sympy(row.d)
        twist, turn = radians(row.alpha), radians(row.theta)
        if robot.convention is Convention.MODIFIED:
            product = product * rot_x(twist) * trans(a, 0) * trans(0, d) * rot_z(turn)
        else:
            product = product * rot_z(turn) * trans(0, d) * trans(a, 0) * rot_x(twist)
    return product.applyfunc(sympy.simplify)


def compare(ours: Pose, theirs: sympy.Matrix) -> None:
    """Make sure that both say the same, at a random point."""
    draw = random.Random(5)  # noqa: S311  a point, not a secret
    point = {symbol: Fraction(draw.randint(1, 99), 50) for symbol in sorted(theirs.free_symbols, key=str)}
    difference = (ours.to_sympy() - theirs).subs(point)
    if any(abs(float(entry)) > CLOSE for entry in difference):
        raise SystemExit("the two products differ")


def radians(angle: Angle) -> sympy.Expr:
    """An exact angle as sympy writes it."""
    constant = sympy.Rational(angle.degrees.numerator, angle.degrees.denominator) * sympy.pi / 180
    return constant + sum(sympy.Symbol(name, real=True) * int(factor) for name, factor in angle.terms)


def rot_x(angle: sympy.Expr) -> sympy.Matrix:
    """Rotation about x."""
    c, s = sympy.cos(angle), sympy.sin(angle)
    return sympy.Matrix([[1, 0, 0, 0], [0, c, -s, 0], [0, s, c, 0], [0, 0, 0, 1]])


def rot_z(angle: sympy.Expr) -> sympy.Matrix:
    """Rotation about z."""
    c, s = sympy.cos(angle), sympy.sin(angle)
    return sympy.Matrix([[c, -s, 0, 0], [s, c, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])


def trans(x: sympy.Expr, z: sympy.Expr) -> sympy.Matrix:
    """Translation along x and z."""
    return sympy.Matrix([[1, 0, 0, x], [0, 1, 0, 0], [0, 0, 1, z], [0, 0, 0, 1]])
