"""Running commands as a user does: in this process, or in one of their own where that is the point."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

from tests.cli.running import Done, Run, run

ROOT = Path(__file__).parents[2]


@pytest.fixture
def dhcli(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Run:
    """Run `dhcli` with these words in this process, in an empty folder; see `run`."""
    monkeypatch.chdir(tmp_path)
    return run


@pytest.fixture
def process(tmp_path: Path) -> Run:
    """Run a script of the shell that starts `python -m dhcli` as `"$0" -m dhcli`, in an empty folder."""

    def run_script(script: str, **environment: str) -> Done:
        done = subprocess.run(
            ["bash", "-o", "pipefail", "-c", script, sys.executable],  # noqa: S607  the shell of whoever tests
            cwd=tmp_path,
            env={**os.environ, "PYTHONPATH": str(ROOT), **environment},
            stdin=subprocess.DEVNULL,
            capture_output=True,
            encoding="utf-8",
            timeout=60,
            check=False,
        )
        return Done(done.returncode, done.stdout, done.stderr)

    return run_script
