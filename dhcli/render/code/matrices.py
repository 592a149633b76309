"""Matrices and points for programs and papers: LaTeX, MATLAB, numpy, sympy, CSV; numbers in full precision."""

from __future__ import annotations

import csv
import io
import re
from collections.abc import Collection, Iterable, Sequence
from typing import TYPE_CHECKING

from dhcli.frozen import frozen
from dhcli.notation.names import natural_key
from dhcli.notation.styles import Joints, identifier, latex_name
from dhcli.notation.tree import Expr
from dhcli.notation.walk import symbols
from dhcli.notation.writer import write
from dhcli.render.look import Look
from dhcli.safe import comment as comment_line
from dhcli.safe import one_line

if TYPE_CHECKING:
    from dhcli.kinematics.question import AnyPose
    from dhcli.notation.let import Definition

_SPELLING = {"csv": "sympy", "json": "sympy"}
"""Formats whose formulas are spelled as another one spells them."""


def entry(value: Expr | float, joints: Joints, look: Look) -> str:
    """One entry as its format spells it."""
    if isinstance(value, Expr):
        text = write(value, look.style or _SPELLING.get(look.format, look.format), joints)
        return look.shown(text) if look.format == "latex" else text
    if look.format == "latex":
        return look.number(value)
    return repr(exact(value))


def exact(value: float) -> float:
    """A number for a program: as computed, whatever decimals people are shown; never minus zero."""
    return float(value) + 0.0


def pose_source(
    pose: AnyPose, look: Look, *, comment: str, named: bool = False, definitions: Sequence[Definition] = ()
) -> str:
    """A matrix in the language of the format, with what it is in a comment where that language has comments.

    Args:
        pose: The matrix.
        look: The format, and decimals.
        comment: What the matrix is.
        named: Whether it is one of several and needs a name.
        definitions: Names that stand in it for brackets, which come first.
    """
    own = pose.name if named else ""
    return matrix_source(pose.rows, pose.joints, look, comment=comment, name=own, definitions=definitions)


@frozen
class Letter:
    """What a matrix without a name is called where a language wants one."""

    letter: str


def matrix_source(
    entries: Sequence[Sequence[Expr | float]],
    joints: Joints,
    look: Look,
    *,
    comment: str,
    name: str | Letter,
    definitions: Sequence[Definition] = (),
) -> str:
    """Any matrix in the language of the format; see `pose_source`.

    Args:
        entries: Its rows.
        joints: The robot's joint angles.
        look: The format, and decimals.
        comment: What the matrix is.
        name: Its name, if it needs one; or a letter for where a language wants a name.
        definitions: Names that stand in it for brackets, which come first.
    """
    rows = [[entry(value, joints, look) for value in row] for row in entries]
    lets = [(one.name, entry(one.expr, joints, look)) for one in definitions]
    letter = name.letter if isinstance(name, Letter) else "T"
    label = "" if isinstance(name, Letter) else name
    named = variable(label)
    if look.format == "latex":
        before = "".join(f"{latex_name(short)} = {text} \\\\\n" for short, text in lets)
        return before + (f"{latex_label(label)} = " if named else "") + _latex(rows)
    if look.format == "matlab":
        names = _syms([*entries, [one.expr for one in definitions]], without={one.name for one in definitions})
        before = "".join(f"{short} = {text};\n" for short, text in lets)
        return f"{comment_line(comment, '%')}{names}{before}{named or letter} = {_matlab(rows)};\n"
    if look.format == "sympy":
        return (f"{named} = " if named else "") + f"Matrix([{', '.join('[' + ', '.join(row) + ']' for row in rows)}])\n"
    before = "".join(f"{short} = {text}\n" for short, text in lets)
    head = "import numpy as np\n\n" if look.in_file else ""
    said = comment_line(comment, "#")
    return f"{head}{said}{before}" + (f"{named or letter} = " if named or look.in_file else "") + _numpy(rows)


def vector_source(values: Sequence[Expr | float], joints: Joints, look: Look) -> str:
    """A column of three in the language of the format."""
    cells = [entry(value, joints, look) for value in values]
    if look.format == "latex":
        return _latex([[text] for text in cells])
    if look.format == "matlab":
        return f"{_syms([values])}p = [{'; '.join(cells)}];\n"
    if look.format == "sympy":
        return f"Matrix([{', '.join(cells)}])\n"
    return f"np.array([{', '.join(cells)}])\n"


def csv_rows(rows: Sequence[Sequence[Expr | float]], joints: Joints, look: Look) -> str:
    """Rows of entries, formulas as sympy reads them."""
    return "".join(csv_line([entry(value, joints, look) for value in row]) for row in rows)


def csv_line(cells: Iterable[str]) -> str:
    """One line of a CSV file, cells quoted where they need it; what somebody else wrote is a `csv_cell` before."""
    text, cells = io.StringIO(), list(cells)
    is_plain = "".join(cells).isprintable()  # as nearly every line is, which may have many cells
    csv.writer(text, lineterminator="\n").writerow(cells if is_plain else map(one_line, cells))
    return text.getvalue()


def variable(name: str) -> str:
    """The name of a matrix as programs accept it: `T_03`, `A_1_inv`, `Rot_z_theta1`."""
    return re.sub(r"\W+", "_", name.replace("^-1", "_inv")).strip("_")


def latex_label(name: str) -> str:
    r"""The name of a matrix in LaTeX: `T_{03}`, `A_{1}^{-1}`; a factor is upright text."""
    stem, power, _ = name.partition("^-1")
    if stem.partition("_")[0] not in ("T", "A"):
        return rf"\mathrm{{{stem}}}"
    return latex_name(stem) + ("^{-1}" if power else "")


def _latex(rows: Sequence[Sequence[str]]) -> str:
    body = " \\\\\n".join("  " + " & ".join(row) for row in rows)
    return f"\\begin{{bmatrix}}\n{body}\n\\end{{bmatrix}}\n"


def _matlab(rows: Sequence[Sequence[str]]) -> str:
    # Blanks inside a cell would begin a new one: MATLAB reads `[a -b]` as two.
    return "[" + "; ".join(", ".join(row) for row in rows) + "]"


def _numpy(rows: Sequence[Sequence[str]]) -> str:
    return "np.array([" + ",\n          ".join("[" + ", ".join(row) + "]" for row in rows) + "])\n"


def _syms(rows: Sequence[Sequence[Expr | float]], without: Collection[str] = ()) -> str:
    """The line that tells MATLAB which names are symbols."""
    names = {n for row in rows for value in row if isinstance(value, Expr) for n in symbols(value)} - set(without)
    return (
        f"syms {' '.join(identifier(name, 'matlab') for name in sorted(names, key=natural_key))} real\n"
        if names
        else ""
    )
