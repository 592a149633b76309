"""Options that many commands share, written once: a parameter of a command that stands for a group of options."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Iterator, Mapping
from copy import copy
from dataclasses import field, fields, is_dataclass
from functools import wraps
from typing import Annotated, Any, get_args, get_origin

from typer.models import OptionInfo

from dhcli.frozen import frozen

REQUIRED = {"required": True}
"""Metadata of a field that must be typed, where the command has it; its default is for those that do not."""


@frozen
class But:
    """How a group of options differs in one command; `Annotated[Chosen, But(without=("q",))]`.

    Attributes:
        without: Fields that are no options of this command; they keep their defaults.
        instead: What other fields are, with the help of this command.
        panel: The heading of the help that all its options stand under.
    """

    without: tuple[str, ...] = ()
    instead: Mapping[str, object] = field(default_factory=dict)
    panel: str = ""


def spread(command: Callable[..., Any]) -> Callable[..., Any]:
    """The command as typer wants it: each field of a parameter that is a dataclass is a parameter of its own."""
    signature = inspect.signature(command, eval_str=True)
    groups = {name: _group(p.annotation) for name, p in signature.parameters.items() if _is_group(p.annotation)}
    if not groups:
        return command
    parameters: list[inspect.Parameter] = []
    for name, parameter in signature.parameters.items():
        whole = parameter.replace(kind=inspect.Parameter.KEYWORD_ONLY)
        parameters += _options(*groups[name]) if name in groups else [whole]

    @wraps(command)
    def spread_out(**typed: Any) -> Any:  # noqa: ANN401  whatever typer reads
        made = {}
        for name, (group, but) in groups.items():
            own = [each.name for each in fields(group) if each.name not in but.without]
            made[name] = group(**{option: typed.pop(option) for option in own})
        return command(**made, **typed)

    spread_out.__signature__ = signature.replace(parameters=parameters)  # type: ignore[attr-defined]
    spread_out.__annotations__ = {parameter.name: parameter.annotation for parameter in parameters}
    return spread_out


def _is_group(annotation: object) -> bool:
    kind = get_args(annotation)[0] if get_origin(annotation) is Annotated else annotation
    return isinstance(kind, type) and is_dataclass(kind)


def _group(annotation: Any) -> tuple[type[Any], But]:  # noqa: ANN401  a dataclass, or an annotated one
    if get_origin(annotation) is Annotated:
        group, but = get_args(annotation)
        return group, but
    return annotation, But()


def _options(group: type[Any], but: But) -> Iterator[inspect.Parameter]:
    """The fields of a group as parameters of a command."""
    hints = inspect.get_annotations(group, eval_str=True) | dict(but.instead)
    for each in fields(group):
        if each.name not in but.without:
            hint = _under(hints[each.name], but.panel) if but.panel else hints[each.name]
            default = inspect.Parameter.empty if each.metadata == REQUIRED else each.default
            yield inspect.Parameter(each.name, inspect.Parameter.KEYWORD_ONLY, default=default, annotation=hint)


def _under(hint: Any, panel: str) -> Any:  # noqa: ANN401  an annotation
    """The same option under another heading of the help; an argument stays where it is."""
    kind, option = get_args(hint)
    if not isinstance(option, OptionInfo):
        return hint
    option = copy(option)
    option.rich_help_panel = panel
    return Annotated[kind, option]
