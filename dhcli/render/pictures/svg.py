"""A figure as SVG: plain enough for every reader of SVG, the same bytes for the same figure."""

from __future__ import annotations

import zlib
from collections.abc import Iterator
from functools import partial
from itertools import groupby, pairwise

from dhcli.kinematics.entries import rounded
from dhcli.render.pictures.looks import COLOURS, LOOKS, TEXTS, UPRIGHT, Look
from dhcli.safe import html
from dhcli.scene.shapes import Figure, Shape, Text
from dhcli.scene.vectors import Flat
from dhcli.scene.words import Words

_number = partial(rounded, digits=1)

_PLAIN = frozenset({"caption", "cell", "head"})
"""Texts beside the drawing, which need no paper around their letters."""

FONTS = "'Times New Roman',Times,'Liberation Serif','Nimbus Roman','DejaVu Serif',serif"
"""Serifs whose lines are no higher than the places of the labels."""


def svg(figure: Figure, *, dark: bool = False, size: tuple[int, int] | None = None) -> str:
    """The text of an SVG file.

    Args:
        figure: The figure.
        dark: Whether it is dark always; otherwise it follows the reader's colour scheme.
        size: Width and height at which it is shown [px]; by default as it was drawn.
    """
    width, height = size or (round(figure.width), round(figure.height))
    body = "\n".join([*_shapes(figure.shapes), *_texts(figure.texts)])
    key = f"f{zlib.crc32((body + str(dark)).encode()):08x}"
    looks = sorted({shape.look for shape in figure.shapes})
    texts = sorted({text.look for text in figure.texts})
    described = html(f"{figure.title}: {figure.caption}")
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" class="{key}" width="{width}" height="{height}" '
        f'viewBox="0 0 {_number(figure.width)} {_number(figure.height)}" role="img" aria-label="{described}">\n'
        f"<title>{html(figure.title)}</title>\n"
        f"<style>{_style(looks, texts, key, dark=dark)}</style>\n"
        f"{_defs(figure.shapes, key)}"
        f'<rect class="paper" width="100%" height="100%"/>\n{body.replace("url(#", f"url(#{key}")}\n</svg>\n'
    )


def _style(looks: list[str], texts: list[str], key: str, *, dark: bool) -> str:
    """Rules for the looks that are used, by day, and by night where the reader's scheme is dark."""
    fixed = [f"text{{font-family:{FONTS};font-style:italic;text-anchor:middle}}"]
    fixed.append(".halo-text{fill:none;stroke-width:3.6;stroke-linejoin:round}")
    fixed += [f".t-{text}{{font-style:normal}}" for text in texts if text in UPRIGHT]
    fixed += [".t-caption,.t-cell{text-anchor:start}"] if {"caption", "cell"} & set(texts) else []
    for name in looks:
        look = LOOKS[name]
        fixed.append(f".{name}{{{_shape_rule(look)}}}")
    rules = [_scoped(rule, key) for rule in (*fixed, *_colours(looks, texts, night=dark))]
    if not dark:
        night = "".join(_scoped(rule, key) for rule in _colours(looks, texts, night=True))
        rules.append(f"@media (prefers-color-scheme:dark){{{night}}}")
    return "".join(rules)


def _scoped(rule: str, key: str) -> str:
    """A rule that holds inside one figure only: several may stand on one page."""
    selectors, _, declarations = rule.partition("{")
    return ",".join(f".{key} {selector}" for selector in selectors.split(",")) + "{" + declarations


def _shape_rule(look: Look) -> str:
    parts = [] if look.fill else ["fill:none"]
    if look.stroke:
        parts.append(f"stroke-width:{_number(look.width)}")
    if look.dash:
        parts.append(f"stroke-dasharray:{' '.join(map(_number, look.dash))}")
    if look.round:
        parts.append("stroke-linejoin:round;stroke-linecap:round")
    return ";".join(parts)


