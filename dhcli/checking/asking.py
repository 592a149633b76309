"""How a question is asked, and what is known of it without an exercise."""

from __future__ import annotations

from abc import ABC, abstractmethod
from fractions import Fraction
from typing import TYPE_CHECKING, Any, ClassVar, Protocol, Self

from dhcli.checking.whole import is_closed
from dhcli.errors import Place
from dhcli.kinematics.robot import Robot
from dhcli.notation.scope import Scope

if TYPE_CHECKING:
    from dhcli.mobility.linkage import Linkage


class Besides(Protocol):
    """What an exercise file says of a part besides `ask:`, for the kinds that need more."""

    def texts(self, key: str) -> tuple[str, ...]:
        """A list of texts."""
        ...

    def one_of(self, key: str, count: int) -> int:
        """Which of so many, counted from 1; 1 where it is none, which is told."""
        ...

    def linkage(self, name: str) -> Any:  # noqa: ANN401  a linkage or its counts, of a room that few exercises need
        """The linkage of a name or a pattern; None if there is none, which is told."""
        ...


class Asking(ABC):
    """A kind of question as it is asked; `exercise.Question` adds what is right, and how an answer is judged.

    Attributes:
        words: First words of `ask:` that mean this kind.
        examples: How it is asked, for messages and for people who write exercises.
        keys: Keys of a part that only this kind reads.
        is_explained: Whether a slip is looked for behind a wrong answer.
        is_in_table: Whether the robot's table would give the answer away.
        is_plain: Whether an answer is neither a formula nor a measure, so that a sheet need not say how to write them.
        may_show_frames: Whether frames and lengths in a picture would not give the answer away.
        earns_by_row: Whether the entries of an answer belong together row by row, as those of a table do.
        is_overlaid: Whether an answer can be drawn over the arm.
    """

    __slots__ = ()

    words: ClassVar[tuple[str, ...]] = ()
    examples: ClassVar[tuple[str, ...]] = ()
    keys: ClassVar[tuple[str, ...]] = ()
    is_explained: ClassVar[bool] = True
    is_in_table: ClassVar[bool] = False
    is_plain: ClassVar[bool] = False
    may_show_frames: ClassVar[bool] = False
    earns_by_row: ClassVar[bool] = False
    is_overlaid: ClassVar[bool] = False

    @classmethod
    @abstractmethod
    def asked(cls, text: str, scope: Scope, place: Place | None) -> Self:
        """Read the text that asks it, its first word with it.

        Raises:
            NotationError: It cannot be read.
        """

    def completed(self, _besides: Besides) -> Self:
        """The question with what a file says of it besides `ask:`."""
        return self

    def in_unit(self, _unit: Fraction, _scope: Scope) -> Self:
        """The question with the bare lengths in it in metres, where a sheet is in another unit.

        Args:
            _unit: Metres in a bare length of the sheet.
            _scope: The names that it may use.
        """
        return self

    def check(self, _robot: Robot | None) -> None:  # noqa: B027  most kinds ask nothing of a robot
        """Make sure that a robot has what is asked about.

        Raises:
            DhcliError: There is no robot, or it has no such link, frame or table.
        """

    @property
    def needs_table(self) -> bool:
        """Whether a student looks at the robot's table for it."""
        return False

    @property
    def statements(self) -> tuple[str, ...]:
        """The statements to choose from."""
        return ()

    @property
    def linkage_counted(self) -> Linkage | None:
        """The linkage that it is about, if it is about one."""
        return None

    @property
    def in_rows(self) -> bool:
        """Whether an answer has rows of several entries, between which a blank may stand."""
        return False

    @property
    def has_cosines(self) -> bool:
        """Whether an answer in symbols may have cosines and sines in it."""
        return False

    def is_length(self, _row: int, _column: int) -> bool:
        """Whether an entry of an answer stands for itself; those for which it does not are a direction together."""
        return True

    def is_whole(self, text: str, _blank: tuple[int, int]) -> bool:
        """Whether what was typed so far is plainly complete: its brackets close, and no operand is still to come.

        Args:
            text: What was typed.
            _blank: Rows and columns of the answer, `blank` of a question.
        """
        return is_closed(text)

    @property
    def names(self) -> frozenset[str]:
        """Names that it brings along, besides those of the robot."""
        return frozenset()
