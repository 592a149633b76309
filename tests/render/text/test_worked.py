"""Solutions of several parts: what they have in common is shown once, and nothing is left out."""

from __future__ import annotations

import io

from dhcli.checking.judge import Judge
from dhcli.files.yaml.exercises import load_exercise
from dhcli.render.paper import Paper
from dhcli.render.text.worked import FEWEST, since, solutions_text
from tests.row_by_row import row_by_row

EXERCISES = ["yim/planar-two-links", "yim/stanford-hand", "yim/planar-in-numbers", "motion/planar-jacobian"]


@row_by_row("name", EXERCISES)
def test_steps_behind_those_of_an_earlier_part_are_all_there(name: str) -> None:
    """What is left out stands word for word in the part that is named, and the matrix reached is shown again."""
    judge = Judge(load_exercise(name))
    steps = {part.id: judge.solution(part) for part in judge.exercise.asked}
    done: dict[str, tuple[object, ...]] = {}
    shortened = 0
    for part, own in steps.items():
        told = since(own, {other: steps[other] for other in done})
        if told != own:
            shortened += 1
            other = next(one for one in done if told[0].text.startswith(f"As for {one},") or one in told[0].text)
            reached = 1 if told[1].rows else 0
            left = len(own) - len(told[1 + reached :])
            assert sum(len(step.text.splitlines()) + len(step.rows) for step in own[:left]) >= FEWEST
            assert own[:left] == steps[other][:left]
            assert told[1 + reached :] == own[left:]
            assert not reached or told[1] == [step for step in own[:left] if step.rows][-1]
        done[part] = own
    assert shortened


def test_a_part_by_itself_is_worked_out_whole() -> None:
    """There is nothing before it."""
    judge = Judge(load_exercise("yim/stanford-hand"))
    paper = Paper.of(io.StringIO())
    for part in judge.exercise.asked[:3]:
        text = solutions_text(judge.exercise, {part.id: judge.solution(part)}, paper)
        assert "As for" not in text
        assert text.count("From frame") == 6
