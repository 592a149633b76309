"""Every kind of question, and the text of `ask:` as the question that it asks."""

from __future__ import annotations

from typing import Any

from dhcli.checking.exercise import Question
from dhcli.checking.kinds.cell import CellQuestion
from dhcli.checking.kinds.choice import ChoiceQuestion
from dhcli.checking.kinds.count import CountQuestion
from dhcli.checking.kinds.factors import FactorsQuestion
from dhcli.checking.kinds.matrix import MatrixQuestion
from dhcli.checking.kinds.orientation import OrientationQuestion
from dhcli.checking.kinds.scalar import ScalarQuestion
from dhcli.checking.kinds.table import TableQuestion
from dhcli.checking.wanted import NotAskedError
from dhcli.errors import NotationError, Place, Problem, nearest
from dhcli.notation.scope import Scope

LONGEST = 2000
"""Characters of a question."""

KINDS: list[type[Question[Any]]] = [
    MatrixQuestion,
    TableQuestion,
    CellQuestion,
    FactorsQuestion,
    ScalarQuestion,
    OrientationQuestion,
    CountQuestion,
    ChoiceQuestion,
]
"""A new kind is a file beside these, and a line here."""


def read_question(text: str, scope: Scope, place: Place | None = None) -> Question[Any]:
    """Read the text that asks a question.

    Args:
        text: One of the examples of a kind.
        scope: The names that points, products and scalars may use.
        place: Where the text stands, for errors.

    Raises:
        NotationError: It asks nothing that is known, or a part of it cannot be read.
    """
    text = text.strip()
    if len(text) > LONGEST:
        raise NotationError(Problem(f"a question of more than {LONGEST} characters is not read", place))
    word = text.split(None, 1)[0] if text else ""
    kind = next((kind for kind in KINDS if word in kind.words), MatrixQuestion)  # `0..3` is a pose, too
    try:
        return kind.asked(text, scope, place)
    except NotAskedError as error:
        raise _unknown(error.text, place) from None


def examples() -> tuple[str, ...]:
    """How each kind is asked."""
    return tuple(example for kind in KINDS for example in kind.examples)


def keys() -> tuple[str, ...]:
    """Keys of a part that only some kinds read."""
    return tuple(key for kind in KINDS for key in kind.keys)


def _unknown(text: str, place: Place | None) -> NotationError:
    if text.startswith("entry 4"):
        return NotationError(Problem("the bottom row of a pose is 0 0 0 1 for everybody", place, "ask for rows 1 to 3"))
    known = {example.split()[0]: example for example in examples()}
    similar = nearest(text.split(None, 1)[0] if text else "", known)
    hint = "did you mean " + " or ".join(known[word] for word in similar) + "?" if similar else ""
    return NotationError(
        Problem(f"'{text:.60}' asks nothing that is known", place, hint or "write one of: " + " · ".join(examples()))
    )
