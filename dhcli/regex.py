"""Regular expressions that are compiled when something is first looked for with them.

To compile one takes a hundred times as long as to look with it. A command imports sixty and uses twenty.
"""

from __future__ import annotations

import re
from typing import Any, cast


def regex(text: str, flags: int = 0) -> re.Pattern[str]:
    """A regular expression, as `re.compile` gives one."""
    return cast("re.Pattern[str]", _Regex(text, flags))


class _Regex:
    """Its text, and once it is used what it is used for."""

    def __init__(self, text: str, flags: int) -> None:
        self.pattern, self._flags = text, flags

    def __getattr__(self, name: str) -> Any:  # noqa: ANN401  what looks, in one way or another
        if name not in _USES:
            raise AttributeError(name)
        compiled = re.compile(self.pattern, self._flags)
        for each in _USES:
            setattr(self, each, getattr(compiled, each))
        return getattr(self, name)


_USES = ("match", "fullmatch", "search", "sub", "split", "findall", "finditer")
