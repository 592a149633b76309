"""What `frozen` makes is what `dataclass(frozen=True, slots=True)` makes, said of the same class by both."""

import copy
import inspect
import pickle
import pprint
import pydoc
from collections.abc import Callable
from dataclasses import FrozenInstanceError, dataclass, field, fields, is_dataclass, replace
from functools import cached_property
from typing import Any, ClassVar, Generic, TypeVar

import pytest
from hypothesis import given
from hypothesis import strategies as st

import dhcli
from dhcli import inverse, load_robot
from dhcli.frozen import frozen
from tests.row_by_row import row_by_row

T = TypeVar("T")
slotted = dataclass(frozen=True, slots=True)


def _classes(make: Callable[[type], type]) -> dict[str, Any]:
    """Classes of every kind that dhcli has, by one of the two makers."""

    @make
    class Empty:
        """No field."""

    @make
    class One:
        """One field."""

        x: object

    @make
    class Point:
        """Two, with a default."""

        x: object
        y: object = 7

    @make
    class Space(Point):
        """An heir, with one that tells nobody apart and one that is not shown."""

        z: object = field(default=0, compare=False)
        note: object = field(default="", repr=False)

    @make
    class Five:
        """More than the plain ones."""

        a: object
        b: object
        c: object
        d: object = 4
        e: object = 5

    @make
    class Made(Generic[T]):
        """A default for each, and one that nobody gives."""

        x: T
        held: dict[str, int] = field(default_factory=dict)
        behind: object = 0
        memo: list[int] = field(default_factory=list, init=False, repr=False, compare=False)
        late: object = field(init=False, compare=False)
        shared: ClassVar[int] = 3
        every: ClassVar = ("a",)

        def __post_init__(self) -> None:
            object.__setattr__(self, "late", ("of", self.x))

    @make
    class Own:
        """Its own equality, hash and look."""

        x: object

        def __eq__(self, other: object) -> bool:
            return isinstance(other, Own)

        def __hash__(self) -> int:
            return 5

        def __repr__(self) -> str:
            return "own"

    return {made.__name__: made for made in (Empty, One, Point, Space, Five, Made, Own)}


OURS, THEIRS = _classes(frozen), _classes(slotted)
CALLS: tuple[tuple[str, tuple[object, ...], dict[str, object]], ...] = (
    ("Empty", (), {}),
    ("One", (float("inf"),), {}),
    ("One", (), {"x": "a"}),
    ("Point", (1,), {}),
    ("Point", (1, 2), {}),
    ("Point", (), {"y": 1, "x": 2}),
    ("Space", (1, 2, 3), {}),
    ("Space", (1,), {"z": 3, "note": "n"}),
    ("Five", (1, 2, 3), {}),
    ("Five", (1, 2), {"e": 6, "c": 3}),
    ("Made", (1,), {}),
    ("Made", (1, {"a": 2}), {}),
    ("Own", (1,), {}),
)
REFUSED: tuple[tuple[str, tuple[object, ...], dict[str, object]], ...] = (
    ("Empty", (1,), {}),
    ("One", (), {}),
    ("One", (1, 2), {}),
    ("Point", (1,), {"x": 2}),
    ("Point", (1,), {"w": 2}),
    ("Five", (1, 2), {}),
    ("Five", (1, 2, 3, 4, 5, 6), {}),
    ("Five", (1, 2, 3), {"a": 2}),
    ("Five", (1, 2, 3), {"w": 2}),
    ("Made", (), {"late": 1}),
)


@row_by_row(("name", "values", "named"), CALLS)
def test_it_holds_and_says_what_a_dataclass_does(
    name: str, values: tuple[object, ...], named: dict[str, object]
) -> None:
    """Its values, its look, what `replace` and a copy make of it, and what is alike."""
    ours, theirs = OURS[name](*values, **named), THEIRS[name](*values, **named)
    assert is_dataclass(ours)
    assert [each.name for each in fields(ours)] == [each.name for each in fields(theirs)]
    for each in fields(ours):
        assert getattr(ours, each.name) == getattr(theirs, each.name)
    assert repr(ours) == repr(theirs)
    assert ours == OURS[name](*values, **named) == copy.copy(ours) == copy.deepcopy(ours) == replace(ours)
    assert ours != theirs or name == "Own"
    assert not hasattr(ours, "__dict__")


@row_by_row(("name", "values", "named"), REFUSED)
@row_by_row("classes", [OURS, THEIRS])
def test_what_is_given_wrongly_is_refused(
    classes: dict[str, Any], name: str, values: tuple[object, ...], named: dict[str, object]
) -> None:
    """One too many, one missing, one twice, one that is none; the message names the class."""
    with pytest.raises(TypeError, match=rf"\b{name}\.__init__\(\) |{name}\(\) takes"):
        classes[name](*values, **named)


@pytest.mark.parametrize("name", [name for name in OURS if name != "Made"])
def test_it_is_taken_apart_and_documented_like_a_dataclass(name: str) -> None:
    """`match`, `help` and the readers of annotations see the same."""
    assert OURS[name].__match_args__ == THEIRS[name].__match_args__
    ours, theirs = inspect.signature(OURS[name]), inspect.signature(THEIRS[name])
    assert [(each.name, each.default) for each in ours.parameters.values()] == [
        (each.name, each.default) for each in theirs.parameters.values()
    ]


