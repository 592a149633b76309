"""Rows of a DH table that have keys, as programs keep them: `{a: 0.4, alpha: 90°, d: 0, theta: q1}` in YAML or JSON."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from dhcli.errors import FileError, Problem
from dhcli.files.foreign.heads import Named, named, needed
from dhcli.files.foreign.rows import Cell, RowText
from dhcli.files.foreign.tables import LIMITS, READ, kind_of
from dhcli.files.yaml.placed import PlacedMapping, PlacedNode, PlacedScalar, PlacedSequence, read_yaml


def keyed_rows(text: str, source: str) -> tuple[list[RowText], tuple[str, ...]]:
    """The first list in a file whose items have keys a, alpha, d and theta, and what else these have.

    Args:
        text: YAML or JSON.
        source: What it is called in errors.

    Returns:
        No rows where there is no such list, or the text is neither YAML nor JSON.

    Raises:
        FileError: A row lacks a column that the first has; or it is not what the end of its name promises.
    """
    try:
        root = read_yaml(text, source, is_foreign=True)
    except FileError:
        if source.lower().endswith((".json", ".yaml", ".yml")):
            raise
        return [], ()
    listed = next(filter(None, map(_rows, _nodes(root))), ())
    besides = {key.text: None for row in listed for key, _ in row.entries if named(key.text).column not in READ}
    return [_row(row) for row in listed], tuple(besides)


def _nodes(node: PlacedNode) -> Iterator[PlacedNode]:
    """A node and all that is below it, in the order of the file."""
    yield node
    below = node.items if isinstance(node, PlacedSequence) else ()
    if isinstance(node, PlacedMapping):
        below = tuple(value for _, value in node.entries)
    for inner in below:
        yield from _nodes(inner)


def _rows(node: PlacedNode) -> Sequence[PlacedMapping]:
    """The rows that a list, or a mapping with a name for each, consists of; none where it is something else."""
    items = node.items if isinstance(node, PlacedSequence) else ()
    if isinstance(node, PlacedMapping):
        items = tuple(value for _, value in node.entries)
    rows = [item for item in items if isinstance(item, PlacedMapping)]
    if not rows or len(rows) < len(items):
        return ()
    columns = _columns(rows[0])
    return rows if set(needed(columns)) <= columns.keys() else ()


def _columns(row: PlacedMapping) -> Mapping[str, tuple[Named, PlacedNode]]:
    """What a row holds by column."""
    found = ((named(key.text), value) for key, value in row.entries)
    return {head.column: (head, value) for head, value in found if head.column in READ}


def _row(row: PlacedMapping) -> RowText:
    columns = _columns(row)
    if lacking := [column for column in needed(columns) if column not in columns]:
        raise FileError(Problem(f"{lacking[0]} is missing in this row", row.place, f"write {lacking[0]}: 0"))
    cells: dict[str, Cell] = {}
    kind = ""
    for column, (head, value) in columns.items():
        if not isinstance(value, PlacedScalar):
            raise FileError(Problem(f"{column}: one value is wanted", value.place))
        if column == "kind":
            kind = kind_of(value.text, value.place)
        elif value.text or column not in LIMITS:
            cells[column] = Cell(value.text or "0", value.place_of(0), head.unit)
    return RowText(row.place, cells, kind)
