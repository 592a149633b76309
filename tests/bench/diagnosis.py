"""How well slips are named, over every exercise and robot: `python tests/bench/diagnosis.py [PAIRS [EVERY]]`.

PAIRS pairs of slips are drawn for each part (2), and every part is looked at, or each EVERYth. Each mistake that
changes an answer is made, the answer it leads to is typed, and the diagnosis of that text is held against the mistake.
Mistakes that give the same text count as one. Of the mistakes in the terms of a formula, which are hundreds in a pose,
some are drawn for each part. An answer is `alike` if all that is named for it gives the same answer
at every value of joints and lengths, as where a single entry was asked: the question itself cannot tell them apart.
"""

from __future__ import annotations

import random
import statistics
import sys
import time
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, field, replace
from functools import partial
from itertools import islice
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[2]))

from dhcli import load_exercise, load_robot
from dhcli.checking.diagnosis.matrix_causes import typed_text
from dhcli.checking.diagnosis.mistakes import IN_TERMS
from dhcli.checking.diagnosis.mistakes.in_terms import IN_ENTRY, among_of
from dhcli.checking.diagnosis.result import Diagnosis, Slip
from dhcli.checking.diagnosis.search import matches, same, search_of
from dhcli.checking.diagnosis.slips import candidates, setting_of
from dhcli.checking.diagnosis.typed import typed_answer
from dhcli.checking.exercise import Case, Exercise, Part
from dhcli.checking.judge import Judge
from dhcli.checking.kinds.joints import JointsQuestion
from dhcli.checking.kinds.made import question_about
from dhcli.checking.kinds.matrix import MatrixQuestion
from dhcli.checking.kinds.table import TableQuestion
from dhcli.checking.motion.from_columns import ColumnsQuestion
from dhcli.checking.motion.grid import alike as same_points
from dhcli.checking.motion.marking import values_of
from dhcli.checking.motion.question import MotionQuestion
from dhcli.checking.symbolic import same as equal
from dhcli.checking.verdicts import Verdict
from dhcli.errors import DhcliError
from dhcli.files.library.entries import Kind, entries
from dhcli.kinematics.robot import Robot
from dhcli.kinematics.values import joint_values

UNSOLVED = (Verdict.WRONG, Verdict.CLOSE)

NOT_MADE = ("misprint", "convention")
"""What is seen without making it: what the document prints, and a table of the other convention."""

NEAR = 2e-3
"""Answers in numbers that differ by no more than this share of the largest entry are one, twice the tolerance."""


@dataclass
class Tally:
    """What came out for one group of answers.

    Attributes:
        made: Wrong answers that a mistake leads to.
        unique: Those for which just that mistake is named.
        alike: Others, for which each mistake named gives the same answer at all values.
        few: Those for which it is named among at most three.
        named: Those for which something is named.
        wrong: Names of mistakes that would give the right answer, or another one than that typed.
        seconds: Time of each diagnosis.
    """

    made: int = 0
    unique: int = 0
    alike: int = 0
    few: int = 0
    named: int = 0
    wrong: int = 0
    seconds: list[float] = field(default_factory=list)

    def line(self, title: str) -> str:
        """The row of the table."""
        made = self.made or 1
        median, longest = statistics.median(self.seconds or [0]) * 1000, max(self.seconds or [0]) * 1000
        rest = self.unique / max(1, self.made - self.alike)
        shares = f"{self.unique / made:8.1%} {self.alike / made:8.1%} {rest:8.1%} "
        shares += f"{self.few / made:8.1%} {self.named / made:8.1%}"
        return f"{title:34}{self.made:7} {shares} {self.wrong:6} {median:9.1f} {longest:7.0f}"


def parts() -> Iterator[tuple[str, Judge, Part]]:
    """Every part of the library, and the pose of every robot in symbols and, with values, in numbers."""
    for entry in entries(Kind.EXERCISES):
        exercise = load_exercise(entry.path)
        judge = Judge(exercise)
        for part in exercise.parts:
            yield ("exercises, numbers" if exercise.numeric else "exercises, symbols"), judge, part
    for entry in entries(Kind.ROBOTS):
        robot = load_robot(entry.path)
        for numeric in (False, True):
            if numeric and (not robot.variables or any(value is None for value in robot.parameters.values())):
                continue
            exercise = about(robot, numeric=numeric)
            yield ("robots, numbers" if numeric else "robots, symbols"), Judge(exercise), exercise.parts[0]
            yield from motions(robot, exercise)


