"""Valid texts made invalid, or only odd: a seed decides how, so that every finding comes again."""

from __future__ import annotations

import random
import re

TOKENS = (
    *("0", "1", "-1", "90°", "30", "1e400", "1e-400", "1e-60", "1e19", "007", "0x10", "1_000", "nan", "inf", "-inf"),
    *("π", "pi", "√3/2", "½", "³", "٣", "−", "–", "°", "′", "°°", "mm", "m", "deg", "rad", "km", "1 m m", "2 m 3"),
    *("theta1", "theta_{1}", "θ1", "a1", "l1", "q1", "elbow-joint", "c1", "s12", "c(1)", "x" * 50, "'", '"'),
    *("sin(", "cos(90°)", "sqrt(-1)", "1/0", "1/(a1-a1)", "2^0.5", "2^-3", "1e-60^5", "factorial(9)", "abs(-3)"),
    *("(", ")", "[", "]", "{", "}", "((((", "]]]]", ",", ";", ":", "..", "...", "|", "&", "\\\\", "\\frac{1}{2}"),
    *("Rot(z,90°)", "Trans(1,0,0)", "Rot(", "Trans(nan,0,0)", "step", "n", "0..1", "1..0", "a=b=c", "=", "=1+1", "@x"),
    *(
        "R",
        "P",
        "6R",
        "20000-R",
        "!",
        "4 pin",
        "loop",
        "null",
        "~",
        "true",
        "- ",
        "? ",
        "*x",
        "&x",
        "!!python",
        "%",
        "#",
    ),
    *(" ", "  ", "\t", "\n", "\r\n", "\0", "\x1b[31m", "\x9b", "\u202e", "\u200b", "\ufeff", "\u2028", "\ud800", "🤖"),
)
_PIECES = re.compile(r"[A-Za-z_]+|[0-9.]+|\s+|[^\w\s]")
REPEATED = (2, 3, 10, 60)


def mutated(text: str, chance: random.Random) -> str:
    """A text with one to three changes."""
    for _ in range(chance.choice((1, 1, 1, 2, 3))):
        text = _changed(text, chance)
    return text


def mutated_bytes(content: bytes, chance: random.Random) -> bytes:
    """A file that is no text any more, perhaps: bytes turned, cut off, doubled."""
    if not content:
        return b"\xff"
    at = chance.randrange(len(content))
    match chance.randrange(4):
        case 0:
            return content[:at]
        case 1:
            return content[:at] + bytes([chance.randrange(256)]) + content[at + 1 :]
        case 2:
            return content[:at] + content[at : at + 40] * 5 + content[at:]
    return content[:at] + content[at + chance.randrange(1, 9) :]


def _changed(text: str, chance: random.Random) -> str:
    pieces = [found.span() for found in _PIECES.finditer(text)] or [(0, len(text))]
    start, end = chance.choice(pieces)
    other = chance.choice(pieces)
    token = chance.choice(TOKENS)
    match chance.randrange(8):
        case 0:  # another word in the place of one
            return text[:start] + token + text[end:]
        case 1:  # one more
            return text[:start] + token + text[start:]
        case 2:  # one less
            return text[:start] + text[end:]
        case 3:  # over and over
            return text[:start] + text[start:end] * chance.choice(REPEATED) + text[end:]
        case 4:  # from elsewhere
            return text[:start] + text[other[0] : other[1]] + text[end:]
        case 5:  # cut off
            return text[:end]
        case 6:  # a token over and over
            return text[:start] + token * chance.choice(REPEATED) + text[start:]
    lines = text.split("\n")  # two lines change places, or one stands twice
    one, two = chance.randrange(len(lines)), chance.randrange(len(lines))
    lines[one] = lines[two]
    return "\n".join(lines)
