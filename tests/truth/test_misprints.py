"""Each mathematical misprint of the documents is found out: what is printed differs from what dhcli computes."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

import pytest

from dhcli.algebra.equality import equal
from dhcli.algebra.terms import TERMS
from dhcli.errors import NotationError
from dhcli.kinematics.fold import fold
from dhcli.kinematics.moves import Chain, Rot, along, read_chain
from dhcli.notation.angle import Angle
from dhcli.notation.matrix import parse_matrix
from dhcli.notation.parser import parse
from dhcli.notation.tree import Expr, Symbol
from tests.row_by_row import row_by_row
from tests.truth.items import CELLS, EQUATIONS, ERRATA, MISPRINTS, TRUTH, Matrix, chain, computed, matrix, read

IN_CELLS = {n for n, erratum in MISPRINTS.items() if erratum["cells"]}
IN_LINES = {n for n, erratum in MISPRINTS.items() if erratum["eqs"] and n != 106}
IN_WORDS = {76, 86, 87, 106}
"""A column with an entry lost, wrong indices twice, and a bracket that is never closed: each has its own test below."""


def items_of(n: int) -> list[str]:
    """The items in which an erratum stands."""
    return [name.strip() for name in ERRATA[n]["items"].split(",")]


def printed_cells(n: int) -> Iterator[tuple[str, int, int, Expr, Expr]]:
    """Each cell of an erratum as item, row, column, what is printed and what is right."""
    for line, number, i, j in ERRATA[n]["cells"]:
        found = [
            (name, i, j, read(printed), read(right))
            for name in items_of(n)
            if [line, number] in TRUTH[name]["printed_refs"]
            for row, column, printed, right in TRUTH[name]["errata"]
            if (row, column) == (i, j)
        ]
        assert len(found) == 1, (n, line, number, i, j)
        yield from found


def printed_lines(n: int) -> Iterator[tuple[str, int, int, Expr, Expr]]:
    """Each equation of an erratum as item, row, column, what is printed and what is right."""
    (name,) = items_of(n)
    for line in ERRATA[n]["eqs"]:
        (equation,) = [found for found in TRUTH[name]["equations"] if found["line"] == line]
        i, j = CELLS[equation["entry"]]
        yield name, i + 1, j + 1, read(equation["printed"]), matrix(EQUATIONS[name]["expected"])[i][j]


def is_found_out(name: str, i: int, j: int, printed: Expr, right: Expr) -> bool:
    """Whether dhcli computes the right entry, and not the printed one."""
    ours = computed(EQUATIONS[name])[i - 1][j - 1]
    return equal(ours, right) and not equal(ours, printed)


def test_all_27_misprints_are_covered() -> None:
    """Every one of class M by cells, by lines, or by a test of its own; none is left out."""
    assert len(MISPRINTS) == 27
    assert not IN_CELLS & IN_LINES
    assert set(MISPRINTS) == IN_CELLS | IN_LINES | IN_WORDS


@row_by_row("n", sorted(IN_CELLS))
def test_a_printed_cell_is_not_what_comes_out(n: int) -> None:
    """In every print of the matrix; the right cell is what comes out."""
    found = list(printed_cells(n))
    assert found
    assert all(is_found_out(*cell) for cell in found)


@pytest.mark.parametrize("n", sorted(IN_LINES))
def test_a_printed_line_is_not_what_comes_out(n: int) -> None:
    """In every print of the equation; the right entry is what comes out."""
    found = list(printed_lines(n))
    assert found
    assert all(is_found_out(*line) for line in found)


def test_every_wrong_cell_of_the_truth_belongs_to_an_erratum() -> None:
    """The items' own lists of wrong cells hold nothing that the errata do not."""
    known = {(name, i, j) for n in IN_CELLS for name, i, j, _, _ in printed_cells(n)}
    known |= {(name, i, j) for n in IN_LINES for name, i, j, _, _ in printed_lines(n)}
    wrong = {
        (name, i, j)
        for name, item in EQUATIONS.items()
        for i, j, printed, right in item["errata"]
        if j is not None and printed is not None and right is not None
    }
    assert wrong == known


@row_by_row("name", [name for name, item in EQUATIONS.items() if item["printed"]])
def test_a_printed_matrix_is_right_but_for_its_errata(name: str) -> None:
    """So that a misprint is never overlooked, nor found where there is none."""
    item = EQUATIONS[name]
    wrong = {(i, j) for i, j, *_ in item["errata"]}
    for i, (line, ours) in enumerate(zip(item["printed"], computed(item), strict=True), 1):
        if (i, None) in wrong:  # a last row of three cells
            assert len(line) == 3
            continue
        for j, (text, entry) in enumerate(zip(line, ours, strict=True), 1):
            if text is not None:
                assert equal(read(text), entry) == ((i, j) not in wrong), (i, j)


@pytest.mark.parametrize("name", ["Y38", "Y45", "W17", "W18"])
def test_a_printed_line_is_right_but_for_its_errata(name: str) -> None:
    """Line by line, as the slides print the entries of a pose; lines for which there is no entry left out."""
    wrong = {line for n in IN_LINES if name in items_of(n) for line in ERRATA[n]["eqs"]}
    ours = computed(EQUATIONS[name])
    for equation in TRUTH[name]["equations"]:
        if equation["entry"] is not None and equation["printed"] is not None:
            i, j = CELLS[equation["entry"]]
            assert equal(read(equation["printed"]), ours[i][j]) == (equation["line"] not in wrong), equation["line"]


