"""DH tables of robot files, as answers that are compared with another robot."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from dhcli.checking.tables.motions import TwoArms
from dhcli.checking.tables.right import RightArm
from dhcli.checking.tables.samples import Values
from dhcli.checking.tolerance import Tolerance
from dhcli.checking.verdicts import Verdict
from dhcli.errors import FileError, Place, Problem
from dhcli.files.foreign.forms import Form, form_of
from dhcli.files.reading import read_text, source_of
from dhcli.files.yaml.placed import PlacedMapping, PlacedNode, PlacedScalar, PlacedSequence, read_yaml
from dhcli.files.yaml.robots import read_robot
from dhcli.frozen import frozen
from dhcli.kinematics.axes import Arm
from dhcli.kinematics.conventions import COLUMNS, Convention
from dhcli.kinematics.forward import put_in
from dhcli.kinematics.moves import Chain
from dhcli.kinematics.robot import Robot
from dhcli.notation.walk import parted, substitute
from dhcli.notation.writer import write, write_angle
from dhcli.regex import regex

_LENGTH = regex(r"[\d.)]\s{0,9}(mm|cm|m|in)\b")
"""The unit of a length behind its number."""


@frozen
class Table:
    """A DH table from a file.

    Attributes:
        convention: Its convention.
        text: Its rows as the text of an answer.
        note: What the file says besides and no table holds; nothing if the other robot has the same.
    """

    convention: Convention
    text: str
    note: str = ""


def read_table(path: Path | str, reference: Robot, text: str | None = None) -> Table:
    """The DH table of a robot file, or in rows as an answer has them, to be compared with another robot.

    Args:
        path: The file.
        reference: The robot it is compared with. A length of the file that this one does not know, or knows with
            another value, is put in as a number; all others stay letters.
        text: The text of the file, where it has been read.

    Raises:
        FileError: It is no robot file, or has products instead of a table.
    """
    text, source = read_text(path) if text is None else text, source_of(path)
    root = read_yaml(text, source, is_foreign=form_of(text) is Form.TABLE)
    if not isinstance(root, PlacedMapping):
        return _plain(root, text, reference)
    robot = read_robot(text, source, "stdin" if str(path) == "-" else Path(path).stem)
    own = {
        name: value
        for name, value in robot.parameters.items()
        if value is not None and (name not in reference.parameters or reference.parameters[name] not in (None, value))
    }
    lengths, angles = parted(own)
    has_units = any(_LENGTH.search(value) for value in _values(root))
    lines = ["a [m], alpha, d [m], theta" if has_units else ", ".join(COLUMNS)]  # bare, it may be meant in mm
    for link in robot.links:
        if link.row is None:
            hint = "convention: standard or modified"
            raise FileError(Problem("has products, not a DH table", Place(str(path)), hint))
        row = link.row
        a, d = (substitute(length, lengths, angles) for length in (row.a, row.d))
        alpha, theta = row.alpha.substitute(angles), row.theta.substitute(angles)
        lines.append(", ".join((write(a), write_angle(alpha), write(d), write_angle(theta))))
    return Table(robot.convention, "\n".join(lines), _besides(robot, reference))


def _plain(root: PlacedNode, text: str, reference: Robot) -> Table:
    """Rows alone: lists, mappings or lines; the convention is that of the other robot, for no row says it."""
    convention = Convention.MODIFIED if reference.convention is Convention.MODIFIED else Convention.STANDARD
    if isinstance(root, PlacedSequence):
        heads: list[str] = []
        for row in root.items:
            if isinstance(row, PlacedMapping):
                heads = [key.text for key, _ in row.entries]
                break
        lines = [", ".join(heads)] if heads else []
        for row in root.items:
            cells = {key.text: value for key, value in row.entries} if isinstance(row, PlacedMapping) else {}
            nodes = [cells[head] for head in heads if head in cells] if heads else [row]
            lines.append(", ".join(cell for node in nodes for cell in _scalars(node)))
        text = "\n".join(lines)
    return Table(convention, text, f"the rows name no convention, and were read as {convention.value} DH")


def _besides(robot: Robot, reference: Robot) -> str:
    """Base and tool, which stand in no table, where they are not those of the other robot."""
    differing = [
        name
        for name, one, other in (("base", robot.base, reference.base), ("tool", robot.tool, reference.tool))
        if not _same(_at_values(one, robot), _at_values(other, reference))
    ]
    if not differing:
        return ""
    named = " and ".join(f"{name}:" for name in differing)
    return f"beside the table: {named} of {robot.name} differs from {reference.name}, and was not compared"


def _same(one: Arm, other: Arm) -> bool:
    exactly = Tolerance(rotation=1e-9, position=1e-9)
    return TwoArms(RightArm(one, Values({}, {})), other, exactly).same_motion.verdict is Verdict.RIGHT


def _at_values(chain: Chain, robot: Robot) -> Arm:
    """Moves that stand still, with the robot's own values in the place of letters."""
    return Arm.of(put_in(chain, robot.known), ())


def _values(root: PlacedNode) -> Iterator[str]:
    """What a robot file writes for its lengths and in its rows."""
    wanted = ("parameters", "links")
    top = root.entries if isinstance(root, PlacedMapping) else ()
    for node in (node for key, node in top if key.text in wanted):
        yield from _scalars(node)


def _scalars(node: PlacedNode) -> Iterator[str]:
    if isinstance(node, PlacedScalar):
        yield node.text
    elif isinstance(node, PlacedSequence):
        for item in node.items:
            yield from _scalars(item)
    elif isinstance(node, PlacedMapping):
        for _, item in node.entries:
            yield from _scalars(item)
