"""Handing a result over: in which format, on which paper, on stdout or into a file."""

from __future__ import annotations

import sys
from collections.abc import Iterable
from pathlib import Path

from dhcli.cli.shell.console import say, tell, write_out
from dhcli.errors import DhcliError, FileError, Place, Problem, UnknownNameError, did_you_mean
from dhcli.frozen import frozen
from dhcli.render.endings import ENDINGS, check_ending, format_by_ending
from dhcli.render.kinds import check_format, content, formats, render
from dhcli.render.look import Look
from dhcli.render.paper import Paper

STYLES = ("short", "full")


@frozen
class Delivery:
    """How a person wants a result.

    Attributes:
        command: The command typed.
        format: The format asked for; None leaves it to the file's ending, and else to the terminal's table.
        digits: Decimals asked for.
        style: Spelling of formulas asked for.
        output: The file to write.
        overwrite: Whether that file may be overwritten.
    """

    command: str
    format: str | None = None
    digits: int | None = None
    style: str | None = None
    output: str | None = None
    overwrite: bool = False

    def hand_over(self, kind: str, result: object, warnings: Iterable[str] = ()) -> None:
        """Render a result and write it.

        Raises:
            UnknownNameError: There is no such format for this kind of result.
            FileError: The file cannot be written, or exists already.
        """
        name = self.chosen(kind)
        paper = Paper() if self.output else Paper.of(sys.stdout)
        look = Look(name, paper, self.digits, self.style, in_file=self.output is not None)
        warned = list(warnings)
        if name == "json":
            from dhcli.render.json.envelope import envelope

            text = envelope(self.command, content(kind, result, look), (), warned)
        else:
            text = render(kind, result, look)
        self._write(text)
        self.warn(warned)

    def chosen(self, kind: str) -> str:
        """The format: the one asked for, else that of the file's ending, else a table.

        Raises:
            UnknownNameError: There is no such format, style or ending.
            DhcliError: The file ends as one in another format does.
        """
        if self.style is not None and self.style not in STYLES:
            raise UnknownNameError(f"there is no style {self.style}", did_you_mean(self.style, STYLES))
        check_overwrite(self.output, overwrite=self.overwrite)
        name = self.format
        if name is None and self.output is not None:
            name = format_by_ending(self.output, formats(kind), ENDINGS)
        name = "table" if name is None else name
        check_format(kind, name)
        if self.format is not None:
            check_ending(self.output, self.format, "--format", formats(kind))
        if self.style is not None and name not in ("table", "json"):
            raise DhcliError(f"--style is for tables; {name} has its own spelling", "leave one of the two out")
        return name

    def check_output(self) -> None:
        """Make sure that the file may be written, before work begins that takes long.

        Raises:
            FileError: It exists already.
        """
        if self.output is not None:
            check_free(self.output, overwrite=self.overwrite)

    def _write(self, text: str) -> None:
        if self.output is None:
            write_out(text)
            return
        write_file(self.output, text, overwrite=self.overwrite)
        tell(f"wrote {self.output}")

    def warn(self, warnings: Iterable[str]) -> None:
        """Tell what a person should know all the same."""
        if warned := list(warnings):
            from dhcli.render.text.problems import warning_line

            paper = Paper.of(sys.stderr)
            say("".join(warning_line(message, paper) for message in warned))


def check_overwrite(output: str | None, *, overwrite: bool) -> None:
    """Make sure that there is a file where one may be overwritten.

    Raises:
        DhcliError: `--overwrite` has none.
    """
    if overwrite and not output:
        raise DhcliError("--overwrite needs a file to overwrite", "name it with -o FILE")


def make_folder(path: Path) -> None:
    """Make a folder unless it is there.

    Raises:
        FileError: A file has its name, or it may not be made.
    """
    try:
        path.mkdir(exist_ok=True)
    except OSError as error:
        raise FileError(Problem(f"no folder can be made here: {error.strerror}", Place(str(path)))) from None


def check_free(path: Path | str, *, overwrite: bool, instead: str = "") -> None:
    """Make sure that a file can be written, and that none of this name stands there unless it may be overwritten.

    Args:
        path: The file.
        overwrite: Whether it may.
        instead: What else may be done, before overwriting is spoken of.

    Raises:
        FileError: It exists already, or nothing can be written there.
    """
    from dhcli.storage.atomic import check_place

    if Path(path).is_file() and not overwrite:
        raise FileError(Problem("exists already", Place(str(path)), f"{instead}--overwrite overwrites it"))
    check_place(path)


def write_file(path: Path | str, content: str | bytes, *, overwrite: bool, instead: str = "") -> None:
    """Write a file whole or not at all.

    Args:
        path: The file.
        content: What it is to hold.
        overwrite: Whether one that stands there may be overwritten.
        instead: What else may be done with that one, before overwriting is spoken of.

    Raises:
        FileError: It exists already and may not be overwritten, or it cannot be written.
    """
    from dhcli.storage.atomic import write_whole

    check_free(path, overwrite=overwrite, instead=instead)
    write_whole(path, content, overwrite=overwrite)
