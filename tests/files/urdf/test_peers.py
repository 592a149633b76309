"""URDF as other programs read it, where they are installed: `pip install -e '.[peers]'`."""

from __future__ import annotations

import math
import random
from importlib.metadata import PackageNotFoundError, files
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest

from dhcli.errors import DhcliError
from dhcli.files.urdf.chains import tips_of
from dhcli.files.urdf.model import read_model
from dhcli.files.urdf.robots import read_urdf
from dhcli.files.urdf.writing import urdf_text
from dhcli.files.yaml.robots import load_robot
from dhcli.kinematics.describe.asked import Asked
from dhcli.kinematics.describe.description import describe
from dhcli.kinematics.forward import forward
from dhcli.kinematics.robot import Robot
from tests.files.urdf.test_urdf import EXPORTED
from tests.nightly import some

if TYPE_CHECKING:
    from numpy.typing import NDArray

MISSING = "is not installed: pip install -e '.[peers]'"
CLOSE = 1e-12


def drawn(robot: Robot) -> list[float]:
    """Joint values, the same every time."""
    draw = random.Random(robot.name)  # noqa: S311
    return [draw.uniform(-1, 1) for _ in robot.variables]


def by_pinocchio(pinocchio: Any, model: Any, q: dict[str, float], tip: str) -> NDArray[np.float64]:  # noqa: ANN401
    """The pose of a link; joints that are not named are at zero."""
    values = pinocchio.neutral(model)
    for name, value in q.items():
        joint = model.joints[model.getJointId(name)]
        turned = [math.cos(value), math.sin(value)] if joint.nq == 2 else [value]
        values[joint.idx_q : joint.idx_q + joint.nq] = turned
    found = model.createData()
    pinocchio.framesForwardKinematics(model, found, values)
    pose: NDArray[np.float64] = found.oMf[model.getFrameId(tip)].homogeneous
    return pose


@pytest.mark.parametrize("name", EXPORTED)
def test_pinocchio_reads_what_is_written(name: str) -> None:
    """The same pose to 1e-12."""
    pinocchio = pytest.importorskip("pinocchio", reason=f"pinocchio {MISSING}")
    robot = load_robot(name)
    q = drawn(robot)
    model = pinocchio.buildModelFromXML(urdf_text(robot))
    pose = by_pinocchio(pinocchio, model, dict(zip(robot.variables, q, strict=True)), "tool0")
    assert np.abs(pose - forward(robot, q, start="base", end="tool").matrix).max() < CLOSE


@pytest.mark.filterwarnings("ignore")  # of its own dependencies
@pytest.mark.parametrize("name", EXPORTED)
def test_yourdfpy_reads_what_is_written(name: str, tmp_path: Path) -> None:
    """The same pose to 1e-12, and it finds nothing to complain of."""
    yourdfpy = pytest.importorskip("yourdfpy", reason=f"yourdfpy {MISSING}")
    robot = load_robot(name)
    q = drawn(robot)
    path = tmp_path / "x.urdf"
    path.write_text(urdf_text(robot), "utf-8")
    loaded = yourdfpy.URDF.load(str(path), load_meshes=False)
    assert loaded.validate()
    loaded.update_cfg(dict(zip(robot.variables, q, strict=True)))
    assert np.abs(loaded.get_transform("tool0") - forward(robot, q, start="base", end="tool").matrix).max() < CLOSE


def shipped() -> list[Path]:
    """The URDF files of example-robot-data, but for one that is empty; none where it is not installed."""
    try:
        found = files("example-robot-data") or ()
    except PackageNotFoundError:
        return []
    paths = (Path(str(file.locate())) for file in found if file.suffix == ".urdf")
    return sorted(path for path in paths if "<link" in path.read_text("utf-8"))


SHIPPED = shipped()


@pytest.mark.parametrize("path", some(SHIPPED, 8) if SHIPPED else [], ids=lambda path: f"{path.parts[-3]}-{path.stem}")
def test_a_chain_that_others_ship_moves_as_pinocchio_says(path: Path) -> None:
    """As it is read to 1e-12 of the reach; its tables too, wherever there is no warning."""
    pinocchio = pytest.importorskip("pinocchio", reason=f"pinocchio {MISSING}")
    text = path.read_text("utf-8")
    model = pinocchio.buildModelFromUrdf(str(path))
    for tip in tips_of(read_model(text, path.name))[:4]:
        try:
            robot = read_urdf(text, path.name, "arm", tip=tip, as_typed=True)
        except DhcliError as error:
            assert "follows" in str(error) or "no joint of one variable" in str(error)
            continue
        q = drawn(robot)
        given = {robot.called.get(name, name): value for name, value in zip(robot.variables, q, strict=True)}
        truth = by_pinocchio(pinocchio, model, given, tip)
        reach = max(1.0, np.abs(truth[:3, 3]).max())
        assert np.abs(forward(robot, q).matrix - truth).max() <= CLOSE * reach
        for form in ("standard", "modified"):
            found = describe(robot, Asked(form))  # type: ignore[arg-type]
            values = [q[robot.variables.index(name)] for name in found.robot.variables]
            pose = forward(found.robot, values, start="base", end="tool").matrix
            assert found.warnings or np.abs(pose - truth).max() <= CLOSE * reach


def test_there_are_files_to_read_where_the_peers_are_installed() -> None:
    """Were none found, the test above could not fail."""
    if not SHIPPED:
        pytest.skip(f"example-robot-data {MISSING}")
    assert len(SHIPPED) > 20
