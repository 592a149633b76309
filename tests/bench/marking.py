"""Marking: one symbolic 4x4 of PUMA 560 in the process, and a whole `dhcli check`, beside importing sympy alone."""

from __future__ import annotations

import sys
from collections.abc import Iterator

from measure import Row, side_by_side
from startup import run

from dhcli import load_robot
from dhcli.checking.exercise import question_about
from dhcli.checking.marking import expected, mark
from dhcli.checking.verdicts import Verdict

SYMPY = [sys.executable, "-c", "import sympy"]


def rows(rounds: int) -> Iterator[Row]:
    """The pose of PUMA 560 in full spelling, marked in both ways."""
    exercise = question_about(load_robot("puma560"), "0", "6", numeric=False, given={})
    part = exercise.parts[0]
    answer = expected(exercise, part, "full")
    if mark(exercise, part, answer).verdict is not Verdict.RIGHT:
        raise SystemExit("the right answer is not marked right")
    peer = ("python -c 'import sympy'", lambda: run(SYMPY))
    ours = ("mark(exercise, part, answer)", lambda: mark(exercise, part, answer))
    yield side_by_side("marking a symbolic 4x4, PUMA 560", ours, peer, rounds=rounds)
    command = [sys.executable, "-m", "dhcli", "check", "puma560", "--symbolic", "--answer", answer]
    if run(command).returncode != 0:
        raise SystemExit("dhcli check does not work")
    yield side_by_side("a whole dhcli check", ("dhcli check puma560 ...", lambda: run(command)), peer, rounds=rounds)
