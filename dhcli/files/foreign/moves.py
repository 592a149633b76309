"""Poses as the Robotics Toolbox writes them, `transl(0, 0, 0.1) * trotz(pi/4)`, as moves."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhcli.errors import Place, Problem
from dhcli.files.foreign.rows import Cell, Reader
from dhcli.files.foreign.statements import closing, elements, split, unbracketed
from dhcli.kinematics.moves import Chain, Fixed, Move, Rot, Trans, along
from dhcli.notation.factors import AXES, Axis
from dhcli.notation.tree import Expr
from dhcli.regex import regex

if TYPE_CHECKING:
    from collections.abc import Sequence

_TURN = regex(r"(?:t?rot|SE3\.R)(?P<axis>[xyz])")
_SLIDE = regex(r"SE3\.T(?P<axis>[xyz])")
_SHIFTS = ("transl", "SE3", "SE3.Trans")
_NOTHING = ("eye", "SE3", "SE3.identity")
_DEGREES = ("'deg'", '"deg"', "unit='deg'", 'unit="deg"')


def chain_of(reader: Reader, text: str, what: str, place: Place, units: str) -> Chain:
    """The moves of a base or a tool."""
    found: list[Move] = []
    for factor in split(text, "*@"):
        move = _move(reader, factor, Cell("", place, units), what)
        if move is None:
            hint = f"delete it, and write {what}: Trans(0, 0, 0.1) into the robot file"
            reader.problems.append(Problem(f"{what}: {factor!r:.60} is not read", place, hint))
        else:
            found += move
    return tuple(found)


def _move(reader: Reader, factor: str, blank: Cell, what: str) -> Chain | None:
    """One factor; None if it is none that is known."""
    start = factor.find("(")
    if factor.startswith("["):
        return _matrix(reader, factor, blank, what)
    if start < 0 or closing(factor, start) != len(factor) - 1:
        return None
    name, args = factor[:start].strip(), split(factor[start + 1 : -1])
    lengths = elements(unbracketed(args[0])) if len(args) == 1 else args
    if turn := _TURN.fullmatch(name):
        unit = "deg" if any(arg.replace(" ", "") in _DEGREES for arg in args[1:]) else "rad"
        angle = reader.angle(Cell(args[0] if args else "0", blank.place, unit), what)
        return (Rot(_axis(turn["axis"]), angle),)
    if (slide := _SLIDE.fullmatch(name)) and len(args) == 1:
        return (along(_axis(slide["axis"]), _length(reader, args[0], blank, what)),)
    if name in _SHIFTS and len(lengths) == len(AXES):
        x, y, z = (_length(reader, text, blank, what) for text in lengths)
        return (Trans(x, y, z),)
    return () if name in _NOTHING and args in ([], ["4"]) else None


def _matrix(reader: Reader, factor: str, blank: Cell, what: str) -> Chain | None:
    rows = [elements(unbracketed(row)) for row in split(unbracketed(factor), ";\n" if ";" in factor else ",")]
    if [len(row) for row in rows] != [4] * 4:
        return None
    plain = Cell("", blank.place)
    fixed = [_row(reader, row, (plain, blank), what) for row in rows[:3]]
    return (Fixed((fixed[0], fixed[1], fixed[2])),)


def _row(reader: Reader, row: Sequence[str], cells: tuple[Cell, Cell], what: str) -> tuple[Expr, Expr, Expr, Expr]:
    """Three direction cosines and a length."""
    plain, blank = cells
    a, b, c = (_length(reader, text, plain, what) for text in row[:3])
    return a, b, c, _length(reader, row[3], blank, what)


def _length(reader: Reader, text: str, blank: Cell, what: str) -> Expr:
    return reader.length(Cell(text, blank.place, blank.unit), what)


def _axis(letter: str) -> Axis:
    return AXES["xyz".index(letter)]
