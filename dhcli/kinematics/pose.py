"""A pose: where one frame is, seen from another."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import field
from typing import TYPE_CHECKING, Any, TypeVar, overload

from dhcli.algebra.arithmetic import plus
from dhcli.errors import RobotError
from dhcli.frozen import frozen
from dhcli.geometry.motion import dot, inverse, product
from dhcli.kinematics.entries import DIGITS
from dhcli.kinematics.given import are_floats, coordinates, float_coordinates, rows_of
from dhcli.kinematics.matrix import Matrix, Rows
from dhcli.notation.styles import THETAS, Joints
from dhcli.notation.tree import Expr

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from dhcli.geometry.euler import EulerAngles, RollPitchYaw
    from dhcli.geometry.motion import Motion
    from dhcli.geometry.rotations import AxisAngle, Quaternion, RotationVector

N = TypeVar("N")


@frozen
class Pose(Matrix[N]):
    """A homogeneous matrix with the names of its two frames.

    Frame letters cancel as in a book: `T_ab @ T_bc` is `T_ac`, and `T_ab @ p_b` is `p_a`.

    Attributes:
        rows: Entries, shape (4, 4), floats or expressions; translation in metres. Lists and arrays are taken too.
        reference: The frame it is seen from.
        frame: The frame it describes.
        title: What it is called where that is more than its frames, such as `A_1` or `Rot(z, theta1)`.
        joints: The robot's joint angles, for shorthand.

    Raises:
        RobotError: The rows are no matrix of that shape, or an entry is neither a number nor an expression.
    """

    rows: tuple[tuple[N, ...], ...]
    reference: str = "0"
    frame: str = "1"
    title: str = ""
    joints: Joints = field(default=THETAS, compare=False, repr=False)

    def __post_init__(self) -> None:
        """Refuse what is no matrix, and make tuples of lists."""
        if not are_floats(self.rows):
            object.__setattr__(self, "rows", rows_of(self.rows))

    @property
    def is_symbolic(self) -> bool:
        """Whether the entries are expressions."""
        return isinstance(self.rows[0][0], Expr)

    @property
    def name(self) -> str:
        """`T_03`, or the title if it has one."""
        return self.title or matrix_name(self.reference, self.frame)

    @property
    def rotation(self) -> tuple[tuple[N, ...], ...]:
        """The direction cosines, shape (3, 3); columns are the axes of the frame described."""
        return tuple(row[:3] for row in self.rows[:3])

    @property
    def position(self) -> tuple[N, N, N]:
        """The origin of the frame described [m]."""
        return self.rows[0][3], self.rows[1][3], self.rows[2][3]

    @property
    def rpy(self) -> RollPitchYaw[float]:
        """Roll, pitch and yaw [rad]: `R = Rz(yaw) Ry(pitch) Rx(roll)`, pitch in [-π/2, π/2].

        At pitch ±π/2 only one of roll and yaw can be told: roll is then 0, and `locked` says so.

        Raises:
            RobotError: An entry holds a symbol; so for the other two.
        """
        from dhcli.geometry.euler import RollPitchYaw

        return RollPitchYaw.of(self.in_numbers().rotation)

    @property
    def quaternion(self) -> Quaternion[float]:
        """The unit quaternion w, x, y, z with w >= 0."""
        from dhcli.geometry.rotations import Quaternion

        return Quaternion.of(self.in_numbers().rotation)

    @property
    def axis_angle(self) -> AxisAngle[float]:
        """One rotation about one unit axis, by an angle in [0, π] [rad]; the axis of no rotation is z."""
        from dhcli.geometry.rotations import AxisAngle

        return AxisAngle.of(self.in_numbers().rotation)

    @property
    def rotation_vector(self) -> RotationVector[float]:
        """The unit axis times the angle [rad]."""
        from dhcli.geometry.rotations import RotationVector

        return RotationVector.of(self.in_numbers().rotation)

    def euler(self, axes: str, *, fixed: bool = False) -> EulerAngles[float]:
        """Three turns about axes in this order, such as `zyz`; `other` of the result is the other triple.

        Args:
            axes: Three of x, y and z, no axis twice in a row.
            fixed: Whether the axes stay where they are; else each turn carries those after it along.

        Raises:
            UnknownNameError: There is no such order.
            RobotError: An entry holds a symbol.
        """
        from dhcli.geometry.euler import euler

        return euler(axes, fixed=fixed).of(self.in_numbers().rotation)

    def _numbers(self) -> Rows[float]:
        return self.in_numbers().rows

    def in_numbers(self) -> Pose[float]:
        """This pose in floats: itself, or what its expressions come to where none holds a symbol.

        Raises:
            RobotError: An entry holds a symbol.
        """
        if not self.is_symbolic:
            return self  # type: ignore[return-value]
        rows = self._floats(self.name, "forward(robot, q) gives numbers, and to_sympy() keeps the symbols")
        return Pose(rows, self.reference, self.frame, self.title, self.joints)

    @overload
    def __matmul__(self, other: Pose[N]) -> Pose[N]: ...
    @overload
    def __matmul__(self, other: NDArray[Any]) -> NDArray[np.float64]: ...
    @overload
    def __matmul__(self, other: Sequence[N | float | str]) -> tuple[N, ...]: ...
    def __matmul__(
        self, other: Pose[N] | Sequence[N | float | str] | NDArray[Any]
    ) -> Pose[N] | tuple[N, ...] | NDArray[np.float64]:
        """Chain two poses, or find where points are.

        Args:
            other: A pose whose reference is this frame; a point of this frame, shape (3,) [m]; or many of them in a
                numpy array, shape (N, 3). For a pose in symbols a coordinate may be text: `(0, 0, "a6")`.

        Returns:
            A pose, or the point seen from the reference, a tuple of 3, or an array of points, shape (N, 3).

        Raises:
            RobotError: The frames do not meet, one of two poses is in symbols, a point has not three coordinates, or
                it is neither a pose nor a point.
            NotationError: A coordinate cannot be read.
        """
        if isinstance(other, Pose):
            if other.reference != self.frame:
                raise RobotError(
                    f"{self.name} ends in frame {self.frame}, {other.name} starts from {other.reference}",
                    "the inner frames of a product must be the same",
                )
            if other.is_symbolic != self.is_symbolic:
                kinds = ("numbers", "symbols") if other.is_symbolic else ("symbols", "numbers")
                message = f"{self.name} is in {kinds[0]}, {other.name} in {kinds[1]}"
                raise RobotError(message, "take both from forward, or both from symbolic")
            return self._with(product(self.rows, other.rows), self.reference, other.frame)
        if getattr(other, "ndim", 1) != 1:
            return self._of_points(other)  # type: ignore[arg-type]
        if not hasattr(other, "__len__"):
            raise RobotError(
                f"{self.name} @ takes a pose or a point, not {other!r:.60}",
                f"{self.name} @ (0, 0, 0.1), or the pose behind",
            )
        if len(other) != 3:  # noqa: PLR2004
            raise RobotError(f"a point has three coordinates, not {len(other)}")
        point: Sequence[N] = coordinates(other) if self.is_symbolic else float_coordinates(other)  # type: ignore[assignment]
        return tuple(plus(dot(row, point), row[3]) for row in self.rows[:3])  # type: ignore[misc]  # no integers in a pose

    def _of_points(self, points: NDArray[Any]) -> NDArray[np.float64]:
        """Where points are, shape (N, 3) [m], given in the frame described, shape (N, 3)."""
        if points.ndim != 2 or points.shape[1] != 3:  # noqa: PLR2004  rows and columns
            hint = "the matrix of a product of numpy arrays is T.matrix @ other"
            raise RobotError(f"points have the shape (N, 3), not {points.shape}", hint)
        matrix = self.matrix
        found: NDArray[np.float64] = points @ matrix[:3, :3].T + matrix[:3, 3]
        return found

    def inverse(self) -> Pose[N]:
        """The reference seen from the frame described."""
        return self._with(inverse(self.rows), self.frame, self.reference)

    def _with(self, motion: Motion[N], reference: str, frame: str) -> Pose[N]:
        """A pose with other rows between other frames."""
        zero = self.rows[3][0]
        rows = [[plus(zero, entry) for entry in row] for row in motion]
        return Pose((*map(tuple, rows), self.rows[3]), reference, frame, "", self.joints)  # type: ignore[arg-type]

    def cells(self, style: str = "short", digits: int = DIGITS) -> tuple[tuple[str, ...], ...]:
        """The entries as text: expressions in a notation, numbers rounded for people."""
        return self._written(self.joints, style, digits)

    def __repr__(self) -> str:
        """The name and the matrix, as a notebook or the prompt shows it."""
        return f"{self.name}:\n{self}"


def matrix_name(reference: str, frame: str) -> str:
    """What the matrix between two frames is called: `T_03`, `T_{base,tool}`."""
    is_short = len(reference) == 1 and len(frame) == 1
    return f"T_{reference}{frame}" if is_short else f"T_{{{reference},{frame}}}"


def computed(rows: tuple[tuple[float, ...], ...], reference: str, frame: str, joints: Joints) -> Pose[float]:
    """A pose of numbers that were just computed, and need no look: to look takes as long as to compute them.

    Args:
        rows: Entries, shape (4, 4), each a float; translation in metres.
        reference: The frame it is seen from.
        frame: The frame it describes.
        joints: The robot's joint angles, for shorthand.
    """
    made: Pose[float] = object.__new__(Pose)
    _PUT(made, "rows", rows)
    _PUT(made, "reference", reference)
    _PUT(made, "frame", frame)
    _PUT(made, "title", "")
    _PUT(made, "joints", joints)
    return made


_PUT = object.__setattr__
