"""What an answer earns: by the usual shares, and by those that an author sets; and parts that were withdrawn."""

from __future__ import annotations

import re
from collections.abc import Mapping
from pathlib import Path

import pytest

from dhcli.checking.credit import USUAL, Shares
from dhcli.checking.earning import worth, worth_of
from dhcli.checking.exercise import Exercise
from dhcli.checking.judge import Judge
from dhcli.checking.variants import vary
from dhcli.checking.verdicts import Verdict
from dhcli.errors import DhcliError, FileError
from dhcli.files.yaml.exercises import load_exercise, read_exercise
from dhcli.files.yaml.sheets import read_sheet, write_sheet
from tests.row_by_row import row_by_row

LINK = "0.8660 -0.5 0 0.3464; 0.5 0.8660 0 0.2; 0 0 1 0; 0 0 0 1"
HEAD = "format: 1\ntitle: t\nsource: s\ntask: t\nrobot: planar-2r\n"
NUMERIC = "numeric: true\ngiven: {theta1: 30°, theta2: 45°}\n"


def exercise(ask: str, credit: str = "", *, of_all: str = "", numeric: bool = True) -> Exercise:
    """An exercise of one part about the planar arm, a1 = 0.4 m and a2 = 0.3 m."""
    top = f"credit: {of_all}\n" if of_all else ""
    own = f"    credit: {credit}\n" if credit else ""
    return read_exercise(f"{HEAD}{NUMERIC if numeric else ''}{top}parts:\n  - id: p\n    ask: {ask}\n{own}", "e", "e")


def earned(asked: Exercise, answer: str) -> tuple[Verdict, float]:
    """The verdict on an answer to the one part, and what it earns."""
    sheet = Judge(asked).sheet({"p": answer})
    return sheet.verdict, pytest.approx(sheet.earned)


# ------------------------------------------------------------------------------------------------ shares of a pose


@pytest.mark.parametrize(
    ("credit", "share"),
    [("1", 2 / 3), ("{rotation: 0.7}", 0.3), ("{position: 1/4}", 1 / 4), ("{points: 4, rotation: 1/2}", 2)],
)
def test_a_wrong_rotation_costs_what_the_rotation_is_worth(credit: str, share: float) -> None:
    """Usually one of three items, x and y being the others: z is the same for everybody."""
    answer = LINK.replace("-0.5", "0.5").replace("0.5 0.8660 0 0.2", "-0.5 0.8660 0 0.2")
    assert earned(exercise("link 1", credit), answer) == (Verdict.WRONG, share)


def test_one_wrong_coordinate_costs_its_part_of_the_position() -> None:
    """Half of it, where two are counted."""
    answer = LINK.replace("0.3464", "0.9")
    assert earned(exercise("link 1"), answer) == (Verdict.WRONG, 2 / 3)
    assert earned(exercise("link 1", "{rotation: 0.6}"), answer) == (Verdict.WRONG, 0.6 + 0.4 / 2)


@pytest.mark.parametrize(
    ("credit", "answer", "share"),
    [
        ("1", "0.87 -0.5 0 0.9; 0.5 0.87 0 0.2; 0 0 1 0; 0 0 0 1", 2 / 3),
        ("1", "0.87 -0.5 0 0.9; 0.5 0.87 0 0.9; 0 0 1 0; 0 0 0 1", 1 / 3),
        ("{rounded: 1/2}", "0.87 -0.5 0 0.9; 0.5 0.87 0 0.2; 0 0 1 0; 0 0 0 1", 1 / 2),
        ("1", "0.9 -0.5 0 0.9; 0.5 0.9 0 0.2; 0 0 1 0; 0 0 0 1", 1 / 3),
        ("1", "0.87 -0.5 0 0.9; -0.5 0.87 0 0.2; 0 0 1 0; 0 0 0 1", 1 / 3),
    ],
)
def test_beside_a_wrong_entry_two_decimals_earn_what_they_earn_alone(credit: str, answer: str, share: float) -> None:
    """A slip in one coordinate is no reason to judge the digits of the others otherwise."""
    assert earned(exercise("link 1", credit), answer) == (Verdict.WRONG, share)


def test_axes_that_are_right_to_the_digits_typed_are_not_called_turned() -> None:
    """What is told is the coordinate that is wrong."""
    sheet = Judge(exercise("link 1")).sheet({"p": "0.87 -0.5 0 0.9; 0.5 0.87 0 0.2; 0 0 1 0; 0 0 0 1"})
    assert sheet.parts[0].mark.remarks == (
        "the axes point the right way, but their direction cosines need more digits",
        "the position is off by 0.554 m along x",
    )


