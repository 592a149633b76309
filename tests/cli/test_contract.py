"""What scripts rely on: exit codes, the keys of the JSON envelope, and which stream has what."""

import json
import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest

from dhcli.cli import app
from dhcli.cli.main import CALLED, main
from tests.cli.running import Run, nobody_reads
from tests.row_by_row import row_by_row

ROOT = Path(__file__).parents[2]
ENVELOPE = {"dhcli", "command", "ok", "data", "problems"}
PROBLEM = {"severity", "message", "hint", "source", "line", "column"}
FK = {"robot", "convention", "values", "symbolic", "reference", "frame", "matrix"}
POSE = {"name", "reference", "frame", "matrix"}


def test_a_command_that_worked_ends_with_0(dhcli: Run) -> None:
    """And says nothing on stderr."""
    done = dhcli("fk", "scara", "--pose", "pick")
    assert (done.code, done.err) == (0, "")


def test_bad_input_ends_with_2(dhcli: Run) -> None:
    """And leaves stdout empty."""
    done = dhcli("fk", "nobody")
    assert (done.code, done.out) == (2, "")


def test_a_bug_ends_with_3_and_a_short_message(dhcli: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    """How to report it, and no traceback."""

    def broken(name: str, **_: object) -> None:
        raise ZeroDivisionError(name)

    monkeypatch.setattr("dhcli.files.yaml.robots.load_robot", broken)
    done = dhcli("fk", "scara")
    assert done.code == 3
    assert done.err.startswith("dhcli: this is a bug in dhcli: ZeroDivisionError: scara\n  hint: please report it")
    assert "Traceback" not in done.err


def test_a_bug_shows_its_traceback_when_asked(monkeypatch: pytest.MonkeyPatch) -> None:
    """DHCLI_DEBUG is for those who mend it."""

    def broken(name: str, **_: object) -> None:
        raise ZeroDivisionError(name)

    monkeypatch.setattr("dhcli.files.yaml.robots.load_robot", broken)
    monkeypatch.setenv("DHCLI_DEBUG", "1")
    with pytest.raises(ZeroDivisionError):
        main(["fk", "scara"])


@pytest.mark.skipif(os.name == "nt", reason="signals as Unix knows them")
def test_ctrl_c_ends_with_130_and_no_traceback(tmp_path: Path) -> None:
    """While it waits for standard input: the first byte of the prompt is not needed, the message of the wait is."""
    code = "import sys, dhcli.files.reading as r\nfrom dhcli.cli.main import main\n"
    code += "def wait():\n    print('waiting', flush=True)\n    import time\n    time.sleep(60)\n"
    code += "r.standard_input = wait\nsys.exit(main(['fk', '-']))"
    environment = {**os.environ, "PYTHONPATH": str(Path(__file__).parents[2])}
    with subprocess.Popen(
        [sys.executable, "-c", code], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=environment
    ) as running:
        assert running.stdout is not None
        assert running.stdout.readline() == "waiting\n"
        running.send_signal(signal.SIGINT)
        _, err = running.communicate(timeout=30)
    assert running.returncode == 130
    assert "Traceback" not in err


@pytest.mark.skipif(os.name == "nt", reason="needs bash")
@pytest.mark.parametrize(
    "words", ["fk puma560 -s --frames", "sweep planar-2r", "list", "show puma560", "--help", "fk --help"]
)
def test_a_reader_that_goes_away_changes_nothing(dhcli: Run, words: str) -> None:
    """The exit code is that of the work, and nothing is said."""
    with nobody_reads() as stdout:
        done = dhcli(*words.split(), stdout=stdout)
    assert (done.code, done.err) == (0, "")


@pytest.mark.skipif(os.name == "nt", reason="needs bash")
@pytest.mark.parametrize("unbuffered", ["", "1"])
def test_nor_does_it_when_python_ends(process: Run, unbuffered: str) -> None:
    """What stands in its buffers then is forgotten."""
    script = '"$0" -m dhcli fk puma560 --symbolic --frames | true; echo "${PIPESTATUS[0]}"'
    done = process(script, PYTHONUNBUFFERED=unbuffered)
    assert (done.out, done.err) == ("0\n", "")


@pytest.mark.skipif(os.name == "nt", reason="needs bash")
def test_a_broken_pipe_keeps_the_code_of_bad_input(process: Run) -> None:
    """The envelope of the error had no reader."""
    done = process('"$0" -m dhcli fk nobody --format json | true; echo "${PIPESTATUS[0]}"')
    assert done.out == "2\n"


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="needs /dev/full")
def test_a_full_disk_is_told(process: Run) -> None:
    """What could not be written was not done."""
    done = process('"$0" -m dhcli fk scara --pose pick > /dev/full')
    assert done.code == 2
    assert "standard output: cannot be written" in done.err
    assert "Traceback" not in done.err


