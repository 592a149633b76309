"""Arrays of other libraries: they come back as such, say what numpy's say, and are traced and differentiated."""

from __future__ import annotations

import sys
from importlib import import_module
from types import ModuleType
from typing import Any

import numpy as np
import pytest

from dhcli import forward_batch, inverse, inverse_batch, jacobian, load_robot
from dhcli.algebra.arrays import library_of
from dhcli.errors import RobotError
from dhcli.kinematics.conventions import Convention
from dhcli.kinematics.moves import Trans
from dhcli.kinematics.robot import Link, Robot
from dhcli.notation.tree import ONE, ZERO
from tests.row_by_row import row_by_row

ROBOTS = ("scara", "puma560", "stanford")

pytest.importorskip("array_api_compat")


@pytest.fixture(params=["array_api_strict", "jax.numpy", "torch"])
def xp(request: pytest.FixtureRequest) -> ModuleType:
    """Each library that is installed, in double precision."""
    found: ModuleType = pytest.importorskip(request.param)
    if request.param == "jax.numpy":
        import_module("jax").config.update("jax_enable_x64", val=True)
    return found


def rows(name: str, count: int = 5) -> np.ndarray:
    """Joint values, angles beyond a turn among them."""
    joints = len(load_robot(name).variables)
    return np.random.default_rng(1).uniform(-9, 9, (count, joints))


@pytest.mark.parametrize("name", ROBOTS)
def test_poses_come_back_as_what_was_given(name: str, xp: ModuleType) -> None:
    """Of any leading axes, none of them too; other frames and lengths; no row is a row too few."""
    robot, q = load_robot(name), rows(name, 6)
    given = xp.asarray(q)
    for start, end in ((None, None), ("tool", "base")):
        wanted = forward_batch(robot, q, start=start, end=end)
        found = forward_batch(robot, given, start=start, end=end)
        assert type(found) is type(given)
        assert found.dtype == given.dtype
        assert np.abs(np.asarray(found) - wanted).max() <= 1e-14
        cube = forward_batch(robot, xp.reshape(given, (2, 3, -1)), start=start, end=end)
        assert np.abs(np.asarray(cube).reshape(6, 4, 4) - wanted).max() <= 1e-14
        assert np.abs(np.asarray(forward_batch(robot, given[0, ...], start=start, end=end)) - wanted[0]).max() <= 1e-14
    assert forward_batch(robot, given[:0, :]).shape == (0, 4, 4)


@row_by_row("name", ROBOTS)
@row_by_row("analytic", ["", "rpy", "zyz"])
def test_jacobians_come_back_as_what_was_given(name: str, analytic: str, xp: ModuleType) -> None:
    """NaN where there are no rates, or no values."""
    robot, q = load_robot(name), rows(name)
    q[2, 0] = np.nan
    found = jacobian(robot, xp.asarray(q), analytic=analytic)
    assert type(found) is type(xp.asarray(q))
    assert np.asarray(found) == pytest.approx(jacobian(robot, q, analytic=analytic), abs=1e-11, nan_ok=True)


def test_single_precision_stays_single(xp: ModuleType) -> None:
    """Constants of a robot do not make it double."""
    given = xp.asarray(rows("puma560"), dtype=xp.float32)
    assert forward_batch(load_robot("puma560"), given).dtype == xp.float32
    assert jacobian(load_robot("puma560"), given).dtype == xp.float32


def test_what_cannot_be_played_is_refused_in_words(xp: ModuleType) -> None:
    """Another width, whole and complex numbers, and what is for numpy's arrays alone."""
    robot = load_robot("scara")
    fine = xp.asarray(rows("scara"))
    for given, said in (
        (xp.asarray(rows("puma560")), r"scara has 3 joints; Q has the shape \(5, 6\), not \(\.\.\., 3\)"),
        (xp.asarray(1.0), r"the shape \(\)"),
        (xp.asarray([[1, 2, 3]]), "Q holds numbers of .*int.*, not floats"),
        (xp.asarray(rows("scara") + 0j), "complex.*, not floats"),
    ):
        with pytest.raises(RobotError, match=said):
            forward_batch(robot, given)
    for only in ({"out": np.zeros((5, 4, 4))}, {"dtype": "float32"}, {"threads": 2}):
        with pytest.raises(RobotError, match=f"{next(iter(only))} are for arrays of numpy"):
            forward_batch(robot, fine, **only)  # type: ignore[arg-type]
    with pytest.raises(RobotError, match="threads are for arrays of numpy"):
        jacobian(robot, fine, threads=2)