def test_of_a_short_answer_each_number_with_two_decimals_earns_its_part() -> None:
    """0.3 for 0.346 does not; beside it, 0.20 is within the tolerance."""
    short = "0.87 -0.5 0 0.3; 0.5 0.87 0 0.20; 0 0 1 0; 0 0 0 1"
    assert earned(exercise("link 1"), short) == (Verdict.ROUNDED, 2 / 3)


def test_in_symbols_each_entry_is_an_item_and_the_halves_weigh_what_was_set() -> None:
    """One of four cosines is wrong, and one of two lengths."""
    answer = "c1 -s1 0 a1*c1; -s1 c1 0 a1*c1; 0 0 1 0; 0 0 0 1"
    assert earned(exercise("link 1", numeric=False), answer) == (Verdict.WRONG, 4 / 6)
    asked = exercise("link 1", "{rotation: 0.8}", numeric=False)
    assert earned(asked, answer) == (Verdict.WRONG, 0.8 * 3 / 4 + 0.2 / 2)


def test_a_zero_that_is_none_costs_an_entry_in_its_half() -> None:
    """And never more than the half is worth."""
    asked = exercise("link 1", "{rotation: 0.8}", numeric=False)
    one = "c1 -s1 s1 a1*c1; s1 c1 0 a1*s1; 0 0 1 0; 0 0 0 1"
    assert earned(asked, one) == (Verdict.WRONG, 0.8 * 3 / 4 + 0.2)
    assert earned(asked, one.replace("0 0 1 0;", "s1 s1 c1 0;")) == (Verdict.WRONG, pytest.approx(0.2))


@pytest.mark.parametrize("credit", ["{close: 1}", "{rotation: 0.9}", "{position: 0.9}"])
def test_whoever_works_out_nothing_earns_nothing_whatever_was_set(credit: str) -> None:
    """The identity for a link."""
    assert earned(exercise("link 1", credit), "1 0 0 0; 0 1 0 0; 0 0 1 0; 0 0 0 1")[1] == 0
    assert earned(exercise("link 1", credit, numeric=False), "1 0 0 0; 0 1 0 0; 0 0 1 0; 0 0 0 1")[1] == 0


# ------------------------------------------------------------------------------------------- shares of the verdicts


@pytest.mark.parametrize(("credit", "share"), [("1", 1 / 2), ("{close: 0.6}", 1.6 / 2)])
def test_what_is_close_earns_its_share(credit: str, share: float) -> None:
    """Each length by itself: x is 2 mm off where 0.7 mm are allowed, y is right."""
    assert earned(exercise("position of link 1", credit), "0.3484, 0.2000, 0") == (Verdict.CLOSE, share)


@pytest.mark.parametrize(("credit", "share"), [("1", 3 / 4), ("{close: 0.6}", 3.6 / 4), ("{close: 1}", 1)])
def test_an_entry_of_a_jacobian_that_is_close_earns_its_share(credit: str, share: float) -> None:
    """One of the four that are not the same for everybody, 1.5 mm off where 0.5 mm are allowed."""
    asked = exercise("jacobian linear of 0..2", credit)
    assert earned(asked, "-0.4913 -0.2898; 0.4241 0.0776; 0 0") == (Verdict.CLOSE, share)


@pytest.mark.parametrize(("credit", "share"), [("1", 1), ("{rounded: 0.5}", 0.5)])
def test_a_velocity_that_is_rounded_earns_its_share(credit: str, share: float) -> None:
    """All of it unless somebody says otherwise."""
    assert earned(exercise("velocity of 0..2 with rates (1, 1)", credit), "-0.78, 0.50, 0") == (Verdict.ROUNDED, share)


def test_a_zero_of_a_jacobian_that_is_none_costs_what_an_entry_earns() -> None:
    """Whatever was set: four entries count, and the wrong zero is a fifth."""
    for credit in ("1", "{close: 0.5}", "{rounded: 0.3}"):
        asked = exercise("jacobian linear of 0..2", credit)
        assert earned(asked, "-0.4898 -0.2898; 0.4241 0.0776; 0 0.5") == (Verdict.WRONG, 4 / 5)