@pytest.mark.skipif(os.name == "nt", reason="needs bash")
def test_closed_streams_are_no_bug(process: Run) -> None:
    """`>&-`, as some daemons start their children."""
    assert process('"$0" -m dhcli fk scara --pose pick >&- 2>&-').code == 0


def test_the_envelope_of_a_pose_has_exactly_these_keys(dhcli: Run) -> None:
    """A new key is a decision, and stands here."""
    envelope = dhcli("fk", "scara", "--pose", "pick", "--format", "json").envelope
    assert set(envelope) == ENVELOPE
    assert (envelope["dhcli"], envelope["command"], envelope["ok"], envelope["problems"]) == (1, "fk", True, [])
    assert set(envelope["data"]) == FK
    assert all(isinstance(entry, float) for row in envelope["data"]["matrix"] for entry in row)


@pytest.mark.parametrize(
    ("words", "key"),
    [("--frames", "frames"), ("--links", "links"), ("--factors all", "factors")],
)
def test_a_listing_adds_one_key(dhcli: Run, words: str, key: str) -> None:
    """A list of poses with names."""
    data = dhcli("fk", "scara", "--pose", "pick", *words.split(), "--format", "json").data
    assert set(data) == {*FK, key}
    assert all(set(pose) == POSE for pose in data[key])


def test_a_point_adds_one_key(dhcli: Run) -> None:
    """As it was given, and as it is seen."""
    data = dhcli("fk", "scara", "--pose", "pick", "--point", "1,2,l1", "--format", "json").data
    assert set(data) == {*FK, "point"}
    assert data["point"]["given"] == [1.0, 2.0, "l1"]
    assert [type(value) for value in data["point"]["seen"]] == [float] * 3


def test_other_ways_add_one_key(dhcli: Run) -> None:
    """By the names that were asked for."""
    words = ("--as", "rpy,axis-angle,quaternion,position")
    data = dhcli("fk", "scara", "--pose", "pick", *words, "--format", "json").data
    assert set(data) == {*FK, "as"}
    assert {form: set(said) for form, said in data["as"].items() if isinstance(said, dict)} == {
        "rpy": {"roll", "pitch", "yaw"},
        "axis-angle": {"axis", "angle"},
        "quaternion": {"w", "x", "y", "z"},
    }
    assert len(data["as"]["position"]) == 3


def test_let_adds_definitions(dhcli: Run) -> None:
    """Formulas are text."""
    data = dhcli("fk", "puma560", "-s", "--let", "--format", "json").data
    assert set(data) == {*FK, "definitions"}
    assert data["definitions"][0] == {
        "name": "k1",
        "value": "cos(theta4)*cos(theta5)*cos(theta6) - sin(theta4)*sin(theta6)",
    }
    assert all(isinstance(entry, str) for row in data["matrix"] for entry in row)


def test_an_error_has_the_same_envelope(dhcli: Run) -> None:
    """On stdout, for the program that reads it; the talk is on stderr as ever."""
    done = dhcli("fk", "scara", "--q", "30mm,0,0", "--format", "json")
    assert done.code == 2
    assert set(done.envelope) == ENVELOPE
    assert (done.envelope["ok"], done.envelope["data"], done.envelope["command"]) == (False, None, "fk")
    (problem,) = done.envelope["problems"]
    assert set(problem) == PROBLEM
    assert (problem["severity"], problem["source"], problem["line"], problem["column"]) == ("error", "--q", None, 1)


def test_a_misspelled_option_speaks_json_too(dhcli: Run) -> None:
    """What typer finds is no exception."""
    done = dhcli("fk", "scara", "--formt", "x", "--format=json")
    assert done.envelope["problems"][0]["message"] == "there is no option --formt"


def test_the_transform_has_exactly_these_keys(dhcli: Run) -> None:
    """Points and vectors are lists, empty or not."""
    data = dhcli("transform", "Rot(z,90°)", "--point", "1,0,0", "--format", "json").data
    assert set(data) == {"order", "symbolic", "reference", "frame", "matrix", "steps", "points", "vectors"}
    assert [set(step) for step in data["steps"]] == [{"move", "reference", "frame", "matrix"}]
    assert data["points"] == [{"given": [1.0, 0.0, 0.0], "seen": [0.0, 1.0, 0.0]}]


