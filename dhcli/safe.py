"""Text that somebody else wrote, made safe for where it goes: one function for each medium, and nothing else does it.

Foreign is every text that dhcli did not make itself: names of files, titles, answers, what is typed. Nothing in it may
steer a terminal, leave a comment of generated code, or become a formula, a command or a tag. A test holds the rooms
above to these functions (`tests/cli/test_foreign_text.py`).
"""

from __future__ import annotations

import re

from dhcli.regex import regex

_FORMULA = tuple("=+-@＝＋－＠")  # noqa: RUF001  the wide ones begin a formula as well
_NAME = regex(r"[A-Za-z][A-Za-z0-9_-]*(?:/[A-Za-z0-9_-]+)?")
_LATEX = {
    "\\": r"\textbackslash{}",
    "{": r"\{",
    "}": r"\}",
    "^": r"\textasciicircum{}",
    "~": r"\textasciitilde{}",
    **{sign: f"\\{sign}" for sign in "$&#%_"},
}
_MARKDOWN_SIGN = regex(r"[!#$&*<>@\[-`{-~]|^[-+=]|:(?=//)|(?i:(?<=www)\.)")
"""What begins or ends something in a line, or a line; a comma does not, and a page full of `\\,` reads badly."""
_MARKDOWN_NUMBER = regex(r"^(\d+)(?=[.)])")
_LATEX_SIGN = regex(r"[\\{}^~$&#%_]")


def one_line(text: str) -> str:
    """A text on one line of a terminal: controls, marks that turn the direction of writing, line ends become blanks."""
    return text if text.isprintable() else "".join(letter if letter.isprintable() else " " for letter in text)


def comment(text: str, mark: str) -> str:
    """A comment of a program on one line, which nothing in the text can end.

    Nor can it go on in the next line, as in C behind a backslash, which `??/` is too.

    Args:
        text: What it says.
        mark: What begins a comment in that language: `#`, `%`.
    """
    said = f"{mark} {one_line(text)}".rstrip()
    return f"{said}.\n" if said.endswith(("\\", "??/")) else f"{said}\n"


def docstring(*lines: str) -> str:
    """A docstring of Python, which nothing in its lines can end: a summary, and what stands below it."""
    first, *more = (one_line(text).replace("\\", "/").replace('"', "'") for text in lines)
    return "\n".join([f'"""{first}', "", *more, '"""']) if more else f'"""{first}"""'


def csv_cell(text: str) -> str:
    """A cell that no spreadsheet takes for a formula; quotes are for the writer of the whole line.

    Source: OWASP, CSV injection: an apostrophe before what begins like one; full-width signs count too, and so does
    what stands behind blanks, tabs or letters without width.
    """
    said = one_line(text)
    is_formula = said.lstrip().startswith(_FORMULA) or text.startswith(("\t", "\r", "\n"))
    return f"'{said}" if is_formula else said


def yaml_scalar(text: str) -> str:
    """A text as one value in YAML; in quotes unless it is plainly a name, or the id of an exercise."""
    if _NAME.fullmatch(text):
        return text
    if text.isprintable() and "'" in text and not {'"', "\\"} & set(text):
        return f'"{text}"'
    if text.isprintable():
        return "'" + text.replace("'", "''") + "'"
    import json

    return json.dumps(text)  # controls and letters without width in double quotes, spelled by their numbers


def latex(text: str) -> str:
    """Plain text in LaTeX, outside formulas."""
    return _LATEX_SIGN.sub(lambda sign: _LATEX[sign[0]], one_line(text))


def markdown(text: str) -> str:
    """Plain text in Markdown, on one line: no emphasis, link, tag, formula, list or heading begins in it.

    Source: CommonMark 0.31, 2.4: any ASCII punctuation may be escaped; GitHub's extensions for links without brackets.
    """
    return _MARKDOWN_NUMBER.sub(r"\1\\", _MARKDOWN_SIGN.sub(r"\\\g<0>", one_line(text).strip()))


def markdown_heading(level: int, text: str) -> str:
    """A heading in Markdown, on one line."""
    return f"{'#' * level} {markdown(text)}"


def markdown_code(text: str) -> str:
    """A piece of code in Markdown, on one line: nothing in it ends it."""
    said = one_line(text).replace("`", "'")
    return f"`{said}`"


def html(text: str) -> str:
    """Plain text in HTML and SVG, also between the quotes of an attribute."""
    from html import escape

    return escape(one_line(text), quote=True)


def xml_attribute(text: str) -> str:
    """The value of an attribute in XML, with its quotes."""
    return f'"{html(text)}"'


def xml_comment(text: str) -> str:
    """A comment of XML on one line, which nothing in the text can end: two hyphens may not stand in one."""
    return f"<!-- {re.sub('-{2,}', '-', one_line(text))} -->"
