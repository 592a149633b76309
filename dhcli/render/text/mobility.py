"""The answer of `dof`: what was counted, whether to believe it, and why not."""

from __future__ import annotations

import textwrap
from collections.abc import Iterable
from typing import Any

from dhcli.errors import plural
from dhcli.mobility.counting import Counts
from dhcli.mobility.linkage import Joint, Linkage
from dhcli.mobility.result import Mobility
from dhcli.notation.tree import Expr, Number
from dhcli.notation.writer import write
from dhcli.render.look import Look
from dhcli.render.paper import Paper
from dhcli.render.text.table import table_text

MOST_ROWS = 60
"""Joints that are listed one by one; of longer chains only the kinds are."""

NARROW = 78
"""Columns at which sentences are folded, so that they fit the narrowest usual window."""

ROUNDING = 1e-12
"""A singular value below this is rounding, whose digits differ from machine to machine."""


def mobility_table(found: Mobility, look: Look) -> str:
    """The whole answer, to be read from top to bottom."""
    blocks = [_head(found, look.paper), _joints(found, look), _formula(found, look.paper), _truth(found, look.paper)]
    return "\n".join(block for block in blocks if block)


def linkage_table(linkage: Linkage | Counts, look: Look) -> str:
    """A linkage as `show` has it: its joints and where it comes from, without an answer."""
    if isinstance(linkage, Counts):
        return "\n".join([_head(Mobility(linkage), look.paper), _groups(linkage, look)])
    found = Mobility(Counts.of(linkage), linkage)
    blocks = [_head(found, look.paper), _joints(found, look)]
    for name, text in (("Notes", linkage.notes), ("Source", linkage.source)):
        if text.strip():
            blocks.append(
                f"{look.paper.ink(name, 'bold')}\n"
                + "".join(_folded(line, look.paper) for line in text.strip().split("\n"))
            )
    return "\n".join(blocks)


def mobility_content(found: Mobility, _look: Look) -> dict[str, Any]:
    """The answer as JSON holds it."""
    return {
        "mobility": found.mobility,
        "gruebler": _number(found.counts.by_freedoms),
        "instantaneous": found.instantaneous,
        "bounds": None if found.bounds is None else list(found.bounds),
        "certificate": found.certificate,
        "formula_holds": found.formula_holds,
        "formulas": list(found.counts.formulas),
        **counts_content(found.counts),
        "joints_listed": []
        if found.linkage is None
        else [_joint(joint, found.linkage) for joint in found.linkage.joints],
        "other_reading": None
        if found.other is None
        else {"reading": found.other.reading, "gruebler": found.other.gruebler},
        "loops": list(found.lambdas),
        "idle": list(found.idle),
        "redundant": found.redundant,
        "output": found.output or None,
        "motion": found.motion or None,
        "branches": list(found.branches),
        "order": found.order,
        "singular_values": list(found.singular_values),
        "kept": found.kept,
        "dropped": found.dropped,
        "reasons": list(found.reasons),
        "settles": found.settles,
    }


def linkage_content(linkage: Linkage | Counts, _look: Look) -> dict[str, Any]:
    """A linkage as JSON holds it."""
    if isinstance(linkage, Counts):
        return {"title": linkage.title, **counts_content(linkage), "joints_listed": []}
    return {
        "name": linkage.name,
        "title": linkage.title,
        "source": linkage.source,
        "notes": linkage.notes,
        "ground": linkage.ground,
        "output": linkage.output or None,
        "link_names": list(linkage.links),
        "placed": linkage.is_placed,
        **counts_content(Counts.of(linkage)),
        "joints_listed": [_joint(joint, linkage) for joint in linkage.joints],
    }


def counts_content(counts: Counts) -> dict[str, Any]:
    """What went into the formula."""
    return {
        "space": str(counts.space),
        "lambda": counts.space.lambda_,
        "links": _number(counts.n),
        "joints": _number(counts.j),
        "sum_f": _number(counts.sum_f),
        "sum_c": _number(counts.sum_c),
        "reading": counts.reading or None,
    }


def _joint(joint: Joint, linkage: Linkage) -> dict[str, Any]:
    f, c = linkage.space.freedoms(joint.pair), linkage.space.constraints(joint.pair)
    return {"name": joint.name, "type": joint.pair.name, "links": list(joint.links), "f": f, "C": c}


def _number(expr: Expr) -> int | str:
    return int(expr.value) if isinstance(expr, Number) else write(expr, "sympy")


def _head(found: Mobility, paper: Paper) -> str:
    """Title, and what was counted."""
    counts, linkage = found.counts, found.linkage
    title = (linkage.title or linkage.name if linkage else counts.title) or "linkage"
    facts = [str(counts.space) if counts.space.name else "", f"λ = {counts.space.lambda_}"]
    facts += [f"n = {write(counts.n)} links with the ground", f"j = {write(counts.j)} joints"]
    if linkage and linkage.loops:
        facts.append(plural(linkage.loops, "loop"))
    lines = paper.ink(paper.spell(title), "bold") + "\n" + _folded(" · ".join(filter(None, facts)), paper, indent="")
    if counts.reading:
        lines += _folded(f"read as: {counts.reading}", paper, indent="")
    if found.other is not None:
        text = f"read as {found.other.reading} it would have F = {found.other.gruebler}"
        bare = counts.title.removeprefix("loop ")
        typed = f"loop {bare}" if "loop" in found.other.reading else bare
        lines += _folded(f"{text}; for that type: {typed}", paper, indent="")
    return lines