def test_the_list_has_exactly_these_keys(dhcli: Run) -> None:
    """One entry for each file."""
    data = dhcli("list", "robots", "--format", "json").data
    assert set(data) == {"entries"}
    keys = {"kind", "name", "joints", "solved", "title", "origin", "path", "shadowed", "broken"}
    assert all(set(entry) == keys for entry in data["entries"])
    assert "scara" in {entry["name"] for entry in data["entries"]}


def test_a_robot_has_exactly_these_keys(dhcli: Run) -> None:
    """Everything that the page shows."""
    data = dhcli("show", "puma560", "--format", "json").data
    assert set(data) == {
        *("name", "title", "source", "notes", "convention", "pattern", "frames", "columns", "links", "joints"),
        *("parameters", "poses", "base", "tool", "tools", "actuators"),
    }
    assert set(data["links"][0]) == {"number", "a", "alpha", "d", "theta"}
    assert set(data["joints"][0]) == {"name", "kind", "link", "called", "limits"}


@row_by_row("name", app.COMMANDS)
def test_every_command_has_a_help_page_with_examples(dhcli: Run, name: str) -> None:
    """That work as they stand, as far as they need no file."""
    done = dhcli(name, "--help")
    assert (done.code, done.err) == (0, "")
    assert f"dhcli {name}" in done.out
    assert "Examples" in done.out or name == "new"


def test_the_examples_of_the_help_pages_work(dhcli: Run) -> None:
    """Every line that begins with dhcli."""
    from importlib import import_module
    from shlex import split

    modules = [import_module(f"dhcli.cli.commands.{name}") for name in app.COMMANDS]
    texts = [app.EXAMPLES, *(getattr(module, "EXAMPLES", "") for module in modules)]
    lines = [line for text in texts for line in text.split("\n") if line.startswith("dhcli ")]
    assert len(lines) > 10
    assert dhcli("start", "planar-two-links").code == 0
    for folder in (Path("homework-3"), Path("submission")):
        folder.mkdir()
        (folder / "student.yaml").write_bytes(Path("planar-two-links.sheet.yaml").read_bytes())
    for name in ("my-table.yaml", "my-frames.yaml"):
        Path(name).write_text((ROOT / "robots" / "puma560.yaml").read_text(encoding="utf-8"), encoding="utf-8")
    Path("robots").mkdir()
    arm = (ROOT / "robots" / "scara.yaml").read_text(encoding="utf-8")
    Path("robots/my-arm.yaml").write_text(arm, encoding="utf-8")
    Path("exercises/my-course").mkdir(parents=True)
    exercise = (ROOT / "exercises/yim/planar-two-links.yaml").read_text(encoding="utf-8")
    Path("exercises/my-course/first.yaml").write_text(exercise, encoding="utf-8")
    Path("planar-two-links.sheet.yaml").rename("blank.yaml")
    Path("q.csv").write_text("0.1,0.2,0.3,0.4,0.5,0.6\n", encoding="utf-8")
    Path("names.txt").write_text("Ada\n", encoding="utf-8")
    for line in sorted(lines, key=lambda line: not line.startswith("dhcli start")):
        done = dhcli(*split(line)[1:])
        if line.startswith("dhcli watch"):
            assert "terminal" in done.err
        elif line.endswith("planar-two-links.sheet.yaml"):
            assert done.code == 1, "a blank sheet is not right"
        else:
            assert done.code == 0, (line, done.out, done.err)


def test_the_version_is_that_of_the_package(dhcli: Run) -> None:
    """On stdout."""
    from dhcli import __version__

    assert dhcli("--version").out == f"dhcli {__version__}\n"


def test_no_words_show_the_help(dhcli: Run) -> None:
    """As a newcomer starts."""
    done = dhcli()
    assert done.code == 0
    assert "Usage: dhcli" in done.out


@pytest.mark.parametrize(
    ("words", "expected"),
    [
        ("dhcli fk puma5", "puma560"),
        ("dhcli show scara-z", "scara-zhou"),
        ("dhcli sh", "show"),
        ("dhcli list li", "linkages"),
    ],
)
def test_the_shell_completes_names(dhcli: Run, words: str, expected: str) -> None:
    """Robots, commands and kinds."""
    count = str(len(words.split()) - 1)
    done = dhcli(_DHCLI_COMPLETE="complete_bash", COMP_WORDS=words, COMP_CWORD=count)
    assert expected in done.out.split("\n")


