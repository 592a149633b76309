"""Linkage files: those that dhcli brings along, every form of them, and what is wrong with broken ones."""

from __future__ import annotations

import numpy as np
import pytest

from dhcli.errors import DhcliError
from dhcli.files.library.entries import Kind, entries
from dhcli.files.yaml import coordinates
from dhcli.files.yaml.linkages import find_linkage, load_linkage, read_linkage
from dhcli.mobility.counting import Counts
from dhcli.mobility.finding import mobility_of
from dhcli.mobility.linkage import Joint, Linkage
from dhcli.mobility.pairs import LETTERS, PLANAR, SPATIAL, pair_of
from dhcli.mobility.slips import count, slips
from tests.nightly import NIGHT
from tests.row_by_row import row_by_row

LIBRARY = {
    "3-rrr": (3, 3),
    "bennett": (-2, 1),
    "bricard": (0, 1),
    "cam-follower": (2, 2),
    "complex-six-bar": (1, 1),
    "delta": (9, 9),
    "five-bar": (2, 2),
    "four-bar-in-space": (-2, 1),
    "goldberg": (-1, 1),
    "hoberman": (-3, 1),
    "hooke-coupling": (-2, 1),
    "open-chain-3r": (3, 3),
    "parallel-four-bar": (1, 1),
    "parallel-four-bar-third-crank": (0, 1),
    "peaucellier": (1, 1),
    "planar-four-bar": (1, 1),
    "planetary-gear": (2, 2),
    "ring-of-arms": (None, None),
    "sarrus": (0, 1),
    "scissor": (1, 1),
    "shaft-coupling": (-2, 1),
    "six-r-arm": (6, 6),
    "slider-crank": (1, 1),
    "stephenson": (1, 1),
    "stewart-gough": (6, 6),
    "universal-joint": (2, 2),
    "watt": (1, 1),
}
"""F of the formula and true mobility, from the sources that the files name."""

HEAD = "format: 1\ntitle: t\nsource: s\n"
FOUR_BAR = "space: planar\npoints: {A: [0, 0], B: [0, 1], C: [3, 2], D: [3, 0]}\n"
UNREAL = "a: sqrt(-1) is not a real number"
JOINTS = "joints: [ground R a at A, a R b at B, b R c at C, c R ground at D]\n"


def read(text: str) -> Linkage | Counts:
    """A linkage from what stands below the head."""
    return read_linkage(HEAD + text, "l.yaml", "l")


def problems(text: str) -> list[str]:
    """What is wrong, without hints."""
    with pytest.raises(DhcliError) as caught:
        read(text)
    for problem in caught.value.problems:
        assert problem.place is not None
        assert problem.place.line is not None
    return [problem.message for problem in caught.value.problems]


def test_every_linkage_of_the_library_is_known_here() -> None:
    """So that a new one gets its numbers."""
    assert {entry.name for entry in entries(Kind.LINKAGES)} == set(LIBRARY)


@pytest.mark.parametrize("name", LIBRARY)
def test_a_linkage_of_the_library_has_its_numbers(name: str) -> None:
    """Formula and truth; each is explained for those who learn the format from it."""
    linkage = load_linkage(name)
    found = mobility_of(linkage)
    assert (found.gruebler, found.mobility) == LIBRARY[name]
    if isinstance(linkage, Linkage):
        assert linkage.title
        assert linkage.source
        assert (found.formula_holds is False) == bool(found.reasons)


def test_slips_of_a_linkage() -> None:
    """Named, and never the right value."""
    shaft = load_linkage("shaft-coupling")
    assert count("mobility", shaft) == 1
    assert slips("mobility", shaft)["the formula is believed"] == -2
    assert next(iter(slips("mobility", shaft))) == "the formula is believed"
    assert slips("gruebler", shaft)["space taken for the plane"] == 1
    four_bar = load_linkage("planar-four-bar")
    assert slips("gruebler", four_bar)["the plane taken for space"] == -2
    assert slips("links", four_bar)["the ground is not counted"] == 3
    assert slips("gruebler", load_linkage("peaucellier"))["a pin of several links counted once"] == 9
    assert slips("mobility", load_linkage("delta"))["idle freedoms are left out"] == 3


def test_the_forms_of_a_four_bar_agree() -> None:
    """Joints, bars, a chain and counts."""
    forms = [
        FOUR_BAR + JOINTS,
        FOUR_BAR + "bars: {ground: [A, D], a: [A, B], b: [B, C], c: [C, D]}\n",
        "space: planar\nchain: ground R a R b R c R ground\n",
        "lambda: 3\nlinks: 4\njoints: 4R\n",
    ]
    found = [mobility_of(read(form)) for form in forms]
    assert [one.gruebler for one in found] == [1, 1, 1, 1]
    assert [one.mobility for one in found] == [1, 1, None, None]