def test_without_the_extra_it_is_named(xp: ModuleType, monkeypatch: pytest.MonkeyPatch) -> None:
    """And the way without it, which works."""
    monkeypatch.setitem(sys.modules, "array_api_compat", None)
    given = xp.asarray(rows("scara"))
    with pytest.raises(RobotError, match=r"arrays of \w+ need array-api-compat.*dhcli\[arrays\].*numpy.asarray\(Q\)"):
        forward_batch(load_robot("scara"), given)
    assert forward_batch(load_robot("scara"), np.asarray(given)).shape == (5, 4, 4)


def test_a_robot_without_joints_stands_where_it_stands(xp: ModuleType) -> None:
    """One pose for each empty row."""
    still = Robot("still", "", "", Convention.PRODUCT, (), (Link(1, (Trans(ZERO, ZERO, ONE),)),))
    assert np.asarray(forward_batch(still, xp.zeros((2, 0), dtype=xp.float64)))[:, 2, 3].tolist() == [1.0, 1.0]


def test_numpy_and_lists_are_no_other_library() -> None:
    """Nor is what only looks like an array."""
    assert {library_of(given) for given in (np.zeros(3), np.float64(1), [[1.0]], (1,), "0.1", None, object())} == {""}


@pytest.mark.parametrize("name", ROBOTS)
def test_jax_traces_compiles_maps_and_differentiates(name: str) -> None:
    """`jit`, `vmap`, forward and backward derivatives: those of the position are the Jacobian."""
    jax: Any = pytest.importorskip("jax")
    jax.config.update("jax_enable_x64", val=True)
    robot, q = load_robot(name), rows(name)
    given, wanted = jax.numpy.asarray(q), forward_batch(robot, q)
    assert np.abs(jax.jit(lambda rows: forward_batch(robot, rows))(given) - wanted).max() <= 1e-14
    assert np.abs(jax.vmap(lambda row: forward_batch(robot, row))(given) - wanted).max() <= 1e-14

    def position(row: Any) -> Any:  # noqa: ANN401
        return forward_batch(robot, row)[:3, 3]

    columns = jacobian(robot, q, part="linear")
    for derivative in (jax.jacfwd, jax.jacrev):
        assert np.abs(jax.jit(jax.vmap(derivative(position)))(given) - columns).max() <= 1e-13
    assert np.abs(jax.jit(lambda rows: jacobian(robot, rows, part="linear"))(given) - columns).max() <= 1e-13
    slope = jax.grad(lambda row: jacobian(robot, row)[0, 0])(given[0])
    step = 1e-6 * np.eye(q.shape[1])
    differences = (jacobian(robot, q[0] + step) - jacobian(robot, q[0] - step))[:, 0, 0] / 2e-6
    assert np.asarray(slope) == pytest.approx(differences, abs=1e-8)
    assert np.isfinite(jax.vmap(jax.jacfwd(position))(jax.numpy.full_like(given, np.pi))).all()


@pytest.mark.filterwarnings("ignore::FutureWarning")  # of torch about itself
@pytest.mark.parametrize("name", ROBOTS)
def test_torch_differentiates_and_maps(name: str) -> None:
    """Autograd, and torch.func: the derivatives of the position are the Jacobian."""
    torch: Any = pytest.importorskip("torch")
    robot, q = load_robot(name), rows(name)
    columns = jacobian(robot, q, part="linear")
    leaf = torch.tensor(q, requires_grad=True)
    for k in range(3):
        (slope,) = torch.autograd.grad(forward_batch(robot, leaf)[:, k, 3].sum(), leaf)  # type: ignore[attr-defined]
        assert np.abs(slope.numpy() - columns[:, k, :]).max() <= 1e-13
    mapped = torch.func.vmap(torch.func.jacfwd(lambda row: forward_batch(robot, row)[:3, 3]))(torch.tensor(q))
    assert np.abs(mapped.numpy() - columns).max() <= 1e-13


@pytest.mark.parametrize("raised", [RuntimeError("no numbers while there is a gradient"), TypeError("it is traced")])
def test_an_array_that_keeps_its_numbers_to_itself_is_told(raised: Exception) -> None:
    """A tensor of PyTorch that wants a gradient, an array that JAX traces: inverse kinematics looks at numbers."""

    class Tensor:
        """As much of one as numpy asks for."""

        def __array_namespace__(self) -> None:
            """What tells that it is one."""

        def __array__(self, *_: object, **__: object) -> np.ndarray:
            """Refuse."""
            raise raised

    Tensor.__module__ = "torch._tensor"
    for ask in (inverse, inverse_batch):
        with pytest.raises(RobotError, match=f"an array of torch does not give its numbers: {raised}"):
            ask(load_robot("scara"), Tensor())  # type: ignore[operator]
