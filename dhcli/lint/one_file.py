"""What is found in one file: all that keeps it from loading, or else every broken rule, each with its place."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import chain
from pathlib import Path
from typing import TYPE_CHECKING

from dhcli.errors import DhcliError, Place, Problem
from dhcli.files.library.entries import Kind
from dhcli.files.library.kinds import kind_of
from dhcli.files.reading import read_text
from dhcli.files.yaml.placed import PlacedMapping, PlacedNode, PlacedScalar, PlacedSequence, read_yaml
from dhcli.frozen import frozen
from dhcli.kinematics.validity import Finding
from dhcli.lint.kept import kept
from dhcli.lint.names import Names
from dhcli.lint.places import path_to, place_in
from dhcli.lint.wording import unfinished

if TYPE_CHECKING:
    from dhcli.checking.exercise import Exercise

SHEETS = (".sheet.yaml", ".sheet.yml")
BESIDE_JUDGING = frozenset(
    ("format", "title", "source", "task", "prompt", "hints", "tests", "printed", "variants", "feedback")
)
"""Keys of exercises that may be wrong without changing what is right: the rest can be judged all the same."""


@frozen
class Told:
    """A finding at its place.

    Attributes:
        problem: Where, what, and what would be right.
        is_warning: Whether an author may well leave it as it is.
    """

    problem: Problem
    is_warning: bool = False


def told_of(path: str, names: Names) -> Iterator[Told]:
    """The findings of one file: what keeps it from loading, or else every broken rule, in the order of its lines."""
    if path.lower().endswith(SHEETS):  # named itself, for in a folder it is passed over
        problem = Problem("is an answer sheet", Place(path), f"dhcli check EXERCISE {path} judges it")
        return iter([Told(problem)])
    root: PlacedNode | None = None
    found: list[Told] = []
    try:
        root = read_yaml(read_text(path), path, [])  # what it refuses is told by the loader, with all the rest
        rules = _rules(path, kind_of(path), root)
    except DhcliError as error:
        found = [Told(_placed(problem, path)) for problem in error.problems]
        found += _besides(path, root, error.problems) if root is not None else ()
    else:
        found = [_told(one, root) for one in kept(rules)]
    found += [_told(one, root) for one in names.clashes(path) if root is not None]
    return iter(sorted(found, key=lambda one: one.problem.order))


def _told(one: Finding, root: PlacedNode) -> Told:
    """A finding at its place."""
    return Told(Problem(one.message, place_in(root, one.where), one.hint), one.is_warning)


def _besides(path: str, root: PlacedNode, problems: Sequence[Problem]) -> Iterator[Told]:
    """What is found in a file that does not load, besides what keeps it from that.

    Nothing is told of a place where a problem is told already, and nothing is judged where the problems are more than
    a matter of words: what is wrong then follows from them.
    """
    inside = [path_to(root, problem.place) for problem in problems if problem.place]
    try:
        rules = tuple(_rules_so_far(Path(path), inside, root))
    except DhcliError:
        yield from _left_to_write("", root)
        return
    for one in rules:
        if not any(_told_by(where, one.where) for where in inside):
            yield _told(one, root)


def _rules_so_far(path: Path, inside: Sequence[tuple[str | int, ...]], root: PlacedNode) -> Iterator[Finding]:
    """What the rules say of as much of a file as can be read.

    Raises:
        DhcliError: Nothing of it can be.
    """
    from dhcli.files.yaml.exercises import exercise_so_far
    from dhcli.files.yaml.robots import robot_so_far
    from dhcli.lint import lengths, lost, robots

    kind = kind_of(str(path))
    if kind is Kind.EXERCISES:
        exercise, _ = exercise_so_far(path)
        yield from lost.findings(root, exercise)
        yield from _rules_of_exercise(exercise, judged=all(BESIDE_JUDGING.intersection(where) for where in inside))
    elif kind is Kind.ROBOTS:
        robot, mentioned = robot_so_far(path)
        yield from lost.findings(root)
        yield from robots.findings(robot, mentioned)
        if ("units",) not in inside:
            yield from lengths.of_robot(robot)
    else:
        raise DhcliError("of a linkage that does not load there is no rest")


def _told_by(problem: tuple[str | int, ...], finding: tuple[str | int, ...]) -> bool:
    """Whether a problem stands where a finding does, or one inside the other below the top of the file."""
    shorter = min(len(problem), len(finding))
    return problem == finding or (shorter > 1 and problem[:shorter] == finding[:shorter])


def _left_to_write(key: str, node: PlacedNode) -> Iterator[Told]:
    """What a template left to write in a file that does not load: its blanks keep it from that, and are told too."""
    if isinstance(node, PlacedScalar) and node.text.strip():
        for one in unfinished({(key,): node.text}):
            yield Told(Problem(one.message, place_in(node, ()), one.hint))
    for below, inner in node.entries if isinstance(node, PlacedMapping) else ():
        yield from _left_to_write(below.text, inner)
    for inner in node.items if isinstance(node, PlacedSequence) else ():
        yield from _left_to_write(key, inner)


def _rules(path: str, kind: Kind, root: PlacedNode) -> Iterator[Finding]:
    """What the rules for its kind say of a file, which is loaded before that.

    Raises:
        DhcliError: It does not load.
    """
    from dhcli.files.yaml.exercises import load_exercise
    from dhcli.files.yaml.linkages import load_linkage
    from dhcli.files.yaml.robots import load_robot
    from dhcli.lint import lengths, linkages, lost, robots

    if kind is Kind.ROBOTS:
        robot = load_robot(Path(path))
        return chain(lost.findings(root), robots.findings(robot), lengths.of_robot(robot))
    if kind is Kind.LINKAGES:
        linkage = load_linkage(Path(path))
        return chain(lost.findings(root), linkages.findings(linkage))
    exercise = load_exercise(Path(path))
    return chain(lost.findings(root, exercise), _rules_of_exercise(exercise, judged=True))


def _rules_of_exercise(exercise: Exercise, *, judged: bool) -> Iterator[Finding]:
    """What the rules say of an exercise: those about what is written alone, or also those about how it is judged."""
    from dhcli.checking.judge import Judge
    from dhcli.lint import exercises, mistakes, variants

    yield from exercises.written(exercise)
    yield from variants.written(exercise)
    if not judged or not exercise.asked:
        return
    judge = Judge(exercise)
    told = tuple(kept(exercises.findings(judge)))
    yield from told
    if not any(one.where[:1] == ("tolerance",) for one in told):  # else the pose is not what hides mistakes
        yield from mistakes.findings(judge)
        yield from kept(variants.findings(judge), ("variants",))


def _placed(problem: Problem, path: str) -> Problem:
    """A problem that is at least in its file."""
    return problem if problem.place is not None else Problem(problem.message, Place(path), problem.hint)
