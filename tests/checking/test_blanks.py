"""Blanks that multiply in one place and separate in another."""

from __future__ import annotations

import pytest

from dhcli.checking.judge import check
from dhcli.checking.verdicts import Verdict
from dhcli.files.yaml.exercises import load_exercise

ARM = load_exercise("yim/planar-two-links")
JACOBIAN = load_exercise("motion/planar-jacobian")


@pytest.mark.parametrize(
    ("answer", "read"),
    [
        ("a1 c1 + a2 c12", "a1*c1 + a2*c12"),
        ("[a1 c1 + a2 c12]", "a1*c1 + a2*c12"),
        ("p_x = a1 c1 + a2 c12", "a1*c1 + a2*c12"),
        ("a1 c1 +a2 c12", "a1*c1 + a2*c12"),
        ("a1 cos θ1 + a2 cos(θ1+θ2)", "a1*c1 + a2*c12"),
        ("- a1 s1 - a2 s12", "-a1*s1 - a2*s12"),
    ],
)
def test_one_expression_is_no_point(answer: str, read: str) -> None:
    """Between its blanks stand as many cells as coordinates by chance; a length and a cosine are not added there."""
    mark = check(ARM, "d02", answer)
    assert mark.verdict is Verdict.CANNOT_READ
    assert mark.remarks == (f"this is one expression, {read}, and 3 were asked: write commas between them",)


@pytest.mark.parametrize(
    ("part", "answer", "verdict"),
    [
        ("d02", "a1c1 + a2c12 a1s1 + a2s12 0", Verdict.RIGHT),
        ("d02", "a1 c1 + a2 c12, a1 s1 + a2 s12, 0", Verdict.RIGHT),
        ("d02", "a1 c1 + a2 c12; a1 s1 + a2 s12; 0", Verdict.RIGHT),
        ("d02", "a1 + a2 0 0", Verdict.WRONG),
        ("d02", "c1 + a2 0 0", Verdict.WRONG),
        ("d02", "a1 + a2 a1 a2", Verdict.WRONG),
        ("x2", "c1c2 - s1s2 s1c2 + c1s2 0", Verdict.RIGHT),
        ("x2", "c1c2 - s1s2 s1 c12", Verdict.WRONG),
        ("x2", "c1 -s1 0", Verdict.WRONG),
        ("x2", "c1 -s1 c12", Verdict.WRONG),
        ("x2", "c1 c2 - s1 s2", Verdict.CANNOT_READ),
    ],
)
def test_cells_between_blanks_stay_cells(part: str, answer: str, verdict: Verdict) -> None:
    """Where only they are of one kind, where a product is written without a blank, where a number follows one."""
    assert check(ARM, part, answer).verdict is verdict


def test_a_column_of_a_jacobian_is_asked_about_as_well() -> None:
    """Its entries are lists of the same kind."""
    mark = check(JACOBIAN, "column1", "-a1 s1 - a2 s12")
    assert mark.remarks == ("this is one expression, -a1*s1 - a2*s12, and 3 were asked: write commas between them",)
    assert check(JACOBIAN, "column1", "-a1s1 - a2s12 a1c1 + a2c12 0").verdict is Verdict.RIGHT