def test_the_spelling_of_the_documents_is_read_as_it_stands() -> None:
    """`c_1[c_{23}(c_4c_5c_6 - s_4s_6) - s_{23}s_5c_6]` as it was typed, misprints included: 75 lines but for two."""
    lines = [equation for item in TRUTH.values() for equation in item["equations"]]
    whole = [equation for equation in lines if equation["printed"] is not None]
    assert (len(lines), len(whole)) == (75, 73)
    assert [e["raw"] for e in whole if parse(e["raw"].rstrip(",.")) != read(e["printed"])] == []


def test_e76_a_column_with_its_first_entry_lost_is_no_point_of_the_arm() -> None:
    """Three entries where a homogeneous column has four; read as coordinates they give another tip."""
    column = parse_matrix("[-e*sin(alpha); c; 1]")
    assert (len(column), len(EQUATIONS["Z20"]["expected"])) == (3, 4)
    printed = tip(*(row[0].expr for row in column))
    right = matrix(EQUATIONS["Z21"]["expected"])
    assert [equal(ours, entry[0]) for ours, entry in zip(printed, right, strict=True)] == [False] * 3
    ours = tip(*(read(text) for text in TRUTH["Z20"]["compute"]["point"]))
    assert [equal(one, entry[0]) for one, entry in zip(ours, right, strict=True)] == [True] * 3


def test_e86_the_steps_with_the_indices_of_row_i_give_another_matrix() -> None:
    """About x_i by alpha_i and along it by a_i: nine entries are not those of the modified matrix."""
    printed = "Rot(x, alpha_i) Trans(x, a_i) Trans(z, d_i) Rot(z, theta_i)"
    right = "Rot(x, alpha_{i-1}) Trans(x, a_{i-1}) Trans(z, d_i) Rot(z, theta_i)"
    wrong = {(1, 4), (2, 1), (2, 2), (2, 3), (2, 4), (3, 1), (3, 2), (3, 3), (3, 4)}
    assert different(read_chain(printed)) == wrong
    assert different(read_chain(right)) == set()


def test_e87_a_translation_by_the_twist_gives_the_misprinted_cell_of_e88() -> None:
    """D_x(alpha_{i-1}) in the product line is how alpha_{i-1} came into row 1, column 4."""
    previous, theta = "alpha_{i-1}", Angle.of("theta_i")
    moves = (Rot("x", Angle.of(previous)), along("x", Symbol(previous)), along("z", Symbol("d_i")), Rot("z", theta))
    assert different(moves) == {(1, 4)}
    ((_, i, j, printed, _),) = printed_cells(88)
    assert fold(moves, TERMS)[i - 1][j - 1] == printed


def test_e106_a_bracket_that_is_never_closed_is_refused_and_closes_in_one_place_only() -> None:
    """The line is no expression; of the places where `]` could stand, one gives the entry that comes out."""
    (raw,) = {equation["raw"].rstrip(",") for equation in TRUTH["W18"]["equations"] if equation["printed"] is None}
    with pytest.raises(NotationError, match="to close"):
        parse(raw)
    start = raw.index("[") + 1
    ours = computed(EQUATIONS["W18"])[1][0]
    places = [i for i in (*range(start + 1, len(raw)), len(raw)) if closes_well(raw, i)]
    right = [i for i in places if equal(parse(raw[:i] + "]" + raw[i:]), ours)]
    assert len(places) > 3
    assert {raw[:i].rstrip() for i in right} == {"s_1[c_{23}(c_4c_5c_6 - s_4s_6) - s_{23}s_5c_6"}


def tip(x: Expr, y: Expr, z: Expr) -> tuple[Expr, Expr, Expr]:
    """A point of frame 3 of Zhou's 3R arm, seen from frame 0."""
    rows = fold((*chain(EQUATIONS["Z19"]["compute"]), along("x", x), along("y", y), along("z", z)), TERMS)
    return rows[0][3], rows[1][3], rows[2][3]


def different(moves: Chain) -> set[tuple[int, int]]:
    """The cells in which moves differ from the modified DH matrix of the truth."""
    ours: Matrix = fold(moves, TERMS)
    right = matrix(EQUATIONS["Z46"]["expected"])
    return {(i + 1, j + 1) for i in range(4) for j in range(4) if not equal(ours[i][j], right[i][j])}


def closes_well(text: str, place: int) -> bool:
    """Whether a bracket closed at a place leaves something that can be read, with no sign cut in two."""
    try:
        parse(text[:place] + "]" + text[place:])
    except NotationError:
        return False
    return True


def test_pairs_of_lines_that_repeat_each_other_are_equally_wrong() -> None:
    """W18 is printed twice, and both prints are alike, slips included."""
    equations = TRUTH["W18"]["equations"]
    half = len(equations) // 2
    assert [e["raw"] for e in equations[:half]] == [e["raw"] for e in equations[half:]]
    assert all(a["line"] < b["line"] for a, b in pairwise(equations))
