"""An error in the middle of a rule: it is a finding, and neither the other rules nor the other files are lost."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pytest

from dhcli.checking.diagnosis.result import Slip
from dhcli.checking.exercise import Case
from dhcli.checking.kinds import registry
from dhcli.errors import DhcliError, NotationError, Problem, RobotError
from dhcli.kinematics.validity import Finding
from dhcli.lint.files import lint
from dhcli.lint.kept import kept
from tests.checking.kinds.parity import ParityQuestion

TEXT = """\
format: 1
title: Counting in twos
source: a test
robot: planar-2r
numeric: true
task: Is it even?
parts:
  - {id: first, ask: parity joints, hints: [count them]}
  - {id: second, ask: parity 7, hints: [count them]}
tests:
  - {part: first, answer: even, verdict: RIGHT}
  - {part: first, answer: odd, verdict: WRONG}
"""
AT_FIRST, AT_SECOND = "8:5", "9:5"


def refuse(*_: object, **__: object) -> Any:  # noqa: ANN401  it never returns
    """What stumbles."""
    raise RobotError("seven devils", "call a priest")


@dataclass(frozen=True, slots=True)
class Stumbling(ParityQuestion):
    """The toy kind, some method of which raises an error that a user can cause."""

    def findings(self, case: Case, where: tuple[str | int, ...]) -> Iterable[Finding]:
        """As of the toy kind."""
        return ParityQuestion.findings(self, case, where)

    def hidden(self, _case: Case) -> Iterable[Slip]:
        """None."""
        return ()


@pytest.mark.parametrize("method", ["findings", "hidden", "expected", "read", "mark", "causes", "slips", "describe"])
def test_no_error_of_one_exercise_ends_the_lint_of_a_folder(
    method: str, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    """Whichever method of a kind stumbles: every file is linted, and the finding stands at a line of its own file."""
    monkeypatch.setattr(registry, "KINDS", [*registry.KINDS, Stumbling])
    monkeypatch.setattr(Stumbling, method, refuse)
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path / "data"))
    folder = tmp_path / "exercises"
    folder.mkdir()
    (folder / "a.yaml").write_text(TEXT, "utf-8")
    (folder / "b.yaml").write_text(TEXT.replace("Counting in twos", "TODO"), "utf-8")
    (folder / "c.yaml").write_text("format: 1\ntitle: [\n", "utf-8")
    linted = lint([str(folder)])
    told: dict[str, list[Problem]] = {Path(path).name: [] for path in linted.files}
    for one in linted.told:
        assert one.problem.place is not None
        told[Path(one.problem.place.source).name].append(one.problem)
    assert list(told) == ["a.yaml", "b.yaml", "c.yaml"]
    assert any("TODO" in problem.message for problem in told["b.yaml"])
    assert told["c.yaml"]
    stumbled = [problem for problem in told["a.yaml"] if "seven devils" in problem.message]
    assert bool(stumbled) is (method not in ("causes", "slips"))  # which lint does not ask for here
    assert all(problem.place and problem.place.line for problem in stumbled)


@pytest.mark.parametrize(("method", "hidden"), [("findings", False), ("hidden", True)])
def test_the_parts_are_told_one_by_one(
    method: str, monkeypatch: pytest.MonkeyPatch, tmp_path: Path, *, hidden: bool
) -> None:
    """Each with its name, at its own line, and the hint of the error."""
    monkeypatch.setattr(registry, "KINDS", [*registry.KINDS, Stumbling])
    monkeypatch.setattr(Stumbling, method, refuse)
    path = tmp_path / "own.yaml"
    path.write_text(TEXT, "utf-8")
    found = [one.problem for one in lint([str(path)]).told]
    stumbled = [f"{one.place}: {one.message} ({one.hint})" for one in found if "devils" in one.message]
    assert stumbled == [
        f"{path}:{AT_FIRST}: first: seven devils (call a priest)",
        f"{path}:{AT_SECOND}: second: seven devils (call a priest)",
    ]
    assert any("everybody knows 7" in one.message for one in found) is hidden


def test_what_came_before_an_error_is_kept() -> None:
    """And every problem of it becomes a finding."""

    def rules() -> Iterator[Finding]:
        yield Finding(("title",), "good")
        raise NotationError([Problem("one", hint="mend it"), Problem("two")])

    assert list(kept(rules(), ("parts",), "p")) == [
        Finding(("title",), "good"),
        Finding(("parts",), "p: one", "mend it"),
        Finding(("parts",), "p: two"),
    ]
    assert [one.message for one in kept(rules())][1:] == ["one", "two"]


def test_a_bug_is_no_finding() -> None:
    """It is told as what it is."""

    def rules() -> Iterator[Finding]:
        yield Finding((), "good")
        raise KeyError("theta1")

    with pytest.raises(KeyError):
        list(kept(rules()))
    assert not issubclass(KeyError, DhcliError)
