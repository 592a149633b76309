"""The derivation behind a question, and the same derivation with one slip in it, as a student may make it."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from fractions import Fraction
from functools import lru_cache, partial

from dhcli.checking.diagnosis.result import Slip
from dhcli.checking.exercise import Case
from dhcli.checking.kinds.linked import needed
from dhcli.checking.returned import Shown
from dhcli.checking.solving.goal import Target, of_robot
from dhcli.checking.solving.in_step import changed_step, slips_in_step, with_other
from dhcli.checking.units import ONE as METRE
from dhcli.checking.units import in_unit
from dhcli.errors import RobotError
from dhcli.frozen import frozen
from dhcli.kinematics.conventions import NAMES
from dhcli.kinematics.frames import between
from dhcli.kinematics.inverse.derivation import Derivation
from dhcli.kinematics.inverse.derive import NoFormError, derive
from dhcli.kinematics.inverse.derive_rules import Step
from dhcli.kinematics.inverse.derive_values import joint_values
from dhcli.kinematics.inverse.derive_words import atom_text, condition_text, level_text, named_text, value_text
from dhcli.kinematics.moves import names
from dhcli.kinematics.robot import Robot, Value
from dhcli.kinematics.values import numbers
from dhcli.notation.angle import Angle
from dhcli.notation.tree import ONE, ZERO, Product, Symbol, negate
from dhcli.notation.walk import put_for, substitute, symbols, walk
from dhcli.notation.writer import write


@frozen
class Slipped:
    """A derivation with a slip in it.

    Attributes:
        slip: The slip.
        derivation: The derivation that it leads to.
        at: The joint whose formula is changed; empty where many are.
    """

    slip: Slip
    derivation: Derivation
    at: str = ""


def derivation_of(case: Case, target: Target, unit: Fraction = METRE) -> Derivation | None:
    """The derivation for the robot and the frames asked about; None where no textbook form is found.

    Args:
        case: Where it is asked.
        target: What is to be reached.
        unit: Metres in a length of the derivation: its robot has its bare numbers in that unit.
    """
    robot = needed(case.exercise.robot)
    if target.along:  # the formulas are of the whole pose
        return None
    return _derived(_moved(robot, unit), *target.ends(robot), "position" if target.task == "position" else "pose")


_moved = lru_cache(maxsize=64)(in_unit)
"""Each mark asks for the same; without numbers in its table a robot is itself in every unit."""


@lru_cache(maxsize=64)
def _derived(robot: Robot, start: str, end: str, task: str) -> Derivation | None:
    """A derivation takes seconds where there are six joints, and every exercise on a robot asks for the same."""
    try:
        return derive(robot, start=start, end=end, task=task)
    except (NoFormError, RobotError):
        return None


def steps_shown(derivation: Derivation, upto: str = "") -> Iterator[Shown]:
    """The steps as a book has them, to the one that finds a joint."""
    joints = derivation.robot.writing
    yield Shown(f"{NAMES[derivation.robot.convention]}; T is the pose given, with the entries r11 to r33, px, py, pz")
    for step in derivation.steps:
        lines = [
            f"{write(one.left, 'short', joints)} = {write(one.right, 'short', joints)}    {level_text(derivation, one)}"
            for one in step.equations
        ]
        lines.append(f"{named_text(step.atom)} = {value_text(step, 'short', joints_of=derivation)}")
        lines += [said] if (said := condition_text(step, "short", derivation)) else []
        yield Shown("\n".join(lines))
        if upto and atom_text(step.atom) == upto:
            return


def moving_joints(robot: Robot, target: Target) -> tuple[str, ...]:
    """The joints between the frames asked about, in order."""
    there = names(between(robot, *target.ends(robot)))
    return tuple(name for name in robot.variables if name in there)


def values_at(
    derivation: Derivation, robot: Robot, values: Mapping[str, Value], entries: Mapping[str, float]
) -> list[dict[str, float]]:
    """What a derivation gives for the entries of a pose, one for each combination of signs that is real."""
    known: dict[str, Angle | float] = {**numbers(of_robot(robot, values)), **entries}
    try:
        return list(joint_values(derivation, known))
    except (ZeroDivisionError, OverflowError, KeyError):
        return []


def slipped(derivation: Derivation, robot: Robot) -> Iterator[Slipped]:
    """Every derivation with one slip in it."""
    for k, step in enumerate(derivation.steps):
        name = atom_text(step.atom)
        for slip, changed in slips_in_step(step, name):
            steps = (*derivation.steps[:k], changed, *derivation.steps[k + 1 :])
            yield Slipped(slip, replace(derivation, steps=steps), name)
    yield from _left_out(derivation, robot)
    yield from _wrist_from_whole(derivation)


def _left_out(derivation: Derivation, robot: Robot) -> Iterator[Slipped]:
    """A length that was forgotten: that of the hand, or an offset."""
    frames = robot.frames
    last = [frame for frame in frames if frame.isdecimal()][-1]
    end = frames.index(derivation.end)
    hand = names(between(robot, frames[frames.index(last) - 1], frames[end])) if end >= frames.index(last) else set()
    used = frozenset[str]().union(
        *(symbols(expr) for step in derivation.steps for expr in (step.value, step.spread or ONE))
    )
    for length in sorted(used & robot.parameters.keys() - robot.angles):
        is_hand = length in hand and len(derivation.steps) > 3  # noqa: PLR2004  an arm before the hand
        if is_hand:
            words = f"the wrist centre is not moved back by {length}: p is the origin of the hand"
            slip = Slip(f"not-moved-back {length}", words, "where is the point at which the wrist axes meet?")
            yield from _moved_wrong(derivation, length)
        else:
            slip = Slip(f"left-out {length}", f"{length} is left out", "follow the links from the base to the end")
        try:
            left = partial(substitute, lengths={length: ZERO}, angles={})
            steps = tuple(changed_step(step, left) for step in derivation.steps)
        except (ZeroDivisionError, ArithmeticError):
            continue
        yield Slipped(slip, replace(derivation, steps=steps))


def _moved_wrong(derivation: Derivation, length: str) -> Iterator[Slipped]:
    """The wrist centre moved from the hand along another axis of it than z, or away from the arm."""
    question = "along which axis of the hand does the length stand?"
    for column, axis in (("1", "x"), ("2", "y")):
        steps = tuple(_along(step, length, column) for step in derivation.steps)
        if steps != derivation.steps:
            slip = Slip(
                f"moved-along-{axis} {length}", f"the wrist centre is moved back by {length} along {axis}", question
            )
            yield Slipped(slip, replace(derivation, steps=steps))
    steps = tuple(with_other(step, Symbol(length), negate(Symbol(length))) for step in derivation.steps)
    slip = Slip(f"moved-on {length}", f"the wrist centre is moved on by {length}, not back", "which way does z point?")
    yield Slipped(slip, replace(derivation, steps=steps))


def _along(step: Step, length: str, column: str) -> Step:
    """A step in which a length stands along another column of the rotation."""
    exprs = [step.value, *([step.spread] if step.spread is not None else [])]
    for node in {node for expr in exprs for node in walk(expr) if isinstance(node, Product)}:
        factors = set(node.factors)
        for row in "123":
            old = Symbol(f"r{row}3")
            if Symbol(length) in factors and old in factors:
                step = with_other(step, node, put_for(node, {old: Symbol(f"r{row}{column}")}))
    return step


def _wrist_from_whole(derivation: Derivation) -> Iterator[Slipped]:
    """The angles of the wrist from R as it is given, and not from what the arm leaves of it."""
    if len(derivation.steps) <= 3:  # noqa: PLR2004
        return
    arm = frozenset(derivation.robot.variables[:3])
    standing = {name: Angle() for name in arm & derivation.robot.angles}

    def changed(step: Step) -> Step:
        own = {name for name, _ in step.atom} if not isinstance(step.atom, str) else {step.atom}
        entries = {name for name in symbols(step.value) if name.startswith("r")}
        if own & arm or not entries or not symbols(step.value) & arm:
            return step
        return changed_step(step, partial(substitute, lengths={}, angles=standing))

    try:
        steps = tuple(map(changed, derivation.steps))
    except (ZeroDivisionError, ArithmeticError):
        return
    if steps != derivation.steps:
        words = "the angles of the wrist are taken from R as given, not from what the first three joints leave of it"
        slip = Slip("whole-rotation", words, "R_36 is inv(R_03) R")
        yield Slipped(slip, replace(derivation, steps=steps))
