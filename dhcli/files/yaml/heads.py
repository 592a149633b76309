"""What the top of a file says: its format, and by its keys whether it is a robot, a linkage, an exercise or a sheet."""

from __future__ import annotations

import re
from collections.abc import Sequence

from dhcli.errors import FileError, Problem
from dhcli.files.keys.linkages import SIGNS
from dhcli.files.reading import source_of
from dhcli.files.yaml.placed import PlacedMapping, PlacedNode, PlacedScalar
from dhcli.files.yaml.slips import node_kind

FORMAT = 1
_KINDS = (
    (("answers",), "an answer sheet", "dhcli check {exercise} {file} judges it"),
    (("parts",), "an exercise", "dhcli start {file} writes a sheet for it"),
    (("frames",), "a list of frames", "dhcli check ROBOT --frames {file} judges it"),
    (("variables", "convention"), "a robot", "dhcli show {file} shows it"),
    (SIGNS, "a linkage", "dhcli dof {file} counts its freedoms"),
)
"""What tells one kind of file from the others: keys of which no other kind has one, and what it is good for."""


def check_kind(root: PlacedMapping, known: Sequence[str]) -> None:
    """Make sure that a file has no key that tells another kind than the one wanted, and none that tells that one."""
    found = {key.text: (key, value) for key, value in root.entries}
    wanted = next((noun for signs, noun, _ in _KINDS if signs[0] in known), "")
    if not wanted or any(sign in found for signs, noun, _ in _KINDS if noun == wanted for sign in signs):
        return
    for signs, noun, use in _KINDS:
        sign = next((sign for sign in signs if sign in found and sign not in known), "")
        if sign:
            _, exercise = found.get("exercise", (None, None))
            named = exercise.text if isinstance(exercise, PlacedScalar) and exercise.text else "EXERCISE"
            place = found[sign][0].place
            file = "-" if place.source == source_of("-") else place.source
            hint = use.format(exercise=named, file=file)
            raise FileError(Problem(f"this is {noun}, and {wanted} is wanted", place, hint))


def check_format(value: PlacedNode) -> None:
    """Refuse a file of another format at once."""
    text = value.text if isinstance(value, PlacedScalar) else node_kind(value)
    if text == str(FORMAT):
        return
    if re.fullmatch("[1-9][0-9]*", text, re.ASCII):
        message = f"format {text} needs a newer dhcli; this one reads format {FORMAT}"
        problem = Problem(message, value.place, "pip install --upgrade dhcli")
    else:
        problem = Problem(f"format: should be {FORMAT}, is '{text}'", value.place, f"write format: {FORMAT}")
    raise FileError(problem)