def _joints(found: Mobility, look: Look) -> str:
    """Each joint with f and C."""
    linkage = found.linkage
    if linkage is None or len(linkage.joints) > MOST_ROWS:
        return _groups(found.counts, look)
    rows = []
    for joint in linkage.joints:
        f, c = linkage.space.freedoms(joint.pair), linkage.space.constraints(joint.pair)
        rows.append([joint.name, joint.pair.name, " - ".join(joint.links), str(f), str(c)])
    rows.append(["", "", "together", write(found.counts.sum_f), write(found.counts.sum_c)])
    return table_text(["joint", "type", "between", "f", "C"], rows, look.paper)


def _groups(counts: Counts, look: Look) -> str:
    """The joints by kind."""
    rows = [[write(group.count), group.pair.name, str(group.f), str(group.c)] for group in counts.groups]
    rows.append([write(counts.j), "together", write(counts.sum_f), write(counts.sum_c)])
    return table_text(["number", "type", "f each", "C each"], rows, look.paper)


def _formula(found: Mobility, paper: Paper) -> str:
    """Both forms, with the numbers filled in."""
    lines = "".join(f"  {line}\n" for form in found.counts.formulas for line in _wrapped(form, _room(paper) - 2, paper))
    return paper.ink("What the formula gives", "bold") + "\n" + lines


def _truth(found: Mobility, paper: Paper) -> str:
    """Whether to believe it, the truth, and why they differ."""
    if found.mobility is None and found.bounds is None:
        return paper.ink("Can it be trusted?", "bold") + "\n" + _folded(found.settles, paper)
    if found.mobility is None:
        low, high = found.bounds or (0, 0)
        verdict, ink = f"Undecided: between {low} and {high}.", "yellow"
    elif found.formula_holds:
        verdict, ink = f"Yes: the mobility is {found.mobility}, as the formula says.", "green"
    else:
        verdict, ink = f"No: the mobility is {found.mobility}, not {found.gruebler}.", "red"
    lines = (
        paper.ink("Can it be trusted?", "bold")
        + "\n"
        + "".join(f"  {paper.ink(line, 'bold', ink)}\n" for line in _wrapped(verdict, _room(paper) - 2, paper))
    )
    lines += "".join(_folded(reason, paper) for reason in found.reasons)
    lines += "".join(_folded(f"Idle: {idle}.", paper) for idle in found.idle)
    return lines + "\n" + _details(found, paper)


def _details(found: Mobility, paper: Paper) -> str:
    """The figures behind the verdict."""
    rows: list[tuple[str, str]] = [("mobility", _mobility(found))]
    rows.append(("certain?", found.certificate))
    if found.instantaneous is not None:
        rows.append(("at this instant", str(found.instantaneous)))
    if found.redundant:
        many = plural(abs(found.redundant), "constraint") + (" repeats" if found.redundant == 1 else " repeat")
        rows.append(
            (
                "redundant",
                f"{many} others" if found.redundant > 0 else f"{plural(-found.redundant, 'freedom')} less than counted",
            )
        )
    if found.motion:
        rows.append((f"motion of {found.output}", _motion(found.motion)))
    if found.lambdas and not all(loop == found.counts.space.lambda_ for loop in found.lambdas):
        rows.append(("λ of the loops", ", ".join(map(str, found.lambdas))))
    if found.kept is not None or found.dropped is not None:
        kept = "none" if found.kept is None else f"{found.kept:.1e}"
        dropped = "none" if found.dropped is None else f"{found.dropped:.1e}"
        if found.dropped is not None and found.dropped < ROUNDING:
            dropped = f"below {ROUNDING:.0e}"
        rows.append(("singular values", f"smallest kept {kept}, largest dropped {dropped} (largest 1)"))
    width = min(max(len(name) for name, _ in rows), 24)
    text = ""
    for name, value in rows:
        first, *rest = _wrapped(value, max(_room(paper) - width - 4, 12), paper)
        text += f"  {paper.ink(paper.spell(name).ljust(width), 'dim')}  {first}\n"
        text += "".join(f"  {' ' * width}  {line}\n" for line in rest)
    return (
        text + _folded("Mobility is a property of the position and assembly given.", paper) if found.lambdas else text
    )


def _mobility(found: Mobility) -> str:
    if found.mobility is None:
        low, high = found.bounds or (0, 0)
        return f"undecided, between {low} and {high}"
    idle = len(found.idle)
    return f"{found.mobility}" + (f" ({found.mobility - idle} and {idle} idle)" if idle else "")


def _motion(motion: str) -> str:
    """`2T1R: 2 translations, 1 rotation`."""
    numbers = ((int(motion[0]), "translation"), (int(motion[2]), "rotation"))
    words = [plural(count, noun) for count, noun in numbers if count]
    return f"{motion}: {', '.join(words) or 'none'}"


def _folded(text: str, paper: Paper, indent: str = "  ") -> str:
    return "".join(f"{indent}{line}\n" for line in _wrapped(text, _room(paper) - len(indent), paper))


def _wrapped(text: str, width: int, paper: Paper) -> Iterable[str]:
    return textwrap.wrap(paper.spell(text), width, break_long_words=False, break_on_hyphens=False) or [""]


def _room(paper: Paper) -> int:
    """Columns for sentences."""
    return min(NARROW, paper.width)
