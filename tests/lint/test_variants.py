"""Rules for variants: what a student would get must be fair, solvable and nowhere given away."""

from __future__ import annotations

import re
from dataclasses import replace
from pathlib import Path

import pytest

from dhcli.checking.exercise import Part
from dhcli.checking.judge import Judge
from dhcli.checking.variants import vary
from dhcli.checking.verdicts import Verdict
from dhcli.checking.written import Range
from dhcli.files.yaml.exercises import load_exercise, read_exercise
from dhcli.lint import variants
from dhcli.notation.angle import Angle
from tests.lint.linting import Broken, assert_told, cases, findings
from tests.nightly import some

CLEAN = """\
format: 1
title: The arm in numbers
source: a test
robot: planar-2r
numeric: true
unit: m
given: {theta1: 35°, theta2: 20°}
variants:
  theta1: 20°..70° step 5°
  theta2: 20°..70° step 5°
task: Find the end.
parts:
  - id: tip
    ask: position of pose 0..2
    prompt: Where is the end?
    hints: [the last column]
tests:
  - {part: tip, answer: "0.4997, 0.4752, 0", verdict: RIGHT}
  - {part: tip, answer: "0.4997, 0.5752, 0", verdict: WRONG}
"""

EVERY_SEED = variants.SEEDS
BELOW = "dhcli writes the drawn numbers below the task; leave it out here"
NUMBER = "theta1 varies, and this text gives it a number"
SAID = "this text says 35°, which is theta1 in the file and another number in a variant"


@cases(
    Broken("Find the end.", "Find the end at θ1 = 30°.", "11:7", NUMBER, BELOW),
    Broken("Where is the end?", "The end at theta_1=-0.3?", "15:13", NUMBER, BELOW),
    Broken("the last column", "\\theta_1 = 35 again", "16:13", NUMBER, BELOW),
    Broken("Find the end.", "Find the end at 35°.", "11:7", SAID, "write theta1", is_warning=True),
    Broken("the last column", "the cosine of 35° first", "16:13", SAID, "write theta1", is_warning=True),
)
def test_a_text_that_gives_a_drawn_number_away_is_told(broken: Broken, tmp_path: Path) -> None:
    """In the task, beside a part, and in a hint."""
    assert_told(tmp_path, CLEAN, broken)


@pytest.mark.parametrize(
    "text",
    [
        *("Find theta1 + theta2 = phi.", "Link 1 = 0.4 m.", "135° and 35.5", "q = theta1"),
        "At joint zero, theta1 = theta2 = 0, the arm is stretched out.",
        "At θ2 = 0.0° it is straight.",
    ],
)
def test_other_numbers_in_a_text_are_left_alone(text: str, tmp_path: Path) -> None:
    """They do not vary."""
    assert findings(tmp_path, CLEAN.replace("Find the end.", text)) == []


def test_a_zero_that_is_drawn_is_told_in_a_text(tmp_path: Path) -> None:
    """The text says where the arm stands then, and not how its zero is counted."""
    text = CLEAN.replace("theta1: 35°,", "theta1: 0,").replace("Find the end.", "Find the end at theta1 = 0.")
    assert any(NUMBER in repr(found) for found in findings(tmp_path, text))


def test_a_draw_outside_the_limits_of_a_joint_is_told(tmp_path: Path) -> None:
    """With the first value that is, and with the limits."""
    text = CLEAN.replace("planar-2r", "puma560").replace("pose 0..2", "pose 0..1")
    text = text.replace("  theta1: 20°..70° step 5°", "  theta1: 150°..170° step 5°")
    found = findings(tmp_path, text)
    assert Broken("", "", "9:11", "theta1: 165° is outside its limits, -160° to 160°", "narrow the range") in found