@pytest.mark.parametrize("words", ["", "fk", "new robot"])
def test_help_has_a_short_name(dhcli: Run, words: str) -> None:
    """Of every command; it is the same page."""
    short, long = dhcli(*words.split(), "-h"), dhcli(*words.split(), "--help")
    assert (short.code, short.out) == (0, long.out)
    assert "Usage: dhcli" in short.out


def test_a_word_that_is_no_command_is_answered_in_whole_sentences(dhcli: Run) -> None:
    """Also where no command is like it."""
    assert "hint: dhcli --help shows what can be typed" in dhcli("xyzzy").err
    assert "hint: did you mean sweep?; dhcli --help" in dhcli("swep").err


@pytest.mark.parametrize(
    ("word", "hint"),
    [
        ("forward", "did you mean dhcli fk?"),
        ("Ikine", "did you mean dhcli ik?"),
        ("mobility", "did you mean dhcli dof?"),
        ("version", "did you mean dhcli --version?"),
        ("jacobean", "did you mean jacobian?"),
        ("code", "dhcli help code tells of it"),
        ("urdf", "dhcli help urdf tells of it"),
    ],
)
def test_a_command_by_another_name_is_told_by_its_own(dhcli: Run, word: str, hint: str) -> None:
    """That of another program, one mistyped, or a word that is a page of the manual."""
    assert f"hint: {hint}; dhcli --help shows what can be typed" in dhcli(word).err


def test_each_command_that_another_word_is_told_as_is_there(dhcli: Run) -> None:
    """With a page of its own; and no other word is a command itself."""
    for command in sorted({*CALLED.values()}):
        assert dhcli(command, *(() if command.startswith("-") else ("--help",))).code == 0
    assert not {*CALLED} & {*app.COMMANDS}


def test_an_option_before_its_command_is_told_to_stand_behind_it(dhcli: Run) -> None:
    """And the answer in JSON names the command."""
    done = dhcli("--format", "json", "fk", "scara")
    assert "hint: options stand behind the command; dhcli --help" in done.err
    assert json.loads(done.out)["command"] == "fk"


def test_an_option_with_one_value_is_not_given_twice(dhcli: Run) -> None:
    """The first one would be dropped in silence; flags and lists may be repeated."""
    done = dhcli("fk", "scara", "--q", "0,0,0", "--point", "0,0,1", "--point", "0,0,2")
    assert (done.code, done.out) == (2, "")
    assert "--point is given 2 times" in done.err
    assert dhcli("fk", "scara", "--q", "0,0,0", "--deg", "--deg", "--set", "l1=1", "--set", "l2=1").code == 0


@pytest.mark.parametrize(
    ("words", "formats", "suffixes"),
    [
        ("list", "table, json or csv.", ".json .csv .txt"),
        ("show", "table, json, latex, csv or md.", ".json .tex .csv .md .txt"),
        ("dof", "table or json.", ".json .txt"),
    ],
)
def test_help_names_the_formats_there_are(dhcli: Run, words: str, formats: str, suffixes: str) -> None:
    """And no others."""
    page = " ".join(dhcli(words, "--help").out.replace("│", " ").split())
    assert f"--format NAME {formats}" in page
    assert f"Write to a file; {suffixes} choose the format." in page


@pytest.mark.parametrize(
    ("words", "found"),
    [
        ("fk puma560 --pose re", ["ready"]),
        ("fk scara --to t", ["tool"]),
        ("sweep scara --over th", ["theta1", "theta2"]),
        ("sweep ./no-such.yaml --over th", []),
        ("fk scara --as rpy,p", ["rpy,position"]),
        ("list --format c", ["csv"]),
        ("describe scara --as mo", ["modified", "motors"]),
        ("describe scara --choose n", ["next-d"]),
        ("schema e", ["exercise"]),
        ("start yim/planar-l", ["yim/planar-linkages"]),
        ("dof benn", ["bennett"]),
        ("help judg", ["judging"]),
    ],
)
def test_the_shell_completes_what_a_robot_has(dhcli: Run, words: str, found: list[str]) -> None:
    """Poses, frames, joints; formats and forms; nothing where the robot cannot be read."""
    typed = f"dhcli {words}"
    done = dhcli(_DHCLI_COMPLETE="complete_bash", COMP_WORDS=typed, COMP_CWORD=str(len(typed.split()) - 1))
    assert done.out.split() == found
