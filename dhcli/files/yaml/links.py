"""The links of a robot file: rows of a table, or products of moves."""

from __future__ import annotations

from collections.abc import Sequence

from dhcli.errors import Place
from dhcli.files.keys.robots import CONVENTIONS
from dhcli.files.keys.shapes import ROW, required
from dhcli.files.yaml.fields import Fields
from dhcli.files.yaml.placed import PlacedMapping, PlacedNode
from dhcli.files.yaml.reader import Reader
from dhcli.files.yaml.slips import row_of
from dhcli.files.yaml.typed import read_moves
from dhcli.kinematics.conventions import COLUMNS, Convention, Row, calibrated_moves, convention_hint, moves_of
from dhcli.kinematics.derived import Value
from dhcli.kinematics.robot import Link
from dhcli.notation.angle import Angle
from dhcli.notation.tree import ZERO, Expr

ANGLES = ("alpha", "theta", "beta")
_ELSEWHERE = {
    "offset": "add it in its cell: theta: theta1 + 90°",
    **dict.fromkeys(("type", "kind", "joint", "sigma"), "a joint turns by a variable in theta, and slides by one in d"),
}
"""What to say of columns of other programs."""
_ROW = "{a: a1, alpha: 90°, d: 0, theta: theta1}"


class Links:
    """Reads them.

    Attributes:
        convention: What the robot is; a product until a table is read.
        columns: The columns of a table, in the order of its first row.
    """

    def __init__(
        self,
        fields: Fields,
        reader: Reader,
        places: dict[tuple[str | int, ...], Place],
        variables: Sequence[str],
    ) -> None:
        """Read from the fields of a file.

        Args:
            fields: Those at its top.
            reader: Reads what stands in the links.
            places: Where to note the place of each link and cell.
            variables: Those that the file lists.
        """
        self.fields = fields
        self.reader = reader
        self.places = places
        self.variables = variables
        self.convention = Convention.PRODUCT
        self.columns: tuple[str, ...] = COLUMNS
        self._has_beta = False

    def read(self, first: int) -> tuple[Link, ...]:
        """The links, numbered from the first."""
        self.convention = _convention(self.fields)
        nodes = self.fields.sequence("links", f"- {self._example}")
        # A calibrated table: its fifth column leaves no table of four, so each row is a product.
        keys = (key.text for node in nodes if isinstance(node, PlacedMapping) for key, _ in node.entries)
        self._has_beta = "beta" in keys
        links = tuple(self._link(node, i, first + i) for i, node in enumerate(nodes))
        if self._has_beta:
            self.convention, self.columns = Convention.PRODUCT, COLUMNS
        return links

    @property
    def _example(self) -> str:
        """How a link is written."""
        return "Rot(z, theta1) * Trans(l1, 0, 0)" if self.convention is Convention.PRODUCT else _ROW

    def _link(self, node: PlacedNode, index: int, number: int) -> Link:
        """A row, or a product."""
        problems = self.fields.problems
        self.places["links", index] = node.place
        if self.convention is Convention.PRODUCT:
            scalar = read_moves(problems, node, "links")
            return Link(number, self.reader.moves(scalar), None, scalar.text) if scalar else Link(number, ())
        if not isinstance(node, PlacedMapping):
            meant, shown = row_of(node, self.variables)
            hint = f"write {shown}, if its cells are these" if shown else ""
            hint = hint or f"write {self._example}, or convention: product for moves"
            problems.add(node.place, f"links: row {index + 1} should be a mapping", hint)
            if not meant.entries:
                return Link(number, ())
            node = meant
        fields = problems.mapping(node, "links", known=(*COLUMNS, "beta"), required=required(ROW), elsewhere=_ELSEWHERE)
        if len(fields.entries) == len(COLUMNS) and index == 0:
            self.columns = tuple(fields.entries)
        cells = {column: self._cell(fields, column, index) for column in COLUMNS}
        a, d = _as_length(cells["a"]), _as_length(cells["d"])
        row = Row(a=a, alpha=_as_angle(cells["alpha"]), d=d, theta=_as_angle(cells["theta"]))
        if not self._has_beta:
            return Link(number, moves_of(row, self.convention), row)
        return Link(number, calibrated_moves(row, _as_angle(self._cell(fields, "beta", index)), self.convention))

    def _cell(self, fields: Fields, column: str, index: int) -> Value:
        """A cell of a row; nothing where it cannot be read."""
        scalar = fields.scalar(column)
        is_angle = column in ANGLES
        value = None
        if scalar is not None:
            self.places["links", index, column] = scalar.place
            value = self.reader.value(scalar, column, is_angle=is_angle, scope=self.reader.scope)
        return value or (Angle() if is_angle else ZERO)


def _convention(fields: Fields) -> Convention:
    """How the links of a file are described; the standard convention where it cannot be read."""
    scalar = fields.scalar("convention")
    if scalar is None:
        return Convention.STANDARD
    try:
        return Convention(scalar.text)
    except ValueError:
        hint = convention_hint(scalar.text, CONVENTIONS)
        fields.problems.add(scalar.place, f"convention: '{scalar.text}' is not known", hint)
        return Convention.STANDARD


def _as_length(value: Value) -> Expr:
    return value if isinstance(value, Expr) else ZERO


def _as_angle(value: Value) -> Angle:
    return value if isinstance(value, Angle) else Angle()
