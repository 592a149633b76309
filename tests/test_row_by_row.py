"""A test over rows tries all of them, and names each that fails."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.row_by_row import row_by_row


@row_by_row("number", [1, 2, 3])
def test_every_row_is_tried_with_what_fixtures_give(number: int, tmp_path: Path) -> None:
    """In the order of the rows; the fixture is made once."""
    assert number == len(list(tmp_path.iterdir())) + 1
    (tmp_path / str(number)).touch()


def test_all_rows_that_fail_are_named_with_what_is_wrong() -> None:
    """Also what is skipped, and where nothing was raised that should have been; the rows behind them are tried too."""
    tried = list[str]()

    @row_by_row("number, words", [(1, "one"), (2, "two"), (3, "x" * 500), (4, "four"), (5, "five")])
    def test(number: int, words: str) -> None:
        tried.append(words[:4])
        if number == 2:
            with pytest.raises(ValueError, match="anything"):
                int("2")
        if number == 4:
            pytest.skip("not today")
        assert number != 3, "three is out"

    with pytest.raises(BaseExceptionGroup) as caught:
        test()
    assert tried == ["one", "two", "xxxx", "four", "five"]
    said = caught.value.message.split("\n")
    assert said[0] == "3 of 5 rows fail:"
    assert said[1:3] == ["  2, 'two'", "    Failed: DID NOT RAISE ValueError"]
    assert said[3].endswith("x...")
    assert said[4].startswith("    AssertionError: three is out")
    assert said[-2:] == ["  4, 'four'", "    Skipped: not today"]
    kinds = [type(error) for error in caught.value.exceptions]
    assert kinds == [pytest.fail.Exception, AssertionError, pytest.skip.Exception]


def test_a_table_inside_another_fails_row_by_row_too() -> None:
    """Whatever its rows end by, those of the outer one go on, and both are named."""
    tried = list[tuple[int, str]]()

    @row_by_row("number", [1, 2])
    @row_by_row("letter", ["a", "b"])
    def test(number: int, letter: str) -> None:
        tried.append((number, letter))
        if letter == "a":
            pytest.fail("not this one")

    with pytest.raises(BaseExceptionGroup) as caught:
        test()
    assert tried == [(1, "a"), (1, "b"), (2, "a"), (2, "b")]
    said = caught.value.message
    assert said.startswith("2 of 2 rows fail:")
    assert said.count("'a'\n    Failed: not this one") == 2


def test_a_table_of_nothing_or_of_other_rows_is_refused() -> None:
    """A test over it would say nothing."""
    for names, rows in (("number", []), ("number, words", [(1, "one"), (2,)])):
        with pytest.raises(AssertionError):
            row_by_row(names, rows)
