"""Where in a file something stands: data keep no lines, so the tree is walked once more by keys and positions."""

from __future__ import annotations

from dhcli.errors import Place
from dhcli.files.keys.linkages import FORMS
from dhcli.files.yaml.placed import PlacedMapping, PlacedNode, PlacedScalar, PlacedSequence
from dhcli.files.yaml.unknown import meant

IN_PLACE_OF = {"links": ("links", "axes", "screws"), "joints": FORMS}
"""Keys of which a file has one: what a rule calls the links of a robot, or the joints of a linkage."""


def place_in(root: PlacedNode, where: tuple[str | int, ...]) -> Place:
    """The place of what a path leads to, or of the nearest thing above it that the file has.

    Args:
        root: The tree of a file.
        where: Keys of mappings, and positions in lists, such as ("parts", 2, "hints", 0); for the links of a
            robot its axes or screws may stand in the file.
    """
    place = root.place
    if where and (forms := IN_PLACE_OF.get(str(where[0]))):
        where = (next((key for key in forms if _below(root, key)), where[0]), *where[1:])
    if where and isinstance(root, PlacedMapping) and _below(root, where[0]) is None:
        top = (key.text for key, _ in root.entries if meant(key.text, (str(where[0]),)))
        where = (next(top, where[0]), *where[1:])
    for step in where:
        found = _below(root, step)
        if found is None:
            return place
        key, root = found
        place = key if key is not None and not _is_short(root) else root.place
    return place


def path_to(root: PlacedNode, place: Place) -> tuple[str | int, ...]:
    """The keys and positions that lead to the last thing that begins at or before a place."""
    path: list[str | int] = []
    inner: PlacedNode | None = root
    while inner is not None:
        steps: list[tuple[str | int, Place, PlacedNode]] = []
        if isinstance(inner, PlacedMapping):
            steps = [(key.text, key.place, value) for key, value in inner.entries]
        elif isinstance(inner, PlacedSequence):
            steps = [(k, item.place, item) for k, item in enumerate(inner.items)]
        before = [step for step in steps if step[1].order <= place.order]
        path += [before[-1][0]] if before else []
        inner = before[-1][2] if before else None
    return tuple(path)


def _below(node: PlacedNode, step: str | int) -> tuple[Place | None, PlacedNode] | None:
    """What stands one step below, with the place of its key if it has one."""
    if isinstance(node, PlacedSequence):
        return (None, node.items[step]) if isinstance(step, int) and step < len(node.items) else None
    entries = node.entries if isinstance(node, PlacedMapping) else ()
    return next(((key.place, value) for key, value in entries if key.text == step), None)


def _is_short(node: PlacedNode) -> bool:
    """Whether a marker is best put at the value itself: a text on one line."""
    return isinstance(node, PlacedScalar) and node.place.text.rstrip()[-1:] not in ("|", ">")
