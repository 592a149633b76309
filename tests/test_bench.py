"""The benchmark program: what is wrong is not timed, what is missing is said, and the arithmetic of its table."""

import os
import runpy
import subprocess
import sys
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from dhcli import forward, jacobian, load_robot
from dhcli.cli.app import COMMANDS
from tests.cli.running import PIPES, start

BENCH = Path(__file__).parent / "bench"


@pytest.fixture(autouse=True)
def bench_on_path(monkeypatch: pytest.MonkeyPatch) -> None:
    """The modules of the program find each other beside it."""
    monkeypatch.syspath_prepend(str(BENCH))


def program(words: Sequence[str]) -> int:
    """What README starts."""
    sys.argv[1:] = words
    runpy.run_path(str(BENCH), run_name="__main__")
    return 0


@pytest.mark.skipif(not hasattr(os, "fork"), reason="the program runs in a copy of this process")
def test_the_program_prints_a_table_for_each_group_asked_for(tmp_path: Path) -> None:
    """With the smallest number of rounds."""
    with start(tmp_path, "pose", "parsing", "--rounds", "1", work=program, **PIPES) as running:
        out, err = running.communicate(timeout=120)
    assert running.returncode == 0, err
    lines = out.splitlines()
    assert [line for line in lines if line in {"pose", "parsing", "batch"}] == ["pose", "parsing"]
    row = next(line for line in lines if line.startswith("| one pose of puma560") and "numpy" in line)
    *_, ours, theirs, ratio, spread, _ = (cell.strip() for cell in row.split("|"))
    assert ours.endswith("s")
    assert theirs.endswith("s")
    assert float(ratio) > 0
    assert spread == "one pair"


@pytest.mark.parametrize("name", ["puma560", "stanford", "zhou-6r", "panda", "ur5e"])
def test_every_peer_at_hand_says_what_forward_says(name: str) -> None:
    """Both conventions, a sliding joint, and a row that does not move; for one pose and for a stack."""
    import peers
    import poses

    robot = load_robot(name)
    q = poses.joint_values(robot, 3)
    expected = np.array([forward(robot, row.tolist()).rows for row in q])
    for peer in peers.PEERS:
        if peer.version:
            assert poses.equal(peer.many(robot)(q), expected)
            assert poses.equal(peer.build(robot)(q[0]), expected[0])


@pytest.mark.parametrize("name", ["planar-2r", "puma560", "stanford", "panda", "ur5e"])
def test_every_peer_at_hand_says_what_jacobian_says(name: str) -> None:
    """Columns of z × (p - o), of both conventions and a slide."""
    import motion
    import poses

    robot = load_robot(name)
    q = poses.joint_values(robot, 3)
    for peer in motion.PEERS:
        if peer.version:
            assert poses.equal(peer.many(robot)(q), jacobian(robot, q))


def test_jacobians_are_measured_beside_poses_and_sympy(monkeypatch: pytest.MonkeyPatch) -> None:
    """The smallest robot: the rows of each group."""
    import motion

    monkeypatch.setattr(motion, "PEERS", motion.PEERS[:1])
    rows = [*motion.batch(1, ("planar-2r",), 50), *motion.one(1, ("planar-2r",)), *motion.symbols(1, ("planar-2r",))]
    assert [row.work for row in rows] == [
        *["50 Jacobians of planar-2r"] * 2,
        "one Jacobian of planar-2r",
        "Jacobian of planar-2r",
    ]
    assert all(row.pairs for row in rows)


def test_a_peer_that_says_something_else_stops_the_program(monkeypatch: pytest.MonkeyPatch) -> None:
    """Its time would mean nothing."""
    import peers
    import poses

    wrong = replace(peers.PEERS[0], name="wrong", build=lambda robot: lambda q: peers.by_numpy(robot)(q + 1e-9))
    monkeypatch.setattr(poses, "PEERS", (wrong,))
    for group in (poses.one(1), poses.batch(1, sizes=(5,)), poses.growth(1, sizes=(), size=5)):
        with pytest.raises(SystemExit, match="wrong do not say the same"):
            next(group)


