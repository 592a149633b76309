"""What it takes to write a function in a language; the languages themselves are data in `languages`."""

from __future__ import annotations

import keyword
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import field, replace

from dhcli.frozen import frozen
from dhcli.notation.styles import RESERVED as TYPED
from dhcli.notation.styles import Style, plain_name
from dhcli.notation.tree import Expr, Number
from dhcli.notation.writer import write
from dhcli.regex import regex
from dhcli.safe import comment, docstring

Cells = Sequence[Sequence[str]]

_WORD = regex(r"\w+")
_FOREIGN = regex(r"[^A-Za-z0-9_]")
TAKEN = frozenset(
    (
        *("T", "J", "q", "pi", "cosine", "solutions", "found", "forward", "jacobian", "inverse", "square"),
        *("cos", "sin", "tan", "sqrt", "pow", "fabs", "abs", "acos", "asin", "atan", "atan2", "zeros", "nargin"),
    )
)
"""Names that stand in the functions themselves, whatever the language."""

RESERVED: Mapping[str, frozenset[str]] = {
    "python": frozenset(keyword.kwlist) | {"math", "abs"},
    "numpy": TYPED["numpy"] | {"abs"},
    "matlab": TYPED["matlab"],
    "c": frozenset(
        (
            *("auto", "break", "case", "char", "const", "continue", "default", "do", "double", "else", "enum"),
            *("extern", "float", "for", "goto", "if", "inline", "int", "long", "register", "restrict", "return"),
            *("short", "signed", "sizeof", "static", "struct", "switch", "typedef", "union", "unsigned", "void"),
            *("volatile", "while", "bool", "true", "false", "nullptr", "constexpr", "typeof", "alignas", "alignof"),
            *("asm", "class", "delete", "new", "private", "public", "template", "this", "namespace", "operator"),
            *("NAN", "INFINITY", "HUGE_VAL", "linux", "unix", "i386", "y0", "y1", "yn", "j0", "j1", "jn", "gamma"),
        )
    ),
    "julia": frozenset(
        (
            *("baremodule", "begin", "break", "catch", "const", "continue", "do", "else", "elseif", "end", "export"),
            *("false", "finally", "for", "function", "global", "if", "import", "in", "isa", "let", "local", "macro"),
            *("module", "quote", "return", "struct", "true", "try", "using", "where", "while", "im", "push"),
            *("Inf", "NaN"),
        )
    ),
    "javascript": frozenset(
        (
            *("abstract", "arguments", "await", "break", "case", "catch", "class", "const", "continue", "debugger"),
            *("default", "delete", "do", "else", "enum", "eval", "export", "extends", "false", "finally", "for"),
            *("function", "if", "implements", "import", "in", "instanceof", "interface", "let", "new", "null"),
            *("package", "private", "protected", "public", "return", "static", "super", "switch", "this", "throw"),
            *("true", "try", "typeof", "var", "void", "while", "with", "yield", "Math", "NaN", "Infinity", "undefined"),
        )
    ),
}
"""Words that a language keeps for itself, constants and macros too."""


