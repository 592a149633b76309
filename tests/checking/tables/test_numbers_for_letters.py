"""Numbers in a table of letters: judged at the robot's own lengths, whatever freedom is used is named."""

from __future__ import annotations

import math
import random
import re
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from dhcli.checking.exercise import Memo
from dhcli.checking.judge import Judge
from dhcli.checking.kinds.made import question_about_table
from dhcli.checking.pasted import UnreadableError
from dhcli.checking.tables.marking import answer_of, mark_table
from dhcli.checking.tables.typed_rows import read_table as rows_read
from dhcli.checking.verdicts import Mark, Verdict
from dhcli.errors import FileError
from dhcli.files.yaml.tables import read_table
from dhcli.kinematics.conventions import Convention, Row
from dhcli.kinematics.robot import Robot
from dhcli.notation.tree import Number, number
from dhcli.notation.walk import substitute
from tests.checking.tables.robots_with_tables import NAMES, ROOT, Rows, fk, robot, rows_of
from tests.nightly import examples

WITH_VALUES = tuple(
    name
    for name in NAMES
    if robot(name).parameters and all(isinstance(value, Number) for value in robot(name).parameters.values())
)


def lengths(name: str) -> dict[str, float]:
    """The robot's own lengths [m]."""
    return {k: float(v.value) for k, v in robot(name).parameters.items() if isinstance(v, Number)}


def file_with(tmp_path: Path, name: str, change: dict[str, str], *, pattern: str = "{}") -> Path:
    """A copy of a robot file with other lengths."""
    text = (ROOT / f"{name}.yaml").read_text("utf-8")
    for letter, value in change.items():
        text, count = re.subn(rf"\b{letter}: -?[\d.]+ (mm|m)\b", f"{letter}: {pattern.format(value)}", text, count=1)
        assert count == 1
    path = tmp_path / "mine.yaml"
    path.write_text(text, "utf-8")
    return path


def checked(arm: Robot, path: Path) -> Mark:
    """What `check ROBOT --table FILE` says."""
    table = read_table(path, arm)
    exercise = question_about_table(arm, table.convention)
    return Judge(exercise).mark(exercise.parts[0], table.text)


@pytest.mark.parametrize(
    ("name", "change", "verdict"),
    [
        ("ur5e", {"d4": "138 mm"}, Verdict.CLOSE),  # 4.7 mm off; 1.3 mm are allowed
        ("ur5e", {"d4": "134.5 mm"}, Verdict.RIGHT),
        ("ur5e", {"d4": "150 mm"}, Verdict.WRONG),
        ("ur5e", {"d6": "110 mm"}, Verdict.CLOSE),
        ("ur5e", {"d6": "120 mm"}, Verdict.WRONG),
        ("ur5e", {"a2": "-428 mm"}, Verdict.CLOSE),
        ("panda", {"d5": "387 mm"}, Verdict.CLOSE),
        ("panda", {"d5": "384.5 mm"}, Verdict.RIGHT),
        ("panda", {"a3": "100 mm"}, Verdict.WRONG),
        ("puma560", {"d3": "155 mm"}, Verdict.CLOSE),
    ],
)
def test_a_length_in_numbers_is_judged_at_the_robots_own_values(
    name: str, change: dict[str, str], verdict: Verdict, tmp_path: Path
) -> None:
    """At drawn lengths, a metre each, all of these passed."""
    mark = checked(robot(name), file_with(tmp_path, name, change))
    assert mark.verdict is verdict
    assert mark.verdict is not Verdict.RIGHT or mark.remarks == ()


def test_a_table_that_is_close_says_so_where_no_cell_can() -> None:
    """The robot has no table in this convention, so there are no cells to mark."""
    exercise = question_about_table(robot("planar-2r"), Convention.MODIFIED)
    mark = Judge(exercise).mark(exercise.parts[0], "0, 0, 0, theta1; 403 mm, 0, 0, theta2")
    assert (mark.verdict, mark.cells) == (Verdict.CLOSE, ())
    assert mark.remarks == ("right to within ten times the tolerance: look at the digits of its lengths",)
    right = Judge(exercise).mark(exercise.parts[0], "0, 0, 0, theta1; 400 mm, 0, 0, theta2")
    assert (right.verdict, right.remarks) == (Verdict.EQUIVALENT, ("your end frame is shifted along x by -0.3 m",))


def test_a_freedom_is_named_with_its_millimetres(tmp_path: Path) -> None:
    """The base may stand elsewhere, told in the unit of the sheet, and nobody is left to find out by how much."""
    mark = checked(robot("ur5e"), file_with(tmp_path, "ur5e", {"d1": "165.5 mm"}))
    assert (mark.verdict, mark.remarks) == (
        Verdict.EQUIVALENT,
        ("your frame 0 sits elsewhere along z0, by -0.003 m",),
    )
    turned = checked(robot("ur5e"), file_with(tmp_path, "ur5e", {"a2": "425 mm"}))
    assert turned.verdict is Verdict.EQUIVALENT
    assert "your theta2 has another zero (180°)" in turned.remarks


