"""A robot that is given as products, on terminals of several widths."""

from __future__ import annotations

import re

import pytest

from dhcli import load_robot
from dhcli.render.look import Look
from dhcli.render.paper import Paper
from dhcli.render.text.robot import links_table

DATA = "tests/data/urdf/three-joints.urdf"


@pytest.mark.parametrize("width", [60, 80, 120])
def test_products_are_folded_between_their_moves_to_fit_a_terminal(width: int) -> None:
    """No line is wider, none begins or ends within a move, and together they are the product."""
    robot = load_robot(DATA, tip="tool0")
    lines = links_table(robot, Look(paper=Paper(width=width, terminal=True))).splitlines()
    assert all(len(line) <= width for line in lines)
    told = [re.sub(r"^ \d |\b(revolute|prismatic)$", "", line).strip() for line in lines[2:-1]]
    assert " ".join(told) == " ".join(link.product for link in robot.links)


def test_what_is_piped_is_not_folded() -> None:
    """A line for each link."""
    robot = load_robot(DATA, tip="tool0")
    lines = links_table(robot, Look(paper=Paper(width=60))).splitlines()
    assert len(lines) == 2 + len(robot.links) + 1
