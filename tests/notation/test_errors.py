"""Texts that are not read: the column, what is wrong there, and what would be read."""

from __future__ import annotations

import pytest

from dhcli.errors import NotationError, Place
from dhcli.notation.names import describe, foreign_letter
from dhcli.notation.parser import parse
from dhcli.notation.scope import Scope
from tests.row_by_row import row_by_row

ROBOT = Scope(joints=("theta1", "theta2"), lengths=("a1", "a2", "d3"))


def refused(text: str, scope: Scope = ROBOT, place: Place | None = None) -> str:
    """The error of a text, without the word `expression`."""
    with pytest.raises(NotationError) as caught:
        parse(text, scope, place)
    return str(caught.value).removeprefix("expression:")


@row_by_row(
    ("text", "message"),
    [
        ("", "1: the end where a number, a name or a bracket was expected"),
        ("a1 +", "5: the end where a number, a name or a bracket was expected"),
        ("a1 + * a2", "6: '*' where a number, a name or a bracket was expected"),
        ("a1*(a2 + d3", "12: the end where ) was expected to close ("),
        ("(a1]", "4: ']' where ) was expected to close ("),
        ("a1)", "3: ')' is left over here (is a bracket or an operator missing?)"),
        ("a1, a2", "3: ',' is left over here (is a bracket or an operator missing?)"),
        ("a1 = 2", "4: '=' is left over here (write one side of the equation alone)"),
        ("a1 ? 2", "4: ? (Question Mark) means nothing here"),
        ("a1 + \x07", "6: (U+0007) means nothing here"),
        ("2 3", "3: two numbers side by side (write * between them, or a comma if they are two values)"),
        ("1.2.3", "4: two numbers side by side (write * between them, or a comma if they are two values)"),
        ("a3", "1: a3 is not a name that is known here (did you mean d3 or a2 or a1?)"),
        ("a12 + d3^2", "1: a12 is not a name that is known here (the square is written a1^2)"),
        ("theta22", "1: theta22 is not a name that is known here (did you mean theta2 or theta1?)"),
        ("a1 + theta9", "6: theta9 is not a name that is known here (did you mean theta2 or theta1?)"),
        ("zzz", "1: zzz is not a name that is known here (known: theta1, theta2, a1, a2, d3)"),
        ("cos", "4: the end where the argument of cos was expected (write cos(theta1))"),
        ("cos + 1", "5: '+' where the argument of cos was expected (write cos(theta1))"),
        ("cos(theta1, theta2)", "1: cos takes 1 argument, not 2"),
        ("atan2(a1)", "1: atan2 takes 2 arguments, not 1"),
        ("cos(5 mm)", "1: mm is a unit of length, an angle is wanted (write 30° or 0.5 rad)"),
        ("asin(30°)", "1: asin takes numbers, and a unit of angle stands in it"),
        ("1/0", "2: a division by zero"),
        ("a1/(d3 - d3)", "3: a division by zero"),
        ("0^-1", "2: a division by zero"),
        ("tan(90°)", "1: a division by zero"),
        ("a1/sin(180°)", "3: a division by zero"),
        ("a1^a2", "3: an exponent must be a number"),
        ("a1^65", "3: an exponent beyond 64 is not read"),
        ("2^(1/65)", "2: an exponent beyond 64 is not read"),
        ("\\frac{1}{0}", "1: a division by zero"),
        ("\\frac123", "6: '123' where { was expected after \\frac"),
        ("a1 \\", "4: a backslash at the end (remove it, or write a LaTeX command such as \\theta)"),
        ("a_", "2: _ (Low Line) means nothing here"),
        ("0.5..a1", "4: . (Full Stop) means nothing here"),
        ("(0,5)", "3: ',' where ) was expected to close ("),
    ],
)
def test_an_error_points_at_its_column(text: str, message: str) -> None:
    """And says what was expected, and the nearest thing that would be read."""
    assert refused(text) == message


@pytest.mark.parametrize(
    ("text", "column", "letter", "latin"),
    [
        ("а1", 1, "а", "a"),
        ("a1 + с1", 6, "с", "c"),
        ("2*Α", 3, "Α", "A"),
        ("οne", 1, "ο", "o"),
        ("a1 х a2", 4, "х", "x"),
    ],
)
def test_a_letter_that_looks_like_another_is_named(text: str, column: int, letter: str, latin: str) -> None:
    """Pasted slides carry Cyrillic and Greek letters that no eye can tell."""
    message = f"{column}: the letter {describe(letter)} looks like a Latin {latin} but is another (write {latin})"
    assert refused(text) == message
    assert foreign_letter(letter) == latin
    assert foreign_letter(latin) is None


def test_the_place_of_a_text_is_that_of_its_first_letter() -> None:
    """In a file with its line, in an option with its column, over several lines with both."""
    assert refused("a1 + 1/0", place=Place("robot.yaml", 7, 12)) == "robot.yaml:7:18: a division by zero"
    assert refused("a1 + 1/0", place=Place("--q", None, 4)) == "--q:10: a division by zero"
    assert refused("a1 +\n  1/0", place=Place("sheet")) == "sheet:2:4: a division by zero"
    assert refused("a1 +\n  1/0", place=Place("f", 3, 9)) == "f:4:4: a division by zero"


def test_the_line_is_shown_whole() -> None:
    """For a marker under it."""
    with pytest.raises(NotationError) as caught:
        parse("a1 +\n  b*a2\n + 1", ROBOT, Place("sheet"))
    assert caught.value.problems[0].place == Place("sheet", 2, 3, "  b*a2")
