"""What a URDF says, as it stands there: links and joints, every number still the text that was typed."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from xml.parsers import expat

from dhcli.errors import FileError, NotationError, Place, Problem, did_you_mean
from dhcli.files.foreign.forms import Form, form_of, told
from dhcli.frozen import frozen
from dhcli.notation.parser import parse
from dhcli.notation.quantity import DimensionError, to_angle
from dhcli.notation.scope import Scope
from dhcli.regex import regex

DEEPEST = 100
MOST = 20_000
KINDS = ("fixed", "revolute", "continuous", "prismatic")
_OTHERS = ("floating", "planar", "spherical")
_WORDS = {
    "revolute": ("rotational", "rotation", "rotary", "hinge", "pin"),
    "prismatic": ("linear", "slider", "slide", "sliding", "translational"),
    "fixed": ("rigid", "static"),
}
"""What other programs call joints."""
_ZEROS = ("0", "0", "0")
_NUMBER = regex(r"[-+]?[0-9]{0,20}\.[0-9]{1,20}")


@frozen
class Mimic:
    """A joint that follows another: multiplier times its value, and an offset."""

    joint: str
    multiplier: str = "1"
    offset: str = "0"


@dataclass(slots=True)
class Joint:
    """A joint as it stands in the file.

    Attributes:
        name: Its name.
        kind: One of `KINDS`.
        place: Where it begins.
        parent: The link it is on.
        child: The link it moves.
        xyz: Position of its frame in the parent's [m].
        rpy: Roll, pitch, yaw of its frame in the parent's [rad].
        axis: Axis in its own frame.
        limits: Lowest and highest value [rad or m]; None where there are none.
        mimic: The joint that it follows.
    """

    name: str
    kind: str
    place: Place
    parent: str = ""
    child: str = ""
    xyz: tuple[str, ...] = _ZEROS
    rpy: tuple[str, ...] = _ZEROS
    axis: tuple[str, ...] = ("1", "0", "0")
    limits: tuple[str, str] | None = None
    mimic: Mimic | None = None


@dataclass(slots=True)
class Model:
    """A whole URDF: its links, each with its place, and its joints in the order of the file."""

    source: str
    name: str = ""
    links: dict[str, Place] = field(default_factory=dict)
    joints: list[Joint] = field(default_factory=list)


def read_model(text: str, source: str) -> Model:
    """Read the text of a URDF.

    Raises:
        FileError: It is no XML, or no URDF, or has what cannot be read; with its line.
    """
    form = form_of(text)
    if form in (Form.SDF, Form.MJCF):
        raise FileError(told(form, source))
    reader = _Reader(Model(source), text.split("\n"))
    parser = expat.ParserCreate("UTF-8")  # the text was decoded already, whatever its first line says
    parser.StartElementHandler = reader.start
    parser.EndElementHandler = reader.end
    parser.StartDoctypeDeclHandler = reader.doctype
    reader.parser = parser
    try:
        parser.Parse(text.encode("utf-8"), True)  # noqa: FBT003  the last piece
    except expat.ExpatError as error:
        place = Place(source, error.lineno, error.offset + 1)
        said = expat.ErrorString(error.code)
        raise FileError(Problem(f"is no XML: {said}", place, _XML_HINTS.get(said, ""))) from None
    if not reader.path_seen:
        raise FileError(Problem("holds no <robot>", Place(source)))
    if reader.problems:
        raise FileError(reader.problems)
    return reader.model


_EXAMPLES = {"axis": "0 0 1", "rpy": "0 0 1.5708"}
"""Three numbers that stand in the place of others, where they are no lengths."""


def _number_hint(piece: str) -> str:
    """What to write for a piece of text that is no number: a decimal comma, or an angle with π, as one."""
    decimal = piece.replace(",", ".")
    if _NUMBER.fullmatch(decimal):
        return f"write {decimal}"
    try:
        angle = to_angle(parse(piece, Scope()), bare="rad")
    except (NotationError, DimensionError):
        return ""
    return f"write {round(angle.constant(), 12):g}"


_XML_HINTS = {
    "no element found": "is the file cut off? <robot> has no end",
    "unclosed token": "is the file cut off?",
    "mismatched tag": "each <tag> has its </tag>, in turn",
    "not well-formed (invalid token)": "in names and texts & is &amp; and < is &lt;",
}


class _Reader:
    """Takes the tags one by one; of what is wrong and does not stop it, all is told at the end."""

    def __init__(self, model: Model, lines: Sequence[str]) -> None:
        self.model = model
        self.lines = lines
        self.problems: list[Problem] = []
        self.parser: expat.XMLParserType
        self.path: list[str] = []
        self.joint: Joint | None = None
        self.path_seen = False
        self.count = 0

    def doctype(self, *_: object) -> None:
        """No document type, and so no entities: a small file could say a gigabyte with them."""
        self.stop("a DOCTYPE is not read", "delete it; a URDF needs none")

    def start(self, tag: str, attributes: Mapping[str, str]) -> None:
        self.count += 1
        if self.count > MOST or len(self.path) > DEEPEST:
            self.stop(f"more than {MOST:,} tags, or deeper than {DEEPEST}", "is it the right file?")
        if tag.startswith("xacro:") or any("${" in text or "$(" in text for text in attributes.values()):
            self.stop(
                "this is a xacro, a template of a URDF", "write what it makes into a file: xacro arm.xacro > arm.urdf"
            )
        self.path.append(tag.rpartition(":")[2])
        match self.path:
            case ["robot"]:
                self.path_seen = True
                self.model.name = attributes.get("name", "")
            case [_]:
                self.stop(f"<{tag}> is no URDF", "a URDF begins with <robot name=...>")
            case ["robot", "link"]:
                name = self.wanted(attributes, "name", tag)
                if name in self.model.links:
                    self.tell(f"there are two links called {name}")
                self.model.links[name] = self.place()
            case ["robot", "joint"]:
                self.open_joint(attributes)
            case ["robot", "joint", inner] if self.joint is not None:
                self.part(self.joint, inner, attributes)

    def end(self, _tag: str) -> None:
        if self.path == ["robot", "joint"] and self.joint is not None:
            for what in ("parent", "child"):
                if not getattr(self.joint, what):
                    self.tell(f"joint {self.joint.name} has no <{what} link=...>")
            self.model.joints.append(self.joint)
            self.joint = None
        self.path.pop()

    def open_joint(self, attributes: Mapping[str, str]) -> None:
        """A joint begins."""
        name, kind = self.wanted(attributes, "name", "joint"), self.wanted(attributes, "type", "joint")
        if kind not in (*KINDS, *_OTHERS):
            meant = next((own for own, words in _WORDS.items() if kind.lower() in words), "")
            hint = f"write {meant}" if meant else did_you_mean(kind, KINDS)
            self.tell(f"joint {name}: there is no type {kind}", hint)
        if any(joint.name == name for joint in self.model.joints):
            self.tell(f"there are two joints called {name}")
        self.joint = Joint(name, kind, self.place())

    def part(self, joint: Joint, tag: str, attributes: Mapping[str, str]) -> None:
        """A tag within a joint."""
        match tag:
            case "parent":
                joint.parent = self.wanted(attributes, "link", tag)
            case "child":
                joint.child = self.wanted(attributes, "link", tag)
            case "origin":
                joint.xyz = self.three(attributes.get("xyz", "0 0 0"), "xyz")
                joint.rpy = self.three(attributes.get("rpy", "0 0 0"), "rpy")
            case "axis":
                joint.axis = self.three(attributes.get("xyz", "1 0 0"), "axis")
            case "limit" if joint.kind in ("revolute", "prismatic") and {"lower", "upper"} & attributes.keys():
                low, high = attributes.get("lower", "0"), attributes.get("upper", "0")
                self.three(f"{low} {high} 0", "limit")
                joint.limits = low.strip(), high.strip()
            case "mimic":
                multiplier, offset = attributes.get("multiplier", "1"), attributes.get("offset", "0")
                self.three(f"{multiplier} {offset} 0", "mimic")
                joint.mimic = Mimic(self.wanted(attributes, "joint", tag), multiplier.strip(), offset.strip())

    def three(self, text: str, what: str) -> tuple[str, ...]:
        """Three numbers."""
        pieces = tuple(text.split())
        if len(pieces) != 3:  # noqa: PLR2004  x y z
            parted = text.replace(",", " ").replace(";", " ").split()
            shown = " ".join(parted) if len(parted) == 3 else _EXAMPLES.get(what, "0 0 0.1")  # noqa: PLR2004  x y z
            key = what if what in ("xyz", "rpy") else "xyz"
            self.tell(f"{what}: three numbers are wanted, not '{text}'", f'write {key}="{shown}"')
            return _ZEROS
        for piece in pieces:
            try:
                value = float(piece)
            except ValueError:
                value = float("nan")
            if not math.isfinite(value) or "_" in piece:
                self.tell(f"{what}: '{piece}' is no number", _number_hint(piece))
                return _ZEROS
        return pieces

    def wanted(self, attributes: Mapping[str, str], key: str, tag: str) -> str:
        """An attribute that must be there."""
        if not attributes.get(key, "").strip():
            self.stop(f"<{tag}> lacks {key}=...")
        return attributes[key].strip()

    def place(self) -> Place:
        """Where the parser is."""
        line, column = self.parser.CurrentLineNumber, self.parser.CurrentColumnNumber + 1
        return Place(self.model.source, line, column, "".join(self.lines[line - 1 : line]))

    def tell(self, message: str, hint: str = "") -> None:
        """Note what is wrong, and go on."""
        self.problems.append(Problem(message, self.place(), hint))

    def stop(self, message: str, hint: str = "") -> None:
        """Give up."""
        raise FileError([*self.problems, Problem(message, self.place(), hint)])
