"""No certificate that is not one: passing motions, high orders, tangents, and the type of a motion."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from dhcli.mobility.copies import mapped
from dhcli.mobility.finding import mobility_of
from dhcli.mobility.linkage import Joint
from dhcli.mobility.result import Mobility
from tests.mobility.building import joint, planar, spatial
from tests.mobility.mechanisms import linkage
from tests.nightly import NIGHT, cases_for_nights, examples, paired

FEET = [(1.0, 0.0), (-0.5, 0.8), (-0.4, -0.9), (0.3, 0.2), (0.5, 0.7), (-0.5, 0.1), (0.2, -0.5)]
HEIGHT = 2.0


# --- Motions of a part that exist in one position only


def crank_and_two_bars(tip: tuple[float, float]) -> list[Joint]:
    """A crank whose end lies over a pin of the ground, and two equal bars from the one to the other."""
    return [
        joint("R", "g", "crank", (0, 0)),
        joint("R", "crank", "u", (1, 0)),
        joint("R", "u", "v", tip),
        joint("R", "v", "g", (1, 0)),
    ]


def test_a_motion_that_the_rest_takes_away_is_not_added() -> None:
    """Two bars over one pin spin; when the crank turns they come apart, and stand on the bisector: one freedom."""
    found = planar(crank_and_two_bars((2, 0)), "crank")
    assert (found.gruebler, found.instantaneous, found.mobility, found.idle) == (1, 2, 1, ())
    assert "u with v spin between joints crank-u and v-g in this position only" in " ".join(found.reasons)


def test_what_nothing_else_can_leave_stays_idle() -> None:
    """With the bars along the crank's way the crank is at a dead point: only the bars spin."""
    found = planar(crank_and_two_bars((1, 1)), "crank")
    assert (found.gruebler, found.instantaneous, found.mobility, len(found.idle)) == (1, 1, 1, 1)


def test_a_five_bar_with_two_bars_over_a_pin_has_two_freedoms() -> None:
    """As the formula has it; three motions begin."""
    five = [
        joint("R", "g", "crank", (0, 0)),
        joint("R", "crank", "b", (1, 0)),
        joint("R", "b", "c", (2, 1.5)),
        joint("R", "c", "d", (3, 1)),
        joint("R", "d", "g", (3, 0)),
    ]
    found = planar([*five, *crank_and_two_bars((2, 0))[1:]], "b")
    assert (found.gruebler, found.instantaneous, found.mobility, found.idle) == (2, 3, 2, ())


@pytest.mark.parametrize("parts", [1, 2])
def test_a_rod_between_balls_spins_wherever_it_goes(parts: int) -> None:
    """Also a rod that is welded of two parts: its line stays in it."""
    weld = [joint("fixed", "rod1", "rod2")] if parts == 2 else []
    joints = [
        joint("R", "g", "a", (0, 0, 0), (0, 0, 1)),
        joint("S", "a", "rod1", (1, 0, 0)),
        *weld,
        joint("S", f"rod{parts}", "b", (2, 1, 1)),
        joint("R", "b", "g", (3, 0, 1), (0, 1, 0.2)),
    ]
    found = spatial(joints, "b")
    assert (found.mobility, len(found.idle), found.motion) == (2, 1, "0T1R")


# --- Ranks that are constant along a branch and larger than its dimension


def on_equal_legs(count: int) -> list[Joint]:
    """A platform on equal parallel bars."""
    return [joint("bar", "g", "platform", (*foot, 0), other=(*foot, HEIGHT)) for foot in FEET[:count]]


@pytest.mark.parametrize("count", cases_for_nights([4, 5, 6, 7], 4, 7))
def test_a_platform_on_equal_parallel_legs_translates_on_a_sphere(count: int) -> None:
    """The turn about the legs' direction is instantaneous wherever it stands: 2T0R, not 3 freedoms, not rotations."""
    found = spatial(on_equal_legs(count), "platform")
    assert (found.instantaneous, found.mobility, found.motion) == (3, 2, "2T0R")


