"""The manual: Markdown pages that come with the program, found by topic or by the command they are about."""

from __future__ import annotations

import os
from pathlib import Path

from dhcli.errors import UnknownNameError, nearest
from dhcli.files.reading import read_text
from dhcli.frozen import frozen
from dhcli.regex import regex

FOLDER = Path(__file__).parents[1] / "manual"
GROUPS = {"tutorial": "Tutorials", "howto": "How to", "reference": "Reference", "explanation": "Explanations"}
"""The folders of pages, in the order in which they are read, and what they are called."""
LEAST_TYPED = 3
"""Letters by which pages are found that have them anywhere."""
MOST_PAGES = 4
"""Pages that are named for a word in them."""
_COMMAND = regex(r"`dhcli ([a-z]+)[^`]*`")


@frozen
class Topic:
    """A page of the manual.

    Attributes:
        name: What it is asked for by: the name of its file without the suffix.
        title: Its heading, without marks.
        group: One of `GROUPS`.
        path: The file.
        commands: The commands it is about: those in its heading.
    """

    name: str
    title: str
    group: str
    path: Path
    commands: tuple[str, ...]


def topics() -> tuple[Topic, ...]:
    """Every page, by group and then by name."""
    return tuple(
        _topic(FOLDER / group / name, group)
        for group in GROUPS
        for name in sorted(os.listdir(FOLDER / group))
        if name.endswith(".md")
    )


def read_page(name: str | None) -> str:
    """A page of the manual as Markdown.

    Args:
        name: A topic, a command, or the beginning of a topic; None for the list of topics.

    Raises:
        UnknownNameError: There is no such topic; the hint names the nearest, else where they are listed.
    """
    return read_text(find_topic(name).path if name else FOLDER / "index.md")


def find_topic(name: str) -> Topic:
    """The page of a topic or a command.

    Raises:
        UnknownNameError: There is none.
    """
    wanted = name.lower().replace(" ", "-").removesuffix(".md")
    every = topics()
    for topic in every:
        if wanted == topic.name:
            return topic
    for topic in every:
        if wanted in topic.commands:
            return topic
    begun = [topic for topic in every if topic.name.startswith(wanted)] if wanted else []
    if len(begun) == 1:
        return begun[0]
    known = [*(topic.name for topic in every), *(command for topic in every for command in topic.commands)]
    near = [topic.name for topic in begun] or nearest(wanted, known, cutoff=0.7)
    hint = f"did you mean {' or '.join(near)}?; " if near else ""
    if not near and (pages := _speaking(wanted.replace("-", " "), every)):
        hint = f"it is spoken of in {', '.join(pages)}; "
    raise UnknownNameError(f"the manual has no page '{name}'", f"{hint}dhcli help lists the topics")


def _topic(path: Path, group: str) -> Topic:
    with path.open(encoding="utf-8") as stream:
        heading = stream.readline().lstrip("# ").rstrip()
    return Topic(path.stem, heading.replace("`", ""), group, path, tuple(_COMMAND.findall(heading)))


def _speaking(words: str, every: tuple[Topic, ...]) -> list[str]:
    """Topics whose page has the words: in a heading first, then most often."""
    found = []
    for topic in every if len(words) >= LEAST_TYPED else ():
        text = read_text(topic.path).lower()
        in_headings = any(words in line for line in text.splitlines() if line.startswith("#"))
        found.append((in_headings, text.count(words), topic.name))
    return [name for _, count, name in sorted(found, reverse=True) if count][:MOST_PAGES]
