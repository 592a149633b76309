"""`--variant`: own numbers for everybody, from the sheet to the solution."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from tests.cli.running import Run
from tests.cli.terminal import Terminal

PLANAR = "yim/planar-in-numbers"
SHEET = "planar-in-numbers.sheet.yaml"
ALICE = "[cos(35°) -sin(35°) 0 0.4cos(35°); sin(35°) cos(35°) 0 0.4sin(35°); 0 0 1 0; 0 0 0 1]"
FILE = "[√3/2 -1/2 0 0.2√3; 1/2 √3/2 0 1/5; 0 0 1 0; 0 0 0 1]"


def fill(part: str, answer: str) -> None:
    """Write an answer into the sheet in this folder, by hand so to speak."""
    path = Path(SHEET)
    head, _, rest = path.read_text("utf-8").partition(f"  {part}: |\n")
    lines = rest.split("\n")
    blank = next(k for k, line in enumerate(lines) if not line.strip())
    path.write_text(head + f"  {part}: |\n    {answer}\n" + "\n".join(lines[blank:]), "utf-8")


def test_a_sheet_carries_its_variant_and_its_numbers(dhcli: Run) -> None:
    """The numbers for the eyes, the name for the check."""
    done = dhcli("start", "planar-in-numbers", "--variant", "alice")
    assert done.code == 0
    text = Path(SHEET).read_text("utf-8")
    assert "# Given: theta1 = 35°, theta2 = 60°\n" in text
    given = "given: {a1: 0.4 m, a2: 0.3 m, theta1: 35°, theta2: 60°}"
    assert f"exercise: {PLANAR}\nvariant: alice\n{given}\nanswers:\n" in text


@pytest.mark.parametrize("name", ["alice", "12", "O'Neill: a # b", "no", "Ægir Þór"])
def test_any_name_survives_the_sheet(dhcli: Run, name: str) -> None:
    """Quoted where YAML would read something else."""
    assert dhcli("start", PLANAR, "--variant", name).code == 0
    assert dhcli("check", PLANAR, SHEET, "--format", "json").envelope["data"]["variant"] == name


def test_a_sheet_is_judged_by_its_own_numbers(dhcli: Run) -> None:
    """Without a word on the command line."""
    dhcli("start", PLANAR, "--variant", "alice")
    fill("a1", ALICE)
    assert "✓ RIGHT       a1" in dhcli("check", PLANAR, SHEET, "--part", "a1").out
    fill("a1", FILE)
    assert "✗ WRONG       a1" in dhcli("check", PLANAR, SHEET, "--part", "a1").out


def test_one_answer_can_be_checked_with_a_variant(dhcli: Run) -> None:
    """As without one."""
    assert dhcli("check", PLANAR, "--part", "a1", "--answer", ALICE, "--variant", "alice").code == 0
    assert dhcli("check", PLANAR, "--part", "a1", "--answer", ALICE).code == 1
    assert dhcli("check", PLANAR, "--part", "a1", "--answer", FILE).code == 0


def test_two_variants_at_once_are_refused(dhcli: Run) -> None:
    """The sheet of a friend."""
    dhcli("start", PLANAR, "--variant", "alice")
    assert dhcli("check", PLANAR, SHEET, "--variant", "alice").code == 1, "a blank sheet is not right"
    done = dhcli("check", PLANAR, SHEET, "--variant", "bob")
    assert (done.code, done.out) == (2, "")
    assert f"{SHEET} is a sheet of variant alice, not of bob" in done.err


def test_show_hint_and_solution_follow(dhcli: Run) -> None:
    """The page names the variant."""
    page = dhcli("show", PLANAR, "--variant", "alice").out
    assert "variant alice\n" in page
    assert "given: theta1 = 35°, theta2 = 60°" in page
    assert "dhcli start yim/planar-in-numbers --variant alice writes a sheet" in page
    assert dhcli("hint", PLANAR, "--variant", "alice").code == 0
    done = dhcli("hint", PLANAR, "--variant", "alice")
    assert "dhcli solution yim/planar-in-numbers --variant alice --part a1" in done.err
    solution = dhcli("solution", PLANAR, "--part", "a1", "--variant", "alice", "--yes").out
    assert "theta1 = 35°" in solution
    assert "So the answer is [[0.819152, -0.573576" in solution


def test_json_has_the_numbers(dhcli: Run) -> None:
    """In radians and metres."""
    data = dhcli("show", PLANAR, "--variant", "alice", "--format", "json").data
    assert data["variant"] == "alice"
    assert data["given"] == {"theta1": pytest.approx(0.6108652), "theta2": pytest.approx(1.0471976)}
    assert dhcli("show", PLANAR, "--format", "json").data["variant"] is None


@pytest.mark.parametrize("command", ["start", "show", "hint", "solution", "check"])
def test_what_has_no_variants_says_so(dhcli: Run, command: str) -> None:
    """Nothing is written."""
    done = dhcli(command, "wpi/puma560-links", "--variant", "alice", *(["--answer", "1"] if command == "check" else []))
    assert (done.code, done.out) == (2, "")
    assert "has no variants" in done.err
    assert not list(Path().glob("*.yaml"))


def test_a_robot_has_no_variants(dhcli: Run) -> None:
    """Said in words."""
    assert "scara is a robot: only exercises have variants" in dhcli("show", "scara", "--variant", "alice").err
    done = dhcli("check", "scara", "--q", "0,0,0", "--answer", "1", "--variant", "alice")
    assert (done.code, "has no variants" in done.err) == (2, True)


@pytest.mark.skipif(os.name == "nt", reason="pseudo-terminals as Unix knows them")
def test_the_walk_tells_the_numbers(tmp_path: Path) -> None:
    """Before it asks."""
    with Terminal(tmp_path, "check", PLANAR, "--variant", "alice", "--part", "a1") as screen:
        screen.until("given: theta1 = 35°, theta2 = 60°")
        screen.until("a1> ")
        screen.type("\x04")
        assert screen.end() == 1


def test_a_sheet_of_an_exercise_that_was_changed_since_is_not_judged(dhcli: Run) -> None:
    """A right answer must not become wrong because other numbers are drawn now; a sheet that does not say is judged."""
    dhcli("start", PLANAR, "--variant", "alice")
    fill("a1", ALICE)
    sheet = Path(SHEET)
    text = sheet.read_text("utf-8")
    assert dhcli("check", PLANAR, SHEET, "--part", "a1").code == 0
    sheet.write_text(text.replace("theta1: 35°", "theta1: 36°"), "utf-8")
    done = dhcli("check", PLANAR, SHEET, "--part", "a1")
    assert done.code == 2
    assert f"{SHEET} was written with other numbers than this exercise has: theta1 = 36° there, 35° now" in done.err
    assert f"or dhcli start {PLANAR} --variant alice again" in done.err
    sheet.write_text("".join(line for line in text.splitlines(keepends=True) if not line.startswith("given:")), "utf-8")
    assert dhcli("check", PLANAR, SHEET, "--part", "a1").code == 0


def test_a_name_that_an_output_cannot_hold_is_written_to_no_sheet(dhcli: Run) -> None:
    """Without its accents it would draw other numbers, and the sheet could not be judged."""
    done = dhcli("start", PLANAR, "--variant", "José", "-o", "-", PYTHONIOENCODING="ascii")
    assert (done.code, done.out) == (2, "")
    assert "another name draws other numbers" in done.err
    assert "-o FILE.yaml" in done.err
    assert "variant: Kim\n" in dhcli("start", PLANAR, "--variant", "Kim", "-o", "-", PYTHONIOENCODING="ascii").out
    assert "variant: 'José'\n" in dhcli("start", PLANAR, "--variant", "José", "-o", "-").out