def test_translations_on_a_sphere_are_all_that_keeps_four_legs_equal() -> None:
    """The oracle for the test above: at any point of the sphere a turn changes the legs in second order."""
    draw = np.random.default_rng(1)
    feet = np.array([(*foot, 0.0) for foot in FEET[:4]])
    for _ in range(20):
        leg = HEIGHT * (way := draw.normal(size=3)) / np.linalg.norm(way)
        axis = leg / HEIGHT
        # a turn by t about an axis along the legs through any point, and the best translation for it
        for angle in (1e-2, -1e-2):
            turn = np.eye(3) * math.cos(angle) + (1 - math.cos(angle)) * np.outer(axis, axis)
            turn += math.sin(angle) * np.array([[0, -axis[2], axis[1]], [axis[2], 0, -axis[0]], [-axis[1], axis[0], 0]])
            moved = (
                feet @ turn.T
            ) - feet  # leg i changes by |leg + moved_i + shift|² - |leg|², less what a shift can do
            changes = np.sum(moved**2, axis=1) + 2 * moved @ leg
            columns = np.column_stack([2 * moved, np.ones(4)])  # linear part of a shift, and its square and 2 leg·shift
            assert np.linalg.norm(changes - columns @ np.linalg.lstsq(columns, changes, rcond=1e-6)[0]) > 1e-8


@pytest.mark.parametrize("legs", [3, 4])
def test_universal_joints_keep_a_platform_from_turning(legs: int) -> None:
    """Here the rank is the dimension."""
    joints = []
    for i, foot in enumerate(FEET[:legs]):
        joints.append(joint("U", "g", f"leg{i}", (*foot, 0), (1, 0, 0), axis2=(0, 1, 0)))
        joints.append(joint("U", f"leg{i}", "platform", (*foot, HEIGHT), (0, 1, 0), axis2=(1, 0, 0)))
    found = spatial(joints, "platform")
    assert (found.instantaneous, found.mobility, found.motion) == (2, 2, "2T0R")


def test_spinning_rods_are_added_to_a_sphere_of_translations() -> None:
    """Four equal rods between balls: 2 of the platform, 4 idle; the formula's 6 is right here, 7 motions begin."""
    joints = []
    for i, foot in enumerate(FEET[:4]):
        joints += [joint("S", "g", f"rod{i}", (*foot, 0)), joint("S", f"rod{i}", "platform", (*foot, HEIGHT))]
    found = spatial(joints, "platform")
    assert (found.gruebler, found.instantaneous, found.mobility, len(found.idle)) == (6, 7, 6, 4)
    assert found.motion == "2T0R"


# --- Structures that resist in a high order


def collinear_pairs(lengths: list[float]) -> list[Joint]:
    """Collinear bars, the end of each pair held by the middle of the next: the gap grows like A^(2^pairs)."""
    joints, held, middle = [], "", np.array([1.0, 0.0])
    for i, length in enumerate(lengths):
        way = length * np.array([(1.0, 0.0), (0.0, -1.0)][i % 2])
        joints += [joint("R", "g", f"a{i}", middle - way), joint("R", f"a{i}", f"b{i}", middle)]
        joints += [joint("R", held, f"a{i}", middle)] if held else []
        held, middle = f"b{i}", middle + 1.1 * way
    return [*joints, joint("R", held, "g", middle)]


@pytest.mark.parametrize(("pairs", "order"), [(1, 2), (2, 4), (3, 8)])
def test_the_order_in_which_a_structure_resists_is_seen(pairs: int, order: int) -> None:
    """Each pair that holds the one before squares its shortening."""
    found = planar(collinear_pairs([1.0] * pairs), "a0")
    assert (found.instantaneous, found.mobility, found.order, found.motion) == (1, 0, order, "0T0R")


@pytest.mark.parametrize("pairs", [4, 5])
def test_where_double_precision_cannot_tell_it_is_undecided(pairs: int) -> None:
    """A^16 and A^32 vanish in rounding; that they are no motion is not certain either."""
    found = planar(collinear_pairs([1.0] * pairs), "a0")
    assert (found.mobility, found.bounds) == (None, (0, 1))
    assert found.certificate.startswith("undecided")


