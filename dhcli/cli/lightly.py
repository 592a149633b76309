"""numpy imported without what only its readers ask for: its docstrings, and the types that annotations name.

Both are a third of its import, and no command asks for either.
"""

from __future__ import annotations

import sys
from importlib import import_module
from types import GenericAlias, ModuleType

_DOCSTRINGS = ("numpy._core._add_newdocs", "numpy._core._add_newdocs_scalars")
"""What says of functions that are there what they do, and does nothing else; `python -OO` leaves it out, too."""
_TYPES = "numpy._typing"


def spare_numpy() -> None:
    """Let numpy, where it is not imported yet, be imported so; to be called by a process that is a command."""
    if "numpy" in sys.modules:
        return
    sys.modules |= {name: ModuleType(name) for name in _DOCSTRINGS}
    sys.modules[_TYPES] = _Types(_TYPES)


class _Types(ModuleType):
    """What stands for numpy's types until one of them is wanted, other than for an annotation of numpy's own."""

    class NDArray:
        """An array, where numpy says what its functions return."""

        def __class_getitem__(cls, of: object) -> GenericAlias:
            """One of numbers of a kind."""
            return GenericAlias(cls, of)

    def __getattr__(self, name: str) -> object:
        """Become what it stands for."""
        if name.startswith("__"):
            raise AttributeError(name)
        del sys.modules[_TYPES]
        vars(self).update(vars(import_module(_TYPES)))
        return getattr(self, name)
