"""A regular expression that waits finds what one finds that does not."""

import copy
import pickle
import re

import pytest
from hypothesis import given
from hypothesis import strategies as st

from dhcli.regex import regex

LETTERS = st.text("abAB1 ", max_size=12)


@given(
    st.sampled_from(["a", "(a)|b", "a*", "[ab]+?1", "(?P<x>a+)(?P<y>1?)", ""]),
    st.sampled_from([0, re.IGNORECASE]),
    LETTERS,
)
def test_it_finds_the_same(text: str, flags: int, letters: str) -> None:
    """However it is used, and however often."""
    ours, theirs = regex(text, flags), re.compile(text, flags)
    for use in ("match", "fullmatch", "search"):
        for _ in range(2):
            one, other = getattr(ours, use)(letters), getattr(theirs, use)(letters)
            assert (one and (one.span(), one.groupdict())) == (other and (other.span(), other.groupdict()))
    assert ours.split(letters) == theirs.split(letters)
    assert ours.findall(letters) == theirs.findall(letters)
    assert [one.span() for one in ours.finditer(letters)] == [one.span() for one in theirs.finditer(letters)]
    assert ours.sub("-", letters) == theirs.sub("-", letters)
    assert ours.pattern == theirs.pattern


def test_it_is_compiled_when_it_is_used() -> None:
    """What is none is told then, and not before."""
    broken = regex("(")
    with pytest.raises(re.error, match="unterminated"):
        broken.match("a")


def test_it_is_copied_used_or_not() -> None:
    """As all that stands in a module may be."""
    waiting, used = regex("a+"), regex("a+")
    assert used.match("aa")
    for each in (waiting, used):
        assert copy.deepcopy(each).fullmatch("aa")
        assert pickle.loads(pickle.dumps(each)).fullmatch("aa")  # noqa: S301
