"""T_06 in symbols: textbook form beside multiplying and simplifying in sympy, with the operations of both."""

from __future__ import annotations

import random
from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction

import sympy
from measure import Row, Task, side_by_side
from sympy.core.cache import clear_cache

from dhcli import Pose, Robot, load_robot, symbolic
from dhcli.algebra.symbolic import to_sympy
from dhcli.kinematics.conventions import Convention
from dhcli.notation.angle import Angle
from dhcli.notation.tree import Expr
from dhcli.notation.walk import operations

ROBOTS = ("stanford", "puma560", "zhou-6r", "panda")
END = 6
CLOSE = 1e-9


def rows(rounds: int, robots: tuple[str, ...] = ROBOTS, end: int = END) -> Iterator[Row]:
    """A row for each robot."""
    for robot in map(load_robot, robots):
        counts: list[int] = []

        def same(ours: Pose[Expr], theirs: sympy.Matrix, counts: list[int] = counts) -> bool:
            counts += sum(operations(entry) for row in ours.rows[:3] for entry in row), sum(map(binary, theirs[:3, :]))
            return agree(ours.to_sympy(), theirs)

        row = side_by_side(
            f"T_0{end} of {robot.name}",
            Task("symbolic", lambda robot=robot: symbolic(robot, end=end)),
            Task("sympy, multiply and simplify", lambda robot=robot: multiplied(robot, end)),
            same,
            rounds=rounds,
        )
        yield replace(row, note=f"operations: {counts[0]}, sympy's {counts[1]}")


def binary(expr: sympy.Expr) -> int:
    """+ - * / and powers of a sympy expression, counted as ours are: sin(theta1 + theta2) is a name like s12."""
    named = expr.replace(sympy.cos, lambda angle: sympy.Symbol(f"cos {angle}"))
    named = named.replace(sympy.sin, lambda angle: sympy.Symbol(f"sin {angle}"))
    counted = sympy.count_ops(named, visual=True)
    return sum(int(counted.coeff(sympy.Symbol(name))) for name in ("ADD", "SUB", "MUL", "DIV", "POW"))


def multiplied(robot: Robot, end: int) -> sympy.Matrix:
    """The product of a robot's first DH matrices as most people compute it, with nothing remembered from before."""
    clear_cache()
    product = sympy.eye(4)
    for link in robot.links[:end]:
        row = link.row
        a, d = to_sympy(row.a), to_sympy(row.d)
        twist, turn = radians(row.alpha), radians(row.theta)
        if robot.convention is Convention.MODIFIED:
            product = product * rot_x(twist) * trans(a, 0) * trans(0, d) * rot_z(turn)
        else:
            product = product * rot_z(turn) * trans(0, d) * trans(a, 0) * rot_x(twist)
    return product.applyfunc(sympy.simplify)


def agree(ours: sympy.Matrix, theirs: sympy.Matrix) -> bool:
    """Whether two matrices have the same names and say the same at a random point."""
    draw = random.Random(5)  # noqa: S311  a point, not a secret
    names = sorted(ours.free_symbols | theirs.free_symbols, key=str)
    point = {name: Fraction(draw.randint(1, 99), 50) for name in names}
    return all(abs(float(entry)) < CLOSE for entry in (ours - theirs).subs(point))


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
