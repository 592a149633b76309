"""Pages of the manual on a terminal: drawn by rich, in the width and the letters of the window."""

from __future__ import annotations

import io
from typing import TYPE_CHECKING

from dhcli.regex import regex
from dhcli.render.paper import Paper, in_ascii

if TYPE_CHECKING:
    from rich.console import Console, ConsoleOptions, RenderResult

WIDEST = 96
"""Columns at which running text is folded at most."""
_LINK = regex(r"(?<!!)\[([^\]]+)\]\((?!https?:)[^)]*?([a-z0-9-]+)\.md[^)]*\)")


def page_text(page: str, paper: Paper) -> str:
    """A page of Markdown for a person: headings, lists, tables and examples drawn; in a pipe as it stands."""
    if not paper.terminal:
        return page if paper.unicode else "".join(f"{in_ascii(line)}\n" for line in page.splitlines())
    from rich.console import Console
    from rich.markdown import CodeBlock, Heading, Markdown
    from rich.text import Text

    class Flat(Heading):
        """A heading at the left, not in a box."""

        def __rich_console__(self, console: Console, options: ConsoleOptions) -> RenderResult:
            """The text; a title is underlined, too."""
            yield Text(self.text.plain, "bold" if self.tag != "h1" else "bold underline")

    class Example(CodeBlock):
        """A block that is never folded, as wide as it is."""

        def __rich_console__(self, console: Console, options: ConsoleOptions) -> RenderResult:
            """The lines, a little to the right."""
            for line in str(self.text).rstrip().split("\n"):
                yield Text(f"  {line}", "cyan", no_wrap=True, overflow="ignore")

    class Page(Markdown):
        """Markdown with headings and examples as this manual has them."""

        elements = {**Markdown.elements, "heading_open": Flat, "fence": Example, "code_block": Example}  # noqa: RUF012

    drawn = io.StringIO()
    console = Console(
        file=drawn,
        width=min(paper.width, WIDEST),
        force_terminal=paper.colour,
        color_system="standard" if paper.colour else None,
        no_color=not paper.colour,
        emoji=False,
        legacy_windows=False,
    )
    shown = _LINK.sub(lambda link: link[1] if link[1].strip("`") == link[2] else f"{link[1]} ({link[2]})", page)
    console.print(Page(shown, hyperlinks=False), crop=False)
    lines = (line.rstrip() for line in drawn.getvalue().splitlines())
    return "".join(f"{line if paper.unicode else in_ascii(line)}\n" for line in lines)
