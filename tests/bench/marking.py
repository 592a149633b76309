"""A symbolic 4x4 of PUMA 560 and its wrong tables: read beside sympy, and marked beside importing sympy alone."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from dataclasses import replace

import sympy
from measure import Row, Task, duration, side_by_side
from startup import run
from symbols import agree
from sympy.parsing.sympy_parser import parse_expr

from dhcli import load_robot
from dhcli.algebra.symbolic import to_sympy
from dhcli.checking.exercise import Exercise
from dhcli.checking.judge import Judge
from dhcli.checking.kinds.made import question_about, question_about_table
from dhcli.checking.verdicts import Verdict
from dhcli.notation.matrix import Cell, parse_matrix

SYMPY = [sys.executable, "-c", "import sympy"]


def question() -> tuple[Exercise, str]:
    """The pose of PUMA 560 as an exercise, and the right answer in full spelling, which sympy reads, too."""
    exercise = question_about(load_robot("puma560"), "pose 0..6", numeric=False, given={})
    return exercise, Judge(exercise).expected(exercise.parts[0], "full")


def parsing(rounds: int) -> Iterator[Row]:
    """The text read, by us and by the two readers of sympy, which evaluate it as Python: this text can be trusted."""
    exercise, answer = question()
    names = {name: sympy.Symbol(name, real=True) for name in (*exercise.scope.joints, *exercise.scope.lengths)}
    ours = Task("parse_matrix", lambda: parse_matrix(answer, replace(exercise.scope)))  # which remembers nothing
    for name, read in (("parse_expr", parse_expr), ("sympify", lambda text, names: sympy.sympify(text, locals=names))):
        peer = Task(f"sympy, {name}", lambda read=read: sympy.Matrix(read(answer, names)))
        note = f"{len(answer)} characters; sympy's cache is warm"
        yield side_by_side("parsing a 4x4 of PUMA 560", ours, peer, same_matrix, rounds=rounds, note=note)


def wrong_tables() -> tuple[Exercise, tuple[str, ...]]:
    """The table of PUMA 560 as an exercise, and its wrong answers: one for each kind of mistake, and what is none."""
    robot = load_robot("puma560")
    exercise = question_about_table(robot, robot.convention)
    part, judge = exercise.parts[0], Judge(exercise)
    kinds = {slip.name.partition(" ")[0]: slip.name for slip in judge.slips(part)}
    answers = [judge.answer_with(part, name) for name in kinds.values()]
    right = [row.strip("[]") for row in judge.expected(part).split("], [")]
    swapped = ((1, 0, 2, 3, 4, 5), (0, 1, 3, 2, 4, 5))
    answers += ["\n".join(right[k] for k in order) for order in swapped]
    answers.append("\n".join(("0, 0, 0, theta1", "0, 35, 0, theta2", *right[2:4], "0, 45, d4, theta5", right[5])))
    wrong = tuple(text for text in answers if judge.mark(part, text).verdict is Verdict.WRONG)
    return exercise, wrong


def tables(rounds: int) -> Iterator[Row]:
    """Wrong tables marked and explained, by a judge for each and by one for all, beside importing sympy as often."""
    exercise, answers = wrong_tables()
    part, known = exercise.parts[0], Judge(exercise)
    peer = Task("python -c 'import sympy'", lambda: run(SYMPY))
    for title, judge in (("a new judge", lambda: Judge(exercise)), ("the same judge", lambda: known)):
        row = side_by_side(
            f"{len(answers)} wrong tables of PUMA 560, explained by {title}",
            Task("check", lambda judge=judge: [judge().check(part, text) for text in answers]),
            peer,
            lambda ours, theirs: (
                all(mark.verdict is Verdict.WRONG for mark in ours)
                and sum(mark.diagnosis is not None for mark in ours) > len(ours) // 2
                and theirs.returncode == 0
            ),
            rounds=rounds,
        )
        yield replace(row, note=f"{duration(row.seconds / len(answers))} a table")


def rows(rounds: int) -> Iterator[Row]:
    """The pose marked in the process, and by a whole `dhcli check`; then tables."""
    exercise, answer = question()
    part = exercise.parts[0]
    command = [sys.executable, "-m", "dhcli", "check", "puma560", "--symbolic", "--answer", answer]
    peer = Task("python -c 'import sympy'", lambda: run(SYMPY))
    yield side_by_side(
        "marking a 4x4 of PUMA 560",
        Task("mark, a new judge", lambda: Judge(exercise).mark(part, answer)),
        peer,
        lambda ours, theirs: ours.verdict is Verdict.RIGHT and theirs.returncode == 0,
        rounds=rounds,
    )
    yield side_by_side(
        "the same as a command",
        Task("dhcli check puma560 ...", lambda: run(command)),
        peer,
        lambda ours, theirs: ours.returncode == 0 == theirs.returncode,
        rounds=rounds,
    )
    yield from tables(rounds)


def same_matrix(ours: tuple[tuple[Cell, ...], ...], theirs: sympy.Matrix) -> bool:
    """Whether the same matrix was read."""
    return agree(sympy.Matrix([[to_sympy(cell.expr) for cell in row] for row in ours]), theirs)
