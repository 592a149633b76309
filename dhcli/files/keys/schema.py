"""A JSON schema for each kind of file, for editors that complete keys and mark mistakes; draft 2020-12.

An editor sees values as YAML does: `90°` is a text, `0` a number, `true` neither. What only dhcli can tell, such as
whether a name is a joint, is left to `dhcli lint`.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, TypeAlias

from dhcli.errors import UnknownNameError, did_you_mean
from dhcli.files.keys.robots import ROBOTS
from dhcli.files.keys.shapes import FLAGS, Either, Key, Keyed, Many, Named, Scalar, Shape, required

if TYPE_CHECKING:
    from collections.abc import Callable

Schema: TypeAlias = dict[str, Any]

FORMAT = Key("format", "the format of the file, always 1", Scalar(pattern="1"), is_required=True)
_ANY = ["string", "number", "boolean"]
_OWN = {"^x-": True}


def schema_of(kind: str) -> Schema:
    """The schema of a kind of file.

    Args:
        kind: robot, exercise or linkage.

    Raises:
        UnknownNameError: There is no such kind.
    """
    made = _KINDS.get(kind)
    if made is None:
        raise UnknownNameError(f"there is no schema of {kind}", did_you_mean(kind, _KINDS))
    head = {"$schema": "https://json-schema.org/draft/2020-12/schema", "title": f"A {kind} file of dhcli"}
    return {**head, **made()}


def _robot() -> Schema:
    every = {key.name: key for keys in ROBOTS.values() for key in keys}
    found = _object([FORMAT, *every.values()])
    found["required"] = ["format", *(name for name in every if all(name in required(keys) for keys in ROBOTS.values()))]
    found["properties"]["links"] = _described(every["links"], {"type": "array"})
    found["allOf"] = [_where(convention, keys, every) for convention, keys in ROBOTS.items()]
    return found


def _where(convention: str, keys: Sequence[Key], every: Iterable[str]) -> Schema:
    """What holds for robots of one convention."""
    own = {key.name: key for key in keys}
    properties = {name: _schema(own[name].holds) if name in own else False for name in every}
    different = {name: schema for name, schema in properties.items() if schema is False or name == "links"}
    said = {"properties": {"convention": {"const": convention}}, "required": ["convention"]}
    return {"if": said, "then": {"properties": different, "required": list(required(keys))}}


def _exercise() -> Schema:
    from dhcli.files.keys.exercises import EXERCISE  # questions of all kinds

    return _object([FORMAT, *EXERCISE])


def _linkage() -> Schema:
    from dhcli.files.keys.linkages import FORMS, LINKAGE

    one_of = [("space", "lambda"), FORMS]
    every = [{"oneOf": [{"required": [name]} for name in names]} for names in one_of]
    return {**_object([FORMAT, *LINKAGE]), "allOf": every}


_KINDS: Mapping[str, Callable[[], Schema]] = {"robot": _robot, "exercise": _exercise, "linkage": _linkage}
KINDS = tuple(_KINDS)


def _object(keys: Iterable[Key]) -> Schema:
    keys = tuple(keys)
    return {
        "type": "object",
        "properties": {key.name: _described(key, _schema(key.holds)) for key in keys},
        "patternProperties": _OWN,
        "required": list(required(keys)),
        "additionalProperties": False,
    }


def _described(key: Key, schema: Schema) -> Schema:
    """A schema with what an editor shows beside it."""
    example = f" Example: {key.example}" if key.example else ""
    return {"description": f"{_sentence(key.means)}{example}", **schema}


def _sentence(means: str) -> str:
    plain = means.replace("`", "")
    return f"{plain[:1].upper()}{plain[1:]}."


def _schema(shape: Shape) -> Schema:
    match shape:
        case Scalar():
            return _scalar(shape)
        case Many(of, least, most):
            found: Schema = {"type": "array", "items": _schema(of)}
            return found | ({"minItems": least} if least else {}) | ({"maxItems": most} if most else {})
        case Named(of):
            return {"type": "object", "additionalProperties": _schema(of)}
        case Keyed(keys):
            return _object(keys)
        case Either(of):
            return {"anyOf": [_schema(each) for each in of]}


def _scalar(shape: Scalar) -> Schema:
    if shape.words:
        logical = [FLAGS[word] for word in shape.words if word in FLAGS]
        return {"enum": [*shape.words, *dict.fromkeys(logical)]}
    if shape.pattern:
        numbers = [number for number in range(1000) if re.fullmatch(shape.pattern, str(number))]
        whole = {"type": "integer", "minimum": numbers[0], "maximum": numbers[-1]}
        return {"anyOf": [whole, {"type": "string", "pattern": f"^(?:{shape.pattern})$"}]}
    if shape.is_angle:
        return {"anyOf": [{"type": "string"}, {"const": 0, "description": "an angle has a unit: 90°, 1.57 rad"}]}
    return {"type": [*_ANY, *(["null"] if shape.may_be_empty else [])]}
