"""Every kind of result, and the formats there are for it."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from importlib import import_module
from typing import Any

from dhcli.errors import UnknownNameError
from dhcli.frozen import frozen
from dhcli.render.endings import meant
from dhcli.render.look import Look


@frozen
class _Kind:
    """A kind of result.

    Attributes:
        noun: What it is called in messages.
        content: What makes what stands under `data` in JSON of it.
        renderers: What writes it in each other format; formats that one function writes stand together.
    """

    noun: str
    content: str
    renderers: Mapping[str, str]


_MATRIX = "latex matlab numpy sympy"
_FUNCTION = "python numpy c matlab julia javascript"
_KINDS = {
    "pose": _Kind(
        "a pose",
        "json.contents:forward_content",
        {"table": "text.forward:pose_table", _MATRIX: "code.forward:pose_code", "csv": "code.forward:pose_csv"},
    ),
    "let": _Kind(
        "--let",
        "json.contents:forward_content",
        {"table": "text.forward:pose_table", "latex matlab numpy": "code.forward:let_code"},
    ),
    "poses": _Kind(
        "a list of poses",
        "json.contents:forward_content",
        {"table": "text.forward:poses_table", _MATRIX: "code.forward:poses_code", "csv": "code.forward:poses_csv"},
    ),
    "point": _Kind(
        "a point",
        "json.contents:forward_content",
        {"table": "text.forward:point_table", _MATRIX: "code.forward:point_code", "csv": "code.forward:point_csv"},
    ),
    "placement": _Kind(
        "--as",
        "json.contents:forward_content",
        {"table": "text.placement:placement_table", "csv": "text.placement:placement_csv"},
    ),
    "transform": _Kind(
        "a transform",
        "text.transform:transform_content",
        {
            "table": "text.transform:transform_table",
            _MATRIX: "text.transform:transform_code",
            "csv": "text.transform:transform_csv",
        },
    ),
    "steps": _Kind(
        "--steps",
        "text.transform:transform_content",
        {"table": "text.transform:steps_table", _MATRIX: "text.transform:steps_code"},
    ),
    "robot": _Kind(
        "a robot",
        "text.robot:robot_content",
        {
            "table": "text.robot:robot_table",
            "latex": "text.robot:robot_latex",
            "csv": "text.robot:robot_csv",
            "md": "code.markdown:robot_markdown",
        },
    ),
    "marks": _Kind(
        "a judgement", "text.marks:marks_content", {"table": "text.marks:marks_table", "csv": "text.marks:marks_csv"}
    ),
    "class": _Kind(
        "a class",
        "code.grades:class_content",
        {"table": "text.grades:class_table", "csv": "code.grades:class_csv", "gradescope": "code.grades:gradescope"},
    ),
    "exercise": _Kind(
        "an exercise",
        "text.exercise:exercise_content",
        {"table": "text.exercise:exercise_table", "md": "code.markdown:exercise_markdown"},
    ),
    "mobility at joint values": _Kind(
        "a count of freedoms", "text.at_pose:at_pose_content", {"table": "text.at_pose:at_pose_table"}
    ),
    "mobility": _Kind(
        "a count of freedoms", "text.mobility:mobility_content", {"table": "text.mobility:mobility_table"}
    ),
    "linkage": _Kind("a linkage", "text.mobility:linkage_content", {"table": "text.mobility:linkage_table"}),
    "library": _Kind(
        "a list",
        "text.library:library_content",
        {"table": "text.library:library_table", "csv": "text.library:library_csv"},
    ),
    "lint": _Kind("findings", "text.lint:lint_content", {"table": "text.lint:lint_table"}),
    "sweep": _Kind(
        "a sweep", "text.sweep:sweep_content", {"table": "text.sweep:sweep_table", "csv": "text.sweep:sweep_csv"}
    ),
    "inverse": _Kind(
        "inverse kinematics",
        "text.inverse:inverse_content",
        {
            "table": "text.inverse:inverse_table",
            "csv": "text.inverse:inverse_csv",
            "latex": "text.inverse:inverse_latex",
        },
    ),
    "derivation": _Kind(
        "a derivation",
        "text.derivation:derivation_content",
        {
            "table": "text.derivation:derivation_table",
            "latex": "code.derivation:derivation_latex",
            "md": "code.derivation:derivation_markdown",
        },
    ),
    "jacobian": _Kind(
        "a Jacobian",
        "json.velocity:jacobian_content",
        {
            "table": "text.velocity:jacobian_table",
            _MATRIX: "code.velocity:jacobian_code",
            "csv": "code.velocity:jacobian_csv",
        },
    ),
    "singularities": _Kind(
        "singularities",
        "json.velocity:singular_content",
        {
            "table": "text.singular:singular_table",
            _MATRIX: "code.velocity:singular_code",
            "csv": "code.velocity:singular_csv",
        },
    ),
    "torques": _Kind(
        "torques",
        "json.velocity:torques_content",
        {
            "table": "text.velocity:torques_table",
            _MATRIX: "code.velocity:torques_code",
            "csv": "code.velocity:torques_csv",
        },
    ),
    "velocity": _Kind(
        "rates and velocities",
        "json.velocity:velocity_content",
        {
            "table": "text.velocity:velocity_table",
            _MATRIX: "code.velocity:velocity_code",
            "csv": "code.velocity:velocity_csv",
        },
    ),
    "description": _Kind(
        "a description",
        "text.describe:description_content",
        {
            "table": "text.describe:description_table",
            "yaml": "code.robots:description_yaml",
            "urdf": "code.robots:description_urdf",
        },
    ),
    "motors": _Kind("motors", "text.motors:motors_content", {"table": "text.motors:motors_table"}),
    "function": _Kind("a function", "code.functions:function_content", {_FUNCTION: "code.functions:function_code"}),
    "inverse function": _Kind(
        "a function", "text.derivation:derivation_content", {_FUNCTION: "code.inverses:inverse_code"}
    ),
}
"""Every kind of result, each function by its module in this room; it is imported when it is needed."""
_RENDERERS = {
    (kind, name): where
    for kind, one in _KINDS.items()
    for names, where in one.renderers.items()
    for name in names.split()
}
_FUNCTIONS = ("pose", "let", "jacobian", "inverse", "derivation")
"""Kinds of results whose commands write functions too."""


def formats(kind: str) -> tuple[str, ...]:
    """The formats in which a kind of result can be written."""
    return ("json", *(name for known, name in _RENDERERS if known == kind))


def render(kind: str, result: object, look: Look) -> str:
    """A result in a format that is not JSON.

    Raises:
        UnknownNameError: This kind of result has no such format.
    """
    check_format(kind, look.format)
    write: Callable[[Any, Look], str] = _imported(_RENDERERS[kind, look.format])
    return write(result, look)


def content(kind: str, result: object, look: Look) -> dict[str, Any]:
    """A result as what stands under `data` in JSON."""
    convert: Callable[[Any, Look], dict[str, Any]] = _imported(_KINDS[kind].content)
    return convert(result, look)


def check_format(kind: str, name: str) -> None:
    """Make sure that a kind of result can be written in a format.

    Raises:
        UnknownNameError: It cannot; the hint lists the formats there are.
    """
    if name not in formats(kind):
        hint = f"formats: {', '.join(formats(kind))}"
        known = {format_ for _, format_ in _RENDERERS} | {"json"}
        of = f" for {_KINDS[kind].noun}" if name in known else ""
        if ("function", name) in _RENDERERS and kind in _FUNCTIONS:
            hint = f"a function that runs is --code {name}; {hint}"
        elif name not in known and (near := meant(name, formats(kind))).startswith("did"):
            hint = f"{near}; {hint}"
        called = name or "''"
        raise UnknownNameError(f"there is no format {called}{of}", hint)


def _imported(where: str) -> Any:  # noqa: ANN401  one of the functions named above
    module, _, function = where.partition(":")
    return getattr(import_module(f"dhcli.render.{module}"), function)
