"""The unit of a sheet, for every kind of question, every unit, in numbers and in symbols."""

from __future__ import annotations

import pytest

from dhcli.checking.kinds.registry import KINDS
from dhcli.checking.verdicts import Verdict
from dhcli.notation.quantity import LENGTH_UNITS
from tests.checking.mutated_kinds import cells_of, exercise_of, written
from tests.judging import answer_with, expected, mark, shortest, slips
from tests.nightly import NIGHT, paired
from tests.row_by_row import row_by_row

UNITS = ("m", "cm", "mm", "in", "none")

GIVEN = {"theta1": "35°", "theta2": "-110°", "a1": "0.4 m", "a2": "0.3 m"}

LENGTHS: dict[str, str] = {
    # how each kind asks for a length: the right answer in metres, at the values given
    "link": "link 1",
    "pose": "pose 0..2",
    "inverse": "inverse of link 1",
    "position": "position of pose 0..2",
    "entry": "entry 1 4 of pose 0..2",
    "point": "point (5, -3, 2) of link 1",
    "point with a unit": "point (5 mm, -3 mm, 0) of link 1",
    "product": 'product "Trans(8, -6, 14) Rot(y, 90°)"',
    "product with a unit": 'product "Trans(8 mm, -6 mm, 0) Rot(y, 90°)"',
    "vector of lengths": "vector (a1, 0, a2) of link 1",
    "scalar": "scalar 2*a1 + 3",
    "cell": "cell a 1",
    "factors": "factors 1",
}

PLAIN: dict[str, str] = {
    # what has no unit
    "rotation": "rotation of pose 0..2",
    "axis": "axis x of pose 0..2",
    "vector": "vector (0.6, 0, 0.8) of pose 0..2",
    "entry of the rotation": "entry 1 1 of pose 0..2",
    "scalar of an angle": "scalar theta1 + theta2",
    "scalar of a number": "scalar a1/a2 + cos(theta1)",
    "cell of an angle": "cell alpha 1",
    "rpy": "rpy of pose 0..2",
}


ASKED = (*LENGTHS.values(), *PLAIN.values())


@row_by_row(
    ("asked", "unit"),
    paired([*((ask, True) for ask in ASKED), *((ask, False) for ask in ASKED if not ask.startswith("rpy"))], UNITS),
)
def test_the_right_answer_is_right_as_it_is_shown(asked: tuple[str, bool], unit: str) -> None:
    """The expected answer and the shortest one, typed on the sheet; rpy is asked for in numbers only."""
    ask, numeric = asked
    exercise, part = exercise_of(ask, given=GIVEN, unit=unit, numeric=numeric)
    for text in (expected(exercise, part), shortest(exercise, part)):
        assert mark(exercise, part, text).verdict is Verdict.RIGHT, text


@row_by_row("unit", [unit for unit in UNITS if unit != "none"])
@row_by_row("ask", [ask for name, ask in LENGTHS.items() if "link" in name or name in ("scalar", "cell")])
def test_numbers_are_those_of_metres_divided_by_the_unit(ask: str, unit: str) -> None:
    """The same question on a sheet in metres and in another unit, its own bare numbers a unit's worth each."""
    metres = float(LENGTH_UNITS[unit])
    exercise, part = exercise_of(ask, given=GIVEN, unit=unit, numeric=True)
    values = {"link 1": 0.4, "scalar 2*a1 + 3": 0.8 + 3 * metres, "cell a 1": 0.4}
    right = values[ask] / metres
    if ask == "link 1":
        rows = cells_of(expected(exercise, part))
        along = float(rows[0][3]) ** 2 + float(rows[1][3]) ** 2
        assert along**0.5 == pytest.approx(right, rel=1e-6)
        return
    assert mark(exercise, part, f"{right:.9f}").verdict is Verdict.RIGHT
    assert mark(exercise, part, f"{right * metres:.9f} m").verdict is Verdict.RIGHT
    if unit != "m":
        assert mark(exercise, part, f"{right * metres:.9f}").verdict is not Verdict.RIGHT


@pytest.mark.parametrize("unit", ["mm", "cm"])
@pytest.mark.parametrize("ask", ["position of link 1", "point (5, 0, 0) of link 1", "entry 1 4 of link 1"])
def test_a_text_that_writes_its_unit_is_believed(ask: str, unit: str) -> None:
    """Every length in metres, on a sheet that is not."""
    exercise, part = exercise_of(ask, given=GIVEN, unit=unit, numeric=True)
    metres = float(LENGTH_UNITS[unit])
    rows = [[f"{float(cell) * metres:.9f} m" for cell in row] for row in cells_of(expected(exercise, part))]
    assert mark(exercise, part, written(rows)).verdict is Verdict.RIGHT


