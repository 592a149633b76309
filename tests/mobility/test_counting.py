"""The formula in both forms, over patterns, counts and formulas."""

from __future__ import annotations

import pytest

from dhcli.errors import DhcliError
from dhcli.mobility.counting import Counts, counts
from dhcli.mobility.finding import mobility_of
from dhcli.mobility.linkage import Linkage
from dhcli.mobility.pairs import PAIRS, PLANAR, SPATIAL, SPHERICAL, Space, pair_of, space_of
from dhcli.mobility.patterns import count_of, joint_counts, other_reading, read_pattern
from dhcli.mobility.slips import count, slips
from tests.row_by_row import row_by_row


def counted(text: str, space: Space = SPATIAL) -> Counts:
    """The counts of a pattern."""
    found = read_pattern(text, space)
    return Counts.of(found) if isinstance(found, Linkage) else found


@row_by_row(
    ("pattern", "n", "j", "f"),
    [
        ("6R", "7", "6", "6"),
        ("RRPRRR", "7", "6", "6"),
        ("2RP", "4", "3", "3"),
        ("U", "2", "1", "2"),
        ("loop 6R", "6", "6", "0"),
        ("loop 4R", "4", "4", "-2"),
        ("6-UPS", "14", "18", "6"),
        ("6-SPS", "14", "18", "12"),
        ("3-RPS", "8", "9", "3"),
        ("2-PRU+1-PRS", "8", "9", "1"),
        ("n-RPS", "2 + 2*n", "3*n", "6 - n"),
        ("(n + 1)-UPS", "4 + 2*n", "3 + 3*n", "6"),
    ],
)
def test_a_pattern_is_counted(pattern: str, n: str, j: str, f: str) -> None:
    """Links with the ground, joints, and F in both forms."""
    found = counted(pattern)
    assert (str(found.n), str(found.j), str(found.by_freedoms), str(found.by_constraints)) == (n, j, f, f)


@row_by_row(
    ("space", "n", "joints", "f"),
    [
        (PLANAR, "4", "4R", 1),
        (PLANAR, "4", "3R 1P", 1),
        (PLANAR, "5", "5R", 2),
        (PLANAR, "6", "7R", 1),
        (PLANAR, "3", "2R, 1 gear", 1),
        (PLANAR, "4", "2R 1P 1 cam", 2),
        (SPHERICAL, "4", "4R", 1),
        (SPATIAL, "4", "4R", -2),
        (SPATIAL, "7", "6R", 6),
        (Space(4), "4", "4R", 0),
        (Space(1), "3", "2P", 2),
    ],
)
def test_bare_counts_are_counted(space: Space, n: str, joints: str, f: int) -> None:
    """As a student fills the formula in."""
    assert counts(space, count_of(n), joint_counts(joints)).gruebler == f


def test_numbers_stand_in_both_formulas() -> None:
    """So that one sees what was counted."""
    assert counted("RRP").formulas == (
        "F = λ(n - j - 1) + Σf = 6(4 - 3 - 1) + (2·1 + 1·1) = 3",
        "F = λ(n - 1) - ΣC = 6(4 - 1) - (2·5 + 1·5) = 3",
    )


def test_a_fraction_of_n_stands_in_brackets_before_its_freedoms() -> None:
    """`n/7·5` could be read as n through 35; what is typed as a decimal stays one."""
    assert (
        counts(SPATIAL, count_of("n"), joint_counts("n/7 R")).formulas[1].endswith("6(n - 1) - (n/7)·5 = -6 + 37*n/7")
    )
    assert "+ 0.4*n·1 = -6" in counts(SPATIAL, count_of("n"), joint_counts("n/2.5 R")).formulas[0]


def test_a_formula_in_n_is_that_of_the_scissor() -> None:
    """2n bars and 3n - 2 pins have one freedom, however many."""
    found = counts(PLANAR, count_of("2*n"), joint_counts("(3*n - 2)R"))
    assert str(found.by_freedoms) == "1"


def test_freedoms_and_constraints_add_up_for_every_joint() -> None:
    """C = λ - f wherever the joint exists."""
    for space in (PLANAR, SPATIAL):
        for name in space.known():
            assert space.freedoms(pair_of(name)) + space.constraints(pair_of(name)) == space.lambda_
    assert [SPATIAL.freedoms(pair_of(letter)) for letter in "WRPHCUSE"] == [0, 1, 1, 1, 2, 2, 3, 3]
    assert len({pair.name for pair in PAIRS}) == len(PAIRS)


def test_the_other_reading_is_offered() -> None:
    """An open chain as a loop, a loop as an open chain; legs have one reading."""
    assert [
        other.gruebler if (other := other_reading(read_pattern(p))) else None for p in ("6R", "loop 6R", "6-UPS", "R")
    ] == [
        0,
        6,
        None,
        None,
    ]


def test_an_answer_says_what_it_could_settle() -> None:
    """Counts give the formula only; an open chain is certain."""
    assert mobility_of(read_pattern("loop 6R")).mobility is None
    assert mobility_of(read_pattern("6R")).certificate.startswith("exact")
    assert mobility_of(counted("n-RPS")).gruebler is None


@row_by_row("text", ["", "6", "6X", "-3R", "0-UPS", "loop R", "loop", "99999999R", "a-b", "6-", "RR RX"])
def test_what_is_no_pattern_is_refused_with_its_place(text: str) -> None:
    """And with what would be right."""
    with pytest.raises(DhcliError) as caught:
        read_pattern(text)
    assert caught.value.problems[0].place is not None


@pytest.mark.parametrize("text", ["0", "7", "-1", "flat", "", "3.5"])
def test_a_space_that_does_not_exist_is_refused(text: str) -> None:
    """λ is 1 to 6."""
    with pytest.raises(DhcliError):
        space_of(text)


@row_by_row(
    ("n", "joints"),
    [("-4", "4R"), ("4", "-4R"), ("4.5", "4R"), ("4", "R4"), ("4", ""), ("0", "1R"), ("9", "4R"), ("sqrt(2)", "4R")],
)
def test_counts_that_make_no_sense_are_refused(n: str, joints: str) -> None:
    """Negative, broken, or too few to hold together."""
    with pytest.raises(DhcliError):
        counts(SPATIAL, count_of(n), joint_counts(joints))


def test_count_answers_what_an_exercise_asks() -> None:
    """All of its quantities."""
    asked = {what: count(what, "6R") for what in ("mobility", "gruebler", "links", "joints", "constraints", "freedoms")}
    assert asked == {"mobility": 6, "gruebler": 6, "links": 7, "joints": 6, "constraints": 30, "freedoms": 6}
    with pytest.raises(DhcliError):
        count("mobility", "loop 6R")
    with pytest.raises(DhcliError):
        count("length", "6R")


def test_slips_have_names_and_are_never_right() -> None:
    """The ground forgotten, joints as links, the wrong space, C for f."""
    found = slips("gruebler", "6R")
    assert found["the ground is not counted"] == 0
    assert found["constraints C taken for freedoms f"] == 30
    assert slips("links", "6R")["joints counted as links"] == 6
    assert slips("constraints", "6R")["freedoms f taken for constraints C"] == 6
    assert "a pin of several links counted once" not in found
    for what in ("gruebler", "links", "joints", "constraints", "freedoms"):
        assert count(what, "RRP") not in slips(what, "RRP").values()
