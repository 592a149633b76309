"""`units: mm` for a file of bare numbers, and the fifth column of a calibrated table."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from dhcli import Robot, forward, inverse, jacobian, load_robot
from dhcli.errors import FileError

MILLIMETRES = """\
format: 1
title: In millimetres
source: made for the tests
units: mm
convention: standard
variables: [theta1, d2]
parameters: {l: 300, k: 2*l + 10, r: 0.5 m}
links:
  - {a: 400, alpha: 90°, d: l + 50, theta: theta1}
  - {a: 0, alpha: 0, d: d2 + 25, theta: 0}
tool: Trans(0, 0, 100) Trans(0, k, r) [1 0 0 7; 0 1 0 0; 0 0 1 0; 0 0 0 1]
limits: {d2: [0, 250]}
poses: {out: [30°, 100]}
actuators: {motors: {m2: [0, 120]}, d2: 2*m2 + 20}
"""
CALIBRATED = """\
format: 1
title: Calibrated
source: made for the tests
convention: {convention}
variables: [theta1, theta2, theta3]
parameters: {{d1: 0.4, a2: 0.5, b2: 0.13°}}
links:
  - {{a: 0, alpha: 89.95°, d: d1, theta: theta1 + 0.02°}}
  - {{a: a2, alpha: 0.11°, d: 0, theta: theta2, beta: b2}}
  - {{a: 0.3, alpha: 0, d: 0, theta: theta3, beta: -0.2°}}
"""


def loaded(text: str, folder: Path) -> Robot:
    """A robot from the text of a file."""
    path = folder / "x.yaml"
    path.write_text(text, "utf-8")
    return load_robot(path)


def test_a_file_in_millimetres_is_the_one_with_its_units_written_out(tmp_path: Path) -> None:
    """Cells, parameters and what follows from them, moves, limits, poses, motors; what has a unit keeps it."""
    written = MILLIMETRES.replace("units: mm\n", "")
    for bare in ("300", "400", "50,", "25,", "100)", "250", "100]", "120", "20}", "2*l + 10", "0 0 7"):
        number = bare.rstrip(",)]}")
        assert written.count(bare) == 1
        with_unit = "310 mm + l" if number == "2*l + 10" else f"{number} mm"
        written = written.replace(bare, bare.replace(number, with_unit))
    written = written.replace("k: 310 mm + l", "k: 0.61 m").replace("[1 0 0 0 0 7 mm;", "[1 0 0 0.007;")
    one, other = loaded(MILLIMETRES, tmp_path), loaded(written, tmp_path)
    assert np.asarray(forward(one, "out", end="tool")) == pytest.approx(np.asarray(forward(other, "out", end="tool")))
    assert (one.limits, one.poses, one.actuators) == (other.limits, other.poses, other.actuators)
    assert one.links == other.links


def test_bare_numbers_of_other_files_are_metres_as_ever(tmp_path: Path) -> None:
    """And an unknown unit is told with those there are."""
    bare = loaded(MILLIMETRES.replace("units: mm\n", ""), tmp_path)
    assert str(bare.parameters["l"]) == "300"
    with pytest.raises(FileError, match=r"units: 'inch' is not known") as caught:
        loaded(MILLIMETRES.replace("units: mm", "units: inch"), tmp_path)
    assert "in" in caught.value.problems[0].hint


@pytest.mark.parametrize("convention", ["standard", "modified"])
def test_a_calibrated_row_turns_about_y_besides(tmp_path: Path, convention: str) -> None:
    """Behind a row of the standard convention, in front of one of the modified.

    Source: Hayati and Mirmirani 1985; Khalil and Dombre, Modeling, Identification and Control of Robots, chapter 11.
    """
    arm = loaded(CALIBRATED.format(convention=convention), tmp_path)
    q = np.array([0.3, -0.4, 0.9])
    rows = [(0, 89.95, 0.4, q[0] + np.radians(0.02), 0), (0.5, 0.11, 0, q[1], 0.13), (0.3, 0, 0, q[2], -0.2)]
    pose = np.eye(4)
    for a, alpha, d, theta, beta in rows:
        z, x = turn(2, theta) @ shift(2, d), shift(0, a) @ turn(0, np.radians(alpha))
        y = turn(1, np.radians(beta))
        pose = pose @ (z @ x @ y if convention == "standard" else y @ x @ z)
    assert np.asarray(forward(arm, list(q))) == pytest.approx(pose, abs=1e-14)
    assert len(inverse(arm, pose)) == 1
    assert inverse(arm, pose)[0] == pytest.approx(q)
    step = 1e-6 * np.eye(3)
    rates = [
        (np.asarray(forward(arm, list(q + s)))[:3, 3] - np.asarray(forward(arm, list(q - s)))[:3, 3]) / 2e-6
        for s in step
    ]
    assert jacobian(arm, list(q), part="linear") == pytest.approx(np.array(rates).T, abs=1e-8)


def turn(axis: int, angle: float) -> np.ndarray:
    """A rotation about x, y or z."""
    i, j = (axis + 1) % 3, (axis + 2) % 3
    pose = np.eye(4)
    pose[i, i] = pose[j, j] = np.cos(angle)
    pose[j, i], pose[i, j] = np.sin(angle), -np.sin(angle)
    return pose


def shift(axis: int, by: float) -> np.ndarray:
    """A translation along x, y or z."""
    pose = np.eye(4)
    pose[axis, 3] = by
    return pose
