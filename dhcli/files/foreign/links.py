"""A link as a listing of the Robotics Toolbox makes it: what its arguments say, as text."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, field

from dhcli.errors import Place, Problem
from dhcli.files.foreign.statements import Call, elements, unbracketed
from dhcli.regex import regex

LINK = regex(r"\b(DHLink|Link|link|Revolute(?:MDH|DH)?|Prismatic(?:MDH|DH)?)\s*\(")
ORDERS = {True: ("theta", "d", "a", "alpha", "sigma", "offset"), False: ("alpha", "a", "theta", "d", "sigma", "offset")}
"""What the numbers of `Link([...])` are, and of `link([...])` before version 9."""
_NAMED = regex(r"(?P<key>[A-Za-z]\w*)\s*=(?!=)\s*(?P<value>.+)", re.DOTALL)
_FLAGS = {"modified": ("mdh", "1"), "standard": ("mdh", "0"), "prismatic": ("sigma", "1"), "revolute": ("sigma", "0")}


@dataclass(slots=True)
class ToolboxLink:
    """What a listing says about a link.

    Attributes:
        label: What it is called, L1 or L(1); empty where it stands in a list.
        line: Where it stands, from 1.
        said: Its arguments by name, as text.
    """

    label: str
    line: int
    said: dict[str, str] = field(default_factory=dict)

    @property
    def slides(self) -> bool:
        """Whether the joint slides: as it says, else where theta is given and d is not."""
        if "sigma" in self.said:
            return self.said["sigma"].strip("'\"").upper() in ("1", "P")
        return "theta" in self.said and "d" not in self.said

    @property
    def own(self) -> str:
        """The column of its variable, whose number the toolbox does not look at."""
        return "d" if self.slides else "theta"


def link_of(call: Call, label: str, place: Place, problems: list[Problem]) -> ToolboxLink:
    """What a call of a link says."""
    said: dict[str, str] = {}
    if call.name.startswith(("Prismatic", "Revolute")):
        said["sigma"] = "1" if call.name.startswith("Prismatic") else "0"
    if call.name.endswith("MDH"):
        said["mdh"] = "1"
    elif call.name in ("RevoluteDH", "PrismaticDH"):
        said["mdh"] = "0"
    said |= options(call.args, place, problems, ORDERS[call.name != "link"])
    return ToolboxLink(label, place.line or 1, said)


def options(args: Sequence[str], place: Place, problems: list[Problem], order: Sequence[str]) -> dict[str, str]:
    """Arguments by name: `'d', 0.1`, `d=0.1`, a vector, or a word that is one by itself."""
    said: dict[str, str] = {}
    waiting = list(args)
    while waiting:
        arg = waiting.pop(0)
        word = arg.strip("'\"") if arg[:1] in "'\"" else ""
        if word in _FLAGS:
            key, value = _FLAGS[word]
            said[key] = value
        elif word and waiting:
            said[word] = waiting.pop(0)
        elif named := _NAMED.fullmatch(arg):
            said[named["key"]] = named["value"]
        elif arg.startswith("["):
            said |= zip(order, elements(unbracketed(arg)), strict=False)
        elif not word:
            problems.append(Problem(f"{arg!r:.60} is not read", place, "write Link('d', 0.1, 'a', 0.4, 'alpha', pi/2)"))
    return said
