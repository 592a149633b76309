"""Joint values from JSON Lines: an object or a list a row; whole blocks at once while all is well."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator, Sequence
from itertools import chain
from operator import itemgetter
from typing import Any

import numpy as np

from dhcli.errors import FileError, Place, Problem, plural
from dhcli.files.rows.blocks import Block, Sieve, cell_problem
from dhcli.files.rows.cells import CellError, json_number
from dhcli.files.rows.columns import JointColumns, JointTable
from dhcli.files.rows.source import Source, text_blocks
from dhcli.notation.decimals import read_json
from dhcli.regex import regex

_ONE_A_LINE = "JSON Lines has a row in each line: {\"theta1\": 0.1, ...} or [0.1, ...]; jq -c '.[]' makes it of a list"
_ONE_LIST = regex(r"\s*(?:\[[ \t]*(?:\n|[\[{])|\{[ \t]*\n)")
_MOST_HEADERS = 100
"""Sets of names that are remembered."""


class JsonRows:
    """Reads the rows of a JSON Lines file; lists have the joints in their order, objects by name."""

    def __init__(self, source: Source, asked: JointTable) -> None:
        """Read the joint values of a robot."""
        self._source = source
        self._asked = asked
        self._known: dict[tuple[str, ...], JointColumns] = {}

    def place_of(self, row: int) -> Place:
        """Where a row stands."""
        return Place(self._source.name, row)

    def blocks(self) -> Iterator[Block]:
        """The rows.

        Raises:
            FileError: The source cannot be read, or holds one list of rows.
        """
        begun = False
        for first, text in text_blocks(self._source):
            lines = text.split("\n")[:-1]
            if not begun and (begun := bool(text.strip())):
                self._check_beginning(text)
            yield self._at_once(first, lines) or self._line_by_line(first, lines)

    def _check_beginning(self, text: str) -> None:
        """Make sure that the rows are not the items of one list, of which some may well stand in lines of their own."""
        if _ONE_LIST.match(text):
            raise FileError(
                Problem("is one list or object, not a row in each line", Place(self._source.name), _ONE_A_LINE)
            )

    def _at_once(self, first: int, lines: list[str]) -> Block | None:
        """All rows of a block, if there is nothing to say about any of them."""
        rows = parsed_at_once(lines, "{" if lines[0].startswith("{") else "[")
        if rows is None:
            return None
        try:
            names = tuple(rows[0]) if isinstance(rows[0], dict) else ()
            columns = self._columns(names, Place("")) if names else self._asked.in_order(len(rows[0]))
            if names:
                table = np.fromiter(chain.from_iterable(map(_picker(names), rows)), np.float64, len(rows) * len(names))
                table = table.reshape(len(rows), len(names))
            else:
                table = np.array(rows, dtype=np.float64)
        except (ValueError, TypeError, KeyError, OverflowError, FileError):
            return None
        if table.shape != (len(rows), columns.width) or not np.isfinite(table).all():
            return None
        return Block(columns.values(table), range(first, first + len(rows)), columns.in_radians)

    def _line_by_line(self, first: int, lines: list[str]) -> Block:
        """The same with an eye on every value."""
        sieve, in_radians = Sieve(), (False,) * len(self._asked.robot.joints)
        for row, line in enumerate(lines, first):
            if not line.strip():
                continue
            place = Place(self._source.name, row, None, line)
            try:
                columns, numbers = self._row(line, place)
            except FileError as error:
                sieve.refuse(error.problems)
                continue
            ways = zip(columns.order, columns.factors, columns.held, strict=True)
            sieve.good(row, [still if k is None else numbers[k] * up / down for k, (up, down), still in ways])
            in_radians = tuple(map(max, in_radians, columns.in_radians))
        values = np.array(sieve.values, dtype=np.float64).reshape(-1, len(in_radians))
        return Block(values, sieve.rows, in_radians, tuple(sieve.bad), sieve.bad_rows)

    def _row(self, line: str, place: Place) -> tuple[JointColumns, list[float]]:
        """The numbers of a row, in the order in which they stand.

        Raises:
            FileError: With all that is wrong.
        """
        row = _parsed(line, place)
        if isinstance(row, _Object):
            pairs = _within(row)
            names, values = tuple(name for name, _ in pairs), [value for _, value in pairs]
            columns = self._columns(names, place)
        elif isinstance(row, list) and not any(isinstance(value, list | _Object) for value in row):
            values, columns = row, self._asked.in_order(len(row))
            if len(values) != (wanted := columns.width):
                message = (
                    f"{plural(len(values), 'number')} where {self._asked.robot.name} has {plural(wanted, 'joint')}"
                )
                hint = f"--ignore-columns takes the first {wanted}" if len(values) > wanted else ""
                raise FileError(Problem(message, place, hint))
        else:
            raise FileError(Problem("is no row", place, _ONE_A_LINE))
        numbers, problems = [0.0] * len(values), []
        for joint, k in zip(self._asked.robot.variables, columns.order, strict=True):
            if k is None:
                continue
            try:
                numbers[k] = json_number(values[k])
            except CellError as error:
                problems.append(cell_problem(joint, error, place))
        if problems:
            raise FileError(problems)
        return columns, numbers

    def _columns(self, names: tuple[str, ...], place: Place) -> JointColumns:
        """The columns that an object's names make; most files have the same in every row."""
        if names not in self._known:
            if len(self._known) >= _MOST_HEADERS:
                self._known.clear()
            places = [place] * len(names)
            self._known[names] = self._asked.columns(names, places, place)
        return self._known[names]


