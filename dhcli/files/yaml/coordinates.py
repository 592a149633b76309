"""Numbers, points and directions of linkage files: expressions over the names that `let:` gives."""

from __future__ import annotations

import math
from itertools import islice

from dhcli.algebra.floats import Floats
from dhcli.errors import NotationError, did_you_mean
from dhcli.files.yaml.fields import Fields, Problems
from dhcli.files.yaml.placed import PlacedNode, PlacedScalar
from dhcli.files.yaml.typed import parsed
from dhcli.geometry.vectors import ALONG, Vector, axis_called
from dhcli.notation.angle import FULL_TURN_IN_RADIANS, Angle
from dhcli.notation.quantity import ANGLE_UNITS, DimensionError, to_angle, to_length
from dhcli.notation.scope import Scope
from dhcli.notation.tree import Expr, Trig, Unit
from dhcli.notation.walk import symbols, walk
from dhcli.regex import regex

MOST_NAMES = 1_000
"""Names under `let:`; each is read with all before it in view."""

_BETWEEN = regex(r"\s*([^\s>→-]{1,99})\s{0,9}(?:-{1,9}>?|→|,)?\s{0,9}([^\s>→-]{1,99})\s*")
_FROM_TO = regex(r"\s*(\S+)\s+to\s+(\S+)\s*")


class Coordinates:
    """Reads what stands in a linkage file in numbers; what is wrong is noted, and 0 taken in its place."""

    def __init__(self, problems: Problems, let: Fields, points: Fields, *, planar: bool) -> None:
        """Read the names, then the points.

        Args:
            problems: Where to note what is wrong.
            let: Names with their expressions, each of which may use those before it.
            points: Points by name.
            planar: Whether two coordinates are enough.
        """
        self.problems = problems
        self.values: dict[str, Angle | float] = {}
        self.dimensions = 2 if planar else 3
        self._scope: Scope | None = None
        for name in islice(let.entries, MOST_NAMES):
            if (scalar := let.scalar(name)) is not None:
                self.values[name] = self.value(scalar, name)
                self._scope = None
        if len(let.entries) > MOST_NAMES:
            surplus = let.place_of(next(islice(let.entries, MOST_NAMES, None)))
            problems.add(surplus, f"let: more than {MOST_NAMES:,} names are not read", "is it the right file?")
        self.points: dict[str, Vector] = {}
        for name, (_, node) in points.entries.items():
            self.points[name] = self._coordinates(node, name)

    @property
    def scope(self) -> Scope:
        """The names known so far."""
        if self._scope is None:
            angles = [name for name, value in self.values.items() if isinstance(value, Angle)]
            lengths = [name for name, value in self.values.items() if not isinstance(value, Angle)]
            self._scope = Scope(angles=tuple(angles), lengths=tuple(lengths))
        return self._scope

    def value(self, scalar: PlacedScalar, key: str) -> Angle | float:
        """An angle, exact if it can be, or a length in metres."""
        expr = self._expression(scalar)
        if expr is None:
            return 0.0
        named = symbols(expr)
        has_unit = any(isinstance(node, Unit) and node.name in ANGLE_UNITS for node in walk(expr))
        if has_unit or (named and all(isinstance(self.values.get(name), Angle) for name in named)):
            try:
                return to_angle(expr, bare="refuse").substitute(self.values)
            except DimensionError as error:
                if has_unit:
                    self.problems.add(scalar.place, f"{key}: {error.message}", error.hint)
                    return 0.0
        return self._number(expr, scalar, key)  # also an angle that is no sum, in radians: 2*atan(1/tan(theta1/2))

    def number(self, scalar: PlacedScalar, key: str) -> float:
        """A length in metres, or a plain number."""
        expr = self._expression(scalar)
        return 0.0 if expr is None else self._number(expr, scalar, key)

    def point(self, node: PlacedNode, key: str) -> Vector:
        """A point by name or by its coordinates."""
        if not isinstance(node, PlacedScalar) or node.text.startswith("("):
            return self._coordinates(node, key)
        if node.text in self.points:
            return self.points[node.text]
        hint = did_you_mean(node.text, self.points) or "write [x, y, z], or name it under points:"
        self.problems.add(node.place, f"{key}: there is no point called {node.text}", hint)
        return (0.0, 0.0, 0.0)

    def direction(self, node: PlacedNode, key: str) -> Vector:
        """A direction: `x`, `-z`, `A to B`, or its components."""
        if not isinstance(node, PlacedScalar) or node.text.startswith("("):
            return self._coordinates(node, key)
        if axis := axis_called(node.text):
            return axis
        if match := _FROM_TO.fullmatch(node.text):
            ends = [self.point(PlacedScalar(name, node.place), key) for name in match.groups()]
            return ends[1][0] - ends[0][0], ends[1][1] - ends[0][1], ends[1][2] - ends[0][2]
        between = _BETWEEN.fullmatch(node.text)
        hint = "write x, -y, [1, 0, 1], or A to B"
        if axis_called(node.text.lower()):
            hint = f"write {node.text.lower()}"
        elif between and {*between.groups()} <= self.points.keys():
            hint = f"write {between[1]} to {between[2]}"
        self.problems.add(node.place, f"{key}: '{node.text}' is no direction", hint)
        return ALONG["z"]

    def _coordinates(self, node: PlacedNode, key: str) -> Vector:
        example = "[x, y]" if self.dimensions < len(ALONG) else "[x, y, z]"
        is_round = isinstance(node, PlacedScalar) and node.text.startswith("(")
        items = self.problems.sequence(node, key, "" if is_round else example, count=self.dimensions)
        if items and not self.dimensions <= len(items) <= len(ALONG):
            wanted = "two coordinates" if self.dimensions < len(ALONG) else "three coordinates"
            hint = "write [x, y]" if self.dimensions < len(ALONG) else "write [x, y, z]"
            self.problems.add(node.place, f"{key}: {wanted} are wanted, not {len(items)}", hint)
            return (0.0, 0.0, 0.0)
        found = [self.number(scalar, key) for item in items if (scalar := self.problems.scalar(item, key)) is not None]
        padded = (*found, 0.0, 0.0, 0.0)
        return padded[0], padded[1], padded[2]

    def _expression(self, scalar: PlacedScalar) -> Expr | None:
        try:
            expr = parsed(scalar, self.scope)
        except NotationError as error:
            self.problems.take(error)
            return None
        turning = (name for node in walk(expr) if isinstance(node, Trig) for name in sorted(node.angle.names))
        for name in dict.fromkeys(turning):
            if isinstance(value := self.values.get(name), float) and abs(value) > FULL_TURN_IN_RADIANS:
                message = f"{name} is {value:g} without a unit, and stands in a cosine or sine"
                self.problems.add(scalar.place, message, f"write {name}: {value:g}°")
        return expr

    def _number(self, expr: Expr, scalar: PlacedScalar, key: str) -> float:
        try:
            value = Floats(self.values).value(to_length(expr))
        except DimensionError as error:
            self.problems.add(scalar.place, f"{key}: {error.message}", error.hint)
            return 0.0
        except (KeyError, OverflowError, ZeroDivisionError):
            value = math.nan
        if not math.isfinite(value):
            self.problems.add(
                scalar.place,
                f"{key}: {scalar.text} is not a number",
                "a root of a negative number, or a division by zero?",
            )
            return 0.0
        return value
