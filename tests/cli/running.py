"""What a command leaves behind, and the type of what runs one."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, TypeAlias

import pytest


@dataclass(frozen=True)
class Done:
    """What a command left behind."""

    code: int
    out: str
    err: str

    @property
    def envelope(self) -> dict[str, Any]:
        """Standard output as JSON that holds no NaN."""
        return json.loads(self.out, parse_constant=lambda word: pytest.fail(f"{word} in JSON"))

    @property
    def data(self) -> Any:  # noqa: ANN401  JSON
        """What stands under `data` of a command that succeeded."""
        assert self.code == 0, self.err
        return self.envelope["data"]


Run: TypeAlias = Callable[..., Done]
"""Runs dhcli with the words given."""