@pytest.mark.parametrize(
    "around",
    [
        "[{}] m",
        "({})m",
        "[{}]^T m",
        "\\begin{{pmatrix}} {} \\end{{pmatrix}} m",
        "p = \\begin{{pmatrix}} {} \\end{{pmatrix}}\\,\\mathrm{{m}}",
    ],
)
def test_a_unit_behind_a_vector_is_that_of_every_coordinate(around: str) -> None:
    """Of all coordinates; behind a last one without a bracket it is that of this one alone."""
    exercise, part = exercise_of("position of link 1", given=GIVEN, unit="mm", numeric=True)
    cells = [f"{float(cell) / 1000:.9f}" for row in cells_of(expected(exercise, part)) for cell in row]
    separator = " \\\\ " if "begin" in around else ", "
    assert mark(exercise, part, around.format(separator.join(cells))).verdict is Verdict.RIGHT
    assert mark(exercise, part, f"{', '.join(cells)} m").verdict is not Verdict.RIGHT


@pytest.mark.parametrize("ask", [PLAIN["vector"], PLAIN["axis"], PLAIN["rotation"]])
def test_directions_have_no_unit(ask: str) -> None:
    """The same numbers on every sheet; with a unit they are refused, and in thousandths wrong."""
    texts = {expected(*exercise_of(ask, given=GIVEN, unit=unit, numeric=True)) for unit in UNITS}
    assert len(texts) == 1
    exercise, part = exercise_of(ask, given=GIVEN, unit="mm", numeric=True)
    rows = cells_of(texts.pop())
    in_mm = written([[f"{cell} mm" for cell in row] for row in rows])
    assert mark(exercise, part, in_mm).verdict is Verdict.CANNOT_READ
    thousandths = written([[f"{float(cell) * 1000}" for cell in row] for row in rows])
    assert mark(exercise, part, thousandths).verdict is Verdict.WRONG


@pytest.mark.parametrize(
    ("answer", "verdict"),
    [
        ("[a1*c1 + 5*c1 + 3*s1, a1*s1 + 5*s1 - 3*c1, 2]", Verdict.RIGHT),
        ("[(a1 + 5)*c1 + 3*s1, (a1 + 5)*s1 - 3*c1, 2]", Verdict.RIGHT),
        ("[sqrt((a1 + 5)^2)*c1 + 3*s1, (a1 + 5)*s1 - 3*c1, 2 mm]", Verdict.RIGHT),
        ("[a1*c1 + 0.005*c1 + 0.003*s1, a1*s1 + 0.005*s1 - 0.003*c1, 0.002]", Verdict.WRONG),
        ("[1000*a1*c1 + 5*c1 + 3*s1, 1000*a1*s1 + 5*s1 - 3*c1, 2]", Verdict.WRONG),
    ],
)
def test_numbers_beside_letters_are_in_the_unit_of_the_sheet(answer: str, verdict: Verdict) -> None:
    """A letter is a length as it stands, the numbers beside it are millimetres."""
    exercise, part = exercise_of(LENGTHS["point"], unit="mm")
    assert mark(exercise, part, answer).verdict is verdict


@pytest.mark.parametrize("ask", list(LENGTHS.values()))
def test_slips_are_written_in_the_unit_of_the_sheet(ask: str) -> None:
    """The answer of a student with a slip is never right, and is no thousand times too long."""
    for numeric in (True, False):
        exercise, part = exercise_of(ask, given=GIVEN, unit="mm", numeric=numeric)
        for slip in slips(exercise, part)[: 20 if NIGHT else 2]:
            judged = mark(exercise, part, answer_with(exercise, part, slip.name))
            assert judged.verdict is not Verdict.RIGHT, slip.name


def test_every_kind_that_has_lengths_is_walked() -> None:
    """A new kind stands in one of the lists, or is neither a measure nor a formula."""
    walked = {ask.split()[0] for ask in (*LENGTHS.values(), *PLAIN.values())}
    # tables and joint values have tests of their own; the others are no measures
    elsewhere = {"table", "count", "choice", "joints", "angle", "count solutions", "reach"}
    for kind in KINDS:
        assert walked & set(kind.words) or elsewhere & set(kind.words), kind
