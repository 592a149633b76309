"""Slips in the entries of a formula: each entry is the right one, or holds a slip in its terms.

Only the entries that are wrong are looked at, one by one, so that a slip that stands in all of them is as cheap as one
in a single entry.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from operator import itemgetter

from dhcli.checking.diagnosis.mistakes import BY_ID
from dhcli.checking.diagnosis.mistakes.in_terms import TERM_MAKERS, Among, among_of, place_in
from dhcli.checking.diagnosis.result import Slip
from dhcli.checking.diagnosis.search import Search
from dhcli.checking.diagnosis.slips import slip_of
from dhcli.checking.diagnosis.typed import TypedMatrix
from dhcli.checking.diagnosis.work import terms
from dhcli.checking.exercise import Causes
from dhcli.notation.tree import Expr
from dhcli.notation.walk import operations

PAIR = 2

MOST_TOLD = 3
"""Entries that are told one by one; of more, it is told how many."""

Found = dict[tuple[str, str], None]
"""Slips that give an entry, each by its name and what it is about, in the order in which they are named."""


@dataclass(frozen=True, slots=True)
class EntryCauses:
    """What slips in the terms of wrong entries explain an answer.

    Attributes:
        one: One slip, in one entry or in all that are wrong.
        more: Slips of one kind in all wrong entries, or two slips, each in an entry of its own.
    """

    one: Causes = ()
    more: Causes = ()


def entry_causes(typed: TypedMatrix) -> EntryCauses:
    """The slips in the terms of the entries that are wrong, if each of these has one; numbers have no terms."""
    search = typed.search
    if search.setting.numeric:
        return EntryCauses()
    rows = terms(search.right, {})
    among = among_of(rows, search.setting)
    wrong = sorted(_wrong(typed), key=lambda place: operations(rows[place[0]][place[1]]))  # what is short fails soon
    found: list[tuple[str, Found]] = []
    kinds = frozenset(TERM_MAKERS)
    for r, c in wrong:
        here = dict.fromkeys(_slips_in(rows[r][c], among, _Entry(typed, r, c), kinds))
        if not here:
            return EntryCauses()
        if len(wrong) > PAIR:  # only one slip in all of them is looked for
            kinds &= {name for name, _ in here}
        found.append((place_in(search.right.question, r, c), here))
    if len(found) == 1:
        place, here = found[0]
        return EntryCauses(((_slip(next(iter(here)), place),),))
    found.sort(key=itemgetter(0))
    return EntryCauses(_in_all(found), _of_a_kind(found) or _one_each(found)) if found else EntryCauses()


@dataclass(frozen=True, slots=True)
class _Entry:
    """One entry of an answer, at each point."""

    typed: TypedMatrix
    row: int
    column: int

    def is_given_by(self, expr: Expr) -> bool:
        """Whether an expression gives what was typed."""
        limit = self.typed.slacks[0][self.row][self.column]
        return all(
            abs(over.value(expr) - values[self.row][self.column]) <= limit
            for over, values in zip(self.typed.search.points, self.typed.values, strict=True)
        )


def _wrong(typed: TypedMatrix) -> Iterator[tuple[int, int]]:
    search: Search = typed.search
    for r, row in enumerate(typed.slacks[0]):
        for c, limit in enumerate(row):
            pairs = zip(typed.values, search.truth, strict=True)
            if not all(abs(values[r][c] - truth[r][c]) <= limit for values, truth in pairs):
                yield r, c


def _slips_in(right: Expr, among: Among, entry: _Entry, kinds: frozenset[str]) -> Iterator[tuple[str, str]]:
    for name, made in TERM_MAKERS.items():
        for text, changed in made(right, among) if name in kinds else ():
            if entry.is_given_by(changed):
                yield name, text


def _slip(found: tuple[str, str], place: str) -> Slip:
    name, text = found
    return slip_of(BY_ID[name], f"{place} {text}")


def _in_all(found: Sequence[tuple[str, Found]]) -> Causes:
    """The slip that stands in all wrong entries."""
    (_, first), *others = found
    for name, text in first:
        if all((name, text) in here for _, here in others):
            return ((_throughout(name, [text], [place for place, _ in found]),),)
    return ()


def _of_a_kind(found: Sequence[tuple[str, Found]]) -> Causes:
    """Slips of the same kind in all wrong entries, such as c1*c2 for c12 in some and s1*s2 for s12 in others."""
    for name, _ in found[0][1]:
        texts = [next((text for kind, text in here if kind == name), "") for _, here in found]
        if all(texts):
            return ((_throughout(name, texts, [place for place, _ in found]),),)
    return ()


def _throughout(name: str, texts: Sequence[str], places: Sequence[str]) -> Slip:
    """A slip that is made in several entries, such as `sum-as-product 1,1 and 2,2 c1*c2 for c12`."""
    mistake, about = BY_ID[name], " and ".join(dict.fromkeys(texts))
    where = f"{', '.join(places[:-1])} and {places[-1]}"
    shown = f"entries ({'), ('.join(places[:-1])}) and ({places[-1]})"
    if len(places) > MOST_TOLD:
        where, shown = "throughout", f"{len(places)} entries"
    rows = ", ".join(dict.fromkeys(place.partition(",")[0] for place in places))
    words = mistake.words.replace("entry ({entry})", shown).replace("{term}", about)
    words = words.replace(" has ", " have ").replace(" lacks ", " lack ")
    hint = mistake.hint.replace("row {row}", f"rows {rows}" if "," in rows else f"row {rows}")
    return Slip(f"{name} {where} {about}", words, hint, mistake.rank)


def _one_each(found: Sequence[tuple[str, Found]]) -> Causes:
    if len(found) != PAIR:
        return ()
    return (tuple(_slip(next(iter(here)), place) for place, here in found),)
