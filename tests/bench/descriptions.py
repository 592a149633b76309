"""What becomes of URDF files that other packages ship: `python tests/bench/descriptions.py [FOLDER ...]`.

Every serial chain with two moving joints or more, of every URDF in `example-robot-data` or in the folders named: its
poses as dhcli reads it, as its tables of both conventions, and as its export is read by others, against pinocchio; and
how the DH chains of iDynTree and the rules of urdf_to_dh do on the same chains.
`pip install -e '.[peers]'` brings the peers; one that is not installed is left out.
"""

from __future__ import annotations

import math
import os
import random
import sys
import tempfile
import warnings
from collections import Counter
from collections.abc import Iterator
from contextlib import redirect_stderr, redirect_stdout, suppress
from dataclasses import dataclass, field
from importlib.metadata import distribution
from importlib.util import find_spec
from io import StringIO
from itertools import pairwise
from pathlib import Path
from typing import Any

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
sys.path.insert(0, str(Path(__file__).parents[2]))

import numpy as np

from dhcli import DhcliError, Robot
from dhcli.files.urdf.chains import tips_of
from dhcli.files.urdf.model import read_model
from dhcli.files.urdf.robots import read_urdf
from dhcli.files.urdf.writing import urdf_text
from dhcli.kinematics.describe.asked import Asked
from dhcli.kinematics.describe.description import describe
from dhcli.kinematics.describe.drawn import drawing_of, same_direction
from dhcli.kinematics.forward import forward
from dhcli.notation.tree import ONE

Array = np.ndarray[Any, np.dtype[np.float64]]
CLOSE, WRONG = 1e-12, 1e-6
MOST_TIPS = 8
"""Chains of one file: hands have many fingers alike."""


@dataclass
class Tally:
    """What was counted, and the largest differences from pinocchio, in metres and direction cosines."""

    counts: Counter[str] = field(default_factory=Counter)
    worst: dict[str, float] = field(default_factory=dict)

    def take(self, what: str, error: float) -> None:
        """One comparison."""
        self.counts[what] += 1
        self.counts[f"{what} within 1e-12"] += error <= CLOSE
        self.counts[f"{what} wrong"] += not error <= WRONG
        self.worst[what] = max(self.worst.get(what, 0.0), error)


def chains(folders: list[str]) -> Iterator[tuple[Path, str, Robot]]:
    """Each chain of each file, as dhcli reads it with every number as typed."""
    seen = set()
    for path in sorted(path for folder in folders for path in Path(folder).rglob("*.urdf")):
        text = path.read_text("utf-8", errors="replace")
        with suppress(DhcliError):
            for tip in tips_of(read_model(text, path.name))[:MOST_TIPS]:
                with suppress(DhcliError):
                    robot = read_urdf(text, path.name, "arm", tip=tip, as_typed=True)
                    key = (robot.links, robot.variables)
                    if len(robot.variables) > 1 and key not in seen:
                        seen.add(key)
                        yield path, tip, robot


def joint_names(robot: Robot) -> list[str]:
    """The joints of the URDF in the order of the variables; the notes say which is which."""
    lines = [line.partition(" is the joint ") for line in robot.notes.splitlines()]
    known = {variable: joint.removesuffix(".") for variable, _, joint in lines}
    return [known.get(variable, variable) for variable in robot.variables]


def by_pinocchio(model: Any, names: list[str], q: list[float], tip: str) -> Array:  # noqa: ANN401  pinocchio's
    """The pose of a link; all other joints are at zero."""
    import pinocchio

    values = pinocchio.neutral(model)
    for name, value in zip(names, q, strict=True):
        joint = model.joints[model.getJointId(name)]
        turned = [math.cos(value), math.sin(value)] if joint.nq == 2 else [value]
        values[joint.idx_q : joint.idx_q + joint.nq] = turned
    data = model.createData()
    pinocchio.framesForwardKinematics(model, data, values)
    pose: Array = data.oMf[model.getFrameId(tip)].homogeneous
    return pose


