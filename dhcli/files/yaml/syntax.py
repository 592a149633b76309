"""What PyYAML says about a syntax error, in words for someone who has never read the YAML specification."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Protocol

from dhcli.errors import Place, Problem
from dhcli.regex import regex
from dhcli.safe import yaml_scalar

if TYPE_CHECKING:
    import yaml

_QUOTED = regex(r"'[^']*'|\"[^\"]*\"")
_NAME_WITH_BRACE = regex(r"[\w^)}\]][{\[]")
_BRACE_HINT = "a name with braces or brackets needs quotes, such as 'alpha_{i-1}'"

_KEY = regex(r"[{,]\s*([\w-]+):\s+")
_ONE_UNIT = regex(r"\[([^\[\]]*)\]\s*(°|deg|rad|mm|cm|m|in)")
_IN_LIST_OR_MAPPING = regex(r"-(?:\s|$)|[^\n]{0,200}:(?:\s|$)")
_GLUED = regex(r"([\w-]+):(\S.*)")
_EQUALS = regex(r"([\w-]+)\s*=\s*(\S.*)")
_NEXT_KEY = regex(r",\s*[\w-]+:\s")
_ENDED = regex(r"['\"]\s*$")
_QUOTES = ("'", '"')
_OPENING = {quote: regex(rf"(?:(?<=[\[{{,\s])|^)([\w-]+:\s+)?{quote}") for quote in _QUOTES}
_CLOSING = {quote: regex(rf"{quote}\s*(?:#.*)?$") for quote in _QUOTES}
_CLOSING_IN_BRACKETS = {quote: regex(rf"{quote}\s*(?:[,}}\]]|$)") for quote in _QUOTES}
"""Where a text in quotes begins, and where it ends; its key."""
_SEPARATED = "entries are separated by ', '; a value with a comma, a colon or a quote in it needs quotes around it"

DEEPEST = 40
TOO_DEEP = f"lists and mappings are nested more than {DEEPEST} deep"

# A part of PyYAML's message (both parsers'), whether its context mark is the better place, our message, our hint.
_PHRASES: tuple[tuple[str, bool, str, str], ...] = (
    ("maximum nesting depth", False, TOO_DEEP, ""),  # libyaml has a limit of its own and reads ahead of ours
    ("quoted scalar found unexpected", True, "this quote is never closed", "close it, or write the text without"),
    (
        "found unknown escape character",
        False,
        "a backslash in double quotes begins an escape, and this is none",
        "use single quotes, as in '\\sin'",
    ),
    ("escape", False, "this escape in double quotes is not one that YAML knows", "use single quotes"),
    (
        "sequence entries are not allowed",
        False,
        "a list cannot begin on the line of its key",
        "put each '- entry' on a line of its own; a minus sign has no space after it",
    ),
    ("mapping keys are not allowed", False, "'? ' cannot stand here", "text needs quotes"),
    ("scanning a block scalar", True, "'|' and '>' begin a block of text", "text that begins with them needs quotes"),
    ("scanning an alias", True, "'*' begins a YAML alias", "text that begins with '*' needs quotes"),
    ("scanning an anchor", True, "'&' begins a YAML anchor", "text that begins with '&' needs quotes"),
    (" tag", True, "'!' begins a YAML tag", "text that begins with '!' needs quotes"),
    ("directive", True, "a line cannot begin with '%'", "use # for a comment"),
    ("incompatible YAML document", False, "this version of YAML is not known", "delete the line"),
    ("node content", False, "a value is missing here", "text that begins with a bracket or comma needs quotes"),
    (
        "block collection",
        False,
        "this line does not go on the list above it",
        "the '- ' of one list stand in one column",
    ),
)


class Mark(Protocol):
    """What the marks of both PyYAML parsers have, counted in characters."""

    @property
    def line(self) -> int:
        """Line from 0."""

    @property
    def column(self) -> int:
        """Column from 0."""


def explain_syntax(error: yaml.MarkedYAMLError, lines: Sequence[str], place: Callable[[Mark | None], Place]) -> Problem:
    """Say what is wrong in plain words."""
    here = place(error.problem_mark)
    start = place(error.context_mark) if error.context_mark else here
    context, said = error.context or "", error.problem or ""
    indent = here.text[: len(here.text) - len(here.text.lstrip())]
    if "\t" in indent:
        place_of_tab = replace(here, column=indent.index("\t") + 1)
        return Problem("a tab indents this line; YAML wants spaces", place_of_tab, "two spaces a level are usual")
    if "mapping values are not allowed" in said:
        return _explain_colon(here, lines)
    is_in_brackets = "expected ',' or" in said
    if _ENDED.search(_split(here)[0]) and (quoted := _explain_quotes(here, is_in_brackets=is_in_brackets)):
        return quoted
    if is_in_brackets:
        return _explain_bracket(here, start)
    if context == "while parsing a block mapping" or "document start" in said or _split(here)[1].startswith(":"):
        return _explain_leftover(here, start, lines)
    if "could not find expected ':'" in said:
        return _explain_line(start, lines)
    return _explain_phrase(here, start, f"{context} {said}".strip())


def _explain_phrase(here: Place, start: Place, said: str) -> Problem:
    """One of the messages that mean the same wherever they come."""
    if "cannot start any token" in said:
        first = _split(here)[1][:1]
        if first == "\t":
            return Problem("a tab stands here; YAML wants a space", here)
        return Problem(f"a value cannot begin with '{first}'", here, "put it in quotes")
    for phrase, at_start, message, hint in _PHRASES:
        if phrase in said:
            return Problem(message, start if at_start else here, hint)
    return Problem(f"not valid YAML: {said}", here)


def _explain_line(start: Place, lines: Sequence[str]) -> Problem:
    """A line among keys that has no colon."""
    line = start.text.strip()
    above = next((text.strip() for text in reversed(lines[: (start.line or 1) - 1]) if text.strip()), "")
    slip = _GLUED.match(line) or _EQUALS.match(line)
    if above.endswith(("|", ">")):
        hint = f"text below '{above}' is indented more than its key"
    elif line.startswith(("//", "%", "/*", ";")):
        hint = "use # for a comment"
    elif slip:
        hint = f"a colon and a space stand behind a key: {slip[1]}: {slip[2]}"
    else:
        hint = "a colon needs a space after it; text that goes on must be indented more than its key"
    return Problem("this line is neither 'key: value' nor '- entry'", start, hint)


def _explain_colon(here: Place, lines: Sequence[str]) -> Problem:
    """A `: ` where no key can end."""
    before, _ = _split(here)
    if ": " in before:
        entries = before[len(before) - len(before.lstrip("- ")) :] + here.text[len(before) :]
        hint = f"several keys on one line stand in braces: {{{entries.strip()}}}" if _NEXT_KEY.search(entries) else ""
        return Problem("a second ': ' stands in one value", here, hint or "a value with a colon needs quotes")
    above = next((line.strip() for line in reversed(lines[: (here.line or 1) - 1]) if line.strip()), "")
    hint = "keys of one mapping start in one column"
    if re.match(r"[\w-]+:\S", above):
        hint = "in the line above, the colon needs a space after it"
    elif above and ":" not in above:
        hint = "the line above has no ': ' after its key"
    indent = len(before) - len(before.lstrip())
    return Problem("this key cannot stand here", replace(here, column=indent + 1), hint)


def _explain_bracket(here: Place, start: Place) -> Problem:
    """A list or mapping in brackets that does not go on as it should; `start` is its opening bracket."""
    opening = _split(start)[1][:1]
    closing = "}" if opening == "{" else "]"
    at_end = not _split(here)[1].strip()
    braces = _BRACE_HINT if _has_name_with_brace(start.text) or _has_name_with_brace(here.text) else ""
    if here.line == start.line and not at_end:
        message = f"',' or '{closing}' should stand here"
        return Problem(message, here, braces or (opening == "{" and _in_quotes(here)) or _SEPARATED)
    message = f"this '{opening}' is never closed" if at_end else f"this '{opening}' is still open on line {here.line}"
    return Problem(message, start, braces or f"'{closing}' is missing, or a ',' between two entries")


def _explain_quotes(here: Place, *, is_in_brackets: bool) -> Problem | None:
    """A quote that ends a text before its end, as the apostrophe in 'l'avant'; None if it is not that."""
    before, rest = _split(here)
    quote = before.rstrip()[-1]
    starts = [found for found in _OPENING[quote].finditer(before) if found.end() < len(before.rstrip())]
    end = (_CLOSING_IN_BRACKETS if is_in_brackets else _CLOSING)[quote].search(rest)
    if not rest or rest.startswith(_QUOTES) or (is_in_brackets and not end):
        return None
    hint = "in single quotes an apostrophe is written twice: ''" if quote == "'" else "use single quotes around it"
    if starts and end:
        text = before[starts[-1].end() :] + rest[: end.start()]
        hint = f"write {starts[-1][1] or ''}{yaml_scalar(text)}"
    return Problem("text follows the closing quote", here, hint)


