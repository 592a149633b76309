"""The C function of a derivation, compiled: it fills in what the formulas say."""

from __future__ import annotations

import ctypes
import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest

from dhcli.files.yaml.robots import load_robot
from dhcli.kinematics.forward import forward
from dhcli.kinematics.inverse.asked import inverse
from dhcli.kinematics.inverse.derive import derive
from dhcli.render.code.derivation import lengths_used
from dhcli.render.code.derivation_c import derivation_c
from dhcli.render.look import Look

COMPILER = shutil.which("cc")


def text(name: str) -> str:
    """The C file of a robot."""
    return derivation_c(derive(load_robot(name)), Look("c"))


def test_the_function_says_what_it_takes_and_gives() -> None:
    """The pose, the lengths, and room for as many rows as there may be."""
    code = text("planar-2r")
    assert "int inverse(const double T[4][4], double a1, double a2, double solutions[][2])" in code
    assert "at most 2" in code
    assert "^" not in code.partition("int inverse")[2]
    assert "(2.0*a1*a2)" in code


@pytest.mark.skipif(COMPILER is None, reason="there is no C compiler here")
@pytest.mark.parametrize("name", ["planar-2r", "cylindrical", "puma560"])
def test_the_compiled_function_returns_every_solution(name: str, tmp_path: Path) -> None:
    """Each of them is one that `inverse` finds, and none is missing."""
    source, library = tmp_path / "inverse.c", tmp_path / "inverse.so"
    source.write_text(text(name), "utf-8")
    command = [
        str(COMPILER),
        "-std=c99",
        "-Wall",
        "-Werror",
        "-shared",
        "-fPIC",
        "-o",
        str(library),
        str(source),
        "-lm",
    ]
    subprocess.run(command, check=True)
    robot, derivation = load_robot(name), derive(load_robot(name))
    q = [0.4, 0.7, 0.5, -0.6, 0.8, 1.1][: len(robot.variables)]
    pose = forward(robot, q)
    rows = np.zeros((derivation.branches, len(robot.variables)))
    lengths = [ctypes.c_double(float(robot.parameters[length].value)) for length in lengths_used(derivation)]  # type: ignore[union-attr]
    pointer = ctypes.POINTER(ctypes.c_double)
    matrix = np.ascontiguousarray(pose.matrix)
    count = ctypes.CDLL(str(library)).inverse(matrix.ctypes.data_as(pointer), *lengths, rows.ctypes.data_as(pointer))
    found = inverse(robot, pose, task="position" if derivation.place_only else "pose")
    assert count == len(found)
    for row in rows[:count]:
        assert found.distances(row).min() < 1e-9
