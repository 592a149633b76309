"""Every kind of question, and the text of `ask:` as the question that it asks."""

from __future__ import annotations

from importlib import import_module
from typing import Any

from dhcli.checking.exercise import Question
from dhcli.checking.kinds.cell import CellQuestion
from dhcli.checking.kinds.choice import ChoiceQuestion
from dhcli.checking.kinds.count import CountQuestion
from dhcli.checking.kinds.factors import FactorsQuestion
from dhcli.checking.kinds.matrix import MatrixQuestion
from dhcli.checking.kinds.scalar import ScalarQuestion
from dhcli.checking.kinds.table import TableQuestion
from dhcli.checking.wanted import NotAskedError
from dhcli.errors import NotationError, Place, Problem
from dhcli.notation.scope import Scope

LONGEST = 2000
"""Characters of a question."""

KINDS: list[type[Question[Any]]] = [
    MatrixQuestion,
    TableQuestion,
    CellQuestion,
    FactorsQuestion,
    ScalarQuestion,
    CountQuestion,
    ChoiceQuestion,
]
"""A new kind is a file beside these, and a line here."""

LATER = {
    "rpy": "orientation.OrientationQuestion",
    "euler": "orientation.OrientationQuestion",
    "fixed": "orientation.OrientationQuestion",
    "quaternion": "orientation.OrientationQuestion",
    "axis-angle": "orientation.OrientationQuestion",
    "rotation-vector": "orientation.OrientationQuestion",
    "joints": "joints.JointsQuestion",
    "angle": "joint_formula.JointFormulaQuestion",
    "joint": "joint_formula.JointFormulaQuestion",
    "count solutions": "reaching.SolutionsQuestion",
    "reach": "reaching.ReachQuestion",
    "jacobian": "jacobian.JacobianQuestion",
    "column": "jacobian.JacobianQuestion",
    "entry": "jacobian.JacobianQuestion",
    "determinant": "determinant.DeterminantQuestion",
    "singular": "singular.SingularQuestion",
    "rank": "rank.RankQuestion",
    "manipulability": "manipulability.ManipulabilityQuestion",
    "torques": "torques.TorquesQuestion",
    "velocity": "velocity.VelocityQuestion",
    "angular": "velocity.VelocityQuestion",
    "joint rates": "rates.RatesQuestion",
    "frames": "frames.FramesQuestion",
    "differential": "differential.DifferentialQuestion",
}
"""Kinds by their first words that are imported when one is asked, because they need rooms of their own."""


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
    try:
        return _asked(text, scope, place)
    except NotAskedError as error:
        raise _unknown(text, error.text, scope, place) from None


def _asked(text: str, scope: Scope, place: Place | None = None) -> Question[Any]:
    """The question of a text.

    Raises:
        NotAskedError: It asks nothing that is known.
        NotationError: A part of it cannot be read.
    """
    unknown = text
    for kind in _kinds(text.split(None, 2)) or [MatrixQuestion]:  # `0..3` is a pose, too
        try:
            return kind.asked(text, scope, place)
        except NotAskedError as error:  # `entry 1 2` may be of a pose, or of a Jacobian
            unknown = error.text
    raise NotAskedError(unknown)


def examples() -> tuple[str, ...]:
    """How each kind is asked."""
    return tuple(example for kind in every_kind() for example in kind.examples)


def every_kind() -> tuple[type[Question[Any]], ...]:
    """All kinds, those too that are imported only when they are asked."""
    return (*KINDS, *map(_imported, dict.fromkeys(LATER.values())))


def _kinds(words: list[str]) -> list[type[Question[Any]]]:
    """The kinds that the first words may mean: `count solutions` before `count`."""
    starts = (" ".join(words[:2]), *words[:1])
    found: list[type[Question[Any]]] = []
    for start in starts:
        found += [kind for kind in KINDS if start in kind.words]
        found += [_imported(LATER[start])] if start in LATER else []
    return found


def _imported(name: str) -> type[Question[Any]]:
    module, _, kind = name.partition(".")
    found: type[Question[Any]] = getattr(import_module(f"dhcli.checking.kinds.{module}"), kind)
    return found


def _unknown(asked: str, text: str, scope: Scope, place: Place | None) -> NotationError:
    from dhcli.checking.kinds.meant import hint_for  # most questions are known

    hint = hint_for(asked, text, examples(), lambda other: _asked(other, scope))
    if hint.startswith("write "):
        return NotationError(Problem(f"'{text:.60}' asks nothing that is known", place, hint))
    if text.startswith("entry 4") and "jacobian" not in text:
        return NotationError(Problem("the bottom row of a pose is 0 0 0 1 for everybody", place, "ask for rows 1 to 3"))
    kind, *numbers = text.split()[:3] or [""]
    if kind == "entry" and "jacobian" not in text and not {*numbers} <= {"1", "2", "3", "4"}:
        return NotationError(Problem("a pose has four rows and four columns", place, "ask for entry 1 4 of pose 0..3"))
    return NotationError(Problem(f"'{text:.60}' asks nothing that is known", place, hint))
