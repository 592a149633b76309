"""A robot's table and an exercise for a page in Markdown."""

from __future__ import annotations

from collections.abc import Iterator

from dhcli.checking.earning import worth
from dhcli.checking.exercise import Exercise, Part
from dhcli.files.yaml.beside import given_lines, how_written
from dhcli.kinematics.conventions import ORDER, Convention
from dhcli.kinematics.robot import Robot
from dhcli.render.look import Look
from dhcli.render.text.robot import formula_rows, product_text
from dhcli.safe import markdown, markdown_code, markdown_heading, one_line

_INDENT = "    "


def robot_markdown(robot: Robot, look: Look) -> str:
    """The table with its cells as formulas, and the order of its moves under it; or the products."""
    is_product = robot.convention is Convention.PRODUCT
    if is_product:
        products = (
            [str(link.number), markdown_code(product_text(link, look)).replace("|", r"\|")] for link in robot.links
        )
        rows = [["$i$", "$A_i$"], *products]
    else:
        rows = formula_rows(robot)
    lines = [f"| {' | '.join(row)} |" for row in rows]
    lines.insert(1, "|" + "---|" * len(rows[0]))
    if not is_product:
        lines += ["", markdown_code(ORDER[robot.convention])]
    return "\n".join(lines) + "\n"


def exercise_markdown(exercise: Exercise, _look: Look) -> str:
    """The task, what is given, and the parts, without answers and hints."""
    lines = [markdown_heading(2, exercise.title), "", *_task(exercise.task), ""]
    for text in (*given_lines(exercise), *(how_written(exercise) if exercise.numeric else ())):
        lines += [markdown(text[0].upper() + text[1:]), ""]
    for number, part in enumerate(exercise.asked, 1):
        lines += [*_part(exercise, part, number), ""]
    return "\n".join(lines).rstrip("\n") + "\n"


def _task(text: str) -> Iterator[str]:
    """A text with its paragraphs; what is indented stays as it is typed."""
    for line in text.strip("\n").splitlines():
        yield f"{_INDENT}{one_line(line.strip())}" if line.startswith(_INDENT) else markdown(line)


def _part(exercise: Exercise, part: Part, number: int) -> Iterator[str]:
    """One item of a list, with how it is answered below."""
    credit = worth(exercise, part)
    asked = part.prompt.strip() or part.question.describe(exercise)
    said = f"{number}. **{markdown(part.id)}**: {markdown(' '.join(asked.split()))}"
    yield said + f" ({markdown(credit)})" * bool(credit)
    form = part.form(exercise) if part.prompt.strip() else ""
    notes = [*filter(None, form.splitlines()), *part.question.notes(exercise)]
    if notes:
        yield ""
        yield "   " + " \\\n   ".join(map(markdown, notes))
    if part.question.statements:
        yield ""
        yield from (f"   {n}. {markdown(option)}" for n, option in enumerate(part.question.statements, 1))
