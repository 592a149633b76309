"""`scalar`: an angle, a length or a number, computed from an expression."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace
from functools import partial
from typing import ClassVar, Self

from dhcli.checking.diagnosis.alternatives import Alternative, AlternativesQuestion
from dhcli.checking.exercise import Case, Exercise
from dhcli.checking.returned import Reading, Shown
from dhcli.checking.values import TypedValue, is_right_value, mark_value, quantity_of, read_typed_value, spelled_value
from dhcli.checking.verdicts import Mark
from dhcli.errors import Place
from dhcli.frozen import frozen
from dhcli.notation.dimensions import read_at
from dhcli.notation.parser import parse_quantity
from dhcli.notation.quantity import is_inverse
from dhcli.notation.scope import Scope
from dhcli.notation.tree import Expr, Trig
from dhcli.notation.walk import symbols, walk


@frozen
class ScalarQuestion(AlternativesQuestion[TypedValue]):
    """An angle, a length or a number, computed from an expression."""

    expr: Expr
    text: str

    may_show_frames: ClassVar = True
    words: ClassVar = ("scalar",)
    examples: ClassVar = ("scalar 2*a1",)

    @classmethod
    def asked(cls, text: str, scope: Scope, place: Place | None) -> Self:
        """`scalar 2*a1`."""
        rest = text.removeprefix("scalar").strip()
        if place is not None and place.column is not None:
            place = replace(place, column=place.column + len(text) - len(rest))
        expr = parse_quantity(rest, scope, place)
        if is_inverse(expr):
            _check_angle(expr, scope, place)
        return cls(expr, rest)

    def describe(self, _exercise: Exercise) -> str:
        return "one value"

    @property
    def has_cosines(self) -> bool:
        return any(isinstance(node, Trig) for node in walk(self.expr))

    @property
    def names(self) -> frozenset[str]:
        return symbols(self.expr)

    def expected(self, case: Case, _style: str = "short") -> str:
        return spelled_value(quantity_of(self.expr, case.exercise), case.exercise)

    def steps(self, case: Case) -> Iterable[Shown]:
        if case.exercise.given or case.exercise.numeric:
            yield Shown(f"What is asked for is {self.text}")

    def read(self, case: Case, text: str, place: Place | None = None) -> TypedValue:
        return read_typed_value(case.exercise, text, place)

    def mark(self, case: Case, reading: Reading[TypedValue]) -> Mark:
        return mark_value(case.exercise, quantity_of(self.expr, case.exercise), reading.value, case.tolerance)

    def alternatives(self, case: Case, name: str = "") -> Iterator[Alternative[TypedValue]]:
        from dhcli.checking.diagnosis.mistakes.values import IN_VALUES

        kind = name.partition(" ")[0]
        for mistake in (one for one in IN_VALUES if kind in ("", one.id)):
            for where, expr in mistake.made(self.expr, case.exercise):
                value = quantity_of(expr, case.exercise)
                yield Alternative(
                    mistake.slip(where),
                    spelled_value(value, case.exercise),
                    partial(is_right_value, case.exercise, value, tolerance=case.tolerance),
                )


def _check_angle(expr: Expr, scope: Scope, place: Place | None) -> None:
    """Make sure that what holds an inverse function is an angle, and not the sum of one and a length."""
    from dhcli.checking.angles import in_radians

    read_at(place, in_radians, expr, scope)