@pytest.mark.parametrize("credit", ["1", "{close: 1}", "{rotation: 0.5}"])
@pytest.mark.parametrize(
    ("ask", "numeric", "zeros", "one_right"),
    [
        ("column 1 of jacobian space of 0..2", False, "0, 0, 0, 0, 0, 0", "0, 0, 1, 0, 0, 1"),
        ("angular velocity of 0..2 with rates (1, 1)", True, "0, 0, 0", "0, 2, 0"),
        ("differential motion (0, 0, 0) turn (0, 0, 0.01) of 0..1", True, "0 0 0 0;" * 4, "0 0 1 0;" * 4),
        ("axis z of pose 0..2", False, "0, 0, 0", "0, 0, -1"),
        ("axis z of pose 0..2", True, "0, 0, 0", "0, 0, -1"),
        ("'product \"Trans(0, 0, 5) Rot(y, 90°)\"'", False, "0 0 0 0; 0 0 0 0; 0 0 0 0; 0 0 0 1", "1 0 0 0; " * 4),
        ("'product \"Trans(0, 0, 5) Rot(y, 90°)\"'", True, "0 0 0 0; 0 0 0 0; 0 0 0 0; 0 0 0 1", "1 0 0 0; " * 4),
        ("'position of product \"Trans(0, 0, 5) Rot(y, 90°)\"'", True, "0, 0, 0", "5, 0, 0"),
    ],
)
def test_zeros_earn_nothing_where_zeros_are_right(
    ask: str, credit: str, zeros: str, one_right: str, *, numeric: bool
) -> None:
    """Nor does an answer with as many wrong entries beside them as there are to be worked out."""
    for answer in (zeros, one_right):
        assert earned(exercise(ask, credit, numeric=numeric), answer)[1] == 0, answer


def test_a_coordinate_that_is_zero_at_the_values_given_only_costs() -> None:
    """At 90° x is 0: y is what was to be worked out, and a wrong x costs as much."""
    asked = read_exercise(
        f"{HEAD}numeric: true\ngiven: {{theta1: 90°}}\nparts: [{{id: p, ask: position of link 1}}]\n", "e", "e"
    )
    assert earned(asked, "0, 0.1, 0") == (Verdict.WRONG, 0)
    assert earned(asked, "0.3, 0.4, 0") == (Verdict.WRONG, 1 / 2)
    assert earned(asked, "0, 0.4, 0") == (Verdict.RIGHT, 1)


@pytest.mark.parametrize(("credit", "share"), [("1", 0), ("{close: 0.6}", 0.6)])
def test_a_value_that_is_close_earns_its_share(credit: str, share: float) -> None:
    """1 % off."""
    assert earned(exercise("scalar a1*cos(theta1)", credit), "0.3490") == (Verdict.CLOSE, share)


@pytest.mark.parametrize(("credit", "share"), [("1", 1), ("{rounded: 0.5}", 0.5), ("{rounded: 0}", 0)])
def test_what_is_rounded_earns_its_share(credit: str, share: float) -> None:
    """All of it unless somebody says otherwise."""
    answer = "0.87 -0.5 0 0.35; 0.5 0.87 0 0.2; 0 0 1 0; 0 0 0 1"
    assert earned(exercise("link 1", credit), answer) == (Verdict.ROUNDED, share)


@row_by_row(("credit", "share"), [("1", 0.5), ("{unit: 0}", 0), ("{unit: 0.9}", 0.9)])
@row_by_row(
    ("ask", "answer"),
    [
        ("position of link 1", "346.4, 200, 0"),
        ("pose 0..1", LINK.replace("0.3464", "346.4").replace("0.2", "200")),
        ("table standard", "400 0 0 theta1; 300 0 0 theta2"),
        ("rpy of link 1", "0, 0, 0.5236"),
        ("jacobian linear of 0..2", "-489.8 -289.8; 424.1 77.65; 0 0"),
        ("velocity of 0..2 with rates (1, 1)", "-779.6, 501.7, 0"),
        ("determinant of jacobian linear of 0..2", "84852.8"),
    ],
)
def test_an_answer_that_is_right_in_another_unit_earns_its_share(
    ask: str, answer: str, credit: str, share: float
) -> None:
    """It is not judged wrong, and says which unit it is in."""
    sheet = Judge(exercise(ask, credit)).sheet({"p": answer})
    mark = sheet.parts[0].mark
    assert (mark.verdict, sheet.earned) == (Verdict.CANNOT_READ, pytest.approx(share))
    assert mark.other_unit in ("mm", "radians")
    assert re.match(rf"right in {mark.other_unit}²?; ", mark.remarks[0])


def test_what_is_wrong_in_every_unit_earns_nothing_for_its_unit() -> None:
    """One length of three is off."""
    mark = Judge(exercise("position of link 1")).sheet({"p": "346.4, 250, 0"}).parts[0].mark
    assert (mark.verdict, mark.other_unit, mark.earned) == (Verdict.WRONG, "", 0)