def parsed_at_once(lines: Sequence[str], begin: str) -> list[Any] | None:
    """The rows of some lines, objects `{` or lists `[`, if there is nothing to say about how they are written.

    Parsed as one list, lines could pass for other rows than they are: `[1,2],[3,4]` for two. So every line begins and
    ends as a row does, there are as many rows as lines, none has another of its kind in it, and nothing is text.
    """
    text, end = ",".join(lines), {"{": "}", "[": "]"}[begin]
    if (
        not all(line.startswith(begin) and line.endswith(end) for line in lines)
        or not text.count(begin) == text.count(end) == len(lines)
        or ("u" in text and "true" in text)  # most names have no u, and one letter is found sooner than a word
        or ("f" in text and "false" in text)
    ):
        return None
    try:
        rows: list[Any] = read_json(f"[{text}]")
        # Twice as many quotes as names: no name comes twice in an object, and no value is text.
        quotes = 2 * sum(map(len, rows)) if begin == "{" else 0
    except (ValueError, TypeError, RecursionError):
        return None
    return rows if len(rows) == len(lines) and text.count('"') == quotes else None


class _Object:
    """A JSON object with all of its members, also those of the same name."""

    def __init__(self, pairs: list[tuple[str, Any]]) -> None:
        self.pairs = pairs


def _within(row: _Object) -> list[tuple[str, Any]]:
    """The members of a row; `"q": {...}` holds the joints where dhcli has written it, a position where they lead.

    A joint state of ROS has names in one list and their positions in another, beside what nobody asks for.
    """
    found = dict(row.pairs)
    names, values = found.get("name"), found.get("position")
    if isinstance(names, list) and isinstance(values, list) and _are_names(names, len(values)):
        return [*zip(names, values, strict=True)]
    pairs, is_nested = list[tuple[str, Any]](), any(_is_joints(name, value) for name, value in row.pairs)
    for name, value in row.pairs:
        if not (is_nested and name == "position"):
            pairs += value.pairs if _is_joints(name, value) else [(name, value)]
    return pairs


def _are_names(names: list[Any], count: int) -> bool:
    return len(names) == count and all(isinstance(name, str) for name in names)


def _is_joints(name: str, value: object) -> bool:
    return name == "q" and isinstance(value, _Object)


def _parsed(line: str, place: Place) -> object:
    try:
        return json.loads(line, object_pairs_hook=_Object)
    except json.JSONDecodeError as error:
        where = Place(place.source, place.line, error.colno, line)
        raise FileError(Problem(f"is not JSON: {error.msg[:1].lower()}{error.msg[1:]}", where, _ONE_A_LINE)) from None
    except (ValueError, RecursionError):  # a number of thousands of digits, or brackets in brackets in brackets
        raise FileError(Problem("is no row", place, _ONE_A_LINE)) from None


def _picker(names: tuple[str, ...]) -> Callable[[Any], Any]:
    """What takes the values of these names out of an object, if it has no others."""
    pick = itemgetter(*names) if len(names) > 1 else lambda row: (row[names[0]],)
    return lambda row: pick(row) if len(row) == len(names) else ()
