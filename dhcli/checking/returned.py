"""What a question returns: an answer that was read or judged, a step, causes, a drawing."""

from __future__ import annotations

from typing import TYPE_CHECKING, Generic, TypeAlias, TypeVar

from dhcli.algebra.floats import Floats
from dhcli.checking.diagnosis.result import Slip
from dhcli.checking.verdicts import Mark
from dhcli.frozen import frozen
from dhcli.kinematics.robot import Robot
from dhcli.notation.tree import Expr

if TYPE_CHECKING:
    from dhcli.kinematics.values import Values
    from dhcli.scene.traced import Traced

T = TypeVar("T")

Causes: TypeAlias = tuple[tuple[Slip, ...], ...]
"""Slips that give just an answer, one or two together; each cause is enough by itself."""

Rows: TypeAlias = tuple[tuple[Expr | float, ...], ...]
Matrices: TypeAlias = tuple[tuple[tuple[float, ...], ...], ...]
"""A homogeneous matrix at each of some points."""


@frozen
class Reading(Generic[T]):
    """An answer that has been read: the text, and what its kind of question reads in it."""

    text: str
    value: T


@frozen
class Judged(Generic[T]):
    """A mark, with the answer as it was read; None where it cannot be, or is blank."""

    mark: Mark
    reading: Reading[T] | None = None


@frozen
class Shown:
    """One step of a solution.

    Attributes:
        text: What is done, in words; each line on its own.
        rows: The matrix it gives, if it gives one; lengths of numbers in the unit of the sheet.
    """

    text: str
    rows: Rows = ()


@frozen
class Overlaid:
    """An answer as a drawing over the arm that is right.

    Attributes:
        robot: The arm, with the table whose frames are compared.
        traced: The frames of the answer.
        values: The values of all names at which they stand so.
    """

    robot: Robot
    traced: Traced
    values: Values


@frozen
class Points:
    """Values of some names, one set for each point at which something is evaluated."""

    names: frozenset[str]
    at: tuple[Floats, ...]