# --------------------------------------------------------------------------------------------------- moves and rows


MOVES = "Rot(z, theta1) Trans(a1, 0, 0)"


@pytest.mark.parametrize(
    ("answer", "share"),
    [
        (MOVES, 1),
        ("Trans(a1, 0, 0) Rot(z, theta1)", 0.6),
        ("Rot(z, theta1)", 0.3),
        ("Rot(z, theta1) Trans(0, a1, 0)", 0.3),
        ("Rot(z, theta1) Rot(x, 90°) Trans(a1, 0, 0)", 0.3),
        ("Rot(z, theta1) Rot(z, theta1) Rot(z, theta1)", 0),
    ],
)
def test_moves_earn_each_its_part_and_the_order_the_rest(answer: str, share: float) -> None:
    """One that is too many costs what one earns, so that it does not pay to write down all there are."""
    asked = exercise("factors 1", "{moves: 0.6}", numeric=False)
    assert earned(asked, answer)[1] == pytest.approx(share)
    assert earned(exercise("factors 1", numeric=False), answer)[1] == float(answer == MOVES)


@pytest.mark.parametrize(("credit", "share"), [("1", None), ("{table: rows}", 1 / 2), ("{table: whole}", 0)])
def test_a_table_earns_by_cells_by_rows_or_as_a_whole(credit: str, share: float | None) -> None:
    """The second row has one wrong cell of its two that count."""
    verdict, got = earned(exercise("table standard", credit, numeric=False), "a1 0 0 theta1; 2*a2 0 0 theta2")
    assert verdict is Verdict.WRONG
    assert got == (3 / 4 if share is None else share)


# ------------------------------------------------------------------------------------------------------ in the file


def test_a_part_says_otherwise_than_the_exercise_key_by_key() -> None:
    """What it does not say holds as the exercise has it."""
    asked = exercise("link 1", "{points: 2, close: 1/4}", of_all="{close: 1/2, unit: 1, position: 0.3}")
    (part,) = asked.parts
    assert asked.shares == Shares(rotation=0.7, close=0.5, unit=1.0)
    assert (part.credit, part.shares) == (2, Shares(rotation=0.7, close=0.25, unit=1.0))
    assert exercise("link 1", "2").parts[0].shares is None


@pytest.mark.parametrize(
    ("credit", "words"),
    [
        ("{close: 2}", "close: a share is 0 to 1, is 2"),
        ("{unit: -0.1}", "unit: a share is 0 to 1"),
        ("{close: 50%}", "a share is a number: write 1/2 or 0.5"),
        ("{rotation: 0.5, position: 0.6}", "do not add up to 1"),
        ("{table: row}", "did you mean rows"),
        ("{cloze: 1}", "did you mean close"),
        ("{points: much}", "points"),
    ],
)
def test_shares_that_cannot_be_meant_are_refused_in_words(credit: str, words: str) -> None:
    """With the line they stand in."""
    with pytest.raises(FileError, match=words) as caught:
        exercise("link 1", credit)
    assert caught.value.problems[0].place is not None
    assert caught.value.problems[0].place.line == 11


def test_what_differs_from_the_usual_is_told_before_anybody_answers() -> None:
    """On the sheet, and by `show`; the usual shares are told by the manual."""
    plain, asked = load_exercise("planar-two-links"), exercise("link 1", of_all="{close: 1/2}")
    assert worth_of(plain) == "8 parts, 13 credits"
    assert "· 2 credits" in write_sheet(plain)
    assert "Worth: 8 parts, 13 credits" in write_sheet(plain)
    assert "# Worth: what is CLOSE earns 0.5\n" in write_sheet(asked)
    assert worth(asked, asked.parts[0]) == ""
    own = exercise("link 1", "{close: 0, table: rows}", of_all="{close: 1/2}")
    assert worth_of(own) == "what is CLOSE earns 0.5; p: what is CLOSE earns 0; p: a table earns row by row"
    assert USUAL.beside(USUAL) == ()


# -------------------------------------------------------------------------------------------------- withdrawn parts


def two_parts(withdrawn: str = "", more: str = "") -> Exercise:
    """Two links, the second of which may be withdrawn, and the product that builds on both."""
    own = f", withdrawn: {withdrawn}" if withdrawn else ""
    parts = (
        "  - {id: a, ask: link 1}\n"
        f"  - {{id: b, ask: link 2, credit: 3{own}}}\n"
        "  - {id: c, ask: pose 0..2, depends: [a, b]}\n"
    )
    return read_exercise(f"{HEAD}{more}parts:\n{parts}", "e", "e")


