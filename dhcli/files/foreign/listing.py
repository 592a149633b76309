"""A listing of the Robotics Toolbox, in MATLAB or Python: links, a SerialLink or DHRobot; nothing of it is run."""

from __future__ import annotations

import re
from collections.abc import Iterable

from dhcli.errors import FileError, Place, Problem
from dhcli.files.foreign.links import LINK, ORDERS, ToolboxLink, link_of, options
from dhcli.files.foreign.moves import chain_of
from dhcli.files.foreign.rows import Cell, Reader, RowText, Whole, robot_of_rows, scope_of
from dhcli.files.foreign.statements import Call, Statement, calls, elements, split, statements, unbracketed
from dhcli.kinematics.conventions import Convention
from dhcli.kinematics.moves import Chain
from dhcli.kinematics.robot import Robot, Value
from dhcli.notation.names import canonical
from dhcli.notation.parser import RESERVED
from dhcli.notation.quantity import UNITS
from dhcli.regex import regex

MOST_LINKS = 100
_ROBOT = regex(r"\b(SerialLink|DHRobot)\s*\(")
_ASSIGNED = regex(
    r"(?P<target>[A-Za-z]\w*(?:[({\[]\d{1,3}[)}\]])?)(?:\.(?P<key>\w+))?\s*=(?!=)\s*(?P<value>.+)", re.DOTALL
)
_RADIANS = regex(r"\b(?:(?:np|numpy|math)\.)?(?:deg2rad|radians)\(([^()]*)\)")
_MODULE = regex(r"\b(?:np|numpy|math|sp|sympy)\.")
_NAME = regex(r"[A-Za-z]\w*")
_LOOP = regex(r"(?:for|while)\b")
_IN_LOOP = regex(r"\bfor\b.*\bin\b", re.DOTALL)
_CALLED = regex(r"([A-Za-z]\w*)\s*\(")
_KEYS = ("theta", "d", "a", "alpha", "offset", "qlim", "sigma", "mdh")


def read_listing(text: str, source: str, name: str, units: str, *, as_typed: bool = False) -> Robot:
    """A robot from the links of a listing.

    Args:
        text: The listing.
        source: What it is called in errors.
        name: What the robot is called.
        units: Unit of its lengths; metres by default, as the toolbox has it.
        as_typed: Whether 1.5708 stays what it is, and is not taken as 90°.

    Raises:
        FileError: With all that cannot be read.
    """
    return _Listing(source, units, text, as_typed=as_typed).robot(name)


