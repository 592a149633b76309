"""What an author may have meant by an `ask:` that asks nothing that is known."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence

from dhcli.checking.wanted import NotAskedError
from dhcli.errors import NotationError, nearest
from dhcli.regex import regex

_SPELLINGS = (
    (regex(r"(?:\b[Tt]_?\{?|\bpose\s+)([0-9])([0-9])\}?(?![\w.])"), r"pose \1..\2"),
    (
        regex(r"(?:\b[Tt]_?|\bpose\s+)\{?([0-9]{1,2})\s*(?:to|-|–|→|,|;|\.{1,3}|)\s*([0-9]{1,2})\}?(?![\w.])"),  # noqa: RUF001
        r"pose \1..\2",
    ),
    (regex(r"(?:\blink\s+)?\bA_?\{?([0-9]{1,2})\}?(?![\w.])"), r"link \1"),
    (regex(r"\bentry\s*\(?([0-9])\s*,?\s*([0-9])\)?(?=\s)"), r"entry \1 \2"),
    (regex(r"\bproduct\s+([^\"\s][^\"]*)"), r'product "\1"'),
    (regex(r"\b(?:the )?(?:jacobian(?: matrix)?|J)(?![\w.])", re.IGNORECASE), "jacobian"),
    (regex(r"\b(?:the )?(linear|angular|space|body|analytic \w+) jacobian\b", re.IGNORECASE), r"jacobian \1"),
    (regex(r"\bdet(?:erminant)?\s*(?:of )?\(?(jacobian[^()]*)\)?", re.IGNORECASE), r"determinant of \1"),
    (regex(r"\b(rank|manipulability)\s*(?:of )?\(?(jacobian[^()]*)\)?", re.IGNORECASE), r"\1 of \2"),
    (regex(r"\Alinear velocity\b"), "velocity"),
    (
        regex(r"\A(?:the )?singular(?:ities| poses| configurations)?\b(?! when)(?: of| when)?", re.IGNORECASE),
        "singular when",
    ),
    (regex(r"\A(?:the )?(?:dof|degrees of freedom|mobility) (?:of )?(?:the )?", re.IGNORECASE), "count mobility "),
    (regex(r"\A(?:the )?(?:count|number of) (links|joints) (?:of |in )?(?:the )?", re.IGNORECASE), r"count \1 "),
    (regex(r"\A(?:the )?number of solutions\b"), "count solutions"),
    (regex(r"\A(?:the )?(?:DH )?(?:table )?(standard|modified)(?: DH)?(?: table)?\Z", re.IGNORECASE), r"table \1"),
    (regex(r"\A(a|alpha|d|theta)\s+(?:of (?:link|row) )?([0-9]{1,2})\Z"), r"cell \1 \2"),
    (regex(r"\A(?:the )?([xyz])[ -]axis of\b"), r"axis \1 of"),
    (regex(r"\A(?:the )?roll,? pitch,?(?: and)? yaw (?:angles )?of\b"), "rpy of"),
    (regex(r"\A([xyz]{3}) (?:angles )?of\b"), r"euler \1 of"),
    (regex(r"\A(?:the )?(?:joint )?torques? (?:for )?(?=\()"), "torques for "),
    (regex(r"\A(?:the )?rates for\b"), "joint rates for"),
    (regex(r"\A(?:the )?joint values (?:of|for)\b"), "joints of"),
    (regex(r"\A(.*\b(?:jacobian|velocity|torques|rates|differential)\b.*\bof) pose(?= [0-9])", re.DOTALL), r"\1"),
)
"""`T02`, `T_{02}`, `pose 0-2` and `pose 0 to 2` are `pose 0..2`, `A_2` is `link 2`, `entry (1, 4)` is `entry 1 4`,
`det J` is `determinant of jacobian`, `number of links of press` is `count links press`, `standard table` is
`table standard`, `velocity of pose 0..3` is `velocity of 0..3`, for a velocity is no piece of a pose."""

_CALLED = {
    "dh": "table standard",
    "denavit": "table standard",
    "ik": "joints of position (0.5, 0.3, 0)",
    "inverse kinematics": "joints of position (0.5, 0.3, 0)",
    "forward kinematics": "pose 0..3",
    "fk": "pose 0..3",
    "transformation": "pose 0..3",
    "matrix": "pose 0..3",
    "orientation": "rotation of pose 0..3",
    "dof": "count mobility four-bar",
    "degrees": "count mobility four-bar",
    "mobility": "count mobility four-bar",
    "multiple": "choice",
    "select": "choice",
    "forces": "torques for (f_x, f_y, 0) of 0..3",
}
"""How else a question is called, by its first words."""

_FEW = ("link 1", "pose 0..3", "position of pose 0..3", "table standard", "joints of position (0.5, 0.3, 0)")
_FEW_MORE = ("jacobian of 0..3", "singular when linear of 0..3", "count mobility four-bar", "choice")


def hint_for(text: str, unknown: str, examples: Sequence[str], read: Callable[[str], object]) -> str:
    """What to write instead.

    Args:
        text: All that was asked.
        unknown: The part of it that is not known.
        examples: How each kind of question is asked.
        read: Reads a question, and raises where there is none.
    """
    spelled = text
    for spelling, written in _SPELLINGS:
        spelled = spelling.sub(written, spelled)
    if spelled != text and _is_read(spelled, read):
        return f"write {spelled}"
    words = unknown.lower().split()
    for start in (" ".join(words[:2]), *words[:1]):
        if start in _CALLED:
            return f"did you mean {_CALLED[start]}?"
    known = {example.split()[0]: example for example in examples}
    if similar := nearest(unknown.split(None, 1)[0] if unknown else "", known):
        return "did you mean " + " or ".join(known[word] for word in similar) + "?"
    return f"such as {' · '.join((*_FEW, *_FEW_MORE))}; dhcli help exercise-files lists all"


def _is_read(text: str, read: Callable[[str], object]) -> bool:
    try:
        read(text)
    except (NotationError, NotAskedError):
        return False
    return True
