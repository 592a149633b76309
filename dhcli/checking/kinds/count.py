"""`count`: a whole number of a linkage, and on a miss the slips that give exactly the number typed."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import replace
from functools import partial
from operator import eq
from typing import TYPE_CHECKING, ClassVar, Self

from dhcli.checking.asking import Besides
from dhcli.checking.diagnosis.alternatives import Alternative, AlternativesQuestion
from dhcli.checking.diagnosis.result import Slip
from dhcli.checking.exercise import Case, Exercise
from dhcli.checking.pasted import UnreadableError, without_label, without_number_word
from dhcli.checking.returned import Reading, Shown
from dhcli.checking.verdicts import COUNTED, Mark, Verdict
from dhcli.errors import DhcliError, NotationError, Place, Problem
from dhcli.frozen import frozen
from dhcli.notation.parser import parse
from dhcli.notation.scope import Scope
from dhcli.notation.tree import Number, Unit
from dhcli.notation.walk import walk
from dhcli.regex import regex

if TYPE_CHECKING:
    from dhcli.mobility.counting import Counts
    from dhcli.mobility.linkage import Linkage

LARGEST = 10**6
_FREEDOMS = ("d", "freedom")
WHAT = {
    "mobility": _FREEDOMS,
    "gruebler": _FREEDOMS,
    "links": ("link",),
    "joints": ("joint",),
    "constraints": ("constraint",),
    "freedoms": _FREEDOMS,
}

_NOUN = regex(
    r"\s{0,9}(?P<noun>(?:link|joint|constraint|(?:degrees?\s{1,9}of\s{1,9})?freedom|d\.?o\.?f\.?)s?)\s{0,9}[=:]",
    re.IGNORECASE,
)
"""What is counted, before the number."""


@frozen
class CountQuestion(AlternativesQuestion[int]):
    """A count of a linkage: its mobility, links, joints or constraints.

    Attributes:
        what: What is counted.
        linkage: A pattern such as `6R`, or the name of a linkage.
        found: What that is; whoever loads the exercise has looked it up.
    """

    what: str
    linkage: str
    found: Linkage | Counts | None = None

    may_show_frames: ClassVar = True
    words: ClassVar = ("count",)
    examples: ClassVar = ("count mobility four-bar",)
    is_plain: ClassVar = True
    has_one_name: ClassVar = False

    @classmethod
    def asked(cls, text: str, _scope: Scope, place: Place | None) -> Self:
        """`count mobility four-bar`."""
        rest = text.removeprefix("count").strip()
        what, _, linkage = rest.partition(" ")
        if what not in WHAT or not linkage.strip():
            raise NotationError(Problem(f"'count {rest}' is not understood", place, "write count mobility four-bar"))
        return cls(what, linkage.strip())

    def completed(self, besides: Besides) -> Self:
        return replace(self, found=besides.linkage(self.linkage))

    @property
    def linkage_counted(self) -> Linkage | None:
        from dhcli.mobility.linkage import Linkage

        return self.found if isinstance(self.found, Linkage) else None

    def describe(self, _exercise: Exercise) -> str:
        return f"{self.what} of {self.linkage}, a whole number"

    def expected(self, case: Case, _style: str = "short") -> str:
        return str(self._right(case))

    def _right(self, case: Case) -> int:
        return case.memo.of(("count", case.part.id), self._counted)

    def _counted(self) -> int:
        from dhcli.mobility.slips import count

        return count(self.what, self._known)

    @property
    def _known(self) -> Linkage | Counts:
        if self.found is None:
            raise DhcliError(f"the linkage {self.linkage} was not looked up", "load the exercise from its file")
        return self.found

    def steps(self, _case: Case) -> Iterable[Shown]:
        from dhcli.mobility.counting import Counts

        is_linkage = not isinstance(self._known, Counts)
        counts = self._known if isinstance(self._known, Counts) else Counts.of(self._known)
        counted = f"n = {counts.n} links with the ground, j = {counts.j} joints"
        yield Shown(f"{counted}, Σf = {counts.sum_f}, ΣC = {counts.sum_c}, λ = {counts.space.lambda_}")
        if self.what in ("mobility", "gruebler"):
            yield Shown(counts.formulas[0])
        if self.what == "mobility" and is_linkage:
            yield Shown(f"Whether that is the truth, and why: dhcli dof {self.linkage}")

    def read(self, case: Case, text: str, place: Place | None = None) -> int:
        self._right(case)
        named = _NOUN.match(text)
        if named and not named["noun"].lower().startswith(WHAT[self.what]):
            raise UnreadableError(f"{named['noun']} stands before the number, and what is asked for is {self.what}")
        text = text[named.end() :] if named else text
        expr = parse(without_number_word(without_label(text), WHAT[self.what]), Scope(), place or Place("answer"))
        if any(isinstance(node, Unit) for node in walk(expr)):
            raise UnreadableError("a count is a whole number and has no unit")
        if not isinstance(expr, Number) or expr.value.denominator != 1 or abs(expr.value.numerator) > LARGEST:
            raise UnreadableError("a count is a whole number")
        return int(expr.value)

    def mark(self, case: Case, reading: Reading[int]) -> Mark:
        right, typed = self._right(case), reading.value
        if typed == right:
            return Mark(Verdict.RIGHT, str(typed), earned=1.0, expected=str(right))
        names = [slip.words for slip, value in self._slips(case) if value == typed]
        remarks = (f"{typed}{COUNTED}{' or when '.join(names)}",) if names else ()
        return Mark(Verdict.WRONG, str(typed), remarks=remarks, expected=str(right))

    def alternatives(self, case: Case, _name: str = "") -> Iterable[Alternative[int]]:
        return (Alternative(slip, str(value), partial(eq, value)) for slip, value in self._slips(case))

    def _slips(self, case: Case) -> tuple[tuple[Slip, int], ...]:
        """Slips in the count, each with the number it gives."""
        return case.memo.of(("slips of count", case.part.id), self._miscounted)

    def _miscounted(self) -> tuple[tuple[Slip, int], ...]:
        from dhcli.mobility.slips import slips

        try:
            found = slips(self.what, self._known)
        except DhcliError:
            return ()
        hint = "go through what was counted: links with the ground, joints, and the freedoms of each"
        return tuple((Slip(words.replace(" ", "-"), words, hint), value) for words, value in found.items())
