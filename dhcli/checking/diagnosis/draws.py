"""The mistakes that many draws of an exercise's numbers hide; what the draws have in common is worked out once."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import TypeAlias

from dhcli.checking.diagnosis.search import Search, search_of
from dhcli.checking.exercise import Exercise
from dhcli.checking.questions import MatrixQuestion

Unclear: TypeAlias = frozenset[tuple[str, str]]
"""Mistakes that a pose does not show plainly, each as the name of a part and that of a slip."""


class Draws:
    """An exercise whose numbers vary."""

    def __init__(self, exercise: Exercise) -> None:
        """Take the exercise with the numbers of its file."""
        questions = [part.question for part in exercise.parts if isinstance(part.question, MatrixQuestion)]
        turning = exercise.robot.variables if exercise.robot else ()
        self._moves_only = exercise.variants.keys() <= set(turning)
        self._searches = {question: search_of(exercise, question) for question in dict.fromkeys(questions)}
        self._always: Unclear | None = None

    def unclear(self, drawn: Exercise) -> Unclear:
        """The mistakes that a draw does not show plainly."""
        return frozenset((part, one.slips[0].name) for part, search in self._drawn(drawn) for one in search.unclear)

    def always(self, references: Iterable[Exercise]) -> Unclear:
        """The mistakes that no draw shows: it is the question that hides them.

        Args:
            references: Draws to tell by, looked at once.
        """
        if self._always is None:
            for drawn in references:
                found = self.unclear(drawn)
                self._always = found if self._always is None else self._always & found
                if not self._always:
                    break
        return self._always or frozenset()

    def _drawn(self, drawn: Exercise) -> Iterator[tuple[str, Search]]:
        """The searches at the values of a draw, kept with it for whoever diagnoses an answer."""
        for part in drawn.parts:
            question = part.question
            if not isinstance(question, MatrixQuestion):
                continue
            if self._moves_only and ("search", question) not in drawn.truths:
                drawn.truths["search", question] = Search(drawn, question, self._searches[question])
            yield part.id, search_of(drawn, question)


def draws_of(exercise: Exercise) -> Draws:
    """The draws of an exercise, kept with it."""
    known = exercise.truths.get("draws")
    if not isinstance(known, Draws):
        known = exercise.truths["draws"] = Draws(exercise)
    return known
