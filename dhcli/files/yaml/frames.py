"""Frames of a file, as an answer that is judged on a robot's axes; a robot file with a table is one as well."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from dhcli.errors import FileError, did_you_mean
from dhcli.files.reading import read_text, source_of
from dhcli.files.yaml.drawn import with_semicolons
from dhcli.files.yaml.fields import Fields, Problems
from dhcli.files.yaml.placed import PlacedMapping, PlacedNode, PlacedScalar, PlacedSequence, read_yaml
from dhcli.files.yaml.tables import read_table
from dhcli.frozen import frozen
from dhcli.kinematics.conventions import Convention
from dhcli.kinematics.robot import Robot

KEYS = ("convention", "pose", "frames", "title", "source")
ROW = ("frame", "origin", "x", "y", "z")
EXAMPLE = "{origin: (a1, 0, 0), x: +x, z: +z}"
_CONVENTIONS = (Convention.STANDARD.value, Convention.MODIFIED.value)


@frozen
class Frames:
    """Frames from a file.

    Attributes:
        convention: The convention whose rules they are to keep.
        text: A row for each frame, or for each of a table, as the text of an answer.
        pose: The named pose in which they are drawn; empty where the file does not say.
        note: What the file says besides and no frames hold.
    """

    convention: Convention
    text: str
    pose: str = ""
    note: str = ""


def read_frames(path: Path | str, reference: Robot) -> Frames:
    """The frames of a file, or the table of a robot file.

    Raises:
        FileError: It holds neither; every problem, with line and column.
    """
    text, source = read_text(path), source_of(path)
    root = read_yaml(with_semicolons(text), source, spelled=text)
    if isinstance(root, PlacedMapping) and any(key.text == "links" for key, _ in root.entries):
        table = read_table(path, reference, text)
        return Frames(table.convention, table.text, note=table.note)
    problems = Problems()
    fields = problems.document(root, known=KEYS, required=("convention", "frames"))
    convention = fields.text("convention")
    if convention and convention not in _CONVENTIONS:
        hint = did_you_mean(convention, _CONVENTIONS)
        problems.add(fields.place_of("convention"), f"convention: there are no frames of '{convention}'", hint)
    rows = [row for node in fields.sequence("frames") for row in _row(problems, node)]
    if not rows and "frames" in fields:
        problems.add(fields.place_of("frames"), "frames: there are none", f"write - {EXAMPLE} for each")
    problems.raise_if_any(FileError)
    return Frames(Convention(convention), "\n".join(rows), fields.text("pose"))


def _row(problems: Problems, node: PlacedNode) -> Iterator[str]:
    """A frame as a row of an answer; none where it cannot be one."""
    if isinstance(node, PlacedScalar):
        yield node.text
        return
    fields: Fields = problems.mapping(node, "frames", known=ROW, required=("origin", "x", "z"), example=EXAMPLE)
    cells = {key: text for key in fields.entries if (text := _cell(problems, fields.get(key), key))}
    number = f"frame {cells.pop('frame')}: " if "frame" in cells else ""
    yield number + ", ".join(f"{key} = {text}" for key, text in cells.items())


def _cell(problems: Problems, node: PlacedNode | None, key: str) -> str:
    """An axis or a point: a text, or a list of texts."""
    if isinstance(node, PlacedSequence):
        texts = [scalar.text for item in node.items if (scalar := problems.scalar(item, key)) is not None]
        return f"({', '.join(texts)})"
    scalar = None if node is None else problems.scalar(node, key)
    return "" if scalar is None else scalar.text.replace(";", ",")
