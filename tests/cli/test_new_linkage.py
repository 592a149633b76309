"""`dhcli new linkage`: a file that loads in every form."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.cli.running import Run


@pytest.mark.parametrize(
    ("form", "gruebler", "mobility"), [("joints", 1, 1), ("bars", 1, 1), ("chain", 9, None), ("loop", -2, 1)]
)
def test_a_new_linkage_loads_and_has_its_freedoms(
    dhcli: Run, tmp_path: Path, form: str, gruebler: int, mobility: int | None
) -> None:
    """Found by its name, shown, and counted; lint asks for the words that are left to write, and for nothing else."""
    written = dhcli("new", "linkage", "my-press", "--form", form)
    assert written.code == 0, written.err
    assert "next: dhcli show my-press, then dhcli dof my-press" in written.err
    data = dhcli("dof", "my-press", "--format", "json").data
    assert (data["gruebler"], data["mobility"]) == (gruebler, mobility)
    assert dhcli("show", "my-press").code == 0
    path = tmp_path / "robots/linkages/my-press.yaml"
    assert max(map(len, path.read_text("utf-8").splitlines())) <= 120
    asked = dhcli("lint", str(path))
    assert (asked.out + asked.err).count("still says 'write here") == 1
    path.write_text(path.read_text("utf-8").replace("write here where the numbers come from; these are", "my"), "utf-8")
    mended = dhcli("lint", str(path))
    assert (mended.code, "nothing to mend" in mended.out + mended.err) == (0, True)


def test_a_new_linkage_is_written_where_it_is_asked_for(dhcli: Run, tmp_path: Path) -> None:
    """To a file, or to standard output; and over nothing."""
    assert "dhcli dof mine.yaml" in dhcli("new", "linkage", "mine", "-o", "mine.yaml").err
    assert dhcli("dof", "mine.yaml").code == 0
    assert dhcli("new", "linkage", "mine", "-o", "mine.yaml").code == 2
    assert "format: 1" in dhcli("new", "linkage", "mine", "-o", "-").out


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["new", "linkage", "../x"], "cannot be the name of a linkage"),
        (["new", "linkage", "x", "--form", "bar"], "did you mean bars?"),
    ],
)
def test_what_cannot_be_is_refused(dhcli: Run, words: list[str], message: str) -> None:
    """With what would be right."""
    done = dhcli(*words)
    assert (done.code, message in done.err) == (2, True)
