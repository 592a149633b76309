"""Running commands as a user does: in this process where that is enough, in one of their own where streams matter."""

import json
import os
import subprocess
import sys
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pytest

from dhcli.cli.main import main

ROOT = Path(__file__).parents[2]


@dataclass(frozen=True)
class Done:
    """What a command left behind."""

    code: int
    out: str
    err: str

    @property
    def envelope(self) -> dict[str, Any]:
        """Standard output as JSON that holds no NaN."""
        return json.loads(self.out, parse_constant=lambda word: pytest.fail(f"{word} in JSON"))

    @property
    def data(self) -> Any:
        """What stands under `data` of a command that succeeded."""
        assert self.code == 0, self.err
        return self.envelope["data"]


@pytest.fixture
def dhcli(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Callable[..., Done]:
    """Run `dhcli` with these words in this process, in an empty folder."""
    monkeypatch.chdir(tmp_path)

    def run(*words: str) -> Done:
        capsys.readouterr()
        code = main(words)
        streams = capsys.readouterr()
        return Done(int(code), streams.out, streams.err)

    return run


@pytest.fixture
def process(tmp_path: Path) -> Callable[..., Done]:
    """Run `python -m dhcli` in a process of its own, in an empty folder, its streams piped."""

    def run(*words: str, stdin: str | None = None, shell: str = "", **environment: str) -> Done:
        command = [sys.executable, "-m", "dhcli", *words]
        if shell:
            command = ["bash", "-o", "pipefail", "-c", shell, sys.executable, *command]
        done = subprocess.run(
            command,
            cwd=tmp_path,
            env={**os.environ, "PYTHONPATH": str(ROOT), **environment},
            input=stdin,
            stdin=subprocess.DEVNULL if stdin is None else None,
            capture_output=True,
            encoding="utf-8",
            timeout=60,
            check=False,
        )
        return Done(done.returncode, done.stdout, done.stderr)

    return run
