"""The parameters of a robot file: values with units, formulas of other parameters, and those left open."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from dhcli.errors import NotationError, did_you_mean
from dhcli.files.yaml.fields import Fields
from dhcli.files.yaml.placed import PlacedScalar
from dhcli.files.yaml.reader import Reader
from dhcli.files.yaml.typed import has_unit_of_angle, taken_exactly
from dhcli.kinematics.derived import Formula, circle, value_of
from dhcli.kinematics.robot import Value
from dhcli.notation.angle import Angle
from dhcli.notation.parser import parse
from dhcli.notation.quantity import DimensionError, has_angle_unit, with_unit
from dhcli.notation.scope import Scope
from dhcli.notation.walk import symbols


class Parameters:
    """Reads the mapping `parameters`.

    Attributes:
        formulas: Those that follow from others.
    """

    def __init__(self, fields: Fields, reader: Reader) -> None:
        """Read from the fields of a file.

        Args:
            fields: The mapping.
            reader: Reads what stands in it.
        """
        self.problems = fields.problems
        self.fields = fields
        self.reader = reader
        self.formulas: dict[str, Formula] = {}
        self._names = tuple(fields.entries)
        self._unknown: set[str] = set()

    def read(self, is_angle: Callable[[str], bool | None]) -> dict[str, Value | None]:
        """The value of each parameter; None where the file leaves it, or what it follows from, open.

        Args:
            is_angle: Whether a parameter is an angle by where it stands in the table; None if it stands nowhere.
        """
        found = {key: self._own(key, is_angle(key)) for key in self._names}
        around = circle(self.formulas)
        if around:
            self.problems.add(self.fields.place_of(around[0]), f"{' and '.join(around)} follow from each other")
            return found
        waiting = list(self.formulas)
        while waiting:
            ready = [key for key in waiting if not symbols(self.formulas[key].expr) & set(waiting)]
            for key in ready:
                found[key] = self._derived(key, found)
            waiting = [key for key in waiting if key not in ready]
        return found

    def _own(self, key: str, is_angle: bool | None) -> Value | None:  # noqa: FBT001  a callable's answer, passed on
        node = self.fields.get(key)
        if isinstance(node, PlacedScalar) and not node.text and not node.quoted:
            return None
        scalar = self.fields.scalar(key)
        if scalar is None:
            return None
        formula = self._formula(key, scalar, is_angle)
        if formula is not None:
            self.formulas[key] = formula
            return None
        if is_angle is None:
            is_angle = has_unit_of_angle(scalar)
        return self.reader.value(scalar, key, is_angle=is_angle)

    def _formula(self, key: str, scalar: PlacedScalar, is_angle: bool | None) -> Formula | None:  # noqa: FBT001
        """A parameter in terms of others; none if no other stands in it."""
        if not any(letter.isalpha() for letter in scalar.text):
            return None
        try:
            expr = parse(scalar.text, Scope(lengths=self._names), scalar.place_of(0))
        except NotationError:
            return None  # told when it is read as a constant
        inside = symbols(expr)
        if not inside:
            return None
        if key in inside:
            others = did_you_mean(key, [name for name in self._names if name != key])
            self.problems.add(scalar.place, f"{key}: follows from itself", others)
            return None
        if is_angle is None:
            self._unknown.add(key)
            is_angle = has_angle_unit(expr)
        if is_angle and self.reader.remarks is not None:
            expr = taken_exactly(expr, key, self.reader.remarks)
        return Formula(expr if is_angle else with_unit(expr, self.reader.unit), is_angle)

    def _derived(self, key: str, found: dict[str, Value | None]) -> Value | None:
        formula = self.formulas[key]
        known = {name: value for name in symbols(formula.expr) if (value := found[name]) is not None}
        if len(known) < len(symbols(formula.expr)):
            return None
        if key in self._unknown and known and all(isinstance(value, Angle) for value in known.values()):
            self.formulas[key] = formula = replace(formula, is_angle=True)
        try:
            return value_of(formula, known)
        except DimensionError as error:
            self.problems.add(self.fields.place_of(key), f"{key}: {error.message}", error.hint)
            return None
