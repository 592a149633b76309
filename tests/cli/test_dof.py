"""`dhcli dof`: the formula, whether to believe it, and the truth."""

import json
from pathlib import Path

import pytest

from tests.cli.running import Run
from tests.row_by_row import row_by_row

KEYS = {
    "mobility", "gruebler", "instantaneous", "bounds", "certificate", "formula_holds", "formulas", "space", "lambda",
    "links", "joints", "sum_f", "sum_c", "reading", "joints_listed", "other_reading", "loops", "idle", "redundant",
    "output", "motion", "branches", "order", "singular_values", "kept", "dropped", "reasons", "settles",
}  # fmt: skip


@pytest.mark.parametrize(
    ("words", "gruebler", "mobility"),
    [
        ("6R", 6, 6),
        ("loop 6R", 0, None),
        ("6-UPS", 6, None),
        ("bennett", -2, 1),
        ("puma560", 6, 6),
        ("--planar --links 4 --joints 4R", 1, None),
        ("--lambda 3 --links 4 --joints 3R+1P", 1, None),
        ("--planar loop 4R", 1, None),
        ("20000-R", -99994, None),
        ("n-RPS", "6 - n", None),
    ],
)
def test_json_has_all_figures(dhcli: Run, words: str, gruebler: int | str, mobility: int | None) -> None:
    """Its keys are a contract."""
    data = dhcli("dof", *words.split(), "--format", "json").data
    assert set(data) == KEYS
    assert (data["gruebler"], data["mobility"]) == (gruebler, mobility)


def test_a_table_reads_from_counts_to_truth(dhcli: Run) -> None:
    """And fits 80 columns."""
    done = dhcli("dof", "sarrus")
    assert done.code == 0
    for text in (
        "n = 6 links with the ground",
        "6(6 - 6 - 1) + 6·1 = 0",
        "No: the mobility is 1, not 0.",
        "directions",
    ):
        assert text in " ".join(done.out.split())
    assert max(map(len, done.out.splitlines())) <= 80


def test_a_pattern_says_how_it_was_read(dhcli: Run) -> None:
    """And what the other reading would give."""
    out = dhcli("dof", "6R").out
    assert "read as: open chain with the ground" in out
    assert "read as closed loop it would have F = 0; for that type: loop 6R" in out


def test_idle_freedoms_are_named(dhcli: Run) -> None:
    """They count, and are told apart."""
    out = dhcli("dof", "cam-follower").out
    assert "Idle: roller spins between joints 2 and 3 and moves nothing else." in out
    assert "2 (1 and 1 idle)" in out


@row_by_row(
    ("words", "message"),
    [
        (["dof"], "nothing to count"),
        (["dof", "benett"], "did you mean bennett"),
        (["dof", "--links", "4"], "--joints is missing"),
        (["dof", "6R", "--links", "4", "--joints", "4R"], "one or the other"),
        (["dof", "--planar", "--lambda", "3", "6R"], "say the same thing"),
        (["dof", "bennett", "--planar"], "says itself where it moves"),
        (["dof", "--lambda", "0", "--links", "4", "--joints", "4R"], "it is 1 to 6"),
        (["dof", "--links", "-4", "--joints", "4R"], "is negative"),
        (["dof", "bennett", "--tol", "2"], "tolerance of 2"),
        (["dof", "nowhere/l.yaml"], "no such file"),
        (["dof", "6R", "--format", "latex"], "there is no format latex"),
        (["dof", "R  " * 20 + "!"], "is no linkage, no robot and no pattern"),
        (["dof", "--planar", "--links", "4", "--joints", "()" * 28], "is not a number of joints"),
        (["dof", "--planar", "--links", "4", "--joints", "4infR"], "'4infR' is not a number of joints"),
        (["dof", "30000-R"], "up to 20,000 joints are read"),
    ],
)
def test_bad_input_ends_with_2_and_a_hint(dhcli: Run, words: list[str], message: str) -> None:
    """Never a traceback."""
    done = dhcli(*words)
    assert done.code == 2
    assert message in done.err


def test_a_linkage_is_shown(dhcli: Run) -> None:
    """Its joints and its source, without the answer."""
    out = dhcli("show", "planar-four-bar").out
    assert "crank - coupler" in out
    assert "Source" in out
    assert "trusted" not in out
    assert dhcli("show", "bennett", "--format", "json").data["link_names"] == ["ground", "1", "2", "3"]


def test_linkages_are_listed(dhcli: Run) -> None:
    """With their joints."""
    out = dhcli("list", "linkages").out
    assert "bennett" in out
    assert "4R" in out
    assert "broken" not in out


def test_joints_are_counted_in_words(dhcli: Run) -> None:
    """`4 pin 1 slot` is four pins and a slot."""
    data = dhcli("dof", "--planar", "--links", "5", "--joints", "4 pin 1 slot", "--format", "json").data
    assert (data["joints"], data["sum_f"], data["gruebler"]) == (5, 6, 3)
    assert "6(3 - 2 - 1) + 2·4 = 8" in dhcli("dof", "--links", "3", "--joints", "2 balls in a tube").out


def test_one_constraint_repeats_and_three_repeat(dhcli: Run) -> None:
    """The verb follows the number."""
    assert "1 constraint repeats others" in dhcli("dof", "sarrus").out
    assert "3 constraints repeat others" in dhcli("dof", "bennett").out


def test_a_urdf_is_counted_as_the_chain_that_it_holds(dhcli: Run, tmp_path: Path) -> None:
    """As a robot file is."""
    joint = '<joint name="j{0}" type="{1}"><parent link="l{0}"/><child link="l{2}"/><axis xyz="0 0 1"/></joint>'
    links = "".join(f'<link name="l{i}"/>' for i in range(3))
    joints = joint.format(0, "continuous", 1) + joint.format(1, "continuous", 2)
    path = tmp_path / "arm.urdf"
    path.write_text(f'<robot name="arm">{links}{joints}</robot>', "utf-8")
    done = dhcli("dof", str(path))
    assert done.code == 0
    assert "n = 3 links with the ground · j = 2 joints" in done.out


def test_a_urdf_is_counted_along_one_chain_of_it(dhcli: Run) -> None:
    """A tree is asked for its tip; a tip that is none, and options for what is no URDF, are told so."""
    urdf = str(Path(__file__).parents[1] / "data" / "urdf" / "three-joints.urdf")
    assert "which one?" in dhcli("dof", urdf).err
    done = dhcli("dof", urdf, "--tip", "tool0", "--format", "json")
    assert json.loads(done.out)["data"]["mobility"] == 3
    assert "did you mean tool0" in dhcli("dof", urdf, "--tip", "tol").err
    assert "only a URDF has links" in dhcli("dof", "puma560", "--tip", "tool0").err
    done = dhcli("dof", "--planar", "--links", "4", "--joints", "4R", "--base", "x")
    assert (done.code, "links of a URDF" in done.err) == (2, True)
