"""`dhcli schema`: JSON on standard output, or in a file."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from dhcli.files.keys.schema import KINDS, schema_of
from tests.cli.running import Run


@pytest.mark.parametrize("kind", KINDS)
def test_the_command_prints_a_schema_or_writes_it(dhcli: Run, tmp_path: Path, kind: str) -> None:
    """JSON and nothing else; over no file."""
    assert json.loads(dhcli("schema", kind).out) == schema_of(kind)
    done = dhcli("schema", kind, "-o", "x.json")
    assert "yaml-language-server: $schema=x.json" in done.err
    assert json.loads((tmp_path / "x.json").read_text("utf-8")) == schema_of(kind)
    assert dhcli("schema", kind, "-o", "x.json").code == 2


def test_what_has_no_schema_is_told_with_the_nearest(dhcli: Run) -> None:
    """By name."""
    done = dhcli("schema", "robots")
    assert (done.code, "did you mean robot?" in done.err) == (2, True)