def _colours(looks: list[str], texts: list[str], *, night: bool) -> list[str]:
    def colour(name: str) -> str:
        return COLOURS[name][night]

    rules = [f".paper{{fill:{colour('paper')}}}", f".halo-text{{stroke:{colour('paper')}}}"]
    for name in looks:
        look = LOOKS[name]
        fill = f"fill:{colour(look.fill)};" if look.fill and look.fill != "shade" else ""
        stroke = f"stroke:{colour(look.stroke)}" if look.stroke else ""
        rules.append(f".{name}{{{fill}{stroke}}}")
    rules += [f".t-{look}{{fill:{colour(TEXTS[look])}}}" for look in texts]
    if any(LOOKS[name].fill == "shade" for name in looks):
        rules += [f".s-{name}{{stop-color:{colour(name)}}}" for name in ("shadow", "shine", "metal")]
    return rules


def _defs(shapes: tuple[Shape, ...], key: str) -> str:
    """A gradient across each drum; all have the same stops."""
    found = []
    for number, shape in enumerate(each for each in shapes if each.shade):
        assert shape.shade  # noqa: S101  filtered
        (x1, y1), (x2, y2) = shape.shade
        place = " ".join(f'{k}="{_number(v)}"' for k, v in (("x1", x1), ("y1", y1), ("x2", x2), ("y2", y2)))
        stops = (
            '<stop class="s-shadow" offset="0"/><stop class="s-shine" offset=".42"/><stop class="s-metal" offset="1"/>'
        )
        found.append(
            f'<linearGradient id="{key}g{number}" gradientUnits="userSpaceOnUse" {place}>{stops}</linearGradient>'
        )
    return f"<defs>{''.join(found)}</defs>\n" if found else ""


def _shapes(shapes: tuple[Shape, ...]) -> list[str]:
    found: list[str] = []
    shaded = 0
    last = ""
    for shape in shapes:
        fill = ""
        if shape.shade:
            fill, shaded = f' fill="url(#g{shaded})"', shaded + 1
        path = _path(shape.points, closed=shape.closed)
        if shape.look == last and not fill:
            found[-1] = found[-1][:-3] + path + '"/>'  # lines of one look that follow each other are one path
        else:
            found.append(f'<path class="{shape.look}"{fill} d="{path}"/>')
        last = shape.look if not shape.closed or shape.look.startswith("density") else ""
    return found


def _path(points: tuple[Flat, ...], *, closed: bool) -> str:
    """Corners as steps from the one before, in whole tenths of a pixel, so that they add up to where they are."""
    tenths = [(round(10 * x), round(10 * y)) for x, y in points]
    steps = "".join(_pair(x - a, y - b) for (a, b), (x, y) in pairwise(tenths))
    return f"M{_pair(*tenths[0]).strip()}{'l' * bool(steps)}{steps.strip()}{'z' * closed}"


def _pair(x: int, y: int) -> str:
    """Two numbers in tenths, each with a blank before it where no minus parts them."""
    return "".join(text if text[0] == "-" else f" {text}" for text in (_tenths(x), _tenths(y)))


def _tenths(value: int) -> str:
    whole, rest = divmod(abs(value), 10)
    return "-" * (value < 0) + (f"{whole or ''}.{rest}" if rest else str(whole))


def _texts(texts: tuple[Text, ...]) -> Iterator[str]:
    """All labels: first what makes paper around their letters, then these; those of one size in one group."""
    labels = [text for text in texts if text.look not in _PLAIN]
    for attributes, group in ((' class="halo-text" aria-hidden="true"', labels), ("", texts)):
        for size, some in groupby(group, key=lambda text: text.size):
            yield f'<g{attributes} font-size="{_number(size)}">'
            yield from (_text(text, halo=bool(attributes)) for text in some)
            yield "</g>"


def _text(text: Text, *, halo: bool) -> str:
    look = f' class="t-{text.look}"' if not halo or text.look in UPRIGHT else ""
    place = f'x="{_number(text.at[0])}" y="{_number(text.at[1])}"'
    return f"<text{look} {place}>{_words(text.words, text.size)}</text>"


def _words(words: Words, size: float) -> str:
    """Runs of letters; an index is lowered and the next run raised again."""
    found, lowered = [], False
    drop = _number(0.24 * size)
    for run in words:
        text = html(run.text)
        if run.below:
            found.append(f'<tspan dy="{drop}" font-size="{_number(0.7 * size)}">{text}</tspan>')
        else:
            found.append(f'<tspan dy="-{drop}">{text}</tspan>' if lowered else text)
        lowered = run.below
    return "".join(found)
