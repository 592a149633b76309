"""Mistakes in placing frames: the frames of a student who makes one, and the one behind frames that break a rule."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace

from dhcli.checking.diagnosis.record import Catalogue, Mistake
from dhcli.checking.diagnosis.result import Slip
from dhcli.checking.frames.reading import TypedFrame
from dhcli.checking.frames.rules import DH1, FRAME, TASK, X_CELL, Z_CELL, Broken, Rules
from dhcli.checking.returned import Causes
from dhcli.frozen import frozen
from dhcli.geometry.vectors import Vector, cross, dot, length, scaled
from dhcli.kinematics.conventions import NAMES, OTHER
from dhcli.kinematics.describe.drawn import Frame
from dhcli.kinematics.describe.linear import moved
from dhcli.kinematics.describe.process import frames_of

MOST = 2
"""Slips that are named together; of more one cannot say what was meant."""


@frozen
class Placing:
    """A way to place a frame wrongly.

    Attributes:
        frame: The frame of a student who places it so; None where it cannot be.
        fits: Whether it is behind a broken rule.
    """

    frame: Callable[[Rules, Sequence[TypedFrame], int], TypedFrame | None]
    fits: Callable[[Rules, Sequence[TypedFrame], Broken], bool]


IN_FRAMES: Catalogue[Placing] = Catalogue()
"""What people do wrong when they place frames, the plainest first; in words `{before}` is the frame before, and
`{other}` the neighbour that x has to meet."""


def causes_of(rules: Rules, typed: Sequence[TypedFrame], broken: Sequence[Broken]) -> Causes:
    """The slips behind frames that break rules; none where one of the rules has no known slip behind it."""
    if is_of_other(rules, typed):
        return ((convention_slip(rules),),)
    found: dict[str, Slip] = {}
    for one in broken:
        mistake = next((mistake for mistake in IN_FRAMES if mistake.made.fits(rules, typed, one)), None)
        if mistake is None:
            return ()
        slip = _slip(mistake, rules, one.frame)
        found[slip.name] = slip
    return (tuple(found.values()),) if 0 < len(found) <= MOST else ()


def every_slip(rules: Rules, right: Sequence[TypedFrame]) -> Iterator[tuple[Slip, tuple[TypedFrame, ...]]]:
    """Every mistake that breaks a rule, with the frames of a student who makes it in right ones."""
    other = tuple(map(as_typed, frames_of(rules.sketch.walked, OTHER[rules.sketch.convention])))
    if rules.broken(other) and is_of_other(rules, other):
        yield convention_slip(rules), other
    for k in range(len(right)):
        for mistake in IN_FRAMES:
            made = mistake.made.frame(rules, right, k)
            frames = (*right[:k], made, *right[k + 1 :]) if made is not None else ()
            slip = _slip(mistake, rules, k)
            if frames and ((slip,),) == causes_of(rules, frames, rules.broken(frames)):
                yield slip, frames


def _slip(mistake: Mistake[Placing], rules: Rules, k: int) -> Slip:
    """The mistake at frame k."""
    first, other = rules.sketch.first, rules.sketch.other_of(k)
    return mistake.slip(str(first + k), before=first + k - 1, other=first + (k if other is None else other))


def as_typed(frame: Frame) -> TypedFrame:
    """A frame as if it had been typed."""
    return TypedFrame(frame, {})


def is_of_other(rules: Rules, typed: Sequence[TypedFrame]) -> bool:
    """Whether frames keep the rules of the other convention; with one joint nearly all do."""
    sketch = rules.sketch
    free = replace(sketch, convention=OTHER[sketch.convention], stated=frozenset())
    return len(sketch.axes) > 1 and not replace(rules, sketch=free).broken(typed)


def convention_slip(rules: Rules) -> Slip:
    """The frames are those of the other convention."""
    asked = rules.sketch.convention
    words = f"the frames are those of {NAMES[OTHER[asked]]}, and {asked.value} was asked"
    return Slip("convention", words, "which joint turns about z of frame 1, joint 1 or joint 2?")


_NEAR = 0.999
"""Cosine of directions that count as the same when a slip is looked for."""


def _parallel(one: Vector, other: Vector) -> bool:
    return abs(dot(one, other)) > _NEAR


def _square(one: Vector, other: Vector) -> bool:
    return length(cross(one, other)) > _NEAR


def _on_neighbour(rules: Rules, typed: Sequence[TypedFrame], k: int) -> TypedFrame | None:
    neighbour = _neighbour(rules, k)
    if neighbour is None:
        return None
    frame, other = typed[k].frame, typed[neighbour].frame
    return as_typed(Frame(frame.x, other.z, other.origin))


def _is_on_neighbour(rules: Rules, typed: Sequence[TypedFrame], one: Broken) -> bool:
    neighbour = _neighbour(rules, one.frame)
    line = None if neighbour is None else rules.sketch.axis_of(neighbour)
    if one.rule != DH1 or line is None:
        return False
    frame = typed[one.frame].frame
    gap = {} if line.through is None else moved(frame.origin, line.through, -1)
    beside = {letter: cross(vector, line.direction) for letter, vector in gap.items()}
    return _parallel(frame.z, line.direction) and not rules.amount(beside)


def _neighbour(rules: Rules, k: int) -> int | None:
    """The frame before, whose axis one takes by mistake; behind the first the next one."""
    for other in (k - 1, k + 1):
        if 0 <= other < len(rules.sketch.frames) and rules.sketch.axis_of(other) and rules.sketch.axis_of(k):
            return other
    return None


IN_FRAMES(
    "frame-on-joint",
    "frame {where} stands on the axis of a neighbouring joint",
    "on which joint axis does frame {where} stand?",
)(Placing(_on_neighbour, _is_on_neighbour))


def _kept_z(_rules: Rules, typed: Sequence[TypedFrame], k: int) -> TypedFrame | None:
    return as_typed(replace(typed[k].frame, z=typed[k - 1].frame.z)) if k else None


def _is_kept_z(_rules: Rules, typed: Sequence[TypedFrame], one: Broken) -> bool:
    k = one.frame
    return one.rule == DH1 and one.cell == Z_CELL and k > 0 and dot(typed[k].frame.z, typed[k - 1].frame.z) > _NEAR


IN_FRAMES(
    "z-kept",
    "z{where} was taken over from frame {before}, where the next joint axis points another way",
    "which joint turns about z{where}, and where does its axis point?",
)(Placing(_kept_z, _is_kept_z))


def _against(_rules: Rules, typed: Sequence[TypedFrame], k: int) -> TypedFrame:
    frame = typed[k].frame
    return as_typed(replace(frame, z=scaled(frame.z, -1)))


def _is_against(rules: Rules, typed: Sequence[TypedFrame], one: Broken) -> bool:
    right = rules.sketch.frames[one.frame].z
    return one.rule == TASK and one.cell == Z_CELL and dot(typed[one.frame].frame.z, right) < -_NEAR


IN_FRAMES(
    "z-sign",
    "z{where} points the other way, against the positive sense",
    "the right-hand rule: which way does z{where} point?",
)(Placing(_against, _is_against))


def _left(_rules: Rules, typed: Sequence[TypedFrame], k: int) -> TypedFrame:
    return replace(as_typed(typed[k].frame), y=scaled(typed[k].frame.y, -1))


def _is_left(_rules: Rules, typed: Sequence[TypedFrame], one: Broken) -> bool:
    y = typed[one.frame].y
    return one.rule == FRAME and y is not None and dot(y, typed[one.frame].frame.y) < -_NEAR


IN_FRAMES(
    "left-handed",
    "y{where} points the other way, so that frame {where} is left-handed",
    "curl the fingers of the right hand from x{where} to y{where}: the thumb is z{where}",
)(Placing(_left, _is_left))


def _along_other(rules: Rules, typed: Sequence[TypedFrame], k: int) -> TypedFrame | None:
    other = rules.sketch.other_of(k)
    if other is None or not _square(typed[other].frame.z, typed[k].frame.z):
        return None
    return as_typed(replace(typed[k].frame, x=typed[other].frame.z))


def _is_along_other(rules: Rules, typed: Sequence[TypedFrame], one: Broken) -> bool:
    other = rules.sketch.other_of(one.frame)
    return one.cell == X_CELL and other is not None and _parallel(typed[one.frame].frame.x, typed[other].frame.z)


IN_FRAMES(
    "x-along-z",
    "x{where} lies along the z axis of frame {other}, to which it has to be perpendicular",
    "which two z axes is x{where} perpendicular to?",
)(Placing(_along_other, _is_along_other))


def _kept_x(_rules: Rules, typed: Sequence[TypedFrame], k: int) -> TypedFrame | None:
    return as_typed(replace(typed[k].frame, x=typed[k - 1].frame.x)) if k else None


def _is_kept_x(_rules: Rules, typed: Sequence[TypedFrame], one: Broken) -> bool:
    k = one.frame
    return one.cell == X_CELL and k > 0 and dot(typed[k].frame.x, typed[k - 1].frame.x) > _NEAR


IN_FRAMES(
    "x-kept",
    "x{where} was taken over from frame {before}, where the common normal points another way",
    "which two z axes is x{where} perpendicular to?",
)(Placing(_kept_x, _is_kept_x))


def _kept_origin(_rules: Rules, typed: Sequence[TypedFrame], k: int) -> TypedFrame | None:
    return as_typed(replace(typed[k].frame, origin=typed[k - 1].frame.origin)) if k else None


def _is_kept_origin(rules: Rules, typed: Sequence[TypedFrame], one: Broken) -> bool:
    k = one.frame
    is_origin = one.cell not in (X_CELL, Z_CELL)
    return is_origin and k > 0 and not rules.amount(moved(typed[k].frame.origin, typed[k - 1].frame.origin, -1))


IN_FRAMES(
    "origin-kept",
    "o{where} was left at the origin of frame {before}",
    "where do x{where} and z{where} meet?",
)(Placing(_kept_origin, _is_kept_origin))
