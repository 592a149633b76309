"""What a robot is described by: links, joints, lengths, frames; whether they make one is not asked here."""

from __future__ import annotations

from collections.abc import Hashable, Iterable, Mapping, Sequence
from dataclasses import field
from functools import cached_property
from pathlib import Path
from typing import Literal

from dhcli.errors import RobotError, plural
from dhcli.frozen import FrozenDict, frozen
from dhcli.kinematics.actuators import Actuators
from dhcli.kinematics.conventions import COLUMNS, Convention, Row, convention_hint
from dhcli.kinematics.derived import Formula, Value
from dhcli.kinematics.given import chain_of, mapping_of, tuple_of, value_of
from dhcli.kinematics.moves import Chain, angle_names, every_angle, names, product_text
from dhcli.notation.angle import Angle
from dhcli.notation.names import usual_aliases
from dhcli.notation.scope import Scope
from dhcli.notation.styles import Joints

Kind = Literal["revolute", "prismatic"]


@frozen
class Joint:
    """A joint and its variable.

    Attributes:
        name: The variable, such as theta1 or d3.
        kind: Revolute or prismatic, by where the variable stands; one that does both, as a screw does, is revolute.
        link: Number of the link it moves, of several the first.
    """

    name: str
    kind: Kind
    link: int


@frozen
class Link:
    """One link: the moves from the frame before it to its own.

    Attributes:
        number: Number of the link and of its frame.
        moves: The moves, four for a DH row.
        row: The DH row, or None in a product.
        text: The product as somebody wrote it, empty where nobody has; links of the same moves are equal all the same.
    """

    number: int
    moves: Chain
    row: Row | None = None
    text: str = field(default="", compare=False)

    @property
    def product(self) -> str:
        """The product as it was written, else as dhcli writes it."""
        return self.text or product_text(self.moves)


