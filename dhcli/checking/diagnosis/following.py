"""Follow-through: a matrix that is right from a student's own earlier answers earns its credit."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from dhcli.checking.diagnosis.bench import inverse, product
from dhcli.checking.diagnosis.search import matches, search_of
from dhcli.checking.diagnosis.typed import typed_answer
from dhcli.checking.entries import Entries
from dhcli.checking.exercise import Case
from dhcli.checking.pasted import UnreadableError
from dhcli.checking.returned import Matrices, Points, Reading
from dhcli.checking.truth import piece_of
from dhcli.checking.wanted import Wanted
from dhcli.errors import DhcliError
from dhcli.kinematics.fold import fold
from dhcli.kinematics.frames import View, between, span_of

MOST_WAYS = 64

Ways = dict[int, list[tuple[int, str, Matrices]]]
"""From the index of a frame: matrices that lead on, to which frame, from which part (empty for the right one)."""


def follows(case: Case, question: Wanted, entries: Entries, earlier: Mapping[str, Reading[Any]]) -> tuple[str, ...]:
    """The earlier parts, of those answered otherwise than the solution, from which a wrong matrix is right."""
    robot = case.exercise.robot
    if not earlier or robot is None or not isinstance(question.source, View):
        return ()
    first, last = span_of(robot, question.source)
    try:
        typed = typed_answer(case, question, entries)
        if typed is None or first >= last:
            return ()
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
        return ()
    for count, (used, matrices) in enumerate(_paths(ways, first, last)):
        if count >= MOST_WAYS:
            break
        finished = (inverse(m) if question.inverse else m for m in matrices)
        pieces = (piece_of(m, question, over) for m, over in zip(finished, points.at, strict=True))
        if used and all(matches(v, p, typed.slacks[-1]) for v, p in zip(typed.values, pieces, strict=True)):
            return used
    return ()


def _paths(ways: Ways, here: int, last: int) -> Iterator[tuple[tuple[str, ...], Matrices]]:
    """Every way from a frame to the last: the parts used, and the product at each point."""
    for end, name, matrices in ways.get(here, ()):
        used = (name,) if name else ()
        if end == last:
            yield used, matrices
        for more, rest in _paths(ways, end, last) if end < last else ():
            yield (*used, *more), tuple(product(a, b) for a, b in zip(matrices, rest, strict=True))
