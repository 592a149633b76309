"""What a shell completes: names that begin like what was typed, imported or read as it asks."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from importlib import import_module
from typing import TYPE_CHECKING, TypeAlias

import typer

if TYPE_CHECKING:
    from dhcli.kinematics.robot import Robot

Complete: TypeAlias = Callable[[str], list[str]]


def among(*names: str) -> Complete:
    """Of a few words."""

    def complete(incomplete: str) -> list[str]:
        return _begun(incomplete, names)

    return complete


def of_module(module: str, table: str, *more: str) -> Complete:
    """Of a table of names that a module of dhcli's has, and more of them."""

    def complete(incomplete: str) -> list[str]:
        return _begun(incomplete, (*getattr(import_module(f"dhcli.{module}"), table), *more))

    return complete


def of_library(*kinds: str) -> Complete:
    """Of what the library holds of some kinds; reads no file."""

    def complete(incomplete: str) -> list[str]:
        from dhcli.files.library.entries import Kind, entries

        return _begun(incomplete, (entry.name for kind in kinds for entry in entries(Kind(kind))))

    return complete


def of_robot(part: str) -> Callable[[typer.Context, str], list[str]]:
    """Of the robot that is typed already: its `poses`, `frames` or `variables`."""

    def complete(ctx: typer.Context, incomplete: str) -> list[str]:
        robot = _robot_of(ctx)
        return _begun(incomplete, getattr(robot, part)) if robot else []

    return complete


def exercise(incomplete: str) -> list[str]:
    """Names of exercises, with their folder or without; reads no file."""
    from dhcli.files.library.entries import Kind, entries

    names = [entry.name for entry in entries(Kind.EXERCISES)]
    return [name for name in names if name.startswith(incomplete) or name.split("/")[-1].startswith(incomplete)]


def forms(incomplete: str) -> list[str]:
    """Ways to say a pose, behind those that are typed already."""
    from dhcli.kinematics.placement import FORMS

    before, comma, begun = incomplete.rpartition(",")
    return [f"{before}{comma}{name}" for name in _begun(begun, FORMS)]


def topic(incomplete: str) -> list[str]:
    """Topics of the manual."""
    from dhcli.files.manual import topics

    return _begun(incomplete, (one.name for one in topics()))


def _begun(incomplete: str, names: Iterable[str]) -> list[str]:
    return [name for name in names if name.startswith(incomplete)]


def _robot_of(ctx: typer.Context) -> Robot | None:
    """The robot, unless it cannot be read; a shell that completes has no room for errors."""
    from dhcli.errors import DhcliError
    from dhcli.files.yaml.robots import load_robot

    # Behind an option that still lacks its value typer leaves the arguments where they are.
    name = ctx.params.get("robot") or next(iter(ctx.args), None)
    try:
        return load_robot(name) if name and name != "-" else None
    except DhcliError:
        return None