@frozen
class Language:
    """How a language writes.

    Attributes:
        name: What the user calls it.
        style: How it spells formulas.
        mark: What begins a comment.
        first: Lines at the top of the file.
        head: The first line of a function: its name, its arguments, what it gives.
        argument: One argument.
        preset: One with a value that it has by default; the same where a language has none.
        let: A name and its value.
        choose: A name, a condition, its value where it holds, and its value elsewhere.
        end: What closes a function or a loop; nothing where indentation does.
        returned: The lines that give a matrix back: what gives its shape, its name, its cells.
        entry: An entry of a matrix that is given: its name, row and column.
        base: Number of the first row.
        signs: A loop over 1 and -1.
        turns: A loop over 0 and π.
        quarters: A loop over the four right angles.
        skip: Leaves a round, or the function, if a condition holds: the condition, and the word for it.
        begin: Makes an empty list of solutions.
        append: Adds a row to it.
        finish: Gives it back.
        unused: Says of an argument that it is not needed, where compilers ask.
    """

    name: str
    style: Style
    mark: str
    first: tuple[str, ...]
    head: str
    argument: str
    preset: str
    let: str
    choose: str
    end: str
    returned: Callable[[Sequence[str], str, Cells], list[str]]
    entry: str
    base: int
    signs: str
    turns: str
    quarters: str
    skip: str
    begin: str
    append: str
    finish: str
    unused: str = ""

    def spelling(self, names: Iterable[str]) -> Spelling:
        """A spelling for names, each an own one that the language accepts."""
        spelled: dict[str, str] = {}
        used = set(RESERVED[self.name] | TAKEN)
        for name in names:
            plain = _FOREIGN.sub("_", plain_name(name))
            while plain in used:
                plain += "_"
            used.add(plain)
            spelled[name] = plain
        return Spelling(self, spelled)

    def function(self, heading: Heading, spelling: Spelling, body: Sequence[str]) -> str:
        """A whole file with one function.

        Args:
            heading: Its name, arguments and description.
            spelling: How its names are spelled.
            body: Its lines, without margin.
        """
        names = spelling.names
        ordered = sorted(heading.lengths, key=lambda name: heading.lengths[name] is not None)
        own = {name: heading.lengths[name] for name in ordered}
        values = {**own, **heading.more}
        arguments = [*heading.given, *(self.argument.format(names[name]) for name in heading.joints)]
        for name, value in values.items():
            form = self.argument if value is None else self.preset
            arguments.append(form.format(names[name], "" if value is None else decimal(value)))
        first = self.head.format(heading.name, ", ".join([*arguments, *heading.filled]), heading.gives)
        said = list(heading.said)
        if self.preset == self.argument and self.name == "c" and (words := _own_values(own, names)):
            said.append(words)
        if self.name == "matlab":
            body = [*_presets(len(arguments) - len(values), values, names), *body]
        body = [*self._spare([*heading.joints, *heading.lengths], spelling, body), *body]
        inside = docstring(*said).split("\n") if self.mark == "#" and self.name != "julia" else []
        above = [] if inside else [comment(line, self.mark).rstrip("\n") for line in said]
        lines = [f"    {line}" if line else "" for line in (*inside, *body)]
        end = [self.end] if self.end else []
        before = self.first if any(self.style.prefix in line for line in body) else ()  # or linters find it unused
        return "\n".join([*before, *above, *first.split("\n"), *lines, *end]) + "\n"

    def _spare(self, given: Iterable[str], spelling: Spelling, body: Sequence[str]) -> Iterator[str]:
        """Lines for what is given and does not stand in the body."""
        used = {word for line in body for word in _WORD.findall(line)} if self.unused else set[str]()
        for name in given if self.unused else ():
            if spelling.names[name] not in used:
                yield self.unused.format(spelling.names[name])


@frozen
class Heading:
    """What stands above the body of a function.

    Attributes:
        name: Its name.
        said: What it does, a line each.
        joints: Joint values that it takes.
        lengths: Lengths that it takes, with the values they have by default.
        more: What it takes behind them, with values by default, that is none of the robot's.
        given: Arguments before those, as they are spelled.
        filled: Arguments behind those, as they are spelled.
        gives: What its result is called, or the type of it.
    """

    name: str
    said: Sequence[str]
    joints: Sequence[str]
    lengths: Mapping[str, float | None]
    more: Mapping[str, float] = field(default_factory=dict)
    given: Sequence[str] = ()
    filled: Sequence[str] = ()
    gives: str = ""


@frozen
class Spelling:
    """How a function in a language spells its names."""

    language: Language
    names: Mapping[str, str]

    def formula(self, expr: Expr) -> str:
        """A formula in those names."""
        if type(expr) is Number:
            return decimal(float(expr.value))
        return write(expr, replace(self.language.style, symbol=self.names.__getitem__))

    def let(self, name: str, value: str) -> str:
        """A line that gives a name its value."""
        return self.language.let.format(self.names[name], value)

    def choose(self, name: str, condition: str, value: str, other: str) -> str:
        """A line that gives a name one value or another."""
        return self.language.choose.format(self.names[name], condition, value, other)


def decimal(value: float) -> str:
    """A number as all of the languages read it, without losing a bit; never minus zero."""
    return repr(float(value) + 0.0)


def _own_values(lengths: Mapping[str, float | None], names: Mapping[str, str]) -> str:
    own = ", ".join(f"{names[name]} = {decimal(value)}" for name, value in lengths.items() if value is not None)
    return f"Of this robot: {own}." if own else ""


def _presets(before: int, lengths: Mapping[str, float | None], names: Mapping[str, str]) -> list[str]:
    """Values by default where a language has none in its headings."""
    return [
        f"if nargin < {before + k}, {names[name]} = {decimal(value)}; end"
        for k, (name, value) in enumerate(lengths.items(), 1)
        if value is not None
    ]