@cases(
    Broken(
        "  theta1: 20°..70° step 5°",
        "  theta1: 45°..135° step 45°",
        "8:1",
        "own: 1000 draws gave no pose at which mistakes show; the last: theta1 is a multiple of 45°",
        "widen the variants, theta1: 45°..135° step 45°, theta2: 20°..70° step 5°",
    )
)
def test_ranges_without_a_fair_pose_are_told(broken: Broken, tmp_path: Path) -> None:
    """With the rule that the last draw broke."""
    assert_told(tmp_path, CLEAN, broken)


def test_ranges_in_which_every_pose_hides_something_are_told() -> None:
    """At this tolerance each of the two poses hides other mistakes: the first seed is named, with one of them."""
    planar = load_exercise("yim/planar-in-numbers")
    angles = {"theta1": (30,), "theta2": (20, 55)}
    ranges = {name: Range("", tuple(map(Angle.in_degrees, values))) for name, values in angles.items()}
    coarse = replace(planar.tolerance, position=0.02)
    (found,) = variants.findings(Judge(replace(planar, variants=ranges, tolerance=coarse)))
    assert found.where == ("variants",)
    assert found.is_warning
    assert re.fullmatch(
        r"variant 1: no pose was found that shows every mistake; at this one \w+ hides [a-z-]+.*", found.message
    )
    assert found.hint == "widen the ranges, or narrow the tolerance"


def test_a_variant_whose_solution_is_not_right_is_told(tmp_path: Path) -> None:
    """With the command that shows it; once, though it is so for every seed."""
    text = CLEAN.replace("    hints:", "    exact: true\n    hints:")
    told = [one for one in findings(tmp_path, text) if one.at == "8:1"]
    assert told == [
        Broken(
            "",
            "",
            "8:1",
            "variant 1: the solution of tip is judged ROUNDED",
            "dhcli solution own --variant 1 --part tip",
        )
    ]


def test_all_seeds_are_drawn_and_every_part_of_each_is_solved(monkeypatch: pytest.MonkeyPatch) -> None:
    """The last of 200 as well as the first, by day of fewer; numbers that were solved already are not solved again."""
    assert list(EVERY_SEED) == [str(number) for number in range(1, 201)]
    seeds = some(EVERY_SEED, 4)
    monkeypatch.setattr(variants, "SEEDS", seeds)
    exercise = load_exercise("yim/planar-in-numbers")
    drawn: list[Judge] = []
    solved: list[tuple[str, str]] = []

    def solve(one: Judge, part: Part) -> Verdict:
        solved.append((one.exercise.variant, part.id))
        return Verdict.RIGHT

    monkeypatch.setattr(variants, "vary", lambda one, seed: drawn.append(vary(one, seed)) or drawn[-1])
    monkeypatch.setattr(variants, "_own_verdict", solve)
    assert list(variants.findings(Judge(exercise))) == []
    assert [one.exercise.variant for one in drawn] == list(seeds)
    different = {tuple(sorted((name, str(value)) for name, value in one.exercise.given.items())) for one in drawn}
    assert len(solved) == len(different) * len(exercise.parts)
    assert {part for _, part in solved} == {part.id for part in exercise.parts}


def test_a_fault_that_only_the_last_seed_has_is_found(monkeypatch: pytest.MonkeyPatch) -> None:
    """Nothing is sampled."""
    exercise = load_exercise("yim/stanford-in-numbers")
    last = exercise.parts[-1].id
    monkeypatch.setattr(
        variants,
        "_own_verdict",
        lambda one, part: Verdict.WRONG if (one.exercise.variant, part.id) == ("200", last) else Verdict.RIGHT,
    )
    (found,) = variants.findings(Judge(exercise))
    assert found.message == f"variant 200: the solution of {last} is judged WRONG"


def test_an_exercise_without_variants_breaks_none_of_these_rules() -> None:
    """Its numbers may well stand in its text."""
    text = CLEAN.replace("variants:\n  theta1: 20°..70° step 5°\n  theta2: 20°..70° step 5°\n", "")
    text = text.replace("Find the end.", "At theta1 = 35°.")
    assert list(variants.findings(Judge(read_exercise(text, "own.yaml", "own")))) == []