@examples(0.2)
@given(st.lists(st.floats(0.4, 2.5), min_size=3, max_size=4))
def test_a_high_order_is_never_called_a_motion(lengths: list[float]) -> None:
    """Whatever the lengths."""
    assert planar(collinear_pairs(lengths), "a0").mobility in (0, None)


@examples(0.4)
@given(st.floats(0.3, 1.3), st.floats(0.5, 3.0), st.floats(-0.8, 0.8))
def test_a_motion_with_a_short_range_is_not_taken_for_a_high_order(angle: float, base: float, rise: float) -> None:
    """Three equal parallel cranks, of any size, also near a dead point."""
    found = planar(three_cranks(angle, base, rise), "platform")
    assert (found.mobility, found.motion) == (1, "1T0R")


def test_the_locked_3_upu_is_proved_rigid() -> None:
    """No combination of its two forms is definite, but they have no common zero."""
    found = mobility_of(linkage("snu3upu_locked"))
    assert (found.mobility, found.instantaneous, found.order) == (0, 2, 2)
    assert found.certificate.startswith("exact: the second order test")


# --- The type of a motion, and rounded drawings


def three_cranks(angle: float, base: float, rise: float, decimals: int = 17) -> list[Joint]:
    """A platform on three equal parallel cranks, as a drawing has it."""
    joints = []
    for i, foot in enumerate([(0.0, 0.0), (base, rise), (2.3 * base, -rise)]):
        end = foot[0] + math.cos(angle), foot[1] + math.sin(angle)
        for links, point in ((("g", f"crank{i}"), foot), ((f"crank{i}", "platform"), end)):
            joints.append(joint("R", *links, [round(x, decimals) for x in point]))
    return joints


@examples(0.4)
@given(st.floats(0.4, 1.2), st.floats(0.8, 2.0), st.floats(0.1, 0.5), st.sampled_from([3, 4]))
def test_rounded_cranks_translate_with_a_tolerance(angle: float, base: float, rise: float, decimals: int) -> None:
    """1T0R: what a rounded platform turns is rounding."""
    found = planar(three_cranks(angle, base, rise, decimals), "platform", 3 * 10.0**-decimals)
    assert (found.mobility, found.motion) == (1, "1T0R")


def hinted(found: Mobility) -> list[str]:
    """The sentences that speak of rounding."""
    return [reason for reason in found.reasons if "look rounded" in reason]


def test_without_a_tolerance_a_rounded_drawing_is_suspected() -> None:
    """With the tolerance that fits its decimals; exact cranks are not."""
    (sentence,) = hinted(planar(three_cranks(1.1, 1.234567, 0.1, 3), "platform"))
    assert "try --tol 0.003" in sentence
    assert not hinted(planar(three_cranks(1.1, 1.234567, 0.1, 3), "platform", 0.003))
    assert not hinted(planar(three_cranks(1.1, 1.234567, 0.1), "platform"))


@pytest.mark.parametrize("cells", [5, 40 if NIGHT else 20])
def test_a_long_scissor_is_not_taken_for_a_rounded_drawing(cells: int) -> None:
    """Its singular values are small too, but fall step by step."""
    joints = []
    for i in range(cells):
        joints.append(joint("R", "g" if i == 0 else f"a{i}", f"b{i}", (2 * i + 1, 1)))
        if i:
            before = "g" if i == 1 else f"a{i - 1}"
            joints += [joint("R", before, f"b{i}", (2 * i, 2)), joint("R", f"b{i - 1}", f"a{i}", (2 * i, 0))]
    found = planar(joints)
    assert found.mobility == 1
    assert not hinted(found)


def test_joints_at_one_point_have_an_answer() -> None:
    """A size of zero divides nothing."""
    joints = [
        joint("P", "g", "t", axis=(1, 0, 0)),
        joint("line-contact", "t", "roller", (0, 0, 1), (0, 0, 1), axis2=(0, 1, 0)),
        joint("R", "roller", "g", (0, 0, 1), (0, 1, 0)),
    ]
    found = spatial(joints, "t")
    assert (found.mobility, len(found.idle)) == (2, 1)


