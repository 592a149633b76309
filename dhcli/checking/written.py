"""What an author writes in an exercise besides its questions: printed answers, own tests, ranges, further names."""

from __future__ import annotations

from collections.abc import Iterable

from dhcli.frozen import frozen
from dhcli.kinematics.robot import Robot, Value
from dhcli.notation.names import beside, capital, is_greek, parts, usual_aliases
from dhcli.notation.scope import Scope
from dhcli.regex import regex

_CAPITAL = regex(r"\b[A-Z]\b")
_LINK = regex(r"(?<![^\W\d_])[lL](?:[0-9_]|\b)")
"""A length called l, with an index or without."""
_MAY_BE_CAPITAL = frozenset("abefghijklmnopqrtuvwxyz")
"""Letters whose capital stands for nothing else: C and S are a cosine and a sine, D what books call a long part."""


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


def answer_scope(robot: Robot | None, extra: tuple[str, ...], said: Iterable[str] = ()) -> Scope:
    """The scope of a robot with further names, whose Greek ones are angles; open where there is neither.

    Args:
        robot: The robot, if there is one.
        extra: Further names.
        said: Texts of the task: a capital in them means something of its own, and is not the small letter.
    """
    if robot is None:
        angles = tuple(name for name in extra if is_greek(name))
        lengths = tuple(n for n in extra if n not in angles)
        return Scope(angles=angles, lengths=lengths, aliases=_capitals(extra, said), is_open=not extra)
    own = robot.scope
    more = [name for name in extra if name not in own.names]
    links = beside(_links(own, said), more)
    if not more and not links:
        return own
    return Scope(
        joints=own.joints,
        angles=(*own.angles, *(name for name in more if is_greek(name))),
        lengths=(*own.lengths, *(name for name in more if not is_greek(name))),
        aliases={**links, **_capitals(more, said), **beside(own.aliases, more)},
    )


def _links(own: Scope, said: Iterable[str]) -> dict[str, str]:
    """`l1` and `L1` for a1: where a1, a2, ... have no gap, nothing else their index, and no name or text has an l."""
    indexed = [(name, *parts(name)) for name in own.lengths]
    links = [(index, name) for name, stem, index in indexed if stem == "a" and index]
    counted = [str(k + 1) for k in range(len(links))]
    if sorted(index for _, stem, index in indexed if stem == "a" or index in counted) != counted:
        return {}
    if any(map(_LINK.search, (*own.names, *said))):
        return {}
    return {f"{letter}{index}": name for index, name in links for letter in "lL"}


def _capitals(names: Iterable[str], said: Iterable[str]) -> dict[str, str]:
    """Capital letters that can only mean a name of one small letter: none of a cosine, a sine, or of the texts."""
    spoken = {word for text in said for word in _CAPITAL.findall(text)}
    single = (name for name in names if len(name) == 1 and name in _MAY_BE_CAPITAL)
    return {capital(name): name for name in single if capital(name) not in spoken} | usual_aliases(names)
