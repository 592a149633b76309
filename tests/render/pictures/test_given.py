"""What is drawn is looked at when it is asked for: a notebook would show the error as a traceback of its own."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from dhcli import draw, load_robot
from dhcli.errors import DhcliError
from tests.row_by_row import row_by_row

ARM = load_robot("planar-2r")


@row_by_row(
    ("given", "said"),
    [
        ({"q": [0.1]}, "planar-2r has 2 joints, 1 value given"),
        ({"q": [0.1, 0.2, 0.3]}, "planar-2r has 2 joints, 3 values given"),
        ({"q": {"theta9": 1}}, "planar-2r has no joint theta9"),
        ({"q": 3}, "3 is no list of joint values"),
        ({"q": "nowhere"}, "has no pose called nowhere"),
        ({"q": [0.1, 0.2], "pose": "zero"}, "two answers to one question"),
        ({"pose": "nowhere"}, "has no pose called nowhere"),
        ({"pose": [0.1, 0.2]}, "has no pose called"),
        ({"to": [0.1]}, "planar-2r has 2 joints, 1 value given"),
        ({"view": 3}, "3 is no view"),
        ({"view": (30, 20, 10)}, "is no view"),
        ({"view": (30, 100)}, "is no view"),
        ({"view": ("a", 20)}, "is no view"),
        ({"view": "sideways"}, "there is no view 'sideways'"),
    ],
)
def test_what_no_picture_can_show_is_refused_at_once(given: dict[str, Any], said: str) -> None:
    """In words, before anything is drawn."""
    with pytest.raises(DhcliError) as caught:
        draw(ARM, **given)
    assert said in str(caught.value)


@pytest.mark.parametrize("view", ["front", "30,20", (30, 20), [30.0, 20], None])
def test_a_view_is_a_name_or_two_angles(view: Any) -> None:  # noqa: ANN401  what a notebook may hand over
    """As text or as numbers."""
    assert draw(ARM, [0.1, 0.2], view=view).svg().startswith("<svg")


@pytest.mark.parametrize("kind", [np.array, list, lambda q: dict(zip(ARM.variables, q, strict=True))])
def test_a_picture_keeps_its_joint_values(kind: Callable[[Any], Any]) -> None:
    """A loop goes on with its array, and pictures of before are shown after it."""
    q, to = kind([0.1, 0.2]), kind([0.3, 0.4])
    pictures = draw(ARM, q), draw(ARM, q, to=to)
    same = draw(ARM, kind([0.1, 0.2])), draw(ARM, kind([0.1, 0.2]), to=kind([0.3, 0.4]))
    assert pictures == same
    assert hash(pictures) == hash(same)
    for key in q if isinstance(q, dict) else range(2):
        q[key], to[key] = 1, 2
    assert [one.svg() for one in pictures] == [one.svg() for one in same]
    assert draw(ARM, q).svg() != same[0].svg()
