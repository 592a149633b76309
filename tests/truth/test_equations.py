"""Every matrix, chain, point and inverse of the four documents, recomputed and found equal, exactly."""

from __future__ import annotations

from functools import cache

import pytest

from dhcli.algebra.equality import equal
from dhcli.algebra.floats import Floats
from dhcli.algebra.terms import TERMS
from dhcli.files.library.entries import Kind
from dhcli.files.library.lookup import find
from dhcli.files.yaml.robots import load_robot
from dhcli.kinematics.conventions import Convention
from dhcli.kinematics.fold import fold
from dhcli.kinematics.forward import forward, symbolic
from dhcli.kinematics.moves import read_chain
from dhcli.kinematics.pose import Pose
from dhcli.kinematics.robot import Robot
from dhcli.notation.angle import Angle
from dhcli.notation.parser import parse
from dhcli.notation.quantity import to_angle
from dhcli.notation.tree import Expr, number
from dhcli.notation.walk import substitute
from tests.nightly import in_turn
from tests.row_by_row import row_by_row
from tests.truth.items import EQUATIONS, TRUTH, Matrix, angle, chain, computed, computed_over, matrix, read, typed

IN_FILES = {
    # 000 Yim
    "Y13": ("planar-2r", "0", "1"),
    "Y14": ("planar-2r", "1", "2"),
    "Y15": ("planar-2r", "0", "2"),
    "Y20": ("dh-link", "0", "1"),
    "Y28": ("cylindrical", "0", "1"),
    "Y29": ("cylindrical", "1", "2"),
    "Y30": ("cylindrical", "2", "3"),
    "Y31": ("cylindrical", "0", "3"),
    "Y33": ("spherical-wrist", "3", "4"),
    "Y34": ("spherical-wrist", "4", "5"),
    "Y35": ("spherical-wrist", "5", "6"),
    "Y36": ("spherical-wrist", "3", "6"),
    "Y38": ("cylindrical-wrist", "0", "6"),
    "Y40": ("stanford", "0", "1"),
    "Y41": ("stanford", "1", "2"),
    "Y42": ("stanford", "2", "3"),
    "Y43": ("stanford", "0", "3"),
    "Y44": ("stanford", "3", "6"),
    "Y45": ("stanford", "0", "6"),
    "Y46a": ("cartesian", "0", "3"),
    "Y46b": ("articulated", "0", "3"),
    "Y49": ("scara-yim", "0", "1"),
    "Y50": ("scara-yim", "1", "2"),
    "Y51": ("scara-yim", "2", "3"),
    "Y52": ("scara-yim", "3", "4"),
    "Y53": ("scara-yim", "0", "4"),
    # 002 Bajd
    "B27": ("assembly-blocks", "0", "1"),
    "B28": ("assembly-blocks", "1", "2"),
    "B29": ("assembly-blocks", "2", "3"),
    "B30": ("assembly-blocks", "0", "3"),
    "B30b": ("assembly-blocks", "0", "2"),
    "B34": ("scara", "0", "1"),
    "B35": ("scara", "1", "2"),
    "B36": ("scara", "2", "3"),
    "B37": ("scara", "0", "3"),
    "B39": ("scara-standard", "0", "3"),
    # 003 Zhou
    "Z05": ("dh-link", "0", "1"),
    "Z10": ("dh-link", "1", "0"),
    "Z15": ("dh-link", "0", "1"),
    "Z16": ("zhou-3r", "0", "1"),
    "Z17": ("zhou-3r", "1", "2"),
    "Z18": ("zhou-3r", "2", "3"),
    "Z19": ("zhou-3r", "0", "3"),
    "Z23": ("scara-zhou", "0", "1"),
    "Z24": ("scara-zhou", "1", "2"),
    "Z25": ("scara-zhou", "2", "3"),
    "Z26": ("scara-zhou", "3", "4"),
    "Z27": ("scara-zhou", "0", "4"),
    "Z29": ("dh-link", "0", "1"),
    "Z30": ("zhou-6r", "0", "1"),
    "Z31": ("zhou-6r", "1", "2"),
    "Z32": ("zhou-6r", "2", "3"),
    "Z33": ("zhou-6r", "3", "4"),
    "Z34": ("zhou-6r", "4", "5"),
    "Z35": ("zhou-6r", "5", "6"),
    "Z36": ("zhou-6r", "6", "tool"),
    "Z37": ("zhou-6r", "0", "3"),
    "Z38": ("zhou-6r", "3", "6"),
    "Z39": ("zhou-6r", "0", "6"),
    "Z40": ("zhou-6r", "0", "tool"),
    "Z46": ("dh-link-modified", "0", "1"),
    "Z48a": ("zhou-3r-modified", "0", "1"),
    "Z48b": ("zhou-3r-modified", "1", "2"),
    "Z48c": ("zhou-3r-modified", "2", "3"),
    "Z48d": ("zhou-3r-modified", "0", "3"),
    "Z49a": ("puma200", "0", "1"),
    "Z49b": ("puma200", "1", "2"),
    "Z49c": ("puma200", "2", "3"),
    "Z49d": ("puma200", "3", "4"),
    "Z49e": ("puma200", "4", "5"),
    "Z49f": ("puma200", "5", "6"),
    "Z49g": ("puma200", "0", "3"),
    "Z49h": ("puma200", "3", "6"),
    "Z49i": ("puma200", "0", "6"),
    "Z49j": ("puma200-spherical-wrist", "0", "6"),
    # 004 WPI
    "W07": ("dh-link-modified", "0", "1"),
    "W08": ("puma560", "0", "1"),
    "W09": ("puma560", "1", "2"),
    "W10": ("puma560", "2", "3"),
    "W11": ("puma560", "3", "4"),
    "W12": ("puma560", "4", "5"),
    "W13": ("puma560", "5", "6"),
    "W14": ("puma560", "4", "6"),
    "W15": ("puma560", "3", "6"),
    "W16": ("puma560", "1", "3"),
    "W17": ("puma560", "1", "6"),
    "W18": ("puma560", "0", "6"),
}
"""Where the files of `robots/` hold an item: the robot, and the two frames it leads from and to."""

