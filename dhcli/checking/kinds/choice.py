"""`choice`: one of several statements, by its number, its letter or its text."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import replace
from typing import ClassVar, Self

from dhcli.checking.exercise import Besides, Case, Exercise, Question, Reading, Shown
from dhcli.checking.pasted import UnreadableError
from dhcli.checking.verdicts import Mark, Verdict
from dhcli.errors import Place
from dhcli.frozen import frozen
from dhcli.notation.scope import Scope

_LABEL = re.compile(r"[(\[]?([0-9]{1,3}|[a-z])[)\].:]{0,2}(?: (.+))?")


@frozen
class ChoiceQuestion(Question[int]):
    """One of several statements; `right` counts from 1."""

    options: tuple[str, ...]
    right: int

    words: ClassVar = ("choice",)
    examples: ClassVar = ("choice",)
    keys: ClassVar = ("options", "right")
    is_explained: ClassVar = False
    is_plain: ClassVar = True

    @classmethod
    def asked(cls, _text: str, _scope: Scope, _place: Place | None) -> Self:
        """Nothing more stands behind the word."""
        return cls((), 0)

    def completed(self, besides: Besides) -> Self:
        options, right = besides.texts("options"), besides.whole("right") or 0
        if not 1 <= right <= len(options):
            besides.refuse("right: should be the number of an option, counted from 1")
        return replace(self, options=options, right=right)

    def describe(self, _exercise: Exercise) -> str:
        return "the number of one statement"

    @property
    def statements(self) -> tuple[str, ...]:
        return self.options

    def expected(self, _case: Case, _style: str = "short") -> str:
        return str(self.right)

    def steps(self, _case: Case) -> Iterable[Shown]:
        yield Shown(f"The answer is {self.right}: {self.options[self.right - 1]}")

    def read(self, _case: Case, text: str, _place: Place | None = None) -> int:
        plain = [" ".join(option.split()).casefold() for option in self.options]
        answer = " ".join(text.split()).casefold()
        label = _LABEL.fullmatch(answer)
        chosen = 0
        if answer in plain:
            chosen = plain.index(answer) + 1
        elif label is not None:
            number = int(label[1]) if label[1].isdigit() else ord(label[1]) - ord("a") + 1
            chosen = number if not label[2] or plain[number - 1 : number] == [label[2]] else 0
        if not 1 <= chosen <= len(self.options):
            raise UnreadableError(f"choose a number from 1 to {len(self.options)}")
        return chosen

    def mark(self, _case: Case, reading: Reading[int]) -> Mark:
        verdict = Verdict.RIGHT if reading.value == self.right else Verdict.WRONG
        earned = float(verdict is Verdict.RIGHT)
        return Mark(verdict, self._told(reading.value), earned=earned, expected=self._told(self.right))

    def _told(self, number: int) -> str:
        return f"{number}: {self.options[number - 1]}"
