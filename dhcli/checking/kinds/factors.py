"""`factors`: the elementary moves of a link, in order."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING, ClassVar, Self

from dhcli.algebra.terms import TERMS
from dhcli.checking.diagnosis.result import Slip
from dhcli.checking.exercise import Case, Causes, Exercise, Question, Reading, Shown
from dhcli.checking.kinds.linked import found_link, link_of, place_of, read_number
from dhcli.checking.pasted import without_label
from dhcli.checking.verdicts import Mark, Verdict
from dhcli.checking.wanted import Span, Wanted
from dhcli.errors import Place
from dhcli.kinematics.conventions import ORDER, moves_of
from dhcli.kinematics.forward import spelled
from dhcli.kinematics.moves import Chain, Fixed, Rot, Trans, along, read_chain
from dhcli.kinematics.robot import Robot
from dhcli.notation.factors import AXES
from dhcli.notation.scope import Scope
from dhcli.notation.tree import ZERO

if TYPE_CHECKING:
    from dhcli.checking.diagnosis.alternatives import Alternative


@dataclass(frozen=True, slots=True)
class FactorsQuestion(Question[Chain]):
    """The elementary moves of a link, in order."""

    link: str

    words: ClassVar = ("factors",)
    examples: ClassVar = ("factors 2",)
    is_in_table: ClassVar = True

    @classmethod
    def asked(cls, text: str, _scope: Scope, place: Place | None) -> Self:
        """`factors 2`."""
        return cls(read_number(text.removeprefix("factors"), place))

    def check(self, robot: Robot | None) -> None:
        found_link(robot, self.link)

    def describe(self, _exercise: Exercise) -> str:
        return f"the elementary moves of link {self.link}, in order"

    @property
    def has_cosines(self) -> bool:
        return True

    def expected(self, case: Case, _style: str = "short") -> str:
        return _spelled(link_of(case.exercise, self.link).moves, case.exercise)

    def steps(self, case: Case) -> Iterable[Shown]:
        if case.exercise.robot is not None:
            yield Shown(ORDER[case.exercise.robot.convention])

    def read(self, case: Case, text: str, place: Place | None = None) -> Chain:
        return read_chain(without_label(text), case.exercise.scope, place or Place("answer"))

    def mark(self, case: Case, reading: Reading[Chain]) -> Mark:
        return _mark(case.exercise, link_of(case.exercise, self.link).moves, reading.value)

    def slips(self, case: Case) -> Iterable[Slip]:
        return (one.slip for one in self._changing(case))

    def answer_with(self, case: Case, name: str) -> str | None:
        from dhcli.checking.diagnosis.alternatives import answer_of, changing

        return answer_of(changing(case, self._alternatives(case, name)), name)

    def causes(self, case: Case, reading: Reading[Chain]) -> Causes:
        return tuple((one.slip,) for one in self._changing(case, reading))

    def _changing(self, case: Case, reading: Reading[Chain] | None = None) -> Iterator[Alternative[Chain]]:
        from dhcli.checking.diagnosis.alternatives import changing

        return changing(case, self._alternatives(case), reading, distinct=not case.exercise.numeric)

    def _alternatives(self, case: Case, name: str = "") -> Iterator[Alternative[Chain]]:
        """Slips in the moves of the link, each move a factor of its own."""
        from dhcli.checking.diagnosis.alternatives import Alternative
        from dhcli.checking.diagnosis.mistakes import Level
        from dhcli.checking.diagnosis.mistakes.changes import OTHER
        from dhcli.checking.diagnosis.slips import candidates, setting_of
        from dhcli.checking.diagnosis.work import Factor, Multiplied, Work

        exercise, robot = case.exercise, case.exercise.robot
        if robot is None:
            return
        index = place_of(robot, self.link)
        link = robot.links[index]

        def asked(slip: Slip, chain: Chain) -> Alternative[Chain]:
            return Alternative(slip, _spelled(chain, exercise), partial(_mark, exercise, chain))

        if link.row is not None and robot.convention in OTHER:
            words = "the moves stand in the order of the other convention"
            slip = Slip("convention", words, "which convention has this robot, standard or modified?")
            yield asked(slip, moves_of(link.row, OTHER[robot.convention]))
        steps = tuple(Factor(str(k), (move,)) for k, move in enumerate(link.moves, 1))
        work = Work(Wanted(Span(robot.frames[index + 1], robot.frames[index + 2])), steps)
        for one in candidates(work, setting_of(exercise), name=name):
            is_product = one.mistake.level is not Level.MATRIX and one.work.multiplied is Multiplied.IN_ORDER
            if is_product and one.work.steps != steps:
                yield asked(one.slips[0], tuple(move for step in one.work.steps for move in step.chain))


def _spelled(chain: Chain, exercise: Exercise) -> str:
    """Moves as a person would type them."""
    return " ".join(spelled(move, exercise.writing) for move in chain)


def _mark(exercise: Exercise, right: Chain, typed: Chain) -> Mark:
    moving, wanted = _elementary(typed), _elementary(right)
    same_moves = sorted(moving) == sorted(wanted)
    remarks: tuple[str, ...] = ()
    verdict = Verdict.RIGHT if same_moves and _same_product(typed, right) else Verdict.WRONG
    if verdict is Verdict.WRONG and same_moves:
        remarks = ("the moves are right, their order is not",)
    elif verdict is Verdict.WRONG:
        remarks = (f"{len(set(moving) & set(wanted))} of {len(set(wanted))} moves are right",)
    earned = float(verdict is Verdict.RIGHT)
    shown = _spelled(right, exercise)
    return Mark(verdict, _spelled(typed, exercise), remarks=remarks, earned=earned, expected=shown)


def _elementary(chain: Chain) -> list[str]:
    """The moves about and along single axes that move anything, as text."""
    from dhcli.checking.symbolic import same

    found: list[str] = []
    for move in chain:
        if isinstance(move, Rot) and not move.angle.is_zero:
            found.append(spelled(move))
        elif isinstance(move, Trans):
            pairs = zip(AXES, move.offset, strict=True)
            found += [spelled(along(axis, length)) for axis, length in pairs if not same(length, ZERO, {})]
        elif isinstance(move, Fixed):
            found.append(spelled(move))
    return found


def _same_product(first: Chain, second: Chain) -> bool:
    from dhcli.checking.symbolic import same
    from dhcli.kinematics.fold import fold

    rows = zip(fold(first, TERMS), fold(second, TERMS), strict=True)
    return all(same(a, b, {}) for one, other in rows for a, b in zip(one, other, strict=True))
