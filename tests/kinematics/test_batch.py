from collections.abc import Iterator
from types import SimpleNamespace

import numpy as np
import pytest
from numpy.typing import NDArray

from dhcli import forward, forward_batch, load_robot
from dhcli.algebra import kernel
from dhcli.algebra.floats import Floats
from dhcli.algebra.loop import loop
from dhcli.errors import RobotError
from dhcli.kinematics import playing
from dhcli.kinematics.conventions import Convention
from dhcli.kinematics.fold import fold
from dhcli.kinematics.frames import between
from dhcli.kinematics.moves import Trans
from dhcli.kinematics.playing import BLOCK, CHUNK, FEW
from dhcli.kinematics.robot import Link, Robot
from dhcli.kinematics.values import numbers, parameter_values
from dhcli.notation.tree import ONE, ZERO
from tests.row_by_row import row_by_row


@pytest.fixture(params=["floats", "numpy", "loop"])
def player(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> Iterator[str]:
    """Each way in which rows are played: one by one, by numpy, by the loop, here as plain Python."""
    monkeypatch.setattr(kernel, "_LOADED", SimpleNamespace(loop=loop, is_ready=lambda count: request.param == "loop"))
    monkeypatch.setattr(playing, "FEW", 10**6 if request.param == "floats" else 0)
    with np.errstate(all="ignore"):
        yield request.param


@pytest.mark.usefixtures("player")
@pytest.mark.parametrize("name", ["scara", "puma560", "stanford", "panda"])
def test_a_batch_is_the_plain_fold_row_by_row(name: str) -> None:
    """Every pose of a batch is the pose of its row."""
    robot = load_robot(name)
    poses = np.random.default_rng(1).uniform(-3, 3, (7, len(robot.variables)))
    batch = forward_batch(robot, poses)
    for q, pose in zip(poses, batch, strict=True):
        assert np.allclose(pose, forward(robot, list(q)).matrix, atol=1e-14)


REACH = 1.0
"""At least the reach of PUMA 560 [m]."""


@pytest.mark.usefixtures("player")
@pytest.mark.parametrize(
    "q",
    [
        np.pi * np.arange(-9, 9, 2).repeat(6).reshape(-1, 6),
        np.pi * (2 * np.random.default_rng(3).integers(-(10**7), 10**7, (200, 6)) + 1.0),
        np.pi + 10.0 ** np.random.default_rng(4).uniform(-17, -2, (200, 6)),
        np.nextafter(np.pi / 2 * np.arange(1, 100, 2), 0).repeat(6).reshape(-1, 6),
        np.random.default_rng(5).uniform(-1e6, 1e6, (200, 6)),
        np.random.default_rng(6).uniform(-1e300, 1e300, (200, 6)),
        10.0 ** np.random.default_rng(7).uniform(-320, -3, (200, 6)),
    ],
    ids=["odd pi", "large odd pi", "near pi", "half pi", "large", "huge", "tiny"],
)
def test_a_batch_loses_no_digits_where_the_half_angle_tangent_has_poles_or_angles_are_large(
    q: NDArray[np.float64],
) -> None:
    """1e-14 of the reach from the plain fold of the unmerged chain, with the sines of the C library."""
    robot = load_robot("puma560")
    lengths = numbers(parameter_values(robot, {}))
    batch = forward_batch(robot, q)
    chain = between(robot, "0", "6")
    for row, pose in zip(q, batch, strict=True):
        plain = fold(chain, Floats({**lengths, **dict(zip(robot.variables, row, strict=True))}))
        assert np.abs(pose - np.array(plain)).max() <= 1e-14 * REACH


def test_a_matrix_of_another_width_is_refused() -> None:
    """The message names both shapes."""
    with pytest.raises(RobotError, match="3 joints"):
        forward_batch(load_robot("scara"), np.zeros((2, 4)))


def test_blocks_meet_without_a_seam_and_write_where_they_are_told() -> None:
    """Rows on both sides of a border are those of the plain fold; `out` may be any view of floats."""
    robot = load_robot("puma560")
    poses = np.random.default_rng(2).uniform(-4, 4, (BLOCK + 3, 6))
    wide = np.zeros((BLOCK + 3, 4, 8))
    given = forward_batch(robot, poses, out=wide[:, :, ::2])
    for k in (0, BLOCK - 1, BLOCK, BLOCK + 2):
        assert np.allclose(given[k], forward(robot, list(poses[k])).matrix, atol=1e-14)
    assert np.shares_memory(given, wide)


@pytest.mark.usefixtures("player")
def test_no_pose_and_poses_that_are_no_numbers() -> None:
    """Nothing in, nothing out; one is one; NaN and infinity stay in their row, without a warning."""
    robot = load_robot("puma560")
    assert forward_batch(robot, np.empty((0, 6))).shape == (0, 4, 4)
    assert forward_batch(robot, [[0.1] * 6])[0] == pytest.approx(forward(robot, [0.1] * 6).matrix, abs=1e-15)
    for bad in ([[np.nan] * 6], [[np.inf] * 6, [np.nan] * 6]):
        given = forward_batch(robot, [[0.1] * 6, *bad])
        assert np.isfinite(given[0]).all()
        assert np.isnan(given[1:, 0, 0]).all()


@pytest.mark.usefixtures("player")
def test_arrays_of_any_layout_are_read_and_written() -> None:
    """Columns first, every second row, read-only, integers, booleans; into a view, backwards, and in float32."""
    robot = load_robot("scara")
    q = np.random.default_rng(1).uniform(-3, 3, (20, 3))
    plain = forward_batch(robot, q)
    fixed = q.copy()
    fixed.flags.writeable = False
    for given in (np.asfortranarray(q), np.repeat(q, 2, axis=0)[::2], fixed, q.astype(object), q.tolist()):
        assert np.abs(forward_batch(robot, given) - plain).max() <= 1e-15
    whole = forward_batch(robot, np.array([[0, 1, 2], [True, False, 3]]))
    assert whole[1] == pytest.approx(forward(robot, [1, 0, 3]).matrix, abs=1e-15)
    wide = np.zeros((20, 4, 8))
    assert np.shares_memory(forward_batch(robot, q, out=wide[:, :, ::2]), wide)
    assert np.abs(wide[:, :, ::2] - plain).max() <= 1e-15
    backwards = np.zeros((20, 4, 4))[::-1]
    assert np.abs(forward_batch(robot, q, out=backwards) - plain).max() <= 1e-15


@pytest.mark.usefixtures("player")
def test_single_precision_is_double_rounded_at_the_end() -> None:
    """By `dtype`, or into an `out` of it; each entry to 6e-8 of itself, and values beyond it are infinite."""
    robot = load_robot("scara")
    q = np.random.default_rng(1).uniform(-3, 3, (20, 3))
    exact = forward_batch(robot, q)
    single = forward_batch(robot, q, dtype="float32")
    assert single.dtype == np.float32
    assert (np.abs(single - exact) <= 6e-8 * np.abs(exact)).all()
    assert np.array_equal(forward_batch(robot, q, out=np.zeros((20, 4, 4), np.float32)), single)
    assert forward_batch(robot, [[0, 0, 1e300]], dtype=np.float32)[0, 2, 3] == -np.inf


@pytest.mark.parametrize("threads", [1, 2, 5])
def test_threads_change_nothing(threads: int, player: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Chunks of few rows, so that there are many; every row is the same to the bit."""
    monkeypatch.setattr(playing, "CHUNK", 16)
    monkeypatch.setattr(playing, "STRETCH", 32)
    monkeypatch.setattr(playing, "BLOCK", 8)
    robot = load_robot("puma560")
    q = np.random.default_rng(2).uniform(-12, 12, (77, 6))
    alone = forward_batch(robot, q)
    assert np.array_equal(forward_batch(robot, q, threads=threads), alone), player
    assert np.array_equal(forward_batch(robot, q, threads=threads, out=np.zeros((77, 4, 4))), alone)


@pytest.mark.usefixtures("player")
@pytest.mark.parametrize("count", [0, 1, 2])
def test_more_threads_than_rows_are_no_matter(count: int) -> None:
    """Nor are more than a machine could start."""
    q = np.full((count, 3), 0.1)
    assert np.array_equal(forward_batch(load_robot("scara"), q, threads=10**9), forward_batch(load_robot("scara"), q))


@row_by_row("count", [0, 1, BLOCK - 1, BLOCK, 2 * BLOCK + 1, CHUNK, CHUNK + 1, 1_000_000])
@row_by_row("threads", [1, 2, 3, 7])
def test_threads_have_equal_shares(count: int, threads: int) -> None:
    """All rows once and in order, none longer than a chunk; as many for each thread where there are enough rows."""
    parts = playing.shares(count, threads, CHUNK)
    assert [part.start for part in parts[1:]] == [part.stop for part in parts[:-1]]
    sizes = [min(part.stop, count) - part.start for part in parts]
    assert sum(sizes) == count
    assert max(sizes, default=0) <= CHUNK
    if threads > 1 and count >= 2 * BLOCK * threads:
        assert len(parts) % threads == 0
        assert max(sizes) - min(sizes) < len(parts)


def test_other_lengths_are_recorded_by_themselves() -> None:
    """Called in turn with the robot's own and with others."""
    robot = load_robot("planar-2r")
    for _ in range(2):
        assert forward_batch(robot, [[0, 0]])[0, 0, 3] == pytest.approx(0.7)
        assert forward_batch(robot, [[0, 0]], parameters={"a2": 1.0})[0, 0, 3] == pytest.approx(1.4)


def test_columns_that_nobody_uses_are_used_again(monkeypatch: pytest.MonkeyPatch) -> None:
    """One call after another makes them once, and so do calls of nearly as many rows; how many are idle is bounded."""
    made = []
    plain = playing.Columns
    monkeypatch.setattr(playing, "Columns", lambda *given: made.append(1) or plain(*given))
    monkeypatch.setattr(kernel, "_LOADED", SimpleNamespace(loop=None, is_ready=lambda count: False))
    monkeypatch.setattr(playing, "_IDLE", type(playing._IDLE)(maxlen=2))
    robot = load_robot("scara")
    for _ in range(3):
        forward_batch(robot, np.zeros((FEW + 1, 3)))
    for count in range(FEW + 1, FEW + 9):
        forward_batch(robot, np.zeros((count, 3)))
    assert len(made) == 1
    for count in range(50, 500, 50):
        forward_batch(robot, np.zeros((count, 3)))
    assert len(playing._IDLE) == 2


def test_threads_and_one_thread_in_turn_make_their_columns_once(monkeypatch: pytest.MonkeyPatch) -> None:
    """Blocks of a call are equally long, so that no odd rest takes the place of what the next call needs."""
    made = []
    plain = playing.Columns
    monkeypatch.setattr(playing, "Columns", lambda *given: made.append(given[1]) or plain(*given))
    monkeypatch.setattr(kernel, "_LOADED", SimpleNamespace(loop=None, is_ready=lambda count: False))
    monkeypatch.setattr(playing, "_IDLE", type(playing._IDLE)(maxlen=4))
    robot, q = load_robot("scara"), np.zeros((CHUNK + 30_001, 3))
    for threads in (1, 2, 1, 2):
        forward_batch(robot, q, threads=threads)
    assert 2 <= len(made) <= 3
    assert max(made) < CHUNK


@pytest.mark.parametrize("rows", [[[0.1, 0.2, 0.3], [0.1]], [["a", "b", "c"]]])
def test_what_is_no_array_of_numbers_is_refused(rows: list[list[float]]) -> None:
    """Rows of different lengths, text."""
    with pytest.raises(RobotError, match="no array of numbers"):
        forward_batch(load_robot("scara"), rows)


def test_a_robot_without_joints_stands_where_it_stands() -> None:
    """One pose for each empty row."""
    still = Robot("still", "", "", Convention.PRODUCT, (), (Link(1, (Trans(ZERO, ZERO, ONE),)),))
    assert forward_batch(still, np.empty((2, 0)))[:, 2, 3].tolist() == [1.0, 1.0]


def test_an_out_of_another_shape_is_refused() -> None:
    """The message names both."""
    with pytest.raises(RobotError, match=r"\(2, 4, 4\) of float64"):
        forward_batch(load_robot("scara"), np.zeros((2, 3)), out=np.zeros((3, 4, 4)))


def test_arguments_that_cannot_be_used_are_refused_in_words() -> None:
    """A list for `out`, an array that nobody may write to, complex numbers, rows of different lengths."""
    robot = load_robot("scara")
    fixed = np.zeros((1, 4, 4))
    fixed.flags.writeable = False
    with pytest.raises(RobotError, match="out is read-only"):
        forward_batch(robot, [[0, 0, 0]], out=fixed)
    with pytest.raises(RobotError, match="out is no numpy array but list"):
        forward_batch(robot, [[0, 0, 0]], out=[1])  # type: ignore[arg-type]
    with pytest.raises(RobotError, match="not \\(1, 4, 4\\) of float64 or float32"):
        forward_batch(robot, [[0, 0, 0]], out=np.zeros((1, 4, 4), dtype=np.int64))
    with pytest.raises(RobotError, match="of >f8, not"):
        forward_batch(robot, [[0, 0, 0]], out=np.zeros((1, 4, 4), dtype=">f8"))
    with pytest.raises(RobotError, match="of float32, not"):
        forward_batch(robot, [[0, 0, 0]], out=np.zeros((1, 4, 4), dtype=np.float32), dtype=float)
    for dtype in (int, "f2", "nonsense", complex):
        with pytest.raises(RobotError, match="float64 or float32"):
            forward_batch(robot, [[0, 0, 0]], dtype=dtype)
    for threads in (0, -1, 1.5, "2", None, True):
        with pytest.raises(RobotError, match="threads is a number from 1"):
            forward_batch(robot, [[0, 0, 0]], threads=threads)  # type: ignore[arg-type]
    with pytest.raises(RobotError, match="Q is no array of numbers"):
        forward_batch(robot, np.array([[None, object(), 0]]))
    with pytest.raises(RobotError, match="complex numbers are given"):
        forward_batch(robot, np.zeros((1, 3), dtype=complex))
    with pytest.raises(RobotError, match=r"Q is no array of numbers .*rows of 3 numbers, all as long"):
        forward_batch(robot, [[0, 0, 0], [1]])
