"""A symbolic 4x4 of PUMA 560: read beside sympy reading it, and marked beside importing sympy alone."""

from __future__ import annotations

import sys
from collections.abc import Iterator

import sympy
from measure import Row, Task, side_by_side
from startup import run
from symbols import agree
from sympy.parsing.sympy_parser import parse_expr

from dhcli import load_robot
from dhcli.algebra.symbolic import to_sympy
from dhcli.checking.exercise import Exercise
from dhcli.checking.judge import Judge
from dhcli.checking.kinds.made import question_about
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
    ours = Task("parse_matrix", lambda: parse_matrix(answer, exercise.scope))
    for name, read in (("parse_expr", parse_expr), ("sympify", lambda text, names: sympy.sympify(text, locals=names))):
        peer = Task(f"sympy, {name}", lambda read=read: sympy.Matrix(read(answer, names)))
        note = f"{len(answer)} characters; sympy's cache is warm"
        yield side_by_side("parsing a 4x4 of PUMA 560", ours, peer, same_matrix, rounds=rounds, note=note)


def rows(rounds: int) -> Iterator[Row]:
    """The pose marked in the process, and by a whole `dhcli check`."""
    exercise, answer = question()
    part, judge = exercise.parts[0], Judge(exercise)
    command = [sys.executable, "-m", "dhcli", "check", "puma560", "--symbolic", "--answer", answer]
    peer = Task("python -c 'import sympy'", lambda: run(SYMPY))
    yield side_by_side(
        "marking a 4x4 of PUMA 560",
        Task("mark", lambda: judge.mark(part, answer)),
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


def same_matrix(ours: tuple[tuple[Cell, ...], ...], theirs: sympy.Matrix) -> bool:
    """Whether the same matrix was read."""
    return agree(sympy.Matrix([[to_sympy(cell.expr) for cell in row] for row in ours]), theirs)
