"""A tape as formulas: what is needed more than once has a name, everything else stands where it is used.

So a function in any language computes no cosine and no product twice, and still reads as a person would write it.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction

from dhcli.algebra.program import needed
from dhcli.algebra.tape import UFUNCS, Cell, Column, Number, Operation, Tape
from dhcli.frozen import frozen
from dhcli.notation import tree
from dhcli.notation.let import Definition
from dhcli.notation.names import natural_key
from dhcli.notation.tree import Call, Expr, Power, Product, Sum, Symbol, factor_key, negate, split

FUNCTIONS = {ufunc: name for name, ufunc in UFUNCS.items()}
"""What notation calls the steps that numpy calls by other names."""

TURNING = ("cos", "sin")
UNCHANGING = ("multiply", "add", "subtract")


@frozen
class Written:
    """Numbers as formulas.

    Attributes:
        definitions: Names, each for a formula in names that stand before it.
        results: The numbers, in those names and the variables.
    """

    definitions: tuple[Definition, ...]
    results: tuple[Expr, ...]


def written(tape: Tape, results: Sequence[Number], indices: Mapping[str, str]) -> Written:
    """Numbers of a tape as formulas.

    Args:
        tape: The tape.
        results: The numbers wanted.
        indices: Short indices of variables, for names such as `c23`.

    Raises:
        ValueError: A number in it is not finite.
    """
    return _Writing(tape, results, indices).written()


class _Writing:
    def __init__(self, tape: Tape, results: Sequence[Number], indices: Mapping[str, str]) -> None:
        self.results = results
        ends = [result.column for result in results if isinstance(result, Cell)]
        self.steps = needed(tape, ends)
        self.uses = Counter(column for step in self.steps.values() for column in step.columns) + Counter(ends)
        self.known: dict[Column, Expr] = {cell.column: Symbol(name) for name, cell in tape.variables.items()}
        self.labels = {cell.column: indices.get(name, "") for name, cell in tape.variables.items()}
        self.variables = tape.variables.keys()
        self.taken = set(tape.variables)
        self.named = set[str]()

    def written(self) -> Written:
        """Angles and their cosines and sines first, in joint order, then what is made of them."""
        turning, others = dict[Column, Definition](), list[Definition]()
        early = self.angles()
        for column, step in self.steps.items():
            expr = self.formula(step)
            self.labels[column] = self.label(step)
            if self.uses[column] > 1 or step.ufunc in TURNING:
                name = self.name(column, step)
                if column in early:
                    turning[column] = Definition(name, expr)
                else:
                    others.append(Definition(name, expr))
                expr = Symbol(name)
            self.known[column] = expr
        ordered = [turning[column] for column in sorted(turning, key=self.joint_order)]
        return Written((*ordered, *others), tuple(map(self.result, self.results)))

    def angles(self) -> set[Column]:
        """Cosines and sines, and what leads to them."""
        found = set[Column]()
        for column, step in reversed(self.steps.items()):
            if column in found or step.ufunc in TURNING:
                found |= {column, *step.columns}
        return found

    def joint_order(self, column: Column) -> tuple[bool, int, int]:
        """`c1`, then `c2`, then `c23`; what has no short index behind them, as it came."""
        label = self.labels[column]
        return not label, int(label or 0), column.place

    def result(self, number: Number) -> Expr:
        if not isinstance(number, Cell):
            return _constant(float(number))
        return negate(self.known[number.column]) if number.negative else self.known[number.column]

    def formula(self, step: Operation) -> Expr:
        """A step in terms of what stands before it."""
        operands = [self.known[o] if isinstance(o, Column) else _constant(o) for o in step.operands]
        match step.ufunc:
            case "add":
                return _sum(*operands)
            case "subtract":
                return _sum(operands[0], negate(operands[1]))
            case "multiply":
                return self.product(*operands)
            case "divide":
                return self.product(operands[0], Power(operands[1], Fraction(-1)))
            case "negative":
                return negate(operands[0])
            case "power":
                return _power(operands[0], Fraction(step.operands[1]))  # type: ignore[arg-type]  # a constant
        return Call(FUNCTIONS.get(step.ufunc, step.ufunc), tuple(operands))

    def product(self, *factors: Expr) -> Expr:
        """A product as it was computed, flat, lengths before cosines, the sign in front."""
        number, rest = Fraction(1), list[Expr]()
        for factor in factors:
            part, others = split(factor)
            number *= part.value
            if type(others) is Sum and tree.is_negative(others.terms[0]):
                number, others = -number, negate(others)
            rest += others.factors if type(others) is Product else [others]
        rest = sorted((one for one in rest if one != tree.ONE), key=self.factor_order)
        whole = ([] if number == 1 else [tree.Number(number)]) + rest
        return whole[0] if len(whole) == 1 else Product(tuple(whole))

    def factor_order(self, factor: Expr) -> tuple[bool, tuple[object, ...]]:
        """Lengths before names, which are mostly cosines and sines; brackets last."""
        return type(factor) is Symbol and factor.name in self.named, factor_key(factor)

    def label(self, step: Operation) -> str:
        """`23` for theta2 + theta3 and theta3 + theta2; nothing for other sums, and for steps that are none."""
        labels = [self.labels[o] if isinstance(o, Column) else "" for o in step.operands]
        return "".join(sorted("".join(labels))) if step.ufunc in ("add", *TURNING) and all(labels) else ""

    def name(self, column: Column, step: Operation) -> str:
        """A name that is not taken: `c23`, `c_alpha`, or the next of `t1`, `t2` ..."""
        label = self.labels[column]
        letter = step.ufunc[0] if step.ufunc in TURNING else "q" if label else "t"
        operand = step.operands[0]
        turned = self.known[operand] if letter in "cs" and isinstance(operand, Column) else None
        if not label and type(turned) is Symbol and turned.name in self.variables:
            label = f"_{turned.name}"
        name = next(name for name in self.names(letter, label) if name not in self.taken)
        self.taken.add(name)
        self.named.add(name)
        return name

    @staticmethod
    def names(letter: str, label: str) -> Iterator[str]:
        if label:
            yield f"{letter}{label}"
        number = 0
        while True:
            number += 1
            yield f"{letter}_{number}" if letter in "cs" else f"{letter}{number}"


class Lean(Tape):
    """A tape without steps that change nothing: times 0 or 1, plus 0.

    Where a tape is played, a number that is none must not be lost by them; in a function they are only in the way.
    """

    def step(self, ufunc: str, *operands: Column | float, negative: bool = False) -> Number:  # type: ignore[override]
        """What an operation gives; a constant or one of the operands where that is known."""
        first, *more = operands
        if ufunc == "multiply" and more[0] == 0:
            return 0.0
        if ufunc == "subtract" and first == 0 and isinstance(more[0], Column):
            return Cell(self, more[0], not negative)
        if isinstance(first, Column) and more == [1.0 if ufunc == "multiply" else 0.0] and ufunc in UNCHANGING:
            return Cell(self, first, negative)
        if ufunc == "subtract" and first == more[0]:
            return 0.0
        return super().step(ufunc, *operands, negative=negative)


def _power(base: Expr, exponent: Fraction) -> Expr:
    """A power; what is below a line as 1 over a root."""
    if exponent < 0 and exponent != -1:
        return Power(Power(base, -exponent), Fraction(-1))
    return Power(base, exponent)


def _constant(value: float) -> tree.Number:
    if not math.isfinite(value):
        raise ValueError(value)
    return tree.Number(Fraction(value))


def _sum(*terms: Expr) -> Expr:
    """A sum as it was computed, flat, what is subtracted behind; numbers in it are one."""
    flat = [one for term in terms for one in (term.terms if type(term) is Sum else (term,))]
    numbers = [one for one in flat if type(one) is tree.Number]
    if len(numbers) > 1:
        flat = [one for one in flat if type(one) is not tree.Number]
        # by their decimals, so that 0.1 and 0.2 are 0.3
        total = float(sum(Fraction(repr(float(one.value))) for one in numbers))
        flat += [_constant(total)] if total or not flat else []
    return flat[0] if len(flat) == 1 else Sum(tuple(sorted(flat, key=_term_order)))


def _term_order(term: Expr) -> tuple[bool, tuple[tuple[str, int], ...]]:
    """What is subtracted last, `a1*c1` before `a2*c12`."""
    rest = split(term)[1]
    first = rest.factors[0] if type(rest) is Product else rest
    return tree.is_negative(term), natural_key(first.name) if type(first) is Symbol else ()
