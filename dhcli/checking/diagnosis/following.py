"""Follow-through: a matrix or an orientation that is right from a student's own earlier answers earns its credit."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from itertools import islice
from typing import TYPE_CHECKING, Any

from dhcli.checking.diagnosis.bench import inverse, product
from dhcli.checking.diagnosis.search import Numbers, matches, search_of
from dhcli.checking.diagnosis.typed import typed_answer
from dhcli.checking.entries import Entries
from dhcli.checking.exercise import Case
from dhcli.checking.orientations import near
from dhcli.checking.pasted import UnreadableError
from dhcli.checking.returned import Matrices, Points, Reading
from dhcli.checking.truth import piece_of
from dhcli.checking.wanted import Wanted
from dhcli.errors import DhcliError
from dhcli.kinematics.fold import fold
from dhcli.kinematics.frames import View, between, span_of

if TYPE_CHECKING:
    from dhcli.geometry.rotations import Rotation

MOST_WAYS = 64

UNKNOWN = math.nan
"""A coordinate that an answer leaves open: what depends on it is equal to nothing."""

TWO_DECIMALS = 5.1e-3
"""What an entry of a rotation is off that was typed to two decimals, the least that count."""

Ways = dict[int, list[tuple[int, str, Matrices]]]
"""From the index of a frame: matrices that lead on, to which frame, from which part (empty for the right one)."""


def follows(case: Case, question: Wanted, entries: Entries, earlier: Mapping[str, Reading[Any]]) -> tuple[str, ...]:
    """The earlier parts, of those answered otherwise than the solution, from which a wrong matrix is right."""
    if not _leads_on(case, question, earlier):
        return ()
    try:
        typed = typed_answer(case, question, entries)
    except (UnreadableError, DhcliError):
        return ()
    if typed is None:
        return ()
    for used, pieces in _worked_out(case, question, earlier):
        if all(matches(v, p, typed.slacks[-1]) for v, p in zip(typed.values, pieces, strict=True)):
            return used
    return ()


def orientation_follows(
    case: Case, question: Wanted, typed: Rotation[float], earlier: Mapping[str, Reading[Any]]
) -> tuple[str, ...]:
    """The earlier parts from which a wrong orientation is right, however it was said.

    Args:
        case: The part with its exercise.
        question: Which rotation is said.
        typed: The rotation that was typed, shape (3, 3).
        earlier: Answers to parts before it.
    """
    limit = max(case.tolerance.rotation, TWO_DECIMALS)
    for used, (piece, *_) in _worked_out(case, question, earlier) if _leads_on(case, question, earlier) else ():
        if near(piece, typed, limit):
            return used
    return ()


def leads_from(
    case: Case, question: Wanted, entries: Entries, span: tuple[int, int]
) -> tuple[int, int, Matrices] | None:
    """From which frame to which a typed matrix leads within a span, and its entries at each point of the search."""
    robot = case.exercise.robot
    if robot is None or not isinstance(question.source, View) or not question.is_factor or question.inverse:
        return None
    start, end = span_of(robot, question.source)
    typed = typed_answer(case, question, entries)
    if typed is None or not span[0] <= start < min(end, span[1]):
        return None
    return start, end, typed.values if question.piece == "pose" else tuple(map(_without_position, typed.values))


def _without_position(rotation: Numbers) -> Numbers:
    """A rotation, shape (3, 3), as a pose, shape (4, 4), of which nobody knows where it is."""
    return (*((*row, UNKNOWN) for row in rotation), (0.0, 0.0, 0.0, 1.0))


def _leads_on(case: Case, question: Wanted, earlier: Mapping[str, Reading[Any]]) -> bool:
    """Whether anything before a question about frames of a robot may lead to it."""
    robot = case.exercise.robot
    if not earlier or robot is None or not isinstance(question.source, View):
        return False
    first, last = span_of(robot, question.source)
    return first < last


def _worked_out(
    case: Case, question: Wanted, earlier: Mapping[str, Reading[Any]]
) -> Iterator[tuple[tuple[str, ...], Matrices]]:
    """What is asked as it comes out of earlier answers, at each point of its search, and of which answers."""
    robot, source = case.exercise.robot, question.source
    if robot is None or not isinstance(source, View):
        return
    first, last = span_of(robot, source)
    try:
        search = search_of(question, case.memo)
        points = Points(search.names, search.points)
        ways: Ways = {}
        for k in range(first, last):
            chain = between(robot, robot.frames[k], robot.frames[k + 1])
            ways[k] = [(k + 1, "", tuple(fold(chain, over) for over in points.at))]
        for other in case.exercise.before(case.part):
            if other.id in earlier:
                way = other.question.leads(Case(other, case.memo), earlier[other.id], (first, last), points)
                if way is not None and way[0] in ways:
                    ways[way[0]].insert(0, (way[1], other.id, way[2]))
    except (UnreadableError, DhcliError):
        return
    for used, matrices in islice(_paths(ways, first, last), MOST_WAYS):
        if used:
            finished = (inverse(m) if question.inverse else m for m in matrices)
            yield used, tuple(piece_of(m, question, over) for m, over in zip(finished, points.at, strict=True))


def _paths(ways: Ways, here: int, last: int) -> Iterator[tuple[tuple[str, ...], Matrices]]:
    """Every way from a frame to the last: the parts used, and the product at each point."""
    for end, name, matrices in ways.get(here, ()):
        used = (name,) if name else ()
        if end == last:
            yield used, matrices
        for more, rest in _paths(ways, end, last) if end < last else ():
            yield (*used, *more), tuple(product(a, b) for a, b in zip(matrices, rest, strict=True))
