"""Rules about what stands in a file and gets lost: a number sign that begins a comment, a value that nothing uses."""

from __future__ import annotations

from collections.abc import Iterator

from dhcli.checking.exercise import Exercise
from dhcli.errors import did_you_mean
from dhcli.files.yaml.placed import PlacedMapping, PlacedNode, PlacedScalar, PlacedSequence
from dhcli.kinematics.validity import Finding
from dhcli.notation.names import canonical, parts
from dhcli.regex import regex
from dhcli.safe import yaml_scalar

_CUT = regex(r"\s+#\S.*")
"""A comment that begins without a blank, as the number of an exercise does."""
_WORD = regex(r"[^\W\d_]\w*(?:\{[^{}]*\})?")
_VALUES = ("given", "variants")


def findings(root: PlacedNode, exercise: Exercise | None = None) -> Iterator[Finding]:
    """Everything that gets lost in a file.

    Args:
        root: The tree of the file.
        exercise: The exercise that it holds, if it is one.
    """
    for where, scalar in _scalars(root, ()):
        start = (scalar.place.column or 1) - 1
        behind = scalar.place.text[start + len(scalar.text) :]
        if not scalar.quoted and scalar.text and (lost := _CUT.fullmatch(behind)):
            message = f"'{lost[0].strip():.60}' is a comment, and no part of the text"
            hint = f"if it is one: {yaml_scalar(scalar.text + lost[0])}"
            yield Finding(where, message, hint, is_warning=True)
    if exercise is not None:
        yield from _unused(root, exercise)


def _unused(root: PlacedNode, exercise: Exercise) -> Iterator[Finding]:
    """Values given of names like those of the robot that neither it has nor any text of the exercise.

    What a question brings along, such as the rates of joints or the forces on the end, stands in no text.
    """
    robot = exercise.robot
    own = robot.scope.names if robot else ()
    stems = {parts(name)[0] for name in own}
    texts = (scalar.text for where, scalar in _scalars(root, ()) if where[:1] not in {(key,) for key in _VALUES})
    used = {canonical(word) for text in texts for word in _WORD.findall(text)}.union(map(canonical, own))
    for name in exercise.given:
        if canonical(name) not in used and parts(name)[0] in stems:
            hint = did_you_mean(name, own) or "delete it"
            yield Finding(("given", name), f"{name}: nothing uses it", hint, is_warning=True)


def _scalars(node: PlacedNode, where: tuple[str | int, ...]) -> Iterator[tuple[tuple[str | int, ...], PlacedScalar]]:
    """Every text below a node, with its path."""
    if isinstance(node, PlacedScalar):
        yield where, node
    for key, value in node.entries if isinstance(node, PlacedMapping) else ():
        yield from _scalars(value, (*where, key.text))
    for index, item in enumerate(node.items) if isinstance(node, PlacedSequence) else ():
        yield from _scalars(item, (*where, index))
