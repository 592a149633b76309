"""Nothing crashes, nothing hangs: mutated input at every door ends with 0, 1 or 2, in words, and within bounds.

`DHCLI_FUZZ=5000 pytest tests/fuzz` tries so many cases a door, `DHCLI_FUZZ_SEED=x` others; see the manual, "building".
"""

from __future__ import annotations

import inspect
import json
import os
import pickle
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import dhcli
from dhcli import DhcliError, Pose, Robot, load_exercise, load_robot
from dhcli.cli.app import COMMANDS, load
from dhcli.lint import variants
from tests.cli.running import run
from tests.fuzz.corpus import CASES, SLOW
from tests.fuzz.doors import DOORS, LINES, ROOT, Case, cases
from tests.fuzz.measuring import MOST_BYTES, TooMuchWorkError, counted
from tests.nightly import NIGHT, cases_for_nights, in_turn, some

COUNT = int(os.environ.get("DHCLI_FUZZ", "0")) or (250 if NIGHT else 12)
SEED = os.environ.get("DHCLI_FUZZ_SEED", "dhcli")
STEERING = set("\x1b\x07\x9b\x85\u202e\u200b\u2028")
OWN = ("--open", "--help", "--install-completion", "--show-completion", "--version")
"""Options that are typer's, and the one that opens a window."""


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """An empty folder to run in."""
    monkeypatch.chdir(tmp_path)
    return tmp_path


def fault_of(case: Case, *, memory: bool = False) -> str:
    """What is wrong with how a case ended; empty if nothing is."""
    for name, content in case.files.items():
        path = Path(name)
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content)
    try:
        with counted(memory=memory) as count:
            done = run(*case.words, stdin=case.stdin)
    except TooMuchWorkError as error:
        return str(error)
    said = done.out + done.err
    if done.code not in (0, 1, 2):
        return f"exit {done.code}: {done.err}"
    if "Traceback" in said or STEERING & set(said):
        return f"says {said[:400]!r}"
    if done.code == 2 and not done.err.startswith("dhcli: ") and "CAN'T READ" not in done.out:
        return f"2 without a word: {said[:400]!r}"
    if count.bytes > MOST_BYTES:
        return f"{count.bytes:,} bytes"
    if done.out and "--format" in case.words and "json" in case.words and "-o" not in case.words:
        json.loads(done.out)
    return ""


@pytest.mark.parametrize("door", DOORS)
def test_mutated_input_ends_in_words(door: str) -> None:
    """Whatever is found is a case to be kept in the corpus."""
    found = [(case, fault) for case in cases(door, COUNT, SEED) if (fault := fault_of(case))]
    assert found == []


@pytest.mark.parametrize("name", cases_for_nights(list(CASES), *(set(CASES) - SLOW)))
def test_what_was_found_once_stays_mended(name: str) -> None:
    """Each within a second of calls and 200 MB."""
    assert fault_of(CASES[name], memory=NIGHT) == ""


def test_every_option_of_every_command_is_mutated() -> None:
    """A new option needs a line that has it."""
    known = {(words[0], word) for words in LINES for word in words if word.startswith("-")}
    missing = [
        (name, param.opts)
        for name in COMMANDS
        for command in (load(name), *getattr(load(name), "commands", {}).values())
        for param in command.params
        if param.opts[0].startswith("-") and param.opts[0] not in OWN and not {(name, o) for o in param.opts} & known
    ]
    assert missing == []


def test_every_line_is_valid_before_it_is_mutated(monkeypatch: pytest.MonkeyPatch) -> None:
    """Else nothing but the first check would be tried; `watch` needs a terminal; by day at least one a command."""
    monkeypatch.setattr(variants, "SEEDS", some(variants.SEEDS, 50))
    one_of_each = {words[0]: words for words in LINES}.values()
    files = next(cases("words", 1, "files")).files
    refused = []
    for words in LINES if NIGHT else dict.fromkeys((*one_of_each, *some(LINES, 6))):
        for name, content in files.items():
            Path(name).parent.mkdir(parents=True, exist_ok=True)
            Path(name).write_bytes(content)
        done = run(*words)
        if done.code not in (0, 1) and words[0] != "watch":
            refused.append((words, done.err))
    assert refused == []


