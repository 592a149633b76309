"""`dhcli describe`."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from tests.cli.running import run


def test_a_table_in_the_other_convention_says_what_went_to_the_tool() -> None:
    """A planar arm in modified DH needs a tool."""
    out = run("describe", "planar-2r", "--as", "modified").out
    assert "a_{i-1}" in out
    assert "to tool: Trans(a2, 0, 0)" in out
    assert "proved: the same motion from base to tool, for all values" in out


def test_the_steps_name_their_rules_and_what_was_free() -> None:
    """DH1 to DH3, parallel axes."""
    out = " ".join(run("describe", "puma560", "--as", "modified", "--steps").out.split())
    for words in ("DH1: z_i is the axis of joint i", "DH2: x_i is", "DH3: x_i meets it", "are parallel, a2 apart"):
        assert words in out
    assert "free: d2, as a normal stands anywhere; d2 is 0 there" in out
    assert "x3: z3 and z4 are skew" in out


def second_row(out: str) -> list[str]:
    """The cells of row 2 of a table."""
    return next(line for line in out.split("\n") if line.startswith(" 2 ")).split()


def test_a_choice_is_made_as_it_is_asked_for() -> None:
    """The lengths of the maker are negative, and the cylindrical arm has its height in row 1."""
    assert "-a2" in second_row(run("describe", "ur5e", "--as", "standard", "--steps").out)
    assert "a2" in second_row(run("describe", "ur5e", "--as", "standard", "--choose", "previous-x").out)
    out = run("describe", "cylindrical", "--as", "standard", "--choose", "next-d", "--steps").out
    assert " 1   0     0      d1    theta1   revolute" in out
    assert "free: x1 and its origin; x0 is kept, d2 is 0 there" in out


def test_a_written_description_is_a_robot(tmp_path: Path) -> None:
    """And can be described back."""
    path = str(tmp_path / "drawn.yaml")
    assert run("describe", "stanford", "--as", "axes", "-o", path).code == 0
    out = run("describe", path, "--as", "standard").out
    assert [line.split()[1:5] for line in out.split("\n") if line.startswith((" 1 ", " 2 ", " 3 "))] == [
        ["0", "-90°", "0", "theta1"],
        ["0", "90°", "d2", "theta2"],
        ["0", "0", "d3", "0"],
    ]


def test_json_has_the_table_the_steps_and_the_proof() -> None:
    """For programs."""
    data = json.loads(run("describe", "zhou-3r", "--as", "modified", "--steps", "--format", "json").out)["data"]
    assert data["proof"] == {"kind": "exact", "error": 0.0}
    assert data["result"]["convention"] == "modified"
    assert {step["step"] for step in data["steps"]} == {1, 2, 3, 4, 5, 6}


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("scara", "--as", "modifed"), "did you mean modified"),
        (("dh-link", "--as", "axes"), "directions depend on alpha_i"),
        (("scara", "--as", "standard", "--choose", "next_d"), "did you mean next-d"),
        (("scara", "--as", "axes", "--choose", "next-d"), "--choose is about tables"),
        (("assembly-blocks", "--as", "standard"), "no joints"),
        (("scara", "--as", "axes", "--pose", "elbo"), "elbow"),
        (("dh-link", "--as", "modified", "--numbers"), "has no value"),
    ],
)
def test_what_cannot_be_described_is_said(words: tuple[str, ...], said: str) -> None:
    """Exit code 2 and a reason."""
    result = run("describe", *words)
    assert result.code == 2
    assert said in result.err


def test_every_description_is_told_to_whoever_asks_for_another() -> None:
    """URDF among them, which is a file besides."""
    hint = run("describe", "puma560", "--as", "foo").err.splitlines()[-1]
    assert all(form in hint for form in ("standard", "modified", "axes", "screws", "body-screws", "product", "urdf"))