OTHERS = {
    "a single factor": "Y19a Y19b Y19c Y19d Z06 Z07 Z08 Z09",
    "one factor of a link of scara": "B34a B34b B35a B35b B36a B36b",
    "a general move or a point": "B02 B03 B04 B06 B08 B09 B11 B12 B13",
    "moves in numbers, to be typed": "B15a B15b B15c B16 B19 B20 B21 B22a B22b B22c B23 B24",
    "a point of zhou-3r": "Z20 Z21",
    "another table for puma200: the brackets read as offsets": "Z49k",
}
"""The items that no file holds, and why."""

NOT_IN_DOCUMENTS = {"fanuc-like", "palletizer", "panda", "puma560-standard", "puma560-unimation", "ur5e"}
"""Robots from published tables or of example dimensions; test_statements compares puma560-unimation with puma560."""


@cache
def robot(name: str) -> Robot:
    """A robot of the library, loaded once."""
    return load_robot(name)


def same(one: Matrix, other: Matrix) -> bool:
    """Whether two matrices have the same shape and every entry is equal for all values of the names."""
    return [len(line) for line in one] == [len(line) for line in other] and all(
        equal(a, b) for p, q in zip(one, other, strict=True) for a, b in zip(p, q, strict=True)
    )


def test_there_are_125_equations() -> None:
    """So that none is lost unseen."""
    assert len(EQUATIONS) == 125


@row_by_row("name", EQUATIONS)
def test_the_equation_comes_out_as_the_truth_says(name: str) -> None:
    """Entry by entry, for all values of the names."""
    assert same(computed(EQUATIONS[name]), matrix(EQUATIONS[name]["expected"]))


@row_by_row("name", in_turn([*EQUATIONS], 0, 2))
def test_the_short_form_is_read_as_the_long_one(name: str) -> None:
    """`c1*s23` of the truth means cos(theta1)*sin(theta2 + theta3), to the tree."""
    assert matrix(EQUATIONS[name]["expected_short"]) == matrix(EQUATIONS[name]["expected"])


@row_by_row("name", in_turn([name for name, item in EQUATIONS.items() if item.get("sample")], 1, 2))
def test_the_equation_comes_out_in_numbers(name: str) -> None:
    """At the sample of the truth, which was found by carrying frames along, to 1e-9."""
    sample = EQUATIONS[name]["sample"]
    at = {key.replace("_im1", "_{i-1}"): value for key, value in sample["at"].items()}
    value = computed_over(EQUATIONS[name], Floats(at))
    assert len(value) == len(sample["value"])
    for line, wanted in zip(value, sample["value"], strict=True):
        assert line == pytest.approx(wanted, abs=1e-9, rel=0)


@row_by_row("name", IN_FILES)
def test_the_file_of_the_robot_gives_the_equation(name: str) -> None:
    """The whole way from the YAML file to the printed matrix."""
    arm, start, end = IN_FILES[name]
    assert same(symbolic(robot(arm), start=start, end=end).rows, matrix(TRUTH[name]["expected"]))


@row_by_row("name", [name for name, item in EQUATIONS.items() if item["compute"]["op"] == "chain"])
def test_the_product_can_be_typed(name: str) -> None:
    """`Trans(8, -6, 14) Rot(y, pi/2) Rot(z, pi/2)` as text gives the same moves."""
    compute = EQUATIONS[name]["compute"]
    assert read_chain(typed(compute)) == chain(compute)


def test_every_equation_stands_in_a_file_or_says_why_not() -> None:
    """No item is forgotten, none stands in both lists."""
    others = [name for names in OTHERS.values() for name in names.split()]
    assert sorted([*IN_FILES, *others]) == sorted(EQUATIONS)


def test_every_robot_of_the_documents_is_compared_with_them() -> None:
    """All files of `robots/` but those from published tables."""
    found = {arm for arm, _, _ in IN_FILES.values()}
    files = {path.stem for path in find(Kind.ROBOTS, "scara").parent.glob("*.yaml")}
    assert files == found | NOT_IN_DOCUMENTS


