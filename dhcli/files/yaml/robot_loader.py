"""The fields of a robot file, read one after another with every problem at once."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from typing import Any

from dhcli.errors import FileError, Place, Problem
from dhcli.files.keys.robots import TABLE, UNITS
from dhcli.files.keys.shapes import Key, required
from dhcli.files.keys.shapes import names as names_of
from dhcli.files.yaml.drives import read_drives
from dhcli.files.yaml.fields import Problems
from dhcli.files.yaml.joint_values import JointValues, in_turn
from dhcli.files.yaml.links import Links
from dhcli.files.yaml.parameters import Parameters
from dhcli.files.yaml.placed import PlacedMapping, PlacedNode, PlacedScalar, PlacedSequence
from dhcli.files.yaml.reader import Reader
from dhcli.files.yaml.typed import read_flag, read_moves, read_whole, read_word
from dhcli.kinematics.description import Description
from dhcli.kinematics.moves import Chain, every_angle, names
from dhcli.kinematics.robot import Link, Robot, Value
from dhcli.kinematics.validity import Finding, InvalidRobotError, findings
from dhcli.notation.names import canonical
from dhcli.notation.scope import Scope

_POSES = "{home: [0, 90°, 100 mm]}"
_BY_ROW = "whether it turns or slides is said by the row in which it stands"
MOVING = ("links", "axes", "screws", "end", "home", "base", "tool", "tools")
"""Keys under which names of parameters are used."""


class Loader:
    """One pass over a file; what is wrong is collected, and something harmless taken in its place."""

    def __init__(
        self,
        root: PlacedNode,
        name: str,
        refused: list[Problem],
        keys: Sequence[Key] = TABLE,
    ) -> None:
        """Read what every robot has; the keys differ with what stands in the place of links."""
        self.problems = Problems(refused)
        self.name = name
        self.fields = self.problems.document(root, known=names_of(keys), required=required(keys))
        self.places: dict[tuple[str | int, ...], Place] = {}
        self.variables = tuple(self.names("variables", self.fields.sequence("variables", are_names=True)))
        self.parameters = self.fields.mapping("parameters", example="{a1: 300 mm, a2: 0.2 m}")
        if not self.parameters.entries:  # a list of names, which is told, leaves their values open
            listed = [item for item in _items(self.fields.get("parameters")) if isinstance(item, PlacedScalar)]
            open_ = {item.text: (item, PlacedScalar("", item.place)) for item in listed}
            self.parameters = replace(self.parameters, entries=dict(open_))
        known = (*self.variables, *self.parameters.entries)
        self.scope = Scope(lengths=known, is_open="variables" not in self.fields)
        keeps_digits = "exact" in self.fields and not read_flag(self.fields, "exact")
        self.reader = Reader(
            self.problems, self.scope, None if keeps_digits else [], read_word(self.fields, "units", UNITS)
        )
        self.links = Links(self.fields, self.reader, self.places, self.variables)
        self.clear: frozenset[str] = frozenset()
        self.doubtful: frozenset[str] = frozenset()

    def robot(self) -> Robot:
        """The robot, or all that is wrong."""
        found = self.so_far()
        self.problems.raise_if_any(FileError)
        assert isinstance(found, Robot)  # noqa: S101  else the rules it breaks were raised
        return found

    def so_far(self) -> Description:
        """The robot, or what can be read of it where something is wrong, which is noted."""
        parts = self.parts()
        found: Description
        try:
            found = Robot(**parts)
        except InvalidRobotError:
            found = Description(**parts)
            for finding in findings(found, self.doubtful):
                self.problems.add(self.place_of(finding), self.key_of(finding) + finding.message, finding.hint)
        is_known = self.variables and not self.doubtful
        driven = read_drives(self.fields, found, self.reader.unit) if is_known and "actuators" in self.fields else None
        return found if driven is None else replace(found, actuators=driven)

    def parts(self) -> dict[str, Any]:
        """The fields of the robot."""
        first = self.read_first()
        before = len(self.problems.found)
        links = self.read_links(first)
        is_broken = len(self.problems.found) > before or not {"convention", "links"} <= self.fields.entries.keys()
        if "variables" not in self.fields:
            self.take_variables(self.moving(links))
        movers = [name for link in links for name in names(link.moves)]
        idle = frozenset(self.variables).difference(movers)
        # Of one that moves two rows while another moves none nobody knows which of them is meant.
        self.clear = frozenset(name for name in movers if not idle or movers.count(name) == 1)
        self.doubtful = idle if is_broken else frozenset()
        base, tool = self.chain("base"), self.chain("tool")
        tools = self.read_tools()
        chain = (*base, *(move for link in links for move in link.moves), *tool)
        chain += tuple(move for moves in tools.values() for move in moves)
        angles = every_angle(chain)
        reader = Parameters(self.parameters, self.reader)
        parameters = reader.read(lambda key: self.is_angle(key, angles))
        turns = {name: name in angles if name in self.clear else None for name in self.variables}
        values = JointValues(turns, self.reader, self.places)
        if not links and isinstance(self.fields.get("links"), PlacedSequence):
            self.problems.add(self.fields.place_of("links"), "links: a robot has at least one link")
        return {
            "name": self.name,
            "convention": self.links.convention,
            "variables": self.variables,
            "links": links,
            "parameters": parameters,
            "base": base,
            "tool": tool,
            "tools": tools,
            "first": first,
            "limits": values.limits(in_turn(self.fields, "limits", self.variables)),
            "poses": self.read_poses(values),
            "called": values.called(self.fields.mapping("called", example="{theta1: shoulder_pan_joint}")),
            "columns": self.links.columns,
            "derived": reader.formulas,
            "remarks": tuple(dict.fromkeys(self.reader.remarks or ())),
            **{key: self.fields.text(key) for key in ("title", "source", "notes")},
        }

    def read_links(self, first: int) -> tuple[Link, ...]:
        """The rows, or the products."""
        return self.links.read(first)

    def read_poses(self, values: JointValues) -> dict[str, tuple[Value, ...]]:
        """The named poses."""
        return values.poses(self.fields.mapping("poses", example=_POSES))

    def moving(self, links: Sequence[Link]) -> Iterable[str]:
        """The names that the links move by and nobody has declared, where a file does not list its variables."""
        return (name for link in links for name in sorted(names(link.moves)))

    def take_variables(self, found: Iterable[str]) -> None:
        """Take names for the variables that a file does not list, and show how it would."""
        self.variables = tuple(dict.fromkeys(name for name in found if name not in self.parameters))
        for k, problem in enumerate(self.problems.found):
            if self.variables and problem.message == "variables: is missing":
                self.problems.found[k] = replace(problem, hint=f"variables: [{', '.join(self.variables)}]")

    def read_tools(self) -> dict[str, Chain]:
        """The tools by name."""
        fields = self.fields.mapping("tools", example="gripper: Trans(0, 0, 0.1)")
        found: dict[str, Chain] = {}
        for key in fields.entries:
            self.places["tools", key] = fields.place_of(key)
            scalar = read_moves(self.problems, fields.entries[key][1], key)
            found[key] = () if scalar is None else self.reader.moves(scalar)
        return found

    def read_first(self) -> int:
        """The number of the first link."""
        scalar = self.fields.scalar("first")
        if scalar is None:
            return 1
        first = read_whole(self.fields, "first")
        if first == 0:
            self.problems.add(scalar.place, "first: links are numbered from 1")
        return first or 1

    def names(self, section: str, nodes: Iterable[PlacedNode]) -> Iterable[str]:
        """The names in a list, their places kept."""
        for i, node in enumerate(nodes):
            self.places[section, i] = node.place
            if isinstance(node, PlacedMapping) and len(node.entries) == 1:
                name = node.entries[0][0]
                self.problems.add(node.place, f"{section}: a name stands alone", f"write {name.text}; {_BY_ROW}")
                yield name.text
            elif (scalar := self.problems.scalar(node, section)) is not None:
                yield scalar.text

    def chain(self, key: str) -> Chain:
        """The product under a key."""
        node = self.fields.get(key)
        scalar = None if node is None else read_moves(self.problems, node, key)
        if scalar is None:
            return ()
        self.places[(key,)] = scalar.place
        return self.reader.moves(scalar)

    def is_angle(self, key: str, angles: frozenset[str]) -> bool | None:
        """Whether a parameter is an angle, by where it stands; None if it stands nowhere."""
        self.places["parameters", key] = self.parameters.place_of(key)
        if any(canonical(key) == canonical(name) for name in angles):
            return True
        return False if self.is_used(key) else None

    def is_used(self, key: str) -> bool:
        """Whether a name stands anywhere among the links, or what else moves."""
        return any(key in _texts(node) for where in MOVING if (node := self.fields.get(where)) is not None)

    def place_of(self, finding: Finding) -> Place:
        """Where a rule was broken, as near as the file can tell."""
        for length in range(len(finding.where), 0, -1):
            place = self.places.get(finding.where[:length])
            if place is not None:
                return place
        return self.fields.place

    def key_of(self, finding: Finding) -> str:
        """What the message about a broken rule begins with."""
        last = finding.where[-1]
        return f"{last}: " if isinstance(last, str) else f"{finding.where[0]}: "


def _items(node: PlacedNode | None) -> Sequence[PlacedNode]:
    return node.items if isinstance(node, PlacedSequence) else ()


def _texts(node: PlacedNode) -> str:
    """All that is written below a node."""
    if isinstance(node, PlacedScalar):
        return node.text
    if isinstance(node, PlacedMapping):
        return " ".join(_texts(value) for _, value in node.entries)
    return " ".join(_texts(item) for item in node.items)
