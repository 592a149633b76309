"""A figure as PDF: one page, its lines and letters as such, in the fonts that every reader of PDF has.

Written here because no library renders the SVG faithfully: fpdf2 stops at Greek letters and knows no gradients there,
pymupdf ignores the style sheet and paints a black page.
"""

from __future__ import annotations

import zlib
from functools import partial
from itertools import pairwise

from dhcli.kinematics.entries import rounded
from dhcli.notation.names import GREEK
from dhcli.render.pictures.looks import COLOURS, LOOKS, TEXTS, UPRIGHT
from dhcli.scene.shapes import Figure, Shape, Text
from dhcli.scene.vectors import Flat

_n = partial(rounded, digits=3)

PIXEL = 0.75
"""A pixel in points, as CSS has it."""

# Widths of the printable ASCII letters of Times-Italic, in thousandths; Adobe's font metrics.
_ITALIC = (
    250, 333, 420, 500, 500, 833, 778, 333, 333, 333, 500, 675, 250, 333, 250, 278, 500, 500, 500, 500, 500, 500, 500,
    500, 500, 500, 333, 333, 675, 675, 675, 500, 920, 611, 611, 667, 722, 611, 611, 722, 722, 333, 444, 667, 556, 833,
    667, 722, 611, 722, 611, 500, 556, 722, 611, 833, 611, 556, 556, 389, 278, 389, 422, 500, 333, 500, 500, 444, 500,
    444, 278, 500, 500, 278, 278, 444, 278, 722, 500, 500, 500, 500, 389, 389, 278, 500, 444, 667, 444, 444, 389,
    400, 275, 400, 541,
)  # fmt: skip
_SYMBOL = dict(zip("αβγδεζηθικλμνξπρστφχψω−′", "abgdezhqiklmnxprstjcyw-¢", strict=True))
"""The letters that the font Symbol has, each with what has its code among those of Times."""

_ROMAN, _SLANTED, _GREEK = "F1", "F2", "F3"


def pdf(figure: Figure, *, dark: bool = False, size: tuple[int, int] | None = None) -> bytes:
    """The bytes of a PDF file, the same for the same figure.

    Args:
        figure: The figure.
        dark: Whether it is light on dark.
        size: Width and height at which it is shown [px]; by default as it was drawn.
    """
    factor = PIXEL * (min(size[0] / figure.width, size[1] / figure.height) if size else 1.0)
    width, height = figure.width * factor, figure.height * factor
    shadings: list[str] = []
    lines = [f"{_n(factor)} 0 0 {_n(-factor)} 0 {_n(height)} cm 1 j"]
    lines.append(f"{_colour('paper', dark)} rg 0 0 {_n(figure.width)} {_n(figure.height)} re f")
    lines += [_shape(shape, shadings, dark=dark) for shape in figure.shapes]
    for text in figure.texts:
        lines += _text(text, dark=dark)
    return _file(figure, "\n".join(lines), (width, height), shadings)


def _shape(shape: Shape, shadings: list[str], *, dark: bool) -> str:
    look = LOOKS[shape.look]
    path = (
        " ".join(f"{_n(x)} {_n(y)} {'l' if i else 'm'}" for i, (x, y) in enumerate(shape.points)) + " h" * shape.closed
    )
    before = ""
    if shape.shade:
        shadings.append(_shading(shape.shade, dark=dark))
        before = f"q {path} W n /S{len(shadings) - 1} sh Q "
    fill = bool(look.fill) and look.fill != "shade"
    paint = ("B" if look.stroke else "f") if fill else "S" if look.stroke else "n"
    state = [f"{_colour(look.fill, dark)} rg"] if fill else []
    if look.stroke:
        dash = f"[{' '.join(map(_n, look.dash))}] 0 d"
        state.append(f"{_colour(look.stroke, dark)} RG {_n(look.width)} w {dash} {int(look.round)} J")
    return f"{before}{' '.join(state)} {path} {paint}"


