"""Where in a file something stands: data keep no lines, so the tree is walked once more by keys and positions."""

from __future__ import annotations

from dhcli.errors import Place
from dhcli.files.yaml.placed import PlacedMapping, PlacedNode, PlacedScalar, PlacedSequence


def place_in(root: PlacedNode, where: tuple[str | int, ...]) -> Place:
    """The place of what a path leads to, or of the nearest thing above it that the file has.

    Args:
        root: The tree of a file.
        where: Keys of mappings and positions in lists, such as ("parts", 2, "hints").
    """
    place = root.place
    for step in where:
        found = _below(root, step)
        if found is None:
            return place
        key, root = found
        place = key if key is not None and not _is_short(root) else root.place
    return place


def _below(node: PlacedNode, step: str | int) -> tuple[Place | None, PlacedNode] | None:
    """What stands one step below, with the place of its key if it has one."""
    if isinstance(node, PlacedSequence) and isinstance(step, int) and step < len(node.items):
        return None, node.items[step]
    entries = node.entries if isinstance(node, PlacedMapping) else ()
    return next(((key.place, value) for key, value in entries if key.text == step), None)


def _is_short(node: PlacedNode) -> bool:
    """Whether a marker is best put at the value itself: a text on one line."""
    return isinstance(node, PlacedScalar) and node.place.text.rstrip()[-1:] not in ("|", ">")
