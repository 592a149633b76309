"""How each language writes a function: its heading, a name for a value, a matrix, a loop; formulas are the writer's."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

from dhcli.notation.styles import Style
from dhcli.render.code.language import Cells, Language


def _lists(_shape: Sequence[str], _name: str, cells: Cells) -> list[str]:
    return ["return [", *(f"    [{', '.join(row)}]," for row in cells), "]"]


def _array(shape: Sequence[str], name: str, cells: Cells) -> list[str]:
    """Entries of an array that has the shape of the joint values before rows and columns."""
    size = f"({len(cells)}, {len(cells[0])})"
    shaped = f"np.broadcast({', '.join(shape)}).shape + {size}" if shape else size
    filled = [
        f"{name}[..., {i}, {k}] = {cell}" for i, row in enumerate(cells) for k, cell in enumerate(row) if cell != "0.0"
    ]
    return [f"{name} = np.zeros({shaped})", *filled, f"return {name}"]


def _stored(_shape: Sequence[str], name: str, cells: Cells) -> list[str]:
    return [f"{name}[{i}][{k}] = {cell};" for i, row in enumerate(cells) for k, cell in enumerate(row)]


def _in_commas(_shape: Sequence[str], name: str, cells: Cells) -> list[str]:
    rows = [", ".join(row) for row in cells]
    return [f"{name} = [", *(f"    {row};" for row in rows[:-1]), f"    {rows[-1]}];"]


def _in_blanks(_shape: Sequence[str], _name: str, cells: Cells) -> list[str]:
    """Cells with brackets where a blank or a sign in them would begin another."""
    rows = [" ".join(f"({cell})" if " " in cell or cell[0] == "-" else cell for cell in row) for row in cells]
    return ["return [", *(f"    {row}" for row in rows), "]"]


def _in_script(shape: Sequence[str], name: str, cells: Cells) -> list[str]:
    lines = _lists(shape, name, cells)
    return [*lines[:-1], "];"]


_PYTHON = Language(
    "python",
    style=Style(
        "python", caret="**", pi="math.pi", degrees=None, prefix="math.", decimal=True, functions={"abs": "fabs"}
    ),
    mark="#",
    first=("import math", "", ""),
    head="def {}({}):",
    argument="{}",
    preset="{}={}",
    let="{} = {}",
    choose="{0} = {2} if {1} else {3}",
    end="",
    returned=_lists,
    entry="{}[{}][{}]",
    base=0,
    signs="for {} in (1, -1):",
    turns="for {} in (0, math.pi):",
    quarters="for {} in (0, math.pi, math.pi/2, -math.pi/2):",
    skip="if {}:\n    {}",
    begin="solutions = []",
    append="solutions.append([{}])",
    finish="return solutions",
)

_NUMPY = replace(
    _PYTHON,
    name="numpy",
    style=replace(
        _PYTHON.style,
        pi="np.pi",
        prefix="np.",
        functions={"atan2": "arctan2", "acos": "arccos", "asin": "arcsin", "atan": "arctan"},
    ),
    first=("import numpy as np", "", ""),
    returned=_array,
    turns="for {} in (0, np.pi):",
    quarters="for {} in (0, np.pi, np.pi/2, -np.pi/2):",
)

_C = Language(
    "c",
    style=replace(_PYTHON.style, pi="pi", prefix="", power="pow({}, {})"),
    mark="//",
    first=("#include <math.h>", ""),
    head="{2} {0}({1})\n{{",
    argument="double {}",
    preset="double {}",
    let="const double {} = {};",
    choose="const double {} = {} ? {} : {};",
    end="}",
    returned=_stored,
    entry="{}[{}][{}]",
    base=0,
    signs="for (double {0} = 1; {0} > -2; {0} -= 2) {{",
    turns="for (double {0} = 0; {0} < 4; {0} += pi) {{",
    quarters="for (double {0} = 0; {0} < 6; {0} += pi/2) {{",
    skip="if ({})\n    {};",
    begin="int found = 0;",
    append="",
    finish="return found;",
    unused="(void){};",
)

_MATLAB = Language(
    "matlab",
    style=replace(_PYTHON.style, pi="pi", prefix="", caret="^", functions={}),
    mark="%",
    first=(),
    head="function {2} = {0}({1})",
    argument="{}",
    preset="{}",
    let="{} = {};",
    choose="if {1}, {0} = {2}; else, {0} = {3}; end",
    end="end",
    returned=_in_commas,
    entry="{}({}, {})",
    base=1,
    signs="for {} = [1, -1]",
    turns="for {} = [0, pi]",
    quarters="for {} = [0, pi, pi/2, -pi/2]",
    skip="if {}, {}, end",
    begin="solutions = [];",
    append="solutions(end + 1, :) = [{}];",
    finish="",
)

_JULIA = replace(
    _PYTHON,
    name="julia",
    style=replace(_MATLAB.style, functions={"atan2": "atan"}),
    first=(),
    head="function {}({})",
    choose="{} = {} ? {} : {}",
    end="end",
    returned=_in_blanks,
    entry="{}[{}, {}]",
    base=1,
    signs="for {} in (1, -1)",
    turns="for {} in (0, pi)",
    quarters="for {} in (0, pi, pi/2, -pi/2)",
    skip="if {}\n    {}\nend",
    begin="solutions = Vector{Float64}[]",
    append="push!(solutions, [{}])",
)

_JAVASCRIPT = replace(
    _C,
    name="javascript",
    # a minus before a power is a fault there
    style=replace(_C.style, pi="Math.PI", prefix="Math.", power="Math.pow({}, {})", functions={}),
    first=(),
    head="function {}({}) {{",
    argument="{}",
    preset="{} = {}",
    let="const {} = {};",
    choose="const {} = {} ? {} : {};",
    returned=_in_script,
    signs="for (const {} of [1, -1]) {{",
    turns="for (const {} of [0, Math.PI]) {{",
    quarters="for (const {} of [0, Math.PI, Math.PI/2, -Math.PI/2]) {{",
    skip="if ({}) {};",
    begin="const solutions = [];",
    append="solutions.push([{}]);",
    finish="return solutions;",
    unused="",
)

LANGUAGES: Mapping[str, Language] = {
    language.name: language for language in (_PYTHON, _NUMPY, _C, _MATLAB, _JULIA, _JAVASCRIPT)
}
"""The languages by the name the user gives them; where one writes as another does, it is told from that one."""
