"""`start`, `hint`, `solution` and `watch`: what surrounds an exercise."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from dhcli.checking.verdicts import Verdict
from dhcli.files.progress import path_of_progress, read_progress, record
from dhcli.files.yaml.exercises import load_exercise
from dhcli.files.yaml.sheets import read_sheet
from tests.cli.running import Run
from tests.cli.terminal import Terminal

PLANAR = "yim/planar-two-links"
SHEET = "planar-two-links.sheet.yaml"
A1 = "[c1 -s1 0 a1*c1; s1 c1 0 a1*s1; 0 0 1 0; 0 0 0 1]"
FIRST_HINT = "Parallel axes have no twist between them, and here both links lie in one plane."
SECOND_HINT = "Only the columns a and theta hold anything but zero."

terminal = pytest.mark.skipif(os.name == "nt", reason="pseudo-terminals as Unix knows them")


@pytest.fixture
def broken_progress() -> Path:
    """A progress file that nobody can read."""
    path = path_of_progress()
    path.parent.mkdir(parents=True)
    path.write_text("{broken")
    return path


# --------------------------------------------------------------------------------------------------------- start


def test_start_writes_a_sheet_and_says_what_comes_next(dhcli: Run, tmp_path: Path) -> None:
    """Named after the exercise; stdout stays empty."""
    done = dhcli("start", "planar-two-links")
    assert (done.code, done.out) == (0, "")
    assert f"wrote {SHEET}" in done.err
    assert f"dhcli check {PLANAR} {SHEET}" in done.err
    assert f"dhcli watch {PLANAR} {SHEET}" in done.err
    assert list(read_sheet(tmp_path / SHEET).answers) == [part.id for part in load_exercise(PLANAR).parts]


def test_the_sheet_that_start_writes_can_be_checked_at_once(dhcli: Run) -> None:
    """All parts are skipped; nothing is solved and nothing is wrong."""
    dhcli("start", PLANAR)
    done = dhcli("check", PLANAR, SHEET)
    assert (done.code, done.err) == (1, "")
    assert "0 of 8 parts solved, 0 of 13 credits" in done.out
    assert "WRONG" not in done.out


def test_start_overwrites_nothing_unless_it_must(dhcli: Run, tmp_path: Path) -> None:
    """A filled-in sheet is hours of work."""
    (tmp_path / SHEET).write_text("hours of work")
    done = dhcli("start", PLANAR)
    assert done.code == 2
    assert "exists already" in done.err
    assert "it may hold answers: -o OTHER.yaml writes another; --overwrite overwrites it" in done.err
    assert (tmp_path / SHEET).read_text() == "hours of work"
    assert dhcli("start", PLANAR, "--overwrite").code == 0
    assert "answers:" in (tmp_path / SHEET).read_text("utf-8")


def test_start_writes_where_it_is_told(dhcli: Run, tmp_path: Path) -> None:
    """A file, or stdout."""
    assert dhcli("start", PLANAR, "-o", "mine.yaml").code == 0
    done = dhcli("start", PLANAR, "-o", "-")
    assert (done.code, done.err) == (0, "")
    assert done.out == (tmp_path / "mine.yaml").read_text("utf-8")
    assert dhcli("start", PLANAR, "-o", "no/such/folder.yaml").code == 2


@pytest.mark.parametrize("command", ["start", "hint", "solution", "watch"])
def test_an_unknown_exercise_ends_with_2_and_the_nearest(dhcli: Run, command: str) -> None:
    """And writes nothing."""
    done = dhcli(command, "planar-two-link")
    assert (done.code, done.out) == (2, "")
    assert "planar-two-links" in done.err


# ---------------------------------------------------------------------------------------------------------- hint


def test_hints_come_one_by_one(dhcli: Run) -> None:
    """From gentle to plain; the last one stays."""
    outs = [dhcli("hint", PLANAR) for _ in range(3)]
    assert [done.out for done in outs] == [
        f"table, hint 1 of 2: {FIRST_HINT}\n",
        f"table, hint 2 of 2: {SECOND_HINT}\n",
        f"table, hint 2 of 2: {SECOND_HINT}\n",
    ]
    assert [done.code for done in outs] == [0, 0, 0]
    assert outs[0].err == ""
    assert f"dhcli solution {PLANAR} --part table works it out" in outs[1].err
    assert read_progress()[0][PLANAR]["table"].tries == 0


def test_a_hint_is_for_the_first_part_that_is_not_solved(dhcli: Run) -> None:
    """A part that was right needs none."""
    record(PLANAR, {"table": Verdict.EQUIVALENT, "a1": Verdict.CLOSE})
    assert dhcli("hint", PLANAR).out.startswith("a1, hint 1 of ")


def test_a_hint_can_be_asked_for_any_part(dhcli: Run) -> None:
    """By its name; an unknown one is refused."""
    assert dhcli("hint", PLANAR, "--part", "t02").out.startswith("t02, hint 1 of ")
    done = dhcli("hint", PLANAR, "--part", "t03")
    assert (done.code, done.out) == (2, "")
    assert "did you mean t02" in done.err


def test_a_part_without_hints_says_so(dhcli: Run, tmp_path: Path) -> None:
    """And counts none."""
    text = "format: 1\ntitle: t\nsource: s\ntask: t\nparts:\n  - {id: a, ask: scalar 1}\n"
    (tmp_path / "e.yaml").write_text(text, "utf-8")
    assert dhcli("hint", "e.yaml").out == "a: there is no hint for this part\n"


def test_a_hint_is_given_although_progress_is_broken(dhcli: Run, broken_progress: Path) -> None:
    """The file is set aside, and said so."""
    done = dhcli("hint", PLANAR)
    assert done.code == 0
    assert FIRST_HINT in done.out
    assert "set aside" in done.err
    assert broken_progress.with_name("progress.json.broken-1").read_text() == "{broken"


# ------------------------------------------------------------------------------------------------------ solution


def test_a_solution_is_not_shown_to_a_script_before_a_try(dhcli: Run) -> None:
    """Unless it says --yes."""
    done = dhcli("solution", PLANAR, "--part", "a1")
    assert (done.code, done.out) == (2, "")
    assert "never tried: a1" in done.err
    assert f"dhcli check {PLANAR} --part a1 asks for it; --yes" in done.err
    assert dhcli("solution", PLANAR, "--part", "a1", "--yes").code == 0


def test_a_solution_is_shown_after_a_try(dhcli: Run) -> None:
    """Of that part, and of no other."""
    dhcli("check", PLANAR, "--part", "a1", "--answer", "[1 0 0 0; 0 1 0 0; 0 0 1 0; 0 0 0 1]")
    assert dhcli("solution", PLANAR, "--part", "a1").code == 0
    refused = dhcli("solution", PLANAR).err
    assert "never tried: table, a2" in refused
    assert f"dhcli check {PLANAR} --part table asks for table; --yes shows" in refused


def test_a_solution_goes_step_by_step(dhcli: Run) -> None:
    """The order of the moves, each link, each product, the answer."""
    out = dhcli("solution", PLANAR, "--part", "t02", "--yes").out
    steps = [
        out.index(text)
        for text in (
            "A_i = Rot(z, theta_i) Trans(z, d_i) Trans(x, a_i) Rot(x, alpha_i)",
            "From frame 0 to frame 1",
            "From frame 1 to frame 2",
            "T_02 = T_01 T_12",
            "So the answer is [[c12, -s12, 0, a1*c1 + a2*c12]",
        )
    ]
    assert steps == sorted(steps)


def test_the_answer_of_a_solution_is_right_when_typed(dhcli: Run) -> None:
    """Copied from the screen."""
    out = dhcli("solution", PLANAR, "--part", "t02", "--yes").out
    answer = out.rsplit("So the answer is ", 1)[1].strip()
    assert dhcli("check", PLANAR, "--part", "t02", "--answer", answer).code == 0


def test_a_solution_in_numbers_is_worked_in_numbers(dhcli: Run) -> None:
    """Each matrix with the values that went into it, in the unit of the sheet; a point in that unit too."""
    out = dhcli("solution", "zhou/six-r-at-work-in-mm", "--part", "camera", "--yes").out
    assert "From frame 0 to frame 1, with l1 = 500 mm, theta1 = 30°" in out
    assert "⎢ 0      1   0      500 ⎥" in out
    assert "the point (20, -30, 50) through T_06" in out
    assert "(20, -30, 50, 1)" in out
    assert "cos" not in out


@pytest.mark.parametrize(
    ("exercise", "part", "words"),
    [
        ("yim/counting-freedoms", "links", "n = 7 links with the ground, j = 6 joints"),
        ("yim/counting-freedoms", "limit", "The answer is 3: over all joints, i = 1 to j"),
        ("zhou/puma200-table", "table", "a_{i-1}: from z_{i-1} to z_i along x_{i-1}"),
        ("yim/planar-linkages", "f4", "F = λ(n - j - 1) + Σf = 3(4 - 4 - 1) + 4·1 = 1"),
        ("bajd/rotate-a-vector", "about_z", "multiplied with a 0 below it: (1, 0, 0, 0)"),
    ],
)
def test_a_solution_says_how(dhcli: Run, exercise: str, part: str, words: str) -> None:
    """What is counted and by which formula, what a parameter measures, which statement it is."""
    assert words in dhcli("solution", exercise, "--part", part, "--yes").out


def test_every_solution_can_be_shown(dhcli: Run) -> None:
    """For one exercise with every kind of question."""
    for name in (PLANAR, "yim/dh-factors", "yim/planar-in-numbers", "yim/counting-freedoms", "bajd/displaced-frame"):
        done = dhcli("solution", name, "--yes")
        assert (done.code, done.err) == (0, ""), name
        assert done.out.count("answer is") == len(load_exercise(name).parts)


@terminal
@pytest.mark.parametrize(("reply", "code"), [("y", 0), ("yes", 0), ("n", 2), ("", 2)])
def test_on_a_terminal_solution_asks_once(tmp_path: Path, reply: str, code: int) -> None:
    """And takes no for an answer; Enter is no."""
    with Terminal(tmp_path, "solution", PLANAR) as screen:
        asked = screen.until(r"\[y/N\] ")
        assert "You have not tried table, a1, a2" in asked
        screen.type(f"{reply}\n")
        assert screen.end() == code
        assert screen.seen.count("[y/N]") == 0
        assert ("The answer is" in screen.seen) == (code == 0)
        assert (f"dhcli hint {PLANAR}" in screen.seen) == (code == 2)


# --------------------------------------------------------------------------------------------------------- watch


def test_watch_needs_a_sheet_and_a_terminal(dhcli: Run, tmp_path: Path) -> None:
    """And says what to do without."""
    done = dhcli("watch", PLANAR)
    assert done.code == 2
    assert f"dhcli start {PLANAR} -o {SHEET} writes one" in done.err
    dhcli("start", PLANAR)
    done = dhcli("watch", PLANAR, SHEET)
    assert (done.code, done.out) == (2, "")
    assert f"dhcli check {PLANAR} {SHEET} checks once" in done.err
    assert (tmp_path / SHEET).exists()


def write(path: Path, answers: str) -> None:
    """Save a sheet as an editor does: whole, in the place of the old one."""
    beside = path.with_suffix(".tmp")
    beside.write_text(f"format: 1\nexercise: {PLANAR}\nanswers:\n{answers}", "utf-8")
    beside.replace(path)


@terminal
def test_watch_checks_at_each_save(tmp_path: Path) -> None:
    """Hints on h, an error in the sheet on the screen and not the end, q to stop."""
    path = tmp_path / SHEET
    write(path, "  a1: _\n")
    with Terminal(tmp_path, "watch", PLANAR, own_process=True) as screen:
        assert "0 of 8 parts solved" in screen.until("q quit")
        write(path, f"  a1: '{A1}'\n")
        assert "1 of 8 parts solved, 2 of 13 credits" in screen.until("q quit")
        screen.type("h")
        assert f"hint for table: {FIRST_HINT}" in screen.until("q quit")
        screen.type("h")
        assert f"hint for table: {SECOND_HINT}" in screen.until("q quit")
        screen.type("h")
        assert f"hint for table: {SECOND_HINT}" in screen.until("q quit")
        write(path, "  a1: [1, 2\n")
        assert SHEET in screen.until("q quit")
        write(path, f"  a1: '{A1}'\n  a2: '1'\n")
        assert "CAN'T READ" in screen.until("q quit")
        screen.type("r")
        assert "1 of 8 parts solved" in screen.until("q quit")
        screen.type("q")
        assert screen.end() == 0
    assert read_progress()[0][PLANAR]["a1"].best == "RIGHT"


@terminal
def test_watch_survives_a_sheet_that_is_gone_for_a_moment(tmp_path: Path) -> None:
    """And comes back."""
    path = tmp_path / SHEET
    write(path, "  a1: _\n")
    with Terminal(tmp_path, "watch", PLANAR, SHEET, own_process=True) as screen:
        screen.until("q quit")
        path.unlink()
        assert "no such file" in screen.until("q quit")
        write(path, f"  a1: '{A1}'\n")
        assert "1 of 8 parts solved" in screen.until("q quit")
        screen.type("q")
        assert screen.end() == 0


@terminal
def test_ctrl_c_ends_watch_and_gives_the_terminal_back(tmp_path: Path) -> None:
    """With 130, and no traceback."""
    write(tmp_path / SHEET, "  a1: _\n")
    with Terminal(tmp_path, "watch", PLANAR, own_process=True) as screen:
        screen.until("q quit")
        screen.interrupt()
        assert screen.end() == 130
        assert "Traceback" not in screen.seen


@terminal
def test_watch_refuses_a_sheet_of_another_exercise(tmp_path: Path) -> None:
    """As check does: its answers would all be wrong."""
    (tmp_path / SHEET).write_text("format: 1\nexercise: yim/dh-factors\nanswers: {order: _}\n", "utf-8")
    with Terminal(tmp_path, "watch", PLANAR, own_process=True) as screen:
        assert "is a sheet of yim/dh-factors, not of yim/planar-two-links" in screen.until("q quit|hint")


@terminal
def test_a_save_that_changes_nothing_is_no_try(tmp_path: Path) -> None:
    """Nor is a hint, a name, another look or another part's answer; an answer that is new is one."""
    path = tmp_path / SHEET
    write(path, "  a1: '1'\n")
    with Terminal(tmp_path, "watch", PLANAR, own_process=True) as screen:
        screen.until("q quit")
        for key in "hwr":
            screen.type(key)
            screen.until("q quit")
        write(path, "  a1: '1'\n")
        screen.until("q quit")
        write(path, "  a1: '1'\n  a2: '2'\n")
        screen.until("q quit")
        write(path, "  a1: '3'\n  a2: '2'\n")
        screen.until("q quit")
        screen.type("q")
        assert screen.end() == 0
    tries = {part: done.tries for part, done in read_progress()[0][PLANAR].items()}
    assert tries == {"a1": 2, "a2": 1}


