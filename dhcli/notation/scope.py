"""Which names a text may use, and what shorthand such as `c12` or `sθ_1` stands for among them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import field

from dhcli.frozen import frozen
from dhcli.notation.angle import Angle
from dhcli.notation.names import GREEK_NAMES, canonical, is_greek, parts
from dhcli.notation.tree import Expr, Symbol, Trig
from dhcli.notation.trig import cosine, sine
from dhcli.regex import regex

LONGEST_WORD = 200

_INITIALS = {"a": "alpha", "b": "beta", "g": "gamma"}
"""Letters behind c and s for Greek ones that a keyboard lacks, where nothing has their name."""

_SIGNED = regex(r"\d(?:[+-]\d){1,8}")
_TERM = regex(r"([+-]?)(\d)")

MOST_READ = 10_000
"""Words whose readings are remembered: a scope may live as long as the answers of a whole class are marked."""

MOST_KEPT = 2_000
"""Functions and cells that are remembered as well."""


@frozen
class Scope:
    """The names that mean something in a text.

    Attributes:
        joints: Joint angles; `c12` is the cosine of the sum of those that end in 1 and 2.
        angles: Other angles, such as twists.
        lengths: Everything else: lengths, joint displacements, plain numbers.
        aliases: Other spellings in canonical form, such as q1 for theta1.
        is_open: Whether any other name stands for itself.
        is_usual: Whether such a name must look like one in a formula, a letter with an index; others are asked about.
        read: What was read with these names: functions with their arguments and cells of matrices, by their tokens,
            each with how many parts were counted.
    """

    joints: tuple[str, ...] = ()
    angles: tuple[str, ...] = ()
    lengths: tuple[str, ...] = ()
    aliases: Mapping[str, str] = field(default_factory=dict)
    is_open: bool = False
    is_usual: bool = False
    read: dict[str, tuple[Expr, int]] = field(default_factory=dict, init=False, repr=False, compare=False)
    _known: dict[str, str] = field(default_factory=dict, init=False, repr=False, compare=False)
    _read: dict[str, tuple[Expr, ...]] = field(default_factory=dict, init=False, repr=False, compare=False)

    def __post_init__(self) -> None:
        self._known.update(self.aliases)
        self._known.update((canonical(name), name) for name in self.names)
        for name in self.names:  # θi is θ_i where it can be nothing else
            stem, index = parts(name)
            if len(index) == 1 and index.isalpha() and not (stem in self._known and index in self._known):
                self._known.setdefault(stem + index, name)

    @property
    def names(self) -> tuple[str, ...]:
        """All names declared."""
        return (*self.joints, *self.angles, *self.lengths)

    def has(self, word: str) -> bool:
        """Whether a word is one of the declared names."""
        return canonical(word) in self._known

    def length_meant(self, word: str) -> str:
        """The length of which a word is another name, and no name itself; empty if it is of none."""
        plain = canonical(word)
        name = self._known[plain] if plain in self.aliases else ""
        return name if name in self.lengths and canonical(name) != plain else ""

    def is_angle(self, name: str) -> bool:
        """Whether a name stands for an angle; in an open scope Greek letters and q do."""
        if name in self.joints or name in self.angles:
            return True
        return self.is_open and name not in self.lengths and parts(name)[0] in GREEK_NAMES | {"q"}

    def readings(self, word: str) -> tuple[Expr, ...]:
        """What a word may stand for: a name, or the cosine or sine of an angle; empty if nothing."""
        if word not in self._read:
            if len(self._read) >= MOST_READ:
                self._read.clear()
            self._read[word] = self._readings(word)
        return self._read[word]

    def keep(self, spelling: str, expr: Expr, parts_counted: int) -> None:
        """Remember what some tokens were read as."""
        if len(self.read) >= MOST_KEPT:
            self.read.clear()
        self.read[spelling] = expr, parts_counted

    def _readings(self, word: str) -> tuple[Expr, ...]:
        known = self._known.get(canonical(word))
        found: list[Expr] = [Symbol(known)] if known else []
        if len(word) > 1 and word[0] in "cCsS":
            function = cosine if word[0] in "cC" else sine
            for angle in self._angles(word[1:]):
                trig = function(angle)
                if trig not in found:
                    found.append(trig)
        return tuple(found)

    def split(self, word: str) -> list[tuple[Expr, ...]]:
        """All ways to read a run of letters and digits as a product of names; at most two are looked for."""
        found: list[tuple[Expr, ...]] = []
        dead: set[int] = set()

        def search(start: int, pieces: tuple[Expr, ...]) -> bool:
            if start == len(word):
                found.append(pieces)
                return True
            if start in dead or len(found) > 1:
                return False
            alive = False
            for end in _ends(word, start):
                for reading in self.readings(word[start:end]):
                    alive = search(end, (*pieces, reading)) or alive
            if not alive:
                dead.add(start)
            return alive

        if len(word) <= LONGEST_WORD:
            search(0, ())
        return found

    def _angles(self, text: str) -> Iterator[Angle]:
        """The angles that the text behind `c` or `s` may stand for."""
        digits = text.strip("_{}")
        if text.startswith("_{") and _SIGNED.fullmatch(digits):
            yield from self._signed(digits)
            return
        if (digits.isdecimal() and digits.isascii()) or any(parts(name)[1] == digits for name in self.joints):
            yield from self._indexed(digits)
            return
        if text.startswith("_{") and not text[2:3].isalnum():
            text = text[2:-1]  # c_{\\theta_i}, as some write the cosine of theta_i
        name = self._known.get(canonical(text.lstrip("_"))) or self._known.get(_INITIALS.get(text, ""))
        if name is not None and self.is_angle(name):
            yield Angle.of(name)
            return
        sums = self.sums(text.lstrip("_"))
        yield from sums
        if self.is_open and not sums and name is None and is_greek(text):
            yield Angle.of(canonical(text))

    def sums(self, word: str) -> tuple[Angle, ...]:
        """What an undeclared `theta12` may stand for: the sum of theta1 and theta2."""
        stem, index = parts(word)
        spellings = {
            parts(name)[0] for name in (*self.joints, *(a for a, n in self.aliases.items() if n in self.joints))
        }
        if self.has(word) or stem not in spellings or not index.isdecimal():
            return ()
        return tuple(self._indexed(index))

    def _signed(self, index: str) -> Iterator[Angle]:
        """The angle of an index with signs, `1-2`: that of joint 1 less that of joint 2."""
        joints = {parts(name)[1]: Angle.of(name) for name in self.joints}
        terms = [("-" if sign == "-" else "+", digit) for sign, digit in _TERM.findall(index)]
        if all(digit in joints for _, digit in terms):
            yield sum((joints[digit] if sign == "+" else -joints[digit] for sign, digit in terms), Angle())

    def _indexed(self, digits: str) -> Iterator[Angle]:
        joints = {parts(name)[1]: name for name in self.joints}
        if self.is_open and not joints:
            joints = {digit: f"theta{digit}" for digit in "123456789"}
        if digits in joints:
            yield Angle.of(joints[digits])
        if len(digits) > 1 and list(digits) == sorted(set(digits)) and all(digit in joints for digit in digits):
            yield sum((Angle.of(joints[digit]) for digit in digits), Angle())


OPEN = Scope(is_open=True)
"""A scope in which every name stands for itself, and `c12` for cos(theta1 + theta2)."""


def usual(declared: Iterable[str] = ()) -> Scope:
    """A scope for a text typed without any robot: names declared, and those that look like names in a formula.

    Args:
        declared: Names that may look like words, such as shoulder; the Greek ones are angles.
    """
    names = tuple(declared)
    angles = tuple(name for name in names if parts(name)[0] in GREEK_NAMES | {"q"})
    return Scope(angles=angles, lengths=tuple(n for n in names if n not in angles), is_open=True, is_usual=True)


def _ends(word: str, start: int) -> Iterator[int]:
    """Where a name that starts here may end: never inside a number or a subscript's braces, nor before a digit."""
    depth = 0
    for end in range(start + 1, len(word) + 1):
        depth += (word[end - 1] == "{") - (word[end - 1] == "}")
        if depth == 0 and (end == len(word) or not (word[end].isdigit() or word[end] in "_{}₀₁₂₃₄₅₆₇₈₉")):
            yield end


def trig_name(expr: Expr) -> str:
    """How a reading is described in a question: cos(theta1 + theta2), or the name itself."""
    from dhcli.notation.writer import write

    return write(expr, "full") if isinstance(expr, Trig) else str(expr)
