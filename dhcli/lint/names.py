"""Names of the library and of the files at hand: one name should stand for one thing."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator

from dhcli.files.library.entries import BUILT_IN, Kind, entries
from dhcli.files.library.kinds import kind_of
from dhcli.frozen import frozen
from dhcli.kinematics.validity import Finding


@frozen
class Named:
    """Something with a name.

    Attributes:
        kind: What it is.
        name: The word that it can be asked for by: the file name, of an exercise too.
        path: Its file.
        is_built_in: Whether dhcli brings it along.
    """

    kind: Kind
    name: str
    path: str
    is_built_in: bool = False


@frozen
class Names:
    """Files at hand and everything else of the same names, by the real paths of the files."""

    named: dict[str, Named]

    @classmethod
    def of(cls, files: Iterable[str]) -> Names:
        """The names of files, which need not be in the library, and what has them there."""
        at_hand = [Named(kind_of(path), os.path.splitext(os.path.basename(path))[0], path) for path in files]  # noqa: PTH119, PTH122
        names = {one.name for one in at_hand}
        library = [
            Named(kind, name, str(entry.path), entry.origin == BUILT_IN)
            for kind in Kind
            for entry in entries(kind)
            if (name := entry.name.split("/")[-1]) in names
        ]
        return cls({os.path.realpath(one.path): one for one in (*at_hand, *library)})

    def clashes(self, path: str) -> Iterator[Finding]:
        """What else has the name of a file: a thing of another kind, or one that it hides."""
        own = self.named[os.path.realpath(path)]
        for other in self.named.values():
            if other.name != own.name or other is own:
                continue
            where = f"the built-in {other.kind.noun}" if other.is_built_in else f"the {other.kind.noun} {other.path}"
            if other.kind is not own.kind:
                yield Finding((), f"{own.name} is the name of {where}, too", "name the file otherwise")
            elif own.kind is Kind.EXERCISES:
                message = f"{own.name} is also the name of {where}: only folder and name tell them apart"
                yield Finding((), message, "name the file otherwise", is_warning=True)
            else:
                yield Finding((), f"{own.name} hides {where}", "name the file otherwise", is_warning=True)
