"""The columns of poses: matrices, or positions with an orientation beside them, as `fk --rows` says it."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, cast

import numpy as np

from dhcli.errors import FileError, Place, Problem, RobotError
from dhcli.files.rows import INDEX, MATRIX, POSITION, TURNS
from dhcli.files.rows.heads import factor_of, name_and_unit
from dhcli.frozen import frozen
from dhcli.geometry.euler import EulerAngles, Order, RollPitchYaw
from dhcli.geometry.rotations import AxisAngle, Quaternion, RotationVector
from dhcli.kinematics.placement import ORIENTATIONS
from dhcli.regex import regex

if TYPE_CHECKING:
    from numpy.typing import NDArray

_HINT = (
    f"wanted: {','.join(MATRIX)}, or {','.join(POSITION)}, also with an orientation beside it such as "
    f"{','.join(TURNS['quaternion'])} or {','.join(TURNS['rpy'])}, as fk --rows writes them"
)

_A_TURN = 7.0
"""What no angle of an orientation is beyond [rad]; in degrees it is."""

LENGTHS = frozenset(POSITION)
ANGLES = frozenset(
    {"angle"}.union(*(heads for form, heads in TURNS.items() if form not in {"quaternion", "axis-angle"}))
)
"""What of a pose has a unit."""


@frozen
class PoseColumns:
    """How a table holds poses.

    Attributes:
        form: How the orientation is said beside the position; empty where there is none, or where it is a matrix.
        order: For each number of a pose, its column.
        heads: What they are called.
        factors: What makes metres and radians of them: what times they are, and then over what.
        width: How many columns there are, also of what is no pose.
        bare: The columns of angles whose heads have no unit.
    """

    form: str
    order: tuple[int, ...]
    heads: tuple[str, ...]
    factors: tuple[NDArray[np.float64], NDArray[np.float64]]
    width: int
    bare: tuple[int, ...] = ()

    in_radians = ()

    @property
    def names(self) -> dict[int, str]:
        """What each column of a pose is called."""
        return dict(zip(self.order, self.heads, strict=True))

    def values(self, table: NDArray[np.float64]) -> NDArray[np.float64]:
        """Poses, shape (N, 4, 4), or positions (N, 3)."""
        times, over = self.factors
        return posed(self.form, table[:, self.order] * times / over)

    def void(self, table: NDArray[np.float64]) -> tuple[Sequence[int], str]:
        """The rows whose quaternion or axis has no direction, or whose angles are hardly in radians."""
        far = np.abs(table[:, self.bare]) > _A_TURN
        if far.any():
            heads = [self.names[k] for i, k in enumerate(self.bare) if far[:, i].any()]
            said = f"{', '.join(heads)}: more than a turn in radians; in degrees the header says so, {heads[0]}[deg]"
            return np.flatnonzero(far.any(axis=1)).tolist(), said
        parts = directions(self.form, table[:, self.order[len(POSITION) :]])
        none = np.flatnonzero(~parts.any(axis=1)).tolist() if parts.shape[1] else []
        return none, f"{', '.join(TURNS.get(self.form, ()))} are all 0: that is no {self.form}"


@frozen
class PoseTable:
    """What a table of poses is read for.

    Attributes:
        whole: Whether what stands beside a position must be known, so that no orientation is left out unseen.
    """

    whole: bool = True

    wanted = POSITION

    def is_known(self, head: str) -> bool:
        """Whether the head of a column is that of a pose."""
        heads, _ = heads_of([head], [Place("")])
        return heads[0] in _KNOWN

    def in_order(self, _: int, whole: Place) -> PoseColumns:
        """Nothing: what numbers without a header are nobody knows.

        Raises:
            FileError: Always.
        """
        raise FileError(Problem("poses have a header, and this line has numbers", whole, _HINT))

    def columns(self, heads: Sequence[str], places: Sequence[Place], whole: Place) -> PoseColumns:
        """The columns of a table with a header.

        Raises:
            FileError: A column is missing or doubled, has a unit that is none, or says what is not known.
        """
        names, units = heads_of(heads, places)
        form, wanted = "", MATRIX
        if not all(name in names for name in MATRIX):
            form = next((form for form, turns in TURNS.items() if all(name in names for name in turns)), "")
            wanted = (*POSITION, *TURNS.get(form, ()))
        if missing := [name for name in wanted if name not in names]:
            raise FileError(_missing(missing, whole))
        if doubled := [k for k, name in enumerate(names) if name in wanted and name in names[:k]]:
            hint = "keep one of them"
            raise FileError(Problem(f"{names[k]} has two columns", places[k], hint) for k in doubled)
        if self.whole and wanted == POSITION:
            check_alone([name for name in names if name not in POSITION], whole)
        order = tuple(names.index(name) for name in wanted)
        times, over = factors_of(wanted, [units[k] for k in order], [places[k] for k in order])
        bare = tuple(k for k in order if names[k] in ANGLES and not units[k])
        return PoseColumns(form, order, wanted, (times, over), len(heads), bare)


_CALLED = {
    **{name: f"p_{name[-1]}" for axis in "xyz" for name in (axis, f"p{axis}", f"pos_{axis}")},
    **{f"q{part}": f"q_{part}" for part in "wxyz"},
}
"""What others call the same columns."""

_IN_MESSAGE = regex(r"(?:\S{0,80}[./_])?(?P<part>position|orientation)[./_](?P<axis>[wxyz])")
"""A column of a message of ROS, `pose.position.x`."""

_MAKERS = {
    frozenset("abc"): "A, B, C of KUKA are yaw[deg],pitch[deg],roll[deg]",
    frozenset("wpr"): "W, P, R of FANUC are roll[deg],pitch[deg],yaw[deg]",
    frozenset("oat"): "O, A, T of Kawasaki are zyz_1[deg],zyz_2[deg],zyz_3[deg]",
    frozenset(("rx", "ry", "rz")): "rx, ry, rz of Universal Robots are r_x,r_y,r_z, a rotation vector in radians",
    frozenset(("q1", "q2", "q3", "q4")): "q1 to q4 of ABB are q_w,q_x,q_y,q_z",
}
"""What makers call an orientation, and the columns that say the same."""

_KNOWN = frozenset((*MATRIX, *POSITION, *(name for names in TURNS.values() for name in names)))


def _missing(names: Sequence[str], whole: Place) -> Problem:
    return Problem(f"no column is called {', '.join(names)}", whole, _HINT)


def heads_of(cells: Sequence[str], places: Sequence[Place]) -> tuple[list[str], list[str]]:
    """Names and units of columns: `p_x[mm]`; a head that is not read so is the name of what nobody asks for."""
    heads, units = [], []
    for cell, place in zip(cells, places, strict=True):
        try:
            head, unit = name_and_unit(cell, place)
        except RobotError:
            head, unit = cell.strip(), ""
        name = _CALLED.get(head.lower(), head.lower())
        if match := _IN_MESSAGE.fullmatch(name):
            name = f"{'p' if match['part'] == 'position' else 'q'}_{match['axis']}"
        heads.append(name)
        units.append(unit)
    return heads, units


def factors_of(wanted: Sequence[str], units: Sequence[str], places: Sequence[Place]) -> NDArray[np.float64]:
    """What makes metres and radians of the numbers of a row, shape (2, n): what times they are, and then over what.

    Raises:
        FileError: A unit is none, or that of something else.
    """
    factors, problems = [], list[Problem]()
    for head, unit, place in zip(wanted, units, places, strict=True):
        if unit and head not in LENGTHS | ANGLES:
            problems.append(Problem(f"{head} has no unit, and not {unit}", place, f"write {head}"))
            continue
        try:
            factors.append(factor_of(head, unit, place, turns=head in ANGLES))
        except RobotError as error:
            problems += error.problems
    if problems:
        raise FileError(problems)
    return np.array(factors, dtype=np.float64).T


def check_alone(others: Sequence[str], place: Place) -> None:
    """Make sure that nothing beside a position says more of the pose.

    Raises:
        FileError: Something does, and it is not known what.
    """
    if unknown := [head for head in others if head not in (INDEX, "")]:
        known = f"an orientation is {','.join(TURNS['quaternion'])} or {','.join(TURNS['rpy'])} in radians"
        known = next((said for heads, said in _MAKERS.items() if heads <= {*unknown}), known)
        message = f"{', '.join(unknown)} beside a position: that says no orientation that is known"
        raise FileError(Problem(message, place, f"{known}; --task position leaves what else stands there aside"))


def directions(form: str, turns: NDArray[np.float64]) -> NDArray[np.float64]:
    """What of an orientation has a direction, a quaternion or an axis, shape (N, ...); of angles nothing, (N, 0)."""
    return turns[:, : {"quaternion": 4, "axis-angle": 3}.get(form, 0)]


def posed(form: str, numbers: NDArray[np.float64]) -> NDArray[np.float64]:
    """Poses, shape (N, 4, 4), or positions (N, 3), of the numbers of rows.

    Args:
        form: How the orientation is said beside the position; empty where there is none, or where it is a matrix.
        numbers: Shape (N, ...); a position, then the orientation, or three rows of a matrix.
    """
    if numbers.shape[1] == len(POSITION):
        return numbers
    poses = np.tile(np.eye(4), (len(numbers), 1, 1))
    if not form:
        poses[:, :3] = numbers.reshape(-1, 3, 4)
        return poses
    poses[:, :3, 3] = numbers[:, :3]
    for i, row in enumerate(_rotation(form, numbers[:, 3:])):
        for k, entry in enumerate(row):
            poses[:, i, k] = entry
    return poses


def _rotation(form: str, turns: NDArray[np.float64]) -> Sequence[Sequence[NDArray[np.float64]]]:
    if form == "rpy":
        return RollPitchYaw(*turns.T).rotation()
    if form == "rotation-vector":
        return RotationVector(*turns.T).rotation()
    if form == "quaternion":
        return Quaternion(*_units(turns)).rotation()
    if form == "axis-angle":
        x, y, z = _units(turns[:, :3])
        return AxisAngle((x, y, z), turns[:, 3]).rotation()
    a, b, c = turns.T
    return EulerAngles(cast("Order", ORIENTATIONS[form]), (a, b, c)).rotation()


def _units(vectors: NDArray[np.float64]) -> NDArray[np.float64]:
    """The parts of vectors of the length 1 along others, none of them 0; column by column."""
    vectors = vectors / np.abs(vectors).max(axis=1, keepdims=True)  # nothing overflows
    sizes: NDArray[np.float64] = np.linalg.norm(vectors, axis=1, keepdims=True)
    return (vectors / sizes).T
