"""A program that says what commands import: `python importing.py LINE ...` writes a list of one object for each line.

Each command runs in a process of its own, forked from one that has imported what every command begins with; so a table
of all commands costs what the commands cost, and no start of Python. What is noted is who imported a module first.
"""

from __future__ import annotations

import gc
import io
import json
import os
import runpy
import sys
from contextlib import redirect_stderr, redirect_stdout

import typer  # noqa: F401  before anything is noted


class Notes:
    """A finder that finds nothing, and notes who asked for each module that is not there yet."""

    def __init__(self) -> None:
        """Nobody has asked yet."""
        self.asked: dict[str, str] = {}

    def find_spec(self, name: str, *_: object) -> None:
        """Note the first file above the machinery of imports."""
        frame = sys._getframe(1)
        while frame.f_back and "importlib" in frame.f_code.co_filename:
            frame = frame.f_back
        self.asked.setdefault(name, frame.f_globals["__name__"])


NOTES = Notes()


def noted(line: str) -> dict[str, object]:
    """Run a command here: its exit code, what it says beside its result, and of each module it imports who asked.

    And how many objects Python will look through for garbage when it ends.
    """
    sys.argv[:] = ["dhcli", *line.split()]
    code: object = None
    with redirect_stdout(io.StringIO()), redirect_stderr(io.StringIO()) as said:
        try:
            runpy.run_module("dhcli", run_name="__main__", alter_sys=True)
        except SystemExit as ended:
            code = ended.code
    left = len(gc.get_objects())
    asked = {name: asker for name, asker in NOTES.asked.items() if name in sys.modules}
    return {"code": code or 0, "said": said.getvalue(), "asked": asked, "left": left}


def in_a_process(line: str) -> object:
    """The same, forked, so that the next command finds nothing imported."""
    reading, writing = os.pipe()
    child = os.fork()
    if not child:
        try:
            report = json.dumps(noted(line))
            with os.fdopen(writing, "w", encoding="utf-8") as pipe:
                pipe.write(report)
        finally:
            os._exit(0)
    os.close(writing)
    with os.fdopen(reading, encoding="utf-8") as pipe:
        report = pipe.read()
    os.waitpid(child, 0)
    return json.loads(report)


if __name__ == "__main__":
    sys.meta_path.insert(0, NOTES)  # type: ignore[arg-type]
    import dhcli.cli.app
    import dhcli.cli.main  # noqa: F401  see above

    json.dump([in_a_process(line) for line in sys.argv[1:]], sys.stdout)
