"""A class: its names, and a sheet for each of them in a folder of its own."""

from __future__ import annotations

import shlex
import unicodedata
from pathlib import Path
from typing import TYPE_CHECKING

from dhcli.checking.variants import LONGEST_SEED, vary
from dhcli.cli.shell.console import tell
from dhcli.cli.shell.delivery import check_free, make_folder, write_file
from dhcli.errors import DhcliError, FileError, Place, Problem, plural
from dhcli.files.reading import read_text, source_of
from dhcli.files.yaml.sheets import write_sheet

if TYPE_CHECKING:
    from dhcli.checking.judge import Judge

NOT_IN_FOLDERS = frozenset('/\\:*?"<>|')
"""Letters that some system allows in no name of a folder."""

MOST_SHOWN = 3
"""Names without a sheet that are told."""

INSTEAD = "it may hold answers: -o OTHER writes into another folder; "


def read_roster(file: str) -> tuple[str, ...]:
    """The names of a class, a line each; empty lines and those that begin with # say nothing.

    Raises:
        FileError: The file cannot be read or holds no name; or with every name that can be none of a folder, or that
            stands there twice, with its line.
    """
    source = source_of(file)
    problems: list[Problem] = []
    lines: dict[str, int] = {}
    names: list[str] = []
    for number, line in enumerate(read_text(file).splitlines(), 1):
        name = unicodedata.normalize("NFC", line.strip())
        if not name or name.startswith("#"):
            continue
        first = lines.setdefault(name.casefold(), number)  # some systems take large and small letters for the same
        if fault := _fault(name):
            hint = "each sheet stands in a folder of that name"
            problems.append(Problem(f"{name[:LONGEST_SEED]!r} {fault}", Place(source, number), hint))
        elif first != number:
            hint = "tell the two apart, for each has a folder"
            problems.append(Problem(f"{name} stands in line {first} too", Place(source, number), hint))
        names.append(name)
    if problems:
        raise FileError(problems)
    return tuple(names)


def _fault(name: str) -> str:
    """Why a name can be none of a folder; empty if it can."""
    if len(name) > LONGEST_SEED:
        return f"has more than {LONGEST_SEED} letters"
    if not name.isprintable() or NOT_IN_FOLDERS & set(name):
        return "holds a letter that no folder can have in its name"
    return "begins with a dot" if name.startswith(".") else ""


def _late(names: list[str]) -> str:
    """What to do for those who have no sheet yet, where others have one."""
    if not names:
        return ""
    shown = ", ".join(names[:MOST_SHOWN]) + (", ..." if len(names) > MOST_SHOWN else "")
    return f"a file with only the names that have none ({shown}) adds theirs; "


def start_class(judge: Judge, file: str, output: str | None, *, overwrite: bool) -> None:
    """Write a sheet for each name of a class, with numbers of its own where the exercise has variants.

    Args:
        judge: The judge of the exercise.
        file: A file with a name a line; `-` is standard input.
        output: The folder, named after the exercise by default.
        overwrite: Whether sheets that stand there may be overwritten; else nothing is written when there is one.

    Raises:
        DhcliError: There is no name, or a sheet cannot be written.
    """
    names = read_roster(file)
    if not names:
        raise DhcliError(f"{source_of(file)} holds no name", "write a name a line")
    last = judge.exercise.file_name
    folder = Path(output or f"{last}-sheets")
    paths = {name: folder / name / f"{last}.sheet.yaml" for name in names}
    instead = INSTEAD + _late([name for name, path in paths.items() if not path.exists()])
    for path in paths.values():
        if path.parent.is_dir():
            check_free(path, overwrite=overwrite, instead=instead)
    for name, path in paths.items():
        drawn = vary(judge, name) if judge.exercise.variants else judge
        for above in (folder, path.parent):
            make_folder(above)
        write_file(path, write_sheet(drawn.exercise, name), overwrite=overwrite, instead=INSTEAD)
    each = "with numbers of its own each" if judge.exercise.variants else "all with the same numbers"
    tell(f"wrote {plural(len(paths), 'sheet')} into {folder}, {each}")
    tell(f"next: dhcli grade {shlex.quote(str(folder))}, when they are filled in")