def test_a_peer_that_is_not_installed_is_listed_as_such(monkeypatch: pytest.MonkeyPatch) -> None:
    """It is not built, and its row has no times."""
    import measure
    import peers
    import poses

    absent = replace(peers.PEERS[0], name="nobody's", package="dhcli-no-such-package")
    monkeypatch.setattr(poses, "PEERS", (absent,))
    rows = [*poses.one(1, robots=("puma560",)), *poses.batch(1, sizes=(5,)), *poses.growth(1, sizes=(), size=5)]
    assert len(rows) == 9
    assert not any(row.pairs for row in rows)
    assert measure.table(rows[:1]).splitlines() == [
        "| work                | dhcli             | peer     | peer takes    |",
        "|---------------------|-------------------|----------|---------------|",
        "| one pose of puma560 | forward(robot, q) | nobody's | not installed |",
    ]


def test_the_other_ways_of_many_poses_have_their_rows(monkeypatch: pytest.MonkeyPatch) -> None:
    """Threads and sweeps beside what they replace; arrays and the compiled loop beside whoever is installed."""
    import arrays
    import poses

    monkeypatch.setattr(poses, "find_spec", lambda name: None)
    monkeypatch.setattr(poses, "PEERS", poses.PEERS[:1])
    rows = [*poses.threads(1, sizes=(50,), count=3), *poses.sweeps(1, counts=(4,))]
    assert [row.work for row in rows] == ["5e1 poses of puma560", "a grid of 3x3x3", "a grid of 4x4x4"]
    assert all(row.pairs for row in rows)
    assert [row.peer for row in poses.fast(1, sizes=(50,))] == ["numba"]
    assert [row.peer for row in arrays.rows(1, sizes=(50,))] == ["JAX, jit and vmap", "PyTorch Kinematics"]


def test_batches_say_what_a_pose_and_a_joint_cost(monkeypatch: pytest.MonkeyPatch) -> None:
    """Panda's first two joints, three, and so on to all seven."""
    import peers
    import poses

    monkeypatch.setattr(poses, "PEERS", peers.PEERS[:1])
    rows = [*poses.batch(1, sizes=(50,)), *poses.growth(1, sizes=(50,), size=50)]
    assert [row.work for row in rows] == [
        *["5e1 poses of puma560"] * 2,
        *(f"5e1 poses of {n} joints" for n in range(2, 8)),
    ]
    assert all("ns a pose" in row.note for row in rows)
    assert all("ns a joint" in row.note for row in rows[2:])


def test_a_row_has_medians_of_the_pairs_and_the_spread_of_their_ratios() -> None:
    """The ratio is the median of the ratios, and not the ratio of the medians."""
    from measure import Row, table

    pairs = ((1.0, 2.0), (2.0, 2.0), (1.5, 6.0))
    assert table([Row("work", "ours", "peer", pairs, "note")]).splitlines() == [
        "| work | dhcli | peer | dhcli takes | peer takes | peer/dhcli | spread      | note |",
        "|------|-------|------|-------------|------------|------------|-------------|------|",
        "| work | ours  | peer | 1.50 s      | 2.0 s      | 2.0        | 1.00 to 4.0 | note |",
    ]


def test_what_takes_long_is_measured_once(monkeypatch: pytest.MonkeyPatch) -> None:
    """And the table says so; everything else gets its rounds after one pair that is not counted."""
    import measure

    calls = []
    tasks = measure.Task("ours", lambda: calls.append("ours")), measure.Task("peer", lambda: calls.append("peer"))
    monkeypatch.setattr(measure, "SHORTEST", 0)
    row = measure.side_by_side("work", *tasks, lambda ours, theirs: True, rounds=2)
    assert calls == ["ours", "peer"] * 3
    assert len(row.pairs) == 2
    monkeypatch.setattr(measure, "LONGEST", 0)
    row = measure.side_by_side("work", *tasks, lambda ours, theirs: True, rounds=2)
    assert len(calls) == 8
    assert row.cells()[6] == "one pair"


