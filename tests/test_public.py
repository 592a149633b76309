"""What the library gives is a value: equal to what is made again, a key, copied, sent elsewhere, taken apart."""

from __future__ import annotations

import copy
import pickle
from collections.abc import Callable
from dataclasses import asdict, fields, is_dataclass, replace
from typing import Any

import numpy as np
import pytest

import dhcli
from dhcli.frozen import FrozenDict

Q = (0.1, 0.2, 0.3, 0.4, 0.5, 0.6)


def arm() -> dhcli.Robot:
    """One with limits, poses and parameters."""
    return dhcli.load_robot("puma560")


def two() -> dhcli.Robot:
    """One that is short."""
    return dhcli.load_robot("planar-2r")


def poses() -> Any:  # noqa: ANN401  an array, shape (2, 4, 4)
    """Two poses that the arm reaches."""
    return dhcli.forward_batch(arm(), [Q, Q])


MADE: dict[str, Callable[[], Any]] = {
    "DhcliError": lambda: dhcli.DhcliError("what is wrong", "what would be right"),
    "Exercise": lambda: dhcli.load_exercise("planar-two-links"),
    "Jacobian": lambda: dhcli.symbolic_jacobian(two()),
    "Mark": lambda: dhcli.check(dhcli.load_exercise("planar-two-links"), "d02", "a1*c1, a1*s1, 0"),
    "Linkage": lambda: dhcli.load_linkage("bennett"),
    "Mobility": lambda: dhcli.mobility_of(dhcli.load_linkage("bennett")),
    "Path": lambda: dhcli.follow(arm(), poses(), near=Q),
    "Picture": lambda: dhcli.draw(two()),
    "Pose": lambda: dhcli.forward(arm(), Q),
    "Rates": lambda: dhcli.joint_rates(arm(), Q, velocity=(0.1, 0, 0)),
    "Robot": arm,
    "Singularities": lambda: dhcli.singularities(two()),
    "Solutions": lambda: dhcli.inverse(arm(), dhcli.forward(arm(), Q)),
    "Sweep": lambda: dhcli.sweep(two(), {"theta1": "0..90° n 3", "theta2": "0..pi/2 n 3"}),
}
"""One of each class that the library gives, made anew each time."""

ITSELF = ("DhcliError", "Path", "Solutions")
"""Those that equal themselves alone: errors, and what holds arrays."""


def test_each_public_class_is_among_them() -> None:
    """A new one comes into the table; what a function gives stands there by its class."""
    assert {name for name in dhcli.__all__ if isinstance(getattr(dhcli, name), type)} <= MADE.keys()
    assert {name: type(make()).__name__ for name, make in MADE.items()} == {name: name for name in MADE}


@pytest.mark.parametrize("name", sorted(MADE))
def test_it_is_a_value(name: str) -> None:
    """By all that Python has for one."""
    one, other = MADE[name](), MADE[name]()
    if name in ITSELF:
        assert one == one  # noqa: PLR0124  and no other
        assert len({one, other}) == 2
    else:
        assert one == other
        assert len({one, other}) == 1
    assert repr(one) == repr(other)
    again = {"copied": copy.copy(one), "deeply": copy.deepcopy(one), "sent": pickle.loads(pickle.dumps(one))}  # noqa: S301  our own
    if is_dataclass(one) and not isinstance(one, type):
        assert asdict(one).keys() == {each.name for each in fields(one)}
        again["replaced"] = replace(one)
    for how, copied in again.items():
        assert type(copied) is type(one), how
        assert name in ITSELF or copied == one, how
        assert _parts(copied) == _parts(one), how


def _parts(one: object) -> list[str]:
    """What it holds, as text, so that arrays compare."""
    if not is_dataclass(one):
        return [repr(vars(one))]
    return [
        np.array2string(value) if isinstance(value, np.ndarray) else repr(value)
        for value in (getattr(one, each.name) for each in fields(one) if each.compare and each.repr)
        if not _is_made_of(value)
    ]


def _is_made_of(value: object) -> bool:
    """Whether a value shows where it lies in memory, which another has elsewhere."""
    return " at 0x" in repr(value)


def test_a_mapping_that_is_frozen_is_a_dict_but_for_being_changed() -> None:
    """It is a key, and whoever wants to change it makes a dict of it."""
    one = FrozenDict({"a": 1, "b": (2,)})
    assert one == {"b": (2,), "a": 1}
    assert len({one, FrozenDict({"b": (2,), "a": 1})}) == 1
    assert one | {"a": 3} == {"a": 3, "b": (2,)}
    for copied in (copy.copy(one), copy.deepcopy(one), pickle.loads(pickle.dumps(one))):  # noqa: S301  our own
        assert (type(copied), copied) == (FrozenDict, one)
    changes: list[Callable[[Any], object]] = [
        lambda d: d.__setitem__("a", 2),
        lambda d: d.__delitem__("a"),
        lambda d: d.update(a=2),
        lambda d: d.pop("a"),
        lambda d: d.popitem(),
        lambda d: d.setdefault("c", 2),
        lambda d: d.clear(),
        lambda d: d.__ior__({"a": 2}),
    ]
    for change in changes:
        with pytest.raises(TypeError, match="cannot be changed"):
            change(one)
    assert one == {"a": 1, "b": (2,)}
