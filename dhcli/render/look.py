"""How a result is to look, and which formats there are for it."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from dataclasses import field
from importlib import import_module
from typing import Any

from dhcli.errors import UnknownNameError
from dhcli.frozen import frozen
from dhcli.kinematics.entries import DIGITS, rounded
from dhcli.regex import regex
from dhcli.render.paper import Paper

_NOUNS = {
    "pose": "a pose",
    "let": "--let",
    "poses": "a list of poses",
    "point": "a point",
    "placement": "--as",
    "transform": "a transform",
    "steps": "--steps",
    "robot": "a robot",
    "marks": "a judgement",
    "class": "a class",
    "exercise": "an exercise",
    "mobility": "a count of freedoms",
    "mobility at joint values": "a count of freedoms",
    "linkage": "a linkage",
    "library": "a list",
    "lint": "findings",
    "sweep": "a sweep",
    "inverse": "inverse kinematics",
    "derivation": "a derivation",
    "jacobian": "a Jacobian",
    "singularities": "singularities",
    "torques": "torques",
    "velocity": "rates and velocities",
    "description": "a description",
    "motors": "motors",
    "function": "a function",
    "inverse function": "a function",
}
"""What each kind of result is called in messages."""

_RENDERERS = {
    ("pose", "table"): "dhcli.render.text.forward:pose_table",
    ("pose", "latex"): "dhcli.render.code.forward:pose_code",
    ("pose", "matlab"): "dhcli.render.code.forward:pose_code",
    ("pose", "numpy"): "dhcli.render.code.forward:pose_code",
    ("pose", "sympy"): "dhcli.render.code.forward:pose_code",
    ("pose", "csv"): "dhcli.render.code.forward:pose_csv",
    ("let", "table"): "dhcli.render.text.forward:pose_table",
    ("let", "latex"): "dhcli.render.code.forward:let_code",
    ("let", "matlab"): "dhcli.render.code.forward:let_code",
    ("let", "numpy"): "dhcli.render.code.forward:let_code",
    ("poses", "table"): "dhcli.render.text.forward:poses_table",
    ("poses", "latex"): "dhcli.render.code.forward:poses_code",
    ("poses", "matlab"): "dhcli.render.code.forward:poses_code",
    ("poses", "numpy"): "dhcli.render.code.forward:poses_code",
    ("poses", "sympy"): "dhcli.render.code.forward:poses_code",
    ("poses", "csv"): "dhcli.render.code.forward:poses_csv",
    ("point", "table"): "dhcli.render.text.forward:point_table",
    ("point", "latex"): "dhcli.render.code.forward:point_code",
    ("point", "matlab"): "dhcli.render.code.forward:point_code",
    ("point", "numpy"): "dhcli.render.code.forward:point_code",
    ("point", "sympy"): "dhcli.render.code.forward:point_code",
    ("point", "csv"): "dhcli.render.code.forward:point_csv",
    ("placement", "table"): "dhcli.render.text.placement:placement_table",
    ("placement", "csv"): "dhcli.render.text.placement:placement_csv",
    ("transform", "table"): "dhcli.render.text.transform:transform_table",
    ("transform", "latex"): "dhcli.render.text.transform:transform_code",
    ("transform", "matlab"): "dhcli.render.text.transform:transform_code",
    ("transform", "numpy"): "dhcli.render.text.transform:transform_code",
    ("transform", "sympy"): "dhcli.render.text.transform:transform_code",
    ("transform", "csv"): "dhcli.render.text.transform:transform_csv",
    ("steps", "table"): "dhcli.render.text.transform:steps_table",
    ("steps", "latex"): "dhcli.render.text.transform:steps_code",
    ("steps", "matlab"): "dhcli.render.text.transform:steps_code",
    ("steps", "numpy"): "dhcli.render.text.transform:steps_code",
    ("steps", "sympy"): "dhcli.render.text.transform:steps_code",
    ("robot", "table"): "dhcli.render.text.robot:robot_table",
    ("robot", "latex"): "dhcli.render.text.robot:robot_latex",
    ("robot", "csv"): "dhcli.render.text.robot:robot_csv",
    ("marks", "table"): "dhcli.render.text.marks:marks_table",
    ("marks", "csv"): "dhcli.render.text.marks:marks_csv",
    ("class", "table"): "dhcli.render.text.grades:class_table",
    ("class", "csv"): "dhcli.render.code.grades:class_csv",
    ("class", "gradescope"): "dhcli.render.code.grades:gradescope",
    ("exercise", "table"): "dhcli.render.text.exercise:exercise_table",
    ("mobility at joint values", "table"): "dhcli.render.text.at_pose:at_pose_table",
    ("mobility", "table"): "dhcli.render.text.mobility:mobility_table",
    ("linkage", "table"): "dhcli.render.text.mobility:linkage_table",
    ("library", "table"): "dhcli.render.text.library:library_table",
    ("lint", "table"): "dhcli.render.text.lint:lint_table",
    ("library", "csv"): "dhcli.render.text.library:library_csv",
    ("sweep", "table"): "dhcli.render.text.sweep:sweep_table",
    ("sweep", "csv"): "dhcli.render.text.sweep:sweep_csv",
    ("inverse", "table"): "dhcli.render.text.inverse:inverse_table",
    ("inverse", "csv"): "dhcli.render.text.inverse:inverse_csv",
    ("inverse", "latex"): "dhcli.render.text.inverse:inverse_latex",
    ("derivation", "table"): "dhcli.render.text.derivation:derivation_table",
    ("derivation", "latex"): "dhcli.render.code.derivation:derivation_latex",
    ("derivation", "md"): "dhcli.render.code.derivation:derivation_markdown",
    ("jacobian", "table"): "dhcli.render.text.velocity:jacobian_table",
    ("jacobian", "latex"): "dhcli.render.code.velocity:jacobian_code",
    ("jacobian", "matlab"): "dhcli.render.code.velocity:jacobian_code",
    ("jacobian", "numpy"): "dhcli.render.code.velocity:jacobian_code",
    ("jacobian", "sympy"): "dhcli.render.code.velocity:jacobian_code",
    ("jacobian", "csv"): "dhcli.render.code.velocity:jacobian_csv",
    ("singularities", "table"): "dhcli.render.text.singular:singular_table",
    ("singularities", "latex"): "dhcli.render.code.velocity:singular_code",
    ("singularities", "matlab"): "dhcli.render.code.velocity:singular_code",
    ("singularities", "numpy"): "dhcli.render.code.velocity:singular_code",
    ("singularities", "sympy"): "dhcli.render.code.velocity:singular_code",
    ("singularities", "csv"): "dhcli.render.code.velocity:singular_csv",
    ("torques", "table"): "dhcli.render.text.velocity:torques_table",
    ("torques", "latex"): "dhcli.render.code.velocity:torques_code",
    ("torques", "matlab"): "dhcli.render.code.velocity:torques_code",
    ("torques", "numpy"): "dhcli.render.code.velocity:torques_code",
    ("torques", "sympy"): "dhcli.render.code.velocity:torques_code",
    ("torques", "csv"): "dhcli.render.code.velocity:torques_csv",
    ("velocity", "table"): "dhcli.render.text.velocity:velocity_table",
    ("velocity", "latex"): "dhcli.render.code.velocity:velocity_code",
    ("velocity", "matlab"): "dhcli.render.code.velocity:velocity_code",
    ("velocity", "numpy"): "dhcli.render.code.velocity:velocity_code",
    ("velocity", "sympy"): "dhcli.render.code.velocity:velocity_code",
    ("velocity", "csv"): "dhcli.render.code.velocity:velocity_csv",
    ("description", "table"): "dhcli.render.text.describe:description_table",
    ("motors", "table"): "dhcli.render.text.motors:motors_table",
    ("description", "yaml"): "dhcli.render.code.robots:description_yaml",
    ("function", "python"): "dhcli.render.code.functions:function_code",
    ("function", "numpy"): "dhcli.render.code.functions:function_code",
    ("function", "c"): "dhcli.render.code.functions:function_code",
    ("function", "matlab"): "dhcli.render.code.functions:function_code",
    ("function", "julia"): "dhcli.render.code.functions:function_code",
    ("function", "javascript"): "dhcli.render.code.functions:function_code",
    ("inverse function", "python"): "dhcli.render.code.inverses:inverse_code",
    ("inverse function", "numpy"): "dhcli.render.code.inverses:inverse_code",
    ("inverse function", "c"): "dhcli.render.code.inverses:inverse_code",
    ("inverse function", "matlab"): "dhcli.render.code.inverses:inverse_code",
    ("inverse function", "julia"): "dhcli.render.code.inverses:inverse_code",
    ("inverse function", "javascript"): "dhcli.render.code.inverses:inverse_code",
    ("description", "urdf"): "dhcli.render.code.robots:description_urdf",
}
"""Where the renderer of each kind of result and format stands; it is imported when it is needed."""

_FUNCTIONS = ("pose", "let", "jacobian", "inverse", "derivation")
"""Kinds of results whose commands write functions too."""

_CONTENTS = {
    "pose": "dhcli.render.json.contents:forward_content",
    "let": "dhcli.render.json.contents:forward_content",
    "poses": "dhcli.render.json.contents:forward_content",
    "point": "dhcli.render.json.contents:forward_content",
    "placement": "dhcli.render.json.contents:forward_content",
    "transform": "dhcli.render.text.transform:transform_content",
    "steps": "dhcli.render.text.transform:transform_content",
    "robot": "dhcli.render.text.robot:robot_content",
    "marks": "dhcli.render.text.marks:marks_content",
    "class": "dhcli.render.code.grades:class_content",
    "exercise": "dhcli.render.text.exercise:exercise_content",
    "mobility at joint values": "dhcli.render.text.at_pose:at_pose_content",
    "mobility": "dhcli.render.text.mobility:mobility_content",
    "linkage": "dhcli.render.text.mobility:linkage_content",
    "library": "dhcli.render.text.library:library_content",
    "lint": "dhcli.render.text.lint:lint_content",
    "sweep": "dhcli.render.text.sweep:sweep_content",
    "inverse": "dhcli.render.text.inverse:inverse_content",
    "derivation": "dhcli.render.text.derivation:derivation_content",
    "jacobian": "dhcli.render.json.velocity:jacobian_content",
    "singularities": "dhcli.render.json.velocity:singular_content",
    "torques": "dhcli.render.json.velocity:torques_content",
    "velocity": "dhcli.render.json.velocity:velocity_content",
    "description": "dhcli.render.text.describe:description_content",
    "motors": "dhcli.render.text.motors:motors_content",
    "function": "dhcli.render.code.functions:function_content",
    "inverse function": "dhcli.render.text.derivation:derivation_content",
}
"""Where each kind of result becomes what stands under `data` in JSON."""


_NOISE = 1e-9
"""What is smaller is taken for rounding and shown as 0."""
_DECIMAL = regex(r"[0-9]+\.[0-9]+")
_FEWEST = 3
"""Digits of a number that would be rounded to nothing."""


@frozen
class Look:
    """How a result is to look.

    Attributes:
        format: Name of the format.
        paper: What it is written on.
        digits: Decimals; None for what the format usually has.
        style: Spelling of formulas, `short` or `full`; None for what the format usually has.
        in_file: Whether it goes into a file, which should run by itself.
        places: Most decimals of a number in a formula; None for all it has.
    """

    format: str = "table"
    paper: Paper = field(default_factory=Paper)
    digits: int | None = None
    style: str | None = None
    in_file: bool = False
    places: int | None = None

    def formula(self, text: str) -> str:
        """A formula for people: a number that has more decimals than are shown is rounded, though never to nothing."""
        if self.places is None:
            return text
        return _DECIMAL.sub(lambda number: _shorter(number[0], self.places or 0), text)

    def number(self, value: float) -> str:
        """A number for people."""
        return rounded(value, DIGITS if self.digits is None else self.digits)

    def numbers(self, values: Iterable[float]) -> list[str]:
        """Numbers for people that belong together; where all are small, three digits of the largest are shown."""
        values = list(values)
        texts = [self.number(value) for value in values]
        largest = max((abs(value) for value in values), default=0.0)
        if self.digits is not None or largest < _NOISE or any(text != "0" for text in texts):
            return texts
        return [rounded(value, 2 - math.floor(math.log10(largest))) for value in values]


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
    convert: Callable[[Any, Look], dict[str, Any]] = _imported(_CONTENTS[kind])
    return convert(result, look)


def check_format(kind: str, name: str) -> None:
    """Make sure that a kind of result can be written in a format.

    Raises:
        UnknownNameError: It cannot; the hint lists the formats there are.
    """
    if name not in formats(kind):
        hint = f"formats: {', '.join(formats(kind))}"
        known = {format_ for _, format_ in _RENDERERS} | {"json"}
        of = f" for {_NOUNS[kind]}" if name in known else ""
        if ("function", name) in _RENDERERS and kind in _FUNCTIONS:
            hint = f"a function that runs is --code {name}; {hint}"
        raise UnknownNameError(f"there is no format {name}{of}", hint)


def _shorter(number: str, places: int) -> str:
    """A decimal number without its sign, in fewer places if it has more."""
    if len(number.partition(".")[2]) <= places:
        return number
    short = rounded(float(number), places)
    return short if short != "0" else rounded(float(number), _FEWEST - 1 - math.floor(math.log10(float(number))))


def _imported(where: str) -> Any:  # noqa: ANN401  one of the functions named above
    module, _, function = where.partition(":")
    return getattr(import_module(module), function)
