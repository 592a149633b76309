"""Rules for robots: what the table needs is there, what is there is needed, and the numbers make sense."""

from __future__ import annotations

from collections.abc import Iterator

from dhcli.algebra.floats import Floats
from dhcli.files.yaml.templates import NAME
from dhcli.kinematics.derived import Value, in_floats
from dhcli.kinematics.description import Description
from dhcli.kinematics.limits import is_within_limits
from dhcli.kinematics.moves import names
from dhcli.kinematics.validity import Finding
from dhcli.kinematics.values import symbols_of
from dhcli.lint.wording import unfinished
from dhcli.notation.angle import Angle, magnitude
from dhcli.notation.quantity import value_text
from dhcli.notation.tree import Expr
from dhcli.notation.walk import symbols

FULL_TURN = 360


def findings(robot: Description, mentioned: frozenset[str] = frozenset()) -> Iterator[Finding]:
    """Every broken rule of a robot, apart from those about the size of its lengths.

    Args:
        robot: A robot, or what can be read of one.
        mentioned: Parameters that are used as far as anybody can tell.
    """
    texts: dict[tuple[str | int, ...], str] = {
        ("title",): robot.title,
        ("source",): robot.source,
        ("notes",): robot.notes,
    }
    yield from unfinished({where: text for where, text in texts.items() if text})
    if not NAME.fullmatch(robot.name):
        hint = "letters, digits, - and _, such as my-arm.yaml"
        yield Finding((), f"the file name '{robot.name}' is the name of the robot, and cannot be typed", hint)
    for remark in robot.remarks:
        yield Finding((), remark, "write the exact value, or `exact: false` to keep the digits", is_warning=True)
    yield from _parameters(robot, mentioned)
    yield from _rows(robot)
    yield from _poses(robot)


def _parameters(robot: Description, mentioned: frozenset[str]) -> Iterator[Finding]:
    used = mentioned | names(robot.chain).union(*(symbols(formula.expr) for formula in robot.derived.values()))
    for name, value in robot.parameters.items():
        where = ("parameters", name)
        if name not in used:
            yield Finding(where, f"{name}: no link uses it", "delete it, or put it into the table")
        elif isinstance(value, Expr) and not symbols(value):
            hint = "write 0 into the table, or leave its value open"
            if not Floats().value(value):
                yield Finding(where, f"{name}: is 0", hint, is_warning=True)


def _rows(robot: Description) -> Iterator[Finding]:
    for index, link in enumerate(robot.links):
        row = link.row
        if row is None:
            continue
        where: tuple[str | int, ...] = ("links", index)
        constants: tuple[Value, ...] = (row.a, row.alpha, row.d, row.theta)
        if all(_is_zero(value) for value in constants):
            message = f"row {index + 1} is all zeros: nothing moves, and nothing is moved"
            yield Finding(where, message, "did its joint variable get lost?")
        for column in ("alpha", "theta"):
            angle: Angle = getattr(row, column)
            if magnitude(angle.degrees) > FULL_TURN or abs(float(angle.radians)) > FULL_TURN / 57:
                message = f"{column} of row {index + 1}: {value_text(Angle((), angle.degrees, angle.radians))}"
                yield Finding((*where, column), f"{message} is more than a turn", "rad or °?", is_warning=True)
            for name, factor in angle.terms:
                if name in robot.variables and abs(factor) != 1:
                    message = f"{column} of row {index + 1}: one degree of {name} turns the joint by {factor}"
                    yield Finding((*where, column), message, f"write {name} or -{name}", is_warning=True)


def _poses(robot: Description) -> Iterator[Finding]:
    for pose, values in robot.poses.items():
        for name, value in zip(robot.variables, values, strict=False):
            low, high = robot.limits.get(name, (value, value))
            is_range = in_floats(low) < in_floats(high)  # else that is told
            if not is_range or symbols_of(value) or is_within_limits(robot, name, in_floats(value)):
                continue
            message = f"{pose}: {name} = {value_text(value)} is outside its limits"
            yield Finding(("poses", pose), message, f"{value_text(low)} to {value_text(high)}")


def _is_zero(value: Value) -> bool:
    return value.is_zero if isinstance(value, Angle) else not symbols(value) and not Floats().value(value)
