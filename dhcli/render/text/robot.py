"""A robot on one page: its table, joints, parameters, poses, and where the numbers come from."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Any

from dhcli.errors import plural
from dhcli.files.yaml.prose import folded
from dhcli.kinematics.conventions import LETTERS, NAMES, ORDER, Convention
from dhcli.kinematics.moves import Chain, angle_names, expressions, spelled
from dhcli.kinematics.robot import Joint, Link, Robot
from dhcli.notation.quantity import value_text
from dhcli.notation.walk import symbols
from dhcli.notation.writer import write, write_value
from dhcli.render.code.matrices import csv_line
from dhcli.render.look import Look
from dhcli.render.paper import Paper
from dhcli.render.text.motors import actuators_content
from dhcli.render.text.prose import WIDEST
from dhcli.render.text.quantities import in_degrees, in_units
from dhcli.render.text.table import Inked, table_text
from dhcli.safe import csv_cell, latex

_BESIDES = 12
"""Columns of a table of products besides those of products and joints: numbers, gaps, a `*` at the end of a line."""
_LEAST = 20
"""Columns that a product has, however narrow the terminal is."""


def heads(robot: Robot) -> tuple[str, ...]:
    """The heads of the table in the file's order: `a_{i-1}` where the convention counts so."""
    before = {"a", "alpha"} if robot.convention is Convention.MODIFIED else set()
    return tuple(
        f"{LETTERS[column]}_{{i-1}}" if column in before else f"{LETTERS[column]}_i" for column in robot.columns
    )


def robot_table(robot: Robot, look: Look) -> str:
    """A page about a robot."""
    paper = look.paper
    count = plural(len(robot.joints), "joint") + f" {robot.pattern}" * bool(robot.joints)
    facts = f"{robot.name} · {NAMES[robot.convention]} · {count}"
    blocks = [
        f"{paper.ink(paper.spell(robot.title), 'bold')}\n{paper.ink(paper.spell(facts), 'dim')}\n",
        links_table(robot, look),
        *filter(None, (part(robot, look) for part in (_joints, _motors, _parameters, _poses, _ends))),
        *(
            _prose(name, text, paper)
            for name, text in (("Notes", robot.notes), ("Source", robot.source))
            if text.strip()
        ),
    ]
    return "\n".join(blocks)


def robot_csv(robot: Robot, _look: Look) -> str:
    """The rows of the table, or the products."""
    if robot.convention is Convention.PRODUCT:
        products = (csv_line([str(link.number), csv_cell(link.product)]) for link in robot.links)
        return csv_line(["i", "product"]) + "".join(products)
    lines = [csv_line(["i", *robot.columns])]
    lines += [csv_line([str(link.number), *_row(robot, link, "full")]) for link in robot.links]
    return "".join(lines)


def robot_latex(robot: Robot, look: Look) -> str:
    """The table for a paper."""
    if robot.convention is Convention.PRODUCT:
        rows = [[str(link.number), rf"\texttt{{{latex(product_text(link, look))}}}"] for link in robot.links]
        titles = ["$i$", "product"]
    else:
        titles, *rows = formula_rows(robot)
    body = "".join(f"  {' & '.join(row)} \\\\\n" for row in rows)
    columns = "c" + ("l" if robot.convention is Convention.PRODUCT else "c" * len(robot.columns))
    return f"\\begin{{tabular}}{{{columns}}}\n  {' & '.join(titles)} \\\\ \\hline\n{body}\\end{{tabular}}\n"


def formula_rows(robot: Robot) -> list[list[str]]:
    """The heads and the rows of a DH table as formulas between dollar signs."""
    letters = (head.replace("α", r"\alpha").replace("θ", r"\theta") for head in heads(robot))
    rows = [[str(link.number), *(f"${cell}$" for cell in _row(robot, link, "latex"))] for link in robot.links]
    return [["$i$", *(f"${head}$" for head in letters)], *rows]


def robot_content(robot: Robot, _look: Look) -> dict[str, Any]:
    """A robot as JSON holds it: constants in radians and metres, cells of the table as text."""
    return {
        "name": robot.name,
        "title": robot.title,
        "source": robot.source,
        "notes": robot.notes,
        "convention": robot.convention.value,
        "pattern": robot.pattern,
        "frames": list(robot.frames),
        "columns": [] if robot.convention is Convention.PRODUCT else list(robot.columns),
        "links": [_link_content(robot, link) for link in robot.links],
        "joints": [_joint_content(robot, joint) for joint in robot.joints],
        "parameters": {n: None if value is None else in_units(value) for n, value in robot.parameters.items()},
        "poses": {n: [in_units(v) for v in values] for n, values in robot.poses.items()},
        "base": _product(robot, robot.base),
        "tool": _product(robot, robot.tool),
        "actuators": None if robot.actuators is None else actuators_content(robot.actuators),
        "tools": {name: _product(robot, chain) for name, chain in robot.tools.items()},
    }


def _link_content(robot: Robot, link: Link) -> dict[str, Any]:
    if link.row is None:
        return {"number": link.number, "product": link.product}
    return {"number": link.number, **dict(zip(robot.columns, _row(robot, link, "full"), strict=True))}


def _joint_content(robot: Robot, joint: Joint) -> dict[str, Any]:
    limits = robot.limits.get(joint.name)
    return {
        "name": joint.name,
        "kind": joint.kind,
        "link": joint.link,
        "called": robot.called.get(joint.name),
        "limits": None if limits is None else [in_units(limit) for limit in limits],
    }


