"""Jacobians as books print them, to the letter, and with no more operations than there."""

from __future__ import annotations

import pytest

from dhcli import load_robot, symbolic_jacobian
from dhcli.kinematics.velocity.jacobian import Jacobian
from dhcli.kinematics.velocity.view import Viewing
from dhcli.notation.tree import Expr
from dhcli.notation.walk import operations

BOOKS: list[tuple[str, Viewing, int, list[str]]] = [
    ("planar-2r", {}, 2, ["-a1*s1 - a2*s12, -a2*s12", "a1*c1 + a2*c12, a2*c12", "0, 0"]),
    ("planar-2r", {"axes": 2}, 2, ["a1*s2, 0", "a1*c2 + a2, a2", "0, 0"]),
    ("scara", {}, 3, ["-l2*c1 - l3*c12, -l3*c12, 0", "-l2*s1 - l3*s12, -l3*s12, 0", "0, 0, -1"]),
    (
        "articulated",
        {},
        3,
        [
            "-s1*(a2*c2 + a3*c23), -c1*(a2*s2 + a3*s23), -a3*c1*s23",
            "c1*(a2*c2 + a3*c23), -s1*(a2*s2 + a3*s23), -a3*s1*s23",
            "0, a2*c2 + a3*c23, a3*c23",
        ],
    ),
    ("cylindrical", {}, 3, ["-d3*c1, 0, -s1", "-d3*s1, 0, c1", "0, 1, 0"]),
    (
        "stanford",
        {"end": 5},
        3,
        ["-d3*s1*s2 - d2*c1, d3*c1*c2, c1*s2", "d3*c1*s2 - d2*s1, d3*s1*c2, s1*s2", "0, -d3*s2, c2"],
    ),
    (
        "puma560",
        {"end": 4, "axes": 3},
        3,
        ["-d3*c23, a2*s3 - d4, -d4", "d3*s23, a2*c3 + a3, a3", "a2*c2 + a3*c23 - d4*s23, 0, 0"],
    ),
]


def operations_of(found: Jacobian[Expr]) -> int:
    """Binary operations of all entries."""
    return sum(operations(entry) for row in found.rows for entry in row)


@pytest.mark.parametrize(("name", "viewing", "columns", "rows"), BOOKS)
def test_the_linear_rows_are_those_of_the_books(name: str, viewing: Viewing, columns: int, rows: list[str]) -> None:
    """Every entry, to the letter; joints further out do not move the point."""
    found = symbolic_jacobian(load_robot(name), part="linear", **viewing)
    cells = found.cells()
    assert [", ".join(row[:columns]) for row in cells] == rows
    assert all(cell == "0" for row in cells for cell in row[columns:])


@pytest.mark.parametrize(
    ("name", "viewing", "most"),
    [
        ("stanford", {}, 129),
        ("ur5e", {}, 111),
        ("panda", {}, 809),
        ("puma560", {}, 75),
        ("puma560", {"axes": 3}, 13),
    ],
)
def test_a_jacobian_has_no_more_operations_than_it_needs(name: str, viewing: Viewing, most: int) -> None:
    """All six rows; those of v alone take 98, 100 and 673 for the first three."""
    found = symbolic_jacobian(load_robot(name), **viewing)
    assert operations_of(found) <= most
    linear = {"stanford": 98, "ur5e": 100, "panda": 673}
    if name in linear:
        assert operations_of(symbolic_jacobian(load_robot(name), part="linear", **viewing)) <= linear[name]


def test_angular_columns_are_the_axes() -> None:
    """Of PUMA 560: z0, then two parallel ones, and nothing for a slide of the Stanford arm."""
    puma = symbolic_jacobian(load_robot("puma560"), part="angular")
    assert [row[0] for row in puma.cells()] == ["0", "0", "1"]
    assert [row[1] for row in puma.cells()] == [row[2] for row in puma.cells()] == ["-s1", "c1", "0"]
    stanford = symbolic_jacobian(load_robot("stanford"), part="angular")
    assert [row[2] for row in stanford.cells()] == ["0", "0", "0"]


def test_rates_of_rpy_are_written_with_the_angles_themselves() -> None:
    """B⁻¹ ω: singular at cos(pitch) = 0."""
    found = symbolic_jacobian(load_robot("planar-2r"), analytic="rpy")
    assert found.labels == ("v_x", "v_y", "v_z", "roll'", "pitch'", "yaw'")
    assert [row[0] for row in found.cells()[3:]] == ["0", "0", "1"]
    arm = symbolic_jacobian(load_robot("articulated"), part="angular", analytic="rpy")
    assert arm.cells()[0][1] == "sin(theta1-yaw)/cos(pitch)"


def test_the_space_jacobian_of_a_planar_arm_has_the_axes_as_columns() -> None:
    """(ω, -ω × q) of Lynch and Park: the second axis stands at (a1*c1, a1*s1)."""
    found = symbolic_jacobian(load_robot("planar-2r"), place=0, angular_first=True)
    assert found.labels[:3] == ("ω_x", "ω_y", "ω_z")
    assert [", ".join(row) for row in found.cells()] == ["0, 0", "0, 0", "1, 1", "0, a1*s1", "0, -a1*c1", "0, 0"]


def test_the_body_jacobian_of_a_planar_arm_has_no_first_angle() -> None:
    """It is seen from the end."""
    found = symbolic_jacobian(load_robot("planar-2r"), axes=2, angular_first=True)
    assert [", ".join(row) for row in found.cells()[3:]] == ["a1*s2, 0", "a1*c2 + a2, a2", "0, 0"]


def test_values_are_put_in_exactly_and_every_joint_keeps_its_column() -> None:
    """A joint at 0 still moves."""
    found = symbolic_jacobian(load_robot("planar-2r"), "theta2=0", parameters={"a2": "0.3 m"})
    assert [", ".join(row) for row in found.cells()[:2]] == ["-s1*(a1 + 0.3), -0.3*s1", "c1*(a1 + 0.3), 0.3*c1"]


def test_a_point_may_have_letters() -> None:
    """The tool tip of a planar arm."""
    found = symbolic_jacobian(load_robot("planar-2r"), point=("e", 0, 0), part="linear")
    assert found.cells()[0] == ("-a1*s1 - s12*(a2 + e)", "-s12*(a2 + e)")
