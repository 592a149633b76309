"""Generated functions run in their own languages, where there is a compiler or an interpreter for them."""

from __future__ import annotations

import ctypes
import hashlib
import json
import re
import shutil
import subprocess
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import pytest

PROGRAMS = {"c": "cc", "javascript": "node", "matlab": "octave-cli", "julia": "julia"}
"""What runs a language; Python runs itself."""

HERE = [
    language
    if language in ("python", "numpy") or shutil.which(PROGRAMS[language])
    else pytest.param(language, marks=pytest.mark.skip(reason=f"{PROGRAMS[language]} is not installed here"))
    for language in ("python", "numpy", "c", "javascript", "matlab", "julia")
]


class Call:
    """A function's file, and the numbers that it is called with.

    Attributes:
        code: The file.
        name: The function's name.
        numbers: The arguments.
        shape: Of the matrix that it gives, or of the room for solutions.
        pose: The pose that comes before the numbers, for the way back.
    """

    def __init__(
        self,
        code: str,
        name: str,
        numbers: Sequence[float],
        shape: tuple[int, int],
        pose: Sequence[Sequence[float]] = (),
    ) -> None:
        """Keep all of it."""
        self.code, self.name, self.numbers, self.shape, self.pose = code, name, list(numbers), shape, pose

    def renamed(self) -> str:
        """The file with another name of the function, so that many stand in one."""
        return re.sub(rf"\b{self.name}\(", f"{self.called}(", self.code)

    @property
    def called(self) -> str:
        """The other name; of the same file, the same."""
        return f"{self.name}_{hashlib.md5(self.code.encode(), usedforsecurity=False).hexdigest()}"

    def spoken(self, marks: tuple[str, str, str, str] = ("[", "; ", "]", " ")) -> str:
        """The call in a language that writes it with brackets: before a matrix, between rows, behind, between cells."""
        first, middle, last, comma = marks
        rows = middle.join(comma.join(map(repr, row)) for row in self.pose)
        given = [f"{first}{rows}{last}"] if self.pose else []
        return f"{self.called}({', '.join([*given, *map(repr, self.numbers)])})"


def written(calls: Sequence[Call]) -> str:
    """The functions of all calls, each once."""
    return "\n".join(dict.fromkeys(call.renamed() for call in calls))


def results(language: str, calls: Sequence[Call], folder: Path) -> list[Any]:
    """The matrices that the functions give, all of them by one start of the language."""
    if language in ("python", "numpy"):
        return [by_python(call) for call in calls]
    return {"c": by_compiler, "javascript": by_node, "matlab": by_octave, "julia": by_julia}[language](calls, folder)


def namespace(code: str) -> dict[str, Any]:
    """What a file of Python defines."""
    space: dict[str, Any] = {}
    exec(code, space)  # noqa: S102  our own output, as a user runs it
    return space


def by_python(call: Call) -> Any:  # noqa: ANN401
    """In a namespace of its own."""
    return namespace(call.code)[call.name](*([call.pose] if call.pose else []), *call.numbers)


def by_compiler(calls: Sequence[Call], folder: Path) -> list[Any]:
    """One library of them all."""
    source, library = folder / "functions.c", folder / "functions.so"
    source.write_text(written(calls), "utf-8")
    flags = ["-std=c99", "-Wall", "-Wextra", "-Werror", "-shared", "-fPIC"]
    subprocess.run([str(shutil.which("cc")), *flags, "-o", str(library), str(source), "-lm"], check=True)
    loaded, found = ctypes.CDLL(str(library)), []
    for call in calls:
        rows, columns = call.shape
        matrix = (ctypes.c_double * columns * rows)()
        given = [(ctypes.c_double * 4 * 4)(*map(tuple, call.pose))] if call.pose else []
        count = getattr(loaded, call.called)(*given, *map(ctypes.c_double, call.numbers), matrix)
        found.append([list(row) for row in matrix][: count if call.pose else rows])
    return found


def by_node(calls: Sequence[Call], folder: Path) -> list[Any]:
    """One script of them all."""
    script = "'use strict';\n" + written(calls)
    said = ", ".join(call.spoken(("[[", "], [", "]]", ", ")) for call in calls)
    script += f"\nconsole.log(JSON.stringify([{said}]));\n"
    return read_back(["node"], folder / "functions.js", script)


def by_octave(calls: Sequence[Call], folder: Path) -> list[Any]:
    """One script; the functions stand before what calls them."""
    script = "1;\n" + written(calls) + "\n"
    said = ["printf('[');"]
    for call in calls:
        said += [f"M = {call.spoken()};", "printf('[');"]
        said += ["for row = 1:size(M, 1), printf('[%s],', strjoin(compose_row(M(row, :)), ',')); end", "printf('0],');"]
    script += (
        "function cells = compose_row(r)\n cells = arrayfun(@(x) sprintf('%.17g', x), r, 'UniformOutput', 0);\nend\n"
    )
    found = read_back(
        ["octave-cli", "--no-init-file"], folder / "functions.m", script + "\n".join([*said, "printf('0]');"])
    )
    return [matrix[:-1] for matrix in found[:-1]]


def by_julia(calls: Sequence[Call], folder: Path) -> list[Any]:
    """One script of them all."""
    script = written(calls)
    script += "\nrows(M::Matrix) = [[M[i, k] for k in 1:size(M, 2)] for i in 1:size(M, 1)]\nrows(M::Vector) = M"
    script += "\nsaid(M) = string('[', join([string('[', join(row, ','), ']') for row in rows(M)], ','), ']')"
    said = [f"print(said({call.spoken()}), ',')" for call in calls]
    return read_back(
        ["julia", "--startup-file=no"], folder / "functions.jl", "\n".join([script, "print('[')", *said, 'print("0]")'])
    )[:-1]


def read_back(command: list[str], path: Path, script: str) -> list[Any]:
    """What a script prints, as JSON."""
    path.write_text(script, "utf-8")
    done = subprocess.run([*command, str(path)], check=True, capture_output=True, text=True, encoding="utf-8")
    found: list[Any] = json.loads(done.stdout)
    return found
