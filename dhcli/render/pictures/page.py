"""A figure as a page: one file that asks for nothing, with sliders, orbit, live matrices, and linkages that move."""

from __future__ import annotations

import json
from importlib.resources import files
from typing import TYPE_CHECKING, Any

from dhcli.errors import DhcliError
from dhcli.kinematics.conventions import NAMES, ORDER
from dhcli.kinematics.robot import Robot
from dhcli.mobility.linkage import Linkage
from dhcli.regex import regex
from dhcli.render.pictures.looks import COLOURS, LOOKS, TEXTS, UPRIGHT
from dhcli.render.pictures.page_arm import arm_model
from dhcli.render.pictures.page_linkage import plane_model, space_model
from dhcli.render.pictures.svg import FONTS
from dhcli.safe import html
from dhcli.scene.shapes import Figure

if TYPE_CHECKING:
    from dhcli.scene.drawing import Drawing

_LITERAL = regex(r"""(`[^`]*`|"[^"\n]*"|(?<=\()/(?:[^/\n\\[]|\\.|\[[^\]]*\])+/\w*)""")
"""A text or a pattern inside a script; no script has `+ +` or `- -`, where a blank would mean something."""

_MATHS = regex(r"\bMath\.(\w+)")
_BLANKS = regex(r" +(?=[-=+*/%<>,?:&|!{}();\[\]])|(?<=[-=+*/%<>,?:&|!{}();\[\]]) +")
_INDEX = regex(r"_(?:\{([^}]*)\}|(\w))")
"""An index as a terminal writes it: `a_i`, `a_{i-1}`."""

_ONLY_FLAT = frozenset({"bar", "wheel", "pin", "axis", "axis-dot"})
_ONLY_IN_SPACE = frozenset(
    {"link", "ground-link", "ground-sheet", "knob", "drum", "ball", "cap", "face", "face-light", "face-dark", "sheet"}
    | {"plate", "hatch", "break", "hand", "halo", "dim", "dim-head", "slide", "slide-head", "turn", "turn-head"}
    | {f"{letter}{part}" for letter in "xyz" for part in ("", "-head", "-ring")}
)
_ONLY_OF_ARMS = frozenset({"cloud", "dim-head", "slide-head", "turn-head", "halo", "plate", "hatch", "break", "hand"})
_ONLY_OF_ARMS |= {name for name in LOOKS if name[0] in "xyz" or LOOKS[name].stroke in ("dim", "turn")}
_ONLY_OF_ARMS |= {"pin-ground", "ground-line", "hatch-line", "extension"}
_NEVER = frozenset({"rule", "moment", *(name for name in LOOKS if name.startswith(("density", "theirs")))})

_FIGURE = '<svg id="figure" viewBox="0 0 820 640" tabindex="0" role="img" aria-label="{label}"></svg>'


def page(picture: Drawing) -> str:
    """The text of an HTML file.

    Raises:
        DhcliError: What is asked for cannot be drawn.
    """
    what = picture.what
    if picture.worksheet:
        hint = "write .svg, .pdf, .png, .tex or .txt"
        raise DhcliError("a page computes frames and table, which a worksheet leaves to the student", hint)
    if picture.more:
        raise DhcliError(
            "a page shows one arm or one linkage", "write .svg, .pdf, .png, .tex or .txt, or draw one alone"
        )
    if picture.beside is not None:
        raise DhcliError("a page shows one table", "write .svg, .pdf, .png or .tex to see two over each other")
    if picture.moves:
        picture.motion()  # what cannot be drawn is refused before
    if isinstance(what, Robot):
        return _page(
            what.title,
            NAMES[what.convention],
            _arm_controls(what),
            arm_model(picture),
            ("flat", "space", "view", "arm"),
            picture,
        )
    subtitle = f"{len(what.links)} links, {what.pattern}"
    if not what.is_placed:
        return _still(what, picture.figure(), picture)
    if what.space.is_planar:
        picture.figure()  # what cannot be drawn is refused before
        return _page(what.title, subtitle, _LINKAGE, plane_model(what), ("flat", "linkage", "newton", "drive"), picture)
    model = space_model(picture)
    if "ties" not in model:
        return _page(what.title, subtitle, _VIEWS + _PNG, model, ("flat", "space", "view", "still"), picture)
    scripts = ("flat", "space", "view", "spatial", "newton", "drive")
    return _page(what.title, subtitle, _VIEWS + _LINKAGE, model, scripts, picture)


def _page(
    title: str, subtitle: str, controls: str, model: dict[str, Any], scripts: tuple[str, ...], picture: Drawing
) -> str:
    data = json.dumps(model, ensure_ascii=False, separators=(",", ":")).replace("<", "\\u003c")
    code = _short_names("\n".join(_script(name) for name in scripts))
    label = html(f"{title}, {subtitle}")
    styles = _read("page.css") + _read("arm.css") * ("arm" in scripts)
    return (
        f'<!DOCTYPE html>\n<html lang="en">\n<head><meta charset="utf-8">\n'
        f'<meta name="viewport" content="width=device-width,initial-scale=1">\n<title>{html(title)}</title>\n'
        f"<style>{_colours(scripts, dark=picture.dark)}{styles}</style>\n"
        f'<style id="looks">{_looks(scripts)}</style></head>\n<body><main>\n'
        f'<div class="stage">{_FIGURE.format(label=label)}<p class="hint"><span id="seen"></span></p></div>\n'
        f"<aside><h1>{html(title)}</h1><p>{html(subtitle)}</p>\n{controls}</aside></main>\n"
        f'<script type="application/json" id="model">{data}</script>\n<script>"use strict";\n{code}\n</script>\n'
        "</body></html>\n"
    )