def answers(asked: Exercise, **others: str) -> Mapping[str, str]:
    """Right answers but for some."""
    judge = Judge(asked)
    return {part.id: judge.expected(part) for part in asked.parts} | others


@pytest.mark.parametrize("old", ["_", "1", "c2 s2 0 0; s2 c2 0 0; 0 0 1 0; 0 0 0 1", "c2 -s2 0 a2*c2; s2 c2 0 a2*s2"])
def test_a_withdrawn_part_neither_earns_nor_costs_anything(old: str) -> None:
    """Whatever a sheet that was handed out has in it, and whether it has it at all."""
    asked = two_parts("the figure was wrong")
    sheet = Judge(asked).sheet(answers(asked, b=old))
    assert (sheet.verdict, sheet.earned, sheet.credit) == (Verdict.RIGHT, 2, 2)
    assert [part.id for part in sheet.withdrawn] == ([] if old == "_" else ["b"])
    without = {name: text for name, text in answers(asked).items() if name != "b"}
    assert Judge(asked).sheet(without).earned == 2


def test_what_follows_from_an_answer_to_a_withdrawn_part_keeps_its_credit() -> None:
    """As it would if the part were still asked."""
    slip = "c2 -s2 0 a2*s2; s2 c2 0 a2*c2; 0 0 1 0; 0 0 0 1"
    x, y = "a1*c1 + a2*(c1*s2 - s1*c2)", "a1*s1 + a2*(s1*s2 + c1*c2)"
    product = f"[c12, -s12, 0, {x}; s12, c12, 0, {y}; 0, 0, 1, 0; 0, 0, 0, 1]"
    for asked in (two_parts(), two_parts("a misprint")):
        marks = {one.part.id: one.mark for one in Judge(asked).sheet(answers(asked, b=slip, c=product)).parts}
        assert (marks["c"].verdict, marks["c"].earned) == (Verdict.WRONG, 1)


def test_a_withdrawn_part_is_not_asked_any_more(tmp_path: Path) -> None:
    """New sheets do not have it, and old ones are read."""
    asked = two_parts("the figure was wrong")
    (tmp_path / "new.yaml").write_text(write_sheet(asked), "utf-8")
    assert list(read_sheet(tmp_path / "new.yaml").answers) == ["a", "c"]
    assert [part.id for part in asked.asked] == ["a", "c"]
    with pytest.raises(DhcliError, match="b was withdrawn: the figure was wrong"):
        Judge(asked).sheet({"b": "1"}, only="b")


def test_the_numbers_of_a_sheet_stay_when_a_part_is_withdrawn() -> None:
    """Which draw is fair depends on all parts, those that are not asked any more too."""
    more = NUMERIC + "variants: {theta1: 10°..80° step 10°, theta2: 10°..80° step 10°}\n"
    before, after = Judge(two_parts(more=more)), Judge(two_parts("too hard", more))
    for seed in ("1", "2", "3", "alice"):
        assert vary(before, seed).exercise.given == vary(after, seed).exercise.given


def test_an_exercise_asks_at_least_one_part() -> None:
    """All of them withdrawn is none."""
    with pytest.raises(FileError, match="all are withdrawn"):
        read_exercise(f"{HEAD}parts:\n  - {{id: a, ask: link 1, withdrawn: why not}}\n", "e", "e")


@pytest.mark.parametrize("line", ["name:", "name: ''", "name: _", "name: '  '", ""])
def test_a_name_that_nobody_filled_in_is_no_name(tmp_path: Path, line: str) -> None:
    """The sheet is read all the same."""
    (tmp_path / "s.yaml").write_text(f"format: 1\n{line}\nanswers: {{a: '1'}}\n", "utf-8")
    assert read_sheet(tmp_path / "s.yaml").name == ""


def test_lengths_in_another_unit_with_a_slip_besides_earn_no_more_for_being_seen() -> None:
    """Its entries are shown as judged in that unit; the credit is that of the unit of the sheet."""
    answer = LINK.replace("0.3464", "346.4").replace("0 0.2;", "0 -200;")
    usual = Judge(exercise("link 1")).sheet({"p": answer})
    assert "the lengths are in mm" in usual.parts[0].mark.remarks[0]
    assert Judge(exercise("link 1", "{rotation: 0.1, close: 1}")).sheet({"p": answer}).earned == usual.earned
