r"""Text as it stands on a screen or in a paper, down to what was meant: no display environments, no final stop.

What dhcli prints for people has a heading and names for brackets; papers set formulas in `$$`, `\[` or `align` and
end them with a full stop; MATLAB sets a common factor above a matrix. Every step leaves alone
what it does not know for certain, and goes through a text once.
"""

from __future__ import annotations

import re

from dhcli.regex import regex

LONGEST = 200_000
"""Characters of a text with the brackets of `--let` put in."""

_DISPLAY = regex(
    r"\\(?:begin|end)\{(?:equation|align|aligned|alignat|gather|gathered|split|displaymath|math|multline)\*?\}"
    r"|\\(?:tag|label)\{[^{}]{0,60}\}|\\(?:nonumber|notag|hline)\b|\\(?:over|under)brace\{[^{}]{0,60}(?:\{[^{}]{0,60}\}[^{}]{0,60}){0,4}\}[\^_]\{[^{}]{0,20}\}"
    r"|\$\$?|\\\[(?!\s*-?[\d.]+\s*(?:pt|ex|em|mm|cm|in)\s*\])|\\[\]()]"
)
"""What sets a formula apart and is no part of it; a `\\[2pt]` at the end of a row is."""

_INDEX_IN_BRACKETS = regex(r"(?<=\w)_\(([\w+−-]{1,9})\)")  # noqa: RUF001
_TIMES_TEN = regex(r"(?<=[\d.]) ?[xX] ?(?=10 ?(?:\^|\*\*|[⁻⁰¹²³⁴-⁹]))")
"""`8.66 x 10^-3`."""
_NUMBER_OF_EQUATION = regex(r"\\q?quad\s{0,9}\([0-9]{1,3}\.[0-9]{1,3}\)\s{0,99}$")
_ROWS_OF_EQUATIONS = regex(
    r"^\s*(?:\\left\s?\\?[{.]\s{0,9})?\\begin\{(?:array\}\s*\{[rcl ]{1,9}|cases)\}"
    r"|\\end\{(?:array|cases)\}\s{0,9}(?:\\right\s?\\?[}.])?\s*$"
)
_WRAPPED = regex(r"〖([A-Za-z]{1,9})〗")
"""A function as Word sets one that has an exponent, `〖cos〗^(-1)`."""
_HEADING = regex(
    r"^(?:\S{1,20} of .{1,80}: frame \S{1,12} seen from frame \S{1,12}|(?:standard DH|modified DH|product of moves)\b.*"
    r"|[xyz]' points along .*)$"
)
_MORE_HEADING = regex(r"^[^=⎡⎢⎣\[]{1,20} = [^·]{1,40}(?: · .*)?$|^lengths in \w+$")
_LET = regex(r"^[^\S\n]*(?:let[^\S\n]+)?(k[0-9]{1,3})[^\S\n]*=[^\S\n]*(\S.*)$")
_NAME_OF_BRACKET = regex(r"(?<![\w.])k[0-9]{1,3}(?![\w])")
_COMMON_FACTOR = regex(r"\s*([0-9](?:\.[0-9]{1,20})?[eE][+-]?[0-9]{1,3})[^\S\n]*\*[^\S\n]*\n")
_STYLED = regex(r"[\U0001d400-\U0001d7ff\u210e\uff01-\uff5e\u3000\u2460-\u24ff]")
_LOWERED = regex(r"[\u2080-\u208e\u2090-\u209c\u1d62-\u1d6a\u2c7c]{1,12}")
"""An index in small letters, digits and signs, `αᵢ₋₁`."""
_SIGNS = {
    "ᵀ": "^T",
    "⟨": "(",
    "⟩": ")",
    "〈": "(",
    "〉": ")",
    "、": ",",
    "î": "i",
    "ĵ": "j",
    "\u0302": "",
    "½": "(1/2)",
    "⅓": "(1/3)",
    "⅔": "(2/3)",
    "¼": "(1/4)",
    "¾": "(3/4)",
    "〖": "(",
    "〗": ")",
    **dict.fromkeys("\u2061\u2063\u200b\u2060\ufeff\u00ad", ""),
    "\u2062": "*",
}
"""What stands around vectors and in those of their axes, to the hat of k̂; fractions in one sign; what no eye sees."""
_MIXED = regex(r"(?<![\w.,])([0-9]{1,30})([½⅓⅔¼¾])")
"""A mixed number: 2½ is two and a half, not twice a half."""


def plain(text: str) -> str:
    """A formula without what a paper or a screen sets around it, and without the stop at its end."""
    if "\\" in text or "$" in text:
        text = _DISPLAY.sub(" ", text)
    if "seen from frame" in text or "let k" in text:
        text = _for_people(text)
    if "_(" in text:
        text = _INDEX_IN_BRACKETS.sub(r"_{\1}", text)
    if "10" in text:
        text = _TIMES_TEN.sub("*", text)
    if "^{*}" in text:
        text = text.replace("^{*}", "*")
    text = _NUMBER_OF_EQUATION.sub("", text)
    stripped = text.rstrip(" \t\r\n.,;&")
    while stripped.endswith("\\\\"):
        stripped = stripped[:-2].rstrip(" \t\r\n.,;&")
    return stripped


def unstyled(text: str) -> str:
    """A text with plain letters, digits and signs for those that papers set and wide keyboards type: 𝜃 is θ.

    A raised T, angle brackets of a vector and ½ become what is read there, an index of small letters `_{i-1}`, a
    matrix of Word's `■(a&b@c&d)` rows with semicolons; letters that only look alike stay.
    """
    if text.isascii():
        return text
    from unicodedata import normalize  # few texts need it

    def index(match: re.Match[str]) -> str:
        plain = normalize("NFKC", match[0]).replace("−", "-")  # noqa: RUF001
        return match[0] if plain.isdecimal() else f"_{{{plain}}}"

    if "■" in text or "█" in text:
        text = text.replace("■", "").replace("█", "").replace("@", ";")
    text = _LOWERED.sub(index, _WRAPPED.sub(r"\1", text))
    styled = "".join(normalize("NFKC", one) if _STYLED.match(one) else one for one in text)
    return "".join(_SIGNS.get(one, one) for one in _MIXED.sub(r"(\1+\2)", styled))


def equations(text: str) -> str:
    r"""A list of equations without the `\begin{array}{rcl}` or `\begin{cases}` around it."""
    is_list = "=" in text and ("\\begin{array}" in text or "\\begin{cases}" in text)
    return _ROWS_OF_EQUATIONS.sub(" ", text) if is_list else text


def with_factor(text: str) -> str:
    """A matrix under MATLAB's `1.0e+03 *` as that number times the matrix."""
    found = _COMMON_FACTOR.match(text)
    return f"{found[1]}*[{text[found.end() :].strip()}]" if found else text


def _for_people(text: str) -> str:
    """What dhcli prints for people without its heading, and with the brackets in the place of their names."""
    kept: list[str] = []
    brackets: dict[str, str] = {}
    for line in text.split("\n"):
        named = _LET.match(line)
        if named:
            brackets[named[1]] = f"({_put_in(named[2].strip(), brackets)})"
        elif not _HEADING.match(line) and not (not kept and _MORE_HEADING.match(line) and "·" in line):
            kept.append(line)
        if sum(map(len, brackets.values())) > LONGEST:
            return text
    found = _put_in("\n".join(kept), brackets)
    return found if len(found) <= LONGEST else text


def _put_in(text: str, brackets: dict[str, str]) -> str:
    return _NAME_OF_BRACKET.sub(lambda name: brackets.get(name[0], name[0]), text) if brackets else text
