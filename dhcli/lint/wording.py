"""Texts that an author has not finished, whatever they belong to."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from dhcli.kinematics.validity import Finding
from dhcli.regex import regex

_UNFINISHED = regex(r"\b(?:TODO|FIXME|XXX|TBD)\b|\bwrite here\b[^.;\n]*")


def unfinished(texts: Mapping[tuple[str | int, ...], str]) -> Iterator[Finding]:
    """A finding for each text that is blank, and for each thing that a template left to write."""
    for where, text in texts.items():
        what = where[-1]
        if not text.strip():
            yield Finding(where, f"{what}: nothing but blanks", "say it, or leave the key out")
        for left in dict.fromkeys(found[0].rstrip() for found in _UNFINISHED.finditer(text)):
            yield Finding(where, f"{what}: still says '{left}'", "write what belongs there")
