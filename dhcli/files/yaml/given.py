"""What an exercise gives: values of names, and the ranges that its variants draw them from."""

from __future__ import annotations

from dhcli.checking.written import Range
from dhcli.files.yaml.fields import Fields
from dhcli.files.yaml.placed import PlacedScalar
from dhcli.files.yaml.ranges import is_bare, read_variants
from dhcli.files.yaml.typed import has_unit_of_angle, read_value
from dhcli.kinematics.robot import Robot, Value
from dhcli.notation.angle import Angle
from dhcli.notation.names import canonical, is_greek
from dhcli.notation.quantity import LENGTH_UNITS


class Given:
    """Reads the key `given`, and then `variants`.

    Attributes:
        values: The values that could be read.
        refused: The names of those that could not.
    """

    def __init__(self, fields: Fields, robot: Robot | None, unit: str) -> None:
        """Read the values.

        Args:
            fields: Those at the top of the file.
            robot: The robot of the exercise, if there is one.
            unit: The unit of its sheet.
        """
        self.fields = fields
        self.robot = robot
        self.unit = unit
        self.values: dict[str, Value] = {}
        self.refused: set[str] = set()
        given = fields.mapping("given", example="{theta1: 30°}")
        for written in given.entries:
            key = self._own_name(written)
            scalar = given.scalar(written)
            value = self._value(scalar, key) if scalar else None
            if key in self.values:
                fields.problems.add(given.place_of(written), f"given: {key} stands twice", "keep one")
            elif value is None:
                self.refused.add(key)
            else:
                self.values[key] = value

    def is_angle(self, key: str) -> bool:
        """Whether a name stands for an angle: by the robot, by the value given, or by its Greek letter."""
        if self.robot is not None and self._of_robot(key):
            return key in self.robot.angles
        return is_greek(key) or isinstance(self.values.get(key), Angle)

    def variants(self) -> dict[str, Range]:
        """The ranges of names."""
        if self.robot is None and "robot" in self.fields:
            return {}  # that it was not found is said; its names are not known
        known = (*(self.robot.scope.names if self.robot else ()), *self.values)
        return read_variants(self.fields, known, self.is_angle, self._unit_of)

    def _own_name(self, written: str) -> str:
        """The robot's spelling of a name, such as theta1 for θ1 and theta_1; others as they are written."""
        own = self.robot.scope.names if self.robot else ()
        return next((name for name in own if canonical(name) == canonical(written)), written)

    def _value(self, scalar: PlacedScalar, key: str) -> Value | None:
        unit = self._unit_of(key)
        if unit and not self.is_angle(key) and is_bare(scalar.text):
            message = f"{key}: a length without its unit, on a sheet in {unit}"
            self.fields.problems.add(scalar.place, message, f"write {scalar.text} {unit}")
            return None
        is_angle = self.is_angle(key) or (not self._of_robot(key) and has_unit_of_angle(scalar))
        return read_value(self.fields.problems, scalar, key, is_angle=is_angle)

    def _of_robot(self, key: str) -> bool:
        return self.robot is not None and key in self.robot.scope.names

    def _unit_of(self, key: str) -> str:
        """The unit that a length must have where a bare one, which is in metres, would be read in that of the sheet."""
        return self.unit if self.unit in LENGTH_UNITS and self.unit != "m" and self._of_robot(key) else ""
