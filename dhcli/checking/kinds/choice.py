"""`choice`: one of several statements, by its number, its letter or its text."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from typing import ClassVar, Self

from dhcli.checking.asking import Besides
from dhcli.checking.exercise import Case, Exercise, Question
from dhcli.checking.pasted import UnreadableError
from dhcli.checking.returned import Reading, Shown
from dhcli.checking.verdicts import Mark, Verdict
from dhcli.errors import Place
from dhcli.frozen import frozen
from dhcli.notation.scope import Scope
from dhcli.regex import regex

_LABEL = regex(r"[(\[]?([0-9]{1,3}|[a-z])[)\].:]{0,2}(?: (.+))?")

_CALLED = regex(
    r"^(?:(?:answer|option|statement|choice|number|no|nr)(?:\s{0,9}[:.]\s{0,9}|\s{1,9})|#\s{0,9})"
    r"(?=[(\[]?(?:\d{1,3}|[a-z])[)\].:]{0,2}$)"
)
"""What stands before the number of a statement, `option 2`, `answer: b`."""
_NUMBERS = (("one", "first", "1st"), ("two", "second", "2nd"), ("three", "third", "3rd"), ("four", "fourth", "4th"))
_COUNTED = regex(
    rf"(?:the )?(?P<number>{'|'.join(word for words in _NUMBERS for word in words)})"
    r"(?: (?:one|statement|option|answer|sentence))?\.?"
)
"""`the second one`."""
LISTED = 240
"""Characters that the statements together may have to be listed in a message."""

_MARKS = ".,;:!?\"'“”‘’()[]"  # noqa: RUF001  as they are typed


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
        options = besides.texts("options")
        return replace(self, options=options, right=besides.one_of("right", len(options)))

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
        answer = _CALLED.sub("", " ".join(text.split()).casefold(), count=1)
        label = _LABEL.fullmatch(answer)
        found = self._worded(answer, whole=label is not None and not label[2])
        if label is not None and not found:
            number = int(label[1]) if label[1].isdigit() else ord(label[1]) - ord("a") + 1
            found = [number] if not label[2] or number in self._worded(label[2]) else []
        if not found and (counted := _COUNTED.fullmatch(answer)):
            found = [next(k for k, words in enumerate(_NUMBERS, 1) if counted["number"] in words)]
        wanted = f"choose a number from 1 to {len(self.options)}, or write the words of one statement alone"
        if len(found) > 1:
            raise UnreadableError(f"these words stand in {' and '.join(map(str, found))}: {wanted}")
        if not found or not 1 <= found[0] <= len(self.options):
            raise UnreadableError(f"{wanted}{self._listed}")
        return found[0]

    @property
    def _listed(self) -> str:
        """The statements, where all are short enough for a message."""
        listed = " · ".join(self.options)
        return f": {listed}" if len(listed) <= LISTED else ""

    def _worded(self, answer: str, *, whole: bool = False) -> list[int]:
        """The numbers of the statements that these words are; else, but for `whole`, of those in which they stand."""
        typed, options = _words_of(answer), [_words_of(option) for option in self.options]
        found = [number for number, words in enumerate(options, 1) if words == typed]
        found = found or [number for number, words in enumerate(options, 1) if _glued(words) == _glued(typed)]
        if found or whole or not typed:
            return found
        return [number for number, words in enumerate(options, 1) if _holds(words, typed)]

    def mark(self, _case: Case, reading: Reading[int]) -> Mark:
        verdict = Verdict.RIGHT if reading.value == self.right else Verdict.WRONG
        earned = float(verdict is Verdict.RIGHT)
        return Mark(verdict, self._told(reading.value), earned=earned, expected=self._told(self.right))

    def _told(self, number: int) -> str:
        return f"{number}: {self.options[number - 1]}"


def _words_of(text: str) -> list[str]:
    """The words of a statement, without the marks of a sentence around them; signs of formulas stay."""
    words = (word.strip(_MARKS) for word in text.casefold().split())
    return [word for word in words if word]


def _glued(words: list[str]) -> str:
    """Words as one, so that HD is H D, and `4,5,6` is `4, 5 and 6`."""
    return "".join(word.replace(",", "") for word in words if word not in ("and", "&"))


def _holds(words: list[str], typed: list[str]) -> bool:
    """Whether words follow one another in a statement."""
    return any(words[k : k + len(typed)] == typed for k in range(len(words) - len(typed) + 1))
