"""Mistakes in a single move, where a link is a product of moves and has no row."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace

from dhcli.checking.diagnosis.mistakes.changes import CALCULATOR, LENGTHS, RIGHT_ANGLE, other_unit, scale_of
from dhcli.checking.diagnosis.record import Catalogue
from dhcli.checking.diagnosis.result import Rank
from dhcli.checking.diagnosis.work import Factor, Level, Made, Maker, Setting, Work
from dhcli.kinematics.moves import Move, Rot, Trans, along
from dhcli.notation.angle import Angle
from dhcli.notation.factors import AXES
from dhcli.notation.tree import ZERO, Expr, multiply, negate

IN_MOVES: Catalogue[Maker] = Catalogue(Level.TABLE)


@IN_MOVES("turn-sign", "the turn in move {where} goes the other way", "look at the sense of the turn in move {where}")
def turn_sign(work: Work, _setting: Setting) -> Made:
    """A turn the other way; half a turn has no sense."""
    return _turns(work, lambda angle: None if angle.quarter_turns() in (0, 2) else -angle)


@IN_MOVES("turn-offset", "the offset of the turn in move {where} is forgotten", "look at the zero of move {where}")
def turn_offset(work: Work, _setting: Setting) -> Made:
    """The variable alone."""
    return _turns(work, lambda angle: Angle(angle.terms) if angle.terms else None)


@IN_MOVES("turn-signs", "every turn by a joint goes the other way", "which way are the turns positive?", alone=True)
def turn_signs(work: Work, setting: Setting) -> Made:
    """All turns that a joint makes the other way, where that is more than one."""
    moving, changed, count = set(setting.variables), work, 0
    for index, k, _, move in _moves(work):
        if isinstance(move, Rot) and move.angle.names & moving:
            changed = changed.with_step(index, _with_move(changed.steps[index], k, replace(move, angle=-move.angle)))
            count += 1
    if count > 1:
        yield "", changed


@IN_MOVES(
    "turn-sin-cos",
    "sine and cosine of the turn in move {where} have changed places",
    "look at sine and cosine of the turn in move {where}",
    rank=Rank.SYMPTOM,
)
def turn_sine_cosine(work: Work, _setting: Setting) -> Made:
    """Cos for sin: the complement of the angle."""
    return _turns(work, lambda angle: RIGHT_ANGLE - angle)


@IN_MOVES(
    "turn-unit",
    "the turn in move {where} is taken in the wrong unit, degrees for radians or the other way round",
    CALCULATOR,
    of_values=True,
)
def turn_unit(work: Work, setting: Setting) -> Made:
    """A turn with its number in the other unit."""
    return _turns(work, lambda angle: other_unit(angle, setting))


@IN_MOVES(
    "shift-sign",
    "the sign of the shift along {term} in move {entry} is turned round",
    "look at the sense of the shift in move {row}",
)
def shift_sign(work: Work, _setting: Setting) -> Made:
    """A shift the other way."""
    return _shifts(work, negate)


@IN_MOVES(
    "shift-in-mm",
    "the shift along {term} in move {entry} is in another unit than the other lengths, mm for m",
    LENGTHS,
)
def shift_unit(work: Work, setting: Setting) -> Made:
    """The number of another unit in the place of a shift."""
    factor = scale_of(setting)
    return iter(()) if factor is None else _shifts(work, lambda length: multiply(factor, length))


@IN_MOVES("move-missing", "move {where} is left out", "count the moves of link {row}")
def missing(work: Work, _setting: Setting) -> Made:
    """A move of a link of several is left out."""
    for index, step in enumerate(work.steps):
        if step.row is None and len(step.chain) > 1:
            for k in range(len(step.chain)):
                chain = (*step.chain[:k], *step.chain[k + 1 :])
                yield _where(step, k), work.with_step(index, Factor(step.name, chain))


def _turns(work: Work, change: Callable[[Angle], Angle | None]) -> Made:
    for index, k, step, move in _moves(work):
        if isinstance(move, Rot):
            angle = change(move.angle)
            if angle is not None and angle != move.angle:
                yield _where(step, k), work.with_step(index, _with_move(step, k, replace(move, angle=angle)))


def _shifts(work: Work, change: Callable[[Expr], Expr]) -> Made:
    for index, k, step, move in _moves(work):
        if not isinstance(move, Trans):
            continue
        for axis, length in zip(AXES, move.offset, strict=True):
            if length != ZERO:
                others = [along(other, part) for other, part in zip(AXES, move.offset, strict=True) if other != axis]
                changed = (along(axis, change(length)), *(one for one in others if any(p != ZERO for p in one.offset)))
                where = f"{_where(step, k)} {axis}"
                chain = (*step.chain[:k], *changed, *step.chain[k + 1 :])
                yield where, work.with_step(index, Factor(step.name, chain))


def _moves(work: Work) -> Iterator[tuple[int, int, Factor, Move]]:
    """Every move of the factors that have no row, with the numbers of the factor and of the move."""
    for index, step in enumerate(work.steps):
        if step.row is None:
            for k, move in enumerate(step.chain):
                yield index, k, step, move


def _with_move(step: Factor, k: int, move: Move) -> Factor:
    return Factor(step.name, (*step.chain[:k], move, *step.chain[k + 1 :]))


def _where(step: Factor, k: int) -> str:
    """The number of a move; in a link of several `2.1`."""
    return step.name if len(step.chain) == 1 else f"{step.name}.{k + 1}"
