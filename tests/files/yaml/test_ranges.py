"""`variants:` of an exercise file: ranges and lists, exact, and every mistake with its place."""

from fractions import Fraction

import pytest

from dhcli.checking.exercise import Exercise
from dhcli.checking.written import Range
from dhcli.errors import FileError
from dhcli.files.yaml.exercises import read_exercise
from dhcli.notation.angle import Angle
from dhcli.notation.tree import Number
from tests.row_by_row import row_by_row

GIVEN = "{e: 5 mm, beta: 3°, theta1: 30°, theta2: 40°}"
HEAD = f"format: 1\ntitle: T\nsource: S\ntask: Do it\nrobot: scara\nnumeric: true\ngiven: {GIVEN}\n"
PARTS = "parts:\n  - {id: t, ask: pose 0..2}\n"


def read(variants: str) -> Exercise:
    """An exercise with these variants; they stand on line 8."""
    return read_exercise(f"{HEAD}variants: {variants}\n{PARTS}", "my.yaml", "my/own")


def values(variants: str) -> list[str]:
    """The values of the only name that varies, exactly."""
    (range_,) = read(variants).variants.values()
    assert isinstance(range_, Range)
    return [
        f"{v.degrees}° {v.radians} rad" if isinstance(v, Angle) else str(v.value)
        for v in range_.values
        if isinstance(v, Angle | Number)
    ]


@row_by_row(
    ("variants", "first", "last", "count"),
    [
        ("{theta1: 20°..70° step 5°}", "20° 0 rad", "70° 0 rad", 11),
        ("{theta1: -70deg .. -20 degrees step 5°}", "-70° 0 rad", "-20° 0 rad", 11),
        ("{theta1: 0..60° step 20°}", "0° 0 rad", "60° 0 rad", 4),
        ("{theta2: 0.1 rad..0.4 rad step 0.1 rad}", "0° 1/10 rad", "0° 2/5 rad", 4),
        ("{theta2: π/6..π/3 step π/12}", "30° 0 rad", "60° 0 rad", 3),
        ("{d3: 80 mm..180 mm step 10 mm}", "2/25", "9/50", 11),
        ("{d3: 0.1..0.3 step 0.1}", "1/10", "3/10", 3),
        ("{l1: 1 m..1 m step 1 m}", "1", "1", 1),
        ("{theta1: 20°..70° n 3}", "20° 0 rad", "70° 0 rad", 3),
        ("{theta1: 70°..20° n 11}", "70° 0 rad", "20° 0 rad", 11),
        ("{d3: 0..0.1 n 4}", "0", "1/10", 4),
        ("{e: [5 mm, 0.7 cm]}", "1/200", "7/1000", 2),
        ("{beta: [10°, 20°, 0.1 rad]}", "10° 0 rad", "0° 1/10 rad", 3),
    ],
)
def test_a_range_is_exact(variants: str, first: str, last: str, count: int) -> None:
    """From the first to the last value, both included; no float is met."""
    found = values(variants)
    assert (found[0], found[-1], len(found)) == (first, last, count)


def test_a_length_is_shown_with_its_decimals() -> None:
    """0.12 m and not 3/25 m."""
    (range_,) = read("{d3: 80 mm..120 mm step 20 mm}").variants.values()
    assert [str(value) for value in range_.values] == ["0.08", "0.1", "0.12"]
    assert Number(Fraction(3, 25)) in range_.values


@row_by_row(
    ("variants", "column", "message"),
    [
        ("{theta9: 20°..70° step 5°}", 12, "theta9 is neither a joint nor a parameter of the robot, nor given"),
        ("{theta1: 20..70 step 5}", 20, "the angle 20 has no unit"),
        ("{theta1: 20°..70° step 5}", 34, "the angle 5 has no unit"),
        ("{theta1: 20°..70° step 0}", 34, "the step is 0"),
        ("{theta1: 20°..70° step -5°}", 34, "the step is -5°"),
        ("{theta1: 20°..70° step 7°}", 34, "steps of 7° from 20° do not meet 70° (end at 69° or at 76°)"),
        ("{theta1: 70°..20° step 5°}", 20, "70° is above 20° (write 20°..70°)"),
        ("{theta1: 20°..1 rad step 5°}", 20, "the range mixes units: rad, °"),
        ("{theta1: 0.1 rad..π/4 step 0.1 rad}", 20, "the range mixes units: rad, π"),
        ("{d3: 100 mm..0.2 m step 10 mm}", 16, "the range mixes units: m, mm"),
        ("{d3: 0.1..0.2 m step 0.1}", 16, "the range mixes units: m, no unit"),
        ("{d3: 20°..70° step 5°}", 16, "deg is a unit of angle, a length is wanted"),
        ("{d3: 1 mm..2 m step 1 mm}", 16, "the range mixes units"),
        ("{d3: 0..20000 step 1}", 30, "these are 20,001 values"),
        ("{d3: 0..sqrt(2) step 0.1}", 16, "a range goes from a number to a number"),
        (
            "{theta1: 20°..70° n 1}",
            31,
            "n 1 is one value, and a range has two ends (write n 2 or more; or one value, [20°])",
        ),
        ("{theta1: 20°..70° n five}", 31, "'five' is not a number of values (write n 11)"),
        ("{theta1: 20°..70° n 20001}", 31, "these are 20,001 values"),
        ("{theta1: 20°..70° n}", 20, "'20°..70° n' is no range"),
        ("{theta1: 20° to 70°}", 20, "'20° to 70°' is no range (write 20°..70° step 5°, or a list of values)"),
        ("{theta1: 10..60}", 20, "'10..60' is no range (write 10°..60° step 5°, or a list of values)"),
        ("{theta1: 20°..70°}", 20, "'20°..70°' is no range"),
        ("{theta1: []}", 20, "the list is empty"),
        ("{theta1: [20°, 20°]}", 26, "20° stands twice"),
        ("{theta1: {from: 20°}}", 20, "should be a text"),
        ("[theta1]", 11, "variants: should be a mapping"),
    ],
)
def test_a_bad_range_is_told_with_its_place(variants: str, column: int, message: str) -> None:
    """Line 8, and the column of what is wrong."""
    with pytest.raises(FileError) as caught:
        read(variants)
    told = [str(problem) for problem in caught.value.problems]
    assert any(message in text for text in told), told
    assert {(p.place.line, p.place.column) for p in caught.value.problems if p.place} >= {(8, column)}, told


def test_all_bad_ranges_are_told_at_once() -> None:
    """One error with three problems."""
    with pytest.raises(FileError) as caught:
        read("{theta1: 20..70 step 5°, x: 1..2 step 1, d3: 2..1 step 1}")
    assert len(caught.value.problems) == 4


def test_each_name_that_may_vary_is_told_once() -> None:
    """One that is given is one of the robot's, too."""
    with pytest.raises(FileError) as caught:
        read("{q: [1 m]}")
    (hint,) = (problem.hint for problem in caught.value.problems)
    known = hint.removeprefix("known: ").split(", ")
    assert len(set(known)) == len(known) > 3