@terminal
@pytest.mark.parametrize("options", [(), ("--why",)])
def test_watch_names_slips_where_it_is_asked(tmp_path: Path, options: tuple[str, ...]) -> None:
    """By the option, or by a key that takes it back too."""
    turned = A1.replace("-s1", "s1").replace("; s1 c1", "; -s1 c1")
    write(tmp_path / SHEET, f"  a1: '{turned}'\n")
    with Terminal(tmp_path, "watch", PLANAR, *options, own_process=True) as screen:
        shown = [screen.until("q quit")]
        for _ in range(2):
            screen.type("w")
            shown.append(screen.until("q quit"))
        screen.type("q")
        assert screen.end() == 0
    is_named = ["why: the rotation is transposed" in text for text in shown]
    assert is_named == ([True, False, True] if options else [False, True, False])


@terminal
def test_watch_draws_anew_in_a_window_of_another_size(tmp_path: Path) -> None:
    """Without another look at the sheet, which would be another try; lines fit the window."""
    write(tmp_path / SHEET, "  a1: '1'\n")
    with Terminal(tmp_path, "watch", PLANAR, own_process=True, columns=100) as screen:
        wide = screen.until("q quit")
        screen.resize(50)
        narrow = screen.until("q quit")
        screen.type("q")
        assert screen.end() == 0
    longest = [max(map(len, text.split("\x1b[H")[-1].split("\n"))) for text in (wide, narrow)]
    assert longest[0] > 50 >= longest[1]
    assert read_progress()[0][PLANAR]["a1"].tries == 1