class _Listing:
    """One pass over the statements."""

    def __init__(self, source: str, units: str, text: str, *, as_typed: bool) -> None:
        self.source = source
        self.as_typed = as_typed
        self.units = units
        self.lines = text.split("\n")
        self.links: list[ToolboxLink] = []
        self.order: list[str] | None = None
        self.ends: dict[str, tuple[str, int]] = {}
        self.values: dict[str, Cell] = {}
        self.modified: set[str] = set()
        self.title = ""
        self.problems: list[Problem] = []
        self.loops = False
        for statement in statements(_MODULE.sub("", _RADIANS.sub(r"((\1)*pi/180)", text))):
            self.take(statement)

    def robot(self, name: str) -> Robot:
        links = self.ordered()
        if self.loops:
            self.problems.append(Problem("has a loop, and nothing is run", Place(self.source), "write each link out"))
        if not links:
            self.problems.append(Problem("names no link", Place(self.source), "write L(1) = Link('d', 0.1, 'a', 0.4)"))
        if len(links) > MOST_LINKS:
            self.problems.append(Problem(f"names more than {MOST_LINKS} links", Place(self.source)))
        rows = [self.row(link) for link in links]
        if self.problems:
            raise FileError(self.problems)
        texts = [cell.text for row in rows for cell in row.cells.values()]
        texts += [
            *(cell.text for cell in self.values.values()),
            *self.values,
            *(text for text, _ in self.ends.values()),
        ]
        reader = Reader(scope_of(texts), as_typed=self.as_typed)
        for i, link in enumerate(links, 1):
            unused = link.said.get(link.own, "0")
            if unused.strip("+-.0") and link.own not in rows[i - 1].cells:
                left = f"{link.own} = {unused} of link {i} is left out"
                reader.remarks.append(f"{left}: the toolbox puts the joint's value there")
        limits = {i: pair for i, link in enumerate(links, 1) if (pair := self.limits(reader, link)) is not None}
        whole = Whole(
            name,
            self.title or name,
            f"the listing {self.source}",
            self.convention(links),
            self.end(reader, "base"),
            self.end(reader, "tool"),
            limits,
            self.values,
        )
        return robot_of_rows(reader, rows, whole)

    def take(self, statement: Statement) -> None:
        """Note what a statement says."""
        match = _ASSIGNED.fullmatch(statement.text)
        target, key, value = (
            (match["target"], match["key"] or "", match["value"]) if match else ("", "", statement.text)
        )
        robots = list(calls(value, _ROBOT))
        found = list(calls(value, LINK))
        if len(found) + len(robots) < len(LINK.findall(value)) + len(_ROBOT.findall(value)):
            self.problems.append(Problem("a bracket is never closed", self.place(statement.line)))
        for call in found:
            alone = len(found) == 1 and not robots and call.start == 0
            self.links.append(link_of(call, target if alone else "", self.place(statement.line), self.problems))
        for call in robots:
            self.serial(call, statement)
        self.loops |= _LOOP.match(statement.text) is not None or (bool(found) and _IN_LOOP.search(value) is not None)
        if not match or found or robots:
            return
        if key in ("base", "tool"):
            self.ends[key] = (value, statement.line)
        elif key in _KEYS:
            self.changed(target, key, value, statement)
        elif not key and _NAME.fullmatch(target) and canonical(target) not in UNITS:
            self.values[canonical(target)] = Cell(value.strip(), self.place(statement.line, value.strip()), self.units)

    def serial(self, call: Call, statement: Statement) -> None:
        """What a call of SerialLink says: which links, in which order, its ends, its name."""
        first = call.args[0] if call.args else ""
        inner = unbracketed(first)
        named = elements(inner.replace("\n", " ")) if not LINK.search(first) else []
        if (
            first.startswith("[")
            and not LINK.search(first)
            and (";" in inner or "\n" in inner or not _NAME.match(inner))
        ):
            for row in split(inner, ";\n"):
                said = dict(zip(ORDERS[True], elements(row), strict=False))
                self.links.append(ToolboxLink("", statement.line, {"sigma": "0", **said}))
        elif named and all(_NAME.match(label) for label in named):
            self.order = named
        said = options(call.args[1:], self.place(statement.line), self.problems, ())
        self.title = said.get("name", "").strip("'\"") or self.title
        if "mdh" in said:
            self.modified.add(said["mdh"])
        self.ends |= {end: (said[end], statement.line) for end in ("base", "tool") if end in said}

    def changed(self, target: str, key: str, value: str, statement: Statement) -> None:
        """`L(2).offset = pi/2` behind the link."""
        for link in self.links:
            if link.label and link.label == target:
                link.said[key] = value
                return
        hint = "write it where the link is made: 'offset', pi/2"
        self.problems.append(Problem(f"{target}.{key} is of no link of this listing", self.place(statement.line), hint))

    def ordered(self) -> list[ToolboxLink]:
        """The links of the robot, in its order; of two with the same label the later one."""
        last = {link.label: link for link in self.links if link.label}
        links = [link for link in self.links if not link.label or last[link.label] is link]
        if self.order is None:
            return links
        found: list[ToolboxLink] = []
        for label in self.order:
            own = [
                link for link in links if link.label == label or re.fullmatch(rf"{label}[(\[{{]\d+[)\]}}]", link.label)
            ]
            found += own or [link for link in links if not link.label]
        return found

    def row(self, link: ToolboxLink) -> RowText:
        """A link as a row; the variable's own value is nobody's, unless it is a name."""
        cells: dict[str, Cell] = {}
        for key in ("a", "alpha", "d", "theta", "offset"):
            text = link.said.get(key)
            if text is None or (key == link.own and not self.is_open_name(text)):
                continue
            is_angle = key in ("alpha", "theta") or (key == "offset" and not link.slides)
            place = self.place(link.line, text)
            cells[key] = Cell(self.checked(text, place), place, "rad" if is_angle else self.units)
        return RowText(self.place(link.line), cells, "P" if link.slides else "R")

    def checked(self, text: str, place: Place) -> str:
        """A cell on one line; a call in it is noted, for it would be read as a product."""
        if called := [name for name in _CALLED.findall(text) if name not in RESERVED]:
            self.problems.append(Problem(f"{called[0]}(...) is not read", place, "write the number"))
        return " ".join(text.split())

    def is_open_name(self, text: str) -> bool:
        """Whether a text is a name without a value, such as q1."""
        return _NAME.fullmatch(text.strip()) is not None and canonical(text.strip()) not in {*self.values, "pi"}

    def convention(self, links: Iterable[ToolboxLink]) -> Convention:
        """The convention of all links; the toolbox takes the standard one where nothing is said."""
        said = self.modified or {link.said.get("mdh", "0") for link in links}
        is_modified = {word.strip() in ("1", "true", "True") for word in said}
        if len(is_modified) > 1:
            hint = "keep one of the two"
            raise FileError(Problem("some links are standard and some modified", Place(self.source), hint))
        return Convention.MODIFIED if True in is_modified else Convention.STANDARD

    def limits(self, reader: Reader, link: ToolboxLink) -> tuple[Value, Value] | None:
        """The limits of a joint, `[-160 160]*deg`."""
        text = link.said.get("qlim", "").strip()
        if not text or text in ("[]", "None"):
            return None
        head, _, factor = text.rpartition("]*") if "]*" in text else (text, "", "")
        pair = elements(unbracketed(head + "]" * bool(factor)))
        place = self.place(link.line, text)
        if len(pair) != 2:  # noqa: PLR2004  lowest and highest
            reader.problems.append(Problem("qlim: two values are wanted", place, "write [-160 160]*pi/180"))
            return None
        low, high = (f"({each})*{factor}" if factor else each for each in pair)
        unit = self.units if link.slides else "rad"
        is_angle = not link.slides
        found = [reader.value(Cell(each, place, unit), "qlim", is_angle=is_angle) for each in (low, high)]
        return (found[0], found[1]) if found[0] is not None and found[1] is not None else None

    def end(self, reader: Reader, name: str) -> Chain:
        """The moves of the base or the tool."""
        if name not in self.ends:
            return ()
        text, line = self.ends[name]
        return chain_of(reader, " ".join(text.split()), name, self.place(line, text), self.units)

    def place(self, line: int, text: str = "") -> Place:
        """A line of the listing, and where a text stands in it."""
        whole = self.lines[line - 1]
        column = whole.find(text) + 1
        return Place(self.source, line, column, whole) if column else Place(self.source, line)