@row_by_row("name", ["Y27", "Y32", "Y39", "Y48", "Z14", "Z22", "Z28", "Z48", "Z49", "W04"])
def test_the_table_of_the_robot_is_the_printed_one(name: str) -> None:
    """Every cell, the convention, and which joint is of which kind."""
    files = {
        "Y27": "cylindrical",
        "Y32": "spherical-wrist",
        "Y39": "stanford",
        "Y48": "scara-yim",
        "Z14": "zhou-3r",
        "Z22": "scara-zhou",
        "Z28": "zhou-6r",
        "Z48": "zhou-3r-modified",
        "Z49": "puma200",
        "W04": "puma560",
    }
    arm, table = robot(files[name]), TRUTH[name]["dh"]
    assert arm.convention is Convention(TRUTH[name]["convention"])
    for link, printed in zip(arm.links, table, strict=True):
        assert link.row is not None
        assert (link.row.a, link.row.d) == (read(printed["a"]), read(printed["d"]))
        assert (link.row.alpha, link.row.theta) == (angle(printed["alpha"]), angle(printed["theta"]))
    assert [(joint.name, joint.kind) for joint in arm.joints] == [(row["variable"], row["joint"]) for row in table]


@pytest.mark.parametrize(("name", "arm"), [("Z28", "zhou-6r"), ("Z49", "puma200")])
def test_brackets_of_the_table_are_the_pose_drawn(name: str, arm: str) -> None:
    """`theta1(90°)` is a value of the variable in a named pose, no offset."""
    drawn = tuple(Angle.in_degrees(row["home_deg"]) for row in TRUTH[name]["dh"])
    assert robot(arm).poses["drawn"] == drawn


def test_the_conjecture_for_puma200_is_its_table_with_two_cells_changed() -> None:
    """Z49j: d4 = c and d5 = 0 is what a spherical wrist needs."""
    rows = [dict(row) for row in TRUTH["Z49"]["dh"]]
    rows[3]["d"], rows[4]["d"] = "c", "0"
    conjecture = [{key: row[key] for key in ("a", "alpha", "d", "theta")} for row in TRUTH["Z49j"]["compute"]["rows"]]
    assert conjecture == [{key: row[key] for key in ("a", "alpha", "d", "theta")} for row in rows]


def test_the_other_reading_of_the_brackets_of_puma200_gives_another_matrix() -> None:
    """Z49k: with the brackets added as offsets the wrist is not the one of the table."""
    assert not same(symbolic(robot("puma200"), start=3, end=6).rows, matrix(TRUTH["Z49k"]["expected"]))


def test_the_tip_of_the_3r_arm_is_a_point_of_its_last_frame() -> None:
    """Z20 and Z21 through the file: frame 3 at the point of the truth, and at α = π/6 in numbers."""
    point = [read(text) for text in TRUTH["Z21"]["compute"]["point"]]
    tip = symbolic(robot("zhou-3r")) @ point
    assert same(tuple((entry,) for entry in tip), matrix(TRUTH["Z21"]["expected"]))
    bent = [substitute(entry, {}, {"alpha": to_angle(parse("pi/6"))}) for entry in point]
    assert bent == [parse(text) for text in TRUTH["Z20"]["facts"]["numeric"]]


def test_a_numeric_pose_of_every_robot_is_its_symbolic_one_with_numbers() -> None:
    """At a named pose of each file, with the lengths of the file."""
    for path in sorted(find(Kind.ROBOTS, "scara").parent.glob("*.yaml")):
        arm = robot(path.stem)
        for pose in arm.poses:
            exact = symbolic(arm, pose, parameters={k: v for k, v in arm.parameters.items() if v is not None})
            wanted = [[Floats().value(entry) for entry in line] for line in exact.rows]
            for line, expected in zip(forward(arm, pose).rows, wanted, strict=True):
                assert line == pytest.approx(expected, abs=1e-12)


def test_the_last_row_is_0_0_0_1() -> None:
    """B14, and the prints that lost a zero: whatever the chain, even the empty one."""
    zero, one = number(0), number(1)
    for moves in ((), *(chain(item["compute"]) for item in EQUATIONS.values())):
        assert fold(moves, TERMS)[3] == (zero, zero, zero, one)


def test_a_pose_is_the_product_of_its_links() -> None:
    """Y12, Y16, B26, B33, Z02, Z12: 0T_n = 0T_1 1T_2 ... in every robot of the documents, exactly."""
    for name in sorted({arm for arm, _, _ in IN_FILES.values()}):
        arm = robot(name)
        product: Pose[Expr] = symbolic(arm, start=arm.frames[1], end=arm.frames[1])
        for start, end in zip(arm.frames[1:-2], arm.frames[2:-1], strict=True):
            product = product @ symbolic(arm, start=start, end=end)
        assert same(product.rows, symbolic(arm).rows), name