def has_antiparallel(robot: Robot) -> bool:
    """Whether an axis is parallel to the next in the opposite sense."""
    lines = drawing_of(robot.chain, robot.variables, {}).lines
    return any(same_direction(one.direction, other.direction) < 0 for one, other in pairwise(lines))


def by_urdf_to_dh(robot: Robot) -> list[tuple[float, float, float, float]]:
    """d, theta, a and alpha of each row by the rules of urdf_to_dh: frames on the joint axes, one after the other.

    An axis counts as parallel to the one before where their cross product is below 1e-5, whatever their senses, and
    has then no twist; where it is the same line, no turn either. Its x axis points towards the next axis, or along the
    cross product with x ≥ 0 where the two meet.
    """
    rows, here = [], np.eye(4)
    for line in drawing_of(robot.chain, robot.variables, {}).lines:
        back = np.linalg.inv(here)
        axis = back[:3, :3] @ np.array(line.direction)
        origin = (back @ [*(line.through or {}).get(ONE, (0.0, 0.0, 0.0)), 1.0])[:3]
        row = _urdf_to_dh_row(origin, axis)
        rows.append(row)
        here = here @ _row(*row)
    return rows


def _urdf_to_dh_row(origin: Array, axis: Array) -> tuple[float, float, float, float]:
    x, y, z = origin
    across = np.array([-axis[1], axis[0], 0.0])
    if np.abs(across).max() < 1e-5:
        return (z, 0.0, 0.0, 0.0) if math.hypot(x, y) < 1e-8 else (z, math.atan2(y, x), math.hypot(x, y), 0.0)
    t = -(x * axis[0] + y * axis[1]) / (axis[0] ** 2 + axis[1] ** 2)
    foot = origin + t * axis
    apart = math.hypot(foot[0], foot[1])
    normal = np.array([foot[0], foot[1], 0.0]) if apart > 1e-6 else across * (-1 if across[0] < 0 else 1)
    normal = normal / np.linalg.norm(normal)
    twist = math.atan2(across @ normal, axis[2])
    return foot[2], math.atan2(normal[1], normal[0]), apart if apart > 1e-6 else 0.0, twist


def _row(d: float, theta: float, a: float, alpha: float) -> Array:
    ct, st, ca, sa = math.cos(theta), math.sin(theta), math.cos(alpha), math.sin(alpha)
    return np.array([[ct, -st * ca, st * sa, a * ct], [st, ct * ca, -ct * sa, a * st], [0, sa, ca, d], [0, 0, 0, 1]])


def moved_by(robot: Robot, rows: list[tuple[float, float, float, float]], q: list[float]) -> Array:
    """The motion of the last link away from zero that a table means: T(q) T(0)^-1, whatever frame is on the link."""
    ends = []
    for values in (q, [0.0] * len(q)):
        pose = np.eye(4)
        for (d, theta, a, alpha), joint, value in zip(
            [*rows[1:], (0.0, 0.0, 0.0, 0.0)], robot.joints, values, strict=True
        ):
            slides = joint.kind == "prismatic"
            pose = pose @ _row(d + value * slides, theta + value * (not slides), a, alpha)
        ends.append(_row(*rows[0]) @ pose)
    moved: Array = ends[0] @ np.linalg.inv(ends[1])
    return moved


def by_idyntree(path: Path, names: list[str], base: str, tip: str, q: list[float]) -> Array | None:
    """The pose by the DH chain that iDynTree extracts; None where it makes none."""
    import idyntree.swig as idyn

    loader = idyn.ModelLoader()
    chain = idyn.DHChain()
    joints = idyn.StringVector(names)
    with redirect_stderr(StringIO()), redirect_stdout(StringIO()):
        if not loader.loadReducedModelFromFile(str(path), joints):
            return None
        if not idyn.ExtractDHChainFromModel(loader.model(), base, tip, chain):
            return None
    order = [names.index(chain.getDOFName(i)) for i in range(chain.getNrOfDOFs())]
    pose = chain.getH0().asHomogeneousTransform().toNumPy()
    for i, k in enumerate(order):
        link = chain(i)
        pose = pose @ _row(link.D, link.Offset + q[k], link.A, link.Alpha)
    end: Array = pose @ chain.getHN().asHomogeneousTransform().toNumPy()
    return end