def _text(text: Text, *, dark: bool) -> list[str]:
    """The runs of a text one after another, in the middle of its place; a halo of paper under labels."""
    pieces: list[tuple[str, str, float, float]] = []
    upright = text.look in UPRIGHT
    for run in text.words:
        size, drop = (0.7 * text.size, 0.24 * text.size) if run.below else (text.size, 0.0)
        for letter in run.text:
            font = _GREEK if letter in _SYMBOL or letter in GREEK else _ROMAN if upright else _SLANTED
            pieces.append((font, letter, size, drop))
    x, y = text.at
    if text.look not in ("caption", "cell"):
        x -= sum(_width(letter) * size for _, letter, size, _ in pieces) / 2
    labels = [f"{_colour(TEXTS[text.look], dark)} rg 0 Tr"]
    if text.look not in ("caption", "cell", "head"):
        labels.insert(0, f"{_colour('paper', dark)} RG 3.6 w [] 0 d 1 Tr")
    found = []
    for state in labels:
        at = x
        shown = []
        for font, letter, size, drop in pieces:
            shown.append(f"/{font} {_n(size)} Tf 1 0 0 -1 {_n(at)} {_n(y + drop)} Tm ({_escaped(font, letter)}) Tj")
            at += _width(letter) * size
        found.append(f"BT {state} {' '.join(shown)} ET")
    return found


def _width(letter: str) -> float:
    if " " <= letter <= "~":
        return _ITALIC[ord(letter) - 32] / 1000
    return 0.247 if letter == "′" else 0.53


def _escaped(font: str, letter: str) -> str:
    code = _SYMBOL.get(letter, "?") if font == _GREEK else letter
    byte = code.encode("cp1252", "replace")
    return f"\\{byte[0]:03o}" if byte in b"()\\" or byte[0] > 126 else byte.decode("ascii")  # noqa: PLR2004  not ASCII


def _shading(shade: tuple[Flat, Flat], *, dark: bool) -> str:
    (x1, y1), (x2, y2) = shade
    stops = [_colour(name, dark) for name in ("shadow", "shine", "metal")]
    parts = " ".join(f"<< /FunctionType 2 /Domain [0 1] /C0 [{a}] /C1 [{b}] /N 1 >>" for a, b in pairwise(stops))
    function = f"<< /FunctionType 3 /Domain [0 1] /Functions [{parts}] /Bounds [0.42] /Encode [0 1 0 1] >>"
    ends = " ".join(map(_n, (x1, y1, x2, y2)))
    return f"<< /ShadingType 2 /ColorSpace /DeviceRGB /Coords [{ends}] /Function {function} /Extend [true true] >>"


def _file(figure: Figure, content: str, size: tuple[float, float], shadings: list[str]) -> bytes:
    """The objects of a file with one page, and the table of where they stand."""
    stream = zlib.compress(content.encode("latin-1", "replace"), 9)
    fonts = {_ROMAN: "Times-Roman", _SLANTED: "Times-Italic", _GREEK: "Symbol"}
    coded = {key: "" if key == _GREEK else " /Encoding /WinAnsiEncoding" for key in fonts}
    named = " ".join(
        f"/{key} << /Type /Font /Subtype /Type1 /BaseFont /{font}{coded[key]} >>" for key, font in fonts.items()
    )
    shaded = " ".join(f"/S{i} {shading}" for i, shading in enumerate(shadings))
    title = "".join(c if " " <= c <= "~" and c not in "()\\" else " " for c in figure.title)
    objects = [
        b"<< /Type /Catalog /Pages 2 0 R >>",
        b"<< /Type /Pages /Kids [3 0 R] /Count 1 >>",
        f"<< /Type /Page /Parent 2 0 R /MediaBox [0 0 {_n(size[0])} {_n(size[1])}] /Contents 4 0 R "
        f"/Resources << /Font << {named} >> /Shading << {shaded} >> >> >>".encode(),
        f"<< /Length {len(stream)} /Filter /FlateDecode >>\nstream\n".encode() + stream + b"\nendstream",
        f"<< /Title ({title}) /Creator (dhcli) >>".encode(),
    ]
    found, places = b"%PDF-1.4\n%\xe2\xe3\xcf\xd3\n", []
    for number, each in enumerate(objects, 1):
        places.append(len(found))
        found += f"{number} 0 obj\n".encode() + each + b"\nendobj\n"
    table = "".join(f"{place:010d} 00000 n \n" for place in places)
    return (
        found
        + (
            f"xref\n0 {len(objects) + 1}\n0000000000 65535 f \n{table}"
            f"trailer\n<< /Size {len(objects) + 1} /Root 1 0 R /Info 5 0 R >>\nstartxref\n{len(found)}\n%%EOF\n"
        ).encode()
    )


def _colour(name: str, dark: bool) -> str:  # noqa: FBT001  one of two columns
    code = COLOURS[name][dark].lstrip("#")
    return " ".join(_n(int(code[i : i + 2], 16) / 255) for i in (0, 2, 4))
