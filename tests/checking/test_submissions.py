"""The public table of submissions: what students type, and the verdict that a fair lecturer gives."""

from __future__ import annotations

import json
from collections import Counter
from functools import cache
from pathlib import Path
from typing import Any

import pytest

from dhcli.checking.exercise import Exercise, Part
from dhcli.checking.verdicts import Verdict
from dhcli.files.yaml.exercises import load_exercise, read_exercise
from tests.judging import mark
from tests.row_by_row import row_by_row

TABLE: dict[str, Any] = json.loads((Path(__file__).parents[1] / "data" / "submissions.json").read_text("utf-8"))
SUBMISSIONS: list[dict[str, Any]] = TABLE["submissions"]
OF_THE_PART = ("ask", "compare", "decimals", "exact", "options", "right")
KEYS = {"id", "target", "answer", "verdict", "why", "remark", "earned"}


@cache
def asked(target: str) -> tuple[Exercise, Part]:
    """The part of an exercise that a target names, or one made of a robot and options."""
    spec = dict(TABLE["targets"][target])
    if "exercise" in spec:
        exercise = load_exercise(spec["exercise"])
        return exercise, exercise.part(spec["part"])
    part = {"id": "answer", **{key: spec.pop(key) for key in OF_THE_PART if key in spec}}
    document = {"format": 1, "title": target, "source": "tests", "task": target, **spec, "parts": [part]}
    exercise = read_exercise(json.dumps(document, ensure_ascii=False), "submissions.json", "target")
    return exercise, exercise.parts[0]


@row_by_row("submission", SUBMISSIONS)
def test_a_submission_gets_the_verdict_of_a_fair_lecturer(submission: dict[str, Any]) -> None:
    """And the remark and the credit, where the table has them."""
    exercise, part = asked(submission["target"])
    judged = mark(exercise, part, submission["answer"])
    assert judged.verdict.word == submission["verdict"], (submission["why"], judged.remarks)
    if "remark" in submission:
        assert any(submission["remark"] in remark for remark in judged.remarks), judged.remarks
    if "earned" in submission:
        assert judged.earned == pytest.approx(submission["earned"], abs=1e-3)


def test_every_row_of_the_table_is_complete() -> None:
    """Ids are unique, every target is defined and used, every verdict is a word of dhcli, and each has its reason."""
    ids = Counter(submission["id"] for submission in SUBMISSIONS)
    assert [name for name, count in ids.items() if count > 1] == []
    assert {submission["target"] for submission in SUBMISSIONS} == set(TABLE["targets"])
    assert {submission["verdict"] for submission in SUBMISSIONS} == {verdict.word for verdict in Verdict}
    assert all(submission["why"] and set(submission) <= KEYS for submission in SUBMISSIONS)


def test_the_table_covers_what_students_do() -> None:
    """Enough rows, and every verdict often enough to mean something."""
    verdicts = Counter(submission["verdict"] for submission in SUBMISSIONS)
    assert len(SUBMISSIONS) >= 300
    assert min(verdicts.values()) >= 3, verdicts
    assert min(verdicts[word] for word in ("RIGHT", "WRONG", "CAN'T READ")) >= 80, verdicts
