"""Linkages in a few letters: `6R`, `RRPRRR`, `loop 6R`, `6-UPS`, `2-PRU+1-PRS`, `ground R crank R rod P ground`.

A pattern is an open chain unless `loop` stands before it: `6R` has 7 links, `loop 6R` has 6. Whoever answers says which
was read and what the other would give. Legs `m-ABC` stand between a ground and a platform.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from dhcli.errors import DhcliError, Place, Problem
from dhcli.mobility.counting import Counts, counts
from dhcli.mobility.linkage import Joint, Linkage
from dhcli.mobility.pairs import LETTERS, PAIRS, SPATIAL, LinkageError, Pair, Space, pair_of
from dhcli.notation.parser import parse
from dhcli.notation.tree import Expr, Number, number

MOST_JOINTS = 20_000
"""A pattern with more is a slip of the keyboard."""

_LETTERS = "".join(LETTERS)
_RUN = re.compile(rf"\s*(?P<count>\d*)\s*(?P<letter>[{_LETTERS}])", re.ASCII)
_LEG = re.compile(
    rf"\s*(?P<count>[^\s()+-]+|\([^()]*\))\s*[-\u2010-\u2013]\s*(?P<leg>(?:\d*[{_LETTERS}]|_)+)\s*", re.ASCII
)
_LOOP = re.compile(r"\s*(?:closed\s+)?(?:loop|closed)\s+(?P<rest>.+)", re.IGNORECASE)
_OPEN = re.compile(r"\s*(?:open|chain)\s+(?P<rest>.+)", re.IGNORECASE)

EXAMPLES = "6R, RRPRRR, loop 6R, 6-UPS, 2-PRU+1-PRS"


def looks_like_pattern(text: str) -> bool:
    """Whether a text is meant as a pattern: letters of joints and numbers, or legs."""
    if _LOOP.fullmatch(text) or _LEG.match(text):
        return True
    return bool(re.fullmatch(rf"\s*(?:\d*\s*[{_LETTERS}]\s*)+", text, re.ASCII))


def read_pattern(text: str, space: Space = SPATIAL, place: Place | None = None) -> Linkage | Counts:
    """Read a pattern.

    Args:
        text: One of the forms above.
        space: Where the linkage moves.
        place: Where the text stands, for errors.

    Returns:
        The joint graph, or counts where the number of legs is a formula such as `n-RPS`.

    Raises:
        LinkageError: It is no pattern.
    """
    place = place or Place("pattern", None, 1, text)
    try:
        if match := _LOOP.fullmatch(text):
            return _closed(letters(match["rest"]), text, space)
        if _LEG.match(text):
            return _legs(text, space)
        if match := _OPEN.fullmatch(text):
            text = match["rest"]
        return _open(letters(text), text, space)
    except DhcliError as error:
        raise type(error)(Problem(p.message, p.place or place, p.hint) for p in error.problems) from None


def letters(text: str) -> tuple[Pair, ...]:
    """`2RP` as three pairs.

    Raises:
        LinkageError: A letter stands for no joint, or there are none.
    """
    found: list[Pair] = []
    start, text = 0, text.strip()
    while start < len(text):
        match = _RUN.match(text, start)
        if match is None:
            known = ", ".join(f"{letter} {pair.name}" for letter, pair in LETTERS.items())
            raise LinkageError(
                f"'{text[start]}' in '{text}' is not the letter of a joint",
                f"letters: {known}; write it like {EXAMPLES}",
            )
        count = int(match["count"][:6] or 1)
        if count + len(found) > MOST_JOINTS:
            raise LinkageError(f"more than {MOST_JOINTS:,} joints are not read")
        found += [LETTERS[match["letter"]]] * count
        start = match.end()
    if not found:
        raise LinkageError("a pattern without a joint", f"write it like {EXAMPLES}")
    return tuple(found)


def other_reading(linkage: Linkage | Counts) -> Counts | None:
    """The counts of a chain read the other way, closed for open; None if it can be read in one way only."""
    if not isinstance(linkage, Linkage) or not linkage.reading or linkage.loops > 1:
        return None
    own = Counts.of(linkage)
    assert isinstance(own.n, Number)  # noqa: S101  a joint graph has a number of links
    was_open = linkage.loops == 0
    if was_open and len(linkage.joints) < 2:  # noqa: PLR2004  a loop has two joints at least
        return None
    return counts(
        linkage.space,
        own.n + (-1 if was_open else 1),
        [(group.pair, group.count) for group in own.groups],
        linkage.name,
        "closed loop" if was_open else "open chain with the ground",
    )


def read_chain(text: str, ground: str = "ground", place: Place | None = None) -> tuple[tuple[str, Pair, str], ...]:
    """`ground R crank R rod R slider P ground` as links and the joints between them.

    Raises:
        LinkageError: Links and joints do not alternate, or a word between two links is no joint.
    """
    words = text.replace(" - ", " ").split()
    if len(words) < 3 or len(words) % 2 == 0:  # noqa: PLR2004  link, joint, link
        hint = f"write it like {ground} R crank R rod R slider P {ground}"
        raise LinkageError(Problem("links and joints do not alternate", place, hint))
    found = []
    for i in range(0, len(words) - 2, 2):
        try:
            found.append((words[i], pair_of(words[i + 1]), words[i + 2]))
        except LinkageError as error:
            raise LinkageError(Problem(p.message, place, p.hint) for p in error.problems) from None
    return tuple(found)


def joint_counts(text: str, place: Place | None = None) -> tuple[tuple[Pair, Expr], ...]:
    """`4R`, `3R, 1P`, `3*n R + n P` as kinds and numbers.

    Raises:
        LinkageError: A piece does not end in a joint.
    """
    names = "|".join(sorted((pair.name for pair in PAIRS), key=len, reverse=True))
    found: list[tuple[Pair, Expr]] = []
    for piece in re.findall(
        rf"\s*[,+]?\s*((?:[^,A-Z]|\([^()]*\))*?\s*(?:{names}|[{_LETTERS}](?![a-z])))s?(?=\s|$|[,+0-9n(A-Z])|(\S+)", text
    ):
        match = re.fullmatch(rf"(?P<count>.*?)\s*[*·]?\s*(?P<pair>{names}|[{_LETTERS}])", piece[0].strip())
        if match is None:
            raise LinkageError(
                Problem(f"'{(piece[0] or piece[1]).strip()}' is not a number of joints", place, "write 4R, or 3R 1P")
            )
        found.append((pair_of(match["pair"]), count_of(match["count"] or "1", place)))
    if not found:
        raise LinkageError(Problem("no joints are given", place, "write 4R, or 3R 1P"))
    return tuple(found)


def count_of(text: str, place: Place | None = None) -> Expr:
    """A count as a number or a formula, by notation's own grammar."""
    return parse(text, place=place or Place("count", None, 1, text))


