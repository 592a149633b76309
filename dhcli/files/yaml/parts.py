"""The parts of an exercise file: each a question, with what it is worth, what helps, and how near is near enough."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from typing import Any

from dhcli.checking.credit import Shares
from dhcli.checking.exercise import Part, Question
from dhcli.checking.kinds.registry import read_question
from dhcli.checking.tables.comparing import COMPARED
from dhcli.checking.tolerance import Tolerance
from dhcli.checking.written import Printed
from dhcli.errors import DhcliError, NotationError, Place, did_you_mean
from dhcli.files.keys.exercises import PART
from dhcli.files.keys.shapes import names, required
from dhcli.files.yaml.credits import read_credit
from dhcli.files.yaml.fields import Fields, Problems
from dhcli.files.yaml.named import Named
from dhcli.files.yaml.placed import PlacedNode, PlacedScalar, PlacedSequence, as_text
from dhcli.files.yaml.tolerances import read_decimals
from dhcli.files.yaml.typed import MOST_DIGITS, read_flag, read_texts, read_word
from dhcli.frozen import frozen
from dhcli.kinematics.robot import Robot
from dhcli.notation.scope import Scope

OF_ALL = dict.fromkeys(
    (
        "numeric",
        "unit",
        "tolerance",
        "given",
        "names",
        "printed",
        "feedback",
        "variants",
        "also",
        "tests",
        "picture",
    ),
    "it stands at the top of the file, and holds for all",
)
"""Keys that stand at the top of a file and hold for all parts."""

EXAMPLE = "{id: a1, ask: link 1}"


@frozen
class PartReader:
    """Reads the parts of one file, one after the other.

    Attributes:
        problems: Where to note what is wrong.
        scope: The names that questions may use.
        robot: The robot, if there is one.
        has_robot: Whether the file names a robot, which may not have been found.
        unit: Metres in a bare length of a sheet.
        tolerance: The tolerance of the exercise.
        shares: What answers earn in the exercise.
        printed: What the document prints, by part.
        named: What finds linkages.
        ids: The ids so far, also of parts that cannot be read.
    """

    problems: Problems
    scope: Scope
    robot: Robot | None
    has_robot: bool
    unit: Fraction
    tolerance: Tolerance
    shares: Shares
    printed: dict[str, Printed]
    named: Named
    ids: list[str]

    def part(self, node: PlacedNode, index: int) -> Part | None:
        """A part; None if there is no telling what it asks."""
        fields = self.problems.mapping(
            node, "parts", known=names(PART), required=required(PART), elsewhere=OF_ALL, example=EXAMPLE
        )
        name, depends = fields.text("id"), read_texts(fields, "depends")
        self.check_id(fields, name, depends)
        ask = fields.scalar("ask")
        question = self.question(fields, ask) if ask is not None and name else None
        credit, shares = read_credit(fields, self.shares)
        rest: dict[str, Any] = {
            "prompt": fields.text("prompt"),
            "credit": credit,
            "shares": shares,
            "withdrawn": fields.text("withdrawn"),
            "depends": depends,
            "hints": read_texts(fields, "hints"),
            "tolerance": self.own_tolerance(fields),
            "compare": read_word(fields, "compare", COMPARED),
            "printed": self.printed.get(name),
            "index": index,
        }
        return None if question is None else Part(name, question, **rest)

    def check_id(self, fields: Fields, name: str, depends: tuple[str, ...]) -> None:
        """Make sure that an id can be typed and is the only one, and that a part builds on what stands before it."""
        place = fields.place_of("id")
        if not all(letter.isalnum() or letter in "_-" for letter in name):
            hint = "".join(letter if letter.isalnum() or letter in "_-" else "-" for letter in name).strip("-")
            message = f"id: '{name}' holds more than letters, digits, _ and -"
            self.problems.add(place, message, f"write {hint}" if hint else "write a1")
        if name and name in self.ids:
            self.problems.add(place, f"id: the id {name} is used twice", "each part has a name of its own")
        for other in depends:
            if other not in self.ids:
                message = f"depends: {name} depends on {other}, which does not stand before it"
                self.problems.add(fields.place_of("depends"), message, did_you_mean(other, self.ids))
        if name:
            self.ids.append(name)

    def question(self, fields: Fields, ask: PlacedScalar) -> Question[Any] | None:
        """What is asked; None if it cannot be read."""
        try:
            question = read_question(ask.text, self.scope, ask.place_of(0))
            if self.unit != 1:
                question = question.in_unit(self.unit, self.scope)
        except NotationError as error:
            self.problems.take(error)
            return None
        question = question.completed(_Besides(self.problems, self.named, fields, ask.place))
        if self.robot is not None or not self.has_robot:  # that the robot was not found is told already
            self.check_exists(question, ask.place)
        return question

    def check_exists(self, question: Question[Any], place: Place) -> None:
        """Make sure that the robot has the frames, the link or the table that is asked about."""
        try:
            question.check(self.robot)
        except DhcliError as error:
            for problem in error.problems:
                self.problems.add(place, f"ask: {problem.message}", problem.hint)

    def own_tolerance(self, fields: Fields) -> Tolerance | None:
        """The tolerance of the part, if it differs from that of the exercise."""
        tolerance = None
        if "exact" in fields:
            tolerance = replace(self.tolerance, exact=read_flag(fields, "exact"))
        if "decimals" in fields:
            tolerance = replace(tolerance or self.tolerance, decimals=read_decimals(fields))
        return tolerance


@frozen
class _Besides:
    """What a part says besides `ask:`, for the kinds of questions that need more."""

    problems: Problems
    named: Named
    fields: Fields
    ask: Place

    def texts(self, key: str) -> tuple[str, ...]:
        """A list of texts."""
        return read_texts(self.fields, key)

    def one_of(self, key: str, count: int) -> int:
        """Which of so many, counted from 1; 1 where it is none, which is told."""
        scalar = self.fields.scalar(key)
        typed = scalar.text if scalar else ""
        if typed.isdecimal() and len(typed) <= MOST_DIGITS and 1 <= int(typed) <= count:
            return int(typed)
        if not count:
            if "options" not in self.fields:
                self.problems.add(self.fields.place, "options: is missing", "write options: [its axis, its origin]")
        elif scalar or key not in self.fields:
            node = self.fields.get("options")
            options = list(map(as_text, node.items)) if isinstance(node, PlacedSequence) else []
            letter = 1 + ord(typed.lower()) - ord("a") if len(typed) == 1 and typed.isascii() else 0
            letter = options.index(typed) + 1 if typed in options else letter
            hint = f"write {letter}" if 1 <= letter <= count else f"write 1 to {count}"
            said = f"'{typed}' is not the number of one of the {count} options, counted from 1"
            place = scalar.place if scalar else self.fields.place
            self.problems.add(place, f"{key}: {said if scalar else 'is missing'}", hint)
        return 1

    def linkage(self, name: str) -> object | None:
        """The linkage of a name or a pattern; None if there is none, which is told."""
        return self.named.linkage("ask", self.ask, name)
