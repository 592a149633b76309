"""What is said of a key that its mapping does not know, and the key that is plainly meant by it."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

from dhcli.errors import did_you_mean, nearest
from dhcli.notation.names import canonical

OWN = "x-"
"""Keys that begin so are the author's own; dhcli does not look at them."""

OTHER_WORDS = {
    "question": "ask",
    "questions": "parts",
    "tasks": "parts",
    "text": "prompt",
    "choices": "options",
    "correct": "right",
    "marks": "credit",
    "points": "credit",
    "score": "credit",
    "description": "task",
    "problem": "task",
    "arm": "robot",
    "values": "given",
    "letters": "names",
    "symbols": "names",
    "reference": "source",
    "name": "title",
    "dh": "links",
    "rows": "links",
    "table": "links",
    "joints": "variables",
    "constants": "parameters",
    "lengths": "parameters",
    "at": "point",
    "position": "point",
    "between": "links",
    "bodies": "links",
    "along": "axis",
    "about": "axis",
    "direction": "axis",
    "kind": "type",
    "r": "a",
    "s": "d",
}
"""What an author may call a key, where no key of this name stands in the same mapping."""

COMPUTED = ("answer", "answers", "solution", "solutions", "expected")
"""Keys that an author of exercises may look for, and that none has."""

_PLAINLY = 0.8
"""How like a key a word must be to be taken for it."""


def meant(word: str, known: Iterable[str]) -> str:
    """The key that is plainly meant by an unknown one; empty where that is not plain."""
    known = tuple(known)
    folded = canonical(word).lower()
    if other := next((key for key in known if key.lower() == folded), OTHER_WORDS.get(folded, "")):
        return other if other in known else ""
    return next(iter(nearest(word, known, most=1, cutoff=_PLAINLY)), "")


def hint_for(word: str, known: Sequence[str], elsewhere: Mapping[str, str]) -> str:
    """The nearest key, where else it stands, or the slip of spelling that makes YAML see another key than the author.

    Args:
        word: The unknown key.
        known: The keys that may stand there.
        elsewhere: What to say of keys that stand somewhere else in the file.
    """
    if ":" in word and word.split(":", maxsplit=1)[0].strip() in known:
        return "a colon needs a space after it"
    if invisible := [letter for letter in word if not letter.isprintable()]:
        return f"it holds the invisible character U+{ord(invisible[0]):04X}"
    if word in elsewhere:
        return elsewhere[word]
    if key := meant(word, known):
        return f"did you mean {key}?"
    if word in COMPUTED and {"ask", "parts"}.intersection(known):
        return "answers are computed; those under tests: are tried"
    return did_you_mean(word, known) or f"a key of your own begins with {OWN}: {OWN}{word}"
