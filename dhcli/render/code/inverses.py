"""A derivation as a function that returns every solution, in each language."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

from dhcli.errors import plural
from dhcli.kinematics.derived import in_floats
from dhcli.kinematics.inverse.derivation import Derivation
from dhcli.kinematics.inverse.derive_rules import FAINT
from dhcli.kinematics.inverse.derive_words import atom_text
from dhcli.notation.angle import Angle
from dhcli.notation.tree import (
    HALF,
    ONE,
    ZERO,
    Call,
    Expr,
    Power,
    Product,
    Sum,
    Symbol,
    Trig,
    add,
    is_negative,
    negate,
    power,
)
from dhcli.notation.walk import symbols, walk
from dhcli.regex import regex
from dhcli.render.code.functions import lengths_words, robot_words
from dhcli.render.code.language import Heading, Spelling
from dhcli.render.code.languages import LANGUAGES
from dhcli.render.code.stages import Stage, Stages, entries_used, lengths_used, shared
from dhcli.render.look import Look
from dhcli.render.text.forward import frame_words

_ALWAYS_ALL = 3
"""So many joints have formulas that say something wherever the arm can be."""

_ONE = "1 + 1e-9"
"""A cosine up to this is one of 1: that of an arm stretched out is 1 but for rounding, of a pose in a file too."""

_NOTHING = "1e-9"
"""A sine and a cosine up to this say nothing of their angle."""

_TOLERANCE, _TYPED = "tolerance", 1e-3
"""How far beside the pose joint values may lead: a pose typed with four decimals asks for so much."""

_PI = regex(r"\bpi\b")


def inverse_code(result: Derivation, look: Look) -> str:
    """A file with one function: a pose and lengths in, a list of joint values out, all in joint order."""
    language = LANGUAGES[look.format]
    lengths, entries, stages = lengths_used(result), list(entries_used(result)), shared(result)
    unknown = [stage.name for stage in stages.steps]
    names = [*lengths, *(name for name, _, _ in entries), *unknown]
    names += [one.name for one in stages.formulas.definitions]
    names += [f"{kind}_{name}" for name in unknown for kind in ("sign", "turn", "cosine")]
    more = {_TOLERANCE: _TYPED} if stages.gaps else {}
    spelling = language.spelling([*more, *names])
    joints = [spelling.names[name] for name in result.joints]
    own = {name: None if (v := result.robot.parameters[name]) is None else in_floats(v) for name in lengths}
    said = list(_said(result, stages, joints, spelling, more))
    heading = Heading("inverse", said, (), own, more, ("T",), gives="solutions")
    if language.name == "c":
        given, filled = ("const double T[4][4]",), (f"double solutions[][{len(joints)}]",)
        heading = replace(heading, given=given, filled=filled, gives="int")
    b = language.base
    body = [spelling.let(name, language.entry.format("T", i - 1 + b, k - 1 + b)) for name, i, k in entries]
    body += [language.begin, *_Nest(spelling, stages, joints, lengths).lines(), *language.finish.split("\n")]
    if language.name == "c" and any(map(_PI.search, body)):
        body.insert(0, "const double pi = 3.14159265358979323846;")
    return language.function(heading, spelling, [line for line in body if line.strip()])


def _said(
    result: Derivation, stages: Stages, joints: Sequence[str], spelling: Spelling, more: Mapping[str, float]
) -> Iterator[str]:
    """What the function takes and gives."""
    robot = result.robot
    of = "the position in the pose T" if result.place_only else "the pose T"
    yield f"Every solution of {robot.name} for {of} of {frame_words(result.end)} seen from {frame_words(result.start)}."
    yield f"{robot_words(robot)}; radians and metres."
    yield f"Joint values of each, in this order: {', '.join(joints)}; at most {plural(result.branches, 'solution')}."
    if len(joints) > _ALWAYS_ALL:
        yield "At a singular pose, where a formula says nothing, some of them may be missing."
    if tried := [atom_text(stage.step.atom) for stage in stages.steps if stage.is_tried]:
        yield f"Where {', or '.join(tried)} is free, four values of it are tried: at most {stages.most}."
    if spelling.language.name == "c":
        yield f"Returns how many there are; solutions has room for {plural(stages.most, 'row')}."
    if more:
        name, kinds = spelling.names[_TOLERANCE], "m" if result.place_only else "m and direction cosines"
        typed = f"{_TYPED:g} allows for a pose typed with four decimals"
        yield f"Each leads back there within {name} [{kinds}]; {typed}."
    yield from lengths_words(robot, {name: spelling.names[name] for name in lengths_used(result)})
    yield f"Source: {robot.source}"


class _Nest:
    """The loops, one inside the other, with what each line needs before it."""

    def __init__(self, spelling: Spelling, stages: Stages, joints: Sequence[str], lengths: Sequence[str]) -> None:
        self.spelling, self.language, self.joints, self.stages = spelling, spelling.language, joints, stages
        self.waiting = {one.name: one.expr for one in stages.formulas.definitions}
        self.steady, self.depth = set(lengths), 0

    def lines(self) -> Iterator[str]:
        early = [gap for gap in self.stages.gaps if not self.unknown(gap)]
        late = [gap for gap in self.stages.gaps if gap not in early]
        for lines in (self.checks(early), *map(self.stage, self.stages.steps), self.checks(late), self.found()):
            for line in lines:
                margin = "    " * self.depth
                yield from (f"{margin}{part}" for part in line.split("\n"))
                self.depth += line.startswith("for ")
        for level in reversed(range(self.depth)):
            yield "    " * level + self.language.end

    def unknown(self, expr: Expr) -> bool:
        """Whether a formula needs a joint value."""
        found = {stage.name for stage in self.stages.steps}
        return any(
            name in found or (name in self.waiting and self.unknown(self.waiting[name])) for name in symbols(expr)
        )

    def checks(self, gaps: Sequence[Expr]) -> Iterator[str]:
        """The lines that leave joint values out which do not lead back to the pose."""
        for gap in gaps:
            yield from self.needed(gap)
            first = gap.terms[0] if type(gap) is Sum else gap
            size = self.spelling.formula(Call("abs", (negate(gap) if is_negative(first) else gap,)))
            yield self.left_if(f"{size} > {self.spelling.names[_TOLERANCE]}")

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
        elif stage.is_tried:
            turn = spelling.names[f"turn_{stage.name}"]
            yield language.quarters.format(turn)
            yield from self.needed(stage.value)
            beside = Product((Call("abs", (Trig("sin", Angle.of(f"turn_{stage.name}")),)), _size(stage.value)))
            yield self.left_if(f"{spelling.formula(beside)} > {_NOTHING}")
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
            value = self.turned(stage, value)
        if stage.instead is None:
            yield spelling.let(stage.name, spelling.formula(value))
            return
        yield from self.needed(stage.instead)
        own, other = (spelling.formula(_size(arc)) for arc in (stage.value, stage.instead))
        instead = spelling.formula(self.turned(stage, stage.instead) if two else stage.instead)
        yield spelling.choose(stage.name, f"{own} > {FAINT}*({other})", spelling.formula(value), instead)

    def turned(self, stage: Stage, value: Expr) -> Expr:
        """A value, and what the loop adds to it."""
        return Sum((value, Symbol(f"turn_{stage.name}")))

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
        used = frozenset().union(*(symbols(expr) for expr in formulas if expr is not None))
        for name in [name for name in self.waiting if name in used]:
            if name in self.waiting:
                part = self.waiting.pop(name)
                yield from self.needed(part)
                self.steady |= {name} if symbols(part) <= self.steady else set()
                yield from self.divisible(part)
                yield self.spelling.let(name, self.spelling.formula(part))


def _size(arc: Expr) -> Expr:
    """How large the sine and the cosine are of which an angle is that."""
    assert isinstance(arc, Call), "an angle of a sine and a cosine"  # noqa: S101
    return add(*(Call("abs", (part,)) for part in arc.arguments))


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
