"""Sheets of one small exercise, right, wrong and broken."""

from __future__ import annotations

from pathlib import Path

EXERCISE = "yim/planar-two-links"
RIGHT = "a1 c1 + a2 c12; a1 s1 + a2 s12; 0"
WRONG = "a1 c1 + a2 c12; a1 c1 + a2 s12; 0"


def sheet(answers: dict[str, str], exercise: str | None = EXERCISE, **more: str) -> str:
    """The text of a sheet."""
    said = {} if exercise is None else {"exercise": exercise}
    head = "".join(f"{key}: '{value}'\n" for key, value in {**said, **more}.items())
    return f"format: 1\n{head}answers:\n" + "".join(f"  {part}: '{text}'\n" for part, text in answers.items())


def hand_in(folder: Path, name: str, text: str | bytes | None = None) -> Path:
    """A file of a class, with its folders; by default a sheet with one right answer."""
    path = folder / name
    path.parent.mkdir(parents=True, exist_ok=True)
    content = sheet({"d02": RIGHT}) if text is None else text
    path.write_bytes(content if isinstance(content, bytes) else content.encode())
    return path
