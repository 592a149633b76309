"""Exercise files: a robot, questions and what the document prints, read with every problem at once."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from dhcli.checking.exercise import Exercise, Part, Printed, Trial, answer_scope
from dhcli.checking.questions import ChoiceQuestion, CountQuestion, Question, check_question, read_question
from dhcli.checking.variants import Range
from dhcli.checking.verdicts import Verdict
from dhcli.errors import DhcliError, FileError, NotationError, Problem, did_you_mean
from dhcli.files.fields import Fields, Problems
from dhcli.files.library import Kind, entries, find
from dhcli.files.placed import PlacedMapping, PlacedNode, PlacedScalar, read_yaml
from dhcli.files.ranges import read_variants
from dhcli.files.reading import read_text, source_of
from dhcli.files.robots import load_robot
from dhcli.files.tolerances import read_tolerance
from dhcli.files.typed import (
    has_unit_of_angle,
    read_flag,
    read_number,
    read_texts,
    read_value,
    read_whole,
)
from dhcli.kinematics.robot import Robot, Value
from dhcli.notation.angle import Angle
from dhcli.notation.names import GREEK_NAMES, parts
from dhcli.notation.quantity import LENGTH_UNITS

KEYS = (
    "title",
    "source",
    "robot",
    "task",
    "given",
    "names",
    "numeric",
    "unit",
    "tolerance",
    "also",
    "parts",
    "printed",
    "tests",
    "variants",
    "feedback",
)
PART_KEYS = ("id", "ask", "prompt", "credit", "depends", "hints", "compare", "options", "right", "exact", "decimals")


def load_exercise(name: str | Path) -> Exercise:
    """Load an exercise by its id, such as `wpi/puma560-links`, or from a file.

    Raises:
        UnknownNameError: No exercise has this id; the nearest are listed.
        FileError: The file is no exercise; every problem, each with file, line and column.
    """
    path = name if isinstance(name, Path) else find(Kind.EXERCISES, full_id(name))
    ids = {entry.path: entry.name for entry in entries(Kind.EXERCISES)}
    text = read_text("-" if str(path) == "-" else path)
    return read_exercise(text, source_of(path), ids.get(path, path.stem))


def read_exercise(text: str, source: str, name: str) -> Exercise:
    """Read an exercise from the text of a file.

    Raises:
        FileError: With all problems.
    """
    refused: list[Problem] = []
    return _Loader(read_yaml(text, source, refused), name, refused).exercise()


def full_id(name: str) -> str:
    """An id from its last part, where only one exercise ends so."""
    if "/" in name or name.endswith((".yaml", ".yml")) or name == "-":
        return name
    ends = [entry.name for entry in entries(Kind.EXERCISES) if entry.name.split("/")[-1] == name and not entry.shadowed]
    return ends[0] if len(ends) == 1 else name


class _Loader:
    """One pass over a file; what is wrong is collected, and something harmless taken in its place."""

    def __init__(self, root: PlacedNode, name: str, refused: list[Problem]) -> None:
        self.problems = Problems(refused)
        self.name = name
        self.fields = self.problems.document(root, known=KEYS, required=("title", "source", "task", "parts"))
        self.robot = self.read_robot("robot")
        self.names = read_texts(self.fields, "names")
        self.given: dict[str, Value] = {}
        self.read_given()
        self.scope = answer_scope(self.robot, (*self.given, *self.names))
        self.printed = self.read_printed()
        self.tolerance = read_tolerance(self.fields)

    def exercise(self) -> Exercise:
        parts_ = tuple(part for node in self.fields.sequence("parts") if (part := self.part(node)))
        trials = tuple(trial for node in self.fields.sequence("tests") if (trial := self.trial(node, parts_)))
        also = self.also()
        unit = self.fields.text("unit", "m")
        if unit not in (*LENGTH_UNITS, "none"):
            self.problems.add(
                self.fields.place_of("unit"), f"unit: '{unit}' is no unit of length", "write m, mm, cm or none"
            )
        self.check_ids(parts_)
        feedback = self.fields.text("feedback", "verdict")
        if feedback not in ("verdict", "expected"):
            self.problems.add(
                self.fields.place_of("feedback"), f"feedback: '{feedback}' is not known", "write expected"
            )
        found = Exercise(
            id=self.name,
            title=self.fields.text("title"),
            source=self.source(),
            task=self.fields.text("task"),
            parts=parts_,
            robot=self.robot,
            given=self.given,
            names=self.names,
            numeric=read_flag(self.fields, "numeric"),
            unit=unit,
            tolerance=self.tolerance,
            also=also,
            trials=trials,
            shows_expected=feedback == "expected",
            variants=self.variants(),
        )
        self.problems.raise_if_any(FileError)
        return found

    def read_robot(self, key: str) -> Robot | None:
        scalar = self.fields.scalar(key)
        if scalar is None:
            return None
        try:
            return load_robot(scalar.text)
        except DhcliError as error:
            for problem in error.problems:
                self.problems.add(scalar.place, f"{key}: {problem.message}", problem.hint)
            return None

    def also(self) -> tuple[Robot, str] | None:
        fields = self.fields.mapping("also", known=("robot", "note"), required=("robot",))
        scalar = fields.scalar("robot")
        if scalar is None:
            return None
        try:
            return load_robot(scalar.text), fields.text("note")
        except DhcliError as error:
            self.problems.take(error)
            return None

    def source(self) -> str:
        node = self.fields.get("source")
        if isinstance(node, PlacedMapping):
            fields = self.fields.mapping("source", known=("document", "item"), required=("document", "item"))
            return f"{fields.text('document')}, {fields.text('item')}"
        return self.fields.text("source")

    def read_given(self) -> None:
        fields = self.fields.mapping("given")
        for key in fields.entries:
            scalar = fields.scalar(key)
            value = self.value(scalar, key) if scalar else None
            if value is not None:
                self.given[key] = value

    def value(self, scalar: PlacedScalar, key: str) -> Value | None:
        is_angle = self.is_angle(key) or (not self.of_robot(key) and has_unit_of_angle(scalar))
        return read_value(self.problems, scalar, key, is_angle=is_angle)

    def is_angle(self, key: str) -> bool:
        """Whether a name stands for an angle: by the robot, by the value given, or by its Greek letter."""
        if self.robot is not None and self.of_robot(key):
            return key in self.robot.angles
        return _is_angle(key) or isinstance(self.given.get(key), Angle)

    def of_robot(self, key: str) -> bool:
        return self.robot is not None and key in self.robot.scope.names

    def variants(self) -> dict[str, Range]:
        if self.robot is None and "robot" in self.fields:
            return {}  # that it was not found is said; its names are not known
        known = (*(self.robot.scope.names if self.robot else ()), *self.given)
        return read_variants(self.fields, known, self.is_angle)

    def read_printed(self) -> dict[str, Printed]:
        fields = self.fields.mapping("printed")
        printed: dict[str, Printed] = {}
        for key in fields.entries:
            node = fields.get(key)
            if isinstance(node, PlacedMapping):
                inner = self.problems.mapping(node, key, known=("answer", "note"), required=("answer",))
                printed[key] = Printed(inner.text("answer"), inner.text("note"))
            else:
                printed[key] = Printed(fields.text(key))
        return printed

    def part(self, node: PlacedNode) -> Part | None:
        fields = self.problems.mapping(node, "parts", known=PART_KEYS, required=("id", "ask"))
        ask = fields.scalar("ask")
        if ask is None or "id" not in fields:
            return None
        try:
            question = read_question(ask.text, self.scope, ask.place_of(0))
        except NotationError as error:
            self.problems.take(error)
            return None
        if isinstance(question, ChoiceQuestion):
            options = read_texts(fields, "options")
            right = read_whole(fields, "right") or 0
            if not 1 <= right <= len(options):
                self.problems.add(fields.place, "right: should be the number of an option, counted from 1")
            question = ChoiceQuestion(options, right)
        if isinstance(question, CountQuestion):
            question = self.looked_up(question, ask)
        self.check_exists(question, ask)
        tolerance = None
        if "exact" in fields:
            tolerance = replace(self.tolerance, exact=read_flag(fields, "exact"))
        if "decimals" in fields:
            tolerance = replace(tolerance or self.tolerance, decimals=read_whole(fields, "decimals"))
        name, credit = fields.text("id"), read_number(fields, "credit")
        if not all(letter.isalnum() or letter in "_-" for letter in name):
            self.problems.add(fields.place_of("id"), f"id: '{name}' holds more than letters, digits, _ and -")
        return Part(
            id=name,
            question=question,
            prompt=fields.text("prompt"),
            credit=1.0 if credit is None else credit,
            depends=read_texts(fields, "depends"),
            hints=read_texts(fields, "hints"),
            tolerance=tolerance,
            compare=self.compare(fields),
            printed=self.printed.get(name),
        )

    def check_exists(self, question: Question, ask: PlacedScalar) -> None:
        """Make sure that the robot has the frames, the link or the table that is asked about."""
        try:
            check_question(question, self.robot)
        except DhcliError as error:
            for problem in error.problems:
                self.problems.add(ask.place, f"ask: {problem.message}", problem.hint)

    def looked_up(self, question: CountQuestion, ask: PlacedScalar) -> CountQuestion:
        from dhcli.files.linkages import find_linkage  # few exercises count

        try:
            return replace(question, found=find_linkage(question.linkage))
        except DhcliError as error:
            for problem in error.problems:
                self.problems.add(ask.place, f"ask: {problem.message}", problem.hint)
            return question

    def compare(self, fields: Fields) -> str:
        known = ("literal", "same-motion", "same-robot")
        text = fields.text("compare", "same-robot")
        if text not in known:
            self.problems.add(fields.place_of("compare"), f"compare: '{text}' is not known", did_you_mean(text, known))
        return text

    def trial(self, node: PlacedNode, parts_: tuple[Part, ...]) -> Trial | None:
        fields = self.problems.mapping(
            node, "tests", known=("part", "answer", "mistake", "verdict"), required=("part", "verdict")
        )
        known = [part.id for part in parts_]
        name = fields.text("part")
        if name and name not in known:
            self.problems.add(fields.place_of("part"), f"part: there is no part {name}", did_you_mean(name, known))
        words = [verdict.word for verdict in Verdict]
        verdict = fields.text("verdict")
        if verdict and verdict not in words:
            self.problems.add(
                fields.place_of("verdict"), f"verdict: '{verdict}' is not known", did_you_mean(verdict, words)
            )
        blank = fields.get("answer")
        answer = "" if isinstance(blank, PlacedScalar) and blank.quoted and not blank.text else fields.text("answer")
        return Trial(name, answer, verdict, fields.text("mistake"))

    def check_ids(self, parts_: tuple[Part, ...]) -> None:
        place = self.fields.place_of("parts")
        seen: set[str] = set()
        for part in parts_:
            if part.id in seen:
                self.problems.add(place, f"parts: the id {part.id} is used twice")
            for name in part.depends:
                if name not in seen:
                    self.problems.add(place, f"parts: {part.id} depends on {name}, which does not stand before it")
            seen.add(part.id)
        for key in self.printed:
            if key not in seen:
                hint = did_you_mean(key, seen)
                self.problems.found.append(
                    Problem(f"printed: there is no part {key}", self.fields.place_of("printed"), hint)
                )


def _is_angle(name: str) -> bool:
    return parts(name)[0] in GREEK_NAMES
