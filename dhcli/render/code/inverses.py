"""A derivation as a function that returns every solution, in each language."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from dhcli.algebra.arithmetic import evaluate
from dhcli.algebra.tape import Number
from dhcli.algebra.written import Lean, Written, written
from dhcli.frozen import frozen
from dhcli.kinematics.derived import in_floats
from dhcli.kinematics.inverse.derivation import Derivation
from dhcli.kinematics.inverse.derive_levels import POSITION, ROTATION
from dhcli.kinematics.inverse.derive_rules import Step
from dhcli.kinematics.inverse.derive_terms import name_of
from dhcli.notation.angle import Angle
from dhcli.notation.tree import HALF, ONE, ZERO, Call, Expr, Power, Product, Sum, Symbol, Trig, add, negate, power
from dhcli.notation.walk import rebuild, symbols, symbols_in, walk
from dhcli.regex import regex
from dhcli.render.code.functions import lengths_words, robot_words
from dhcli.render.code.language import Heading, Spelling
from dhcli.render.code.languages import LANGUAGES
from dhcli.render.look import Look
from dhcli.render.text.forward import frame_words

_ONE = "1 + 1e-12"
"""A cosine up to this is one of 1: that of an arm stretched out is 1 but for rounding."""

_PI = regex(r"\bpi\b")


@frozen
class Stage:
    """A step in formulas that share their parts with all other steps.

    Attributes:
        step: The step.
        name: What its unknown is called.
        before: What there must be a root or an arc cosine of, if the step has one.
        value: Its value, or what stands before the sign.
        spread: What stands behind the sign, if anything does; the arc cosine of `before` where that is one.
    """

    step: Step
    name: str
    before: Expr | None
    value: Expr
    spread: Expr | None

    @property
    def has_cosine(self) -> bool:
        """Whether the unknown is plus or minus an arc cosine."""
        return self.step.two == "plus-minus" and isinstance(self.step.spread, Call)


def inverse_code(result: Derivation, look: Look) -> str:
    """A file with one function: a pose and lengths in, a list of joint values out, all in joint order."""
    language = LANGUAGES[look.format]
    lengths, entries = lengths_used(result), list(entries_used(result))
    formulas, stages = shared(result)
    unknown = [stage.name for stage in stages]
    names = [*lengths, *(name for name, _, _ in entries), *unknown, *(one.name for one in formulas.definitions)]
    names += [f"{kind}_{name}" for name in unknown for kind in ("sign", "turn", "cosine")]
    spelling = language.spelling(names)
    joints = [spelling.names[name] for name in result.robot.variables if name in unknown]
    own = {name: None if (v := result.robot.parameters[name]) is None else in_floats(v) for name in lengths}
    heading = Heading("inverse", list(_said(result, joints, spelling)), (), own, ("T",), gives="solutions")
    if language.name == "c":
        given, filled = ("const double T[4][4]",), (f"double solutions[][{len(joints)}]",)
        heading = Heading("inverse", heading.said, (), own, given, filled, "int")
    b = language.base
    body = [spelling.let(name, language.entry.format("T", i - 1 + b, k - 1 + b)) for name, i, k in entries]
    body += [language.begin, *_Nest(spelling, formulas, joints, lengths).lines(stages), *language.finish.split("\n")]
    if language.name == "c" and any(map(_PI.search, body)):
        body.insert(0, "const double pi = 3.14159265358979323846;")
    return language.function(heading, spelling, [line for line in body if line.strip()])


def _said(result: Derivation, joints: Sequence[str], spelling: Spelling) -> Iterator[str]:
    """What the function takes and gives."""
    robot = result.robot
    of = "the position in the pose T" if result.place_only else "the pose T"
    yield f"Every solution of {robot.name} for {of} of {frame_words(result.end)} seen from {frame_words(result.start)}."
    yield f"{robot_words(robot)}; radians and metres."
    yield f"Joint values of each, in this order: {', '.join(joints)}; at most {result.branches} solutions."
    if spelling.language.name == "c":
        yield f"Returns how many there are; solutions has room for {result.branches} rows."
    yield from lengths_words(robot, {name: spelling.names[name] for name in lengths_used(result)})
    yield f"Source: {robot.source}"


class _Nest:
    """The loops, one inside the other, with what each line needs before it."""

    def __init__(self, spelling: Spelling, formulas: Written, joints: Sequence[str], lengths: Sequence[str]) -> None:
        self.spelling, self.language, self.joints = spelling, spelling.language, joints
        self.waiting = {one.name: one.expr for one in formulas.definitions}
        self.steady, self.depth = set(lengths), 0

    def lines(self, stages: Sequence[Stage]) -> Iterator[str]:
        for stage in stages:
            for line in self.stage(stage):
                margin = "    " * self.depth
                yield from (f"{margin}{part}" for part in line.split("\n"))
                self.depth += line.startswith("for ")
        for line in self.found():
            yield f"{'    ' * self.depth}{line}"
        for level in reversed(range(self.depth)):
            yield "    " * level + self.language.end

    def found(self) -> Iterator[str]:
        """The lines that keep a solution."""
        if self.language.append:
            yield self.language.append.format(", ".join(self.joints))
            return
        yield from (f"solutions[found][{k}] = {name};" for k, name in enumerate(self.joints))
        yield "found += 1;"

    def stage(self, stage: Stage) -> Iterator[str]:
        """The lines of one step; those that begin with `for` open a loop."""
        spelling, language, two = self.spelling, self.language, stage.step.two
        yield from self.needed(*([stage.value, stage.spread] if stage.before is None else [stage.before]))
        if two == "plus-minus":
            yield language.signs.format(spelling.names[f"sign_{stage.name}"])
        elif two:
            yield language.turns.format(spelling.names[f"turn_{stage.name}"])
        value, spread = stage.value, stage.spread
        yield from self.divisible(*([value, spread] if stage.before is None else [stage.before]))
        if stage.before is not None:
            limit = f"{spelling.formula(stage.before)} < 0"
            if stage.has_cosine:
                cosine = Symbol(f"cosine_{stage.name}")
                yield spelling.let(cosine.name, spelling.formula(stage.before))
                limit, spread = f"{spelling.formula(Call('abs', (cosine,)))} > {_ONE}", _arc_cosine(cosine)
            yield self.left_if(limit)
        yield from self.needed(value, spread)
        if stage.before is not None:
            yield from self.divisible(value)
        if two == "plus-minus" and spread is not None:
            term: Expr = Product((Symbol(f"sign_{stage.name}"), spread))
            value = term if value == ZERO else Sum((value, term))
        elif two:
            value = Sum((value, Symbol(f"turn_{stage.name}")))
        yield spelling.let(stage.name, spelling.formula(value))

    def left_if(self, condition: str) -> str:
        """The lines that go on with the next round if a condition holds; outside of all loops nothing is found then."""
        leave = "continue" if self.depth else self.language.finish.removesuffix(";") or "return"
        return self.language.skip.format(condition, leave)

    def divisible(self, *formulas: Expr | None) -> Iterator[str]:
        """Lines that leave out what would be divided by 0: some languages end there, others go on without a number.

        A length by which is divided makes the formulas what they are; none of the robot's own is 0.
        """
        below = dict.fromkeys(base for expr in formulas if expr is not None for base in _below(expr))
        for base in below:
            if not symbols(base) <= self.steady:
                yield self.left_if(f"{self.spelling.formula(base)} == 0")

    def needed(self, *formulas: Expr | None) -> Iterator[str]:
        """Lines for the parts of formulas that have none yet."""
        used = symbols_in(expr for expr in formulas if expr is not None)
        for name in [name for name in self.waiting if name in used]:
            if name in self.waiting:
                part = self.waiting.pop(name)
                yield from self.needed(part)
                self.steady |= {name} if symbols(part) <= self.steady else set()
                yield from self.divisible(part)
                yield self.spelling.let(name, self.spelling.formula(part))


def _arc_cosine(cosine: Expr) -> Expr:
    """The angle of a cosine, also of one that rounding has put beyond 1; of others to the same digits as `acos`."""
    rest = Call("abs", (add(ONE, negate(power(cosine, 2))),))
    return Call("atan2", (power(rest, HALF), cosine))


def _below(expr: Expr) -> Iterator[Expr]:
    """What must not be 0, for it stands below a line; of a root what it is taken of."""
    for node in walk(expr):
        if type(node) is Power and node.exponent < 0:
            base = node.base
            while type(base) is Power:
                base = base.base
            yield from base.factors if type(base) is Product else (base,)


def shared(result: Derivation) -> tuple[Written, tuple[Stage, ...]]:
    """All formulas of a derivation over one tape, so that none of them computes what another has."""
    unknown = [name_of(step.atom) for step in result.steps]
    tape = Lean(list(dict.fromkeys([*lengths_used(result), *(name for name, _, _ in entries_used(result)), *unknown])))
    sums: dict[tuple[tuple[str, object], ...], str] = {}
    numbers, places = list[Number](), list[list[int | None]]()
    indices = dict(result.robot.writing.index)
    for step, name in zip(result.steps, unknown, strict=True):
        row: list[int | None] = []
        for expr in _parts(step):
            row.append(None if expr is None else len(numbers))
            if expr is not None:
                numbers.append(evaluate(_whole_sums(expr, sums), tape))
        places.append(row)
        if not isinstance(step.atom, str) and len(step.atom) > 1:
            sums[step.atom] = name
            digits = [indices.get(part, "") for part, factor in step.atom if factor == 1]
            if len(digits) == len(step.atom) and all(digits):
                indices[name] = "".join(digits)
    formulas = written(tape, numbers, indices)
    found = [[None if place is None else formulas.results[place] for place in row] for row in places]
    return formulas, tuple(
        Stage(step, name, before, value, spread)
        for step, name, (before, value, spread) in zip(result.steps, unknown, found, strict=True)
        if value is not None
    )


def _parts(step: Step) -> tuple[Expr | None, Expr, Expr | None]:
    """What must not be out of range, the value, and what stands behind the sign."""
    if step.two == "plus-minus" and isinstance(step.spread, Call):
        return step.spread.arguments[0], step.value, None
    return step.condition if step.two == "plus-minus" else None, step.value, step.spread


def lengths_used(result: Derivation) -> list[str]:
    """The lengths and constant angles that the formulas need."""
    used = _used(result)
    return [name for name in result.robot.parameters if name in used]


def entries_used(result: Derivation) -> Iterator[tuple[str, int, int]]:
    """The entries of the pose that the formulas need, with their row and column from 1."""
    used = _used(result)
    for name in ROTATION:
        if name in used:
            yield name, int(name[1]), int(name[2])
    for row, name in enumerate(POSITION, 1):
        if name in used:
            yield name, row, 4


def _used(result: Derivation) -> frozenset[str]:
    every = (expr for step in result.steps for expr in (step.value, step.spread, *_parts(step)) if expr is not None)
    return symbols_in(every)


def _whole_sums(expr: Expr, sums: dict[tuple[tuple[str, object], ...], str]) -> Expr:
    """An expression in which a sum that was found as a whole has a name of its own."""

    def leaf(node: Expr) -> Expr:
        if type(node) is Trig and node.angle.terms in sums:
            whole = Angle.of(sums[node.angle.terms])
            return Trig(node.function, Angle(whole.terms, node.angle.degrees, node.angle.radians))
        return node

    # what is put together again anew loses the root below a line
    return rebuild(expr, leaf) if any(leaf(node) != node for node in walk(expr)) else expr
