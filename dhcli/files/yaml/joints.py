"""Joints of linkage files: one by one, in chains, as planar bars with their pins, and as loops of DH rows."""

from __future__ import annotations

from dhcli.errors import DhcliError, NotationError, Place
from dhcli.files.keys.linkages import JOINT, LOOP, LOOP_ROW
from dhcli.files.keys.shapes import names, required
from dhcli.files.yaml.coordinates import Coordinates
from dhcli.files.yaml.fields import Fields, Problems
from dhcli.files.yaml.placed import PlacedNode, PlacedScalar, PlacedSequence
from dhcli.files.yaml.typed import parsed, read_flag, read_word
from dhcli.kinematics.conventions import COLUMNS, TABLES, Convention, Row
from dhcli.mobility.dhloop import joints_of_loop
from dhcli.mobility.linkage import Joint
from dhcli.mobility.pairs import LETTERS, WORDS, LinkageError, Pair, Space, pair_of
from dhcli.mobility.patterns import count_of, read_chain
from dhcli.notation.angle import Angle
from dhcli.notation.brackets import split
from dhcli.notation.quantity import DimensionError, to_angle, to_length
from dhcli.regex import regex

_ARROW = regex(r"\s-{1,9}\s|\s{0,9}(?:-{1,9}>|→)\s*|,\s")
_SHORT = regex(
    r"(?P<a>\S+)\s+(?P<pair>\S+)\s+(?P<b>\S+)(?:\s+at\s+(?P<point>[\[(].*?[\])]|\S+))?(?:\s+(?:about|along)\s+(?P<axis>\S.*))?"
)


def _hint_for_short(text: str) -> str:
    """What to write for a joint on one line that is not read: without arrows, and with the joint between its links."""
    plain = " ".join(_ARROW.sub(" ", text).split())
    if _has_other_order(plain):
        pair, a, *rest = plain.split()
        plain = " ".join((a, pair, *rest))
    if plain != text.strip() and _SHORT.fullmatch(plain):
        return f"write {plain}"
    return "write ground R crank at A, or {type: R, links: [...]}"


def _has_other_order(text: str) -> bool:
    """Whether the joint stands before both links, `R ground crank`, or commas between them."""
    first, second = [*text.split(), "", ""][:2]
    return first.endswith(",") or (first in LETTERS and second not in LETTERS and second.lower() not in WORDS)


def _part(line: PlacedScalar, start: int, end: int) -> PlacedNode:
    """A part of a joint on one line, as YAML would give it by itself: a list where it stands in square brackets."""
    part = PlacedScalar(line.text[start:end], line.place)
    if not (part.text.startswith("[") and part.text.endswith("]")):
        return part
    pieces = ((start + 1 + at, piece) for at, piece in split(part.text[1:-1]))
    return PlacedSequence(
        tuple(PlacedScalar(text.strip(), line.place_of(at + len(text) - len(text.lstrip()))) for at, text in pieces),
        line.place,
    )


