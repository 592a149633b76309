"""Products of moves as people type them."""

from __future__ import annotations

import pytest

from dhcli.errors import NotationError
from dhcli.kinematics.moves import Chain, Fixed, Rot, Trans, inverse, read_chain
from dhcli.notation.angle import Angle
from dhcli.notation.parser import parse
from dhcli.notation.products import MOST_FACTORS, parse_factors
from dhcli.notation.quantity import to_angle, to_length
from tests.row_by_row import row_by_row

RIGHT = Angle.in_degrees(90)


def trans(x: str, y: str, z: str) -> Trans:
    """A translation by three texts."""
    return Trans(*(to_length(parse(text)) for text in (x, y, z)))


@row_by_row(
    ("text", "chain"),
    [
        ("Rot(z, 90°)", (Rot("z", RIGHT),)),
        ("Rot(z,90°)Rot(x,pi/2)", (Rot("z", RIGHT), Rot("x", RIGHT))),
        ("rot(y, 90 deg) * Trans(1, 2, 3)", (Rot("y", RIGHT), trans("1", "2", "3"))),
        ("Rot_x(90°) @ Trans_z(d1)", (Rot("x", RIGHT), trans("0", "0", "d1"))),
        ("Rotz(90°)", (Rot("z", RIGHT),)),
        ("RotX(90°) TransZ(d1)", (Rot("x", RIGHT), trans("0", "0", "d1"))),
        ("trotx(90°) transl(0, 0, d1)", (Rot("x", RIGHT), trans("0", "0", "d1"))),
        ("rotation(X, 90°) Translation(Z, d1)", (Rot("x", RIGHT), trans("0", "0", "d1"))),
        ("R_{z}(90°) D_{x}(a)", (Rot("z", RIGHT), trans("a", "0", "0"))),
        ("Rx(90°) Ty(b)", (Rot("x", RIGHT), trans("0", "b", "0"))),
        ("Trans(z, d1)", (trans("0", "0", "d1"),)),
        ("Trans(30 mm, -2 cm, 0)", (trans("0.03", "-0.02", "0"),)),
        ("Rot(y'', 90°)", (Rot("y", RIGHT),)),
        ("Rot(z, theta1 - 90°)", (Rot("z", to_angle(parse("theta1 - 90°"))),)),
        ("Trans(a1*cos(theta1), 0, sqrt(2))", (trans("a1*cos(theta1)", "0", "sqrt(2)"),)),
        ("inv(Rot(z, 90°))", (Rot("z", -RIGHT),)),
        ("Rot(z, 90°)^-1", (Rot("z", -RIGHT),)),
        ("Rot(z, 90°)^{-1}", (Rot("z", -RIGHT),)),
        ("Rot(z, 90°)⁻¹", (Rot("z", -RIGHT),)),
        ("inv(Rot(z, 90°) Trans(1, 2, 3))", (trans("-1", "-2", "-3"), Rot("z", -RIGHT))),
        ("(Rot(z, 90°) Trans(1, 2, 3))^-1", (trans("-1", "-2", "-3"), Rot("z", -RIGHT))),
        ("inv(inv(Rot(z, 90°)) Rot(x, 90°))", (Rot("x", -RIGHT), Rot("z", RIGHT))),
        ("((Rot(z, 90°)))", (Rot("z", RIGHT),)),
        ("Rot(z, 90°)\n  Trans(1, 2, 3)", (Rot("z", RIGHT), trans("1", "2", "3"))),
    ],
)
def test_a_product_is_read_move_by_move(text: str, chain: Chain) -> None:
    """From left to right, inverses turned round."""
    assert read_chain(text) == chain


@pytest.mark.parametrize(
    "text",
    [
        "[0 -1 0 a; 1 0 0 2; 0 0 1 3; 0 0 0 1]",
        "[[0, -1, 0, a], [1, 0, 0, 2], [0, 0, 1, 3], [0, 0, 0, 1]]",
        "np.array([[0, -1, 0, a], [1, 0, 0, 2], [0, 0, 1, 3], [0, 0, 0, 1]])",
        r"\begin{bmatrix} 0 & -1 & 0 & a \\ 1 & 0 & 0 & 2 \\ 0 & 0 & 1 & 3 \\ 0 & 0 & 0 & 1 \end{bmatrix}",
    ],
)
def test_a_literal_matrix_may_stand_among_the_moves(text: str) -> None:
    """In every spelling of a matrix, inverted too."""
    rows = (("0", "-1", "0", "a"), ("1", "0", "0", "2"), ("0", "0", "1", "3"))
    fixed = Fixed(tuple(tuple(parse(entry) for entry in row) for row in rows))  # type: ignore[arg-type]
    assert read_chain(f"Rot(z, 90°) {text} Rot(x, 90°)") == (Rot("z", RIGHT), fixed, Rot("x", RIGHT))
    assert read_chain(f"inv({text})") == inverse((fixed,))


