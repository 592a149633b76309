"""The `__init__` of a frozen dataclass, as a closure over what sets its fields: nothing is compiled."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import MISSING, Field
from operator import methodcaller
from types import FunctionType
from typing import Any, TypeAlias, cast

_Put: TypeAlias = Callable[[object, object], None]


def init_of(cls: type, found: Sequence[Field[Any]]) -> Callable[..., None]:
    """What takes the values of the fields, by position or by name."""
    taken = [each for each in found if each.init]
    names = tuple(each.name for each in taken)
    defaults = {each.name: each.default for each in taken if each.default is not MISSING or _is_made(each)}
    puts = [_put(cls, each) for each in taken]
    finish = _finish(cls, found)
    if 1 <= len(puts) <= len(_PLAIN):
        if finish:
            puts[-1] = _last(puts[-1], finish)
        plain = _PLAIN[len(puts) - 1](*puts)
        # The names of the parameters are data of the compiled function: this renames them, and compiles nothing.
        own = ("self", *names)
        code = plain.__code__.replace(co_varnames=own, co_name="__init__", co_qualname=f"{cls.__qualname__}.__init__")
        return FunctionType(code, plain.__globals__, "__init__", tuple(defaults.values()), plain.__closure__)
    wanted = {*names}

    def __init__(self: object, *values: object, **named: object) -> None:  # noqa: N807
        if not values and named.keys() == wanted:  # as `replace` gives them
            values = tuple(map(named.__getitem__, names))
        elif named or len(values) != len(names):
            values = _arranged(type(self).__qualname__, names, defaults, values, named)
        for put, value in zip(puts, values, strict=True):
            put(self, value)
        if finish:
            finish(self)

    return __init__


def _is_made(each: Field[Any]) -> bool:
    return each.default_factory is not MISSING


def _put(cls: type, each: Field[Any]) -> _Put:
    """What sets a field past the lock; where the value is missing, what its factory makes."""
    put: _Put = getattr(cls, each.name).__set__
    make: Any = each.default_factory

    def put_or_make(self: object, value: object) -> None:
        put(self, make() if value is MISSING else value)

    return put_or_make if _is_made(each) else put


def _finish(cls: type, found: Sequence[Field[Any]]) -> Callable[[object], object] | None:
    """What sets the fields that nobody gives, and lets the class have the last word; None if there is nothing to do."""
    made = [_put(cls, each) for each in found if not each.init and _is_made(each)]
    ends = methodcaller("__post_init__") if hasattr(cls, "__post_init__") else None  # an heir may have its own

    def finish(self: object) -> None:
        for put in made:
            put(self, MISSING)
        if ends:
            ends(self)

    return finish if made else ends


def _last(put: _Put, finish: Callable[[object], object]) -> _Put:
    """What sets the last field that is given, and finishes."""

    def put_and_finish(self: object, value: object) -> None:
        put(self, value)
        finish(self)

    return put_and_finish


def _init_1(a: _Put) -> FunctionType:
    def init(self: object, p: object) -> None:
        a(self, p)

    return cast("FunctionType", init)


def _init_2(a: _Put, b: _Put) -> FunctionType:
    def init(self: object, p: object, q: object) -> None:
        a(self, p)
        b(self, q)

    return cast("FunctionType", init)


def _init_3(a: _Put, b: _Put, c: _Put) -> FunctionType:
    def init(self: object, p: object, q: object, r: object) -> None:
        a(self, p)
        b(self, q)
        c(self, r)

    return cast("FunctionType", init)


def _init_4(a: _Put, b: _Put, c: _Put, d: _Put) -> FunctionType:
    def init(self: object, p: object, q: object, r: object, s: object) -> None:
        a(self, p)
        b(self, q)
        c(self, r)
        d(self, s)

    return cast("FunctionType", init)


def _init_5(a: _Put, b: _Put, c: _Put, d: _Put, e: _Put) -> FunctionType:
    def init(self: object, p: object, q: object, r: object, s: object, t: object) -> None:
        a(self, p)
        b(self, q)
        c(self, r)
        d(self, s)
        e(self, t)

    return cast("FunctionType", init)


def _init_6(a: _Put, b: _Put, c: _Put, d: _Put, e: _Put, f: _Put) -> FunctionType:
    def init(self: object, p: object, q: object, r: object, s: object, t: object, u: object) -> None:  # noqa: PLR0913, PLR0917
        a(self, p)
        b(self, q)
        c(self, r)
        d(self, s)
        e(self, t)
        f(self, u)

    return cast("FunctionType", init)


_PLAIN: tuple[Callable[..., FunctionType], ...] = (_init_1, _init_2, _init_3, _init_4, _init_5, _init_6)
"""What takes one value to six: most records have no more, and formulas and their tokens are made of these."""


def _arranged(
    owner: str,
    names: Sequence[str],
    defaults: Mapping[str, object],
    values: Sequence[object],
    named: dict[str, object],
) -> tuple[object, ...]:
    """The value of each field, in their order.

    Raises:
        TypeError: As Python raises it: a value too many, one missing, a name that is none.
    """
    if len(values) > len(names):
        raise TypeError(f"{owner}.__init__() takes {len(names)} values, and {len(values)} are given")
    arranged, missing = list(values), []
    for name in names[len(values) :]:
        if name in named:
            arranged.append(named.pop(name))
        elif name in defaults:
            arranged.append(defaults[name])
        else:
            missing.append(repr(name))
    if named:
        name = next(iter(named))
        said = "multiple values for argument" if name in names else "an unexpected keyword argument"
        raise TypeError(f"{owner}.__init__() got {said} {name!r}")
    if missing:
        raise TypeError(f"{owner}.__init__() is missing {', '.join(missing)}")
    return tuple(arranged)