@examples(0.4)
@given(st.floats(1.2, 4.0), st.floats(1.2, 4.0), st.floats(0.5, 2.0))
def test_three_cranks_at_their_dead_point_still_translate(second: float, third: float, size: float) -> None:
    """Of the two motions that begin there one goes on; it has to be looked for, not met by chance."""
    feet = [(size * x, 0.0) for x in (0.0, second, second + third)]
    joints = []
    for i, (x, y) in enumerate(feet):
        joints += [joint("R", "g", f"c{i}", (x, y)), joint("R", f"c{i}", "platform", (x + size, y))]
    found = planar(joints, "platform")
    assert (found.instantaneous, found.mobility, found.motion) == (2, 1, "1T0R")


@pytest.mark.parametrize("base", [1.3, 2.0, 3.1])
def test_the_two_motions_of_a_flat_parallelogram_are_both_told(base: float) -> None:
    """As a parallelogram the coupler translates, as an antiparallelogram it turns."""
    pins = [(0, 0), (1, 0), (1 + base, 0), (base, 0)]
    links = ["g", "crank", "coupler", "rocker", "g"]
    found = planar([joint("R", links[i], links[i + 1], pins[i]) for i in range(4)], "coupler")
    assert (found.instantaneous, found.mobility, found.motion) == (2, 1, "1T0R")
    assert "the output has 1T0R on one, 0T1R on another" in " ".join(found.reasons)


@pytest.mark.parametrize(
    ("name", "decimals"),
    paired(["fourbar_shaky_brace", "collinear2", "jessen", "sarrus", "delta_rrpar", "serial6r"], [3, 4]),
)
def test_a_rounded_drawing_gets_no_certificate_that_is_not_one(name: str, decimals: int) -> None:
    """What is shaky is not taken for a motion because the gap hides in the tolerance; the motion is the exact one's."""
    exact = mobility_of(linkage(name))
    drawn = mapped(linkage(name), lambda p: np.round(p, decimals), lambda d: np.round(d / np.linalg.norm(d), decimals))
    found = mobility_of(drawn, 3 * 10.0**-decimals)
    assert (found.mobility, found.motion) == (exact.mobility, exact.motion)


# --- Watt's linkage, whose middle goes straight up to the fifth power


def watt(at: float, hand: int, tag: str) -> list[Joint]:
    """Two equal arms, and between them a coupler whose middle (at, 0) starts straight up."""
    return [
        joint("R", "g", f"arm{tag}", (at - 3, hand)),
        joint("R", f"arm{tag}", f"coupler{tag}", (at, hand)),
        joint("R", f"coupler{tag}", f"rocker{tag}", (at, -hand)),
        joint("R", f"rocker{tag}", "g", (at + 3, -hand)),
    ]


def test_a_dead_point_of_the_output_does_not_hide_how_it_moves() -> None:
    """For an instant the coupler translates; it turns as soon as it is on its way."""
    assert planar(watt(0, 1, ""), "coupler").motion == "0T1R"


def test_an_almost_straight_line_is_not_straight() -> None:
    """A pin in a straight slot stops it, with a gap that grows like the fifth power."""
    found = planar([*watt(0, 1, ""), joint("slot", "g", "coupler", (0, 0), slide=(0, 1))])
    assert (found.instantaneous, found.mobility, found.order) == (1, 0, 5)


@pytest.mark.parametrize("hand", [1, -1])
@pytest.mark.parametrize("distance", [4.0, 7.0])
def test_two_watt_linkages_with_a_bar_between_move(hand: int, distance: float) -> None:
    """Connelly and Servatius 1994: also where the motion begins at a cusp, rigid in third order and yet a mechanism."""
    joints = [*watt(0, 1, "1"), *watt(distance, hand, "2")]
    joints += [joint("R", "coupler1", "bar", (0, 0)), joint("R", "bar", "coupler2", (distance, 0))]
    found = planar(joints, "bar")
    assert (found.gruebler, found.instantaneous, found.mobility) == (1, 2, 1)
