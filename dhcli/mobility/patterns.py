"""Linkages in a few letters: `6R`, `RRPRRR`, `loop 6R`, `6-UPS`, `2-PRU+1-PRS`, `ground R crank R rod P ground`.

A pattern is an open chain unless `loop` stands before it: `6R` has 7 links, `loop 6R` has 6. Whoever answers says which
was read and what the other would give. Legs `m-ABC` stand between a ground and a platform.
"""

from __future__ import annotations

from collections.abc import Iterator

from dhcli.errors import DhcliError, Place, Problem
from dhcli.mobility.counting import Counts, counts
from dhcli.mobility.linkage import Joint, Linkage
from dhcli.mobility.pairs import LETTERS, SPATIAL, LinkageError, Pair, Space, pair_of
from dhcli.mobility.scanning import check_count, joint_pieces
from dhcli.notation.brackets import split
from dhcli.notation.parser import parse
from dhcli.notation.tree import Expr, Number, number

MOST_JOINTS = 20_000
"""A pattern with more is a slip of the keyboard."""

_LONGEST_COUNT = 6
_SHOWN = 40
"""Characters of a long text that an error repeats."""

_DIGITS = frozenset("0123456789")
_CLOSED, _OPEN = frozenset({"loop", "closed"}), frozenset({"open", "chain"})
_DASHES = "-\u2010\u2011\u2012\u2013"

EXAMPLES = "6R, RRPRRR, loop 6R, 6-UPS, 2-PRU+1-PRS"


def looks_like_pattern(text: str) -> bool:
    """Whether a text is meant as a pattern: letters of joints and numbers, or legs."""
    heading, rest = _heading(text)
    if heading == "loop":
        return bool(rest)
    squeezed = "".join(rest.split())
    if squeezed and all(character in LETTERS or character in _DIGITS for character in squeezed):
        return squeezed[-1] in LETTERS
    return _leg(_leg_texts(text)[0]) is not None


def read_pattern(text: str, space: Space = SPATIAL) -> Linkage | Counts:
    """Read a pattern.

    Returns:
        The joint graph, or counts where the number of legs is a formula such as `n-RPS`.

    Raises:
        LinkageError: It is no pattern.
    """
    place = Place("pattern", None, 1, text)
    try:
        heading, rest = _heading(text)
        if heading == "loop":
            return _closed(letters(rest), text, space)
        if _leg(_leg_texts(text)[0]) is not None:
            return _legs(text, space)
        return _open(letters(rest), rest, space)
    except DhcliError as error:
        raise type(error)(Problem(p.message, p.place or place, p.hint) for p in error.problems) from None


def letters(text: str) -> tuple[Pair, ...]:
    """`2RP` as three pairs.

    Raises:
        LinkageError: A letter stands for no joint, or there are none.
    """
    found: list[Pair] = []
    text, digits = text.strip(), ""
    for character in text:
        if character in _DIGITS:
            digits += character if len(digits) <= _LONGEST_COUNT else ""
        elif character in LETTERS:
            count = int(digits or 1)
            if count + len(found) > MOST_JOINTS:
                raise LinkageError(f"more than {MOST_JOINTS:,} joints are not read")
            found += [LETTERS[character]] * count
            digits = ""
        elif not character.isspace():
            raise _no_letter(character, text)
    if digits and found:
        raise _no_letter(digits[0], text)
    if not found:
        raise LinkageError("a pattern without a joint", f"write it like {EXAMPLES}")
    return tuple(found)


def _no_letter(character: str, text: str) -> LinkageError:
    known = ", ".join(f"{letter} {pair.name}" for letter, pair in LETTERS.items())
    message = f"'{character}' in '{_short(text)}' is not the letter of a joint"
    return LinkageError(message, f"letters: {known}; write it like {EXAMPLES}")


def _short(text: str) -> str:
    return text if len(text) <= _SHOWN else f"{text[:_SHOWN]}..."


def _heading(text: str) -> tuple[str, str]:
    """`loop`, `open` or nothing, and what stands behind it: `closed loop 6R`, `loop 6R`, `open RRP`."""
    first, _, rest = text.strip().partition(" ")
    word, rest = first.lower(), rest.strip()
    if word == "closed" and rest[:5].lower() == "loop ":
        return "loop", rest[5:].strip()
    if rest and word in _CLOSED:
        return "loop", rest
    return ("open", rest) if rest and word in _OPEN else ("", text)


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
    found = [(pair, count_of(count or "1", place)) for count, pair in joint_pieces(text, place)]
    if not found:
        raise LinkageError(Problem("no joints are given", place, "write 4R, or 3R 1P"))
    return tuple(found)


def count_of(text: str, place: Place | None = None) -> Expr:
    """A count as a number or a formula, by notation's own grammar; a name in it is one letter, with an index or not.

    Raises:
        DhcliError: It is no formula, or holds a word.
    """
    check_count(text, place)
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


def _leg_texts(text: str) -> list[str]:
    """The pieces of `2-PRU+1-PRS`, parted at + and , outside of brackets."""
    return [piece for _, piece in split(text, "+,")]


def _leg(piece: str) -> tuple[str, str] | None:
    """`(n + 1)-UPS` as a count and the letters of one leg; None if it is no leg."""
    piece = piece.strip()
    at = max(piece.rfind(dash) for dash in _DASHES)
    count, leg = piece[:at].strip(), piece[at + 1 :].strip().replace("_", "")
    if at < 1 or not leg or not all(character in LETTERS or character in _DIGITS for character in leg):
        return None
    bracketed = count.startswith("(") and count.find(")") == len(count) - 1
    plain = not any(character.isspace() or character in f"()+{_DASHES}" for character in count)
    return (count, leg) if count and leg[-1] in LETTERS and (bracketed or plain) else None


def _legs(text: str, space: Space) -> Linkage | Counts:
    """`2-PRU+1-PRS`: legs between the ground and a platform."""
    legs: list[tuple[Expr, tuple[Pair, ...]]] = []
    for piece in _leg_texts(text):
        counted = _leg(piece)
        if counted is None:
            raise LinkageError(f"'{_short(piece.strip())}' is not read as legs", "write 6-UPS, or 2-PRU+1-PRS")
        legs.append((count_of(counted[0]), letters(counted[1])))
    if any(not isinstance(count, Number) for count, _ in legs):
        return _symbolic_legs(legs, text, space)
    joints: list[Joint] = []
    number_of_legs = 0
    for count, pairs in legs:
        assert isinstance(count, Number)  # noqa: S101  the others have just been handled
        if count.value.denominator != 1 or not 0 < count.value * len(pairs) <= MOST_JOINTS - len(joints):
            message = f"{_short(str(count))} is not a number of legs"
            raise LinkageError(message, f"write 6-UPS; up to {MOST_JOINTS:,} joints are read")
        for _ in range(int(count.value)):
            number_of_legs += 1
            leg = f"leg{number_of_legs}"
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
