"""The list of what there is."""

import pytest

from dhcli.checking.verdicts import Verdict
from dhcli.files.library.catalogue import catalogue
from dhcli.files.library.entries import Kind
from dhcli.files.progress import record
from dhcli.render.look import Look
from dhcli.render.paper import Paper, in_ascii
from dhcli.render.text.library import library_table


@pytest.mark.parametrize("unicode", [True, False])
def test_the_list_fits_eighty_columns(*, unicode: bool) -> None:
    """What is the same in all rows gives way, and a title goes on below."""
    record("yim/planar-two-links", {"a1": Verdict.RIGHT})
    paper = Paper(80, terminal=True, unicode=unicode)
    table = library_table(catalogue(list(Kind)), Look(paper=paper))
    lines = (table if unicode else in_ascii(table)).splitlines()
    assert max(map(len, lines)) <= 80
    assert not any("built-in" in line for line in lines)
    [at] = [at for at, line in enumerate(lines) if "inverse/planar-joints-in-numbers" in line]
    assert lines[at].endswith("  Planar arm with two links,")
    assert lines[at + 1].split() == ["joint", "angles", "in", "numbers"]


def test_exercises_show_how_many_parts_are_solved() -> None:
    """Right and equivalent parts count, wrong ones do not."""
    record("yim/planar-two-links", {"a1": Verdict.RIGHT, "a2": Verdict.WRONG, "t02": Verdict.EQUIVALENT})
    table = library_table(catalogue([Kind.EXERCISES]), Look())
    [line] = [line for line in table.splitlines() if "yim/planar-two-links" in line]
    assert line.split()[:3] == ["yim/planar-two-links", "RR", "2/8"]
