"""Numbers with the way to them, and whole numbers with words around them: read as what was meant."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from dhcli.checking.judge import check
from dhcli.checking.reckoned import ReckonedError, reckoned
from dhcli.checking.verdicts import Verdict
from tests.once import load_exercise
from tests.row_by_row import row_by_row

SCARA, COUNTS, LINKAGES, REACH = (
    "bajd/scara-pose-in-mm",
    "yim/counting-freedoms",
    "yim/planar-linkages",
    "inverse/planar-reach",
)


@given(st.integers(-99, 99), st.integers(-99, 99), st.sampled_from("+-*"), st.integers(0, 3))
def test_a_reckoning_is_what_it_comes_to_or_is_refused(a: int, b: int, sign: str, off: int) -> None:
    """The right result leaves the first side, another one is no answer, and a name before it changes nothing."""
    text = f"({a}) {sign} ({b})"
    result = {"+": a + b, "-": a - b, "*": a * b}[sign]
    for name in ("", "F = ", "z = "):
        if off:
            with pytest.raises(ReckonedError, match="write the answer alone"):
                reckoned(f"{name}{text} = {result + off}")
        else:
            assert reckoned(f"{name}{text} = {result}") == text


@row_by_row(
    ("text", "meant"),
    [
        ("400 - 120 = 280 mm", "280 mm"),
        ("sqrt(0.61) = 0.78", "sqrt(0.61)"),
        ("2/3 = 0.67", "2/3"),
        ("90° = pi/2", "90°"),
        ("pi/2 = 90°", "90°"),
        ("0.4 = 400 mm", "400 mm"),
        ("-2/3 = -0.67", "-2/3"),
        ("0.2804 m = 280.4 mm", "0.2804 m"),
        ("1 + 1 = 2 = 4/2", "1 + 1"),
        ("z = 280", "z = 280"),
        ("a1 + 0 = a1", "a1 + 0 = a1"),
        ("x >= 3", "x >= 3"),
        ("[1 = 2]", "[1 = 2]"),
        ("", ""),
    ],
)
def test_the_first_side_has_all_digits_and_the_last_the_unit(text: str, meant: str) -> None:
    """Labels, names and matrices are none of its business."""
    assert reckoned(text) == meant


@row_by_row("text", ["0.2 m = 280.4 mm", "0.0 = 0.1", "1.29 = 1.4", "pi/3 = 90°", "0.3 = 400 mm"])
def test_a_result_shows_a_number_to_its_own_digits_in_its_own_unit(text: str) -> None:
    """A tenth of a millimetre is no tenth of a metre, and the last digit is rounded or cut off."""
    with pytest.raises(ReckonedError, match="write the answer alone"):
        reckoned(text)


def test_what_may_be_equal_in_the_unit_of_a_sheet_is_not_called_unequal() -> None:
    """On a sheet in millimetres 280 is 0.28 m."""
    with pytest.raises(ReckonedError, match=r"^280 stands beside 0\.28 m: write"):
        reckoned("280 = 0.28 m")
    with pytest.raises(ReckonedError, match=r"^0\.2 m is not 280\.4 mm: write"):
        reckoned("0.2 m = 280.4 mm")


@row_by_row(
    ("exercise", "part", "answer", "verdict"),
    [
        (SCARA, "height", "400-120=280", Verdict.RIGHT),
        (SCARA, "height", "z = 400 - 120 = 280 mm", Verdict.RIGHT),
        (SCARA, "height", "400+120 = 520", Verdict.WRONG),
        (SCARA, "height", "400-120 = 520", Verdict.CANNOT_READ),
        (COUNTS, "sixr", "6*(7-6-1)+6 = 6", Verdict.RIGHT),
        (LINKAGES, "f4", "F = 3(4-1) - 2*4 = 1", Verdict.RIGHT),
        (LINKAGES, "f4", "3(4-1)-4 = 5", Verdict.WRONG),
        (LINKAGES, "f4", "7 = 1", Verdict.CANNOT_READ),
        (COUNTS, "links", "7 (with the ground)", Verdict.RIGHT),
        (COUNTS, "links", "6 (without the ground)", Verdict.WRONG),
        (COUNTS, "links", "there are 7 links", Verdict.RIGHT),
        (COUNTS, "links", "there are 7 joints", Verdict.CANNOT_READ),
        (COUNTS, "links", "links: 7", Verdict.RIGHT),
        (COUNTS, "links", "Link = 6", Verdict.WRONG),
        (COUNTS, "sixr", "degrees of freedom: 6", Verdict.RIGHT),
        (COUNTS, "sixr", "d.o.f. = 6", Verdict.RIGHT),
        (REACH, "ways", "2 (elbow up & down)", Verdict.RIGHT),
        (REACH, "rim", "exactly one", Verdict.RIGHT),
        (REACH, "rim", "only 2", Verdict.WRONG),
        (REACH, "outside", "no because sqrt(.61)=.78>.7", Verdict.RIGHT),
        (REACH, "outside", "Nope", Verdict.RIGHT),
        (REACH, "outside", "reach = no", Verdict.RIGHT),
        (REACH, "hole", "yeah, r=0.07", Verdict.WRONG),
        (REACH, "inside", "reachable, no problem", Verdict.RIGHT),
        ("motion/puma560-rank-in-numbers", "wrist", "rank 2", Verdict.RIGHT),
        ("motion/puma560-rank-in-numbers", "wrist", "the rank is 2", Verdict.RIGHT),
        ("motion/planar-jacobian", "singular", "when theta2 is 0 or 180 degrees", Verdict.RIGHT),
        ("motion/planar-jacobian", "singular", "if θ2 is 90°", Verdict.WRONG),
    ],
)
def test_answers_with_words_around_them_are_judged(exercise: str, part: str, answer: str, verdict: Verdict) -> None:
    """As a person says them; what cannot be is no answer."""
    found = check(load_exercise(exercise), part, answer)
    assert found.verdict is verdict, found.remarks


def test_two_solutions_that_are_one_are_counted_twice() -> None:
    """At the rim, where elbow up and elbow down are the same."""
    found = check(load_exercise(REACH), "rim", "2")
    assert found.diagnosis is not None
    assert found.diagnosis.ids == ("counted-twice",)


@row_by_row(
    ("exercise", "part", "answer"),
    [
        (COUNTS, "links", "7 or 6"),
        (COUNTS, "links", "7 (or 6)"),
        (COUNTS, "links", "7 (not 6)"),
        (COUNTS, "links", "7, 6"),
        (COUNTS, "links", "not 7"),
        (COUNTS, "links", "joints = 7"),
        (COUNTS, "links", "degrees of freedom = 7"),
        (COUNTS, "links", "dof: 7"),
        (COUNTS, "sixr", "links = 6"),
        (REACH, "ways", "2 or 1"),
        (REACH, "ways", "2 (or 1)"),
        (REACH, "inside", "yes, no"),
        (REACH, "inside", "no wait, yes"),
        (REACH, "inside", "not yes"),
        (REACH, "inside", "y/n"),
        ("yim/planar-two-links", "blocks", "1 or 2"),
        (SCARA, "height", "280 or 520"),
        (SCARA, "height", "±280"),
        ("motion/planar-jacobian", "determinant", "±a1*a2*s2"),
        ("inverse/planar-joints-in-numbers", "down", "2.48, 67.98 or 59.45, -67.98"),
    ],
)
def test_two_answers_are_none(exercise: str, part: str, answer: str) -> None:
    """Whoever says both has not chosen, and whoever names another thing has not said this one."""
    assert check(load_exercise(exercise), part, answer).verdict is Verdict.CANNOT_READ
