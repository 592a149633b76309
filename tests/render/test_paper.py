"""What text is written on: colours, widths, letters."""

import io

import pytest

from dhcli.checking.verdicts import Verdict
from dhcli.render.paper import Paper, in_ascii


class _Terminal(io.StringIO):
    encoding = "utf-8"

    def isatty(self) -> bool:
        return True


def test_a_pipe_has_a_fixed_width_and_no_colour(monkeypatch: pytest.MonkeyPatch) -> None:
    """Whatever the window is."""
    monkeypatch.setenv("COLUMNS", "40")
    monkeypatch.delenv("NO_COLOR")
    assert (Paper.of(io.StringIO()).width, Paper.of(io.StringIO()).colour) == (100, False)


def test_a_terminal_has_its_own_width_and_colours(monkeypatch: pytest.MonkeyPatch) -> None:
    """Unless NO_COLOR is set, or it is a dumb one."""
    monkeypatch.setenv("COLUMNS", "72")
    monkeypatch.delenv("NO_COLOR")
    assert Paper.of(_Terminal()) == Paper(width=72, colour=True, unicode=True, terminal=True)
    monkeypatch.setenv("TERM", "dumb")
    assert Paper.of(_Terminal()).colour is False
    monkeypatch.setenv("TERM", "xterm")
    monkeypatch.setenv("NO_COLOR", "1")
    assert Paper.of(_Terminal()).colour is False


def test_ink_leaves_the_text_alone_without_colour() -> None:
    """And wraps it in one sequence with."""
    assert Paper().ink("x", "bold", "red") == "x"
    assert Paper(colour=True).ink("x", "bold", "red") == "\x1b[1;31mx\x1b[0m"


@pytest.mark.parametrize(
    ("text", "ascii_text"),
    [
        ("θ_1 + 90°", "theta_1 + 90deg"),
        ("⎡ ⎢ ⎣ ⎤ ⎥ ⎦", "[ [ [ ] ] ]"),
        ("Armstrong-Hélouvry", "Armstrong-Helouvry"),
        ("−π/2 · √3", "-pi/2, sqrt3"),
        ("Σf = 4·1", "sum f = 4*1"),
        ("11 µm", "11 um"),
        ("dT = Δ T", "dT = Delta T"),
        ("½ ∓ 1", "1/2 -+ 1"),
        ("日本", "??"),
    ],
)
def test_every_text_has_a_spelling_in_ascii(text: str, ascii_text: str) -> None:
    """By name where a letter has one."""
    assert in_ascii(text) == ascii_text


def test_every_verdict_has_a_sign_of_its_own_in_ascii() -> None:
    """An entry that is CLOSE and one that is ROUNDED stand side by side, and earn differently."""
    assert len({in_ascii(verdict.sign) for verdict in Verdict}) == len(Verdict)


def test_what_steers_a_terminal_becomes_a_blank() -> None:
    """Escapes, bells, line ends, marks of direction."""
    assert Paper().spell("a\x1b[2Jb\x07c\nd\u202ee\x9bf") == "a [2Jb c d e f"


def test_an_aside_is_for_who_looks_at_a_window() -> None:
    """A pipe or a file gets the answer alone."""
    assert Paper(terminal=True).aside("dhcli ik puma560") == ["dhcli ik puma560"]
    assert Paper().aside("dhcli ik puma560") == []
