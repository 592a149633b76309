"""The list of what there is."""

from dhcli.checking.verdicts import Verdict
from dhcli.files.catalogue import catalogue
from dhcli.files.library import Kind
from dhcli.files.progress import record
from dhcli.render.library import library_table
from dhcli.render.look import Look


def test_exercises_show_how_many_parts_are_solved() -> None:
    """Right and equivalent parts count, wrong ones do not."""
    record("yim/planar-two-links", {"a1": Verdict.RIGHT, "a2": Verdict.WRONG, "t02": Verdict.EQUIVALENT})
    table = library_table(catalogue([Kind.EXERCISES]), Look())
    [line] = [line for line in table.splitlines() if "yim/planar-two-links" in line]
    assert line.split()[:3] == ["yim/planar-two-links", "RR", "2/8"]
