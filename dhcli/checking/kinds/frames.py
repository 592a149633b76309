"""`frames`: a frame for each link, put on the joint axes by the rules of one of the conventions; or their table."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from typing import TYPE_CHECKING, ClassVar, Self, TypeAlias

from dhcli.checking.diagnosis.result import Slip
from dhcli.checking.exercise import Case, Exercise, Question
from dhcli.checking.frames.marking import frame_text, frames_text, mark_frames, table_of
from dhcli.checking.frames.reading import TypedFrame, read_frames
from dhcli.checking.frames.rules import Rules
from dhcli.checking.frames.sketch import axes_text, drawn_at, pose_of, seen_from, sketch_of
from dhcli.checking.frames.slips import as_typed, causes_of, every_slip
from dhcli.checking.frames.spelling import has_frames, rows_of, small_axes
from dhcli.checking.kinds.linked import needed
from dhcli.checking.kinds.table import TableQuestion, arm_of, leads_of
from dhcli.checking.returned import Causes, Matrices, Overlaid, Points, Reading, Shown
from dhcli.checking.tables.comparing import END
from dhcli.checking.tables.typed_rows import TypedRow
from dhcli.checking.verdicts import UNSOLVED, Mark, Verdict
from dhcli.checking.whole import is_closed
from dhcli.errors import NotationError, Place, Problem, RobotError
from dhcli.frozen import frozen
from dhcli.kinematics.conventions import TABLES, Convention, Row
from dhcli.kinematics.coupling import is_coupled
from dhcli.kinematics.describe.words import Speaker, written
from dhcli.kinematics.robot import Robot
from dhcli.notation.scope import Scope

if TYPE_CHECKING:
    from dhcli.kinematics.values import Values

Answer: TypeAlias = tuple[TypedFrame, ...] | tuple[TypedRow, ...]
"""Frames, or the rows of a table."""

COLUMNS = 5
"""The three coordinates of an origin, the x axis and the z axis."""


@frozen
class FramesQuestion(Question[Answer]):
    """A frame for each link: its origin, its x axis and its z axis, in the pose drawn.

    Attributes:
        convention: The convention whose rules are to be kept.
        pose: The named pose in which the robot is drawn; empty for its pose `drawn`, else zero.
        note: What is told beside every verdict, of an answer from a file.
    """

    convention: Convention
    pose: str = ""
    note: str = ""

    words: ClassVar = ("frames",)
    examples: ClassVar = ("frames standard", "frames modified at zero")
    is_in_table: ClassVar = True
    is_overlaid: ClassVar = True
    earns_by_row: ClassVar = True
    in_rows: ClassVar = True

    @classmethod
    def asked(cls, text: str, _scope: Scope, place: Place | None) -> Self:
        """`frames standard`, `frames modified at drawn`."""
        convention, _, pose = text.removeprefix("frames").strip().partition(" at ")
        if convention.strip() not in TABLES:
            hint = "write frames standard or frames modified, and at POSE behind it"
            rest = convention.strip()
            raise NotationError(Problem(f"there are no frames '{rest:.60}'" if rest else "which frames?", place, hint))
        return cls(Convention(convention.strip()), pose.strip())

    def check(self, robot: Robot | None) -> None:
        if is_coupled(needed(robot)):
            message = "its rows share a joint, so that no axis is that of one joint alone: it has no frames to ask for"
            raise RobotError(message, "ask for a cell, or for a matrix")
        pose_of(needed(robot), self.pose)

    def describe(self, exercise: Exercise) -> str:
        first, last = self._ends(exercise)
        return f"frames {first} to {last} by the rules of {self.convention.value} DH"

    def blank(self, exercise: Exercise) -> tuple[int, int]:
        first, last = self._ends(exercise)
        return last - first + 1, COLUMNS

    def notes(self, exercise: Exercise) -> Iterable[str]:
        sketch = sketch_of(exercise, self.convention, self.pose)
        yield "a row for each frame: the coordinates of its origin, then x and z, such as a, 0, 0, +x, +z; or the table"
        seen = seen_from(exercise, self.convention)
        yield f"seen from {seen}, drawn with {drawn_at(sketch.pose)}: {'; '.join(axes_text(sketch))}"

    def pose_drawn(self, exercise: Exercise) -> Values:
        return sketch_of(exercise, self.convention, self.pose).joint_values

    def is_whole(self, text: str, _blank: tuple[int, int]) -> bool:
        *_, last = text.strip().splitlines() or [""]
        return is_closed(text) and (text.strip().startswith("[") or len(rows_of(last)) > 1)

    def unvalued(self, exercise: Exercise) -> tuple[str, ...]:
        lengths = needed(exercise.robot).parameters if exercise.numeric else ()
        return tuple(name for name in lengths if name not in exercise.values)

    def expected(self, case: Case, _style: str = "short") -> str:
        return frames_text(self._rules(case).sketch.frames, case.exercise)

    def steps(self, case: Case) -> Iterable[Shown]:
        sketch = self._rules(case).sketch
        speaker = Speaker(sketch.walked, self.convention, sketch.robot.first, sketch.robot.writing, sketch.measured)
        yield from map(Shown, written(speaker.drawn()))
        rows = (frame_text(frame, case.exercise) for frame in sketch.frames)
        lines = (f"frame {number}: {row}" for number, row in enumerate(rows, sketch.first))
        yield Shown("Frame by frame, the origin, x and z:\n" + "\n".join(lines))

    def read(self, case: Case, text: str, place: Place | None = None) -> Answer:
        text = small_axes(text)
        if not has_frames(text):
            return self._table.read(case, text, place)
        first, last = self._ends(case.exercise)
        return read_frames(text, case.exercise, range(first, last + 1), self._rules(case).sketch.pose)

    def mark(self, case: Case, reading: Reading[Answer]) -> Mark:
        if frames := _frames(reading.value):
            mark = self._second_truth(case, frames) or mark_frames(case.exercise, self._rules(case), frames)
        else:
            mark = self._marked_table(case, _rows(reading.value))
        return replace(mark, remarks=(*mark.remarks, self.note)) if self.note else mark

    def slips(self, case: Case) -> Iterable[Slip]:
        return (slip for slip, _ in self._mistaken(case))

    def answer_with(self, case: Case, name: str) -> str | None:
        for slip, frames in self._mistaken(case):
            if slip.name == name:
                return "; ".join(frame_text(one.frame, case.exercise, left=one.y is not None) for one in frames)
        return self._table.answer_with(case, name)

    def causes(self, case: Case, reading: Reading[Answer]) -> Causes:
        if frames := _frames(reading.value):
            rules = self._rules(case)
            return causes_of(rules, frames, rules.broken(frames))
        return self._table.causes(case, Reading(reading.text, _rows(reading.value)))

    def differs(self, mark: Mark) -> bool:
        return mark.verdict.passed is True and bool(mark.remarks)

    def rows(self, case: Case, reading: Reading[Answer]) -> tuple[Row, ...]:
        if not (frames := _frames(reading.value)):
            return self._table.rows(case, Reading(reading.text, _rows(reading.value)))
        rules = self._rules(case)
        return () if rules.broken(frames) else table_of(rules.sketch, [one.frame for one in frames])

    def leads(
        self, case: Case, reading: Reading[Answer], span: tuple[int, int], points: Points
    ) -> tuple[int, int, Matrices] | None:
        return leads_of(self.rows(case, reading), self.convention, span, points)

    def arm(self, case: Case, reading: Reading[Answer]) -> Robot | None:
        return arm_of(case.exercise.robot, self.rows(case, reading), self.convention)

    def _second_truth(self, case: Case, frames: tuple[TypedFrame, ...]) -> Mark | None:
        """EQUIVALENT if frames lie on the axes of the exercise's other robot."""
        exercise = case.exercise
        if exercise.also is None or not self._rules(case).broken(frames):
            return None
        robot, note = exercise.also
        other = replace(exercise, robot=robot, also=None)
        rules = Rules(sketch_of(other, self.convention, self.pose), case.tolerance)
        mark = mark_frames(other, rules, frames)
        return replace(mark, verdict=Verdict.EQUIVALENT, remarks=(note, *mark.remarks)) if mark.earned == 1 else None

    def overlaid(self, case: Case, reading: Reading[Answer], values: Values) -> Overlaid:
        from dhcli.checking.overlaid import overlaid_frames

        rules = self._rules(case)
        drawn = {**values, **rules.sketch.joint_values}
        if frames := _frames(reading.value):
            return overlaid_frames(rules, frames, self._table.robot_drawn(case.exercise), drawn)
        return self._table.overlaid(case, Reading(reading.text, _rows(reading.value)), drawn)

    def _marked_table(self, case: Case, rows: tuple[TypedRow, ...]) -> Mark:
        """A table is right when frames of it can lie on the axes, the last one anywhere if the task leaves it open."""
        from dhcli.checking.tables.comparing import compare_of
        from dhcli.checking.tables.marking import answer_of, mark_table

        compare = compare_of(case)
        is_open = END not in self._rules(case).sketch.stated
        answer = answer_of(case.memo, self.convention, rows, compare, case.tolerance, end_free=is_open or None)
        mark = mark_table(answer)
        said = f"no frames on these axes have this table in {self.convention.value} DH"
        return replace(mark, remarks=(said, *mark.remarks)) if mark.verdict in UNSOLVED else mark

    def _mistaken(self, case: Case) -> tuple[tuple[Slip, tuple[TypedFrame, ...]], ...]:
        """Every single mistake, with the frames of a student who makes it."""
        rules = self._rules(case)
        right = tuple(map(as_typed, rules.sketch.frames))
        return case.memo.of(("mistaken", self, case.tolerance), lambda: tuple(every_slip(rules, right)))

    @property
    def _table(self) -> TableQuestion:
        """The question for the table of these frames."""
        return TableQuestion(self.convention)

    def _rules(self, case: Case) -> Rules:
        sketch = case.memo.of(
            ("sketch", self.convention, self.pose), lambda: sketch_of(case.exercise, self.convention, self.pose)
        )
        return Rules(sketch, case.tolerance)

    @staticmethod
    def _ends(exercise: Exercise) -> tuple[int, int]:
        """The numbers of the first frame and of the last."""
        robot = needed(exercise.robot)
        return robot.first - 1, robot.first - 1 + len(robot.variables)


def _frames(answer: Answer) -> tuple[TypedFrame, ...]:
    """The frames of an answer; none where it is a table."""
    return tuple(one for one in answer if isinstance(one, TypedFrame))


def _rows(answer: Answer) -> tuple[TypedRow, ...]:
    """The rows of an answer; none where it is frames."""
    return tuple(one for one in answer if isinstance(one, TypedRow))
