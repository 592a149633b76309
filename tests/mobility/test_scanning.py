"""Lists of joints and patterns: read from left to right, whatever stands there."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from dhcli.errors import DhcliError
from dhcli.mobility.pairs import LETTERS, WORDS, pair_of
from dhcli.mobility.patterns import MOST_JOINTS, joint_counts, looks_like_pattern, read_pattern
from dhcli.mobility.scanning import LONGEST
from tests.nightly import examples
from tests.row_by_row import row_by_row

law = examples(2)


def read(text: str) -> list[tuple[str, str]]:
    """Counts and kinds, as text."""
    return [(str(count), pair.name) for pair, count in joint_counts(text)]


@row_by_row(
    ("text", "expected"),
    [
        ("4 pin 1 slot", [("4", "revolute"), ("1", "slot")]),
        ("4 pins and 1 slot", [("4", "revolute"), ("1", "slot")]),
        ("3 pin joints, 1 slider", [("3", "revolute"), ("1", "prismatic")]),
        ("2 balls in a tube, 1 line contact", [("2", "ball-in-tube"), ("1", "line-contact")]),
        ("1 ball", [("1", "spherical")]),
        ("1 pin in a slot 2 R", [("1", "slot"), ("2", "revolute")]),
        ("2R 1P 1 cam", [("2", "revolute"), ("1", "prismatic"), ("1", "cam")]),
        ("3R1P", [("3", "revolute"), ("1", "prismatic")]),
        ("RRP", [("1", "revolute"), ("1", "revolute"), ("1", "prismatic")]),
        ("3*n R + n P", [("3*n", "revolute"), ("n", "prismatic")]),
        ("n + 1 R", [("n + 1", "revolute")]),
        ("(3*n - 2)R", [("3*n - 2", "revolute")]),
        ("2·R", [("2", "revolute")]),
    ],
)
def test_counts_and_words(text: str, expected: list[tuple[str, str]]) -> None:
    """Letters, words, plurals, phrases, formulas."""
    assert read(text) == expected


@row_by_row(
    ("text", "message"),
    [
        ("4infR", "'4infR' is not a number of joints"),
        ("4 inf R", "'inf' is no count"),
        ("nan R", "'nan' is no count"),
        ("0x10 R", "'0x10' is no count"),
        ("4 pinns", "did you mean pin"),
        ("4 R 3", "'3' is not a number of joints"),
        ("R4", "'4' is not a number of joints"),
        ("4 )R", "is not a number of joints"),
        ("()" * 28, "is not a number of joints"),
        ("(" * 1000, "is not a number of joints"),
        ("", "no joints are given"),
        (" " * (LONGEST + 1), "more than 2,000 characters"),
        ("(" * LONGEST + "R", "more than 2,000 characters"),
    ],
)
def test_what_is_no_list_is_refused_in_words(text: str, message: str) -> None:
    """Never read as a product of names."""
    with pytest.raises(DhcliError) as caught:
        joint_counts(text)
    assert message in str(caught.value)


@law
@given(st.lists(st.tuples(st.integers(1, 99), st.sampled_from(sorted({*WORDS, *LETTERS}))), min_size=1, max_size=6))
def test_a_list_that_is_written_is_read_back(pieces: list[tuple[int, str]]) -> None:
    """With every word that there is."""
    expected = [(str(count), pair_of(word).name) for count, word in pieces]
    assert read(", ".join(f"{count} {word}" for count, word in pieces)) == expected
    assert (
        read(" ".join(f"{count}{word}" if word in LETTERS else f"{count} {word}s" for count, word in pieces))
        == expected
    )


@law
@given(st.text("RPSn42 ()+-*,.!loopinfxé…", max_size=40))
def test_any_text_is_read_or_refused(text: str) -> None:
    """In the list and in the pattern; a text that looks like a pattern is read as one, or told why not."""
    for reader in (joint_counts, read_pattern):
        try:
            assert reader(text)
        except DhcliError as error:
            assert all(problem.message for problem in error.problems)


@pytest.mark.parametrize(
    "text",
    ["R  " * 20 + "!", "R  " * 20_000 + "!", " " * 200_000 + "!", "a-" * 50_000, "(" * 50_000 + "-R", "loop " * 20_000],
)
def test_a_long_text_that_is_no_pattern_is_told_at_once(text: str) -> None:
    """Each character is looked at a few times; these took for ever."""
    if not text.startswith("loop"):
        assert not looks_like_pattern(text)
    with pytest.raises(DhcliError) as caught:
        read_pattern(text)
    assert len(str(caught.value.problems[0].message)) < 300


@pytest.mark.parametrize(
    ("text", "joints", "links"),
    [("20000-R", 20_000, 2), ("10000-RR", 20_000, 10_002), ("open 3R", 3, 4), ("6–UPS", 18, 14)],
)
def test_patterns_of_any_length_are_read(text: str, joints: int, links: int) -> None:
    """Up to the number of joints that is read at all."""
    found = read_pattern(text)
    assert len(found.joints) == joints  # type: ignore[union-attr]
    assert len(found.links) == links  # type: ignore[union-attr]


def test_more_joints_than_that_are_refused() -> None:
    """Over all legs together."""
    for text in (f"{MOST_JOINTS + 1}-R", f"{MOST_JOINTS}-R+1-R", "R" * (MOST_JOINTS + 1)):
        with pytest.raises(DhcliError):
            read_pattern(text)
