"""Rules for linkages: the geometry decides what the formula cannot."""

from __future__ import annotations

from collections.abc import Iterator

from dhcli.errors import are
from dhcli.kinematics.validity import Finding
from dhcli.lint import lengths
from dhcli.lint.wording import unfinished
from dhcli.mobility.counting import Counts
from dhcli.mobility.finding import mobility_of
from dhcli.mobility.linkage import Linkage


def findings(linkage: Linkage | Counts) -> Iterator[Finding]:
    """Every broken rule of a linkage."""
    yield from unfinished({("title",): linkage.title})
    if isinstance(linkage, Counts):
        return
    yield from unfinished({("source",): linkage.source})
    yield from lengths.of_linkage(linkage)
    yield from _half_placed(linkage)
    if not linkage.is_placed:
        return
    found = mobility_of(linkage)  # what keeps it from being analysed is a finding too: see `kept`
    if found.mobility is None:
        hint = "are the lengths exact? expressions keep them so"
        yield Finding((), f"the geometry does not decide the mobility: {found.certificate}", hint)


def _half_placed(linkage: Linkage) -> Iterator[Finding]:
    """Joints without a place where others have one: then only the formula counts."""
    some = any(joint.is_placed(linkage.space) for joint in linkage.joints)
    for index, joint in enumerate(linkage.joints if some else ()):
        missing = [name for name in joint.needs(linkage.space) if getattr(joint, name) is None]
        if missing:
            message = f"joint {joint.name}: its {' and '.join(missing)} {are(len(missing))} not said"
            hint = "without it only the formula counts"
            yield Finding(("joints", index), message, hint, is_warning=True)
