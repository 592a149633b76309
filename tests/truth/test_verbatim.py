"""Every formula of the four documents, letter by letter as it is printed, is read, and judged as the errata say.

`tests/data/printed.json` holds the formulas with their lines. What they are to be read as is written down independently
in `truth.json`, and which cells are misprints in `errata.json`.
"""

from __future__ import annotations

import json
from typing import Any

import pytest

from dhcli.algebra.equality import equal
from dhcli.errors import NotationError
from dhcli.notation.matrix import parse_matrix
from dhcli.notation.parser import parse
from dhcli.notation.pasted import without_label
from dhcli.notation.scope import OPEN
from dhcli.notation.tree import Expr
from tests.row_by_row import row_by_row
from tests.truth.items import _DATA, CELLS, EQUATIONS, ERRATA, TRUTH, matrix, read

PRINTED: list[dict[str, Any]] = json.loads((_DATA / "printed.json").read_text("utf-8"))
MATRICES = [found for found in PRINTED if "n" in found]
LINES = [found for found in PRINTED if "n" not in found]
LOST = {340, 516, 641, 129}
"""Lines whose matrices have lost a cell of the bottom row, errata 33 and 96; each is refused, and judged with it."""
SHORT = r"\\ 0 & 0 & 1 \end"


def place(found: dict[str, Any]) -> str:
    """Where a formula stands, as the id of its test."""
    return f"{found['doc']}-{found['line']}-{found.get('n', found.get('entry'))}-{found['item']}"


def cells_of(found: dict[str, Any]) -> list[list[Expr]]:
    """The cells of a printed matrix as they are read, with the cell of the bottom row that a print has lost."""
    text = without_label(found["text"])
    if found["line"] in LOST:
        text = text.replace(SHORT, SHORT.replace("0", "0 & 0", 1))
    return [[cell.expr for cell in row] for row in parse_matrix(text, OPEN)]


def test_every_print_is_here() -> None:
    """All matrices and equations that the truth refers to, each once."""
    references = {(t["doc"], line, n, name) for name, t in TRUTH.items() for line, n in t["printed_refs"]}
    assert {(m["doc"], m["line"], m["n"], m["item"]) for m in MATRICES} == references
    lines = {(t["doc"], e["line"], name) for name, t in TRUTH.items() for e in t["equations"]}
    assert {(e["doc"], e["line"], e["item"]) for e in LINES} == lines
    assert len(PRINTED) == len(MATRICES) + len(LINES) == 192


@row_by_row("found", [found for found in MATRICES if (found["item"], found["line"]) != ("Z07", 56)])
def test_a_printed_matrix_is_read_as_it_is_written_down(found: dict[str, Any]) -> None:
    """With its label, its display signs and the stop at its end; of Z07 the truth records the print of line 86."""
    written = TRUTH[found["item"]]["printed"]
    if found["line"] in LOST and SHORT in found["text"]:
        written = [*written[:3], ["0", "0", "0", "1"]]
    assert all(
        equal(cell, read(str(right)))
        for row, rights in zip(cells_of(found), written, strict=True)
        for cell, right in zip(row, rights, strict=True)
    )


@row_by_row("found", MATRICES)
def test_a_printed_matrix_is_wrong_exactly_where_the_errata_say(found: dict[str, Any]) -> None:
    """Cell by cell."""
    right = matrix(EQUATIONS[found["item"]]["expected"])
    differing = {
        (i, j)
        for i, row in enumerate(cells_of(found), 1)
        for j, cell in enumerate(row, 1)
        if not equal(cell, right[i - 1][j - 1])
    }
    said = {
        (i, j)
        for erratum in ERRATA.values()
        if erratum["doc"] == found["doc"]
        for line, n, i, j in erratum["cells"]
        if (line, n) == (found["line"], found["n"])
    }
    assert differing == said


def test_a_print_that_has_lost_a_cell_is_refused() -> None:
    """With its row, and what the bottom row of a pose is."""
    lost = [found for found in MATRICES if found["line"] in LOST and SHORT in found["text"]]
    assert {found["line"] for found in lost} == LOST
    for found in lost:
        with pytest.raises(NotationError, match="row 4 has 3 cells where others have 4") as caught:
            parse_matrix(without_label(found["text"]), OPEN)
        assert caught.value.problems[0].hint == "the bottom row of a pose is 0 0 0 1"


@row_by_row("found", LINES)
def test_a_printed_equation_is_read_and_judged(found: dict[str, Any]) -> None:
    """One entry a line; a bracket that is never closed is refused, and is an erratum too."""
    (equation,) = [e for e in TRUTH[found["item"]]["equations"] if e["line"] == found["line"]]
    is_erratum = any(found["line"] in e["eqs"] for e in ERRATA.values() if e["doc"] == found["doc"])
    if equation["printed"] is None:
        with pytest.raises(NotationError, match="to close"):
            parse(without_label(found["text"]), OPEN)
        assert is_erratum
        return
    ours = parse(without_label(found["text"]), OPEN)
    assert equal(ours, read(equation["printed"]))
    if equation["entry"] is not None:
        i, j = CELLS[equation["entry"]]
        assert equal(ours, matrix(EQUATIONS[found["item"]]["expected"])[i][j]) != is_erratum
