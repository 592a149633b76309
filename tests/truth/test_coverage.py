"""How much of the four documents the tests of this folder cover; what they do not, and why."""

from __future__ import annotations

from tests.truth.items import EQUATIONS, TRUTH


def ids(text: str) -> frozenset[str]:
    """Names of items, separated by blanks."""
    return frozenset(text.split())


STATED = {
    "test_equations": ids("Y12 Y16 B26 B33 Z02 Z12 B14 Y27 Y32 Y39 Y48 Z14 Z22 Z28 Z48 Z49 W04 W06"),
    "test_statements": ids(
        "Y17 Y18 Y21 Y22 Y23 Y24 Y25 Y26 Y37 Y46 B01 B05 B07 B10 B17 B18 B25 B32 B38 "
        "Z03 Z04 Z11 Z13 Z43 Z44 Z45 Z47 W03"
    ),
}
"""Items without an equation of their own that are computed here, by the file that does."""

FREEDOMS = {"Y02", "Y03", "Y04", "Y05", "Y06", "Y07", "Y08", "Y09", "Y10", "Z42", "W01"}
"""Counts of freedoms: they wait for `dhcli.mobility`."""

NOTHING_TO_COMPUTE = {
    "Y01": "the goal of the week",
    "Y11": "titles of slides whose figures are lost",
    "Y47": "what the letters of SCARA stand for",
    "B31": "a robot whose axes are not given",
    "Z01": "the aim of the chapter",
    "Z41": "a program that is not in the document",
    "Z50": "a program that is not in the document",
    "W02": "figures that are lost",
    "W05": "a coupling of the wrist's motors without numbers",
}
"""Items that hold no formula."""

CHECKS_OF_MOBILITY = ids(
    "dof_universal dof_formulas mobility_parallel mobility_sixbar mobility_pathological mobility_chains"
)


def test_every_item_is_covered_or_says_why_not() -> None:
    """191 items: 125 equations, 46 statements, 11 that wait for mobility, 9 with nothing to compute."""
    stated = [name for names in STATED.values() for name in names]
    listed = [*EQUATIONS, *stated, *FREEDOMS, *NOTHING_TO_COMPUTE]
    assert sorted(listed) == sorted(TRUTH)
    assert (len(TRUTH), len(EQUATIONS), len(stated)) == (191, 125, 46)


def test_every_named_check_but_those_of_mobility_is_covered() -> None:
    """The named checks belong to items listed above, by the document's own statement of them."""
    covered = {*EQUATIONS, *(name for names in STATED.values() for name in names)}
    left = {item["check"] for name, item in TRUTH.items() if item["check"] and name not in covered}
    assert left == CHECKS_OF_MOBILITY
