"""The placer of labels: none on another, none outside, the same every time."""

from __future__ import annotations

from hypothesis import given, settings
from hypothesis import strategies as st

from dhcli.scene.ink import Ink
from dhcli.scene.labels import PRINT, Rect, Wish, placed
from dhcli.scene.shapes import Shape, Text
from dhcli.scene.words import Run

ROOM = Rect(0, 0, 400, 300)
flats = st.tuples(st.floats(5, 395), st.floats(5, 295))
wishes = st.lists(
    st.builds(
        lambda point, letters, away: Wish((point,), (Run(letters[0]), Run(letters[1:] or "1", below=True)), "x", away),
        flats,
        st.text("xyzθ012", min_size=1, max_size=5),
        st.tuples(st.floats(-1, 1), st.floats(-1, 1)),
    ),
    max_size=25,
)


def _rect(text: Text) -> Rect:
    wide, high = PRINT.box(text.words)
    x, y = text.at[0], text.at[1] - 0.26 * text.size
    return Rect(x - wide / 2, y - high / 2, x + wide / 2, y + high / 2)


@settings(max_examples=40)
@given(wishes=wishes, line=st.tuples(flats, flats))
def test_no_label_overlaps_another_or_leaves_the_paper(
    wishes: list[Wish], line: tuple[tuple[float, float], tuple[float, float]]
) -> None:
    """However many want the same place."""
    ink = Ink(400, 300)
    ink.add([Shape(line, "edge")])
    _, texts = placed(wishes, ink, ROOM)
    boxes = [_rect(text) for text in texts]
    assert all(b.left >= 0 and b.right <= 400 and b.top >= 0 and b.bottom <= 300 for b in boxes)
    shrunk = [Rect(b.left + 1e-6, b.top + 1e-6, b.right - 1e-6, b.bottom - 1e-6) for b in boxes]
    assert not any(a.meets(b) for i, a in enumerate(shrunk) for b in shrunk[i + 1 :])


def test_forty_labels_of_one_point_all_find_a_place() -> None:
    """There is room for them farther away."""
    crowd = [Wish(((200.0, 150.0),), (Run("z"), Run(str(i), below=True)), "z") for i in range(40)]
    leaders, texts = placed(crowd, Ink(400, 300), ROOM)
    assert len(texts) == 40
    assert len(leaders) > 20


def test_a_label_keeps_off_the_lines_where_there_is_room() -> None:
    """A bar through the point: the label stands beside it, on the side that it would like."""
    ink = Ink(400, 300)
    ink.add([Shape(((0.0, 150.0), (400.0, 150.0)), "edge")])
    for away, above in (((0.0, -1.0), True), ((0.0, 1.0), False)):
        _, (text,) = placed([Wish(((200.0, 150.0),), (Run("a"),), "dim", away)], ink, ROOM)
        assert (_rect(text).bottom <= 153) == above
        assert ink.amount(text.at[0] - 4, _rect(text).top + 4, text.at[0] + 4, _rect(text).bottom - 4) == 0


@settings(max_examples=30)
@given(
    shapes=st.lists(st.tuples(flats, flats), max_size=6),
    corner=flats,
    size=st.tuples(st.integers(1, 90), st.integers(1, 90)),
)
def test_the_sum_over_a_rectangle_is_the_sum_of_its_cells(
    shapes: list[tuple[tuple[float, float], tuple[float, float]]], corner: tuple[float, float], size: tuple[int, int]
) -> None:
    """The table of sums against adding up."""
    ink = Ink(400, 300)
    ink.add([Shape(points, "edge") for points in shapes])
    left, top, right, bottom = corner[0], corner[1], corner[0] + size[0], corner[1] + size[1]
    columns = range(int(left / 4), min(ink.columns, int(right / 4) + 1))
    rows = range(int(top / 4), min(ink.rows, int(bottom / 4) + 1))
    assert ink.amount(left, top, right, bottom) == sum(ink.cells[j * ink.columns + i] for j in rows for i in columns)
