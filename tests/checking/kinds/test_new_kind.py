"""A kind of question is one file: a new one is asked, hinted at, solved, marked, explained, varied, linted, graded."""

from __future__ import annotations

from pathlib import Path

import pytest

from dhcli.checking.kinds import registry
from tests.checking.kinds.parity import ParityQuestion
from tests.cli.conftest import dhcli  # noqa: F401  the fixture
from tests.cli.running import Run

TEXT = """\
format: 1
title: Counting in twos
source: a test
robot: planar-2r
numeric: true
task: Is it even?
given: {theta1: 25°, theta2: 40°}
variants: {theta1: 20°..70° step 1°, theta2: 20°..70° step 1°}
parts:
  - {id: joints, ask: parity joints, hints: [count them]}
  - {id: tip, ask: "position of pose 0..2", hints: [multiply]}
tests:
  - {part: joints, answer: even, verdict: RIGHT}
  - {part: joints, mistake: other-way, verdict: WRONG}
"""


@pytest.fixture
def own(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> str:
    """An exercise with the new kind, in a library of its own; the kind is one entry more in the registry."""
    monkeypatch.setattr(registry, "KINDS", [*registry.KINDS, ParityQuestion])
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path / "data"))
    monkeypatch.setenv("DHCLI_PATH", str(tmp_path / "library"))
    path = tmp_path / "library" / "exercises" / "own" / "twos.yaml"
    path.parent.mkdir(parents=True)
    path.write_text(TEXT, "utf-8")
    return str(path)


def test_a_new_kind_is_linted(own: str, dhcli: Run) -> None:  # noqa: F811
    """By its own tests and solution, and by the rule it brings along."""
    assert dhcli("lint", own).code == 0
    path = Path(own)
    once = "\n".join(line for line in TEXT.split("\n") if not line.startswith("variants"))  # the draws are linted above
    path.write_text(once.replace("parity joints", "parity 7").replace("answer: even", "answer: odd"), "utf-8")
    done = dhcli("lint", own)
    assert done.code == 1
    assert "joints: everybody knows 7" in done.out
    path.write_text(once.replace("parity joints", "parity of all"), "utf-8")
    assert "neither even nor odd" in dhcli("lint", own).out


def test_a_new_kind_is_started_shown_hinted_and_solved(own: str, dhcli: Run) -> None:  # noqa: F811
    """Each command asks the class."""
    sheet = dhcli("start", "own/twos", "-o", "-").out
    assert "  # even or odd: joints · 1 credit\n  joints: |\n    _\n" in sheet
    assert "joints: even or odd: joints · 1 credit" in dhcli("show", "own/twos").out
    assert "count them" in dhcli("hint", "own/twos").out
    solved = dhcli("solution", "own/twos", "--yes", "--part", "joints").out
    assert solved.endswith("Half of it leaves 0\n\nSo the answer is even\n")


@pytest.mark.parametrize(
    ("answer", "code", "said"),
    [
        ("even", 0, "RIGHT"),
        ("odd", 1, "why: even and odd have changed places"),
        ("seven", 2, "write even or odd"),
    ],
)
def test_a_new_kind_is_judged_and_explained(own: str, dhcli: Run, answer: str, code: int, said: str) -> None:  # noqa: F811
    """Right, wrong with the slip named, and unreadable with what would be read."""
    done = dhcli("check", "own/twos", "--part", "joints", "--answer", answer, "--why")
    assert done.code == code
    assert said in done.out


def test_a_new_kind_is_varied_and_graded(own: str, dhcli: Run, tmp_path: Path) -> None:  # noqa: F811
    """In a sheet with numbers of its own, beside a part of another kind."""
    sheet = dhcli("start", "own/twos", "-o", "-", "--variant", "alice").out
    folder = tmp_path / "class"
    folder.mkdir()
    (folder / "alice.yaml").write_text(sheet.replace("joints: |\n    _", "joints: |\n    odd"), "utf-8")
    from dhcli.classroom.folder import find_sheets
    from dhcli.classroom.marking import grade

    graded = [grade(one) for one in find_sheets(str(folder)).submissions]
    assert [(one.exercise, one.variant, [(p.part, p.verdict.word, p.slips) for p in one.parts]) for one in graded] == [
        (
            "own/twos",
            "alice",
            [("joints", "WRONG", ("even and odd have changed places",)), ("tip", "SKIPPED", ())],
        )
    ]


def test_a_message_lists_the_new_kind(own: str) -> None:
    """As one of the questions that are known."""
    from dhcli.errors import NotationError
    from dhcli.notation.scope import Scope

    with pytest.raises(NotationError) as caught:
        registry.read_question("parities joints", Scope())
    assert caught.value.problems[0].hint.startswith("did you mean parity joints")
