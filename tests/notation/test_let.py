"""Names for brackets: `let k1 = ...`."""

import pytest

from dhcli import load_robot, symbolic
from dhcli.algebra.equality import equal
from dhcli.files.library.entries import Kind, entries
from dhcli.notation.let import name_parts
from dhcli.notation.parser import parse
from dhcli.notation.walk import operations, substitute, symbols
from tests.row_by_row import row_by_row

ROBOTS = [entry.name for entry in entries(Kind.ROBOTS) if entry.origin == "built-in"]


@pytest.mark.parametrize("name", ROBOTS)
def test_putting_the_definitions_back_gives_the_same_matrix(name: str) -> None:
    """Each definition is in terms of those before it, so they are put back last to first."""
    rows = symbolic(load_robot(name)).rows
    definitions, named = name_parts(rows)
    for before, after in zip(rows, named, strict=True):
        for entry, short in zip(before, after, strict=True):
            for one in reversed(definitions):
                short = substitute(short, {one.name: one.expr}, {})  # noqa: PLW2901
            assert equal(entry, short)


@row_by_row("name", ROBOTS)
def test_a_definition_uses_only_names_that_come_before_it(name: str) -> None:
    """So that a reader, and a program, can go from top to bottom."""
    rows = symbolic(load_robot(name)).rows
    definitions, _ = name_parts(rows)
    later = {one.name for one in definitions}
    for one in definitions:
        assert not symbols(one.expr) & later
        later.discard(one.name)


@pytest.mark.parametrize(("name", "most"), [("panda", 134), ("puma560", 76), ("stanford", 81)])
def test_the_operations_shrink(name: str, most: int) -> None:
    """Panda from 450 to 134, definitions counted."""
    definitions, rows = name_parts(symbolic(load_robot(name)).rows)
    count = sum(operations(one.expr) for one in definitions) + sum(operations(e) for row in rows for e in row)
    assert count <= most


def test_the_opposite_of_a_bracket_has_the_same_name() -> None:
    """With a minus, also where the terms stand in another order."""
    definitions, ((first, second),) = name_parts([[parse("x*(a - b)"), parse("y*(b - a)")]])
    assert [str(one.expr) for one in definitions] == ["a - b"]
    assert (str(first), str(second)) == ("x*k1", "-y*k1")


def test_names_that_are_taken_are_left_alone() -> None:
    """A robot may have a length k1."""
    definitions, _ = name_parts([[parse("k1*(a + b)"), parse("c*(a + b)")]])
    assert [one.name for one in definitions] == ["k2"]


def test_a_short_result_gets_no_names() -> None:
    """Nothing to gain."""
    rows = symbolic(load_robot("planar-2r")).rows
    assert name_parts(rows) == ((), rows)
