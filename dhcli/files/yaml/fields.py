"""Taking the fields of a file one by one, and telling all that is wrong with them in one error.

A loader asks a `Problems` for the mapping at the top, and the `Fields` it gets for their values. Whatever is missing,
unknown or of the wrong kind is noted and an empty value handed out, so that the loader goes on to the next mistake.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from types import MappingProxyType

from dhcli.errors import DhcliError, FileError, Place, Problem
from dhcli.files.yaml.cut import is_open, is_piece, is_quoting, tell
from dhcli.files.yaml.heads import FORMAT, check_format, check_kind
from dhcli.files.yaml.placed import PlacedMapping, PlacedNode, PlacedScalar, PlacedSequence
from dhcli.files.yaml.slips import (
    blanks_between,
    entries_of,
    hint_for_brackets,
    items_of,
    node_kind,
    with_decimal_points,
    with_equals,
)
from dhcli.files.yaml.unknown import OWN, hint_for, meant
from dhcli.frozen import frozen
from dhcli.notation.tokens import is_name

LISTED = "[a, b] or lines that begin with '- '"


class Problems:
    """Everything found wrong with a file so far."""

    def __init__(self, found: Iterable[Problem] = ()) -> None:
        """What was found before the file was looked at."""
        self.found = [*found]

    def add(self, place: Place, message: str, hint: str = "") -> None:
        """Note one problem."""
        self.found.append(Problem(message, place, hint))

    def take(self, error: DhcliError) -> None:
        """Note the problems of an error that was caught."""
        self.found.extend(error.problems)

    def raise_if_any(self, kind: type[DhcliError] = FileError) -> None:
        """Raise all that was found, in the order of the file.

        Raises:
            DhcliError: Of the given kind, if there is at least one problem.
        """
        if self.found:
            raise kind(sorted(self.found, key=lambda problem: problem.order))

    def document(
        self,
        root: PlacedNode,
        *,
        known: Iterable[str],
        required: Iterable[str] = (),
        elsewhere: Mapping[str, str] = MappingProxyType({}),
    ) -> Fields:
        """The mapping at the top of a file, which must begin with `format: 1`.

        Args:
            root: What `read_yaml` gave.
            known: The keys that may stand there; `format` is added.
            required: Those of them that must stand there, as for `mapping`.
            elsewhere: What to say of keys that stand below others.

        Raises:
            FileError: The file has another format, is no mapping, or is of another kind, so that judging its other keys
                would mislead.
        """
        known = tuple(known)
        if isinstance(root, PlacedMapping) and len(root.entries) == 1:
            (key, below) = root.entries[0]
            if (
                key.text not in known
                and isinstance(below, PlacedMapping)
                and len({k.text for k, _ in below.entries} & {*known}) > 1
            ):
                message = f"{key.text}: what stands below it belongs at the top of the file"
                self.add(key.place, message, "take this line out, and the blanks before the others")
                root = below
        if isinstance(root, PlacedMapping):
            for key, value in root.entries:
                if key.text == "format":
                    check_format(value)
            check_kind(root, known)
        example = "format: 1 and other 'key: value' lines; dhcli new writes a file to start from"
        means = required if isinstance(required, Mapping) else {}
        wanted = {"format": f"format: {FORMAT}", **dict.fromkeys(required, ""), **means}
        found = self.mapping(
            root, "the file", known=("format", *known), required=wanted, elsewhere=elsewhere, example=example
        )
        if not isinstance(root, PlacedMapping):
            self.raise_if_any()  # what else it lacks, nobody wants to know
        return found

    def mapping(
        self,
        node: PlacedNode,
        what: str,
        *,
        known: Iterable[str] | None = None,
        required: Iterable[str] = (),
        elsewhere: Mapping[str, str] = MappingProxyType({}),
        example: str = "'key: value' lines",
    ) -> Fields:
        """A node that should be a mapping.

        Args:
            node: The node.
            what: Its key, or what else to call it in messages.
            known: The keys that may stand there; None where they are free, such as names of parameters.
            required: The keys that must stand there; a mapping of them says what to write.
            elsewhere: What to say of keys that an author may look for here, and which stand somewhere else.
            example: What to write where it is no mapping.

        Returns:
            Its fields without the unknown ones, but with those that plainly mean a known one; none if it is no mapping.
        """
        if not isinstance(node, PlacedMapping):
            listed, shown = entries_of(node) if known is None else ((), "")
            self.add(node.place, f"{what}: should be a mapping, is {node_kind(node)}", f"write {shown or example}")
            return Fields(self, node.place, {key.text: (key, value) for key, value in listed})
        entries = self._known_entries(node, known if known is None else tuple(known), elsewhere, tuple(required))
        means = required if isinstance(required, Mapping) else {}
        for name in required:
            if name not in entries:
                self.add(node.place, f"{name}: is missing", means.get(name, ""))
        return Fields(self, node.place, entries)

    def _known_entries(
        self,
        node: PlacedMapping,
        known: tuple[str, ...] | None,
        elsewhere: Mapping[str, str],
        required: tuple[str, ...],
    ) -> dict[str, tuple[PlacedScalar, PlacedNode]]:
        """The entries of a mapping that may stand there; all others are told."""
        entries: dict[str, tuple[PlacedScalar, PlacedNode]] = {}
        there = {key.text for key, _ in node.entries}
        owner, has_equals = "", False
        missing = [name for name in required if name not in there]
        for key, value in node.entries:
            if known is not None and key.text.startswith(OWN):
                continue
            if entry := with_equals(key, value):
                key, value = entry  # noqa: PLW2901  it is read as it is meant
                if not has_equals:
                    hint = f"write {key.text}: {value.text}" if isinstance(value, PlacedScalar) else ""
                    self.add(key.place, f"{key.text}: a colon stands behind a key, and not =", hint)
                has_equals = True
            if known is None or key.text in known:
                owner = key.text
            elif owner and (cut := _cut_off(entries[owner][1], key)):
                if len(missing) == 1 and is_name(key.text) and not (is_open(cut.text) or is_quoting(cut.text)):
                    self.add(key.place, f"{key.text}: its key is missing", f"write {missing[0]}: {key.text}")
                    entries[missing.pop()] = key, key
                    continue
                text = cut.with_piece(key)
                entries[owner] = (entries[owner][0], text)
                tell(self.found, cut.text, text.text, text.place, owner)
                continue
            else:
                self.add(key.place, f"{key.text}: unknown key", hint_for(key.text, known, elsewhere))
                owner = "" if key.text in elsewhere else meant(key.text, known)
                if not owner or owner in there or owner in entries:
                    owner = ""
                    continue
            entries[owner] = (key, value)
        return entries

    def sequence(
        self, node: PlacedNode, what: str, example: str = "", *, count: int = 0, are_names: bool = False
    ) -> tuple[PlacedNode, ...]:
        """The items of a node that should be a list; none if it is not.

        Args:
            node: The node.
            what: Its key.
            example: What to write where it is no list.
            count: How many items there should be, where that is known: what has so many is what is meant.
            are_names: Whether they are names, which blanks may separate.
        """
        if isinstance(node, PlacedSequence):
            if (parted := blanks_between(node, count))[0]:
                self.add(node.place, f"{what}: a comma stands between values", f"write {parted[1]}")
                return parted[0]
            if not (items := with_decimal_points(node, count)):
                return node.items
            message = f"{what}: a number has a decimal comma, which ends a value here"
            self.add(node.place, message, f"write [{', '.join(item.text for item in items)}]")
            return items
        items, shown = items_of(node, count, are_names=are_names)
        is_it = not example or len(items) == count or (are_names and len(items) > 1)
        if not any(problem.place == node.place for problem in self.found):  # such as the comma that has cut it
            hint = f"write {(shown if is_it else '') or example or LISTED}"
            self.add(node.place, f"{what}: should be a list, is {node_kind(node)}", hint)
        return items if is_it else ()

    def scalar(self, node: PlacedNode, what: str) -> PlacedScalar | None:
        """A node that should be a text which is not empty; None if it is not."""
        if isinstance(node, PlacedScalar) and node.text.strip():
            return node
        should = "is empty" if isinstance(node, PlacedScalar) else f"should be a text, is {node_kind(node)}"
        self.add(node.place, f"{what}: {should}", "" if isinstance(node, PlacedScalar) else hint_for_brackets(node))
        return None


@frozen
class Fields:
    """The entries of one mapping, by key; a key that is not there gives an empty value and no problem.

    Attributes:
        problems: Where to note what is wrong.
        place: Where the mapping begins.
        entries: Key and value by the text of the key, in the order of the file.
    """

    problems: Problems
    place: Place
    entries: dict[str, tuple[PlacedScalar, PlacedNode]]

    def __contains__(self, key: str) -> bool:
        """Whether the key stands there."""
        return key in self.entries

    def get(self, key: str) -> PlacedNode | None:
        """The value of a key, of any kind."""
        return self.entries[key][1] if key in self.entries else None

    def place_of(self, key: str) -> Place:
        """Where a key stands, or the mapping if the key does not."""
        return self.entries[key][0].place if key in self.entries else self.place

    def scalar(self, key: str) -> PlacedScalar | None:
        """The value of a key as a text with its place."""
        node = self.get(key)
        return None if node is None else self.problems.scalar(node, key)

    def text(self, key: str, default: str = "") -> str:
        """The value of a key as a text."""
        found = self.scalar(key)
        return default if found is None else found.text

    def sequence(
        self, key: str, example: str = "", *, count: int = 0, are_names: bool = False
    ) -> tuple[PlacedNode, ...]:
        """The items of the list under a key, as for `Problems.sequence`."""
        node = self.get(key)
        return () if node is None else self.problems.sequence(node, key, example, count=count, are_names=are_names)

    def mapping(
        self,
        key: str,
        *,
        known: Iterable[str] | None = None,
        required: Iterable[str] = (),
        example: str = "'key: value' lines",
    ) -> Fields:
        """The fields of the mapping under a key."""
        node = self.get(key)
        if node is None:
            return Fields(self.problems, self.place, {})
        return self.problems.mapping(node, key, known=known, required=required, example=example)


def _cut_off(value: PlacedNode, key: PlacedScalar) -> PlacedScalar | None:
    """The value before an unknown key, if that is no key and a comma has cut it off the value; else None."""
    if not isinstance(value, PlacedScalar) or not value.text or value.quoted or key.quoted:
        return None
    return value if is_piece(key.text, key.place) and ":" not in key.text else None
