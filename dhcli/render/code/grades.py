"""The grades of a class for programs: a spreadsheet, a script, and the autograder of Gradescope."""

from __future__ import annotations

import json
from typing import Any

from dhcli.checking.verdicts import Verdict
from dhcli.classroom.grades import Graded, PartGrade
from dhcli.classroom.report import STEPS, ClassReport
from dhcli.render.code.matrices import csv_line, exact
from dhcli.render.json.envelope import problem_content
from dhcli.render.look import Look
from dhcli.safe import csv_cell, one_line

_VISIBLE = {"visibility": "visible", "output_format": "text"}


def class_csv(report: ClassReport, _look: Look) -> str:
    """One line for each sheet, two columns for each part; what students wrote is made harmless."""
    columns = {part: at for at, part in enumerate(dict.fromkeys(part.part for part in report.parts))}
    heads = [csv_cell(f"{part} {what}") for part in columns for what in ("verdict", "earned")]
    lines = [csv_line(["student", "sheet", "exercise", "variant", *heads, "earned", "credit", "problem"])]
    for row in report.rows:
        said = [csv_cell(text) for text in (row.student, row.sheet, row.exercise, row.variant)]
        sums = [_number(row.earned), _number(row.credit)] if row.parts else ["", ""]
        problems = csv_cell("; ".join(str(problem) for problem in row.problems))
        lines.append(csv_line([*said, *_part_cells(row, columns), *sums, problems]))
    return "".join(lines)


def class_content(report: ClassReport, _look: Look) -> dict[str, Any]:
    """The report, and every sheet, as JSON holds it."""
    return {
        "folder": report.folder.path,
        "sheets": len(report.rows),
        "graded": len(report.graded),
        "failed": len(report.failed),
        "empty": list(report.folder.empty),
        "others": list(report.folder.others),
        "notices": list(report.notices),
        "mean": report.mean,
        "distribution": [
            {"from": step / 100, "sheets": count} for step, count in zip(STEPS, report.spread, strict=True)
        ],
        "parts": [
            {
                "exercise": one.exercise,
                "part": one.part,
                "credit": one.credit,
                "mean": one.mean,
                "verdicts": {verdict.word: one.verdicts.get(verdict, 0) for verdict in Verdict},
                "slips": [{"slip": slip, "sheets": count} for slip, count in one.slips],
            }
            for one in report.parts
        ],
        "results": [_row_content(row) for row in report.rows],
    }


def gradescope(report: ClassReport, _look: Look) -> str:
    """What an autograder of Gradescope writes into `results.json` for the one sheet of a submission.

    A sheet that was not graded scores nothing and says why, so that its student can mend it.

    Source: Gradescope, Autograder Specifications, output format.
    """
    (row,) = report.rows
    result: dict[str, Any] = {"score": exact(row.earned), "stdout_visibility": "hidden", **_VISIBLE}
    if row.problems:
        result["output"] = _lines(["this sheet could not be graded", *map(str, row.problems)])
    result["tests"] = [_test(part) for part in row.parts]
    return json.dumps(result, indent=2) + "\n"


def _part_cells(row: Graded, columns: dict[str, int]) -> list[str]:
    cells = [""] * 2 * len(columns)
    for grade in row.parts:
        at = 2 * columns[grade.part]
        cells[at : at + 2] = grade.verdict.word, _number(grade.earned)
    return cells


def _row_content(row: Graded) -> dict[str, Any]:
    return {
        "student": row.student,
        "sheet": row.sheet,
        "exercise": row.exercise or None,
        "variant": row.variant or None,
        "earned": row.earned,
        "credit": row.credit,
        "parts": [
            {
                "part": one.part,
                "verdict": one.verdict.word,
                "passed": one.verdict.passed,
                "earned": one.earned,
                "credit": one.credit,
                "actual": one.reading or None,
                "rationale": list(one.remarks),
                "slips": list(one.slips),
                "unit": one.other_unit or None,
            }
            for one in row.parts
        ],
        "problems": [problem_content(problem, "error") for problem in row.problems],
    }


def _test(part: PartGrade) -> dict[str, Any]:
    said = [f"{part.verdict.sign} {part.verdict.word}"]
    if part.reading:
        said.append(f"I read this as: {part.reading}")
    test = {
        "name": part.part,
        "score": exact(part.earned),
        "max_score": exact(part.credit),
        "output": _lines([*said, *part.remarks]),
        **_VISIBLE,
    }
    if part.verdict.passed or (part.verdict.passed is False and part.earned < part.credit):
        test["status"] = "passed" if part.verdict.passed else "failed"  # else Gradescope goes by the score
    return test


def _lines(texts: list[str]) -> str:
    """Texts below each other, without what would steer the page that shows them."""
    return "\n".join(one_line(text) for text in texts)


def _number(value: float) -> str:
    return repr(round(exact(value), 6))