def _open(pairs: tuple[Pair, ...], text: str, space: Space) -> Linkage:
    links = ("ground", *(f"{i}" for i in range(1, len(pairs) + 1)))
    return Linkage(
        text.strip(), space, tuple(_row(pairs, links)), "ground", links[-1], reading="open chain with the ground"
    )


def _closed(pairs: tuple[Pair, ...], text: str, space: Space) -> Linkage:
    if len(pairs) < 2:  # noqa: PLR2004  a joint would tie a link to itself
        raise LinkageError("a loop has at least two joints", "write loop 4R")
    links = ("ground", *(f"{i}" for i in range(1, len(pairs))), "ground")
    return Linkage(text.strip(), space, tuple(_row(pairs, links)), "ground", reading="closed loop")


def _row(pairs: tuple[Pair, ...], links: tuple[str, ...], first: str = "") -> Iterator[Joint]:
    for i, pair in enumerate(pairs):
        yield Joint(pair, (links[i], links[i + 1]), f"{first}{i + 1}")


def _legs(text: str, space: Space) -> Linkage | Counts:
    """`2-PRU+1-PRS`: legs between the ground and a platform."""
    legs: list[tuple[Expr, tuple[Pair, ...]]] = []
    for piece in re.split(r"\+(?![^()]*\))|,", text):
        match = _LEG.fullmatch(piece)
        if match is None:
            raise LinkageError(f"'{piece.strip()}' is not read as legs", "write 6-UPS, or 2-PRU+1-PRS")
        legs.append((count_of(match["count"]), letters(match["leg"].replace("_", ""))))
    if any(not isinstance(count, Number) for count, _ in legs):
        return _symbolic_legs(legs, text, space)
    joints: list[Joint] = []
    for count, pairs in legs:
        assert isinstance(count, Number)  # noqa: S101  the others have just been handled
        if count.value.denominator != 1 or not 0 < count.value * len(pairs) <= MOST_JOINTS:
            raise LinkageError(f"{count} is not a number of legs", "write 6-UPS")
        for _ in range(int(count.value)):
            leg = f"leg{len({joint.name.partition('.')[0] for joint in joints}) + 1}"
            inner = (f"{leg}.{i}" for i in range(1, len(pairs)))
            joints += _row(pairs, ("ground", *inner, "platform"), f"{leg}.")
    return Linkage(text.strip(), space, tuple(joints), "ground", "platform", reading="legs between ground and platform")


def _symbolic_legs(legs: list[tuple[Expr, tuple[Pair, ...]]], text: str, space: Space) -> Counts:
    n: Expr = number(2)
    joints: dict[Pair, Expr] = {}
    for count, pairs in legs:
        n = n + count * (len(pairs) - 1)
        for pair in pairs:
            joints[pair] = joints.get(pair, number(0)) + count
    return counts(space, n, joints.items(), text.strip(), "legs between ground and platform")
