"""Handing a picture over: in letters on the terminal, in a file, or as a page for the browser."""

from __future__ import annotations

import re
import sys
from pathlib import Path
from typing import TYPE_CHECKING

from dhcli.cli.shell.console import tell, write_out
from dhcli.cli.shell.delivery import check_free, write_file
from dhcli.errors import DhcliError, Place, Problem
from dhcli.render.paper import Paper
from dhcli.render.pictures.picture import format_of

if TYPE_CHECKING:
    from dhcli.render.pictures.picture import Picture


def check_picture(path: str, *, overwrite: bool, page: str = "") -> None:
    """Refuse a file that is no picture, or that exists already, before anything is computed.

    Args:
        path: The file.
        overwrite: Whether it may be overwritten.
        page: Why it cannot be a page; empty where it can.

    Raises:
        DhcliError: Its suffix stands for no such picture.
        FileError: It exists already.
    """
    if page and format_of(path) == "page":
        raise DhcliError(page, "write .svg, .pdf, .png or .tex")
    check_free(path, overwrite=overwrite)


def write_picture(picture: Picture, path: str, *, overwrite: bool, animate: bool = False, of: str = "") -> None:
    """Write a picture in the format that the suffix of the file stands for.

    Args:
        picture: The picture.
        path: The file.
        overwrite: Whether one that stands there may be overwritten.
        animate: Whether it moves by itself.
        of: What it shows, where that is to be told.

    Raises:
        FileError: The file exists already, or cannot be written.
    """
    content = picture.animated() if animate else picture.rendered(format_of(path))
    write_file(path, content, overwrite=overwrite)
    tell(f"wrote {path}" + (f": {of}" if of else ""))


def write_letters(picture: Picture, path: str, sides: tuple[int, int] | None, *, overwrite: bool) -> None:
    """Write a picture in letters, so many columns and rows of them.

    Raises:
        FileError: The file exists already, or cannot be written.
    """
    write_file(path, picture.terminal(None, *(sides or ())), overwrite=overwrite)
    tell(f"wrote {path}")


def in_letters(picture: Picture, sides: tuple[int, int] | None) -> None:
    """The picture on standard output, as large as the window allows."""
    import shutil

    paper = Paper.of(sys.stdout)
    columns, rows = sides or (min(paper.width, 120), None)
    if sides is None and paper.terminal:
        rows = max(8, min(round(columns * 0.42), shutil.get_terminal_size((80, 24)).lines - 3))
    write_out(picture.terminal(paper, columns, rows))


def page_to_open(picture: Picture, name: str) -> str:
    """A page in a folder of its own that the system clears; a worksheet, which is no page, and several as SVG."""
    import tempfile

    folder = tempfile.mkdtemp(prefix="dhcli-")
    suffix, text = ("svg", picture.svg()) if picture.worksheet or picture.more else ("html", picture.page())
    path = Path(folder) / f"{re.sub(r'[^A-Za-z0-9_-]+', '-', name) or 'page'}.{suffix}"
    path.write_text(text, encoding="utf-8")
    tell(f"wrote {path}")
    return str(path)


def sides(text: str) -> tuple[int, int]:
    """`820x640` in numbers."""
    match = re.fullmatch(r"\s*(\d{1,5})\s*[x×,]\s*(\d{1,5})\s*", text, re.ASCII)
    if match is None:
        raise DhcliError(Problem(f"'{text}' is no size", Place("--size"), "write width and height, such as 820x640"))
    return int(match[1]), int(match[2])