def _row(robot: Robot, link: Link, style: str) -> list[str]:
    """The cells of a DH row in the order of the file."""
    return [write_value(getattr(link.row, column), style, robot.writing) for column in robot.columns]


def product_text(link: Link, look: Look) -> str:
    """A link's product, as somebody has written it, else with few decimals."""
    return look.formula(link.product) if link.text else look.shown(link.product)


def links_table(robot: Robot, look: Look) -> str:
    """The DH table with the order of its operations, or the products."""
    paper = look.paper
    rows: list[list[str]] = []
    is_product = robot.convention is Convention.PRODUCT
    kinds = [_kind(robot, link) for link in robot.links]
    room = paper.width - max(map(len, kinds), default=0) - _BESIDES if is_product and paper.terminal else None
    for link, kind in zip(robot.links, kinds, strict=True):
        product = product_text(link, look)
        cells, *more = [[product]] if link.row is None else [list(map(look.formula, _row(robot, link, "short")))]
        if room is not None:
            cells, *more = ([line] for line in _in_lines(product, room))
        rows.append([str(link.number), *(_underlined(cell, robot, paper) for cell in cells), kind])
        rows += (["", _underlined(line, robot, paper), ""] for (line,) in more)
    table = table_text(["i", *(("A_i",) if is_product else heads(robot)), "joint"], rows, paper)
    order = ORDER[robot.convention].replace("alpha_", "α_").replace("theta_", "θ_")
    return table + paper.ink(paper.spell(order), "dim") + "\n"


def _in_lines(product: str, width: int) -> Iterator[str]:
    """A product in lines no wider than a terminal has room for, each but the last with its `*` at the end."""
    line = ""
    for factor in product.split(" * "):
        longer = f"{line} * {factor}" if line else factor
        if line and len(longer) > max(width, _LEAST):
            yield f"{line} *"
            longer = factor
        line = longer
    yield line


def _kind(robot: Robot, link: Link) -> str:
    """What moves a link: a joint that turns, one that slides, a screw that does both, or nothing."""
    moving = robot.movers[link.number]
    turns = not moving.isdisjoint(angle_names(link.moves))
    slides = any(not moving.isdisjoint(symbols(expr)) for expr in expressions(link.moves))
    return ("helical" if slides else "revolute") if turns else "prismatic" if slides else "fixed"


def _underlined(cell: str, robot: Robot, paper: Paper) -> Inked:
    names = "|".join(map(re.escape, sorted(robot.variables, key=len, reverse=True)))
    whole = rf"(?<![A-Za-z0-9_])(?:{names})(?![A-Za-z0-9_])"
    return Inked(re.sub(whole, lambda name: paper.ink(name[0], "underline"), paper.spell(cell)) if names else cell)


def _joints(robot: Robot, look: Look) -> str:
    """The limits of the joints, and what they are called elsewhere."""
    heads = (["called"] if robot.called else []) + (["from", "to"] if robot.limits else [])
    if not heads:
        return ""
    rows = []
    for joint in robot.joints:
        limits = map(in_degrees, robot.limits.get(joint.name, ()))
        called = robot.called.get(joint.name, "")
        rows.append([joint.name, *([called] if robot.called else []), *limits, *([""] * len(heads))][: len(heads) + 1])
    return table_text(["limits" if robot.limits else "joint", *heads], rows, look.paper)


def _motors(robot: Robot, look: Look) -> str:
    """What the motors do, where they drive joints together."""
    if robot.actuators is None:
        return ""
    lines = (f"  {look.paper.spell(sentence)}\n" for sentence in robot.actuators.sentences())
    return look.paper.ink("motors", "bold") + "\n" + "".join(lines)


def _parameters(robot: Robot, look: Look) -> str:
    if not robot.parameters:
        return ""
    rows = [
        [name, _formula(robot, name) + ("no value" if value is None else value_text(value))]
        for name, value in robot.parameters.items()
    ]
    return table_text(["parameter", "value"], rows, look.paper)


def _formula(robot: Robot, name: str) -> str:
    """What a parameter is in terms of others."""
    return f"{write(robot.derived[name].expr, 'full', robot.writing)} = " if name in robot.derived else ""


def _poses(robot: Robot, look: Look) -> str:
    if not robot.poses:
        return ""
    rows = [[name, *map(in_degrees, values)] for name, values in robot.poses.items()]
    return table_text(["pose", *robot.variables], rows, look.paper)


def _ends(robot: Robot, look: Look) -> str:
    """Base and tool, where there are any."""
    paper = look.paper
    ends = [(name, chain) for name, chain in (("base", robot.base), ("tool", robot.tool)) if chain]
    ends += [(f"tool {paper.spell(name)}", chain) for name, chain in robot.tools.items()]
    return "".join(f"{paper.ink(name, 'bold')}  {paper.spell(_product(robot, chain))}\n" for name, chain in ends)


def _product(robot: Robot, chain: Chain) -> str:
    return " ".join(spelled(move, robot.writing) for move in chain)


def _prose(name: str, text: str, paper: Paper) -> str:
    spelled = "\n".join(map(paper.spell, text.strip().split("\n")))
    return "\n".join([paper.ink(name, "bold"), *folded(spelled, min(paper.width, WIDEST), "  ", "  "), ""])
