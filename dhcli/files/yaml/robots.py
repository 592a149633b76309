"""Robot files, by name or by path: the textbook's table as YAML, and a URDF."""

from __future__ import annotations

import re
from functools import lru_cache
from pathlib import Path

from dhcli.errors import FileError, Place, Problem
from dhcli.files.library.entries import Kind
from dhcli.files.library.lookup import check_typed, find
from dhcli.files.reading import LIMIT, is_xml, read_text, source_of
from dhcli.files.yaml.placed import read_yaml
from dhcli.files.yaml.robot_loader import Loader
from dhcli.kinematics.description import Description
from dhcli.kinematics.robot import Robot, read_from
from dhcli.regex import regex

XML = (".urdf", ".xml", ".xacro")
XML_LIMIT = 20_000_000
"""What the name of a URDF ends in, and the most bytes of one; meshes stand in files of their own."""
MOST_KEPT = 64
"""Robots of files that are kept: more than one class or one course has."""
DRAWN = regex(r"^convention:\s*['\"]?(axes|screws)['\"]?\s*(?:#.*)?$", re.MULTILINE)
"""How a file says that it gives axes or screws in the place of links."""


def load_robot(name: str | Path, *, base: str | None = None, tip: str | None = None, as_typed: bool = False) -> Robot:
    """Load a robot by name or from a file, a YAML of dhcli's or a URDF.

    Args:
        name: A name of the library such as `puma560`, a path, or `-` for standard input.
        base: The link of a URDF that is frame 0; by default its root.
        tip: The link of a URDF that is the last frame; by default the only one at the end of a chain that moves.
        as_typed: Whether 1.5708 in a URDF stays what it is, and is not taken as 90°.

    Raises:
        UnknownNameError: No robot has this name, or the URDF has no such link; the nearest are listed.
        FileError: The file is no robot; every problem, each with file, line and column.
    """
    check_typed(Kind.ROBOTS, name)
    path = name if isinstance(name, Path) else find(Kind.ROBOTS, name)
    text = read_text("-" if str(path) == "-" else path, limit=XML_LIMIT if path.suffix.lower() in XML else LIMIT)
    if str(path) == "-":
        return robot_of(text, source_of(path), "stdin", base=base, tip=tip, as_typed=as_typed)
    read = _of_file if len(text) <= LIMIT else _of_file.__wrapped__  # the text is kept with the robot
    return read(text, source_of(path), path, base, tip, as_typed)


@lru_cache(MOST_KEPT)
def _of_file(text: str, source: str, path: Path, base: str | None, tip: str | None, as_typed: bool) -> Robot:  # noqa: FBT001
    """The robot in a file; who loads it again has the same one, and with it what was worked out for it."""
    return read_from(robot_of(text, source, path.stem, base=base, tip=tip, as_typed=as_typed), path)


def robot_of(
    text: str, source: str, name: str, *, base: str | None = None, tip: str | None = None, as_typed: bool = False
) -> Robot:
    """A robot from the text of a file, which may be a URDF; see `load_robot`."""
    if is_xml(text):
        from dhcli.files.urdf.robots import read_urdf  # most robots are YAML

        return read_urdf(text, source, name, base=base, tip=tip, as_typed=as_typed)
    if source.lower().endswith((".urdf", ".xacro")):
        hint = "a URDF begins with <robot name=...>; a robot file of dhcli is YAML and ends in .yaml"
        raise FileError(Problem("is no XML, which the end of its name promises", Place(source, 1), hint))
    if as_typed:
        hint = "exact: false in a robot file keeps its numbers"
        raise FileError(Problem("only a URDF is read as it is typed when asked to", Place(source), hint))
    if base is not None or tip is not None:
        hint = "frames of a robot file are named with --from and --to"
        raise FileError(Problem("only a URDF has links to choose from", Place(source), hint))
    return read_robot(text, source, name)


def read_robot(text: str, source: str, name: str) -> Robot:
    """Read a robot from the text of a file.

    Raises:
        FileError: With all problems.
    """
    return _loader(text, source, name).robot()


def robot_so_far(path: Path) -> tuple[Description, frozenset[str]]:
    """What can be read of a robot file in which something is wrong: for those who look for more in the rest.

    Returns:
        The robot as far as it goes, and the parameters that stand in a text about moves, read or not.

    Raises:
        FileError: It is no mapping in YAML that says `format: 1`, so that there is no rest.
    """
    loader = _loader(read_text(path), source_of(path), path.stem)
    return loader.so_far(), frozenset(filter(loader.is_used, loader.parameters.entries))


def _loader(text: str, source: str, name: str) -> Loader:
    """What reads a text."""
    refused: list[Problem] = []
    if drawn := DRAWN.search(text):
        from dhcli.files.yaml.drawn import DrawnLoader, with_semicolons  # few robots are drawn

        root = read_yaml(with_semicolons(text), source, refused, spelled=text)
        return DrawnLoader(root, name, refused, drawn[1])
    return Loader(read_yaml(text, source, refused), name, refused)