def motions(robot: Robot, exercise: Exercise) -> Iterator[tuple[str, Judge, Part]]:
    """The Jacobian of a robot, and the torques and rates of its joints, as exercises."""
    span = f"of {robot.frames[1]}..{robot.frames[-2]}"
    for ask in (
        f"jacobian {span}",
        f"torques for (3, -2, 5) moment (1, 2, -1) {span}",
        f"joint rates for (0.1, 0.2, 0.3) {span}",
    ):
        kind = f"{ask.split()[0]}, {'numbers' if exercise.numeric else 'symbols'}"
        try:
            asked = question_about(robot, ask, numeric=exercise.numeric, given=exercise.given)
            judge = Judge(asked)
            judge.expected(asked.parts[0])
        except DhcliError:  # no joint, or no square matrix
            continue
        yield kind, judge, asked.parts[0]


def about(robot: Robot, *, numeric: bool) -> Exercise:
    """The pose of a robot as an exercise."""
    typed = [f"{23 + 14 * k}°" if j.kind == "revolute" else f"{0.1 + k / 20}" for k, j in enumerate(robot.joints)]
    given = joint_values(robot, ",".join(typed)) if numeric else {}
    return question_about(robot, f"pose {robot.frames[1]}..{robot.frames[-2]}", numeric=numeric, given=given)


def singles(judge: Judge, part: Part, tally: Tally) -> None:
    """Every single mistake of a part."""
    answers: dict[str, set[str]] = {}
    for slip in judge.slips(part):
        answers.setdefault(judge.answer_with(part, slip.name), set()).add(slip.name)
    for answer, makers in answers.items():
        judged = judge.judged(part, answer)
        if judged.mark.verdict not in UNSOLVED:
            continue
        start = time.perf_counter()
        found = judge.explained(part, judged).diagnosis or Diagnosis()
        tally.seconds.append(time.perf_counter() - start)
        tally.made += 1
        hit = any(name in makers for name in found.ids)
        tally.named += bool(found.causes)
        unique = hit and len(found.ids) == 1
        tally.unique += unique
        tally.alike += (
            not unique and bool(found.causes) and any(alike(judge, part, (maker, *found.ids)) for maker in makers)
        )
        tally.few += hit and len(found.ids) <= 3
        for name in found.ids:
            if name not in NOT_MADE and " + " not in name and name not in makers:
                other = judge.answer_with(part, name)
                is_right = judge.mark(part, other).verdict.passed is True
                tally.wrong += is_right or not agree(judge, part, answer, other)


def in_terms(judge: Judge, part: Part, tally: Tally, draw: random.Random) -> None:
    """Some of the mistakes in the terms of the entries of a part, each in one entry."""
    wrong = term_answers(judge, part)
    for wanted in draw.sample(sorted(wrong), min(TERMS, len(wrong))):
        answer = wrong[wanted][0]()
        judged = judge.judged(part, answer)
        if judged.mark.verdict not in UNSOLVED:
            continue
        start = time.perf_counter()
        found = judge.explained(part, judged).diagnosis or Diagnosis()
        tally.seconds.append(time.perf_counter() - start)
        tally.made += 1
        tally.named += bool(found.causes)
        unique = found.ids == (wanted,)
        others = [
            [one() for one in wrong[name]] if name in wrong else [made(judge, part, name)]
            for name in found.ids
            if name != wanted
        ]
        fits = [any(agree(judge, part, answer, one) for one in other) for other in others if any(other)]
        tally.unique += unique
        tally.alike += not unique and bool(found.causes) and all(fits)
        tally.wrong += len(fits) - sum(fits)
        tally.few += bool(found.causes) and len(found.ids) <= 3