def _in_quotes(here: Place) -> str:
    """The value in which brackets or quotes have led astray, in the quotes that it needs; nothing if it is not that."""
    before, rest = _split(here)
    keys = list(_KEY.finditer(before))
    behind = _NEXT_KEY.search(rest)
    end = behind.start() if behind else rest.rfind("}")
    if not keys or end < 0 or rest.startswith(":") or _KEY.match(f",{rest}"):
        return ""
    text = (before[keys[-1].end() :] + rest[:end]).strip()
    if text[:1] in ("'", '"') and text[:1] == text[-1:]:
        text = text[1:-1]
    if measured := _ONE_UNIT.fullmatch(text):
        unit = measured[2] if measured[2] == "°" else f" {measured[2]}"
        values = ", ".join(f"{value.strip()}{unit}" for value in measured[1].split(","))
        return f"the unit stands behind each number: [{values}]"
    return f"write {keys[-1][1]}: {yaml_scalar(text)}"


def _explain_leftover(here: Place, start: Place, lines: Sequence[str]) -> Problem:
    """Something that is no part of what stands before it."""
    before, rest = _split(here)
    above = next((text for text in reversed(lines[: (here.line or 1) - 1]) if text.strip()), "")
    column = len(above) - len(above.lstrip()) + 1
    message, hint = "this line does not line up with the lines above it", "keys of one mapping start in one column"
    if rest.startswith(("}", "]")):
        message, hint = f"this '{rest[0]}' closes nothing", "delete it, or open it"
    elif rest.startswith(":"):
        message, hint = "a key is missing before ':'", ""
    elif rest.startswith("%"):
        message, hint = "a line cannot begin with '%'", "use # for a comment"
    elif before.strip():
        message, hint = "this does not belong to the value before it", "the whole value may need quotes"
    elif column > (here.column or 1) and not _IN_LIST_OR_MAPPING.match(rest):
        message = "this line stands further left than the text above it"
        hint = f"the lines of one text start in one column, here in column {column}"
    elif rest.startswith("-"):
        message, hint = "a list entry stands among the keys", "entries of a list stand under their key"
        if above.lstrip().startswith("- "):
            message = "this '- ' does not stand below that of the entry above"
            hint = f"the '- ' of one list stand in one column, here in column {above.index('-') + 1}"
    elif start is not here:
        hint = f"the keys above start in column {start.column}"
    return Problem(message, here, hint)


def _split(place: Place) -> tuple[str, str]:
    """What stands in the line of a place before it, and from it on."""
    column = (place.column or 1) - 1
    return place.text[:column], place.text[column:]


def _has_name_with_brace(line: str) -> bool:
    """Whether an unquoted name such as `alpha_{i-1}` stands in a line."""
    return bool(_NAME_WITH_BRACE.search(_QUOTED.sub(" ", line)))