def test_what_is_made_anew_each_time_can_be_left_out_by_the_signature() -> None:
    """Behind it stands a field with a default, which could not follow one without."""
    ours, theirs = (
        [(each.name, each.default is each.empty) for each in inspect.signature(made["Made"]).parameters.values()]
        for made in (OURS, THEIRS)
    )
    assert ours == theirs


@pytest.mark.parametrize("name", dhcli.__all__)
def test_no_signature_of_the_library_tells_where_something_lies_in_memory(name: str) -> None:
    """A default that says so would be another in each process."""
    if callable(thing := getattr(dhcli, name)):
        assert " at 0x" not in str(inspect.signature(thing))


@row_by_row(("name", "values", "named"), CALLS)
def test_a_field_stays_what_it_is(name: str, values: tuple[object, ...], named: dict[str, object]) -> None:
    """Nor does one come that is none."""
    value = OURS[name](*values, **named)
    for each in (*fields(value), *fields(OURS["One"])):
        with pytest.raises(FrozenInstanceError):
            setattr(value, each.name, 1)
        with pytest.raises(FrozenInstanceError):
            delattr(value, each.name)


@given(st.tuples(st.integers(0, 1), st.integers(0, 1), st.integers(0, 1)), st.tuples(*[st.integers(0, 1)] * 3))
def test_two_are_equal_as_two_dataclasses_are(one: tuple[int, ...], other: tuple[int, ...]) -> None:
    """What is not compared does not tell them apart, and equal ones have one hash."""
    ours = OURS["Space"](*one), OURS["Space"](*other)
    theirs = THEIRS["Space"](*one), THEIRS["Space"](*other)
    assert (ours[0] == ours[1]) == (theirs[0] == theirs[1])
    assert (hash(ours[0]) == hash(ours[1])) == (hash(theirs[0]) == hash(theirs[1]))


@frozen
class Kept:
    """One that pickle can find."""

    x: int
    y: tuple[int, ...] = ()


def test_it_goes_to_another_process_and_back() -> None:
    """Its slots are set past the lock."""
    assert pickle.loads(pickle.dumps(Kept(1, (2,)))) == Kept(1, (2,))  # noqa: S301


def test_it_is_printed_prettily_however_long_it_is() -> None:
    """`pprint` asks a dataclass that needs more than a line how it was made."""
    long = Kept(1, tuple(range(60)))
    assert pprint.pformat({"kept": long}).startswith("{'kept': ")
    assert pprint.pformat(inverse(load_robot("puma560"), [0.4, 0.1, 0.3], task="position")).count("elbow") > 1
    with pytest.raises(TypeError, match="cannot inherit non-frozen dataclass"):
        dataclass(type("Heir", (Kept,), {"__annotations__": {"z": int}, "z": 1}))


def test_what_it_works_out_is_kept() -> None:
    """Once for each, told apart by nothing, and not sent along; an heir has one place for what it keeps."""
    worked = []

    @frozen
    class Sum:
        x: int
        y: int

        @cached_property
        def total(self) -> int:
            worked.append(self)
            return self.x + self.y

    @frozen
    class Named(Sum):
        name: str = "a"

        @cached_property
        def twice(self) -> int:
            return 2 * self.total

    for made in (Sum(1, 2), Named(1, 2)):
        other = replace(made)
        assert made.total == made.total == 3
        assert made == other == copy.copy(made)
        assert not vars(copy.copy(made))
        with pytest.raises(FrozenInstanceError):
            made.x = 2  # type: ignore[misc]
    assert Named(1, 2).twice == 6
    assert len(worked) == 3


def test_an_heir_finishes_in_its_own_way() -> None:
    """`__post_init__` of a class that is not frozen itself, but its base is."""
    for classes in (OURS, THEIRS):

        class Checked(classes["Made"]):  # type: ignore[misc]
            def __post_init__(self) -> None:
                super().__post_init__()
                object.__setattr__(self, "late", (*self.late, self.shared, *self.every))

        assert Checked(1).late == ("of", 1, 3, "a")


def test_a_dataclass_inherits_from_it() -> None:
    """Its fields come first, by position, as those of a dataclass do."""
    for classes in (OURS, THEIRS):

        @dataclass(frozen=True, slots=True)
        class Heir(classes["Point"]):  # type: ignore[misc]
            z: object = 3

        assert repr(Heir(1, 2)).endswith("Heir(x=1, y=2, z=3)")
        assert Heir(1, y=2) == replace(Heir(1), y=2)
        assert [each.kw_only for each in fields(Heir)] == [False] * 3


def test_a_default_that_can_be_changed_is_refused() -> None:
    """It would be changed for all."""
    for make in (frozen, slotted):
        with pytest.raises(ValueError, match="default_factory"):

            @make
            class Shared:
                x: list[int] = []  # noqa: RUF012  what is refused


def test_it_is_replaced_by_copy_where_python_can() -> None:
    """`copy.replace` came with Python 3.13."""
    assert Kept(1).__replace__(x=2) == Kept(2)  # type: ignore[attr-defined]
    assert "class C" not in pydoc.plain(pydoc.render_doc(Kept))  # which is the example of `dataclasses.replace`
    if hasattr(copy, "replace"):
        assert copy.replace(Kept(1), x=2) == Kept(2)
