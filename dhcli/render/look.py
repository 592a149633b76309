"""How a result is to look, and which formats there are for it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from importlib import import_module
from typing import Any, TypeAlias

from dhcli.errors import UnknownNameError
from dhcli.kinematics.pose import DIGITS, rounded
from dhcli.render.paper import Paper

Renderer: TypeAlias = Callable[[Any, "Look"], str]

_RENDERERS = {
    ("pose", "table"): "dhcli.render.forward:pose_table",
    ("pose", "latex"): "dhcli.render.forward:pose_code",
    ("pose", "matlab"): "dhcli.render.forward:pose_code",
    ("pose", "numpy"): "dhcli.render.forward:pose_code",
    ("pose", "sympy"): "dhcli.render.forward:pose_code",
    ("pose", "csv"): "dhcli.render.forward:pose_csv",
    ("poses", "table"): "dhcli.render.forward:poses_table",
    ("poses", "latex"): "dhcli.render.forward:poses_code",
    ("poses", "matlab"): "dhcli.render.forward:poses_code",
    ("poses", "numpy"): "dhcli.render.forward:poses_code",
    ("poses", "sympy"): "dhcli.render.forward:poses_code",
    ("poses", "csv"): "dhcli.render.forward:poses_csv",
}
"""Where the renderer of each kind of result and format stands; it is imported when it is needed. JSON needs none."""


@dataclass(frozen=True, slots=True)
class Look:
    """How a result is to look.

    Attributes:
        format: Name of the format.
        paper: What it is written on.
        digits: Decimals; None for what the format usually has.
        style: Spelling of formulas, `short` or `full`; None for what the format usually has.
    """

    format: str = "table"
    paper: Paper = field(default_factory=Paper)
    digits: int | None = None
    style: str | None = None

    def number(self, value: float) -> str:
        """A number for people."""
        return rounded(value, DIGITS if self.digits is None else self.digits)


def formats(kind: str) -> tuple[str, ...]:
    """The formats in which a kind of result can be written."""
    return ("json", *(name for known, name in _RENDERERS if known == kind))


def renderer(kind: str, name: str) -> Renderer:
    """The function that writes a kind of result in a format.

    Raises:
        UnknownNameError: There is none; the hint lists those there are.
    """
    try:
        module, _, function = _RENDERERS[kind, name].partition(":")
    except KeyError:
        raise UnknownNameError(f"there is no format {name} for this", "formats: " + ", ".join(formats(kind))) from None
    found: Renderer = getattr(import_module(module), function)
    return found
