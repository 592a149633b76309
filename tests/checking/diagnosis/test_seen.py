"""A matrix is new unless one that was seen is the same, compared with every single one."""

from __future__ import annotations

import math

from hypothesis import given
from hypothesis import strategies as st

from dhcli.checking.diagnosis.seen import SAME, Seen, same

entries = st.sampled_from([0.0, 1.0, -1.0, 0.5, 0.5 + 0.4 * SAME, 0.5 + 0.9 * SAME, 3e5, 3e5 * (1 + 0.9 * SAME), 1e300])
rows = st.tuples(entries, entries)
matrices = st.lists(st.tuples(rows, rows), max_size=40)


@given(matrices)
def test_what_is_new_is_what_no_comparison_finds(found: list[tuple[tuple[float, float], ...]]) -> None:
    """Entries that differ by less than rounding among them, and large ones."""
    seen, known = Seen(), []
    for matrix in found:
        is_new = not any(same(matrix, other) for other in known)
        assert seen.is_new(matrix) is is_new
        if is_new:
            known.append(matrix)


def test_entries_that_change_places_make_another_matrix() -> None:
    """Though their sum is the same."""
    seen = Seen()
    assert seen.is_new(((1.0, 2.0), (3.0, 4.0)))
    assert seen.is_new(((1.0, 3.0), (2.0, 4.0)))
    assert not seen.is_new(((1.0, 2.0), (3.0, 4.0 + SAME)))


def test_what_is_no_number_is_never_the_same() -> None:
    """A formula that is not defined at a point."""
    seen = Seen()
    assert seen.is_new(((math.nan,),))
    assert seen.is_new(((math.nan,),))
    assert seen.is_new(((math.inf,),))
    assert seen.is_new(((1.0,),))
