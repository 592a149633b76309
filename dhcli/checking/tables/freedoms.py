"""The freedom that a right table has used, in the words of somebody who draws frames."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace

from dhcli.algebra.floats import Floats
from dhcli.frozen import frozen
from dhcli.geometry.rigid import Rigid
from dhcli.geometry.vectors import ALONG
from dhcli.kinematics.axes import Point
from dhcli.kinematics.conventions import Convention
from dhcli.kinematics.fold import fold
from dhcli.kinematics.moves import Chain, names
from dhcli.kinematics.same_robot import Match


@frozen
class Drawn:
    """Two tables of the same robot with the same rows, whose frames can be compared one by one.

    Attributes:
        truth: The moves of each row of the right table.
        other: The moves of each row of the answer.
        convention: The convention of both.
        first: Number of the first row.
    """

    truth: tuple[Chain, ...]
    other: tuple[Chain, ...]
    convention: Convention
    first: int


@frozen
class Slack:
    """What counts as no difference: an angle [rad] and a length [m]; and how lengths are told, if not as letters."""

    angle: float
    length: float
    said: Callable[[float], str] | None = None

    def finer(self) -> Slack:
        """A tenth of it, to name what is too small to be seen at first."""
        return replace(self, angle=self.angle / 10, length=self.length / 10)

    def told(self, *lengths: float) -> str:
        """By how much something is shifted; nothing where lengths are letters."""
        if self.said is None:
            return ""
        return " by " + " and ".join(map(self.said, lengths))


def frame_freedoms(drawn: Drawn, match: Match, variables: Sequence[str], point: Point, slack: Slack) -> tuple[str, ...]:
    """How the frames of a right table differ from those of the solution, one by one."""
    apart = list(_apart(drawn, match, variables, point))
    movers = [_mover(chain, variables) for chain in drawn.truth]
    said: list[str] = []
    for index, difference in enumerate(apart):
        number = drawn.first - 1 + index
        row = index if drawn.convention is Convention.STANDARD else index - 1
        mover = movers[row] if 0 <= row < len(movers) else None
        counts = mover is not None and match.senses[list(variables).index(mover)] < 0
        said += _turned(number, difference, mover if counts else None, slack)
    return (*said, *_shifted(drawn, apart, movers, slack))


def joint_freedoms(
    match: Match, variables: Sequence[str], kinds: Sequence[bool], slack: Slack, said: str
) -> tuple[str, ...]:
    """Which joints count from another zero or in the other sense; a sense that has been said is left out."""
    found: list[str] = []
    for name, turns, sense, zero in zip(variables, kinds, match.senses, match.zeros, strict=True):
        if sense < 0 and f"{name} counts the other way" not in said:
            found.append(f"your {name} counts the other way")
        if turns:
            degrees = math.remainder(math.degrees(zero), 360)
            if math.radians(abs(degrees)) > slack.angle:
                found.append(f"your {name} has another zero ({_signed(degrees)})")
        elif abs(zero) > slack.length:
            amount = f" ({slack.said(zero)})" if slack.said else ""
            found.append(f"your {name} has another zero{amount}")
    return tuple(found)


def end_freedoms(name: str, frame: Rigid, slack: Slack) -> tuple[str, ...]:
    """How a base or end frame lies in the solution's, in a few words; nothing if it is the same."""
    shifted = [axis for axis, offset in zip("xyz", frame.offset, strict=True) if abs(offset) > slack.length]
    by = slack.told(*(offset for offset in frame.offset if abs(offset) > slack.length))
    said = []
    if frame.tilt() > slack.angle:
        turns = {axis: frame.angle_about(unit) for axis, unit in ALONG.items()}
        about = [axis for axis, unit in ALONG.items() if abs(frame.turned(unit)["xyz".index(axis)] - 1) <= slack.angle]
        said.append(f"turned by {_signed(math.degrees(turns[about[0]]))} about {about[0]}" if about else "turned")
    if shifted:
        said.append("shifted along " + " and ".join(shifted) + by)
    return (f"your {name} frame is " + " and ".join(said),) if said else ()


def _apart(drawn: Drawn, match: Match, variables: Sequence[str], point: Point) -> Iterator[Rigid]:
    """Each frame of the answer seen from the same frame of the solution, once the robots lie on each other."""
    over = Floats({**point, **dict.fromkeys(variables, 0.0)})
    one = two = Rigid()
    joints = 0
    yield match.maps[0].inverse()
    for right, typed in zip(drawn.truth, drawn.other, strict=True):
        one @= Rigid.of(fold(right, over))
        two @= Rigid.of(fold(typed, over))
        joints += _mover(right, variables) is not None
        yield (match.maps[joints] @ one).inverse() @ two


def _turned(number: int, difference: Rigid, mover: str | None, slack: Slack) -> Iterator[str]:
    up = difference.rows[2][2]
    sideways = math.atan2(difference.rows[1][0], difference.rows[0][0])
    if abs(abs(up) - 1) > slack.angle:
        yield f"your frame {number} is turned"
        return
    if up < 0:
        yield f"your z{number} points the other way" + (f", so {mover} counts the other way" if mover else "")
    if abs(abs(sideways) - math.pi) <= slack.angle:
        yield f"your x{number} points the other way"
    elif abs(sideways) > slack.angle:
        yield f"your x{number} is turned by {_signed(math.degrees(sideways))} about z{number}"


def _shifted(drawn: Drawn, apart: list[Rigid], movers: list[str | None], slack: Slack) -> Iterator[str]:
    """Frames that sit elsewhere; neighbours that have moved together are one split of two lengths d."""
    last = len(apart) - 1
    start: int | None = None
    for index, difference in enumerate([*apart, Rigid()]):
        x, y, z = difference.offset
        number = drawn.first - 1 + index
        sideways = math.hypot(x, y) > slack.length
        along = abs(z) > slack.length and not sideways
        if along and start is None:
            start = index
        if not along and start is not None:
            yield _split(drawn.first, start, index - 1, last, slack.told(apart[start].offset[2]))
            start = None
        if sideways:
            row = index if drawn.convention is Convention.STANDARD else index - 1
            mover = movers[row] if 0 <= row < len(movers) else None
            slides = mover is not None and not _turns(drawn.truth[row], mover)
            yield (
                f"you draw the axis of {mover} elsewhere: of a sliding joint only the direction matters"
                if slides
                else f"your frame {number} sits elsewhere"
            )


def _split(first: int, start: int, end: int, last: int, by: str) -> str:
    if start == 0:
        return f"your frame {first - 1} sits elsewhere along z{first - 1}{by and ',' + by}"
    if end == last:
        return f"your frame {first - 1 + last} sits elsewhere along z{first - 1 + last}{by and ',' + by}"
    return f"you split d{first - 1 + start} and d{first + end} along the parallel axes differently"


def _mover(chain: Chain, variables: Sequence[str]) -> str | None:
    inside = names(chain)
    return next((name for name in variables if name in inside), None)


def _turns(chain: Chain, name: str) -> bool:
    from dhcli.kinematics.moves import angle_names

    return name in angle_names(chain)


def _signed(degrees: float) -> str:
    text = f"{round(degrees, 2) + 0:g}"
    if text in ("180", "-180"):
        return "180°"
    return f"{'' if text.startswith('-') else '+'}{text}°"