def test_rounds_are_fewer_where_they_would_take_long(monkeypatch: pytest.MonkeyPatch) -> None:
    """As many as the time allows, two at least."""
    import measure

    times = iter([(0.5, None), (0.5, None)] * 3)
    monkeypatch.setattr(measure, "timed", lambda work: next(times))
    monkeypatch.setattr(measure, "seconds", lambda work, often: 0.5)
    task = measure.Task("", lambda: None)
    for longest, count in ((3.0, 3), (1.2, 2), (9.0, 5)):
        monkeypatch.setattr(measure, "LONGEST", longest)
        assert len(measure.side_by_side("work", task, task, lambda ours, theirs: True, rounds=5).pairs) == count


def test_where_dhcli_is_behind_is_said() -> None:
    """The furthest first; not where it is ahead, nor where there is no peer."""
    from measure import Row, behind

    rows = [Row("a", "ours", "x", ((2.0, 1.0),)), Row("b", "ours", "y", ((1.0, 2.0),))]
    rows += [Row("c", "ours", "z", ((8.0, 2.0),)), Row("d", "ours", "none")]
    assert behind(rows) == ["c, ours: 4.0 times z", "a, ours: 2.0 times x"]


def test_a_processor_can_do_without_what_numpy_chooses_its_code_by() -> None:
    """Where there is AVX-512, a program that is told so says that there is none, and has nothing more to do without."""
    import processor

    environment = processor.without_wide()
    assert ("AVX-512" in processor.processor().split(", ")) is bool(environment)
    if environment:
        program = "import processor; print(processor.processor(), processor.without_wide())"
        done = subprocess.run(
            [sys.executable, "-c", program],
            cwd=BENCH,
            env=environment,
            capture_output=True,
            encoding="utf-8",
            check=True,
        )
        assert "no AVX-512" in done.stdout
        assert done.stdout.endswith("{}\n")


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (12.0, "12.0 s"),
        (0.0433, "43 ms"),
        (0.00156, "1.56 ms"),
        (9.96e-6, "10.0 µs"),
        (2e-9, "2.0 ns"),
        (250.0, "250 s"),
    ],
)
def test_a_time_has_two_digits_and_a_unit(value: float, text: str) -> None:
    """Three where the first is 1."""
    from measure import duration

    assert duration(value) == text


def test_symbols_are_compared_and_counted() -> None:
    """A small robot, for sympy takes its time."""
    import symbols
    import sympy

    (row,) = symbols.rows(1, ("planar-2r",), end=2)
    assert row.note == "operations: 6, sympy's 6"
    x, y = sympy.symbols("x y", real=True)
    assert symbols.binary(sympy.cos(x + y) ** 2 - x / 3) == 3
    assert symbols.agree(sympy.Matrix([x + y]), sympy.Matrix([y + x]))
    assert not symbols.agree(sympy.Matrix([x + y]), sympy.Matrix([x - y]))


def test_start_up_has_a_row_for_every_command_that_ends() -> None:
    """A command that is new gets its row."""
    from startup import COMMANDS as TIMED

    assert {typed.split()[0] for typed in TIMED} == {"--help", *COMMANDS} - {"watch"}


def test_start_up_is_held_against_one_unit(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """By time, and by instructions where perf counts them; a command that fails is not timed."""
    import startup
    from measure import Row

    for name in ("PYTHONPYCACHEPREFIX", "XDG_DATA_HOME"):  # the group sets these; put back at the end
        monkeypatch.setenv(name, "")
    monkeypatch.setenv("PYTHONDONTWRITEBYTECODE", "1")
    monkeypatch.setattr(startup, "furnish", lambda _home: None)
    monkeypatch.setattr(startup, "UNIT", "import sys")
    row = Row("a command", "the whole process", startup.UNIT, ((0.3, 0.2), (0.2, 0.2), (0.4, 0.2)))
    assert startup.in_units(row, 300, 200) == "1.50 units, 1.50 by instructions"
    assert startup.in_units(row, 0, 0) == "1.50 units"
    counted = startup.instructions([sys.executable, "-c", ""], str(tmp_path))
    assert counted == 0 or counted > 1_000_000
    with pytest.raises(SystemExit, match="do not say the same"):
        list(startup.rows(1, ("fk no-such-robot",)))
