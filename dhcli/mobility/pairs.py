"""The pairs that join two links: their letters, their freedoms, and the geometry that each of them needs."""

from __future__ import annotations

import re

from dhcli.errors import DhcliError, did_you_mean
from dhcli.frozen import frozen


class LinkageError(DhcliError):
    """A linkage that cannot exist, a count that makes no sense, or a question that a linkage cannot answer."""


@frozen
class Pair:
    """A kind of joint.

    Attributes:
        name: Its name in files and tables.
        letter: Its letter in patterns such as RRP; empty if it has none.
        spatial: Freedoms f in space; None if there is no such joint in space.
        planar: Freedoms f in the plane; None if there is no such joint in the plane.
        needs: Fields of the joint that give its geometry in space.
        flat_needs: The same in the plane, where a revolute axis is the plane's normal.
        means: What the fields are, for people who write files.
    """

    name: str
    letter: str
    spatial: int | None
    planar: int | None
    needs: tuple[str, ...]
    flat_needs: tuple[str, ...]
    means: str = ""


PAIRS = (
    Pair("fixed", "W", 0, 0, (), (), "a weld: the two links are one"),
    Pair("revolute", "R", 1, 1, ("point", "axis"), ("point",), "a pin: a point on its axis, and the axis"),
    Pair("prismatic", "P", 1, 1, ("axis",), ("axis",), "a slider: its direction"),
    Pair("helical", "H", 1, None, ("point", "axis", "pitch"), (), "a screw: its axis, and the advance of one turn"),
    Pair("cylindrical", "C", 2, None, ("point", "axis"), (), "turns about an axis and slides along it"),
    Pair("universal", "U", 2, None, ("point", "axis", "axis2"), (), "a cross: its centre and both axes"),
    Pair("spherical", "S", 3, None, ("point",), (), "a ball: its centre"),
    Pair("planar", "E", 3, 3, ("axis",), (), "plane on plane: the normal"),
    Pair(
        "slot",
        "",
        2,
        2,
        ("point", "axis", "slide"),
        ("point", "slide"),
        "a pin of the second link in a slot of the first",
    ),
    Pair(
        "cam", "", 5, 2, ("point", "other"), ("point", "other"), "profiles in contact: the centres of curvature of both"
    ),
    Pair(
        "ball-in-tube",
        "",
        4,
        None,
        ("point", "axis"),
        (),
        "a ball of the second link in a tube of the first: the ball's centre, and the tube's direction",
    ),
    Pair(
        "line-contact",
        "",
        4,
        None,
        ("point", "axis", "axis2"),
        (),
        "a cylinder of the second link on a plane of the first: a point on the cylinder's axis, the plane's normal, "
        "and the cylinder's direction",
    ),
    Pair(
        "bar", "", 5, 2, ("point", "other"), ("point", "other"), "two points kept at their distance by a massless rod"
    ),
    Pair(
        "gear",
        "",
        5,
        2,
        ("carrier", "radii"),
        ("carrier", "radii"),
        "meshing wheels: the link that carries both, and the radii",
    ),
    Pair(
        "rolling", "", None, 1, (), ("point", "other", "radii"), "wheels that roll without a carrier: centres and radii"
    ),
)
"""Every kind of joint. Source of the freedoms: Lynch and Park, Modern Robotics, table 2.1."""

LETTERS = {pair.letter: pair for pair in PAIRS if pair.letter}

_OTHER_NAMES = {
    "pin": "revolute", "hinge": "revolute", "turning": "revolute", "slider": "prismatic", "sliding": "prismatic",
    "screw": "helical", "cylinder": "cylindrical", "ball": "spherical", "socket": "spherical",
    "ball and socket": "spherical", "hooke": "universal", "cardan": "universal", "plane": "planar", "weld": "fixed",
    "pin-in-slot": "slot", "pin in slot": "slot", "pin in a slot": "slot", "contact": "cam", "point contact": "cam",
    "point-contact": "cam", "mesh": "gear", "gear mesh": "gear", "rod": "bar", "tube": "ball-in-tube",
    "ball in tube": "ball-in-tube", "ball in a tube": "ball-in-tube", "ball in groove": "ball-in-tube",
    "ball in a groove": "ball-in-tube", "line contact": "line-contact", "line": "line-contact",
}  # fmt: skip
WORDS = {pair.name: pair for pair in PAIRS} | {
    word: next(p for p in PAIRS if p.name == name) for word, name in _OTHER_NAMES.items()
}
"""Every word for a joint, in small letters; some are of several words."""


