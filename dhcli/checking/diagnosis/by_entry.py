"""Slips in the entries of a formula: each entry is the right one, or holds a slip in its terms.

Only the entries that are wrong are looked at, one by one, so that a slip that stands in all of them is as cheap as one
in a single entry.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from functools import partial
from operator import itemgetter

from dhcli.checking.diagnosis.bench import terms
from dhcli.checking.diagnosis.mistakes import BY_ID
from dhcli.checking.diagnosis.mistakes.in_terms import IN_ENTRY, Among, among_of, place_in
from dhcli.checking.diagnosis.result import Slip
from dhcli.checking.diagnosis.search import Search
from dhcli.checking.diagnosis.typed import TypedMatrix
from dhcli.checking.returned import Causes
from dhcli.errors import joined
from dhcli.frozen import frozen
from dhcli.notation.tree import Expr
from dhcli.notation.walk import operations

PAIR = 2

MOST_TOLD = 3
"""Entries that are told one by one; of more, it is told how many."""

Found = dict[tuple[str, str], None]
"""Slips that give an entry, each by its name and what it is about, in the order in which they are named."""


@frozen
class EntryCauses:
    """What slips in the terms of wrong entries explain an answer.

    Attributes:
        one: One slip, in one entry or in all that are wrong.
        more: Slips of one kind in all wrong entries, or two slips, each in an entry of its own.
    """

    one: Causes = ()
    more: Causes = ()


@frozen
class WrongEntry:
    """An entry that is wrong.

    Attributes:
        place: Row and column as they are told, `2,4`; empty where there is but one.
        right: The right entry.
        is_given_by: Whether an expression gives what was typed.
    """

    place: str
    right: Expr
    is_given_by: Callable[[Expr], bool]


def matrix_entry_causes(typed: TypedMatrix) -> EntryCauses:
    """The slips in the terms of the wrong entries of a matrix; numbers have no terms."""
    search = typed.search
    if search.setting.numeric:
        return EntryCauses()
    rows, question = terms(search.right, {}), search.right.question
    wrong = [WrongEntry(place_in(question, r, c), rows[r][c], partial(_gives, typed, r, c)) for r, c in _wrong(typed)]
    return entry_causes(wrong, among_of(rows, search.setting))


def entry_causes(entries: Iterable[WrongEntry], among: Among) -> EntryCauses:
    """The slips in the terms of the entries that are wrong, if each of these has one."""
    wrong = sorted(entries, key=lambda one: operations(one.right))  # what is short fails soon
    found: list[tuple[str, Found]] = []
    kinds = frozenset(one.id for one in IN_ENTRY)
    for one in wrong:
        here = dict.fromkeys(_slips_in(one, among, kinds))
        if not here:
            return EntryCauses()
        if len(wrong) > PAIR:  # only one slip in all of them is looked for
            kinds &= {name for name, _ in here}
        found.append((one.place, here))
    if len(found) == 1:
        place, here = found[0]
        return EntryCauses(((_slip(next(iter(here)), place),),))
    found.sort(key=itemgetter(0))
    return EntryCauses(_in_all(found), _of_a_kind(found) or _one_each(found)) if found else EntryCauses()


def _gives(typed: TypedMatrix, row: int, column: int, expr: Expr) -> bool:
    """Whether an expression gives what was typed, at each point."""
    limit = typed.slacks[0][row][column]
    return all(
        abs(over.value(expr) - values[row][column]) <= limit
        for over, values in zip(typed.search.points, typed.values, strict=True)
    )


def _wrong(typed: TypedMatrix) -> Iterator[tuple[int, int]]:
    search: Search = typed.search
    for r, row in enumerate(typed.slacks[0]):
        for c, limit in enumerate(row):
            pairs = zip(typed.values, search.truth, strict=True)
            if not all(abs(values[r][c] - truth[r][c]) <= limit for values, truth in pairs):
                yield r, c


def _slips_in(entry: WrongEntry, among: Among, kinds: frozenset[str]) -> Iterator[tuple[str, str]]:
    for mistake in IN_ENTRY:
        for text, changed in mistake.made(entry.right, among) if mistake.id in kinds else ():
            if entry.is_given_by(changed):
                yield mistake.id, text


def _slip(found: tuple[str, str], place: str) -> Slip:
    name, text = found
    return BY_ID[name].slip(f"{place} {text}") if place else slip_in(name, text, "the answer")


def slip_in(kind: str, text: str, shown: str, name: str = "") -> Slip:
    """A slip in the terms of what is no entry of a matrix.

    Args:
        kind: Name of the mistake.
        text: What it is about, such as `c2 for c12`.
        shown: What stands for the entry in its words.
        name: What stands for the place in its name.
    """
    mistake = BY_ID[kind]
    words = mistake.words.replace("entry ({entry})", shown).format(term=text)
    hint = mistake.hint.replace("row {row}", shown)
    return Slip(" ".join(filter(None, (kind, name, text))), words, hint, mistake.rank)


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
    where, shown = joined(places), f"entries {joined([f'({place})' for place in places])}"
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
