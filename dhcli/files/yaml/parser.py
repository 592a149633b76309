"""PyYAML's events of a text, with as little of PyYAML as that takes.

Its package imports a scanner, a parser and a writer in Python, which libyaml makes superfluous: they are three quarters
of its import, and a tenth of a short command. Whoever else asks for them gets them, then.
"""

from __future__ import annotations

import sys
from collections.abc import Iterator
from contextlib import suppress
from functools import partial
from importlib import import_module
from importlib.util import find_spec, module_from_spec
from types import ModuleType, SimpleNamespace
from typing import TYPE_CHECKING, cast

if TYPE_CHECKING:
    from importlib.abc import Loader

    import yaml


_ERRORS = ("reader", "scanner", "parser", "composer", "constructor", "emitter", "serializer", "representer")
"""The modules of which libyaml's parser wants the error of that name, and nothing else."""


def import_yaml() -> None:
    """Import PyYAML's package without running it, and of its modules those that libyaml's parser needs."""
    if "yaml" in sys.modules or (spec := find_spec("yaml")) is None:
        return
    package = module_from_spec(spec)
    package.__class__ = _Light
    sys.modules["yaml"] = package
    for name in ("error", "events", "nodes", "tokens"):
        import_module(f"yaml.{name}")
    for name in _ERRORS:
        called = f"{name.capitalize()}Error"
        setattr(package, name, SimpleNamespace(**{called: partial(_error, name, called)}))
    with suppress(ImportError):  # PyYAML may be built without libyaml
        import_module("yaml._yaml")
    for name in _ERRORS:
        delattr(package, name)


def _error(module: str, called: str, *said: object) -> Exception:
    """One of PyYAML's errors, whose module is imported when it is raised."""
    return cast("Exception", getattr(import_module(f"yaml.{module}"), called)(*said))


class _Light(ModuleType):
    """A package that has not run; it does when something is asked of it that only then is there."""

    def __getattr__(self, name: str) -> object:
        """Become the whole package."""
        self.__class__ = ModuleType  # type: ignore[assignment]
        cast("Loader", self.__loader__).exec_module(self)
        return getattr(self, name)


def events(text: str) -> Iterator[yaml.Event]:
    """The events of a text.

    Raises:
        yaml.error.MarkedYAMLError: It is not YAML.
    """
    try:
        import yaml._yaml
    except ImportError:  # PyYAML was built without libyaml, which is five times as fast
        import yaml

        yield from yaml.parse(text, Loader=yaml.BaseLoader)
        return
    parser = yaml._yaml.CParser(text)  # noqa: SLF001  PyYAML's own modules know it by this name
    try:
        while (event := parser.get_event()) is not None:
            yield event
    finally:
        parser.dispose()