def term_answers(judge: Judge, part: Part) -> dict[str, list[Callable[[], str]]]:
    """For each mistake in the terms of one entry the answers that it leads to; two for a term that stands twice."""
    case, question = Case(part, judge.memo), part.question
    if judge.exercise.numeric:
        return {}
    if isinstance(question, MatrixQuestion):
        search = search_of(question, judge.memo)
        right = search.general.entries(search.right)
        every = {one.slips[0].name: one for one in candidates(search.right, search.setting, among=IN_TERMS)}
        wrong = {name: one for name, one in every.items() if not same(search.general.entries(one.work), right)}
        return {name: [partial(typed_text, case, one.work)] for name, one in wrong.items()}
    if not isinstance(question, MotionQuestion):
        return {}
    right_grid = question.right(case)
    found: dict[str, list[Callable[[], str]]] = {}
    among = among_of(right_grid.rows, setting_of(judge.exercise))
    for r, row in enumerate(right_grid.rows):
        for c, entry in enumerate(row):
            for mistake in IN_ENTRY:
                for text, changed in mistake.made(entry, among):
                    line = (*row[:c], changed, *row[c + 1 :])
                    grid = replace(right_grid, rows=(*right_grid.rows[:r], line, *right_grid.rows[r + 1 :]))
                    about = " ".join(filter(None, (mistake.id, question.place(r, c), text)))
                    found.setdefault(about, []).append(partial(question.text, case, grid))
    return found


def made(judge: Judge, part: Part, name: str) -> str:
    """The answer of a mistake; nothing where it cannot be made."""
    try:
        return judge.answer_with(part, name)
    except DhcliError:
        return ""


def agree(judge: Judge, part: Part, answer: str, other: str) -> bool:
    """Whether two answers say the same: to the digits typed, or as expressions."""
    if isinstance(part.question, MotionQuestion):
        return same_grid(judge, part, answer, other)
    if isinstance(part.question, JointsQuestion):
        return solutions(answer) == solutions(other)
    if answer == other or not isinstance(part.question, MatrixQuestion):
        return answer == other or judge.mark(part, answer).reading == judge.mark(part, other).reading
    case = Case(part, judge.memo)
    first, second = (typed_answer(case, part.question, part.question.read(case, text)) for text in (answer, other))
    if first is None or second is None:
        return False
    slack = tuple(tuple(2 * limit for limit in row) for row in first.slacks[0])  # both have been rounded
    return all(matches(a, b, slack) for a, b in zip(first.values, second.values, strict=True))


def solutions(answer: str) -> list[list[float]]:
    """Joint values as they are typed, in degrees or metres: solutions in one order, angles from 0 to 360."""
    return sorted(
        [round(float(value.rstrip("° m")) % 360, 2) for value in row.split(", ")]
        for row in answer.strip("[]").split("; ")
    )


def same_grid(judge: Judge, part: Part, answer: str, other: str) -> bool:
    """Whether two answers about motion say the same: within the tolerance, or as expressions."""
    case = Case(part, judge.memo)
    first, second = (part.question.read(case, text) for text in (answer, other))
    exercise = judge.exercise
    if not exercise.numeric:
        return all(
            equal(a.expr, b.expr, exercise.values)
            for r, s in zip(first, second, strict=True)
            for a, b in zip(r, s, strict=True)
        )
    one, two = values_of(first, exercise), values_of(second, exercise)
    size = max(abs(value) for row in (*one, *two) for value in row)
    return all(abs(a - b) <= NEAR * size for r, s in zip(one, two, strict=True) for a, b in zip(r, s, strict=True))


def pairs(judge: Judge, part: Part, tally: Tally, count: int, draw: random.Random) -> None:
    """Some of the pairs of mistakes of a part."""
    answers = pair_answers(judge, part)
    for wanted in draw.sample(sorted(answers), min(count, len(answers))):
        answer = answers[wanted]()
        judged = judge.judged(part, answer)
        if judged.mark.verdict not in UNSOLVED:
            continue
        start = time.perf_counter()
        found = judge.explained(part, judged).diagnosis or Diagnosis()
        tally.seconds.append(time.perf_counter() - start)
        tally.made += 1
        tally.named += bool(found.causes)
        simpler = bool(found.causes) and len(found.causes[0]) == 1
        hit = wanted in found.ids or simpler  # one slip that gives the same answer is the better explanation
        unique = hit and len(found.ids) == 1
        tally.unique += unique
        tally.alike += not unique and bool(found.causes) and alike(judge, part, (wanted, *found.ids))
        tally.wrong += sum(not agree(judge, part, answer, answers[name]()) for name in found.ids if name in answers)
        tally.few += hit and len(found.ids) <= 3


