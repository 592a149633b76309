"""Robots given by their joint axes, or by their screws and the home pose, in the place of a table."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace

from dhcli.errors import NotationError, Place, Problem, RobotError, are, did_you_mean, plural
from dhcli.files.keys.robots import ROBOTS, SIDES
from dhcli.files.yaml.fields import Fields
from dhcli.files.yaml.joint_values import JointValues
from dhcli.files.yaml.placed import PlacedMapping, PlacedNode, PlacedScalar, PlacedSequence, as_text
from dhcli.files.yaml.robot_loader import Loader
from dhcli.files.yaml.typed import parsed, read_value, read_word
from dhcli.geometry.orthonormal import not_a_rotation
from dhcli.geometry.vectors import ORIGIN, UNITS, Vector, axis_called, length, scaled
from dhcli.kinematics.describe.drawn import Drawing, Frame, Line, drawing_of
from dhcli.kinematics.describe.linear import Form, LettersError, Point, form_of, moved, point_of
from dhcli.kinematics.describe.products import chains_of
from dhcli.kinematics.describe.screws import ScrewAxis, Side, lines_of
from dhcli.kinematics.moves import Chain, Fixed
from dhcli.kinematics.robot import Link, Value
from dhcli.notation.angle import Angle
from dhcli.notation.brackets import split
from dhcli.notation.names import GREEK_NAMES, parts
from dhcli.notation.quantity import DimensionError, to_length
from dhcli.notation.tree import ONE, ZERO, Expr
from dhcli.notation.walk import symbols_in

_OF_AXES = ("through", "slides", "pitch")
_SIX = 6
_LEAST = 1e-9
"""Two points of an axis that are nearer are one [m]."""


def with_semicolons(text: str) -> str:
    """The same text in which a point within braces is one value: `{through: (0; 0; l1)}`; places stay."""
    return "\n".join(_semicolons(line) for line in text.split("\n"))


def _semicolons(line: str) -> str:
    braces = depth = 0
    letters = list(line)
    for i, letter in enumerate(letters):
        if letter == "#" and (i == 0 or letters[i - 1].isspace()):
            break
        braces += (letter == "{") - (letter == "}")
        depth += (letter == "(") - (letter == ")")
        if letter == "," and braces and depth:
            letters[i] = ";"
    return "".join(letters)


class DrawnLoader(Loader):
    """Reads axes or screws; the robot becomes a product of moves whose frames stand as the base in the pose drawn."""

    def __init__(self, root: PlacedNode, name: str, refused: list[Problem], convention: str) -> None:
        """Read the fields that every robot has."""
        super().__init__(root, name, refused, ROBOTS[convention])
        self.given = convention
        self.drawn: dict[str, Value] = {}

    def read_links(self, first: int) -> tuple[Link, ...]:
        """A link for each joint."""
        nodes = self.fields.sequence(self.given)
        if "variables" not in self.fields:
            rows = (node.entries for node in nodes if isinstance(node, PlacedMapping))
            self.take_variables(key.text for row in rows for key, _ in row if key.text not in _OF_AXES)
        end = self.end("end" if self.given == "axes" else "home")
        try:
            lines = self.screw_lines(nodes, end) if self.given == "screws" else tuple(self.axis_lines(nodes))
        except RobotError as error:
            self.problems.found += [replace(p, place=self.fields.place_of(self.given)) for p in error.problems]
            lines = ()
        chains = tuple(chains_of(Drawing(lines, end))) if lines else ()
        for i, node in enumerate(nodes):
            self.places["links", i] = node.place
        if not nodes and self.given in self.fields:
            self.problems.add(self.fields.place_of(self.given), f"{self.given}: a robot has at least one joint")
        return tuple(Link(first + i, chain) for i, chain in enumerate(chains))

    def read_poses(self, values: JointValues) -> dict[str, tuple[Value, ...]]:
        """The named poses, and the one drawn."""
        poses = super().read_poses(values)
        if self.drawn:
            if "drawn" in poses:
                message = "poses: drawn is the name of the pose that `drawn:` gives"
                self.problems.add(self.places["poses", "drawn"], message)
            zeros = {name: ZERO if turns is False else Angle() for name, turns in values.turns.items()}
            poses["drawn"] = tuple(self.drawn.get(name, zeros[name]) for name in self.variables)
        return poses

    def end(self, key: str) -> Frame:
        """The end frame in the pose drawn."""
        chain: Chain = self.chain(key)
        for move in chain:
            if isinstance(move, Fixed) and (fault := not_a_rotation(move.rows)):
                hint = "its first three columns must be perpendicular unit vectors, right-handed"
                self.problems.add(self.fields.place_of(key), f"{key}: {fault}", hint)
                return Frame()
        try:
            return drawing_of(chain, (), {}).end
        except LettersError as error:
            self.problems.add(
                self.fields.place_of(key), f"{key}: {error.problems[0].message}", "lengths may be letters"
            )
            return Frame()

    def row(self, node: PlacedNode, index: int, example: str) -> Fields:
        """The fields of a row; one that is a list alone is that of the variable in its turn."""
        what = f"{self.given}: row {index + 1}"
        if not isinstance(node, PlacedSequence) or not index < len(self.variables):
            return self.problems.mapping(node, what, example=example)
        name = self.variables[index]
        hint = f"write {{{name}: ({as_text(node)[1:-1]})}}"
        self.problems.add(node.place, f"{what}: should be a mapping, is a list", hint)
        return Fields(self.problems, node.place, {name: (PlacedScalar(name, node.place), node)})

    def axis_lines(self, nodes: tuple[PlacedNode, ...]) -> Iterator[Line]:
        """The lines of drawn axes."""
        drawn = self.fields.mapping("drawn")
        for key in drawn.entries:
            scalar = drawn.scalar(key)
            if key not in self.variables:
                self.problems.add(drawn.place_of(key), f"drawn: {key} is not a joint variable")
            elif scalar:
                turns = not self.slides_by_name(key)
                value = read_value(self.problems, scalar, key, is_angle=turns)
                self.drawn[key] = value if value is not None else Angle()
        for i, node in enumerate(nodes):
            fields = self.row(node, i, "{theta1: +z, through: (0, 0, 0)}")
            named = [key for key in fields.entries if key not in _OF_AXES]
            known = [key for key in named if key in self.variables]
            for key in named:
                if key not in self.variables:
                    self.problems.add(
                        fields.place_of(key), f"{key} is not a joint variable", did_you_mean(key, self.variables)
                    )
            if len(known) != 1:
                self.problems.add(
                    node.place,
                    f"axes: row {i + 1} names {plural(len(known), 'joint')}",
                    "write {theta1: +z, through: (0, 0, 0)}",
                )
                continue
            yield self.axis_line(fields, known[0], node.place)

    def axis_line(self, fields: Fields, name: str, place: Place) -> Line:
        """The line of one joint: a direction and a point, or two points."""
        slides = fields.text("slides") == "true" or self.slides_by_name(name)
        node, drawn, pitch = fields.get(name), self.drawn.get(name, ZERO), self.pitch(fields)
        if slides and "pitch" in fields:
            self.problems.add(fields.place_of("pitch"), f"{name} slides only", "a screw turns: leave slides out")
        if isinstance(node, PlacedScalar) and (ends := node.text.split(" to ")) and len(ends) == 2:  # noqa: PLR2004
            start, end = (self.point(replace(node, text=text.strip()), name) for text in ends)
            direction = self.between(start, end, node, name)
            return Line(name, direction, None if slides else start, turns=not slides, drawn=drawn, pitch=pitch)
        if "through" not in fields and not slides:
            message = f"{name} turns about a line, and a point of it is missing"
            self.problems.add(place, message, "write through: (0, 0, 0), or slides: true")
        through = fields.get("through")
        point = self.point(through, "through") if through is not None else {}
        direction = self.direction(node, name)
        return Line(name, direction, None if slides else point, turns=not slides, drawn=drawn, pitch=pitch)

    def between(self, start: Point, end: Point, node: PlacedNode, name: str) -> Vector:
        """The direction from one point of an axis to another."""
        gap = {letter: vector for letter, vector in moved(end, start, -1).items() if length(vector) > _LEAST}
        if not gap:
            if not self.problems.found:
                self.problems.add(
                    node.place, f"{name}: the two points of the axis are one", "write (0, 0, 0) to (0, 0, 1)"
                )
            return UNITS[2]
        if set(gap) - {ONE}:
            letters = ", ".join(str(letter) for letter in gap if letter != ONE)
            message = f"{name}: the direction from one point to the other depends on {letters}"
            self.problems.add(node.place, message, "points an equal way apart, such as (a, 0, 0) to (a, 0, 1)")
            return UNITS[2]
        return scaled(gap[ONE], 1 / length(gap[ONE]))

    def screw_lines(self, nodes: tuple[PlacedNode, ...], home: Frame) -> tuple[Line, ...]:
        """The lines of screws, in the base."""
        side: Side = "body" if read_word(self.fields, "frame", SIDES) == "body" else "space"
        screws = []
        for i, node in enumerate(nodes):
            fields = self.row(node, i, "{theta1: (0, 0, 1, 0, 0, 0)}")
            for key in fields.entries:
                if key not in self.variables:
                    self.problems.add(
                        fields.place_of(key), f"{key} is not a joint variable", did_you_mean(key, self.variables)
                    )
                    continue
                parts_ = self.expressions(fields.get(key), key, _SIX)
                if len(parts_) == _SIX:
                    screws.append(ScrewAxis(key, self.numbers(parts_[:3], fields.get(key), key), point_of(parts_[3:])))
        return lines_of(tuple(screws), home, side)

    def pitch(self, fields: Fields) -> Form:
        """How far a screw goes for each radian; the file says it for one turn."""
        found = self.expressions(fields.get("pitch"), "pitch", 1) if "pitch" in fields else ()
        turn = form_of(found[0]) if found else {}
        return {letter: value / math.tau for letter, value in turn.items()}

    @staticmethod
    def slides_by_name(name: str) -> bool:
        """Whether a variable such as d3 means a length; theta3 and q3 mean angles."""
        stem = parts(name)[0]
        return stem not in GREEK_NAMES | {"q"} and stem == "d"

    def direction(self, node: PlacedNode | None, key: str) -> Vector:
        """`+z`, `-x`, or three numbers, as a unit vector."""
        if isinstance(node, PlacedScalar) and (axis := axis_called(node.text.strip())):
            return axis
        vector = self.numbers(self.expressions(node, key, 3), node, key)
        if not length(vector):
            if node is not None and not self.problems.found:
                self.problems.add(node.place, f"{key}: a direction is not zero", "write +z, -x or (0, 1, 1)")
            return UNITS[2]
        return scaled(vector, 1 / length(vector))

    def point(self, node: PlacedNode, key: str) -> Point:
        """Three lengths, which may be letters."""
        found = self.expressions(node, key, 3)
        return point_of(found) if found else {}

    def numbers(self, exprs: tuple[Expr, ...], node: PlacedNode | None, key: str) -> Vector:
        """Three plain numbers."""
        if free := sorted(symbols_in(exprs)):
            place = self.fields.place if node is None else node.place
            message = f"{key}: a direction cannot depend on {', '.join(free)}"
            self.problems.add(place, message, "lengths may be letters, directions are numbers")
            return UNITS[2]
        vector = point_of(exprs).get(ONE, ORIGIN) if exprs else ORIGIN
        return vector if all(map(math.isfinite, vector)) else UNITS[2]

    def expressions(self, node: PlacedNode | None, key: str, count: int) -> tuple[Expr, ...]:
        """Expressions in brackets or in a list; none if there are not so many."""
        pieces: list[PlacedScalar] = []
        if isinstance(node, PlacedSequence):
            pieces = [scalar for item in node.items if (scalar := self.problems.scalar(item, key)) is not None]
        elif isinstance(node, PlacedScalar):
            inside = node.text.strip().removeprefix("(").removesuffix(")")
            pieces = [PlacedScalar(piece.strip(), node.place) for _, piece in split(inside)]
        if len(pieces) != count or isinstance(node, PlacedMapping):
            place = self.fields.place if node is None else node.place
            meant = pieces[0].text.split() if len(pieces) == 1 else []
            is_meant = len(meant) == count > 1
            wanted = "(0, 0, l1)" if count == 3 else "(0, 0, 1, 0, 0, 0): ω, then v"  # noqa: PLR2004
            self.problems.add(
                place,
                f"{key}: {plural(count, 'value')} {are(count)} wanted, not {len(pieces)}",
                f"write ({', '.join(meant)})" if is_meant else f"write {wanted}",
            )
            if not is_meant:
                return ()
            pieces = [PlacedScalar(text, place) for text in meant]
        found = []
        for piece in pieces:
            try:
                found.append(to_length(parsed(piece, self.scope)))
            except NotationError as error:
                self.problems.take(error)
            except DimensionError as error:
                self.problems.add(piece.place, f"{key}: {error.message}", error.hint)
        return tuple(found) if len(found) == count else ()