@row_by_row(
    ("text", "message"),
    [
        ("", "1: no move is written here"),
        ("Rot(z, 90)", "8: the angle 90 has no unit"),
        ("Rot(90°)", "1: Rot turns or shifts along x, y or z, not 90°"),
        ("Rot(w, 90°)", "1: Rot turns or shifts along x, y or z, not w"),
        ("Rot(z)", "6: Rot about z takes one value, not 0"),
        ("Rot(z, 1 rad, 2 rad)", "20: Rot about z takes one value, not 2"),
        ("Trans(1, 2, 3, 4)", "1: Trans takes three lengths, not 4"),
        ("Trans(1)", "1: Trans takes three lengths, not 1"),
        ("Trans(1, 2, 30°)", "13: deg is a unit of angle, a length is wanted"),
        ("Rot(z, 30 mm)", "8: mm is a unit of length, an angle is wanted"),
        ("Rot(z, 90°) Foo(1)", "13: Foo is not a move"),
        ("Rot(z, 90°) + Trans(1, 2, 3)", "13: '+' is not a move or a matrix"),
        ("5 Rot(z, 90°)", "1: '5' is not a move or a matrix"),
        ("Rot(z, 90°", "4: ( is never closed"),
        ("[1 0 0; 0 1 0; 0 0 1]", "1: a pose has 4 rows of 4, this matrix is 3x3"),
        ("Rot(z, 90°) Trans(1, 2, x y)", None),
        ("Trans(1, 2, 1/0)", "14: a division by zero"),
    ],
)
def test_what_is_no_move_is_told_with_its_column(text: str, message: str | None) -> None:
    """And what would be read."""
    if message is None:
        assert len(parse_factors(text)) == 2
        return
    with pytest.raises(NotationError) as caught:
        parse_factors(text)
    problem = caught.value.problems[0]
    assert f"{problem.place.column}: {problem.message}" == message  # type: ignore[union-attr]


@pytest.mark.parametrize("text", ["Trans(0.4*cos(30), 0, 0)", "Trans(0, l1*sin(45), 0) Rot(z, 90°)"])
def test_a_cosine_of_degrees_without_their_sign_is_asked_about(text: str) -> None:
    """As an angle of a turn is; in radians up to a turn, and in degrees with their sign, it is read."""
    with pytest.raises(NotationError, match="does not say what"):
        read_chain(text)
    read_chain(text.replace("30", "30°").replace("45", "45°"))
    read_chain(text.replace("30", "0.5236").replace("45", "0.7854"))


@row_by_row(
    ("matrix", "hint"),
    [
        ("[1 0 0 0; 0 1 0 0; 0 0 1 0]", "add the row 0 0 0 1"),
        ("[1 0 0; 0 1 0; 0 0 1]", "add the position as fourth column, and the row 0 0 0 1"),
        ("[1 2; 3 4]", ""),
    ],
)
def test_a_matrix_that_is_part_of_a_pose_is_told_what_it_lacks(matrix: str, hint: str) -> None:
    """Of any other, nobody knows what was meant."""
    with pytest.raises(NotationError) as caught:
        read_chain(matrix)
    assert caught.value.problems[0].hint == hint


def test_a_factor_keeps_its_text() -> None:
    """For headings of steps."""
    assert [factor.text for factor in parse_factors("Rot(z , 90°) *Trans_x(a) [1 0 0 0;0 1 0 0;0 0 1 0;0 0 0 1]")] == [
        "Rot(z , 90°)",
        "Trans_x(a)",
        "[1 0 0 0;0 1 0 0;0 0 1 0;0 0 0 1]",
    ]


def test_at_most_200_moves_are_read() -> None:
    """No arm has more."""
    assert len(parse_factors("Rot(z, 90°)" * MOST_FACTORS)) == MOST_FACTORS
    with pytest.raises(NotationError, match="more than 200 moves are not read"):
        parse_factors("Rot(z, 90°)" * (MOST_FACTORS + 1))
