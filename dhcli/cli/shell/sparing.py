"""Libraries imported without what they import for others, which costs a command more than what it uses of them."""

from __future__ import annotations

import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from importlib.machinery import ModuleSpec, PathFinder
from types import ModuleType
from typing import Any

NUMPY = ("numpy._typing", "numpy._core._add_newdocs", "numpy._core._add_newdocs_scalars")
"""What is read by people and type checkers alone: types for annotations, and the documentation of compiled code."""


class _StandIn:
    """Whatever is taken from a module that is spared: a name in an annotation, a base of a class."""

    def __class_getitem__(cls, _: object) -> type[_StandIn]:
        return cls


@contextmanager
def sparing(*names: str) -> Iterator[None]:
    """Have a stand-in for each of some modules, unless it is imported already; nothing of it stays."""
    spared = {*names} - sys.modules.keys()
    for name in spared:
        stand_in: Any = ModuleType(name)
        stand_in.__getattr__ = lambda _: _StandIn
        sys.modules[name] = stand_in
    try:
        yield
    finally:
        for name in spared:
            del sys.modules[name]


def spare(library: str, names: Sequence[str]) -> None:
    """Have a library imported without some of its modules, once and whoever asks for it."""
    if PathFinder in sys.meta_path:
        sys.meta_path.insert(sys.meta_path.index(PathFinder), _Finder(library, names))


class _Finder:
    """What finds the library first, and has it imported like that."""

    def __init__(self, library: str, names: Sequence[str]) -> None:
        self._library, self._names = library, names

    def find_spec(self, name: str, path: Sequence[str] | None = None, _: ModuleType | None = None) -> ModuleSpec | None:
        if name != self._library:
            return None
        sys.meta_path.remove(self)
        found = PathFinder.find_spec(name, path)
        if found and found.loader:
            run = found.loader.exec_module

            def exec_module(module: ModuleType) -> None:
                with sparing(*self._names):
                    run(module)

            found.loader.exec_module = exec_module  # type: ignore[method-assign]
        return found