def test_a_joint_in_a_line_has_its_numbers_where_they_stand() -> None:
    """As names say them, and what is wrong with one is told at its own place."""
    lines = (
        "ground R a at [0, 0]",
        "a R b at [0, r*cos(0°)]",
        "b R c at [3,2]",
        "c R ground at [3, 0 ] about [0, 0, 1]",
    )
    placed = read("space: planar\nlet: {r: 100 cm}\njoints:\n" + "".join(f"  - {line}\n" for line in lines))
    named = read(FOUR_BAR + JOINTS)
    assert isinstance(placed, Linkage)
    assert isinstance(named, Linkage)
    assert [joint.point for joint in placed.joints] == [joint.point for joint in named.joints]
    assert placed.joints[-1].axis == (0, 0, 1)
    slide = read("space: spatial\njoints:\n  - ground C a at [1, 2, -3] along [1, 0, -1]\n")
    assert isinstance(slide, Linkage)
    assert (slide.joints[0].point, slide.joints[0].axis) == ((1, 2, -3), (1, 0, -1))
    with pytest.raises(DhcliError) as caught:
        read("space: planar\njoints:\n  - ground R a at [0, q]\n")
    place = caught.value.problems[0].place
    assert place is not None
    assert (place.line, place.column) == (6, 23)


def test_a_pin_through_three_links_is_two_joints() -> None:
    """In both forms."""
    text = FOUR_BAR + "joints: [{type: R, links: [ground, a, b], point: A}]\n"
    linkage = read(text)
    assert isinstance(linkage, Linkage)
    assert [joint.name for joint in linkage.joints] == ["1.1", "1.2"]
    bars = read(FOUR_BAR + "bars: {ground: [A, B], a: [A, C], b: [A, D]}\n")
    assert isinstance(bars, Linkage)
    assert len(bars.joints) == 2


def test_a_word_finds_a_file_a_name_a_robot_or_a_pattern() -> None:
    """In this order."""
    assert isinstance(find_linkage("bennett"), Linkage)
    assert count("mobility", find_linkage("puma560")) == 6
    assert count("links", find_linkage("6R")) == 7
    assert isinstance(find_linkage("n-RPS"), Counts)
    with pytest.raises(DhcliError) as caught:
        find_linkage("benett")
    assert caught.value.problems[0].hint.startswith("did you mean bennett")
    assert "6R" in caught.value.problems[0].hint


