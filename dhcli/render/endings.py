"""What the ending of a file says about its format, and where an option says another."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

from dhcli.errors import DhcliError, UnknownNameError, did_you_mean

ENDINGS = {
    "json": (".json",),
    "table": (".txt",),
    "latex": (".tex",),
    "md": (".md",),
    "matlab": (".m",),
    "c": (".c", ".h"),
    "python": (".py",),
    "numpy": (".py",),
    "sympy": (".py",),
    "julia": (".jl",),
    "javascript": (".js", ".mjs"),
    "csv": (".csv",),
    "jsonl": (".jsonl", ".ndjson"),
    "npy": (".npy",),
    "gradescope": (".json",),
    "yaml": (".yaml", ".yml"),
    "urdf": (".urdf",),
}
"""The endings of files in each format; the first is the one to write. Of any other ending nothing is said."""

PICTURES = {
    "svg": (".svg",),
    "tikz": (".tex",),
    "png": (".png",),
    "pdf": (".pdf",),
    "page": (".html",),
    "terminal": (".txt",),
}
"""The same of pictures, of which none is of the formats above."""

_CALLED = {
    "octave": ("matlab", "Octave runs it"),
    **dict.fromkeys(("c++", "cpp", "cxx", "cc", "hpp"), ("c", "C++ compiles it")),
    **dict.fromkeys(("c99", "c11", "ansi-c"), ("c", "")),
    **dict.fromkeys(("node", "nodejs", "typescript", "ts", "ecmascript"), ("javascript", "")),
    **dict.fromkeys(("python3", "python2"), ("python", "")),
    "np": ("numpy", ""),
    "markdown": ("md", ""),
    **dict.fromkeys(("text", "plain"), ("table", "")),
}
"""What people call formats and languages, and what is to be said of ours; endings of files are other such names."""

_ANYTHING = (".txt",)
"""Endings of files that may hold any text."""

_OTHERS = (".xlsx", ".xls", ".ods", ".docx", ".npz", ".mat", ".gz", ".zip", *(end for (end,) in PICTURES.values()))
"""Endings of files that no program could open if they held a format from above."""


def meant(name: str, known: Iterable[str]) -> str:
    """A hint at the format or language that is meant by another name for it, an ending, or a slip of the keyboard.

    Args:
        name: What was typed.
        known: The formats there are.
    """
    known, plain = tuple(known), name.lower().lstrip(".")
    called, said = _CALLED.get(plain, ("", ""))
    if called in known:
        return f"did you mean {called}?" + (f"; {said}" if said else "")
    ending = [each for each in known if f".{plain}" in _endings_of(each)]
    return f"did you mean {' or '.join(ending)}?" if ending else did_you_mean(name, known)


def format_by_ending(
    output: str | Path, formats: Iterable[str], others: Iterable[str] = (), of: str = "", more: str = "or say --format"
) -> str:
    """The format that the ending of a file stands for.

    Args:
        output: The file.
        formats: The formats there are; of two with the same ending the first.
        others: Formats that are none of them, whose lack is told elsewhere.
        of: What the endings are of, for the hint.
        more: What else helps; nothing where it is empty.

    Raises:
        UnknownNameError: The ending stands for none of them.
    """
    ending, formats = _ending(output), tuple(formats)
    for name in (*formats, *others):
        if ending in _endings_of(name):
            return name
    known = dict.fromkeys(each for name in formats for each in _endings_of(name))
    near = did_you_mean(ending, known)
    hint = f"{near} " if near.startswith("did") else ""
    hint += f"known suffixes{of}: {' '.join(known)}" + (f"; {more}" if more else "")
    raise UnknownNameError(f"{output} does not say which format it should have", hint)


def check_ending(
    output: str | None, name: str, option: str = "", formats: Iterable[str] = (), instead: str = ""
) -> None:
    """Refuse a file that ends as one in another format does.

    Args:
        output: The file; None where there is none.
        name: The format it would hold.
        option: The option that says so; empty where the command writes no other.
        formats: The formats that the option could say.
        instead: What to do with the option where none of them fits the ending.

    Raises:
        DhcliError: It ends so; the hint says both ways out.
    """
    ending = _ending(output or "")
    held = [each for each, endings in ENDINGS.items() if ending in endings]
    if name in held or ending in _ANYTHING or not (held or ending in _OTHERS):
        return
    fitting = next((f"{option} {each}" for each in formats if each in held), instead)
    hint = f"write {ENDINGS[name][0]}" + (f", or {fitting}" if fitting else "")
    ends = held[0] if held else ending.lstrip(".")
    says = f"{option} says {name}" if option else f"would hold {name}"
    raise DhcliError(f"{output} ends as a file in {ends} does, and {says}", hint)


def _endings_of(name: str) -> tuple[str, ...]:
    return (ENDINGS | PICTURES)[name]


def _ending(output: str | Path) -> str:
    return Path(output).suffix.lower()
