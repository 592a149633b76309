"""Running commands as a user does: in this process where that is enough, in one of their own where streams matter."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

from dhcli.cli.main import main
from tests.cli.running import Done, Run

ROOT = Path(__file__).parents[2]


@pytest.fixture
def dhcli(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Run:
    """Run `dhcli` with these words in this process, in an empty folder."""
    monkeypatch.chdir(tmp_path)

    def run(*words: str) -> Done:
        capsys.readouterr()
        code = main(words)
        streams = capsys.readouterr()
        return Done(int(code), streams.out, streams.err)

    return run


@pytest.fixture
def process(tmp_path: Path) -> Run:
    """Run `python -m dhcli` in a process of its own, in an empty folder, its streams piped."""

    def run(*words: str, stdin: str | None = None, script: str = "", **environment: str) -> Done:
        command = [sys.executable, "-m", "dhcli", *words]
        if script:
            command = ["bash", "-o", "pipefail", "-c", script, sys.executable, *command]
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
