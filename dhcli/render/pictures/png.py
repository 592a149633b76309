"""A figure as PNG, by resvg: the extra `[draw]`."""

from __future__ import annotations

from dhcli.errors import DhcliError
from dhcli.render.pictures.svg import svg
from dhcli.scene.shapes import Figure

SHARP = 2.0
"""Pixels of the image for a pixel of the figure, unless a size is asked for."""


class MissingExtraError(DhcliError):
    """A library that an optional format needs is not installed."""


def png(figure: Figure, *, dark: bool = False, size: tuple[int, int] | None = None) -> bytes:
    """The bytes of a PNG file.

    Args:
        figure: The figure.
        dark: Whether it is light on dark.
        size: Width and height of the image [px]; twice what it was drawn at by default.

    Raises:
        MissingExtraError: resvg is not installed.
    """
    try:
        import resvg_py
    except ImportError:
        hint = "pip install 'dhcli[draw]' brings it; .svg, .pdf, .tex and .html need nothing"
        raise MissingExtraError("PNG needs resvg, which is not installed", hint) from None
    text = svg(figure, dark=dark, size=size)
    return bytes(resvg_py.svg_to_bytes(svg_string=text, zoom=1.0 if size else SHARP))
