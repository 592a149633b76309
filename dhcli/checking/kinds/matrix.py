"""`link`, `pose`, `product` and the pieces of them: a homogeneous matrix, or what is asked of one."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace
from fractions import Fraction
from typing import TYPE_CHECKING, Any, ClassVar, Self

from dhcli.checking.diagnosis.result import Slip
from dhcli.checking.entries import Entries, Entry, entries_text, read_entries
from dhcli.checking.exercise import Case, Exercise, Question
from dhcli.checking.pasted import UnreadableError
from dhcli.checking.returned import Causes, Judged, Matrices, Overlaid, Points, Reading, Shown
from dhcli.checking.truth import is_length, names_in, truth_of, unvalued
from dhcli.checking.verdicts import UNSOLVED, Mark, Verdict
from dhcli.checking.wanted import Composed, Wanted, read_wanted
from dhcli.checking.whole import is_whole_matrix
from dhcli.errors import DhcliError, Place
from dhcli.frozen import frozen
from dhcli.kinematics.frames import View
from dhcli.notation.dimensions import read_at
from dhcli.notation.scope import Scope
from dhcli.notation.writer import write

if TYPE_CHECKING:
    from dhcli.kinematics.values import Values


@frozen
class MatrixQuestion(Wanted, Question[Entries]):
    """A matrix, or a piece of one."""

    may_show_frames: ClassVar = True
    is_overlaid: ClassVar = True
    words: ClassVar = ("link", "pose", "product", "inverse", "rotation", "position", "entry", "axis", "point", "vector")
    examples: ClassVar = (
        "link 1",
        "pose 0..3",
        'product "Rot(z, 90°)"',
        "inverse of link 1",
        "rotation of pose 0..3",
        "rotation from rpy(10°, 20°, 30°)",
        "position of pose 0..3",
        "entry 1 4 of pose 0..3",
        "axis x of pose 0..3",
        "point (1, 2, 3) of pose 0..3",
        "vector (1, 0, 0) of pose 0..3",
    )
    has_cosines: ClassVar = True

    @classmethod
    def asked(cls, text: str, scope: Scope, place: Place | None) -> Self:
        """A link, a pose, a product, an inverse, or a piece of one."""
        found = read_wanted(text, scope, place)
        return cls(found.source, found.inverse, found.piece, found.index, found.point, found.measured, found.is_link)

    def in_unit(self, unit: Fraction, scope: Scope) -> Self:
        """Bare coordinates of a point, and bare lengths of a product, are in the unit of the sheet."""
        from dhcli.checking.units import chain_in_metres, length_in_metres

        source = self.source
        if isinstance(source, Composed):
            source = Composed(chain_in_metres(source.text, unit, scope), source.text)
        if self.piece not in ("point", "vector") or not is_length(self, 0, 0):
            return replace(self, source=source)
        pairs = zip(self.point, self.measured, strict=True)
        point = tuple(one if given else read_at(None, length_in_metres, one, unit, scope) for one, given in pairs)
        return replace(self, source=source, point=point)

    def describe(self, exercise: Exercise) -> str:
        from dhcli.checking.workings import coordinates

        point = coordinates(self, exercise)
        return self._in_words(f"the point ({point})", f"the vector ({point})")

    def describe_form(self, _exercise: Exercise) -> str:
        """Neither the factors of a product nor the coordinates of a point are told."""
        words = self._in_words("a point", "a vector")
        return words if isinstance(self.source, View) else words.rpartition(": ")[2]

    def _in_words(self, point: str, vector: str) -> str:
        whole, (row, column) = self.whole, self.index
        pieces = {
            "pose": f"{whole}: a 4x4 matrix, row by row",
            "rotation": f"the rotation of {whole}: a 3x3 matrix",
            "position": f"the position of {whole}: three lengths",
            "entry": f"entry ({row + 1},{column + 1}) of {whole}",
            "axis": f"the {'xyz'[row]} axis of {whole}: three direction cosines",
            "point": f"{point} through {whole}: three lengths",
            "vector": f"{vector} turned by {whole}: three numbers",
        }
        return pieces[self.piece]

    def blank(self, _exercise: Exercise) -> tuple[int, int]:
        rows, columns = self.shape
        return (1, rows) if columns == 1 else (rows, columns)

    @property
    def in_rows(self) -> bool:
        return self.shape[1] > 1

    def is_length(self, row: int, column: int) -> bool:
        return is_length(self, row, column)

    def is_whole(self, text: str, blank: tuple[int, int]) -> bool:
        return is_whole_matrix(text, blank)

    @property
    def names(self) -> frozenset[str]:
        return names_in(self)

    def unvalued(self, exercise: Exercise) -> tuple[str, ...]:
        return unvalued(self, exercise) if exercise.numeric else ()

    def expected(self, case: Case, style: str = "short") -> str:
        from dhcli.checking.workings import as_text

        return as_text(case, self, style)

    def shortest(self, case: Case) -> str:
        from dhcli.checking.workings import shortest

        return shortest(case, self, lambda text: self._is_right(case, text))

    def _is_right(self, case: Case, text: str) -> bool:
        try:
            return self.mark(case, Reading(text, self.read(case, text))).verdict is Verdict.RIGHT
        except UnreadableError:
            return False

    def steps(self, case: Case) -> Iterable[Shown]:
        from dhcli.checking.workings import matrix_steps

        return matrix_steps(case, self)

    def read(self, case: Case, text: str, place: Place | None = None) -> Entries:
        return read_entries(self, case.exercise, text, place)

    def mark(self, case: Case, reading: Reading[Entries]) -> Mark:
        from dhcli.checking.diagnosis.plausible import at_a_point, is_trivial
        from dhcli.checking.numeric import mark_measured
        from dhcli.checking.symbolic import mark_symbols

        exercise, entries = case.exercise, reading.value
        truth = truth_of(self, case)
        if exercise.numeric:
            judged = mark_measured(self, truth, entries, case.memo, case.tolerance)
        else:
            judged = mark_symbols(self, truth, entries, case.memo)
        is_open = judged.verdict in UNSOLVED or (judged.verdict is Verdict.ROUNDED and not exercise.numeric)
        if is_open and is_trivial(at_a_point(entries, exercise.values)):
            judged = replace(judged, earned=0.0)  # what is right in it was not worked out

        def written(entry: Entry) -> str:
            return case.memo.recent("written", entry, lambda: write(entry.typed, "short", exercise.writing))

        typed = tuple(tuple(map(written, row)) for row in entries)
        columns = self.shape[1]
        shown = [cell.expected for cell in judged.cells]
        rows = tuple(tuple(shown[i : i + columns]) for i in range(0, len(shown), columns))
        return replace(judged, reading=entries_text(typed), expected=entries_text(rows))

    def misprinted(self, case: Case, judged: Judged[Entries], printed: Judged[Entries]) -> tuple[str, ...]:
        """A remark for each wrong entry that is just what the document prints.

        The right entry is told only where the exercise shows what was expected: a misprint is no reason to give it
        away.
        """
        from dhcli.checking.symbolic import same

        exercise, remarks, cells = case.exercise, [], judged.mark.cells
        if judged.mark.verdict not in UNSOLVED or judged.reading is None or printed.reading is None:
            return ()
        for cell in cells:
            r, c = cell.row, cell.column
            typed, shown = judged.reading.value[r][c].expr, printed.reading.value[r][c].expr
            if cell.verdict in UNSOLVED and same(typed, shown, exercise.values, exercise):
                where = "this" if len(cells) == 1 else f"entry ({r + 1},{c + 1})"
                right = f", the right entry is {cell.expected}" if exercise.shows_expected else ""
                remarks.append(f"{where} is what the document prints; it is a misprint{right}")
        return tuple(remarks)

    def slips(self, case: Case) -> Iterable[Slip]:
        from dhcli.checking.diagnosis.search import search_of

        return (one.slips[0] for one in search_of(self, case.memo).visible)

    def answer_with(self, case: Case, name: str) -> str | None:
        from dhcli.checking.diagnosis.matrix_causes import answer_with

        return answer_with(case, self, name)

    def hidden(self, case: Case) -> Iterable[Slip]:
        from dhcli.checking.diagnosis.search import search_of

        return (one.slips[0] for one in search_of(self, case.memo).hidden)

    def unclear(self, case: Case) -> Iterable[str]:
        from dhcli.checking.diagnosis.search import search_of

        return (one.slips[0].name for one in search_of(self, case.memo).unclear)

    def causes(self, case: Case, reading: Reading[Entries]) -> Causes:
        from dhcli.checking.diagnosis.matrix_causes import matrix_causes

        return matrix_causes(case, self, reading.value)

    def told(self, case: Case, mark: Mark, reading: Reading[Entries]) -> Mark:
        from dhcli.checking.diagnosis.geometry import HALVES, geometry
        from dhcli.checking.diagnosis.typed import typed_answer

        if mark.is_in_other_unit:
            return mark
        try:
            typed = typed_answer(case, self, reading.value)
        except (UnreadableError, DhcliError):
            return mark
        words = geometry(case.exercise, self, typed) if typed is not None else ""
        others = tuple(remark for remark in mark.remarks if not remark.startswith(HALVES))
        return replace(mark, remarks=(words, *others)) if words else mark

    def follows(self, case: Case, reading: Reading[Entries], earlier: Mapping[str, Reading[Any]]) -> tuple[str, ...]:
        from dhcli.checking.diagnosis.following import follows
        from dhcli.checking.diagnosis.plausible import at_a_point, is_trivial

        if is_trivial(at_a_point(reading.value, case.exercise.values)):
            return ()
        return follows(case, self, reading.value, earlier)

    def is_plausible(self, case: Case, judged: Judged[Entries]) -> bool:
        from dhcli.checking.diagnosis.plausible import HALF, at_a_point, has_name, is_motion, is_trivial

        if judged.reading is None:
            return False
        values, mark = at_a_point(judged.reading.value, case.exercise.values), judged.mark
        if is_trivial(values) or has_name(mark):
            return not is_trivial(values)
        is_from_here = not case.exercise.numeric or mark.earned >= HALF
        return is_from_here and (not self.is_factor or is_motion(values))

    def leads(
        self, case: Case, reading: Reading[Entries], span: tuple[int, int], _points: Points
    ) -> tuple[int, int, Matrices] | None:
        from dhcli.checking.diagnosis.following import leads_from

        return leads_from(case, self, reading.value, span)

    def overlaid(self, case: Case, reading: Reading[Entries], values: Values) -> Overlaid | None:
        from dhcli.checking.overlaid import overlaid_matrix

        return overlaid_matrix(case.exercise, self, reading.value, values)
