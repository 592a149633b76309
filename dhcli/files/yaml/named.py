"""Robots and linkages that an exercise names: where their files stand, and how what is wrong in them is told."""

from __future__ import annotations

from collections.abc import Callable
from os.path import isfile
from pathlib import Path
from typing import TYPE_CHECKING, TypeVar

from dhcli.errors import DhcliError, Place
from dhcli.files.library.entries import Kind
from dhcli.files.library.lookup import find, is_path
from dhcli.files.yaml.fields import Problems
from dhcli.files.yaml.placed import PlacedScalar
from dhcli.files.yaml.robots import load_robot
from dhcli.files.yaml.templates import NAME
from dhcli.frozen import frozen
from dhcli.kinematics.robot import Robot

if TYPE_CHECKING:
    from dhcli.mobility.counting import Counts
    from dhcli.mobility.linkage import Linkage

T = TypeVar("T")


@frozen
class Named:
    """What one exercise names.

    Attributes:
        problems: Where to note what is wrong.
        folder: The folder of the exercise's file, in which a path begins.
        roots: Roots of a library that come before all others: that of the course.
    """

    problems: Problems
    folder: Path = Path()
    roots: tuple[Path, ...] = ()

    def robot(self, key: str, scalar: PlacedScalar | None) -> Robot | None:
        """The robot that stands under a key; None if there is none, which is told."""
        if scalar is None:
            return None
        name = scalar.text
        if called := self._elsewhere(name, Kind.ROBOTS):
            message = f"{key}: there is no file {name} here, where this file stands"
            self.problems.add(scalar.place, message, f"write {called}: a name is looked for among all robots")
            name = called
        return self._found(key, scalar.place, lambda: load_robot(self._meant(name, Kind.ROBOTS)))

    def linkage(self, key: str, place: Place, name: str) -> Linkage | Counts | None:
        """The linkage of a name, a path or a pattern; None if there is none, which is told."""
        from dhcli.files.yaml.linkages import find_linkage  # few exercises count

        return self._found(key, place, lambda: find_linkage(self._meant(name, Kind.LINKAGES, Kind.ROBOTS)))

    def _meant(self, name: str, *kinds: Kind) -> str | Path:
        """The file that is meant, beside that of the exercise or in its course, or else the name as it is."""
        if name == "-":
            hint = "save it beside this file, and write its name: ./arm.yaml"
            raise DhcliError("- is standard input, and a file names a file", hint)
        if is_path(kinds[0], name):
            return self.folder / name
        files = (root / kind.folder / f"{name}.yaml" for root in self.roots for kind in kinds if NAME.fullmatch(name))
        return next((path for path in files if isfile(path)), name)

    def _found(self, key: str, place: Place, load: Callable[[], T]) -> T | None:
        """What is loaded; None if it cannot be: told at the place that names it, with the place in its own file."""
        try:
            return load()
        except DhcliError as error:
            for problem in error.problems:
                where = f"{problem.place}: " if problem.place is not None else ""
                self.problems.add(place, f"{key}: {where}{problem.message}", problem.hint)
            return None

    def _elsewhere(self, name: str, kind: Kind) -> str:
        """The name by which a file is found whose path leads nowhere from here; empty if it does, or none is found."""
        stem = Path(name).stem
        if name == "-" or not is_path(kind, name) or isfile(self.folder / name):
            return ""
        try:
            if not isinstance(self._meant(stem, kind), Path):
                find(kind, stem)
        except DhcliError:
            return ""
        return stem