def pair_of(word: str) -> Pair:
    """A pair by its letter or its name.

    Raises:
        LinkageError: There is no such joint; the hint lists the letters.
    """
    word = word.strip()
    found = LETTERS.get(word.upper() if len(word) == 1 else word) or WORDS.get(word.lower())
    if found is None:
        letters = ", ".join(f"{letter} {pair.name}" for letter, pair in LETTERS.items())
        hint = did_you_mean(word, WORDS) if len(word) > 2 else ""  # noqa: PLR2004  a letter is like nothing
        raise LinkageError(f"there is no joint '{word}'", hint if hint.startswith("did") else f"joints: {letters}")
    return found


@frozen
class Space:
    """Where a linkage moves.

    Attributes:
        lambda_: Freedoms of a free body there, the λ of the formula.
        name: planar, spherical or spatial; empty for a λ given as a bare number.
    """

    lambda_: int
    name: str = ""

    @property
    def is_planar(self) -> bool:
        """Whether joints are those of the plane; so for a bare 3 too, where the counts are the same."""
        return self.name == "planar" or (self.lambda_ == PLANAR.lambda_ and not self.name)

    def freedoms(self, pair: Pair) -> int:
        """The freedoms f that a pair leaves between its links here.

        Raises:
            LinkageError: There is no such joint in this space.
        """
        flat, solid = pair.planar, pair.spatial
        f = flat if self.is_planar and (flat is not None or self.name) else solid
        if f is None and not self.name and self.lambda_ == PLANAR.lambda_:
            f = flat
        if f is None:
            raise LinkageError(
                f"there is no {pair.name} joint {self.where}", f"joints there: {', '.join(self.known())}"
            )
        if self.lambda_ < SPATIAL.lambda_ and not self.is_planar and pair.letter == "":
            f = max(f - (SPATIAL.lambda_ - self.lambda_), 0)
        if f > self.lambda_:
            raise LinkageError(
                f"a {pair.name} joint has {f} freedoms, more than λ = {self.lambda_} leaves to a free body"
            )
        return f

    def constraints(self, pair: Pair) -> int:
        """The constraints C = λ - f of a pair."""
        return self.lambda_ - self.freedoms(pair)

    def known(self) -> tuple[str, ...]:
        """The joints that there are here."""
        return tuple(pair.name for pair in PAIRS if (pair.planar if self.is_planar else pair.spatial) is not None)

    @property
    def where(self) -> str:
        """`in the plane`, `in space`, ..., for sentences."""
        words = {"planar": "in the plane", "spherical": "on the sphere", "spatial": "in space"}
        return words.get(self.name, f"for λ = {self.lambda_}")

    def __str__(self) -> str:
        """`planar`, or `λ = 4`."""
        return self.name or f"λ = {self.lambda_}"


PLANAR, SPHERICAL, SPATIAL = Space(3, "planar"), Space(3, "spherical"), Space(6, "spatial")
SPACES = {space.name: space for space in (PLANAR, SPHERICAL, SPATIAL)}
_CALLED = {"planar": ("plane", "2d", "flat"), "spherical": ("sphere",), "spatial": ("space", "3d", "general")}


def space_of(text: str) -> Space:
    """A space by name, or λ as a number from 1 to 6.

    Raises:
        LinkageError: It is neither.
    """
    word = text.strip().lower()
    if word in SPACES:
        return SPACES[word]
    if re.fullmatch("[1-6]", word, re.ASCII):
        return SPATIAL if word == "6" else Space(int(word))
    if re.fullmatch(r"[+-]?\d+", word, re.ASCII):
        hint = "a free body has 3 freedoms in the plane, 6 in space"
        raise LinkageError(f"λ = {word} is not possible; it is 1 to 6", hint)
    meant = next((name for name, words in _CALLED.items() if word in words), "")
    hint = f"write {meant}" if meant else "planar, spherical, spatial, or λ from 1 to 6"
    raise LinkageError(f"there is no space '{text.strip()}'", hint)
