"""Robots that try what a figure can bear, and the library."""

from __future__ import annotations

from dhcli.files.library.entries import Kind, entries
from dhcli.files.yaml.linkages import load_linkage
from dhcli.files.yaml.robots import load_robot, read_robot
from dhcli.kinematics.robot import Robot
from dhcli.mobility.linkage import Linkage

ROBOTS = tuple(entry.name for entry in entries(Kind.ROBOTS))
LINKAGES = tuple(entry.name for entry in entries(Kind.LINKAGES) if isinstance(load_linkage(entry.name), Linkage))


def robot_of(rows: list[str], variables: list[str], *, convention: str = "standard", more: str = "") -> Robot:
    """A robot from the lines of its table."""
    links = "\n".join(f"  - {row}" for row in rows)
    text = (
        f"format: 1\ntitle: Tried\nsource: made for a test\nconvention: {convention}\n"
        f"variables: [{', '.join(variables)}]\n{more}\nlinks:\n{links}\n"
    )
    return read_robot(text, "tried.yaml", "tried")


def long_robot(count: int) -> Robot:
    """So many joints in a row, each across the one before."""
    rows = [f"{{a: 0.1, alpha: {90 if i % 2 else -90}°, d: 0.05, theta: theta{i}}}" for i in range(1, count + 1)]
    return robot_of(rows, [f"theta{i}" for i in range(1, count + 1)])


def odd_robots() -> dict[str, Robot]:
    """No length at all, lengths without values, no joint, a dozen joints, very short beside very long."""
    return {
        "all zero": robot_of(
            ["{a: 0, alpha: 90°, d: 0, theta: theta1}", "{a: 0, alpha: 0, d: 0, theta: theta2}"], ["theta1", "theta2"]
        ),
        "no values": load_robot("dh-link"),
        "no joint": robot_of(["{a: 0.3, alpha: 0, d: 0.2, theta: 0}"], []),
        "twelve": long_robot(12),
        "far apart": robot_of(
            [
                "{a: 0.000001, alpha: 90°, d: 1000000, theta: theta1}",
                "{a: 1000000, alpha: 0, d: 0.000001, theta: theta2}",
                "{a: 0, alpha: 0, d: d3, theta: 0}",
            ],
            ["theta1", "theta2", "d3"],
        ),
        "tiny": robot_of(
            ["{a: 0.000001, alpha: 0, d: 0, theta: theta1}", "{a: 0.000002, alpha: 0, d: 0, theta: theta2}"],
            ["theta1", "theta2"],
        ),
    }
