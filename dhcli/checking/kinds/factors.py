"""`factors`: the elementary moves of a link, in order."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace
from functools import partial
from typing import ClassVar, Self

from dhcli.checking.diagnosis.alternatives import Alternative, AlternativesQuestion
from dhcli.checking.diagnosis.result import Slip
from dhcli.checking.exercise import Case, Exercise
from dhcli.checking.kinds.linked import link_of, needed, read_number
from dhcli.checking.pasted import without_label
from dhcli.checking.returned import Reading, Shown
from dhcli.checking.tolerance import NOT_EXACT, Tolerance
from dhcli.checking.units import chain_in_metres, move_in_metres
from dhcli.checking.verdicts import AGREEING, Mark, Verdict
from dhcli.checking.wanted import Wanted
from dhcli.errors import Place, are, plural
from dhcli.frozen import frozen
from dhcli.kinematics.conventions import ORDER, OTHER, moves_of
from dhcli.kinematics.frames import View, place_of
from dhcli.kinematics.moves import Chain, spelled
from dhcli.kinematics.robot import Robot
from dhcli.notation.brackets import depths
from dhcli.notation.scope import Scope
from dhcli.regex import regex

_BETWEEN = frozenset(",;→⟶⇒")
_NUMBER = regex(r"(^|\n)[ \t]{0,9}1?\d[.)][ \t]{1,9}(?=[A-Za-z])")
_IN_INDEX = regex(r"\b(Rot|Trans|R|T|D)_\{ ?([xyz]) ?, ?([^{},]{1,40}(?:\{[^{}]{1,20}\})?)\}")
"""`Rot_{z,θ_i}`, a move whose axis and angle stand in its index."""
_INDEX_OF_AXIS = regex(r"\(\s{0,9}([xyz])(?:\d|_\{?[\w-]{1,5}\}?)\s{0,9},")
"""Which axis z is of a link is known: that of the frame before it, and x that of its own."""


@frozen
class FactorsQuestion(AlternativesQuestion[Chain]):
    """The elementary moves of a link, in order."""

    link: str

    words: ClassVar = ("factors",)
    examples: ClassVar = ("factors 2",)
    is_in_table: ClassVar = True
    has_cosines: ClassVar = True

    @classmethod
    def asked(cls, text: str, _scope: Scope, place: Place | None) -> Self:
        """`factors 2`."""
        return cls(read_number(text.removeprefix("factors"), place))

    def check(self, robot: Robot | None) -> None:
        link_of(robot, self.link)

    def describe(self, _exercise: Exercise) -> str:
        return f"the elementary moves of link {self.link}, in order"

    def expected(self, case: Case, _style: str = "short") -> str:
        return _spelled(link_of(case.exercise.robot, self.link).moves, case.exercise)

    def steps(self, case: Case) -> Iterable[Shown]:
        yield Shown(ORDER[needed(case.exercise.robot).convention])

    def read(self, case: Case, text: str, place: Place | None = None) -> Chain:
        exercise = case.exercise
        product = as_product(without_label(text))
        return chain_in_metres(product, exercise.metres, exercise.scope, place or Place("answer"))

    def mark(self, case: Case, reading: Reading[Chain]) -> Mark:
        return _mark(case.exercise, link_of(case.exercise.robot, self.link).moves, reading.value, case.tolerance)

    def alternatives(self, case: Case, name: str = "") -> Iterator[Alternative[Chain]]:
        """Slips in the moves of the link, each move a factor of its own."""
        from dhcli.checking.diagnosis.slips import candidates, setting_of
        from dhcli.checking.diagnosis.work import Factor, Level, Multiplied, Work

        exercise, robot = case.exercise, needed(case.exercise.robot)
        index = place_of(robot, self.link)
        link = robot.links[index]

        def asked(slip: Slip, chain: Chain) -> Alternative[Chain]:
            return Alternative(
                slip, _spelled(chain, exercise), partial(_is_right, exercise, chain, tolerance=case.tolerance)
            )

        if link.row is not None and robot.convention in OTHER:
            words = "the moves stand in the order of the other convention"
            slip = Slip("convention", words, "which convention has this robot, standard or modified?")
            yield asked(slip, moves_of(link.row, OTHER[robot.convention]))
        steps = tuple(Factor(str(k), (move,)) for k, move in enumerate(link.moves, 1))
        work = Work(Wanted(View(robot.frames[index + 1], robot.frames[index + 2])), steps)
        for one in candidates(work, setting_of(exercise), name=name):
            is_product = one.mistake.level is not Level.MATRIX and one.work.multiplied is Multiplied.IN_ORDER
            if is_product and one.work.steps != steps:
                yield asked(one.slips[0], tuple(move for step in one.work.steps for move in step.chain))


def as_product(text: str) -> str:
    """Moves as a product: commas, arrows and numbers of a list between them go, and so do the indices of axes."""
    text = _IN_INDEX.sub(r"\1(\2, \3)", _NUMBER.sub(r"\1", text))
    text = _INDEX_OF_AXIS.sub(r"(\1,", text)
    return "".join(
        " " if not depth and letter in _BETWEEN else letter for letter, depth in zip(text, depths(text), strict=True)
    )


def _spelled(chain: Chain, exercise: Exercise) -> str:
    """Moves as a person would type them."""
    unit, scope = 1 / exercise.metres, exercise.scope
    return " ".join(spelled(move_in_metres(move, unit, scope), exercise.writing) for move in chain)


def _is_right(exercise: Exercise, right: Chain, typed: Chain, tolerance: Tolerance) -> bool:
    return _mark(exercise, right, typed, tolerance).verdict in AGREEING


def _mark(exercise: Exercise, right: Chain, typed: Chain, tolerance: Tolerance) -> Mark:
    from dhcli.checking.moves import Comparison

    compared = Comparison(exercise, right, tolerance)
    moving, wanted = compared.elementary(typed), compared.elementary(right)
    matched = compared.matched(moving, wanted)
    same_moves = matched == len(wanted) == len(moving)
    remarks: tuple[str, ...] = ()
    verdict = Verdict.RIGHT if same_moves and compared.same_product(typed) else Verdict.WRONG
    if verdict is Verdict.WRONG and same_moves:
        remarks = ("the moves are right, their order is not",)
    elif verdict is Verdict.WRONG:
        remarks = (f"{matched} of {plural(len(wanted), 'move')} {are(matched)} right",)
    earned = float(verdict is Verdict.RIGHT)
    if verdict is Verdict.RIGHT and tolerance.exact:
        strict = Comparison(exercise, right, replace(tolerance, angle=0.0, position=0.0))
        if strict.matched(strict.elementary(typed), strict.elementary(right)) < len(wanted):
            verdict, remarks = Verdict.ROUNDED, (NOT_EXACT,)
    shown = _spelled(right, exercise)
    surplus = max(0, len(moving) - len(wanted))  # one that is too many costs what one earns
    found = max(0, matched - surplus) / len(wanted) if wanted else 0.0
    return Mark(verdict, _spelled(typed, exercise), remarks=remarks, earned=earned, expected=shown, found=found)
