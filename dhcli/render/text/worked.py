"""Solutions worked out step by step; what one part has in common with another is shown once."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import takewhile

from dhcli.checking.exercise import Exercise, Part
from dhcli.checking.returned import Shown
from dhcli.render.look import Look
from dhcli.render.paper import Paper
from dhcli.render.text.marks import question_text
from dhcli.render.text.matrix import matrix_lines
from dhcli.render.text.prose import prose_lines

FEWEST = 7
"""Lines that two parts begin with before they are told as those of the first: more than one link and its matrix."""


def solutions_text(exercise: Exercise, steps: Mapping[str, Sequence[Shown]], paper: Paper) -> str:
    """The solutions of parts, each matrix under what it is.

    Args:
        exercise: The exercise.
        steps: The steps of each part by its name, in order.
        paper: Where they are written.
    """
    names = list(steps)
    texts = []
    for k, name in enumerate(names):
        told = since(steps[name], {other: steps[other] for other in names[:k]})
        texts.append(_solution_text(exercise, exercise.part(name), told, paper))
    return "\n".join(texts)


def since(steps: Sequence[Shown], earlier: Mapping[str, Sequence[Shown]]) -> tuple[Shown, ...]:
    """The steps of a part from where they leave those of an earlier one, with the matrix that these have led to."""
    shared = {name: _in_common(steps, others) for name, others in earlier.items()}
    name = max(shared, key=lambda one: shared[one], default="")
    count = shared.get(name, 0)
    if sum(len(step.text.splitlines()) + len(step.rows) for step in steps[:count]) < FEWEST:
        return tuple(steps)
    reached = [step for step in steps[:count] if step.rows][-1:]
    return (Shown(f"As for {name}, up to" if reached else f"As for {name}; then"), *reached, *steps[count:])


def _in_common(first: Sequence[Shown], second: Sequence[Shown]) -> int:
    """How many steps two solutions begin with; the answer is one of its own."""
    pairs = zip(first[:-1], second[:-1], strict=False)
    return sum(1 for _ in takewhile(lambda pair: pair[0] == pair[1], pairs))


def _solution_text(exercise: Exercise, part: Part, steps: Sequence[Shown], paper: Paper) -> str:
    lines = [question_text(exercise, part, paper, whole=True).rstrip("\n")]
    for step in steps:
        lines += ["", *(line for text in step.text.splitlines() for line in prose_lines(text, paper))]
        if step.rows:
            lines += matrix_lines(step.rows, exercise.writing, Look(paper=paper))
    return "\n".join(lines) + "\n"
