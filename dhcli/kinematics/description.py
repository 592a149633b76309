"""What a robot is described by: links, joints, lengths, frames; whether they make one is not asked here."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property
from types import MappingProxyType
from typing import Literal

from dhcli.kinematics.conventions import COLUMNS, Convention, Row
from dhcli.kinematics.derived import Formula, Value
from dhcli.kinematics.moves import Chain, angle_names, expressions
from dhcli.notation.angle import Angle
from dhcli.notation.scope import Scope
from dhcli.notation.styles import Joints
from dhcli.notation.tree import Trig
from dhcli.notation.walk import symbols, walk

Kind = Literal["revolute", "prismatic"]


@dataclass(frozen=True, slots=True)
class Joint:
    """A joint and its variable.

    Attributes:
        name: The variable, such as theta1 or d3.
        kind: Revolute or prismatic, by where the variable stands.
        link: Number of the link it moves.
    """

    name: str
    kind: Kind
    link: int


@dataclass(frozen=True, slots=True)
class Link:
    """One link: the moves from the frame before it to its own.

    Attributes:
        number: Number of the link and of its frame.
        moves: The moves, four for a DH row.
        row: The DH row, or None in a product.
        text: The product as it was written, empty for a DH row.
    """

    number: int
    moves: Chain
    row: Row | None = None
    text: str = ""


@dataclass(frozen=True)
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

    def __post_init__(self) -> None:
        """Let nobody change a mapping in place."""
        for attribute in ("parameters", "limits", "poses", "derived"):
            object.__setattr__(self, attribute, MappingProxyType(dict(getattr(self, attribute))))

    @cached_property
    def joints(self) -> tuple[Joint, ...]:
        """The joints in the order of the variables."""
        found = {}
        for link in self.links:
            turning = angle_names(link.moves)
            for name in (*turning, *(name for expr in expressions(link.moves) for name in symbols(expr))):
                if name in self.variables:
                    found[name] = Joint(name, "revolute" if name in turning else "prismatic", link.number)
        return tuple(found[name] for name in self.variables if name in found)

    @cached_property
    def angles(self) -> frozenset[str]:
        """Every name that stands for an angle."""
        chain = self.chain
        inside = {
            name
            for expr in expressions(chain)
            for node in walk(expr)
            if type(node) is Trig
            for name in node.angle.names
        }
        given = {name for name, value in self.parameters.items() if isinstance(value, Angle)}
        return angle_names(chain) | inside | given

    @cached_property
    def chain(self) -> Chain:
        """All moves from frame `base` to frame `tool`."""
        return (*self.base, *(move for link in self.links for move in link.moves), *self.tool)

    @cached_property
    def scope(self) -> Scope:
        """The names that a text about this robot may use, with q1, q2, ... for its joints."""
        turning = tuple(joint.name for joint in self.joints if joint.kind == "revolute")
        others = [name for name in (*self.variables, *self.parameters) if name not in turning]
        aliases = {f"q{number}": name for number, name in enumerate(self.variables, self.first)}
        return Scope(
            joints=turning,
            angles=tuple(name for name in others if name in self.angles),
            lengths=tuple(name for name in others if name not in self.angles),
            aliases=aliases,
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
