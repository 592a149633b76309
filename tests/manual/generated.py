"""Pages of the manual that are made from the program itself."""

from __future__ import annotations

import contextlib
import inspect
import io
import os
import re
from collections.abc import Callable, Collection, Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import Any
from unittest.mock import patch

from dhcli.files.keys.shapes import Key, Scalar

MANUAL = Path(__file__).parents[2] / "dhcli" / "manual"


def index_page(head: str) -> str:
    """The list of all pages, behind what is written by hand."""
    from dhcli.files.manual import GROUPS, topics

    lines = [head.partition("\n## ")[0].rstrip(), ""]
    for group, heading in GROUPS.items():
        lines += [f"## {heading}", ""]
        lines += [f"- [`{one.name}`]({group}/{one.name}.md): {one.title}" for one in topics() if one.group == group]
        lines.append("")
    return "\n".join(lines)


def commands_page() -> str:
    """Every command with its help."""
    from dhcli.cli.app import PANELS

    lines = ["# Commands", "", "Each command as `--help` shows it.", ""]
    for panel, names in PANELS.items():
        lines += [f"## {panel}", ""]
        for name in names:
            lines += [f"### dhcli {name}", "", "```text", *_help_of(name), "```", ""]
    return "\n".join(lines)


def _help_of(*words: str) -> list[str]:
    from dhcli.cli.main import main

    screen = io.StringIO()
    environment = {"COLUMNS": "100", "TERMINAL_WIDTH": "100", "NO_COLOR": "1"}
    with contextlib.redirect_stdout(screen), patch.dict(os.environ, environment):
        main([*words, "--help"])
    lines = [line.rstrip() for line in screen.getvalue().strip("\n").splitlines()]
    return lines[next(i for i, line in enumerate(lines) if line.strip()) :]


def mistakes_page() -> str:
    """Every mistake that dhcli knows, by name."""
    from dhcli.checking.diagnosis.mistakes import EVERY
    from dhcli.checking.frames.slips import IN_FRAMES
    from dhcli.checking.motion.mistakes import IN_COLUMNS

    lines = [
        "# Mistakes by name",
        "",
        "The slips that dhcli looks for behind a wrong answer, and that an exercise may test itself with:",
        "`{part: t02, mistake: alpha-sign 2, verdict: WRONG}`. A number behind the name is the row, or row and column.",
        "",
        "| name | what has happened |",
        "|---|---|",
    ]
    lines += [f"| `{one.id}` | {_words(one.words)} |" for one in EVERY]
    lines += [
        "",
        "In the columns of a Jacobian, and so in its determinant, in torques, velocities and rates; the place behind",
        "the name is a joint or a frame, `joint-kind d3`, `in-frame 2`. `dhcli lint` lists those of a part that a",
        "misspelled name could mean.",
        "",
        "| name | what has happened |",
        "|---|---|",
    ]
    lines += [f"| `{one.id}` | {_words(one.words)} |" for one in IN_COLUMNS]
    lines += ["", "And on the way from the columns to each answer:", "", "| name | what has happened |", "|---|---|"]
    lines += [f"| `{name}` | {words} |" for name, words in _behind_columns({one.id for one in IN_COLUMNS}).items()]
    lines += [
        "",
        "In frames; the number behind the name is the frame. `convention` is one of them as well.",
        "",
        "| name | what has happened |",
        "|---|---|",
    ]
    lines += [f"| `{one.id}` | {_words(one.words)} |" for one in IN_FRAMES]
    return "\n".join([*lines, ""])


_ASKED = (
    ("articulated", "jacobian of 0..3"),
    ("articulated", "column 2 of jacobian analytic rpy of 0..3"),
    ("articulated", "determinant of jacobian linear of 0..3"),
    ("articulated", "singular when linear of 0..3"),
    ("ur5e", "singular when angular of 0..6"),
    ("articulated", "rank of jacobian linear of 0..3"),
    ("articulated", "manipulability of jacobian linear of 0..3"),
    ("articulated", "torques for (3, -2, 5) of 0..3"),
    ("articulated", "joint rates for (0.1, 0.2, 0.3) of 0..3"),
    ("articulated", "velocity of 0..3 with rates (1, 2, -1)"),
    ("articulated", "differential motion (0.1, 0.2, 0.3) turn (0.1, 0, 0.2) of 0..3"),
)
"""A question of each kind about motion."""


def _behind_columns(known: Collection[str]) -> dict[str, str]:
    """What else can go wrong in a question about motion, by name."""
    from dhcli import load_robot
    from dhcli.checking.judge import Judge
    from dhcli.checking.kinds.made import question_about
    from dhcli.kinematics.values import joint_values

    found: dict[str, str] = {}
    for name, ask in _ASKED:
        robot = load_robot(name)
        elbow = 0.0 if ask.startswith("rank") else 1.1  # a rank that is full has few slips
        given = joint_values(robot, [0.4, 0.7, elbow, -0.8, 1.3, 0.5][: len(robot.variables)])
        judge = Judge(question_about(robot, ask, numeric=True, given=given))
        for slip in judge.slips(judge.exercise.parts[0]):
            kind, _, where = slip.name.partition(" ")
            if kind not in known:
                found.setdefault(kind, slip.words.replace(where, "i") if where else slip.words)
    return found


_FRAMES = (("{before}", "i-1"), ("{other}", "i-1 or i+1"))


def _words(text: str) -> str:
    for name, shown in (("{where}", "i"), ("{row}", "i"), ("{entry}", "i"), ("{term}", "..."), *_FRAMES):
        text = text.replace(name, shown)
    return text.replace("|", "\\|")


