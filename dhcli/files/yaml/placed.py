"""YAML as a tree that keeps the exact spelling and the place of everything.

PyYAML is used only to find where each text begins and ends. It never decides what a text means: `1e-3`, `on`, `010`
and `12:30` stay the texts they are, and whoever knows what belongs there reads them. What could hide a mistake
(a key given twice, anchors, tags, merge keys, a second document) is refused, all of it in one error.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import TYPE_CHECKING, NoReturn, TypeAlias, TypeGuard

from dhcli.errors import FileError, Place, Problem
from dhcli.files.yaml.cut import is_open, is_piece, is_quoting, tell, whole, with_decimal_comma
from dhcli.files.yaml.parser import events, import_yaml
from dhcli.files.yaml.syntax import DEEPEST, TOO_DEEP, Mark, explain_syntax
from dhcli.frozen import frozen
from dhcli.regex import regex

if TYPE_CHECKING:
    import yaml

MOST_NODES = 20_000

# What YAML 1.1 calls a line break; str.splitlines knows others, and the line numbers would drift apart.
_LINE_BREAK = regex("\r\n|[\r\n\x85\u2028\u2029]")
_MADE_BY_ESCAPE = regex("[\x00-\x09\x0b-\x1f\x7f-\x9f\u2028\u2029\ud800-\udfff]")
_UNREADABLE = regex("[^\t\n\r\x20-\x7e\x85\xa0-\ud7ff\ue000-\ufefe\uff00-\ufffd\U00010000-\U0010ffff]")
"""What YAML does not allow; it takes 8 ms to compile, when a line holds something odd."""


@frozen
class PlacedScalar:
    """A text, with the place where it begins.

    Attributes:
        text: The text as spelled, without its quotes; empty where a value is missing.
        place: Where it begins; the quote, if it has one.
        quoted: Whether it stands in quotes or is a block of text (`|`, `>`), so that it cannot be meant as a number.
    """

    text: str
    place: Place
    quoted: bool = False

    def place_of(self, offset: int) -> Place:
        """The place of one character of the text.

        Returns:
            The place of that character, or of the whole text if it is not spelled on one line as it reads.
        """
        if self.place.column is None:
            return self.place
        start = self.place.column - 1 + self.quoted
        if not self.place.text.startswith(self.text, start):
            return self.place
        return Place(self.place.source, self.place.line, start + offset + 1, self.place.text)

    def with_piece(self, piece: PlacedScalar) -> PlacedScalar:
        """The text with a piece that a comma has cut off it."""
        return replace(self, text=whole(self.text, self.place, piece.text, piece.place))


@frozen
class PlacedSequence:
    """A list, with the place where it begins."""

    items: tuple[PlacedNode, ...]
    place: Place


@frozen
class PlacedMapping:
    """Keys and values in the order they are written, with the place where the first begins; no key stands twice."""

    entries: tuple[tuple[PlacedScalar, PlacedNode], ...]
    place: Place


PlacedNode: TypeAlias = PlacedScalar | PlacedSequence | PlacedMapping


def as_text(node: PlacedNode) -> str:
    """A node as the text that it looks like: a list is the matrix or the vector that stands there."""
    if isinstance(node, PlacedScalar):
        return node.text
    if isinstance(node, PlacedSequence):
        return "[" + ", ".join(map(as_text, node.items)) + "]"
    return "{" + ", ".join(f"{key.text}: {as_text(value)}" for key, value in node.entries) + "}"


def read_yaml(
    text: str, source: str, refused: list[Problem] | None = None, *, spelled: str = "", is_foreign: bool = False
) -> PlacedNode:
    """Read one YAML document into a tree with places.

    Args:
        text: The document; a byte order mark and any line ends are accepted.
        source: What to call it in messages, usually the file name.
        refused: Where to note what is refused but does not stop the reading, such as a key given twice, for a loader
            that tells everything at once; by default it is raised.
        spelled: What stands in the file, where letters of it were replaced to make `text`; values and messages show it.
        is_foreign: Whether it is known to be no file of dhcli's; else one that is of another form is told apart.

    Raises:
        FileError: Every problem up to the first that stops the reading: it is empty, is not YAML, uses what dhcli
            refuses, or is too deep or too large a tree.
    """
    import_yaml()
    import yaml.error

    text, spelled = text.lstrip("\ufeff"), (spelled or text).lstrip("\ufeff")
    builder = _Builder([*_LINE_BREAK.split(spelled), ""], source)  # one line more: a mark may stand after the last
    builder.refuse_unreadable()
    try:
        root = builder.document(events(text))
    except yaml.error.MarkedYAMLError as error:
        if not is_foreign:
            _refuse_foreign(text, source)
        raise FileError([*builder.problems, explain_syntax(error, builder.lines, builder.place)]) from None
    keys = {key.text for key, _ in root.entries} if isinstance(root, PlacedMapping) else frozenset[str]()
    if not is_foreign and "format" not in keys:
        _refuse_foreign(text, source, has_keys=bool(keys))
    if refused is not None:
        refused += builder.problems
    elif builder.problems:
        raise FileError(builder.problems)
    return root


def _refuse_foreign(text: str, source: str, *, has_keys: bool = False) -> None:
    """Say so if a text that is no file of dhcli's is a URDF, a table or another form that can become one.

    What has keys is no table and no listing, whatever stands in its comments.
    """
    from dhcli.files.foreign.forms import Form, form_of, told  # most files are what they should be

    form = form_of(text)
    if form is not None and not (has_keys and form in (Form.TABLE, Form.LISTING)):
        raise FileError(told(form, source))


def _is_plain(node: PlacedNode | None) -> TypeGuard[PlacedScalar]:
    """Whether a node is a text without quotes."""
    return isinstance(node, PlacedScalar) and not node.quoted


def _goes_on(last: PlacedScalar, key: PlacedScalar) -> bool:
    """Whether what YAML takes for a key is a piece of the value before it."""
    return (is_open(last.text) or is_quoting(last.text)) and is_piece(key.text, key.place)


class _Builder:
    """Builds the tree from PyYAML's events and collects what is refused."""

    def __init__(self, lines: list[str], source: str) -> None:
        self.lines, self.source = lines, source
        self.problems: list[Problem] = []
        self.nodes = 0

    def place(self, mark: Mark | None) -> Place:
        """The place of a mark, with its line for a marker."""
        if mark is None:
            return Place(self.source)
        return Place(self.source, mark.line + 1, mark.column + 1, self.lines[mark.line])

    def refuse_unreadable(self) -> None:
        """Stop at a character that no YAML file may hold, before the parser stumbles over it."""
        for number, line in enumerate(self.lines, start=1):
            if not line.isprintable() and (found := _UNREADABLE.search(line)):
                place = Place(self.source, number, found.start() + 1, line)
                self.give_up(place, f"the character U+{ord(found[0]):04X} cannot stand in a YAML file", "delete it")

    def document(self, events: Iterator[yaml.Event]) -> PlacedNode:
        """Build the tree of the only document."""
        import yaml.events as kinds

        next(events)
        root = None if isinstance(next(events), kinds.StreamEndEvent) else self.node(next(events), events, 1)
        if root is None or root == PlacedScalar("", root.place):
            self.give_up(Place(self.source), "is empty")
        _end, after = next(events), next(events)
        if isinstance(after, kinds.DocumentStartEvent):
            self.refuse(self.place(after.start_mark), "a second document begins here", "one file holds one document")
        return root

    def node(self, event: yaml.Event, events: Iterator[yaml.Event], depth: int) -> PlacedNode:
        """Build what begins with an event."""
        import yaml.events as kinds

        place = self.place(event.start_mark)
        self.nodes += 1
        if self.nodes > MOST_NODES:
            self.give_up(place, f"the file holds more than {MOST_NODES:,} keys and values", "is it the right file?")
        if depth > DEEPEST:
            self.give_up(place, TOO_DEEP)
        if isinstance(event, kinds.NodeEvent) and event.anchor is not None:
            sign, word = ("*", "alias") if isinstance(event, kinds.AliasEvent) else ("&", "anchor")
            self.refuse(place, f"'{sign}{event.anchor}' is a YAML {word}", "write the value itself; text needs quotes")
        if isinstance(event, (kinds.ScalarEvent, kinds.CollectionStartEvent)) and event.tag is not None:
            self.refuse(place, "'!' begins a YAML tag", "leave it out; text needs quotes")
        if isinstance(event, kinds.MappingStartEvent):
            return self.mapping(place, events, depth)
        if isinstance(event, kinds.SequenceStartEvent):
            return self.sequence(place, events, depth, is_flow=bool(event.flow_style))
        return self.scalar(event, place) if isinstance(event, kinds.ScalarEvent) else PlacedScalar("", place)

    def sequence(self, place: Place, events: Iterator[yaml.Event], depth: int, *, is_flow: bool) -> PlacedSequence:
        """Build a list; one in brackets may have cut a text."""
        import yaml.events as kinds

        items: list[PlacedNode] = []
        while not isinstance(event := next(events), kinds.SequenceEndEvent):
            item = self.node(event, events, depth + 1)
            last = items[-1] if is_flow and items else None
            if _is_plain(last) and _is_plain(item) and is_open(last.text):
                items[-1] = self.put_together(last, item)
            else:
                items.append(item)
        return PlacedSequence(tuple(items), place)

    def put_together(self, last: PlacedScalar, piece: PlacedScalar, key: str = "") -> PlacedScalar:
        """A text with the next piece of it, and one problem for all its pieces."""
        found = last.with_piece(piece)
        tell(self.problems, last.text, found.text, found.place, key)
        return found

    def mapping(self, place: Place, events: Iterator[yaml.Event], depth: int) -> PlacedMapping:
        """Build a mapping; every key is a text and stands once."""
        import yaml.events as kinds

        entries: dict[str, tuple[PlacedScalar, PlacedNode]] = {}
        owner, last = None, None
        while not isinstance(event := next(events), kinds.MappingEndEvent):
            key = self.node(event, events, depth + 1)
            if owner and _is_plain(last) and _is_plain(key) and _goes_on(last, key):
                last = self.put_together(last, key, owner.text)
                entries[owner.text] = (owner, last)
                self.node(next(events), events, depth + 1)
                continue
            if not isinstance(key, PlacedScalar):
                self.refuse(key.place, "a key cannot be a list or mapping", "text with brackets needs quotes")
            elif key.text == "<<" and not key.quoted:
                self.refuse(key.place, "'<<' is a YAML merge key", "write the entries themselves")
            elif key.text == "" and not isinstance(event, kinds.AliasEvent):
                self.refuse(key.place, "a key is missing before ':'")
            elif number := "" if key.quoted else with_decimal_comma(key.text, key.place):
                message = f"{number} has a decimal comma, which ends a value here"
                self.refuse(key.place, message, f"write {number.replace(',', '.')}")
                self.node(next(events), events, depth + 1)
                continue
            elif key.text in entries:
                first = entries[key.text][0].place
                self.refuse(key.place, f"{key.text}: stands twice, first on line {first.line}", "keep one")
            value = self.node(next(events), events, depth + 1)
            if isinstance(key, PlacedScalar):
                owner, last = entries.setdefault(key.text, (key, value))
        return PlacedMapping(tuple(entries.values()), place)

    def scalar(self, event: yaml.ScalarEvent, place: Place) -> PlacedScalar:
        """Keep a text, unless its double quotes have turned a LaTeX theta into a tab and `heta`."""
        if event.style == '"' and (found := _MADE_BY_ESCAPE.search(event.value)):
            message = f"this text in double quotes holds the control character U+{ord(found[0]):04X}"
            self.refuse(place, message, "a backslash that is meant as one needs single quotes")
        return PlacedScalar(self.spelled(event, place), place, quoted=bool(event.style))

    @staticmethod
    def spelled(event: yaml.ScalarEvent, place: Place) -> str:
        """A text as the file has it, where it stands plain on one line; there what was replaced comes back."""
        text: str = event.value
        start = (place.column or 1) - 1
        there = place.text[start : start + len(text)] if place.text else ""
        is_it = not event.style and len(there) == len(text) and there.replace(",", ";") == text.replace(",", ";")
        return there if is_it else text

    def refuse(self, place: Place, message: str, hint: str = "") -> None:
        """Note a problem and go on."""
        self.problems.append(Problem(message, place, hint))

    def give_up(self, place: Place, message: str, hint: str = "") -> NoReturn:
        """Raise with what was found so far and a problem that stops the reading."""
        raise FileError([*self.problems, Problem(message, place, hint)])
