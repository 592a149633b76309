"""What a robot file says of its joints by name: the keys `limits`, `poses` and `called`."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from dhcli.errors import Place, did_you_mean
from dhcli.files.yaml.fields import Fields
from dhcli.files.yaml.placed import PlacedMapping, PlacedNode, PlacedScalar, PlacedSequence, as_text
from dhcli.files.yaml.reader import Reader
from dhcli.files.yaml.typed import has_unit_of_angle
from dhcli.kinematics.derived import Value
from dhcli.notation.angle import Angle
from dhcli.notation.names import canonical

_ANGLE, _LENGTH = "90°", "100 mm"
"""Values that hints show."""


def in_turn(fields: Fields, key: str, variables: Sequence[str]) -> Fields:
    """The fields of a mapping by joint; a list with a list for each joint is that of the variables in their order."""
    node = fields.get(key)
    items = node.items if isinstance(node, PlacedSequence) else ()
    if not items or len(items) != len(variables) or not all(isinstance(item, PlacedSequence) for item in items):
        return fields.mapping(key, example="{theta1: [-160°, 160°]}")
    shown = ", ".join(f"{name}: {as_text(item)}" for name, item in zip(variables, items, strict=True))
    fields.problems.add(fields.place_of(key), f"{key}: should be a mapping, is a list", f"write {{{shown}}}")
    entries = {name: (PlacedScalar(name, item.place), item) for name, item in zip(variables, items, strict=True)}
    return Fields(fields.problems, items[0].place, dict(entries))


class JointValues:
    """Reads them, now that it is known what each joint does."""

    def __init__(
        self,
        turns: Mapping[str, bool | None],
        reader: Reader,
        places: dict[tuple[str | int, ...], Place],
    ) -> None:
        """Take what is known of the joints.

        Args:
            turns: For each variable whether it is an angle; None where nobody knows, for no row moves by it, or it
                stands in one that cannot be read.
            reader: Reads their values.
            places: Where to note the place of each key.
        """
        self.turns = turns
        self.reader = reader
        self.places = places

    def limits(self, fields: Fields) -> dict[str, tuple[Value, Value]]:
        """The lowest and the highest value of joints, as far as they can be read."""
        found = {}
        for key in fields.entries:
            name = self._variable(fields, "limits", key)
            if name is None:
                continue
            turns = self.turns.get(name)
            low = {True: f"-{_ANGLE}", False: "0", None: "lowest"}[turns]
            high = {True: _ANGLE, False: _LENGTH, None: "highest"}[turns]
            before = len(fields.problems.found)
            values = self._list(fields, key, [turns] * 2, f"[{low}, {high}]")
            if values is not None and len(values) != 2:  # noqa: PLR2004  lowest and highest
                fields.problems.add(fields.place_of(key), f"{key}: two values are wanted", f"write [{low}, {high}]")
            if values is not None and len(fields.problems.found) == before:
                found[name] = (values[0], values[1])
        return found

    def called(self, fields: Fields) -> dict[str, str]:
        """What joints are called elsewhere."""
        found = {}
        for key in fields.entries:
            name, scalar = self._variable(fields, "called", key), fields.scalar(key)
            if name is not None and scalar is not None and scalar.text.strip():
                found[name] = scalar.text.strip()
        return found

    def poses(self, fields: Fields) -> dict[str, tuple[Value, ...]]:
        """The values of all joints in each named pose that is a list."""
        found = {}
        for key in fields.entries:
            self.places["poses", key] = fields.place_of(key)
            values = self._list(fields, key, list(self.turns.values()), self._example(fields.get(key)))
            if values is not None:
                found[key] = values
        return found

    def _variable(self, fields: Fields, section: str, key: str) -> str | None:
        """The joint variable that a key means; where there are variables, another key is told, and is None."""
        name = next((name for name in self.turns if canonical(name) == canonical(key)), "")
        if not name and self.turns:
            message = f"{section}: {key} is not a joint variable"
            fields.problems.add(fields.place_of(key), message, did_you_mean(key, self.turns))
            return None
        self.places[section, name or key] = fields.place_of(key)
        return name or key

    def _list(self, fields: Fields, key: str, turns: Sequence[bool | None], example: str) -> tuple[Value, ...] | None:
        """Values of joints, 0 where one cannot be read; None where there is no list."""
        before = len(fields.problems.found)
        nodes = fields.sequence(key, example, count=len(turns))
        if not nodes and len(fields.problems.found) > before:
            return None
        values: list[Value] = []
        for i, node in enumerate(nodes):
            scalar = fields.problems.scalar(node, key)
            is_angle = turns[i] if i < len(turns) else None
            value = None
            if scalar is not None:
                is_angle = has_unit_of_angle(scalar) if is_angle is None else is_angle
                value = self.reader.value(scalar, key, is_angle=is_angle)
            values.append(value if value is not None else Angle())
        return tuple(values)

    def _example(self, node: PlacedNode | None) -> str:
        """A pose as a list: the one that stands there with keys, or any."""
        entries = node.entries if isinstance(node, PlacedMapping) else ()
        there = {canonical(key.text): value.text for key, value in entries if isinstance(value, PlacedScalar)}
        shown = {True: _ANGLE, False: _LENGTH, None: "0"}
        return "[" + ", ".join(there.get(canonical(name), shown[turns]) for name, turns in self.turns.items()) + "]"
