"""The four course documents as `tests/data/truth.json` and `errata.json` record them, in dhcli's own terms.

An item says how its matrix is computed (`compute`) and what comes out (`expected`); nothing here knows the answer.
"""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from dhcli.algebra.arithmetic import Arithmetic
from dhcli.kinematics.conventions import Convention, Row, moves_of
from dhcli.kinematics.fold import fold
from dhcli.kinematics.merge import merge
from dhcli.kinematics.moves import Chain, Fixed, Rot, Trans, inverse
from dhcli.notation.angle import Angle
from dhcli.notation.parser import parse
from dhcli.notation.quantity import to_angle
from dhcli.notation.tree import Expr, Power, Product, Sum, negate, number, split
from dhcli.notation.walk import operations
from dhcli.notation.writer import write

_DATA = Path(__file__).parent.parent / "data"

Item = dict[str, Any]
Matrix = tuple[tuple[Expr, ...], ...]

TRUTH: dict[str, Item] = {item["id"]: item for item in json.loads((_DATA / "truth.json").read_text("utf-8"))}
"""Every item of the documents by its id, such as W18."""

ERRATA: dict[int, dict[str, Any]] = {
    erratum["n"]: erratum for erratum in json.loads((_DATA / "errata.json").read_text("utf-8"))
}
"""Every discrepancy by its number."""

EQUATIONS = {name: item for name, item in TRUTH.items() if "expected" in item}
"""The items whose answer is a matrix or a column."""

MISPRINTS = {n: erratum for n, erratum in ERRATA.items() if erratum["cls"] == "M"}
"""The mathematical misprints."""

CELLS = {
    **{f"r{i}{j}": (i - 1, j - 1) for i in (1, 2, 3) for j in (1, 2, 3)},
    **{f"p{axis}": (i, 3) for i, axis in enumerate("xyz")},
}
"""Where the entries stand that the documents print one by one."""


def read(text: str) -> Expr:
    """An expression of the truth; its Python names are given back their subscripts."""
    return parse(text.replace("_im1", "_{i-1}"))


def angle(text: str) -> Angle:
    """An angle of the truth."""
    return to_angle(read(text))


def matrix(texts: Sequence[Sequence[str]]) -> Matrix:
    """A matrix of the truth."""
    return tuple(tuple(read(text) for text in row) for row in texts)


def row(entries: dict[str, str]) -> Row:
    """A row of a DH table of the truth."""
    return Row(read(entries["a"]), angle(entries["alpha"]), read(entries["d"]), angle(entries["theta"]))


def chain(compute: dict[str, Any]) -> Chain:
    """The moves that an item tells to multiply."""
    match compute["op"]:
        case "dh":
            convention = Convention(compute["convention"])
            return tuple(move for entries in compute["rows"] for move in moves_of(row(entries), convention))
        case "chain":
            return tuple(_factor(factor) for factor in compute["factors"])
        case "inverse":
            return inverse(chain(compute["T"]))
        case "axes":
            x, y, z, p = (compute[key] for key in "xyzp")
            return (Fixed(tuple(tuple(map(number, entries)) for entries in zip(x, y, z, p, strict=True))),)  # type: ignore[arg-type]
        case "column":
            return (_point(compute["point"]),)
        case "apply":
            return (*chain(compute["T"]), _point(compute["point"]))
    raise AssertionError(compute)


def typed(compute: dict[str, Any]) -> str:
    """The same product as a person would type it; for the operation `chain`."""
    texts = []
    for kind, *rest in compute["factors"]:
        if kind == "Mat":
            texts.append("[" + "; ".join(", ".join(entries) for entries in rest[0]) + "]")
        else:
            texts.append(f"{kind}({', '.join(rest)})")
    return " ".join(texts).replace("_im1", "_{i-1}")


def entries_of(compute: dict[str, Any], pose: Matrix) -> Matrix:
    """What an item asks for of a pose: the matrix, a point as a column of four, or its three coordinates."""
    if compute["op"] not in ("column", "apply"):
        return pose
    column = tuple((entries[3],) for entries in pose)
    return column[:3] if compute.get("cartesian") else column


def computed(item: Item) -> Matrix:
    """What dhcli computes for an item, in textbook form."""
    from dhcli.algebra.terms import TERMS

    return entries_of(item["compute"], fold(merge(chain(item["compute"])), TERMS))


def computed_over(item: Item, over: Arithmetic[Any]) -> tuple[tuple[Any, ...], ...]:
    """What dhcli computes for an item in another arithmetic."""
    return entries_of(item["compute"], fold(chain(item["compute"]), over))


def tree(expr: Expr) -> object:
    """An expression up to the order of terms and factors and the signs of brackets; nothing is expanded."""
    if isinstance(expr, Sum):
        return ("sum", *sorted((tree(term) for term in expr.terms), key=repr))
    factor, rest = split(expr)
    sign = -1 if factor.value < 0 else 1
    factors: list[object] = []
    for node in rest.factors if isinstance(rest, Product) else (rest,):
        if isinstance(node, Sum):
            one, other = tree(node), tree(negate(node))
            if repr(other) < repr(one):
                one, sign = other, -sign
            factors.append(one)
        else:
            assert not isinstance(node, Power), "no document prints one"
            factors.append(write(node, "full"))
    return ("product", sign * abs(factor.value), *sorted(factors, key=repr))


def count(entries: Matrix) -> int:
    """Operations in all entries of a matrix; nothing is shared between them."""
    return sum(operations(entry) for line in entries for entry in line)


def _factor(factor: Sequence[Any]) -> Rot | Trans | Fixed:
    kind, *rest = factor
    if kind == "Rot":
        return Rot(rest[0], angle(rest[1]))
    if kind == "Trans":
        return _point(rest)
    assert [str(entry) for entry in rest[0][3]] == ["0", "0", "0", "1"]
    return Fixed(matrix(rest[0][:3]))  # type: ignore[arg-type]


def _point(texts: Sequence[str]) -> Trans:
    x, y, z = map(read, texts)
    return Trans(x, y, z)