def test_a_file_that_writes_its_units_is_believed(tmp_path: Path) -> None:
    """`133.3 m` is wrong; bare, it may have been meant in millimetres."""
    own = {letter: f"{1000 * value:g}" for letter, value in lengths("ur5e").items()}
    metres = checked(robot("ur5e"), file_with(tmp_path, "ur5e", own, pattern="{} m"))
    assert metres.verdict is Verdict.WRONG
    assert not any("this sheet is in" in remark for remark in metres.remarks)
    bare = checked(robot("ur5e"), file_with(tmp_path, "ur5e", own))
    assert (bare.verdict, bare.remarks) == (Verdict.CANNOT_READ, ("right in mm; this sheet is in m",))
    right = checked(robot("ur5e"), file_with(tmp_path, "ur5e", own, pattern="{} mm"))
    assert right.verdict is Verdict.RIGHT


def test_an_answer_that_writes_its_units_is_believed() -> None:
    """In its cells, or once in its heads."""
    table = "0 0 0 θ1\n-90 0 0 θ2\n0 431.8{u} 150{u} θ3\n-90 20.3{u} 431.8{u} θ4\n90 0 0 θ5\n-90 0 0 θ6"
    exercise = question_about_table(robot("puma560"), robot("puma560").convention)

    def marked(text: str) -> Mark:
        return mark_table(answer_of(Memo(exercise), robot("puma560").convention, rows_read(text, robot("puma560"))))

    with pytest.raises(UnreadableError, match="right in mm; this sheet is in m"):
        marked(table.format(u=""))
    assert marked(table.format(u="m")).verdict is Verdict.WRONG
    assert marked(table.format(u="mm")).verdict is Verdict.RIGHT
    assert marked("alpha a [m] d [m] theta\n" + table.format(u="")).verdict is Verdict.WRONG
    assert marked("alpha a [mm] d [mm] theta\n" + table.format(u="")).verdict is Verdict.RIGHT


def test_a_file_of_products_is_no_table(tmp_path: Path) -> None:
    """Said with what would be one."""
    path = tmp_path / "mine.yaml"
    path.write_text((ROOT / "scara.yaml").read_text("utf-8"), "utf-8")
    with pytest.raises(FileError, match="has products, not a DH table"):
        read_table(path, robot("scara"))


# --- a law -----------------------------------------------------------------------------------------------------------


def in_part_numbers(name: str, letter: str, value: float) -> Rows:
    """The robot's rows with a number for one letter, rounded to a tenth of a millimetre."""
    known = {letter: number(Fraction(round(value * 10000), 10000))}
    return tuple(
        Row(substitute(row.a, known, {}), row.alpha, substitute(row.d, known, {}), row.theta) for row in rows_of(name)
    )


def largest_error(name: str, other: Rows) -> float:
    """How far the end frames are apart at 40 poses all round the circle, by numpy alone [m]."""
    arm, draw = robot(name), random.Random(4)  # noqa: S311
    worst = 0.0
    for _ in range(40):
        q = {joint: draw.uniform(-math.pi, math.pi) for joint in arm.variables}
        one, two = (fk(rows, arm.convention, {**lengths(name), **q}) for rows in (rows_of(name), other))
        worst = max(worst, float(np.linalg.norm(one[:3, 3] - two[:3, 3])))
    return worst


@examples(0.6)
@given(st.sampled_from(WITH_VALUES), st.floats(0, 0.999), st.sampled_from((0.0003, 0.002, -0.004, 0.02, -0.1, 0.5)))
def test_a_number_is_right_just_where_numpy_finds_the_end_within_the_tolerance(
    name: str, share: float, off: float
) -> None:
    """RIGHT holds at the robot's lengths; EQUIVALENT says what was used; and nothing that is right is refused."""
    from dhcli.checking.tables.cells import dh_table_text, size_of

    arm = robot(name)
    letter = sorted(lengths(name))[int(share * len(lengths(name)))]
    other = in_part_numbers(name, letter, lengths(name)[letter] + off)
    exercise = question_about_table(arm, arm.convention)
    text = dh_table_text(other, arm.columns, arm.writing)
    mark = Judge(exercise).mark(exercise.parts[0], text)
    limit, error = 1e-3 * size_of(rows_of(name), exercise), largest_error(name, other)
    if error <= limit:
        assert mark.verdict is Verdict.RIGHT, (letter, off, mark.remarks)
    elif mark.verdict is Verdict.EQUIVALENT:
        assert mark.remarks
        assert "another table of the same motion" not in mark.remarks
    elif mark.verdict is Verdict.RIGHT:
        assert error <= 1.5 * limit  # cells within a tolerance each; their errors add up
    else:
        assert mark.verdict in (Verdict.CLOSE, Verdict.WRONG)