@row_by_row(
    ("text", "message"),
    [
        (FOUR_BAR + "joints: [ground R a at A, a R a at B]", "joint 2: ties a to itself"),
        (FOUR_BAR + "joints: [ground X a at A]", "type: there is no joint 'X'"),
        (FOUR_BAR + "joints: [ground S a at A]", "joint 1: there is no spherical joint in the plane"),
        (FOUR_BAR + "joints: [a R b at A]", "no link is the ground"),
        (FOUR_BAR + "joints: [a R b at A]\nground: c", "ground: no joint ties a link called c"),
        (FOUR_BAR + JOINTS + "output: d", "output: no joint ties a link called d"),
        (FOUR_BAR + "joints: [ground R a at A, b R c at B]", "nothing connects b, c with the ground ground"),
        (FOUR_BAR + "joints: [ground R a at E]", "point: there is no point called E"),
        (FOUR_BAR + "joints: [ground R]", "'ground R' is not read as a joint"),
        (FOUR_BAR + "joints: [ground P a along w]", "axis: 'w' is no direction"),
        (
            FOUR_BAR + "joints: [{type: P, links: [ground, a], axis: [0, 0]}]",
            "joint 1: axis has length zero, so that it points nowhere",
        ),
        (FOUR_BAR + "joints: [{type: P, links: [ground, a], axis: z}]", "joint 1: it leaves the plane z = 0"),
        (
            FOUR_BAR + "joints: [{type: R, links: [ground, a], point: A, axis: x}]",
            "joint 1: its axis is not at right angles to the plane",
        ),
        (FOUR_BAR + "joints: [{type: R, links: [ground]}]", "links: a joint ties at least two links"),
        (
            FOUR_BAR + "joints: [{type: gear, links: [ground, a], radii: [1, 2]}]",
            "joint 1: a gear mesh needs its carrier",
        ),
        (
            FOUR_BAR + "joints: [{type: gear, links: [ground, a], carrier: a, radii: [1, 2]}]",
            "joint 1: the carrier a is one of the wheels",
        ),
        (
            FOUR_BAR + "joints: [{type: gear, links: [ground, a], carrier: b, radii: [1, 0]}]",
            "joint 1: a radius is not above zero",
        ),
        (
            FOUR_BAR + "joints: [{type: gear, links: [ground, a], radii: [1]}]",
            "radii: two are wanted, one for each wheel",
        ),
        (FOUR_BAR + "joints: []", "a linkage has at least one joint"),
        (FOUR_BAR + JOINTS + "chain: a R b", "joints and chain: only one form of a linkage may stand here"),
        (FOUR_BAR, "no linkage: give joints, chain, bars or loop"),
        ("joints: 4R\nlinks: 4", "space: is missing"),
        ("space: planar\nlambda: 3\njoints: 4R\nlinks: 4", "space and lambda say the same thing"),
        ("lambda: 0\njoints: 4R\nlinks: 4", "lambda: λ = 0 is not possible; it is 1 to 6"),
        ("lambda: 3\njoints: 4R", "links: is missing"),
        ("lambda: 3\njoints: 4R\nlinks: -4", "links: -4 is negative"),
        ("lambda: 3\njoints: 4R\nlinks: 9", "4 joints cannot connect 9 links"),
        ("space: planar\nchain: ground R a R", "links and joints do not alternate"),
        ("space: planar\nchain: ground R a Q b", "there is no joint 'Q'"),
        ("space: spatial\nbars: {ground: [A, B], a: [A, B]}", "bars: are pinned together in the plane"),
        ("space: planar\nbars: {ground: [A, B], a: [A, C], b: [D, E]}", "b: shares no pin with another bar"),
        ("space: planar\nlet: {a: sqrt(-1)}\n" + JOINTS.replace(" at ", " about z at "), UNREAL),
        ("space: spatial\npoints: {A: [0, 0]}\njoints: [ground R a at A]", "A: three coordinates are wanted, not 2"),
    ],
)  # fmt: skip
def test_a_broken_file_says_what_is_wrong_and_where(text: str, message: str) -> None:
    """One of its problems is this one."""
    assert message in problems(text)


def loop(theta: str) -> str:
    """A four-bar as a loop of DH rows; a square closes at 90°."""
    row = "{a: 1, alpha: 0, d: 0, theta: %s}"
    return "space: spatial\nloop:\n  convention: standard\n  rows: [" + ", ".join([row % theta] * 4) + "]\n"


def test_a_loop_of_dh_rows_must_close() -> None:
    """And says how far it is from it."""
    found = mobility_of(read(loop("90°")))
    assert (found.gruebler, found.mobility) == (-2, 1)
    (message,) = problems(loop("89°"))
    assert message.startswith("loop: the loop does not close: the last frame is 0.0498 m and 4° away")


def test_a_rounded_loop_closes_with_a_tolerance() -> None:
    """As far as the rounding goes."""
    text = HEAD + loop("89.99°")
    assert isinstance(read_linkage(text, "l.yaml", "l", 0.001), Linkage)


def test_a_wheel_without_a_pin_is_refused() -> None:
    """Teeth hold nothing."""
    text = "space: planar\njoints: [ground R a, {type: gear, links: [a, b], carrier: ground, radii: [1, 2]}]\n"
    linkage = read(FOUR_BAR.replace("space: planar\n", "") + text.replace("ground R a", "ground R a at A"))
    with pytest.raises(DhcliError, match="nothing but gear teeth holds b"):
        mobility_of(linkage)


def test_a_very_long_chain_is_answered_in_bounded_time() -> None:
    """10,000 joints: an open chain is exact, a loop without geometry is the formula."""
    assert mobility_of(find_linkage("10000R")).mobility == 10_000
    assert mobility_of(find_linkage("loop 10000R")).gruebler == 9994
    with pytest.raises(DhcliError):
        find_linkage("100000R")


def test_a_key_given_twice_hides_nothing_else() -> None:
    """All problems of the file at once, in its order."""
    text = FOUR_BAR + "output: b\noutput: z\nstrange: 1\njoints: [ground X a at A, a R b at E]\n"
    assert problems(text) == [
        "output: stands twice, first on line 6",
        "strange: unknown key",
        "type: there is no joint 'X'",
        "point: there is no point called E",
    ]
    assert problems("space: planar\nlinks: 4\nlinks: 5\njoints: 4infR\n")[0] == "links: stands twice, first on line 5"