# --- The library -------------------------------------------------------------------------------------------------

JUNK: tuple[Any, ...] = (
    *(None, True, 0, -1, 3.5, float("nan"), float("inf"), 10**400, 1j, "", "abc", "0,0,0", "a\0", b"x", object()),
    *([], [None], [1, 2], [[1, 2, 3]], {}, {"theta1": None}, {1: 2}, {"x": "y"}, (1, "30°", 0.1), np.zeros(3)),
    *(
        np.zeros((2, 3)),
        np.array(["a"]),
        np.array([[]]),
        range(3),
        iter([1]),
        "Rot(z,90°)",
        "θ1=1",
        ["1e400", "0", "0"],
    ),
)


def calls() -> Iterator[tuple[str, Callable[[Any], Any]]]:
    """Every public function, with junk in the place of each argument."""
    robot = load_robot("scara")
    q = [0.1, 0.2, 0.3]
    yield "load_robot", load_robot
    yield "load_exercise", load_exercise
    for function in (dhcli.forward, dhcli.symbolic):
        yield f"{function.__name__} robot", function
        yield f"{function.__name__} q", lambda junk, f=function: f(robot, junk)
        for name in ("start", "end", "parameters"):
            yield f"{function.__name__} {name}", lambda junk, f=function, n=name: f(robot, q, **{n: junk})
    for function, names in (
        (dhcli.forward_batch, ("start", "end", "parameters", "out", "dtype", "threads")),
        (
            dhcli.jacobian,
            ("start", "end", "axes", "place", "point", "part", "analytic", "parameters", "dtype", "threads"),
        ),
    ):
        yield f"{function.__name__} robot", lambda junk, f=function: f(junk, [q])
        yield f"{function.__name__} Q", lambda junk, f=function: f(robot, junk)
        for name in names:
            yield f"{function.__name__} {name}", lambda junk, f=function, n=name: f(robot, [q], **{n: junk})
    over = ["theta1=0..1 n 3", "d3=0..0.1 n 2"]
    yield "sweep robot", lambda junk: dhcli.sweep(junk, over)
    yield "sweep over", lambda junk: dhcli.sweep(robot, junk)
    for name in ("q", "start", "end", "point", "parameters", "threads"):
        yield f"sweep {name}", lambda junk, n=name: dhcli.sweep(robot, over, **{n: junk})
    for name in ("tool", "base", "links", "variables", "parameters", "limits", "poses", "convention"):
        yield f"replace {name}", lambda junk, n=name: replace(robot, **{n: junk})
    yield from makers()
    yield from motions()
    exercise = load_exercise("yim/planar-in-numbers")
    yield "check exercise", lambda junk: dhcli.check(junk, "a1", "1")
    yield "check part", lambda junk: dhcli.check(exercise, junk, "1")
    yield "check answer", lambda junk: dhcli.check(exercise, "a1", junk)
    yield "Pose", Pose
    yield "Pose rows", lambda junk: Pose([[junk] * 4] * 4)  # type: ignore[arg-type]


