"""The figures of a class, counted by hand."""

from __future__ import annotations

import pytest

from dhcli.checking.verdicts import Verdict
from dhcli.classroom.folder import Folder
from dhcli.classroom.grades import Graded, PartGrade
from dhcli.classroom.report import report_on
from dhcli.errors import Problem

FOLDER = Folder("class", (), ("empty",))
R, W, S = Verdict.RIGHT, Verdict.WRONG, Verdict.SKIPPED


def row(name: str, *parts: PartGrade, exercise: str = "course/one") -> Graded:
    """A sheet with its grades."""
    return Graded(f"{name}.yaml", name, exercise, "", parts)


CLASS = (
    row("1", PartGrade("a", R, 2, 2), PartGrade("b", R, 3, 3)),
    row("2", PartGrade("a", W, 1, 2, slips=("sign", "sign", "order")), PartGrade("b", W, 0, 3, slips=("unit",))),
    row("3", PartGrade("a", W, 0, 2, slips=("sign",)), PartGrade("b", S, 0, 3)),
    row("4", PartGrade("a", R, 2, 2), PartGrade("b", W, 2, 3, slips=("order",))),
    Graded("5.yaml", "5", problems=(Problem("is empty"),)),
    row("6", PartGrade("a", R, 1, 1), exercise="another/one"),
)


def test_the_figures_of_a_small_class_are_those_counted_by_hand() -> None:
    """Each exercise has parts of its own; a slip counts once a sheet, the commonest first, then as sheets name them."""
    report = report_on(FOLDER, CLASS)
    other, a, b = report.parts
    assert (other.exercise, other.part, other.verdicts, other.mean) == ("another/one", "a", {R: 1}, 1)
    assert (a.exercise, a.part, a.credit) == ("course/one", "a", 2)
    assert (a.verdicts, a.mean) == ({R: 2, W: 2}, pytest.approx(5 / 4))
    assert a.slips == (("sign", 2), ("order", 1))
    assert (b.verdicts, b.mean) == ({R: 1, W: 2, S: 1}, pytest.approx(5 / 4))
    assert b.slips == (("unit", 1), ("order", 1))
    assert (len(report.graded), [one.student for one in report.failed]) == (5, ["5"])


def test_the_credit_is_spread_over_six_classes() -> None:
    """Shares 1, 0.2, 0, 0.8 and 1; each class holds its lower border, and full credit stands alone."""
    report = report_on(FOLDER, CLASS)
    assert report.spread == (1, 1, 0, 0, 1, 2)
    assert report.mean == pytest.approx(3 / 5)


@pytest.mark.parametrize("shares", [(0.1, 0.2, 0.3), (0.7, 0.2, 0.1)])
def test_rounding_costs_nobody_the_full_credit(shares: tuple[float, ...]) -> None:
    """0.1 + 0.2 + 0.3 is not 0.6 in floats."""
    report = report_on(FOLDER, [row("1", *(PartGrade(str(s), R, s * 3 / 3, s) for s in shares))])
    assert report.spread == (0, 0, 0, 0, 0, 1)


def test_a_class_without_grades_has_no_mean() -> None:
    """Nothing is divided by nothing."""
    report = report_on(FOLDER, [CLASS[4], row("7", PartGrade("a", R, 0, 0))])
    assert (report.mean, sum(report.spread)) == (None, 0)


def test_a_sheet_that_is_right_but_for_a_unit_is_worth_a_look() -> None:
    """One that is also wrong is not; a part left blank, or right in any unit, does not matter."""
    other = PartGrade("a", Verdict.CANNOT_READ, 1, 2, other_unit="mm")
    rows = (
        row("1", other, PartGrade("b", R, 3, 3)),
        row("2", other, PartGrade("b", S, 0, 3), PartGrade("c", Verdict.ROUNDED, 1, 1)),
        row("3", other, PartGrade("b", W, 0, 3)),
        row("4", PartGrade("a", R, 2, 2), PartGrade("b", R, 3, 3)),
    )
    assert report_on(FOLDER, rows).notices == ("course/one: right but for the unit, mm: 2 sheets (1, 2)",)
