"""What makes a description a robot; every rule that a file or a caller can break, in one place."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from dhcli.algebra.floats import Floats
from dhcli.errors import Problem, RobotError, did_you_mean, plural
from dhcli.frozen import frozen
from dhcli.kinematics.derived import Value, in_floats
from dhcli.kinematics.description import Description, Link
from dhcli.kinematics.moves import Chain, Fixed, Trans, angle_names, expressions, names
from dhcli.notation.angle import Angle
from dhcli.notation.derivative import derivative
from dhcli.notation.names import canonical
from dhcli.notation.parser import RESERVED
from dhcli.notation.quantity import UNITS, is_affine, value_text
from dhcli.notation.scope import trig_name
from dhcli.notation.tokens import is_name
from dhcli.notation.tree import Expr, Number, Trig
from dhcli.notation.walk import angles_in, symbols

A_NAME = "write letters from a to z or Greek ones, with digits or an index: elbow_1, l_x"


@frozen
class Finding:
    """One broken rule.

    Attributes:
        where: Path to the part, such as ("links", 2, "theta"), for a loader that knows where it stands.
        message: What is wrong.
        hint: What would be right.
        is_warning: Whether an author may well leave it as it is.
    """

    where: tuple[str | int, ...]
    message: str
    hint: str = ""
    is_warning: bool = False


class InvalidRobotError(RobotError):
    """A description that is no robot.

    Attributes:
        findings: Every broken rule.
    """

    def __init__(self, name: str, findings: tuple[Finding, ...]) -> None:
        """Collect the findings of one robot."""
        self.findings = findings
        paths = (".".join(str(part) for part in finding.where) for finding in findings)
        super().__init__(
            Problem(f"{name}: {p}: {f.message}", None, f.hint) for p, f in zip(paths, findings, strict=True)
        )


def check(robot: Description) -> None:
    """Raise if anything is wrong with a robot.

    Raises:
        InvalidRobotError: With all findings.
    """
    if found := tuple(findings(robot)):
        raise InvalidRobotError(robot.name, found)


def findings(robot: Description, doubtful: frozenset[str] = frozenset()) -> Iterator[Finding]:
    """Every broken rule.

    Args:
        robot: What is described.
        doubtful: Variables that move no link as far as it could be read, and may move one all the same.
    """
    yield from _names(robot)
    yield from _shorthand(robot)
    yield from _links(robot, doubtful)
    yield from _frames(robot)
    yield from _limits(robot)
    yield from _poses(robot)
    yield from _called(robot)


def _names(robot: Description) -> Iterator[Finding]:
    seen: dict[str, str] = {}
    for section, listed in (("variables", robot.variables), ("parameters", tuple(robot.parameters))):
        for index, name in enumerate(listed):
            where = (section, index if section == "variables" else name)
            if not is_name(name):
                yield Finding(where, f"{name!r:.60} is not a name", A_NAME)
            elif name in RESERVED or name in UNITS:
                yield Finding(where, f"{name} has a meaning of its own", "choose another name")
            if canonical(name) in seen:
                yield Finding(where, f"{name} is used twice", f"{seen[canonical(name)]} is declared already")
            seen.setdefault(canonical(name), name)


def _shorthand(robot: Description) -> Iterator[Finding]:
    for name in robot.parameters:
        others = [trig_name(reading) for reading in robot.scope.readings(name) if isinstance(reading, Trig)]
        if others:
            yield Finding(("parameters", name), f"{name} is short for {others[0]} here", "choose another name")


def _links(robot: Description, doubtful: frozenset[str]) -> Iterator[Finding]:
    used: dict[str, int] = {}
    idle = _idle(robot) - doubtful
    declared = {*robot.variables, *robot.parameters}
    for index, link in enumerate(robot.links):
        inside = names(link.moves)
        for name in sorted(inside - declared):
            yield Finding(("links", index), f"{name} is not declared", did_you_mean(name, declared))
        moving = sorted(inside & set(robot.variables), key=robot.variables.index)
        movers = {names((move,)).intersection(moving) for move in link.moves} - {frozenset()}
        if len(moving) > 1 and len(movers) > 1:
            yield Finding(
                ("links", index),
                f"one link has two variables, {' and '.join(moving)}",
                "give each joint a link of its own",
            )
        for name in moving:
            if name in used and idle:  # all of them move something: the two rows are meant
                hint = f"it moves link {robot.links[used[name]].number} already"
                yield Finding(("links", index), f"{name} is used twice", hint)
            used.setdefault(name, index)
        yield from _affine(link, index, moving, angle_names(link.moves if idle else robot.chain))
        yield from _matrices(link.moves, ("links", index))
    for index, name in enumerate(robot.variables):
        if name in idle:
            yield Finding(("variables", index), f"{name} moves no link", "use it in a row, or make it a parameter")


def _affine(link: Link, index: int, moving: list[str], turning: frozenset[str]) -> Iterator[Finding]:
    lengths: list[tuple[tuple[str | int, ...], Expr]] = [(("links", index), e) for e in expressions(link.moves)]
    if link.row is not None:
        lengths = [(("links", index, "a"), link.row.a), (("links", index, "d"), link.row.d)]
    for name in moving:
        for where, expr in lengths:
            if name not in symbols(expr):
                continue
            if not is_affine(expr, name) or _inside_angle(expr, name):
                yield Finding(where, f"{expr} is not affine in {name}", f"write a multiple of {name} plus a constant")
                continue
            slope = derivative(expr, name)
            if symbols(slope).intersection(moving):
                yield Finding(where, f"{expr} is not linear in the joints", "write a sum of multiples of them")
            elif name in turning and slope in (Number(Fraction(1)), Number(Fraction(-1))):
                hint = f"a joint turns or slides; a screw has a lead: p*{name}"
                yield Finding(where, f"{name} stands for an angle and for a length", hint)


def _inside_angle(expr: Expr, name: str) -> bool:
    return name in angles_in(expr)


def _frames(robot: Description) -> Iterator[Finding]:
    tools = ((("tools", name), chain) for name, chain in robot.tools.items())
    for where, chain in ((("base",), robot.base), (("tool",), robot.tool), *tools):
        part = where[-1]
        for name in sorted(names(chain)):
            if name in robot.variables:
                yield Finding(where, f"{name} is a joint variable, and {part} does not move", "make it a link")
            elif name not in robot.parameters:
                yield Finding(where, f"{name} is not declared", did_you_mean(name, robot.parameters))
        yield from _matrices(chain, where)


def _matrices(chain: Chain, where: tuple[str | int, ...]) -> Iterator[Finding]:
    for move in chain:
        if isinstance(move, Fixed):
            from dhcli.geometry.orthonormal import not_a_rotation  # most robots have no literal matrix

            fault = not_a_rotation(move.rows)
            if fault:
                yield Finding(where, fault, "its first three columns must be perpendicular unit vectors, right-handed")
        if isinstance(move, Trans | Fixed):
            for expr in expressions((move,)):
                if isinstance(expr, Number) or not symbols(expr):
                    value = Floats().value(expr)
                    if value != value:  # noqa: PLR0124  NaN
                        yield Finding(where, f"{expr} is not a real number")


def _idle(robot: Description) -> set[str]:
    """Variables that move nothing; where there are any, one that moves two rows was meant for one of them."""
    return {*robot.variables}.difference(*(names(link.moves) for link in robot.links))


def _kinds(robot: Description) -> dict[str, str]:
    """What each joint does; not of one that moves two rows by mistake, which is told and may be neither."""
    idle = _idle(robot)
    rows = [name for link in robot.links for name in names(link.moves) & set(robot.variables)]
    return {joint.name: joint.kind for joint in robot.joints if not idle or rows.count(joint.name) == 1}


def _limits(robot: Description) -> Iterator[Finding]:
    kinds = _kinds(robot)
    for name, (low, high) in robot.limits.items():
        where = ("limits", name)
        if name not in robot.variables:
            yield Finding(where, f"{name} is not a joint variable", did_you_mean(name, robot.variables))
            continue
        yield from _kind(where, name, kinds.get(name, ""), (low, high))
        if in_floats(low) >= in_floats(high):
            swapped = f"[{value_text(high)}, {value_text(low)}]" if in_floats(low) > in_floats(high) else ""
            hint = f"write {swapped or '[lowest, highest]'}"
            yield Finding(where, "the lower limit is not below the upper one", hint)


def _poses(robot: Description) -> Iterator[Finding]:
    kinds = _kinds(robot)
    for pose, values in robot.poses.items():
        if len(values) != len(robot.variables):
            message = f"{plural(len(values), 'value')} for {plural(len(robot.variables), 'joint')}"
            yield Finding(("poses", pose), message, "one for each of " + ", ".join(robot.variables))
            continue
        for name, value in zip(robot.variables, values, strict=True):
            yield from _kind(("poses", pose), name, kinds.get(name, ""), (value,))


def _called(robot: Description) -> Iterator[Finding]:
    own = {canonical(name): name for name in robot.variables}
    seen: dict[str, str] = {}
    for variable, name in robot.called.items():
        where = ("called", variable)
        if variable not in robot.variables:
            yield Finding(where, f"{variable} is not a joint variable", did_you_mean(variable, robot.variables))
        elif name in seen or own.get(canonical(name), variable) != variable:
            other = seen.get(name) or own[canonical(name)]
            yield Finding(where, f"{name} would be {variable} and {other}", "give each joint a name of its own")
        seen.setdefault(name, variable)


def _kind(where: tuple[str | int, ...], name: str, kind: str, values: tuple[Value, ...]) -> Iterator[Finding]:
    for value in values:
        if kind == "revolute" and not isinstance(value, Angle):
            yield Finding(where, f"{name} turns, and {value} is not an angle", "write 90° or 1.57 rad")
        if kind == "prismatic" and isinstance(value, Angle) and not value.is_zero:
            yield Finding(where, f"{name} slides, and an angle is no length", "write 300 mm or 0.3 m")
