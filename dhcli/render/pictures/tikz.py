"""A figure as TikZ: it compiles with a plain LaTeX, takes the fonts around it, and can be edited by hand."""

from __future__ import annotations

import math
from functools import partial

from dhcli.kinematics.entries import rounded
from dhcli.notation.names import GREEK
from dhcli.render.pictures.looks import COLOURS, LOOKS, TEXTS, UPRIGHT, Look
from dhcli.safe import comment
from dhcli.scene.shapes import Figure, Shape, Text
from dhcli.scene.vectors import Flat
from dhcli.scene.words import Words

_number = partial(rounded, digits=2)

PIXEL = 0.5
"""A pixel of the figure in points: 820 of them fit the text of a page."""

_SPECIAL = {c: "\\" + c for c in "#$%&_{}"} | {
    "\\": r"\textbackslash{}",
    "~": r"\textasciitilde{}",
    "^": r"\textasciicircum{}",
}
_SIGNS = {"−": "-", "′": "'", "·": r"\cdot ", "π": r"\pi ", "°": r"^\circ "}


def tikz(figure: Figure, *, dark: bool = False, size: tuple[int, int] | None = None) -> str:
    """A `tikzpicture`, with a document around it that a comment turns off.

    Args:
        figure: The figure.
        dark: Whether it is light on dark.
        size: Width and height at which it is shown [px]; by default as it was drawn.
    """
    pixel = PIXEL * (min(size[0] / figure.width, size[1] / figure.height) if size else 1.0)
    colours = "\n".join(
        rf"\definecolor{{dh-{name}}}{{HTML}}{{{ink[dark].lstrip('#').upper()}}}" for name, ink in COLOURS.items()
    )
    looks = sorted({shape.look for shape in figure.shapes})
    styles = ",\n  ".join(f"dh-{name}/.style={{{_style(LOOKS[name], pixel)}}}" for name in looks)
    ground = rf"\fill[dh-paper] (0,0) rectangle ({_number(figure.width)},{_number(figure.height)});" if dark else ""
    body = [ground] * bool(ground) + [_shape(shape) for shape in figure.shapes] + [_text(t) for t in figure.texts]
    lines = "\n".join(body)
    return (
        f"{comment(f'{figure.title}: {figure.caption}', '%')}"
        "% Include it with \\input; the preamble needs \\usepackage{tikz}. Alone it is a document of its own.\n"
        "\\ifdefined\\tikzpicture\\def\\dhend{}\\else\n"
        "\\documentclass{article}\\usepackage{tikz}\\pagestyle{empty}\\begin{document}\\def\\dhend{\\end{document}}\\fi\n"
        f"{colours}\n"
        f"\\begin{{tikzpicture}}[x={_number(pixel)}pt, y=-{_number(pixel)}pt, inner sep=0pt,\n  {styles}]\n"
        f"\\path (0,0) rectangle ({_number(figure.width)},{_number(figure.height)});\n"
        f"{lines}\n\\end{{tikzpicture}}\n\\dhend\n"
    )


def _style(look: Look, pixel: float) -> str:
    parts = [f"line width={_number(look.width * pixel * 1.1)}pt"]
    if look.stroke:
        parts.append(f"draw=dh-{look.stroke}")
    if look.fill and look.fill != "shade":
        parts.append(f"fill=dh-{look.fill}")
    if look.dash:
        pairs = zip(look.dash[::2], look.dash[1::2], strict=True)
        dashes = " ".join(f"on {_number(a * pixel)}pt off {_number(b * pixel)}pt" for a, b in pairs)
        parts.append(f"dash pattern={dashes}")
    if look.round:
        parts.append("line cap=round, line join=round")
    return ", ".join(parts)


def _shape(shape: Shape) -> str:
    path = " -- ".join(_point(point) for point in shape.points) + " -- cycle" * shape.closed
    if shape.shade:
        (x1, y1), (x2, y2) = shape.shade
        turn = math.degrees(math.atan2(-(y2 - y1), x2 - x1)) + 90
        colours = f"left color=dh-shadow, right color=dh-metal, middle color=dh-shine, shading angle={turn:.1f}"
        return rf"\shade[{colours}] {path}; \path[dh-{shape.look}] {path};"
    return rf"\path[dh-{shape.look}] {path};"


def _text(text: Text) -> str:
    colour = f"dh-{TEXTS[text.look]}"
    if text.look in ("caption", "cell"):
        font = r"\scriptsize" if text.look == "caption" else r"\small"
        return rf"\node[anchor=base west, text={colour}, font={font}] at {_point(text.at)} {{{plain_tex(text.words)}}};"
    label = maths(text.words, upright=text.look in UPRIGHT)
    return rf"\node[anchor=base, text={colour}] at {_point(text.at)} {{{label}}};"


def maths(words: Words, *, upright: bool) -> str:
    r"""A label as LaTeX sets it: `$\theta_{1}$`."""
    found = []
    for run in words:
        letters = "".join(_letter(letter) for letter in run.text)
        if len(run.text) > 1 and run.text.isalpha() and not run.below:
            letters = rf"\mathit{{{letters}}}"
        if run.below and any(c.isalpha() for c in run.text) and len(run.text) > 1 and run.text.isalpha():
            letters = rf"\mathrm{{{letters}}}"
        found.append(f"_{{{letters}}}" if run.below else letters)
    inside = "".join(found).replace(", ", r",\,")
    return f"$\\mathrm{{{inside}}}$" if upright else f"${inside}$"


def plain_tex(words: Words) -> str:
    """A text outside formulas, its Greek letters and signs in formulas of their own."""
    found = []
    for run in words:
        text = "".join(
            f"${_letter(c)}$" if c in GREEK or c in _SIGNS else _SPECIAL.get(c, c if c.isprintable() else " ")
            for c in run.text
        )
        found.append(f"\\textsubscript{{{text}}}" if run.below else text)
    return "".join(found)


def _letter(letter: str) -> str:
    if letter in GREEK:
        return f"\\{GREEK[letter]} "
    return _SIGNS.get(letter, _SPECIAL.get(letter, letter if letter.isprintable() else " "))


def _point(point: Flat) -> str:
    return f"({_number(point[0])},{_number(point[1])})"