def test_a_joint_given_in_words_is_counted() -> None:
    """In a file as on the command line."""
    found = mobility_of(read("space: planar\nlinks: 6\njoints: 4 pin 1 slot\n"))
    assert (str(found.counts.j), str(found.counts.sum_f), found.gruebler) == ("5", "6", 6)


@pytest.mark.parametrize("spatial", [False, True])
def test_a_loop_of_a_thousand_joints_is_answered(spatial: bool) -> None:
    """It has as many freedoms as joints, less those of a body: counted in the loop's few equations."""
    draw = np.random.default_rng(5)
    names = ["g", *map(str, range(1, 1000)), "g"]
    joints = []
    for i in range(1000):
        point, axis = draw.normal(size=(2, 3)) if spatial else ((*draw.normal(size=2), 0.0), (0.0, 0.0, 1.0))
        joints.append(Joint(LETTERS["R"], (names[i], names[i + 1]), str(i), tuple(point), tuple(axis)))
    found = mobility_of(Linkage("ring", SPATIAL if spatial else PLANAR, tuple(joints), "g"))
    assert (found.mobility, found.gruebler) == ((994, 994) if spatial else (997, 997))
    assert len(found.singular_values) == (6 if spatial else 3)


def test_a_long_loop_of_dh_rows_closes() -> None:
    """A regular polygon; its frames are multiplied one after the other."""
    count = 1000 if NIGHT else 300
    row = f"{{a: 1, alpha: 0, d: 0, theta: 360°/{count}}}"
    text = "space: spatial\nloop:\n  convention: standard\n  rows: [" + ", ".join([row] * count) + "]\n"
    assert mobility_of(read(text)).mobility == count - 3


def test_many_bars_between_two_links_are_answered() -> None:
    """By the form of the equations that has six columns, not five thousand; by day of three hundred bars."""
    count = 1000 if NIGHT else 300
    ends = np.random.default_rng(6).normal(size=(count, 2, 3))
    joints = tuple(
        Joint(pair_of("bar"), ("g", "body"), str(i), tuple(a), other=tuple(b)) for i, (a, b) in enumerate(ends)
    )
    found = mobility_of(Linkage("bars", SPATIAL, joints, "g", "body"))
    assert (found.mobility, found.redundant) == (0, count - 6)
    assert found.kept is not None
    assert found.kept <= 1


def test_a_linkage_too_large_for_its_geometry_keeps_its_formula() -> None:
    """And says so."""
    lines = [f"  - {i or 'ground'} R {i + 1 if i < 5999 else 'ground'} at {'AB'[i % 2]}" for i in range(6000)]
    found = mobility_of(read("space: planar\npoints: {A: [0, 0], B: [1, 0]}\njoints:\n" + "\n".join(lines) + "\n"))
    assert (found.gruebler, found.mobility, found.bounds) == (5997, None, None)
    assert "more than 5,000 links" in found.settles


def test_more_names_than_a_person_writes_are_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    """Each is read with all before it in view; the other problems of the file are told too. By day of a lower limit."""
    assert coordinates.MOST_NAMES == 1_000
    most = 1_000 if NIGHT else 100
    monkeypatch.setattr(coordinates, "MOST_NAMES", most)
    names = "".join(f"  x{i}: {f'x{i - 1} + 1' if i else 1}\n" for i in range(most + 1))
    assert problems(f"space: planar\nlet:\n{names}points: {{A: [x{most - 1}, x]}}\njoints: [ground R a at A]\n") == [
        f"let: more than {most:,} names are not read",
        "x is not a name that is known here",
    ]


def test_a_linkage_and_its_mobility_show_themselves_in_a_line() -> None:
    """As the prompt shows them; and what is no linkage is refused by what it is."""
    assert repr(load_linkage("slider-crank")) == "<Linkage slider-crank: Slider-crank, 4 links 3R 1P>"
    assert (
        repr(mobility_of(load_linkage("delta"))) == "<Mobility of Delta robot with pairs of rods: 9; by the formula 9>"
    )
    many = mobility_of(load_linkage("ring-of-arms"))
    assert repr(many) == "<Mobility of Platform on n RPS legs: unknown; by the formula 6 - n>"
    for given, said in (("bennett", r"load_linkage\('bennett'\) loads one"), (None, "not None")):
        with pytest.raises(DhcliError, match=said):
            mobility_of(given)  # type: ignore[arg-type]
