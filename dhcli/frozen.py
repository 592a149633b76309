"""Frozen dataclasses with slots that cost the start of a command little.

`dataclasses` writes a program of six functions for each class and compiles it, half a millisecond a class, and a
command imports a hundred. A class that is `frozen` is one of its dataclasses to everyone who asks (`fields`, `replace`,
pattern matching), with the same six functions as closures over the names of the fields: nothing is compiled.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import _FIELD, MISSING, Field, FrozenInstanceError, field, fields, replace  # type: ignore[attr-defined]
from functools import cached_property
from operator import attrgetter
from types import SimpleNamespace
from typing import TYPE_CHECKING, Any, TypeVar, cast, dataclass_transform

from dhcli.inits import init_of

if TYPE_CHECKING:
    from inspect import Signature

_PARAMS = SimpleNamespace(
    init=True,
    repr=True,
    eq=True,
    order=False,
    unsafe_hash=False,
    frozen=True,
    match_args=True,
    kw_only=False,
    slots=True,
    weakref_slot=False,
)
"""What `dataclasses`, `pprint` and pytest ask of how a class was made."""

T = TypeVar("T")
K = TypeVar("K")
V = TypeVar("V")


class FrozenDict(dict[K, V]):
    """A `dict` that nobody changes, so that it has a hash; copied, and sent to other processes, as one."""

    __slots__ = ()

    def __hash__(self) -> int:  # type: ignore[override]  # a dict has none
        return hash(frozenset(self.items()))

    def __reduce__(self) -> tuple[type, tuple[dict[K, V]]]:
        return type(self), (dict(self),)

    def _refuse(self, *_: object, **__: object) -> Any:  # noqa: ANN401  whatever each of them gives
        raise TypeError("this mapping cannot be changed: dict(...) makes one of it that can")

    __setitem__ = __delitem__ = __ior__ = clear = pop = popitem = setdefault = update = _refuse


@dataclass_transform(frozen_default=True, field_specifiers=(field,))
def frozen(cls: type[T]) -> type[T]:
    """Make a class what `dataclass(frozen=True, slots=True)` makes of it.

    One with a `cached_property` has a place to keep what it found. A `__repr__` that the class or a base of it writes
    stays, and its own `__eq__` and `__hash__`. A `dataclass` may inherit from it.
    """
    own = {name: _field(cls, name, kind) for name, kind in cls.__annotations__.items() if "ClassVar" not in str(kind)}
    found: dict[str, Field[Any]] = {}
    for base in cls.__mro__[:0:-1]:
        found |= base.__dict__.get("__dataclass_fields__", {})
    slots = [name for name in own if name not in found]
    found |= own
    # Only a new class can have slots; what is in it from the beginning costs less than what is put there later.
    replaced = {*own, "__dict__", "__weakref__"}
    body = {name: value for name, value in cls.__dict__.items() if name not in replaced} | _BODY
    if any(isinstance(value, cached_property) for value in body.values()):
        slots += () if cast("type", cls.__base__).__dictoffset__ else ("__dict__",)
    body |= {"__qualname__": cls.__qualname__, "__slots__": tuple(slots), "__dataclass_fields__": found}
    body["__match_args__"] = tuple(each.name for each in found.values() if each.init)
    if cls.__repr__ is object.__repr__:
        body["__repr__"] = _repr
    if "__eq__" not in cls.__dict__:
        body["__eq__"] = _eq(_values_of([each.name for each in found.values() if each.compare]))
        if "__hash__" not in cls.__dict__:
            hashed = [each.name for each in found.values() if (each.compare if each.hash is None else each.hash)]
            body["__hash__"] = _hash(_values_of(hashed))
    made: type[T] = cast("Any", type(cls))(cls.__name__, cls.__bases__, body)
    made.__init__ = init_of(made, tuple(found.values()))  # type: ignore[method-assign]  # it puts values into the slots
    return made


def _field(cls: type, name: str, kind: object) -> Field[Any]:
    """A field from its annotation and what is written after it.

    What marks it as one is private to `dataclasses`. A copy of a field of a class that was compiled has the mark too,
    but takes six times as long, and with that class 1.6 ms of a start.

    Raises:
        ValueError: Its default can be changed, and would be changed for all.
    """
    default = cls.__dict__.get(name, MISSING)
    if default.__class__.__hash__ is None:
        raise ValueError(f"{cls.__qualname__}.{name}: a default that can be changed is for default_factory")
    each: Field[Any] = default if isinstance(default, Field) else field(default=default)
    each.name, each.type, each._field_type = name, kind, _FIELD  # type: ignore[attr-defined]  # noqa: SLF001
    each.kw_only = False
    return each


def _fields(of: object) -> tuple[Field[Any], ...]:
    return fields(of)  # type: ignore[arg-type]


def _values_of(names: Sequence[str]) -> Callable[[object], tuple[object, ...]]:
    """What gives some attributes of an object as a tuple."""
    if not names:
        return lambda _: ()
    values = attrgetter(*names)
    return values if len(names) > 1 else lambda self: (values(self),)


def _eq(key: Callable[[object], tuple[object, ...]]) -> Callable[[object, object], bool]:
    def __eq__(self: object, other: object) -> bool:  # noqa: N807
        return key(self) == key(other) if other.__class__ is self.__class__ else NotImplemented

    return __eq__


def _hash(key: Callable[[object], tuple[object, ...]]) -> Callable[[object], int]:
    def __hash__(self: object) -> int:  # noqa: N807
        return hash(key(self))

    return __hash__


def _repr(self: object) -> str:
    shown = ", ".join(f"{each.name}={getattr(self, each.name)!r}" for each in _fields(self) if each.repr)
    return f"{type(self).__qualname__}({shown})"


def _setattr(_self: object, name: str, _value: object) -> None:
    raise FrozenInstanceError(f"cannot assign to field {name!r}")


def _delattr(_self: object, name: str) -> None:
    raise FrozenInstanceError(f"cannot delete field {name!r}")


def _getstate(self: Any) -> list[object]:  # noqa: ANN401  one of whatever class is made here
    return [getattr(self, name) for name in self.__dataclass_fields__]


def _setstate(self: Any, state: Iterable[object]) -> None:  # noqa: ANN401  the same
    for name, value in zip(self.__dataclass_fields__, state, strict=True):
        object.__setattr__(self, name, value)


def _replace(self: Any, /, **changes: object) -> object:  # noqa: ANN401  the same; `help` shows what stands here
    return replace(self, **changes)


class _Signature:
    """What `help` shows in the brackets of a class, put together when someone asks."""

    def __get__(self, instance: object, owner: type) -> Signature:
        from inspect import Parameter, Signature

        return Signature(
            [
                Parameter(
                    each.name,
                    Parameter.POSITIONAL_OR_KEYWORD,
                    default=next(
                        (d for d in (each.default, each.default_factory) if d is not MISSING), Parameter.empty
                    ),
                    annotation=each.type,
                )
                for each in _fields(owner)
                if each.init
            ]
        )


_BODY: dict[str, object] = {
    "__dataclass_params__": _PARAMS,
    "__setattr__": _setattr,
    "__delattr__": _delattr,
    "__getstate__": _getstate,
    "__setstate__": _setstate,
    "__signature__": _Signature(),
    "__replace__": _replace,
}
"""What every class has that is made here."""