def motions() -> Iterator[tuple[str, Callable[[Any], Any]]]:
    """The ways back, velocities and pictures; but for what is only yes or no."""
    robot = load_robot("scara")
    q = [0.1, 0.2, 0.3]
    pose = dhcli.forward(robot, q)
    for function, given in (
        (dhcli.inverse, {"robot": robot, "T": pose}),
        (dhcli.inverse_batch, {"robot": robot, "T": [pose.matrix]}),
        (dhcli.follow, {"robot": robot, "T": [pose.matrix], "near": q}),
        (dhcli.joint_rates, {"robot": robot, "q": q, "velocity": [0.1, 0, 0]}),
        (dhcli.velocity_of, {"robot": robot, "q": q, "rates": q}),
        (dhcli.torques, {"robot": robot, "q": q, "force": [1, 0, 0]}),
        (dhcli.symbolic_torques, {"robot": robot}),
        (dhcli.symbolic_jacobian, {"robot": robot}),
        (dhcli.manipulability, {"robot": robot, "q": q}),
        (dhcli.singularities, {"robot": robot}),
        (dhcli.in_motors, {"robot": robot}),
        (dhcli.draw, {"what": robot, "q": q}),
    ):
        names = inspect.signature(function).parameters
        viewing = ("start", "end", "axes", "place", "point") if "viewing" in names else ()
        for name in (*names, *viewing):
            if name != "viewing" and names.get(name, NO_NAME).annotation != "bool":
                yield f"{function.__name__} {name}", lambda junk, f=function, g=given, n=name: f(**{**g, n: junk})
    for function in (dhcli.roll_pitch_yaw, dhcli.quaternions, dhcli.axis_angles):
        yield function.__name__, function


NO_NAME = inspect.Parameter("viewing", inspect.Parameter.KEYWORD_ONLY)
"""For options of a view, which a signature does not list."""


def makers() -> Iterator[tuple[str, Callable[[Any], Any]]]:
    """Every way to make a robot in Python, or another of one."""
    robot, screws, rows = load_robot("planar-2r"), [(0, 0, 1, 0, 0, 0)], [("a", 0, 0, "q1")]
    urdf = (ROOT / "tests" / "data" / "urdf" / "three-joints.urdf").read_text("utf-8")
    yield "from_screws", lambda junk: Robot.from_screws(junk, "")
    yield "from_screws home", lambda junk: Robot.from_screws(screws, junk)
    yield "from_dh", lambda junk: Robot.from_dh(junk, variables=["q1"])
    yield "from_text", Robot.from_text
    yield "from_urdf", Robot.from_urdf
    yield "save", lambda junk: None if isinstance(junk, str) else robot.save(junk)
    for name in ("frame", "variables", "name"):
        yield f"from_screws {name}", lambda junk, n=name: Robot.from_screws(screws, "", **{n: junk})
    for name in ("variables", "convention", "parameters", "name"):
        given = {"variables": ["q1"], "parameters": {"a": 1}}
        yield f"from_dh {name}", lambda junk, n=name, g=given: Robot.from_dh(rows, **{**g, n: junk})
    for name in ("base", "tip", "name"):
        yield f"from_urdf {name}", lambda junk, n=name: Robot.from_urdf(urdf, **{"tip": "tool0", n: junk})
    for name in ("tool", "base", "parameters", "name"):
        yield f"copy {name}", lambda junk, n=name: robot.copy(**{n: junk})


def test_junk_in_a_call_of_the_library_is_refused_in_words() -> None:
    """Taken, or a DhcliError; never an error of Python's that says nothing."""
    bad = []
    for turn, (name, call) in enumerate(calls()):
        for junk in in_turn(JUNK, turn, 3):
            try:
                with counted(memory=False):
                    call(junk)
            except DhcliError:
                continue
            except (Exception, TooMuchWorkError) as error:  # noqa: BLE001  that is what is looked for
                bad.append(f"{name}({junk!r:.30}): {type(error).__name__}: {error}"[:150])
    assert bad == []


def test_a_robot_made_of_junk_is_no_robot_after_a_copy() -> None:
    """What was taken is taken for good."""
    robot = replace(load_robot("scara"), tool="Trans(0,0,1)", parameters={"l1": 1, "l2": 2.5, "l3": "3 mm"})
    assert pickle.loads(pickle.dumps(robot)) == robot  # noqa: S301  our own