class JointReader:
    """Reads the joints of one file, in whichever form they stand.

    Attributes:
        places: Where each joint that was read stands.
        loose: Pins that one bar alone holds, with the name of that bar.
    """

    def __init__(self, fields: Fields, numbers: Coordinates, space: Space, tolerance: float) -> None:
        """Read from the fields of a file.

        Args:
            fields: The whole file.
            numbers: Its names and points.
            space: Where the linkage moves.
            tolerance: Relative error of rounded values, for the closure of a loop of DH rows.
        """
        self.problems: Problems = fields.problems
        self.fields = fields
        self.numbers = numbers
        self.space = space
        self.tolerance = tolerance
        self.places: list[Place] = []
        self.loose: dict[str, str] = {}

    def read(self, form: str) -> list[Joint]:
        """The joints under one of the keys `joints`, `chain`, `bars` and `loop`."""
        return {"joints": self.joints, "chain": self.chain, "bars": self.bars, "loop": self.loop}[form]()

    def joints(self) -> list[Joint]:
        """A list of joints, short or as mappings."""
        found: list[Joint] = []
        for node in self.fields.sequence("joints"):
            number = str(len(found) + 1)
            made = [self.short(node, number)] if isinstance(node, PlacedScalar) else self.joint(node, number)
            self.places += [node.place] * len(made)
            found += made
        return found

    def short(self, scalar: PlacedScalar, number: str) -> Joint:
        """`ground R crank at A`, `ground P slider along x`, `ground R crank at [0, 0, 1] about [1, 0, 1]`."""
        match = _SHORT.fullmatch(scalar.text)
        if match is None or _has_other_order(scalar.text):
            self.problems.add(scalar.place, f"'{scalar.text}' is not read as a joint", _hint_for_short(scalar.text))
            return Joint(LETTERS["R"], ("ground", number), number)
        point, axis = (match[key] and _part(scalar, *match.span(key)) for key in ("point", "axis"))
        pair = self.pair(match["pair"], scalar.place)
        return Joint(
            pair,
            (match["a"], match["b"]),
            number,
            self.numbers.point(point, "point") if point else None,
            self.numbers.direction(axis, "axis") if axis else None,
        )

    def joint(self, node: PlacedNode, number: str) -> list[Joint]:
        """A joint as a mapping; a pin through k links is k - 1 joints."""
        fields = self.problems.mapping(node, "joints", known=names(JOINT), required=required(JOINT))
        before = len(self.problems.found)
        items = fields.sequence("links", "[ground, crank]", are_names=True)
        links = [s.text for item in items if (s := self.problems.scalar(item, "links"))]
        if "links" in fields and len(links) < 2 and len(self.problems.found) == before:  # noqa: PLR2004  two links
            self.problems.add(
                fields.place_of("links"), "links: a joint ties at least two links", "write [ground, crank]"
            )
        pair = self.pair(fields.text("type"), fields.place_of("type")) if "type" in fields else LETTERS["R"]
        name = fields.text("name") or number
        vectors = {key: self.numbers.point(n, key) for key in ("point", "other") if (n := fields.get(key))}
        vectors |= {key: self.numbers.direction(n, key) for key in ("axis", "axis2", "slide") if (n := fields.get(key))}
        pitch, radii = fields.scalar("pitch"), self.radii(fields)
        return [
            Joint(
                pair,
                (links[0], other),
                name if len(links) == 2 else f"{name}.{k}",  # noqa: PLR2004  two links
                pitch=None if pitch is None else self.numbers.number(pitch, "pitch"),
                carrier=fields.text("carrier") or None,
                radii=radii,
                internal=read_flag(fields, "internal"),
                **vectors,
            )
            for k, other in enumerate(links[1:], 1)
        ]

    def chain(self) -> list[Joint]:
        """One chain of links and joints, or several that share links."""
        node = self.fields.get("chain")
        assert node is not None  # noqa: S101  the caller has looked
        items = (node,) if isinstance(node, PlacedScalar) else self.fields.sequence("chain")
        found: list[Joint] = []
        for item in items:
            if (scalar := self.problems.scalar(item, "chain")) is None:
                continue
            try:
                for a, pair, b in read_chain(scalar.text, place=scalar.place):
                    found.append(Joint(pair, (a, b), str(len(found) + 1)))
                    self.places.append(scalar.place)
            except LinkageError as error:
                self.problems.take(error)
        return found

    def bars(self) -> list[Joint]:
        """Bars with their pins; where k bars share a pin there are k - 1 joints."""
        pins: dict[str, list[str]] = {}
        places: dict[str, Place] = {}
        bars = self.fields.mapping("bars")
        if not self.space.is_planar:
            self.problems.add(
                self.fields.place_of("bars"),
                "bars: are pinned together in the plane",
                "say space: planar, or list joints",
            )
        for bar in bars.entries:
            for item in bars.sequence(bar, are_names=True):
                if scalar := self.problems.scalar(item, bar):
                    pins.setdefault(scalar.text, []).append(bar)
                    places.setdefault(scalar.text, scalar.place)
        pinned = {bar for held in pins.values() if len(held) > 1 for bar in held}
        for bar in bars.entries:
            if bar not in pinned:
                self.problems.add(bars.place_of(bar), f"{bar}: shares no pin with another bar")
        found: list[Joint] = []
        self.loose = {pin: held[0] for pin, held in pins.items() if len(held) == 1}
        for pin, held in pins.items():
            if "points" in self.fields:
                self.numbers.point(PlacedScalar(pin, places[pin]), "bars")
            for k, other in enumerate(held[1:], 1):
                name = pin if len(held) == 2 else f"{pin}.{k}"  # noqa: PLR2004  two bars
                found.append(Joint(LETTERS["R"], (held[0], other), name, self.numbers.points.get(pin)))
                self.places.append(places[pin])
        return found

    def pair(self, word: str, place: Place) -> Pair:
        """A kind of joint; a revolute one in the place of what is none."""
        try:
            return pair_of(word)
        except LinkageError as error:
            self.add_at(place, error, "type")
            return LETTERS["R"]

    def radii(self, fields: Fields) -> tuple[float, float] | None:
        """The radii of two wheels."""
        if "radii" not in fields:
            return None
        found = [
            self.numbers.number(s, "radii")
            for item in fields.sequence("radii", count=2)
            if (s := self.problems.scalar(item, "radii"))
        ]
        if len(found) != 2:  # noqa: PLR2004  one for each wheel
            self.problems.add(
                fields.place_of("radii"), "radii: two are wanted, one for each wheel", "write [20 mm, 40 mm]"
            )
            return None
        return found[0], found[1]

    def loop(self) -> list[Joint]:
        """A closed loop of DH rows."""
        fields = self.fields.mapping("loop", known=names(LOOP), required=required(LOOP))
        word = read_word(fields, "convention", TABLES)
        rows = [self.row(node) for node in fields.sequence("rows")]
        self.problems.raise_if_any()
        self.places = [node.place for node in fields.sequence("rows")]
        try:
            return list(joints_of_loop(rows, Convention(word or "standard"), self.numbers.values, self.tolerance))
        except LinkageError as error:
            self.add_at(fields.place_of("rows"), error, "loop")
            return []

    def row(self, node: PlacedNode) -> tuple[Row, Pair]:
        """One row of a DH table, and the kind of its joint."""
        fields = self.problems.mapping(node, "rows", known=names(LOOP_ROW), required=required(LOOP_ROW))
        scope, cells = self.numbers.scope, {}
        for column in COLUMNS:
            scalar = fields.scalar(column)
            if scalar is None:
                continue
            try:
                expr = parsed(scalar, scope)
                cells[column] = to_angle(expr, bare="refuse") if column in ("alpha", "theta") else to_length(expr)
            except NotationError as error:
                self.problems.take(error)
            except DimensionError as error:
                self.problems.add(scalar.place, f"{column}: {error.message}", error.hint)
        joint = fields.scalar("joint")
        pair = self.pair(joint.text, joint.place) if joint else LETTERS["R"]
        if len(cells) < len(COLUMNS):
            return Row(count_of("0"), Angle(), count_of("0"), Angle()), pair
        return Row(**cells), pair  # type: ignore[arg-type]

    def add_at(self, place: Place, error: DhcliError, key: str) -> None:
        """Note the problems of an error, at its own place or else at the one given."""
        for problem in error.problems:
            self.problems.add(problem.place or place, f"{key}: {problem.message}", problem.hint)
