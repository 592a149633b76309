"""Exercise files: a robot, questions and what the document prints, read with every problem at once."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from fractions import Fraction
from pathlib import Path

from dhcli.checking.exercise import Exercise
from dhcli.checking.figures import LEVELS
from dhcli.checking.verdicts import Verdict
from dhcli.checking.written import Printed, Trial, answer_scope
from dhcli.errors import DhcliError, FileError, Problem, did_you_mean, nearest
from dhcli.files.keys.exercises import ALSO, EXERCISE, FEEDBACK, PART, PRINTED, SOURCE, TEST, TOLERANCE
from dhcli.files.keys.shapes import names, required
from dhcli.files.library.entries import Kind, entries, full_id
from dhcli.files.library.lookup import check_typed, find
from dhcli.files.reading import read_text, source_of
from dhcli.files.yaml.credits import read_shares
from dhcli.files.yaml.fields import Fields, Problems
from dhcli.files.yaml.given import Given
from dhcli.files.yaml.named import Named
from dhcli.files.yaml.parts import PartReader
from dhcli.files.yaml.placed import PlacedMapping, PlacedNode, PlacedScalar, PlacedSequence, as_text, read_yaml
from dhcli.files.yaml.tolerances import read_tolerance
from dhcli.files.yaml.typed import (
    read_flag,
    read_texts,
    read_word,
)
from dhcli.kinematics.robot import Robot
from dhcli.notation.quantity import LENGTH_UNITS
from dhcli.notation.scope import Scope

ELSEWHERE = {
    **dict.fromkeys(names(PART), "it stands in a part, below parts:"),
    **dict.fromkeys(names(TOLERANCE), "it stands below tolerance:"),
    **dict.fromkeys(("answer", "mistake", "verdict"), "it stands in a test, below tests:"),
}
"""What to say of keys at the top of a file that stand below others."""

MEANT = dict.fromkeys(("correct", "true", "yes", "ok"), "RIGHT") | dict.fromkeys(("incorrect", "false", "no"), "WRONG")
"""Other words for verdicts."""


def load_exercise(name: str | Path) -> Exercise:
    """Load an exercise by its id, such as `wpi/puma560-links`, or from a file.

    Raises:
        UnknownNameError: No exercise has this id; the nearest are listed.
        FileError: The file is no exercise; every problem, each with file, line and column.
    """
    return _loader(name).whole()


def exercise_so_far(path: Path) -> tuple[Exercise, tuple[Problem, ...]]:
    """What can be read of an exercise file, and what is wrong with it: for those who look for more in the rest.

    Raises:
        FileError: It is no mapping in YAML that says `format: 1`, so that there is no rest.
    """
    loader = _loader(path)
    return loader.exercise(), tuple(loader.problems.found)


def _loader(name: str | Path) -> _Loader:
    """What reads the exercise of an id or in a file."""
    check_typed(Kind.EXERCISES, name)
    path = name if isinstance(name, Path) else find(Kind.EXERCISES, full_id(name))
    ids = {entry.path: entry.name for entry in entries(Kind.EXERCISES)}
    text = read_text("-" if str(path) == "-" else path)
    roots = _course_of(path) if path not in ids else ()
    folder = Path() if str(path) == "-" else path.parent
    return _Loader.of(text, source_of(path), ids.get(path, path.stem), roots, folder)


def read_exercise(text: str, source: str, name: str) -> Exercise:
    """Read an exercise from the text of a file.

    Args:
        text: YAML; the path of a robot in it begins at the working folder.
        source: What the text is called in errors.
        name: What the exercise is called.

    Raises:
        FileError: With all problems.
    """
    return _Loader.of(text, source, name).whole()


def _course_of(path: Path) -> Iterator[Path]:
    """The root that a file belongs to, so that it means the same wherever it is loaded from."""
    for folder in path.absolute().parents:
        if folder.name == Kind.EXERCISES.value:
            yield folder.parent
            return


class _Loader:
    """One pass over a file; what is wrong is collected, and something harmless taken in its place."""

    def __init__(
        self, root: PlacedNode, name: str, refused: list[Problem], roots: tuple[Path, ...], folder: Path
    ) -> None:
        self.problems = Problems(refused)
        self.named = Named(self.problems, folder, roots)
        self.name = name
        self.fields = self.problems.document(
            root, known=names(EXERCISE), required=required(EXERCISE), elsewhere=ELSEWHERE
        )
        self.robot = self.named.robot("robot", self.fields.scalar("robot"))
        self.unit = read_word(self.fields, "unit", (*LENGTH_UNITS, "none"), "write m, mm, cm or none") or "m"
        self.names = read_texts(self.fields, "names")
        self.given = Given(self.fields, self.robot, self.unit)
        self.printed = self.read_printed()
        self.tolerance = read_tolerance(self.fields)
        self.shares = read_shares(self.fields)
        has_robot = "robot" in self.fields
        scope = answer_scope(self.robot, (*self.given.values, *self.names))
        if has_robot and self.robot is None:
            scope = Scope(is_open=True)  # its names are not known, and that it was not found is told
        unit = LENGTH_UNITS.get(self.unit, Fraction(1))
        self.parts = PartReader(
            self.problems, scope, self.robot, has_robot, unit, self.tolerance, self.shares, self.printed, self.named, []
        )

    @classmethod
    def of(cls, text: str, source: str, name: str, roots: Iterable[Path] = (), folder: Path = Path()) -> _Loader:
        """What reads a text; what stands in the roots comes before the library, and a path begins in the folder."""
        refused: list[Problem] = []
        return cls(read_yaml(text, source, refused), name, refused, tuple(roots), folder)

    def whole(self) -> Exercise:
        """The exercise of a file that says nothing wrong."""
        found = self.exercise()
        self.problems.raise_if_any(FileError)
        return found

    def exercise(self) -> Exercise:
        """The exercise, as far as it can be read."""
        nodes = self.fields.sequence("parts", example="- {id: a1, ask: link 1}")
        parts_ = tuple(part for k, node in enumerate(nodes) if (part := self.parts.part(node, k)))
        if not nodes and isinstance(self.fields.get("parts"), PlacedSequence):
            place = self.fields.place_of("parts")
            self.problems.add(place, "parts: an exercise has at least one", "write - {id: a1, ask: link 1}")
        if parts_ and all(part.withdrawn for part in parts_):
            place = self.fields.place_of("parts")
            self.problems.add(place, "parts: all are withdrawn", "an exercise asks at least one")
        nodes = self.fields.sequence("tests", example="- {part: a1, answer: ..., verdict: WRONG}")
        trials = tuple(self.trial(node) for node in nodes)
        also = self.also()
        self.check_printed()
        feedback = read_word(self.fields, "feedback", FEEDBACK, "write expected, or leave it out")
        found = Exercise(
            id=self.name,
            title=self.fields.text("title"),
            source=self.source(),
            task=self.fields.text("task"),
            parts=parts_,
            robot=self.robot,
            given=self.given.values,
            names=self.names,
            numeric=read_flag(self.fields, "numeric"),
            unit=self.unit,
            tolerance=self.tolerance,
            shares=self.shares,
            also=also,
            trials=trials,
            shows_expected=feedback == "expected",
            variants=self.given.variants(),
            picture=read_word(self.fields, "picture", LEVELS),
        )
        self.check_values(found)
        return found

    def check_values(self, exercise: Exercise) -> None:
        """Names without a value, where the right answer needs one; a value that was refused is told already."""
        try:
            missing = [name for name in exercise.missing if name not in self.given.refused]
        except DhcliError:  # there is no right answer: of a robot that was not found, or one that is too long
            return
        if missing and isinstance(self.fields.get("given"), PlacedMapping | None):
            wanted = ", ".join(f"{name}: {'25°' if self.given.is_angle(name) else '0.12 m'}" for name in missing)
            message = f"given: no value for {', '.join(missing)}, and the answers are numbers"
            key = "given" if "given" in self.fields else "numeric"
            self.problems.add(self.fields.place_of(key), message, f"given: {{{wanted}}}")

    def also(self) -> tuple[Robot, str] | None:
        fields = self.fields.mapping(
            "also", known=names(ALSO), required=required(ALSO), example="{robot: NAME, note: why it is right too}"
        )
        robot = self.named.robot("also", fields.scalar("robot"))
        return None if robot is None else (robot, fields.text("note"))

    def source(self) -> str:
        node = self.fields.get("source")
        if isinstance(node, PlacedMapping):
            fields = self.fields.mapping("source", known=names(SOURCE), required=required(SOURCE))
            return f"{fields.text('document')}, {fields.text('item')}"
        return self.fields.text("source")

    def read_printed(self) -> dict[str, Printed]:
        fields = self.fields.mapping("printed", example='{a1: "c1 -s1; s1 c1"}')
        printed: dict[str, Printed] = {}
        for key in fields.entries:
            node = fields.get(key)
            if isinstance(node, PlacedMapping):
                inner = self.problems.mapping(node, key, known=names(PRINTED), required=required(PRINTED))
                printed[key] = Printed(_answer(inner, "answer"), inner.text("note"))
            else:
                printed[key] = Printed(_answer(fields, key))
        return printed

    def trial(self, node: PlacedNode) -> Trial:
        """A test."""
        example = "{part: a1, answer: ..., verdict: WRONG}"
        fields = self.problems.mapping(node, "tests", known=names(TEST), required=required(TEST), example=example)
        known = self.parts.ids
        name = fields.text("part")
        if name and name not in known and known:
            self.problems.add(fields.place_of("part"), f"part: there is no part {name}", did_you_mean(name, known))
        if fields.entries and {"answer", "mistake"} <= fields.entries.keys():
            message = "mistake: a test tries an answer or a mistake, and not both"
            self.problems.add(fields.place_of("mistake"), message, "delete one of them")
        elif fields.entries and not {"answer", "mistake"}.intersection(fields.entries):
            self.problems.add(fields.place, "answer: is missing", "write answer: ..., or mistake: sin-cos 1")
        words = [verdict.word for verdict in Verdict]
        verdict = fields.text("verdict")
        if verdict and verdict not in words:
            meant = MEANT.get(verdict.lower()) or next(iter(nearest(verdict, words, most=1, cutoff=0.8)), "")
            hint = f"write {meant}" if meant else f"one of {', '.join(words)}"
            self.problems.add(fields.place_of("verdict"), f"verdict: '{verdict}' is not known", hint)
            verdict = meant
        return Trial(name, _answer(fields, "answer"), verdict, fields.text("mistake"))

    def check_printed(self) -> None:
        for key in self.printed:
            if key not in self.parts.ids:
                hint = did_you_mean(key, self.parts.ids)
                self.problems.add(self.fields.place_of("printed"), f"printed: there is no part {key}", hint)


def _answer(fields: Fields, key: str) -> str:
    """An answer as a sheet has it: a text, which may be empty in quotes, or a list."""
    node = fields.get(key)
    is_it = isinstance(node, PlacedSequence) or (isinstance(node, PlacedScalar) and node.quoted and not node.text)
    return as_text(node) if node is not None and is_it else fields.text(key)