def pair_answers(judge: Judge, part: Part) -> dict[str, Callable[[], str]]:
    """For each pair of mistakes of a part the answer that it leads to."""
    case, question = Case(part, judge.memo), part.question
    if isinstance(question, MatrixQuestion):
        works = search_of(question, judge.memo).pairs
        return {names(one.slips): partial(typed_text, case, one.work) for one in works}
    if isinstance(question, ColumnsQuestion):
        return {names(one.slips): partial(question.text, case, one.grid) for one in question.pairs(case)}
    return {}


def names(slips: Iterable[Slip]) -> str:
    """Mistakes that were made together as a diagnosis calls them."""
    return " + ".join(slip.name for slip in slips)


def alike(judge: Judge, part: Part, names_: Iterable[str]) -> bool:
    """Whether mistakes, or pairs of them, give one and the same answer at all values; a misprint copied does too."""
    if isinstance(part.question, ColumnsQuestion):
        return alike_grids(judge, part, part.question, set(names_))
    if not isinstance(part.question, MatrixQuestion):
        return not isinstance(part.question, TableQuestion)  # the same number or name, which is all there is
    search = search_of(part.question, judge.memo)
    wanted = set(names_) - {"misprint"}
    every = (*search.singles, *search.pairs) if any(" + " in name for name in wanted) else search.singles
    works = [one.work for one in every if names(one.slips) in wanted]
    if len(works) != len(wanted):
        return False
    first, *others = (search.general.entries(work) for work in works)
    return all(same(first, other) for other in others)


def alike_grids(judge: Judge, part: Part, question: ColumnsQuestion, wanted: set[str]) -> bool:
    """Whether mistakes in columns, or pairs of them, give one and the same answer at all values."""
    case = Case(part, judge.memo)
    paired = question.pairs(case) if any(" + " in name for name in wanted) else ()
    grids = [one.grid for one in paired if names(one.slips) in wanted]
    grids += [grid for slip, grid in question.every(case, question.right(case)) if slip.name in wanted]
    first, *others = (question.at_points(judge.memo, grid) for grid in grids)
    return len(grids) >= len(wanted) and all(same_points(first, other) for other in others)


MANY = 100
"""Pairs of PUMA 560 that are tried."""


TERMS = 12
"""Mistakes in the terms of a formula that are tried in each part."""


def main() -> None:
    """Print the table."""
    count, every = (*map(int, sys.argv[1:]), *(2, 1)[len(sys.argv) - 1 :])
    draw = random.Random(1)  # noqa: S311
    single: dict[str, Tally] = {}
    double: dict[str, Tally] = {}
    of_terms: dict[str, Tally] = {}
    for group, judge, part in islice(parts(), 0, None, every):
        singles(judge, part, single.setdefault(group, Tally()))
        pairs(judge, part, double.setdefault(group, Tally()), count, draw)
        if not judge.exercise.numeric:
            in_terms(judge, part, of_terms.setdefault(group, Tally()), random.Random(1))  # noqa: S311
    puma = {"PUMA 560, symbols": False, "PUMA 560, numbers": True}
    of_puma = {title: (Tally(), Tally()) for title in puma}
    for title, numeric in puma.items():
        judge = Judge(about(load_robot("puma560"), numeric=numeric))
        singles(judge, judge.exercise.parts[0], of_puma[title][0])
        pairs(judge, judge.exercise.parts[0], of_puma[title][1], MANY, draw)
    heads = ("made", 7), ("unique", 8), ("alike", 8), ("of rest", 8), ("of <= 3", 8), ("named", 8), ("wrong", 6)
    print(" " * 34 + " ".join(f"{head:>{width}}" for head, width in (*heads, ("median ms", 9), ("most ms", 7))))
    for title, tallies in (("one slip", single), ("in terms", of_terms), ("two slips", double)):
        for group, tally in tallies.items():
            print(tally.line(f"{title}: {group}"))
    for k, title in enumerate(("one slip", "two slips")):
        for group, tallies in of_puma.items():
            print(tallies[k].line(f"{title}: {group}"))
    everything = list(single.values())
    made, unique = sum(t.made for t in everything), sum(t.unique for t in everything)
    alike_ = sum(t.alike for t in everything)
    print(f"single slips named uniquely: {unique} of {made} ({unique / made:.1%})")
    print(f"of the {made - alike_} that the question can tell apart: {unique / (made - alike_):.1%}")


if __name__ == "__main__":
    main()
