"""Pages of the manual, played: what each command in them prints today.

`python tests/manual/pages.py` writes the output of today, and the pages that are made from the program, into the files;
look at the difference before it is committed.
"""

from __future__ import annotations

import contextlib
import os
import re
import shlex
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path
from unittest.mock import patch

ROOT = Path(__file__).parents[2]
MANUAL = ROOT / "dhcli" / "manual"
PAGES = (ROOT / "README.md", *sorted(MANUAL.rglob("*.md")))
_FENCE = re.compile(r"^```(\w+)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
_FILE_NAME = re.compile(r"# (\S+\.\w+)\n")


def fenced(page: str, language: str) -> list[str]:
    """The blocks of a page in a language."""
    return [body for found, body in _FENCE.findall(page) if found == language]


def named(path: Path) -> str:
    """What a page is called in reports."""
    return path.relative_to(ROOT).as_posix()


@contextlib.contextmanager
def folder_of_a_reader() -> Iterator[Path]:
    """A folder to work in, with what a checkout brings along and nothing of the person who runs this."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "tests").symlink_to(ROOT / "tests")
        for shelf in ("exercises", "robots"):  # what a page writes there stays here
            (folder / shelf).mkdir()
            for entry in (ROOT / shelf).iterdir():
                (folder / shelf / entry.name).symlink_to(entry)
        environment = {
            "XDG_DATA_HOME": str(folder / "data"),
            "XDG_CACHE_HOME": str(folder / "data"),
            "COLUMNS": "80",
            "NO_COLOR": "1",
        }
        with contextlib.chdir(folder), patch.dict(os.environ, environment):
            yield folder


def played(page: str) -> str:
    """A page with the output that its commands have now, each in the state that those before it have left.

    A block whose first line is a comment with a file name is that file from there on.
    """
    with folder_of_a_reader() as folder:
        return _FENCE.sub(lambda block: _played_block(block, folder), page)


def _played_block(block: re.Match[str], folder: Path) -> str:
    language, body = block.groups()
    if language == "console":
        return f"```console\n{''.join(_played_commands(body))}```"
    if name := _FILE_NAME.match(body):
        path = folder / name[1]
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(body, "utf-8")
    return block[0]


def _played_commands(body: str) -> Iterator[str]:
    for piece in re.split(r"^\$ ", body, flags=re.MULTILINE)[1:]:
        command = piece.partition("\n")[0]
        yield f"$ {command}\n{output_of(command)}"


def output_of(command: str) -> str:
    """What a command prints, errors included; what stands before a `|` is read by what stands behind it."""
    from tests.cli.running import run

    text = ""
    for part in re.split(r" \| (?=dhcli )", command):
        words = shlex.split(part)
        if words[0] == "cat":
            return Path(words[1]).read_text("utf-8")
        assert words[0] == "dhcli", part
        text = run(*words[1:], stdin=text or None, together=True).out
    return text


def main() -> None:
    """Write what the commands print now into every page."""
    from generated import GENERATED

    for path, make in GENERATED.items():
        path.write_text(make(), "utf-8")
    for path in PAGES:
        page = path.read_text("utf-8")
        path.write_text(played(page), "utf-8")


if __name__ == "__main__":
    sys.path[:0] = [str(ROOT), str(ROOT / "tests" / "manual")]
    main()
