"""Plans are found once: those of the library are shipped, others kept, and what cannot be read is found again."""

from __future__ import annotations

import subprocess
import sys
from functools import cache
from pathlib import Path

import numpy as np
import pytest

from dhcli import inverse, load_robot
from dhcli.kinematics.inverse import choosing, keeping
from dhcli.kinematics.inverse.keeping import Kept, content_of, read, recalled, remember, written
from dhcli.kinematics.inverse.prepared import prepare
from dhcli.kinematics.inverse.tasks import TASKS
from dhcli.storage.cache import place
from tests.kinematics.inverse.arms import CLASSES, measured, random_arm
from tests.kinematics.inverse.plans import asked
from tests.nightly import some

POSE = TASKS["pose"]
POINTING_DOWN = np.array([[1, 0, 0, 0.4], [0, -1, 0, 0.2], [0, 0, -1, 0.1], [0, 0, 0, 1]])


@pytest.fixture(autouse=True)
def _forgotten() -> None:
    """Nothing is remembered from test to test."""
    prepare.cache_clear()


def test_a_robot_of_the_library_needs_no_plan(monkeypatch: pytest.MonkeyPatch) -> None:
    """Whatever of its pose is asked for, the plan is shipped, and it has the rules of the one that would be found now.

    Which of equations that serve alike it takes may differ from machine to machine, by rounding.
    """
    with monkeypatch.context() as shipped:
        shipped.setattr(choosing, "find_plan", None)
        cases = list(asked())
    assert len(cases) >= 90
    for arm, task in some(cases, 9):
        now, then = choosing.chosen(arm, task, ()), recalled(arm, task, ())
        assert then is not None
        assert [type(step) for step in now.plan.steps] == [type(step) for step in then.plan.steps]
        assert now.spare == then.spare


@pytest.mark.parametrize(
    "kind", ["three parallel", "two meet", "slide third", "general", "five joints, axis", "measured"]
)
def test_what_is_written_is_read_back(kind: str) -> None:
    """Plans of every rule."""
    rng = np.random.default_rng(3)
    if kind == "measured":
        arm, task = measured(random_arm(CLASSES["spherical wrist, two parallel"], rng), 1e-4, rng), POSE
    else:
        arm, task = random_arm(CLASSES[kind], rng), TASKS[CLASSES[kind].task]
    kept = choosing.chosen(arm, task, ())
    content = content_of(arm, task, ())
    again = read(written(kept, content), content, arm)
    assert again is not None
    for one, other in ((again.plan, kept.plan), (again.plan.meant, kept.plan.meant)):
        assert (one is None) == (other is None)
        if one is not None and other is not None:
            assert (one.held, one.steps, one.slack) == (other.held, other.steps, other.slack)
            assert one.actions.arm.axes == other.actions.arm.axes
    assert again.spare == kept.spare


def kept_file() -> Path:
    """The one file that is kept."""
    (path,) = place(keeping.FOLDER).iterdir()
    return path


@cache
def own_arm() -> Kept:
    """The plan of an arm that no file describes."""
    return choosing.chosen(random_arm(CLASSES["spherical wrist"], np.random.default_rng(1)), POSE, ())


def test_a_plan_is_kept_on_disk() -> None:
    """And found again by the numbers of the arm, which another arm does not have."""
    kept = own_arm()
    assert recalled(kept.plan.actions.arm, POSE, ()) is None
    remember(kept, POSE, ())
    again = recalled(kept.plan.actions.arm, POSE, ())
    assert again is not None
    assert again.plan.steps == kept.plan.steps
    other = random_arm(CLASSES["spherical wrist"], np.random.default_rng(2))
    assert recalled(other, POSE, ()) is None
    assert recalled(kept.plan.actions.arm, POSE, (2,)) is None
    assert recalled(kept.plan.actions.arm, TASKS["position"], ()) is None


def test_another_length_is_another_plan() -> None:
    """A robot is asked with lengths of its own: the plan is found, kept, and not taken for the robot's own."""
    robot = load_robot("puma560")
    pose = POINTING_DOWN
    inverse(robot, pose)
    assert not place(keeping.FOLDER).exists()
    first = inverse(robot, pose, parameters={"a3": 0.05})
    file = kept_file()
    stamp = file.stat().st_mtime_ns
    prepare.cache_clear()
    assert np.array_equal(inverse(robot, pose, parameters={"a3": 0.05}).q, first.q)
    assert file.stat().st_mtime_ns == stamp


@cache
def solved_and_kept() -> tuple[np.ndarray, str, str]:
    """The solutions of an arm with a length of its own, and the name and the text of the file of its plan."""
    found = inverse(load_robot("puma560"), POINTING_DOWN, parameters={"a3": 0.05})
    return found.q, kept_file().name, kept_file().read_text("utf-8")


@pytest.mark.parametrize(
    "broken", ["", "{", "null", "[]", "[1, 2]", "\0", "half", "digit", "folder", "other plan", "bytes", "[[[["]
)
def test_a_broken_plan_is_made_again(broken: str) -> None:
    """Nothing is said of it, and the solutions are all there."""
    right, name, good = solved_and_kept()
    file = place(keeping.FOLDER) / name
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(good, "utf-8")
    match broken:
        case "half":
            file.write_text(good[: len(good) // 2], "utf-8")
        case "digit":
            at = next(k for k in range(len(good) // 2, len(good)) if good[k].isdigit())
            file.write_text(good[:at] + str((int(good[at]) + 1) % 10) + good[at + 1 :], "utf-8")
        case "folder":
            file.unlink()
            file.mkdir()
        case "other plan":
            content = content_of(own_arm().plan.actions.arm, POSE, ())
            file.write_text(written(own_arm(), content), "utf-8")
        case "bytes":
            file.write_bytes(b"\xff\xfe\x00")
        case "[[[[":
            file.write_text("[" * 100_000, "utf-8")
        case _:
            file.write_text(broken, "utf-8")
    prepare.cache_clear()
    assert np.array_equal(inverse(load_robot("puma560"), POINTING_DOWN, parameters={"a3": 0.05}).q, right)
    if broken != "folder":
        assert file.read_text("utf-8") == good


def test_a_plan_of_another_format_is_made_again(monkeypatch: pytest.MonkeyPatch) -> None:
    """What was kept by an older dhcli is none of ours."""
    kept = own_arm()
    remember(kept, POSE, ())
    monkeypatch.setattr(keeping, "FORMAT", keeping.FORMAT + 1)
    assert recalled(kept.plan.actions.arm, POSE, ()) is None


def test_where_nothing_can_be_kept_the_plan_is_found_each_time(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A cache folder that is a file."""
    (tmp_path / "file").write_text("", "utf-8")
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "file"))
    kept = own_arm()
    remember(kept, POSE, ())
    assert recalled(kept.plan.actions.arm, POSE, ()) is None


def test_a_plain_solve_imports_only_what_it_needs() -> None:
    """No planning, no families, no reasons, none of the rules that most arms do without."""
    code = (
        "import sys; from dhcli import forward, inverse, load_robot; robot = load_robot('puma560');"
        "print(len(inverse(robot, forward(robot, 'nominal'))));"
        "print(*(name.rpartition('.')[2] for name in sys.modules if name.startswith('dhcli.kinematics.inverse.')))"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, encoding="utf-8", check=True)
    count, loaded = done.stdout.splitlines()
    assert count == "8"
    unneeded = {"planning", "choosing", "samples", "rule_two", "rule_all", "weak", "families", "reasons", "derive"}
    assert not unneeded & set(loaded.split())