@frozen
class Description:
    """A serial robot as somebody describes it, valid or not; its fields are explained at `robot.Robot`."""

    name: str
    title: str
    source: str
    convention: Convention
    variables: tuple[str, ...]
    links: tuple[Link, ...]
    parameters: Mapping[str, Value | None] = field(default_factory=dict)
    base: Chain = ()
    tool: Chain = ()
    first: int = 1
    limits: Mapping[str, tuple[Value, Value]] = field(default_factory=dict)
    poses: Mapping[str, tuple[Value, ...]] = field(default_factory=dict)
    columns: tuple[str, ...] = COLUMNS
    notes: str = ""
    derived: Mapping[str, Formula] = field(default_factory=dict)
    remarks: tuple[str, ...] = ()
    tools: Mapping[str, Chain] = field(default_factory=dict)
    actuators: Actuators | None = None
    drives: Description | None = None
    called: Mapping[str, str] = field(default_factory=dict, compare=False)
    path: Path | None = field(default=None, compare=False)

    def __post_init__(self) -> None:
        """Take what a caller gives as what it plainly means, and let nobody change a mapping in place.

        Raises:
            RobotError: Something is not what it should be, such as a number for a list of moves.
            NotationError: A text among them cannot be read.
        """
        for attribute in ("base", "tool"):
            object.__setattr__(self, attribute, chain_of(getattr(self, attribute), attribute))
        object.__setattr__(self, "variables", tuple_of(self.variables, "variables", 'write ["theta1", "d2"]'))
        object.__setattr__(self, "links", tuple_of(self.links, "links", "each is a Link"))
        _all_are(self.links, Link, "links", "each is a Link with its number and its moves")
        _all_are(self.variables, str, "variables", 'write ["theta1", "d2"]')
        turning = self.turning
        mappings: dict[str, dict[str, object]] = {
            "parameters": {
                name: None if given is None else value_of(given, name, is_angle=name in turning)
                for name, given in mapping_of(self.parameters, "parameters").items()
            },
            "limits": {
                name: _values(given, f"limits.{name}", [name in turning] * 2, 'write ("-90°", "90°")')
                for name, given in mapping_of(self.limits, "limits").items()
            },
            "tools": {name: chain_of(given, name) for name, given in mapping_of(self.tools, "tools").items()},
            "poses": {
                name: _values(given, f"poses.{name}", [joint in turning for joint in self.variables])
                for name, given in mapping_of(self.poses, "poses").items()
            },
        }
        for attribute, mapping in mappings.items():
            object.__setattr__(self, attribute, FrozenDict(mapping))
        object.__setattr__(self, "derived", FrozenDict(mapping_of(self.derived, "derived")))
        object.__setattr__(self, "called", FrozenDict(mapping_of(self.called, "called")))
        object.__setattr__(self, "convention", _convention(self.convention))

    @cached_property
    def recorded(self) -> dict[Hashable, object]:
        """What was worked out for it and may be asked for again; see `dhcli.kinematics.recorded.kept`."""
        return {}

    @cached_property
    def joints(self) -> tuple[Joint, ...]:
        """The joints in the order of the variables."""
        turning = self.turning
        found = {}
        for name in self.variables:
            kind: Kind = "revolute" if name in turning else "prismatic"
            if number := next((link.number for link in self.links if name in self.movers[link.number]), None):
                found[name] = Joint(name, kind, number)
        return tuple(found.values())

    @property
    def known(self) -> dict[str, Value]:
        """Its lengths and constant angles that have a value."""
        return {name: value for name, value in self.parameters.items() if value is not None}

    @cached_property
    def turning(self) -> frozenset[str]:
        """Names that stand inside rotations, and motors that turn behind a ball screw."""
        driven = self.drives.actuators if self.drives is not None else None
        motors = driven.turning.intersection(driven.motors) if driven is not None else frozenset[str]()
        return angle_names(self.chain) | motors

    @cached_property
    def movers(self) -> Mapping[int, frozenset[str]]:
        """The variables that move each link, by its number."""
        return {link.number: names(link.moves).intersection(self.variables) for link in self.links}

    @cached_property
    def angles(self) -> frozenset[str]:
        """Every name that stands for an angle."""
        chain = (*self.chain, *(move for tool in self.tools.values() for move in tool))
        given = {name for name, value in self.parameters.items() if isinstance(value, Angle)}
        return self.turning | every_angle(chain) | given

    @cached_property
    def chain(self) -> Chain:
        """All moves from frame `base` to frame `tool`."""
        return (*self.base, *(move for link in self.links for move in link.moves), *self.tool)

    @cached_property
    def scope(self) -> Scope:
        """The names that a text about this robot may use, with q1, q2, ... for its joints, and other spellings."""
        turning = tuple(joint.name for joint in self.joints if joint.kind == "revolute")
        others = [name for name in (*self.variables, *self.parameters) if name not in turning]
        aliases = {f"q{number}": name for number, name in enumerate(self.variables, self.first)}
        return Scope(
            joints=turning,
            angles=tuple(name for name in others if name in self.angles),
            lengths=tuple(name for name in others if name not in self.angles),
            aliases=usual_aliases((*turning, *others)) | aliases,
        )

    @cached_property
    def writing(self) -> Joints:
        """How its joint angles are written: `c12`, and factors in joint order."""
        return Joints.of(self.variables, self.scope.joints)

    @cached_property
    def frames(self) -> tuple[str, ...]:
        """Names of the frames in order: base, the numbered ones, tool."""
        return ("base", str(self.first - 1), *(str(link.number) for link in self.links), "tool")

    @property
    def pattern(self) -> str:
        """The joints as letters, such as RRP."""
        return "".join(joint.kind[0].upper() for joint in self.joints)


def _values(given: object, part: str, turning: Sequence[bool], hint: str = "") -> tuple[Value, ...]:
    """Values one by one; how many there should be, other rules say, but limits are always two."""
    found = tuple_of(given, part, hint)
    if hint and len(found) != len(turning):
        raise RobotError(f"{part}: {plural(len(found), 'value')}", hint)
    kinds = [*turning, *[False] * len(found)]
    return tuple(value_of(each, part, is_angle=is_angle) for each, is_angle in zip(found, kinds, strict=False))


def _all_are(given: Iterable[object], kind: type, part: str, hint: str) -> None:
    for each in given:
        if not isinstance(each, kind):
            raise RobotError(f"{part}: {each!r:.60} is no {'name' if kind is str else kind.__name__}", hint)


def _convention(given: Convention | str) -> Convention:
    try:
        return Convention(given)
    except ValueError:
        known = [convention.value for convention in Convention]
        raise RobotError(f"convention: {given!r:.60} is not known", convention_hint(str(given), known)) from None