def _still(linkage: Linkage, figure: Figure, picture: Drawing) -> str:
    """A page that only shows, for a linkage whose points are not known."""
    from dhcli.render.pictures.svg import svg

    title = html(linkage.title)
    drawn = svg(figure, dark=picture.dark)
    return (
        f'<!DOCTYPE html>\n<html lang="en">\n<head><meta charset="utf-8"><title>{title}</title></head>\n'
        f"<body>{drawn}<p>{title}: no points are known, so nothing can move.</p></body></html>\n"
    )


def _script(name: str) -> str:
    """A script without its comments, indents and the blanks that only please the eye."""
    lines = (line.strip() for line in _read(f"{name}.js").splitlines())
    kept = [line.split(" // ")[0] for line in lines if line and not line.startswith("//")]
    pieces = _LITERAL.split("\n".join(kept))
    pieces[::2] = [_BLANKS.sub("", code) for code in pieces[::2]]  # between the literals, which stay as they are
    return "".join(pieces)


def _short_names(code: str) -> str:
    """The functions of Math by their own names; no script calls anything else so."""
    names = sorted(set(_MATHS.findall(code)))
    return f"const{{{','.join(names)}}}=Math;\n" + _MATHS.sub(r"\1", code)


def _read(name: str) -> str:
    return (files("dhcli.render.pictures") / name).read_text(encoding="utf-8")


def _colours(scripts: tuple[str, ...], *, dark: bool) -> str:
    """The colours as variables, by day and by night."""
    left_out = {"theirs", "theirs-pale", *(f"density-{level}" for level in (1, 2, 3, 5))}
    left_out |= set() if "arm" in scripts else {"hand", "y", "turn", "density-4"}
    inks = {name: ink for name, ink in COLOURS.items() if name not in left_out}
    day, night = ("".join(f"--{name}:{ink[column]};" for name, ink in inks.items()) for column in (0, 1))
    if dark:
        return f":root{{{night}color-scheme:dark}}"
    return f":root{{{day}}}@media(prefers-color-scheme:dark){{:root{{{night}}}}}@media print{{:root{{{day}}}}}"


def _looks(scripts: tuple[str, ...]) -> str:
    """The looks of what some scripts draw, in the plane or in space."""
    rules = [f"#figure text,text{{font-family:{FONTS};font-style:italic;text-anchor:middle}}"]
    rules.append(".halo-text{fill:none;stroke:var(--paper);stroke-width:3.6;stroke-linejoin:round}")
    rules += [f".s-{name}{{stop-color:var(--{name})}}" for name in ("shadow", "shine", "metal")]
    left_out = _NEVER | (_ONLY_FLAT if "space" in scripts else _ONLY_IN_SPACE)
    if "space" in scripts and "arm" not in scripts:
        left_out |= _ONLY_OF_ARMS
    for name, look in LOOKS.items():
        if name in left_out:
            continue
        parts = (
            [f"fill:var(--{look.fill})"] if look.fill and look.fill != "shade" else [] if look.fill else ["fill:none"]
        )
        if look.stroke:
            parts.append(f"stroke:var(--{look.stroke});stroke-width:{look.width:g}")
        if look.dash:
            parts.append(f"stroke-dasharray:{' '.join(f'{d:g}' for d in look.dash)}")
        if look.round:
            parts.append("stroke-linejoin:round;stroke-linecap:round")
        rules.append(f".{name}{{{';'.join(parts)}}}")
    for name, colour in TEXTS.items() if "arm" in scripts else [("dim", "dim"), ("mark", "line")]:
        upright = ";font-style:normal" if name in UPRIGHT else ""
        rules.append(f".t-{name}{{fill:var(--{colour}){upright}}}")
    return "".join(rules)


def _arm_controls(robot: Robot) -> str:
    order = html(ORDER[robot.convention].replace("alpha_", "α_").replace("theta_", "θ_"))
    order = _INDEX.sub(lambda index: f"<sub>{index[1] or index[2]}</sub>", order)
    checks = "".join(
        f'<label><input type="checkbox" id="on-{name}"{" checked" * on}> {name}</label>'
        for name, on in (("frames", True), ("dimensions", True), ("y", False), ("body", True), ("turns", True))
    )
    return (
        '<h2>Joints</h2><div id="joints"></div><div id="poses" class="controls"></div>\n'
        f'<h2>Show</h2><div class="controls">{checks}</div>\n'
        '<div class="controls"><span id="views"></span><button id="png">PNG</button></div>\n'
        '<h2>Pose of frame <select id="to" aria-label="of frame"></select> in frame '
        '<select id="from" aria-label="in frame"></select> <span id="isA"></span></h2>\n'
        '<table class="matrix" id="matrix"></table><p id="place"></p>\n'
        f'<h2>Table</h2><table id="table"></table><p class="hint">{order}</p>\n'
    )


_VIEWS = '<div class="controls"><span id="views"></span></div><div id="joints"></div><div id="poses"></div>\n'
_PNG = '<button id="png">PNG</button>'
_LINKAGE = (
    '<h2>Move</h2><div class="controls"><select id="driver" aria-label="link to move"></select></div>\n'
    '<input type="range" id="drive" min="-360" max="360" step="any" value="0" aria-label="how far">\n'
    '<p id="far"></p><div class="controls"><button id="play">play</button><button id="home">as drawn</button>'
    '<label><input type="checkbox" id="on-names" checked> names</label>'
    '<label>trace <select id="trace" aria-label="trace of"></select></label><button id="png">PNG</button></div>\n'
    '<p id="note" class="warn" role="status"></p>\n'
    '<h2>Points</h2><table id="pins"></table><p class="hint">Drag a pin or a link to move the linkage.</p>\n'
)