def library_page(head: str) -> str:
    """The public names with their docstrings, behind what is written by hand."""
    import dhcli

    lines = [head.partition(MARK)[0].rstrip(), "", MARK, ""]
    for name in dhcli.__all__:
        found: Any = getattr(dhcli, name)
        if isinstance(found, str):
            continue
        lines += [f"### {name}", "", "```text", f"{name}{_signature(found)}", ""]
        lines += [*(inspect.getdoc(found) or "").splitlines(), "```", ""]
        for method, function in _methods(found):
            lines += ["```text", f"{name}.{method}{_signature(function)}", ""]
            lines += [*(inspect.getdoc(function) or "").splitlines(), "```", ""]
    return "\n".join(lines)


def _methods(found: object) -> list[tuple[str, Callable[..., object]]]:
    """The public methods that a class itself tells about, and those of a matrix."""
    from dhcli.kinematics.matrix import Matrix

    classes = [one for one in found.__mro__ if one in (found, Matrix)] if isinstance(found, type) else []
    names = dict.fromkeys(name for one in classes for name in vars(one) if not name.startswith("_"))
    named = [(name, getattr(found, name)) for name in names]
    return [(name, one) for name, one in named if inspect.isroutine(one) and one.__doc__]


class _Bare(str):
    """An annotation that is shown as it stands in the source; a default in quotes keeps them."""

    __slots__ = ()

    def __repr__(self) -> str:
        return str(self)


def _signature(found: Callable[..., object]) -> str:
    try:
        signature = inspect.signature(found)
    except (TypeError, ValueError):
        return ""
    shown = [each.replace(annotation=_shown(each.annotation)) for each in signature.parameters.values()]
    bare = signature.replace(parameters=shown, return_annotation=_shown(signature.return_annotation))
    return re.sub(r"<[^>]*>", "...", str(bare))


def _shown(annotation: object) -> object:
    return _Bare(annotation.replace("'", "")) if isinstance(annotation, str) else annotation


def keys_page(page: Path, tables: Mapping[str, Sequence[Key]]) -> str:
    """The keys of a kind of file, behind what is written by hand."""
    lines = [page.read_text("utf-8").partition(KEYS_MARK)[0].rstrip(), "", KEYS_MARK, ""]
    lines += ["`dhcli schema` has the same for [editors](../howto/schema.md).", ""]
    for heading, keys in tables.items():
        lines += [heading, "", "| key | means |", "|---|---|"] if heading else ["| key | means |", "|---|---|"]
        for key in keys:
            shown = f"`{key.example or key.name}`{', required' * key.is_required}"
            lines.append(f"| {shown} | {_words(_means(key))} |")
        lines.append("")
    return "\n".join(lines)


def _means(key: Key) -> str:
    words = key.holds.words if isinstance(key.holds, Scalar) else ()
    listed = ", ".join(words)
    is_told = all(word in key.means for word in words) or words in (("true", "false"), ("yes", "no", "true", "false"))
    return key.means if is_told else f"{key.means} ({listed})"


def key_tables() -> dict[Path, Callable[[], str]]:
    """The pages that end with the keys of a kind of file."""
    from dhcli.files.keys import exercises, linkages, robots
    from dhcli.files.keys.shapes import ROW

    def only(keys: Sequence[Key], of: Sequence[Key]) -> list[Key]:
        return [key for key in keys if key not in of]

    products = only(robots.PRODUCTS, robots.TABLE)
    robot = {
        "": robots.TABLE,
        "A row of `links:`": [*ROW, robots.BETA],
        "With `convention: product`": products,
        "With `convention: axes`, in the place of `links`, `first`, `base`, `tool` and `tools`": only(
            robots.AXES, robots.TABLE
        ),
        "With `convention: screws`, likewise": only(robots.SCREWS, robots.TABLE),
    }
    exercise = {
        "": exercises.EXERCISE,
        "A part": exercises.PART,
        "Under `tolerance:`": exercises.TOLERANCE,
        "Under `credit:`, in a part too, which has `points: 2` besides": exercises.SHARES,
        "Under `source:`": exercises.SOURCE,
        "Under `also:`": exercises.ALSO,
        "Under a part of `printed:`": exercises.PRINTED,
        "A test": exercises.TEST,
    }
    linkage = {
        "": linkages.LINKAGE,
        "A joint": linkages.JOINT,
        "Under `loop:`": linkages.LOOP,
        "A row of `loop:`": linkages.LOOP_ROW,
    }
    folder = MANUAL / "reference"
    tables = {"robot": robot, "exercise": exercise, "linkage": linkage}
    return {
        (page := folder / f"{kind}-files.md"): partial(keys_page, page, of_kind) for kind, of_kind in tables.items()
    }


MARK = "## Every name"
KEYS_MARK = "## Every key"
LIBRARY = MANUAL / "reference" / "library.md"
INDEX = MANUAL / "index.md"
PICTURES = MANUAL / "howto"


def picture(name: str) -> str:
    """A robot as README and the manual show it."""
    import dhcli

    return dhcli.draw(dhcli.load_robot(name)).svg()


GENERATED: dict[Path, Callable[[], str]] = {
    INDEX: lambda: index_page(INDEX.read_text("utf-8")),
    MANUAL / "reference" / "commands.md": commands_page,
    MANUAL / "reference" / "mistakes.md": mistakes_page,
    PICTURES / "puma560.svg": lambda: picture("puma560"),
    PICTURES / "stanford.svg": lambda: picture("stanford"),
    LIBRARY: lambda: library_page(LIBRARY.read_text("utf-8")),
    **key_tables(),
}
"""Each page that is made, and what makes it."""