def compare(path: Path, tip: str, robot: Robot, tally: Tally) -> None:
    """One chain by all that are at hand."""
    import pinocchio

    names = joint_names(robot)
    q = [random.Random(f"{path.name} {tip} {i}").uniform(-1, 1) for i in range(len(names))]  # noqa: S311
    truth = by_pinocchio(pinocchio.buildModelFromUrdf(str(path)), names, q, tip)
    size = max(1.0, float(np.abs(truth[:3, 3]).max()))
    tally.take("read", _gap(forward(robot, q).matrix, truth) / size)
    for form in ("standard", "modified"):
        try:
            found = describe(robot, Asked(form))  # type: ignore[arg-type]
        except DhcliError:
            tally.counts[f"{form} refused"] += 1
            continue
        values = [q[robot.variables.index(name)] for name in found.robot.variables]
        pose = forward(found.robot, values, start="base", end="tool").matrix
        warned = " with a warning" if found.warnings else ""
        tally.take(f"{form} table{warned}", _gap(pose, truth) / size)
    text = urdf_text(robot)
    exported = pinocchio.buildModelFromXML(text)
    tally.take("export, pinocchio", _gap(by_pinocchio(exported, list(robot.variables), q, "tool0"), truth) / size)
    if find_spec("yourdfpy"):
        import yourdfpy

        with tempfile.NamedTemporaryFile("w", suffix=".urdf") as file, warnings.catch_warnings():
            warnings.simplefilter("ignore")
            file.write(text)
            file.flush()
            loaded = yourdfpy.URDF.load(file.name, load_meshes=False)
        loaded.update_cfg(dict(zip(robot.variables, q, strict=True)))
        tally.take("export, yourdfpy", _gap(loaded.get_transform("tool0"), truth) / size)
    still = by_pinocchio(pinocchio.buildModelFromUrdf(str(path)), names, [0.0] * len(q), tip)
    with suppress(DhcliError, np.linalg.LinAlgError):
        found_motion = moved_by(robot, by_urdf_to_dh(robot), q)
        against = ", axes against each other" if has_antiparallel(robot) else ""
        tally.take(f"rules of urdf_to_dh{against}", _gap(found_motion, truth @ np.linalg.inv(still)) / size)
    if find_spec("idyntree"):
        model = read_model(path.read_text("utf-8", errors="replace"), path.name)
        base = next(link for link in model.links if all(joint.child != link for joint in model.joints))
        pose = by_idyntree(path, names, base, tip, q)
        if pose is None:
            tally.counts["iDynTree refused"] += 1
        else:
            tally.take(f"iDynTree{', with slides' * ('P' in robot.pattern)}", _gap(pose, truth) / size)


def _gap(one: Array, other: Array) -> float:
    return float(np.abs(np.asarray(one) - other).max())


def main(folders: list[str]) -> None:
    """Print a line for each way."""
    if not folders:
        shipped = distribution("example-robot-data").files or ()
        folders = sorted({str(Path(str(file.locate())).parent) for file in shipped if file.suffix == ".urdf"})
    tally, files = Tally(), set()
    for path, tip, robot in chains(folders):
        files.add(path)
        try:
            compare(path, tip, robot, tally)
        except (ValueError, RuntimeError) as error:
            tally.counts[f"not read by a peer: {str(error)[:60]}"] += 1
    print(f"{len(files)} files, {tally.counts['read']} chains")
    print(f"{'':50}{'all':>5} {'1e-12':>5} {'wrong':>5}   worst")
    for what, worst in tally.worst.items():
        count = tally.counts
        print(f"{what:50}{count[what]:5} {count[f'{what} within 1e-12']:5} {count[f'{what} wrong']:5}   {worst:.1e}")
    for what, number in tally.counts.items():
        if what.endswith("refused") or what.startswith("not read"):
            print(f"{what:50}{number:5}")


if __name__ == "__main__":
    main(sys.argv[1:])
