"""What an author writes in an exercise besides its questions: printed answers, own tests, ranges, further names."""

from __future__ import annotations

from dhcli.frozen import frozen
from dhcli.kinematics.robot import Robot, Value
from dhcli.notation.names import is_greek
from dhcli.notation.scope import Scope


@frozen
class Printed:
    """What a document prints where it answers a part.

    Attributes:
        text: The answer as printed.
        note: What is known about it, such as the row that was lost.
    """

    text: str
    note: str = ""


@frozen
class Trial:
    """A submission that an exercise tests itself with.

    Attributes:
        part: The part it answers.
        answer: The answer; empty if a mistake makes it.
        mistake: The mistake that makes the answer.
        verdict: What it must be judged.
    """

    part: str
    answer: str
    verdict: str
    mistake: str = ""


@frozen
class Range:
    """The values that a name may take.

    Attributes:
        text: As the author wrote it, `20°..70° step 5°`.
        values: All of them, exact, at least one.
    """

    text: str
    values: tuple[Value, ...]


def answer_scope(robot: Robot | None, extra: tuple[str, ...]) -> Scope:
    """The scope of a robot with further names, whose Greek ones are angles; open where there is neither."""
    if robot is None:
        angles = tuple(name for name in extra if is_greek(name))
        return Scope(angles=angles, lengths=tuple(n for n in extra if n not in angles), is_open=not extra)
    own = robot.scope
    more = [name for name in extra if name not in own.names]
    if not more:
        return own
    return Scope(
        joints=own.joints,
        angles=(*own.angles, *(name for name in more if is_greek(name))),
        lengths=(*own.lengths, *(name for name in more if not is_greek(name))),
        aliases=own.aliases,
    )
